"""Compose's solver: request -> scene, and scene -> repaired scene.

Comes in: a Request or a Scene. Goes out: Generated, Fixed, issues. May import: catalogs. Not here: HTTP and files' names.
"""
