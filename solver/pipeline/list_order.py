"""The order in which a list is placed: by what is asked for, not by ids or places in the list, so that a told-otherwise list is the same.

What two rounds of looking at relations cannot tell apart stays in the order that was sent. Where not everything finds a place the sent
order counts, as it says what matters most (place).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from solver.relations.subject import Kind
from solver.requested import PieceRequest

ROUNDS_TOLD: Final = 2
"""How many pieces away relations tell pieces apart."""


def by_content(requests: Sequence[PieceRequest], kinds: Mapping[str, Kind]) -> tuple[PieceRequest, ...]:
    """Returns requests, with every size filled in, sorted by kind, size, number and relations."""
    told = {name: repr((kind.name, kind.size)) for name, kind in kinds.items()}
    for request in requests:
        told[request.id] = repr((not request.required, kinds[request.id].name, request.size, request.count))
    for _ in range(ROUNDS_TOLD):
        told |= {request.id: f"{told[request.id]} {_relations(request, told)}" for request in requests}
    return tuple(sorted(requests, key=lambda request: told[request.id]))


def _relations(request: PieceRequest, told: Mapping[str, str]) -> str:
    """Returns a request's relations as words, the pieces they name by what these are."""
    specs = [spec.model_dump_json(exclude={"of"}) + repr([told.get(name, name) for name in spec.of]) for spec in request.relations]
    return repr(specs)
