# SPDX-License-Identifier: MIT
# Fuzzers of what devices parse, and of what the command and the page read: tests/lab/test_fuzz runs them, `make fuzz` longer.
LAB_FUZZ_PACKAGES = clang-14 libclang-rt-14-dev liblz4-dev xz-utils
LAB_FUZZERS = $(patsubst tests/lab/fuzz_%.c,$(BUILD)/tests/lab/fuzz_%,$(wildcard tests/lab/fuzz_*.c))

$(LAB_FUZZERS): $(BUILD)/tests/lab/fuzz_%: tests/lab/fuzz_%.c tests/lab/fuzz.h tests/lab/fuzzer $(wildcard firmware/core/*.[ch] lib/*.[ch]) \
		host/sinks/panel/virtual_panel.c host/sinks/panel/virtual_panel.h $(wildcard host/mesh/*.[ch] host/base/*.[ch])
	LAB_BUILD=$(BUILD) tests/lab/fuzzer $* $@

$(BUILD)/tests/lab/fuzz_imu: $(addprefix firmware/ports/pico/,hand.c hand.h board.h boards.def) $(wildcard tests/lab/sdk/hardware/*.h)

# These are linked with the rest of the host.
LAB_HOST_FUZZERS = $(addprefix $(BUILD)/tests/lab/fuzz_,png svg import stl lights words checkpoint)
$(LAB_HOST_FUZZERS): tests/lab/unwind.h tests/lab/fuzz_child.h host/page/module/stl.c $(HOST_ARCHIVES)

# What the fuzzers start from, an archive each, unpacked.
LAB_SEEDS = $(LAB_FUZZERS:$(BUILD)/tests/lab/fuzz_%=$(BUILD)/tests/lab/seeds/%)
$(LAB_SEEDS): $(BUILD)/tests/lab/seeds/%: tests/lab/seeds/%.tar.xz
	@rm -rf $@ && mkdir -p $@ && tar -xJf $< -C $@ && touch $@

setup-fuzz:
	@.ci/need "fuzzing" $(LAB_FUZZ_PACKAGES)

fuzz: setup-build setup-fuzz ## check: what devices, the command and the page read, fuzzed for SECONDS (600) each; what is new goes to build/fuzz
	@+$(SUBMAKE) run-fuzz
run-fuzz: $(LAB_FUZZERS) $(LAB_SEEDS)
	@for fuzzer in $(LAB_FUZZERS); do name=$${fuzzer##*_} && mkdir -p build/fuzz/$$name && \
		$$fuzzer -max_total_time=$(or $(SECONDS),600) -timeout=300 -max_len=4096 -print_final_stats=1 \
		-artifact_prefix=build/fuzz/ build/fuzz/$$name $(BUILD)/tests/lab/seeds/$$name || exit 1; done

# As few inputs as have all that those do.
fuzz-seeds: $(LAB_FUZZERS) $(LAB_SEEDS) ## maintain: keep what make fuzz has found beside the seeds, the fewest inputs that reach as much (FUZZER=mesh: of one)
	@for name in $(or $(FUZZER),$(notdir $(LAB_SEEDS))); do tests/lab/keep_seeds $(BUILD)/tests/lab/fuzz_$$name tests/lab/seeds/$$name.tar.xz \
		$(BUILD)/tests/lab/seeds/$$name build/fuzz/$$name || exit 1; done

.PHONY: setup-fuzz fuzz run-fuzz fuzz-seeds
