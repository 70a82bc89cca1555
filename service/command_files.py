"""Files that a command reads: scenes, requests and lists in JSON or YAML, told from floor plans of other programs.

And what a person is told of the scenes in them.
"""

from collections.abc import Callable, Container, Iterable, Iterator
from typing import TYPE_CHECKING, Final, TypeVar

from service.standard_streams import STREAM, read_content, say
from solver.errors import FieldError, SyntaxFault
from solver.exchange import A_SCENE, format_of_file, load_text
from solver.plain import Document

if TYPE_CHECKING:
    from catalogs import Catalogs


T = TypeVar("T")


def read_file(name: str) -> object:
    """Reads a file or standard input, by its name's ending or else by how it begins."""
    return parsed(name, read_content(name))


def parsed(name: str, content: bytes) -> object:
    """Reads the content of a file."""
    return checked(name, lambda: load_text(content, format_of_file(name, content)))


def checked(name: str | None, work: Callable[[], T]) -> T:
    """Does some work on a document; what is wrong with the document is said with its file's name."""
    try:
        return work()
    except FieldError as error:
        raise FieldError(f"{spoken(name)}{error.field}", error.problem, error.allowed) from None
    except SyntaxFault as fault:
        raise SyntaxFault(f"{spoken(name)}{fault}") from None


def spoken(name: str | None) -> str:
    """Returns how what is wrong with a file begins."""
    return "" if name is None else f"{'standard input' if name == STREAM else name}: "


def scene_of_file(name: str) -> object:
    """Reads a scene; of an answer that holds one, that one.

    Raises:
        FieldError: it is a floor plan of another program.
    """
    content = read_content(name)
    try:
        document, fault = parsed(name, content), None
    except SyntaxFault as error:
        document, fault = None, error
    if not isinstance(document, dict) and (format := format_of_foreign(name, content)):
        raise FieldError(f"{spoken(name)}scene", f"is a floor plan of the format {format}", A_SCENE)
    if fault is not None:
        raise fault
    return held_scene(document)


def held_scene(document: object) -> object:
    """Returns the scene of an answer that holds one, else the document itself."""
    return document["scene"] if isinstance(document, dict) and "scene" in document and "rooms" not in document else document


def format_of_foreign(name: str, content: bytes) -> str | None:
    """Returns the format of a file that is a floor plan of another program; None where it is none."""
    from solver.pipeline.import_plan import plan_format  # noqa: PLC0415 - that is much to load for a scene

    return checked(name, lambda: plan_format("" if name == STREAM else name, content))


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
