# SPDX-License-Identifier: MIT
# Tier exact: the whole domain against an independent oracle (128-bit integers, GMP, MPFR); the host's batch loops against
# the library. Of the host only batch*.c are linked, so that its packages are not needed.
EXACT_PACKAGES = gcc libc6-dev make libcmocka-dev libgmp-dev libmpfr-dev python3
EXACT_CHECK = libcmocka-dev:cmocka.h libgmp-dev:gmp.h libmpfr-dev:mpfr.h
EXACT_TESTS = $(patsubst tests/exact/test_%.c,$(BUILD)/tests/exact/test_%,$(wildcard tests/exact/test_*.c))
EXACT_TESTS += $(addprefix $(BUILD)/tests/exact/test_,unit_wide reach_wide lights_wide)
EXACT_CFLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Ilib -Ihost $(OPENMP) $(CFLAGS) $(SANITIZERS)

$(BUILD)/tests/exact/%.o: tests/exact/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(EXACT_CFLAGS) -c $< -o $@

# The same tests of what products of 64 bits find, as on Cortex-M3 and later, where sums of lights are laid out otherwise: with sanitizers.
EXACT_WIDE_FLAGS = -DGLINT_WIDE=1 -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all
$(BUILD)/tests/exact/test_%_wide.o: tests/exact/test_%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(EXACT_CFLAGS) $(EXACT_WIDE_FLAGS) -c $< -o $@

$(BUILD)/tests/exact/wide/%.o: lib/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(EXACT_CFLAGS) $(EXACT_WIDE_FLAGS) -c $< -o $@

$(BUILD)/tests/exact/host/%.o: host/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(EXACT_CFLAGS) -c $< -o $@

$(BUILD)/tests/exact/test_batch: $(addprefix $(BUILD)/tests/exact/host/models/,batch.o batch_avx2.o batch_portable.o)
$(BUILD)/tests/exact/test_near $(BUILD)/tests/exact/test_near_whole: $(BUILD)/tests/exact/near.o
$(BUILD)/tests/exact/test_pixel $(BUILD)/tests/exact/test_lights $(BUILD)/tests/exact/test_reach: $(addprefix $(BUILD)/tests/exact/,cases.o reference_lights.o reference_pixel.o)
$(BUILD)/tests/exact/test_unit: $(addprefix $(BUILD)/tests/exact/,reference_lights.o reference_pixel.o)
$(BUILD)/tests/exact/test_unit_wide: $(addprefix $(BUILD)/tests/exact/,reference_lights.o reference_pixel.o)
$(BUILD)/tests/exact/test_reach_wide $(BUILD)/tests/exact/test_lights_wide: $(addprefix $(BUILD)/tests/exact/,cases.o reference_lights.o reference_pixel.o)
EXACT_WIDE = $(patsubst lib/%.c,$(BUILD)/tests/exact/wide/%.o,$(wildcard lib/*.c))
$(addprefix $(BUILD)/tests/exact/test_,unit_wide reach_wide lights_wide): $(EXACT_WIDE)
$(addprefix $(BUILD)/tests/exact/test_,unit_wide reach_wide lights_wide): HOST_LDFLAGS += -fsanitize=address,undefined
EXACT_ORACLES = $(patsubst tests/exact/%.c,$(BUILD)/tests/exact/%.o,$(wildcard tests/exact/oracle*.c))
# The folder is a prerequisite so that a removed oracle leaves the programs, too.
$(EXACT_TESTS): %: %.o $(EXACT_ORACLES) $(BUILD)/libglint.a tests/exact
	$(CC) $(HOST_LDFLAGS) $(filter %.o,$^) $(filter %.a,$^) -o $@ -lcmocka -lmpfr -lgmp -lm

setup-exact:
	@.ci/need "tier exact" $(EXACT_PACKAGES)

test-exact: ## check: the library over its whole domain: 0 wrong; MODEL=NAME: one model
	@+tests/tier exact "$(SUBMAKE)"

# MODEL=NAME: what is known of one model, with the pixels of one in seven. The list of models is glint.h's.
ifneq ($(and $(MODEL),$(filter run-exact test-exact,$(MAKECMDGOALS))),)
EXACT_MODELS := $(shell printf '\043include "glint.h"\n\043define NAME(number, name, ...) name\nmodels: GLINT_MODELS(NAME)\n' | \
	$(CC) -Ilib -E -P - | sed -n 's/^models: //p')
$(if $(filter-out $(EXACT_MODELS),$(MODEL))$(word 2,$(MODEL)),$(error MODEL=$(MODEL): unknown model; choose from $(EXACT_MODELS)))
EXACT_TESTS := $(addprefix $(BUILD)/tests/exact/test_,eval eval_t cutoff pixel grain near)
EXACT_RUNS = $(filter-out %/test_near,$(EXACT_TESTS)) "$(BUILD)/tests/exact/test_near every_*"
EXACT_ENV = EXACT_MODEL=$(MODEL) GLINT_PIXELS=$(or $(GLINT_PIXELS),150)
else
EXACT_RUNS = "tests/exact/test_bounds $(BUILD)" $(EXACT_TESTS) tests/exact/test_tables
EXACT_ENV = EXACT_MODEL=
endif

run-exact: $(EXACT_TESTS)
	@CC="$(CC)" HOST_LDFLAGS="$(HOST_LDFLAGS)" $(EXACT_ENV) tests/tally $(EXACT_RUNS)

# The quick part: a part of the arguments from c, of the cutoffs and of the pixels.
check-exact:
	@+if tests/missing "$(CC)" "" "" $(EXACT_CHECK) >/dev/null; then $(SUBMAKE) run-check-exact; \
	else tests/tally "echo ok 1 - tier exact # SKIP cmocka, gmp or mpfr is not installed: make setup-exact"; fi

EXACT_QUICK = $(addprefix $(BUILD)/tests/exact/test_,eval eval_t cutoff pixel grain unit unit_wide reach reach_wide lights lights_wide)
exact-quick-programs: $(EXACT_QUICK)
run-check-exact: exact-quick-programs
	@EXACT_EVERY=21 GLINT_PIXELS=1 tests/tally $(EXACT_QUICK) tests/exact/test_tables

.PHONY: setup-exact test-exact run-exact check-exact exact-quick-programs run-check-exact
