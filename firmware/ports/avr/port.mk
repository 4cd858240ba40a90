# SPDX-License-Identifier: MIT
# AVR: make firmware PORT=avr
avr_TOOLS = avr-
avr_BOARDS = atmega2560 atmega328p
avr_FLAGS_atmega2560 = -mmcu=atmega2560 -DCONFORMANCE_COLOUR=0 -DCONFORMANCE_EVERY_C=0
avr_LINK_atmega2560 = $(CURDIR)/firmware/ports/avr/budget.ld
avr_FLAGS_atmega328p = -mmcu=atmega328p -DCONFORMANCE_MODELS_ONLY=1
avr_LINK_atmega328p = $(CURDIR)/firmware/ports/avr/budget328p.ld
$(eval $(call bare_port,avr))

avr_PACKAGES = gcc-avr avr-libc
setup-firmware-avr: setup-build
	@.ci/need "firmware for AVR" $(avr_PACKAGES)

.PHONY: setup-firmware-avr
