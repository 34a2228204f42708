"""What was typed under the kinds that a table has had."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

Tree = dict[str, Any]


class KindMemory:
    """The tables of one place of the design in the order in which they were left."""

    def __init__(self) -> None:
        self._tables: dict[str, Tree] = {}

    def leave(self, table: Mapping[str, Any]) -> None:
        """A table is about to make room for one of another kind."""
        kind = str(table.get("kind"))
        self._tables.pop(kind, None)
        self._tables[kind] = dict(table)

    def typed(self, kind: str) -> Tree | None:
        """The kind's own table as it was left; None where there was none yet."""
        return self._tables.get(kind)

    @property
    def seen(self) -> Tree:
        """Each name's value in the table that had it last."""
        return {name: value for table in self._tables.values() for name, value in table.items() if name != "kind"}
