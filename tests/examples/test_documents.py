"""README and documentation say what the code does today: their examples run, their numbers and pictures are current."""

from __future__ import annotations

import io
import re
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from PIL import Image

import strainwave
from benchmarks.documents import PICTURES, ROOT, description, documents, example_folder, pictures, refreshed
from strainwave.analysis import analyze
from strainwave.analysis.case_study import CaseStudy
from strainwave.cli import main
from strainwave.design import json_schema
from tests.designs import case

NAMES = [str(document.relative_to(ROOT)) for document in documents()]
PYTHON = re.compile(r"^```python\n(?P<code>.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\((?!https?:)(?P<target>[^)#]+)")


@pytest.fixture(scope="module")
def study() -> CaseStudy:
    return CaseStudy.compute()


def read(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


@pytest.mark.parametrize("name", NAMES)
def test_a_document_is_up_to_date(name: str, study: CaseStudy, tmp_path: Path) -> None:
    """Otherwise: python benchmarks/documents.py, with the document's name or for all."""
    assert read(name) == refreshed(read(name), study, tmp_path, samples=False)
    for drawn in tmp_path.iterdir():
        assert_looks_the_same(PICTURES / drawn.name, drawn.read_bytes())


@pytest.mark.parametrize("name", [name for name in NAMES if PYTHON.search(read(name))])
def test_python_examples_run(name: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    with example_folder() as folder:
        monkeypatch.chdir(folder)
        with pytest.raises(SystemExit):
            main(["new", "--out", "my-gear.toml"])
        known: dict[str, object] = {}
        for example in PYTHON.finditer(read(name)):
            for written in folder.glob("*.csv"):
                written.unlink()  # examples of one page may write the same file
            exec(compile(example["code"], name, "exec"), known)
        monkeypatch.undo()
    assert "Traceback" not in capsys.readouterr().err


def test_the_example_of_the_readme_has_at_most_15_lines_and_says_what_it_computes(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    found = PYTHON.search(read("README.md"))
    assert found is not None
    assert sum(bool(line) for line in found["code"].splitlines()) <= 15
    with example_folder() as folder:
        monkeypatch.chdir(folder)
        exec(compile(found["code"], "README.md", "exec"), {})
        monkeypatch.undo()
    out = capsys.readouterr().out
    assert "least gap in motion 1.49 µm at tooth index 36.0" in out
    assert "39 teeth per side nearly touch; interference: False" in out


@pytest.mark.parametrize("name", NAMES)
def test_links_lead_somewhere(name: str) -> None:
    folder = (ROOT / name).parent
    broken = [found["target"] for found in LINK.finditer(read(name)) if not (folder / found["target"]).exists()]
    assert broken == []


@pytest.mark.parametrize("name", ["case-study", "backlash", "mesh"])
def test_a_picture_is_up_to_date(name: str, study: CaseStudy) -> None:
    """Otherwise: python benchmarks/documents.py. A picture says in its metadata which figures it shows."""
    with Image.open(PICTURES / f"{name}.png") as picture:
        assert picture.info["Description"] == description(name, study)


def test_the_pictures_look_as_drawn_today(study: CaseStudy) -> None:
    """But for fonts, which differ a little between versions of matplotlib."""
    for name, content in pictures(study).items():
        assert_looks_the_same(PICTURES / name, content)


def assert_looks_the_same(kept: Path, content: bytes) -> None:
    drawn, before = (np.asarray(matplotlib.image.imread(picture)) for picture in (io.BytesIO(content), kept))
    assert drawn.shape == before.shape, kept.name
    assert float((np.abs(drawn - before).max(axis=-1) > 0.2).mean()) < 0.02, kept.name


def test_the_json_keys_are_all_documented() -> None:
    page = read("docs/commands/analyze.md")
    record = analyze(case()).as_dict()
    for key in [*record, *record["teeth"][0], *record["play"], *record["teeth_below"], *record["certificate"]]:
        assert f"`{key}`" in page, key


def test_the_keys_of_a_design_file_are_all_documented() -> None:
    page = read("docs/design-file.md")
    for table in [json_schema(), *json_schema()["$defs"].values()]:
        for key in table.get("properties", {}):
            assert re.search(rf"\b{key}\b", page), key


def test_the_reference_lists_every_public_name() -> None:
    listed = re.findall(r"^::: (?P<name>[\w.]+)$", read("docs/reference.md"), re.MULTILINE)
    public = [getattr(strainwave, name) for name in strainwave.__all__]
    assert sorted(listed) == sorted(f"{value.__module__}.{value.__name__}" for value in public)


def test_the_architecture_names_every_package_and_kernel_file() -> None:
    page = read("ARCHITECTURE.md")
    for folder in sorted(path.name for path in (ROOT / "python" / "strainwave").iterdir() if path.is_dir()):
        assert folder == "__pycache__" or f"`{folder}" in page or f"/{folder}`" in page, folder
    plain = {"lib", "error"}
    for source in sorted(path.stem for path in (ROOT / "crates" / "kernel" / "src").glob("*.rs")):
        assert source in plain or f"`{source}`" in page, source


def test_documents_name_no_path_of_a_machine() -> None:
    for name in NAMES:
        assert not re.search(r"/(home|tmp|root|work)/", read(name)), name


def test_the_documentation_lists_every_page() -> None:
    pages = {str(path.relative_to(ROOT / "docs")) for path in (ROOT / "docs").rglob("*.md")}
    listed = set(re.findall(r": ([\w/-]+\.md)$", (ROOT / "mkdocs.yml").read_text(encoding="utf-8"), re.MULTILINE))
    assert listed == pages


def test_examples_write_into_a_folder_of_their_own() -> None:
    with example_folder() as folder:
        assert [path.name for path in folder.iterdir()] == ["designs"]
        assert folder != Path.cwd()
