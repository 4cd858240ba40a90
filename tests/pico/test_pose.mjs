// SPDX-License-Identifier: MIT
// test_pose.mjs PACKAGES FOLDER PANEL JUDGE GLINT [MESH], run by attach under the lab's kernel: glint stream, by libusb, turns the mesh that
// lies in the board, that of DEMO=teapot or the file of MESH=MESH SPLIT=180, by 28 bytes a frame.
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { Judge } from './judge.mjs'
import { Plugged } from './plugged.mjs'
import { check, equal, run } from './tap.mjs'

const [packages, folder, panel, program, glint, mesh] = process.argv.slice(2)
const judge = new Judge(program, panel)
const { width, height } = judge
const board = new Plugged(packages, folder, judge, () => {}).attached()
const { pico } = board
const frames = [] // how long the transcript is at the end of every whole frame of a host's
let was_whole = false
const plain_sent = pico.wires.sent.bind(pico.wires)
pico.wires.sent = (spi) => {
  plain_sent(spi)
  const is_whole = pico.wires.pixels === 2 * width * height
  if (is_whole && !was_whole && /lights\r\n$/.test(pico.uart)) frames.push(pico.wires.length)
  was_whole = is_whole
}
// The first frame of an owner is complete before the display is switched on.
const lit = (transcript) => Buffer.concat([transcript, Buffer.from('C\x29B\x01', 'latin1')])
const FRAMES = 5
const files = `${process.env.TMPDIR ?? '/tmp'}/pose-%d.ppm`

await run([
  [`glint stream ${mesh ? '--mesh FILE' : 'teapot'} --shade device sends 28 bytes a frame, and the panel shows what glint draws, bit for bit`, async () => {
    await board.serve(() => existsSync('/dev/fb0'), 'the kernel\'s driver')
    const scene = ['stream', mesh ? `--mesh=${mesh}` : 'teapot', '--fps=60', `--frames=${FRAMES}`, '--period=1']
    await board.command([glint, ...scene, '--split=180', `--size=${width}x${height}`, '--format=rgb565', '--path=colour-int8', '--no-outlines', '--to=ppm', '-o', files])
    const text = await board.command([glint, ...scene, '--to=usb', '--shade=device', '--json'])
    equal(frames.length, FRAMES, `frames on the panel; glint says ${text}`)
    frames.forEach((length, i) => {
      const file = readFileSync(files.replace('%d', i))
      judge.same(judge.look(lit(pico.wires.transcript().subarray(0, length))), file.subarray(file.length - 3 * width * height), `frame ${i}`)
    })
    equal(JSON.parse(text.slice(text.indexOf('{'))).frame_bytes.mean, 28, 'bytes a frame')
  }],
  ['a mesh that the board does not hold, and a map, which it does not take, are refused in one line', async () => {
    const other = `${process.env.TMPDIR ?? '/tmp'}/other.obj`
    writeFileSync(other, 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n')
    const text = await board.command([glint, 'stream', `--mesh=${other}`, '--to=usb', '--shade=device', '--frames=1'], 1)
    check((mesh ? /holds another mesh, of 1878 vertices and 3674 triangles; / : /holds another mesh, of 530 vertices and 992 triangles; /).test(text) &&
      / build the board's firmware with MESH=\/.*other.obj$/m.test(text), text)
    // What a board cannot draw: two materials, colours of vertices, textures.
    const scratch = process.env.TMPDIR ?? '/tmp'
    writeFileSync(`${scratch}/two.mtl`, 'newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n')
    writeFileSync(`${scratch}/two.obj`, 'mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 3 2\nf 1 2 4\nusemtl blue\nf 2 3 4\nf 3 1 4\n')
    writeFileSync(`${scratch}/coloured.obj`, 'v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 0 0 1 1 1 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n')
    for (const [file, words] of [['two', 'in one material, and this one has 2; leave it out'],
      ['coloured', "in one colour, and this one has its vertices'; leave it out, or give one by --color"]]) {
      const said = await board.command([glint, 'stream', `--mesh=${scratch}/${file}.obj`, '--to=usb', '--shade=device', '--frames=1'], 1)
      check(said.trimEnd().endsWith(words), said)
    }
    const textured = await board.command([glint, 'stream', 'teapot', '--texture=tests/data/rockwall-albedo.png', '--to=usb', '--shade=device', '--frames=1'], 1)
    check(textured.trimEnd().endsWith('this one has textures; leave it out, or give --no-textures'), textured)
    const map = await board.command([glint, 'stream', '--height=tests/data/rockwall-height.png', '--to=usb', '--shade=device', '--frames=1'], 1)
    check(/^glint: .*the scene: it refuses/m.test(map), map)
  }],
])
