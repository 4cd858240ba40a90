// SPDX-License-Identifier: MIT
// test_hand.mjs PACKAGES FOLDER PANEL JUDGE hand|faults: a board with an accelerometer, whose light follows the hand: a model of the sensor's registers
// on the emulated I2C, still, tilted and knocked, or with faults, in a run of its own, since each takes minutes. Figures of the first go to FOLDER/figures.json.
import { writeFileSync } from 'node:fs'
import { Gud } from './gud.mjs'
import { Judge } from './judge.mjs'
import { Pico, symbolsOf } from './pico.mjs'
import { Qmi8658 } from './qmi8658.mjs'
import { check, equal, run } from './tap.mjs'
import { UsbHost } from './usb_host.mjs'

const [packages, folder, panel, program, part] = process.argv.slice(2)
const judge = new Judge(program, panel, folder)
const { height, board } = judge
const symbols = symbolsOf(`${folder}/glint.elf`)
const figures = {}
const SECONDS = Number(process.env.HAND_SECONDS ?? 2) // ten were seen; test_tilt has them at forty tilts

function powered_up(options) {
  const pico = new Pico(packages, { pins: board.pins }).load(`${folder}/glint.uf2`)
  const { wires, chip } = pico
  const imu = new Qmi8658(chip, board.sda / 2 % 2, options)
  const made = { pico, wires, chip, imu, host: new UsbHost(pico), frames: [], first_change: undefined }
  // What the panel has had in each window (-1: nothing yet), to find the first pixel that changes; frames by their ends.
  const windows = new Map()
  let before, at
  const put = wires.put.bind(wires)
  wires.put = (kind, byte) => {
    put(kind, byte)
    if (kind === 'C') {
      at = 0
      if (byte !== 0x2c) return
      const key = wires.window.toString('hex')
      if (!windows.has(key)) windows.set(key, new Int16Array(2 * judge.width * height).fill(-1))
      before = windows.get(key)
      if (wires.window.readUInt16BE(4) === 0) made.light = light_of(made)
      return
    }
    if (kind !== 'D' || wires.command !== 0x2c) return
    check(at < before.length, `more than ${at} bytes in a window`)
    if (before[at] !== byte) { made.changed++; made.first_change ??= chip.clock.nanos }
    before[at++] = byte
  }
  const sent = wires.sent.bind(wires)
  wires.sent = (spi) => { sent(spi); if (wires.picture_done(height)) made.frames.push({ ns: chip.clock.nanos, length: wires.length }) }
  made.changed = 0
  return made
}
// The light of the demo's frame, as the firmware has it: that of the picture whose first window is being opened.
const light_of = ({ chip }) => [0, 1, 2].map((i) => {
  const at = symbols.get('shown_to_light') + 4 * i
  return chip.readUint32(at) | 0
})
const tilted = (degrees) => [Math.sin(degrees * Math.PI / 180), 0, Math.cos(degrees * Math.PI / 180)]
// Until no frame has ended for so long that nothing is under way: a step of the hand is on the bus within 35 ms, and a frame takes 17.
const QUIET_NS = 80e6
function settle({ pico, chip, frames }) {
  let seen = frames.length, since = chip.clock.nanos
  check(pico.run(() => {
    if (frames.length !== seen) { seen = frames.length; since = chip.clock.nanos }
    return chip.clock.nanos - since > QUIET_NS
  }, 3000), 'the picture does not come to rest')
}
const pass = ({ pico }, ms) => pico.run(() => false, ms)
const said = (pico, text) => pico.uart.split(text).length - 1

// As firmware/core/light_protocol.h has them.
const SET_ENABLE = 0xa1, GET_LIGHT = 0xa6, SET_LIGHT = 0xa7, HELD_MS = 2500, SILENT = 1, SENSED = 2
function message(first, ...to_light) {
  const bytes = Buffer.alloc(16);
  [first, ...to_light].forEach((value, i) => bytes.writeInt32LE(value, 4 * i))
  return bytes
}
function computer_of({ host }) {
  host.enumerate()
  return new Gud(host, { interface_number: 1, endpoint: 2 })
}

let on, asks
const hand = [
  ['the sensor is found, set up as its data sheet says, and the light follows the hand', () => {
    on = powered_up({ seed: 7 })
    check(on.pico.run(() => on.pico.uart.includes('the light follows the hand'), 3000), on.pico.uart)
    equal(on.imu.log.map(([at, value]) => `${at.toString(16)}=${value.toString(16)}`).join(' '), '8=0 2=60 3=15 6=0 8=1', 'what is written')
    check(on.pico.run(() => on.frames.length > 1, 2000), 'no frames')
  }],
  [`for ${SECONDS} s a still hand with a real sensor\'s noise has a still picture, the host\'s bit for bit`, () => {
    settle(on)
    const { length } = on.frames, samples = on.imu.samples
    on.changed = 0
    on.pico.run(() => false, 1000 * SECONDS)
    equal(on.changed, 0, 'bytes of pixels that change')
    equal(on.frames.length, length, 'frames')
    check(on.imu.samples - samples > 240 * SECONDS && on.imu.reads > 240 * SECONDS, `${on.imu.samples - samples} samples, ${on.imu.reads} read`)
    judge.same(judge.look(on.wires.transcript()), judge.scene('watchface', on.light), 'the picture')
  }],
  ['a step of 5 degrees changes the first pixel on the bus within 35 ms, wherever it comes in a period', () => {
    figures.first_ms = []
    for (let i = 0; i < 6; i++) {
      settle(on)
      pass(on, i * 0.77)
      on.first_change = undefined
      on.imu.gravity = tilted(i % 2 ? 0 : 5)
      const from = on.chip.clock.nanos
      check(on.pico.run(() => on.first_change !== undefined, 100), 'nothing changes')
      figures.first_ms.push((on.first_change - from) / 1e6)
    }
    check(Math.max(...figures.first_ms) <= 35, `${figures.first_ms} ms`)
  }],
  ['a hand that moves has 60 frames a second, each the host\'s bit for bit', () => {
    const from = on.frames.length, begin = on.chip.clock.nanos
    for (let i = 0; i < 40; i++) {
      on.imu.gravity = tilted(i)
      on.pico.run(() => false, 16)
    }
    const ends = on.frames.slice(from).map(({ ns }) => ns)
    const times = ends.slice(2).map((ns, i) => (ns - ends[i + 1]) / 1e6)
    figures.frame_ms = times
    check(times.length > 30 && Math.max(...times) < 1000 / 60, `${times.length} frames in ${(on.chip.clock.nanos - begin) / 1e6} ms, the slowest in ${Math.max(...times)} ms`)
    settle(on)
    judge.same(judge.look(on.wires.transcript()), judge.scene('watchface', on.light), 'the picture')
  }],
  ['tilted, the light is where it was in the room: towards what was above', () => {
    on.imu.gravity = tilted(30)
    settle(on)
    const [x, y, z] = on.light, angle = Math.atan2(x, z) * 180 / Math.PI
    check(Math.abs(angle - 30) < 1 && Math.abs(y) < 400, `${[x, y, z]}`)
  }],
  ['a computer that asks learns the light and moves nothing', () => {
    asks = computer_of(on)
    const from = on.frames.length, told = asks.get(GET_LIGHT, 16)
    equal([0, 4, 8, 12].map((at) => told.readInt32LE(at)).join(), [SENSED, ...on.light].join(), 'what it learns')
    equal(asks.get(GET_LIGHT, 4).length, 4, 'bytes where fewer are asked for')
    equal(asks.get(GET_LIGHT, 16, 1), null, 'with a value')
    check(!asks.set(GET_LIGHT, Buffer.alloc(16)), 'it can be set')
    on.imu.gravity = tilted(20)
    asks.get(GET_LIGHT, 16)
    settle(on)
    check(on.frames.length > from && Math.abs(Math.atan2(on.light[0], on.light[2]) * 180 / Math.PI - 20) < 1, `after that the demo's light does not follow: ${on.light}`)
    equal(asks.get(GET_LIGHT, 16).readInt32LE(4), on.light[0], 'what it learns of the next')
    on.imu.gravity = tilted(30)
    settle(on)
  }],
  ['a computer sets the light of the demo, which stands still under it, and 2.5 seconds after the last it is the hand\'s again', () => {
    const hands = on.light.join(), PARAMETER = 4
    for (const wrong of [message(1, 0, 0, 9), message(0, 0, 0, 0), message(0, 0, 0, -5)]) {
      check(!asks.set(SET_LIGHT, wrong), `it takes ${wrong.toString('hex')}`)
      equal(asks.status(), PARAMETER, 'why not')
    }
    check(!asks.set(SET_LIGHT, message(0, 0, 0, 9), 1) && !asks.set(SET_LIGHT, Buffer.alloc(15)), 'it takes a value, or 15 bytes')
    pass(on, 100)
    equal(on.light.join(), hands, 'the light after what was refused')
    for (const light of [[-9000, 12000, 20000], [2 ** 30, -(2 ** 30), 2 ** 31 - 1]]) {
      check(asks.set(SET_LIGHT, message(0, ...light)), 'it is refused')
      pass(on, 100)
      equal(on.light.join(), light.join(), 'the light')
      judge.same(judge.look(on.wires.transcript()), judge.scene('watchface', light), 'the picture')
    }
    const { length } = on.frames
    pass(on, HELD_MS - 250)
    equal(on.frames.length, length, 'frames under a light that stands still')
    check(!asks.set(SET_LIGHT, message(0, 0, 0, -5)), 'a light from behind is taken')
    pass(on, 100)
    judge.same(judge.look(on.wires.transcript()), judge.scene('watchface', [2 ** 30, -(2 ** 30), 2 ** 31 - 1]), 'the picture after that')
    pass(on, 250) // what is refused does not begin that time again
    equal(on.light.join(), hands, 'the light after that time')
    judge.same(judge.look(on.wires.transcript()), judge.scene('watchface', on.light), 'the picture after that time')
    check(asks.set(SET_ENABLE, Buffer.of(1)) && !asks.set(SET_LIGHT, message(0, 0, 0, 9)) && asks.set(SET_ENABLE, Buffer.of(0)), 'it is set while the panel is the host\'s')
    settle(on)
    equal(on.light.join(), hands, 'the light after that')
  }],
  ['face down the panel is lit from the rim', () => {
    const turn = (from, to) => { // as a hand does: a jump would be a knock
      for (let i = 0; i <= 20; i++) { on.imu.gravity = tilted(from + (to - from) * i / 20); on.pico.run(() => false, 20) }
    }
    turn(30, 174)
    settle(on)
    check(on.light[2] === 8192, `${on.light}`)
    judge.same(judge.look(on.wires.transcript()), judge.scene('watchface', on.light), 'the picture')
    turn(174, 0)
    settle(on)
  }],
  ['a tap changes the scene, one change a tap', () => {
    const tap = () => {
      on.imu.gravity = [0.2, 0, 2.2]
      on.pico.run(() => false, 8)
      on.imu.gravity = [0, 0, 1]
      pass(on, 800) // .7 s until another counts
    }
    tap()
    judge.same(judge.look(on.wires.transcript()), judge.scene('coin', on.light), 'the picture')
    tap()
    judge.same(judge.look(on.wires.transcript()), judge.scene('watchface', on.light), 'the picture after another')
  }],
]
const faults = [
  ...['absent', 'nacks', 'hangs', 'nonsense', 'stuck'].map((fault) => [
    `a sensor that ${{ absent: 'is not there', nacks: 'refuses bytes in the middle', hangs: 'never ends a transfer', nonsense: 'says nonsense', stuck: 'is stuck' }[fault]}: the light circles, the UART says so once, and the board goes on`, () => {
      on = powered_up({ seed: 3 })
      on.imu.fault = fault
      check(on.pico.run(() => on.pico.uart.includes('the light circles'), 4000), on.pico.uart)
      const from = on.frames.length
      on.pico.run(() => false, 300)
      check(on.frames.length - from > 0.28 * 60, `${on.frames.length - from} frames in 0.3 s`)
      check(on.pico.run(() => !on.wires.picture_done(height), 50) && on.pico.run(() => on.wires.picture_done(height), 50), 'no frame ends')
      judge.same(judge.look(on.wires.transcript()), judge.scene('watchface', on.light), 'the picture')
      if (fault !== 'hangs' && fault !== 'nonsense') return
      on.pico.run(() => false, 1000) // it is looked for again
      equal(said(on.pico, 'the light circles'), 1, 'times that it is said')
      on.imu.free()
      check(on.pico.run(() => on.pico.uart.includes('follows the hand'), 1500), `it is not found again: ${on.pico.uart}`)
    }]),
  ['a sensor that is lost while it is used, in the middle of a transfer: the same', () => {
    on = powered_up({ seed: 4, address: 0x6a })
    check(on.pico.run(() => on.frames.length > 2, 3000), `at its other address: ${on.pico.uart}`)
    on.imu.fault = 'hangs'
    check(on.pico.run(() => on.pico.uart.includes('the light circles'), 500), on.pico.uart)
    const from = on.frames.length
    on.pico.run(() => false, 300)
    check(on.frames.length - from > 0.28 * 60, `${on.frames.length - from} frames in 0.3 s`)
    const told = computer_of(on).get(GET_LIGHT, 16)
    equal([0, 4, 8, 12].map((at) => told.readInt32LE(at)).join(), `${SILENT},0,0,0`, 'what a computer learns')
    equal(on.wires.faults.length, 0, `faults, the first: ${on.wires.faults[0]}`)
  }],
]
if (part === 'faults') run(faults)
else run(hand, () => {
  writeFileSync(`${folder}/figures.json`, JSON.stringify(figures, null, 2) + '\n')
  const round = (values) => values?.map((value) => value.toFixed(1)).join(', ')
  console.log(`# ${board.name}: first pixel after a step of 5 degrees: ${round(figures.first_ms)} ms; the dial: a frame every ` +
    `${Math.max(...figures.frame_ms ?? [0]).toFixed(2)} ms at most (emulated)`)
})
