"""The ruler of living rooms and bedrooms, on rooms laid by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest

from solver import generate
from solver.request import Request
from solver.scene import Decoration, Furniture, Opening, Room, Scene
from tests.density import living_ruler as ruler
from tests.density.test_density import body


def scene(*pieces: Furniture, kind: str = "living_room", things: tuple[Decoration, ...] = (), openings: tuple[Opening, ...] = ()) -> Scene:
    """Returns a home of one room of 6 x 5 m."""
    room = Room("r", 0, kind, width=6.0, depth=5.0, furniture=pieces, decorations=things, openings=openings)
    return Scene(seed=0, wall_thickness=0.1, rooms=(room,))


def test_a_front_is_free_to_its_last_centimetre() -> None:
    wardrobe = body("wardrobe", (1, 0.08), (1.2, 0.6))
    near, far = body("plant", (2.1, 1.2), (0.4, 0.4)), body("plant", (2.1, 1.29), (0.4, 0.4))
    basket = Decoration("b", "basket", x=2.0, z=1.0, width=0.3, depth=0.3, height=0.3)
    rug = replace(basket, height=0.01)
    assert ruler.fronts_free(scene(wardrobe, near)) == (0, 1)
    assert ruler.fronts_free(scene(wardrobe, far)) == (1, 1)
    assert ruler.fronts_free(scene(wardrobe, things=(basket,))) == (0, 1)
    assert ruler.fronts_free(scene(wardrobe, things=(rug,))) == (1, 1)
    assert ruler.things_in_the_way(scene(wardrobe, near)) == (1, 1)


def test_open_shelves_are_free_along_their_fronts() -> None:
    shelf = body("bookshelf", (1, 0.08), (1.0, 0.3))
    near, far = body("desk", (1.9, 0.45), (1.2, 0.6)), body("desk", (1.9, 0.79), (1.2, 0.6))
    assert ruler.shelves_free(scene(shelf, near)) == (0, 1)
    assert ruler.shelves_free(scene(shelf, far)) == (1, 1)
    found = [ruler.shelves_free(generate(Request(seed=seed)).scene) for seed in range(8_642_000, 8_642_006)]
    assert sum(held for held, _ in found) >= 0.9 * sum(cases for _, cases in found) > 50  # 0.67 before it was wished


def test_seats_are_free_along_their_fronts() -> None:
    chair = body("armchair", (1, 1), (0.8, 0.82))
    near, far = (body("bookshelf", (0.7, z), (0.3, 1.0), 90) for z in (2.19, 2.21))
    assert ruler.seats_free(scene(chair, replace(near, x=1.2))) == (0, 1)
    assert ruler.seats_free(scene(chair, replace(far, x=1.2))) == (1, 1)
    found = [ruler.seats_free(generate(Request(seed=seed)).scene) for seed in range(8_642_000, 8_642_006)]
    assert sum(held for held, _ in found) >= 0.9 * sum(cases for _, cases in found) > 30  # 0.84 before it was wished


def test_coat_racks_are_come_to() -> None:
    rack = body("coat_rack", (1, 0.08), (0.5, 0.36))
    near, far = (body("console_table", (1.2, z), (1.2, 0.34)) for z in (0.73, 0.75))
    assert ruler.racks_free(scene(rack, near)) == (0, 1)
    assert ruler.racks_free(scene(rack, far)) == (1, 1)


def test_desks_are_near_a_window() -> None:
    window = Opening("w", "window", "north", 1.0, 1.2, 1.4, 0.9)
    near, far = (body("desk", (3.1, z), (1.2, 0.6)) for z in (1.99, 2.01))  # 1.5 m aside
    assert ruler.desks_lit(scene(near, openings=(window,))) == (1, 1)
    assert ruler.desks_lit(scene(far, openings=(window,))) == (0, 1)
    assert ruler.desks_lit(scene(far)) == (0, 0)


def _table(*sides: str, corner: tuple[float, float] = (2, 2)) -> Scene:
    x, z = corner
    places = {"n": ((x + 0.5, z - 0.3), 0), "s": ((x + 0.5, z + 0.7), 180), "w": ((x - 0.3, z + 0.2), 90), "e": ((x + 1.4, z + 0.2), 270)}
    chairs = []
    for k, side in enumerate(sides):
        at, turn = places[side]
        chairs.append(replace(body("dining_chair", at, (0.46, 0.5), turn), id=f"chair_{k}", under="dining_table"))
    return scene(body("dining_table", corner, (1.6, 0.9)), *chairs, kind="dining_room")


def test_chairs_are_even_across_a_table() -> None:
    assert ruler.lopsided(_table("n", "s")) == (0, 1)
    assert ruler.lopsided(_table("n", "s", "w")) == (1, 1)
    assert ruler.lopsided(_table("n", "e")) == (1, 1)
    assert ruler.lopsided(_table("s", corner=(2, 0.1))) == (0, 0)
    assert ruler.lonely(_table("n")) == (1, 1) and ruler.lonely(_table("n", "w")) == (0, 1)


def test_beds_have_no_window_behind_their_head_and_floor_at_both_sides() -> None:
    bed, narrow = body("bed", (1, 0.08), (1.6, 2.0)), body("bed", (1, 0.08), (1.2, 2.0))
    behind, beside = (Opening("w", "window", "north", at, 1.2, 1.2, 0.9) for at in (1.8, 3.3))
    assert ruler.heads_under_windows(scene(bed, openings=(behind,))) == (1, 1)
    assert ruler.heads_under_windows(scene(bed, openings=(beside,))) == (0, 1)
    assert ruler.both_sides_free(scene(bed, body("nightstand", (2.62, 0.08), (0.46, 0.4)))) == (1, 1)
    assert ruler.both_sides_free(scene(bed, body("dresser", (3.0, 1.0), (0.44, 0.8)))) == (0, 1)
    assert ruler.both_sides_free(scene(narrow)) == (0, 0)
    assert ruler.stores_under_windows(scene(body("wardrobe", (1, 0.08), (1.2, 0.6)), openings=(behind,))) == (1, 1)


def test_studios_have_nightstands_a_screen_in_sight_and_floor_before_the_bed() -> None:
    scenes = [generate(Request(seed=seed, program="studio")).scene for seed in range(40)]
    found = [floor for one in scenes for floor in ruler.floors(one, "living_room")]
    beds = [(floor, bed) for floor in found for bed in floor.named("bed")]
    tables = [any(table.meets(*ruler.strip(bed, "front", 0.6)) for table in floor.named("coffee_table")) for floor, bed in beds]
    assert sum(len(floor.named("nightstand")) == 2 for floor, _ in beds) >= 0.5 * len(beds) and sum(tables) <= 0.25 * len(beds)
    assert sum(ruler.screen_before_sofa(one)[0] for one in scenes) >= 36


def test_bedrooms_of_homes_have_a_wardrobe() -> None:
    for seed in range(40):
        for floor in ruler.floors(generate(Request(seed=seed, program="family")).scene, "bedroom", "bedroom_master", "kids_bedroom"):
            assert floor.named("wardrobe"), (seed, floor.room.id)


def test_seats_see_what_is_before_them() -> None:
    sofa, away = body("sofa", (1, 0.08), (2, 0.9)), body("armchair", (4.5, 3.5), (0.8, 0.82))
    ahead, aside = body("tv", (1.4, 4.0), (1.2, 0.14), 180), body("tv", (4.2, 3.0), (1.2, 0.14), 180)
    assert ruler.faces_nothing(scene(sofa, away, ahead)) == (1, 2)
    assert ruler.screen_before_sofa(scene(sofa, ahead)) == (1, 1)
    assert ruler.screen_before_sofa(scene(sofa, aside)) == (0, 1)
    assert ruler.screen_before_sofa(scene(sofa)) == (0, 1)
    table = body("dining_table", (1.6, 2), (0.8, 0.8))
    assert ruler.screen_before_sofa(scene(sofa, ahead, table)) == (0, 1)
    assert ruler.screen_before_sofa(scene(sofa, ahead, replace(table, x=3.2))) == (1, 1)
    assert ruler.screen_before_sofa(scene(sofa, ahead, replace(table, height=0.5))) == (1, 1)
    assert ruler.fireplaces_faced(scene(sofa, body("fireplace", (1.4, 4.5), (1.2, 0.4), 180))) == (1, 1)
    assert ruler.fireplaces_faced(scene(sofa, body("fireplace", (4.6, 0.1), (1.2, 0.4)))) == (0, 1)


def test_an_armchair_has_company_or_a_table_at_hand() -> None:
    chair, sofa = body("armchair", (3, 3), (0.8, 0.82)), body("sofa", (3, 0.8), (2, 0.9))
    assert ruler.stranded(scene(chair)) == (1, 1)
    assert ruler.stranded(scene(chair, sofa)) == (0, 1)
    assert ruler.stranded(scene(chair, replace(sofa, z=1.24))) == (1, 1)
    assert ruler.stranded(scene(chair, body("side_table", (2.1, 3), (0.4, 0.4)))) == (0, 1)
    assert ruler.stranded(scene(chair, body("side_table", (2.0, 3), (0.4, 0.4)))) == (1, 1)


def test_small_living_rooms_have_an_armchair() -> None:
    scenes = [generate(Request(seed=seed)).scene for seed in range(8_712, 8_728)]
    small = [
        bool(one.named("armchair")) for home in scenes for one in ruler.floors(home, "living_room") if one.room.width * one.room.depth < 17
    ]
    assert sum(small) >= 0.6 * len(small) > 5


def test_a_piano_has_a_seat_and_room_to_sit() -> None:
    piano, stool = body("piano", (2, 0.08), (1.5, 0.6)), body("ottoman", (2.4, 0.8), (0.6, 0.5))
    assert ruler.pianos_played(scene(piano)) == (0, 1)
    assert ruler.pianos_played(scene(piano, stool)) == (1, 1)
    assert ruler.pianos_played(scene(piano, stool, body("armchair", (3.1, 1.3), (0.8, 0.8)))) == (0, 1)


def test_dining_tables_beside_dining_rooms_are_counted_in_homes_with_both() -> None:
    living = scene(body("dining_table", (2, 2), (1.6, 0.9)))
    both = replace(living, rooms=(*living.rooms, Room("d", 1, "dining_room", width=3.0, depth=3.0)))
    assert ruler.dining_beside_dining_room(living) == (0, 0)
    assert ruler.dining_beside_dining_room(both) == (1, 1)


@pytest.mark.parametrize(("width", "joined"), [(0.6, 1), (0.7, 1), (0.702, 0), (0.8, 0)])
def test_a_home_is_joined_for_the_last_millimetre_of_a_gap(width: float, joined: int) -> None:
    doors = tuple(Opening(f"d{wall}", "door", wall, 2.5, 0.9, connects_to="EXTERIOR") for wall in ("west", "east"))
    halves = body("sofa", (3, 0.05), (1, 2.0)), body("sofa", (3, 2.75), (1, 2.2))
    assert ruler.joined_at(width)(scene(*halves, openings=doors)) == (joined, 1)
    basket = Decoration("b", "basket", x=3.5, z=2.4, width=0.3, depth=0.3, height=0.3)
    assert ruler.joined_at(width)(scene(*halves, openings=doors, things=(basket,))) == (0, 1)
    assert ruler.joined_at(width, False)(scene(*halves, openings=doors, things=(basket,))) == (joined, 1)


@pytest.mark.parametrize("seed", [5310029, 7731031])
def test_a_home_whose_screen_fits_at_few_walls_has_one(seed: int) -> None:
    home = generate(Request(seed=seed, program="family")).scene
    assert any(piece.name == "tv" for room in home.rooms for piece in room.furniture)
