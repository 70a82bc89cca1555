"""ISO 10303-21, the text that IFC files are: entities one by one, each written as it is made.

What fields an entity has says ifcopenshell's schema. Its own files never free what was in them (0.9.0: some 150 bytes an entity, 2 MB for
a small home), which ends a process that writes one home after another.
"""

import re
from collections.abc import Callable, Sequence
from operator import attrgetter
from typing import Any, Final, NamedTuple

_ESCAPED: Final = re.compile(r"[^ -~]+")
_HEADER: Final = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(({view}),'2;1');
FILE_NAME({name},{date},(''),(''),'Compose','Compose','');
FILE_SCHEMA(({schema}));
ENDSEC;
DATA;
"""
_END: Final = "ENDSEC;\nEND-ISO-10303-21;\n"


class Entity:
    """An entity of a file, or a value that says its type, as others name it; its fields are attributes."""

    def __init__(self, kind: str, reference: str, fields: dict[str, Any]) -> None:
        self.kind, self.reference = kind, reference
        self.__dict__.update(fields)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"{self.kind} was given no {name}")


class _Field(NamedTuple):
    name: str
    text: Callable[[Any], str]
    empty: str
    """How it is written where nothing is given."""


class StepFile:
    """A file of one schema."""

    def __init__(self, schema: str) -> None:
        import ifcopenshell  # noqa: PLC0415 (an extra)

        self._name, self._schema = schema, ifcopenshell.ifcopenshell_wrapper.schema_by_name(schema)
        self._fields: dict[str, list[_Field]] = {}
        self._lines: list[str] = []

    def new(self, kind: str, **fields: Any) -> Entity:
        """Returns a new entity; what is not given is left open.

        Raises:
            ValueError: such an entity has no field of a name.
        """
        known = self._fields.get(kind) or self._fields.setdefault(kind, self._fields_of(kind))
        written = [one.empty if (value := fields.get(one.name)) is None else one.text(value) for one in known]
        if unknown := fields.keys() - {one.name for one in known}:
            raise ValueError(f"{kind} has no {', '.join(sorted(unknown))}")
        made = Entity(kind, f"#{len(self._lines) + 1}", fields)
        self._lines.append(f"{made.reference}={kind.upper()}({','.join(written)});\n")
        return made

    def _fields_of(self, kind: str) -> list[_Field]:
        entity: Any = self._schema.declaration_by_name(kind).as_entity()
        return [
            _Field(one.name(), _text_of(one.type_of_attribute()), "*" if is_derived else "$")
            for one, is_derived in zip(entity.all_attributes(), entity.derived(), strict=True)
        ]

    def text(self, name: str, view: str, date: str) -> str:
        """Returns the whole file."""
        said = {"name": _text(name), "view": _text(f"ViewDefinition [{view}]"), "date": _text(date), "schema": _text(self._name)}
        return "".join((_HEADER.format(**said), *self._lines, _END))


def value_of(kind: str, value: object) -> Entity:
    """Returns a value that says its type, as of a property."""
    return Entity(kind, f"{kind.upper()}({_text(value)})", {})


def _text_of(kind: Any) -> Callable[[Any], str]:
    """Returns what writes a field of a type of the schema: values alone tell neither words of an enumeration nor whole numbers."""
    named, simple = kind.as_named_type(), kind.as_simple_type()
    if named and named.declared_type().as_enumeration_type():
        return ".{}.".format
    if named and (of := named.declared_type().as_type_declaration()):
        return _text_of(of.declared_type())
    return _real if simple and simple.declared_type() in ("real", "number") else _text


def _text(value: Any) -> str:
    """Returns a value as files have it, a number of numpy's as that of Python which it is."""
    written = _WRITTEN.get(type(value))
    return written(value) if written else _text(value.item())


def _real(value: float) -> str:
    digits, mark, power = repr(float(value)).removesuffix(".0").partition("e")
    return f"{digits}{'' if '.' in digits else '.'}{mark.upper()}{power}"


def _string(value: str) -> str:
    return "'" + _ESCAPED.sub(_escaped, value.replace("\\", "\\\\").replace("'", "''")) + "'"


def _escaped(found: re.Match[str]) -> str:
    mark, form = ("X2", "utf-16-be") if max(found[0]) <= "\uffff" else ("X4", "utf-32-be")
    return f"\\{mark}\\{found[0].encode(form).hex().upper()}\\X0\\"


def _list(values: Sequence[object]) -> str:
    return f"({','.join(map(_text, values))})"


_WRITTEN: Final[dict[type, Callable[[Any], str]]] = {
    Entity: attrgetter("reference"), bool: {True: ".T.", False: ".F."}.__getitem__, int: str, float: _real, str: _string,
    list: _list, tuple: _list,
}  # fmt: skip
