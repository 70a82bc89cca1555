"""A scene as text for a person: the readable YAML, and the report of what is wrong with it.

Comes in: a scene, its issues and what a person flagged. Goes out: text, and for each of its lines the body it shows.
May import: scene. Start reading in readable.py (the YAML) or report.py (the report).
"""

from solver.view.readable import view
from solver.view.report import report

__all__ = ["report", "view"]
