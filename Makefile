# SPDX-License-Identifier: MIT
# glint. `make help` lists the goals. Set by you: CC, CFLAGS and LDFLAGS, which are added to the project's own flags;
# BUILD=build/NAME, another folder, for another variant; OPENMP= for clang without libomp; SANITIZE=1, with sanitizers;
# TEST=PATTERN, of a tier only the test files that have this in their names.

# Variants, and where they are built.
SANITIZE ?= 0
$(if $(filter-out 0 1,$(SANITIZE)),$(error SANITIZE=$(SANITIZE): choose 0 or 1))
BUILD ?= build/$(if $(filter 1,$(SANITIZE)),sanitized,host)
# A word of the shell, whatever is in it.
quoted = '$(subst ','\'',$(1))'
$(if $(filter 1,$(words $(BUILD))),,$(error BUILD='$(BUILD)': name one folder, without blanks))
# Numbers, where the command line gives them.
$(foreach name,SECONDS MUTANTS SEED MINUTES JOBS,$(if $(filter command,$(origin $(name))),$(if $($(name)),$(if $(shell case $(call quoted,$($(name))) in ('' | *[!0-9]* | ???????????????????*) ;; (*) echo good ;; esac),,\
	$(error $(name)='$($(name))': give a whole number)))))
# make -R has no default of these.
CC ?= cc
AR ?= ar
$(if $(and $(strip $(CC)),$(strip $(AR))),,$(error CC='$(CC)' AR='$(AR)': name a compiler and an archiver, or leave them out))
CFLAGS ?= -O2 -g
OPENMP ?= -fopenmp
PREFIX ?= /usr/local
DESTDIR ?=
TEST ?=
WERROR ?=
# The tiers in the order of make test: one that waits much runs beside one that computes, where neither builds what the other does; the
# lab comes late, when its kernel has been built beside others.
TEST_ORDER = unit exact proof targets packages page+gateware lab pico
TIERS = $(subst +, ,$(TEST_ORDER))
# libglint.pc is read in any folder.
$(if $(filter install install-lib run-install-lib,$(MAKECMDGOALS)),$(if $(filter-out /%,$(firstword $(PREFIX))),$(error PREFIX='$(PREFIX)': give the whole path, from / on)))
# A TMPDIR that cannot be written to would stop compilers and tests.
export TMPDIR := $(shell test -d "$$TMPDIR" && test -w "$$TMPDIR" && echo "$$TMPDIR" || echo /tmp)

# These goals name files from the root on, and make takes a name with a blank for two.
FROM_ROOT = test dist bench bench-cycles usb-rate gpio-rate costs coverage% mutants firmware% $(foreach tier,targets packages page lab pico gateware,setup-$(tier) test-$(tier) run-$(tier))
ifneq ($(words $(CURDIR)),1)
FROM_ROOT_ASKED := $(filter-out firmware-linux $(if $(filter linux,$(PORT)),firmware),$(filter $(FROM_ROOT),$(MAKECMDGOALS)))
$(if $(FROM_ROOT_ASKED),$(error make $(firstword $(FROM_ROOT_ASKED)) cannot run in '$(CURDIR)', a path with blanks; move the folder, or make what can: all, check, page, \
	install, firmware PORT=linux, test-unit, test-exact, test-proof))
endif

# Flags. Those that ask pkg-config do so when they are wanted, and are silent: before set-up it may have no answer.
# What users include: glint.h, which includes the others.
LIB_HEADERS = glint.h glint_mesh.h
VERSION := $(shell sed -n 's/.*GLINT_VERSION_STRING "\(.*\)"/\1/p' lib/glint.h)
WARNINGS = -Wall -Wextra -Wconversion -Wundef -Wshadow -Wstrict-prototypes -Wmissing-prototypes $(WERROR)
ifeq ($(SANITIZE),1)
SANITIZERS = -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
endif
LIB_CFLAGS = -std=c99 -ffreestanding $(WARNINGS) -MMD -MP $(CFLAGS) $(SANITIZERS)
HOST_LIBS = libpng jansson liblz4
# A sink of glint stream whose library is missing is left out; glint --version says which.
has = $(shell pkg-config --exists $(1) 2>/dev/null && echo 1)
WITH_USB := $(call has,libusb-1.0)
WITH_GPIO := $(if $(call has,libgpiod inih),$(if $(call has,'libgpiod >= 2'),2,1))
WITH_TERMINAL := $(call has,chafa)
WITH_WEBP := $(call has,libwebp libwebpmux)
WITH_GIF := $(call has,libgif)
WITH_MPI := $(call has,ompi-c)
# SVG pictures are read by librsvg, which glint loads when it meets one: of its 40 libraries only the headers are used here.
WITH_SVG := $(call has,librsvg-2.0)
# Meshes are read by libassimp, which a child process loads: the number of its version is in the library's name.
WITH_MESH := $(firstword $(subst ., ,$(shell pkg-config --modversion assimp 2>/dev/null)))
# JPEG pictures for them are read by libjpeg.
WITH_JPEG := $(call has,libjpeg)
READ_LIBS = $(if $(WITH_JPEG),libjpeg)
SINK_LIBS = $(if $(WITH_MPI),ompi-c) $(if $(WITH_USB),libusb-1.0) $(if $(WITH_GPIO),libgpiod inih) $(if $(WITH_TERMINAL),chafa) \
	$(if $(WITH_WEBP),libwebp libwebpmux) $(if $(WITH_GIF),libgif)
SINK_FLAGS = -DGLINT_WITH_USB=$(if $(WITH_USB),1,0) -DGLINT_WITH_GPIO=$(if $(WITH_GPIO),$(WITH_GPIO),0) \
	-DGLINT_WITH_TERMINAL=$(if $(WITH_TERMINAL),1,0) -DGLINT_WITH_MPI=$(if $(WITH_MPI),1,0) \
	-DGLINT_WITH_WEBP=$(if $(WITH_WEBP),1,0) -DGLINT_WITH_GIF=$(if $(WITH_GIF),1,0)
# Of the page's module clang makes WebAssembly (host/page/page.mk).
LEFT_OUT = host/page/% $(if $(WITH_USB),,host/sinks/usb/%) $(if $(WITH_TERMINAL),,host/sinks/terminal%) \
	$(if $(WITH_WEBP),,host/sinks/webp%) $(if $(WITH_GIF),,host/sinks/gif%) \
	$(if $(WITH_GPIO),host/sinks/wires/chip_v$(if $(filter 1,$(WITH_GPIO)),2,1).c,host/sinks/wires/%)
HOST_CFLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Ilib -Ifirmware/core -Ihost $(OPENMP) \
	$(SINK_FLAGS) -DGLINT_WITH_SVG=$(if $(WITH_SVG),1,0) -DGLINT_WITH_MESH=$(or $(WITH_MESH),0) -DGLINT_WITH_JPEG=$(if $(WITH_JPEG),1,0) $(HOST_INCLUDES) $(CFLAGS) $(SANITIZERS) $(HOST_MORE)
HOST_LDFLAGS = $(CFLAGS) $(SANITIZERS) $(OPENMP) $(LDFLAGS)
HOST_LDLIBS = $(HOST_FOUND) -lm
# Asked once a make, when first wanted.
HOST_INCLUDES = $(eval HOST_INCLUDES := $$(shell pkg-config --cflags $(HOST_LIBS) $(READ_LIBS) $(SINK_LIBS) $(if $(WITH_SVG),librsvg-2.0) 2>/dev/null))$(HOST_INCLUDES)
HOST_FOUND = $(eval HOST_FOUND := $$(shell pkg-config --libs $(HOST_LIBS) $(READ_LIBS) $(SINK_LIBS) 2>/dev/null))$(HOST_FOUND)

# What is built of what.
# The assembly where the compiler is told to take it.
LIB_ASSEMBLY = $(if $(filter -DGLINT_CORTEX_M0PLUS_ASM -DGLINT_CORTEX_M0PLUS_ASM=1,$(CC) $(CFLAGS)),$(wildcard lib/*.S))
LIB_OBJECTS = $(patsubst lib/%,$(BUILD)/lib/%.o,$(basename $(wildcard lib/*.c) $(LIB_ASSEMBLY)))
CORE_OBJECTS = $(patsubst firmware/core/%.c,$(BUILD)/firmware/core/%.o,$(wildcard firmware/core/*.c))
HOST_SOURCES = $(filter-out $(LEFT_OUT),$(wildcard host/*.c host/*/*.c host/*/*/*.c))
HOST_OBJECTS = $(HOST_SOURCES:host/%.c=$(BUILD)/host/%.o) $(CORE_OBJECTS)
# All of the command but main, for tests; it needs the library behind it.
HOST_ARCHIVES = $(BUILD)/libhost.a $(BUILD)/libglint.a
# Sub-makes use all cores unless the caller's make decides. (Their recipes begin with +: make does not see $(MAKE) in it.)
parallel = $(if $(findstring -j,$(MAKEFLAGS)),,-j$(shell echo $$(($1 * $$(nproc)))))
SUBMAKE = $(MAKE) --no-print-directory $(call parallel,1)
# Instead of the + where a recipe does more than that: make -n, -q and -t, which run nothing, do not run it.
PLUS = $(if $(strip $(foreach flag,n q t,$(findstring $(flag),$(filter-out -%,$(firstword $(MAKEFLAGS)))))),,+)

# Debian packages of each set-up goal: NAME_PACKAGES is the one place of that fact; `make packages` prints them all.
BUILD_PACKAGES = gcc libc6-dev make pkg-config libpng-dev libjansson-dev liblz4-dev libusb-1.0-0-dev \
	libgpiod-dev libinih-dev libchafa-dev libglib2.0-dev librsvg2-dev libassimp-dev libjpeg-dev libwebp-dev libgif-dev
DEMO_PACKAGES = chafa gnuplot-nox
GALLERY_PACKAGES = python3-minimal

all: $(BUILD)/libglint.a $(BUILD)/glint ## use: the library and the glint command, in build/host (after make setup)

# The folders are prerequisites so that a removed source leaves the archive and the command, too.
$(BUILD)/libglint.a: $(LIB_OBJECTS) lib
	rm -f $@ && $(AR) rcs $@ $(LIB_OBJECTS)

$(BUILD)/lib/%.o: lib/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(LIB_CFLAGS) -c $< -o $@

$(BUILD)/lib/%.o: lib/%.S $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(LIB_CFLAGS) -c $< -o $@

$(BUILD)/firmware/core/%.o: firmware/core/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) -Ilib $(LIB_CFLAGS) -c $< -o $@

$(BUILD)/glint: $(HOST_OBJECTS) $(BUILD)/libglint.a $(sort $(dir $(HOST_SOURCES))) firmware/core
	$(CC) $(HOST_LDFLAGS) $(HOST_OBJECTS) $(BUILD)/libglint.a -o $@ $(HOST_LDLIBS)

# Appended, not replaced (q): two folders may have a file of the same name.
$(BUILD)/libhost.a: $(HOST_OBJECTS) $(sort $(dir $(HOST_SOURCES))) firmware/core
	rm -f $@ && $(AR) qcs $@ $(filter-out $(BUILD)/host/main.o,$(HOST_OBJECTS))

$(BUILD)/host/%.o: host/%.c $(BUILD)/flags | $(BUILD)/packages
	@mkdir -p $(@D)
	$(CC) $(HOST_CFLAGS) -c $< -o $@

# Changes when the compiler or its flags do, and then everything in this folder is built again.
FLAGS = $(CC) $(LIB_CFLAGS) $(HOST_CFLAGS) $(LDFLAGS)
$(BUILD)/flags: always
	@mkdir -p $(@D)
	@printf '%s\n' $(call quoted,$(FLAGS)) | cmp -s - $@ || printf '%s\n' $(call quoted,$(FLAGS)) >$@

$(BUILD)/packages:
	@mkdir -p $(@D)
	@pkg-config --exists $(HOST_LIBS) || \
		{ echo "make: $(HOST_LIBS) are not all there: run 'make setup' first" >&2; exit 1; }
	@touch $@

setup: setup-build ## use: install what building, the demo and glint paper need (Debian packages, by apt-get)
	@.ci/need "the demo and glint paper" $(DEMO_PACKAGES)

setup-build:
	@.ci/need "building the glint command" $(BUILD_PACKAGES)

demo: ## use: set up, build, and relight a height map and a built-in scene in the terminal
	@+$(SUBMAKE) setup
	@+$(SUBMAKE) run-demo

run-demo: all
	@mkdir -p build/demo
	@tests/golden/draw $(BUILD)/glint build/demo --compare
	@chafa --size 80x30 build/demo/rockwall.png build/demo/watchface.png
	@echo "demo: rockwall.png, watchface.png, coin.png and sphere.png are in build/demo"
	@echo "demo: to tune them in a browser: make page, then open build/page/index.html"

gallery: setup-build ## use: what it can draw, before and after, as it is and four times as large: build/gallery/index.html, needs python3 only
	@.ci/need "the gallery" $(GALLERY_PACKAGES)
	@+$(SUBMAKE) -s all
	@rm -rf build/gallery && tests/golden/gallery $(BUILD)/glint build/gallery
	@echo "gallery: open build/gallery/index.html in a browser"

# A page for glint and one for each command, from the tables of options behind --help.
COMMAND_PAGES = $(patsubst host/commands/%.c,glint-%.1,$(wildcard host/commands/*.c))
$(BUILD)/man: $(BUILD)/glint
	@rm -rf $@ $@.part && mkdir -p $@.part
	$(BUILD)/glint --_man >$@.part/glint.1
	for command in $$($(BUILD)/glint --_choices ''); do \
		$(BUILD)/glint $$command --_man >$@.part/glint-$$command.1 || exit 1; done
	@mv $@.part $@

INSTALL = $(call quoted,$(DESTDIR)$(PREFIX))
install: all run-install-lib $(BUILD)/man ## use: library, header, libglint.pc, command, its man pages and completion, the udev rule, to DESTDIR/PREFIX (/usr/local)
	install -d $(INSTALL)/lib/udev/rules.d $(INSTALL)/bin $(INSTALL)/share/man/man1 \
		$(INSTALL)/share/bash-completion/completions $(INSTALL)/share/zsh/site-functions
	install -m 755 $(BUILD)/glint $(INSTALL)/bin/
	install -m 644 $(BUILD)/man/*.1 $(INSTALL)/share/man/man1/
	install -m 644 host/completion/glint.bash $(INSTALL)/share/bash-completion/completions/glint
	install -m 644 host/completion/_glint $(INSTALL)/share/zsh/site-functions/
	install -m 644 host/udev/70-glint.rules $(INSTALL)/lib/udev/rules.d/
	test ! -e build/page/index.html || install -D -m 644 build/page/index.html $(INSTALL)/share/glint/page.html

# A folder for each compiler, so that a cross compiler's objects do not replace the host's.
install-lib: have-compiler ## use: library, header and libglint.pc alone, needs a compiler only: CC=arm-none-eabi-gcc AR=arm-none-eabi-ar DESTDIR=...
	@+$(SUBMAKE) BUILD=$(BUILD)/$(shell $(CC) -dumpmachine) run-install-lib

have-compiler:
	@command -v $(firstword $(CC)) >/dev/null || { echo "make: there is no compiler '$(firstword $(CC))': set CC, and AR for its archiver" >&2; exit 1; }

run-install-lib: $(BUILD)/libglint.a
	install -d $(INSTALL)/lib/pkgconfig $(INSTALL)/include
	install -m 644 $(BUILD)/libglint.a $(INSTALL)/lib/
	install -m 644 $(LIB_HEADERS:%=lib/%) $(INSTALL)/include/
	printf '%s\n' $(call quoted,prefix=$(PREFIX)) 'Name: libglint' 'Description: Specular shading with integers only' \
		'Version: $(VERSION)' 'Cflags: -I"$${prefix}/include"' 'Libs: -L"$${prefix}/lib" -lglint' \
		>$(INSTALL)/lib/pkgconfig/libglint.pc
	chmod 644 $(INSTALL)/lib/pkgconfig/libglint.pc

uninstall: ## use: remove what make install put there
	rm -f $(INSTALL)/lib/libglint.a $(INSTALL)/lib/pkgconfig/libglint.pc $(LIB_HEADERS:%=$(INSTALL)/include/%) \
		$(INSTALL)/bin/glint $(INSTALL)/share/glint/page.html $(INSTALL)/lib/udev/rules.d/70-glint.rules \
		$(INSTALL)/share/bash-completion/completions/glint $(INSTALL)/share/zsh/site-functions/_glint \
		$(INSTALL)/share/man/man1/glint.1 $(COMMAND_PAGES:%=$(INSTALL)/share/man/man1/%)

# Firmware: a port's goals are phony, so this pattern catches only what is no port.
PORTS = $(patsubst firmware/ports/%/port.mk,%,$(sort $(wildcard firmware/ports/*/port.mk)))
firmware-%:
	@echo "make: there is no port $*; choose from $(PORTS)" >&2; exit 1
firmware: $(if $(PORT),firmware-$(PORT),$(PORTS:%=firmware-%)) ## firmware: all images, into build/firmware; PORT=NAME: of one port

include firmware/conformance/conformance.mk firmware/ports/bare/bare.mk firmware/gateware/gateware.mk
include $(sort $(wildcard firmware/ports/*/port.mk))
include host/page/page.mk
include tests/bench/bench.mk tests/bench/hazard3/hazard3.mk tests/bench/tgx/tgx.mk tests/bench/host/host.mk tests/bench/stream/stream.mk tests/bench/search/search.mk tests/bench/page/page.mk
include $(sort $(wildcard tests/*/tier.mk))
include tests/strength/strength.mk

# A tier with a quick part that needs no set-up has a goal check-TIER. What it needs of what need not be installed: PACKAGE:PROBE (tests/missing).
CHECKS = $(shell sed -n 's/^\(check-[a-z]*\):.*/\1/p' $(sort $(wildcard tests/*/tier.mk)))
FORMAT_CHECK = clang-format-14:clang-format-14
CHECK_PACKAGES = $(sort $(foreach need,$(FORMAT_CHECK) $(EXACT_CHECK) $(GATEWARE_CHECK) $(UNIT_CHECK) $(UNIT_CHECK_PART),$(firstword $(subst :, ,$(need)))))
# The library as it is shipped, at -O2. Debug information, and the command and the tests as optimized, would take a third of the time.
CHECK_MAKE = $(SUBMAKE) -s BUILD=$(if $(filter 1,$(SANITIZE)),build/check-sanitized,build/check) WERROR=-Werror \
	$(if $(filter file0,$(origin CFLAGS)$(SANITIZE)),CFLAGS=-O2 HOST_MORE=-O1 UNIT_CFLAGS=-O0)
check: missing ## check: in about a minute, with what is installed: warnings, format, and each tier's quick part
	@$(PLUS)echo "== all" && $(CHECK_MAKE) all \
		$$(tests/missing "$(CC)" "" "" $(UNIT_CHECK) >/dev/null && echo unit-quick-programs) \
		$$(tests/missing "$(CC)" "" "" $(EXACT_CHECK) >/dev/null && echo exact-quick-programs) && tests/sum "$(CHECK_MAKE)" check-format $(CHECKS)

# What make check skips.
missing:
	@tests/missing "$(CC)" "make setup-check" "the format" $(FORMAT_CHECK) "tier exact" $(EXACT_CHECK) "tier gateware" $(GATEWARE_CHECK) \
		"tier unit" $(UNIT_CHECK) "a part of tier unit" $(UNIT_CHECK_PART) || true

setup-check:
	@.ci/need "make check" $(CHECK_PACKAGES)

FORMATTED = $(filter %.c %.h %.cpp,$(shell find lib firmware host tests -name '*.[ch]' -o -name '*.cpp'))
check-format:
	@tests/tally "tests/format $(sort $(FORMATTED))"

# The packages of the tiers are installed while the first of them runs: a tier's own set-up then finds them, or says what is missing.
# npm is left out where there is one: Debian's conflicts with that of NodeSource, and nothing would be installed.
# Then the lab's kernel is built, where it is not kept yet, in the time that other tiers wait for browsers and for each other.
TEST_LISTS = $(filter-out TEST_% DEMO_% BENCH_% STRENGTH_% PROOF_EVA_%,$(filter %_PACKAGES,$(.VARIABLES))) \
	$(if $(shell command -v npm),,BENCH_EMULATOR_PACKAGES)
TEST_PACKAGES = $(sort $(foreach list,$(TEST_LISTS),$($(list))))
# The tiers compile much of the same: what one has compiled the next, and the next run, take from ccache.
CACHE_PACKAGES = ccache
TEST_CACHE = PATH="/usr/lib/ccache:$$PATH" CCACHE_DIR="$${XDG_CACHE_HOME:-$$HOME/.cache}/glint/ccache" CCACHE_NOHASHDIR=1 CCACHE_MAXSIZE=2G
# Two jobs a processor, as tests/tally has: where other work has the machine, tests have their share of it.
TEST_SUBMAKE = $(MAKE) --no-print-directory $(call parallel,2)
test: ## check: set up what is missing and run every tier; the last line is the sum
	@.ci/need "make test (it is slower without)" $(CACHE_PACKAGES) || true
	@$(PLUS)$(SUBMAKE) setup-$(firstword $(TIERS)); \
	{ .ci/need "the other tiers" $(TEST_PACKAGES) && env --default-signal=INT,QUIT nice -n 19 tests/lab/kernel >/dev/null; } & \
	$(TEST_CACHE) tests/sum "$(TEST_SUBMAKE)" $(subst +,+test-,$(TEST_ORDER:%=test-%))

# What a release has.
DIST = build/dist
DIST_PANELS = $(foreach panel,$(PICO_RELEASED),build/firmware/pico-$(panel)/glint.uf2=glint-VERSION-pico-$(panel).uf2) \
	build/firmware/pico-st7789-240x240-two-cores-teapot/glint.uf2=glint-VERSION-pico-teapot.uf2 $(foreach board,$(PICO_READY),$(foreach demo,$(PICO_READY_DEMOS),\
	build/firmware/$(board)-$(call pico_panel_of,$(board))$(if $(filter teapot,$(demo)),-two-cores-teapot)/glint.uf2=glint-VERSION-$(board)-$(demo).uf2))
# Boards that have a panel, and what each gets: the dial, from which a tap goes to the coin, and the teapot where an emulator turns it.
PICO_READY := $(filter-out pico pico2 pico-amoled,$(pico_BOARDS))
PICO_READY_DEMOS = dial $(if $(filter $(board),$(pico_EMULATED)),teapot)
DIST_BUILT = $(foreach board,$(GATEWARE_BOARDS),$(GATEWARE)/$(board).bin=glint-VERSION-$(board).bin) $(PAGE)/index.html=glint-VERSION-page.html

dist: all $(BUILD)/man gateware page gallery ## maintain: what a release has, into build/dist: archives, the library as two files, an image for each Pico panel, each board with a panel and one that turns a teapot, bitstreams, the page, the gallery, man pages, SHA256SUMS
	@+for panel in $(PICO_RELEASED); do $(SUBMAKE) -s firmware PORT=pico PANEL=$$panel || exit 1; done
	@+$(SUBMAKE) -s firmware PORT=pico DEMO=teapot SECOND_CORE=1
	@+for board in $(PICO_READY); do $(SUBMAKE) -s firmware PORT=pico BOARD=$$board || exit 1; done
	@+for board in $(filter $(PICO_READY),$(pico_EMULATED)); do $(SUBMAKE) -s firmware PORT=pico BOARD=$$board DEMO=teapot SECOND_CORE=1 || exit 1; done
	@.ci/dist $(DIST) "$(LIB_HEADERS)" $(DIST_PANELS) $(DIST_BUILT) "$$(echo $(BUILD)/man/*.1)=glint-VERSION-man.tar.gz" \
		"$$(echo build/gallery/*)=glint-VERSION-gallery.tar.gz"
	@cat $(DIST)/SHA256SUMS

# Without firmware: the archives and the two files need git and python3.
dist-archives:
	@.ci/dist $(DIST) "$(LIB_HEADERS)"

dist-two-files: ## use: the library as two files to copy, build/dist/glint.c and glint.h, needs python3 only
	@.ci/two-files lib $(DIST) $(LIB_HEADERS)

# A goal with a line here bears "## GROUP: what it does".
help: ## maintain: this list
	@awk -F ' ## ' '/^[a-z][a-z0-9-]*:.* ## / { goal = $$1; sub(/:.*/, "", goal); group = $$2; sub(/:.*/, "", group); \
		sub(/^[a-z]*: /, "", $$2); lines[group] = lines[group] sprintf("  make %-16s %s\n", goal, $$2) } \
		END { n = split("use check measure firmware maintain", groups, " "); \
		for (i = 1; i <= n; i++) printf "%s\n%s", groups[i], lines[groups[i]] }' $(MAKEFILE_LIST)

packages: ## maintain: the Debian packages of each set-up goal
	@$(foreach list,$(sort $(filter-out TEST_%,$(filter %_PACKAGES,$(.VARIABLES)))),echo '$(list:_PACKAGES=): $(strip $($(list)))';)

clean: ## maintain: remove what was built
	rm -rf build

always:
.PHONY: all always have-compiler dist dist-archives dist-two-files firmware setup setup-build setup-check test check missing check-format demo run-demo gallery help packages clean install install-lib run-install-lib uninstall
# make -B asks for sources, too.
.DEFAULT:
	$(if $(wildcard $@),,$(error there is no goal or file '$@'; 'make help' lists the goals))
# The headers of each object, of files whose last line is whole: what another make is writing at this moment may end within a line.
-include $(shell find $(BUILD) $(linux) $(PAGE)/objects -name '*.d' -exec awk 'FNR == 1 { if (whole) print name; name = FILENAME } \
	{ whole = /:/ || /^ / } END { if (whole) print name }' {} + 2>/dev/null)
