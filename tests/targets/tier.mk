# SPDX-License-Identifier: MIT
# Tier targets: the library by cross compilers (integers only, no writable data, bounded stack), and run by emulators.
TARGETS_PACKAGES = gcc libc6-dev make python3-minimal gcc-arm-none-eabi gcc-riscv64-unknown-elf gcc-avr avr-libc simavr \
	qemu-system-arm qemu-system-misc

setup-targets:
	@.ci/need "tier targets (cross compilers, emulators)" $(TARGETS_PACKAGES)
	@+$(SUBMAKE) -s setup-rp2040js || echo "setup: without rp2040js its machines are skipped" >&2

test-targets: ## check: cross-compiled: no floating point, no writable data, stack; emulated: the host's results
	@+tests/tier targets "$(SUBMAKE)"

run-targets: firmware-cortex-m firmware-rv32 firmware-avr
	@PYTHONDONTWRITEBYTECODE=1 TALLY_JOBS=$$(nproc) tests/tally "tests/targets/test_objects $(BUILD)/targets" \
		"tests/targets/test_conformance $(BUILD)/targets $(CONFORMANCE_EXPECTED)"

.PHONY: setup-targets test-targets run-targets
