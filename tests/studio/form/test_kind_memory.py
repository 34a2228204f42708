"""What was typed under other kinds."""

from __future__ import annotations

from strainwave.studio.form.kind_memory import KindMemory


def test_a_table_comes_back_as_it_was_left_last() -> None:
    memory = KindMemory()
    assert memory.typed("four-roller") is None
    memory.leave({"kind": "four-roller", "roller_angle": 20.0})
    memory.leave({"kind": "cosine", "w0": 0.8})
    memory.leave({"kind": "four-roller", "roller_angle": 25.0})
    assert memory.typed("four-roller") == {"kind": "four-roller", "roller_angle": 25.0}


def test_each_name_is_as_the_last_table_had_it() -> None:
    memory = KindMemory()
    memory.leave({"kind": "cosine", "neutral_curve": "shifted", "w0": 0.8})
    memory.leave({"kind": "ellipse", "w0": 0.9})
    assert memory.seen == {"neutral_curve": "shifted", "w0": 0.9}
    memory.leave({"kind": "cosine", "w0": 1.0})
    assert memory.seen == {"w0": 1.0}


def test_what_is_remembered_does_not_change_with_the_draft() -> None:
    memory = KindMemory()
    table = {"kind": "cosine", "w0": 0.8}
    memory.leave(table)
    table["w0"] = 0.9
    assert memory.typed("cosine") == {"kind": "cosine", "w0": 0.8}
