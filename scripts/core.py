"""Build the core: solver/core/**/*.cpp -> solver/core/core.wasm, with the C++ compiler in PyPI's ziglang.

`python scripts/core.py build`; the wheel's build hook calls the same `build`. `python scripts/core.py check MAIN.cpp PROGRAM` builds a
program for this machine from the core and one more file: every index is checked, undefined behaviour traps. The compiler is fetched into
.tools/zig/ where this Python has none; nothing of it is needed to run what was built.
"""

import hashlib
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

from find_uv import find_uv

ROOT = Path(__file__).resolve().parents[1]
CORE = ROOT / "solver" / "core"
WASM = CORE / "core.wasm"
STAMP = CORE / "core.wasm.built-from"
COMPILER = "ziglang==0.17.1"
COMPILER_FOLDER = ROOT / ".tools" / "zig"
CACHE = ROOT / ".tools" / "zig-cache"
# No fused multiplication and no reassociation: a sum is added in the order it is written in, on every machine.
NUMBERS = ("-ffp-contract=off", "-fno-fast-math")
LANGUAGE = ("-std=c++20", "-fno-exceptions", "-fno-rtti", "-Wall", "-Wextra", "-Werror")
TARGET = ("-target", "wasm32-freestanding", "-mcpu=generic+simd128+bulk_memory", "-O3", "-ffreestanding", "-nostdlib")
# Loops keep the addresses they are written with: offsets then lie in the instructions, which WebAssembly's compilers make no better. With
# that, link-time optimisation gains nothing, makes the module a third larger and its build twice as long (measured).
LOOPS = ("-mllvm", "-disable-lsr")
# What a call may use: 1 MB of stack (below all data: an overflow traps) and 1 GB of memory.
LINK = ("-Wl,--no-entry", "-Wl,-z,stack-size=1048576", "-Wl,--max-memory=1073741824", "-s")
FLAGS = (*TARGET, *LOOPS, *LANGUAGE, *NUMBERS, *LINK)
# The core calls no library of C++ and no helpers of the compiler's, which would be built first and take as long as the core.
ALONE = ("-nostdlib++", "-rtlib=none")
CHECKS = ("-DCORE_CHECKED", "-g", "-O0", "-fsanitize=undefined", "-fsanitize-trap=undefined", "-Wno-unknown-attributes", *ALONE)


def sources() -> list[Path]:
    """Return the core's C++ files, headers too, sorted."""
    return sorted(path for path in CORE.rglob("*") if path.suffix in (".cpp", ".hpp"))


def units() -> list[Path]:
    """Return the files that are compiled each, sorted."""
    return [path for path in sources() if path.suffix == ".cpp"]


def fingerprint() -> str:
    """Return a digest of all the built core comes from: sources, compiler and flags."""
    digest = hashlib.sha256("\0".join((COMPILER, *FLAGS)).encode())
    for path in sources():
        digest.update(path.relative_to(CORE).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()


def is_built() -> bool:
    """Say whether core.wasm is there and came from these very sources."""
    return WASM.exists() and STAMP.exists() and STAMP.read_text() == fingerprint()


def packaged_compiler() -> Path | None:
    """Return the compiler in this Python's own ziglang, else in the fetched one."""
    found = importlib.util.find_spec("ziglang")
    folders = [Path(found.origin).parent] if found and found.origin else []
    named = [folder / name for folder in (*folders, COMPILER_FOLDER / "ziglang") for name in ("zig", "zig.exe")]
    return next((path for path in named if path.exists()), None)


def fetch_compiler() -> Path:
    """Fetch ziglang into .tools/, and return its compiler.

    Raises:
        SystemExit: it could not be fetched.
    """
    print(f"Fetching {COMPILER}, the compiler of the core", flush=True)
    install = [str(find_uv()), "pip", "install", "--quiet", "--python", sys.executable, "--target", str(COMPILER_FOLDER), COMPILER]
    subprocess.run(install, check=False)
    found = packaged_compiler()
    if not found:
        raise SystemExit(f"{COMPILER} could not be fetched: see that pip can reach a package index, and try again")
    return found


def compile_to(target: Path, flags: tuple[str, ...], files: list[Path]) -> None:
    """Compile files to one.

    Raises:
        SystemExit: the compiler refused them; it has said why.
    """
    caches = {name: str(CACHE) for name in ("ZIG_GLOBAL_CACHE_DIR", "ZIG_LOCAL_CACHE_DIR")}
    named = [os.path.relpath(path, ROOT) for path in files]
    command = [str(packaged_compiler() or fetch_compiler()), "c++", *flags, "-I", "solver/core", "-o", str(target), *named]
    if subprocess.run(command, cwd=ROOT, env={**os.environ, **caches}, check=False).returncode:
        raise SystemExit("the core was not compiled")


def joined(folder: Path) -> Path:
    """Return a file that includes all units of a folder; it is written only where its text is new, as the compiler looks when."""
    file = CACHE / "folders" / f"{'_'.join(folder.relative_to(ROOT).parts)}.cpp"
    text = "".join(f'#include "{path.relative_to(CORE).as_posix()}"\n' for path in units() if path.parent == folder)
    if not file.exists() or file.read_text() != text:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return file


def build() -> None:
    """Build core.wasm, unless what is there came from these very sources."""
    if is_built():
        return
    fresh = WASM.with_name(f"core.{os.getpid()}.wasm")
    try:
        compile_to(fresh, FLAGS, units())
        os.replace(fresh, WASM)
    finally:
        fresh.unlink(missing_ok=True)
    STAMP.write_text(fingerprint())


def check(main: str, program: str) -> None:
    """Build a program for this machine that checks what it does, from the core and a file with its `main`.

    Folder by folder: starting the compiler for every file would cost more than what it compiles.
    """
    folders = sorted({path.parent for path in units()})
    compile_to(Path(program).resolve(), (*LANGUAGE, *NUMBERS, *CHECKS), [*map(joined, folders), Path(main).resolve()])


if __name__ == "__main__":
    task, words = sys.argv[1:2], sys.argv[2:]
    if task == ["build"] and not words:
        build()
    elif task == ["check"] and len(words) == 2:
        check(*words)
    else:
        raise SystemExit("usage: core.py build | check MAIN.cpp PROGRAM")
