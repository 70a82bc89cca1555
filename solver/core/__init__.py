"""The compiled core: C++ in this folder, built to core.wasm (scripts/core.py), run by wasmtime; see host.py."""

from solver.core.host import CoreFailed, CoreInstance, borrowed

__all__ = ["CoreFailed", "CoreInstance", "borrowed"]
