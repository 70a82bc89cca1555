"""The core's host: loads core.wasm once a process, makes instances of it, calls what it exports.

An instance has a memory of its own, one arena from which the core and the host take what they need; it is given back with the instance,
or down to a mark. Instances share nothing: each may be called by one thread at a time, and calls run beside Python's other threads.
"""

import atexit
import contextlib
import ctypes
import functools
from collections import deque
from collections.abc import Callable, Sequence
from itertools import accumulate, chain
from math import prod
from pathlib import Path
from struct import Struct, pack
from struct import error as StructError
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakSet, finalize

if TYPE_CHECKING:
    import numpy as np
    import wasmtime
    from numpy.typing import DTypeLike, NDArray

WASM = Path(__file__).with_name("core.wasm")
FAILURES = {1: "its memory is full", 2: "the request is none", 3: "an index is out of range", 4: "it does not come to an end"}
"""What the core says of why it ended a call: `enum class Failure` of plain/memory.hpp."""
MEMORY_FULL = 1
MOST_BYTES = 1 << 30
"""What a memory may grow to (scripts/core.py)."""
_PLACE = Struct("<2q")
"""Where bytes begin, and how many they are: `SentBytes` of plain/tables.hpp."""
MOST_IDLE = {False: 32, True: 2}
"""Instances kept for the next that asks: small ones, and roomy ones."""
ROOMY_BYTES = 3 << 20
"""An instance whose memory grew beyond this is roomy."""
MOST_IDLE_BYTES = 64 << 20
"""An instance whose memory grew beyond this is not kept."""


class CoreFailed(RuntimeError):
    """A call of the core ended in a trap: an error within it. Its instance is of no further use."""


class CoreFull(CoreFailed, MemoryError):
    """The core asked for more memory than it may have: 1 GB, or what is left to the process."""


class _Export(NamedTuple):
    """A function of the core: how its numbers lie in wasmtime's slots, and whether it returns one: "f64", "i32", "i64" or None."""

    numbers: Struct
    result: str | None


class _Function(NamedTuple):
    """An export of one instance: what wasmtime calls, where its numbers go and its answer comes from, and what writes them there."""

    address: Any
    numbers: Any
    slots: int
    write: Callable[..., None]
    result: str | None


class _Loaded(NamedTuple):
    engine: "wasmtime.Engine"
    module: "wasmtime.Module"
    linker: "wasmtime.Linker"
    exports: dict[str, _Export]


@functools.cache
def _loaded() -> _Loaded:
    """Compiles core.wasm for this machine, 0.3 s of CPU, or takes what wasmtime's cache in the user's cache folder keeps of it."""
    import wasmtime  # noqa: PLC0415 - what only reads types needs no runtime

    if not WASM.exists():
        raise CoreFailed(f"{WASM} is missing: `make core` builds it")
    config = wasmtime.Config()
    config.memory_may_move = False
    config.parallel_compilation = False  # no threads in a process that may fork
    with contextlib.suppress(wasmtime.WasmtimeError):  # a cache that cannot be had is none
        config.cache = True
    engine = wasmtime.Engine(config)
    module = wasmtime.Module.from_file(engine, str(WASM))
    exports = {}
    for export in module.exports:
        if isinstance(export.type, wasmtime.FuncType):
            results = [str(one) for one in export.type.results]
            numbers = "".join("d8x" if str(one) == "f64" else "q8x" for one in export.type.params)
            exports[export.name] = _Export(Struct(f"<{numbers}"), results[0] if results else None)
    return _Loaded(engine, module, wasmtime.Linker(engine), exports)


def load_core() -> None:
    """Loads the core, where this process has not done so yet, so that the first call need not."""
    _loaded()


class _MemoryPiece:
    """A piece of an instance's memory as numpy takes it; the views made of it keep the instance alive."""

    def __init__(self, instance: "CoreInstance", address: int, shape: tuple[int, ...], dtype: "np.dtype[Any]") -> None:
        self.instance = instance
        self.__array_interface__ = {"version": 3, "data": (address, False), "shape": shape, "typestr": dtype.str}


class CoreInstance:
    """One instance of the core, with its own memory.

    Raises:
        CoreFailed: core.wasm is missing.
        CoreFull: the process may have no more memory.
    """

    def __init__(self) -> None:
        import wasmtime  # noqa: PLC0415

        loaded = _loaded()
        self._exports = loaded.exports
        self._store = wasmtime.Store(loaded.engine)
        try:
            self._instance = loaded.linker.instantiate(self._store, loaded.module)
        except wasmtime.WasmtimeError as error:
            raise CoreFull(f"the core's memory could not be set up: {error}") from error
        self._found = self._instance.exports(self._store)
        memory = self._found["memory"]
        assert isinstance(memory, wasmtime.Memory)
        self._base = ctypes.addressof(memory.data_ptr(self._store).contents)
        self._bytes = memoryview((ctypes.c_uint8 * MOST_BYTES).from_address(self._base)).cast("B")  # as far as it may ever grow
        self._context = self._store._context()
        self._functions: dict[str, _Function] = {}
        self._prepare_trap()
        self.failed = False
        self._begin = int(self.call("reserve", 0))  # where the arena begins; its top is moved here without a call
        state = self._base + self.call("state_at")
        self._top, self._size = ctypes.c_uint64.from_address(state), ctypes.c_uint64.from_address(state + 8)
        _alive.add(self)

    def call(self, name: str, *arguments: float) -> Any:
        """Calls an export with whole numbers and addresses, or floats where it takes f64; returns its number, or None.

        Raises:
            CoreFailed: the call ended in a trap, the instance had failed before, or there is no such export with so many numbers.
            CoreFull: it asked for more memory than there is.
        """
        function = self._functions.get(name) or self._function(name)
        if function is None or self.failed:
            raise CoreFailed(f"the core was not asked for {name}: " + ("it failed before" if self.failed else "it has no such function"))
        try:
            function.write(function.numbers, 0, *arguments)
        except StructError as wrong:
            raise CoreFailed(f"the core was not asked for {name}: it has no such function: {wrong}") from None
        error = self._call(self._context, function.address, function.numbers, function.slots, self._trap_address)
        if error or self._trap:
            raise self._failure(name, error)
        return getattr(function.numbers[0], function.result) if function.result else None

    def _function(self, name: str) -> _Function | None:
        """Prepares the calls of an export: wasmtime's public call looks its types up each time and takes 40 us."""
        from wasmtime import _ffi  # noqa: PLC0415

        export = self._exports.get(name)
        if export is None:
            return None
        slots = max(export.numbers.size // ctypes.sizeof(_ffi.wasmtime_val_raw_t), 1)
        address = ctypes.byref(self._found[name]._func)  # type: ignore[union-attr]
        numbers = (_ffi.wasmtime_val_raw_t * slots)()
        function = self._functions[name] = _Function(address, numbers, slots, export.numbers.pack_into, export.result)
        return function

    def _prepare_trap(self) -> None:
        """Makes the place where wasmtime says why a call ended."""
        from wasmtime import _ffi  # noqa: PLC0415

        self._call = _ffi.wasmtime_func_call_unchecked
        self._trap = ctypes.POINTER(_ffi.wasm_trap_t)()
        self._trap_address = ctypes.byref(self._trap)

    def leave(self) -> None:
        """Ends its use without giving back its memory: views of it can be read on, and Python's end need not call wasmtime."""
        self.failed = True
        self._store._consume()

    def _failure(self, name: str, error: Any) -> CoreFailed:
        """Says why a call ended; nothing is asked of the instance after this."""
        from wasmtime import Trap, WasmtimeError  # noqa: PLC0415

        trap = self._trap
        self._prepare_trap()
        said = str(WasmtimeError._from_ptr(error) if error else Trap._from_ptr(trap)).strip().splitlines()[-1].strip()
        code = 0 if name == "failure" else self.call("failure")
        self.failed = True
        kind = CoreFull if code == MEMORY_FULL else CoreFailed
        return kind(f"{name} ended in a trap of the core: {FAILURES.get(code, said)}")

    @property
    def size(self) -> int:
        """The bytes its memory has grown to."""
        return self._size.value

    def reserve(self, size: int) -> int:
        """Takes bytes of the memory; returns their address, a multiple of 16. They are not set to anything.

        Raises:
            CoreFull: there is no more.
        """
        top = self._top.value
        end = top + (size + 15 & -16)
        if size < 0 or self._begin + end > self._size.value or self.failed:  # the core's own does the same, with all its care
            return int(self.call("reserve", size))
        self._top.value = end
        return self._begin + top

    def mark(self) -> int:
        """Returns how much of the memory is taken, for `release`.

        Raises:
            CoreFailed: the instance had failed before.
        """
        if self.failed:
            raise CoreFailed("the core was not asked for its mark: it failed before")
        return int(self._top.value)

    def release(self, mark: int = 0) -> None:
        """Gives back all that was taken since a mark; what views of it show is then void."""
        self._top.value = mark

    def lent(self) -> "NDArray[np.uint8]":
        """Returns the memory as it is now, for views of parts of it; once the last of them is gone, the instance goes to the idle ones.

        All that was taken is then given back, so that nothing else may use the instance at that time.
        """
        import numpy as np  # noqa: PLC0415 - bytes are asked for without it

        piece = _MemoryPiece(self, self._base, (self.size,), np.dtype(np.uint8))
        finalize(piece, _lay_idle, self).atexit = False
        return np.asarray(piece)

    def view(self, address: int, shape: tuple[int, ...], dtype: "DTypeLike") -> "NDArray[Any]":
        """Returns an array that is a piece of the memory: what the core writes there, it shows; it keeps the instance alive.

        Raises:
            ValueError: the piece is not within the memory.
        """
        import numpy as np  # noqa: PLC0415

        kind = np.dtype(dtype)
        if address < 0 or address + prod(shape) * kind.itemsize > self.size:
            raise ValueError(f"{shape} of {kind} at {address} is not within the core's memory")
        return np.asarray(_MemoryPiece(self, self._base + address, shape, kind))

    def write(self, content: bytes) -> int:
        """Takes memory for bytes and copies them there; returns their address."""
        address, size = self.reserve(len(content)), len(content)
        self._bytes[address : address + size] = content
        return address

    def send(self, contents: Sequence[bytes]) -> int:
        """Writes pieces of bytes, each of a multiple of 8, and a list of where they are; returns its address."""
        sizes = [*map(len, contents)]
        begins = accumulate(sizes[:-1], initial=self.write(b"".join(contents)))
        return self.write(pack(f"<{2 * len(sizes)}q", *chain.from_iterable(zip(begins, sizes, strict=False))))

    def told(self, address: int, count: int) -> list[tuple[int, bytes]]:
        """Returns what such a list tells of: addresses, and copies of the bytes."""
        return [(at, self.read(at, size)) for at, size in _PLACE.iter_unpack(self.read(address, _PLACE.size * count))]

    def read(self, address: int, size: int) -> bytes:
        """Returns a copy of bytes of the memory.

        Raises:
            ValueError: they are not within it.
        """
        if address < 0 or size < 0 or address + size > self._size.value:
            raise ValueError(f"{size} bytes at {address} are not within the core's memory")
        return self._bytes[address : address + size].tobytes()


_idle: dict[bool, deque[CoreInstance]] = {False: deque(), True: deque()}
"""Instances that nobody uses, the roomy ones apart, so that few instances ever take much memory."""


_alive: WeakSet[CoreInstance] = WeakSet()
"""All instances that anybody still holds."""


@atexit.register
def _let_go() -> None:
    """Gives back what wasmtime holds while Python can still do so; what somebody still holds is left to the end of the process."""
    for instances in _idle.values():
        instances.clear()
    if held := list(_alive):
        for instance in held:
            instance.leave()
        _loaded().engine._consume()  # what they hold besides
    _loaded.cache_clear()


def taken(roomy: bool = False) -> CoreInstance:
    """Returns an instance with nothing in its memory: an idle one, or a new one; `roomy`: more than a megabyte will be asked of it."""
    try:
        return _idle[roomy].pop()
    except IndexError:
        return CoreInstance()


def _lay_idle(instance: CoreInstance) -> None:
    """Keeps an instance for the next that asks, unless it failed, is large, or there are enough."""
    size = instance.size
    idle = _idle[size > ROOMY_BYTES]
    if len(idle) < MOST_IDLE[size > ROOMY_BYTES] and size <= MOST_IDLE_BYTES and not instance.failed:
        instance.release()
        idle.append(instance)


class _Loan:
    """An instance that is lent for a block; a generator that does the same takes three times as long."""

    def __init__(self, instance: CoreInstance) -> None:
        self._instance = instance

    def __enter__(self) -> CoreInstance:
        return self._instance

    def __exit__(self, error: type[BaseException] | None, *_: object) -> None:
        if error is None:
            _lay_idle(self._instance)


def borrowed(roomy: bool = False) -> _Loan:
    """Lends an instance for a block. What the block took of its memory is given back at its end.

    After an exception the instance is thrown away. No view of its memory may outlive the block. `roomy`: as of `taken`.
    """
    return _Loan(taken(roomy))


def ask(name: str, *contents: bytes, numbers: Sequence[float] = ()) -> bytes:
    """Calls an export that takes bytes, each as their address and size, and then numbers, and answers with bytes.

    Raises:
        CoreFailed: an error within the core; the bytes are no request.
        CoreFull: it takes more memory than there is.
    """
    core, places = taken(), list[int]()
    for content in contents:
        places += core.write(content), len(content)
    told = core.call(name, *places, *numbers)
    answer = core.read(told & 0xFFFFFFFF, told >> 32)
    _lay_idle(core)  # after an exception it is thrown away
    return answer
