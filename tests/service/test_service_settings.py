"""Settings: from options, environment and file, in that order; refused in words when wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

from service.service_settings import PREFIX, Settings, WrongSetting, all_settings, settings_of
from tests.cli.programs import compose, said


def test_nothing_said_is_all_defaults() -> None:
    assert settings_of({}, {"PATH": "/bin", "COMPOSE_FILE": "docker's own"}) == Settings()


def test_options_go_before_the_environment_and_that_before_the_file(tmp_path: Path) -> None:
    file = tmp_path / "service.yaml"
    file.write_text("port: 1\nwaiting: 1\nrequest_seconds: 1\nallow_host: [a.example]\n")
    environment = {PREFIX + "SETTINGS": str(file), PREFIX + "WAITING": "2", PREFIX + "REQUEST_SECONDS": "2.5"}
    found = settings_of({"port": None, "request_seconds": "3", "allow_host": []}, environment)
    assert found == Settings(port=1, waiting=2, request_seconds=3.0, allow_host=("a.example",))


def test_a_list_is_repeated_or_has_commas() -> None:
    assert settings_of({"allow_host": ["a", "b"]}, {}).allow_host == ("a", "b")
    assert settings_of({}, {PREFIX + "ALLOW_HOST": "a, b"}).allow_host == ("a", "b")


@pytest.mark.parametrize(
    ("options", "environment", "words"),
    [
        ({"port": "65536"}, {}, "--port is 65536; allowed: a whole number from 0 to 65535"),
        ({"port": "http"}, {}, "--port is 'http'"),
        ({}, {PREFIX + "WAITING": "-1"}, PREFIX + "WAITING is -1"),
        ({}, {PREFIX + "REQUEST_SECONDS": ".nan"}, PREFIX + "REQUEST_SECONDS"),
        ({}, {PREFIX + "WAITNG": "3"}, PREFIX + "WAITNG is no setting; there are "),
        ({"host": ""}, {}, "--host"),
        ({"settings": "/none.yaml"}, {}, "the settings cannot be read: no such file: /none.yaml"),
    ],
)
def test_what_is_wrong_is_refused_by_its_name(options: dict[str, object], environment: dict[str, str], words: str) -> None:
    with pytest.raises(WrongSetting) as refused:
        settings_of(options, environment)
    assert words in str(refused.value)


@pytest.mark.parametrize(
    ("content", "words"), [("prt: 80", "prt is not known; port?"), ("[1]", "holds no settings"), ("port: x", ": port is 'x'")]
)
def test_a_wrong_file_is_refused_by_its_keys(tmp_path: Path, content: str, words: str) -> None:
    file = tmp_path / "service.yaml"
    file.write_text(content)
    with pytest.raises(WrongSetting) as refused:
        settings_of({"settings": str(file)}, {})
    assert words in str(refused.value)


def test_help_lists_every_setting_and_a_wrong_one_ends_the_start() -> None:
    listed = compose("serve", "--help").stdout.decode()
    assert [one.option for one in all_settings() if one.option not in listed] == []
    run = compose("serve", "--connections", "none")
    assert run.returncode == 2
    assert said(run).startswith("compose: --connections is 'none'")
