# SPDX-License-Identifier: MIT
# RISC-V of 32 bits without an operating system: make firmware PORT=rv32
rv32_TOOLS = riscv64-unknown-elf-
rv32_BARE = $(BARE)/memory.c
rv32_BOARDS = virt
rv32_FLAGS_virt = -march=rv32imc -mabi=ilp32
rv32_LINK_virt = -nostdlib -T $(CURDIR)/firmware/ports/rv32/virt.ld
$(eval $(call bare_port,rv32))

rv32_PACKAGES = gcc-riscv64-unknown-elf
setup-firmware-rv32: setup-build
	@.ci/need "firmware for RV32" $(rv32_PACKAGES)

.PHONY: setup-firmware-rv32
