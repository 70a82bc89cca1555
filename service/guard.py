"""Around every answer: security headers, and a problem document where the service itself fails; and who may ask.

Requests whose framing, host or origin tell of an attack on the service, or on those who use it, are refused.
"""

import logging
from collections.abc import Collection, Mapping
from typing import Final
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import ClientDisconnect
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from service.problems import problem, unexpected

PAGE_POLICY: Final = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; connect-src 'self' blob:; "
    "worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
"""What the page may load: its own files, nothing inline, nothing from elsewhere. Pictures within assets are `blob:`s of the page's own."""
WORKER_POLICY: Final = PAGE_POLICY.replace("script-src 'self'", "script-src 'self' 'wasm-unsafe-eval'")
"""What the page's worker may load besides: the core, which is compiled there and nowhere else."""
EMBED_POLICY: Final = PAGE_POLICY.replace("frame-ancestors 'none'", "frame-ancestors *").replace("worker-src 'self'", "worker-src 'none'")
"""What the page of a frame may load: no more than the page; other places may show it, as nothing can be changed in it."""
HEADERS: Final = {
    "Content-Security-Policy": PAGE_POLICY,
    "Cross-Origin-Opener-Policy": "same-origin",
    "Permissions-Policy": "camera=(), geolocation=(), microphone=(), payment=(), usb=()",
    "Referrer-Policy": "same-origin",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}
"""Set on every answer that does not set them itself."""
_log = logging.getLogger("compose.service")


class Guard:
    """The outermost layer of the application."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers one connection."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        started = False

        async def send_guarded(message: Message) -> None:
            nonlocal started
            if message["type"] == "http.response.start":
                started = True
                headers = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    headers.setdefault(name, value)
                if headers["Content-Security-Policy"] == EMBED_POLICY:
                    del headers["X-Frame-Options"]
            await send(message)

        try:
            await self._app(scope, receive, send_guarded)
        except ClientDisconnect:
            _log.info("%s %s: the caller left", scope["method"], scope["path"])
        except Exception:
            _log.exception("%s %s failed", scope["method"], scope["path"])
            if started:
                raise
            await unexpected()(scope, receive, send_guarded)


LOOPBACK: Final = frozenset({"localhost", "127.0.0.1", "::1"})
"""The names that a service on one's own machine answers to. A page elsewhere that has its own name point here is turned away by them."""
READING: Final = frozenset({"GET", "HEAD", "OPTIONS"})
"""Methods that change nothing and cost little."""
ANY: Final = "*"
"""As a host that is allowed: all are."""


class Callers:
    """Lets requests through to the routes that name this service, and come from no foreign page.

    `hosts` are its names, without ports; with `ANY` among them every name is right. `origins` are other places whose pages may ask.
    """

    def __init__(self, app: ASGIApp, hosts: Collection[str], origins: Collection[str] = ()) -> None:
        self._app, self._hosts = app, frozenset(host.lower() for host in hosts)
        self._places = frozenset(_place(origin) for origin in origins)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers one request; HEAD as GET, of which the server leaves out the body."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        answer = self._refusal(scope["method"], Headers(scope=scope)) or self._app
        await answer({**scope, "method": "GET"} if scope["method"] == "HEAD" else scope, receive, send)

    def _refusal(self, method: str, headers: Mapping[str, str]) -> Response | None:
        if "content-length" in headers and "transfer-encoding" in headers:
            return _refused(400, "The request is framed twice", "headers", "Content-Length with Transfer-Encoding", "one of the two")
        host = host_name(headers.get("host", ""))
        if ANY not in self._hosts and host not in self._hosts:
            allowed = ", ".join(sorted(self._hosts))
            return _refused(421, "The service has another name", "Host", f"{host!r:.80} is no name of this service", allowed)
        origin = headers.get("origin")
        if method not in READING and origin is not None and _place(origin) not in {headers.get("host", "").lower(), *self._places}:
            allowed = "pages of this service, or of places that `compose serve --allow-origin` names"
            return _refused(403, "The page that asks is not this service's", "Origin", f"{origin!r:.80} is another place", allowed)
        return None


def host_name(host: str) -> str:
    """The name in a Host header, small letters, without the port and the brackets of an address."""
    try:
        return urlsplit(f"//{host}").hostname or ""
    except ValueError:
        return ""


def _place(origin: str) -> str:
    """The host and port of an origin, as a Host header says them."""
    try:
        return urlsplit(origin).netloc.lower()
    except ValueError:
        return ""


def _refused(status: int, title: str, field: str, what: str, allowed: str) -> Response:
    entry = {"field": field, "problem": what, "allowed": allowed}
    return problem(status, title, f"{field}: {what}; allowed: {allowed}.", [entry])
