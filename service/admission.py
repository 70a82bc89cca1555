"""Who is let in: keys where there are any, how often each may ask, and how much work each may have a day."""

import time
from collections import OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from ipaddress import IPv6Address, ip_address
from math import ceil
from typing import Any, Final
from urllib.parse import parse_qsl, urlencode

from starlette.datastructures import Headers
from starlette.requests import cookie_parser
from starlette.responses import RedirectResponse, Response
from starlette.types import ASGIApp, Receive, Scope, Send

from service.keys import KeyRing
from service.problems import problem

KNOWN: Final = 10_000
"""How many callers are remembered; who has asked least recently is forgotten. Our choice: some megabytes."""
MINUTE_S: Final = 60.0
DAY_S: Final = 86_400


@dataclass(frozen=True)
class Allowance:
    """What one caller may do; 0 where there is no limit.

    Calls a minute, that many at once; seconds of work a day, of the calendar in UTC.
    """

    calls: int = 0
    work_s: float = 0


UNBOUNDED: Final = Allowance()


class Rates:
    """Lets each caller ask so often a minute, that many times at once; 0 for no limit."""

    def __init__(self, calls: int) -> None:
        self._calls = calls
        self._left: OrderedDict[str, tuple[float, float]] = OrderedDict()

    def wait(self, who: str, now: float) -> int:
        """Counts a call of somebody; returns 0 where it may be made, else how many seconds to wait. The clock, s, never goes back."""
        if self._calls == 0:
            return 0
        left, then = self._left.pop(who, (float(self._calls), now))
        left = min(float(self._calls), left + max(now - then, 0.0) * self._calls / MINUTE_S)
        allowed = left >= 1
        self._left[who] = (left - 1 if allowed else left, now)
        if len(self._left) > KNOWN:
            self._left.popitem(last=False)
        return 0 if allowed else ceil((1 - left) * MINUTE_S / self._calls)


class Quotas:
    """Lets each caller have so many seconds of work a day; 0 for no limit."""

    def __init__(self, work_s: float) -> None:
        self._most = work_s
        self._day = 0
        self._used: dict[str, float] = {}

    def wait(self, who: str, now: float) -> int:
        """Returns 0 where somebody may have more work today, else the seconds until tomorrow; `now` in seconds since 1970, UTC."""
        self._turn(now)
        return 0 if self._most == 0 or self._used.get(who, 0.0) < self._most else ceil(DAY_S - now % DAY_S)

    def spend(self, who: str, work_s: float, now: float) -> None:
        """Counts work that was done for somebody."""
        self._turn(now)
        if self._most > 0 and (who in self._used or len(self._used) < KNOWN):
            self._used[who] = self._used.get(who, 0.0) + work_s

    def _turn(self, now: float) -> None:
        """Begins another day; a clock that was put back a little goes on with the day there is, one that had been days ahead does not."""
        if (day := int(now // DAY_S)) > self._day or day < self._day - 1:
            self._day, self._used = day, {}


COOKIE: Final = "compose_key"
COOKIE_S: Final = 30 * 86_400
"""How long a browser keeps the key, s. Our choice."""
PAGE: Final = "/"
OPEN: Final = frozenset({PAGE, "/embed", "/core.wasm", "/docs", "/openapi.json", "/healthz", "/readyz"})
"""Paths that need no key: the page itself, which asks for one, what the calls are, and whether the service lives."""
OPEN_FOLDER: Final = "/assets/"
FOR_OTHER_PAGES: Final[Mapping[str, Any]] = {
    "allow_methods": ["GET", "POST", "PATCH", "PUT", "DELETE"],
    "allow_headers": ["Content-Type", "X-API-Key", "If-Match", "If-None-Match", "Last-Event-ID"],
    "expose_headers": ["ETag", "Location", "Retry-After", "Content-Disposition"],
}
"""What pages of other places may send and read, where they may ask; never a cookie."""
OWNER: Final = "owner"
PARAMETER: Final = "key"


@dataclass(frozen=True)
class Admitted:
    """Who may ask, how often, and from where.

    Args:
        keys: without any, everybody may ask.
        each_key: what the owner of a key may do, all keys of one name together.
        each_address: what an address may do; of IPv6 a network of 64 bits.
        origins: places, such as https://homes.example, whose pages may ask.
        clock: seconds of a clock that never goes back.
        date: seconds since 1970, UTC.
    """

    keys: KeyRing = field(default_factory=KeyRing)
    each_key: Allowance = UNBOUNDED
    each_address: Allowance = UNBOUNDED
    origins: tuple[str, ...] = ()
    clock: Callable[[], float] = time.monotonic
    date: Callable[[], float] = time.time


def owner_of(scope: Scope) -> str:
    """Returns the name of the key a request came with; an empty text where the service has no keys."""
    owner: str = scope.get("state", {}).get(OWNER, "")
    return owner


class Admission:
    """Lets those through to the routes that may ask."""

    def __init__(self, app: ASGIApp, admitted: Admitted) -> None:
        self._app, self._admitted = app, admitted
        both = (admitted.each_key, admitted.each_address)
        self._rates = tuple(Rates(one.calls) for one in both)
        self._quotas = tuple(Quotas(one.work_s) for one in both)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers one request."""
        path = scope.get("path", "")
        if scope["type"] != "http" or path.startswith(OPEN_FOLDER) or (path in OPEN and path != PAGE):
            await self._app(scope, receive, send)
            return
        key, cleaned = _key_taken(scope)
        is_in_address, scope = cleaned is not scope, cleaned
        owner = self._admitted.keys.owner_of(key) if self._admitted.keys and key else None
        if path == PAGE:
            answer = _with_cookie(scope, key) if owner is not None and is_in_address else self._app
            await answer(scope, receive, send)
            return
        if refusal := self._refusal(scope, owner, bool(key)):
            await refusal(scope, receive, send)
            return
        scope["state"] = {**scope.get("state", {}), OWNER: owner or ""}
        begun = self._admitted.clock()
        try:
            await self._app(scope, receive, send)
        finally:
            if scope["method"] == "POST":
                self._spend((owner, _address(scope)), self._admitted.clock() - begun)

    def _spend(self, callers: tuple[str | None, str], work_s: float) -> None:
        for who, quotas in zip(callers, self._quotas, strict=True):
            if who is not None:
                quotas.spend(who, work_s, self._admitted.date())

    def _refusal(self, scope: Scope, owner: str | None, is_given: bool) -> Response | None:
        now, date = self._admitted.clock(), self._admitted.date()
        callers = ((owner, "this key"), (_address(scope), "this address"))
        often, much = (0, ""), (0, "")
        for (who, words), rates, quotas in zip(callers, self._rates, self._quotas, strict=True):
            if who is not None:
                often = max(often, (rates.wait(who, now), words))
                much = max(much, (quotas.wait(who, date), words))
        if often[0]:
            return _too_many(*often, "more calls a minute than it may make")
        if self._admitted.keys and owner is None:
            entry = {"field": "key", "problem": "is not known" if is_given else "is missing", "allowed": "a key in X-API-Key"}
            headers = {"WWW-Authenticate": 'ApiKey realm="Compose"'}
            return problem(
                401, "This service wants a key", f"The key {entry['problem']}. Ask whoever runs the service for one.", [entry], headers
            )
        return _too_many(*much, "all the work of its day") if much[0] else None


def _too_many(wait: int, who: str, what: str) -> Response:
    entry = {"field": who.removeprefix("this "), "problem": f"has had {what}", "allowed": f"another try in {wait} s"}
    return problem(429, "Too many requests", f"From {who} came {what}; try again in {wait} s.", [entry], {"Retry-After": str(wait)})


def _address(scope: Scope) -> str:
    """Returns where a request comes from; who has an IPv6 address has all those of its network."""
    host = (scope.get("client") or ("", 0))[0]
    try:
        address = ip_address(host)
    except ValueError:
        return host
    return str(IPv6Address(int(address) >> 64 << 64)) if isinstance(address, IPv6Address) and not address.ipv4_mapped else host


def _key_taken(scope: Scope) -> tuple[str, Scope]:
    """Returns the key that a request holds, an empty text where it holds none; and the request with no key in its address."""
    headers, key = Headers(scope=scope), ""
    if PARAMETER.encode() in scope.get("query_string", b""):
        pairs = parse_qsl(scope["query_string"].decode("latin-1"), keep_blank_values=True)
        key = next((value for name, value in pairs if name == PARAMETER), "")
        rest = urlencode([pair for pair in pairs if pair[0] != PARAMETER])
        scope = {**scope, "query_string": rest.encode("latin-1", "replace")}
    return headers.get("x-api-key") or key or cookie_parser(headers.get("cookie", "")).get(COOKIE, ""), scope


def _with_cookie(scope: Scope, key: str) -> Response:
    """Has the browser keep the key and open the page without it, so that no history and no link holds it."""
    query = scope["query_string"].decode("latin-1")
    answer = RedirectResponse(f"./?{query}" if query else "./", 303, {"Cache-Control": "no-store"})
    answer.set_cookie(COOKIE, key, COOKIE_S, httponly=True, samesite="lax", secure=scope.get("scheme") == "https")
    return answer
