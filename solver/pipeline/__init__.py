"""The flows, top to bottom; the only place where two stages meet. Start reading here.

Comes in: Request or Scene. Goes out: Generated or Fixed. May import: every stage. Not here: what a stage does inside.
"""

from solver.pipeline.fix import fix
from solver.pipeline.generate import generate, reroll

__all__ = ["fix", "generate", "reroll"]
