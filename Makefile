# Every target makes the environment by itself: Python 3.11 or newer and make are all that is needed.
# On Windows, or without make, see "Without make" in README.md.

PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
READY  := $(VENV)/.ready
TESTS  := $(VENV)/.tests
PEERS  := $(VENV)/.peers
UV     := $(BIN)/uv pip install --python $(BIN)/python
WORK   := work
# Nodes and checkers write no bytecode, and with PYTHONDONTWRITEBYTECODE nobody does: each process would compile
# the libraries anew, which takes longer than all else that most of them do.
SITE   := $(VENV)/lib/python*/site-packages
COMPILE := $(BIN)/python -m compileall -qq -j 0
LOCK   := $(BIN)/uv pip compile --universal --generate-hashes --no-emit-index-url --no-emit-find-links \
            --python-version 3.11 --quiet --custom-compile-command "make lock"

.PHONY: help lab grade test test-all lint build bench lock clean

help:
	@echo "make lab       open JupyterLab in work/ with the exercises"
	@echo "make grade     grade the solutions and the untouched exercises, print the gradebook"
	@echo "make test      the tests (under 10 minutes on 2 cores)"
	@echo "make test-all  the tests and the long ones"
	@echo "make lint      ruff and mypy"
	@echo "make build     build the notebooks from their sources"
	@echo "make bench     print the figures that README quotes"

$(READY): requirements-uv.lock requirements.lock pyproject.toml
	@$(PYTHON) -c 'import sys; assert sys.version_info >= (3, 11), "Python 3.11 or newer is needed, this is " + sys.version'
	@echo "Making the environment in $(VENV): $$(grep -c '^[a-z].*==' requirements.lock) packages, about 200 MB to load and 650 MB on the disk, once."
	@$(PYTHON) -m venv $(VENV)
	@$(BIN)/python -m pip install --quiet --require-hashes -r requirements-uv.lock
	@test -t 2 || quiet=--quiet; $(UV) $$quiet --require-hashes -r requirements.lock
	@$(UV) --quiet --no-deps --no-build-isolation -e .
	-@$(COMPILE) simkit grader $(SITE)/numpy $(SITE)/_pytest
	@touch $(READY)

# What only the tests and the developers' tools need, on top of what students have.
$(TESTS): $(READY) requirements-test.lock
	@echo "Adding the tools of the tests: $$(($$(grep -c '^[a-z].*==' requirements-test.lock) - $$(grep -c '^[a-z].*==' requirements.lock))) packages, about 60 MB."
	@test -t 2 || quiet=--quiet; $(UV) $$quiet --require-hashes -r requirements-test.lock
	-@$(COMPILE) $(SITE)
	@touch $(TESTS)

# The terminals of the lab know the commands of ROS.
TERMINALS = --ServerApp.terminado_settings="shell_command=['$(CURDIR)/$(BIN)/simkit','shell','--force']"

# No question at the start whether JupyterLab may fetch news.
SETTINGS = $(VENV)/share/jupyter/lab/settings
NO_NEWS  = {"@jupyterlab/apputils-extension:notification": {"fetchNews": "false", "checkForUpdates": false}}

lab: $(READY)
	@mkdir -p $(SETTINGS) && echo '$(NO_NEWS)' > $(SETTINGS)/overrides.json
	$(BIN)/grader start all
	@test "$$(id -u)" != 0 || test -n "$(findstring allow-root,$(LAB_OPTIONS))" || echo "As root, JupyterLab starts with: make lab LAB_OPTIONS=--allow-root"
	cd $(WORK) && PATH="$(CURDIR)/$(BIN):$$PATH" jupyter lab $(TERMINALS) "Start here.ipynb" $(LAB_OPTIONS)

grade: $(READY)
	$(BIN)/grader grade solutions exercises --out gradebook

test: $(TESTS)
	-@$(COMPILE) simkit grader
	$(BIN)/python -m pytest -n 2 --dist worksteal -m "not slow"

test-all: $(TESTS)
	-@$(COMPILE) simkit grader
	$(BIN)/python -m pytest -n 2 --dist worksteal

lint: $(TESTS)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

build: $(READY)
	$(BIN)/grader build
	$(BIN)/python docs/exercise_list.py
	$(BIN)/python docs/robots/make_pages.py

$(PEERS): $(TESTS) benchmarks/peers.lock
	-$(UV) --quiet --only-binary :all: --require-hashes -r benchmarks/peers.lock
	@touch $(PEERS)

bench: $(READY) $(PEERS)
	@for file in benchmarks/bench_*.py; do $(BIN)/python $$file || exit 1; done

lock: $(READY)
	$(LOCK) pyproject.toml --extra setup -o requirements.lock
	$(LOCK) pyproject.toml --extra setup --extra dev -c requirements.lock -o requirements-test.lock
	echo uv | $(LOCK) - -c requirements.lock -o requirements-uv.lock
	$(LOCK) benchmarks/peers.in -c requirements-test.lock -o benchmarks/peers.lock

clean:
	rm -rf $(VENV) gradebook .mypy_cache .ruff_cache .hypothesis
