// SPDX-License-Identifier: MIT
// test_usb.mjs PACKAGES FOLDER PANEL JUDGE: the image as a GUD display on an emulated USB.
import { bosOf, examineOffer, faultsInOffer } from './descriptors.mjs'
import { FORMAT, Gud, picture565, shown565, STATUS } from './gud.mjs'
import { Judge } from './judge.mjs'
import { Pico } from './pico.mjs'
import { check, equal, run } from './tap.mjs'
import { UsbHost } from './usb_host.mjs'

const [packages, folder, panel, program] = process.argv.slice(2)
const judge = new Judge(program, panel)
const { width, height } = judge
const pico = new Pico(packages).load(`${folder}/glint.uf2`)
const host = new UsbHost(pico)
const gud = new Gud(host)
const settle = () => pico.run(() => false, 1)
const look = () => { settle(); return judge.look(pico.wires.transcript()) }
const whole = { x: 0, y: 0, width, height }
let screen // what should be seen

// A rectangle's pixels into what should be seen.
function paint({ x, y, width: w, height: h }, rgb) {
  for (let line = 0; line < h; line++) rgb.copy(screen, 3 * ((y + line) * width + x), 3 * line * w, 3 * (line + 1) * w)
}
function draws(rectangle, bytes, block, what) {
  check(gud.draw(rectangle, bytes, block), `${what} is refused with status ${gud.status()}`)
  paint(rectangle, shown565(bytes))
  judge.same(look(), screen, what)
}
function refused(done, status, what) {
  check(!done, `${what} is not refused`)
  equal(gud.status(), status, `the status after ${what}`)
}

let frame_ms
run([
  ['it enumerates as what the kernel\'s GUD driver looks for, with a name and a serial number', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), pico.uart)
    const { device, configuration, texts } = host.enumerate()
    equal(device.readUInt32LE(8), 0x614d1d50, 'vendor and product')
    equal(configuration[14], 0xff, 'the interface\'s class')
    equal(configuration[13], 1, 'its endpoints')
    equal(configuration[20], 1, 'the endpoint, OUT')
    equal(configuration[21], 2, 'its type, bulk')
    check(texts[0] === 'glint' && texts[1].includes(`${width}x${height}`) && texts[2].length === 16, texts.join(', '))
  }],
  ['BOS lets browsers in where there is an interface for light, and Windows has WinUSB for that one alone', () => {
    const { device, configuration } = host.enumerate(), interfaces = configuration[4], bos = bosOf(host)
    equal(device.readUInt16LE(2), interfaces === 2 ? 0x0210 : 0x0200, 'bcdUSB')
    equal(device.readUInt16LE(12) & 15, 1, 'the descriptors\' count in bcdDevice')
    equal(device.readUIntBE(4, 3), 0, 'the device\'s class, which makes it a composite one')
    equal(bos === null, interfaces === 1, 'no BOS')
    if (!bos) return
    examineOffer(host)
  }],
  ['a wrong length, GUID, vendor code or any other wrong bit in those descriptors is found', () => {
    if (!bosOf(host)) return
    const { count, unseen } = faultsInOffer(host)
    check(count > 1000, `${count} faults`)
    equal(unseen.join(', '), '', `of ${count} faults not found`)
  }],
  ['requests are told apart by their recipient first', () => {
    const bos = bosOf(host), code = bos?.microsoft.vendorCode ?? 2
    equal(gud.status(), STATUS.ok, 'the status before')
    equal(host.control(0xc0, 0x01, 0, 0, 30), null, 'GUD\'s descriptor, asked of the device')
    equal(host.control(0xc0, code, 0, 8, 255), null, 'another index')
    equal(host.control(0xc0, code, 1, 7, 255), null, 'another value')
    equal(host.control(0x40, code, 0, 7, Buffer.alloc(4)), null, 'a write')
    equal(host.control(0xc2, code, 0, 7, 255), null, 'the set, asked of an endpoint')
    equal(gud.status(), STATUS.ok, 'the status of the display, which none of these concerned')
    equal(host.control(0xc1, code, 0, 7, 255), null, 'the set, asked of an interface')
  }],
  ['the demo goes on until a host enables the controller', () => {
    check(pico.run(() => pico.wires.level('backlight') === 1, 100), 'the backlight stays off')
    check(look().some((level) => level > 0), 'the panel is dark')
    check(!pico.uart.includes('computer'), pico.uart)
  }],
  ['it tells its size, formats, connector and mode', () => {
    const descriptor = gud.get(0x01, 30)
    equal(descriptor.readUInt32LE(0), 0x1d50614d, 'magic')
    equal(descriptor.readUInt32LE(10), 2 * width * height, 'max_buffer')
    equal(descriptor.readUInt32LE(14), width, 'width')
    equal(descriptor.readUInt32LE(26), height, 'height')
    equal(gud.get(0x40, 32).toString('hex'), '4001', 'formats')
    equal(gud.get(0x50, 32).length, 5, 'bytes of connectors')
    equal(gud.get(0x54, 1)[0], 1, 'connector status')
    equal(gud.get(0x55, 24).readUInt16LE(4), width, 'hdisplay')
  }],
  ['enabling the controller stops the demo, and the panel is dark until the display is enabled', () => {
    check(gud.set(0x63, Buffer.of(1)), 'SET_CONTROLLER_ENABLE')
    settle()
    check(pico.uart.endsWith('a computer draws\r\n'), pico.uart)
    check(look().every((level) => level === 0), 'the panel shows something')
    check(gud.state(FORMAT.rgb565), 'the state')
    check(gud.set(0x64, Buffer.of(1)), 'SET_DISPLAY_ENABLE')
    check(look().some((level) => level > 0), 'the panel stays dark')
    screen = look()
  }],
  ['a raw frame arrives bit for bit', () => {
    const from = pico.cycles
    draws(whole, picture565(width, height, 1), undefined, 'the frame')
    frame_ms = (pico.cycles - from) / 125e3 - 1
  }],
  ['an LZ4 frame arrives bit for bit', () => {
    const bytes = picture565(width, height, 2), block = judge.lz4(bytes)
    check(block.length < bytes.length * .8, `${block.length} bytes are hardly compressed`)
    draws(whole, bytes, block, 'the frame')
  }],
  ['rectangles at odd places arrive, raw and LZ4, and nothing beside them changes', () => {
    for (const [i, [x, y, w, h]] of [[1, 3, 1, 1], [width - 7, 5, 7, 33], [13, height - 1, 101, 1], [0, 17, 33, 5]].entries()) {
      const rectangle = { x, y, width: w, height: h }, bytes = picture565(w, h, 10 + i)
      draws(rectangle, bytes, undefined, `raw ${w}x${h}`)
      const others = picture565(w, h, 20 + i)
      draws(rectangle, others, judge.lz4(others), `LZ4 ${w}x${h}`)
    }
  }],
  ['R1 arrives, most significant bit first', () => {
    check(gud.state(FORMAT.r1), 'the state')
    const rectangle = { x: 8, y: 2, width: 19, height: 4 }
    const bits = Buffer.from('a5f060123440ffff20800020', 'hex')
    check(gud.draw(rectangle, bits), `refused with status ${gud.status()}`)
    const rgb = Buffer.alloc(3 * 19 * 4)
    for (let i = 0; i < 19 * 4; i++) {
      const x = i % 19, line = 3 * Math.floor(i / 19)
      if (bits[line + (x >> 3)] >> (7 - x % 8) & 1) rgb.fill(255, 3 * i, 3 * i + 3)
    }
    paint(rectangle, rgb)
    judge.same(look(), screen, 'the bits')
    check(gud.state(FORMAT.rgb565), 'the state, back')
  }],
  ['wrong requests get a STALL and the right status, and nothing is drawn', () => {
    const { unsupported, protocol, parameter } = STATUS
    refused(gud.get(0x7f, 1) !== null, unsupported, 'an unknown question')
    refused(gud.set(0x7f), unsupported, 'an unknown order')
    refused(gud.set(0x60, Buffer.alloc(24)), protocol, 'a short rectangle')
    refused(gud.set(0x60, Buffer.alloc(64)), protocol, 'a long rectangle')
    refused(gud.set(0x60, Buffer.alloc(3000)), protocol, 'a rectangle of 3000 bytes')
    refused(gud.buffer({ ...whole, x: 1, length: 2 * width * height }), parameter, 'a rectangle that sticks out')
    refused(gud.buffer({ x: 0, y: 0, width: 0, height: 1, length: 0 }), parameter, 'an empty rectangle')
    refused(gud.buffer({ x: 0xffffffff, y: 0, width: 2, height: 1, length: 4 }), parameter, 'a place that wraps')
    refused(gud.buffer({ x: 0, y: 0, width: 2, height: 1, length: 3 }), parameter, 'a length that is not the rectangle\'s')
    refused(gud.buffer({ x: 0, y: 0, width: 2, height: 1, length: 4, compressed: 100 }), parameter, 'a block longer than can be')
    refused(gud.state(0x50), parameter, 'a format that is not offered')
    refused(gud.set(0x63, Buffer.of(7)), parameter, 'a controller enabled by 7')
    refused(gud.get(0x54, 1, 1) !== null, parameter, 'a second connector')
    equal(host.control(0xc1, 0x01, 0, 5, 30), null, 'a request to another interface')
    judge.same(look(), screen, 'the panel')
    check(gud.state(FORMAT.rgb565), 'the state, again')
  }],
  ['bytes that no rectangle expects are dropped, and a rectangle that was cut short does not spoil the next', () => {
    host.bulk(1, Buffer.alloc(1000, 0xee))
    judge.same(look(), screen, 'the panel after bytes without a rectangle')
    const cut = { x: 4, y: 4, width: 50, height: 50 }, bytes = picture565(50, 50, 30)
    check(gud.buffer({ ...cut, length: bytes.length }), 'the rectangle')
    host.bulk(1, bytes.subarray(0, 20 * 100 + 30))
    paint({ ...cut, height: 20 }, shown565(bytes.subarray(0, 20 * 100)))
    judge.same(look(), screen, 'the lines that arrived')
    draws({ x: 30, y: 40, width: 9, height: 9 }, picture565(9, 9, 31), undefined, 'the next rectangle')
  }],
  ['a host that ends a halt, or what is none, goes on with the next packet', () => {
    for (const [i, packets] of [3, 2, 1, 4].entries()) {
      check(host.clear_halt(1), 'ending no halt is refused')
      draws({ x: 10 + i, y: 10, width: 32, height: packets }, picture565(32, packets, 60 + i), undefined, `${packets} packets without a halt`)
    }
    check(host.halt(1) && host.is_halted(1), 'it is not halted')
    pico.run(() => false, 5)
    check(!host.armed.has(1) && host.is_halted(1), 'it takes packets')
    check(host.clear_halt(1) && !host.is_halted(1), 'the halt is not ended')
    draws({ x: 5, y: 20, width: 60, height: 30 }, picture565(60, 30, 64), undefined, 'the rectangle after a halt')
  }],
  ['a host that chooses the interface\'s setting once more goes on with the next packet', () => {
    for (const [i, packets] of [3, 2, 1].entries()) {
      check(host.set_interface(0, 1), 'SET_INTERFACE is refused')
      draws({ x: 10 + i, y: 50, width: 32, height: packets }, picture565(32, packets, 70 + i), undefined, `${packets} packets`)
    }
  }],
  ['a wrong LZ4 block is reported by the status and stays within its rectangle', () => {
    const rectangle = { x: 60, y: 60, width: 20, height: 20 }
    check(gud.buffer({ ...rectangle, length: 800, compressed: 40 }), 'the rectangle')
    host.bulk(1, Buffer.alloc(40, 0x0f)) // a match from before the beginning
    check(gud.status() !== STATUS.ok, 'the status is good')
    judge.same(look(), screen, 'the panel')
    draws(rectangle, picture565(20, 20, 40), undefined, 'the same rectangle, right')
  }],
  ['the backlight is as bright as the host sets it: its square, never dark, 100 on all the time', () => {
    equal(gud.get(0x51, 320).toString('hex'), '0c006400000000000000', 'the property, at first')
    for (const [percent, shines] of [[30, 9], [0, 1], [1, 1], [100, 100], [55, 30]]) {
      check(gud.state(FORMAT.rgb565, percent), `${percent} percent are refused with status ${gud.status()}`)
      equal(gud.brightness(), percent, 'the property')
      const found = pico.brightness()
      check(shines === 100 ? found === 100 : Math.abs(found - shines) < 0.5, `it shines ${found} % of the time, not ${shines}`)
      judge.same(look(), screen, `the picture at ${percent} percent`)
    }
    refused(gud.state(FORMAT.rgb565, 101), STATUS.parameter, '101 percent')
    check(gud.state(FORMAT.rgb565), 'the state, without a brightness')
    equal(gud.brightness(), 55, 'the property, which nobody has set')
  }],
  ['suspended it is dark, and picture and brightness are back when the host resumes', () => {
    host.suspend()
    check(look().every((level) => level === 0), 'the panel shows something')
    equal(pico.brightness(), 0, 'percent of the time that it shines')
    host.resume()
    judge.same(look(), screen, 'the panel')
    check(Math.abs(pico.brightness() - 30) < 0.5, 'the brightness is another one')
  }],
  ['a bus reset within a rectangle gives the panel back to the demo', () => {
    check(gud.buffer({ ...whole, length: 2 * width * height }), 'the rectangle')
    host.bulk(1, Buffer.alloc(7777, 0x55))
    pico.wires.pixels = 0
    host.reset()
    check(pico.run(() => pico.wires.pixels === 2 * width * height, 200), `no whole frame: ${pico.uart}`)
    check(pico.uart.endsWith('relighting\r\n'), pico.uart)
    settle()
    equal(pico.brightness(), 100, 'its brightness')
  }],
  ['after that it enumerates and draws again', () => {
    host.enumerate()
    check(gud.begin(FORMAT.rgb565), `refused with status ${gud.status()}`)
    equal(gud.brightness(), 100, 'the brightness')
    screen = look()
    draws(whole, picture565(width, height, 50), undefined, 'the frame')
  }],
  ['a host that sets the same configuration once more begins anew, with the first packet', () => {
    for (const [i, packets] of [3, 2, 1].entries()) {
      check(gud.buffer({ ...whole, length: 2 * width * height }), 'the rectangle')
      host.bulk(1, Buffer.alloc(64 * packets, 0x55))
      check(host.configure(1), 'SET_CONFIGURATION is refused')
      check(pico.run(() => pico.uart.endsWith('relighting\r\n'), 200), pico.uart)
      check(gud.begin(FORMAT.rgb565), `refused with status ${gud.status()}`)
      screen = look()
      draws({ x: 10 + i, y: 80, width: 32, height: packets }, picture565(32, packets, 80 + i), undefined, `${packets} packets`)
    }
  }],
  ['whatever happened, D/C never changed while a byte was sent', () => {
    equal(pico.wires.faults.length, 0, `faults, the first: ${pico.wires.faults[0]}`)
  }],
], () => console.log(`# ${panel}: a raw frame by USB in ${frame_ms?.toFixed(1)} ms, ${(1000 / frame_ms).toFixed(1)} a second ` +
  '(emulated, at 19 packets a millisecond)'))
