# SPDX-License-Identifier: MIT
# Tier exact: the whole domain against an independent oracle (128-bit integers, GMP, MPFR).
EXACT_TESTS = $(patsubst tests/exact/test_%.c,$(BUILD)/tests/exact/test_%,$(wildcard tests/exact/test_*.c))

$(BUILD)/tests/exact/%.o: tests/exact/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Ilib $(OPENMP) $(CFLAGS) -c $< -o $@

$(EXACT_TESTS): %: %.o $(BUILD)/tests/exact/oracle.o $(BUILD)/libglint.a
	$(CC) $(HOST_LDFLAGS) $^ -o $@ -lcmocka -lmpfr -lgmp -lm

setup-exact:
	@.ci/need "tier exact" gcc libc6-dev make libcmocka-dev libgmp-dev libmpfr-dev python3

test-exact: ## the library over its whole domain: 0 wrong
	@+tests/tier exact "$(SUBMAKE)"

run-exact: $(EXACT_TESTS)
	@tests/tally $(EXACT_TESTS) tests/exact/test_tables

# The quick part: every argument from c, every cutoff.
check-exact:
	@+if echo '#include <mpfr.h>' | $(CC) -E - >/dev/null 2>&1 && pkg-config --exists cmocka; then $(SUBMAKE) run-check-exact; \
	else tests/tally "echo ok 1 - tier exact # SKIP cmocka, gmp or mpfr is not installed: make setup-exact"; fi

run-check-exact: $(BUILD)/tests/exact/test_eval $(BUILD)/tests/exact/test_cutoff
	@tests/tally $^ tests/exact/test_tables

.PHONY: setup-exact test-exact run-exact check-exact run-check-exact
