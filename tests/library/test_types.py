"""What a user's type checker sees: every public name with a type, none of them Any.

The checker's cache is one database, which two workers must not open at once: the tests of one file share a worker.
"""

from __future__ import annotations

import re
from pathlib import Path

from mypy import api

import compose_homes
from tests.architecture.tree import ROOT

USER = """
from pathlib import Path
from compose_homes import (
    Furniture, Request, Room, Scene, PieceRequest, dump, fix, generate, load, load_catalogs, place, reroll, validate,
)

made = generate(Request(seed=42, program={"bedrooms": 1}), catalogs=load_catalogs())
house: Scene = made.scene
other = reroll(house, [room.id for room in house.rooms], seed=7).scene
fixed = fix(other, locked=[piece.id for room in other.rooms for piece in room.furniture if piece.name == "bed"])
text: str = dump(fixed.scene, Path("house.yaml"))
wrong = [issue.message for issue in validate(load(text)) if issue.severity == "error"]
answer = place(Room("den", width=4, depth=3), [PieceRequest("sofa", "sofa")])
stands = {piece.id: (piece.x, piece.z) for room in answer.best.scene.rooms for piece in room.furniture}
"""
WRONG = """
import compose_homes
compose_homes.generate(seed=42)
compose_homes.castle
width: str = compose_homes.generate().scene.rooms[0].width
"""


def checked(folder: Path, program: str) -> str:
    """What mypy says of a user's program in strict mode, our sources being where an installed package's are."""
    (folder / "user.py").write_text(program)
    (folder / "mypy.ini").write_text(f"[mypy]\nstrict = True\nmypy_path = {ROOT}\nfollow_imports = silent\n")
    cache = ROOT / ".mypy_cache" / "user"
    said, trouble, _ = api.run(["--config-file", f"{folder}/mypy.ini", "--cache-dir", str(cache), f"{folder}/user.py"])
    assert trouble == ""
    return said


def test_a_users_program_checks_and_nothing_is_any(tmp_path: Path) -> None:
    names = [*compose_homes.__all__, "house", "other", "fixed.moves", "wrong", "answer.best.relations", "stands"]
    shown = [f"compose_homes.{name}" if name in compose_homes.__all__ else name for name in names]
    said = checked(tmp_path, USER + "import compose_homes\n" + "".join(f"reveal_type({name})\n" for name in shown))
    assert "Success" in said
    types = re.findall(r'Revealed type is "(.*)"', said)
    assert len(types) == len(names)
    assert [kind for kind in types if re.search(r"\bAny\b", kind)] == []


def test_a_users_mistakes_are_seen(tmp_path: Path) -> None:
    said = checked(tmp_path, WRONG)
    assert re.findall(r"user.py:(\d): error", said) == ["3", "4", "5"]
