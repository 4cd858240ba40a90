// SPDX-License-Identifier: MIT
// test_round.mjs PACKAGES FOLDER PANEL JUDGE: the demo of an image for a round panel, turned or not: its picture, and what is sent of it.
import { Judge } from './judge.mjs'
import { Pico } from './pico.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, panel, program] = process.argv.slice(2)
const judge = new Judge(program, panel, folder)
const { width, height, board } = judge
const pico = new Pico(packages, { pins: board.pins }).load(`${folder}/glint.uf2`)
const { wires } = pico
const done = () => wires.picture_done(height)
const FRAMES = 3
const ends = []
let bytes = 0, pixels = 0
const put = wires.put.bind(wires)
wires.put = (kind, byte) => { put(kind, byte); if (kind === 'C' || kind === 'D') bytes++; if (kind === 'D' && wires.command === 0x2c) pixels++ }

run([
  ['the board starts and says which panel it has', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), `the UART has only: ${pico.uart}`)
    check(pico.uart.includes(`GC9A01 ${width}x${height}`), pico.uart)
  }],
  ['every frame equals the host\'s in the whole circle, bit for bit, as the panel hangs', () => {
    for (let i = 0; i < FRAMES; i++) {
      if (i === FRAMES - 1) bytes = pixels = 0
      check(pico.run(done, 500), `frame ${i} does not end; ${pico.uart}`)
      ends.push(pico.cycles)
      check(i > 0 || pico.run(() => wires.level('backlight') === 1, 1), 'the backlight stays off')
      judge.same(judge.look(wires.transcript()), judge.demo(i), `frame ${i}`)
      if (i < FRAMES - 1) check(pico.run(() => !done(), 100), `no frame begins after frame ${i}`)
    }
  }],
  ['at most 82.5 % of a square\'s bytes are sent, commands included', () => {
    check(bytes > 0.78 * 2 * width * height && bytes < 0.825 * 2 * width * height, `${bytes} bytes`)
  }],
  ['D/C and the size of a frame change only while nothing is sent', () => {
    equal(wires.faults.length, 0, `faults, the first: ${wires.faults[0]}`)
  }],
], () => console.log(`# ${board.name}, ${panel}, turned by ${90 * judge.rotation}: a frame every ${((ends[2] - ends[1]) / 125e3).toFixed(2)} ms; ` +
  `${bytes} bytes a frame, ${(100 - bytes / width / height * 50).toFixed(1)} % fewer than a square (emulated)`))
