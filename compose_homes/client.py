"""A client of a Compose service: `Client`, and `AsyncClient` for asyncio; both ask the calls of `client_calls` (here `calls`).

It needs httpx2: pip install compose-homes[client].
"""

import asyncio
import json
import time
from collections.abc import AsyncIterator, Iterator, Mapping
from typing import Any, Final, Self, TypeVar

import httpx2

from compose_homes import client_calls as calls
from compose_homes.client_calls import ServiceCall
from service.kept_contract import JobHead
from solver.errors import ComposeError

T = TypeVar("T")

__all__ = ["AsyncClient", "Client", "ServiceCall", "ServiceRefusal", "calls"]

BUSY: Final = (429, 503)
"""Refusals that another try may end."""
MOST_WAIT_S: Final = 60.0
"""The longest wait before another try, s."""
TIMEOUT_S: Final = 120.0
"""How long an answer may take, s: twice what a service gives a call."""


class ServiceRefusal(ComposeError):
    """What the service refused.

    Args:
        status: of HTTP.
        document: the problem document: `title`, `detail`, `errors`.
        retry_after: when to come back, s, where the service says.
    """

    def __init__(self, status: int, document: Mapping[str, Any], retry_after: float | None = None) -> None:
        self.status, self.retry_after = status, retry_after
        self.title, self.detail = str(document.get("title", "")), str(document.get("detail", ""))
        self.errors: list[dict[str, str]] = list(document.get("errors", ()))
        super().__init__(f"{status} {self.title}: {self.detail}")


class _Asker:
    """What both clients do alike."""

    def __init__(self, retries: int) -> None:
        self._retries = retries

    def _request(self, call: ServiceCall[T]) -> dict[str, Any]:
        headers = {"Accept": "application/json", **({"Content-Type": "application/json"} if call.body is not None else {}), **call.headers}
        query = {name: value for name, value in call.query.items() if value not in ("", [])}
        return {"method": call.method, "url": call.path, "content": call.body, "params": query, "headers": headers}

    def _wait(self, answer: httpx2.Response, tried: int) -> float | None:
        """Returns how long to wait before another try, s, or None where there is to be none."""
        if answer.status_code not in BUSY or tried >= self._retries:
            return None
        said = _seconds(answer)
        return min(1.0 if said is None else said, MOST_WAIT_S)

    def _read(self, call: ServiceCall[T], answer: httpx2.Response) -> T:
        if answer.is_success:
            return call.read(answer.content)
        try:
            document = json.loads(answer.content)
        except ValueError:
            document = {}
        raise ServiceRefusal(answer.status_code, document if isinstance(document, dict) else {}, _seconds(answer))


def _seconds(answer: httpx2.Response) -> float | None:
    said = answer.headers.get("retry-after", "")
    return float(said) if said.isdecimal() else None


def _settings(url: str, key: str | None, timeout: float) -> dict[str, Any]:
    return {"base_url": url, "headers": {"X-API-Key": key} if key else {}, "timeout": timeout}


class Client(_Asker):
    """A client; a context that closes its connections.

    Args:
        url: the service's address.
        key: the caller's, where the service wants one.
        retries: how often a call is tried again that is answered by 429 or 503, after the time that the answer says.
        timeout: how long an answer may take, s.
        transport: of httpx2, instead of the network.
    """

    def __init__(
        self, url: str, key: str | None = None, retries: int = 2, timeout: float = TIMEOUT_S, transport: httpx2.BaseTransport | None = None
    ) -> None:
        super().__init__(retries)
        self._client = httpx2.Client(**_settings(url, key, timeout), transport=transport)

    def ask(self, call: ServiceCall[T]) -> T:
        """Asks, and returns the answer.

        Raises:
            ServiceRefusal: the service refuses.
            httpx2.TransportError: no answer came.
        """
        tried = 0
        while True:
            answer = self._client.request(**self._request(call))
            if (wait := self._wait(answer, tried)) is None:
                return self._read(call, answer)
            time.sleep(wait)
            tried += 1

    def follow(self, job: str) -> Iterator[JobHead]:
        """Yields how far a job is, each time that changes, until it is done or removed.

        Raises:
            ServiceRefusal: there is no such job.
            httpx2.TransportError: the connection ends before.
        """
        with self._client.stream("GET", f"jobs/{job}/events", timeout=TIMEOUT_S) as answer:
            if not answer.is_success:
                answer.read()
                self._read(calls.job(job), answer)
            for line in answer.iter_lines():
                if told := calls.job_told(line):
                    yield told

    def close(self) -> None:
        """Closes its connections."""
        self._client.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class AsyncClient(_Asker):
    """The same for asyncio: `async with AsyncClient(url) as client: await client.ask(...)`. The arguments are those of `Client`."""

    def __init__(
        self,
        url: str,
        key: str | None = None,
        retries: int = 2,
        timeout: float = TIMEOUT_S,
        transport: httpx2.AsyncBaseTransport | None = None,
    ) -> None:
        super().__init__(retries)
        self._client = httpx2.AsyncClient(**_settings(url, key, timeout), transport=transport)

    async def ask(self, call: ServiceCall[T]) -> T:
        """Asks, and returns the answer.

        Raises:
            ServiceRefusal: the service refuses.
            httpx2.TransportError: no answer came.
        """
        tried = 0
        while True:
            answer = await self._client.request(**self._request(call))
            if (wait := self._wait(answer, tried)) is None:
                return self._read(call, answer)
            await asyncio.sleep(wait)
            tried += 1

    async def follow(self, job: str) -> AsyncIterator[JobHead]:
        """Yields how far a job is, each time that changes, until it is done or removed.

        Raises:
            ServiceRefusal: there is no such job.
            httpx2.TransportError: the connection ends before.
        """
        async with self._client.stream("GET", f"jobs/{job}/events", timeout=TIMEOUT_S) as answer:
            if not answer.is_success:
                await answer.aread()
                self._read(calls.job(job), answer)
            async for line in answer.aiter_lines():
                if told := calls.job_told(line):
                    yield told

    async def close(self) -> None:
        """Closes its connections."""
        await self._client.aclose()

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()
