"""The calls of a Compose service, as values: what is sent, and how the answer is read. `client` sends them.

    from compose_homes.client import Client, calls

    with Client("http://127.0.0.1:8000") as client:
        house = client.ask(calls.generate(Request(seed=3, program="studio")))

Options are the keys of docs/api.md, by their names there.
"""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Generic, TypeVar

from service.contract import FloorAnswer, Lines, PlaceAnswer, ValidateAnswer
from service.kept_contract import HomeHead, HomeList, HomeVersions, HomeWithScene, JobHead, JobList
from solver.answers import Explained, Fixed, FurnishedPlan, Generated, PlanImport
from solver.exchange import read, write_request, write_scene
from solver.request import Request
from solver.scene import Scene

T = TypeVar("T")


@dataclass(frozen=True)
class ServiceCall(Generic[T]):
    """A call of the service.

    Args:
        method: of HTTP.
        path: relative to the service's address.
        read: makes the answer of its body, or of None where it has none.
        body: what is sent, if anything.
        query: of the address.
        headers: beside the usual ones.
    """

    method: str
    path: str
    read: Callable[[bytes], T]
    body: bytes | None = None
    query: Mapping[str, str | int | Sequence[str]] = field(default_factory=dict)
    headers: Mapping[str, str] = field(default_factory=dict)


def _posted(path: str, answer: type[T], document: Mapping[str, Any]) -> ServiceCall[T]:
    return ServiceCall("POST", path, _reader(answer), json.dumps(document).encode())


def _reader(answer: type[T]) -> Callable[[bytes], T]:
    return lambda body: read(answer, json.loads(body), "answer")


def _scene(scene: Scene | Mapping[str, Any]) -> Any:
    return write_scene(scene) if isinstance(scene, Scene) else scene


def generate(request: Request | Mapping[str, Any] | None = None) -> ServiceCall[Generated]:
    """Makes a furnished home."""
    return _posted("generate", Generated, write_request(request) if isinstance(request, Request) else request or {})


def reroll(scene: Scene | Mapping[str, Any], rooms: Sequence[str], seed: int | None = None) -> ServiceCall[Generated]:
    """Furnishes some rooms anew."""
    return _posted("generate", Generated, {"scene": _scene(scene), "reroll": list(rooms), "seed": seed})


def restyle(scene: Scene | Mapping[str, Any], **options: Any) -> ServiceCall[Generated]:
    """Gives a home another `style`, or other decorations (`decorate`)."""
    return _posted("generate", Generated, {"scene": _scene(scene), **options})


def furnish(plan: Scene | Mapping[str, Any], **options: Any) -> ServiceCall[FurnishedPlan]:
    """Furnishes the rooms of a plan."""
    return _posted("furnish", FurnishedPlan, {"scene": _scene(plan), **options})


def fix(scene: Scene | Mapping[str, Any], **options: Any) -> ServiceCall[Fixed]:
    """Repairs a scene with least movement."""
    return _posted("fix", Fixed, {"scene": _scene(scene), **options})


def place(room: Mapping[str, Any], pieces: Sequence[Mapping[str, Any]], **options: Any) -> ServiceCall[PlaceAnswer]:
    """Places pieces in a room."""
    return _posted("place", PlaceAnswer, {"room": room, "pieces": list(pieces), **options})


def validate(scene: Scene | Mapping[str, Any], **options: Any) -> ServiceCall[ValidateAnswer]:
    """Lists which rules a scene breaks."""
    return _posted("validate", ValidateAnswer, {"scene": _scene(scene), **options})


def view(scene: Scene | Mapping[str, Any]) -> ServiceCall[Lines]:
    """Writes a scene for people to read."""
    return _posted("view", Lines, {"scene": _scene(scene)})


def explain(scene: Scene | Mapping[str, Any], piece: str) -> ServiceCall[Explained]:
    """Says why a piece stands where it does."""
    return _posted("explain", Explained, {"scene": _scene(scene), "id": piece})


def floor(scene: Scene | Mapping[str, Any], rooms: Sequence[str] = ()) -> ServiceCall[FloorAnswer]:
    """Says which floor of rooms is clear, kept free, and free to come to."""
    return _posted("floor", FloorAnswer, {"scene": _scene(scene), "rooms": list(rooms)})


def import_plan(content: bytes) -> ServiceCall[PlanImport]:
    """Reads a floor plan's file of another program."""
    return ServiceCall("POST", "import", _reader(PlanImport), content, headers={"Content-Type": "application/octet-stream"})


def export(scene: Scene | Mapping[str, Any], format: str, **options: Any) -> ServiceCall[bytes]:
    """Writes a scene as a file; a ZIP archive where the format has several."""
    return ServiceCall("POST", f"export/{format}", bytes, json.dumps({"scene": _scene(scene), **options}).encode())


def catalog() -> ServiceCall[dict[str, Any]]:
    """Returns all that the service furnishes with."""
    return ServiceCall("GET", "catalog", json.loads)


def save_home(scene: Scene | Mapping[str, Any], name: str = "Home", notes: str = "", tags: Sequence[str] = ()) -> ServiceCall[HomeHead]:
    """Keeps a home; the answer names its `id`."""
    return _posted("homes", HomeHead, {"scene": _scene(scene), "name": name, "notes": notes, "tags": list(tags)})


def list_homes(search: str = "", tags: Sequence[str] = (), limit: int = 20, after: str | None = None) -> ServiceCall[HomeList]:
    """Lists homes, the last changed first; `after` of an answer asks for the next page."""
    query: dict[str, str | int | Sequence[str]] = {"search": search, "limit": limit, "tag": list(tags), "after": after or ""}
    return ServiceCall("GET", "homes", _reader(HomeList), query=query)


def home(id: str) -> ServiceCall[HomeWithScene]:
    """Returns a home with its scene."""
    return ServiceCall("GET", f"homes/{id}", _reader(HomeWithScene))


def change_home(head: HomeHead, **changes: Any) -> ServiceCall[HomeHead]:
    """Changes `name`, `notes`, `tags` or `scene` of a home, unless somebody has changed it since `head` was read."""
    document = {key: _scene(value) if key == "scene" else value for key, value in changes.items()}
    return ServiceCall("PATCH", f"homes/{head.id}", _reader(HomeHead), json.dumps(document).encode(), headers=_revision(head))


def remove_home(head: HomeHead) -> ServiceCall[None]:
    """Removes a home, unless somebody has changed it since `head` was read."""
    return ServiceCall("DELETE", f"homes/{head.id}", lambda _: None, headers=_revision(head))


def home_versions(id: str) -> ServiceCall[HomeVersions]:
    """Lists the versions of a home."""
    return ServiceCall("GET", f"homes/{id}/versions", _reader(HomeVersions))


def add_job(call: str, body: Mapping[str, Any], seeds: Sequence[int] | None = None) -> ServiceCall[JobHead]:
    """Takes on long work: `call` (such as "generate") with a body, or with that body once a seed; the answer names its `id`.

    `Client.follow` tells how far it is.
    """
    return _posted("jobs", JobHead, {"call": call, "body": dict(body), "seeds": None if seeds is None else list(seeds)})


def list_jobs() -> ServiceCall[JobList]:
    """Lists jobs, the newest first."""
    return ServiceCall("GET", "jobs", _reader(JobList))


def job(id: str) -> ServiceCall[JobHead]:
    """Says how far a job is."""
    return ServiceCall("GET", f"jobs/{id}", _reader(JobHead))


def job_result(id: str, number: int) -> ServiceCall[dict[str, Any]]:
    """Returns what one of a job's calls was answered by, from 0: the answer's document, or the problem document of a refusal."""
    return ServiceCall("GET", f"jobs/{id}/results/{number}", json.loads)


def remove_job(id: str) -> ServiceCall[None]:
    """Ends a job and removes it with its results."""
    return ServiceCall("DELETE", f"jobs/{id}", lambda _: None)


def job_told(line: str) -> JobHead | None:
    """Returns how far a job is, from a line of its events; None where the line says nothing of that."""
    document = json.loads(line.removeprefix("data:")) if line.startswith("data:") else {}
    return read(JobHead, document, "answer") if document else None


def _revision(head: HomeHead) -> dict[str, str]:
    return {"If-Match": f'"{head.revision}"'}
