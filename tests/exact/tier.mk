# SPDX-License-Identifier: MIT
# Tier exact: the whole domain against an independent oracle (128-bit integers, GMP, MPFR); the host's batch loops against
# the library. Of the host only batch*.c are linked, so that its packages are not needed.
EXACT_PACKAGES = gcc libc6-dev make libcmocka-dev libgmp-dev libmpfr-dev python3
EXACT_TESTS = $(patsubst tests/exact/test_%.c,$(BUILD)/tests/exact/test_%,$(wildcard tests/exact/test_*.c))
EXACT_CFLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Ilib -Ihost $(OPENMP) $(CFLAGS) $(SANITIZERS)

$(BUILD)/tests/exact/%.o: tests/exact/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(EXACT_CFLAGS) -c $< -o $@

$(BUILD)/tests/exact/host/%.o: host/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(EXACT_CFLAGS) -c $< -o $@

$(BUILD)/tests/exact/test_batch: $(addprefix $(BUILD)/tests/exact/host/models/,batch.o batch_avx2.o batch_portable.o)
$(BUILD)/tests/exact/test_near $(BUILD)/tests/exact/test_near_whole: $(BUILD)/tests/exact/near.o
$(BUILD)/tests/exact/test_pixel: $(addprefix $(BUILD)/tests/exact/,cases.o reference_pixel.o)
$(BUILD)/tests/exact/test_lights: $(addprefix $(BUILD)/tests/exact/,cases.o reference_lights.o reference_pixel.o)
$(BUILD)/tests/exact/test_reach: $(BUILD)/tests/exact/cases.o
$(BUILD)/tests/exact/test_unit: $(addprefix $(BUILD)/tests/exact/,reference_lights.o reference_pixel.o)
$(EXACT_TESTS): %: %.o $(BUILD)/tests/exact/oracle.o $(BUILD)/libglint.a
	$(CC) $(HOST_LDFLAGS) $(filter %.o,$^) $(filter %.a,$^) -o $@ -lcmocka -lmpfr -lgmp -lm

setup-exact:
	@.ci/need "tier exact" $(EXACT_PACKAGES)

test-exact: ## check: the library over its whole domain: 0 wrong
	@+tests/tier exact "$(SUBMAKE)"

# Several at a time, since some of them compile, and of the others not all use every core.
run-exact: $(EXACT_TESTS)
	@CC="$(CC)" OPENMP="$(OPENMP)" TALLY_TIMEOUT=2400 TALLY_JOBS=$$(nproc) OMP_WAIT_POLICY=passive \
		tests/tally tests/exact/test_bounds $(EXACT_TESTS) tests/exact/test_tables

# The quick part: a part of the arguments from c, every cutoff, the bounds of quick forms.
check-exact:
	@+if echo '#include <mpfr.h>' | $(CC) -E - >/dev/null 2>&1 && pkg-config --exists cmocka; then $(SUBMAKE) run-check-exact; \
	else tests/tally "echo ok 1 - tier exact # SKIP cmocka, gmp or mpfr is not installed: make setup-exact"; fi

run-check-exact: $(addprefix $(BUILD)/tests/exact/test_,eval cutoff near pixel unit reach lights)
	@EXACT_EVERY=21 GLINT_PIXELS=3 OMP_WAIT_POLICY=passive TALLY_JOBS=$$(nproc) tests/tally $^ tests/exact/test_tables

.PHONY: setup-exact test-exact run-exact check-exact run-check-exact
