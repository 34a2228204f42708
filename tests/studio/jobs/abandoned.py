"""A program that starts a job, prints who does it, and waits for its own end."""

from __future__ import annotations

import asyncio

from strainwave.studio.jobs import Jobs
from tests.studio.jobs.tasks import last_forever

if __name__ == "__main__":
    asyncio.run(Jobs().run("waiting", last_forever, None, lambda _, words: print(words, flush=True)))
