# SPDX-License-Identifier: MIT
# glint. `make help` lists what there is. Your own flags: CC, CFLAGS, LDFLAGS, added to the project's; another variant:
# BUILD=build/NAME; clang without libomp: OPENMP= (the search then uses one core).
BUILD ?= build/host
CFLAGS ?= -O2 -g
OPENMP ?= -fopenmp
PREFIX ?= /usr/local
DESTDIR ?=
TIERS = unit exact targets lab pico gateware
# A TMPDIR that cannot be written would stop compilers and tests.
export TMPDIR := $(shell test -d "$$TMPDIR" && test -w "$$TMPDIR" && echo "$$TMPDIR" || echo /tmp)

VERSION := $(shell sed -n 's/.*GLINT_VERSION_STRING "\(.*\)"/\1/p' lib/glint.h)
WARNINGS = -Wall -Wextra -Wconversion -Wundef -Wshadow -Wstrict-prototypes -Wmissing-prototypes $(WERROR)
LIB_CFLAGS = -std=c99 -ffreestanding $(WARNINGS) -MMD -MP $(CFLAGS)
HOST_LIBS = libpng jansson liblz4
# Sinks of glint stream are left out where their library is not there; glint --version tells.
has = $(shell pkg-config --exists $(1) 2>/dev/null && echo 1)
WITH_USB := $(call has,libusb-1.0)
WITH_GPIO := $(if $(call has,libgpiod inih),$(if $(call has,'libgpiod >= 2'),2,1))
WITH_TERMINAL := $(call has,chafa)
SINK_LIBS = $(if $(WITH_USB),libusb-1.0) $(if $(WITH_GPIO),libgpiod inih) $(if $(WITH_TERMINAL),chafa)
SINK_FLAGS = -DGLINT_WITH_USB=$(if $(WITH_USB),1,0) -DGLINT_WITH_GPIO=$(if $(WITH_GPIO),$(WITH_GPIO),0) \
	-DGLINT_WITH_TERMINAL=$(if $(WITH_TERMINAL),1,0)
LEFT_OUT = $(if $(WITH_USB),,host/sinks/usb/%) $(if $(WITH_TERMINAL),,host/sinks/terminal%) \
	$(if $(WITH_GPIO),host/sinks/wires/chip_v$(if $(filter 1,$(WITH_GPIO)),2,1).c,host/sinks/wires/%)
# Recursive (=), so that they are asked for after set-up; silent, because before it there may be no answer.
HOST_CFLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Ilib -Ifirmware/core -Ihost $(OPENMP) \
	$(SINK_FLAGS) $(shell pkg-config --cflags $(HOST_LIBS) $(SINK_LIBS) 2>/dev/null) $(CFLAGS)
HOST_LDFLAGS = $(CFLAGS) $(OPENMP) $(LDFLAGS)
HOST_LDLIBS = $(shell pkg-config --libs $(HOST_LIBS) $(SINK_LIBS) 2>/dev/null) -lm

LIB_OBJECTS = $(patsubst lib/%.c,$(BUILD)/lib/%.o,$(wildcard lib/*.c))
CORE_OBJECTS = $(patsubst firmware/core/%.c,$(BUILD)/firmware/core/%.o,$(wildcard firmware/core/*.c))
HOST_SOURCES = $(filter-out $(LEFT_OUT),$(wildcard host/*.c host/*/*.c host/*/*/*.c))
HOST_OBJECTS = $(HOST_SOURCES:host/%.c=$(BUILD)/host/%.o) $(CORE_OBJECTS)
# Sub-makes use all cores unless the caller's make decides. (Their recipes begin with +: make does not see $(MAKE) in it.)
PARALLEL = $(if $(findstring -j,$(MAKEFLAGS)),,-j$(shell nproc))
SUBMAKE = $(MAKE) --no-print-directory $(PARALLEL)

all: $(BUILD)/libglint.a $(BUILD)/glint ## the library and the glint command, in build/host (after make setup)

# The folders are prerequisites so that a removed source leaves the archive and the command, too.
$(BUILD)/libglint.a: $(LIB_OBJECTS) lib
	rm -f $@ && $(AR) rcs $@ $(LIB_OBJECTS)

$(BUILD)/lib/%.o: lib/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(LIB_CFLAGS) -c $< -o $@

$(BUILD)/firmware/core/%.o: firmware/core/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) -Ilib $(LIB_CFLAGS) -c $< -o $@

$(BUILD)/glint: $(HOST_OBJECTS) $(BUILD)/libglint.a $(sort $(dir $(HOST_SOURCES))) firmware/core
	$(CC) $(HOST_LDFLAGS) $(HOST_OBJECTS) $(BUILD)/libglint.a -o $@ $(HOST_LDLIBS)

$(BUILD)/host/%.o: host/%.c $(BUILD)/flags | $(BUILD)/packages
	@mkdir -p $(@D)
	$(CC) $(HOST_CFLAGS) -c $< -o $@

# Changes when the compiler or its flags do, and then everything in this folder is built again.
FLAGS = $(CC) $(LIB_CFLAGS) $(HOST_CFLAGS) $(LDFLAGS)
$(BUILD)/flags: always
	@mkdir -p $(@D)
	@printf '%s\n' '$(subst ','\'',$(FLAGS))' | cmp -s - $@ || printf '%s\n' '$(subst ','\'',$(FLAGS))' >$@

$(BUILD)/packages:
	@mkdir -p $(@D)
	@pkg-config --exists $(HOST_LIBS) && echo '#include <qoi.h>' | $(CC) -E - >/dev/null 2>&1 || \
		{ echo "make: $(HOST_LIBS) and qoi.h are not all there: run 'make setup' first" >&2; exit 1; }
	@touch $@

PORTS = $(patsubst firmware/ports/%/port.mk,%,$(wildcard firmware/ports/*/port.mk))
firmware-%: # ports' own goals are phony, and so are not looked for here
	@echo "make: there is no port $*, but $(PORTS)" >&2; exit 1
firmware: $(if $(PORT),firmware-$(PORT),$(PORTS:%=firmware-%)) ## firmware into build/firmware; PORT=NAME: one port, of firmware/ports

include firmware/conformance/conformance.mk firmware/ports/bare/bare.mk firmware/gateware/gateware.mk
include $(wildcard firmware/ports/*/port.mk) $(wildcard tests/*/tier.mk) tests/bench/bench.mk tests/bench/host/host.mk tests/bench/stream/stream.mk

setup: ## install what building, the demo and glint paper need (Debian packages, by apt-get)
	@.ci/need "building, the demo and glint paper" $(BUILD_PACKAGES) chafa gnuplot-nox
BUILD_PACKAGES = gcc libc6-dev make pkg-config libpng-dev libjansson-dev libqoi-dev liblz4-dev libusb-1.0-0-dev \
	libgpiod-dev libinih-dev libchafa-dev libglib2.0-dev

setup-build:
	@.ci/need "building the glint command" $(BUILD_PACKAGES)

demo: ## set up, build, and relight a height map and a built-in scene in the terminal
	@+$(SUBMAKE) setup
	@+$(SUBMAKE) run-demo

run-demo: all
	@mkdir -p build/demo
	@tests/golden/draw $(BUILD)/glint build/demo --compare
	@chafa --size 80x30 build/demo/rockwall.png build/demo/watchface.png
	@echo "demo: rockwall.png, watchface.png, coin.png and sphere.png are in build/demo"

check: ## in under a minute, with what is installed: warnings, format, and each tier's quick part
	@+$(CHECK_MAKE) all && tests/sum "$(CHECK_MAKE)" check-format $(CHECKS)
CHECK_MAKE = $(SUBMAKE) BUILD=build/check WERROR=-Werror
# A tier with a quick part that needs no set-up offers a goal check-TIER.
CHECKS = $(shell sed -n 's/^\(check-[a-z]*\):.*/\1/p' $(wildcard tests/*/tier.mk))

FORMATTED = $(wildcard lib/*.[ch] firmware/*/*.[ch] firmware/*/*/*.[ch] firmware/*/*/*/*.[ch] host/*.[ch] host/*/*.[ch] host/*/*/*.[ch] tests/*/*.[ch] tests/*/*/*.[ch] tests/gateware/*.cpp)
check-format:
	@tests/tally "tests/format $(FORMATTED)"

test: ## set up what is missing and run every tier; the last line is the sum
	@+tests/sum "$(SUBMAKE)" $(TIERS:%=test-%)

help: ## this list
	@sed -n 's/^\([a-z][a-z-]*\):.*## \(.*\)/\1@\2/p' $(MAKEFILE_LIST) | awk -F@ '{printf "  make %-14s %s\n", $$1, $$2}'

install: all ## library, header, command, libglint.pc and the udev rule, to DESTDIR/PREFIX (/usr/local)
	install -d "$(INSTALL)/lib/pkgconfig" "$(INSTALL)/lib/udev/rules.d" "$(INSTALL)/include" "$(INSTALL)/bin"
	install -m 644 $(BUILD)/libglint.a "$(INSTALL)/lib/"
	install -m 644 lib/glint.h "$(INSTALL)/include/"
	install -m 755 $(BUILD)/glint "$(INSTALL)/bin/"
	install -m 644 host/udev/70-glint.rules "$(INSTALL)/lib/udev/rules.d/"
	printf '%s\n' 'prefix=$(PREFIX)' 'Name: libglint' 'Description: Specular shading with integers only' \
		'Version: $(VERSION)' 'Cflags: -I"$${prefix}/include"' 'Libs: -L"$${prefix}/lib" -lglint' \
		>"$(INSTALL)/lib/pkgconfig/libglint.pc"
INSTALL = $(DESTDIR)$(PREFIX)

uninstall: ## remove what make install put there
	rm -f "$(INSTALL)/lib/libglint.a" "$(INSTALL)/lib/pkgconfig/libglint.pc" "$(INSTALL)/include/glint.h" \
		"$(INSTALL)/bin/glint" "$(INSTALL)/lib/udev/rules.d/70-glint.rules"

clean: ## remove what was built
	rm -rf build

always:
.PHONY: all always firmware setup setup-build test check check-format demo run-demo help clean install uninstall
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
