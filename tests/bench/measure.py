"""One room measured against each yardstick. CPU times, never the clock on the wall."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from tests.bench.baseline import Guess, guess
from tests.bench.rooms import house_problems, room_problem
from tests.oracles import sums
from tests.oracles.optimum import Optimum, optimum
from tests.oracles.problem import Problem
from tests.oracles.problems import laid_out, search, solve
from tests.oracles.verdict import verdict

LIMIT = 20_000
"""QPs of one search here; where it is spent the room counts as not proven."""
TOLERANCE = 1e-6
"""What a result may break, m, and how far its cost may be from the sum of its terms."""
LEAST_SECONDS = 0.002
"""A room is solved again and again for as long as this, CPU seconds, and the mean is taken."""


@dataclass(frozen=True)
class Found:
    """What the search says of a room: verdict, cost, whether proven, and whether what it says adds up."""

    found: bool
    cost: float
    proven: bool
    sound: bool
    solves: int


def found(problem: Problem) -> Found:
    """Searches a room and adds its answer up anew."""
    outcome = solve(problem, limit=LIMIT)
    if outcome.positions is None:
        return Found(False, float("inf"), outcome.proven, True, outcome.solves)
    p = [axis.tolist() for axis in outcome.positions]
    sound = sums.worst(problem, p) <= TOLERANCE and abs(sums.cost(problem, p) - outcome.cost) <= TOLERANCE * max(1.0, outcome.cost)
    return Found(True, outcome.cost, outcome.proven, sound, outcome.solves)


def stage(problems: Sequence[Problem]) -> Callable[[], None]:
    """Returns the search stage of some rooms as rooms go through it: their numbers are in the work space already."""
    engines = [laid_out(problem) for problem in problems]

    def run() -> None:
        for engine in engines:
            search(engine, LIMIT)

    return run


def cpu_of(work: Callable[[], object], rounds: int = 3) -> float:
    """Returns the CPU seconds of one call: the median of a few means over many calls."""
    work()
    means = []
    for _ in range(rounds):
        calls, start = 0, time.process_time()
        while (spent := time.process_time() - start) < LEAST_SECONDS:
            work()
            calls += 1
        means.append(spent / calls)
    return statistics.median(means)


@dataclass(frozen=True)
class Measured:
    """A room: what the search found and the CPU it took, the feasibility oracle's verdict, the heuristics' guess."""

    seed: int
    choices: int
    ours: Found
    cpu: float
    verdict: bool | None
    guess: Guess


def measure(seed: int) -> Measured:
    """Measures the room of a seed."""
    problem = room_problem(seed)
    ours = found(problem)
    cpu = cpu_of(stage([problem]))
    guessed = guess(problem)
    return Measured(seed, len(problem.choices), ours, cpu, verdict(problem), guessed)


def against_optimum(job: tuple[int, float]) -> tuple[Found, float, Optimum]:
    """Returns what the search and SCIP, with a time limit in seconds, say of a seed's room, and the search's CPU seconds."""
    seed, seconds = job
    problem = room_problem(seed)
    return found(problem), cpu_of(stage([problem])), optimum(problem, seconds)


def house(seed: int) -> tuple[float, int]:
    """Returns the CPU seconds of searching all rooms of a house, rooms that HiGHS calls possible, and its pieces."""
    problems = house_problems(seed, lambda problem: verdict(problem) is True)
    pieces = sum(not part.stand for problem in problems for part in problem.boxes)
    return cpu_of(stage(problems)), pieces
