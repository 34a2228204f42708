"""``strainwave case-study``: the article's four cases beside the published figures."""

from __future__ import annotations

import typer

from strainwave.cli.options import AsJson, Force, Plot


def case_study(as_json: AsJson = False, plot: Plot = None, force: Force = False) -> None:
    """Compute the article's four cases (µm, teeth) and set them beside the published figures."""
    from strainwave.analysis.case_study import CaseStudy
    from strainwave.cli.pictures import check_picture, write_picture

    check_picture(plot, overwrite=force)
    study = CaseStudy.compute()
    write_picture(study, plot, overwrite=force)
    if as_json:
        typer.echo(study.to_json())
        return
    from strainwave.cli.console import say
    from strainwave.cli.tables.case_study import case_study_report

    say(*case_study_report(study))
