"""What each verb prints and writes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from strainwave import __version__
from strainwave.analysis import analyze
from strainwave.cli.tables.zones import STATES
from strainwave.design import load, template
from tests.cli.command import run
from tests.designs import CASE_STUDY

COSINE = CASE_STUDY / "cosine.toml"
CALIBRATED = CASE_STUDY / "cosine-calibrated.toml"
HELP = {
    "new": [
        "--ratio",
        "--pitch-diameter",
        "--generator",
        "--profile",
        "--use",
        "--out",
        "strainwave new --out my-gear.toml",
        "mm",
    ],
    "validate": ["DESIGN", "--json", "strainwave validate my-gear.toml", "unit"],
    "analyze": [
        "--threshold",
        "--angle",
        "--teeth",
        "--json",
        "--csv",
        "--plot",
        "--check",
        "--force",
        "µm",
        "degrees",
    ],
    "compare": ["--with", "--w0", "--goal", "--json", "--csv", "--plot", "µm", "strainwave compare my-gear.toml"],
    "tune": ["--margin", "--goal", "--out", "--json", "--csv", "--plot", "µm", "strainwave tune my-gear.toml"],
    "sweep": ["--vary", "--metric", "--json", "--csv", "--plot", "µm", "strainwave sweep my-gear.toml"],
    "case-study": ["--json", "--plot", "strainwave case-study --plot case-study.png", "µm"],
    "tolerance": ["TOLERANCES", "--samples", "--seed", "--csv", "µm", "strainwave tolerance my-gear.toml"],
    "optimize": [
        "--vary",
        "--objective",
        "--require",
        "--seed",
        "--out",
        "rim-strain",
        "µm",
        "strainwave optimize my-gear.toml",
    ],
}


@pytest.mark.parametrize("verb", HELP)
def test_help_shows_options_units_and_an_example(verb: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, verb, "--help")
    assert outcome.code == 0
    assert all(word in outcome.out for word in HELP[verb]), outcome.out
    assert "Example:" in outcome.out


def test_without_a_verb_it_shows_its_help(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys)
    assert outcome.code == 0
    assert all(verb in outcome.out for verb in HELP)


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(capsys, "--version").out == f"strainwave {__version__}\n"


def test_new_prints_the_template(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(capsys, "new").out == template()


def test_new_writes_a_design_that_analyses(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "my gear.toml"
    assert run(capsys, "new", "--out", target).code == 0
    assert target.read_text(encoding="utf-8") == template()
    assert run(capsys, "analyze", target).code == 0
    again = tmp_path / "again.toml"
    assert run(capsys, "new", again).out.startswith(f"{again}: a design to start from")
    assert again.read_text(encoding="utf-8") == template()


def test_validate_shows_the_geometry(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "validate", COSINE)
    assert outcome.code == 0
    assert outcome.out.startswith("valid")
    assert "S_l* 1.3565" in outcome.out
    assert "S_l* 1.7496" in outcome.out
    assert "+112.8 ppm" in outcome.out


def test_validate_as_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good = json.loads(run(capsys, "validate", COSINE, "--json").out)
    assert good["valid"] is True
    assert good["geometry"]["neutral_curve"]["radius_mm"] == pytest.approx(79.8304)
    file = tmp_path / "bad.toml"
    file.write_text("module = -1", encoding="utf-8")
    outcome = run(capsys, "validate", file, "--json")
    bad = json.loads(outcome.out)
    assert outcome.code == 2
    assert bad["valid"] is False
    assert {"key": "module", "value": -1, "unit": "mm"}.items() <= bad["faults"][0].items()


@pytest.mark.parametrize(
    ("written", "recorded"),
    [("nan", "nan"), ("-inf", "-inf"), ("2026-01-31", "2026-01-31"), ("[1, nan]", "[1, nan]"), ("true", True),
     ("0x" + "f" * 5000, "a number of thousands of digits")],
    ids=["nan", "infinite", "date", "array", "boolean", "huge"],
)  # fmt: skip
def test_validate_as_json_records_values_that_json_cannot_hold(
    written: str, recorded: object, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "bad.toml"
    file.write_text(template().replace("module = 0.8 ", f"module = {written} "), encoding="utf-8")
    outcome = run(capsys, "validate", file, "--json")
    assert outcome.code == 2
    fault = json.loads(outcome.out)["faults"][0]
    assert (fault["key"], fault["value"]) == ("module", recorded)


def test_analyze_begins_with_the_verdict(capsys: pytest.CaptureFixture[str]) -> None:
    good = run(capsys, "analyze", CALIBRATED).out.splitlines()
    assert good[0] == "Case study, cosine cam, calibrated"
    assert good[2] == "NO INTERFERENCE in motion, least gap 1.49 µm (certified to 0.001 µm)"
    bad = run(capsys, "analyze", COSINE).out.splitlines()
    assert bad[2] == "INTERFERENCE in motion, 5.71 µm deep (certified to 0.001 µm)"


def test_analyze_says_what_its_result_says(capsys: pytest.CaptureFixture[str]) -> None:
    result = analyze(load(CALIBRATED))
    out = run(capsys, "analyze", CALIBRATED).out
    assert f"{result.min_backlash_um:.3f} µm at tooth {result.min_tooth}" in out
    counts = next(line for line in out.splitlines() if line.startswith("0 ≤ backlash < 10 µm"))
    assert counts.split()[-3:] == [str(n) for n in (39, 79, 158)]
    play = next(line for line in out.splitlines() if line.startswith("in motion"))
    expected = (result.play_in_motion.normal_um, result.play_in_motion.circumferential_um)
    assert play.split()[2:4] == [f"{value:.2f}" for value in expected]
    assert "w0²/R = 9.0 µm" in " ".join(out.split())


def test_zones_cover_every_tooth_once_in_its_state(capsys: pytest.CaptureFixture[str]) -> None:
    out = run(capsys, "analyze", COSINE, "--angle", "40").out.splitlines()
    header = next(place for place, line in enumerate(out) if line.startswith("teeth  "))
    covered: list[int] = []
    states: list[str] = []
    for line in out[header + 2 : out.index("", header)]:
        ends = line.replace("−", "-").split("  ")[0].split(" … ")
        teeth = range(int(ends[0]), int(ends[-1]) + 1)
        covered += teeth
        states += [next(state for state in STATES if state in line)] * len(teeth)
    result = analyze(load(COSINE), generator_angle_deg=40.0)
    gap_um = result.teeth.backlash_um
    assert covered == result.teeth.tooth.tolist()
    assert states == [STATES[0] if gap < 0.0 else STATES[1] if gap < 10.0 else STATES[2] for gap in gap_um]


def test_at_angle_0_the_zones_show_one_side_and_the_major_axis(capsys: pytest.CaptureFixture[str]) -> None:
    lines = run(capsys, "analyze", COSINE).out.splitlines()
    header = next(place for place, line in enumerate(lines) if line.startswith("teeth ±"))
    assert lines[header + 2].startswith("0 … 8 ")
    assert lines[lines.index("", header) - 1].startswith("47 … 51 ")


def test_analyze_lists_every_tooth_on_request(capsys: pytest.CaptureFixture[str]) -> None:
    result = analyze(load(COSINE))
    lines = run(capsys, "analyze", COSINE, "--teeth").out.splitlines()
    tooth_0 = next(line for line in lines if line.split()[:2] == ["0", "0.0"])
    assert tooth_0.split()[2] == f"{result.teeth.left_um[51]:.2f}"
    assert sum(line.lstrip("−")[:1].isdigit() and len(line.split()) == 8 for line in lines) == 103


@pytest.mark.parametrize("angle", ["7.5", "7°30'"])
def test_analyze_as_json_at_an_angle_and_threshold(angle: str, capsys: pytest.CaptureFixture[str]) -> None:
    out = run(capsys, "analyze", COSINE, "--json", "--angle", angle, "--threshold", "2").out
    assert out == analyze(load(COSINE), threshold_um=2.0, generator_angle_deg=7.5).to_json() + "\n"


def test_check_tells_interference_in_motion_by_the_exit_code(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(capsys, "analyze", CALIBRATED, "--check").code == 0
    assert run(capsys, "analyze", COSINE, "--check").code == 1
    assert run(capsys, "analyze", COSINE).code == 0


def test_check_still_writes_what_was_asked_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(
        capsys, "analyze", COSINE, "--check", "--csv", tmp_path / "t.csv", "--plot", tmp_path / "p.SVG", "--json"
    )
    assert outcome.code == 1
    assert (tmp_path / "t.csv").read_text(encoding="utf-8").count("\n") == 104
    assert (tmp_path / "p.SVG").read_text(encoding="utf-8").startswith("<?xml")
    assert json.loads(outcome.out)["interference"] is True


def test_a_name_in_brackets_is_no_markup(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "a.toml"
    file.write_text(template().replace("New design", "[bold]A[/x]"), encoding="utf-8")
    assert run(capsys, "analyze", file).out.startswith("[bold]A[/x]\n")
    assert run(capsys, "validate", file).out.startswith(f"valid  {file}: [bold]A[/x]\n")


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("cost $\\\\frac{1$ up", "cost $\\frac{1$ up"),
        ("齿轮 🛠", "齿轮 🛠"),
        ("a\\nb\\u001b[31mc", "a\\nb\\x1b[31mc"),
        ("n" * 200, "n" * 90),
        ("", "unnamed design"),
    ],
    ids=["half a formula", "letters that the font lacks", "control characters", "long", "empty"],
)
def test_any_name_can_be_shown_and_drawn(
    name: str, shown: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, picture = tmp_path / "a.toml", tmp_path / "a.svg"
    file.write_text(template().replace("New design", name), encoding="utf-8")
    outcome = run(capsys, "analyze", file, "--plot", picture)
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.startswith(shown)
    assert picture.exists()


def test_case_study_sets_readings_side_by_side(capsys: pytest.CaptureFixture[str]) -> None:
    out = run(capsys, "case-study").out
    least = [line.split()[3:] for line in out.splitlines() if line.startswith("least backlash, µm")]
    assert least == [
        ["1.97", "−5.71", "(−7.68)", "1.49", "(−0.48)"],
        ["1.91", "−5.04", "(−6.95)", "2.16", "(+0.25)"],
        ["−14.8", "−21.77", "(−6.97)", "−14.57", "(+0.23)"],
        ["0.096", "−6.77", "(−6.87)", "0.43", "(+0.33)"],
    ]
    readings = {line.split()[0]: line for line in out.splitlines() if line.startswith(("first-order", "shifted"))}
    assert "−15.31 @ 37, from 31" in readings["shifted"]
    assert "† Inferred" in out
    assert "roller half angle" in out


def test_case_study_as_json_and_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "case-study", "--json", "--plot", tmp_path / "cs.pdf")
    assert outcome.code == 0
    record = json.loads(outcome.out)
    assert len(record["cases"]) == 16
    assert {number["name"] for number in record["inferred"]} >= {"flank offset", "roller half angle", "wrap half angle"}
    assert (tmp_path / "cs.pdf").read_bytes().startswith(b"%PDF")


def test_analyze_draws_and_computes_with_what_it_needs_only() -> None:
    """The whole command is quick because matplotlib and SciPy stay out of it."""
    code = (
        "import sys\nfrom strainwave.cli import main\ntry: main(sys.argv[1:])\nexcept SystemExit: pass\n"
        "print(*sorted({name.split('.')[0] for name in sys.modules} & {'matplotlib', 'scipy', 'PIL'}), 'end')"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, "analyze", str(COSINE)], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "end"
