# SPDX-License-Identifier: MIT
# Cortex-M without an operating system: make firmware PORT=cortex-m [BOARD=microbit]
cortex-m_TOOLS = arm-none-eabi-
cortex-m_BARE = $(BARE)/memory.c
cortex-m_BOARDS = microbit mps2-an385 mps2-an386 mps2-an505 rp2040 rp2040-asm
cortex-m_FLAGS_microbit = -mcpu=cortex-m0 -mthumb -DCONFORMANCE_COLOUR=0
cortex-m_FLAGS_mps2-an385 = -mcpu=cortex-m3 -mthumb
cortex-m_FLAGS_mps2-an386 = -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
cortex-m_FLAGS_mps2-an505 = -mcpu=cortex-m33 -mthumb
cortex-m_FLAGS_rp2040 = -mcpu=cortex-m0plus -mthumb -DCONFORMANCE_EVERY_C=0
cortex-m_FLAGS_rp2040-asm = $(cortex-m_FLAGS_rp2040) -DGLINT_CORTEX_M0PLUS_ASM=1
cortex-m_ASSEMBLY_rp2040-asm = $(wildcard lib/*.S)
cortex-m_SCRIPT = -nostdlib -T $(CURDIR)/firmware/ports/cortex-m/
cortex-m_LINK_microbit = $(cortex-m_SCRIPT)microbit.ld
cortex-m_LINK_mps2-an385 = $(cortex-m_SCRIPT)mps2.ld
cortex-m_LINK_mps2-an386 = $(cortex-m_SCRIPT)mps2.ld
cortex-m_LINK_mps2-an505 = $(cortex-m_SCRIPT)mps2-an505.ld
cortex-m_LINK_rp2040 = $(cortex-m_SCRIPT)rp2040.ld
cortex-m_LINK_rp2040-asm = $(cortex-m_SCRIPT)rp2040.ld
$(eval $(call bare_port,cortex-m))

cortex-m_PACKAGES = gcc-arm-none-eabi
setup-firmware-cortex-m: setup-build
	@.ci/need "firmware for Cortex-M" $(cortex-m_PACKAGES)

.PHONY: setup-firmware-cortex-m
