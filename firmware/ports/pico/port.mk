# SPDX-License-Identifier: MIT
# The Raspberry Pi Pico with a panel, or a board that has one: make firmware PORT=pico [BOARD=pico [ARCH=riscv]] [PANEL=st7789-240x240] [ROTATE=90] [TE=21] [SECOND_CORE=1] [PATH=exact] [DEMO=teapot] [HEIGHT=FILE [BEVEL=8]] [MESH=FILE [SPLIT=30] [AXES=NAME]] [LANDING_PAGE=https://...] [IMAGE=conformance]
# Boards and panels are rows of tables; of each board a word, read once, since a program for each question would take seconds an image.
COMMA := ,
BLANK := $() $()
PICO_ROWS := $(shell sed -n 's/^BOARD(\(.*\))$$/\1/; T; s/, */,/g; p' firmware/ports/pico/boards.def)
# The columns of one board.
pico_columns = $(subst $(COMMA), ,$(filter $(subst $(BLANK),_,$(1))$(COMMA)%,$(PICO_ROWS)))
pico_BOARDS := $(foreach row,$(PICO_ROWS),$(firstword $(subst $(COMMA), ,$(row))))
# Those that an emulator runs; make test-pico reports the others as skipped.
pico_EMULATED := $(strip $(foreach board,$(pico_BOARDS),$(if $(filter rp2040,$(word 3,$(call pico_columns,$(board)))),$(board))))
PICO_BOARD = $(or $(BOARD),pico)
pico_fact = $(word $(1),$(call pico_columns,$(PICO_BOARD)))
pico_panel_of = $(word 4,$(call pico_columns,$(1)))
PANEL ?= $(or $(call pico_fact,4),none)
# The RP2350 has cores of two kinds: arm, or riscv.
ARCH ?= arm
PICO_COMPILER = $(if $(filter riscv,$(ARCH)),riscv64-unknown-elf-,arm-none-eabi-)
PICO_KIND = $(PICO_BOARD)$(filter-out -arm,-$(ARCH))
PICO_CHIP = $(call pico_fact,3)
PICO_PLATFORM = $(if $(filter riscv,$(ARCH)),-DPICO_PLATFORM=rp2350-riscv -DPICO_CLIB=picolibc -DCMAKE_TOOLCHAIN_FILE=$(abspath firmware/ports/pico/riscv/toolchain.cmake))
# glint, or conformance: that checks the board and measures its frame rate.
IMAGE ?= glint
# Each glass upright, and lying if it is not square.
PICO_PANELS := $(shell awk -F '[(), ]+' '$$1 == "GLASS" && $$2 != "SSD1306" { print tolower($$2) "-" $$3 "x" $$4; if ($$3 != $$4) print tolower($$2) "-" $$4 "x" $$3 }' firmware/core/panels.def)
# A panel on QSPI is wired as its board says.
PICO_QSPI = $(filter co5300-%,$(PANEL))
# Of these a release has an image; and of the boards that have a panel.
PICO_RELEASED = st7789-240x240 st7789-240x320 st7789-135x240 ili9341-240x320 ili9341-320x240 gc9a01-240x240
# The picture turned clockwise: 90, 180 or 270.
ROTATE ?= 0
PICO_TURNED = $(filter 90 270,$(ROTATE))
# The pin on which the panel's tearing line is wired, if it is.
TE ?=
# 1: both cores shade.
SECOND_CORE ?= 0
# PATH=exact: every pixel by an exact paint, not by tables; one core. Where commands are looked up is left as it was.
PICO_PATH := $(filter tables exact,$(PATH))
ifneq ($(PICO_PATH),)
override PATH := $(filter-out $(PICO_PATH),$(shell echo "$$PATH"))
override PATH := $(or $(PATH),/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
endif
PICO_EXACT = $(if $(filter exact,$(PICO_PATH)),1,0)
# The page that browsers offer when the board is plugged in; none: they offer none.
LANDING_PAGE ?=
# What the board shows by itself: coin or dial (a watch), a map under a light, or teapot, a mesh that turns. With an accelerometer a tap changes
# from dial to coin.
PICO_USUAL_DEMO = $(if $(PICO_HAS_IMU),dial,coin)
DEMO ?= $(PICO_USUAL_DEMO)
PICO_DEMOS = coin dial teapot
PICO_HAS_IMU = $(filter-out NONE,$(call pico_fact,13))
PICO_SCENE_coin = --scene coin $(if $(TE),,--cut-out)
PICO_SCENE_dial = --scene watchface
PICO_SCENES = $(if $(PICO_HAS_IMU),$(if $(PICO_MESH)$(HEIGHT)$(filter-out 240x240,$(PICO_SIZE)),,$(DEMO) $(filter-out $(DEMO),dial coin)))
# The whole of an AMOLED panel: its map is larger than RAM and flash; a palette is not.
PICO_PALETTE = $(if $(PICO_MESH),,$(if $(PICO_QSPI),$(filter 466x466,$(PICO_SIZE))))
PICO_PALETTE_SOURCE = $(if $(HEIGHT),--height $(call quoted,$(HEIGHT)),$(filter-out --cut-out,$(PICO_SCENE_$(filter coin dial,$(DEMO))))) --size $(PICO_SIZE)
# A file's name as a part of a folder's.
pico_named = $(if $(1),$(shell printf %s $(call quoted,$(basename $(notdir $(firstword $(1))))) | LC_ALL=C tr -c 'A-Za-z0-9._+-' _))
# With a tearing line a frame must fit in one scan of the panel: soft edges would take .2 ms too long, so the coin keeps its wall.
# Instead of the coin a height map of your own, at the panel's size; with BEVEL=N a logo, as glint bake has --bevel, with soft edges.
HEIGHT ?=
PICO_HEIGHT_NAME := $(call pico_named,$(HEIGHT))
BEVEL ?=
PICO_MAP_SOURCE = $(if $(HEIGHT),--height $(call quoted,$(HEIGHT)) $(BEVEL:%=--bevel % --cut-out),$(PICO_SCENE_$(filter coin dial,$(DEMO)))) --size $(PICO_SIZE)
# Or a mesh of your own, as glint bake takes it by --mesh, --split and --axes.
MESH ?=
PICO_MESH_NAME := $(call pico_named,$(MESH))
SPLIT ?= 30
AXES ?=
PICO_MESH = $(if $(MESH),mesh-$(PICO_MESH_NAME),$(filter teapot,$(DEMO)))
PICO_MESH_SOURCE = --no-outlines $(if $(MESH),--mesh $(call quoted,$(MESH)) --no-textures --split $(SPLIT) $(AXES:%=--axes %),--scene teapot --split 180)
# Up to here it is in RAM, where it is drawn in fewer cycles.
PICO_MESH_RAM = 12288
# On an AMOLED panel in its middle, or the whole of it, whose strips of two cores would take all RAM.
PICO_AMOLED_MESHES = $(if $(PICO_QSPI),$(if $(filter arm,$(ARCH)),$(foreach chip,rp2040 rp2350,$(chip).240x240.0.glint $(if $(filter 0,$(SECOND_CORE)),$(chip).466x466.0.glint))))
PICO_FREE_PINS = $(filter-out $(foreach column,6 7 8 9 10 11 12 $(if $(PICO_HAS_IMU),14 15),$(call pico_fact,$(column))),1 2 3 4 5 6 7 14 15 16 17 18 19 20 21 22 26 27 28)
# Of choices that are refused, too, it is one word.
PICO = $(subst $(BLANK),_,build/firmware/$(PICO_KIND)-$(PANEL)$(patsubst %,-turned-%,$(filter-out 0,$(ROTATE)))$(patsubst %,-te%,$(firstword $(TE)))$(if $(filter 1,$(SECOND_CORE)),-two-cores)$(if $(filter 1,$(PICO_EXACT)),-exact)$(PICO_MESH:%=-%)$(patsubst %,-%,$(filter-out $(PICO_USUAL_DEMO) teapot,$(DEMO)))$(if $(HEIGHT),-map-$(PICO_HEIGHT_NAME))$(BEVEL:%=-bevel%)$(if $(LANDING_PAGE),-landing))
PICO_SIDES = $(subst x, ,$(lastword $(subst -, ,$(PANEL))))
PICO_SIZE = $(if $(PICO_TURNED),$(lastword $(PICO_SIDES))x$(firstword $(PICO_SIDES)),$(lastword $(subst -, ,$(PANEL))))

pico_PACKAGES = cmake make python3-minimal gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib
pico_riscv_PACKAGES = gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf
setup-firmware-pico: setup-build
	@.ci/need "firmware for the Pico" $(pico_PACKAGES) $(if $(filter riscv,$(ARCH)),$(pico_riscv_PACKAGES))
	@firmware/ports/pico/fetch-sdk >/dev/null

# Before anything is made of them.
have-pico-choices:
	@$(foreach choice,BOARD ARCH PANEL ROTATE DEMO IMAGE BEVEL AXES,$(if $(word 2,$($(choice))),echo "make: $(choice)=$($(choice)): say one" >&2; exit 1;))
	@$(if $(filter glint conformance,$(IMAGE)),,echo "make: IMAGE=$(IMAGE): the images are glint and conformance" >&2; exit 1)
	@$(if $(filter $(pico_BOARDS),$(PICO_BOARD)),,echo "make: port pico has no board $(PICO_BOARD); choose from $(pico_BOARDS)" >&2; exit 1)
	@$(if $(or $(filter arm,$(ARCH)),$(filter riscv-rp2350,$(ARCH)-$(PICO_CHIP))),,echo "make: ARCH=$(ARCH): is arm, or on a board with an RP2350 riscv" >&2; exit 1)
	@$(if $(filter $(PICO_PANELS),$(PANEL)),,echo "make: PANEL=$(PANEL): the panels are $(PICO_PANELS)" >&2; exit 1)
	@$(if $(and $(filter 1 3,$(call pico_fact,5)),$(filter-out $(firstword $(PICO_SIDES)),$(PICO_SIDES))),echo "make: PANEL=$(PANEL): is not square$(COMMA) so boards.def has to say 0 or 2 quarter turns of $(PICO_BOARD)$(COMMA) not $(call pico_fact,5); that its picture lies$(COMMA) the panel's name says" >&2; exit 1)
	@$(if $(filter 0 90 180 270,$(ROTATE)),,echo "make: ROTATE=$(ROTATE): say 0, 90, 180 or 270" >&2; exit 1)
	@$(if $(filter-out $(PICO_FREE_PINS),$(TE))$(word 2,$(TE)),echo "make: TE=$(TE): is one pin$(COMMA) and those that are free are $(PICO_FREE_PINS)" >&2; exit 1)
	@$(if $(filter x0 x1,x$(subst $(BLANK),_,$(SECOND_CORE))),,echo "make: SECOND_CORE=$(SECOND_CORE): say 0 or 1" >&2; exit 1)
	@$(if $(PICO_QSPI)$(filter co5300-%,$(call pico_fact,4)),$(if $(and $(PICO_QSPI),$(filter co5300-%,$(call pico_fact,4)),$(filter 0,$(ROTATE)),$(if $(TE),,1)),,echo "make: PANEL=$(PANEL)$(COMMA) BOARD=$(PICO_BOARD): AMOLED panels (co5300) are for the boards that have one$(COMMA) which take no others; leave ROTATE and TE out" >&2; exit 1))
	@$(if $(filter 11,$(SECOND_CORE)$(PICO_EXACT)),echo "make: PATH=exact: draws with one core; leave SECOND_CORE=1 out" >&2; exit 1)
	@case "$$LANDING_PAGE" in '') ;; *[!A-Za-z0-9._~:/?%=\&+,@-]*) false ;; https://?* | http://localhost | http://localhost[:/]*) [ $${#LANDING_PAGE} -le 252 ] ;; *) false ;; esac || \
		{ printf 'make: LANDING_PAGE=%s: browsers take https://... or http://localhost..., this one of at most 252 letters, digits and ._~:/?%%=&+,@-\n' "$$LANDING_PAGE" >&2; exit 1; }
	@$(if $(filter $(PICO_DEMOS),$(DEMO)),,echo "make: DEMO=$(DEMO): the demos are $(PICO_DEMOS)" >&2; exit 1)
	@$(if $(PICO_MESH),$(if $(filter rp2040.240x240.0.glint $(PICO_AMOLED_MESHES),$(call pico_fact,3).$(PICO_SIZE).$(PICO_EXACT)$(TE).$(IMAGE)),,echo "make: "$(call quoted,$(if $(MESH),MESH=$(MESH),DEMO=teapot))": is for an RP2040 with a panel of 240x240$(COMMA) or an AMOLED panel$(COMMA) whole with one core; leave TE, PATH, IMAGE and ARCH out" >&2; exit 1))
	@$(if $(word 2,$(MESH)),echo "make: "$(call quoted,MESH=$(MESH))": make takes no file whose name has a blank; rename it" >&2; exit 1)
	@$(if $(word 2,$(HEIGHT)),echo "make: "$(call quoted,HEIGHT=$(HEIGHT))": make takes no file whose name has a blank; rename it" >&2; exit 1)
	@$(if $(and $(BEVEL),$(if $(HEIGHT),,1)),echo "make: BEVEL=$(BEVEL): is for a logo; give HEIGHT=FILE with it" >&2; exit 1)
	@$(if $(and $(HEIGHT),$(PICO_MESH)),echo "make: "$(call quoted,HEIGHT=$(HEIGHT))": the board shows a map or a mesh; leave "$(call quoted,$(if $(MESH),MESH=$(MESH),DEMO=teapot))" out" >&2; exit 1)
	@$(if $(PICO_PALETTE),$(if $(filter 0.0.glint.,$(SECOND_CORE).$(PICO_EXACT).$(IMAGE).$(BEVEL)),,echo "make: PANEL=$(PANEL): a palette is drawn on the whole of it$(COMMA) exactly$(COMMA) by one core and without soft edges; leave SECOND_CORE$(COMMA) PATH$(COMMA) IMAGE and BEVEL out" >&2; exit 1))
	@$(if $(filter-out $(shell seq 180),$(SPLIT))$(word 2,$(SPLIT)),echo "make: SPLIT=$(SPLIT): say whole degrees from 1 to 180" >&2; exit 1)
	@$(foreach choice,SPLIT AXES,$(if $(filter command,$(origin $(choice))),$(if $(MESH),,echo "make: $(choice)=$($(choice)): is for a mesh of your own; give MESH=FILE with it" >&2; exit 1;)))

# CMake knows what depends on what within. Its messages would run a program for each object, which takes longer than a compiler with a cache.
firmware-pico: have-pico-choices $(PICO)/map/$(if $(PICO_MESH),demo_mesh.h,$(if $(PICO_PALETTE),demo_palette.h,demo_map.h)) $(if $(PICO_SCENES),$(PICO)/map/demo_scenes.h) $(BUILD)/bin2uf2 $(CONFORMANCE_EXPECTED)
	@sdk=$$(firmware/ports/pico/fetch-sdk) && export PICO_SDK_PATH="$$sdk/pico-sdk" && \
	cmake -S firmware/ports/pico -B $(PICO)/cmake -DCMAKE_BUILD_TYPE=Release -DCMAKE_RULE_MESSAGES=OFF -DPICO_BOARD=$(subst -,_,$(PICO_BOARD)) $(PICO_PLATFORM) -DPICO_NO_PICOTOOL=1 -DPICO_BOARD_HEADER_DIRS="$(CURDIR)/firmware/ports/pico/boards" \
		-DPICO_SDK_PATH="$$sdk/pico-sdk" -DPICO_TINYUSB_PATH="$$sdk/tinyusb" -DGLINT_BOARD=$(PICO_BOARD) -DGLINT_PANEL=$(PANEL) -DGLINT_ROTATE=$(ROTATE) -DGLINT_TE=$(or $(TE),-1) -DGLINT_SECOND_CORE=$(SECOND_CORE) -DGLINT_EXACT=$(PICO_EXACT) -DGLINT_TURNS_MESH=$(if $(PICO_MESH),1,0) -DGLINT_SCENES=$(if $(PICO_SCENES),1,0) -DGLINT_SHOWS_PALETTE=$(if $(PICO_PALETTE),1,0) -DGLINT_MESH_IN_RAM=$$(find $(PICO)/map/demo_mesh.bin -size -$(PICO_MESH_RAM)c 2>/dev/null | wc -l) '-DGLINT_LANDING_PAGE=$(LANDING_PAGE)' \
		-DGLINT_MAP="$(CURDIR)/$(PICO)/map" -DGLINT_EXPECTED="$(abspath $(CONFORMANCE))" >$(PICO)/log 2>&1 && \
	MAKEFLAGS= cmake --build $(PICO)/cmake --target $(IMAGE) $(call parallel,1) >>$(PICO)/log 2>&1 || { grep -o 'glint: over.*' $(PICO)/log >&2 && $(if $(MESH),echo "make: "$(call quoted,MESH=$(MESH))": a mesh takes 16 bytes of RAM a vertex and 2 a triangle$(if $(filter 1,$(SECOND_CORE)),$(COMMA) for each core): simplify it$(COMMA) or leave its edges whole by SPLIT=180",:) >&2 || grep rror $(PICO)/log >&2; \
		echo "make: the Pico's firmware was not built; the whole log is $(PICO)/log" >&2; exit 1; }
	@grep -A 3 'warning:' $(PICO)/log || true
	@cp $(PICO)/cmake/$(IMAGE).elf $(PICO)/ && $(BUILD)/bin2uf2 $(if $(filter rp2350,$(PICO_CHIP)),pico2,pico)$(filter-out -arm,-$(ARCH)) $(PICO)/cmake/$(IMAGE).bin $(PICO)/$(IMAGE).uf2
	@$(PICO_COMPILER)size $(PICO)/$(IMAGE).elf | awk 'NR == 2 { printf "$(PICO)/$(IMAGE).uf2: %d bytes of flash, %d of RAM\n", $$1 + $$2, $$2 + $$3 }'

$(BUILD)/bin2uf2: firmware/ports/pico/tools/bin2uf2.c $(BUILD)/host/bake/uf2.o
	@$(CC) $(filter-out -MMD -MP,$(HOST_CFLAGS)) $^ -o $@

$(PICO)/map/demo_map.h: $(BUILD)/glint $(if $(HEIGHT)$(BEVEL),always) | have-pico-choices
	@mkdir -p $(@D)
	@$< bake $(PICO_MAP_SOURCE) --to int8 -o $(@D)/demo_map.bin >/dev/null
	@$< bake $(PICO_MAP_SOURCE) --to int8 --name demo_map --as c -o $@.tmp >/dev/null
	@cksum <$(@D)/demo_map.bin | awk '{ soft = $$2 - 4 * $(subst x, * ,$(PICO_SIZE)); print "#define DEMO_MAP_CKSUM " $$1 "u"; \
		print "#define DEMO_COVERAGE " (soft ? "demo_map_coverage" : "NULL"); print "#define DEMO_COVERAGE_BYTES " soft }' >>$@.tmp
	@cmp -s $@.tmp $@ || mv $@.tmp $@

$(BUILD)/pack_scenes: firmware/ports/pico/tools/pack_scenes.c $(BUILD)/firmware/core/cksum.o
	@$(CC) $(filter-out -MMD -MP,$(HOST_CFLAGS)) $^ -o $@ -llz4

$(PICO)/map/demo_scenes.h: $(BUILD)/glint $(BUILD)/pack_scenes | have-pico-choices
	@mkdir -p $(@D)
	@$(foreach scene,$(PICO_SCENES),$< bake $(PICO_SCENE_$(scene)) --size $(PICO_SIZE) --to int8 -o $(@D)/scene-$(scene).bin >/dev/null &&) \
		$(BUILD)/pack_scenes $(PICO_SIZE) $(PICO_SCENES:%=$(@D)/scene-%.bin) >$@.tmp && mv $@.tmp $@

$(BUILD)/pack_palette: firmware/ports/pico/tools/pack_palette.c $(BUILD)/firmware/core/cksum.o $(BUILD)/firmware/core/panel.o
	@$(CC) $(filter-out -MMD -MP,$(HOST_CFLAGS)) $^ -o $@

$(PICO)/map/demo_palette.h: $(BUILD)/glint $(BUILD)/pack_palette $(if $(HEIGHT),always) | have-pico-choices
	@mkdir -p $(@D)
	@$< bake $(PICO_PALETTE_SOURCE) --to palette -o $(@D)/demo_palette.bin >/dev/null
	@$(BUILD)/pack_palette $(PANEL) $(@D)/demo_palette.bin >$@.tmp
	@cmp -s $@.tmp $@ || mv $@.tmp $@

# The teapot as it is, unsplit: what turns hides where its highlights break. A file's each time, since MESH, SPLIT and AXES may be others
# by now. The head of 8 bytes has the counts; the checksum is without it and what follows the triangles: 6 bytes of each part and 3 of each vertex that
# has a colour.
$(PICO)/map/demo_mesh.h: $(BUILD)/glint $(if $(MESH),always) | have-pico-choices
	@mkdir -p $(@D)
	@$< bake $(PICO_MESH_SOURCE) --to int8 -o $(@D)/demo_mesh.bin >/dev/null
	@$< bake $(PICO_MESH_SOURCE) --to int8 --name demo_mesh --as c -o $@.tmp >/dev/null
	@set -- $$(od -An -tu2 -N8 $(@D)/demo_mesh.bin); [ $$3 = 1 ] || echo "make: "$(call quoted,MESH=$(MESH))": has $$3 materials; the board draws it in one" >&2; \
		[ $$4 -lt 256 ] || echo "make: "$(call quoted,MESH=$(MESH))": its vertices have colours; the board draws it in one" >&2; \
		cksum=$$(tail -c +9 $(@D)/demo_mesh.bin | head -c -$$(($$3 * 6 + $$4 / 256 * $$1 * 3)) | cksum | cut -d ' ' -f 1); \
		printf '#define DEMO_MESH_%s\n' "VERTICES $$1" "FACES $$2" "CKSUM $${cksum}u" "SPLIT $(if $(MESH),$(SPLIT),180)" >$(@D)/demo_mesh_sizes.h.tmp
	@cmp -s $(@D)/demo_mesh_sizes.h.tmp $(@D)/demo_mesh_sizes.h || mv $(@D)/demo_mesh_sizes.h.tmp $(@D)/demo_mesh_sizes.h
	@cmp -s $@.tmp $@ || mv $@.tmp $@

.PHONY: setup-firmware-pico firmware-pico have-pico-choices
