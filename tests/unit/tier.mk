# SPDX-License-Identifier: MIT
# Tier unit: every tests/unit/*/test_*.c is a cmocka program, linked with all of the host but main.o; they run twice, the
# second time under the sanitizers. Every other tests/unit/*/test_* is a script that speaks TAP.
# In the environment of each: GLINT, the command; GLINT_SOURCE, the source folder.
UNIT_TESTS = $(patsubst tests/unit/%.c,$(BUILD)/tests/unit/%,$(wildcard tests/unit/*/test_*.c))
UNIT_SCRIPTS = $(filter-out %.c,$(wildcard tests/unit/*/test_*))
UNIT_COMMON = $(filter-out $(BUILD)/host/main.o,$(HOST_OBJECTS)) $(BUILD)/libglint.a
UNIT_ENV = GLINT="$$(realpath $(BUILD)/glint)" GLINT_SOURCE="$(CURDIR)"

$(BUILD)/tests/unit/%.o: tests/unit/%.c $(BUILD)/flags | $(BUILD)/packages
	@mkdir -p $(@D)
	$(CC) $(HOST_CFLAGS) -Itests/unit -c $< -o $@

$(UNIT_TESTS): %: %.o $(UNIT_COMMON)
	$(CC) $(HOST_LDFLAGS) $< $(UNIT_COMMON) -o $@ -lcmocka $(HOST_LDLIBS)

setup-unit: setup-build
	@.ci/need "tier unit" libcmocka-dev g++ clang libomp-dev gnuplot-nox cmake

test-unit: ## the library and the command: pictures, numbers, messages; sanitizers; compilers agree
	@+tests/tier unit "$(SUBMAKE)"

unit-programs: $(UNIT_TESTS) $(BUILD)/glint

ASAN = build/asan
ASAN_FLAGS = -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
run-unit: unit-programs
	@+$(SUBMAKE) BUILD=$(ASAN) CFLAGS="$(ASAN_FLAGS)" unit-programs
	@+$(UNIT_ENV) TALLY_JOBS=$$(nproc) tests/tally $(UNIT_TESTS) $(UNIT_SCRIPTS) \
		$(patsubst $(BUILD)/%,"env GLINT=$(CURDIR)/$(ASAN)/glint $(ASAN)/%",$(UNIT_TESTS)) \
		"tests/unit/compilers $(BUILD)/compilers $(BUILD)/libglint.a $(SUBMAKE)"

# Without set-up and what takes long.
check-unit:
	@+if pkg-config --exists cmocka; then $(SUBMAKE) run-check-unit; \
	else tests/tally "echo ok 1 - tier unit # SKIP cmocka is not installed: make setup-unit"; fi

run-check-unit: unit-programs
	@$(UNIT_ENV) TALLY_JOBS=$$(nproc) tests/tally $(UNIT_TESTS) $(UNIT_SCRIPTS)

.PHONY: setup-unit test-unit unit-programs run-unit check-unit run-check-unit
