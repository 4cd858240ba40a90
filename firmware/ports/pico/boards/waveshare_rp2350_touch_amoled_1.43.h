/* SPDX-License-Identifier: MIT
 * For the SDK, the assembler included: an RP2350A with 16 MB of flash. Pins are in boards.def. */
// pico_cmake_set PICO_PLATFORM=rp2350
#ifndef BOARDS_WAVESHARE_RP2350_TOUCH_AMOLED_1_43_H
#define BOARDS_WAVESHARE_RP2350_TOUCH_AMOLED_1_43_H

#define PICO_RP2350A 1
#define PICO_BOOT_STAGE2_CHOOSE_W25Q080 1
// pico_cmake_set_default PICO_FLASH_SIZE_BYTES = (16 * 1024 * 1024)
#ifndef PICO_FLASH_SIZE_BYTES
#define PICO_FLASH_SIZE_BYTES (16 * 1024 * 1024)
#endif
// pico_cmake_set_default PICO_RP2350_A2_SUPPORTED = 1
#ifndef PICO_RP2350_A2_SUPPORTED
#define PICO_RP2350_A2_SUPPORTED 1
#endif

#endif
