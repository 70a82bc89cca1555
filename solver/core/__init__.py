"""The compiled core: C++ in this folder, built to core.wasm (scripts/core.py), run by wasmtime; see host.py."""

from solver.core.host import WASM, CoreFailed, CoreFull, CoreInstance, ask, borrowed, load_core, taken

__all__ = ["WASM", "CoreFailed", "CoreFull", "CoreInstance", "ask", "borrowed", "load_core", "taken"]
