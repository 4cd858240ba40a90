// SPDX-License-Identifier: MIT
// rp2040js in a seventh less of a processor's time (measured once): of an instruction it asks some seventy conditions in turn, each about
// the instruction's 16 bits alone. Here a table of all 65,536, made by those conditions, says which holds, and the same is done.
// Instructions of 32 bits go the old way.
import { createRequire, Module } from 'node:module'
import { resolve } from 'node:path'

// The source with a switch in front of executeInstruction's chain of conditions.
function sorted(source) {
  const begin = source.indexOf('    executeInstruction() {'), end = source.indexOf('\n    }\n', begin)
  const from = source.indexOf('        if (opcode >>', begin), to = source.lastIndexOf('        this.cycles += deltaCycles;', end)
  if (begin < 0 || from < begin || to < from) throw new Error('this is not the rp2040js that package-lock.json names')
  const chain = source.slice(from, to)
  const branches = [...chain.matchAll(/^ {8}(?:else )?if \((.*)\) \{\n((?: {12}.*\n|\n)*) {8}\}\n/gm)].map(([, condition, body]) => ({ condition, body }))
  const holds = branches.map(({ condition }) => new Function('opcode', 'wideInstruction', 'opcode2', `'use strict'; return ${condition}`))
  const which = Uint8Array.from({ length: 65536 }, (_, opcode) => opcode >> 11 >= 0b11101 ? 0 : 1 + holds.findIndex((hold) => hold(opcode, false, 0)))
  const cases = branches.map(({ body }, i) => `        case ${i + 1}: {\n${body}        break; }\n`).filter((_, i) => which.includes(i + 1))
  return `const whichOf = new Uint8Array([${which}]);\n${source.slice(0, from)}        switch (whichOf[opcode]) {\n${cases.join('')}        default:\n${chain}        }\n${source.slice(to)}`
}

/** rp2040js as npm has put it into the folder PACKAGES. */
export function emulator(packages) {
  const { _compile } = Module.prototype
  Module.prototype._compile = function (source, file) {
    return _compile.call(this, file.endsWith('cortex-m0-core.js') ? sorted(source) : source, file)
  }
  try {
    return createRequire(resolve(packages, 'x'))('rp2040js')
  } finally {
    Module.prototype._compile = _compile
  }
}
