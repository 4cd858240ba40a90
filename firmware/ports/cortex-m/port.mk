# SPDX-License-Identifier: MIT
# Cortex-M without an operating system: make firmware PORT=cortex-m [BOARD=microbit]
cortex-m_TOOLS = arm-none-eabi-
cortex-m_SOURCES = $(BARE_START)
cortex-m_LINK = -nostdlib -T
cortex-m_RUN = qemu-system-arm -display none -semihosting-config enable=on,target=native -M % -kernel
cortex-m_RP2040JS = node tests/targets/rp2040.mjs build/bench/npm
cortex-m_STACK = 1300
cortex-m_STACK_mps3-an547 = 1600
cortex-m_BOARDS = microbit rp2040 rp2040-asm mps2-an385 mps2-an386 mps2-an386-c mps2-an500 mps2-an500-c mps2-an505 mps2-an505-c mps3-an547

cortex-m_CORE_microbit = cortex-m0
cortex-m_FLAGS_microbit = -mcpu=cortex-m0 -mthumb
cortex-m_SCRIPT_microbit = microbit.ld
cortex-m_IMAGE_microbit = -DCONFORMANCE_TABLES=0
cortex-m_SKIPS_microbit = 9

cortex-m_CORE_rp2040 = cortex-m0plus
cortex-m_FLAGS_rp2040 = -mcpu=cortex-m0plus -mthumb
cortex-m_SCRIPT_rp2040 = rp2040.ld
cortex-m_IMAGE_rp2040 = -DCONFORMANCE_EVERY_C=0
cortex-m_SKIPS_rp2040 = 9
cortex-m_RUN_rp2040 = $(cortex-m_RP2040JS)

cortex-m_CORE_rp2040-asm = cortex-m0plus-asm
cortex-m_FLAGS_rp2040-asm = -mcpu=cortex-m0plus -mthumb -DGLINT_CORTEX_M0PLUS_ASM=1
cortex-m_ASSEMBLY_rp2040-asm = $(wildcard lib/*.S)
cortex-m_SCRIPT_rp2040-asm = rp2040.ld
cortex-m_IMAGE_rp2040-asm = -DCONFORMANCE_EVERY_C=0
cortex-m_SKIPS_rp2040-asm = 9
cortex-m_RUN_rp2040-asm = $(cortex-m_RP2040JS)

cortex-m_CORE_mps2-an385 = cortex-m3
cortex-m_FLAGS_mps2-an385 = -mcpu=cortex-m3 -mthumb
cortex-m_SCRIPT_mps2-an385 = mps2.ld

cortex-m_CORE_mps2-an386 = cortex-m4f
cortex-m_FLAGS_mps2-an386 = -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
cortex-m_SCRIPT_mps2-an386 = mps2.ld

cortex-m_CORE_mps2-an500 = cortex-m7f
cortex-m_FLAGS_mps2-an500 = -mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16
cortex-m_SCRIPT_mps2-an500 = mps2.ld

cortex-m_CORE_mps2-an505 = cortex-m33f
cortex-m_FLAGS_mps2-an505 = -mcpu=cortex-m33 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16
cortex-m_SCRIPT_mps2-an505 = mps2-an505.ld

cortex-m_CORE_mps3-an547 = cortex-m55
cortex-m_FLAGS_mps3-an547 = -mcpu=cortex-m55+nofp -mthumb -mfloat-abi=hard
cortex-m_SCRIPT_mps3-an547 = mps3-an547.ld

# The same without the loops by the DSP extension, which the compiler offers for these cores: what -DGLINT_DSP=0 leaves must draw the same.
cortex-m_CORE_mps2-an386-c = cortex-m4f-c
cortex-m_FLAGS_mps2-an386-c = $(cortex-m_FLAGS_mps2-an386) -DGLINT_DSP=0
cortex-m_SCRIPT_mps2-an386-c = mps2.ld
cortex-m_RUN_mps2-an386-c = $(subst %,mps2-an386,$(cortex-m_RUN))

cortex-m_CORE_mps2-an500-c = cortex-m7f-c
cortex-m_FLAGS_mps2-an500-c = $(cortex-m_FLAGS_mps2-an500) -DGLINT_DSP=0
cortex-m_SCRIPT_mps2-an500-c = mps2.ld
cortex-m_RUN_mps2-an500-c = $(subst %,mps2-an500,$(cortex-m_RUN))

cortex-m_CORE_mps2-an505-c = cortex-m33f-c
cortex-m_FLAGS_mps2-an505-c = $(cortex-m_FLAGS_mps2-an505) -DGLINT_DSP=0
cortex-m_SCRIPT_mps2-an505-c = mps2-an505.ld
cortex-m_RUN_mps2-an505-c = $(subst %,mps2-an505,$(cortex-m_RUN))
$(eval $(call bare_port,cortex-m))

cortex-m_PACKAGES = gcc-arm-none-eabi
setup-firmware-cortex-m: setup-build
	@.ci/need "firmware for Cortex-M" $(cortex-m_PACKAGES)

.PHONY: setup-firmware-cortex-m
