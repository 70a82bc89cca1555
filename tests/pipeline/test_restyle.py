"""restyle(): a home in another style or with other decorations is the one that was asked for so; an edited one keeps its furniture."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver import Request, Scene, generate, reroll, restyle, validate
from solver.errors import RequestError
from solver.scene import Furniture
from solver.scene_bodies import counted
from tests.sweeps import seeds

STYLES = tuple(load_catalogs().styles)


def standing(scene: Scene) -> list[Furniture]:
    """All furniture, whatever its colour and its asset."""
    return [replace(piece, color=None, asset=None) for room in scene.rooms for piece in room.furniture]


@pytest.mark.parametrize("seed", seeds(range(6), 3))
def test_a_home_becomes_the_one_that_its_request_makes_in_that_style(seed: int) -> None:
    before = Request(seed=seed, width=12, depth=9, outdoor=True, style=STYLES[seed % 6], decorate=seed % 2 == 1)
    home = generate(before).scene
    for style, decorate in ((STYLES[(seed + 1) % 6], None), (None, seed % 2 == 0), (STYLES[(seed + 2) % 6], True), (STYLES[0], False)):
        told = {name: value for name, value in (("style", style), ("decorate", decorate)) if value is not None}
        made = restyle(home, style=style, decorate=decorate)
        wanted = generate(replace(before, **told))  # type: ignore[arg-type]
        assert (made.scene, made.issues) == (wanted.scene, wanted.issues)
        assert standing(made.scene) == standing(home)


def test_a_programme_and_back() -> None:
    home = generate(Request(seed=3, program="one_bed", style="modern", decorate=True)).scene
    other = restyle(home, style="rustic").scene
    assert other != home
    assert restyle(other, style="modern").scene == home


def test_an_edited_home_keeps_every_edit() -> None:
    home = generate(Request(seed=5, width=12, depth=9, style="classic")).scene
    edited = reroll(home, [home.rooms[0].id], seed=99).scene
    room = max(edited.rooms, key=lambda one: len(one.furniture))
    locked = tuple(replace(piece, locked=k == 0) for k, piece in enumerate(room.furniture[:-1]))
    edited = replace(edited, rooms=tuple(replace(one, furniture=locked) if one.id == room.id else one for one in edited.rooms))
    made = restyle(edited, style="scandi", decorate=True)
    assert standing(made.scene) == standing(edited) != standing(home)
    assert sum(len(one.decorations) for one in made.scene.rooms) > 20
    assert [issue.message for issue in made.issues if issue.severity == "error"] == []
    assert made.issues == validate(made.scene, load_catalogs())
    counts = (made.scene.certificate or {}).get("counts")
    assert counts == counted(made.scene.rooms, made.scene.dynamic)


def test_a_scene_of_others_keeps_its_colours_where_nothing_is_known_and_is_not_peopled() -> None:
    piece = Furniture("thing", "thing", "misc", 1.0, 0.0, 1.0, 0, 0.5, 0.5, 0.5, "#123456")
    home = generate(Request(seed=1, width=5, depth=4)).scene
    foreign = replace(home, request=None, certificate=None, seed=None, dynamic=())
    foreign = replace(foreign, rooms=(replace(foreign.rooms[0], furniture=(piece,)), *foreign.rooms[1:]))
    made = restyle(foreign, style="modern", decorate=True).scene
    assert made.rooms[0].furniture[0].color == "#123456"
    assert made.dynamic == ()
    assert (made.request or {}) == {"style": "modern", "decorate": True}


def test_an_unknown_style_is_refused_with_the_known_ones() -> None:
    home = generate(Request(seed=1, width=5, depth=4)).scene
    with pytest.raises(RequestError, match="unknown style 'baroque'") as told:
        restyle(home, style="baroque")
    assert (told.value.field, told.value.allowed) == ("style", ", ".join(STYLES))
