// SPDX-License-Identifier: MIT
// test_te.mjs PACKAGES FOLDER PANEL JUDGE PIN ADDRESS: the demo of an image that was built for a panel's tearing line (TE) on PIN,
// with a panel that scans: 320 rows and 24 of blanking, 60 times a second; and for browsers to offer ADDRESS.
import { examineOffer, faultsInOffer, landingPageOf } from './descriptors.mjs'
import { Judge } from './judge.mjs'
import { Pico } from './pico.mjs'
import { check, equal, run } from './tap.mjs'
import { UsbHost } from './usb_host.mjs'

const [packages, folder, panel, program, pin, address] = process.argv.slice(2)
const judge = new Judge(program, panel)
const { width, height } = judge
const pico = new Pico(packages).load(`${folder}/glint.uf2`)
const { wires, chip } = pico
const { clock } = chip
const SCAN_NS = 1e9 / 60, ROW_NS = SCAN_NS / 344, BLANK_NS = 24 * ROW_NS

// The line is driven from the command on, high in the blanking; as long as it is wired.
const scan = { wired: true, scans: [], edges: [], mode: undefined }
const blanking = clock.createAlarm(() => { scan.blank = true; drive() })
const scanning = clock.createAlarm(() => { scan.blank = false; drive() })
function drive() {
  if (scan.wired) { chip.gpio[pin].setInputValue(scan.blank); if (!scan.blank) scan.edges.push(clock.nanos) }
  if (scan.blank) { scanning.schedule(BLANK_NS); return }
  scan.scans.push(clock.nanos)
  blanking.schedule(SCAN_NS - BLANK_NS)
}

// When each line of each frame was written, first and last byte; what a command had as data.
const frames = []
const plain = wires.sent.bind(wires)
wires.sent = (spi) => {
  const { value, bits, dc } = wires.frame, before = wires.pixels
  plain(spi)
  if (wires.command === 0x35 && dc) { scan.mode = value; scan.blank = true; drive() }
  if (wires.pixels === bits / 8) frames.push({ begins: [], ends: [] })
  if (!wires.pixels) return
  const frame = frames[frames.length - 1], line = Math.floor(before / 2 / width)
  if (before % (2 * width) === 0) frame.begins[line] = clock.nanos
  if (wires.pixels % (2 * width) === 0) frame.ends[line] = clock.nanos
}
const frame_done = () => wires.pixels === 2 * width * height
function draw(count) {
  for (let i = 0; i < count; i++) {
    check(pico.run(() => !frame_done(), 100) && pico.run(frame_done, 100), `${i} frames of ${count}: ${pico.uart}`)
    const at = frames.length - 1
    if (i === 1 || i === count - 1) judge.same(judge.look(wires.transcript()), judge.lit(at), `frame ${at}`)
  }
}
// How many of the scans since `from` showed lines of more than one frame.
function torn(from) {
  const shown = (line, ns) => {
    let i = frames.length - 1
    while (i >= 0 && !(frames[i].begins[line] < ns + ROW_NS)) i--
    return i >= 0 && frames[i].ends[line] < ns ? i : -1 - i // half a line
  }
  const whole = scan.scans.filter((at) => at >= from && at + SCAN_NS < clock.nanos)
  check(whole.length > 5, `${whole.length} scans`)
  return whole.filter((at) => {
    const seen = new Set()
    for (let line = 0; line < height; line++) seen.add(shown(line, at + line * ROW_NS))
    return seen.size > 1
  }).length
}

let rate
run([
  ['the board says that it waits for TE, and tells the panel to drive it', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), pico.uart)
    check(pico.uart.includes('in step with TE'), pico.uart)
    equal(scan.mode, 0, 'the mode of TE')
  }],
  ['each frame begins where the scan does, and is the host\'s', () => {
    draw(10)
    for (const [i, { begins }] of frames.entries()) {
      const late = begins[0] - Math.max(...scan.edges.filter((at) => at <= begins[0]))
      check(late < 1e6, `frame ${i} begins ${late / 1e3} us after an edge`)
    }
    rate = 9e9 / (frames[9].begins[0] - frames[0].begins[0])
    check(Math.abs(rate - 60) < 0.1, `${rate} frames a second`)
  }],
  ['no scan shows lines of two frames', () => {
    equal(torn(frames[1].begins[0]), 0, 'scans that are torn')
  }],
  ['frames go on with a dead line, which is reported once, and then they tear', () => {
    scan.wired = false
    const from = clock.nanos
    const count = 100 // so that frames of nearly a scan's time meet it everywhere
    draw(count)
    equal(pico.uart.split('TE is dead').length, 2, `times that it is said, and one: ${pico.uart}`)
    check(clock.nanos - from < count * 1e9 / 60 + 60e6, `${count} frames in ${(clock.nanos - from) / 1e6} ms`)
    check(torn(from + 60e6) > 0, 'nothing is torn: this test would not notice')
  }],
  ['when it is back, frames are in step again', () => {
    scan.wired = true
    draw(3)
    const from = clock.nanos
    draw(8)
    check(pico.uart.includes('TE is back'), pico.uart)
    equal(torn(from), 0, 'scans that are torn')
  }],
  ['browsers are told the address that was built in, for its own number only', () => {
    const host = new UsbHost(pico)
    host.pulled_up = true
    host.enumerate()
    examineOffer(host, address)
    equal(landingPageOf(host, 1, 2), null, 'the address of a second page')
    equal(faultsInOffer(host, address).unseen.join(', '), '', 'faults in the descriptors, with the address, that are not found')
  }],
  ['whatever happened, D/C never changed while a byte was sent', () => {
    equal(wires.faults.length, 0, `faults, the first: ${wires.faults[0]}`)
  }],
], () => console.log(`# ${panel}: ${rate?.toFixed(1)} frames a second in step with TE (emulated, by a model of the panel's scan)`))
