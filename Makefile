# Compose: `make run` serves it, `make test` tests it. Both bring what they need into .tools/, .venv/ and web/node_modules/;
# this machine needs python3, make and git, and `make test` may ask apt-get for Chromium. `make help` lists the rest.

HOST ?= 127.0.0.1
PORT ?= 8000
PYTHON3 = python3
# The Pythons that every pinned dependency has a wheel for.
PYTHON_VERSIONS = >=3.11,<3.15
WORKERS = auto
PYTEST_ARGS =
BENCH_ARGS =
FUZZ_ARGS =
HOSTILE_ARGS =
LOAD_ARGS =
LEADERBOARD_ARGS =

SHELL = /bin/sh
.DELETE_ON_ERROR:
.DEFAULT_GOAL = help
.PHONY: help run dev test python-tests page-tests compiled-tests targets bench leaderboard fuzz hostile load lint format core page page-bench pictures gallery chromium pins audit wheel clean

# The matrices are small: threads inside BLAS only cost, and a sum's order must not depend on the machine.
export OMP_NUM_THREADS = 1
export OPENBLAS_NUM_THREADS = 1
export MKL_NUM_THREADS = 1
export NUMEXPR_NUM_THREADS = 1
export PYTHONUTF8 = 1
export UV_NO_PROGRESS = 1
export PIP_ROOT_USER_ACTION = ignore
unexport VIRTUAL_ENV PYTHONPATH PYTHONHOME PYTHONDONTWRITEBYTECODE

PY = .venv/bin/python
PINS = pyproject.toml constraints.txt
UV = uv="$$($(PYTHON3) scripts/find_uv.py)" && "$$uv"
INSTALL = $(UV) pip install --quiet --python $(PY) --constraint constraints.txt

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## /  make \1  /p' Makefile

run: .venv/python.stamp ## serve the page and the API on http://127.0.0.1:8000 (HOST=, PORT=)
	@$(MAKE) --no-print-directory --jobs=3 .venv/run.stamp core page
	@exec .venv/bin/compose serve --host $(HOST) --port $(PORT)

dev: .venv/dev.stamp core ## bring Compose, its core and the tools of its tests into .venv/

test: .venv/python.stamp ## run every test: Python, page, browser; some minutes on two cores
	@$(MAKE) --no-print-directory --jobs=4 python-tests page-tests

python-tests: core page compiled-tests chromium
	$(PY) -m pytest -n $(WORKERS) --maxprocesses 8 --dist loadgroup $(PYTEST_ARGS)

# Its one process runs beside Python's tests: before them the other cores would wait for it.
page-tests: core page
	$(PY) scripts/page.py test

compiled-tests: .venv/tests.stamp
	@:

targets: .venv/dev.stamp core page ## run the long checks and benches: thousands of seeds, timings
	$(PY) -m tests.targets

bench: .venv/dev.stamp core ## measure placement against exact oracles and OSQP with heuristics; and a home stage by stage
	$(PY) -m tests.bench $(BENCH_ARGS)
	$(PY) -m tests.bench.flow

leaderboard: .venv/dev.stamp core ## judge our answers to the published benchmark, or a system's: LEADERBOARD_ARGS='--foreign DIR'
	$(PY) -m tests.leaderboard $(LEADERBOARD_ARGS)

fuzz: .venv/dev.stamp core ## place 100,000 random rooms and check each in exact integers
	$(PY) -m tests.bench.fuzz $(FUZZ_ARGS)

hostile: .venv/dev.stamp core ## look for the requests that cost most, and for texts that are answered by a fault
	$(PY) -m tests.hostile $(HOSTILE_ARGS)

load: .venv/dev.stamp core page ## load a service: 32 clients, 20,000 requests, callers that leave or dribble
	$(PY) -m tests.load $(LOAD_ARGS)

lint: .venv/dev.stamp ## check style and types: ruff, mypy, tsc
	$(PY) -m ruff check .
	$(PY) -m ruff format --check .
	$(PY) -m mypy
	$(PY) scripts/page.py check

format: .venv/dev.stamp ## put the Python sources in ruff's format
	$(PY) -m ruff check --fix-only .
	$(PY) -m ruff format .

core: .venv/python.stamp ## build the compiled core, solver/core/core.wasm, where it is not yet
	@$(PY) scripts/core.py build

page: .venv/python.stamp ## build the page into service/static/
	@$(PY) scripts/page.py build

page-bench: .venv/dev.stamp core page chromium ## measure what the page costs: script time, draw calls, bytes
	$(PY) -m tests.browser.bench

pictures: .venv/dev.stamp core page chromium ## take the README's pictures of the page
	$(PY) -m tests.browser.pictures

gallery: .venv/dev.stamp core ## write one home in every format, and a page of pictures, into gallery/
	$(PY) -m scripts.gallery

chromium: .venv/dev.stamp ## bring the Chromium of the browser tests
	@$(PY) -m tests.chromium

pins: ## write constraints.txt anew from pyproject.toml
	{ echo '# Every version that pyproject.toml leads to; `make pins` writes it anew.'; \
	  $(UV) pip compile --quiet --universal --python-version 3.11 --group dev \
	    --no-header --no-annotate pyproject.toml; } > constraints.txt.new
	mv constraints.txt.new constraints.txt

audit: ## ask for known weaknesses of everything that is pinned, where the network allows
	$(UV) tool run --quiet pip-audit==2.10.1 --requirement constraints.txt --no-deps --disable-pip
	cd web && npm audit

wheel: .venv/python.stamp ## build the wheel, with the core and the page in it, into dist/
	$(UV) build --quiet --wheel --python $(PY)

clean: ## remove everything that make brought or built
	rm -rf .venv .tools dist gallery service/static solver/core/core.wasm* web/node_modules .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# An editable install reads the tree: the hook of the wheel would only have the compiler brought, for a build that needs none.
.venv/run.stamp .venv/dev.stamp: export HATCH_BUILD_NO_HOOKS = true

.venv/python.stamp:
	$(UV) venv --quiet --clear --python '$(PYTHON_VERSIONS)' .venv
	@touch $@

.venv/run.stamp: .venv/python.stamp $(PINS)
	$(INSTALL) --editable .
	@touch $@

.venv/dev.stamp: .venv/python.stamp $(PINS)
	$(INSTALL) --editable . --group dev
	@touch $@ .venv/run.stamp

# Collecting compiles the tests and what they import: each worker would do so for itself. Some ask the core.
.venv/tests.stamp: .venv/dev.stamp $(wildcard tests/*.py tests/*/*.py tests/*/*/*.py) | core
	-@$(PY) -m pytest --collect-only -qq > /dev/null
	@touch $@
