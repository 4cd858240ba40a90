// SPDX-License-Identifier: MIT
// A USB host on the emulated controller: resets, control transfers, bulk OUT, at full speed's pace. Packets of bulk endpoints are
// numbered 0 and 1 in turn, from 0 after a reset or a halt: a device that waits for the other one takes it for the last one again.
import { check, equal } from './tap.mjs'

const PACKET_US = 1000 / 19 // 19 packets of 64 bytes a millisecond: the most that full speed carries
const STALL = 1 << 11, AVAILABLE = 1 << 10, DATA1 = 1 << 13, EP0_IN = 0x80, EP0_OUT = 0x84, OUT_END = 0x100

export class UsbHost {
  constructor(pico) {
    this.pico = pico
    this.usb = pico.chip.usbCtrl
    this.armed = new Map() // OUT endpoints that wait for a packet
    this.queues = new Map() // what is to be sent to them
    this.wanted = new Map() // the numbers that bulk endpoints wait for
    this.next = new Map() // and those that they get
    this.pulled_up = false
    const { usb } = this
    usb.onUSBEnabled = () => { this.pulled_up = true }
    usb.onResetReceived = () => { this.was_reset = true }
    usb.onEndpointRead = (endpoint, length) => { this.armed.set(endpoint, length); this.feed(endpoint) }
    usb.onEndpointWrite = (endpoint, bytes) => { if (endpoint === 0) this.control_in(bytes) }
    const plain = usb.DPRAMUpdated.bind(usb)
    usb.DPRAMUpdated = (offset, value) => {
      if ((offset === EP0_IN || offset === EP0_OUT) && value & STALL && this.transfer) this.transfer.stalled = true
      if (offset > EP0_OUT && offset < OUT_END && offset % 8 === 4) this.told((offset - EP0_OUT) / 8, value)
      plain(offset, value)
    }
  }
  // Of a bulk endpoint, before the emulator knows, which forgets at once that a buffer is available.
  told(endpoint, value) {
    if (value & STALL) this.armed.delete(endpoint)
    if (!(value & AVAILABLE)) return
    check(!this.armed.has(endpoint), `endpoint ${endpoint} waits for a packet twice`)
    this.wanted.set(endpoint, value & DATA1 ? 1 : 0)
  }
  feed(endpoint) {
    const queue = this.queues.get(endpoint)
    if (!this.armed.has(endpoint) || !queue?.length) return
    const packet = queue.shift()
    check(packet.length <= this.armed.get(endpoint), `endpoint ${endpoint} waits for ${this.armed.get(endpoint)} bytes, not ${packet.length}`)
    this.armed.delete(endpoint)
    if (endpoint) {
      const number = this.next.get(endpoint) ?? 0
      equal(this.wanted.get(endpoint), number, `endpoint ${endpoint}: the packet's number`)
      this.next.set(endpoint, 1 - number)
    }
    this.usb.endpointReadDone(endpoint, packet, endpoint ? PACKET_US : undefined)
  }
  push(endpoint, packet) {
    if (!this.queues.has(endpoint)) this.queues.set(endpoint, [])
    this.queues.get(endpoint).push(packet)
    this.feed(endpoint)
  }
  control_in(bytes) {
    const t = this.transfer
    if (!t) return
    if (t.out) { t.done = true; return } // the status
    t.data = Buffer.concat([t.data, bytes])
    if (bytes.length < 64 || t.data.length >= t.length) {
      t.got = true
      this.push(0, new Uint8Array(0)) // the status
      this.status_pushed = true
    }
  }
  reset() {
    this.armed.clear()
    this.queues.clear()
    this.next.clear()
    this.was_reset = false
    this.usb.resetDevice()
    check(this.pico.run(() => this.was_reset, 100), 'the bus reset is not taken')
    this.pico.run(() => false, 1)
  }
  // A control transfer; data to send, or how many bytes to get. null: STALL.
  control(type, request, value, index, data) {
    const out = !(type & 0x80)
    if (type === 0x02 && request === 1) this.next.delete(index) // the end of a halt
    const length = out ? data?.length ?? 0 : data
    const setup = Buffer.alloc(8)
    setup.writeUInt8(type, 0); setup.writeUInt8(request, 1); setup.writeUInt16LE(value, 2); setup.writeUInt16LE(index, 4)
    setup.writeUInt16LE(length, 6)
    this.armed.delete(0)
    this.queues.set(0, [])
    const t = this.transfer = { out, length, data: Buffer.alloc(0), stalled: false, done: false }
    this.usb.sendSetupPacket(setup)
    for (let at = 0; out && at < length; at += 64) this.push(0, new Uint8Array(data.subarray(at, at + 64)))
    const over = () => t.stalled || t.done || (t.got && !this.queues.get(0).length && !this.armed.has(0))
    check(this.pico.run(over, 100), `request 0x${request.toString(16)} of type 0x${type.toString(16)} gets no answer`)
    this.pico.run(() => false, 0.2)
    this.transfer = null
    if (t.stalled) return null
    return out ? Buffer.alloc(0) : t.data
  }
  // The emulator leaves these to us.
  suspend() {
    const { usb } = this
    usb.sieStatus |= 1 << 4
    usb.sieStatusUpdated()
    this.pico.run(() => false, 0.001)
    usb.sieStatus &= ~(1 << 4)
    usb.sieStatusUpdated()
  }
  resume() {
    this.usb.sieStatus |= 1 << 11
    this.usb.sieStatusUpdated()
  }
  // Halts a bulk endpoint, as hosts do in tests only; and ends its halt, as they do after a STALL or a transfer that they gave up.
  halt(endpoint) { return this.control(0x02, 3, 0, endpoint, Buffer.alloc(0)) !== null }
  clear_halt(endpoint) { return this.control(0x02, 1, 0, endpoint, Buffer.alloc(0)) !== null }
  // Its only setting, once more.
  set_interface(number, endpoint) {
    this.next.delete(endpoint)
    return this.control(0x01, 11, 0, number, Buffer.alloc(0)) !== null
  }
  // The configuration that is set, once more.
  configure(number) {
    this.next.clear()
    return this.control(0x00, 9, number, 0, Buffer.alloc(0)) !== null
  }
  is_halted(endpoint) { return this.control(0x82, 0, 0, endpoint, 2)[0] === 1 }
  // Bulk OUT; returns when the device took all.
  bulk(endpoint, bytes, ms = 1000) {
    for (let at = 0; at < bytes.length; at += 64) this.push(endpoint, new Uint8Array(bytes.subarray(at, at + 64)))
    const queue = this.queues.get(endpoint) ?? []
    check(this.pico.run(() => !queue.length && this.armed.has(endpoint), ms), `${queue.length} packets are left over`)
  }
  // As any host: descriptors, an address, the configuration. Returns what the device says of itself.
  enumerate() {
    check(this.pico.run(() => this.pulled_up, 100), 'the device does not pull up')
    this.reset()
    const get = (kind, index, length, language = 0) => this.control(0x80, 6, kind << 8 | index, language, length)
    const device = get(1, 0, 18)
    check(this.control(0x00, 5, 7, 0) !== null, 'SET_ADDRESS is refused')
    const size = get(2, 0, 9).readUInt16LE(2)
    const configuration = get(2, 0, size)
    const text = (index) => get(3, index, 255, 0x409)?.subarray(2).toString('utf16le')
    const texts = [14, 15, 16].map((at) => text(device[at]))
    check(this.control(0x00, 9, configuration[5], 0) !== null, 'SET_CONFIGURATION is refused')
    return { device, configuration, texts }
  }
}
