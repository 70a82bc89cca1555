"""Statistics: what one house shows, and what many show together.

Comes in: a scene, the validator's issues and measures of it. Goes out: `House`s, and plain documents over many of them. May
import: the ground floor. Not here: measuring itself (validate), making houses (pipeline), tables (service).
"""

from solver.statistics.house import House, house_of
from solver.statistics.summary import summary

__all__ = ["House", "house_of", "summary"]
