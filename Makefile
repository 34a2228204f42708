# Everything runs from here: `make help`. The only things needed are make, Python 3.11 or newer and a Rust toolchain.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
RUST_SOURCES := Cargo.toml $(wildcard Cargo.lock) pyproject.toml \
	$(shell find crates -path '*/src/*.rs' -o -name Cargo.toml -o -name build.rs)
DOCS_CONFIG := $(wildcard mkdocs.yml)
# How long `make soak` runs each fuzz target; SOAK_POSES says how many poses it compares with brute force.
SOAK_SECONDS ?= 480

# One interpreter for maturin and for cargo, so that neither rebuilds the binding of the other.
export PYO3_PYTHON := $(CURDIR)/$(BIN)/python
export VIRTUAL_ENV := $(CURDIR)/$(VENV)
export PIP_DISABLE_PIP_VERSION_CHECK := 1

# Installs a Debian package where that can be done without asking.
apt_install = { [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null \
	&& apt-get update -qq && apt-get install -y -qq $(1) >/dev/null; }

.DEFAULT_GOAL := help
.PHONY: help demo test soak bench docs fmt lock clean toolchain chromium check-rust check-python

help: ## Show this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "  make %-8s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

demo: $(VENV)/kernel.stamp ## Set everything up and compute the case study (plot and report in build/)
	@mkdir -p build
	$(BIN)/strainwave case-study --plot build/case-study.png --report build/case-study.html --force
	@echo "The backlash distribution of every case is drawn in $(CURDIR)/build/case-study.png"
	@echo "The report, one page to open in a browser, is $(CURDIR)/build/case-study.html"

test: check-rust check-python $(if $(DOCS_CONFIG),docs) ## Formatters, linters, typing, Rust and Python tests

soak: $(VENV)/dev.stamp $(VENV)/kernel.stamp ## An hour of fuzzing, a million poses against brute force, 100 kills of explorations, half an hour in the studio, long random tests
	PROPTEST_CASES=5120 cargo test --release --package strainwave-kernel --quiet
	cargo test --release --package strainwave-kernel --test soak -- --ignored --nocapture
	scripts/fuzz $(SOAK_SECONDS)
	$(BIN)/pytest tests/property tests/studies/test_wizard.py tests/studies/exploration/test_kills.py tests/export/test_step.py tests/studio/test_random_actions.py \
		$(shell grep -rl 'from hypothesis' tests --include='test_*.py') --soak --hypothesis-profile=soak

bench: $(VENV)/dev.stamp $(VENV)/kernel.stamp chromium ## Write every number that the README quotes
	@for script in benchmarks/*.py; do echo "$$script"; $(BIN)/python "$$script" || exit 1; done

docs: $(VENV)/dev.stamp $(VENV)/kernel.stamp ## Build the documentation site into site/
	@test -n "$(DOCS_CONFIG)" || { echo "There is no mkdocs.yml yet."; exit 1; }
	@# The theme announces its successor before every build, which is no warning about these pages.
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --quiet

fmt: toolchain $(VENV)/dev.stamp ## Format Rust and Python, apply the linter's safe fixes
	cargo fmt --all
	$(BIN)/ruff format
	$(BIN)/ruff check --fix

lock: ## Renew the pinned versions in requirements*.txt
	scripts/lock-requirements $(PYTHON)

clean: ## Remove everything that was built or installed here
	rm -rf $(VENV) build site target dist python/strainwave/_kernel*.so .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find python tests benchmarks -name __pycache__ -type d -prune -exec rm -rf {} + 2>/dev/null || true

check-rust: toolchain $(VENV)/python.stamp
	cargo fmt --all --check
	cargo clippy --workspace --all-targets --quiet -- -D warnings
	@# Random tests see the same cases everywhere; make soak lets them draw others.
	PROPTEST_RNG_SEED=1 cargo test --package strainwave-kernel --quiet

check-python: $(VENV)/dev.stamp $(VENV)/kernel.stamp chromium
	$(BIN)/ruff format --check
	$(BIN)/ruff check
	$(BIN)/mypy --strict python tests
	$(BIN)/python -m mypy.stubtest strainwave._kernel --concise
	$(BIN)/pytest --numprocesses auto --dist loadfile

toolchain:
	@cargo fmt --version >/dev/null 2>&1 && cargo clippy --version >/dev/null 2>&1 \
		|| rustup component add rustfmt clippy 2>/dev/null || { \
		echo "cargo has no rustfmt or no clippy. Run 'rustup component add rustfmt clippy'"; \
		echo "or, with Debian's Rust, 'apt install rustfmt rust-clippy'."; exit 1; }

chromium:
	@{ command -v chromium || command -v chromium-browser || command -v google-chrome; } >/dev/null \
		|| $(call apt_install,chromium) \
		|| echo "No Chromium here: the tests of tests/browser will be skipped. On Debian run 'apt install chromium'."

$(VENV)/python.stamp:
	@command -v $(PYTHON) >/dev/null && $(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
		echo "$(PYTHON) is missing or older than 3.11. Install Python 3.11 or newer, or name one: make PYTHON=python3.12"; \
		exit 1; }
	@$(PYTHON) -c 'import venv, ensurepip' 2>/dev/null || $(call apt_install,python3-venv) || { \
		echo "$(PYTHON) has no venv module. On Debian run 'apt install python3-venv', then make again."; exit 1; }
	$(PYTHON) -m venv $(VENV)
	@touch $@

$(VENV)/core.stamp: $(VENV)/python.stamp requirements.txt
	$(BIN)/python -m pip install --quiet --requirement requirements.txt
	@touch $@

$(VENV)/dev.stamp: $(VENV)/core.stamp requirements-dev.txt
	$(BIN)/python -m pip install --quiet --requirement requirements-dev.txt
	@touch $@

$(VENV)/kernel.stamp: $(VENV)/core.stamp $(RUST_SOURCES)
	@cargo --version 2>/dev/null | awk '{split($$2, v, "."); new = v[1] > 1 || v[2] >= 85} END {exit !new}' || { \
		echo "cargo is missing or older than 1.85. Install Rust 1.85 or newer with rustup (or from Debian 13 on:"; \
		echo "apt install cargo), then make again."; exit 1; }
	PATH="$(CURDIR)/$(BIN):$$PATH" $(BIN)/python -m pip install --quiet --no-deps --no-build-isolation --editable .
	@touch $@
