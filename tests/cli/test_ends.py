"""How commands end where the world is against them: words and an exit status, never a trace."""

from __future__ import annotations

import os
import shlex
import signal
import subprocess
from pathlib import Path

import pytest

from service.cli import INTERRUPTED, main
from service.many import BATCH
from service.pool import AHEAD
from tests.cli.programs import GUARD_S, PROGRAM, ROOT, is_gone, said, started, until

SCENE = b'{"rooms": [{"id": "den", "width": 4, "depth": 3}]}'

STARTS_LATE = """
import os, sys, time
from functools import partial
from pathlib import Path
from service.pool import spread

HERE = Path(sys.argv[1])
if __name__ == "__mp_main__":
    try:
        (HERE / "first").touch(exist_ok=False)
    except FileExistsError:  # the second process: who starts it waits until it has read what it is sent, more than a pipe holds
        (HERE / "second").touch()
        while not (HERE / "told").exists():
            time.sleep(0.01)

def work(number):
    (HERE / "pid.part").write_text(str(os.getpid()))
    (HERE / "pid.part").rename(HERE / "pid")
    time.sleep(600)

def start(_):
    pass

if __name__ == "__main__":
    try:
        list(spread(work, range(9), 2, partial(start, bytes(1 << 20))))
    except KeyboardInterrupt:
        sys.exit(130)
"""


def in_shell(words: str, given: bytes = SCENE, **environment: str) -> subprocess.CompletedProcess[bytes]:
    """Runs a command with the shell's redirections; HOME is left out where it is said to be empty."""
    command = f"{shlex.join(PROGRAM)} {words}"
    known = {**os.environ, **environment}
    known = {name: value for name, value in known.items() if name != "HOME" or value}
    return subprocess.run(["sh", "-c", command], input=given, capture_output=True, check=False, timeout=GUARD_S, cwd=ROOT, env=known)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("validate <&-", "compose: standard input is closed"),
        ("view >&-", "compose: standard output is closed"),
        ("view >/dev/full", "compose: the disk is full"),
    ],
)
def test_what_cannot_be_read_or_written_is_said(words: str, told: str) -> None:
    run = in_shell(words)
    assert run.returncode == 2
    assert said(run) == f"{told}\n"


def test_a_closed_standard_error_takes_no_words_into_the_output() -> None:
    run = in_shell("validate /nowhere/at/all 2>&-")
    assert (run.returncode, run.stdout) == (2, b"")


def test_nobody_needs_a_home() -> None:
    there, gone = (in_shell("generate --seed 1 --width 5 --depth 4", HOME=home) for home in ("", "/nowhere/at/all"))
    assert there.returncode == gone.returncode == 0
    assert there.stdout == gone.stdout != b""


@pytest.mark.parametrize("workers", ["1", "2"])
def test_ctrl_c_ends_any_number_of_homes(tmp_path: Path, workers: str) -> None:
    """A terminal tells it to all processes of the command."""
    command = [*PROGRAM, "generate", "--seed", "1", "--width", "4", "--depth", "4", "-n", "100000000", "--workers", workers]
    with started(*command, "-o", str(tmp_path), stderr=subprocess.PIPE) as run:
        until(lambda: bool(list(tmp_path.glob("*.yaml"))) or run.poll() is not None)
        os.killpg(run.pid, signal.SIGINT)
        _, words = run.communicate(timeout=GUARD_S)
    assert run.returncode == INTERRUPTED
    assert "Traceback" not in words
    assert words.rstrip().endswith("compose: ended")
    assert list(tmp_path.glob("*.part")) == []
    assert len(list(tmp_path.glob("*.yaml"))) < 100_000 > int(workers) * BATCH * AHEAD


def test_a_process_that_is_just_starting_ends_with_the_others(tmp_path: Path) -> None:
    (tmp_path / "jobs.py").write_text(STARTS_LATE)
    command = (PROGRAM[0], str(tmp_path / "jobs.py"), str(tmp_path))
    with started(*command, env={**os.environ, "PYTHONPATH": str(ROOT)}) as run:
        until(lambda: ((tmp_path / "pid").exists() and (tmp_path / "second").exists()) or run.poll() is not None)
        assert run.poll() is None
        run.send_signal(signal.SIGTERM)
        first = int((tmp_path / "pid").read_text())
        until(lambda: is_gone(first))
        (tmp_path / "told").touch()
        assert run.wait(GUARD_S) == INTERRUPTED


def test_ctrl_c_while_a_command_begins(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> None:
    def interrupted(_: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr("service.commands.run", interrupted)
    monkeypatch.setattr("service.standard_streams.give_up_output", lambda: None)
    assert main(["schema"]) == INTERRUPTED
    assert capfd.readouterr().err == "compose: ended\n"


def test_ctrl_c_before_a_command_has_begun_is_silent(tmp_path: Path) -> None:
    """Each time at the import of another module, such as the first of the package's own."""
    inside = "import os, signal, sys; from compose_homes.__main__ import main"
    hook = "sys.addaudithook(lambda name, args: name == 'import' and args[0] == %r and os.kill(os.getpid(), signal.SIGINT))"
    for module in ("signal_of_nobody", "service", "service.cli", "argparse", "service.commands", "pathlib"):
        code = f"{inside}; {hook % module}; sys.argv = ['compose', 'schema']; sys.exit(main())"
        run = subprocess.run([PROGRAM[0], "-c", code], capture_output=True, check=False, timeout=GUARD_S, cwd=ROOT)
        assert (run.returncode, run.stderr) == ((0, b"") if module == "signal_of_nobody" else (INTERRUPTED, b"")), module


def test_the_command_starts_with_nothing_that_takes_time() -> None:
    code = "import sys; before = set(sys.modules); import compose_homes.__main__; print(sorted(set(sys.modules) - before))"
    run = subprocess.run([PROGRAM[0], "-c", code], capture_output=True, check=True, timeout=GUARD_S, cwd=ROOT)
    assert run.stdout.decode().strip() == "['compose_homes', 'compose_homes.__main__']"


def test_a_folder_that_may_not_be_written_in_keeps_what_it_has(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    kept = tmp_path / "house.txt"
    kept.write_text("as it was")
    tmp_path.chmod(0o555)
    try:
        status = main(["schema", "-o", str(kept)])
        if os.geteuid() != 0:  # nothing keeps root out
            assert status == 2
            assert capfd.readouterr().err == f"compose: {kept}: may not be read or written here\n"
            assert kept.read_text() == "as it was"
    finally:
        tmp_path.chmod(0o755)
