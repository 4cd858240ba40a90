# SPDX-License-Identifier: MIT
# make bench: what a highlight and a pixel cost, beside what people use today: cycles on a Cortex-M0+ and an AVR, instructions
# on other cores, bytes; then the host's part, host/host.mk. These are measurements, not tests: nothing here fails for being slow.
BENCH_PACKAGES = libnewlib-arm-none-eabi picolibc-riscv64-unknown-elf
BENCH_EMULATOR_PACKAGES = nodejs npm
BENCH = build/bench
BENCH_SCENE = $(BENCH)/scene
BENCH_NPM = $(BENCH)/npm
# The variants for Cortex-M0+; asm: with the library's assembly.
BENCH_FLAGS_O2 = -O2
BENCH_FLAGS_Os = -Os
BENCH_FLAGS_asm = -O2 -DGLINT_CORTEX_M0PLUS_ASM=1
BENCH_ELFS = $(patsubst %,$(BENCH)/m0plus-%.elf,O2 Os asm)
# The frames of meshes, a program of their own; with the bunny where npm has installed it, to be read by libassimp.
BENCH_MESH = $(BENCH)/mesh
BENCH_MESH_SOURCES = tests/bench/mesh/mesh.c tests/bench/mesh/gouraud.c
# The widget of LVGL beside glint's own calls, with the stand-ins of tier packages.
BENCH_LVGL = lib/examples/lvgl
BENCH_LVGL_SOURCES = tests/bench/mesh/lvgl.c $(BENCH_LVGL)/glint_lvgl.c $(BENCH_LVGL)/glint_lvgl_mesh.c
# What is called by its name (mesh.mjs, calibrate.mjs, twins.mjs): sections that nothing of it needs are left out, or the RAM is too small.
BENCH_MESH_ROOTS = $(addprefix mesh_,begin clothe frame strip memory_bytes normals rect) glint_mesh_sort glint_mesh_albedo_pixels \
	$(addprefix calibrate_,alu call conditions empty high indexed jump loop memory muls multiple pointer sp stack)
BENCH_MESH_LINK = -Wl,--gc-sections $(foreach name,$(BENCH_MESH_ROOTS),-Wl,-u,$(name))
BENCH_MESH_INPUTS = $(wildcard tests/bench/mesh/*.h) $(BENCH_MESH)/teapot.h $(BENCH_MESH)/teapot_split.h
BENCH_BUNNY = $(if $(WITH_MESH),$(wildcard $(BENCH_NPM)/node_modules/bunny/index.js))
BENCH_MESH_ELFS = $(foreach program,mesh lvgl,$(patsubst %,$(BENCH)/$(program)-%.elf,O2 asm))
# libfixmath's source, where it could be fetched.
BENCH_FIXMATH = $(wildcard $(addprefix $(BENCH)/fixmath/libfixmath/,fix16.c fix16_exp.c))
BENCH_FLAGS = -Ilib $(if $(BENCH_FIXMATH),-DBENCH_FIXMATH=1 -DFIXMATH_NO_CACHE -I$(BENCH)/fixmath,-DBENCH_FIXMATH=0)
BENCH_SOURCES = $(wildcard lib/*.c lib/*.S) $(BENCH_FIXMATH) \
	$(filter-out $(if $(BENCH_FIXMATH),,%/fixmath.c),$(wildcard tests/bench/*.c))
# The counted programs have their start-up code and linker scripts. Boards whose core is counted: a new board is. The M0s have emulated
# cycles, -c repeats a board without its own loops, and of the others there is no clock or no room.
BENCH_BOARDS = $(filter-out microbit rp2040% %-c lx106% atmega328% atmega1284%,$(BARE_BOARDS))
BENCH_IMAGES = $(foreach board,$(BENCH_BOARDS),$(bare_image_$(board)))
BENCH_INPUTS = $(BENCH_SOURCES) $(wildcard lib/*.h lib/*.inc tests/bench/*.h) tests/targets/targets.py tests/bench/m0plus.ld tests/bench/bench.mk

setup-bench: setup-build setup-targets setup-bench-host setup-rp2040js setup-page-build
	@.ci/need "make bench" $(BENCH_PACKAGES)
	@tests/bench/fixmath-source $(BENCH)/fixmath

setup-rp2040js:
	@command -v npm >/dev/null || .ci/need "the emulator rp2040js" $(BENCH_EMULATOR_PACKAGES)
	@+$(SUBMAKE) -s $(BENCH_NPM)/done

# What package-lock.json says, checked by its hashes.
$(BENCH_NPM)/done: tests/bench/package.json tests/bench/package-lock.json
	@rm -rf $(@D) && mkdir -p $(@D) && cp $^ $(@D)
	@npm ci --prefix $(@D) --ignore-scripts --no-audit --no-fund --loglevel=error >$(BENCH)/npm.log 2>&1 || \
		{ tail -5 $(BENCH)/npm.log >&2; echo "make: npm could not install rp2040js" >&2; exit 1; }
	@touch $@

bench: ## measure: set up what is missing, measure cycles, instructions, code size and the host; tables, and build/bench/*.json
	@+$(SUBMAKE) setup-bench
	@+$(SUBMAKE) run-bench
	@+$(SUBMAKE) run-bench-host
	@+$(SUBMAKE) run-bench-stream
	@+$(SUBMAKE) run-bench-search
	@+$(SUBMAKE) run-bench-page

# Seconds instead of minutes: what one needs while making a loop faster.
bench-cycles: $(BENCH_ELFS) $(BENCH_MESH_ELFS) $(BENCH_SCENE)/scene.json ## measure: cycles on the Cortex-M0+ alone, n = 60: ROWS=PATTERN (exact), N="5 1000"; PROFILE=1: by function
	@+$(SUBMAKE) -s setup-rp2040js
	@node tests/bench/$(if $(PROFILE),profile,bench).mjs $(BENCH) '$(value ROWS)' $(N)

# Debian's clang of its own release does not know the core's units.
BENCH_HELIUM_PACKAGES = clang-19 llvm-19
bench-helium: ## measure: cycles of Helium's loops, predicted by llvm-mca's Cortex-M55
	@.ci/need "make bench-helium" $(BENCH_HELIUM_PACKAGES)
	@tests/bench/predict

run-bench: bench-programs
	@node tests/bench/bench.mjs $(BENCH)

bench-programs: $(BENCH_ELFS) $(BENCH_MESH_ELFS) $(BENCH_SCENE)/scene.json $(BENCH)/sizes.txt $(BENCH)/counts.txt

# The library, once for the two programs of a variant; one source at a time, since ccache knows only such compilations.
BENCH_COMPILE = arm-none-eabi-gcc -std=c99 -mcpu=cortex-m0plus -mthumb $(BENCH_FLAGS_$*) -ffunction-sections -fdata-sections
BENCH_LIB = $(BENCH)/lib-$*/libglint.a
$(BENCH)/lib-%/done: $(wildcard lib/*) tests/bench/bench.mk
	@rm -rf $(@D) && mkdir -p $(@D)
	@cd $(@D) && for source in $(abspath $(wildcard lib/*.c lib/*.S)); do $(BENCH_COMPILE) -c $$source || exit 1; done; \
		arm-none-eabi-ar rcs libglint.a *.o
	@touch $@
.PRECIOUS: $(BENCH)/lib-%/done

$(BENCH)/m0plus-%.elf: $(BENCH)/lib-%/done $(BENCH_INPUTS) tests/bench/calibrate.S
	@$(BENCH_COMPILE) $(BENCH_FLAGS) \
		-nostartfiles -T tests/bench/m0plus.ld $(filter-out lib/%,$(BENCH_SOURCES)) tests/bench/calibrate.S $(BENCH_LIB) -lm -o $@

$(BENCH)/mesh-%.elf: $(BENCH)/lib-%/done $(BENCH_MESH_SOURCES) $(BENCH_MESH_INPUTS) $(if $(BENCH_BUNNY),$(BENCH_MESH)/bunny.h) $(BENCH_INPUTS) tests/bench/calibrate.S
	@$(BENCH_COMPILE) -Ilib -I$(BENCH_MESH) -DMESH_BUNNY=$(if $(BENCH_BUNNY),1,0) \
		-nostartfiles -T tests/bench/m0plus.ld -Wl,--wrap=glint_mesh_rows $(BENCH_MESH_LINK) $(BENCH_MESH_SOURCES) tests/bench/calibrate.S $(BENCH_LIB) -o $@

$(BENCH)/lvgl-%.elf: $(BENCH)/lib-%/done $(BENCH_LVGL_SOURCES) $(wildcard tests/bench/mesh/*.h $(BENCH_LVGL)/*.h tests/packages/standins/lvgl*.h) $(BENCH_MESH)/teapot.h $(BENCH_INPUTS) tests/bench/calibrate.S
	@$(BENCH_COMPILE) -Ilib -I$(BENCH_MESH) -I$(BENCH_LVGL) -Itests/packages/standins \
		-nostartfiles -T tests/bench/m0plus.ld $(BENCH_LVGL_SOURCES) tests/bench/calibrate.S $(BENCH_LIB) -o $@

# As shipped: no normals of it are 180 degrees apart.
$(BENCH_MESH)/teapot.h: $(BUILD)/glint
	@mkdir -p $(@D)
	@$< bake --scene teapot --split 180 --name teapot --as c -o $@ >/dev/null
$(BENCH_MESH)/teapot_split.h: $(BUILD)/glint
	@mkdir -p $(@D)
	@$< bake --scene teapot --split 30 --no-outlines --name teapot_split --as c -o $@ >/dev/null
$(BENCH_MESH)/bunny.h: $(BUILD)/glint $(BENCH_BUNNY) tests/targets/test_bunny $(BOARDS)
	@mkdir -p $(@D)
	@PYTHONDONTWRITEBYTECODE=1 tests/targets/test_bunny $< obj | $< bake --mesh - --split 180 --no-outlines --name bunny --as c -o $@ >/dev/null

$(BENCH)/sizes.txt: tests/bench/sizes $(BENCH_INPUTS) $(BOARDS)
	@PYTHONDONTWRITEBYTECODE=1 $< $(BENCH) $(BENCH_BOARDS) >$@.tmp && mv $@.tmp $@

$(BENCH)/counts.txt: tests/bench/count $(BENCH_INPUTS) $(wildcard tests/bench/machine/*) $(BENCH_SCENE)/scene.json \
		$(BENCH_IMAGES) $(BOARDS) $(BENCH_MESH_SOURCES) $(BENCH_MESH_INPUTS)
	@PYTHONDONTWRITEBYTECODE=1 $< $(BENCH) $(BENCH_BOARDS) >$@.tmp && mv $@.tmp $@

$(BENCH_SCENE)/scene.json: $(BENCH_SCENE)/scene
	@$< write $(@D)

$(BENCH_SCENE)/scene: tests/bench/scene/scene.c tests/bench/sphere.c tests/bench/sphere.h $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	@$(CC) $(filter-out -MMD -MP,$(HOST_CFLAGS)) $(filter %.c %.o %.a,$^) -o $@ $(HOST_LDFLAGS) $(HOST_LDLIBS)

.PHONY: setup-bench setup-rp2040js bench bench-cycles bench-helium run-bench bench-programs
