"""What commands say of a scene as it was sent, whatever it holds: kinds that nobody here knows, rooms that stay as they are."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from service.standard_streams import say
from solver.plain import Document

if TYPE_CHECKING:
    from catalogs import Catalogs

MOST_TOLD: Final = 6
"""So many names are told of more."""


def told_kinds(scene: object, catalogs: "Catalogs") -> None:
    """Says which kinds are in none of the catalogs that a scene is read with: they are taken by their names and sizes."""
    unknown = [
        kind
        for room in _objects(scene, "rooms")
        for key, known in (("furniture", catalogs.furniture), ("decorations", catalogs.decorations))
        for body in _objects(room, key)
        if isinstance(kind := body.get("kind"), str) and kind.removesuffix("_upright") not in known
    ]
    found = list(dict.fromkeys(unknown))
    if found:
        more = ", ..." if len(found) > MOST_TOLD else ""
        say(f"no catalog here knows {', '.join(found[:MOST_TOLD])}{more}: --catalog names a folder of your own")


def told_as_sent(sent: object, scene: Document) -> None:
    """Says which rooms of a plan were not furnished because they were not empty."""
    given = zip(_objects(sent, "rooms"), scene["rooms"], strict=False)
    kept = [str(room["id"]) for one, room in given if one.get("furniture")]
    if kept:
        say(f"as they were, since something stands in them: {', '.join(kept)}; --room {kept[0]} furnishes around it")


def _objects(holder: object, key: str) -> Iterator[Document]:
    """Yields the objects in a list of a document, if there is one."""
    listed = holder.get(key) if isinstance(holder, dict) else None
    yield from (one for one in (listed if isinstance(listed, list) else ()) if isinstance(one, dict))
