// SPDX-License-Identifier: MIT
// test_light.mjs PACKAGES FOLDER PANEL JUDGE: a map and a material once, then 16 bytes a frame; numbers are those of
// firmware/core/light_protocol.h.
import { FORMAT, Gud, picture565, shown565, STATUS } from './gud.mjs'
import { Judge } from './judge.mjs'
import { Pico } from './pico.mjs'
import { check, equal, run } from './tap.mjs'
import { UsbHost } from './usb_host.mjs'

const [packages, folder, panel, program] = process.argv.slice(2)
const judge = new Judge(program, panel)
const { width, height } = judge
const pico = new Pico(packages).load(`${folder}/glint.uf2`)
const { wires } = pico
const host = new UsbHost(pico)
const gud = new Gud(host)
const light = new Gud(host, { interface_number: 1, endpoint: 2 })
const ENABLE = 0xa1, MATERIAL = 0xa2, MAP = 0xa3
const FULL = 2 * width * height
const look = () => judge.look(wires.transcript())
const frame_done = () => wires.pixels === FULL
let frame_ms, sent_bytes

function refused(done, status, what) {
  check(!done, `${what} is not refused`)
  equal(light.status(), status, `the status after ${what}`)
}
const map = judge.map(), material = judge.material()
const lights = (from, count) => Buffer.concat(Array.from({ length: count }, (_, i) => judge.light(from + i)))

run([
  ['a second interface says that the device shades, and no GUD driver takes it for a display', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), pico.uart)
    const { configuration } = host.enumerate()
    equal(configuration[4], 2, 'interfaces')
    equal(light.get(0x01, 30), null, 'GUD\'s descriptor')
    const descriptor = light.get(0xa0, 12)
    equal(descriptor.toString('latin1', 0, 4), 'glnt', 'the magic')
    equal(descriptor.readUInt16LE(8), width, 'the width')
    equal(descriptor.readUInt16LE(10), height, 'the height')
  }],
  ['a board without an accelerometer says so', () => {
    equal(light.get(0xa6, 16).toString('hex'), '00'.repeat(16), 'its light')
  }],
  ['before it is enabled it takes nothing', () => {
    refused(light.set(MATERIAL, material), STATUS.protocol, 'a material')
    refused(light.set(MAP), STATUS.protocol, 'a map')
    refused(light.set(ENABLE, Buffer.of(2)), STATUS.parameter, 'enabling by 2')
    refused(light.set(ENABLE, Buffer.of(1, 1)), STATUS.protocol, 'a long request')
  }],
  ['enabled it has the panel, dark until there is a picture', () => {
    check(light.set(ENABLE, Buffer.of(1)), 'enabling')
    pico.run(() => false, 1)
    check(pico.uart.endsWith('a computer sends lights\r\n'), pico.uart)
    check(look().every((level) => level === 0), 'the panel shows something')
  }],
  ['a map, a material and a light make the host\'s picture, bit for bit', () => {
    check(light.set(MATERIAL, material), `the material is refused with status ${light.status()}`)
    check(light.set(MAP), 'the map is refused')
    host.bulk(2, map, 2000)
    equal(light.status(), STATUS.ok, 'the status')
    wires.pixels = 0
    host.bulk(2, judge.light(7))
    check(pico.run(frame_done, 400) && pico.run(() => wires.level('backlight') === 1, 5), `no frame: ${pico.uart}`)
    judge.same(look(), judge.lit(7), 'the picture')
  }],
  ['lights that follow make a frame each, in order; what there is no room for waits on the bus', () => {
    const COUNT = 24, before = wires.windows, ends = []
    const bytes = lights(10, COUNT)
    for (let at = 0; at < bytes.length; at += 64) host.push(2, new Uint8Array(bytes.subarray(at, at + 64)))
    for (let i = 0; i < COUNT; i++) {
      check(pico.run(() => !frame_done(), 100) && pico.run(frame_done, 100), `${i} frames of ${COUNT}`)
      ends.push(pico.cycles)
      if (i % 6 === 0 || i === COUNT - 1) judge.same(look(), judge.lit(10 + i), `frame ${i}`)
    }
    pico.run(() => false, 50)
    equal(wires.windows - before, COUNT, 'frames')
    frame_ms = (ends[COUNT - 1] - ends[COUNT - 5]) / 4 / 125e3
    sent_bytes = bytes.length / COUNT
  }],
  ['a light that cannot be leaves the picture, and the next one goes on', () => {
    const before = look()
    host.bulk(2, Buffer.alloc(16))
    pico.run(() => false, 30)
    judge.same(look(), before, 'the picture')
    host.bulk(2, judge.light(3))
    check(pico.run(() => !frame_done(), 100) && pico.run(frame_done, 100), 'no frame')
    judge.same(look(), judge.lit(3), 'the next picture')
  }],
  ['GUD hosts get busy while a light host has the panel, and nothing of theirs is drawn', () => {
    const before = look()
    check(gud.begin(FORMAT.rgb565), 'the GUD host cannot begin')
    check(!gud.buffer({ x: 0, y: 0, width: 2, height: 1, length: 4 }), 'a rectangle is not refused')
    equal(gud.status(), 1, 'its status, GUD_BUSY')
    check(gud.set(0x64, Buffer.of(0)), 'switching its display off')
    judge.same(look(), before, 'the picture')
  }],
  ['suspended it is dark, and the same picture is back when the host resumes', () => {
    const before = look()
    host.suspend()
    pico.run(() => false, 5)
    check(look().every((level) => level === 0) && wires.level('backlight') === 0, 'the panel shows something')
    host.resume()
    pico.run(() => false, 5)
    judge.same(look(), before, 'the picture')
  }],
  ['a map with an invalid normal is refused as a whole', () => {
    const wrong = Buffer.from(map)
    wrong.writeUInt32LE(0x7fff7f7f, 4 * 1234)
    check(light.set(MAP), 'the map')
    host.bulk(2, wrong, 2000)
    pico.run(() => false, 30)
    equal(light.status(), STATUS.parameter, 'the status')
    const before = wires.windows
    host.bulk(2, judge.light(1))
    pico.run(() => false, 30)
    equal(wires.windows, before, 'frames')
    equal(light.status(), STATUS.protocol, 'the status of a light without a map')
  }],
  ['a map that is replaced within a frame leaves the next one whole', () => {
    check(light.set(MAP), 'the map')
    host.bulk(2, map, 2000)
    host.bulk(2, judge.light(5))
    check(pico.run(() => wires.pixels > FULL / 3 && wires.pixels < FULL, 400), 'no frame')
    check(light.set(MAP), 'the next map')
    host.bulk(2, map, 2000)
    host.bulk(2, judge.light(6))
    check(pico.run(() => !frame_done(), 400) && pico.run(frame_done, 400), 'no frame after it')
    judge.same(look(), judge.lit(6), 'the picture')
  }],
  ['another material changes the picture with the same map', () => {
    const other = Buffer.from(material)
    other.writeUInt8(40, 8) // the albedo's red
    check(light.set(MAP), 'the map')
    host.bulk(2, map, 2000)
    check(light.set(MATERIAL, other), 'the material')
    host.bulk(2, judge.light(3))
    check(pico.run(() => !frame_done(), 400) && pico.run(frame_done, 400), 'no frame')
    check(!look().equals(judge.lit(3)), 'the picture is the old one')
  }],
  ['disabled it gives the panel to the GUD host that waits', () => {
    check(light.set(ENABLE, Buffer.of(0)), 'disabling')
    pico.run(() => false, 2)
    check(pico.uart.endsWith('a computer draws\r\n'), pico.uart)
    check(look().every((level) => level === 0), 'its display is off, but something is shown')
    check(gud.set(0x64, Buffer.of(1)), 'switching its display on')
    const bytes = picture565(width, height, 3)
    check(gud.draw({ x: 0, y: 0, width, height }, bytes, judge.lz4(bytes)), `refused with status ${gud.status()}`)
    pico.run(() => false, 1)
    judge.same(look(), shown565(bytes), 'its frame')
  }],
  ['it is not enabled while a GUD rectangle is open, whose memory the map would take', () => {
    check(gud.buffer({ x: 0, y: 0, width: 4, height: 4, length: 32 }), 'the rectangle')
    refused(light.set(ENABLE, Buffer.of(1)), 1, 'enabling')
    host.bulk(1, Buffer.alloc(32))
    check(light.set(ENABLE, Buffer.of(1)), 'enabling, after the rectangle')
  }],
  ['a bus reset gives the panel back to the demo', () => {
    host.reset()
    wires.pixels = 0
    check(pico.run(() => pico.uart.endsWith('relighting\r\n'), 300), pico.uart)
    check(pico.run(frame_done, 100) && pico.run(() => wires.level('backlight') === 1, 5), 'no frame')
  }],
  ['the tables of the slowest model are filled long before the watchdog minds', () => {
    const slow = Buffer.from(material)
    slow.writeUInt8(4, 0) // gauss
    slow.writeUInt8(16, 1)
    slow.writeUInt16LE(1000, 2)
    slow.writeUInt8(1, 4) // linear
    host.enumerate()
    check(light.set(ENABLE, Buffer.of(1)) && light.set(MATERIAL, slow) && light.set(MAP), `refused with status ${light.status()}`)
    host.bulk(2, map, 2000)
    const from = pico.cycles
    host.bulk(2, judge.light(0))
    wires.pixels = 0
    check(pico.run(frame_done, 1000), 'no frame')
    const ms = (pico.cycles - from) / 125e3
    check(ms < 400, `it takes ${ms.toFixed(0)} ms, of the watchdog's 1000`)
  }],
  ['a bus reset at any moment leaves a board that enumerates and draws', () => {
    const begin = () => check(light.set(ENABLE, Buffer.of(1)) && light.set(MATERIAL, material) && light.set(MAP), 'no light')
    const pixels = picture565(width, height, 60), block = judge.lz4(pixels)
    const moments = [
      () => light.set(ENABLE, Buffer.of(1)),
      () => { begin(); host.bulk(2, map.subarray(0, 1000)) },
      () => { begin(); host.bulk(2, map.subarray(0, map.length - 1)) },
      () => { begin(); host.bulk(2, map, 2000) },
      () => { begin(); host.bulk(2, map, 2000); host.push(2, new Uint8Array(lights(0, 1))); pico.run(() => false, 1) }, // it fills tables
      () => { begin(); host.bulk(2, map, 2000); host.bulk(2, lights(0, 4)); pico.run(() => false, 120) }, // within a frame
      () => { begin(); host.bulk(2, map, 2000); host.bulk(2, lights(0, 1).subarray(0, 7)) },
      () => { gud.begin(FORMAT.rgb565); gud.buffer({ x: 0, y: 0, width, height, length: FULL, compressed: block.length }); host.bulk(1, block.subarray(0, 5000)) },
    ]
    for (const [i, moment] of moments.entries()) {
      host.reset()
      host.enumerate()
      moment()
      host.reset()
      host.enumerate()
      check(gud.begin(FORMAT.rgb565) && gud.draw({ x: 0, y: 0, width, height }, pixels, block), `moment ${i}: refused with status ${gud.status()}`)
      pico.run(() => false, 1)
      judge.same(look(), shown565(pixels), `moment ${i}`)
    }
  }],
  ['whatever happened, D/C never changed while a byte was sent', () => {
    equal(wires.faults.length, 0, `faults, the first: ${wires.faults[0]}`)
  }],
], () => console.log(`# ${panel}: a frame every ${frame_ms?.toFixed(2)} ms, ${(1000 / frame_ms).toFixed(1)} a second, of ${sent_bytes} ` +
  'bytes by USB each (emulated, with SPI time modelled; the map is in RAM)'))
