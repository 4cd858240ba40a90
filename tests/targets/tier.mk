# SPDX-License-Identifier: MIT
# Tier targets: the library by cross compilers (integers only, no writable data, bounded stack), and run by emulators.
TARGETS_PACKAGES = gcc libc6-dev make python3-minimal gcc-arm-none-eabi gcc-riscv64-unknown-elf gcc-avr avr-libc simavr \
	gcc-xtensa-lx106 qemu-system-arm qemu-system-misc
# BOARD=NAME: that board alone.
TARGETS_FIRMWARE = $(if $(BOARD),$(bare_goal_$(BOARD)),$(BARE_PORTS:%=firmware-%))

setup-targets:
	@.ci/need "tier targets (cross compilers, emulators)" $(TARGETS_PACKAGES)
	@+$(SUBMAKE) -s setup-rp2040js || echo "setup: without rp2040js its machines are skipped" >&2

test-targets: ## check: cross-compiled: no floating point, no writable data, stack; emulated: the host's results; BOARD=NAME: one board
	@+tests/tier targets "$(SUBMAKE)"

run-targets: $(TARGETS_FIRMWARE) $(BOARDS) $(CONFORMANCE_EXPECTED)
	@$(if $(TARGETS_FIRMWARE),,echo "make: there is no board $(BOARD); choose from $(BARE_BOARDS)" >&2; exit 1)
	@PYTHONDONTWRITEBYTECODE=1 TALLY_JOBS=$$(nproc) tests/tally tests/targets/test_boards "tests/targets/test_objects $(BUILD)/targets $(BOARD)" \
		"tests/targets/test_conformance $(BUILD)/targets $(CONFORMANCE_EXPECTED) $(BOARD)"

.PHONY: setup-targets test-targets run-targets
