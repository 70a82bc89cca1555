"""Scenes and requests <-> JSON, YAML and objects, losslessly.

Comes in: text, or a document of plain values. Goes out: `Scene` and `Request` objects, documents, text, a JSON Schema.
May import: the ground floor. Not here: rules (validate), where bytes come from (service).

One table, made from the dataclasses of `solver.scene`, drives the reader, the writer and the schema.
"""

from solver.exchange.reader import read_poses, read_request, read_scene
from solver.exchange.schema import request_schema, scene_schema
from solver.exchange.text import FORMATS, dump_text, load_text
from solver.exchange.writer import write_request, write_scene

__all__ = [
    "FORMATS",
    "dump_text",
    "load_text",
    "read_poses",
    "read_request",
    "read_scene",
    "request_schema",
    "scene_schema",
    "write_request",
    "write_scene",
]
