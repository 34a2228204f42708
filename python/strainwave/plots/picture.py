"""A figure as the bytes of a picture file."""

from __future__ import annotations

import io
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

from strainwave.errors import StrainwaveError
from strainwave.plots.style import house_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PICTURE_FORMATS = ("png", "svg", "pdf")
DOTS_PER_INCH = 160


def picture_format(path: Path) -> str:
    """The format that the file's name asks for; ``StrainwaveError`` where it is none of png, svg, pdf."""
    asked = path.suffix.lower().removeprefix(".")
    if asked not in PICTURE_FORMATS:
        raise StrainwaveError(f"{path}: a picture's name must end in .png, .svg or .pdf")
    return asked


def picture_bytes(figure: Figure, kind: str, *, description: str = "") -> bytes:
    """The figure as png, svg or pdf, the same bytes for the same figure."""
    file = io.BytesIO()
    # A date in the file would make each drawing of the same figure another file.
    metadata = {
        "png": {"Description": description},
        "svg": {"Date": None, "Description": description},
        "pdf": {"CreationDate": None, "Subject": description},
    }[kind]
    with house_style(), warnings.catch_warnings():
        # A letter of a name that the font lacks is drawn as a box; there is nothing to do about it.
        warnings.filterwarnings("ignore", "Glyph .* missing from font")
        figure.savefig(file, format=kind, dpi=DOTS_PER_INCH, metadata=metadata)
    return file.getvalue()
