"""The files for whoever runs the service name settings that there are, and give few rights. Images are not built here."""

from __future__ import annotations

import re
import shlex
from configparser import ConfigParser
from typing import Any

import yaml

from service.cli import parser
from service.keys import KeyRing, read_keys
from service.service_settings import settings_of
from tests.docs.markdown import ROOT, blocks

DEPLOY = ROOT / "docs" / "deploy"


def ours(environment: dict[str, Any]) -> dict[str, str]:
    """The variables of ours, those that are filled in later filled in."""
    found = {name: re.sub(r"\$\{\w+:\?\}", "filled", str(value)) for name, value in environment.items()}
    return {name: value for name, value in found.items() if name.startswith("COMPOSE_HOMES_")}


def test_the_image_runs_without_rights_and_with_settings_that_there_are() -> None:
    text = (DEPLOY / "Dockerfile").read_text()
    stages = text.split("\nFROM ")
    assert re.search(r"^USER [1-9]\d*:[1-9]\d*$", stages[-1], re.MULTILINE)
    (variables,) = re.findall(r"^ENV (.+)$", stages[-1], re.MULTILINE)
    found = settings_of({}, ours(dict(pair.split("=", 1) for pair in shlex.split(variables))))
    assert (found.host, found.port, found.store) == ("0.0.0.0", 8000, "none")
    assert "make wheel" in text and "\nwheel:" in (ROOT / "Makefile").read_text()


def test_the_containers_are_bounded_and_their_settings_are_known() -> None:
    services = yaml.safe_load((DEPLOY / "compose.yaml").read_text())["services"]
    service = services["compose"]
    assert (service["read_only"], service["cap_drop"], service["security_opt"]) == (True, ["ALL"], ["no-new-privileges:true"])
    assert all(port.startswith("127.0.0.1:") for port in service["ports"])
    assert (DEPLOY / service["build"]["context"] / service["build"]["dockerfile"]).is_file()
    found = settings_of({}, ours(service["environment"]))
    assert str(found.store).startswith("postgresql://") and found.client_connections == 0
    assert found.keys_file == f"/run/secrets/{service['secrets'][0]}"
    assert "ports" not in services["database"]


def test_the_unit_starts_the_service_with_few_rights() -> None:
    unit = ConfigParser(strict=False, interpolation=None)
    unit.optionxform = str  # type: ignore[method-assign,assignment]
    unit.read(DEPLOY / "compose.service")
    service = unit["Service"]
    program, *words = service["ExecStart"].split()
    assert program.endswith("/compose")
    options = vars(parser().parse_args(words))
    variables = dict(pair.split("=", 1) for pair in service["Environment"].split())
    assert variables.pop("COMPOSE_HOMES_SETTINGS").startswith("/etc/")
    assert settings_of(options, variables).store == "/var/lib/compose/homes.sqlite"
    assert (service["DynamicUser"], service["ProtectSystem"], service["NoNewPrivileges"]) == ("yes", "strict", "yes")
    assert service["CapabilityBoundingSet"] == ""


def test_the_proxy_hands_on_who_asks_and_logs_no_keys() -> None:
    text = (DEPLOY / "nginx.conf").read_text()
    assert text.count("{") == text.count("}")
    for header in ("Host $host", "X-Forwarded-For $remote_addr", "X-Forwarded-Proto $scheme"):
        assert f"proxy_set_header {header};" in text
    assert "$request " not in text and "$args" not in text


def test_the_keys_that_are_shown_can_be_used() -> None:
    (block,) = blocks("yaml", "keys")
    assert KeyRing(read_keys(block.text.encode())).owner_of("3f8a6c0d9be24d17a5c1e0f2b7d46a90") == "ann"
