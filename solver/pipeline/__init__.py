"""The flows, top to bottom; the only place where two stages meet. Start reading here: generate.py, own_plan.py, fix.py, place.py.

Comes in: Request, Scene, or a Room and a list of pieces. Goes out: Generated, FurnishedPlan, Fixed, Answered or files.
May import: every stage. Not here: what a stage does inside.
"""

from solver.pipeline.drag_frames import prepare_drag
from solver.pipeline.explain import explain
from solver.pipeline.export import export
from solver.pipeline.fix import fix
from solver.pipeline.generate import generate, reroll
from solver.pipeline.own_plan import furnish
from solver.pipeline.place import place
from solver.validator import validate

__all__ = ["explain", "export", "fix", "furnish", "generate", "place", "prepare_drag", "reroll", "validate"]
