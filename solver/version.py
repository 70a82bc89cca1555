"""The project's version, in one place: a seed means something only with it and the catalog's fingerprint."""

VERSION = "0.30.0"
