"""Proposing a design."""

from __future__ import annotations

from strainwave.errors import StrainwaveError
from strainwave.studies.wizard import proportions
from strainwave.studies.wizard.proposal import Proposal
from strainwave.studies.wizard.request import Request
from strainwave.studies.wizard.search import Aim, tuned
from strainwave.studies.wizard.start import start_of


def propose(
    ratio: float,
    pitch_diameter_mm: float,
    *,
    generator: str | None = None,
    profile: str | None = None,
    use: str = "power",
    threads: int = 0,
) -> Proposal:
    """A complete design for a ratio from 30 to 200 and a flexspline's pitch diameter from 20 to 200 mm.

    Its proportions are documented, and its w0 and flank offset tuned so that no teeth interfere at any generator angle
    and the least backlash lies from 0.5 to 5 um. ``ratio`` is that with the circular spline fixed, without its sign.
    ``generator`` is a kind (every one but ``table``), ``profile`` one of ``PROFILES``, ``use`` power or precision; left
    out, the usual ones. ``threads`` limits the cores used; results do not depend on it. Raises ``StrainwaveError`` with
    the nearest possible request where there is no such design.
    """
    request = Request.of(ratio, pitch_diameter_mm, generator, profile, use)
    start = start_of(request)
    aim = _aim(request)
    found = tuned(start, aim, threads)
    if found is None:
        others = ", ".join(name for name in proportions.PROFILES if name != request.profile)
        raise StrainwaveError(
            f"{start.name}, {request.profile}: no w0 and flank offset reach a least backlash of 0.5 to 5 µm; the "
            f"nearest possible may be another profile: {others}"
        )
    return Proposal(request, found, aim)


def _aim(request: Request) -> Aim:
    share = 0.5 if request.use == "precision" else 1.0
    wanted = share * proportions.TARGET_UM_PER_MODULE * request.module_mm
    greatest = share * proportions.GREATEST_TARGET_UM
    target = min(max(wanted, proportions.LEAST_TARGET_UM), greatest)
    return Aim(request.use, target, target + proportions.SHARING_UM_PER_MODULE * request.module_mm)
