# SPDX-License-Identifier: MIT
# Tier pico: the unmodified firmware image in an emulated RP2040 (rp2040js, the version that package-lock.json of tests/bench
# pins); its panel's pins are judged by the host's virtual panel. At the end a real kernel, that of tier lab, is the host.
PICO_PANELS_TESTED = st7789-240x240 ili9341-320x240
PICO_TE_TESTED = 21
PICO_TOOLS = judge attach cores
# What is built; boards that nothing emulates, to see that they build.
PICO_NOT_RUN = $(filter-out $(pico_EMULATED),$(pico_BOARDS))
# The address in the image with TE: one image less to build.
PICO_LANDING_TESTED = https://example.org/glint
# A round panel, turned; and the boards that have a panel.
PICO_ROUND_TESTED = gc9a01-240x240
PICO_READY_TESTED = $(filter-out pico $(PICO_AMOLED_TESTED),$(pico_EMULATED))
# The board that stands for those with an AMOLED panel; and a dial and a mesh on the whole of it.
PICO_AMOLED_TESTED = pico-amoled
PICO_AMOLED_WHOLE = co5300-466x466
PICO_MESH_TESTED = $(BUILD)/tests/pico/bunny.obj
PICO_BUILT = $(PICO_NOT_RUN:%=BOARD=%) $(PICO_READY_TESTED:%=BOARD=%) $(PICO_READY_TESTED:%=BOARD=%+DEMO=teapot+SECOND_CORE=1) BOARD=$(PICO_AMOLED_TESTED) BOARD=$(PICO_AMOLED_TESTED)+PANEL=$(PICO_AMOLED_WHOLE) BOARD=$(PICO_AMOLED_TESTED)+PANEL=$(PICO_AMOLED_WHOLE)+DEMO=teapot PANEL=$(PICO_ROUND_TESTED)+ROTATE=90 $(PICO_PANELS_TESTED:%=PANEL=%) TE=$(PICO_TE_TESTED)+LANDING_PAGE=$(PICO_LANDING_TESTED) SECOND_CORE=1 PATH=exact DEMO=teapot DEMO=teapot+SECOND_CORE=1 MESH=$(PICO_MESH_TESTED)+SPLIT=180
PICO_TEST = node tests/pico/test_$(1).mjs $(BENCH_NPM) build/firmware/pico-$(panel)$(2) $(panel) $(BUILD)/tests/pico/judge
PICO_CORES = $(patsubst %,firmware/core/%.c,relight turntable pieces panel demo orbit) $(wildcard lib/*.c)

setup-pico: setup-build setup-firmware-pico setup-lab setup-rp2040js setup-page-build

test-pico: ## check: the Pico's firmware emulated: boot, panel, the demo's frames, USB, a real kernel's drivers; cycles
	@+tests/tier pico "$(SUBMAKE)"

# Two at a time, since half of CMake's work uses one core. The conformance image is built in the first one's folder. Paths below
# ours are relative for ccache, if that is there: the SDK's objects of one image are those of the next. Boards differ: one of each goes first.
pico-images: $(BUILD)/glint $(PICO_MESH_TESTED) $(BUILD)/bin2uf2 $(CONFORMANCE_EXPECTED)
	@firmware/ports/pico/fetch-sdk >/dev/null
	@+printf '%s\n' $(PICO_BUILT) | tr + ' ' | CCACHE_BASEDIR="$(CURDIR)" xargs -P 2 -L 1 $(SUBMAKE) -s firmware-pico
	@+CCACHE_BASEDIR="$(CURDIR)" $(SUBMAKE) -s firmware-pico IMAGE=conformance && CCACHE_BASEDIR="$(CURDIR)" $(SUBMAKE) -s firmware-pico IMAGE=conformance SECOND_CORE=1

# What takes longest goes first. LAB_*: as in tier lab.
run-pico: pico-images $(PAGE)/index.html $(PICO_TOOLS:%=$(BUILD)/tests/pico/%) $(addprefix $(BUILD)/tests/lab/,init spi.dtb)
	@LAB_KERNEL=$$(tests/lab/kernel) LAB_BUILD=$(CURDIR)/$(BUILD) && \
		export LAB_KERNEL LAB_BUILD && tests/tally \
		$(foreach board,$(PICO_READY_TESTED),$(foreach part,hand faults,"node tests/pico/test_hand.mjs $(BENCH_NPM) build/firmware/$(board)-$(call pico_panel_of,$(board)) $(call pico_panel_of,$(board)) $(BUILD)/tests/pico/judge $(part)")) \
		$(foreach board,$(PICO_READY_TESTED),"tests/lab/guest --time basic --memory 1024 $(BUILD)/tests/pico/attach node tests/pico/test_end_hand.mjs $(BENCH_NPM) build/firmware/$(board)-$(call pico_panel_of,$(board)) $(call pico_panel_of,$(board)) $(BUILD)/tests/pico/judge $(BUILD)/glint") \
		$(foreach panel,st7789-240x240,"$(call PICO_TEST,faults)" \
		"tests/lab/guest --time basic --memory 1024 $(BUILD)/tests/pico/attach $(call PICO_TEST,end_to_end) $(BUILD)/glint" \
		"tests/lab/guest --time basic --memory 1024 $(BUILD)/tests/pico/attach $(call PICO_TEST,pose,-teapot) $(BUILD)/glint" \
		"tests/lab/guest --time basic --memory 1024 $(BUILD)/tests/pico/attach $(call PICO_TEST,pose,-mesh-bunny) $(BUILD)/glint $(PICO_MESH_TESTED)" \
		"tests/lab/guest --memory 1024 $(call PICO_TEST,webusb) $(BUILD)/glint $(PAGE)" \
		"tests/lab/guest --time basic --memory 1024 $(call PICO_TEST,webusb_pose,-teapot) $(PAGE)" \
		"$(call PICO_TEST,light)" "$(call PICO_TEST,te,-te$(PICO_TE_TESTED)-landing) $(PICO_TE_TESTED) $(PICO_LANDING_TESTED)" \
		"$(call PICO_TEST,second_core,-two-cores)" "$(call PICO_TEST,exact,-exact)" \
		"$(call PICO_TEST,teapot,-two-cores-teapot) both" "$(call PICO_TEST,teapot,-teapot)") \
		"node tests/pico/test_round.mjs $(BENCH_NPM) build/firmware/pico-$(PICO_ROUND_TESTED)-turned-90 $(PICO_ROUND_TESTED) $(BUILD)/tests/pico/judge" \
		$(foreach board,$(PICO_READY_TESTED),"node tests/pico/test_teapot.mjs $(BENCH_NPM) build/firmware/$(board)-$(call pico_panel_of,$(board))-two-cores-teapot $(call pico_panel_of,$(board)) $(BUILD)/tests/pico/judge both") \
		$(foreach panel,$(call pico_panel_of,$(PICO_AMOLED_TESTED)) $(PICO_AMOLED_WHOLE),"node tests/pico/test_amoled.mjs $(BENCH_NPM) build/firmware/$(PICO_AMOLED_TESTED)-$(panel) $(panel) $(BUILD)/tests/pico/judge") \
		"node tests/pico/test_teapot.mjs $(BENCH_NPM) build/firmware/$(PICO_AMOLED_TESTED)-$(PICO_AMOLED_WHOLE)-teapot $(PICO_AMOLED_WHOLE) $(BUILD)/tests/pico/judge" \
		"node tests/pico/test_conformance.mjs $(BENCH_NPM) build/firmware/pico-st7789-240x240 $(CONFORMANCE_EXPECTED)" \
		"node tests/pico/test_conformance.mjs $(BENCH_NPM) build/firmware/pico-st7789-240x240-two-cores $(CONFORMANCE_EXPECTED) both" \
		$(foreach panel,$(PICO_PANELS_TESTED),"$(call PICO_TEST,demo)" "$(call PICO_TEST,usb)") \
		"tests/pico/test_cores $(BUILD)/tests/pico/cores" \
		"tests/pico/test_image build/firmware/pico-st7789-240x240/glint.uf2 st7789-240x240" $(foreach board,$(PICO_NOT_RUN),"echo ok 1 - $(board) # SKIP nothing emulates it")

# The bunny that npm installs beside the emulator.
$(PICO_MESH_TESTED): $(BENCH_NPM)/done tests/targets/test_bunny $(BOARDS)
	@mkdir -p $(@D)
	@PYTHONDONTWRITEBYTECODE=1 tests/targets/test_bunny $(BUILD)/glint obj >$@.tmp && mv $@.tmp $@

$(BUILD)/tests/pico/judge: tests/pico/judge.c $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	@$(CC) $(filter-out -MMD -MP,$(HOST_CFLAGS)) $^ -o $@ $(HOST_LDFLAGS) $(HOST_LDLIBS)

$(BUILD)/tests/pico/attach: tests/pico/attach.c
	@mkdir -p $(@D)
	@$(CC) -std=c11 -D_GNU_SOURCE $(WARNINGS) $(CFLAGS) $< -o $@

$(BUILD)/tests/pico/cores: tests/pico/cores.c $(PICO_CORES) $(wildcard firmware/core/*.h lib/*.h)
	@mkdir -p $(@D)
	@$(CC) -std=c11 -Ilib -Ifirmware/core $(WARNINGS) -O1 -g -fsanitize=thread $(filter %.c,$^) -o $@ -pthread

hwtest: ## check: a Raspberry Pi Pico that is plugged in (BOOTSEL held) and its frame rate; a report to send in
	@$(PLUS)tests/hwtest "$(SUBMAKE)"

.PHONY: setup-pico test-pico pico-images run-pico hwtest
