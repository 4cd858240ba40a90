# SPDX-License-Identifier: MIT
# Tier targets: the library by cross compilers (integers only, no writable data, bounded stack), and run by emulators.
TARGETS_PACKAGES = $(sort gcc libc6-dev libcmocka-dev make python3-minimal simavr qemu-system-arm qemu-system-misc libnewlib-arm-none-eabi \
	$(foreach port,$(BARE_PORTS),$($(port)_PACKAGES)))
# BOARD=NAME: that board alone.
TARGETS_FIRMWARE = $(if $(BOARD),$(bare_goal_$(BOARD)),$(BARE_PORTS:%=firmware-%))

setup-targets: setup-build
	@.ci/need "tier targets (cross compilers, emulators)" $(TARGETS_PACKAGES)
	@+$(SUBMAKE) -s setup-rp2040js || echo "setup: without rp2040js its machines are skipped" >&2

test-targets: ## check: cross-compiled: no floating point, no writable data, stack; emulated: the host's results; BOARD=NAME: one board
	@+tests/tier targets "$(SUBMAKE)"

# Those with lines of their own compare them with C's.
TARGETS_LINES = "tests/targets/test_lines $(BUILD)/targets $(BOARD)"
# The table of costs is of all boards, so that one board's run leaves it; and the bunny, whose mesh lies beside rp2040js.
TARGETS_COSTS = $(if $(BOARD),,"tests/targets/test_costs $(BENCH)" "tests/targets/test_twins $(BENCH)" "tests/targets/test_bunny $(BUILD)/glint $(TARGETS_VIEWS)")
TARGETS_VIEWS = $(BUILD)/tests/unit/slow/test_mesh_views
TARGETS_COSTS_INPUTS = $(filter-out %-Os.elf,$(BENCH_ELFS)) $(BENCH_MESH_ELFS) $(BENCH_SCENE)/scene.json

costs: ## measure: write the table that tier targets compares cycles and sizes with (costs.tsv), and the documents' tables of it; ROWS=PATTERN
	@.ci/need "make costs" $(BENCH_PACKAGES)
	@+$(SUBMAKE) -s setup-rp2040js && $(SUBMAKE) write-costs ROWS='$(value ROWS)'

# By a make of its own, which sees what is installed.
write-costs: $(TARGETS_COSTS_INPUTS) $(BOARDS) $(BENCH_IMAGES)
	@PYTHONDONTWRITEBYTECODE=1 BENCH_BOARDS="$(BENCH_BOARDS)" tests/targets/test_costs $(BENCH) write '$(value ROWS)'; worse=$$?; \
		tests/bench/tables write && exit $$worse

run-targets: $(if $(BOARD),,$(TARGETS_COSTS_INPUTS) $(TARGETS_VIEWS)) $(TARGETS_FIRMWARE) $(BOARDS) $(CONFORMANCE_EXPECTED)
	@$(if $(TARGETS_FIRMWARE),,echo "make: there is no board $(BOARD); choose from $(BARE_BOARDS)" >&2; exit 1)
	@PYTHONDONTWRITEBYTECODE=1 BENCH_BOARDS="$(BENCH_BOARDS)" tests/tally "tests/targets/test_objects $(BUILD)/targets $(BOARD)" $(TARGETS_LINES) \
		"tests/targets/test_conformance $(BUILD)/targets $(CONFORMANCE_EXPECTED) $(BOARD)" $(TARGETS_COSTS) \
		$(if $(BOARD),,"tests/targets/test_big_endian $(BUILD)/targets") tests/targets/test_boards

.PHONY: costs write-costs setup-targets test-targets run-targets
