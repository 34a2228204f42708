"""The base of the files that say what a study asks."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Self, TypeVar

from pydantic import AfterValidator, ValidationError

from strainwave.design.faults import faults_of
from strainwave.errors import DesignError, Fault, FaultError
from strainwave.spec import Spec

T = TypeVar("T")


def _not_empty(tables: tuple[T, ...]) -> tuple[T, ...]:
    if not tables:
        raise FaultError([Fault("", None, "", "must hold at least one table")])
    return tables


Tables = Annotated[tuple[T, ...], AfterValidator(_not_empty)]
"""One table or more."""


class StudyFile(Spec):
    """What a file of tables says."""

    @classmethod
    def from_dict(cls, tree: Mapping[str, Any], source: str | None = None) -> Self:
        """What a tree of tables says, as TOML gives it. DesignError holds every fault, and names `source`."""
        try:
            return cls.model_validate(tree)
        except ValidationError as error:
            raise DesignError(faults_of(error, cls), source) from None
