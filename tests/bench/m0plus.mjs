// SPDX-License-Identifier: MIT
// A Cortex-M0+ (the RP2040's, emulated by rp2040js) with a program in SRAM, whose functions can be called and counted.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { resolve } from 'node:path'

const RETURN = 0x20041000 // a call is over when it comes here
const STACK = 0x20040000

// The parts of a 32-bit little-endian ELF file: what to load where, and the global symbols.
function parseElf(file) {
  const bytes = readFileSync(file)
  const section = (i) => {
    const at = bytes.readUInt32LE(32) + i * bytes.readUInt16LE(46)
    const word = (k) => bytes.readUInt32LE(at + 4 * k)
    return { type: word(1), flags: word(2), address: word(3), offset: word(4), size: word(5), link: word(6) }
  }
  const sections = Array.from({ length: bytes.readUInt16LE(48) }, (_, i) => section(i))
  const symbols = new Map()
  for (const { type, offset, size, link } of sections) {
    if (type !== 2) continue // SHT_SYMTAB
    for (let at = offset; at < offset + size; at += 16) {
      const start = sections[link].offset + bytes.readUInt32LE(at)
      const name = bytes.toString('latin1', start, bytes.indexOf(0, start))
      symbols.set(name, bytes.readUInt32LE(at + 4))
    }
  }
  const loaded = sections.filter(({ type, flags }) => type === 1 && flags & 2) // SHT_PROGBITS, SHF_ALLOC
  return { symbols, images: loaded.map((s) => [s.address, bytes.subarray(s.offset, s.offset + s.size)]) }
}

// rp2040js 1.4.1 counts a push of N registers 1 + N, a pop into pc 3 + N, as the manual does, but for lr and pc themselves.
function forgets(opcode) {
  return opcode >> 8 === 0xb5 || opcode >> 8 === 0xbd
}

export function boot(packages, elf) {
  const { RP2040 } = createRequire(resolve(packages, 'x'))('rp2040js')
  const chip = new RP2040()
  const { core } = chip
  const { symbols, images } = parseElf(elf)
  for (const [address, image] of images) chip.sram.set(image, address - 0x20000000)

  const address = (name) => {
    if (!symbols.has(name)) throw new Error(`${elf} has no symbol ${name}`)
    return symbols.get(name)
  }
  // Runs a function. The cycles are those of its body: an empty function's, the 2 of its return, are taken off.
  const call = (name, ...args) => {
    args.forEach((value, i) => { core.registers[i] = value })
    core.SP = STACK
    core.LR = RETURN | 1
    core.PC = address(name) & ~1
    const before = core.cycles
    let missed = 0
    while (core.PC !== RETURN) {
      if (forgets(chip.readUint16(core.PC))) missed++
      core.executeInstruction()
      if (core.cycles - before > 1e8) throw new Error(`${name} does not return`)
    }
    return { value: core.registers[0], cycles: core.cycles - before + missed - 2 }
  }
  calibrate(call)
  return { call, address }
}

// The counts of calibrate.S by the manual. What they do not agree with is not worth measuring.
const KNOWN = {
  calibrate_empty: 0,
  calibrate_muls: 10,
  calibrate_alu: 12,
  calibrate_memory: 17,
  calibrate_loop: 1 + 100 + 99 * 2 + 1,
  calibrate_call: 3 + 3 + 2 + 5 - 2, // it returns by its pop, not by a bx lr
  calibrate_stack: 4 + 4,
  calibrate_jump: 2 + 1 + 1 + 2
}

function calibrate(call) {
  for (const [name, expected] of Object.entries(KNOWN)) {
    const { cycles } = call(name, 3, 5)
    if (cycles !== expected) throw new Error(`the emulator counts ${cycles} cycles for ${name}, the manual ${expected}`)
  }
}
