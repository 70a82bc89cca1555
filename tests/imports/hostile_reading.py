"""Reads hostile files as the service does, each in a process of its own: `python -m tests.targets files`.

`python -m tests.imports.hostile_reading [NAMES]` prints a line of JSON a file: the status of the answer, its first error, s of processor
time, and MB over what the process held before.
"""

from __future__ import annotations

import json
import os
import resource
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from importlib import import_module
from typing import Any, Final, NoReturn

from catalogs import load_catalogs
from service.packed_catalogs import mark_of, packed, warm
from service.wire import BODY_LIMIT, FILE
from service.work import Failure, Job, do
from tests.imports.hostile_buildings import dxf_of, dxf_outline, ifc_of
from tests.imports.hostile_plans import MAKERS
from tests.imports.plans import box, collection
from tests.imports.test_hostile_files import MENDED, REFUSED, content_of

import_module("tests.imports.hostile_drawings")
MOST_CPU: Final = 60
"""A reading is ended after so many seconds of processor time."""
MOST_DATA: Final = 4 << 30
"""A reading that asks for more memory fails, bytes."""

MOST_SECONDS: Final = 5.0
MOST_MEGABYTES: Final = 300.0
FILES: Final = {**REFUSED, **MENDED, **MAKERS}
WORDS: Final = ("field", "problem", "allowed")
READ: Final = frozenset({
    *MENDED, "geojson_of_a_comb", "geojson_of_five_hundred_circles", "geojson_of_stars", "geojson_of_a_grid_of_walls",
    "geojson_of_openings_in_every_wall", "geojson_of_many_levels", "dxf_of_tags", "dxf_of_many_layers", "svg_of_doors_that_swing",
    "xml_of_30_mb_of_text", "xml_nested_deeply", "sh3d_of_one_name_often", "sh3d_of_properties",
    "sh3d_whose_home_is_30_mb_of_attributes", "sh3d_walls_in_every_place",
})  # fmt: skip
"""What is a plan, though a strange one."""


@dataclass(frozen=True)
class Reading:
    """What reading a file came to."""

    name: str
    size: int
    status: int
    """Of the answer; 500 where there is none."""
    error: dict[str, Any]
    """The first error of the answer; a `trace` where there is no answer."""
    seconds: float
    """Of processor time."""
    megabytes: float
    """The most memory held at once, over what there was before."""

    @property
    def is_good(self) -> bool:
        """Tells whether it is read, or refused with words and a place, and within the limits."""
        told = self.status == 200 if self.name in READ else self.status in (413, 422) and all(self.error.get(key) for key in WORDS)
        return told and self.size <= BODY_LIMIT and self.seconds <= MOST_SECONDS and self.megabytes <= MOST_MEGABYTES


def readings(names: Iterable[str] = FILES) -> Iterator[Reading]:
    """Reads files one after the other."""
    content = packed(load_catalogs())
    warm(content)
    known = mark_of(content)
    room = dxf_outline([(0, 0), (4, 0), (4, 3), (0, 3)])
    for plain in (json.dumps(collection(box("Kitchen", 0, 0, 4, 3))).encode(), dxf_of(room), ifc_of("#1=IFCCARTESIANPOINT((0.,0.,0.));")):
        _answer(plain, known)  # what is loaded once is loaded
    for name in names:
        content, _ = _apart(lambda: content_of(FILES[name]))  # noqa: B023 (done at once)
        told, used = _apart(lambda: _answer(content, known))  # noqa: B023
        said: dict[str, Any] = json.loads(told) if told else {"before": 0, "status": 500, "error": {"trace": "it was ended"}}
        grown = max(0, used.ru_maxrss * _KILOBYTES - said.pop("before"))
        yield Reading(name, len(content), **said, seconds=used.ru_utime + used.ru_stime, megabytes=grown / (1 << 20))


_KILOBYTES: Final = 1 if sys.platform == "darwin" else 1 << 10


def _answer(content: bytes, known: str) -> bytes:
    """Returns what the service answers to a file: its status and its first error; and the bytes that the process held before."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * _KILOBYTES
    done = do(Job("import", content, FILE, "json", known))
    if isinstance(done, Failure):
        said = {"status": 500, "error": {"trace": done.trace}}
    else:
        said = {"status": done.status_code, "error": next(iter(json.loads(bytes(done.body)).get("errors", [])), {})}
    return json.dumps({"before": before, **said}).encode()


def _apart(work: Callable[[], bytes]) -> tuple[bytes, resource.struct_rusage]:
    """Returns what a forked process says before it ends, empty where it was ended, and what it used."""
    source, sink = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(source)
        _say(work, sink)
    os.close(sink)
    with os.fdopen(source, "rb") as heard:
        said = heard.read()
    _, _, used = os.wait4(child, 0)
    return said, used


def _say(work: Callable[[], bytes], sink: int) -> NoReturn:
    try:
        resource.setrlimit(resource.RLIMIT_CPU, (MOST_CPU, MOST_CPU))
        resource.setrlimit(resource.RLIMIT_DATA, (MOST_DATA, MOST_DATA))
        with os.fdopen(sink, "wb") as told:
            told.write(work())
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(0)


def hostile_files() -> bool:
    """Prints what reading each file costs, the dearest last; returns whether all are refused or read within the limits."""
    found = sorted(readings(), key=lambda one: one.seconds)
    for one in found:
        words = " ".join(str(one.error.get(key, "")) for key in WORDS)
        print(f"{'  ' if one.is_good else '! '}{one.name:50} {one.status} {one.seconds:6.2f} CPU s {one.megabytes:5.0f} MB  {words:.100}")
    print(f"{len(found)} files, of which {sum(not one.is_good for one in found)} miss a limit")
    return all(one.is_good for one in found)


def main() -> None:
    """Reads the named files, all by default."""
    for reading in readings(sys.argv[1:] or FILES):
        print(json.dumps(vars(reading)), flush=True)


if __name__ == "__main__":
    main()
