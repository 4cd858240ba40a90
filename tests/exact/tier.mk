# SPDX-License-Identifier: MIT
# Tier exact: the whole domain against an independent oracle (128-bit, GMP, MPFR).
EXACT = $(patsubst tests/exact/%.c,$(BUILD)/tests/exact/%,$(wildcard tests/exact/test_*.c))

setup-exact:
	@.ci/need "the exact tier" gcc libc6-dev make libcmocka-dev libgmp-dev libmpfr-dev python3-minimal

$(BUILD)/tests/exact/%: tests/exact/%.c tests/exact/oracle.c tests/exact/oracle.h $(BUILD)/libglint.a
	@mkdir -p $(@D)
	$(CC) -std=c11 -D_GNU_SOURCE -Wall -Wextra -Wconversion -Wshadow -Ilib -fopenmp $(CFLAGS) $(LDFLAGS) $(filter %.c %.a,$^) -o $@ -lcmocka -lmpfr -lgmp

test-exact: setup-exact $(EXACT) ## the library over its whole domain: 0 wrong
	@tests/tally $(EXACT) tests/exact/test_tables

.PHONY: setup-exact test-exact
