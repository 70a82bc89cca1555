"""Documents and scenes for the readers: hand-made ones, and strategies that draw any."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

from solver import scene as types
from solver.request import MAX_SEED

TEXTS = st.text(st.characters(codec="utf-8"), max_size=12)
NAMES = st.text(st.characters(codec="utf-8"), min_size=1, max_size=12)
NUMBERS = st.floats(-1e6, 1e6)
SIZES = st.floats(1e-9, 1000.0)
WHOLE = st.integers(-(2**53) + 1, 2**53 - 1)
PLAIN = st.recursive(
    st.none() | st.booleans() | WHOLE | st.floats(allow_nan=False, allow_infinity=False) | TEXTS,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(TEXTS, inner, max_size=3),
    max_leaves=8,
)
PLAIN_MAPPINGS = st.dictionaries(TEXTS, PLAIN, max_size=3)
WALLS = st.none() | st.sampled_from(types.WALLS)


def piece(**more: Any) -> dict[str, Any]:
    return {"name": "sofa", "x": 1.0, "z": 1.0, "width": 1.0, "depth": 1.0, "height": 1.0, **more}


def room(*furniture: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"width": 4.0, "depth": 3.0, "furniture": list(furniture), **more}


def scene(*rooms: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"rooms": list(rooms), **more}


def extra(*known: str) -> st.SearchStrategy[dict[str, Any]]:
    """Keys that a record does not have, with anything in them."""
    return st.dictionaries(TEXTS.filter(lambda key: key not in known), PLAIN, max_size=2)


def record(of: Any, **parts: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return st.builds(of, **parts, extra=extra(*parts))


def pose() -> dict[str, st.SearchStrategy[Any]]:
    extents = dict.fromkeys(("width", "depth", "height"), SIZES)
    return {"id": NAMES, "x": NUMBERS, "y": NUMBERS, "z": NUMBERS, "rotation": NUMBERS | st.sampled_from([0, 90, 180.0]), **extents}


FURNITURE = record(
    types.Furniture,
    name=TEXTS,
    category=st.none() | TEXTS,
    color=st.none() | TEXTS,
    wall=WALLS,
    under=st.none() | TEXTS,
    on=st.none() | TEXTS,
    locked=st.booleans(),
    **pose(),
)
DECORATIONS = record(types.Decoration, name=TEXTS, parent=st.none() | TEXTS, mounted_on_wall=WALLS, color=st.none() | TEXTS, **pose())
DYNAMIC = record(types.Dynamic, kind=TEXTS, room=st.none() | TEXTS, **pose())
OPENINGS = record(
    types.Opening,
    id=NAMES,
    kind=st.sampled_from(types.OPENING_KINDS),
    wall=WALLS,
    position=NUMBERS,
    width=SIZES,
    height=SIZES,
    sill=NUMBERS,
    connects_to=st.none() | TEXTS,
    hinge=st.none() | st.sampled_from(["start", "end"]),
    swing=st.none() | st.sampled_from(["in", "out"]),
    main_entrance=st.booleans(),
    render_panel=st.booleans(),
    edge=st.none() | st.integers(0, 3),
    open=st.none() | st.floats(0, 1),
)
SIDES = st.none() | st.builds(types.Sides, *[st.booleans()] * 4)
OUTLINE = st.tuples(SIZES, SIZES).filter(lambda size: min(size) > 1e-3).map(lambda size: ((0.0, 0.0), (size[0], 0.0), size, (0.0, size[1])))


@st.composite
def rooms(draw: st.DrawFn) -> types.Room:
    outline = draw(OUTLINE)
    openings = tuple(draw(st.lists(OPENINGS, max_size=2, unique_by=lambda one: one.id)))
    has_outline = draw(st.booleans()) or any(opening.edge is not None for opening in openings)
    parts = record(
        types.Room,
        id=NAMES,
        index=st.integers(0, 99),
        type=TEXTS,
        level=st.integers(-3, 3),
        x=NUMBERS,
        z=NUMBERS,
        width=SIZES,
        depth=SIZES,
        outline=st.just(outline if has_outline else None),
        outdoor=st.booleans(),
        flooring=st.none() | record(types.Flooring, type=TEXTS, color=TEXTS),
        accent=st.none() | TEXTS,
        exterior_walls=SIDES,
        wall_flags=SIDES,
        openings=st.just(openings),
        furniture=st.lists(FURNITURE, max_size=2).map(tuple),
        decorations=st.lists(DECORATIONS, max_size=2).map(tuple),
    )
    drawn: types.Room = draw(parts)
    return drawn


def has_unique_ids(drawn: types.Scene) -> bool:
    bodies = [body.id for room in drawn.rooms for part in (room.furniture, room.decorations) for body in part]
    bodies += [body.id for body in drawn.dynamic]
    return len(set(bodies)) == len(bodies) and len({room.id for room in drawn.rooms}) == len(drawn.rooms)


SCENES = record(
    types.Scene,
    format=st.just(types.FORMAT),
    seed=st.none() | st.integers(0, MAX_SEED),
    request=st.none() | PLAIN_MAPPINGS,
    generator=st.none() | PLAIN_MAPPINGS,
    size=st.none() | record(types.Size, width=SIZES, depth=SIZES, height=SIZES),
    wall_thickness=st.floats(0.0, 1.0),
    levels=st.lists(
        record(types.Level, index=st.integers(-3, 3), elevation=NUMBERS, height=SIZES), max_size=2, unique_by=lambda one: one.index
    ).map(tuple),
    rooms=st.lists(rooms(), max_size=2).map(tuple),
    corridors=st.lists(PLAIN_MAPPINGS, max_size=2).map(tuple),
    adjacency=st.lists(st.tuples(st.integers(0, 99), st.integers(0, 99)), max_size=3).map(tuple),
    dynamic=st.lists(DYNAMIC, max_size=2).map(tuple),
    certificate=st.none() | PLAIN_MAPPINGS,
).filter(has_unique_ids)
