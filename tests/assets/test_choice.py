"""Which asset a body is shown as: what fits it, with what lies on it; drawn by the seed, the same bytes each time."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from math import log

import pytest

from catalogs import Catalogs, add_assets, load_catalogs
from compose_homes import Decoration, Furniture, Request, Room, Scene, dump, fix, generate
from solver.errors import FieldError
from solver.exchange import dump_text, load_text, read_scene, write_scene
from solver.named_assets import distortion, with_assets
from tests.assets.makers import kept_folder, shape

SIDE = 1.15


def catalogs(**entries: Mapping[str, object]) -> Catalogs:
    """Catalogs with assets made of sofas and so on: `size` is what they are made in."""
    files = {f"{name}.glb": shape(str(entry["shape"]), entry.get("size")) for name, entry in entries.items()}
    said = {
        name: {"file": f"{name}.glb", "license": "CC0-1.0", "kinds": [entry["shape"]]} | _said(entry) for name, entry in entries.items()
    }
    return add_assets(load_catalogs(), kept_folder(files, said))


def _said(entry: Mapping[str, object]) -> dict[str, object]:
    said = {key: value for key, value in entry.items() if key not in ("shape", "size")}
    return said | ({"size": list(entry["size"])} if "size" in entry else {})  # type: ignore[call-overload]


def room(*furniture: Furniture, decorations: tuple[Decoration, ...] = (), seed: int = 1) -> Scene:
    return Scene(seed=seed, rooms=(Room("den", width=8, depth=6, furniture=furniture, decorations=decorations),))


def sofa(number: int = 1, asset: str | None = None, width: float = 2.2) -> Furniture:
    return Furniture(f"sofa_{number}", "sofa", x=2.0, z=number * 1.2, width=width, depth=0.9, height=0.85, kind="sofa", asset=asset)


def names(scene: Scene) -> list[str | None]:
    return [piece.asset for one in scene.rooms for piece in one.furniture]


@pytest.mark.parametrize(("factor", "fits"), [(SIDE - 1e-6, True), (SIDE + 1e-3, False), (1 / SIDE + 1e-6, True), (1 / SIDE - 1e-3, False)])
@pytest.mark.parametrize("side", range(3))
def test_a_side_is_stretched_by_at_most_15_percent(side: int, factor: float, fits: bool) -> None:
    size = [2.2, 0.9, 0.85]
    size[side] /= factor
    known = catalogs(one={"shape": "sofa", "size": tuple(size)})
    assert names(with_assets(room(sofa()), known)) == (["one"] if fits else [None])


def test_the_least_distorted_is_taken() -> None:
    known = catalogs(
        wide={"shape": "sofa", "size": (2.45, 0.9, 0.85)}, close={"shape": "sofa", "size": (2.25, 0.91, 0.86)},
        even={"shape": "sofa", "size": (2.4, 0.98, 0.93)}, chair={"shape": "armchair"},
    )  # fmt: skip
    spread = {name: distortion(known.assets[name], (2.2, 0.9, 0.85)) for name in ("wide", "close", "even")}
    assert spread["wide"] == pytest.approx(log(2.45 / 2.2))
    assert {names(with_assets(room(sofa(), seed=seed), known))[0] for seed in range(40)} == {"close", "even"}


def test_drawn_evenly_by_the_seed_and_in_sets() -> None:
    known = catalogs(**{name: {"shape": "sofa"} for name in ("a", "b", "c", "d")})
    drawn = [names(with_assets(room(sofa(1), sofa(2), seed=seed), known)) for seed in range(400)]
    assert all(one == other for one, other in drawn)
    assert min(Counter(one for one, _ in drawn).values()) > 60
    assert len({tuple(names(with_assets(room(sofa(1), sofa(2, width=2.15), seed=seed), known))) for seed in range(60)}) > 4


def test_what_lies_on_a_body_needs_a_surface_there() -> None:
    pillow = Decoration("pillow", "pillow", "sofa_1", x=2.0, y=0.45, z=1.2, width=0.4, depth=0.4, height=0.15)
    for surfaces, fits in (([], False), ([0.45], True), ([0.43], True), ([0.47], True), ([0.42], False), ([0.1, 0.46], True)):
        known = catalogs(one={"shape": "sofa", "surfaces": surfaces})
        assert names(with_assets(room(sofa(), decorations=(pillow,)), known)) == (["one"] if fits else [None]), surfaces
        assert names(with_assets(room(sofa()), known)) == ["one"]


def test_a_table_carries_on_its_top() -> None:
    known = catalogs(one={"shape": "dining_table"})
    table = Furniture("t", "dining_table", x=3, z=3, width=1.6, depth=0.9, height=0.75)
    vase = Decoration("v", "vase", "t", x=3, y=0.75, z=3, width=0.15, depth=0.15, height=0.3)
    spec = load_catalogs().furniture["dining_table"].size
    table = replace(table, width=spec[0], depth=spec[1], height=spec[2])
    assert names(with_assets(room(table, decorations=(replace(vase, y=spec[2]),)), known)) == ["one"]
    assert names(with_assets(room(table, decorations=(replace(vase, y=spec[2] - 0.1),)), known)) == [None]


def test_a_name_stays_while_it_fits() -> None:
    known = catalogs(a={"shape": "sofa"}, b={"shape": "sofa"}, c={"shape": "sofa"}, d={"shape": "sofa"}, chair={"shape": "armchair"})
    for name in ("a", "b", "c", "d"):
        assert names(with_assets(room(sofa(asset=name)), known)) == [name]
    assert names(with_assets(room(sofa(asset="chair")), known))[0] in {"a", "b", "c", "d"}
    assert names(with_assets(room(sofa(asset="gone", width=1.2)), known)) == [None]
    assert names(with_assets(room(sofa(asset="gone")), load_catalogs())) == ["gone"]


@cache
def whole() -> Catalogs:
    """Catalogs with two assets of every kind of furniture and a few of decorations."""
    kinds = [key for key, kind in load_catalogs().furniture.items() if kind.category != "dynamic"]
    entries: dict[str, dict[str, object]] = {f"{kind}_{n}": {"shape": kind} for kind in kinds for n in (1, 2)}
    return catalogs(**entries, vase={"shape": "vase"}, pillow={"shape": "pillow"})


def test_a_home_is_the_same_but_for_the_names() -> None:
    request = Request(seed=7, program="studio", decorate=True)
    plain, shown = generate(request), generate(request, catalogs=whole())
    named = names(shown.scene) + [item.asset for one in shown.scene.rooms for item in one.decorations]
    assert sum(name is not None for name in named) > 10
    bare = tuple(
        replace(
            one,
            furniture=tuple(replace(piece, asset=None) for piece in one.furniture),
            decorations=tuple(replace(item, asset=None) for item in one.decorations),
        )
        for one in shown.scene.rooms
    )
    assert replace(shown.scene, rooms=bare) == plain.scene
    assert dump(shown.scene) == dump(generate(request, catalogs=whole()).scene)
    assert dump(shown.scene) == dump(with_assets(plain.scene, whole()))
    assert load_text(dump_text(write_scene(shown.scene), "yaml"), "yaml") == write_scene(shown.scene)


def test_a_repaired_scene_keeps_its_assets() -> None:
    made = generate(Request(seed=7, program="studio", decorate=True), catalogs=whole()).scene
    assert dump(fix(made, catalogs=whole()).scene) == dump(made)


@pytest.mark.parametrize("name", ["../sofa", "/etc/passwd", "a/b", "sofa.glb/..", "C:\\x", "", " ", "x" * 101])
def test_a_path_is_no_name(name: str) -> None:
    document = {
        "rooms": [
            {"width": 4, "depth": 4, "furniture": [{"name": "sofa", "x": 1, "z": 1, "width": 1, "depth": 1, "height": 1, "asset": name}]}
        ]
    }
    with pytest.raises(FieldError, match=r"rooms\[0\]\.furniture\[0\]\.asset.*never a path"):
        read_scene(document)
