# SPDX-License-Identifier: MIT
# Xtensa, the ESP8266's core, without an operating system: make firmware PORT=xtensa
xtensa_TOOLS = xtensa-lx106-elf-
xtensa_SOURCES = $(BARE_START)
xtensa_LINK = -nostdlib -T
xtensa_RUN = qemu-system-xtensa -M sim -cpu % -display none -semihosting -kernel
xtensa_STACK = 1300
xtensa_BOARDS = lx106

xtensa_CORE_lx106 = lx106
# As the ESP8266's kits compile: constants stay in flash and are read in words.
xtensa_FLAGS_lx106 = -mtext-section-literals -DESP8266
xtensa_SCRIPT_lx106 = lx106.ld
$(eval $(call bare_port,xtensa))

xtensa_PACKAGES = gcc-xtensa-lx106
setup-firmware-xtensa: setup-build
	@.ci/need "firmware for Xtensa" $(xtensa_PACKAGES)

.PHONY: setup-firmware-xtensa
