"""What the keys of documents may hold: types for the fields of dataclasses, each with its limits.

From them come the reading, the JSON Schema, the words of refusals and the page's types: a key is declared once, as a field.

pydantic reads the types; it is imported when something is read, so that having them costs nothing.
"""

from collections.abc import Callable, Mapping
from dataclasses import MISSING, fields
from functools import cache
from importlib import import_module
from typing import Annotated, Any, ClassVar, Final, TypeVar, get_args, get_type_hints

from annotated_types import Ge, Gt, Le, MaxLen, MinLen

from solver.plain import Wrong, is_text, plain

Value = TypeVar("Value")
MAX_WHOLE: Final = 2**53 - 1
"""The largest integer that every JSON reader keeps exactly."""
MAX_LENGTH: Final = 1000.0
"""Largest size of anything in a scene, m."""
MAX_MAGNITUDE: Final = 1e6
"""Largest magnitude of a number that has no range of its own, m or degrees; our choice, far beyond any house."""
EXTRA: Final = "extra"
"""The field that keeps a record's unknown keys."""
OMITTED: Final = "omitted"
"""Metadata of a field that is not written where it is None."""


class _Strict:
    """Nothing is taken for something else: no text for a number, no 1 for true, no half a surrogate pair for a letter."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        schema = {**handler(source), "strict": True}
        return {**schema, "min_length": schema.get("min_length", 0)} if source is str else schema

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        return {key: value for key, value in handler(schema).items() if (key, value) != ("minLength", 0)}


class _Whole:
    """A whole number, also one that is written with a point."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        return _before(_unpointed, {**handler(source), "strict": True})


class _Given:
    """An entry of the catalogs as a request says it: its keys that are null are not given."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        return _before(_without_nulls, handler(source))


class OneOf:
    """One of some words."""

    def __init__(self, *words: str) -> None:
        self.words = words

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        return _core().core_schema.literal_schema(list(self.words))


class Matching:
    """A text that a regular expression matches."""

    def __init__(self, pattern: str) -> None:
        self.pattern = pattern

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        return {**handler(source), "pattern": self.pattern}


class Says:
    """What a key is about, in words: for its JSON Schema and for refusals."""

    def __init__(self, words: str) -> None:
        self.words = words

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        return {**handler(schema), "description": self.words}


class Like:
    """A mapping with the keys that a type declares; of the type nothing but its schema is used."""

    def __init__(self, declared: Any) -> None:
        self.declared = declared

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        return handler.generate_schema(self.declared)


class _MadeUp:
    """A key that a reader makes up where it is absent."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        return _core().core_schema.with_default_schema(handler(source), default="")

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        written = {key: value for key, value in handler(schema).items() if key != "default"}
        return {**written, "description": "made up where it is absent, alike each time"}


class _Required:
    """A key that must be there, although its field has a default because of the order of fields."""


class _Free:
    """A mapping of anything that JSON can say, copied."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        return _before(lambda value: _kept(value) if isinstance(value, Mapping) else value, _core().core_schema.dict_schema())

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        return {"type": "object"}


class _Indexed:
    """A mapping from an index, also one that is written as a text, to a text."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        return _before(_by_index, handler.generate_schema(dict[Index, Text]))

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        return {"type": "object", "propertyNames": {"pattern": "^[0-9]{1,9}$"}, "additionalProperties": {"type": "string"}}


class TextOr:
    """A text as one type says, or what is no text as another says: what is wrong is said of the one it is meant to be."""

    def __init__(self, text: Any, other: Any) -> None:
        self.text, self.other = text, other
        self._either: list[Any] = []

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        core, self._either = _core(), [handler.generate_schema(one) for one in (self.text, self.other)]
        text, other = map(core.SchemaValidator, self._either)
        return core.core_schema.no_info_plain_validator_function(lambda value: (text if is_text(value) else other).validate_python(value))

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        return handler(_core().core_schema.union_schema(self._either))


RECTANGLE: Final = "rectangle"
ANY: Final = "any"
"""The outline of a planned home that its seed draws."""
MOST_CORNERS: Final = 24
"""Of an outline that is given. Our choice: the ways to cut it double with every inner corner."""
GivenCorners = tuple[tuple[float, float], ...]
STRICT: Final = _Strict()
Text = Annotated[str, STRICT]
Name = Annotated[str, MinLen(1), STRICT]
MADE_UP: Final = _MadeUp()
Identity = Annotated[str, STRICT, MADE_UP]
Flag = Annotated[bool, STRICT]
WHOLE: Final = _Whole()
GIVEN: Final = _Given()
Whole = Annotated[int, Ge(-MAX_WHOLE), Le(MAX_WHOLE), WHOLE]
Index = Annotated[int, Ge(0), Le(MAX_WHOLE), WHOLE]
Number = Annotated[float, STRICT, Ge(-MAX_MAGNITUDE), Le(MAX_MAGNITUDE)]
"""A place, m, or an angle, degrees."""
PositiveMetres = Annotated[float, STRICT, Gt(0), Le(MAX_LENGTH)]
"""A size, m."""
OpenShare = Annotated[float, STRICT, Ge(0), Le(1)]
"""How far something is open: 0 shut, 1 wholly."""
_Coordinate = Annotated[float, STRICT, Ge(-1000.0), Le(1000.0)]
OUTLINE: Final = TextOr(
    Annotated[str, OneOf(RECTANGLE, "L", "T", "U", ANY)],
    Annotated[tuple[tuple[_Coordinate, _Coordinate], ...], MinLen(4), MaxLen(MOST_CORNERS)],
)
"""One of some words, or the corners of an outline, m."""
REQUIRED: Final = _Required()
Free = Annotated[Mapping[str, object], _Free()]
TextByIndex = Annotated[Mapping[int, str], _Indexed()]


def counted(most: int) -> TextOr:
    """Returns what takes whole numbers from 0 to `most` by word, or a text that names such numbers."""
    return TextOr(Text, dict[Text, Annotated[int, Ge(0), Le(most), WHOLE]])


class Record:
    """A dataclass that is read from a document, or written as one, key by key.

    Null where a value is due means: as if it were not there. Unknown keys are kept in the field `extra`; where there is none
    they are refused.
    """

    camel_case: ClassVar[bool] = False
    """Whether a key may also be spelled in camelCase."""

    def __getstate__(self) -> dict[str, Any]:
        """Returns what is copied or pickled: the fields, all made."""
        return {part.name: getattr(self, part.name) for part in fields(self)}  # type: ignore[arg-type]

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: Any) -> Any:
        schema = handler(source)
        read = handler.resolve_ref_schema(schema)
        parts = read["schema"]
        for part in parts["fields"]:
            if part["schema"]["type"] == "default" and part["name"] in required_names(cls):  # type: ignore[arg-type] # classes are hashable
                part["schema"] = part["schema"]["schema"]
        if EXTRA not in cls.__dict__["__dataclass_fields__"]:
            parts["extra_behavior"] = "forbid"
        # Sorting is part of what the reference refers to: pydantic does not come back for a type's second use.
        reference = read.pop("ref")
        sorted_first = _before(_sorter(cls), dict(read))
        read.clear()
        read.update({**sorted_first, "ref": reference})
        return schema

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: Any, handler: Any) -> Any:
        """Returns the JSON Schema of what is read, or of what is written: then every key is there but those left out."""
        reference = handler(schema)
        whole = handler.resolve_ref_schema(reference)
        keys: dict[str, Any] = whole["properties"]
        keys.pop(EXTRA, None)
        for part in fields(cls):  # type: ignore[arg-type]
            if part.name in keys:
                keys[part.name].pop("title", None)
                keys[part.name] |= {} if part.default_factory is MISSING else {"default": part.default_factory()}
                if part.default == "" and keys[part.name].get("minLength"):
                    del keys[part.name]["default"]  # it says that the key is absent
        if EXTRA not in cls.__dict__["__dataclass_fields__"]:
            whole["additionalProperties"] = False
        if handler.mode == "serialization":
            whole["required"] = [part.name for part in fields(cls) if part.name in keys and OMITTED not in part.metadata]  # type: ignore[arg-type]
        else:
            whole["properties"] = {name: key if name in whole.get("required", ()) else _or_null(key) for name, key in keys.items()}
            spelled = {camel(name): name for name in keys if cls.camel_case and camel(name) != name and camel(name) not in keys}
            if spelled:
                whole["properties"] |= {other: {**whole["properties"][name], "deprecated": True} for other, name in spelled.items()}
                whole["not"] = {"anyOf": [{"required": [name, other]} for other, name in spelled.items()]}
        return reference


@cache
def required_names(of: type[Any]) -> frozenset[str]:
    """Returns the keys of a document of a dataclass that must be there although their fields have defaults."""
    hints = get_type_hints(of, include_extras=True)
    return frozenset(name for name, hint in hints.items() if REQUIRED in get_args(hint))


def camel(name: str) -> str:
    """Spells snake_case in camelCase."""
    head, *tail = name.split("_")
    return head + "".join(word.capitalize() for word in tail)


def located(problem: str, allowed: str, way: tuple[str | int, ...] = ()) -> Exception:
    """Returns what is wrong that way inside a value, as the error that pydantic puts in its place."""
    core = _core()
    error = core.PydanticCustomError("refused", "{problem}", {"problem": problem, "allowed": allowed})
    found: Exception = core.ValidationError.from_exception_data("", [core.InitErrorDetails(type=error, loc=way, input=None)])
    return found


def _core() -> Any:
    """Returns pydantic's core, which types alone do not need."""
    return import_module("pydantic_core")


def _before(read: Callable[[Any], Any], schema: Any) -> Any:
    return _core().core_schema.no_info_before_validator_function(read, schema)


def _unpointed(value: Any) -> Any:
    return int(value) if type(value) is float and value.is_integer() else value


def _kept(value: Any) -> Any:
    try:
        return plain(value)
    except Wrong as wrong:
        raise located(wrong.problem, wrong.allowed, wrong.way) from None


def _without_nulls(document: Any) -> Any:
    return {key: value for key, value in document.items() if value is not None} if isinstance(document, Mapping) else document


def _sorter(of: type[Any]) -> Callable[[Any], Any]:
    """Returns what sorts a document's keys: the known ones without nulls, and the unknown ones into `extra`.

    The null of a key that must be there, and may be null, is its value.
    """
    names = {part.name: part.name for part in fields(of) if part.name != EXTRA}
    if of.camel_case:
        names |= {camel(name): name for name in names}
    keeps = EXTRA in of.__dict__["__dataclass_fields__"]
    undefaulted = [part for part in fields(of) if part.default is MISSING and part.default_factory is MISSING]
    may_be_null = {part.name for part in undefaulted if "None" in str(part.type)}

    def sort(document: Any) -> Any:
        if document.__class__ is not dict and not isinstance(document, Mapping):
            return document
        known: dict[str, Any] = {}
        unknown: dict[Any, Any] = {}
        for key, value in document.items():
            name = names.get(key)
            if name is None:
                unknown[key] = value
            elif name in known or (key != name and name in document):
                raise located(f"is given twice, as {name} and as {camel(name)}", "one of the two spellings", (name,))
            elif value is not None or name in may_be_null:
                known[name] = value
        if not unknown:
            return {**known, EXTRA: {}} if keeps else known
        if not all(map(is_text, unknown)):
            wrong = next(key for key in unknown if not is_text(key))
            raise located(f"has the key {wrong!r:.60}", "keys that are texts")
        return {**known, EXTRA: _kept(unknown)} if keeps else {**known, **unknown}

    return sort


def _by_index(value: Any) -> Any:
    if not isinstance(value, Mapping):
        return value
    found: dict[Any, Any] = {}
    for key, name in value.items():
        index = int(key) if isinstance(key, str) and key.isascii() and key.isdigit() and len(key) <= 9 else key
        if index in found:
            raise located("is given twice", "each index once", (index,))
        found[index] = name
    return found


def _or_null(key: dict[str, Any]) -> dict[str, Any]:
    """Returns the schema of a key that may be null."""
    options = key.get("anyOf", [key])
    if {"type": "null"} in options:
        return key
    words: dict[str, Any] = {word: key[word] for word in ("description", "default") if word in key}
    value = {word: said for word, said in key.items() if word not in words}
    return {"anyOf": [*value.pop("anyOf", [value]), {"type": "null"}], **words}
