"""What the files of the project never hold. The words are put together here, so that this file does not hold them either."""

from __future__ import annotations

import re

from tests.architecture.tree import PACKAGES, ROOT, files

# The project says what it needs; where that comes from is the machine's setting.
REGISTRIES = [
    "py" + "pi.org",
    "python" + "hosted",
    "npm" + "js.org",
    "npm" + "js.com",
    "registry.yarn" + "pkg",
    "crates" + ".io",
    "deb." + "debian.org",
    "conda" + ".io",
    "ghcr" + ".io",
]
MACHINE_PATH = re.compile(r"(?<![\w.)}])/(?:" + "|".join(["wor" + "k", "far" + "m", "roo" + "t", "hom" + "e", "User" + "s"]) + r")/\w")
UNFINISHED = re.compile(r"\b(?:" + "|".join(["TO" + "DO", "FIX" + "ME", "XX" + "X"]) + r")\b")
LEFT_OUT = re.compile(
    r"\bpytest\.(?:mark\.)?(?:sk" + r"ip|xf" + r"ail|import" + r"orskip)|\b(?:it|test|describe)\.(?:sk" + r"ip|only|todo)\b"
)


def lines_with(pattern: re.Pattern[str], *suffixes: str) -> list[str]:
    """Where a pattern occurs in the project's text files: file and line."""
    return [
        f"{path.relative_to(ROOT)}:{number} {line.strip()[:120]}"
        for path in files(*suffixes)
        if not is_binary(path.read_bytes())
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if pattern.search(line)
    ]


def is_binary(content: bytes) -> bool:
    return b"\0" in content[:8000]


def test_no_registry_host_is_named() -> None:
    assert lines_with(re.compile("|".join(map(re.escape, REGISTRIES)), re.IGNORECASE)) == []


def test_no_path_of_a_machine_is_named() -> None:
    assert lines_with(MACHINE_PATH) == []


def test_the_patterns_find_what_they_look_for() -> None:
    assert MACHINE_PATH.search("open('/" + "home/ann/house.yaml')")
    assert not MACHINE_PATH.search("service/home/x and {base}/home/x")
    assert UNFINISHED.search("# TO" + "DO: later")
    assert LEFT_OUT.search("@pytest.mark.sk" + "ip(reason='slow')")
    assert lines_with(re.compile("^# Every version that pyproject"), ".txt")


def test_no_lock_file_of_an_installer_is_kept() -> None:
    assert [path.name for path in files() if path.name in {"uv" + ".lock", "poetry.lock", "Pipfile.lock"}] == []


def test_nothing_is_left_unfinished_or_left_out() -> None:
    assert lines_with(UNFINISHED, ".py", ".ts", ".css", ".html", ".yaml") == []
    assert lines_with(LEFT_OUT, ".py", ".ts") == []


def test_nothing_built_is_kept() -> None:
    built = [path for path in files() if {"static", "node_modules", "__pycache__"} & set(path.relative_to(ROOT).parts)]
    assert built == []
    assert {path.relative_to(ROOT).parts[0] for path in files(".py")} >= set(PACKAGES)
