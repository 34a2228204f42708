"""A report as one page of HTML that needs nothing else."""

from __future__ import annotations

import base64
import gzip
import json
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.errors import StrainwaveError
from strainwave.plots.picture import picture_bytes
from strainwave.report.block import Block, Plate
from strainwave.report.wording import LEVEL_WORDS
from strainwave.studies.progress import Progress, silent

if TYPE_CHECKING:
    from jinja2 import Environment
    from matplotlib.figure import Figure

    from strainwave.report.document import Document

# A picture of more strokes than this is smaller, and sooner drawn, as dots.
MOST_SVG_BYTES = 400_000


def html_of(document: Document, progress: Progress = silent) -> str:
    """The page, the same text for the same document."""
    from strainwave.plots.interactive.house import CONFIG, graph_objects

    # What is missing is said before anything is drawn.
    graph_objects()
    template = _environment().get_template("page.html.j2")
    from plotly.offline import get_plotlyjs

    images: dict[Plate, str] = {}
    for plate in document.plates:
        images[plate] = _static_image(plate)
        progress(len(images), len(document.plates))
    return template.render(
        document=document,
        style=_text("page.css"),
        script=_text("page.js"),
        plotly=_packed(get_plotlyjs().encode()),
        # A wheel turned over a picture moves the page on; only the gear in space comes nearer.
        config=CONFIG | {"scrollZoom": "gl3d"},
        level_words=LEVEL_WORDS,
        kind=_kind,
        static=images.__getitem__,
        interactive=_interactive_data,
    )


@cache
def _environment() -> Environment:
    """Everything is escaped that the template does not declare safe."""
    try:
        from jinja2 import Environment, FunctionLoader, StrictUndefined
    except ImportError as error:
        raise StrainwaveError(f"reports need jinja2 ({error}): pip install 'strainwave[report]'") from None
    return Environment(
        loader=FunctionLoader(_text), autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )


def _text(name: str) -> str:
    return files("strainwave.report").joinpath(name).read_text(encoding="utf-8")


def _kind(block: Block) -> str:
    return type(block).__name__.lower()


def _static_image(plate: Plate) -> str:
    """The picture on paper as the address of an image: apart from the page, so that no names in it meet."""
    figure: Figure = plate.draw()
    drawn, kind = picture_bytes(figure, "svg", description=plate.title), "svg+xml"
    if len(drawn) > MOST_SVG_BYTES:
        drawn, kind = picture_bytes(figure, "png", description=plate.title), "png"
    return f"data:image/{kind};base64,{base64.b64encode(drawn).decode()}"


def _interactive_data(plate: Plate) -> str:
    """The picture to zoom into, as plotly reads it, packed."""
    if plate.draw_interactive is None:
        return ""
    drawn = json.loads(plate.draw_interactive().to_json())
    return _packed(json.dumps(_single_precision(drawn)).encode())


def _single_precision(tree: Any) -> Any:
    """The same with arrays of half the size; their last digit is some nanometres of a gear's coordinates then."""
    if isinstance(tree, list):
        return [_single_precision(item) for item in tree]
    if not isinstance(tree, dict):
        return tree
    if tree.get("dtype") == "f8" and "bdata" in tree:
        doubles = np.frombuffer(base64.b64decode(tree["bdata"]), dtype="<f8")
        return {**tree, "dtype": "f4", "bdata": base64.b64encode(doubles.astype("<f4").tobytes()).decode()}
    return {key: _single_precision(value) for key, value in tree.items()}


def _packed(content: bytes) -> str:
    """Text that the page unpacks when it needs it: a few times smaller, and without a character that HTML reads."""
    return base64.b64encode(gzip.compress(content, mtime=0)).decode()
