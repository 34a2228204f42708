"""What one designer has open: a draft, the last good design with its analysis, a reference, and the way back."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from strainwave.analysis import Analysis, analyze
from strainwave.analysis.analyze import counted_below
from strainwave.design import Design
from strainwave.design.replacement import replaced
from strainwave.errors import DesignError, Fault, StrainwaveError
from strainwave.studio.history import History
from strainwave.studio.jobs import Jobs
from strainwave.studio.signal import Signal

THRESHOLD_UM = 10.0
# As long as the drawing takes to reach the page.
FOLLOWS_S = 0.03


@dataclass(frozen=True)
class _Wanted:
    """A draft to be analysed."""

    tree: dict[str, Any]
    what: str
    is_step: bool


class Session:
    """One page's state; knows no widgets. Sessions share nothing.

    `draft` is what the form shows, good or not; `analysis` is of the last draft that was good. All methods are called
    on the event loop; analyses run beside it, and of the drafts that come meanwhile only the last is analysed.
    """

    def __init__(self, design: Design, *, threshold_um: float = THRESHOLD_UM) -> None:
        """Raises ``DesignError`` where the design has no geometry."""
        self.threshold_um = threshold_um
        self.analysis: Analysis = analyze(design, threshold_um=threshold_um)
        self.draft: dict[str, Any] = design.to_dict()
        self.faults: tuple[Fault, ...] = ()
        self.pinned: Analysis | None = None
        self.history = History(design)
        self.shown = Signal()
        """A new analysis is there."""
        self.followed = Signal()
        """It has been there for a moment: for what stands beside the drawing and would hold it up in the browser."""
        self.drafted = Signal()
        """The draft has been replaced by something other than the form: a file, a step back, a study."""
        self.judged = Signal()
        """`faults` may have changed."""
        self.repinned = Signal()
        """The reference has changed."""
        self.jobs = Jobs()
        """The long work of this page."""
        self._wanted: _Wanted | None = None
        self._working = False
        self._following: asyncio.TimerHandle | None = None
        self._settled = asyncio.Event()
        self._settled.set()

    @property
    def design(self) -> Design:
        """The last good design."""
        return self.analysis.design

    async def change(self, changes: Mapping[str, Any]) -> None:
        """Set values of the draft by dotted key (None takes an optional one out) and analyse it."""
        try:
            self.draft = replaced(self.draft, changes)
        except DesignError as error:
            self._judge(error.faults)
            return
        await self._analyse(_Wanted(self.draft, ", ".join(changes), is_step=True))

    async def adopt(self, changes: Mapping[str, Any]) -> None:
        """The same from outside the form, as a step of its own."""
        try:
            self.draft = replaced(self.draft, changes)
        except DesignError as error:
            self._judge(error.faults)
            return
        self.drafted.emit()
        await self._analyse(_Wanted(self.draft, "", is_step=True))

    async def open(self, design: Design) -> None:
        """Take another design, as one step that can be undone."""
        await self._replace(design, is_step=True)

    async def undo(self) -> None:
        """One step back; a draft with faults goes back to the last good design first."""
        await self.settled()
        if self.faults:
            await self._replace(self.design, is_step=False)
        elif self.history.can_undo:
            await self._replace(self.history.undo(), is_step=False)

    async def redo(self) -> None:
        """One step forth again."""
        await self.settled()
        if self.history.can_redo:
            await self._replace(self.history.redo(), is_step=False)

    def count_below(self, threshold_um: float) -> None:
        """Count the teeth of what is shown below another gap, those of the reference too; the draft is as it was.

        ``StrainwaveError`` where it is no gap.
        """
        if threshold_um == self.threshold_um:
            return
        self.analysis = counted_below(self.analysis, threshold_um)
        self.threshold_um = threshold_um
        if self.pinned is not None:
            self.pinned = counted_below(self.pinned, threshold_um)
            self.repinned.emit()
        self._show()

    async def settled(self) -> None:
        """Wait until every draft that has come is analysed."""
        while self._working:
            await self._settled.wait()

    def pin(self) -> None:
        """Make what is shown the reference."""
        self.pinned = self.analysis
        self.repinned.emit()

    def unpin(self) -> None:
        """Have no reference."""
        self.pinned = None
        self.repinned.emit()

    async def swap(self) -> None:
        """Show the reference, and make what was shown the reference."""
        await self.settled()
        if self.pinned is None:
            return
        design = self.pinned.design
        self.pin()
        await self.open(design)

    def close(self) -> None:
        """Tell nobody of anything any more, and end the long work: the page is gone."""
        for signal in (self.shown, self.followed, self.drafted, self.judged, self.repinned):
            signal.silence()
        self.jobs.close()

    async def _replace(self, design: Design, *, is_step: bool) -> None:
        self.draft = design.to_dict()
        self.drafted.emit()
        await self._analyse(_Wanted(self.draft, "", is_step))

    async def _analyse(self, wanted: _Wanted) -> None:
        self._wanted = wanted
        if self._working:
            return
        self._working = True
        self._settled.clear()
        try:
            while (now := self._wanted) is not None:
                self._wanted = None
                await self._take(now)
        finally:
            self._working = False
            self._settled.set()

    async def _take(self, wanted: _Wanted) -> None:
        try:
            found = await asyncio.to_thread(_analysis_of, wanted.tree, self.threshold_um)
        except DesignError as error:
            self._judge(error.faults)
            return
        except StrainwaveError as error:
            self._judge((Fault("", problem=str(error)),))
            return
        if found.threshold_um != self.threshold_um:  # which has come meanwhile
            found = counted_below(found, self.threshold_um)
        self.analysis = found
        if wanted.is_step:
            self.history.add(found.design, wanted.what)
        self._judge(())
        self._show()

    def _show(self) -> None:
        self.shown.emit()
        if self._following is None:
            self._following = asyncio.get_running_loop().call_later(FOLLOWS_S, self._follow)

    def _follow(self) -> None:
        self._following = None
        self.followed.emit()

    def _judge(self, faults: tuple[Fault, ...]) -> None:
        self.faults = faults
        self.judged.emit()


def _analysis_of(tree: dict[str, Any], threshold_um: float) -> Analysis:
    return analyze(Design.from_dict(tree), threshold_um=threshold_um)
