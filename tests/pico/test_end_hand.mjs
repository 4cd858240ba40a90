// SPDX-License-Identifier: MIT
// test_end_hand.mjs PACKAGES FOLDER PANEL JUDGE GLINT, run by attach under the lab's kernel: a board with an accelerometer, a model of it on the emulated I2C.
// glint stream, by libusb, asks the board for its light, and gives it another.
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { Judge } from './judge.mjs'
import { Plugged } from './plugged.mjs'
import { symbolsOf } from './pico.mjs'
import { Qmi8658 } from './qmi8658.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, panel, program, glint] = process.argv.slice(2)
const judge = new Judge(program, panel, folder)
const { width, height } = judge
const symbols = symbolsOf(`${folder}/glint.elf`)
let imu
const board = new Plugged(packages, folder, judge, undefined, ({ chip }) => { imu = new Qmi8658(chip, judge.board.sda / 2 % 2, { seed: 5 }) }).attached()
const { pico } = board
// How long the transcript is at the end of every frame that a computer lights.
const frames = [], sent = pico.wires.sent.bind(pico.wires)
pico.wires.sent = (spi) => { sent(spi); if (pico.wires.picture_done(height) && pico.uart.endsWith('a computer sends lights\r\n')) frames.push(pico.wires.length) }
const shown = () => [0, 1, 2].map((i) => pico.chip.readUint32(symbols.get('shown_to_light') + 4 * i) | 0)
const tilt = (degrees) => { imu.gravity = [Math.sin(degrees * Math.PI / 180), 0, Math.cos(degrees * Math.PI / 180)] }
const file = (name) => `${process.env.TMPDIR ?? '/tmp'}/${name}`
// What glint draws of the wall under a light of the board's, as the panel shows it.
async function wall(to_light) {
  writeFileSync(file('light'), to_light.map((value) => value / 32768).join(' ') + '\n')
  await board.command([glint, ...scene, '--frames=1', '--format=rgb565', '--path=colour-int8', `--lights=${file('light')}`, '--to=ppm', '-o', file('wall-%d.ppm')])
  return judge.seen(readFileSync(file('wall-0.ppm')).subarray(-3 * width * height))
}
const scene = ['stream', '--height=tests/data/rockwall-height.png', `--size=${width}x${height}`, '--fps=0']
const from_board = [...scene, '--to=usb', '--shade=device', '--lights=board']

await run([
  ['the kernel\'s driver has the display, and the hand the light', async () => {
    await board.serve(() => existsSync('/dev/fb0'), '/dev/fb0')
    await board.serve(() => pico.uart.endsWith('a computer draws\r\n') && pico.uart.includes('the light follows the hand'), 'the hand-over')
  }],
  ['glint stream --lights board draws under the light that the board tells, however it is tilted', async () => {
    for (const degrees of [0, 25]) {
      tilt(degrees)
      pico.run(() => false, 700)
      frames.length = 0
      await board.command([glint, ...from_board, '--frames=8'])
      const told = [0, 1, 2].map((i) => pico.chip.readUint32(symbols.get('tilt') + 12 + 4 * i) | 0).map((value) => Math.trunc(value / 64))
      check(Math.abs(Math.atan2(told[0], told[2]) * 180 / Math.PI - degrees) < 1.5, `${degrees} degrees: ${told}`)
      equal(frames.length, 8, `frames at ${degrees} degrees`)
      judge.same(judge.look(Buffer.concat([pico.wires.transcript().subarray(0, frames[7]), Buffer.from('C\x29B\x01', 'latin1')])), await wall(told), `the picture at ${degrees} degrees`)
    }
  }],
  ['glint stream --shade demo sets the light of what the board shows by itself, in the place of what the kernel draws', async () => {
    const lights = [[-1, 1, 2], [0.5, -0.25, 1]]
    writeFileSync(file('lights'), lights.map((light) => light.join(' ')).join('\n') + '\n')
    await board.command([glint, 'stream', '--to=usb', '--shade=demo', `--lights=${file('lights')}`, '--fps=4'])
    await board.serve(() => pico.uart.endsWith('a computer gives the light\r\n'), 'the demo')
    pico.run(() => false, 200)
    const [x, y, z] = shown()
    check(Math.abs(x + 2 * y) <= 2 && Math.abs(z - 2 * x) <= 2 && x > 0, `the light is ${[x, y, z]}`)
    judge.same(board.look(), judge.scene('watchface', [x, y, z]), 'the picture')
    await board.serve(() => pico.uart.endsWith('a computer draws\r\n'), 'the kernel\'s display after the last light')
  }],
  ['a sensor that no longer answers ends the stream with a sentence', async () => {
    imu.fault = 'hangs'
    await board.serve(() => pico.uart.includes('the accelerometer does not answer'), 'what the board says')
    const text = await board.command([glint, ...from_board, '--frames=8'], 1)
    check(/its accelerometer does not answer/.test(text) && text.trim().split('\n').length === 1, text)
  }],
])
