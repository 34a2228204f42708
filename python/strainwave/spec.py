"""The base of every table of a design file."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict


class Spec(BaseModel):
    """One table of a design: immutable, and without keys that nobody reads."""

    model_config = ConfigDict(frozen=True, extra="forbid")
