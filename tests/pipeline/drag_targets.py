"""Drags of many homes: how far neighbours jump, what frames cost by count and by the clock, what becomes of them. `targets drags`."""

from __future__ import annotations

import statistics
import time
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field

from tqdm import tqdm

from catalogs import load_catalogs
from solver import validate
from solver.pipeline.drag import DRAWN, NO_ANSWER, PLACED, STAYED, Dragging, opening_of
from tests.bench.__main__ import percentile
from tests.pipeline.drags import dense_rooms, dragged, jump, neighbours, scene_at

FRAMES = 60
MOST_WORK = 530
JUMP_M, LONG_JUMP_M = 0.2, 1.0
MOST_JUMPS = 0.01
"""Share of frames in which a neighbour may go farther than JUMP_M; none goes farther than LONG_JUMP_M."""
AGAIN = 3
"""How often each frame is timed; the least counts."""
WORDS = {PLACED: "the best found", DRAWN: "drawn towards the wishes", STAYED: "nothing moved", NO_ANSWER: "no answer"}


@dataclass
class DragTally:
    """What drags show."""

    jumps: list[float] = field(default_factory=list)
    work: list[int] = field(default_factory=list)
    cpu_ms: list[float] = field(default_factory=list)
    outcomes: Counter[int] = field(default_factory=Counter)
    drags: int = 0
    broken: int = 0

    def add(self, other: DragTally) -> None:
        """Adds another tally to this one."""
        self.jumps += other.jumps
        self.work += other.work
        self.cpu_ms += other.cpu_ms
        self.outcomes += other.outcomes
        self.drags += other.drags
        self.broken += other.broken


def home_dragged(seed: int) -> DragTally:
    """Drags every piece of the dense rooms of a home."""
    tally, known = DragTally(), load_catalogs()
    for scene in dense_rooms(seed):
        for piece in scene.rooms[0].furniture:
            steps = dragged(scene, piece.id, FRAMES, seed)
            among = neighbours(scene, piece.id)
            opening = opening_of(scene, piece.id, (), known)
            if not steps or opening is None:
                continue
            drag, tally.drags = Dragging(opening), tally.drags + 1
            for step in steps:
                tally.jumps.append(jump(step, among))
                tally.work.append(step.answer.work)
                tally.outcomes[step.answer.outcome] += 1
                tally.cpu_ms.append(min(_timed(drag, step.wish, step.before) for _ in range(AGAIN)))
            last = scene_at(scene, steps[-1].answer.spots, piece.id)
            tally.broken += any(issue.severity == "error" for issue in validate(last, known))
    return tally


def _timed(drag: Dragging, wish: tuple[float, float], before: Sequence[float]) -> float:
    start = time.perf_counter()
    drag.frame(*wish, before)
    return (time.perf_counter() - start) * 1000


def drags(seeds: int, workers: int) -> bool:
    """Prints what drags of so many decorated family homes show; returns whether targets are met."""
    total = DragTally()
    with ProcessPoolExecutor(workers) as pool:
        for part in tqdm(pool.map(home_dragged, range(seeds)), total=seeds, desc="drags", disable=None):
            total.add(part)
    frames = len(total.jumps)
    far, farther = (sum(one > limit for one in total.jumps) for limit in (JUMP_M, LONG_JUMP_M))
    told = ", ".join(f"{WORDS[outcome]} {100 * count / frames:.1f} %" for outcome, count in sorted(total.outcomes.items()))
    print(f"{seeds} homes, {total.drags} drags, {frames} frames: {told}")
    print(f"neighbours jump > {JUMP_M} m in {far} frames, > {LONG_JUMP_M} m in {farther}; the farthest goes {max(total.jumps):.3f} m")
    for name, values in (("QPs and walks", total.work), ("ms (least of three)", total.cpu_ms)):
        print(f"{name}: median {statistics.median(values):.3f}, p99 {percentile(values, 0.99):.3f}, most {max(values):.3f}")
    print(f"drags that end with a broken rule: {total.broken}")
    return far <= MOST_JUMPS * frames and not farther and not total.broken and max(total.work) <= MOST_WORK
