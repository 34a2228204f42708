"""The one look of every interactive picture: the colours, titles and legends of the static ones."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from strainwave.errors import StrainwaveError
from strainwave.plots.style import BLUE, GREEN, GREY, INK, ORANGE, PALE, PURPLE, SKY, VERMILION

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

FONT = "DejaVu Sans, Verdana, sans-serif"
SMALL = 12
LONGEST_TITLE = 100
# What a reader can do in the toolbar: no upload to anywhere, a picture of the same sharpness as print.
CONFIG: dict[str, Any] = {
    "displaylogo": False,
    "responsive": True,
    "scrollZoom": True,
    "toImageButtonOptions": {"format": "svg", "filename": "strainwave"},
}


def graph_objects() -> Any:
    """The module plotly.graph_objects; StrainwaveError where the extra ``interactive`` is missing."""
    try:
        import plotly.graph_objects
    except ImportError as error:
        raise StrainwaveError(
            f"interactive pictures need plotly ({error}): pip install 'strainwave[interactive]', or ask for a "
            ".png, .svg or .pdf"
        ) from None
    return plotly.graph_objects


def house_figure(title: str, *, verdict: str = "", x: str = "", y: str = "") -> Figure:
    """An empty figure in the house's look: the title, a line below it, and the words at both axes with their units."""
    figure = graph_objects().Figure(layout={"template": _template()})
    shown = title if len(title) <= LONGEST_TITLE else f"{title[: LONGEST_TITLE - 1]}…"
    figure.update_layout(title={"text": _plain(shown), "subtitle": {"text": _plain(verdict)}})
    figure.update_xaxes(title_text=x)
    figure.update_yaxes(title_text=y)
    return figure


def equal_scales(figure: Figure) -> None:
    """A millimetre is as long across as up, however the window is shaped."""
    figure.update_yaxes(scaleanchor="x", scaleratio=1.0)


def interactive_page(figure: Figure) -> str:
    """A page that holds all it needs, plotly too, and fills its window."""
    title = (figure.layout.title.text or "strainwave").replace("&lt;", "<").replace("&amp;", "&")
    page: str = figure.to_html(include_plotlyjs=True, full_html=True, config=CONFIG, div_id="picture")
    # plotly writes neither a title nor an icon; without one the browser asks a server for it.
    head = f'<title>{_plain(title)}</title><link rel="icon" href="data:,"><style>body {{ margin: 0 }}</style>'
    return page.replace("<head>", f"<head>{head}", 1)


def _plain(text: str) -> str:
    """Words of the user's own, in which nothing is a mark of HTML."""
    return text.replace("&", "&amp;").replace("<", "&lt;")


@cache
def _template() -> Any:
    """The look as a template, which lies beneath whatever a figure sets itself."""
    axis = {
        "gridcolor": PALE,
        "linecolor": GREY,
        "showline": True,
        "tickcolor": GREY,
        "ticks": "outside",
        "zeroline": False,
        "title": {"standoff": 8},
    }
    objects = graph_objects()
    return objects.layout.Template(
        layout={
            "font": {"family": FONT, "size": SMALL, "color": INK},
            "title": {
                "x": 0.0,
                "xref": "paper",
                "font": {"size": 15, "weight": "bold"},
                "subtitle": {"font": {"size": SMALL}},
            },
            "colorway": [BLUE, ORANGE, GREEN, PURPLE, SKY, VERMILION, GREY],
            "paper_bgcolor": "white",
            "plot_bgcolor": "white",
            "hovermode": "closest",
            "hoverlabel": {"font": {"family": FONT, "size": SMALL}, "align": "left"},
            "legend": {"orientation": "h", "x": 0.0, "y": -0.14, "yanchor": "top"},
            "margin": {"l": 72, "r": 24, "t": 72, "b": 96},
            "separators": ". ",
            "xaxis": axis,
            "yaxis": axis,
        }
    )
