// SPDX-License-Identifier: MIT
// test_amoled.mjs PACKAGES FOLDER PANEL JUDGE: a board with an AMOLED panel on QSPI: a picture in the middle of its glass, or the whole of it from a palette, by a state machine
// that the emulator steps (pico.mjs), which also judges what is sent: even windows, no small writes; a computer's pictures come whole. Figures
// go to FOLDER/figures.json.
import { writeFileSync } from 'node:fs'
import { FORMAT, Gud, picture565, shown565 } from './gud.mjs'
import { Judge } from './judge.mjs'
import { Pico, symbolsOf } from './pico.mjs'
import { Qmi8658 } from './qmi8658.mjs'
import { check, equal, run } from './tap.mjs'
import { UsbHost } from './usb_host.mjs'

const [packages, folder, panel, program] = process.argv.slice(2)
const judge = new Judge(program, panel, folder)
const { width, height, board } = judge
const GLASS = 466, is_whole = width === GLASS, LEFT = is_whole ? 0 : 112, TOP = LEFT // where the picture lies
const dial = (to_light) => is_whole ? judge.palette('watchface', to_light) : judge.scene('watchface', to_light)
const symbols = symbolsOf(`${folder}/glint.elf`)
const pico = new Pico(packages, board).load(`${folder}/glint.uf2`)
const { wires, chip } = pico
const host = new UsbHost(pico)
const imu = new Qmi8658(chip, board.sda / 2 % 2, { seed: 7 })
const tilted = (degrees) => [Math.sin(degrees * Math.PI / 180), 0, Math.cos(degrees * Math.PI / 180)]
const frames = [] // when each was on the panel, its light, how long the bus took
let light, wire
const take_command = wires.take_command.bind(wires), take_data = wires.take_data.bind(wires)
wires.take_command = (value) => {
  take_command(value)
  if (value !== 0x2c || wires.window.readUInt16BE(4) !== TOP) return
  light = [0, 1, 2].map((i) => chip.readUint32(symbols.get('shown_to_light') + 4 * i) | 0)
  wire = wires.wire_ns
}
wires.take_data = (value) => {
  take_data(value)
  if (wires.command === 0x2c && wires.picture_done(height, TOP)) frames.push({ ns: chip.clock.nanos, light, wire_ms: (wires.wire_ns - wire) / 1e6 })
}
const FRAMES = 4
let dark
const figures = {}

run([
  ['the board starts, says which panel it has and finds its accelerometer', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), `the UART has only: ${pico.uart}`)
    check(pico.uart.includes(`CO5300 ${width}x${height}`), pico.uart)
    dark = judge.look(wires.transcript())
  }],
  ['nothing is to be seen until the first picture is whole', () => {
    check(dark.every((level) => level === 0), 'the panel shows something')
    check(pico.run(() => frames.length === 1, 500), 'no frame ends')
  }],
  ['every frame equals the host\'s bit for bit, as the hand moves', () => {
    for (let i = 1; i <= FRAMES; i++) {
      imu.gravity = tilted(i + 2)
      const from = frames.length
      check(pico.run(() => frames.length > from, 200), `frame ${i} does not end: ${pico.uart}`)
      judge.same(judge.look(wires.transcript()), dial(frames.at(-1).light), `frame ${i}`)
    }
  }],
  ['around it the glass is black', () => {
    const glass = judge.look_around(wires.transcript(), GLASS, GLASS), picture = judge.look(wires.transcript())
    let lit = 0
    for (let y = 0; y < GLASS; y++) {
      const row = glass.subarray(3 * GLASS * y, 3 * GLASS * (y + 1)), inside = y >= TOP && y < TOP + height
      if (inside) equal(row.subarray(3 * LEFT, 3 * (LEFT + width)).compare(picture, 3 * width * (y - TOP), 3 * width * (y - TOP + 1)), 0, `line ${y}`)
      for (let x = 0; x < GLASS; x++) if (!(inside && x >= LEFT && x < LEFT + width) && (row[3 * x] || row[3 * x + 1] || row[3 * x + 2])) lit++
    }
    equal(lit, 0, 'pixels that are lit')
  }],
  ['a computer is told to send whole pictures, and what it sends is shown', () => {
    const gud = new Gud(host)
    host.enumerate()
    const descriptor = gud.get(0x01, 30)
    equal(descriptor.readUInt32LE(5), 2, 'flags: full updates')
    equal(descriptor[9], 0, 'compression')
    check(gud.begin(FORMAT.rgb565), `refused with status ${gud.status()}`)
    check(!gud.buffer({ x: 1, y: 1, width: 3, height: 3, length: 18 }), 'an odd rectangle is taken')
    for (const seed of [1, 2]) {
      const bytes = picture565(width, height, seed)
      host.bulk(1, bytes)
      pico.run(() => false, 1)
      judge.same(judge.look(wires.transcript()), judge.seen(shown565(bytes)), `picture ${seed}`)
    }
  }],
  ['after a cut frame the next one begins where the host announces it, as Linux does, or ends a halt', () => {
    const gud = new Gud(host), length = 2 * width * height
    const again = [['announced', () => check(gud.buffer({ x: 0, y: 0, width, height, length }), `refused with status ${gud.status()}`)],
      ['after CLEAR_FEATURE', () => check(host.clear_halt(1), 'CLEAR_FEATURE is refused')],
      ['after a halt and its end', () => check(host.halt(1) && host.clear_halt(1), 'SET_FEATURE or CLEAR_FEATURE is refused')]]
    for (const [i, [what, begin]] of again.entries()) {
      host.bulk(1, picture565(width, height, 10 + i).subarray(0, 64 * (50 + i)))
      begin()
      const bytes = picture565(width, height, 20 + i)
      host.bulk(1, bytes)
      pico.run(() => false, 1)
      judge.same(judge.look(wires.transcript()), judge.seen(shown565(bytes)), what)
    }
  }],
  ['windows are even, writes are not small, and select frames whole bytes', () => {
    equal(wires.faults.length, 0, `faults, the first: ${wires.faults[0]}`)
    check(wires.small >= 72 && wires.small < Infinity, `the smallest write has ${wires.small} bytes`)
  }],
], () => {
  figures.frame_ms = frames.slice(2).map(({ ns }, i) => (ns - frames[i + 1].ns) / 1e6)
  figures.bus_ms = frames.at(-1)?.wire_ms
  writeFileSync(`${folder}/figures.json`, JSON.stringify(figures, null, 2) + '\n')
  console.log(`# ${board.name}, ${panel}: a frame every ${Math.min(...figures.frame_ms).toFixed(2)} ms at best, of which the bus needs ` +
    `${figures.bus_ms?.toFixed(2)} (emulated; its state machine stepped by the processor's cycles)`)
})
