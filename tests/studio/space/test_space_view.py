"""What is shown of the gear in space is what the library gives for the design."""

from __future__ import annotations

import gzip
import json
import pickle

import pytest

from strainwave.analysis import analyze, face_map
from strainwave.analysis.verdict import Verdict
from strainwave.design import Design
from strainwave.plots.gear_view import gear_view
from strainwave.plots.interactive import assembly_3d_figure, face_figure
from strainwave.studio.jobs import Limits
from strainwave.studio.space.space_view import DETAILS, NoSpaceView, SpaceRequest, SpaceView, space_view
from tests.export.gears import small_gear

THRESHOLD_UM = 7.0
ANALYSIS = analyze(small_gear(), threshold_um=THRESHOLD_UM)


def answer(design: Design, detail: str = "normal") -> SpaceView | NoSpaceView:
    """What the job gives, after the way into another process and back."""
    request = pickle.loads(pickle.dumps(SpaceRequest(design, THRESHOLD_UM, detail)))
    found: SpaceView | NoSpaceView = pickle.loads(
        pickle.dumps(space_view(request, Limits(), lambda share, words: None))
    )
    return found


def view_of(design: Design, detail: str = "normal") -> SpaceView:
    """The same of a design that has one."""
    view = answer(design, detail)
    assert isinstance(view, SpaceView)
    return view


def test_words_and_pictures_are_those_of_the_library() -> None:
    view = view_of(small_gear())
    face = face_map(ANALYSIS)
    verdict = Verdict.of(ANALYSIS, face)
    assert (view.level, view.sentence) == (verdict.level, verdict.sentence)
    assert view.along_face in [reason.sentence for reason in verdict.reasons]
    gear, own = json.loads(gzip.decompress(view.gear.packed)), json.loads(assembly_3d_figure(ANALYSIS).to_json())
    assert gear["data"] == own["data"]
    assert "text" not in gear["layout"].get("title", {})
    assert json.loads(view.face_figure)["data"] == json.loads(face_figure(face).to_json())["data"]


def test_finer_detail_has_more_triangles() -> None:
    sizes = [view_of(small_gear(), detail).gear.size for detail in DETAILS]
    assert sizes == sorted(set(sizes))


def test_a_map_that_is_known_is_not_computed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    known = face_map(ANALYSIS, 5)
    monkeypatch.setattr("strainwave.plots.gear_view.face_map", lambda analysis: pytest.fail("computed again"))
    assert gear_view(ANALYSIS, face=known).face is known
    assert len(assembly_3d_figure(ANALYSIS, face=known).data) == 4


def test_the_cores_make_no_difference() -> None:
    one, all_of_them = face_map(ANALYSIS, threads=1), face_map(ANALYSIS)
    assert one.min_in_motion_um.tolist() == all_of_them.min_in_motion_um.tolist()


def test_a_cup_that_cannot_be_bent_has_none() -> None:
    short = {"wave_generator.w0": 2.0, "flexspline.cup_length": 10.0, "flexspline.face_width": 8.0}
    found = answer(small_gear().replace(short))
    assert isinstance(found, NoSpaceView)
    assert "lengthen flexspline.cup_length" in found.why
