"""Backlash along the face: against plane designs, exact sections of the inclined teeth, and limits."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from strainwave.analysis import FaceMap, analyze, face_map
from strainwave.analysis.lobe import drive_teeth
from strainwave.columns import Floats
from strainwave.cup import Cup
from strainwave.errors import DesignError, StrainwaveError
from tests.batch.variations import GENERATORS, PROFILES, varied_design
from tests.designs import case


@pytest.fixture(scope="module")
def cosine() -> FaceMap:
    return face_map(analyze(case("cosine-calibrated")))


@pytest.mark.parametrize("name", GENERATORS)
@pytest.mark.parametrize("angle", [0.0, 37.3])
def test_the_section_at_mid_face_is_the_plane_result(name: str, angle: float) -> None:
    analysis = analyze(varied_design(name), generator_angle_deg=angle)
    found = face_map(analysis, 3)
    at = found.mid_face
    assert found.w0_mm[at] == 0.848
    assert found.gap_um[at] == pytest.approx(analysis.teeth.backlash_um, abs=1e-9)
    assert found.min_backlash_um[at] == pytest.approx(analysis.min_backlash_um, abs=1e-9)
    assert found.min_in_motion_um[at] == pytest.approx(analysis.min_in_motion_um, abs=1e-9)
    assert found.min_in_motion_index[at] == pytest.approx(analysis.min_in_motion_index, abs=1e-9)


@pytest.mark.parametrize("profile", PROFILES)
def test_every_section_is_a_plane_gear_with_the_displacement_that_the_cup_has_there(profile: str) -> None:
    """A cosine has one shape, so a section is the design with another w0: a way round the cup."""
    design = varied_design("cosine", profile)
    found = face_map(analyze(design), 5)
    for w0, gaps, least in zip(found.w0_mm.tolist(), found.gap_um, found.min_in_motion_um.tolist(), strict=True):
        plane = analyze(design.replace("wave_generator.w0", w0))
        assert gaps == pytest.approx(plane.teeth.backlash_um, abs=1e-9)
        assert least == pytest.approx(plane.min_in_motion_um, abs=1e-9)


def test_a_long_cup_has_hardly_a_cone() -> None:
    """Halving the slope halves how far the ends of the face depart from mid-face."""
    departures = []
    for length in (2000.0, 4000.0, 8000.0):
        found = face_map(analyze(case("cosine-calibrated").replace("flexspline.cup_length", length)), 3)
        departures.append(np.abs(found.gap_um[[0, 2]] - found.gap_um[1]).max())
    assert departures[0] / departures[1] == pytest.approx(2.0, rel=0.05)
    assert departures[1] / departures[2] == pytest.approx(2.0, rel=0.05)


def test_the_least_of_all_teeth_counts_the_other_lobe_of_an_odd_number() -> None:
    """With an odd number the second lobe sees half indices."""
    design = case().replace({"flexspline.teeth": 203, "circular_spline.teeth": 205})
    analysis = analyze(design)
    found = face_map(analysis, 3)
    assert found.drive_gap_um.shape == (3, 203)
    assert found.min_backlash_um == pytest.approx(found.drive_gap_um.min(axis=1))
    numbers = drive_teeth(203).tolist()
    lobe = [numbers.index(tooth) for tooth in analysis.teeth.tooth.tolist()]
    assert found.drive_gap_um[:, lobe] == pytest.approx(found.gap_um, abs=1e-9)
    assert found.min_backlash_um[1] == pytest.approx(analysis.min_backlash_um, abs=1e-9)


def test_the_worst_section_has_the_least_backlash_in_motion(cosine: FaceMap) -> None:
    assert len(cosine) == 11
    assert cosine.worst == 0
    assert cosine.worst_in_motion_um == cosine.min_in_motion_um.min()
    assert cosine.interference
    assert not cosine.analysis.interference
    assert set(cosine.interfering_sections) == {0, 1, 2, 3, 4, 7, 8, 9, 10}
    assert cosine.w0_open_end_mm == pytest.approx(cosine.w0_mm[-1])


def test_the_tilt_bound_holds_and_is_not_idle(cosine: FaceMap) -> None:
    """Points of a tooth where the cutting plane really meets it, against the section's own points.

    A point at the height h above the neutral curve lies h dw/dz nearer to the diaphragm than its section, so the plane
    at z meets that of the section h dw/dz beyond; and the inclined height is h / sqrt(1 + (dw/dz)²).
    """
    geometry, design = cosine.analysis.geometry, cosine.analysis.design
    cup, profile = Cup.of(design), geometry.flexspline
    half = profile.position(np.linspace(0.0, profile.length, 200))
    from_neutral = np.array([0.0, profile.pitch_radius - design.neutral_radius_mm])
    points = np.concatenate([half, half * (-1.0, 1.0)]) + from_neutral
    greatest = 0.0
    for z in (cup.mid_face_mm - 13.0, cup.mid_face_mm, cup.mid_face_mm + 13.0):
        for index in np.linspace(0.0, 51.0, 18).tolist():
            step = 1e-3
            before, after = (_neutral_point(cup, index, z + shift) for shift in (-step, step))
            normal = _neutral_point(cup, index, z)[2]
            slope = ((after - before)[:2] @ [math.sin(normal), math.cos(normal)]) / (2.0 * step)
            for point in points[::10]:
                met = z + point[1] * slope
                own = _placed(_neutral_point(cup, index, z), point)
                really = _placed(_neutral_point(cup, index, met), point * (1.0, 1.0 / math.hypot(1.0, slope)))
                greatest = max(greatest, float(np.hypot(*(really - own))))
    assert 0.7 * cosine.tilt_bound_um < 1000.0 * greatest <= cosine.tilt_bound_um


def _neutral_point(cup: Cup, index: float, z: float) -> Floats:
    curve = cup.curve(float(cup.w0_mm(z)))
    phi = float(curve.angle_at(index * curve.perimeter / 204))
    x, y = curve.position(phi)
    return np.array([x, y, phi + float(curve.psi(phi))])


def _placed(neutral: Floats, point: Floats) -> Floats:
    x, y, angle = neutral.tolist()
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([x + cosine * point[0] + sine * point[1], y - sine * point[0] + cosine * point[1]])


@pytest.mark.parametrize("sections", [0, 1, 2, 10, -3, 10_003, 3.0, True])
def test_there_is_an_odd_number_of_sections(sections: int) -> None:
    with pytest.raises(StrainwaveError, match="odd whole number from 3 to 10001"):
        face_map(analyze(case()), sections)


def test_a_cup_that_cannot_be_bent_so_far_names_the_section() -> None:
    design = case().replace({"wave_generator.w0": 10.0, "flexspline.cup_length": 40.0, "flexspline.face_width": 37.0})
    analysis = analyze(design)
    with pytest.raises(DesignError) as caught:
        face_map(analysis, 3)
    (fault,) = caught.value.faults
    assert fault.key == "wave_generator.w0"
    assert "mm of the section 40 mm from the diaphragm's outer face, where" in str(fault)
    assert "lengthen flexspline.cup_length" in str(fault)


def test_the_record_has_stable_keys(cosine: FaceMap) -> None:
    record = json.loads(cosine.to_json())
    assert record["schema_version"] == 1
    assert record["min_in_motion_um"] == cosine.analysis.min_in_motion_um
    face = record["face"]
    assert list(face) == [
        "min_in_motion_um",
        "interference",
        "worst_section",
        "mid_face_section",
        "w0_mid_face_mm",
        "w0_open_end_mm",
        "tilt_bound_um",
        "sections",
    ]
    section = face["sections"][face["mid_face_section"]]
    assert list(section) == [
        "z_mm",
        "w0_mm",
        "min_backlash_um",
        "min_in_motion_um",
        "min_in_motion_index",
        "backlash_um",
    ]
    assert section["backlash_um"] == cosine.gap_um[5].tolist()
    assert len(face["sections"]) == 11
    assert cosine.as_dict() == face


def test_the_csv_has_a_row_for_each_section_and_tooth(cosine: FaceMap, tmp_path: Path) -> None:
    path = tmp_path / "face.csv"
    cosine.to_csv(path)
    header, *rows = path.read_text().splitlines()
    assert header == "z_mm,w0_mm,tooth,index,backlash_um"
    values = np.array([row.split(",") for row in rows], dtype=np.float64)
    assert values.shape == (11 * 103, 5)
    assert values[:, 4].reshape(11, 103).tolist() == cosine.gap_um.tolist()
    assert np.unique(values[:, 0]).tolist() == cosine.z_mm.tolist()
    with pytest.raises(StrainwaveError, match="is there already"):
        cosine.to_csv(path)
