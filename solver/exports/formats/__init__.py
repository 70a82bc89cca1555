"""A module a format: each has `write(model, settings) -> files`, and converts the scene's frame once."""
