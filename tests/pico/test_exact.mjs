// SPDX-License-Identifier: MIT
// test_exact.mjs PACKAGES FOLDER PANEL JUDGE: the demo of an image that was built with PATH=exact.
import { Judge } from './judge.mjs'
import { Pico } from './pico.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, panel, program] = process.argv.slice(2)
const judge = new Judge(program, panel)
const pico = new Pico(packages).load(`${folder}/glint.uf2`)
const { wires } = pico
const bytes = 2 * judge.width * judge.height, FRAMES = 2
const ends = [] // of frames, in cycles

run([
  ['it says that every pixel is exact', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), pico.uart)
    check(pico.uart.includes('every pixel is exact'), pico.uart)
  }],
  ['every frame is the exact rectangle of the host, bit for bit', () => {
    for (let i = 0; i < FRAMES; i++) {
      check(pico.run(() => wires.pixels === bytes, 1000), `frame ${i} does not end: ${wires.pixels} of ${bytes} bytes; ${pico.uart}`)
      ends.push(pico.cycles)
      check(i > 0 || pico.run(() => wires.level('backlight') === 1, 1), 'the backlight stays off')
      judge.same(judge.look(wires.transcript()), judge.exact(i), `frame ${i}`)
      check(pico.run(() => wires.pixels !== bytes, 200), `no frame begins after frame ${i}`)
    }
  }],
  ['the exact picture is not that of the tables', () => {
    check(!judge.exact(0).equals(judge.demo(0)), 'they are alike')
  }],
  ['D/C never changed while a byte was sent', () => {
    equal(wires.faults.length, 0, `faults, the first: ${wires.faults[0]}`)
  }],
], () => console.log(`# ${panel}: every pixel exact, a frame every ${((ends[1] - ends[0]) / 125e3).toFixed(1)} ms (emulated)`))
