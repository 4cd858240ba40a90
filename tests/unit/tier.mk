# SPDX-License-Identifier: MIT
# Tier unit: every tests/unit/*/test_*.c is a cmocka program, linked with all of the host but main.o, built with sanitizers or
# plain. Every other tests/unit/*/test_* is a script that speaks TAP.
# In the environment of each: GLINT, the command; GLINT_SOURCE, the source folder; GLINT_LIBRARY, the library, but for one with
# sanitizers, with which programs that a test compiles do not link.
# GMP and MPFR: model_added builds programs of tier exact.
UNIT_PACKAGES = libqoi-dev libopenmpi-dev openmpi-bin libcmocka-dev libgmp-dev libmpfr-dev g++ clang libomp-dev gnuplot-nox cmake groff-base zsh gcc-12-plugin-dev
# What make check runs needs these, and a part of it those.
UNIT_CHECK = libcmocka-dev:cmocka.h libqoi-dev:qoi.h
UNIT_CHECK_PART = libusb-1.0-0-dev:libusb-1.0/libusb.h libgpiod-dev:gpiod.h libinih-dev:ini.h libchafa-dev:chafa/chafa.h \
	librsvg2-dev:librsvg-2.0/librsvg/rsvg.h libassimp-dev:assimp/version.h libjpeg-dev:jpeglib.h libwebp-dev:webp/mux.h libgif-dev:gif_lib.h g++:g++ groff-base:groff zsh:zsh
# Flags of the tests' own code, after those of all. Tests of host/ and firmware/ are sooner compiled than optimized, those of lib/ have models that
# draw much; what is tested keeps its own flags. Of what sanitizers put in gcc warns, too, at -O0: -w.
UNIT_CFLAGS ?= $(UNIT_CFLAGS_$(word 3,$(subst /, ,$<)))
UNIT_CFLAGS_host = -O0 -g1 $(if $(SANITIZERS),-w)
UNIT_CFLAGS_firmware = $(UNIT_CFLAGS_host)
UNIT_CFLAGS_lib = -O1 -g1
UNIT_CHOSEN = $(wildcard tests/unit/*/test_*.c)
UNIT_ALL := $(UNIT_CHOSEN:tests/unit/%.c=$(BUILD)/tests/unit/%)
ifneq ($(TEST),)
UNIT_CHOSEN := $(filter $(wildcard tests/unit/*/*$(TEST)*),$(UNIT_CHOSEN))
endif
UNIT_TESTS = $(patsubst tests/unit/%.c,$(BUILD)/tests/unit/%,$(UNIT_CHOSEN))
# What make check leaves to make test-unit: slow/, and of what also runs with sanitizers these, of two seconds or more each.
UNIT_LONG = $(addprefix $(BUILD)/tests/unit/host/test_,bake material mesh_files mesh_readers output paper reference search stream terminal)
UNIT_SANITIZABLE = $(filter-out $(BUILD)/tests/unit/slow/%,$(UNIT_TESTS))
UNIT_QUICK = $(filter-out $(UNIT_LONG),$(UNIT_SANITIZABLE))
UNIT_SCRIPTS = $(filter-out %.c,$(wildcard tests/unit/*/test_*))
UNIT_QUICK_SCRIPTS = $(filter-out tests/unit/slow/%,$(UNIT_SCRIPTS))
UNIT_ENV = GLINT="$$(realpath $(BUILD)/glint)" GLINT_SOURCE="$(CURDIR)" \
	GLINT_LIBRARY="$(if $(SANITIZERS),,$$(realpath $(BUILD)/libglint.a))"
UNIT_SANITIZED = build/sanitized
# Scripts that build: what they are given.
UNIT_BUILDERS = "tests/unit/compilers $(BUILD)/compilers $(BUILD)/libglint.a $(SUBMAKE) TEST=" \
	"tests/unit/model_added $(BUILD)/model_added $(SUBMAKE) TEST="

$(BUILD)/tests/unit/%.o: tests/unit/%.c $(BUILD)/flags | $(BUILD)/packages
	@mkdir -p $(@D)
	$(CC) $(HOST_CFLAGS) -Itests/unit $(UNIT_CFLAGS) -c $< -o $@

$(UNIT_ALL): %: %.o $(HOST_ARCHIVES)
	$(CC) $(HOST_LDFLAGS) $< $(HOST_ARCHIVES) -o $@ -lcmocka $(HOST_LDLIBS) $(if $(WITH_WEBP),-lwebpdemux)

setup-unit: setup-build
	@.ci/need "tier unit" $(UNIT_PACKAGES)

test-unit: ## check: the library and the command: pictures, numbers, messages; sanitizers; compilers agree
	@+tests/tier unit "$(SUBMAKE)"

unit-programs: $(UNIT_TESTS) $(BUILD)/glint
unit-sanitizable-programs: $(UNIT_SANITIZABLE) $(BUILD)/glint
unit-quick-programs: $(UNIT_QUICK) $(BUILD)/glint

# With TEST or SANITIZE only what they say; else everything with sanitizers but for what is slow, and plain what make check leaves
# out and what tests the library, which compilers optimize most. What takes longest begins first, so that it does not end alone.
# CCACHE_DEPEND: what has flags that nothing else has is not looked for by a run of the preprocessor, too.
UNIT_PLAIN = $(filter $(BUILD)/tests/unit/slow/% $(BUILD)/tests/unit/lib/% $(UNIT_LONG),$(UNIT_TESTS))
run-unit: $(if $(TEST)$(filter 1,$(SANITIZE)),$(UNIT_TESTS),$(UNIT_PLAIN)) $(BUILD)/glint
ifneq ($(TEST)$(filter 1,$(SANITIZE)),)
	@$(PLUS)$(UNIT_ENV) tests/tally $(UNIT_TESTS) $(UNIT_SCRIPTS) $(if $(TEST),$(UNIT_BUILDERS))
else
	@+CCACHE_DEPEND=1 $(SUBMAKE) BUILD=$(UNIT_SANITIZED) SANITIZE=1 unit-sanitizable-programs
	@$(PLUS)$(UNIT_ENV) tests/tally $(UNIT_BUILDERS) $(sort $(UNIT_SCRIPTS)) \
		$(patsubst $(BUILD)/%,"env GLINT=$(UNIT_SANITIZED)/glint $(UNIT_SANITIZED)/%",$(UNIT_SANITIZABLE)) $(UNIT_PLAIN)
endif

# Without set-up and what takes long.
check-unit:
	@+if tests/missing "$(CC)" "" "" $(UNIT_CHECK) >/dev/null; then $(SUBMAKE) run-check-unit; \
	else tests/tally "echo ok 1 - tier unit # SKIP cmocka is not installed: make setup-unit"; fi

run-check-unit: unit-quick-programs
	@$(UNIT_ENV) tests/tally $(UNIT_QUICK_SCRIPTS) $(UNIT_QUICK)

.PHONY: setup-unit test-unit unit-programs unit-sanitizable-programs unit-quick-programs run-unit check-unit run-check-unit
