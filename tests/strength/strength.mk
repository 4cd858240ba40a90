# SPDX-License-Identifier: MIT
# How strong the tests are: what the quick ones execute (make coverage), and which faults they notice (make mutants).
STRENGTH_PACKAGES = gcovr
STRENGTH_COUNTED = BUILD=build/coverage CFLAGS='-O0 -g --coverage -fprofile-update=atomic -Dalways_inline=unused' \
	LDFLAGS='$(CURDIR)/build/ends.o -Wl,-u,__gcov_dump,--wrap=_exit,--wrap=setrlimit,--wrap=kill,--wrap=raise'
# As the tests with sanitizers in tier unit: what C does not define ends the program.
STRENGTH_TRAPS = -O1 -fsanitize=undefined -fsanitize-undefined-trap-on-error
# What programs have to say about their counters goes there, not among the messages that tests read.
STRENGTH_ERRORS = GCOV_ERROR_FILE="$(CURDIR)/build/coverage/errors.log"
# Without GLINT_LIBRARY: programs that a test compiles do not link with a library that is counted.
STRENGTH_ENV = UNIT_ENV='GLINT="$(CURDIR)/build/coverage/glint" GLINT_SOURCE="$(CURDIR)"'
STRENGTH_EXACT = $(addprefix tests/exact/test_,eval eval_t cutoff grain pixel unit reach lights)
STRENGTH_UNIT = $(patsubst %.c,%,$(wildcard tests/unit/lib/test_*.c tests/unit/firmware/test_*.c))
# How many mutants, and which: another seed chooses others.
STRENGTH_MUTANTS = $(or $(MUTANTS),440)
STRENGTH_SEED = $(or $(SEED),1)

setup-strength: setup-unit setup-exact
	@.ci/need "make coverage" $(STRENGTH_PACKAGES)

# Not in the folder of what is counted, since it is not.
build/ends.o: tests/strength/ends.c
	@mkdir -p $(@D)
	@$(CC) -std=c11 -D_GNU_SOURCE $(WARNINGS) -O1 -c $< -o $@

# What the programs of the library and portable firmware execute, without the command's tests and those of scripts.
coverage-lib: setup-strength build/ends.o ## check: the same of lib/ and firmware/core/ by their own tests alone (two minutes)
	@+$(SUBMAKE) -s $(STRENGTH_COUNTED) all unit-programs $(STRENGTH_EXACT:%=build/coverage/%)
	@find build/coverage -name '*.gcda' -delete; rm -f build/coverage/errors.log
	@$(PLUS)$(STRENGTH_ERRORS) EXACT_EVERY=100 GLINT_PIXELS=1 \
		GLINT="$(CURDIR)/build/coverage/glint" GLINT_SOURCE="$(CURDIR)" tests/tally $(addprefix build/coverage/,$(STRENGTH_EXACT) $(STRENGTH_UNIT))
	@tests/strength/covered build/coverage

# For lines and branches a few arguments are as good as many.
coverage: setup-strength build/ends.o ## check: which lines and branches of lib/, firmware/core/ and host/ the quick tests execute
	@+$(SUBMAKE) -s $(STRENGTH_COUNTED) all unit-programs $(STRENGTH_EXACT:%=build/coverage/%)
	@find build/coverage -name '*.gcda' -delete; rm -f build/coverage/errors.log
	@$(PLUS)$(STRENGTH_ERRORS) EXACT_EVERY=100 GLINT_PIXELS=1 tests/tally $(STRENGTH_EXACT:%=build/coverage/%)
	@$(PLUS)$(STRENGTH_ERRORS) $(SUBMAKE) -s $(STRENGTH_COUNTED) \
		$(STRENGTH_ENV) UNIT_LONG= run-check-unit || \
		echo "coverage: what failed in this build was counted as far as it went"
	@tests/strength/covered build/coverage

# With slow tests, and what the lab's and the Pico's tests run of the command; one test at a time there, since counters that several kernels
# write would be lost. The Pico's images are built first: they are not counted. Nor are the fuzzers, which are clang's and count otherwise.
coverage-whole: setup-strength setup-exact setup-lab setup-pico build/ends.o ## check: the same with slow tests, and the lab's and the Pico's (30 minutes)
	@+$(SUBMAKE) -s pico-images
	@+$(SUBMAKE) -s $(STRENGTH_COUNTED) LAB_FUZZ= all unit-programs lab-programs $(STRENGTH_EXACT:%=build/coverage/%)
	@find build/coverage -name '*.gcda' -delete; rm -f build/coverage/errors.log
	@$(PLUS)$(STRENGTH_ERRORS) EXACT_EVERY=100 GLINT_PIXELS=1 tests/tally $(STRENGTH_EXACT:%=build/coverage/%)
	@+for goal in "TEST=test_ run-unit" "TALLY_JOBS=1 run-lab" "TALLY_JOBS=1 TEST=test_[ep][no][ds]* run-pico"; do \
		$(STRENGTH_ERRORS) $(SUBMAKE) -s $(STRENGTH_COUNTED) LAB_FUZZ= \
		$(STRENGTH_ENV) $$goal || \
		echo "coverage: what failed in this build was counted as far as it went"; done
	@tests/strength/covered build/coverage

# What mutants are judged by: the objects of make check, which are there or in ccache where somebody works, and no other.
STRENGTH_JUDGES = $(STRENGTH_UNIT) tests/unit/host/test_golden tests/unit/host/test_render_lights $(STRENGTH_EXACT) tests/exact/test_near \
	$(patsubst %.c,%,$(wildcard tests/exact/oracle*.c)) $(addprefix tests/exact/,near cases reference_lights reference_pixel) host/main
strength-objects: $(HOST_ARCHIVES) $(STRENGTH_JUDGES:%=$(BUILD)/%.o)

mutants: setup-strength ## check: how many small faults in lib/ and firmware/core/ the quick tests notice; MUTANTS=440 SEED=1; MINUTES=20: a piece, the next goes on; RETRY=1: survivors again; ONLY=pattern: of these names; JOBS=2: at once
	@+$(CHECK_MAKE) strength-objects
	@COMPILE="$(CC) -Ilib -Ifirmware/core -std=c99 -ffreestanding -fPIC" TRAPS="$(STRENGTH_TRAPS)" COUNTERS="-O1 -g --coverage" JOBS="$(JOBS)" \
		JUDGE="$(CC) $(filter-out -W%,$(HOST_CFLAGS)) -Itests/unit -O0" LINK="-lcmocka -lmpfr -lgmp $(HOST_LDLIBS)" GLINT_SOURCE="$(CURDIR)" \
		tests/strength/mutants build/mutants build/check $(STRENGTH_MUTANTS) $(STRENGTH_SEED) $(MINUTES)

# SECONDS of each sink; memory and descriptors, then and now.
soak: all ## check: do long streams grow? all sinks without a device at once for SECONDS (60): memory and descriptors
	@tests/strength/soak $(BUILD)/glint $(or $(SECONDS),60)

.PHONY: soak setup-strength coverage coverage-lib coverage-whole strength-objects mutants
