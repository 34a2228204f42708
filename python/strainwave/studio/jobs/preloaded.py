"""What every job needs, imported once: a job's process is copied from one that has this, and starts in no time."""

# ruff: noqa: F401 (imported to be there)
from contextlib import suppress

import matplotlib.figure
import scipy.optimize
import scipy.stats

import strainwave.cli
import strainwave.plots.interactive
import strainwave.studies.optimization
import strainwave.studies.tolerance
import strainwave.studio.jobs.worker
import strainwave.studio.orders
from strainwave.errors import StrainwaveError
from strainwave.plots.interactive.house import house_figure

with suppress(ImportError):  # an extra; without it only several objectives are impossible
    import pymoo.algorithms.moo.nsga2

with suppress(StrainwaveError):  # without plotly; each job says so
    # It imports most of itself when the first figure is made and written.
    house_figure("").add_hline(0.0).set_subplots(rows=1, cols=2).to_json()
