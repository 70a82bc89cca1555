"""Scenes and requests <-> JSON, YAML and objects, losslessly.

Comes in: text, or a document of plain values. Goes out: `Scene` and `Request` objects, documents, text, a JSON Schema.
May import: the ground floor. Not here: rules (validate), where bytes come from (service).

The types of the fields in `solver.scene` (`solver.fields`) drive the reader, the writer and the schema.
"""

from solver.exchange.reader import A_SCENE, SentRoom, SentScene, checked_request, read, read_request, read_scene, scene_schema
from solver.exchange.scene_text import dump_scene
from solver.exchange.text import FORMATS, GLB, dump_plain, dump_text, format_of_file, format_of_name, load_text
from solver.exchange.told_keys import misspelt, tell_keys
from solver.exchange.writer import as_read, write, write_request, write_scene

__all__ = [
    "A_SCENE", "FORMATS", "GLB", "SentRoom", "SentScene", "as_read", "checked_request", "dump_plain", "dump_scene", "dump_text",
    "format_of_file", "format_of_name", "load_text", "misspelt", "read", "read_request", "read_scene", "scene_schema", "tell_keys", "write",
    "write_request", "write_scene",
]  # fmt: skip
