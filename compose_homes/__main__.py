"""`python -m compose_homes` is `compose`."""

import os
import sys


def main() -> int:
    """Runs a command; Ctrl-C before it has begun ends the program without a word."""
    try:
        import gc  # noqa: PLC0415
        import signal  # noqa: PLC0415

        told = signal.signal(signal.SIGINT, lambda *_: os._exit(130))  # raised amid an import it could become any other fault
        from service.cli import main as command  # noqa: PLC0415

        status = command(begin=lambda: signal.signal(signal.SIGINT, told))
        gc.freeze()  # all goes with the process: Python would look through it for cycles, three times
        return status
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
