# SPDX-License-Identifier: MIT
# RISC-V of 32 bits without an operating system: make firmware PORT=rv32
rv32_TOOLS = riscv64-unknown-elf-
rv32_SOURCES = $(BARE_START)
rv32_LINK = -nostdlib -T
rv32_RUN = qemu-system-riscv32 -M % -bios none -nographic -kernel
rv32_STACK = 1300
rv32_BOARDS = virt

rv32_CORE_virt = rv32imc
rv32_FLAGS_virt = -march=rv32imc -mabi=ilp32
rv32_SCRIPT_virt = virt.ld
$(eval $(call bare_port,rv32))

rv32_PACKAGES = gcc-riscv64-unknown-elf
setup-firmware-rv32: setup-build
	@.ci/need "firmware for RV32" $(rv32_PACKAGES)

.PHONY: setup-firmware-rv32
