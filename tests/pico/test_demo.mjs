// SPDX-License-Identifier: MIT
// test_demo.mjs PACKAGES FOLDER PANEL JUDGE: the stand-alone demo of the image FOLDER/glint.uf2 in the emulator. Figures go to
// FOLDER/figures.json.
import { writeFileSync } from 'node:fs'
import { Judge } from './judge.mjs'
import { Pico, symbolsOf, WatchdogBite } from './pico.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, panel, program] = process.argv.slice(2)
const judge = new Judge(program, panel)
const { width, height } = judge
const pixels = width * height
const symbols = symbolsOf(`${folder}/glint.elf`)
const pico = new Pico(packages).load(`${folder}/glint.uf2`)
const { wires } = pico
const frame_done = () => wires.pixels === 2 * pixels
const FRAMES = 3

// How often the inner loop runs.
let loops = 0
const probe_loop = () => pico.probes.set(symbols.get('glint_colour_int8') & ~1, () => loops++)

const frames = [] // when each was on the panel, in cycles; and its picture
let dark

run([
  ['the board starts, says what it is and initialises the panel', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), `the UART has only: ${pico.uart}`)
    check(/^glint \d+\.\d+\.\d+, /.test(pico.uart), pico.uart)
    dark = judge.look(wires.transcript())
  }],
  ['nothing is to be seen until the first picture is whole', () => {
    check(dark.every((level) => level === 0), 'the panel shows something')
  }],
  ['every frame equals the host\'s bit for bit', () => {
    probe_loop()
    for (let i = 0; i < FRAMES; i++) {
      check(pico.run(frame_done, 500), `frame ${i} does not end: ${wires.pixels} of ${2 * pixels} bytes; ${pico.uart}`)
      const at = pico.cycles
      check(i > 0 || pico.run(() => wires.level('backlight') === 1, 1), 'the backlight stays off')
      frames.push(at)
      judge.same(judge.look(wires.transcript()), judge.demo(i), `frame ${i}`)
      check(pico.run(() => !frame_done(), 100), `no frame begins after frame ${i}`)
    }
  }],
  ['frames differ as the light moves', () => {
    check(!judge.demo(0).equals(judge.demo(1)), 'the first two are alike')
  }],
  ['D/C and the size of a frame change only while nothing is sent', () => {
    equal(wires.faults.length, 0, `faults, the first: ${wires.faults[0]}`)
  }],
  ['the inner loop is the assembly, from RAM, once a line', () => {
    check(symbols.get('glint_colour_int8') >= 0x20000000, 'glint_colour_int8 is in flash')
    check(loops >= FRAMES * height, `${loops} calls for ${FRAMES} frames of ${height} lines`)
  }],
  ['a bus that hangs is met by the watchdog', () => {
    wires.held = true
    try { pico.run(() => false, 1500) } catch (error) {
      if (error instanceof WatchdogBite) return
      throw error
    }
    throw new Error('the watchdog does not bite')
  }],
], () => {
  const frame_cycles = frames.length === FRAMES ? frames[FRAMES - 1] - frames[FRAMES - 2] : 0
  const figures = {
    panel, frame_cycles, frame_ms: frame_cycles / 125e3,
    frames_a_second: 125e6 / frame_cycles, spi_ms_a_frame: pixels * 16e3 / pico.chip.spi[1].clockFrequency,
  }
  writeFileSync(`${folder}/figures.json`, JSON.stringify(figures, null, 2) + '\n')
  console.log(`# ${panel}: a frame every ${figures.frame_ms.toFixed(2)} ms, of which SPI needs ` +
    `${figures.spi_ms_a_frame.toFixed(2)} (emulated, with SPI and flash time modelled)`)
})
