# groundroll: `make` builds everything and runs the study; `make test` proves it.

PYTHON ?= python3
VENV   ?= .venv
BIN    := $(VENV)/bin
STAMP  := $(VENV)/.installed
EXTRA  ?= dev
DOSE   ?= 100000
# those beside the oldest that is supported, as far as they run here
NEWER  := python3.12 python3.13 python3.14
PYTHONS ?= $(shell for p in $(NEWER); do if $$p -c "" 2>/dev/null; then echo $$p; fi; done)

.DEFAULT_GOAL := study
.PHONY: study derive compile test lint types drift unit pythons release docs bench fuzz clean help

study: compile  ## every table and figure of the thesis, into ./study (the default)
	@echo "running the study ..."
	@$(BIN)/groundroll study --out study

$(STAMP): pyproject.toml
	@echo "making an environment in $(VENV) ..."
	@$(PYTHON) -m venv $(VENV)
	@$(BIN)/python -m pip install --quiet --upgrade pip
	@echo "installing groundroll and what it needs there (about 1 GB, a few minutes) ..."
	@$(BIN)/python -m pip install --progress-bar off --editable ".[$(EXTRA)]" > $(VENV)/install.log \
	    || { cat $(VENV)/install.log; false; }
	@touch $@

derive: $(STAMP)  ## regenerate the equations: generated/ from derive/
	@echo "deriving the equations ..."
	@$(BIN)/python -m groundroll.derive

compile: $(STAMP) derive  ## compile every generated function into the user's cache
	@echo "compiling what is not in the cache yet ..."
	@$(BIN)/python -c "from groundroll.generated import PACKS; [p.compiled(f) for p in PACKS.values() for f in p.functions]"

test: lint types drift docs unit  ## everything that proves it

lint: $(STAMP)  ## style
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(STAMP)  ## static types; mypy sees the folders under their installed names
	rm -rf build/types && mkdir -p build/types/groundroll
	ln -s $(CURDIR)/runtime/* $(CURDIR)/derive $(CURDIR)/generated build/types/groundroll/
	cd build/types && MYPYPATH=. $(CURDIR)/$(BIN)/mypy --config-file $(CURDIR)/pyproject.toml -p groundroll

drift: $(STAMP)  ## generated/ is exactly what derive/ makes
	$(BIN)/python -m groundroll.derive --check

unit: $(STAMP)  ## the test suite, or some of it: make unit TESTS=tests/test_sweep.py
	$(BIN)/python -m pytest -n 2 $(TESTS)

pythons:  ## the same on every newer Python that is found
	@test -n "$(PYTHONS)" || echo "no newer Python is found here"
	set -e; for python in $(PYTHONS); do \
	    $(MAKE) unit PYTHON=$$python VENV=build/venv-$$python EXTRA=test; \
	done

release:  ## what must hold before a version is tagged
	.ci/release

docs: $(STAMP)  ## the documentation, into docs/_build
	$(BIN)/python -m sphinx --fail-on-warning --keep-going -q docs docs/_build

bench: $(STAMP)  ## speed, side by side with other tools; not part of the tests
	$(BIN)/python tests/benchmarks/run.py
	$(BIN)/python tests/benchmarks/explorer.py

fuzz: $(STAMP)  ## attack files, calls, command lines and results: make fuzz DOSE=1000 FUZZ="--only calls"
	cd tests && $(CURDIR)/$(BIN)/python -m fuzz --dose $(DOSE) $(FUZZ)

clean:  ## remove what was built here
	rm -rf build study *.egg-info .mypy_cache .ruff_cache .pytest_cache .hypothesis

help:  ## this list
	@grep -hE '^[a-z]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:.*##/\t/' | expand -t 12
