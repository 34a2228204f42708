"""The studio as its own process, as a user runs it."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

COMMAND = Path(sys.executable).with_name("strainwave")
LONGEST_START_S = 60.0
LONGEST_END_S = 15.0
WRONG = re.compile(r"traceback|stack \(most recent|exception|\berror\b|warning", re.IGNORECASE)


@dataclass(eq=False)
class StudioServer:
    """A running ``strainwave studio``; all that it prints goes to `log`."""

    process: subprocess.Popen[bytes]
    log: Path
    address: str
    """Such as ``http://127.0.0.1:41233/``."""

    @classmethod
    def started(cls, log: Path, *arguments: object) -> StudioServer:
        """Run the command, on any free port and without a browser, and wait for its address."""
        return cls.serving(log, COMMAND, "studio", *arguments, "--port", "0", "--no-browser")

    @classmethod
    def serving(cls, log: Path, *command: object, folder: Path | None = None) -> StudioServer:
        """Run a program, in a folder, that serves a studio and prints its address, and wait for that."""
        with log.open("wb") as output:
            words = [str(part) for part in command]
            process = subprocess.Popen(words, stdout=output, stderr=subprocess.STDOUT, cwd=folder)
        until = time.monotonic() + LONGEST_START_S
        while time.monotonic() < until and process.poll() is None:
            if found := re.search(r"http://\S+", log.read_text(encoding="utf-8")):
                return cls(process, log, found[0])
            time.sleep(0.05)
        process.kill()
        raise AssertionError(f"the studio did not start: {log.read_text(encoding='utf-8')}")

    def printed(self) -> str:
        """All that it has printed so far."""
        return self.log.read_text(encoding="utf-8")

    def ended(self) -> int:
        """Interrupt it as Ctrl-C does and give its exit code."""
        self.process.send_signal(signal.SIGINT)
        try:
            return self.process.wait(LONGEST_END_S)
        finally:
            self.process.kill()
            self.process.wait()
