"""survey(): one request -> a house, measured for statistics.

Comes in: a Request with a seed. Goes out: what statistics need of the house. May import: every stage.
"""

from __future__ import annotations

from catalogs import Catalogs
from solver.pipeline.generate import generate
from solver.scene import Request
from solver.statistics import House, house_of
from solver.validate import metrics


def survey(request: Request, catalogs: Catalogs) -> House:
    """Makes a house and returns what it shows.

    Raises:
        RequestError: a field of the request cannot be met by any house.
    """
    made = generate(request, catalogs=catalogs)
    return house_of(made.scene, made.issues, metrics(made.scene, catalogs))
