"""Blocks of a document that scripts write: what stands between ``<!-- NAME:begin -->`` and ``<!-- NAME:end -->``."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent


def filled(text: str, blocks: Mapping[str, str]) -> str:
    """A document with its blocks' new contents, by name; a block that it does not have is left out."""
    for name, content in blocks.items():
        marked = re.compile(rf"(?<=<!-- {name}:begin -->\n).*?(?=<!-- {name}:end -->)", re.DOTALL)
        text = marked.sub(f"\n{content}\n".replace("\\", r"\\"), text)
    return text


def fill(document: str, blocks: Mapping[str, str]) -> None:
    """Write new contents into a document of the project, named from its root, and say so."""
    path = ROOT / document
    path.write_text(filled(path.read_text(encoding="utf-8"), blocks), encoding="utf-8")
    print(f"  {document}")
