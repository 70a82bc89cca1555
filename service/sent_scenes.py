"""What commands say of a scene as it was sent, whatever it holds: kinds that nobody here knows, rooms that stay as they are."""

from collections.abc import Container, Iterable, Iterator
from typing import TYPE_CHECKING, Final

from service.standard_streams import say
from solver.plain import Document

if TYPE_CHECKING:
    from catalogs import Catalogs

MOST_TOLD: Final = 6
"""So many names are told of more."""


def told_kinds(scene: object, catalogs: "Catalogs") -> None:
    """Says which kinds are in none of the catalogs that a scene is read with: they are taken by their names and sizes."""
    known: dict[str, Container[str]] = {"furniture": catalogs.furniture, "decorations": catalogs.decorations}
    kinds = [(one, known[key]) for key, body in _bodies(scene) if isinstance(one := body.get("kind"), str)]
    if unknown := [kind for kind, there in kinds if kind.removesuffix("_upright") not in there]:
        say(f"no catalog here knows {listed(unknown)}: --catalog names a folder of your own")


def told_assets(scene: object, catalogs: "Catalogs") -> None:
    """Says which assets of a scene are not there to be shown: those bodies have the shapes of their kinds."""
    if unknown := [one for _, body in _bodies(scene) if isinstance(one := body.get("asset"), str) and one not in catalogs.assets]:
        say(f"no asset here is called {listed(unknown)}: --assets names a folder of your own")


def listed(names: Iterable[str]) -> str:
    """Returns the first of some names, each once, in words."""
    found = list(dict.fromkeys(names))
    return ", ".join(found[:MOST_TOLD]) + (", ..." if len(found) > MOST_TOLD else "")


def told_as_sent(sent: object, scene: Document) -> None:
    """Says which rooms of a plan were not furnished because they were not empty."""
    given = zip(_objects(sent, "rooms"), scene["rooms"], strict=False)
    kept = [str(room["id"]) for one, room in given if one.get("furniture")]
    if kept:
        say(f"as they were, since something stands in them: {', '.join(kept)}; --room {kept[0]} furnishes around it")


def _bodies(scene: object) -> Iterator[tuple[str, Document]]:
    """Yields furniture and decorations of all rooms, each with the key that it is under."""
    for room in _objects(scene, "rooms"):
        for key in ("furniture", "decorations"):
            yield from ((key, body) for body in _objects(room, key))


def _objects(holder: object, key: str) -> Iterator[Document]:
    """Yields the objects in a list of a document, if there is one."""
    listed = holder.get(key) if isinstance(holder, dict) else None
    yield from (one for one in (listed if isinstance(listed, list) else ()) if isinstance(one, dict))
