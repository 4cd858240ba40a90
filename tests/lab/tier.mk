# SPDX-License-Identifier: MIT
# Tier lab: programs under a Linux kernel of our own, which is an ordinary process on the host's files: simulated GPIO lines
# and USB. tests/lab/guest runs a command in it; every tests/lab/test_*.c is a cmocka program that runs there, linked with
# LAB_COMMON; every other tests/lab/test_* is a script that speaks TAP and runs outside.
include tests/lab/fuzz.mk

LAB_PACKAGES = linux-source-6.1 bc bison flex xz-utils libcmocka-dev libgpiod-dev libtraceevent-dev libusb-1.0-0-dev \
	libdrm-dev sigrok-cli
LAB_CFLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Itests/unit -Itests/lab $(CFLAGS) $(SANITIZERS)
LAB_HOST_CFLAGS = -Ilib -Ihost -Ifirmware/core $(SINK_FLAGS) $(shell pkg-config --cflags $(HOST_LIBS) $(SINK_LIBS) 2>/dev/null)
LAB_COMMON = $(patsubst %,$(BUILD)/tests/lab/%.o,chip capture bus screen sigrok run process usbip known card)
LAB_GUEST_FILES = $(addprefix $(BUILD)/tests/lab/,init spi.dtb)
LAB_TESTS = $(patsubst tests/lab/test_%.c,$(BUILD)/tests/lab/test_%,$(filter-out tests/lab/test_usb_%,$(wildcard tests/lab/test_*.c)))
# The usb sink: some of these call it, some run the command; the display is their own or the firmware's.
LAB_USB_TESTS = $(patsubst tests/lab/%.c,$(BUILD)/tests/lab/%,$(wildcard tests/lab/test_usb_*.c tests/lab/usb_rate.c))
LAB_USB_DISPLAY = $(patsubst %,$(BUILD)/tests/lab/%.o,usb_display usb_function)
LAB_GADGET = $(CURDIR)/$(linux)/glint-gadget
LAB_FAULTY_GADGET = $(CURDIR)/$(linux)/faulty-gadget
# In virtual time, so that what waits and what has a time limit does so on any machine: not what measures rates.
LAB_USB_GUEST = env GLINT=$(CURDIR)/$(BUILD)/glint GADGET=$(LAB_GADGET) tests/lab/guest
LAB_GADGET_GUEST = env GADGET=$(LAB_GADGET) tests/lab/guest --time inf
LAB_LIBGPIOD2 = PKG_CONFIG_PATH="$$(tests/lab/libgpiod2)"
# The command with libgpiod as installed, and with its version 2.
LAB_BOTH_BUILDS = $(BUILD) build/gpiod2
# With none of it the fuzzers are not built, either. Above the rules, whose prerequisites are expanded as they are read.
LAB_FUZZ = tests/lab/test_fuzz

$(BUILD)/tests/lab/%.o: tests/lab/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(LAB_CFLAGS) -c $< -o $@

$(LAB_TESTS): %: %.o $(LAB_COMMON)
	$(CC) $(HOST_LDFLAGS) $< $(LAB_COMMON) -o $@ -lcmocka -ltraceevent

$(LAB_USB_TESTS:%=%.o) $(LAB_USB_DISPLAY) $(BUILD)/tests/lab/gpio_rate.o: LAB_CFLAGS += $(LAB_HOST_CFLAGS)
$(LAB_USB_TESTS): %: %.o $(LAB_USB_DISPLAY) $(HOST_ARCHIVES)
	$(CC) $(HOST_LDFLAGS) $^ -o $@ -lcmocka $(HOST_LDLIBS)

$(addprefix $(BUILD)/tests/lab/,test_gud_drm.o card.o): LAB_CFLAGS += $$(pkg-config --cflags libdrm)

# By libgpiod as installed, and by its version 2.
$(BUILD)/tests/lab/bitbang1: $(patsubst %,$(BUILD)/tests/lab/%.o,bitbang known lines1)
	$(CC) $(HOST_LDFLAGS) $^ -o $@ -lgpiod

$(BUILD)/tests/lab/bitbang2: $(patsubst %,$(BUILD)/tests/lab/%.o,bitbang known lines2)
	$(CC) $(HOST_LDFLAGS) $^ -o $@ $$($(LAB_LIBGPIOD2) pkg-config --libs libgpiod)

$(BUILD)/tests/lab/lines2.o: tests/lab/lines2.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(LAB_CFLAGS) $$($(LAB_LIBGPIOD2) pkg-config --cflags libgpiod) -c $< -o $@

# The guest's first program, and its hardware.
$(BUILD)/tests/lab/init: tests/lab/init.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) -std=c11 -D_GNU_SOURCE $(WARNINGS) -O2 -static $< -o $@

$(BUILD)/tests/lab/spi.dtb: tests/lab/spi.dts
	@mkdir -p $(@D)
	kernel=$$(tests/lab/kernel) && "$$kernel/dtc" -q -O dtb -o $@ $<

# Calls that set lines, by either version.
$(BUILD)/tests/lab/gpio_rate: %: %.o $(LAB_COMMON) $(HOST_ARCHIVES)
	$(CC) $(HOST_LDFLAGS) $^ -o $@ -lcmocka -ltraceevent $(HOST_LDLIBS)

setup-lab: setup-build setup-fuzz
	@.ci/need "tier lab (a Linux kernel to build, its GPIO and USB, sigrok's decoders)" $(LAB_PACKAGES)

test-lab: ## check: under a Linux kernel as a process: GPIO lines captured and decoded, also by sigrok; USB
	@+tests/tier lab "$(SUBMAKE)"

usb-programs: $(LAB_USB_TESTS) $(BUILD)/glint firmware-linux $(LAB_GUEST_FILES)

lab-programs: usb-programs $(LAB_TESTS) $(addprefix $(BUILD)/tests/lab/,bitbang1 bitbang2) $(if $(LAB_FUZZ),$(LAB_FUZZERS) $(LAB_SEEDS)) $(linux)/faulty-gadget

# The command with libgpiod 2.
glint-gpiod2:
	@$(PLUS)$(LAB_LIBGPIOD2) $(SUBMAKE) BUILD=build/gpiod2 all

# What takes longest goes first: of what is built the kernel, of what runs the programs that compute. The others mostly
# wait for USB.
run-lab: $(BUILD)/tests/lab/spi.dtb $(BUILD)/glint glint-gpiod2 lab-programs
	@LAB_KERNEL=$$(tests/lab/kernel) LAB_BUILD=$(CURDIR)/$(BUILD) && \
		export LAB_KERNEL LAB_BUILD && tests/tally \
		$(foreach build,$(LAB_BOTH_BUILDS),"env GLINT=$(CURDIR)/$(build)/glint tests/lab/guest --memory 768 \
			$(BUILD)/tests/lab/test_gpio_stream") $(LAB_FUZZ) \
		"env GADGET=$(LAB_GADGET) FAULTY=$(LAB_FAULTY_GADGET) tests/lab/guest --time inf $(BUILD)/tests/lab/test_gud_drm" \
		"env BITBANG=$(CURDIR)/$(BUILD)/tests/lab/bitbang1 tests/lab/guest $(BUILD)/tests/lab/test_gpio" \
		"env BITBANG=$(CURDIR)/$(BUILD)/tests/lab/bitbang2 tests/lab/guest $(BUILD)/tests/lab/test_gpio" \
		$(filter-out %.c tests/lab/test_fuzz,$(wildcard tests/lab/test_*)) \
		$(patsubst %,"$(LAB_USB_GUEST) --time inf --seconds 5000 %",$(filter $(BUILD)/tests/lab/test_%,$(LAB_USB_TESTS))) \
		$(foreach build,$(LAB_BOTH_BUILDS),"env GLINT=$(CURDIR)/$(build)/glint tests/lab/guest --time basic --seconds 5000 $(BUILD)/tests/lab/test_gpio_faults") \
		"env GLINT=$(CURDIR)/$(BUILD)/glint tests/lab/guest --spi $(BUILD)/tests/lab/test_spidev" \
		$(patsubst %,"$(LAB_GADGET_GUEST) $(BUILD)/tests/lab/test_gud_%",kernel ends host)

usb-rate: usb-programs ## measure: the usb sink's rate beside a bare loop of libusb calls, to the same simulated display
	@LAB_BUILD=$(CURDIR)/$(BUILD) $(LAB_USB_GUEST) $(BUILD)/tests/lab/usb_rate

gpio-rate: $(BUILD)/tests/lab/gpio_rate $(LAB_GUEST_FILES) ## measure: ns of a call that sets lines, beside a bare loop of its ioctl
	@$(PLUS)$(LAB_LIBGPIOD2) $(SUBMAKE) BUILD=build/gpiod2 build/gpiod2/tests/lab/gpio_rate
	@export LAB_BUILD=$(CURDIR)/$(BUILD); for build in $(LAB_BOTH_BUILDS); do \
		tests/lab/guest $$build/tests/lab/gpio_rate | grep '^libgpiod' || exit 1; done

.PHONY: gpio-rate usb-programs usb-rate glint-gpiod2 setup-lab test-lab run-lab lab-programs
