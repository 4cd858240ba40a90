# SPDX-License-Identifier: MIT
# make bench: what a highlight costs on a Cortex-M0+ in cycles, and on Cortex-M in bytes, beside what people use today;
# then the host's part, host/host.mk.
# Measurements, no test: nothing here can fail for being slow.
BENCH = build/bench
BENCH_LEVELS = O2 Os
BENCH_SOURCES = $(wildcard lib/*.c tests/bench/*.c tests/bench/*.S)
BENCH_ELFS = $(BENCH_LEVELS:%=$(BENCH)/m0plus-%.elf)
BENCH_NPM = $(BENCH)/npm
BENCH_CC = arm-none-eabi-gcc -std=c99 -mthumb -ffunction-sections -fdata-sections -Ilib

setup-bench:
	@.ci/need "make bench" gcc-arm-none-eabi libnewlib-arm-none-eabi $(BENCH_HOST_PACKAGES)
	@command -v npm >/dev/null || .ci/need "make bench: the emulator rp2040js" nodejs npm
	@+$(SUBMAKE) -s $(BENCH_NPM)/done

# What package-lock.json says, checked by its hashes.
$(BENCH_NPM)/done: tests/bench/package.json tests/bench/package-lock.json
	@rm -rf $(@D) && mkdir -p $(@D) && cp $^ $(@D)
	@npm ci --prefix $(@D) --ignore-scripts --no-audit --no-fund --loglevel=error >$(BENCH)/npm.log 2>&1 || \
		{ tail -5 $(BENCH)/npm.log >&2; echo "make bench: npm could not install rp2040js" >&2; exit 1; }
	@touch $@

bench: ## set up what is missing, measure cycles, code size and the host, print a table and write build/bench/*.json
	@+$(SUBMAKE) setup-bench
	@+$(SUBMAKE) run-bench
	@+$(SUBMAKE) run-bench-host

run-bench: $(BENCH_ELFS) $(BENCH)/sizes.txt
	@node tests/bench/bench.mjs $(BENCH)

$(BENCH)/m0plus-%.elf: $(BENCH_SOURCES) $(wildcard lib/*.h) tests/bench/m0plus.ld tests/bench/bench.mk
	@mkdir -p $(@D)
	@$(BENCH_CC) -mcpu=cortex-m0plus -$* -nostartfiles -T tests/bench/m0plus.ld $(BENCH_SOURCES) -lm -o $@

$(BENCH)/sizes.txt: $(BENCH_ELFS) tests/bench/sizes
	@tests/bench/sizes "$(BENCH_CC)" $(BENCH)/sizes >$@.tmp && mv $@.tmp $@

.PHONY: setup-bench bench run-bench
