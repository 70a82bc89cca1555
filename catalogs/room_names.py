"""What a plan's name of a room means: the room type that another program or language calls so."""

from __future__ import annotations

import re
from collections.abc import Sequence
from difflib import get_close_matches
from functools import lru_cache
from typing import Final, NamedTuple

from catalogs.schema import Catalogs
from catalogs.synonyms import BEFORE, LEAST_GUESSED, NEARLY, joined, spans_of, words_of

MOST_WORDS: Final = 8
"""Words of a part of a room's name, and parts of it, that are looked at."""
JOINING: Final = (*sorted(BEFORE), "et", "e", "y", "i", "en", "og", "och", "z")
PARTED: Final = re.compile(rf"[/+&,;|()]|\s-\s|\b(?:{'|'.join(JOINING)})\b", re.IGNORECASE)
"""What parts the names of rooms that are two in one."""
LEAST_ENDING: Final = 4
"""Letters of the shortest word that may end another: `studierzimmer` tells nothing, `gartenterrasse` ends in terrace."""


class RoomMeaning(NamedTuple):
    """What a name means: a room type's key, or a key of room_names.yaml that says `other`; and how sure that is.

    `plain` is false where the name only holds such words, or nearly such a word.
    """

    key: str
    plain: bool


class RoomNames:
    """The room types by what plans call them."""

    def __init__(self, catalogs: Catalogs) -> None:
        self._types = frozenset(catalogs.rooms)
        self._by_phrase: dict[str, str] = {}
        for key in catalogs.rooms:
            self._by_phrase.setdefault(joined(words_of(key)), key)
        for key, entry in catalogs.room_names.items():
            for phrase in entry.known_as if entry.means != "nothing" else ():
                self._by_phrase.setdefault(joined(words_of(phrase)), key)
        self._endings = tuple(sorted((word for word in self._by_phrase if _may_end(word)), key=lambda word: (-len(word), word)))
        self._by_phrase.pop("", None)
        vague = (word for entry in catalogs.room_names.values() if entry.means == "nothing" for word in entry.known_as)
        self._vague = frozenset(joined(words_of(word)) for word in vague)

    def meaning(self, name: str) -> RoomMeaning | None:
        """Returns what a name of a room means; None where it tells nothing.

        The whole name counts first, then the first of its parts that tells something (`Living / Dining`): its last words (a
        master bath), else its first (a chambre d'amis).
        """
        whole = self._by_phrase.get(joined(words_of(name)))
        if whole is not None:
            return RoomMeaning(whole, plain=True)
        parts, told = self._told(name)
        found = next((key for words in parts if (key := self._within(words))), None)
        return RoomMeaning(found, plain=self._is_sure(parts, told)) if found else self._nearly(told)

    def is_plain(self, name: str) -> bool:
        """Tells whether a name plainly names a room, without a look at what it nearly says."""
        if joined(words_of(name)) in self._by_phrase:
            return True
        parts, told = self._told(name)
        return self._is_sure(parts, told) and any(self._within(words) for words in parts)

    def _is_sure(self, parts: Sequence[tuple[str, ...]], told: Sequence[str]) -> bool:
        """Tells whether a name has one word that tells something, or is several names of rooms in a row: `Wohnen/Essen/Kochen`."""
        named = [said for words in parts if (said := [word for word in words if word not in self._vague])]
        return len(told) <= 1 or (len(named) > 1 and all(joined(words) in self._by_phrase for words in named))

    def _told(self, name: str) -> tuple[list[tuple[str, ...]], list[str]]:
        """Returns the words of a name's parts, and all of them that tell something."""
        parts = [words_of(part)[:MOST_WORDS] for part in PARTED.split(name)[:MOST_WORDS]]
        return parts, [word for words in parts for word in words if word not in self._vague]

    def _within(self, words: Sequence[str]) -> str | None:
        """Returns what a part of a name means, by its longest last words, else first, else inner ones."""
        return next((key for i, j in spans_of(len(words)) if (key := self._by_phrase.get(joined(words[i:j])))), None)

    def _nearly(self, told: Sequence[str]) -> RoomMeaning | None:
        """Returns the meaning of a word that is written together with another, or misspelled."""
        for word in told:
            ending = next((end for end in self._endings if word.endswith(end)), None)
            near = get_close_matches(word, self._endings, 1, NEARLY) if ending is None and len(word) >= LEAST_GUESSED else []
            if ending or near:
                return RoomMeaning(self._by_phrase[ending or near[0]], plain=False)
        return None


@lru_cache(maxsize=4)
def room_names_of(catalogs: Catalogs) -> RoomNames:
    """Returns the room names that catalogs tell."""
    return RoomNames(catalogs)


def _may_end(phrase: str) -> bool:
    return len(phrase) >= LEAST_ENDING or not phrase.isascii()
