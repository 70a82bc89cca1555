"""Who is in a home is said by people.yaml: entries of one's own are followed."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from catalogs import Catalogs, load_catalogs
from solver.furnish import space_of
from solver.people import Household, peopled
from solver.scene import Dynamic
from tests.people.homes import house


def drawn(known: Catalogs, seed: int) -> tuple[Dynamic, ...]:
    """Who is in a house for a seed, by some catalogs."""
    scene = house(0)
    return peopled(scene.rooms, Household(seed, known, lambda room: space_of(room, scene.wall_thickness, 0.6, scene.rooms)))


def with_people(folder: Path, text: str) -> Catalogs:
    (folder / "people.yaml").write_text(text)
    return load_catalogs(folder)


def test_a_party_of_ones_own(tmp_path: Path) -> None:
    seats = "{categories: [seating], heights: [0.3, 0.7], size: [0.4, 0.45, 0.8]}"
    entry = f"people: {{kinds: person, per: room, chance: 1, most: 2, rooms: [hallway, living_room], poses: [sits], seats: {seats}}}\n"
    known = with_people(tmp_path, entry + "pet: {kinds: cat, per: home, chance: 1, rooms: bathroom, otherwise: office, poses: [roams]}\n")
    types = {room.id: room.type for room in house(0).rooms}
    found = Counter[tuple[str, str, bool]]()
    for seed in range(30):
        here = drawn(known, seed)
        found.update((one.kind, types[one.room or ""], one.on is not None) for one in here)
        assert sum(one.kind == "person" for one in here) <= 2
        assert all((one.width, one.height) == (0.4, 0.8) and one.depth <= 0.45 for one in here if one.on)
    assert {place for kind, place, _ in found if kind == "person"} <= {"hallway", "living_room"}
    assert {sits for kind, _, sits in found if kind == "person"} == {True}
    assert {place for kind, place, _ in found if kind == "cat"} == {"bathroom"}
    assert sum(count for (kind, _, _), count in found.items() if kind == "cat") > 25


def test_a_seed_draws_each_entry_by_itself(tmp_path: Path) -> None:
    text = (Path(__file__).parents[2] / "catalogs" / "people.yaml").read_text()
    more = with_people(tmp_path, text + "guest: {kinds: child, per: home, chance: 1, rooms: [hallway], poses: [roams]}\n")
    for seed in range(10):
        before = drawn(load_catalogs(), seed)
        assert [one for one in drawn(more, seed) if one.kind != "child"] == list(before)
