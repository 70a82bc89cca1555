"""A house that is tried with other bodies, judged once more, and what that counts."""

from collections.abc import Collection

from solver.placement import Budget
from solver.repair import all_bodies
from solver.scene import Scene
from solver.validator import FINDING_WORK, Checked

ROOM_WORK, BODY_WORK, WALKED_WORK = 15.0, 10.0, 2.0
"""What each room counts, each body of a room that changed, and each that is walked past anew; measured."""


def judged_again(house: Checked, scene: Scene, changed: Collection[str], budget: Budget) -> Checked:
    """Returns a house of which nothing but the bodies of some rooms, given by their ids, and people changed, with its issues.

    What is found wrong in the rooms that changed counts as it does anywhere: so a heap is judged less often, not refused.
    """
    bodies = {room.id: len(all_bodies(room)) for room in scene.rooms}
    own = sum(bodies[name] for name in changed)
    budget.left -= ROOM_WORK * len(bodies) + BODY_WORK * own + WALKED_WORK * sum(bodies.values())
    after = house.after(scene)
    budget.left -= FINDING_WORK * sum(len(case.judged.findings) for case in after.cases if case.room.room.id in changed)
    return after
