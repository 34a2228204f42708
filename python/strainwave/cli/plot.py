"""``strainwave plot``: one picture of a design, to print or to zoom into."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from strainwave.cli.options import DesignFile, Force, Threshold

PAGE = ".html"
TEETH = re.compile(r"(?P<first>[-+]?\d+)(?::(?P<last>[-+]?\d+))?")


def plot(
    kind: Annotated[
        Literal[
            "assembly",
            "backlash",
            "gap",
            "neutral-curve",
            "contact",
            "trajectory",
            "face",
            "assembly-3d",
            "profile",
            "mesh",
        ],
        typer.Argument(
            metavar="KIND",
            help="assembly, backlash, gap, neutral-curve, contact, trajectory, face, assembly-3d, profile or mesh.",
            show_default=False,
        ),
    ],
    design: DesignFile,
    out: Annotated[
        Path,
        typer.Option(
            "--out",
            metavar="FILE",
            help="Draw to FILE.png, FILE.svg or FILE.pdf, or write FILE.html, a page of its own to zoom into.",
            show_default=False,
        ),
    ],
    angle: Annotated[
        str,
        typer.Option("--angle", metavar="DEG", help="Wave generator's angle, clockwise: degrees, or text as 7°30'."),
    ] = "0",
    teeth: Annotated[
        str | None,
        typer.Option("--teeth", metavar="A:B", help="assembly: only teeth A to B, clockwise, magnified; or one tooth."),
    ] = None,
    threshold: Threshold = 10.0,
    force: Force = False,
) -> None:
    """Draw a design: the assembled gear, its backlash, its rim, where teeth touch, how a tooth moves."""
    from strainwave.analysis import analyze
    from strainwave.cli.angle import degrees
    from strainwave.cli.naming import naming
    from strainwave.design import load
    from strainwave.plots.kinds import KINDS
    from strainwave.whole_file import check_free, write_whole

    page, chosen, angle_deg = _is_page(out), _teeth(teeth), degrees(angle)
    picture = KINDS[kind]
    picture.check(angle=angle_deg != 0.0, teeth=chosen is not None, interactive=page)
    check_free(out, overwrite=force)
    with naming(design):
        result = analyze(load(design), threshold_um=threshold, generator_angle_deg=angle_deg)
        figure = picture.figure(result, interactive=page, teeth=chosen)
    write_whole(out, _content(figure, out, page=page), overwrite=force)
    typer.echo(f"{out}: {picture.shows}")
    typer.echo(f"at mid-face: {result.verdict}" if picture.along_face else result.verdict)


def _is_page(out: Path) -> bool:
    """Whether an interactive page is asked for; StrainwaveError where the name is that of no picture."""
    from strainwave.errors import StrainwaveError
    from strainwave.plots.picture import PICTURE_FORMATS

    if out.suffix.lower() == PAGE:
        return True
    if out.suffix.lower().removeprefix(".") not in PICTURE_FORMATS:
        raise StrainwaveError(f"{out}: the name must end in .png, .svg or .pdf, or in .html for an interactive page")
    return False


def _teeth(text: str | None) -> tuple[int, int] | None:
    """First and last tooth of A:B, or of a single one."""
    if text is None:
        return None
    found = TEETH.fullmatch(text.strip())
    if found is None:
        raise typer.BadParameter(
            f"{text!r} is neither A:B, such as 32:41, nor one tooth's number", param_hint="--teeth"
        )
    first = int(found["first"])
    return first, int(found["last"] or first)


def _content(figure: Any, out: Path, *, page: bool) -> str | bytes:
    if page:
        from strainwave.plots.interactive import interactive_page

        return interactive_page(figure)
    from strainwave.plots.picture import picture_bytes, picture_format

    return picture_bytes(figure, picture_format(out))
