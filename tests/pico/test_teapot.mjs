// SPDX-License-Identifier: MIT
// test_teapot.mjs PACKAGES FOLDER PANEL JUDGE [both]: the demo of an image that was built with DEMO=teapot, for a panel of any shape; both: and with
// SECOND_CORE=1, whose core is a model of ours (second_core.mjs). Figures go to FOLDER/figures.json.
import { writeFileSync } from 'node:fs'
import { Judge } from './judge.mjs'
import { Pico, symbolsOf } from './pico.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, panel, program, both] = process.argv.slice(2)
const judge = new Judge(program, panel, folder)
const { height } = judge
const symbols = symbolsOf(`${folder}/glint.elf`)
const pico = new Pico(packages, judge.board).load(`${folder}/glint.uf2`)
if (both) pico.with_second_core()
const { wires } = pico
const LIT = Buffer.from(judge.board.qspi ? 'C\x29C\x51D\xff' : 'C\x29B\x01', 'latin1') // the first frame comes before the display is switched on
const FRAMES = both ? 6 : judge.board.qspi ? 3 : 4
const figures = { panel, frames: [], cores: both ? 2 : 1 }

// When the bottom of a picture is on the panel; it may be followed by the next one's window at once.
let ended = []
const take_data = wires.take_data.bind(wires)
wires.take_data = (value) => { take_data(value); if (wires.picture_done(height)) ended.push({ at: pico.cycles, length: wires.length }) }

run([
  ['the board starts and says that it turns a mesh', () => {
    check(pico.run(() => pico.uart.includes('turning a mesh'), 3000), `the UART has only: ${pico.uart}`)
    check(!both || pico.second.running, 'the second core is not launched')
  }],
  ['every frame equals the host\'s picture in one strip, bit for bit', () => {
    check(pico.run(() => ended.length === FRAMES, 600), `${ended.length} of ${FRAMES} frames end: ${pico.uart}`)
    ended.forEach(({ length }, i) => judge.same(judge.look(Buffer.concat([wires.transcript().subarray(0, length), LIT])),
      judge.teapot(i), `frame ${i}`))
    check(judge.board.qspi || wires.level('backlight') === 1, 'the backlight is off')
  }],
  ['frames differ as the mesh turns', () => {
    check(!judge.teapot(0).equals(judge.teapot(1)), 'the first two are alike')
  }],
  [judge.board.qspi ? 'windows are even, writes are not small, and select frames whole bytes' : 'D/C and the size of a frame change only while nothing is sent', () => {
    equal(wires.faults.length, 0, `faults, the first: ${wires.faults[0]}`)
  }],
  ['the mesh and the code that draws it are in RAM', () => {
    const in_flash = [...symbols].filter(([name, at]) => /^(glint_mesh_|glint_reciprocal|turntable_|demo_mesh_(places|normals|faces))/.test(name) &&
      !/^glint_mesh_(exact|check|row_next|in_front|edges_bytes)/.test(name) && at < 0x20000000)
    check(in_flash.length === 0, `in flash: ${in_flash.map(([name]) => name)}`)
  }],
  ['the second core\'s stack suffices', () => {
    if (!both) return
    figures.second_stack = 0x20041000 - pico.second.lowest
    check(figures.second_stack > 0 && figures.second_stack <= 1024 * 7 / 8, `${figures.second_stack} bytes of 1024 are used`)
  }],
], () => {
  figures.frames = ended.slice(1).map(({ at }, i) => (at - ended[i].at) / 125e3)
  const worst = Math.max(...figures.frames.slice(1))
  writeFileSync(`${folder}/figures.json`, JSON.stringify(figures, null, 2) + '\n')
  console.log(`# ${panel}, ${figures.cores} core${both ? 's' : ''}: a frame every ${figures.frames.map((ms) => ms.toFixed(2))} ms, ` +
    `${(1000 / worst).toFixed(1)} a second at the worst (emulated, with SPI time modelled${both ? ', the second core by a model of ours' : ''})`)
})
