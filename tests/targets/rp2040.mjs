// SPDX-License-Identifier: MIT
// rp2040 PACKAGES ELF: runs a program in SRAM on an emulated RP2040, with semihosting. It stops
// where one of the library's functions does not give back the registers it must keep, or is called with a stack that is not
// aligned to 8: assembly may forget either.
import { load, RAM } from '../bench/m0plus.mjs'

const [packages, elf] = process.argv.slice(2)
const { core, memory, symbols, enter } = load(packages, elf)
const names = new Map() // of the library's functions, by where they begin
const routines = new Set(['glint_mesh_outlined', 'glint_mesh_hide_face']) // in assembly, for assembly: they keep no register
for (const [name, at] of symbols) if (name.startsWith('glint_') && !routines.has(name)) names.set(at & ~1, name)
const begins = new Uint8Array(memory.length / 2)
for (const at of names.keys()) begins[(at - RAM) >> 1] = 1

const kept = () => { // r4 to r11, and sp
  const registers = core.registers.slice(4, 13)
  registers[8] = core.SP
  return registers
}
const calls = [] // under way: name, where it returns, and what is to be as it was then
let back = 0 // where the last of them returns

function stop(name, why) {
  console.error(`${name} ${why}`)
  process.exit(1)
}

function leave() {
  const { name, before } = calls.pop()
  const now = kept()
  if (now[8] < before[8]) return calls.push({ name, back, before }) // a call further in has the same place to return to
  if (now.some((value, i) => value !== before[i])) stop(name, 'returns with other registers than it was given')
  back = calls.length ? calls[calls.length - 1].back : 0
}

function run() {
  const { registers } = core
  for (;;) {
    const pc = registers[15]
    if (pc === back) for (let at = calls.length; pc === back && at--;) leave() // a function that ends by calling another returns for it, too
    if (begins[(pc - RAM) >> 1]) {
      if (core.SP & 7) stop(names.get(pc), 'is called with a stack that is not aligned to 8')
      back = core.LR & ~1
      calls.push({ name: names.get(pc), back, before: kept() })
    }
    core.executeInstruction()
  }
}

let text = ''
core.rp2040.onBreak = () => {
  const [operation, argument] = core.registers
  if (operation === 3) { // SYS_WRITEC
    text += String.fromCharCode(memory[argument - RAM])
  } else { // SYS_EXIT; ADP_Stopped_ApplicationExit
    process.stdout.write(text)
    process.exit(argument === 0x20026 ? 0 : 1)
  }
}
enter('bare_run', [])
run()
