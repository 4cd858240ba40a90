// SPDX-License-Identifier: MIT
// rp2040 PACKAGES ELF: runs a program of machine/rp2040.c in SRAM on an emulated RP2040 and prints what it has put. It stops
// where one of the library's functions does not give back the registers it must keep: assembly may forget one.
import { load, RAM, RETURN } from '../bench/m0plus.mjs'

const [packages, elf] = process.argv.slice(2)
const { core, memory, symbols, address, enter } = load(packages, elf)
const names = new Array(memory.length / 2) // by where the library's functions begin
for (const [name, at] of symbols) if (name.startsWith('glint_')) names[(at - RAM) >> 1] = name

const kept = () => [...core.registers.slice(4, 12), core.SP]
const calls = [] // under way: name, where it returns, and what is to be as it was then
enter('start', [])
while (core.PC !== RETURN) {
  const last = calls[calls.length - 1]
  if (last && core.PC === last.back && core.SP >= last.kept[8]) {
    if (kept().some((value, i) => value !== last.kept[i])) {
      console.error(`${last.name} returns with other registers than it was given`)
      process.exit(1)
    }
    calls.pop()
    continue // a function that ends by calling another returns for it, too
  }
  const name = names[(core.PC - RAM) >> 1]
  if (name) calls.push({ name, back: core.LR & ~1, kept: kept() })
  core.executeInstruction()
}
const text = address('machine_text') - RAM
process.stdout.write(memory.toString('latin1', text, memory.indexOf(0, text)))
