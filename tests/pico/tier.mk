# SPDX-License-Identifier: MIT
# Tier pico: the unmodified firmware image in an emulated RP2040 (rp2040js, the version that package-lock.json of tests/bench
# pins); its panel's pins are judged by the host's virtual panel.
PICO_PANELS_TESTED = st7789-240x240 ili9341-320x240

setup-pico: setup-build setup-firmware-pico
	@command -v npm >/dev/null || .ci/need "tier pico: the emulator rp2040js" nodejs npm
	@+$(SUBMAKE) -s $(BENCH_NPM)/done

test-pico: ## the Pico's firmware emulated: boot, panel, the demo's frames, USB; cycles
	@+tests/tier pico "$(SUBMAKE)"

run-pico: $(BUILD)/tests/pico/judge
	@+for panel in $(PICO_PANELS_TESTED); do $(SUBMAKE) -s firmware-pico PANEL=$$panel || exit 1; done
	@tests/tally $(foreach panel,$(PICO_PANELS_TESTED),$(call PICO_TEST,demo) $(call PICO_TEST,usb)) \
		$(foreach panel,st7789-240x240,$(call PICO_TEST,light))
PICO_TEST = "node tests/pico/test_$(1).mjs $(BENCH_NPM) build/firmware/pico-$(panel) $(panel) $(BUILD)/tests/pico/judge"

$(BUILD)/tests/pico/judge: tests/pico/judge.c $(filter-out $(BUILD)/host/main.o,$(HOST_OBJECTS)) $(BUILD)/libglint.a
	@mkdir -p $(@D)
	@$(CC) $(filter-out -MMD -MP,$(HOST_CFLAGS)) $^ -o $@ $(HOST_LDFLAGS) $(HOST_LDLIBS)

.PHONY: setup-pico test-pico run-pico
