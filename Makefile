# Every target makes the environment by itself: Python 3.11 or newer and make are all that is needed.
# On Windows, or without make, see "Without make" in README.md.

PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
READY  := $(VENV)/.ready
PEERS  := $(VENV)/.peers
WORK   := work

.PHONY: help lab grade test test-all lint build bench lock clean

help:
	@echo "make lab       open JupyterLab in work/ with the exercises"
	@echo "make grade     grade the solutions and the untouched exercises, print the gradebook"
	@echo "make test      the tests (under 10 minutes on 2 cores)"
	@echo "make test-all  the tests and the long ones"
	@echo "make lint      ruff and mypy"
	@echo "make build     build the notebooks from their sources"
	@echo "make bench     print the figures that README quotes"

$(READY): requirements.lock pyproject.toml
	$(PYTHON) -c 'import sys; assert sys.version_info >= (3, 11), "Python 3.11 or newer is needed, this is " + sys.version'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --require-hashes -r requirements.lock
	$(BIN)/python -m pip install --quiet --no-deps --no-build-isolation -e .
	$(BIN)/python -m compileall -q simkit grader  # pip does so for all but what is installed in place
	@touch $(READY)

lab: $(READY)
	$(BIN)/grader start all
	cd $(WORK) && ../$(BIN)/jupyter lab $(LAB_OPTIONS)

grade: $(READY)
	$(BIN)/grader grade solutions exercises --out gradebook

test: $(READY)
	$(BIN)/python -m pytest -n 2 -m "not slow"

test-all: $(READY)
	$(BIN)/python -m pytest -n 2

lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

build: $(READY)
	$(BIN)/grader build
	$(BIN)/python docs/exercise_list.py
	$(BIN)/python docs/robots/make_pages.py

$(PEERS): $(READY) benchmarks/peers.lock
	-$(BIN)/python -m pip install --quiet --only-binary :all: --require-hashes -r benchmarks/peers.lock
	@touch $(PEERS)

bench: $(READY) $(PEERS)
	@for file in benchmarks/bench_*.py; do $(BIN)/python $$file || exit 1; done

lock: $(READY)
	$(BIN)/uv pip compile pyproject.toml --extra dev --universal --generate-hashes --no-emit-index-url \
	  --no-emit-find-links --python-version 3.11 --quiet --custom-compile-command "make lock" -o requirements.lock
	$(BIN)/uv pip compile benchmarks/peers.in -c requirements.lock --universal --generate-hashes --no-emit-index-url \
	  --no-emit-find-links --python-version 3.11 --quiet --custom-compile-command "make lock" -o benchmarks/peers.lock

clean:
	rm -rf $(VENV) gradebook .mypy_cache .ruff_cache .hypothesis
