"""Generated calls, right and wrong ones: the service keeps to its own OpenAPI document.

The calls are made in this process, and houses are small whatever is asked for: what is tested is what is taken and answered.
CASES=500 in the environment makes 500 of each call. Schemathesis is loaded by the worker that makes them, not by each that collects them.
"""

from __future__ import annotations

import os
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import HealthCheck, settings

import solver
from service.app import create_app
from solver import generate
from solver.answers import Generated
from solver.export_formats import EXPORTERS
from solver.request import Request
from tests.service.heavy import PATIENCE_S
from tests.service.here import Here
from tests.sweeps import times

if TYPE_CHECKING:
    from schemathesis import Case, CheckContext, Response
    from schemathesis.schemas import BaseSchema

CASES = int(os.environ.get("CASES", times(50, 2)))
"""Generated calls of each kind; `make targets` makes more."""
BEYOND_A_SCHEMA = (
    "runs at an angle",  # outlines
    "encloses nothing",
    "the same corner",
    "which another one has too",  # ids
    "which another level has too",
    "is given twice",
    "nothing in the scene has the id",
    "nothing is called",  # what a relation is to
    "no preset is called",
    "is no word for rooms",
    "the one that is dragged",
    "ids of the rooms to furnish anew",  # a scene without a wish
    "is a relation to something",
    "takes no `of`",
    "cannot be",
    "copies counted",
    "is missing, and so is the name",
    "no kind of the catalog",
    "the room has no outline",
    "is not UTF-8",
    "a file of one of the formats",
    "a scene without errors, or without strict",
    "formats that are read here",
    "is not base64",
    "and so is the document",
    "a file in base64, or a document",
    "is under a millimetre",
    "at most one for each of the room's",  # walls' thicknesses, by the outline
    "of inner walls",
    "larger than the house",  # numbers that depend on each other
    "for planned homes",  # an outline beside neither programme nor area
    "no home of this program",  # an outline's corners and a programme
    "than the program has rooms",
    "has no space for",
    "is given beside the outline's corners",
    "a part that is",
    "changes nothing",
    "must be [least, most]",  # a gap from the larger number to the smaller one
)
"""What is wrong with documents that fit their schema: it shows only when keys are seen together, or with the catalog."""


def made_small(request: Request, **more: Any) -> Generated:
    """Makes a house of one room, whatever its size is to be."""
    return generate(replace(request, program=None, area=None, force_types={}, width=4.0, depth=4.0, min_room_size=4.0), **more)


def what_fits_is_taken(_: CheckContext, answer: Response, case: Case[Any]) -> None:
    if case.meta is None or not case.meta.generation.mode.is_positive or answer.status_code < 400:
        return
    if answer.status_code in (404, 409, 428) and case.path.startswith(("/homes", "/jobs")):
        return  # no schema knows what is kept
    assert answer.status_code == 422, answer.text
    for entry in answer.json()["errors"]:
        if case.media_type == "application/yaml" and entry["allowed"].startswith("a text") and entry["problem"] == "is 1e+100":
            continue  # YAML 1.1, which the cases are written in, takes 1e100 without quotes for a text
        assert any(words in f"{entry['problem']} {entry['allowed']}" for words in BEYOND_A_SCHEMA), entry


@pytest.fixture(scope="module")
def schema() -> BaseSchema:
    """The service's document."""
    import schemathesis

    app = create_app()
    app.workers = Here()  # type: ignore[assignment]
    schema = schemathesis.openapi.from_asgi("/openapi.json", app, timeout=PATIENCE_S)
    schema.config.phases.update(phases=["examples", "fuzzing"])
    schema.config.update(request_timeout=PATIENCE_S)
    return schema


@settings(max_examples=CASES, derandomize=True, deadline=None, suppress_health_check=list(HealthCheck))
def is_answered_as_the_document_says(case: Case[Any]) -> None:
    from schemathesis.specs.openapi.checks import positive_data_acceptance

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(solver, "generate", made_small)
        case.call_and_validate(excluded_checks=[positive_data_acceptance], additional_checks=[what_fits_is_taken])


@pytest.mark.usefixtures("schema")
def test_calls_are_answered_as_the_document_says(request: pytest.FixtureRequest) -> None:
    import schemathesis

    schemathesis.pytest.from_fixture("schema").parametrize()(is_answered_as_the_document_says)(request=request)


@pytest.mark.parametrize("name", ["json", *(name for name, exporter in EXPORTERS.items() if exporter.media_type == "application/json")])
def test_every_export_in_json_is_declared(schema: BaseSchema, name: str) -> None:
    body = schema["/export/{format}"]["POST"].definition.raw["requestBody"]["content"]["application/json"]["example"]
    case = schema["/export/{format}"]["POST"].Case(path_parameters={"format": name}, body=body, media_type="application/json")
    assert case.call_and_validate().status_code == 200
