"""The page as a place to drop files on."""

from __future__ import annotations

from nicegui.element import Element
from nicegui.elements.upload import Upload


class FileDrop(Element, component="file_drop.js"):
    """Gives a file that is dropped anywhere on the page to an uploader."""

    def __init__(self, uploader: Upload, words: str) -> None:
        super().__init__()
        self.props["uploader"] = uploader.id
        self.props["words"] = words
