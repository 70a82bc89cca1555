"""The columns of a dataset's tables and their types. Lengths in m, areas in m2, masses in kg, turns in degrees."""

from __future__ import annotations

from typing import Final

import pyarrow as pa

TEXT, FLAG, REAL, WHOLE = pa.string(), pa.bool_(), pa.float64(), pa.int64()
TEXTS = pa.list_(TEXT)


def _schema(text: dict[str, pa.DataType]) -> pa.Schema:
    return pa.schema([pa.field(name, kind) for name, kind in text.items()])


def _named(names: str, kind: pa.DataType) -> dict[str, pa.DataType]:
    return dict.fromkeys(names.split(), kind)


SCHEMAS: Final[dict[str, pa.Schema]] = {
    "houses": _schema(
        {
            "seed": WHOLE,
            **_named("id split status program style request catalog catalog_fingerprint version", TEXT),
            **_named("width depth area", REAL),
            **_named("rooms doors windows furniture decorations people errors warnings proven best left_out missing", WHOLE),
            **_named("unjoined notes issues", TEXTS),
            **_named("refused digest scene", TEXT),
        }
    ),
    "rooms": _schema(
        {
            "seed": WHOLE,
            "id": TEXT,
            "index": WHOLE,
            "type": TEXT,
            "level": WHOLE,
            "outdoor": FLAG,
            **_named("x z width depth area", REAL),
            "polygon": pa.list_(pa.list_(REAL)),
            "flooring": TEXT,
            **_named("furniture decorations", WHOLE),
            "cost": REAL,
            **_named("proven best", FLAG),
            "left_out": TEXTS,
        }
    ),
    "pieces": _schema(
        {
            "seed": WHOLE,
            **_named("id room sort name kind category", TEXT),
            **_named("x y z turn width depth height mass", REAL),
            **_named("color parent under wall", TEXT),
        }
    ),
    "receptacles": _schema(
        {"seed": WHOLE, **_named("id piece room surface front", TEXT), **_named("x y z turn width depth clearance", REAL)}
    ),
    "doors": _schema(
        {
            "seed": WHOLE,
            **_named("id kind", TEXT),
            "level": WHOLE,
            "axis": TEXT,
            **_named("x z width sill head", REAL),
            **_named("room_a room_b hinge swing", TEXT),
            "main_entrance": FLAG,
        }
    ),
    "graph": _schema({"seed": WHOLE, **_named("a b edge door", TEXT)}),
    "fronts": _schema({"seed": WHOLE, **_named("piece front", TEXT), "opens": REAL, "meets": TEXT}),
}
"""The schemas by table; every row names its home by `seed`."""
