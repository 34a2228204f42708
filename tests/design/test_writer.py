"""Designs written and read back."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import pytest

from strainwave.design import Design, dumps, load, loads, save
from strainwave.errors import StrainwaveError
from strainwave.wave_generators import Table
from tests.designs import CASES, case, circular_spline_as_pieces

PIECES = case().replace("circular_spline.profile", circular_spline_as_pieces())
TABLE = Table.of(lambda phi: 0.848 * math.cos(2.0 * phi) ** 3)
DESIGNS = [
    *(case(name + reading) for name in CASES for reading in ("", "-calibrated")),
    PIECES.replace("circular_spline.profile.pieces[1].corner", True),
    case().replace("wave_generator", TABLE.model_dump(exclude_none=True)),
    case().replace("wave_generator", {"kind": "ellipse", "w0": 1e-4, "cam_to_neutral": 1e-5}),
    case().replace("flexspline.profile.flank_angle", 1.0 / 3.0),
    case().replace("name", 'quotes " \\ \t\n\x00\x1f\x7f ü € 🙂 \u2028'),
    case().replace("flexspline.neutral_radius", 80),
]


@pytest.mark.parametrize("design", DESIGNS, ids=range(len(DESIGNS)))
def test_a_written_design_reads_back_equal_and_writes_the_same_text(design: Design) -> None:
    text = dumps(design)
    assert loads(text) == design
    assert dumps(loads(text)) == text


def test_the_text_reads_like_one_written_by_hand() -> None:
    text = dumps(case())
    assert text.startswith('name = "Case study, cosine cam"\nmodule = 0.8\n\n[flexspline]\nteeth = 204\n')
    assert 'flank_angle = "7°30\'30\\""' in text
    assert "flank_angle = 8.4\n" in text
    assert next(iter(tomllib.loads(text)["wave_generator"])) == "kind"
    assert "None" not in text


def test_a_design_is_saved_and_loaded(tmp_path: Path) -> None:
    path = tmp_path / "gear.toml"
    save(case(), path)
    assert load(path) == case()


def test_a_file_is_overwritten_only_on_request(tmp_path: Path) -> None:
    path = tmp_path / "gear.toml"
    path.write_text("mine")
    with pytest.raises(StrainwaveError, match="is there already"):
        save(case(), path)
    assert path.read_text() == "mine"
    save(case(), path, overwrite=True)
    assert load(path) == case()
