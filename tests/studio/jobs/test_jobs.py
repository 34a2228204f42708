"""Jobs: one at a time, bounded, ended at once, and nothing of them is left."""

from __future__ import annotations

import asyncio
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Awaitable, Callable
from typing import Any

import pytest

from strainwave.errors import StrainwaveError
from strainwave.studio.jobs import CancelledError, Jobs, Limits
from strainwave.studio.jobs.job import running_jobs
from strainwave.studio.jobs.jobs import MOST_AT_ONCE
from strainwave.studio.jobs.limits import GIB
from strainwave.studio.jobs.worker import Report, Task
from tests.studio.jobs import tasks
from tests.studio.jobs.processes import LONGEST_WAIT_S, children_of, gone, open_files, until


def silent(share: float, words: str) -> None:
    """Nobody listens."""


def run(task: Task, request: Any = None, report: Report = silent, **limits: Any) -> Any:
    return asyncio.run(Jobs(Limits(**limits)).run("counting", task, request, report))


def with_pid(steps: Callable[[Jobs, int], Awaitable[None]], task: Task = tasks.last_forever, **limits: Any) -> Any:
    """What comes of a task that tells its process's id, where `steps` are taken as soon as that is known."""

    async def main() -> Any:
        jobs, told = Jobs(Limits(**limits)), asyncio.get_running_loop().create_future()
        running = asyncio.create_task(jobs.run("waiting", task, None, lambda _, words: told.set_result(int(words))))
        pid = await asyncio.wait_for(told, LONGEST_WAIT_S)
        await steps(jobs, pid)
        try:
            return await asyncio.wait_for(running, LONGEST_WAIT_S)
        finally:
            assert await gone(pid)
            assert not jobs.running

    return asyncio.run(main())


def test_a_job_gives_what_its_task_gives_in_another_process() -> None:
    pid, parent = run(tasks.who)
    assert len({pid, parent, os.getpid()}) == 3


def test_progress_comes_in_order() -> None:
    heard: list[tuple[float, str]] = []
    assert run(tasks.count, 4, lambda *each: heard.append(each)) == [0, 1, 2, 3]
    assert heard == [(0.0, "0 of 4"), (0.25, "1 of 4"), (0.5, "2 of 4"), (0.75, "3 of 4")]


def test_progress_is_told_as_often_as_it_can_be_read() -> None:
    heard: list[float] = []
    run(tasks.chatter, 2000, lambda share, _: heard.append(share))
    assert heard[0] == 0.0
    assert len(heard) < 1000


def test_the_message_of_a_study_is_passed_on() -> None:
    with pytest.raises(StrainwaveError, match=r"^no w0 makes a gear$"):
        run(tasks.fail, "no w0 makes a gear")


def test_a_task_that_breaks_says_so_and_is_in_the_log(caplog: pytest.LogCaptureFixture) -> None:
    with pytest.raises(StrainwaveError, match=r"the counting broke.*ZeroDivisionError: the number was 0"):
        run(tasks.break_down)
    assert "in break_down" in caplog.text


def test_more_memory_than_allowed_is_one_message() -> None:
    with pytest.raises(StrainwaveError, match=r"more than 1 GiB of memory"):
        run(tasks.fill_memory, 2 * GIB, memory_bytes=GIB)
    assert run(tasks.fill_memory, 100_000_000, memory_bytes=GIB) == 100_000_000


def test_a_process_that_crashes_is_one_message() -> None:
    with pytest.raises(StrainwaveError, match="the counting ended without an answer: it was killed, or ran out of"):
        run(tasks.crash)


def test_a_process_that_is_killed_is_one_message() -> None:
    async def kill(_: Jobs, pid: int) -> None:
        os.kill(pid, signal.SIGKILL)

    with pytest.raises(StrainwaveError, match="ended without an answer"):
        with_pid(kill)


def test_a_job_ends_with_its_time() -> None:
    async def wait(_: Jobs, pid: int) -> None:
        pass

    with pytest.raises(StrainwaveError, match=r"the waiting took more than 1 s and was ended; ask for less"):
        with_pid(wait, seconds=1.0)


def test_cancelling_ends_the_process() -> None:
    async def cancel(jobs: Jobs, _: int) -> None:
        assert jobs.running == "waiting"
        jobs.cancel()

    with pytest.raises(CancelledError, match="the waiting was cancelled"):
        with_pid(cancel)


def test_cancelling_before_the_process_is_there_starts_none() -> None:
    async def main() -> None:
        jobs = Jobs()
        running = asyncio.create_task(jobs.run("waiting", tasks.last_forever, None, silent))
        await asyncio.sleep(0)
        jobs.cancel()
        with pytest.raises(CancelledError):
            await asyncio.wait_for(running, LONGEST_WAIT_S)
        assert await until(lambda: all(thread.name != "waiting" for thread in threading.enumerate()))

    asyncio.run(main())


def test_stopping_keeps_what_there_is() -> None:
    async def stop(jobs: Jobs, _: int) -> None:
        jobs.stop()

    assert with_pid(stop, tasks.keep_what_there_is) == "half"
    with pytest.raises(CancelledError, match="was stopped before it had found anything"):
        with_pid(stop)


def test_the_page_s_end_is_the_job_s() -> None:
    async def close(jobs: Jobs, _: int) -> None:
        jobs.close()
        with pytest.raises(StrainwaveError, match="closed"):
            await jobs.run("counting", tasks.count, 1, silent)

    with pytest.raises(CancelledError):
        with_pid(close)


def test_one_job_at_a_time() -> None:
    async def another(jobs: Jobs, _: int) -> None:
        with pytest.raises(StrainwaveError, match="the waiting is still running"):
            await jobs.run("counting", tasks.count, 1, silent)
        jobs.cancel()

    with pytest.raises(CancelledError):
        with_pid(another)


def test_all_windows_together_run_so_many() -> None:
    async def main() -> None:
        assert await until(lambda: running_jobs() == 0)
        windows = [Jobs() for _ in range(MOST_AT_ONCE)]
        running = [asyncio.ensure_future(jobs.run("waiting", tasks.last_forever, 1, silent)) for jobs in windows]
        await asyncio.sleep(0)
        with pytest.raises(StrainwaveError, match="4 studies are running in all windows together"):
            await Jobs().run("counting", tasks.count, 0, silent)
        windows[0].cancel()
        assert await until(lambda: running_jobs() < MOST_AT_ONCE)
        assert await Jobs().run("counting", tasks.count, 0, silent) == []
        for jobs in windows:
            jobs.close()
        assert all(isinstance(each, CancelledError) for each in await asyncio.gather(*running, return_exceptions=True))
        assert await until(lambda: running_jobs() == 0)

    asyncio.run(main())


def test_begin_and_end_are_told() -> None:
    async def main() -> list[str]:
        jobs, seen = Jobs(), []
        jobs.changed.connect(lambda: seen.append(jobs.running))
        await jobs.run("counting", tasks.count, 0, silent)
        return seen

    assert asyncio.run(main()) == ["counting", ""]


def test_the_page_s_work_comes_first() -> None:
    assert run(tasks.politeness) > os.nice(0)


def test_nothing_is_left_of_many_jobs() -> None:
    async def main() -> None:
        jobs = Jobs()
        _, parent = await jobs.run("counting", tasks.who, None, silent)
        await quiet(parent)
        before = open_files(), threading.active_count()
        for number in range(20):
            running = asyncio.create_task(jobs.run("counting", tasks.count, number % 3 * 100, silent))
            await asyncio.sleep(0.004 * number)
            if number % 3:
                jobs.cancel()
            await asyncio.gather(running, return_exceptions=True)
        await quiet(parent)
        assert (open_files(), threading.active_count()) == before

    async def quiet(parent: int) -> None:
        assert await until(lambda: not children_of(parent))
        assert await until(lambda: all(thread.name != "counting" for thread in threading.enumerate()))

    asyncio.run(main())


def test_a_server_that_is_killed_leaves_no_job_behind() -> None:
    program = subprocess.Popen([sys.executable, "-m", "tests.studio.jobs.abandoned"], stdout=subprocess.PIPE)
    assert program.stdout is not None
    with program.stdout:
        pid = int(program.stdout.readline())
    program.kill()
    program.wait()
    assert asyncio.run(gone(pid))
