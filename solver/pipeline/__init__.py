"""The flows, top to bottom; the only place where two stages meet. Start reading here: generate.py, own_plan.py, fix.py, place.py.

Comes in: Request, Scene, or a Room and a list of pieces. Goes out: Generated, FurnishedPlan, Fixed, Answered or files.
May import: every stage. Not here: what a stage does inside.
"""
