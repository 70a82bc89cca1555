"""Scenes in files and texts: JSON, YAML or a .glb that was exported, by the file's name, else by how it begins."""

from collections.abc import Mapping
from os import PathLike
from pathlib import Path, PurePath

from solver.errors import RequestError
from solver.export_formats import EXPORTERS
from solver.scene import Scene


def load(source: str | bytes | PathLike[str] | Mapping[str, object], format: str | None = None) -> Scene:
    """Reads a scene from a file, a text or a document that was read already; of an answer that holds one (of `POST /generate`, say) that.

    Args:
        source: a path; or the text itself, as bytes, or as a `str` that has more than one line or begins with a brace;
            or a mapping, such as `json.load` or a client's `response.json()` gives.
        format: "json", "yaml" or "glb"; by default by the file's name, else by how the content begins.

    Raises:
        OSError: the file cannot be read.
        RequestError: the source is of another type.
        SyntaxFault: the content is not of that format; or it is a .glb that Compose did not write.
        SceneError: the document is no scene; names the field and what is allowed.

    Example:
        >>> from compose_homes import load
        >>> scene = load('{"rooms": [{"type": "office", "width": 4, "depth": 3}]}')
        >>> scene.rooms[0].id, scene.rooms[0].width
        ('office_0', 4.0)
    """
    from solver.exchange import read_scene
    from solver.scene_bodies import check_is

    check_is("source", source, (str, bytes, PathLike, Mapping), "a path, a text or a mapping", RequestError)
    document = dict(source) if isinstance(source, Mapping) else _document(source, format)
    if isinstance(document, dict) and "scene" in document and "rooms" not in document:
        document = document["scene"]
    return read_scene(document)


def _document(source: str | bytes | PathLike[str], format: str | None) -> object:
    """Reads a file or a text."""
    from solver.exchange import format_of_file, load_text

    if isinstance(source, str) and ("\n" in source or source.lstrip().startswith("{")):
        source = source.encode()
    content = source if isinstance(source, bytes) else Path(source).read_bytes()
    name = "" if isinstance(source, bytes) else str(source)
    return load_text(content, format or format_of_file(name, content))


def dump(scene: Scene, path: str | PathLike[str] | None = None, format: str | None = None) -> str:
    """Writes a scene, losslessly; equal scenes give equal texts.

    Args:
        scene: what to write.
        path: the file to write; None: the text is only returned.
        format: "json" or "yaml"; by default by the file's name, else YAML.

    Returns:
        The text.

    Raises:
        OSError: the file cannot be written.
        RequestError: the format, or the file's ending, is one that `export` writes, such as glb.
        SceneError: the scene holds what no document can say, such as a number that is not finite.

    Example:
        >>> from compose_homes import Room, Scene, dump, load
        >>> scene = Scene(rooms=(Room("den", width=4, depth=3),))
        >>> load(dump(scene)) == load(dump(scene, format="json")) == scene
        True
    """
    from solver.exchange import dump_scene, format_of_name
    from solver.scene_bodies import check_scene
    from solver.whole_files import write_whole

    check_scene(scene)
    name = str(path or "")
    asked = format or PurePath(name).suffix.lower().removeprefix(".")
    if asked in EXPORTERS:
        raise RequestError("format", f"dump writes no {asked}; export(scene, {asked!r}) does", "json or yaml")
    content = dump_scene(scene, format or format_of_name(name) or "yaml")
    if path is not None:
        write_whole(Path(path), content)
    return content.decode()
