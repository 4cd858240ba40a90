// SPDX-License-Identifier: MIT
// test_end_to_end.mjs PACKAGES FOLDER PANEL JUDGE GLINT, run by attach under the lab's kernel: that kernel's own GUD driver, and
// glint stream by libusb, draw on the emulated board.
import { existsSync, openSync, readdirSync, readFileSync, writeFileSync, writeSync } from 'node:fs'
import { picture565, shown565 } from './gud.mjs'
import { Judge } from './judge.mjs'
import { Plugged } from './plugged.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, panel, program, glint] = process.argv.slice(2)
const judge = new Judge(program, panel)
const { width, height } = judge
const seen = [] // a picture after each transfer of pixels, while they are collected
let collects = false
const board = new Plugged(packages, folder, judge, () => { if (collects) seen.push(look()) }).attached()
const { pico, bridge } = board
const look = () => board.look(), serve = (...args) => board.serve(...args), command = (...args) => board.command(...args)
// How long the transcript is at the end of every whole frame, while they are collected: looked at later, since the host does not
// wait for ever.
const frames = []
let collects_frames = false, was_whole = false
const plain_sent = pico.wires.sent.bind(pico.wires)
pico.wires.sent = (spi) => {
  plain_sent(spi)
  const is_whole = pico.wires.pixels === 2 * width * height
  if (is_whole && !was_whole && collects_frames && /lights\r\n$/.test(pico.uart)) frames.push(pico.wires.length)
  was_whole = is_whole
}
// The first frame of an owner is complete before the display is switched on.
const lit = (transcript) => Buffer.concat([transcript, Buffer.from('C\x29B\x01', 'latin1')])

await run([
  ['the kernel\'s driver for USB displays takes the board for one, and its other interface for none', async () => {
    await serve(() => existsSync('/dev/fb0'), '/dev/fb0')
    await serve(() => pico.uart.endsWith('a computer draws\r\n'), 'the hand-over')
    check(!existsSync('/dev/fb1'), 'there is a second frame buffer')
    equal(readFileSync('/sys/class/graphics/fb0/virtual_size', 'utf8').trim(), `${width},${height}`, 'its size')
  }],
  ['what is written to its frame buffer is on the panel, bit for bit', async () => {
    equal(+readFileSync('/sys/class/graphics/fb0/bits_per_pixel', 'utf8'), 16, 'bits a pixel')
    const pixels = picture565(width, height, 77)
    writeSync(openSync('/dev/fb0', 'w'), pixels)
    const wanted = shown565(pixels)
    await serve(() => !bridge.queue.length && look().equals(wanted), 'the picture')
  }],
  ['the kernel dims its backlight', async () => {
    const folder = `/sys/class/backlight/${readdirSync('/sys/class/backlight')[0]}`
    equal(+readFileSync(`${folder}/max_brightness`, 'utf8'), 100, 'the brightest')
    for (const [percent, shines] of [[40, 16], [0, 1], [100, 100]]) {
      writeFileSync(`${folder}/brightness`, `${percent}`)
      await serve(() => !bridge.queue.length && Math.abs(pico.brightness() - shines) < 0.5, `${percent} percent`)
    }
  }],
  ['glint list finds it by its name', async () => {
    const text = await command([glint, 'list', '--json'])
    check(text.includes(`${width}`) && /glint|ST7789/.test(text), text)
  }],
  ['glint stream, by libusb, draws every frame as glint draws it into files', async () => {
    const FRAMES = 3
    const scene = ['stream', 'coin', `--size=${width}x${height}`, '--format=rgb565', '--fps=0', `--frames=${FRAMES}`]
    const files = `${process.env.TMPDIR ?? '/tmp'}/end-%d.ppm`
    await command([glint, ...scene, '--to=ppm', '-o', files])
    collects = true
    await command([glint, ...scene, '--to=usb', '--detach'])
    collects = false
    let at = 0
    for (let i = 0; i < FRAMES; i++) {
      const file = readFileSync(files.replace('%d', i)), wanted = file.subarray(file.length - 3 * width * height)
      while (at < seen.length && !seen[at].equals(wanted)) at++
      check(at < seen.length, `frame ${i} is not among the ${seen.length} pictures on the panel`)
    }
  }],
  ['glint stream --shade device sends 16 bytes a frame while the kernel keeps the display, and the panel shows what glint draws', async () => {
    const FRAMES = 12
    const scene = ['stream', '--height=tests/data/rockwall-height.png', `--size=${width}x${height}`, '--fps=0', `--frames=${FRAMES}`]
    const files = `${process.env.TMPDIR ?? '/tmp'}/shade-%d.ppm`
    await command([glint, ...scene, '--format=rgb565', '--path=colour-int8', '--to=ppm', '-o', files])
    frames.length = 0
    collects_frames = true
    const text = await command([glint, ...scene, '--to=usb', '--shade=device', '--json'])
    collects_frames = false
    const wanted = Array.from({ length: FRAMES }, (_, i) => readFileSync(files.replace('%d', i)))
    equal(frames.length, FRAMES, `frames on the panel; glint says ${text}`)
    wanted.forEach((file, i) => judge.same(judge.look(lit(pico.wires.transcript().subarray(0, frames[i]))), file.subarray(file.length - 3 * width * height), `frame ${i}`))
    const figures = JSON.parse(text.slice(text.indexOf('{')))
    equal(figures.frame_bytes.mean, 16, 'bytes a frame')
    check(existsSync('/dev/fb0'), 'the kernel\'s driver has lost the display')
  }],
  ['a second program reads that another one uses it', async () => {
    const words = [glint, 'stream', '--height=tests/data/rockwall-height.png', `--size=${width}x${height}`, '--fps=0', '--to=usb', '--shade=device']
    const other = board.start_command(words)
    try {
      await serve(() => pico.uart.endsWith('lights\r\n') || other.status !== undefined, 'glint stream')
      const text = await command(words, 1)
      check(text.includes(': another program uses it; end that first'), text)
    } finally { other.child.kill('SIGINT') }
    await serve(() => other.status !== undefined, 'the end of glint stream')
  }],
  ['the kernel\'s driver has the display back afterwards', async () => {
    await serve(() => existsSync('/dev/fb0'), '/dev/fb0')
    const pixels = picture565(width, height, 78), wanted = shown565(pixels)
    writeSync(openSync('/dev/fb0', 'w'), pixels)
    await serve(() => !bridge.queue.length && look().equals(wanted), 'the picture')
  }],
])
