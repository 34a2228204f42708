"""Whatever is wrong: one clear message, exit code 2, no traceback."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from strainwave.design import template
from tests.cli.command import run
from tests.designs import CASE_STUDY

COSINE = CASE_STUDY / "cosine.toml"
COMMAND = Path(sys.executable).with_name("strainwave")


def changed(old: str, new: str) -> str:
    """The cosine design with a piece of its text changed."""
    text = COSINE.read_text(encoding="utf-8")
    assert old in text
    return text.replace(old, new)


# File content, and what the message must say: the key, the value, the unit or the remedy.
BAD_DESIGNS = {
    "syntax": ("module = = 1", ["line 1"]),
    "unknown key": (changed("module = 0.8", "module = 0.8\nmodul = 1"), ["modul", "not a key"]),
    "negative module": (changed("module = 0.8", "module = -0.8"), ["module = -0.8 mm", "0.001 to 1000 mm"]),
    "odd tooth difference": (
        changed("teeth = 206", "teeth = 207"),
        ["circular_spline.teeth = 207", "flexspline.teeth = 204", "even"],
    ),
    "w0 too large": (changed("w0 = 0.848", "w0 = 30.0"), ["wave_generator.w0 = 30", "mm", "Reduce it"]),
    "nan": (changed("w0 = 0.848", "w0 = nan"), ["wave_generator.w0 = nan mm"]),
    "infinite": (changed("module = 0.8", "module = inf"), ["module = inf mm"]),
    "1e308": (changed("tip_arc_radius = 1.0802", "tip_arc_radius = 1e308"), ["tip_arc_radius = 1e+308 modules"]),
    "a text for a number": (changed("w0 = 0.848", 'w0 = "much"'), ['wave_generator.w0 = "much"', "mm"]),
    "tip not reached": (changed("addendum = 0.9", "addendum = 9.0"), ["flexspline.profile.addendum = 9", "modules"]),
    "empty": ("", ["is empty", "strainwave new"]),
}


@pytest.mark.parametrize("verb", ["analyze", "validate"])
@pytest.mark.parametrize("fault", BAD_DESIGNS)
def test_a_bad_design(verb: str, fault: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    content, said = BAD_DESIGNS[fault]
    file = tmp_path / "bad.toml"
    file.write_text(content, encoding="utf-8")
    outcome = run(capsys, verb, file)
    assert outcome.code == 2
    assert outcome.out == ""
    assert outcome.err.startswith(f"strainwave: {file}: ")
    assert all(word in outcome.err for word in said), outcome.err
    assert "Traceback" not in outcome.err


def test_all_faults_of_a_file_come_together(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "bad.toml"
    text = changed("module = 0.8", "module = -0.8").replace("teeth = 206", "teeth = 207").replace("w0 = ", "w1 = ")
    file.write_text(text, encoding="utf-8")
    outcome = run(capsys, "analyze", file)
    assert outcome.code == 2
    for key in ("module", "circular_spline.teeth", "wave_generator.w0", "wave_generator.w1"):
        assert f"  - {key}" in outcome.err


def test_a_binary_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "bad.toml"
    file.write_bytes(bytes(range(256)))
    outcome = run(capsys, "analyze", file)
    assert outcome.code == 2
    assert "not UTF-8 text" in outcome.err


def test_a_directory(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "analyze", tmp_path)
    assert (outcome.code, outcome.err) == (2, f"strainwave: {tmp_path}: is a directory, not a design file\n")


def test_a_file_that_is_not_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "analyze", tmp_path / "none.toml")
    assert (outcome.code, outcome.err) == (2, f"strainwave: {tmp_path}/none.toml: there is no such file\n")


def test_an_unreadable_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(path: Path, *_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "open", refuse)
    outcome = run(capsys, "analyze", tmp_path / "secret.toml")
    assert outcome.code == 2
    assert "permission denied" in outcome.err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["frobnicate"], "No such command 'frobnicate'"),
        (["--bogus"], "No such option: --bogus"),
        (["analyze"], "Missing argument 'DESIGN'"),
        (["analyze", COSINE, "more"], "unexpected extra argument"),
        (["analyze", COSINE, "--bogus"], "No such option: --bogus"),
        (["analyze", COSINE, "--threshold", "much"], "'--threshold'"),
        (["analyze", COSINE, "--threshold", "-1"], "positive number of micrometres, not -1"),
        (["analyze", COSINE, "--threshold", "nan"], "positive number of micrometres, not nan"),
        (["analyze", COSINE, "--angle", "right"], "--angle: 'right' must be a number of degrees"),
        (["analyze", COSINE, "--angle", "inf"], "from -1000000 to 1000000 degrees, not inf"),
        (["analyze", COSINE, "--angle", "1e300"], "from -1000000 to 1000000 degrees, not 1e+300"),
        (["new", "a.toml", "--out", "b.toml"], "b.toml and a.toml: name one file"),
        (["analyze", COSINE, "--plot", "a.gif"], "a.gif: a picture's name must end in .png, .svg or .pdf"),
        (["analyze", COSINE, "--plot", "/no/such/place/a.png"], "there is no directory /no/such/place"),
        (["analyze", COSINE, "--csv", "/no/such/place/a.csv"], "there is no directory /no/such/place"),
        (["analyze", COSINE, "--csv", "/"], "is a directory"),
        (["case-study", "--plot", "a"], "a picture's name must end in"),
        (["new", "--out", "/no/such/place/a.toml"], "there is no directory /no/such/place"),
    ],
)
def test_wrong_usage(arguments: list[object], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, *arguments)
    assert outcome.code == 2
    assert said in outcome.err
    assert outcome.err.count("\n") == 1
    assert outcome.out == ""


@pytest.mark.parametrize(
    "arguments", [["new", "--out"], ["analyze", COSINE, "--csv"], ["analyze", COSINE, "--plot"]], ids=lambda a: a[0]
)
def test_an_existing_file_is_kept_unless_forced(
    arguments: list[object], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "mine.png"
    target.write_text("mine")
    outcome = run(capsys, *arguments, target)
    assert outcome.code == 2
    assert f"{target}: is there already" in outcome.err
    assert target.read_text() == "mine"
    assert run(capsys, *arguments, target, "--force").code == 0
    assert target.read_bytes() != b"mine"


def test_a_bug_is_owned_up_to(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """With its traceback, for it is to be reported, but never with the exit code of an interference."""

    def fail() -> str:
        raise ZeroDivisionError("seven")

    monkeypatch.setattr("strainwave.design.template", fail)
    outcome = run(capsys, "new")
    assert outcome.code == 2
    assert "ZeroDivisionError: seven" in outcome.err
    assert "a bug of strainwave" in outcome.err


@pytest.mark.parametrize("arguments", [["new"], ["--help"], ["analyze", str(COSINE)], ["case-study"]])
def test_nobody_reads_the_output(arguments: list[str]) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run([COMMAND, *arguments], stdout=writer, stderr=subprocess.PIPE, text=True, check=False)
    os.close(writer)
    assert (done.returncode, done.stderr) == (2, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
def test_the_output_is_full() -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run([COMMAND, "new"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr == "strainwave: the output cannot be written: No space left on device\n"


@pytest.mark.parametrize("closed", ["1", "2"])
def test_a_closed_stream(closed: str) -> None:
    """What a shell's `>&-` and `2>&-` do."""
    script = f'exec "$0" analyze "$1" {closed}>&-'
    done = subprocess.run(["sh", "-c", script, COMMAND, COSINE], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


def test_an_output_that_cannot_show_micrometres() -> None:
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    done = subprocess.run([COMMAND, "analyze", COSINE], env=environment, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"INTERFERENCE in motion" in done.stdout


def test_an_interrupt(tmp_path: Path) -> None:
    """Sent while a design file that never ends is being read."""
    endless = tmp_path / "endless.toml"
    os.mkfifo(endless)
    running = subprocess.Popen([COMMAND, "analyze", endless], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    with endless.open("w") as pipe:  # opens when the command has begun to read
        pipe.write("# ")
        pipe.flush()
        time.sleep(0.2)
        running.send_signal(signal.SIGINT)
        out, err = running.communicate(timeout=30)
    assert (running.returncode, out, err.strip()) == (130, "", "strainwave: interrupted")


def test_the_template_is_no_bad_design(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "good.toml"
    file.write_text(template(), encoding="utf-8")
    assert run(capsys, "analyze", file, "--check").code == 0
