"""Exact answers by general solvers, sharing no code with the placement they judge: slow, plain, and written from the docstrings."""
