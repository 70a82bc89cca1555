"""The service in this process: its calls without processes of their own, its server in a thread, on a free port of this machine."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from threading import Thread
from typing import Any

from service.app import create_app
from service.server import StoppingServer, listening
from service.service_settings import Settings
from service.work import Failure, do, do_alone


class Here:
    """Makes calls in this process."""

    async def start(self, *_: object) -> None:
        """Needs no processes."""

    def stop(self) -> None:
        """Has none."""

    async def run(self, work: Callable[..., Any], *given: Any, **_: bool) -> Any:
        done = do(*given) if work is do_alone else work(*given)
        assert not isinstance(done, Failure), done.trace
        return done


@contextmanager
def served(settings: Settings) -> Iterator[tuple[str, int]]:
    """Answers to every name until the block ends; gives where: host and port."""
    app = create_app(settings=settings)
    app.workers = Here()  # type: ignore[assignment]
    server = StoppingServer(app)
    with closing(listening("127.0.0.1", 0, settings.connections)) as listener:
        thread = Thread(target=server.run, args=([listener],))
        thread.start()
        try:
            yield listener.getsockname()
        finally:
            server.should_exit = True
            thread.join()
