"""Maps and the picture from above, read with Pillow."""

from __future__ import annotations

import io
import json
from functools import cache
from typing import Any

import numpy as np
import pytest
from PIL import Image

from solver.exports import ExportSettings, written_as
from tests.exports import homes


@cache
def written(name: str) -> dict[str, bytes]:
    return written_as(homes.described(name), ExportSettings("png"))


def pixels(content: bytes) -> Any:
    return np.asarray(Image.open(io.BytesIO(content)))


class Map:
    """A map whose pixels are asked for by their place in the house, m."""

    def __init__(self, files: dict[str, bytes], name: str) -> None:
        self.said = json.loads(files["palette.json"])
        place = self.said["maps"][0]
        self.values, self.pixel, self.corner = pixels(files[f"{name}.png"]), place["pixel"], place["north_west"]
        assert self.values.shape == (place["size"][1], place["size"][0])
        self.entries = {entry["number"]: entry for entry in self.said[name]}

    def at(self, x: float, z: float) -> Any:
        row, column = (int((value - corner) / self.pixel) for value, corner in ((z, self.corner[1]), (x, self.corner[0])))
        return self.entries.get(int(self.values[row, column]), {})


def test_maps_say_what_is_where() -> None:
    files = written("own")
    semantic, instance, rooms, free = (Map(files, name) for name in ("semantic", "instance", "rooms", "free_floor"))
    assert free.said["taken"] == {"from": 0.03, "to": 2.0}
    cases = {
        (1.0, 3.4): ("misc", "living/f_stem", "living", "taken"),
        (1.45, 2.95): ("misc", "living/f_arm", "living", "taken"),
        (1.7, 3.4): ("bare_floor", None, "living", "free"),
        (4.6, 1.4): ("decor", "living/vase_1", "living", "taken"),
        (4.0, 1.4): ("table", "living/dining_table_1", "living", "taken"),
        (4.0, 5.9): ("floor", "bed/rug_1", "bed", "free"),
        (0.0, 0.5): ("wall", None, None, "taken"),
        (0.0, 1.5): ("door", None, None, None),
        (1.2, 5.0): ("bare_floor", None, None, "free"),
        (1.6, 0.0): ("window", None, None, "taken"),
        (3.0, -2.0): ("outdoor_floor", None, "garden", "free"),
        (8.0, 5.0): ("outside", None, None, "outside"),
        (2.6, 5.6): ("dynamic", "cat_1", "study", "free"),
    }
    for (x, z), (kind, body, room, state) in cases.items():
        found = semantic.at(x, z).get("name"), instance.at(x, z).get("id")
        assert found == (kind, body), (x, z)
        assert room is None or rooms.at(x, z).get("id") == room, (x, z)
        assert state is None or free.at(x, z).get("name") == state, (x, z)


def test_areas_are_those_of_the_rooms() -> None:
    rooms = Map(written("family"), "rooms")
    numbers = {room.id: number for number, room in enumerate(homes.described("family").rooms, 1)}
    for room in homes.described("family").rooms:
        area = (rooms.values == numbers[room.id]).sum() * rooms.pixel**2
        assert area == pytest.approx(room.area, rel=0.01)


def test_every_body_that_is_seen_has_its_number() -> None:
    model = homes.described("family")
    instance = Map(written("family"), "instance")
    seen = set(np.unique(instance.values).tolist()) - {0}
    large = {number for number, body in enumerate(model.bodies, 1) if body.sort == "furniture" and body.parent is None}
    assert seen <= set(range(1, len(model.bodies) + 1))
    assert len(large - seen) == 0


def test_classes_have_the_same_numbers_in_every_house() -> None:
    one, other = (
        {entry["name"]: entry["number"] for entry in json.loads(written(n)["palette.json"])["semantic"]} for n in ("own", "family")
    )
    assert one == other
    assert len(one) < 256


def test_the_picture_shows_the_letter_as_it_lies() -> None:
    """Its red is where the F is, and nowhere that a mirror image of it would be."""
    picture = pixels(written("own")["picture.png"]).astype(int)
    assert max(picture.shape[:2]) == 1600 and picture.shape[2] == 3
    red = (picture[:, :, 0] > 120) & (picture[:, :, 1] < 70) & (picture[:, :, 2] < 60)
    scale = 1600 / 16.0  # 14 m of house and a metre on both sides
    rows, columns = np.nonzero(red[int(scale * 6.6) : int(scale * 8.1), int(scale * 1.7) : int(scale * 3.0)])
    height, width = np.ptp(rows) / scale, np.ptp(columns) / scale
    assert (height, width) == pytest.approx((1.2, 0.9), abs=0.03)
    letter = red[int(scale * 6.6) :, int(scale * 1.7) :][rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
    h, w = letter.shape
    share = [[bool(letter[int(h * (r + 0.5) / 6), int(w * (c + 0.5) / 6)]) for c in range(6)] for r in range(6)]
    assert share[0] == [True] * 6  # the arm is in the north
    assert [row[0] for row in share] == [True] * 6  # the stem in the west
    assert share[5] == [True, True, False, False, False, False]


def test_every_storey_has_its_pictures() -> None:
    files = written("storeys")
    names = {"picture", "semantic", "instance", "rooms", "free_floor"}
    assert set(files) == {f"{name}{end}" for name in names for end in (".png", "_level_1.png")} | {"palette.json"}


def test_hostile_names_change_no_pixel() -> None:
    hostile, plain = written("hostile"), written("own")
    assert all(hostile[name] == plain[name] for name in ("instance.png", "rooms.png", "free_floor.png"))
    ids = {entry["id"] for entry in json.loads(hostile["palette.json"])["instance"]}
    assert ids == {body.id for body in homes.described("hostile").bodies}
