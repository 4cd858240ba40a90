# SPDX-License-Identifier: MIT
# Tier unit: every tests/unit/test_*.c is a cmocka program, linked with all of the host but main.o.
# In the environment of each: GLINT, the command; GLINT_SOURCE, the source folder.
UNIT_TESTS = $(patsubst tests/unit/test_%.c,$(BUILD)/tests/unit/test_%,$(wildcard tests/unit/test_*.c))
UNIT_COMMON = $(filter-out $(BUILD)/host/main.o,$(HOST_OBJECTS)) $(BUILD)/libglint.a

$(BUILD)/tests/unit/%.o: tests/unit/%.c $(BUILD)/flags | $(BUILD)/packages
	@mkdir -p $(@D)
	$(CC) $(HOST_CFLAGS) -c $< -o $@

$(UNIT_TESTS): %: %.o $(UNIT_COMMON)
	$(CC) $(HOST_LDFLAGS) $< $(UNIT_COMMON) -o $@ -lcmocka $(HOST_LDLIBS)

setup-unit: setup-build
	@.ci/need "tier unit" libcmocka-dev

test-unit: ## unit tests of the library and the glint command
	@+tests/tier unit "$(SUBMAKE)"

unit-programs: $(UNIT_TESTS) $(BUILD)/glint

run-unit: unit-programs
	@GLINT="$$(realpath $(BUILD)/glint)" GLINT_SOURCE="$(CURDIR)" tests/tally $(UNIT_TESTS)

check-unit:
	@+if pkg-config --exists cmocka; then $(SUBMAKE) run-unit; \
	else tests/tally "echo ok 1 - tier unit # SKIP cmocka is not installed: make setup-unit"; fi

.PHONY: setup-unit test-unit unit-programs run-unit check-unit
