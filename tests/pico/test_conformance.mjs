// SPDX-License-Identifier: MIT
// test_conformance.mjs PACKAGES FOLDER EXPECTED [both]: the image FOLDER/conformance.uf2 in the emulator, as far as its first checks,
// against the host's hashes in the header EXPECTED. (All of it takes minutes here; tier targets runs all checks on this core.)
// both: one that was built with SECOND_CORE=1, as far as its frame rate; that core is a model of ours (second_core.mjs).
import { readFileSync } from 'node:fs'
import { Pico } from './pico.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, expected, both] = process.argv.slice(2)
const list = [...readFileSync(expected, 'utf8').matchAll(/0x([0-9a-f]{16})\), \/\* (.*) \*\//g)]
const wanted = list.map((match) => match[1])
const tables = list.findIndex((match) => match[2].startsWith('colour-')) // 20 KB of them, and what follows: too slow here
const CHECKS = Number(process.env.CONFORMANCE_CHECKS ?? tables)

const pico = new Pico(packages)
// The SDK's serial port asks the boot ROM for its functions, to read the flash's number: they are all `bx lr` here.
const rom = new Uint32Array(4096)
const halves = new Uint16Array(rom.buffer)
halves[0x14 / 2] = 0x40 // the table
halves[0x18 / 2] = 0x21 // what looks a function up: movs r0, #0x31; bx lr
halves.set([0x2031, 0x4770], 0x20 / 2)
halves[0x30 / 2] = 0x4770
pico.chip.loadBootrom(rom)
pico.load(`${folder}/conformance.uf2`)
if (both) pico.with_second_core()

run([
  ['the report begins with what is tested, and with the frame rate', () => {
    check(pico.run(() => pico.uart.includes('frames/s'), 5000), `the UART has only: ${pico.uart}`)
    check(/^# glint \d+\.\d+\.\d+, conformance, /.test(pico.uart), pico.uart)
    const [, us, rate] = pico.uart.match(/panel: (\d+) us a frame, (\d+) frames/)
    check(us > 1000 && us < 100000, `${us} us a frame`)
    equal(Number(rate), Math.floor(1e6 / us), 'frames a second')
  }],
  ['the D/C line and the panel are served as by the display itself', () => {
    equal(pico.wires.faults.length, 0, `faults, the first: ${pico.wires.faults[0]}`)
  }],
  ...both ? [['the second core is launched for that rate', () => {
    check(pico.second.running, 'the second core is not launched')
  }]] : [[`the first ${CHECKS} checks give the results of the host`, () => {
    check(CHECKS > 0 && CHECKS <= list.length, `the header has no such check: ${CHECKS} of ${list.length}`)
    const lines = () => [...pico.uart.matchAll(/^(not )?ok (\d+) - .*: ([0-9a-f]{16})(?=.*\r\n)/mg)]
    check(pico.run(() => lines().length >= CHECKS, 600000), `the UART has only: ${pico.uart}`)
    for (const [line, not, number, hash] of lines()) check(!not && hash === wanted[number - 1], line)
  }]],
], () => console.log(`# ${pico.uart.match(/relit.*/)?.[0]} (emulated)`))
