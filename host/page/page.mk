# SPDX-License-Identifier: MIT
# The page: build/page/index.html, one file with the library as WebAssembly in it.
PAGE_PACKAGES = clang lld wasi-libc libclang-rt-dev-wasm32
PAGE = build/page
PAGE_NPM = $(PAGE)/npm
# Of the host what needs no files, libraries or signals; host/page/module has those in memory.
PAGE_HOST = $(filter-out %_json.c host/mesh/import%.c,$(wildcard host/compare/*.c host/draw/*.c host/bake/*.c host/mesh/*.c host/scene/*.c)) \
	$(patsubst %,host/options/%_options.c,drawing shading scene map mesh view light) $(patsubst %,host/commands/%.c,bake material table) \
	$(patsubst %,host/image/%.c,format image levels picture) host/models/models.c $(wildcard host/models/lobe_*.c) \
	$(patsubst %,host/base/%.c,c_library c_names closest memory message output_pair parse text unknown)
# Whose numbers and layouts the page speaks over USB.
PAGE_WIRE = firmware/core/light_protocol firmware/core/gud_protocol
PAGE_C = $(wildcard lib/*.c host/page/module/*.c) $(PAGE_HOST) $(patsubst %,firmware/core/%.c,light_protocol mesh_cksum cksum)
PAGE_OBJECTS = $(PAGE_C:%.c=$(PAGE)/objects/%.o)
PAGE_CFLAGS = --target=wasm32-wasi -O2 -std=c11 -D_GNU_SOURCE -DGLINT_WITH_MESH=0 $(WARNINGS) -MMD -MP \
	-Ihost/page/module/include -Ihost/page/module -Ilib -Ihost -Ifirmware/core
# The stack lies below the data, so that an overflow traps.
PAGE_LDFLAGS = --target=wasm32-wasi -mexec-model=reactor -Wl,--stack-first,-z,stack-size=1048576,--strip-all
PAGE_SCRIPTS = $(wildcard host/page/*.mjs host/page/*.json host/page/src/*.ts host/page/*.html host/page/*.css)

page: setup-page-build ## use: the page, build/page/index.html: a file to open in a browser; it shades, tunes and bakes
	@+$(SUBMAKE) -s $(PAGE)/index.html
	@echo "page: open $(PAGE)/index.html in a browser"

setup-page-build:
	@.ci/need "the page (a compiler for WebAssembly)" $(PAGE_PACKAGES)
	@command -v npm >/dev/null || .ci/need "the page" $(BENCH_EMULATOR_PACKAGES)
	@+$(SUBMAKE) -s $(PAGE_NPM)/done

# What package-lock.json says, checked by its hashes.
$(PAGE_NPM)/done: host/page/package.json host/page/package-lock.json
	@rm -rf $(@D) && mkdir -p $(@D) && cp $^ $(@D)
	@npm ci --prefix $(@D) --ignore-scripts --no-audit --no-fund --loglevel=error >$(PAGE)/npm.log 2>&1 || \
		{ tail -5 $(PAGE)/npm.log >&2; echo "make: npm could not install what the page needs" >&2; exit 1; }
	@touch $@

# The library is what is to be fast; the rest is to be small.
$(PAGE)/objects/host/%.o: PAGE_CFLAGS += -Os

$(PAGE)/objects/%.o: %.c host/page/page.mk
	@mkdir -p $(@D)
	clang $(PAGE_CFLAGS) -c $< -o $@

$(PAGE)/module.wasm: $(PAGE_OBJECTS)
	clang $(PAGE_LDFLAGS) $(PAGE_OBJECTS) -o $@

$(PAGE)/exports.ts: host/page/module_types.mjs host/page/module/page.h $(PAGE_WIRE:%=%.h)
	@mkdir -p $(@D)
	node $^ >$@.part && mv $@.part $@

# Types are checked where the sources, the made types and the packages are together.
$(PAGE)/index.html: $(PAGE)/module.wasm $(PAGE)/exports.ts $(PAGE_NPM)/done $(PAGE_SCRIPTS) tests/bench/costs.tsv
	@rm -rf $(PAGE)/src && cp -r host/page/src $(PAGE)/src && cp $(PAGE)/exports.ts $(PAGE)/src/ && cp host/page/tsconfig.json $(PAGE)
	@rm -rf $(PAGE)/node_modules && ln -s npm/node_modules $(PAGE)/node_modules
	node $(PAGE_NPM)/node_modules/typescript/bin/tsc -p $(PAGE)
	node host/page/build.mjs $(PAGE_NPM) $(PAGE)

.PHONY: page setup-page-build
