# SPDX-License-Identifier: MIT
# glint. `make help` lists what there is. Your own flags: CFLAGS, LDFLAGS, CC; another variant: BUILD=build/NAME.
BUILD ?= build/host
CFLAGS ?= -O2 -g
PREFIX ?= /usr/local
DESTDIR ?=
TIERS = unit exact targets

VERSION := $(shell sed -n 's/.*GLINT_VERSION_STRING "\(.*\)"/\1/p' lib/glint.h)
WARNINGS = -Wall -Wextra -Wconversion -Wundef -Wshadow -Wstrict-prototypes -Wmissing-prototypes
LIB_CFLAGS = -std=c99 -ffreestanding $(WARNINGS) -MMD -MP $(CFLAGS)
HOST_LIBS = libpng jansson
HOST_CFLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Ilib -Ihost -fopenmp $(shell pkg-config --cflags $(HOST_LIBS)) $(CFLAGS)
HOST_LDLIBS = $(shell pkg-config --libs $(HOST_LIBS)) -lm

LIB_OBJECTS = $(patsubst lib/%.c,$(BUILD)/lib/%.o,$(wildcard lib/*.c))
HOST_OBJECTS = $(patsubst host/%.c,$(BUILD)/host/%.o,$(wildcard host/*.c))

all: $(BUILD)/libglint.a $(BUILD)/glint ## the library and the glint command, in build/host (after make setup)

$(BUILD)/libglint.a: $(LIB_OBJECTS)
	rm -f $@ && $(AR) rcs $@ $^

$(BUILD)/lib/%.o: lib/%.c
	@mkdir -p $(@D)
	$(CC) $(LIB_CFLAGS) -c $< -o $@

$(BUILD)/glint: $(HOST_OBJECTS) $(BUILD)/libglint.a
	$(CC) $(CFLAGS) -fopenmp $(LDFLAGS) $^ -o $@ $(HOST_LDLIBS)

$(BUILD)/host/%.o: host/%.c
	@mkdir -p $(@D)
	@for p in $(HOST_LIBS); do pkg-config --exists $$p || { echo "make: no $$p; run 'make setup' first" >&2; exit 1; }; done
	$(CC) $(HOST_CFLAGS) -c $< -o $@

include $(wildcard tests/*/tier.mk)

setup: setup-build ## install what building and the demo need (Debian packages, by apt-get)
setup-build:
	@.ci/need "building the glint command" gcc libc6-dev make pkg-config libpng-dev libjansson-dev libqoi-dev

test: ## set up what is missing and run every tier
	@set -e; for tier in $(TIERS); do $(MAKE) --no-print-directory test-$$tier; done

help: ## this list
	@sed -n 's/^\([a-z][a-z-]*\):.*## \(.*\)/\1@\2/p' $(MAKEFILE_LIST) | awk -F@ '{printf "  make %-14s %s\n", $$1, $$2}'
	@echo "  make test-TIER      one tier: $(TIERS)"

clean: ## remove what was built
	rm -rf build

.PHONY: all setup setup-build test check demo bench help clean install
-include $(shell find build -name '*.d' 2>/dev/null)
