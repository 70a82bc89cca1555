"""Requests spoilt on the wire, by seed: framing that can be read in two ways, headers in disguise, paths that lead out.

Comes in: a seed. Goes out: the bytes. Each holds, where a body may be, another request: who answers that has taken a body for a request.
`wire_faults` sends them to a service and tells of answers that must not be.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random
from threading import Thread
from typing import Final, TextIO, cast
from urllib.parse import urlsplit

from tests.browser.service_process import ServiceProcess

HIDDEN_ID: Final = "hidden-request"
HIDDEN: Final = f"GET /healthz HTTP/1.1\r\nHost: localhost\r\nX-Request-ID: {HIDDEN_ID}\r\n\r\n"
INJECTED: Final = "X-Injected: yes"
ROOT: Final = str(Path(__file__).resolve().parents[2])
MUST_NOT: Final = re.compile(rf'Traceback|{re.escape(ROOT)}|root:x:|\[build-system\]|File "|{HIDDEN_ID}|[\r\n]\s*{INJECTED}', re.IGNORECASE)
"""What no answer holds: traces, paths, files, what was asked within a body, and a header of the caller's."""
STATUS: Final = re.compile(r"HTTP/1\.1 ([1-5][0-9][0-9]) ")
AT_ONCE: Final = 32
PATIENCE_S: Final = 120.0
"""A guard against a connection that is never closed."""
SHORT: Final = ("--idle-seconds", "0.5", "--header-seconds", "0.5", "--body-seconds", "0.5")
"""Settings of a service that is asked: it soon gives up a connection on which nothing comes."""
CALLS: Final = ("/view", "/generate", "/homes", "/jobs", "/export/json", "/nothing", "/healthz", "/homes/x", "/import")


def _head(random: Random, lines: Sequence[str], method: str = "POST", path: str | None = None) -> str:
    """Returns the head of a request with these lines somewhere among the usual ones."""
    usual = ["Host: localhost", "Content-Type: application/json", "Connection: close"]
    at = random.randrange(len(usual) + 1)
    return "\r\n".join([f"{method} {path or random.choice(CALLS)} HTTP/1.1", *usual[:at], *lines, *usual[at:]]) + "\r\n\r\n"


def framed_twice(random: Random) -> str:
    """Says in two ways, or in one that may be overlooked, where its body ends: within it, or after what is hidden."""
    body = "0\r\n\r\n" + HIDDEN
    length = f"Content-Length: {len(body)}"
    chunked = random.choice(
        [
            "Transfer-Encoding: chunked",
            "transfer-encoding:chunked",
            "Transfer-Encoding:\tchunked",
            "Transfer-Encoding: xchunked",
            "Transfer-Encoding : chunked",
            " Transfer-Encoding: chunked",
            "Transfer-Encoding: chunked, identity",
            "X: y\nTransfer-Encoding: chunked",
            "Transfer-Encoding: identity\r\nTransfer-Encoding: chunked",
            "Transfer-Encoding:\r\n chunked",
            "Transfer-Encoding: \x0bchunked",
            "Transfer-Encoding: gzip, chunked",
            "Transfer_Encoding: chunked",
            "Transfer-Encoding: CHUNKED",
        ]
    )
    return _head(random, random.sample([length, chunked], k=2)) + body


def lengths(random: Random) -> str:
    """Says how long its body is in words that are no length, or in several."""
    size = len(HIDDEN)
    other = random.choice([0, 1, size - 1])
    lines = random.choice(
        [
            [f"Content-Length: {size}", f"Content-Length: {other}"],
            [f"Content-Length: {other}", f"Content-Length: {size}"],
            [f"Content-Length: {size}, {other}"],
            [f"Content-Length: +{other}"],
            [f"Content-Length: -{size}"],
            [f"Content-Length: 0x{size:x}"],
            [f"Content-Length: {size}.0"],
            [f"Content-Length : {other}"],
            ["Content-Length: 1_0"],
            ["Content-Length: \u0660".encode().decode("latin-1")],
            [f"Content-Length: {'9' * random.choice([19, 400, 5000])}"],
            ["Content-Length:"],
            [f"Content-Length: {other}\r\n {size}"],
            [f"Content-Length: {size}", f"Content-Length: {size}"],
        ]
    )
    return _head(random, lines) + HIDDEN


def chunks(random: Random) -> str:
    """Sends its body in chunks whose sizes are disguised."""
    size = f"{len(HIDDEN):x}"
    said = random.choice(
        [
            size,
            "0" * 30 + size,
            "+" + size,
            "-" + size,
            "0x" + size,
            size + " ",
            size + ";a=b",
            size + ';a="\n"',
            size + "\t",
            "f" * 30,
            "",
            "g",
        ]
    )
    end = random.choice(["\r\n", "\n", "\r", "\r\r\n"])
    last = random.choice(["0\r\n\r\n", "0\r\nX-Trailer: yes\r\n\r\n", f"0\r\nContent-Length: 9\r\n{INJECTED}\r\n\r\n", "0\n\n", ""])
    return _head(random, ["Transfer-Encoding: chunked"]) + said + end + HIDDEN + "\r\n" + last


def injected(random: Random) -> str:
    """Sends line ends in disguise wherever an answer may say again what it was sent."""
    end = random.choice(["%0d%0a", "%0D%0A%20", "%e5%98%8a%e5%98%8d", "\x0d", "\x0b", "\x85", "\u2028", "\\r\\n", "%250d%250a", "\x00"])
    said = f"a{end}{INJECTED}".encode().decode("latin-1")
    path = random.choice(
        ["/{0}", "/?key={0}", "/homes?after={0}", "/homes/{0}", "/export/{0}", "/asset/{0}", "/jobs/{0}/events", "/?{0}=1"]
    )
    lines = [
        f"{random.choice(['X-Request-ID', 'X-API-Key', 'Cookie', 'Origin', 'Accept', 'If-Match', 'Host', 'X-Forwarded-Proto'])}: {said}"
    ]
    return _head(
        random, random.choice([[], lines]), random.choice(["GET", "POST", "HEAD", "PUT", "DELETE"]), path.format(said.replace(" ", "%20"))
    )


def leading_out(random: Random) -> str:
    """Asks for a file outside."""
    up = random.choice(["..", "%2e%2e", "%2e.", "..%2f..", "%252e%252e", "..\\", "..%5c", "....//", "%c0%ae%c0%ae", "..;", "..%00"])
    start = random.choice(["/assets/", "/asset/", "/", "/export/", "/homes/", "//", "/embed/", "http://localhost/", "/assets//"])
    file = random.choice(["etc/passwd", "pyproject.toml", "proc/self/environ", "service/app.py", "%65tc/passwd"])
    path = start + "/".join([up] * random.randint(1, 9)) + "/" + file
    return _head(random, [], random.choice(["GET", "HEAD", "POST"]), random.choice([path, start + "/" + file, path + "%00.js"]))


def no_request(random: Random) -> str:
    """Sends what is no request, or one of another time."""
    line = random.choice(
        [
            "GET /healthz",
            "GET /healthz HTTP/0.9",
            "GET /healthz HTTP/2.0",
            "GET  /healthz HTTP/1.1",
            "GET\t/healthz HTTP/1.1",
            "G\x00T / HTTP/1.1",
            "CONNECT localhost:22 HTTP/1.1",
            "TRACE / HTTP/1.1",
            "PRI * HTTP/2.0\r\n\r\nSM",
            "OPTIONS * HTTP/1.1",
            "GET http://evil.example/ HTTP/1.1",
            "GET /" + "a" * random.choice([5000, 70_000]) + " HTTP/1.1",
            "\x16\x03\x01\x02",
            "get /healthz http/1.1",
            "GET /healthz HTTP/1.1 ",
            "",
        ]
    )
    lines = random.choice(
        [
            ["Host: localhost"],
            ["Host: evil.example", "Host: localhost"],
            ["Host: localhost", "Host: evil.example"],
            [],
            ["Host:"],
            ["Host: localhost", "A: " + "b" * 70_000],
            ["Host: localhost", *[f"A{k}: b" for k in range(900)]],
            [": a"],
            ["a"],
        ]
    )
    return random.choice(["\r\n", "\n"]).join([line, *lines, "Connection: close", "", ""])


KINDS: Final[Sequence[Callable[[Random], str]]] = (framed_twice, lengths, chunks, injected, leading_out, no_request)


def sent(seed: int) -> bytes:
    """Returns what is sent."""
    return KINDS[seed % len(KINDS)](Random(f"wire {seed}")).encode("latin-1", "replace")


def wrong_in(answer: bytes) -> str:
    """Returns what an answer holds that it must not, or an empty text."""
    text = answer.decode("latin-1")
    found = MUST_NOT.search(text)
    statuses = [status for status in STATUS.findall(text) if status[0] == "5" and status != "503"]
    return (found.group() if found else "") or ", ".join(statuses) or ("" if not text or text.startswith("HTTP/1.1 ") else text[:60])


async def asked(address: str, content: bytes) -> bytes:
    """Sends to a service on a connection of its own; returns all that it answers until it closes."""
    place = urlsplit(address)
    reader, writer = await asyncio.open_connection(place.hostname, place.port)
    try:
        writer.write(content)
        async with asyncio.timeout(PATIENCE_S):
            return await reader.read()
    except ConnectionError:
        return b""  # it was closed before all was sent
    except TimeoutError:
        return b"it was left open"
    finally:
        writer.close()


def wire_faults(service: ServiceProcess, seeds: Iterable[int]) -> list[str]:
    """Returns what a service, which was started with SHORT, answers as it must not."""
    # It says of each request that is none that it is none; where nobody hears that, it waits.
    Thread(target=cast(TextIO, service.process.stderr).read, daemon=True).start()
    with ThreadPoolExecutor(1) as thread:  # of its own: this one may have a loop of a browser's, which tests before it began
        return thread.submit(asyncio.run, _faults(service.address, iter(seeds))).result()


async def _faults(address: str, left: Iterator[int]) -> list[str]:
    found = list[str]()

    async def ask() -> None:
        for seed in left:
            if wrong := wrong_in(await asked(address, sent(seed))):
                found.append(f"{KINDS[seed % len(KINDS)].__name__} {seed}: {wrong}: {sent(seed)[:200]!r}")

    await asyncio.gather(*(ask() for _ in range(AT_ONCE)))
    healthy = await asked(address, b"GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
    return found if b'{"status":"ok"}' in healthy else [*found, f"the service is ill: {healthy[:200]!r}"]
