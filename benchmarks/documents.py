"""Write every number, table, terminal output and picture of the README and the documentation.

In README.md and docs/ a block between ``<!-- NAME:begin -->`` and ``<!-- NAME:end -->`` holds a table of that name,
and in a ``console`` block each line that begins with ``$`` is run and followed by what it prints. A picture that these
commands draw and the page shows is kept in docs/pictures. Run this after a change in results, with the names of some
documents or for all of them; the tests fail where a document is behind.
"""

from __future__ import annotations

import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path

from PIL import Image

from strainwave.analysis import Analysis
from strainwave.analysis.case_study import CaseResult, CaseStudy, Reading
from strainwave.animation import Film
from strainwave.animation.stage import pictures as frames_of
from strainwave.cli.tables.number import fixed, general, whole
from strainwave.plots import backlash_figure, case_study_figure, mesh_figure, picture_bytes, profile_figure

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT))  # run as a script, it stands beside its own kind

from benchmarks import involute_claims  # noqa: E402
from benchmarks.export_figures import export_figures  # noqa: E402
from benchmarks.measurement.blocks import filled  # noqa: E402
from benchmarks.theory_figures import theory_figures  # noqa: E402

PICTURES = ROOT / "docs" / "pictures"
SHOWN = re.compile(r"!\[[^]]*\]\((?:[\w./-]*/)?pictures/(?P<name>[\w-]+\.png)\)")
CONSOLE = re.compile(r"^(?P<sample><!-- sample -->\n)?```console\n(?P<body>.*?)^```$", re.MULTILINE | re.DOTALL)
COLUMNS = "100"


def documents() -> list[Path]:
    """Every document that this script keeps."""
    return [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


def refreshed(text: str, study: CaseStudy, drawn: Path, *, samples: bool = True) -> str:
    """A document with its tables computed and its commands run anew; the pictures of these go to the folder `drawn`.

    What stands below ``<!-- sample -->`` may be another on another machine, such as the end of a search that the last
    bit of a number can turn. Without ``samples`` it is run, but text and pictures stay as they are.
    """
    text = filled(text, {name: table(study) for name, table in TABLES.items() if f"<!-- {name}:begin -->" in text})
    with example_folder() as folder:
        kept: set[str] = set()

        def anew(found: re.Match[str]) -> str:
            before = {path.name for path in folder.iterdir()}
            body = _console(found["body"], folder)
            if not found["sample"] or samples:
                return f"{found['sample'] or ''}```console\n{body}```"
            kept.update({path.name for path in folder.iterdir()} - before)
            return found[0]

        text = CONSOLE.sub(anew, text)
        for name in set(SHOWN.findall(text)) - kept:
            if (folder / name).is_file():
                shutil.copy(folder / name, drawn)
    return text


@contextmanager
def example_folder() -> Iterator[Path]:
    """An empty folder with the ready designs, in which examples may write."""
    with tempfile.TemporaryDirectory() as name:
        shutil.copytree(ROOT / "designs", Path(name) / "designs")
        yield Path(name)


def run(command: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a line of a console block as a reader would, with the command of this interpreter's environment."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    return subprocess.run(
        command,
        shell=True,
        cwd=folder,
        env={"PATH": path, "COLUMNS": COLUMNS, "LANG": "C.UTF-8"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )


def pictures(study: CaseStudy) -> dict[str, bytes]:
    """The pictures by file name; each says in its metadata which figures it shows."""
    cosine = study.result("cosine", "calibrated").analysis
    figures = {
        "case-study": case_study_figure(study),
        "backlash": backlash_figure(cosine),
        "mesh": mesh_figure(cosine),
        "profile": profile_figure(cosine.design),
        **theory_figures(cosine.design),
        **export_figures(cosine.design),
    }
    drawn = {
        f"{name}.png": picture_bytes(figure, "png", description=description(name, study))
        for name, figure in figures.items()
    }
    return drawn | {"animation.png": _frame(study.result("dual-disk-0848", "calibrated").analysis)}


def _frame(analysis: Analysis) -> bytes:
    """One frame of an animation, the generator at 60 degrees."""
    film = Film.of(analysis, frames=6, turns=1.0, fixed="circular-spline", frames_per_s=20.0)
    file = io.BytesIO()
    Image.fromarray(list(islice(frames_of(film), 2))[1]).save(file, "PNG")
    return file.getvalue()


def description(name: str, study: CaseStudy) -> str:
    """The figures that a picture shows, in words: what tells whether it is up to date."""
    if name != "case-study":
        return _shown(study.result("cosine", "calibrated").analysis)
    shown = (result for result in study.results if result.reading in ("as-printed", "calibrated"))
    return "; ".join(f"{result.reading} {_shown(result.analysis)}" for result in shown)


def _shown(analysis: Analysis) -> str:
    return (
        f"{analysis.design.name}: least {analysis.min_backlash_um:.2f} um, "
        f"in motion {analysis.min_in_motion_um:.2f} um, "
        f"{analysis.teeth_below.per_side} per side below {analysis.threshold_um:g} um"
    )


def _console(body: str, folder: Path) -> str:
    commands = [line for line in body.splitlines() if line.startswith("$ ")]
    lines = (line for command in commands for line in [command, *_printed(command.removeprefix("$ "), folder)])
    return "".join(f"{line.rstrip()}\n" for line in lines)


def _printed(command: str, folder: Path) -> list[str]:
    lines = run(command, folder).stdout.splitlines()
    # Help begins and ends with empty lines, which a page has no use for.
    return [line for place, line in enumerate(lines) if line.strip() or 0 < place < len(lines) - 2]


def comparison_table(study: CaseStudy) -> str:
    """Published, as printed and calibrated, a row for each case."""
    rows = [
        "| wave generator | least µm: published | as printed | calibrated | in motion "
        "| teeth < 10 µm per side: published | calibrated | interferes from: published | calibrated |",
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|",
    ]
    for case in study.cases:
        printed, calibrated = study.result(case.key, "as-printed"), study.result(case.key, "calibrated")
        published, computed = case.published, calibrated.analysis
        cells = [
            case.title if case.key == "cosine" else f"{case.title} †",
            f"**{general(published.min_backlash_um)}**",
            _least(printed),
            _least(calibrated),
            f"{fixed(computed.min_in_motion_um)} @ {fixed(computed.min_in_motion_index, 1)}",
            whole(published.teeth_below_per_side),
            whole(computed.teeth_below.per_side if published.teeth_below_per_side else None),
            whole(published.first_interfering_tooth),
            whole(computed.first_interfering_tooth),
        ]
        rows.append(_row(cells))
    return "".join(f"{row}\n" for row in rows)


def neutral_curve_table(study: CaseStudy) -> str:
    """Least backlash on each neutral curve, without clearance, a row for each."""
    readings: dict[Reading, str] = {
        "as-printed": "`first-order` (article)",
        "shifted": "`shifted`",
        "inextensible": "`inextensible`",
    }
    rows = [_row(["neutral curve", *(case.title for case in study.cases)]), "|---|--:|--:|--:|--:|"]
    rows.append(_row(["published", *(f"**{general(case.published.min_backlash_um)}**" for case in study.cases)]))
    for reading, name in readings.items():
        rows.append(_row([name, *(_least(study.result(case.key, reading)) for case in study.cases)]))
    return "".join(f"{row}\n" for row in rows)


def inferred_table(study: CaseStudy) -> str:
    """The numbers that the article does not print."""
    rows = ["| number | key | value | | why |", "|---|---|--:|---|---|"]
    for number in study.inferred:
        why = f"{'fitted: ' if number.fitted else ''}{number.why}"
        rows.append(_row([number.name, f"`{number.key}`", general(number.value), number.unit, why]))
    return "".join(f"{row}\n" for row in rows)


TABLES: dict[str, Callable[[CaseStudy], str]] = {
    "case-study": comparison_table,
    "neutral-curves": neutral_curve_table,
    "inferred": inferred_table,
    "involute-tuned": involute_claims.tuned_table,
    "involute-common": involute_claims.common_table,
}


def _row(cells: list[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _least(result: CaseResult) -> str:
    return f"{fixed(result.analysis.min_backlash_um)} @ {result.analysis.min_tooth}"


def main() -> None:
    """Write the pictures and refresh the documents."""
    study = CaseStudy.compute()
    PICTURES.mkdir(parents=True, exist_ok=True)
    for name, content in pictures(study).items():
        (PICTURES / name).write_bytes(content)
    asked = [Path(name).resolve() for name in sys.argv[1:]]
    for document in asked or documents():
        text = document.read_text(encoding="utf-8")
        document.write_text(refreshed(text, study, PICTURES), encoding="utf-8")
        print(f"  {document.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
