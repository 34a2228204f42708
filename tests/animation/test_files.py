"""Animated files, read back: frames, speed, and the marks of both splines moving the right way."""

from __future__ import annotations

import io
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from numpy.typing import NDArray
from PIL import Image, ImageSequence

from strainwave.analysis import Analysis, analyze
from strainwave.animation import Film, animate, animation_bytes
from strainwave.animation.gif import gif_bytes
from strainwave.animation.stage import DOTS_PER_INCH, SIZE, pictures
from strainwave.errors import StrainwaveError
from strainwave.plots.clearance_colours import OVERLAP
from strainwave.plots.style import GREEN
from tests.designs import case

FRAMES = 6
HEIGHT, WIDTH = round(SIZE[1] * DOTS_PER_INCH), round(SIZE[0] * DOTS_PER_INCH)


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analyze(case("dual-disk-0848-calibrated"))


def film(analysis: Analysis, fixed: Any = "circular-spline", turns: float = 0.5) -> Film:
    return Film.of(analysis, frames=FRAMES, turns=turns, fixed=fixed, frames_per_s=20.0)


def marks(picture: NDArray[np.uint8]) -> tuple[float, float]:
    """Where the marks of space 0 and of tooth 0 are across the magnified view, in pixels: the upper, the lower."""
    near = picture[: int(0.85 * HEIGHT), WIDTH // 2 :]
    green = np.abs(near / 255.0 - to_rgb(GREEN)).max(axis=-1) < 0.05
    rows, columns = np.nonzero(green)
    upper = rows < 0.5 * (rows.min() + rows.max())
    return float(columns[upper].mean()), float(columns[~upper].mean())


@pytest.mark.parametrize(("fixed", "turns"), [("circular-spline", 0.5), ("flexspline", 0.5), ("circular-spline", -0.5)])
def test_the_marks_move_as_the_splines_turn(analysis: Analysis, fixed: str, turns: float) -> None:
    """Against a generator that turns clockwise the flexspline creeps to the left at the top; where it is held, the
    circular spline creeps to the right."""
    frames = list(pictures(film(analysis, fixed, turns)))
    assert len(frames) == FRAMES
    assert frames[0].shape == (HEIGHT, WIDTH, 3)
    (ring_before, tooth_before), (ring_after, tooth_after) = marks(frames[0]), marks(frames[-1])
    ring, tooth = ring_after - ring_before, tooth_after - tooth_before
    # 150 degrees are 0.83 of a tooth of the flexspline and 0.83 of one of the circular spline: about 2 mm.
    if fixed == "flexspline":
        assert ring > 40.0
        assert abs(tooth) < 20.0  # it moves with its rim, and comes back
    else:
        assert np.sign(tooth) == -np.sign(turns)
        assert abs(tooth) > 30.0
        assert abs(ring) < 1.0


def test_frames_leave_nothing_of_those_before(analysis: Analysis) -> None:
    first, *_, last = pictures(film(analysis))
    alone = next(iter(pictures(Film(analysis, np.array([150.0]), "circular-spline", 20.0))))
    assert (np.abs(last.astype(int) - alone).max(axis=-1) > 8).mean() < 1e-3
    assert (np.abs(last.astype(int) - first).max(axis=-1) > 8).mean() > 1e-2


def test_interference_is_seen_in_the_frames(analysis: Analysis) -> None:
    clear = analyze(case("cosine-calibrated"))
    overlap = [
        float((np.abs(next(iter(pictures(film(each)))) / 255.0 - to_rgb(OVERLAP)).max(axis=-1) < 0.03).mean())
        for each in (analysis, clear)
    ]
    assert overlap[0] > 5.0 * overlap[1]


def test_a_gif_has_all_frames_and_loops(analysis: Analysis) -> None:
    with Image.open(io.BytesIO(animation_bytes(film(analysis), "gif"))) as found:
        assert (found.n_frames, found.size) == (FRAMES, (WIDTH, HEIGHT))  # type: ignore[attr-defined]
        assert (found.info["duration"], found.info["loop"]) == (50, 0)
        found.seek(FRAMES - 1)
        shown = np.asarray(found.convert("RGB"))
    last = list(pictures(film(analysis)))[-1]
    assert np.abs(shown.astype(int) - last).max(axis=-1).mean() < 4.0


@pytest.mark.parametrize("rate", [1.0, 20.0, 24.0, 29.97, 33.0, 40.0, 50.0])
def test_a_gif_lasts_as_long_as_its_frames(rate: float) -> None:
    """Read back: every frame ends within half a hundredth of a second, in which the format counts, of its time."""
    count = 100
    frames = (np.full((4, 4, 3), 255 * (number % 2), dtype=np.uint8) for number in range(count))
    with Image.open(io.BytesIO(gif_bytes(frames, count, rate))) as found:
        lasting = [frame.info["duration"] for frame in ImageSequence.Iterator(found)]
    assert len(lasting) == count
    np.testing.assert_allclose(np.cumsum(lasting) / 1e3, np.arange(1, count + 1) / rate, atol=0.005 + 1e-9)
    assert min(lasting) >= 20  # what is shorter, most programs show for 100 ms


def test_a_gif_is_not_faster_than_programs_show_it(analysis: Analysis, tmp_path: Path) -> None:
    drawn: list[tuple[int, int]] = []
    with pytest.raises(
        StrainwaveError, match=r"a GIF shows at most 50 frames per second, not 60: take fewer, or write"
    ):
        animate(analysis, tmp_path / "a.gif", frames=2, frames_per_s=60.0, progress=lambda *done: drawn.append(done))
    assert drawn == []
    assert list(tmp_path.iterdir()) == []
    animate(analysis, tmp_path / "a.html", frames=2, frames_per_s=60.0)


def test_an_mp4_has_all_frames_and_its_speed(analysis: Analysis, tmp_path: Path) -> None:
    from imageio_ffmpeg import get_ffmpeg_exe

    file = tmp_path / "turning.mp4"
    animate(analysis, file, frames=FRAMES, turns=0.5)
    raw = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    read = subprocess.run([get_ffmpeg_exe(), "-i", file, *raw], capture_output=True, check=True)
    about = read.stderr.decode()
    for known in ("Video: h264", "yuv420p", f"{WIDTH}x{HEIGHT}", "20 fps"):
        assert known in about
    frames = np.frombuffer(read.stdout, dtype=np.uint8).reshape(-1, HEIGHT, WIDTH, 3)
    assert len(frames) == FRAMES
    assert np.abs(frames[-1].astype(int) - list(pictures(film(analysis)))[-1]).mean() < 6.0


def test_progress_is_told(analysis: Analysis, tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    animate(analysis, tmp_path / "a.html", frames=3, progress=lambda done, total: told.append((done, total)))
    assert told == [(1, 3), (2, 3), (3, 3)]


def test_without_imageio_one_message_says_what_to_install(
    analysis: Analysis, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(StrainwaveError, match=r"MP4 files need imageio-ffmpeg .* pip install 'strainwave\[video\]'"):
        animate(analysis, tmp_path / "a.mp4", frames=2)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["a.avi", "a", "a.gif.zip"])
def test_another_format_is_refused(analysis: Analysis, tmp_path: Path, name: str) -> None:
    with pytest.raises(StrainwaveError, match=r"must end in \.gif, \.mp4 or \.html"):
        animate(analysis, tmp_path / name)


def test_an_interrupt_leaves_no_file(analysis: Analysis, tmp_path: Path) -> None:
    def interrupt(done: int, _total: int) -> None:
        if done == 2:
            raise KeyboardInterrupt

    for name in ("a.gif", "a.mp4", "a.html"):
        with pytest.raises(KeyboardInterrupt):
            animate(analysis, tmp_path / name, frames=4, progress=interrupt)
    assert list(tmp_path.iterdir()) == []
