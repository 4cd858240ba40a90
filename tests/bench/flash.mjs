// SPDX-License-Identifier: MIT
// The RP2040's flash, which the emulator does not model. FLASH_WORD: the cycles that a 32-bit word costs which is not in the
// cache (125 MHz, a quad read at half of it).
export const FLASH_WORD = 40

export const FLASH_FOOT = `Predicted, not emulated: code and constants run from flash (XIP): every different 32-bit word of them that is
fetched adds ${FLASH_WORD} cycles once (cold), as the cache of 16 KB then holds it; a map in flash adds ${FLASH_WORD} cycles for each 32 bits
read, as each is read once, unless DMA brings its lines into SRAM meanwhile. Not modelled: contention on the bus, conflicts in
the cache.`
