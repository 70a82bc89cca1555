"""The floor as told: against the rules' words and by hand, in metres."""

from __future__ import annotations

from typing import Any

import pytest
from starlette.testclient import TestClient

HALF_WALL = 0.06
DOOR = {"id": "door", "kind": "door", "wall": "north", "position": 2.0, "width": 0.8, "height": 2.0, "connects_to": "EXTERIOR"}
WINDOW = {"id": "window", "kind": "window", "wall": "east", "position": 1.5, "width": 1.2, "height": 1.2, "sill": 0.9}
NEAR = 1e-6


def piece(name: str, x: float, z: float, width: float, depth: float) -> dict[str, Any]:
    return {"id": name, "name": name, "x": x, "z": z, "width": width, "depth": depth, "height": 1.0}


def told(client: TestClient, *furniture: dict[str, Any], **more: Any) -> dict[str, Any]:
    room = {"id": "room", "width": 5.0, "depth": 4.0, "openings": [DOOR, WINDOW], "furniture": list(furniture), **more}
    answer = client.post("/floor", json={"scene": {"wall_thickness": 2 * HALF_WALL, "rooms": [room]}})
    assert answer.status_code == 200, answer.text
    (floor,) = answer.json()["rooms"]
    return dict(floor)


def covers(boxes: list[list[float]], x: float, z: float) -> bool:
    return any(x0 < x < x1 and z0 < z < z1 for x0, z0, x1, z1 in boxes)


def meet(a: list[float], b: list[float]) -> bool:
    return min(a[2], b[2]) - max(a[0], b[0]) > NEAR and min(a[3], b[3]) - max(a[1], b[1]) > NEAR


def test_door_squares_and_window_strips_are_those_of_the_rules(client: TestClient) -> None:
    floor = told(client)
    assert floor["doors"] == [pytest.approx([1.6, 0.0, 2.4, 0.8])]
    assert floor["windows"] == [pytest.approx([4.5, 0.8, 5.0, 2.2])]
    wide = told(
        client, openings=[{**DOOR, "kind": "passage", "width": 1.6}, {**DOOR, "id": "gate", "kind": "garage_door", "wall": "south"}]
    )
    assert wide["doors"] == [pytest.approx([1.2, 0.0, 2.8, 0.9])]


def test_an_empty_room_is_free_but_for_its_walls(client: TestClient) -> None:
    floor = told(client)
    assert floor["clear"] == pytest.approx([HALF_WALL, HALF_WALL, 5 - HALF_WALL, 4 - HALF_WALL])
    assert covers(floor["free"], 2.503, 2.003)
    area = sum((x1 - x0) * (z1 - z0) for x0, z0, x1, z1 in floor["free"])
    assert area == pytest.approx((5 - 2 * HALF_WALL) * (4 - 2 * HALF_WALL), abs=1e-4)


def test_free_floor_lies_in_the_clear_floor_beside_all_bodies(client: TestClient) -> None:
    table, sofa = piece("table", 2.5, 2.4, 1.4, 0.8), piece("sofa", 1.2, 3.4, 2.0, 0.9)
    floor = told(client, table, sofa)
    x0, z0, x1, z1 = floor["clear"]
    assert len(floor["free"]) > 1
    for index, free in enumerate(floor["free"]):
        assert free[0] >= x0 - NEAR and free[1] >= z0 - NEAR and free[2] <= x1 + NEAR and free[3] <= z1 + NEAR
        for body in (table, sofa):
            half, deep = body["width"] / 2, body["depth"] / 2
            assert not meet(free, [body["x"] - half, body["z"] - deep, body["x"] + half, body["z"] + deep])
        assert not any(meet(free, other) for other in floor["free"][:index])


def test_a_pocket_nobody_comes_to_is_not_free(client: TestClient) -> None:
    floor = told(client, piece("shelf", 2.5, 2.0, 4.88, 0.3))
    assert covers(floor["free"], 2.513, 1.013)
    assert not covers(floor["free"], 2.513, 3.013)
    open_floor = told(client, piece("shelf", 2.2, 2.0, 4.28, 0.3))
    assert covers(open_floor["free"], 2.513, 3.013)


def test_a_gap_narrower_than_the_robot_is_not_free(client: TestClient) -> None:
    def between(gap: float) -> bool:
        bodies = (piece("a", 0.06 + 1.0, 2.0, 2.0, 1.0), piece("b", 0.06 + 2.0 + gap + 1.0, 2.0, 2.0, 1.0))
        return covers(told(client, *bodies, openings=[DOOR])["free"], 2.06 + gap / 2 + 0.003, 2.003)

    assert (between(0.59), between(0.60)) == (False, True)


def test_rooms_are_chosen_by_id(client: TestClient) -> None:
    rooms = [{"id": name, "width": 3.0, "depth": 3.0} for name in ("hall", "bath")]
    chosen = client.post("/floor", json={"scene": {"rooms": rooms}, "rooms": ["bath"]}).json()["rooms"]
    refused = client.post("/floor", json={"scene": {"rooms": rooms}, "rooms": ["bath", "attic"]})
    unsaid = client.post("/floor", json={"scene": {"rooms": rooms}}).json()["rooms"]
    assert [room["room"] for room in chosen] == ["bath"]
    assert [room["room"] for room in unsaid] == ["hall", "bath"]
    assert refused.status_code == 422
    assert refused.json()["errors"][0]["field"] == "rooms[1]"
