"""Many designs at once: variations of one design through the kernel on all cores."""

from strainwave.batch.batch import Batch
from strainwave.batch.evaluate import evaluate_batch
from strainwave.batch.metrics import METRICS
from strainwave.batch.statuses import STATUSES

__all__ = ["METRICS", "STATUSES", "Batch", "evaluate_batch"]
