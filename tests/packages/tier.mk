# SPDX-License-Identifier: MIT
# Tier packages: lib/ as each build system takes it, built and, where something runs the result, run. Every
# tests/packages/test_* is a script that speaks TAP.
PACKAGES_PACKAGES = cmake gcc g++ clang libc6-dev make pkg-config python3 python3-yaml python3-kconfiglib gcc-arm-none-eabi \
	gcc-riscv64-unknown-elf gcc-xtensa-lx106 gcc-avr avr-libc qemu-system-arm arduino-builder \
	arduino-core-avr simavr
# The longest first.
PACKAGES_TESTS = $(sort $(wildcard tests/packages/test_*))
PACKAGES_LONG = tests/packages/test_arduino tests/packages/test_readme tests/packages/test_two_files

PACKAGES_NPM = build/packages/npm

setup-packages: setup-build
	@.ci/need "tier packages (build systems, a cross compiler, an emulator)" $(PACKAGES_PACKAGES)
	@command -v npm >/dev/null || .ci/need "the parser of GitHub's workflows" $(BENCH_EMULATOR_PACKAGES)
	@+$(SUBMAKE) -s $(PACKAGES_NPM)/done || echo "setup: without @actions/workflow-parser its test is skipped" >&2

# What package-lock.json says, checked by its hashes.
$(PACKAGES_NPM)/done: tests/packages/package.json tests/packages/package-lock.json
	@rm -rf $(@D) && mkdir -p $(@D) && cp $^ $(@D)
	@npm ci --prefix $(@D) --ignore-scripts --no-audit --no-fund --loglevel=error >$(@D)/npm.log 2>&1 || \
		{ tail -5 $(@D)/npm.log >&2; echo "make: npm could not install @actions/workflow-parser" >&2; exit 1; }
	@touch $@

test-packages: ## check: lib/ by CMake, make install-lib and others, on the host and for a Cortex-M3 in QEMU
	@+tests/tier packages "$(SUBMAKE)"

run-packages: all
	@GLINT="$(abspath $(BUILD)/glint)" tests/tally $(PACKAGES_LONG) $(filter-out $(PACKAGES_LONG),$(PACKAGES_TESTS))

.PHONY: setup-packages test-packages run-packages
