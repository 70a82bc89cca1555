"""Files that are whole or not there: written under another name, then renamed."""

import os
from contextlib import suppress
from pathlib import Path


def write_whole(path: str | Path, content: bytes) -> None:
    """Writes a file so that at any time it is the old one or the new one, whole.

    What is no file, such as a pipe or a terminal, is written to as it is; a link is followed.

    Raises:
        OSError: it cannot be written; a file that was there is as before.
    """
    target = Path(path)
    if target.exists() and not target.is_file():
        target.write_bytes(content)
        return
    target = target.resolve()
    part = target.with_name(f"{target.name}.{os.getpid()}.part")
    try:
        part.write_bytes(content)
        if target.exists():
            part.chmod(target.stat().st_mode)
        part.replace(target)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None
    finally:  # Ctrl-C, too, leaves nothing half-written
        with suppress(OSError):  # a disk that is not written to refuses even that, in the other name
            part.unlink(missing_ok=True)
