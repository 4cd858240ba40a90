# SPDX-License-Identifier: MIT
# The toolchain of the RP2350's RISC-V cores (ARCH=riscv): Debian's gcc and picolibc. Their variants of libraries name no bit operations, with which
# glint's own sources are compiled (CMakeLists.txt).
set(CMAKE_SYSTEM_PROCESSOR hazard3)
set(PICO_DEFAULT_GCC_TRIPLE riscv64-unknown-elf)
set(PICOLIBC /usr/lib/picolibc/riscv64-unknown-elf) # not by its specs, which choose a linker script
set(PICO_COMMON_LANG_FLAGS " -march=rv32imac -misa-spec=2.2 -mabi=ilp32 -mno-riscv-attribute -Wa,-march=rv32imac_zicsr_zifencei_zba_zbb_zbs_zbkb -isystem ${PICOLIBC}/include -L${PICOLIBC}/lib/rv32imac/ilp32 -ftls-model=local-exec -B${CMAKE_CURRENT_LIST_DIR}")
include($ENV{PICO_SDK_PATH}/cmake/preload/toolchains/util/pico_arm_gcc_common.cmake)
