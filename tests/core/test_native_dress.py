"""Rooms decorated by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from random import Random

from catalogs import load_catalogs
from solver.core import borrowed
from solver.decorations.compiled_dressing import compiled_dressing
from solver.decorations.decorated_rows import decorated_rows
from solver.furnish import space_of
from tests.architecture.tree import ROOT
from tests.decorations.random_rooms import furnished, random_settings
from tests.sweeps import seeds

KNOWN = load_catalogs()
SOURCE = Path(__file__).with_name("native_dress.cpp")


def request(seed: int) -> tuple[bytes, bytes]:
    """Returns a random room with our dressing or a random one, as rows."""
    settings = random_settings(Random(f"native dressing {seed // 20}"), KNOWN)
    room, known = furnished(Random(f"native {seed}"), KNOWN), compiled_dressing(settings)
    return known.data, decorated_rows(room, space_of(room, 0.1), known, settings, seed)


def answer(known: bytes, room: bytes) -> bytes:
    """Returns what the core as it is built says."""
    with borrowed() as core:
        packed = core.call("dress", core.write(known), len(known), core.write(room), len(room))
        return core.read(packed & 0xFFFFFFFF, packed >> 32)


def test_checked_and_as_built_agree_to_the_last_bit(tmp_path: Path) -> None:
    program = tmp_path / "native"
    subprocess.run([sys.executable, "scripts/core.py", "check", SOURCE, program], cwd=ROOT, check=True)
    asked = [request(seed) for seed in seeds(range(1200), 4)]
    (tmp_path / "rooms").write_bytes(b"".join(len(part).to_bytes(8, "little") + part for one in asked for part in one))
    run = subprocess.run([program, tmp_path / "rooms"], capture_output=True, check=False)
    assert run.returncode == 0, "a negative status is the signal of a trap: run it in a debugger"
    assert run.stdout == b"".join(answer(*one) for one in asked)
