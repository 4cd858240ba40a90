// SPDX-License-Identifier: MIT
// A Cortex-M0+ (the RP2040's, emulated by rp2040js) with a program in SRAM, whose functions can be called and counted.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { resolve } from 'node:path'
import { KNOWN } from './calibrate.mjs'

export const RAM = 0x20000000
export const RETURN = 0x20041ff0 // the end of 264 KB; a call is over when it comes here
const STACK = RETURN

// The parts of a 32-bit little-endian ELF file: what to load where, and the symbols and their sizes.
function parseElf(file) {
  const bytes = readFileSync(file)
  const section = (i) => {
    const at = bytes.readUInt32LE(32) + i * bytes.readUInt16LE(46)
    const word = (k) => bytes.readUInt32LE(at + 4 * k)
    return { type: word(1), flags: word(2), address: word(3), offset: word(4), size: word(5), link: word(6) }
  }
  const sections = Array.from({ length: bytes.readUInt16LE(48) }, (_, i) => section(i))
  const symbols = new Map(), sizes = new Map()
  for (const { type, offset, size, link } of sections) {
    if (type !== 2) continue // SHT_SYMTAB
    for (let at = offset; at < offset + size; at += 16) {
      const start = sections[link].offset + bytes.readUInt32LE(at)
      const name = bytes.toString('latin1', start, bytes.indexOf(0, start))
      symbols.set(name, bytes.readUInt32LE(at + 4))
      sizes.set(name, bytes.readUInt32LE(at + 8))
    }
  }
  const loaded = sections.filter(({ type, flags }) => type === 1 && flags & 2) // SHT_PROGBITS, SHF_ALLOC
  return { symbols, sizes, images: loaded.map((s) => [s.address, bytes.subarray(s.offset, s.offset + s.size)]) }
}

// rp2040js 1.4.1 counts a push of N registers 1 + N, a pop into pc 3 + N, as the manual does, but for lr and pc themselves.
function forgets(opcode) {
  return opcode >> 8 === 0xb5 || opcode >> 8 === 0xbd
}

// What would be a fault on the chip is an error here: rp2040js goes on after it.
function strict({ chip, core }) {
  const fail = (_, message) => { throw new Error(`the emulated program is at 0x${core.PC.toString(16)}: ${message}`) }
  chip.logger = { debug() {}, info() {}, warn: fail, error: fail }
  const aligned = (method, mask) => {
    const plain = core[method]
    core[method] = (address, value) => {
      if (address & mask) fail('', `0x${address.toString(16)} is not aligned for ${method}`)
      return plain.call(core, address, value)
    }
  }
  aligned('readUint16', 1)
  aligned('writeUint16', 1)
  aligned('writeUint32', 3)
  // Instructions and most data come this way, so it had better be fast: rp2040js looks among its peripherals first.
  const { buffer, byteOffset, length } = chip.sram
  const halves = new Uint16Array(buffer, byteOffset, length / 2), words = new Uint32Array(buffer, byteOffset, length / 4)
  const { readUint16, readUint32, writeUint32 } = core
  const elsewhere = (at, mask) => at & mask || at < 0 || at >= length
  core.readUint16 = (address) => elsewhere(address - RAM, 1) ? readUint16(address) : halves[(address - RAM) >> 1]
  core.readUint32 = (address) => elsewhere(address - RAM, 3) ? readUint32.call(core, address) : words[(address - RAM) >> 2]
  core.writeUint32 = (address, value) => {
    if (elsewhere(address - RAM, 3)) writeUint32(address, value)
    else words[(address - RAM) >> 2] = value
  }
  return halves
}

// The machine with the program loaded: its core, its SRAM as a buffer and as instructions, and the program's symbols.
export function load(packages, elf) {
  const { RP2040 } = createRequire(resolve(packages, 'x'))('rp2040js')
  const chip = new RP2040()
  const { core } = chip
  const { symbols, sizes, images } = parseElf(elf)
  for (const [address, image] of images) chip.sram.set(image, address - RAM)
  const halves = strict({ chip, core })
  const address = (name) => {
    if (!symbols.has(name)) throw new Error(`${elf} has no symbol ${name}`)
    return symbols.get(name)
  }
  const size = (name) => address(name) && sizes.get(name)
  const memory = Buffer.from(chip.sram.buffer, chip.sram.byteOffset, chip.sram.length)
  // Where a function begins: it has its arguments, and returns to RETURN.
  const enter = (name, args) => {
    args.forEach((value, i) => { core.registers[i] = value })
    core.SP = STACK
    core.LR = RETURN | 1
    core.PC = (typeof name === 'string' ? address(name) : name) & ~1
  }
  return { core, memory, halves, symbols, address, size, enter }
}

export function boot(packages, elf) {
  const { core, memory, halves, symbols, address, enter } = load(packages, elf)
  const forgetful = halves.map(forgets) // by address; code does not change
  const word = (at) => memory.readUInt32LE(at - RAM)
  const half = (at) => memory.readInt16LE(at - RAM)
  const byte = (at) => memory[at - RAM]
  const text = (at) => at ? memory.toString('latin1', at - RAM, memory.indexOf(0, at - RAM)) : ''
  const bytes = (at, length) => memory.subarray(at - RAM, at - RAM + length)

  // Runs a function, by its name or address. The cycles are those of its body: an empty function's, the 2 of its return, are
  // taken off. spent: by address, gains the cycles of each instruction.
  const call = (name, args = [], spent = null) => {
    enter(name, args)
    const before = core.cycles
    let missed = 0
    while (core.PC !== RETURN) {
      const at = (core.PC - RAM) >> 1, start = core.cycles
      missed += forgetful[at]
      core.executeInstruction()
      if (spent) spent[at] += core.cycles - start + forgetful[at]
      if (core.cycles - before > 1e9) throw new Error(`${name} does not return`)
    }
    return { value: core.registers[0], cycles: core.cycles - before + missed - 2 }
  }

  // The same; found, a Map, gains the cycles spent in each function. Functions have odd addresses, as Thumb code does.
  const functions = [...symbols].filter(([, at]) => at & 1).map(([symbol, at]) => [symbol, (at - RAM) >> 1]).sort((a, b) => a[1] - b[1])
  const profiled = (found, name, args) => {
    const spent = new Float64Array(halves.length), result = call(name, args, spent)
    functions.forEach(([symbol, at], i) => {
      const cycles = spent.subarray(at, functions[i + 1]?.[1]).reduce((sum, x) => sum + x, 0)
      if (cycles) found.set(symbol, (found.get(symbol) ?? 0) + cycles)
    })
    return result
  }

  // run(), while seen() is shown the address of every read; instructions are read, too.
  const watched = (seen, run) => {
    const plain = { readUint32: core.readUint32, readUint16: core.readUint16, readUint8: core.readUint8 }
    for (const [method, read] of Object.entries(plain)) {
      core[method] = (at) => {
        seen(at)
        return read.call(core, at)
      }
    }
    try { return run() } finally { Object.assign(core, plain) }
  }

  // The 32-bit words of code and constants that a call needs: what flash would have to deliver, were they there.
  const [constants, end] = [RAM, address('constants_end')]
  const words = new Set()
  const traced = (name, args) => watched((at) => { if (at >= constants && at < end) words.add(at >>> 2) }, () => call(name, args))
  const touched = (run) => {
    words.clear()
    run(traced)
    return words.size
  }
  calibrate(call)
  return { call, profiled, watched, touched, address, word, half, byte, text, bytes }
}

function calibrate(call) {
  for (const [name, expected] of Object.entries(KNOWN)) {
    const { cycles } = call(name, [3, 5])
    if (cycles !== expected) throw new Error(`the emulator counts ${cycles} cycles for ${name}, the manual ${expected}`)
  }
}
