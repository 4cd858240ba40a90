# SPDX-License-Identifier: MIT
# AVR: make firmware PORT=avr. Linker scripts here stand beside the compiler's own.
avr_TOOLS = avr-
avr_RUN = simavr -m % -f 16000000
avr_STACK = 1300
avr_BOARDS = atmega2560 atmega1284p atmega328p

avr_CORE_atmega2560 = atmega2560
avr_FLAGS_atmega2560 = -mmcu=atmega2560
avr_SCRIPT_atmega2560 = budget.ld
avr_IMAGE_atmega2560 = -DCONFORMANCE_TABLES=0 -DCONFORMANCE_EVERY_C=0
avr_SKIPS_atmega2560 = 18
avr_PUSHED_atmega2560 = 3

avr_CORE_atmega1284p = atmega1284p
avr_FLAGS_atmega1284p = -mmcu=atmega1284p
avr_SCRIPT_atmega1284p = budget1284p.ld
avr_IMAGE_atmega1284p = -DCONFORMANCE_ALBEDO_ONLY=1
avr_SKIPS_atmega1284p = 42
avr_PUSHED_atmega1284p = 2

avr_CORE_atmega328p = atmega328p
avr_FLAGS_atmega328p = -mmcu=atmega328p
avr_SCRIPT_atmega328p = budget328p.ld
avr_IMAGE_atmega328p = -DCONFORMANCE_MODELS_ONLY=1
avr_SKIPS_atmega328p = 36
avr_PUSHED_atmega328p = 2
$(eval $(call bare_port,avr))

avr_PACKAGES = gcc-avr avr-libc
setup-firmware-avr: setup-build
	@.ci/need "firmware for AVR" $(avr_PACKAGES)

.PHONY: setup-firmware-avr
