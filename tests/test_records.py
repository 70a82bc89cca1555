"""Records like other ones: the fields that are told are new, what is made later stays so."""

from __future__ import annotations

from dataclasses import replace

from solver.records import MadeOnce, changed, kept, made_later, maker_in
from solver.scene import Flooring, Furniture, Room


def bed(name: str) -> Furniture:
    return Furniture(name, "bed", width=1.6, depth=2.0, height=0.5)


def test_a_changed_record_is_what_replace_makes_and_leaves_the_other_one() -> None:
    room = Room("den", 3, "den", width=4.0, depth=3.0, furniture=(bed("den/bed_1"),), extra={"more": 1})
    floor = Flooring("wood", "#aaaaaa")
    new = changed(room, flooring=floor, accent="#bbbbbb")
    assert new == replace(room, flooring=floor, accent="#bbbbbb") != room
    assert room.flooring is None
    assert changed(room) == room


def test_what_is_made_later_is_made_by_neither_of_two_like_records() -> None:
    asked: list[str] = []

    def beds(name: str) -> tuple[Furniture, ...]:
        asked.append(name)
        return (bed(name),)

    room = made_later(Room("den", width=4.0, depth=3.0), furniture=lambda: beds("one"), decorations=lambda: ())
    moved, told = changed(room, x=2.0), changed(room, furniture=(bed("told"),))
    assert asked == []
    assert maker_in(moved, "furniture") is maker_in(room, "furniture")
    assert maker_in(told, "furniture") is None
    assert maker_in(told, "decorations") is maker_in(room, "decorations")
    assert told.furniture == (bed("told"),)
    assert asked == []
    assert moved.furniture == (bed("one"),)
    assert asked == ["one"]
    assert maker_in(made_later(told, furniture=lambda: beds("again")), "furniture")() == (bed("again"),)


def test_what_is_made_once_is_made_anew_when_there_are_many() -> None:
    made = list[int]()

    def squared(key: int) -> int:
        made.append(key)
        return key * key

    kept = MadeOnce(squared, 2)
    assert [kept[3], kept[3], kept[2], kept[3]] == [9, 9, 4, 9] and made == [3, 2]
    assert [kept[4], dict(kept)] == [16, {4: 16}]
    assert kept[3] == 9 and made == [3, 2, 4, 3]


def test_what_is_kept_is_worked_out_once_by_each_record() -> None:
    class Square:
        def __init__(self, side: int) -> None:
            self.side, self.asked = side, 0

        @kept
        def area(self) -> int:
            """The area."""
            self.asked += 1
            return self.side**2

    small, large = Square(2), Square(3)
    assert (small.area, large.area, small.area, large.area) == (4, 9, 4, 9)
    assert (small.asked, large.asked) == (1, 1)
