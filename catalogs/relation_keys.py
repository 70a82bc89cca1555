"""Which keys a relation of a room type takes: any other would have no effect, so it is refused.

Not here: what keys mean (docs/relations.md).
"""

from typing import Final

from catalogs.schema import RelationSpec

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
