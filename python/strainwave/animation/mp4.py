"""Frames as an MP4 video (H.264), which browsers and presentations play."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from strainwave.animation.stage import DOTS_PER_INCH, SIZE, Pixels
from strainwave.errors import StrainwaveError

QUALITY = 8  # of 10


def mp4_bytes(frames: Iterable[Pixels], frames_per_s: float) -> bytes:
    """The video as bytes; StrainwaveError where imageio-ffmpeg (extra ``video``) is missing or finds no ffmpeg."""
    width, height = (round(inches * DOTS_PER_INCH) for inches in SIZE)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "turning.mp4"
        writer = _ffmpeg().write_frames(
            str(file), (width, height), fps=frames_per_s, quality=QUALITY, macro_block_size=2, ffmpeg_log_level="error"
        )
        try:
            writer.send(None)
            for pixels in frames:
                writer.send(pixels.tobytes())
        finally:
            writer.close()
        return file.read_bytes()


def _ffmpeg() -> Any:
    try:
        import imageio_ffmpeg

        imageio_ffmpeg.get_ffmpeg_exe()
    except (ImportError, RuntimeError) as error:
        raise StrainwaveError(
            f"MP4 files need imageio-ffmpeg ({error}): pip install 'strainwave[video]', or name a .gif or .html"
        ) from None
    return imageio_ffmpeg
