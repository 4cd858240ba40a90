# SPDX-License-Identifier: MIT
# Tier lab: programs under a Linux kernel of our own, which is an ordinary process on the host's files: simulated GPIO lines
# and USB. tests/lab/guest runs a command in it; every tests/lab/test_*.c is a cmocka program that runs there, linked with
# LAB_COMMON; every other tests/lab/test_* is a script that speaks TAP and runs outside.
LAB_TESTS = $(patsubst tests/lab/test_%.c,$(BUILD)/tests/lab/test_%,$(filter-out tests/lab/test_usb_%,$(wildcard tests/lab/test_*.c)))
LAB_SCRIPTS = $(filter-out %.c,$(wildcard tests/lab/test_*))
LAB_COMMON = $(patsubst %,$(BUILD)/tests/lab/%.o,chip capture bus screen sigrok run process usbip known card)

$(BUILD)/tests/lab/%.o: tests/lab/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(LAB_CFLAGS) -c $< -o $@

LAB_CFLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Itests/unit -Itests/lab $(CFLAGS)

$(LAB_TESTS): %: %.o $(LAB_COMMON)
	$(CC) $(HOST_LDFLAGS) $< $(LAB_COMMON) -o $@ -lcmocka -ltraceevent

# The usb sink: some call it, some run the command; against a display of their own and against the firmware's.
USB_TESTS = $(patsubst tests/lab/%.c,$(BUILD)/tests/lab/%,$(wildcard tests/lab/test_usb_*.c tests/lab/usb_rate.c))
USB_DISPLAY = $(patsubst %,$(BUILD)/tests/lab/%.o,usb_display usb_function)
USB_COMMON = $(USB_DISPLAY) $(filter-out $(BUILD)/host/main.o,$(HOST_OBJECTS)) $(BUILD)/libglint.a
$(USB_TESTS:%=%.o) $(USB_DISPLAY): LAB_CFLAGS += -Ilib -Ihost -Ifirmware/core $(SINK_FLAGS) \
	$(shell pkg-config --cflags $(HOST_LIBS) $(SINK_LIBS) 2>/dev/null)
$(USB_TESTS): %: %.o $(USB_COMMON)
	$(CC) $(HOST_LDFLAGS) $< $(USB_COMMON) -o $@ -lcmocka $(HOST_LDLIBS)

usb-programs: $(USB_TESTS) $(BUILD)/glint firmware-linux $(addprefix $(BUILD)/tests/lab/,init spi.dtb)
lab-programs: usb-programs
USB_GUEST = env GLINT=$(CURDIR)/$(BUILD)/glint GADGET=$(CURDIR)/$(linux)/glint-gadget tests/lab/guest
LAB_SCRIPTS += $(patsubst %,"$(USB_GUEST) %",$(filter $(BUILD)/tests/lab/test_%,$(USB_TESTS)))

usb-rate: usb-programs ## the usb sink's rate beside a bare loop of libusb calls, to the same simulated display
	@LAB_BUILD=$(CURDIR)/$(BUILD) $(USB_GUEST) $(BUILD)/tests/lab/usb_rate

$(addprefix $(BUILD)/tests/lab/,test_gud_drm.o card.o): LAB_CFLAGS += $$(pkg-config --cflags libdrm)

# By libgpiod as installed, and by its version 2.
$(BUILD)/tests/lab/bitbang1: $(patsubst %,$(BUILD)/tests/lab/%.o,bitbang known lines1)
	$(CC) $(HOST_LDFLAGS) $^ -o $@ -lgpiod

$(BUILD)/tests/lab/bitbang2: $(patsubst %,$(BUILD)/tests/lab/%.o,bitbang known lines2)
	$(CC) $(HOST_LDFLAGS) $^ -o $@ $$($(LIBGPIOD2) pkg-config --libs libgpiod)

$(BUILD)/tests/lab/lines2.o: tests/lab/lines2.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(LAB_CFLAGS) $$($(LIBGPIOD2) pkg-config --cflags libgpiod) -c $< -o $@

LIBGPIOD2 = PKG_CONFIG_PATH="$$(tests/lab/libgpiod2)"

setup-lab: setup-build
	@.ci/need "tier lab (a Linux kernel to build, its GPIO and USB, sigrok's decoders)" linux-source-6.1 bc bison flex \
		xz-utils libcmocka-dev libgpiod-dev libtraceevent-dev libusb-1.0-0-dev libdrm-dev sigrok-cli

test-lab: ## under a Linux kernel as a process: GPIO lines captured and decoded, also by sigrok; USB
	@+tests/tier lab "$(SUBMAKE)"

# The guest's first program, and its hardware.
$(BUILD)/tests/lab/init: tests/lab/init.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) -std=c11 -D_GNU_SOURCE $(WARNINGS) -O2 -static $< -o $@

$(BUILD)/tests/lab/spi.dtb: tests/lab/spi.dts
	@mkdir -p $(@D)
	kernel=$$(tests/lab/kernel) && "$$kernel/dtc" -q -O dtb -o $@ $<

lab-programs: $(LAB_TESTS) $(addprefix $(BUILD)/tests/lab/,init spi.dtb bitbang1 bitbang2) firmware-linux $(linux)/faulty-gadget

# The command with libgpiod 2.
glint-gpiod2:
	@+$(LIBGPIOD2) $(SUBMAKE) BUILD=build/gpiod2 all

# What takes longest goes first: of what is built the kernel, of what runs the programs that compute. The others mostly
# wait for USB's times: two more run than there are processors.
run-lab: $(BUILD)/tests/lab/spi.dtb $(BUILD)/glint glint-gpiod2
LAB_BUSY = $(foreach build,$(BUILD) build/gpiod2,"env GLINT=$(CURDIR)/$(build)/glint tests/lab/guest --memory 768 \
	$(BUILD)/tests/lab/test_gpio_stream") "tests/lab/test_fuzz"
LAB_JOBS = $$(($$(nproc) + 2))

run-lab: lab-programs
	@LAB_KERNEL=$$(tests/lab/kernel) LAB_BUILD=$(CURDIR)/$(BUILD) TALLY_JOBS=$(LAB_JOBS) && \
		export LAB_KERNEL LAB_BUILD TALLY_JOBS && tests/tally $(LAB_BUSY) \
		"env GADGET=$(CURDIR)/$(linux)/glint-gadget FAULTY=$(CURDIR)/$(linux)/faulty-gadget \
			tests/lab/guest $(BUILD)/tests/lab/test_gud_drm" \
		"env BITBANG=$(CURDIR)/$(BUILD)/tests/lab/bitbang1 tests/lab/guest $(BUILD)/tests/lab/test_gpio" \
		"env BITBANG=$(CURDIR)/$(BUILD)/tests/lab/bitbang2 tests/lab/guest $(BUILD)/tests/lab/test_gpio" \
		$(filter-out tests/lab/test_fuzz,$(LAB_SCRIPTS)) \
		$(foreach build,$(BUILD) build/gpiod2,"env GLINT=$(CURDIR)/$(build)/glint tests/lab/guest $(BUILD)/tests/lab/test_gpio_faults") \
		"env GLINT=$(CURDIR)/$(BUILD)/glint tests/lab/guest --spi $(BUILD)/tests/lab/test_spidev" \
		"env GADGET=$(CURDIR)/$(linux)/glint-gadget tests/lab/guest $(BUILD)/tests/lab/test_gud_kernel" \
		"env GADGET=$(CURDIR)/$(linux)/glint-gadget tests/lab/guest $(BUILD)/tests/lab/test_gud_ends" \
		"env GADGET=$(CURDIR)/$(linux)/glint-gadget tests/lab/guest $(BUILD)/tests/lab/test_gud_host"

# Calls that set lines, by either version.
$(BUILD)/tests/lab/gpio_rate.o: LAB_CFLAGS += -Ihost -Ifirmware/core $(SINK_FLAGS)
$(BUILD)/tests/lab/gpio_rate: %: %.o $(LAB_COMMON) $(filter-out $(BUILD)/host/main.o,$(HOST_OBJECTS)) $(BUILD)/libglint.a
	$(CC) $(HOST_LDFLAGS) $^ -o $@ -lcmocka -ltraceevent $(HOST_LDLIBS)

gpio-rate: $(BUILD)/tests/lab/gpio_rate $(addprefix $(BUILD)/tests/lab/,init spi.dtb) ## ns of a call that sets lines, beside a bare loop of its ioctl
	@+$(LIBGPIOD2) $(SUBMAKE) BUILD=build/gpiod2 build/gpiod2/tests/lab/gpio_rate
	@export LAB_BUILD=$(CURDIR)/$(BUILD); for build in $(BUILD) build/gpiod2; do \
		tests/lab/guest $$build/tests/lab/gpio_rate | grep '^libgpiod' || exit 1; done

include tests/lab/fuzz.mk

.PHONY: gpio-rate usb-programs usb-rate glint-gpiod2 setup-lab test-lab run-lab lab-programs
