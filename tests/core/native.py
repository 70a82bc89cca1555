"""The native build of the core, which checks every index and traps at undefined behaviour: see native.cpp."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from tests.architecture.tree import ROOT

SOURCE = Path(__file__).with_name("native.cpp")


class Native:
    """The program; it keeps what it is asked in a folder."""

    def __init__(self, folder: Path) -> None:
        self.program, self.asked = folder / "native", folder / "asked"
        build = [sys.executable, "scripts/core.py", "check", str(SOURCE), str(self.program)]
        built = subprocess.run(build, cwd=ROOT, capture_output=True, text=True, check=False)
        assert built.returncode == 0, built.stderr

    def run(self, call: str, content: bytes) -> subprocess.CompletedProcess[bytes]:
        """Run a call's requests; a negative status is the signal of a trap: run the program in a debugger."""
        self.asked.write_bytes(content)
        return subprocess.run([self.program, call, self.asked], capture_output=True, check=False)

    def answers(self, call: str, requests: Iterable[Sequence[bytes]]) -> bytes:
        """Returns the answers of a call to requests, each of one part or of several, one after the other."""
        run = self.run(call, b"".join(map(framed, requests)))
        assert run.returncode == 0, f"{call} ended with {run.returncode}, a signal if negative: run it in a debugger"
        return run.stdout


def framed(parts: Sequence[bytes]) -> bytes:
    """Returns a request as the program reads it."""
    return b"".join(len(part).to_bytes(8, "little") + part for part in parts)
