"""Files that mean harm or nothing: one clear message and bounded memory."""

from __future__ import annotations

import io
import subprocess
import sys
import tracemalloc
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from ezdxf.filemanagement import new
from hypothesis import given, settings
from hypothesis import strategies as st

from strainwave.errors import StrainwaveError
from strainwave.imports import import_flank
from strainwave.imports.source import LARGEST_FILE_BYTES
from tests.imports.files import CALIBRATED, points, written

MEMORY_BYTES = 150_000_000


def refusal(path: Path) -> str:
    """The message that a file is refused with, on one line, and within the memory allowed."""
    tracemalloc.start()
    try:
        with pytest.raises(StrainwaveError) as caught:
            import_flank(path, CALIBRATED, "flexspline")
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    message = str(caught.value)
    assert peak < MEMORY_BYTES
    assert "\n" not in message
    assert len(message) < 600
    assert message.startswith(str(path))
    return message.removeprefix(f"{path}: ")


def dxf(folder: Path, document: Any) -> Path:
    text = io.StringIO()
    document.write(text)
    return written(folder, "drawn.dxf", text.getvalue())


@pytest.mark.parametrize("name", ["tooth.csv", "tooth.dxf", "tooth.json"])
def test_a_huge_file_is_not_read(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    with path.open("wb") as file:
        file.truncate(50_000_000_000)
    assert refusal(path).startswith("is larger than 2 MB")


@pytest.mark.parametrize("name", ["tooth.csv", "tooth.dxf", "tooth.json"])
def test_a_binary_file(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(bytes(range(256)) * 10)
    assert refusal(path).startswith("is a binary file")


@pytest.mark.parametrize("name", ["tooth.csv", "tooth.dxf", "tooth.json"])
def test_an_empty_file_a_directory_and_none(tmp_path: Path, name: str) -> None:
    assert refusal(written(tmp_path, name, "")) != ""
    (tmp_path / "folder").mkdir()
    folder = tmp_path / "folder" / name
    folder.mkdir()
    assert refusal(folder).startswith("is a directory")
    assert refusal(tmp_path / "none" / name) == "there is no such file"


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("x,y\n0.1,0.2\n0.3,nan\n", "line 3 must hold finite numbers, and reads: 0.3,nan"),
        ("0.1,0.2\n0.3,inf\n", "line 2 must hold finite numbers"),
        ("0.1,0.2\n0.3,1e999\n", "line 2 must hold finite numbers"),
        ("0.1,0.2\n0.3\n", "line 2 must hold two numbers, x and y, and reads: 0.3"),
        ("0.1,0.2\n0.3,0.4,0.5\n", "line 2 must hold two numbers"),
        ("0.1,0.2\nhello\x1b[31m world\n", r"line 2 must hold two numbers, x and y, and reads: hello\x1b[31m world"),
        ("0.1,0.2\n" * 10_000, "holds 1 different points; a flank needs 8 or more"),
        ("<html>\n<body>\n", "holds 0 different points"),
        ("1e300,1e300\n2e300,1e300\n" * 20, "from its origin"),
        ("0,0\n1e-300,0\n" * 20, "mm high"),
    ],
)
def test_points_that_are_none(tmp_path: Path, content: str, problem: str) -> None:
    assert problem in refusal(written(tmp_path, "tooth.csv", content))


def test_a_point_that_follows_itself_counts_once(tmp_path: Path) -> None:
    lines = [f"{x!r};{y!r}\n" for x, y in points("flexspline", whole=True).tolist()]
    once = import_flank(written(tmp_path, "once.csv", "".join(lines)), CALIBRATED, "flexspline")
    doubled = import_flank(written(tmp_path, "twice.csv", "".join(2 * [x][0] for x in lines)), CALIBRATED, "flexspline")
    assert doubled.profile == once.profile


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("[" * 100_000, "nests arrays or objects too deeply"),
        ("{", "is not JSON"),
        ("[1, 2]", 'must hold an object with "start" and "pieces"'),
        ('{"start": [0, 1], "pieces": []}', "pieces must hold at least one piece"),
        ('{"start": [NaN, 1], "pieces": [{"to": [1, 0]}]}', "start[0] = nan modules: must be a number"),
        ('{"start": [0, 1], "pieces": [{"to": [0, 1]}]}', "pieces[0] cannot be: it ends where it begins"),
        ('{"start": [0, 1], "pieces": [{"to": [0.5, -1], "radius": 0.1}]}', "pieces[0] cannot be"),
        ('{"start": [0, 1], "pieces": [{"to": [1, 0], "colour": 3}]}', "pieces[0].colour: is not a key"),
        ('{"unit": "furlong", "start": [0, 1], "pieces": [{"to": [1, 0]}]}', 'unit = "furlong": must be'),
        ('{"start": [0, ' + "9" * 5000 + '], "pieces": []}', "is not JSON"),
    ],
)
def test_pieces_that_are_none(tmp_path: Path, content: str, problem: str) -> None:
    assert problem in refusal(written(tmp_path, "flank.json", content))


def test_blocks_that_multiply_without_end(tmp_path: Path) -> None:
    """Ten references to the next block in each of 40: 10^40 lines."""
    document = new("R2010", units=4)
    for level in range(40):
        block = document.blocks.new(f"B{level}")
        block.add_line((0, 0), (1, 1))
        for place in range(10):
            block.add_blockref(f"B{level + 1}", (place, 0))
    document.modelspace().add_blockref("B0", (0, 0))
    assert refusal(dxf(tmp_path, document)) == "nests blocks more than 8 deep; explode them in the CAD program"


def test_a_block_in_itself(tmp_path: Path) -> None:
    document = new("R2010", units=4)
    block = document.blocks.new("SELF")
    block.add_blockref("SELF", (0, 0))
    document.modelspace().add_blockref("SELF", (0, 0))
    assert "nests blocks more than 8 deep" in refusal(dxf(tmp_path, document))


def test_flat_blocks_that_multiply(tmp_path: Path) -> None:
    """Twenty references in each of five levels, lines at the bottom: 3.2 million."""
    document = new("R2010", units=4)
    for level in range(5):
        block = document.blocks.new(f"B{level}")
        for place in range(20):
            block.add_blockref(f"B{level + 1}", (place, 0))
    document.blocks.new("B5").add_line((0, 0), (1, 1))
    document.modelspace().add_blockref("B0", (0, 0))
    assert "holds more than 5000 entities" in refusal(dxf(tmp_path, document))


def test_a_block_in_a_million_rows(tmp_path: Path) -> None:
    document = new("R2010", units=4)
    document.blocks.new("ONE").add_line((0, 0), (1, 1))
    document.modelspace().add_blockref(
        "ONE", (0, 0), dxfattribs={"row_count": 1000, "column_count": 1000, "row_spacing": 1, "column_spacing": 1}
    )
    assert "repeats a block in rows or columns" in refusal(dxf(tmp_path, document))


def test_drawings_of_something_else(tmp_path: Path) -> None:
    def problem(draw: Any) -> str:
        document = new("R2010", units=4)
        draw(document.modelspace())
        return refusal(dxf(tmp_path, document))

    assert "holds no lines, arcs or curves" in problem(lambda layout: layout.add_text("gear"))
    assert "is closed" in problem(lambda layout: layout.add_lwpolyline([(0, 0), (1, 0), (1, 1)], close=True))
    assert "or draws a piece twice" in problem(
        lambda layout: [layout.add_line((0.4, 0.7), (0.8, -0.8)) for _ in range(3)]
    )
    assert "is closed" in problem(lambda layout: [layout.add_line((0.4, 0.7), (0.8, -0.8)) for _ in range(2)])
    assert "branches at (0.5, 0)" in problem(
        lambda layout: [layout.add_line((0.5, 0), end) for end in ((0.4, 0.7), (0.8, -0.8), (0.3, -0.8))]
    )
    assert "is not flat" in problem(lambda layout: layout.add_line((0.4, 0.7, 0), (0.8, -0.8, 1)))
    assert "no finite numbers" in problem(lambda layout: layout.add_line((0.4, float("nan")), (0.8, -0.8)))
    assert "turns back" in problem(
        lambda layout: layout.add_lwpolyline([(0.4, 0.7), (0.5, -0.4), (0.6, 0.1), (0.8, -0.8)])
    )
    assert "Check the unit" in problem(lambda layout: layout.add_line((40, 70), (80, -80)))
    assert "an entity that cannot be read" in problem(
        lambda layout: layout.add_spline([(0.4, 0.7), (0.4, 0.7), (0.4, 0.7)])
    )


def test_a_drawing_in_a_strange_unit(tmp_path: Path) -> None:
    document = new("R2010", units=20)  # light years
    document.modelspace().add_line((0.4, 0.7), (0.8, -0.8))
    assert "$INSUNITS = 20" in refusal(dxf(tmp_path, document))


def test_the_largest_drawing_of_lines_takes_bounded_memory(tmp_path: Path) -> None:
    """In a process of its own, whose greatest size the system reports: `getrusage` has that of the one it came from."""
    line = "0\nLINE\n8\n0\n10\n{}.0\n20\n0.0\n11\n{}.5\n21\n0.0\n"
    lines = "".join(line.format(place, place) for place in range(42_000))
    path = written(tmp_path, "drawn.dxf", f"0\nSECTION\n2\nENTITIES\n{lines}0\nENDSEC\n0\nEOF\n")
    assert 0.8 * LARGEST_FILE_BYTES < path.stat().st_size < LARGEST_FILE_BYTES
    program = (
        "import re, sys; from pathlib import Path; from strainwave import StrainwaveError\n"
        "from strainwave.imports.dxf_file import read_dxf\n"
        "try: read_dxf(Path(sys.argv[1]), layer=None, unit=None, tolerance_mm=1e-5, module=0.8)\n"
        "except StrainwaveError as error: print(error)\n"
        "print(re.search(r'VmHWM:\\s+(\\d+) kB', Path('/proc/self/status').read_text())[1])"
    )
    done = subprocess.run([sys.executable, "-c", program, str(path)], capture_output=True, text=True, check=True)
    message, kilobytes = done.stdout.splitlines()
    assert "holds more than 5000 entities" in message
    assert int(kilobytes) < 600_000


@given(st.text(max_size=300), st.sampled_from(["csv", "dxf", "json"]))
@settings(max_examples=60)
def test_any_text_is_refused_with_a_message(tmp_path_factory: pytest.TempPathFactory, text: str, suffix: str) -> None:
    path = tmp_path_factory.mktemp("any") / f"tooth.{suffix}"
    path.write_text(text, encoding="utf-8", errors="replace")
    with pytest.raises(StrainwaveError):
        import_flank(path, CALIBRATED, "flexspline")


@given(st.data())
@settings(max_examples=60)
def test_a_damaged_drawing_is_read_or_refused(tmp_path_factory: pytest.TempPathFactory, data: st.DataObject) -> None:
    """Lines of a good drawing exchanged, left out or replaced."""
    document = new("R12")
    document.modelspace().add_line((0.4, 0.72), (0.8, -0.97))
    document.modelspace().add_arc((0, 0), 1.0, 10, 50)
    text = io.StringIO()
    document.write(text)
    lines = text.getvalue().splitlines()
    for _ in range(data.draw(st.integers(1, 6))):
        place = data.draw(st.integers(0, len(lines) - 1))
        lines[place] = data.draw(st.sampled_from(["", "0", "-1", "LINE", "ARC", "nan", "1e999", "ENDSEC", lines[0]]))
    path = tmp_path_factory.mktemp("damaged") / "tooth.dxf"
    path.write_text("\n".join(lines), encoding="utf-8")
    with suppress(StrainwaveError):
        import_flank(path, CALIBRATED, "flexspline")
