"""What must hold between the catalogs' entries; the shape of each entry is the schema's business."""

from __future__ import annotations

from collections.abc import Iterator

from catalogs.dressing_checks import dressing_faults
from catalogs.faults import Fault
from catalogs.schema import Catalogs, Furniture, Piece, RoomType, Rule
from catalogs.styles import Style

OPENINGS = ("door", "garage_door", "window")
"""What `of` may name besides pieces."""
BETWEEN = ("beside", "in_front_of", "opposite", "around", "aligned_with", "in_row", "on", "under")
"""Relations that hold between two pieces: `of` must name one."""
PULLS = ("near", "far_from", "aligned_with")
"""Relations of degree: between pieces they cost, they do not forbid."""
TO_SOMETHING = ("facing", "near", "far_from")
"""Relations to a piece or an opening."""


def faults(catalogs: Catalogs) -> Iterator[Fault]:
    """Yields everything that does not fit together, in the order of the files."""
    for kind, entry in catalogs.furniture.items():
        yield from _furniture_faults(kind, entry)
        if (
            catalogs.furniture.get(catalogs.name_of(kind), entry).category != entry.category
            or catalogs.name_of(kind) not in catalogs.furniture
        ):
            yield Fault("furniture", (kind, "name"), f"{entry.name!r} is no kind of the same category", "a key of furniture.yaml")
    for name, room in catalogs.rooms.items():
        yield from _room_faults(catalogs, f"rooms/{name}", room)
    for name, style in catalogs.styles.items():
        yield from _style_faults(catalogs, name, style)
    yield from _preset_faults(catalogs)
    yield from dressing_faults(catalogs)


def _preset_faults(catalogs: Catalogs) -> Iterator[Fault]:
    words = sorted({room.home.word or name for name, room in catalogs.rooms.items() if room.home})
    for name, preset in catalogs.presets.items():
        for word in preset.rooms:
            if word not in words:
                yield Fault("presets", (name, "rooms", word), f"no room type is counted by {word!r}", ", ".join(words))
        if not any(preset.rooms.values()):
            yield Fault("presets", (name, "rooms"), "the preset has no rooms", "at least one")


def _furniture_faults(kind: str, entry: Furniture) -> Iterator[Fault]:
    for i, length in enumerate(entry.size):
        if round(length * 1000) % 10 or abs(length * 100 - round(length * 100)) > 1e-9:
            yield Fault("furniture", (kind, "size", i), f"{length} m is not a whole number of centimetres", "steps of 0.01")
    for i, surface in enumerate(entry.surfaces):
        if surface.height > entry.size[2] + 1e-9:
            yield Fault(
                "furniture", (kind, "surfaces", i, "height"),
                f"the surface {surface.name!r} lies at {surface.height} m, above the piece", f"at most {entry.size[2]}",
            )  # fmt: skip
        if 2 * surface.inset >= min(entry.size[:2]):
            yield Fault("furniture", (kind, "surfaces", i, "inset"), f"the surface {surface.name!r} has no area left", "a smaller inset")


def _room_faults(catalogs: Catalogs, file: str, room: RoomType) -> Iterator[Fault]:
    if room.flooring not in catalogs.floorings:
        yield Fault(file, ("flooring",), f"unknown flooring {room.flooring!r}", ", ".join(catalogs.floorings))
    for i, other in enumerate(room.plan.behind):
        if other not in catalogs.rooms:
            yield Fault(file, ("plan", "behind", i), f"unknown room type {other!r}", ", ".join(catalogs.rooms))
    names: list[str] = []
    for i, piece in enumerate(room.pieces):
        if piece.piece in names:
            yield Fault(file, ("pieces", i, "piece"), f"the piece {piece.piece!r} stands twice", "one entry with a count")
        names.append(piece.piece)
        yield from _kind_faults(catalogs, file, i, piece)
        for j, other in enumerate(piece.without):
            if other not in catalogs.rooms:
                yield Fault(file, ("pieces", i, "without", j), f"unknown room type {other!r}", ", ".join(catalogs.rooms))
        for j, rule in enumerate(piece.rules):
            yield from _rule_faults(Fault(file, ("pieces", i, "rules", j), ""), room, piece, rule)
    yield from _run_faults(file, room, names)
    yield from _required_faults(catalogs, file, room)
    yield from _order_faults(file, room)


def _run_faults(file: str, room: RoomType, names: list[str]) -> Iterator[Fault]:
    """Checks that a run speaks of pieces of its room type."""
    if room.run is None:
        return
    for key, words in (*((("orders", i), order) for i, order in enumerate(room.run.orders)), (("corners",), room.run.corners)):
        for name in words:
            if name not in names:
                yield Fault(file, ("run", *key), f"unknown piece {name!r}", ", ".join(names))
    for name in room.run.triangle:
        if any(name not in order for order in room.run.orders):
            yield Fault(file, ("run", "triangle"), f"{name!r} is not in every order", ", ".join(names))


def _kind_faults(catalogs: Catalogs, file: str, index: int, piece: Piece) -> Iterator[Fault]:
    for i, variant in enumerate(piece.variants):
        if variant.kind not in catalogs.furniture:
            at = ("pieces", index, "kinds", i, "kind") if piece.kinds else ("pieces", index, "piece")
            yield Fault(file, at, f"unknown kind {variant.kind!r}", "a key of furniture.yaml")
    if piece.variants[-1].min_area:
        at = ("pieces", index, "kinds", len(piece.kinds) - 1, "min_area")
        yield Fault(file, at, "the least variant must suit any room", "no min_area; the piece's own min_area")


def _rule_faults(where: Fault, room: RoomType, piece: Piece, rule: Rule) -> Iterator[Fault]:
    """Checks what a rule's `of` names; `where` holds the room and the key."""
    known = [other.piece for other in room.pieces]
    if rule.type in BETWEEN + TO_SOMETHING and not rule.of:
        yield Fault(where.file, where.at, f"{rule.type} needs `of`", ", ".join(known))
    elif rule.type not in BETWEEN + TO_SOMETHING and rule.of:
        yield Fault(where.file, (*where.at, "of"), f"{rule.type} takes no `of`", "no key `of`")
    if rule.required and rule.type in PULLS and rule.wall is None and not set(rule.of) & set(OPENINGS):
        yield Fault(where.file, (*where.at, "required"), f"{rule.type} of a piece is a matter of degree", "a cost or a weight")
    for other in rule.of:
        openings = OPENINGS if rule.type in TO_SOMETHING else ()
        if other not in known and other not in openings:
            yield Fault(where.file, (*where.at, "of"), f"unknown piece {other!r}", ", ".join([*known, *openings]))
        if other == piece.piece and (piece.count == 1 or rule.type not in ("in_row", "near", "far_from")):
            yield Fault(where.file, (*where.at, "of"), f"{rule.type} of itself", "in_row, near or far_from, with count > 1")


def _required_faults(catalogs: Catalogs, file: str, room: RoomType) -> Iterator[Fault]:
    """Checks that the required pieces are enough for every line of `requires`."""
    names = [catalogs.name_of(kind) for kind in catalogs.furniture]
    for i, line in enumerate(room.requires):
        for kind in line:
            if kind not in names:
                yield Fault(file, ("requires", i, kind), f"unknown kind {kind!r}", "a name of furniture.yaml")
        if not any(_supplied(catalogs, room, kind) >= count for kind, count in line.items()) and not _mixed(catalogs, room, line):
            yield Fault(file, ("requires", i), "the required pieces do not meet this line", "a piece with `required: true`")


def _supplied(catalogs: Catalogs, room: RoomType, kind: str) -> int:
    """Counts the required pieces all of whose variants bear that name."""
    return sum(
        piece.count for piece in room.pieces if piece.required and all(catalogs.name_of(variant.kind) == kind for variant in piece.variants)
    )


def _mixed(catalogs: Catalogs, room: RoomType, line: dict[str, int]) -> bool:
    """Tells whether one required piece meets the line whichever of its variants is taken."""
    return any(
        piece.required
        and all(line.get(catalogs.name_of(variant.kind), 1 << 30) <= piece.count for variant in piece.variants)
        for piece in room.pieces
    )  # fmt: skip


def _order_faults(file: str, room: RoomType) -> Iterator[Fault]:
    """Rules may only refer to pieces that come earlier, required ones first: so no two wait for each other."""
    order = [piece.piece for piece in sorted(room.pieces, key=lambda piece: not piece.required)]
    for i, piece in enumerate(room.pieces):
        for j, rule in enumerate(piece.rules):
            for other in rule.of:
                if other in order and order.index(other) > order.index(piece.piece):
                    yield Fault(
                        file, ("pieces", i, "rules", j, "of"),
                        f"{piece.piece!r} refers to {other!r}, which comes later: rules must not go round in a circle",
                        "a piece named earlier; an optional piece may refer to any required one",
                    )  # fmt: skip


def _style_faults(catalogs: Catalogs, name: str, style: Style) -> Iterator[Fault]:
    decorations = catalogs.decorations.keys() | {entry.group for entry in catalogs.decorations.values()}
    furniture = catalogs.furniture.keys() | {entry.category for entry in catalogs.furniture.values()}
    for key in style.palette:
        if key not in furniture | decorations:
            allowed = "a kind or category of furniture.yaml, a kind or group of decorations.yaml"
            yield Fault("styles", (name, "palette", key), f"unknown kind or category {key!r}", allowed)
    for section, kinds in (("favoured", style.decorations.favoured), ("avoided", style.decorations.avoided)):
        for kind in kinds:
            if kind not in decorations:
                at = (name, "decorations", section)
                yield Fault("styles", at, f"unknown decoration {kind!r}", "a kind or group of decorations.yaml")
    yield from _material_faults(catalogs, name, style)


def _material_faults(catalogs: Catalogs, name: str, style: Style) -> Iterator[Fault]:
    known = ", ".join(catalogs.floorings)
    for section, named in (("floors", style.floors), ("walls", style.walls)):
        for flooring in named:
            if flooring not in catalogs.floorings:
                yield Fault("styles", (name, section, flooring), f"unknown flooring {flooring!r}", known)
    for flooring, floors in style.floors.items():
        for i, floor in enumerate(floors):
            if floor.type is not None and floor.type not in catalogs.floorings:
                yield Fault("styles", (name, "floors", flooring, i, "type"), f"unknown flooring {floor.type!r}", known)
