"""What stands in a field that is left empty."""

from __future__ import annotations

import pytest

from strainwave.design import Design
from strainwave.studio.form.field import Field
from strainwave.studio.form.group import CUP, fields_of, groups_of
from strainwave.studio.form.usual import alternatives, usual, usual_text
from tests.designs import case


def _field(design: Design, key: str) -> Field:
    return next(field for group in groups_of(design.to_dict()) for field in group.fields if field.key == key)


@pytest.mark.parametrize("name", ["cosine", "dual-disk-0900"])
def test_giving_what_is_usual_changes_no_size(name: str) -> None:
    design = case(name)
    groups = {group.name: group for group in groups_of(design.to_dict())}
    keys = {field.key: usual(field, design) for field in groups[CUP].fields}
    assert None not in keys.values()
    given = design.replace(keys)
    for attribute in vars(design.bodies):
        assert getattr(given.bodies, attribute) == pytest.approx(getattr(design.bodies, attribute), rel=1e-12)


def test_the_neutral_circle_lies_in_the_middle_of_the_wall() -> None:
    design = case()
    field = _field(design, "flexspline.neutral_radius")
    # m z / 2 - h_f* m - wall / 2
    assert usual(field, design) == pytest.approx(0.8 * 204 / 2 - 1.212 * 0.8 - 1.6 / 2, rel=1e-15)
    assert usual_text(field, design) == "79.8304"


def test_a_default_of_the_schema_is_shown() -> None:
    design = case()
    assert usual_text(_field(design, "circular_spline.profile.root_fillet_radius"), design) == "0"


def test_nothing_is_shown_for_what_nothing_replaces() -> None:
    design = case()
    assert usual_text(_field(design, "wave_generator.bearing_height"), design) == ""
    assert usual_text(_field(design, "wave_generator.w0"), design) == ""


def test_wrap_angle_and_disk_radius_follow_from_each_other() -> None:
    wrapped = case().replace("wave_generator", {"kind": "dual-disk", "w0": 0.9, "wrap_angle": 13.0})
    fields = {field.key: field for field in fields_of("wave_generator", "dual-disk")}
    radius = usual(fields["wave_generator.disk_radius"], wrapped)
    assert radius is not None
    assert radius < wrapped.neutral_radius_mm
    given = case().replace("wave_generator", {"kind": "dual-disk", "w0": 0.9, "disk_radius": radius})
    assert usual(fields["wave_generator.wrap_angle"], given) == pytest.approx(13.0, abs=1e-9)
    assert usual(fields["wave_generator.wrap_angle"], wrapped) is None


def test_one_of_two_takes_the_other_out() -> None:
    assert alternatives("wave_generator.disk_radius") == ("wave_generator.wrap_angle",)
    assert alternatives("wave_generator.w0") == ()
