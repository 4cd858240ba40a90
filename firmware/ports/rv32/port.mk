# SPDX-License-Identifier: MIT
# RISC-V of 32 bits without an operating system: make firmware PORT=rv32
rv32_TOOLS = riscv64-unknown-elf-
rv32_SOURCES = $(BARE_START)
rv32_LINK = -nostdlib -T
rv32_RUN = qemu-system-riscv32 -M % -bios none -nographic -kernel
rv32_STACK = 1300
rv32_BOARDS = virt rp2350

rv32_CORE_virt = rv32imc
rv32_FLAGS_virt = -march=rv32imc -mabi=ilp32
rv32_SCRIPT_virt = virt.ld

# The RP2350's RISC-V cores, Hazard3, by the same machine. Without Zbs: gcc 12.2 stops at bits that it sets in a constant (internal error).
rv32_CORE_rp2350 = rv32imacb
rv32_FLAGS_rp2350 = -march=rv32imac_zba_zbb -mabi=ilp32 $(rv32_LIBRARIES)
# The compiler has its library for rv32imac, and does not look there where more is named.
rv32_LIBRARIES := -L$(patsubst %/,%,$(dir $(shell $(rv32_TOOLS)gcc -march=rv32imac -mabi=ilp32 -print-libgcc-file-name 2>/dev/null)))
rv32_SCRIPT_rp2350 = virt.ld
rv32_RUN_rp2350 = $(subst %,virt,$(rv32_RUN))
$(eval $(call bare_port,rv32))

rv32_PACKAGES = gcc-riscv64-unknown-elf
setup-firmware-rv32: setup-build
	@.ci/need "firmware for RV32" $(rv32_PACKAGES)

.PHONY: setup-firmware-rv32
