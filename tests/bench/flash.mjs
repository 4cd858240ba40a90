// SPDX-License-Identifier: MIT
// The RP2040's flash, which the emulator does not model. FLASH_WORD: the cycles that a 32-bit word costs which is not in the
// cache (125 MHz, a quad read at half of it).
export const FLASH_WORD = 40

// Its cache: 16 KB in two ways of lines of 8 bytes, of which the one that was not used for longer leaves. A line holds the words
// that were read.
function cache() {
  const tags = new Int32Array(2048).fill(-1), held = new Uint8Array(2048) // way 0 of a set is the one used last
  return (address) => { // does flash have to deliver the word?
    const tag = address >>> 13, word = 1 << (address >>> 2 & 1), first = 2 * (address >>> 3 & 1023)
    if (tags[first] !== tag) {
      const [other, has] = [tags[first], held[first]]
      tags[first] = tag
      held[first] = tags[first + 1] === tag ? held[first + 1] : 0
      tags[first + 1] = other
      held[first + 1] = has
    }
    const missed = !(held[first] & word)
    held[first] |= word
    return missed
  }
}

// The cycles of waits in a frame that reads these addresses of flash, when the frame before it was the same.
export function flashWaits(addresses) {
  const misses = cache()
  let words = 0
  for (const last of [false, true]) for (const address of addresses) words += misses(address) && last
  return FLASH_WORD * words
}

export const FLASH_FOOT = `Predicted, not emulated: code and constants run from flash (XIP): every different 32-bit word of them that is
fetched adds ${FLASH_WORD} cycles once (cold), as the cache of 16 KB then holds it; a map in flash adds ${FLASH_WORD} cycles for each 32 bits
read, as each is read once, unless DMA brings its lines into SRAM meanwhile. Not modelled: contention on the bus, and for code
conflicts in the cache. Tables in flash: a frame after a like one, every read through a model of the cache (two ways, lines of 8
bytes).`
