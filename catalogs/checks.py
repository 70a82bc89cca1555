"""What must hold between the catalogs' entries; the shape of each entry is the schema's business."""

from collections.abc import Collection, Iterator, Sequence
from graphlib import CycleError, TopologicalSorter
from itertools import pairwise
from typing import Final

from catalogs.decoration_types import ALL, INDOOR, SURFACE, Decorating, DecorationKind, Holds, Lies
from catalogs.entries import KindSpec
from catalogs.faults import Fault, Key
from catalogs.insides import insides_of
from catalogs.references import near, unknown_words
from catalogs.schema import Catalogs, PieceSpec, RelationSpec, RoomType
from catalogs.shapes_checks import Shapes, shape_faults

OPENINGS: Final = ("door", "garage_door", "window", "front_door")
"""What `of` may name besides pieces."""
EVERY: Final = ("type", "of", "required", "cost", "weight")
KEYS: Final[dict[str, tuple[str, ...]]] = {
    "against_wall": ("walls",),
    "in_corner": (),
    "centred": (),
    "at_window": (),
    "near_door": ("distance",),
    "far_from_door": ("distance",),
    "beside": ("sides", "gap", "align", "wall"),
    "in_front_of": ("sides", "gap", "align", "wall"),
    "around": ("sides", "gap"),
    "under": ("sides", "gap", "align", "wall"),
    "on": ("align",),
    "in_row": ("gap", "wall"),
    "opposite": (),
    "facing": (),
    "near": ("distance", "wall"),
    "far_from": ("distance", "wall"),
    "aligned_with": ("wall",),
}
"""The keys of each relation besides those that all may have."""
PULLS: Final = ("near", "aligned_with")
"""Relations that only pull towards a piece, by `weight`: no distance is too far. A `cost` is for its `wall`, and for being out of line."""


def idle_keys(rule: RelationSpec) -> list[str]:
    """Returns the keys that a rule has and that nothing comes of."""
    taken = {*EVERY, *KEYS[rule.type]}
    if rule.type in PULLS and not set(rule.of) & set(OPENINGS):
        taken -= {"distance"} if rule.wall or rule.type == "aligned_with" else {"distance", "cost"}
    return sorted(rule.model_fields_set - taken)


BETWEEN = ("beside", "in_front_of", "opposite", "around", "aligned_with", "in_row", "on", "under")
"""Relations that hold between two pieces: `of` must name one."""
BY_DEGREE = ("near", "far_from", "aligned_with")
"""Between pieces these cost, they do not forbid."""
TO_SOMETHING = ("facing", "near", "far_from")
"""Relations to a piece or an opening."""


def faults(catalogs: Catalogs, shapes: Shapes) -> Iterator[Fault]:
    """Yields everything that does not fit together."""
    known = _vocabulary(catalogs, shapes)
    for section in (name for name in Catalogs.model_fields if name not in ("shapes", "profile", "home", "fingerprint")):
        for name, entry in getattr(catalogs, section).items():
            file, at = (f"rooms/{name}", ()) if section == "rooms" else (section, (name,))
            yield from unknown_words(entry, file, at, known)
    for name, parts in shapes.items():
        for i, part in enumerate(parts):
            yield from unknown_words(part, "shapes", (name, i), known)
    for kind, furniture in catalogs.furniture.items():
        yield from _size_faults("furniture", kind, furniture)
        same = catalogs.furniture.get(catalogs.name_of(kind))
        if same is None or same.category != furniture.category:
            yield Fault("furniture", (kind, "name"), f"{furniture.name!r} is no kind of the same category", "a key of furniture.yaml")
    for kind, decoration in catalogs.decorations.items():
        yield from _size_faults("decorations", kind, decoration)
    for name, room in catalogs.rooms.items():
        yield from _room_faults(catalogs, f"rooms/{name}", room)
    for name, preset in catalogs.presets.items():
        if not any(preset.rooms.values()):
            yield Fault("presets", (name, "rooms"), "the preset has no rooms", "at least one")
    yield from _habit_faults(catalogs)
    yield from _synonym_faults(catalogs)
    yield from decorating_faults(catalogs)
    yield from shape_faults(catalogs, shapes)


def _synonym_faults(catalogs: Catalogs) -> Iterator[Fault]:
    """Checks that what others call kinds and rooms are kinds and room types."""
    kinds = (*catalogs.furniture, *catalogs.decorations)
    for name, synonym in catalogs.synonyms.items():
        if synonym.means == "kind" and name not in kinds:
            yield Fault("synonyms", (name,), f"unknown kind {name!r}{near(name, kinds)}", "a key of furniture.yaml or decorations.yaml")
    for name, synonym in catalogs.room_names.items():
        if synonym.means == "kind" and name not in catalogs.rooms:
            yield Fault("room_names", (name,), f"unknown room type {name!r}{near(name, catalogs.rooms)}", "a file of rooms/")


def _habit_faults(catalogs: Catalogs) -> Iterator[Fault]:
    """Checks that habits speak of furniture by the names that scenes call it."""
    names = {catalogs.name_of(kind) for kind in catalogs.furniture}
    for name, habit in catalogs.habits.items():
        if name not in names:
            yield Fault("habits", (name,), f"unknown piece name {name!r}{near(name, names)}", "a name of furniture.yaml")
        for i, way in enumerate(habit.ways):
            for j, rule in enumerate(way):
                for other in (word for word in rule.of if word not in names):
                    at = (name, "ways", i, j, "of")
                    yield Fault("habits", at, f"unknown piece name {other!r}{near(other, names)}", "a name of furniture.yaml")


def _vocabulary(catalogs: Catalogs, shapes: Shapes) -> dict[str, Collection[str]]:
    """Returns the words there are, by what entries say they name."""
    furniture, decorations = catalogs.furniture, catalogs.decorations
    decorating = decorations.keys() | {entry.group for entry in decorations.values()}
    return {
        "decoration": decorations,
        "decoration or group": decorating,
        "flooring": catalogs.floorings,
        "kind": furniture,
        "kind of people or pets": [kind for kind, entry in furniture.items() if entry.category == "dynamic"],
        "kind or category": furniture.keys() | {entry.category for entry in furniture.values()} | decorating,
        "material": catalogs.materials,
        "piece name": {catalogs.name_of(kind) for kind in furniture},
        "room type": catalogs.rooms,
        "shape": shapes,
        "style": catalogs.styles,
        "word for rooms": sorted({room.home.word or name for name, room in catalogs.rooms.items() if room.home}),
    }


def _size_faults(section: str, kind: str, entry: KindSpec) -> Iterator[Fault]:
    """Checks that a kind's surfaces are within it."""
    for i, surface in enumerate(entry.surfaces):
        at = (kind, "surfaces", i)
        if surface.height > entry.size[2] + 1e-9:
            problem = f"the surface {surface.name!r} lies at {surface.height} m, above the piece"
            yield Fault(section, (*at, "height"), problem, f"at most {entry.size[2]}")
        if 2 * surface.inset >= min(entry.size[:2]):
            yield Fault(section, (*at, "inset"), f"the surface {surface.name!r} has no area left", "a smaller inset")


def _room_faults(catalogs: Catalogs, file: str, room: RoomType) -> Iterator[Fault]:
    names: list[str] = []
    for i, piece in enumerate(room.pieces):
        if piece.piece in names:
            yield Fault(file, ("pieces", i, "piece"), f"the piece {piece.piece!r} stands twice", "one entry with a count")
        names.append(piece.piece)
        if len(piece.kinds) == 0 and piece.piece not in catalogs.furniture:
            problem = f"unknown kind {piece.piece!r}{near(piece.piece, catalogs.furniture)}"
            yield Fault(file, ("pieces", i, "piece"), problem, "a key of furniture.yaml")
        least = max((k for k, one in enumerate(piece.variants) if not one.corner), default=0)
        if piece.variants[least].min_area:
            at = ("pieces", i, "kinds", least, "min_area")
            yield Fault(file, at, "the least variant must suit any room", "no min_area; the piece's own min_area")
        if piece.variants[0].corner:
            yield Fault(file, ("pieces", i, "kinds", 0, "corner"), "the wanted variant must stand anywhere", "no corner; another one first")
        for j, rule in enumerate(piece.rules):
            yield from _rule_faults(Fault(file, ("pieces", i, "rules", j), ""), room, piece, rule)
    if room.pieces and room.pieces[-1].with_next:
        yield Fault(file, ("pieces", len(room.pieces) - 1, "with_next"), "no piece comes after this one", "no such key")
    yield from _run_faults(file, room, names)
    yield from _required_faults(catalogs, file, room)
    yield from _order_faults(file, room)


def _run_faults(file: str, room: RoomType, names: list[str]) -> Iterator[Fault]:
    """Checks that a run speaks of pieces of its room type."""
    if room.run is None:
        return
    run = room.run
    lists = (("worktop",), run.worktop), (("landing",), run.landing), (("ends",), run.ends)
    for key, words in (*((("orders", i), order) for i, order in enumerate(run.orders)), *lists):
        for name in words:
            if name not in names:
                yield Fault(file, ("run", *key), f"unknown piece {name!r}{near(name, names)}", ", ".join(names))
    for i, leaving in enumerate(run.leaves):
        after = [name for name in names if not any(name in order for order in run.orders)]
        if leaving.to not in after:
            yield Fault(file, ("run", "leaves", i, "to"), f"unknown piece {leaving.to!r}{near(leaving.to, after)}", ", ".join(after))
    for name in room.run.triangle:
        if any(name not in order for order in room.run.orders):
            yield Fault(file, ("run", "triangle"), f"{name!r} is not in every order", ", ".join(names))


def _rule_faults(where: Fault, room: RoomType, piece: PieceSpec, rule: RelationSpec) -> Iterator[Fault]:
    """Checks what a rule's `of` names; `where` holds the room and the key."""
    known = [other.piece for other in room.pieces]
    if rule.type in BETWEEN + TO_SOMETHING and not rule.of:
        yield Fault(where.file, where.at, f"{rule.type} needs `of`", ", ".join(known))
    elif rule.type not in BETWEEN + TO_SOMETHING and rule.of:
        yield Fault(where.file, (*where.at, "of"), f"{rule.type} takes no `of`", "no key `of`")
    if rule.required and rule.type in BY_DEGREE and rule.wall is None and not set(rule.of) & set(OPENINGS):
        yield Fault(where.file, (*where.at, "required"), f"{rule.type} of a piece is a matter of degree", "a cost or a weight")
    for key in idle_keys(rule):
        to = " a piece" if rule.type in PULLS else ""
        yield Fault(where.file, (*where.at, key), f"{rule.type}{to} takes no `{key}`: nothing would come of it", "no such key")
    for other in rule.of:
        openings = OPENINGS if rule.type in TO_SOMETHING else ()
        if other not in known and other not in openings:
            words = [*known, *openings]
            yield Fault(where.file, (*where.at, "of"), f"unknown piece {other!r}{near(other, words)}", ", ".join(words))
        if other == piece.piece and (piece.count == 1 or rule.type not in ("in_row", *BY_DEGREE)):
            yield Fault(where.file, (*where.at, "of"), f"{rule.type} of itself", "in_row, near, far_from or aligned_with, with count > 1")


def _required_faults(catalogs: Catalogs, file: str, room: RoomType) -> Iterator[Fault]:
    """Checks that the required pieces are enough for every line of `requires`: whichever of their variants are taken."""
    supply = [({catalogs.name_of(one.kind) for one in piece.variants}, piece.count) for piece in room.pieces if piece.required]
    for i, line in enumerate(room.requires):
        together = any(sum(count for names, count in supply if names == {name}) >= wanted for name, wanted in line.items())
        if not together and not any(all(name in line and line[name] <= count for name in names) for names, count in supply):
            yield Fault(file, ("requires", i), "the required pieces do not meet this line", "a piece with `required: true`")


def _order_faults(file: str, room: RoomType) -> Iterator[Fault]:
    """Rules may only refer to pieces that come earlier, required ones first: so no two wait for each other."""
    order = [piece.piece for piece in sorted(room.pieces, key=lambda piece: not piece.required)]
    for i, piece in enumerate(room.pieces):
        before = {one.piece for one in room.pieces[:i]}
        for j, rule in enumerate(piece.rules):
            for other in rule.of:
                if other in order and order.index(other) > order.index(piece.piece):
                    at = ("pieces", i, "rules", j, "of")
                    if other in before:
                        problem = f"{piece.piece!r} is required and refers to {other!r}, which is not: it may be left out"
                        yield Fault(file, at, problem, "a required piece named earlier")
                        continue
                    problem = f"{piece.piece!r} refers to {other!r}, which comes later: rules must not go round in a circle"
                    yield Fault(file, at, problem, "a piece named earlier; an optional piece may refer to any required one")


SLACK = 1e-9


def decorating_faults(catalogs: Catalogs) -> Iterator[Fault]:
    """Yields everything that does not fit together in decorations.yaml and decorating.yaml."""
    for name, kind in catalogs.decorations.items():
        if kind.jitter and kind.surfaces:
            yield Fault("decorations", (name, "jitter"), "what carries things lies straight", "no `jitter` beside `surfaces`")
    for name, entry in catalogs.decorating.items():
        yield from _entry_faults(catalogs, name, entry)
    yield from _circles(catalogs)


def _parents(catalogs: Catalogs, name: str) -> list[Sequence[KindSpec]]:
    """Returns what bears a name: at most one of each sort; a room is no kind at all."""
    pieces = [entry for kind, entry in catalogs.furniture.items() if (entry.name or kind) == name]
    things = [catalogs.decorations[name]] if name in catalogs.decorations else []
    room: list[Sequence[KindSpec]] = [()] if name in catalogs.rooms or name == INDOOR else []
    return [*(found for found in (pieces, things) if found), *room]


def _entry_faults(catalogs: Catalogs, name: str, entry: Decorating) -> Iterator[Fault]:
    parents = _parents(catalogs, name)
    if not parents:
        words = {*catalogs.kinds_by_name(), *catalogs.decorations, *catalogs.rooms, INDOOR}
        problem = f"unknown parent {name!r}{near(name, words)}"
        yield Fault("decorating", (name,), problem, "a name of furniture.yaml, a key of decorations.yaml or of rooms/, or indoor")
        return
    if len(parents) > 1:
        kind = next((kind for kind in catalogs.furniture if catalogs.name_of(kind) == name), None)
        others = "decoration and no room type" if kind else "room type"
        problem = f"{name!r} is a name of several things, which are decorated each in its way"
        yield Fault("furniture" if kind else "decorations", (kind or name,), problem, f"a name that no {others} has")
        return
    (kinds,) = parents
    if entry.holds and not any(kind in catalogs.furniture.values() for kind in kinds):
        yield Fault("decorating", (name, "holds"), "furniture alone holds things", "`lies` for what is on a thing")
        return
    if not kinds and entry.lies:
        yield Fault("decorating", (name, "lies"), "things lie on furniture and decorations", "`stands` for a room's floor")
    if kinds and entry.stands:
        yield Fault("decorating", (name, "stands"), "things stand on a room's floor", "`lies` for what is on a piece")
    for i in range(len(entry.lies)):
        yield from _lying_faults(catalogs, (name, "lies", i), kinds, entry.lies[: i + 1])


def holding_faults(catalogs: Catalogs) -> Iterator[Fault]:
    """Yields every row of what furniture `holds` that has no room inside any kind of its name; shapes are known by now."""
    for name, entry in catalogs.decorating.items():
        for i, row in enumerate(entry.holds):
            yield from _holding_faults(catalogs, (name, "holds", i), name, row)


def _holding_faults(catalogs: Catalogs, at: Key, name: str, row: Holds) -> Iterator[Fault]:
    """Checks that a row has room inside any kind of that name."""
    kinds = {kind: entry for kind, entry in catalogs.furniture.items() if (entry.name or kind) == name}
    inside = [one for kind, entry in kinds.items() for one in insides_of(catalogs.shapes.get(kind, ()), entry.size)]
    if not any(one.sort in row.surface for one in inside):
        yield Fault("decorating", (*at, "surface"), f"{name!r} has no {' or '.join(row.surface)} inside", "a shape with a `hollow` part")
        return
    places = [((one.x[1] - one.x[0], one.z[1] - one.z[0]), one.clearance) for one in inside if one.sort in row.surface]
    for thing in row.put:
        kind = catalogs.decorations.get(thing)
        if kind and not any(_fits(kind, row, *place) for place in places):
            yield Fault("decorating", (*at, "put"), f"{thing!r} is larger than {' and '.join(row.surface)} in {name!r}", "a smaller thing")


def _unknown(at: Key, words: Sequence[str], known: Collection[str], what: str, allowed: str) -> Iterator[Fault]:
    for word in words:
        if word not in known:
            yield Fault("decorating", at, f"unknown {what} {word!r}{near(word, known)}", allowed)


def _lying_faults(catalogs: Catalogs, at: Key, parents: Sequence[KindSpec], rows: Sequence[Lies]) -> Iterator[Fault]:
    """Checks the last of some rows: what it lies on, and whether it finds room there."""
    row, before = rows[-1], {name for other in rows[:-1] for name in other.put}
    names = {surface.name for parent in parents for surface in parent.surfaces}
    yield from _unknown((*at, "surface"), row.surface, names | {ALL}, "surface", ", ".join([*sorted(names), ALL]))
    yield from _unknown((*at, "on"), row.on, before | {SURFACE}, "carrier", ", ".join([*sorted(before), SURFACE]))
    for name in row.on:
        carrier = catalogs.decorations.get(name)
        if carrier is not None and not carrier.surfaces:
            yield Fault("decorating", (*at, "on"), f"{name!r} has no surface", "a kind with `surfaces`")
    if not names and set(row.on) <= {SURFACE}:
        yield Fault("decorating", (*at, "put"), f"{at[0]!r} has no surface to lie on", "a parent with `surfaces`")
        return
    for name in row.put:
        kind = catalogs.decorations.get(name)
        places = list(_places(catalogs, parents, row))
        if kind and places and not any(_fits(kind, row, *place) for place in places):
            widest = max(places, key=lambda place: place[0][0])[0]
            yield Fault("decorating", (*at, "put"), f"{name!r} is larger than its surface", f"at most {widest[0]:.2f} x {widest[1]:.2f} m")


def _places(catalogs: Catalogs, parents: Sequence[KindSpec], row: Lies) -> Iterator[tuple[tuple[float, float], float | None]]:
    """Yields the extents of the surfaces that a row's things may lie on, and the free height above."""
    for name in row.on or (SURFACE,):
        thing = catalogs.decorations.get(name)
        for kind in parents if name == SURFACE else [thing] if thing else []:
            named = [surface for surface in kind.surfaces if ALL in row.surface or surface.name in row.surface]
            for surface in named if row.surface else kind.surfaces[-1:]:
                yield (kind.size[0] - 2 * surface.inset, kind.size[1] - 2 * surface.inset), surface.clearance


def _fits(kind: DecorationKind, row: Lies, extent: tuple[float, float], clearance: float | None) -> bool:
    width, depth, height = kind.size[0] * row.min_scale, kind.size[1] * row.min_scale, kind.size[2]
    if row.upright:
        depth, height = height, depth
    if row.turn in (90, 270):
        width, depth = depth, width
    if row.fill:
        width, depth = 0.0, 0.0
    low_enough = clearance is None or height <= clearance + SLACK
    return low_enough and width <= extent[0] + SLACK and depth <= extent[1] + SLACK


def _circles(catalogs: Catalogs) -> Iterator[Fault]:
    """Refuses decorations that would carry one another without end."""
    things = catalogs.decorating.keys() & catalogs.decorations.keys()
    carries = {name: {put for row in catalogs.decorating[name].lies for put in row.put} & things for name in sorted(things)}
    try:
        TopologicalSorter(carries).prepare()
    except CycleError as circle:
        path = circle.args[1][::-1]
        links = ", ".join(f"{one} carries {other}" for one, other in pairwise(path))
        problem = f"decorations go round in a circle: {links}"
        yield Fault("decorating", (path[0], "lies"), problem, "things that carry others, not themselves")
