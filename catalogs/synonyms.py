"""What a foreign name means: the kind, or the room type, of the catalogs that another program, data set or language calls so."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from functools import lru_cache
from math import log
from typing import Final, Literal, NamedTuple, TypeAlias, get_args
from unicodedata import category, normalize

from catalogs.entries import DrawnName
from catalogs.schema import Catalogs

KindSize: TypeAlias = tuple[float, float, float]
"""Width, depth and height, m."""
NAMED_SO: Final = 3.0
"""A body that is plainly called like a kind may differ from it by so many times in each of its lengths."""
PERHAPS: Final = 2.0
"""The same of one whose name only holds such a word, or is nearly one."""
SAME: Final = 0.08
"""Lengths that differ by less, m, are alike: the thickness of a picture says nothing."""
NEARLY: Final = 0.88
"""How alike two words must be to be one, misspelled."""
LEAST_GUESSED: Final = 5
"""Letters of the shortest word that may be misspelled."""
LEAST_PART: Final = 3
"""Letters of the shortest word within words that are written together."""
BEFORE: Final = frozenset(("with", "for", "without", "and", "mit", "fur", "avec", "pour", "con", "para", "per", "met", "voor", "med"))
"""Words behind which a name says no longer what the body is: a washbasin with cabinet is a washbasin."""
_LETTERS: Final = str.maketrans({"ß": "ss", "ł": "l", "Ł": "L", "ø": "o", "Ø": "O", "æ": "ae", "Æ": "Ae", "đ": "d", "ı": "i"})
"""Letters that are no other letter with an accent, and how they are written without."""
_PLURALS: Final = (("ies", "y"), ("lves", "lf"), ("ches", "ch"), ("shes", "sh"), ("xes", "x"), ("sses", "ss"))
_MANY: Final = 4_096


class Meaning(NamedTuple):
    """What a name means: "furniture", "decoration", or "other" where that is no kind of the catalogs; its key; its scene name."""

    sort: Literal["furniture", "decoration", "other"]
    key: str
    name: str


class _Wanted(NamedTuple):
    """A meaning that a word may have, and the size of such things; None where nothing is known of it."""

    meaning: Meaning
    size: KindSize | None


def words_of(name: str) -> tuple[str, ...]:
    """Returns the words of a name, whatever its way of writing: small letters without accents, in the singular; no numbers.

    Example:
        >>> words_of("TVStands_03")
        ('tv', 'stand')
    """
    letters = "".join(letter for letter in normalize("NFKD", name.translate(_LETTERS)) if category(letter)[0] != "M")
    apart = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", letters)
    return tuple(_singular(word) for word in re.findall(r"[^\W\d_]+", apart.casefold()) if len(word) > 1 or not word.isascii())


def _singular(word: str) -> str:
    for ending, single in _PLURALS:
        if word.endswith(ending):
            return word.removesuffix(ending) + single
    return word[:-1] if len(word) >= LEAST_PART and word.endswith("s") and not word.endswith(("ss", "us", "is")) else word


def joined(words: Iterable[str]) -> str:
    """Returns words as one: however they are written together, they are looked up by this."""
    return "".join(words)


def spans_of(count: int) -> list[tuple[int, int]]:
    """Returns the runs among so many words in the order in which they count: all, the longest last ones, first ones, inner ones."""
    outer = [*((k, count) for k in range(count)), *((0, k) for k in range(count - 1, 0, -1))]
    return outer + [(i, j) for i in range(1, count) for j in range(count - 1, i, -1)]


class Synonyms:
    """The names of others, found by their words."""

    def __init__(self, catalogs: Catalogs) -> None:
        self._catalogs = catalogs
        self._named: dict[str, list[str]] = {}
        for kind in catalogs.furniture:
            self._named.setdefault(catalogs.name_of(kind), []).append(kind)
        self._by_phrase: dict[str, dict[Meaning, KindSize | None]] = {}
        for key in (*catalogs.furniture, *catalogs.decorations):
            self._add(key, self._wanted(key))
        for key, entry in catalogs.synonyms.items():
            for phrase in entry.known_as if entry.means != "nothing" else ():
                self._add(phrase, self._wanted(key))
        vague = (word for entry in catalogs.synonyms.values() if entry.means == "nothing" for word in entry.known_as)
        self._vague = frozenset(joined(words_of(word)) for word in vague) - {""}
        self._parts = frozenset(self._by_phrase) | self._vague
        self._by_length = _by_length(self._by_phrase)
        self.meaning = lru_cache(maxsize=_MANY)(self._meaning)
        """What a foreign name with a size, or a height alone (m; None: not told), means; None where nobody can tell."""

    def _add(self, phrase: str, wanted: Iterable[_Wanted]) -> None:
        known = self._by_phrase.setdefault(joined(words_of(phrase)), {})
        for one in wanted:
            known.setdefault(*one)

    def _wanted(self, key: str) -> Iterator[_Wanted]:
        """Yields what an entry means: a kind of furniture with its size variants, a decoration, or no kind."""
        furniture, decorations = self._catalogs.furniture, self._catalogs.decorations
        if key in furniture:
            name = self._catalogs.name_of(key)
            variants = [key, *(other for other in self._named[name] if name == key != other)]
            yield from (_Wanted(Meaning("furniture", other, name), furniture[other].size) for other in variants)
        elif key in decorations:
            yield _Wanted(Meaning("decoration", key, key), decorations[key].size)
        else:
            yield _Wanted(Meaning("other", key, key), None)

    def said(self, key: str | None) -> Meaning | None:
        """Returns the meaning that a body of a foreign name tells itself, by the key of its kind; None where it is no kind's."""
        return next((one.meaning for one in self._wanted(key) if one.size), None) if key else None

    def _meaning(self, name: str, size: KindSize | float | None = None) -> Meaning | None:
        words = words_of(name)
        cut = next((k for k, word in enumerate(words) if word in BEFORE and k), len(words))
        whole = self._nearest(joined(words), size, NAMED_SO)
        return whole or self._within(words[:cut], size) or self._misspelled(joined(words), size)

    def _within(self, words: Sequence[str], size: KindSize | float | None) -> Meaning | None:
        """Returns what a part of a name means: its longest, last words (a round end table), else its first (lit d'enfant)."""
        words = tuple(part for word in words for part in self._apart(word))
        for start, end in spans_of(len(words)):
            phrase = joined(words[start:end])
            if phrase in self._by_phrase and phrase not in self._vague:
                rest = (*words[:start], *words[end:])
                plain = all(word in self._vague for word in rest)
                return self._nearest(phrase, size, NAMED_SO if plain else PERHAPS) if plain or size else None
        return None

    def _apart(self, word: str) -> tuple[str, ...]:
        """Returns the words that are written together in one, if it is made of known ones: `roundendtable`."""
        if word in self._parts:
            return (word,)
        ways: dict[int, tuple[str, ...]] = {0: ()}
        for end in range(LEAST_PART, len(word) + 1):
            for start in sorted(ways):
                if end - start >= LEAST_PART and word[start:end] in self._parts:
                    ways.setdefault(end, (*ways[start], word[start:end]))
        return ways.get(len(word), (word,))

    def _misspelled(self, phrase: str, size: KindSize | float | None) -> Meaning | None:
        if len(phrase) < LEAST_GUESSED or not isinstance(size, tuple):
            return None
        return next((found for near in _close_to(phrase, self._by_length) if (found := self._nearest(near, size, PERHAPS))), None)

    def _nearest(self, phrase: str, size: KindSize | float | None, most: float) -> Meaning | None:
        """Returns the meaning of a phrase that is nearest in size; None where all are too far, or it has none."""
        known = self._by_phrase.get(phrase, {})
        if size is None:
            return next(iter(known), None)
        sizes = ((size if isinstance(size, tuple) else (*other[:2], size), other, meaning) for meaning, other in known.items() if other)
        measured = [(_difference(one, other, most), meaning) for one, other, meaning in sizes]
        agreeing = [one for one in measured if one[0] is not None]
        if agreeing:
            return min(agreeing, key=lambda one: one[0] or 0.0)[1]
        return next((meaning for meaning, other in known.items() if other is None), None)


def _by_length(phrases: Iterable[str]) -> dict[int, list[str]]:
    found: dict[int, list[str]] = {}
    for phrase in sorted(phrases):
        found.setdefault(len(phrase), []).append(phrase)
    return found


def _close_to(word: str, phrases: Mapping[int, Sequence[str]]) -> list[str]:
    """Returns the phrase that a word is a misspelling of, if there is one; only what is about as long can be."""
    count = len(word)
    near = [one for length, some in phrases.items() if 2 * min(length, count) >= NEARLY * (length + count) for one in some]
    return get_close_matches(word, near, 1, NEARLY)


@lru_cache(maxsize=4)
def own_names(catalogs: Catalogs) -> frozenset[str]:
    """Returns what scenes call furniture of the catalogs: where all is called so, no synonyms are needed."""
    return frozenset(catalogs.kinds_by_name())


@lru_cache(maxsize=4)
def synonyms_of(catalogs: Catalogs) -> Synonyms:
    """Returns the names of others that catalogs tell."""
    return Synonyms(catalogs)


def _difference(one: KindSize, other: KindSize, most: float) -> float | None:
    """Returns how many times two sizes differ, as a sum of logarithms; None where a length does by more than `most`.

    A footprint may be turned: others call a bed's length its width.
    """
    found = 0.0
    for a, b in zip((*sorted(one[:2]), one[2]), (*sorted(other[:2]), other[2]), strict=True):
        more = abs(log(a / b))
        if more > log(most) and abs(a - b) > SAME:
            return None
        found += more
    return found


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
        endings = [word for word in self._by_phrase if len(word) >= LEAST_ENDING or not word.isascii()]
        self._endings = tuple(sorted(endings, key=lambda word: (-len(word), word)))
        self._endings_by_length = _by_length(self._endings)
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
            near = _close_to(word, self._endings_by_length) if ending is None and len(word) >= LEAST_GUESSED else []
            if ending or near:
                return RoomMeaning(self._by_phrase[ending or near[0]], plain=False)
        return None


@lru_cache(maxsize=4)
def room_names_of(catalogs: Catalogs) -> RoomNames:
    """Returns the room names that catalogs tell."""
    return RoomNames(catalogs)


BETWEEN_WORDS: Final = re.compile(r"[\W_]+")
"""What parts the words of a layer's name."""
STOREYS: Final[Mapping[DrawnName, int | None]] = {
    "basement": -1, "ground": 0, "first": 1, "second": 2, "attic": 10, "storey": None, "storey_layer": None,
}  # fmt: skip
"""Which storey each of them is; None: the one with the number that stands in the place of `#`, a digit."""


class DrawnNames:
    """What layers, blocks and groups of drawings are called, and titles; and the names of rooms, which texts in drawings are."""

    def __init__(self, catalogs: Catalogs) -> None:
        self.rooms, self._things = room_names_of(catalogs), synonyms_of(catalogs)
        entries = {key: catalogs.drawn_names[key] for key in get_args(DrawnName) if key in catalogs.drawn_names}
        told = {means: [word for one in entries.values() if one.means == means for word in one.known_as] for means in ("other", "nothing")}
        self._passed, self._without = told["other"], told["nothing"]
        self._sorts = {key: one.known_as for key, one in entries.items() if one.means == "kind" and key not in STOREYS}
        storeys = [(word, key) for key in STOREYS if key in entries for word in entries[key].known_as]
        by_length = sorted(storeys, key=lambda one: -len(one[0]))
        self._storeys = [(re.compile(re.escape(word).replace(r"\#", r"0*(\d)")), key) for word, key in by_length]
        self.storey_of_layer = lru_cache(maxsize=_MANY)(self._storey)
        """Which storey the name of a layer tells; None where it tells none."""
        self.sort_within = lru_cache(maxsize=_MANY)(self._sort_within)
        """What the names around a shape tell, the outermost first: the nearest that tells anything counts."""

    def is_thing(self, name: str) -> bool:
        """Tells whether a name may be that of a piece, too, as `Bed` and `Bath` are."""
        return self._things.meaning(name) is not None

    def is_passed(self, names: Sequence[str]) -> bool:
        """Tells whether a name is one of what is passed over."""
        return any(word in _spaced(name) for name in names for word in self._passed)

    def _sort_within(self, names: tuple[str, ...]) -> str | None:
        for name in reversed(names):
            small = _spaced(name)
            for word in self._without:
                small = small.replace(word, "")
            if self.is_passed((name,)):
                return None
            found = [sort for sort, words in self._sorts.items() if any(word in small for word in words)]
            if found:
                return "label" if "label" in found else "opening" if {"window", "door"} <= {*found} else found[0]
        return None

    def storey(self, title: str) -> int | None:
        """Returns which storey a title tells by the longest word in it, 0 the ground's; None where it tells none."""
        return self._storey(title, passed="storey_layer")

    def _storey(self, title: str, passed: DrawnName | None = None) -> int | None:
        small = _spaced(title)
        told = ((found, STOREYS[key]) for word, key in self._storeys if key != passed and (found := word.search(small)))
        return next((int(found[1]) if storey is None else storey for found, storey in told), None)


def _spaced(name: str) -> str:
    return f" {BETWEEN_WORDS.sub(' ', name.lower())} "


@lru_cache(maxsize=4)
def drawn_names_of(catalogs: Catalogs) -> DrawnNames:
    """Returns what catalogs tell that drawings name."""
    return DrawnNames(catalogs)
