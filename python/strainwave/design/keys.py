"""Dotted keys of a design file, such as flexspline.profile.tip_arc_center[0]."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any

Part = str | int

DEEPEST = 8  # levels; no key of a design has more, but a file can nest thousands

_BARE = re.compile(r"^[A-Za-z0-9_-]+$")
_STEP = re.compile(r"(?:^|\.)(?P<name>[A-Za-z0-9_-]+)|\[(?P<index>[0-9]{1,6})\]")


def joined(key: str, part: Part) -> str:
    """`key` with one more part."""
    if isinstance(part, int):
        return f"{key}[{part}]"
    name = part if _BARE.match(part) else json.dumps(part, ensure_ascii=False)
    return f"{key}.{name}" if key else name


def appended(key: str, relative: str) -> str:
    """`key` followed by a key that is relative to it, either of which may be empty."""
    return f"{key}.{relative}" if key and relative and not relative.startswith("[") else key + relative


def parts_of(key: str) -> list[Part]:
    """The parts of a dotted key; ValueError if it is not one."""
    parts: list[Part] = []
    end = 0
    while step := _STEP.match(key, end):
        parts.append(step["name"] if step["index"] is None else int(step["index"]))
        end = step.end()
    if not parts or end != len(key):
        raise ValueError("is not a dotted key such as wave_generator.w0 or flexspline.profile.tip_arc_center[0]")
    return parts


def leaves(tree: object, key: str = "", depth: int = DEEPEST) -> Iterator[tuple[str, Any]]:
    """Every value in a tree of tables and arrays that is neither, with its dotted key, down to `depth` levels."""
    if isinstance(tree, Mapping | list | tuple):
        if depth > 0:
            for part, value in tree.items() if isinstance(tree, Mapping) else enumerate(tree):
                yield from leaves(value, joined(key, part), depth - 1)
    else:
        yield key, tree
