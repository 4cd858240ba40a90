// SPDX-License-Identifier: MIT
// test_second_core.mjs PACKAGES FOLDER PANEL JUDGE: the demo of an image that was built with SECOND_CORE=1. The emulator has no second
// core: it is a model of ours (second_core.mjs).
import { Judge } from './judge.mjs'
import { Pico, WatchdogBite } from './pico.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, panel, program] = process.argv.slice(2)
const judge = new Judge(program, panel)
const { width, height } = judge
const uf2 = `${folder}/glint.uf2`
const pico = new Pico(packages).load(uf2).with_second_core()
const { wires, second } = pico
const frame_done = () => wires.pixels === 2 * width * height
const RAM_OF_LINES = 0x20040000, STACK = 1024, FRAMES = 4
let frame_ms, used

run([
  ['it says that both cores shade, and launches the second', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), pico.uart)
    check(pico.uart.includes('both cores shade'), pico.uart)
    check(second.running, 'the second core is not launched')
  }],
  ['every frame equals the host\'s bit for bit, half of it by each core', () => {
    let jobs = 0, at
    const plain = second.inbox[0].push
    second.inbox[0].push = function (...values) { jobs++; return plain.apply(this, values) }
    for (let i = 0; i < FRAMES; i++) {
      check(pico.run(frame_done, 500), `frame ${i} does not end: ${wires.pixels} bytes; ${pico.uart}`)
      check(i > 0 || pico.run(() => wires.level('backlight') === 1, 1), 'the backlight stays off')
      if (at) frame_ms = (pico.cycles - at) / 125e3
      at = pico.cycles
      judge.same(judge.look(wires.transcript()), judge.demo(i), `frame ${i}`)
      check(pico.run(() => !frame_done(), 100), `no frame begins after frame ${i}`)
    }
    check(jobs >= FRAMES * height, `the second core has answered ${jobs} times`)
  }],
  ['its stack is above the lines, and suffices', () => {
    used = RAM_OF_LINES + 4096 - second.lowest
    check(used > 0 && used <= STACK * 3 / 4, `${used} bytes of ${STACK} are used`)
  }],
  ['a second core that hangs is met by the watchdog', () => {
    second.running = false
    second.launch = () => {} // no core answers
    try { pico.run(() => false, 1500) } catch (error) {
      if (error instanceof WatchdogBite) return
      throw error
    }
    throw new Error('the watchdog does not bite')
  }],
  ['whatever happened, D/C never changed while a byte was sent', () => {
    equal(wires.faults.length, 0, `faults, the first: ${wires.faults[0]}`)
  }],
], () => console.log(`# ${panel}: with two cores a frame every ${frame_ms?.toFixed(2)} ms; ${used} bytes of the second one's stack ` +
  '(emulated, the second core by a model of ours)'))
