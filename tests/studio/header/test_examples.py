"""Ready designs."""

from __future__ import annotations

from pathlib import Path

from strainwave.studio.header.examples import examples
from tests.designs import CASE_STUDY

DESIGNS = CASE_STUDY.parent


def test_every_ready_design_is_offered_as_it_stands() -> None:
    """All design files of the repository, to the last byte, whatever their comments."""
    ready = {path.read_bytes(): path for folder in ("case-study", "involute") for path in (DESIGNS / folder).iterdir()}
    offered = [file.content for file in examples()]
    assert len(offered) == len(set(offered)) == len(ready)
    assert set(offered) == set(ready)


def test_no_two_have_the_same_name() -> None:
    assert len({file.name for file in examples()}) == len({file.design.title for file in examples()}) == len(examples())


def test_their_files_lie_in_the_package() -> None:
    import strainwave

    package = Path(strainwave.__file__).parent
    assert (package / "studio" / "header" / "examples" / "involute-cosine.toml").is_file()
