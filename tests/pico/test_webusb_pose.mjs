// SPDX-License-Identifier: MIT
// test_webusb_pose.mjs PACKAGES FOLDER PANEL JUDGE PAGE, run under the lab's kernel: the page's own transport and module turn the mesh that
// lies in the emulated board (DEMO=teapot), by WebUSB.
import { existsSync, readFileSync } from 'node:fs'
import { resolve } from 'node:path'
import { Judge } from './judge.mjs'
import { Plugged } from './plugged.mjs'
import { HANGS, check, equal, run } from './tap.mjs'
import { asRgb, conforming, webUsb } from './web_usb.mjs'

const [packages, folder, panel, program, page] = process.argv.slice(2)
const { Engine, filters, meshOnDevice, Pico, stateOfWords, wordsOf } = await import(resolve(page, 'engine.mjs'))
const engine = new Engine(new WebAssembly.Module(readFileSync(`${page}/module.wasm`)))
const judge = new Judge(program, panel)
const { width, height } = judge
const board = new Plugged(packages, folder, judge)
const usb = webUsb(packages)

let pico, split, has
async function connect() {
  const device = await board.during(usb.requestDevice({ filters }), 'requestDevice')
  pico = await board.during(Pico.connect(usb, conforming(device), (bytes) => engine.deviceSize(bytes), 1000 * HANGS), 'connecting')
  split = pico.mesh ? engine.deviceMesh(pico.mesh, ['--scene=teapot']) : 0
  has = { map: '', material: '' }
}
// Draws in the module, sends what changed, and compares the panel with the module's picture. Returns what was sent.
async function follow(...more) {
  const list = wordsOf(meshOnDevice(stateOfWords(['--scene=teapot', ...more]), width, height, split))
  const { rgba } = engine.draw(list), scene = engine.device(width, height, has)
  check(!scene.map && !scene.light, 'a map or a light')
  if (scene.material) await board.during(pico.sendMaterial(scene.material), 'the material')
  if (scene.mesh) await board.during(pico.useMesh(), 'the mesh')
  await board.during(pico.sendPose(scene.pose), 'the pose')
  has = scene.has
  judge.same(board.look(), asRgb(rgba), list.join(' '))
  return scene
}

await run([
  ['the board says that it holds the page\'s teapot, and takes no maps', async () => {
    await board.plug()
    await board.serve(() => existsSync('/dev/fb0'), '/dev/fb0')
    await connect()
    equal(`${pico.width}x${pico.height}`, `${width}x${height}`, 'its size')
    equal(split, 180, 'at how many degrees its edges are split')
    equal(pico.takesMaps, false, 'takes maps')
  }],
  ['the panel shows the page\'s picture of the teapot, bit for bit', async () => {
    const { mesh, material } = await follow('--light=-1,1,1.2')
    check(mesh && material.length === 48, 'the mesh or the material is missing')
  }],
  ['a teapot that turns, and a light that moves, is 28 bytes, and each frame is the page\'s', async () => {
    for (const stands of [['--turn=25,-20,0'], ['--turn=-70,140,10', '--zoom=1.5'], ['--turn=10,20,30', '--light=.3,-.2,1'], ['--light=1,0,.1']]) {
      const { mesh, material, pose } = await follow(...stands.some((word) => word.startsWith('--light')) ? [] : ['--light=-1,1,1.2'], ...stands)
      check(!mesh && !material && pose.length === 28, `${stands}: the mesh ${mesh} and ${material?.length} bytes more`)
    }
  }],
  ['another material, model, colour and space are followed', async () => {
    const { material } = await follow('--model=cayley', '-n9', '--space=linear', '--color=30,90,200', '--specular=.4,.9,1', '--clamp-peak', '--turn=5,6,7')
    check(material, 'no material')
  }],
  ['closed and connected again, it goes on', async () => {
    await board.during(pico.close(), 'closing')
    await connect()
    const { mesh } = await follow('--turn=9,8,7')
    check(mesh, 'no mesh')
    await board.during(pico.close(), 'closing')
  }],
])
