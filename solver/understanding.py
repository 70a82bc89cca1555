"""Scenes in the words of others: furniture gets the catalogs' names while we work at it, and its own back in the answer.

Names of the catalogs stay; so does what nobody understands.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from catalogs import Catalogs
from catalogs.synonyms import own_names, synonyms_of
from solver.body_rows import furniture_names
from solver.scene import Decoration, Furniture, Room, Scene
from solver.scene_bodies import check_scene


@dataclass(frozen=True)
class Understood:
    """A scene in the catalogs' words; and by id, the kind of every piece that was called otherwise."""

    scene: Scene
    understood_as: Mapping[str, str]
    _sent: Mapping[str, Furniture]

    def in_their_words(self, scene: Scene) -> Scene:
        """Returns a scene with the names and kinds that its pieces were sent with."""
        if not self._sent:
            return scene
        return replace(scene, rooms=tuple(self._named(room) for room in scene.rooms))

    def _named(self, room: Room) -> Room:
        if not any(piece.id in self._sent for piece in room.furniture):
            return room
        pieces = (replace(piece, name=own.name, kind=own.kind) if (own := self._sent.get(piece.id)) else piece for piece in room.furniture)
        return replace(room, furniture=tuple(pieces))


def understood(scene: Scene, catalogs: Catalogs) -> Understood:
    """Returns a scene with its furniture in the catalogs' words; the very scene where it is already."""
    check_scene(scene)
    ours = own_names(catalogs)
    if all(ours.issuperset(furniture_names(room)) for room in scene.rooms):
        return Understood(scene, {}, {})
    words: dict[str, str] = {}
    sent: dict[str, Furniture] = {}
    rooms = tuple(_room(room, catalogs, words, sent) for room in scene.rooms)
    return Understood(replace(scene, rooms=rooms) if sent else scene, words, sent)


def _room(room: Room, catalogs: Catalogs, words: dict[str, str], sent: dict[str, Furniture]) -> Room:
    """Returns a room in the catalogs' words; notes in `words` what was understood as what, in `sent` what was renamed."""
    ours, synonyms = own_names(catalogs), synonyms_of(catalogs)
    pieces: list[Furniture] = []
    for piece in room.furniture:
        size = (piece.width, piece.depth, piece.height)
        meaning = None if piece.name in ours else synonyms.said(piece.kind) or synonyms.meaning(piece.name, size)
        if meaning is not None:
            words[piece.id] = meaning.key
        if meaning is not None and meaning.sort == "furniture":
            sent[piece.id] = piece
            pieces.append(replace(piece, name=meaning.name, kind=meaning.key))
        else:
            pieces.append(piece)
    return replace(room, furniture=tuple(pieces))


def with_understood_kinds(scene: Scene, catalogs: Catalogs) -> Scene:
    """Returns a scene that keeps its names, its furniture and decorations with the kinds that they are understood as, or name."""
    synonyms = synonyms_of(catalogs)

    def kind_of(sort: str, body: Furniture | Decoration) -> str | None:
        meaning = synonyms.meaning(body.name, (body.width, body.depth, body.height)) if body.kind is None else None
        return meaning.key if meaning is not None and meaning.sort == sort else body.kind

    rooms = (
        replace(
            room,
            furniture=tuple(replace(piece, kind=kind_of("furniture", piece)) for piece in room.furniture),
            decorations=tuple(replace(piece, kind=kind_of("decoration", piece)) for piece in room.decorations),
        )
        for room in scene.rooms
    )
    return replace(scene, rooms=tuple(rooms))
