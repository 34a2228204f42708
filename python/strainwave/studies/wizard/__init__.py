"""The wizard: a complete design from a ratio and a size."""

from strainwave.studies.wizard.proportions import PROFILES
from strainwave.studies.wizard.proposal import Proposal
from strainwave.studies.wizard.propose import propose
from strainwave.studies.wizard.request import USES, Request, Use

__all__ = ["PROFILES", "USES", "Proposal", "Request", "Use", "propose"]
