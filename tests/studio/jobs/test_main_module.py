"""What multiprocessing knows of the program while a job's process is started."""

from __future__ import annotations

import sys
from multiprocessing.spawn import get_preparation_data
from types import ModuleType

import pytest

from strainwave.studio.jobs.main_module import MAIN, nowhere_main


@pytest.mark.parametrize("origin", [{"__file__": "/tmp/my_studio.py"}, {"__spec__": sys.__spec__}])
def test_processes_hear_of_no_program_and_other_threads_find_it(
    origin: dict[str, object], monkeypatch: pytest.MonkeyPatch
) -> None:
    main = ModuleType(MAIN)
    vars(main).update({"own": object(), **origin})
    monkeypatch.setitem(sys.modules, MAIN, main)
    told = set(get_preparation_data("job"))
    assert any(key.startswith("init_main") for key in told)
    with nowhere_main():
        assert {key for key in told if not key.startswith("init_main")} == set(get_preparation_data("job"))
        assert sys.modules[MAIN].own is main.own  # as pickling does
    assert sys.modules[MAIN] is main
    with pytest.raises(ZeroDivisionError), nowhere_main():
        raise ZeroDivisionError
    assert sys.modules[MAIN] is main
    assert set(get_preparation_data("job")) == told
