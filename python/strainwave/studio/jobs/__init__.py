"""Long work beside the page: in a process of its own, bounded in time and memory, told apart from its page's others."""

from strainwave.studio.jobs.job import CancelledError
from strainwave.studio.jobs.jobs import Jobs
from strainwave.studio.jobs.limits import Limits
from strainwave.studio.jobs.worker import Report, Task

__all__ = ["CancelledError", "Jobs", "Limits", "Report", "Task"]
