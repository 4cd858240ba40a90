# SPDX-License-Identifier: MIT
# Tier proof: what holds for every argument, decided by z3 from what clang makes of the library, or by running all that is finite.
# Analysis needs the headers of what the host uses, too (setup-build).
PROOF_PACKAGES = gcc libc6-dev make libcmocka-dev clang clang-tidy cppcheck z3 python3
PROOF_BUILD = $(BUILD)/tests/proof

# All of lib/ as one source.
$(PROOF_BUILD)/library.h: tests/proof/library.py lib $(wildcard lib/*.[ch])
	@mkdir -p $(@D)
	tests/proof/library.py >$@.part && mv $@.part $@

$(PROOF_BUILD)/finite.h: $(wildcard tests/proof/*.py lib/*.[ch])
	@mkdir -p $(@D)
	tests/proof/cut.py >$@.part && mv $@.part $@

$(PROOF_BUILD)/test_finite: tests/proof/test_finite.c $(PROOF_BUILD)/finite.h $(PROOF_BUILD)/library.h
	$(CC) -std=c11 -D_GNU_SOURCE $(WARNINGS) -Ilib -I$(PROOF_BUILD) $(OPENMP) $(CFLAGS) $< -o $@ -lcmocka -lm

$(PROOF_BUILD)/test_helium: tests/proof/test_helium.c tests/proof/helium/arm_mve.h $(PROOF_BUILD)/library.h
	$(CC) -std=c11 -D_GNU_SOURCE -O2 -D__ARM_FEATURE_MVE=1 $(WARNINGS) -Ilib -Itests/proof/helium -I$(PROOF_BUILD) $(OPENMP) $(CFLAGS) $< -o $@ -lcmocka -lm

# tests/targets/lines.c by the same stand-in; what is undefined in helium.c traps.
PROOF_HELIUM_LINES = $(CC) -std=c11 -D__ARM_FEATURE_MVE=1 -DLINES_CASES=6000 -Ilib -Itests/proof/helium -Ifirmware/ports/bare
$(PROOF_BUILD)/helium_lines: tests/proof/helium/lines.c tests/proof/helium/arm_mve.h tests/targets/lines.c $(wildcard lib/*.[ch])
	@mkdir -p $(@D)
	$(PROOF_HELIUM_LINES) -O1 -fsanitize=undefined -fsanitize-undefined-trap-on-error -c lib/helium.c -o $@.o
	$(PROOF_HELIUM_LINES) $(filter %.c,$(filter-out lib/helium.c,$^)) $@.o -Wl,--wrap=glint_line_begin -o $@

setup-proof: setup-build
	@.ci/need "tier proof" $(PROOF_PACKAGES)

test-proof: ## check: the library for every argument: values from t, proved
	@+tests/tier proof "$(SUBMAKE)"

run-proof: $(PROOF_BUILD)/test_finite $(PROOF_BUILD)/test_helium $(PROOF_BUILD)/helium_lines $(CONFORMANCE_EXPECTED)
	@HOST_FLAGS="$(filter -std=% -I% -D% -f%,$(HOST_CFLAGS))" HOST_SOURCES="$(HOST_SOURCES)" EXPECTED=$(CONFORMANCE) \
		tests/tally tests/proof/test_static $(addprefix "env FAULTS=1 tests/proof/test_,$(addsuffix ",lobes powers)) \
		"tests/proof/test_faults $(PROOF_BUILD)" $(PROOF_BUILD)/test_finite \
		$(addprefix "env FAULTS=1 tests/proof/test_,$(addsuffix ",msh grain directions claims pixel textures)) \
		$(addprefix tests/proof/test_,lobes powers msh grain directions claims pixel words dsp mesh_words textures) $(PROOF_BUILD)/test_helium $(PROOF_BUILD)/helium_lines

# Frama-C is 1.4 GB, and Eva takes minutes: not part of make test.
PROOF_EVA_PACKAGES = frama-c-base gcc libc6-dev
setup-proof-eva:
	@.ci/need "make proof" $(PROOF_EVA_PACKAGES)

proof: setup-proof setup-proof-eva ## check: tier proof, and Frama-C's Eva over functions of the library with all arguments
	@+$(SUBMAKE) run-proof
	@+$(SUBMAKE) run-proof-eva

run-proof-eva:
	@mkdir -p $(PROOF_BUILD)
	@$(CC) -std=c11 -O2 $(OPENMP) -fsanitize=undefined -fno-sanitize-recover=all -Ilib tests/proof/eva_finite.c lib/*.c \
		-o $(PROOF_BUILD)/eva_finite
	@TALLY_TIMEOUT=14400 tests/tally $(PROOF_BUILD)/eva_finite tests/proof/eva

.PHONY: proof setup-proof-eva run-proof-eva
.PHONY: setup-proof test-proof run-proof
