# SPDX-License-Identifier: MIT
# The host's part of make bench: million pixels a second of the batch and of what people use today, compiled for the same
# instructions.
BENCH_HOST = $(BENCH)/host
BENCH_NODE_PACKAGES = nodejs
BENCH_HOST_PACKAGES = gcc libc6-dev make libfixmath-dev
BENCH_HOST_CC = $(CC) -std=gnu11 -D_GNU_SOURCE -Wall -Wextra -MMD -MP -Ilib -Ihost -fopenmp-simd
BENCH_AVX2 = $(if $(filter x86_64,$(shell uname -m)),-mavx2 -mfma)
BENCH_HOST_OBJECTS = $(addprefix $(BENCH_HOST)/,host.o floats.o powf.o fixmath.o batch.o batch_avx2.o batch_portable.o) \
	$(patsubst lib/%.c,$(BENCH_HOST)/lib-%.o,$(wildcard lib/*.c))

BENCH_HOST_FLAGS = -O2

setup-bench-host:
	@.ci/need "make bench-host" $(BENCH_HOST_PACKAGES)
	@command -v node >/dev/null || .ci/need "make bench-host" $(BENCH_NODE_PACKAGES)

bench-host: setup-bench-host ## measure: of make bench, the host's part alone
	@+$(SUBMAKE) run-bench-host

run-bench-host: $(BENCH_HOST)/host
	@if grep -q '^flags.* avx2' /proc/cpuinfo || [ -z "$(BENCH_AVX2)" ]; then \
		$< >$(BENCH)/host.txt.tmp && mv $(BENCH)/host.txt.tmp $(BENCH)/host.txt && \
		node tests/bench/host/host.mjs $(BENCH) "$$($(CC) --version | head -1)"; \
	else echo "make bench: this processor has no AVX2: the host's part is left out"; fi

$(BENCH_HOST)/host: $(BENCH_HOST_OBJECTS)
	@$(CC) $(OPENMP) $^ -o $@ -llibfixmath -lm

$(BENCH_HOST)/%.o: tests/bench/host/%.c tests/bench/host/host.mk
	@mkdir -p $(@D)
	@$(BENCH_HOST_CC) $(BENCH_HOST_FLAGS) -c $< -o $@

$(filter $(BENCH_HOST)/batch%,$(BENCH_HOST_OBJECTS)): $(BENCH_HOST)/%.o: host/models/%.c tests/bench/host/host.mk
	@mkdir -p $(@D)
	@$(BENCH_HOST_CC) -O2 -c $< -o $@

$(BENCH_HOST)/lib-%.o: lib/%.c tests/bench/host/host.mk
	@mkdir -p $(@D)
	@$(BENCH_HOST_CC) -O2 -c $< -o $@

$(BENCH_HOST)/host.o: BENCH_HOST_FLAGS += $(OPENMP)
$(BENCH_HOST)/floats.o: BENCH_HOST_FLAGS = -O3 $(BENCH_AVX2)
$(BENCH_HOST)/powf.o: BENCH_HOST_FLAGS = -Ofast $(BENCH_AVX2)

.PHONY: setup-bench-host bench-host run-bench-host
