// SPDX-License-Identifier: MIT
// test_webusb.mjs PACKAGES FOLDER PANEL JUDGE GLINT PAGE, run under the lab's kernel: the page's own transport and module, in node,
// reach the emulated board by WebUSB (the package usb, on the kernel's usbfs), beside the kernel's driver for its display.
import { existsSync, readFileSync } from 'node:fs'
import { resolve } from 'node:path'
import { Judge } from './judge.mjs'
import { Plugged } from './plugged.mjs'
import { HANGS, check, equal, run } from './tap.mjs'
import { asRgb, conforming, webUsb } from './web_usb.mjs'

const [packages, folder, panel, program, glint, page] = process.argv.slice(2)
const { Engine, filters, onDevice, Pico, sentences, stateOfWords, white, wordsOf } = await import(resolve(page, 'engine.mjs'))
const engine = new Engine(new WebAssembly.Module(readFileSync(`${page}/module.wasm`)))
const judge = new Judge(program, panel)
const { width, height } = judge
const board = new Plugged(packages, folder, judge)
board.in_real_time = true // as a program that streams without pause would keep this one from going on
const usb = webUsb(packages)
engine.addWhite(white, width, height)

let pico, has
async function connect() {
  const device = await board.during(usb.requestDevice({ filters }), 'requestDevice')
  pico = await board.during(Pico.connect(usb, conforming(device), (bytes) => engine.deviceSize(bytes), 1000 * HANGS), 'connecting')
  has = { map: '', material: '' }
}
const words = (light, more = ['--scene=coin', '-n40']) => wordsOf(onDevice(stateOfWords([...more, `--light=${light}`]), width, height, '200,140,40'))
// Draws in the module, sends what changed, and compares the panel with the module's picture. Returns what was sent.
async function follow(list) {
  const { rgba } = engine.draw(list), scene = engine.device(width, height, has)
  if (scene.map) await board.during(pico.sendMap(scene.map), 'the map')
  if (scene.material) await board.during(pico.sendMaterial(scene.material), 'the material')
  await board.during(pico.sendLight(scene.light), 'the light')
  has = scene.has
  judge.same(board.look(), asRgb(rgba), list.join(' '))
  return scene
}
async function trouble(promise) {
  const error = await board.during(promise, 'the trouble').then(() => undefined, (error) => error)
  check(error, 'nothing went wrong')
  return error.message
}
const has_display = () => existsSync('/dev/fb0')

await run([
  ['WebUSB finds the board and has its light interface, while the kernel\'s driver keeps the display', async () => {
    await board.plug()
    await board.serve(has_display, '/dev/fb0')
    await connect()
    equal(`${pico.width}x${pico.height}`, `${width}x${height}`, 'its size')
    check(board.pico.uart.endsWith('a computer sends lights\r\n'), board.pico.uart)
    check(has_display(), 'the display is gone')
  }],
  ['the panel shows the page\'s picture, bit for bit', async () => {
    const { map, material } = await follow(words('-1,1,1.2'))
    check(map.length === 4 * width * height && material.length === 48, 'the map and the material')
  }],
  ['a light that moves is 16 bytes, and each frame is the page\'s', async () => {
    for (let i = 0; i < 5; i++) {
      const { map, material, light } = await follow(words(`${i / 4 - .5},.3,1`))
      check(!map && !material && light.length === 16, `${map?.length} and ${material?.length} bytes more`)
    }
  }],
  ['asked for its light, a board without an accelerometer says so', async () => {
    equal(await board.during(pico.room(), 'the light'), sentences.noSensor, 'the sentence')
  }],
  ['the board shows its own coin under the page\'s light, and then follows again', async () => {
    await board.during(pico.showOwn(true), 'its own picture')
    await board.during(pico.giveLight([-0.5, 0.25, 0.75]), 'the light')
    await board.serve(() => board.pico.uart.endsWith('a computer gives the light\r\n'), 'the hand-over')
    board.pico.run(() => false, 300)
    judge.same(board.look(), judge.scene('coin', [-16384, 8192, 24576]), 'its own picture')
    await board.during(pico.showOwn(false), 'the page\'s picture')
    has = { map: '', material: '' }
    await follow(words('-.2,.3,1'))
  }],
  ['another material, model and space, then another surface, are followed', async () => {
    const other = await follow(words('.2,.4,1', ['--scene=coin', '--model=cayley', '-n9', '--space=linear', '--specular=.4,.9,1', '--clamp-peak']))
    check(!other.map && other.material, 'the map, or no material')
    check((await follow(words('.2,.4,1', ['--scene=watchface', '--color=30,90,200']))).map, 'no map')
  }],
  ['a stalled transfer is a sentence, and connecting again goes on', async () => {
    board.bridge.stalls = 1
    engine.draw(words('.5,.5,1'))
    equal(await trouble(pico.sendLight(engine.device(width, height, has).light)), sentences.stalled, 'the sentence')
    await connect()
    await follow(words('.5,.5,1'))
  }],
  ['a board that has been reset meanwhile refuses, with a reason, and connecting again goes on', async () => {
    const { material } = engine.device(width, height, { map: '', material: '' })
    check(board.host.control(0x41, 0xa1, 0, 1, Buffer.of(0)) !== null, 'disabling behind the kernel\'s back')
    const said = await trouble(pico.sendMaterial(material))
    equal(said, 'The device refused the material: it has been restarted or used by another program. Connect again.', 'the sentence')
    await connect()
    await follow(words('-.5,.5,1'))
  }],
  ['closed, the panel is the kernel\'s again', async () => {
    await board.during(pico.close(), 'closing')
    await board.serve(() => /(a computer draws|relighting)\r\n$/.test(board.pico.uart), 'the hand-over')
  }],
  ['while another program has the board that is said, and afterwards connecting goes on', async () => {
    const other = board.start_command([glint, 'stream', '--height=tests/data/rockwall-height.png', `--size=${width}x${height}`, '--fps=0', '--to=usb', '--shade=device'])
    try {
      await board.serve(() => board.pico.uart.endsWith('lights\r\n') || other.status !== undefined, 'glint stream')
      equal(other.status, undefined, `glint stream says ${other.text}`)
      equal(await trouble(connect()), sentences.held, 'the sentence')
    } finally { other.child.kill('SIGINT') }
    await board.serve(() => other.status !== undefined, 'the end of glint stream')
    check(!other.text.includes('did not give the panel back'), `glint stream says ${other.text}`)
    await connect()
    await follow(words('0,.5,1'))
  }],
  ['an unplugged board is said, and plugged in again it is followed again', async () => {
    board.unplug()
    engine.draw(words('0,-.5,1'))
    equal(await trouble(pico.sendLight(engine.device(width, height, has).light)), sentences.unplugged, 'the sentence')
    await board.plug()
    await board.serve(has_display, '/dev/fb0')
    await connect()
    await follow(words('0,-.5,1'))
    await board.during(pico.close(), 'closing')
  }],
])
