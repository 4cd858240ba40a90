# SPDX-License-Identifier: MIT
# Tier unit: every tests/unit/test_*.c is a cmocka program, linked with all of the host but main.o.
# In the environment of each: GLINT, the command; GLINT_SOURCE, the source folder.
UNIT_TESTS = $(patsubst tests/unit/test_%.c,$(BUILD)/tests/unit/test_%,$(wildcard tests/unit/test_*.c))

$(BUILD)/tests/unit/%.o: tests/unit/%.c
	@mkdir -p $(@D)
	$(CC) $(HOST_CFLAGS) -c $< -o $@

$(BUILD)/tests/unit/test_%: $(BUILD)/tests/unit/test_%.o $(filter-out $(BUILD)/host/main.o,$(HOST_OBJECTS)) $(BUILD)/libglint.a
	$(CC) $(CFLAGS) -fopenmp $(LDFLAGS) $^ -o $@ -lcmocka $(HOST_LDLIBS)

setup-unit: setup-build
	@.ci/need "testing (tier unit)" libcmocka-dev

test-unit: setup-unit ## unit tests of the library and the glint command
	@$(MAKE) --no-print-directory run-unit

run-unit: $(UNIT_TESTS) $(BUILD)/glint
	@GLINT=$(abspath $(BUILD)/glint) GLINT_SOURCE=$(CURDIR) tests/tally $(UNIT_TESTS)

.PHONY: setup-unit test-unit run-unit
.SECONDARY:
