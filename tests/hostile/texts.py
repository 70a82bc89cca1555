"""Spoilt texts, by seed: the examples of every call, in JSON and YAML, with pieces cut, doubled, turned and put in.

Comes in: a seed and a format. Goes out: a call and its body. `faults` has them answered as the service does.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from random import Random
from typing import Any, Final

from starlette.responses import Response

from catalogs import load_catalogs
from service.calls import CALLS
from service.effort import Terms
from service.openapi import examples
from service.packed_catalogs import mark_of, packed
from service.work import Job, do
from solver.exchange import dump_text

TERMS: Final = Terms(work=20_000, most="normal")
STUMBLES: Final = (
    "0x" + "f" * 5000, "0o" + "7" * 5000, "9" * 5000, "1e999", "-1e999", "!!float " + "1" * 310, "!!int '3'", ".nan", "NaN",
    "Infinity", "-0", "&a [*a]", "*a", "<<: *a", "&a {b: &c [*c, *c]}", "!!python/object/apply:os.system ['x']",
    "!!binary |", "!!set {a}", "!!timestamp 2026-01-01", "? ", "- " * 300, "{" * 300, "[" * 3000, "]" * 30, "\x00", "\ufffe",
    "\ud83d", "\u2028", "\u202e", "'", '"', "#", "%YAML 1.1\n---\n", "---\n", "...\n", "\t", "|\n", ">-\n", "null", "~",
    "yes", "[]", "{}", "../../../etc/passwd", "<img src=x onerror=alert(1)>", "${jndi:x}", "__proto__", "%00", "a" * 70_000,
    "1.7976931348623157e308", "5e-324", "9007199254740993", "0.1e-400",
)  # fmt: skip


@cache
def bodies() -> tuple[tuple[str, Any], ...]:
    """Returns the calls that take bodies, each with the body of its example."""
    given = {path.split("/")[1]: one["body"] for path, one in examples().items() if isinstance(one, dict) and "body" in one}
    return tuple((call, given[call]) for call in CALLS if call in given)


def spoilt(seed: int, format: str) -> tuple[str, bytes]:
    """Returns a call and the spoilt text of its body."""
    random = Random(f"{format} {seed}")
    call, body = random.choice(bodies())
    text = dump_text(body, format).decode()
    for _ in range(random.choice([1, 1, 2, 5])):
        start = random.randrange(len(text) + 1)
        end = min(start + random.choice([0, 1, 3, 20, 200]), len(text))
        piece = random.choice(["", random.choice(STUMBLES), text[start:end] * 2, text[start:end][::-1], text[:start][-50:]])
        text = text[:start] + piece + text[end:]
    return call, text.encode("utf-8", "surrogatepass")


def faults(seeds: Iterable[int], format: str) -> Iterator[str]:
    """Yields what is answered by a fault of ours."""
    known = mark_of(packed(load_catalogs()))
    for seed in seeds:
        call, text = spoilt(seed, format)
        done = do(Job(call, text, format, random_answer(seed), known, TERMS))
        if not isinstance(done, Response) or done.status_code >= 500:
            yield f"{format} {seed} /{call}: {getattr(done, 'trace', done)!s:.3000}"


def random_answer(seed: int) -> str:
    """Returns the format of an answer: both in turn."""
    return ("json", "yaml")[seed % 2]
