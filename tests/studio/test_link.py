"""A design in an address."""

from __future__ import annotations

import base64
import re
import tracemalloc
import zlib
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from strainwave.design import Design, dumps
from strainwave.errors import DesignError, StrainwaveError
from strainwave.studio import link
from strainwave.studio.header.examples import examples
from strainwave.studio.link import LONGEST_CODE, coded_design, design_code
from strainwave.toml_file import LARGEST_FILE_BYTES
from strainwave.wave_generators.table import GREATEST_COUNT
from tests.designs import case
from tests.property.test_design_reader import DESIGNS, mutated_trees

READY = [file.design for file in examples()]
IN_AN_ADDRESS = re.compile(r"[A-Za-z0-9_-]+")


def packed(content: bytes) -> str:
    return base64.urlsafe_b64encode(zlib.compress(content, 9)).rstrip(b"=").decode()


def returned(design: Design) -> Design:
    code = design_code(design)
    assert code is not None
    assert IN_AN_ADDRESS.fullmatch(code)
    return coded_design(code)


@pytest.mark.parametrize("design", [*READY, *DESIGNS], ids=lambda design: design.title)
def test_every_ready_design_comes_back(design: Design) -> None:
    assert returned(design) == design
    assert dumps(returned(design)) == dumps(design)


@given(st.text(max_size=200), st.floats(0.01, 3.0), st.lists(st.floats(-1.0, 1.0), min_size=3, max_size=40))
def test_any_name_and_any_number_come_back_to_the_last_bit(name: str, w0: float, samples: list[float]) -> None:
    try:
        design = case().replace({"name": name, "wave_generator": {"kind": "table", "w0": w0, "samples": samples}})
    except DesignError:
        design = case().replace({"name": name, "wave_generator.w0": w0})
    assert returned(design) == design


@settings(max_examples=200)
@given(mutated_trees())
def test_a_mutated_design_comes_back(tree: dict[str, object]) -> None:
    try:
        design = Design.from_dict(tree)
    except DesignError:
        return
    code = design_code(design)
    assert code is None or coded_design(code) == design


@settings(max_examples=400)
@given(st.one_of(st.text(), st.text(alphabet="ABCxyz019-_+/="), st.binary().map(packed)))
def test_garbage_is_one_error(code: str) -> None:
    with pytest.raises(StrainwaveError) as error:
        coded_design(code)
    assert str(error.value)
    assert all(line.isprintable() for line in str(error.value).splitlines())


@given(st.data())
def test_a_damaged_link_is_an_error_and_never_another_design(data: st.DataObject) -> None:
    """A checksum stands at its end."""
    code = design_code(case())
    assert code is not None
    place = data.draw(st.integers(0, len(code) - 1))
    letter = data.draw(st.sampled_from("AZaz09-_"))
    damaged = data.draw(
        st.sampled_from(
            [code[:place], code[place + 1 :], code[:place] + letter + code[place + 1 :], code + code[place:]]
        )
    )
    try:
        # The last letter's bits beyond the last byte say nothing.
        assert coded_design(damaged) == case()
        assert damaged[:-1] == code[:-1]
    except StrainwaveError:
        assert damaged != code


def test_a_link_without_its_end_or_with_more_than_that_is_damaged() -> None:
    packed_file = zlib.compress(dumps(case()).encode(), 9)
    assert coded_design(base64.urlsafe_b64encode(packed_file).decode()) == case()
    for damaged in (packed_file[:-1], packed_file[:-4], packed_file + b"more"):
        with pytest.raises(StrainwaveError, match="damaged"):
            coded_design(base64.urlsafe_b64encode(damaged).decode())


def test_a_bomb_is_not_unpacked() -> None:
    """A link of its length could hold 12 MB; of them no more is unpacked than a file may have."""
    bomb = packed(b"#" * 10_000_000)
    assert len(bomb) < LONGEST_CODE
    tracemalloc.start()
    try:
        with pytest.raises(StrainwaveError, match="larger than 1 MB"):
            coded_design(bomb)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < 3 * LARGEST_FILE_BYTES


def test_a_link_that_is_too_long_is_neither_made_nor_read(monkeypatch: pytest.MonkeyPatch) -> None:
    code = design_code(case())
    assert code is not None
    monkeypatch.setattr(link, "LONGEST_CODE", len(code))
    assert coded_design(code) == case()
    monkeypatch.setattr(link, "LONGEST_CODE", len(code) - 1)
    assert design_code(case()) is None
    with pytest.raises(StrainwaveError, match=f"{len(code)} characters"):
        coded_design(code)


def test_the_longest_table_of_a_wave_generator_has_a_link() -> None:
    random = Random(1)
    samples = [1.0, *(random.uniform(-1.0, 1.0) for _ in range(GREATEST_COUNT - 2)), -1.0]
    design = case().replace("wave_generator", {"kind": "table", "w0": 0.8, "samples": samples})
    assert returned(design) == design
