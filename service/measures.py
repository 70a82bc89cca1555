"""What operators see: figures for Prometheus, an access log with an id for each request."""

import json
import logging
import re
import time
import uuid
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Final

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram, generate_latest
from prometheus_client.exposition import CONTENT_TYPE_LATEST
from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

if TYPE_CHECKING:
    from service.connections import Connections
    from service.workers import Lane, Workers

WORK_HEADER: Final = "X-Work"
"""Of an answer: the work that the call did."""
ISSUES_HEADER: Final = "X-Issues"
"""Of an answer: how many issues of each severity it lists, such as error=1,warning=2."""
RETRIED_HEADER: Final = "X-Retried"
"""Of an answer: how often the call was begun again after a trap of the core."""
ID_HEADER: Final = "X-Request-ID"
_ID: Final = re.compile(r"[A-Za-z0-9._-]{1,64}")
_SECONDS: Final = (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60)
OTHER: Final = "other"
"""What paths count as that are none of the service's."""
access_log: Final = logging.getLogger("compose.access")


class Measures:
    """The figures of one service, of its processes and connections."""

    def __init__(self, workers: "Workers", connections: "Connections") -> None:
        self.registry = CollectorRegistry()
        self._requests = Counter("compose_requests", "Requests answered.", ("path", "status"), registry=self.registry)
        words = "From the headers to the end of the answer."
        self._seconds = Histogram("compose_request_seconds", words, ("path",), registry=self.registry, buckets=_SECONDS)
        self._work = Counter("compose_work", "Work of calls, in searches of a small room.", ("path",), registry=self.registry)
        self._issues = Counter("compose_issues", "Issues listed in answers.", ("severity",), registry=self.registry)
        self._traps = Counter("compose_core_restarts", "Calls begun again on a fresh instance of the core.", registry=self.registry)
        self._gauge("compose_process_restarts", "Processes that died or had grown, and were replaced.", lambda: workers.restarts)
        for name, lane in (("heavy", workers.heavy), ("light", workers.light)):
            self._gauge(f"compose_{name}_running", f"Calls that run in the {name} lane.", _running(lane))
            self._gauge(f"compose_{name}_waiting", f"Calls that wait in the {name} lane.", _waiting(lane))
        self._gauge("compose_connections_open", "Open connections.", lambda: len(connections.open))
        self._gauge("compose_connections_closed", "Connections that gave way or waited too long.", lambda: connections.closed)
        self._gauge("compose_connections_refused", "Connections turned away.", lambda: connections.refused)

    def _gauge(self, name: str, words: str, value: Callable[[], float]) -> None:
        Gauge(name, words, registry=self.registry).set_function(value)

    def count(self, path: str, status: int, seconds: float, headers: Mapping[str, str]) -> None:
        """Counts an answer on a route's path, with its status, its headers and how many seconds it took."""
        self._requests.labels(path, str(status)).inc()
        self._seconds.labels(path).observe(seconds)
        self._work.labels(path).inc(float(headers.get(WORK_HEADER, "0")))
        self._traps.inc(float(headers.get(RETRIED_HEADER, "0")))
        for part in filter(None, headers.get(ISSUES_HEADER, "").split(",")):
            severity, _, number = part.partition("=")
            self._issues.labels(severity).inc(float(number))

    def text(self) -> bytes:
        """Returns all figures as Prometheus reads them."""
        return generate_latest(self.registry)


def _running(lane: "Lane") -> Callable[[], float]:
    return lambda: lane.slots.statistics().borrowed_tokens


def _waiting(lane: "Lane") -> Callable[[], float]:
    return lambda: lane.slots.statistics().tasks_waiting


class Observed:
    """Measures every request, names it, and writes a line of it; the clock is in seconds."""

    def __init__(self, app: ASGIApp, measures: Measures, clock: Callable[[], float] = time.perf_counter) -> None:
        self._app, self._measures, self._clock = app, measures, clock
        self._paths: set[str] = set()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers one request."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        begun, told, size = self._clock(), Headers(), 0
        status = 499  # what proxies say of a caller that left
        given = Headers(scope=scope).get(ID_HEADER, "")
        name = given if _ID.fullmatch(given) else uuid.uuid4().hex

        async def send_named(message: Message) -> None:
            nonlocal status, told, size
            if message["type"] == "http.response.start":
                status = message["status"]
                headers = MutableHeaders(scope=message)
                headers[ID_HEADER] = name
                told = Headers(raw=message["headers"])
            elif message["type"] == "http.response.body":
                size += len(message.get("body", b""))
            await send(message)

        try:
            await self._app(scope, receive, send_named)
        finally:
            seconds = self._clock() - begun
            self._measures.count(self._named(scope), status, seconds, told)
            if access_log.isEnabledFor(logging.INFO):
                access_log.info(_line(scope, status, told, id=name, seconds=round(seconds, 6), bytes=size))

    def _named(self, scope: Scope) -> str:
        """Returns what a path counts as: how it begins, where that is one of the service's."""
        self._paths = self._paths or {_beginning(route.path) for route in scope["app"].routes}
        begins = _beginning(scope["path"])
        return begins if begins in self._paths else OTHER


def _beginning(path: str) -> str:
    return "/" + path.split("/")[1] if "/" in path else OTHER


def _line(scope: Scope, status: int, told: Headers, **more: object) -> str:
    """Returns a line of the access log; what follows the path is left out, as it may hold a key."""
    client = scope.get("client") or ("",)
    said = {
        "time": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()), "client": client[0], "method": scope["method"],
        "path": scope["path"], "status": status, "work": int(told.get(WORK_HEADER, "0")), **more,
    }  # fmt: skip
    return json.dumps(said)


async def metrics(request: Request) -> Response:
    """Answers with all figures."""
    measures: Measures = request.app.measures
    return Response(measures.text(), headers={"Content-Type": CONTENT_TYPE_LATEST})


def log_access() -> None:
    """Has the access log written to standard error, a line of JSON a request."""
    handler = logging.StreamHandler()
    handler.setFormatter(logging.Formatter("%(message)s"))
    access_log.addHandler(handler)
    access_log.setLevel(logging.INFO)
    access_log.propagate = False
