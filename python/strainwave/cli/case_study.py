"""``strainwave case-study``: the article's four cases beside the published figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from strainwave.cli.options import AsJson, Force, Plot

if TYPE_CHECKING:
    from strainwave.analysis.case_study import CaseStudy


def case_study(
    as_json: AsJson = False,
    plot: Plot = None,
    report: Annotated[
        Path | None,
        typer.Option("--report", metavar="FILE", help="Write a report of all cases: FILE.html or FILE.pdf."),
    ] = None,
    force: Force = False,
) -> None:
    """Compute the article's four cases (µm, teeth) and set them beside the published figures."""
    from strainwave.analysis.case_study import CaseStudy
    from strainwave.cli.delivery import check_outputs
    from strainwave.cli.pictures import write_picture

    check_outputs([plot], [report], overwrite=force)
    if report is not None:
        from strainwave.report.report_file import check_report

        check_report(report, overwrite=force)
    study = CaseStudy.compute()
    write_picture(study, plot, overwrite=force)
    if report is not None:
        _write_report(study, report, overwrite=force)
    if as_json:
        typer.echo(study.to_json())
        return
    from strainwave.cli.console import say
    from strainwave.cli.tables.case_study import case_study_report

    say(*case_study_report(study))


def _write_report(study: CaseStudy, path: Path, *, overwrite: bool) -> None:
    from strainwave.cli.progress import watched
    from strainwave.report import Provenance, write_report
    from strainwave.report.case_study import case_study_document

    document = case_study_document(study, Provenance.of(["case-study", "--report", str(path)]))
    with watched("drawing the report") as progress:
        write_report(document, path, overwrite=overwrite, progress=progress)
