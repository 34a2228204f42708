"""Signals reach everyone, in order."""

from __future__ import annotations

from strainwave.studio.signal import Signal


def test_everyone_is_called_in_order_and_as_often_as_it_is_emitted() -> None:
    signal, heard = Signal(), list[str]()
    signal.emit()
    signal.connect(lambda: heard.append("first"))
    signal.connect(lambda: heard.append("second"))
    signal.emit()
    signal.emit()
    assert heard == ["first", "second"] * 2


def test_a_silenced_one_reaches_nobody() -> None:
    signal, heard = Signal(), list[str]()
    signal.connect(lambda: heard.append("first"))
    signal.silence()
    signal.emit()
    assert heard == []
