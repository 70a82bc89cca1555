"""The kernel's source gives the same bytes compiled and as it stands: rooms, whole houses and repairs, in a process of each kind.

As a program, `python -m tests.placement.test_kernel_plain` prints what it calculated, a line each, floats to the last bit.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

from solver import Request, fix, generate
from solver.exchange import dump_text, write_scene
from solver.placement import place
from solver.placement.kernel import jit
from solver.scene import Furniture, Scene
from solver.streams import Stream
from tests.oracles.problems import solve
from tests.placement.rooms import random_space, random_wanted
from tests.placement.test_kernel_dual import random_programme
from tests.placement.test_search import random_problem
from tests.sweeps import times

ROOT = Path(__file__).parents[2]
PROBLEMS, PROGRAMMES, ROOMS, HOUSES = times(60, 30), times(60, 30), times(40, 16), times(4, 2)


def searches() -> Iterator[str]:
    for problem in [random_problem(seed, 3 + seed % 6)[1] for seed in range(PROBLEMS)] + [*map(random_programme, range(PROGRAMMES))]:
        outcome = solve(problem)
        positions = [axis.tobytes().hex() for axis in outcome.positions or ()]
        yield f"search {outcome.cost.hex()} {positions} {outcome.rows} {outcome.proven} {outcome.solves}"


def rooms() -> Iterator[str]:
    for seed in range(ROOMS):
        stream = Stream(seed, "plain")
        space = random_space(stream)
        (arrangement,) = place([(space, random_wanted(space, stream, 3 + seed % 9))])
        yield f"room {arrangement!r}"


def text(scene: Scene) -> str:
    """A scene on one line."""
    return dump_text(write_scene(scene), "json").decode().replace("\n", " ")


def houses() -> Iterator[str]:
    """Houses, and the repair of each once all its furniture was pushed about."""
    for seed in range(HOUSES):
        scene = generate(Request(seed=seed, width=8, depth=6)).scene
        yield f"house {text(scene)}"
        stream = Stream(seed, "pushed")
        pushed = replace(scene, rooms=tuple(replace(r, furniture=tuple(_pushed(f, stream) for f in r.furniture)) for r in scene.rooms))
        fixed = fix(pushed)
        yield f"repair {text(fixed.scene)} {fixed.moves} {fixed.conflicts}"


def _pushed(piece: Furniture, stream: Stream) -> Furniture:
    return replace(piece, x=round(piece.x + stream.unit() - 0.5, 3), z=round(piece.z + stream.unit() - 0.5, 3))


def report() -> list[str]:
    return [*searches(), *rooms(), *houses()]


@cache
def printed(kernel: str) -> list[str]:
    """What a new process prints."""
    environment = {**os.environ, "COMPOSE_KERNEL": kernel}
    command = [sys.executable, "-m", "tests.placement.test_kernel_plain"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, env=environment, check=False)
    assert run.returncode == 0, run.stderr.decode()
    return run.stdout.decode().splitlines()


def test_compiled_and_plain_agree_to_the_last_bit() -> None:
    plain, compiled = printed("plain"), printed("compiled")
    assert (plain[0], compiled[0]) == ("plain True, compiler loaded False", "plain False, compiler loaded True")
    assert len(plain) == len(compiled) == 1 + PROBLEMS + PROGRAMMES + ROOMS + 2 * HOUSES
    assert [(a, b) for a, b in zip(plain[1:], compiled[1:], strict=True) if a != b] == []


def test_the_sample_is_worth_comparing() -> None:
    lines = printed("compiled")
    placed = [line.count("Placed(") for line in lines if line.startswith("room")]
    assert sum(placed) > 4 * ROOMS
    assert any("left_out=()" not in line for line in lines if line.startswith("room"))
    assert sum(" inf " in line for line in lines if line.startswith("search")) > 10
    moved = [line.count("Move(") for line in lines if line.startswith("repair")]
    assert min(moved) > 5


if __name__ == "__main__":
    own = report()
    print(f"plain {jit.PLAIN}, compiler loaded {'numba' in sys.modules}")
    print("\n".join(own))
