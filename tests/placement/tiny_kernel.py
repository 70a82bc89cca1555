"""A kernel of one function, compiled as the placement's is: as a program it prints what the function returns."""

from __future__ import annotations

from solver.placement.kernel import jit
from solver.placement.kernel.cache import one_compiles

with one_compiles(jit.FOLDER, jit.machine()):

    @jit.compiled(lambda types: types.i8(types.i8))
    def doubled(number: int) -> int:
        """Returns twice a number."""
        return 2 * number


if __name__ == "__main__":
    print(doubled(21))
