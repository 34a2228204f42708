"""Two numbers a line, whatever stands between them and whichever sign the decimals have."""

from __future__ import annotations

from pathlib import Path

import pytest

from strainwave.errors import StrainwaveError
from strainwave.imports.points_file import read_points
from tests.imports.files import Floats, points, written

REST = [[float(place), -1.0] for place in range(3, 10)]


def rounded() -> Floats:
    """Points of a tooth; some numbers are whole, some so small that programs write them with an exponent."""
    places = points("flexspline", whole=True).round(6)
    places[20] = places[20].round()
    places[30:33] *= 1e-6
    return places


def decimal_comma(number: float) -> str:
    return repr(number).removesuffix(".0").replace(".", ",").upper()


@pytest.mark.parametrize("between", [";", "\t", " ; ", "  ", ";\t"])
@pytest.mark.parametrize("after", ["", ";"])
def test_decimal_commas(tmp_path: Path, between: str, after: str) -> None:
    """As spreadsheets write them where the comma is the decimal sign."""
    text = "".join(f"{decimal_comma(x)}{between}{decimal_comma(y)}{after}\n" for x, y in rounded().tolist())
    assert "E-0" in text
    path = written(tmp_path, "tooth.csv", f"X [mm]{between}Y [mm]\n{text}")
    assert read_points(path).tolist() == rounded().tolist()


@pytest.mark.parametrize("between", [",", ", ", " ,", " , ", ";", "\t", " ", ",\t", ";;"])
@pytest.mark.parametrize("after", ["", ",", " ;"])
def test_decimal_points(tmp_path: Path, between: str, after: str) -> None:
    lines = (f"{x!r}{between}{y!r}{after}\n" for x, y in rounded().tolist())
    path = written(tmp_path, "tooth.csv", f"# a tooth\nX{between}Y\n{''.join(lines)}")
    assert read_points(path).tolist() == rounded().tolist()


@pytest.mark.parametrize(
    "line", ["1,2", "1, 2", "1 ,2", "1 , 2", "1,2;", "1,2,", ",1,2", "1;2", "1\t2", "+1,2e0", "1.,2."]
)
def test_a_comma_between_whole_numbers_is_no_decimal_comma(tmp_path: Path, line: str) -> None:
    rest = "".join(f"{x},{y}\n" for x, y in REST)
    assert read_points(written(tmp_path, "tooth.csv", f"{line}\n{rest}")).tolist() == [[1.0, 2.0], *REST]


@pytest.mark.parametrize(
    "line",
    [
        "1,2,3",
        "1, 2, 3",
        "1,2 3,4,5",
        "0,4,0,7",
        "0,4;0,7;0",
        "1,2.5 3",
        "1.000,5 2",
        ",5;1,25",
        "1,5;2,5 mm",
        "1,5e;2",
    ],
)
def test_commas_of_two_meanings_are_refused(tmp_path: Path, line: str) -> None:
    path = written(tmp_path, "tooth.csv", f"0.1,0.2\n{line}\n")
    with pytest.raises(StrainwaveError, match=r"line 2 must hold two numbers, x and y, and reads: "):
        read_points(path)
