// SPDX-License-Identifier: MIT
// A USB host on the emulated controller: resets, control transfers, bulk OUT, at full speed's pace.
import { check } from './tap.mjs'

const PACKET_US = 1000 / 19 // 19 packets of 64 bytes a millisecond: the most that full speed carries
const STALL = 1 << 11, EP0_IN = 0x80, EP0_OUT = 0x84

export class UsbHost {
  constructor(pico) {
    this.pico = pico
    this.usb = pico.chip.usbCtrl
    this.armed = new Map() // OUT endpoints that wait for a packet
    this.queues = new Map() // what is to be sent to them
    this.pulled_up = false
    const { usb } = this
    usb.onUSBEnabled = () => { this.pulled_up = true }
    usb.onResetReceived = () => { this.was_reset = true }
    usb.onEndpointRead = (endpoint, length) => { this.armed.set(endpoint, length); this.feed(endpoint) }
    usb.onEndpointWrite = (endpoint, bytes) => { if (endpoint === 0) this.control_in(bytes) }
    const plain = usb.DPRAMUpdated.bind(usb)
    usb.DPRAMUpdated = (offset, value) => {
      if ((offset === EP0_IN || offset === EP0_OUT) && value & STALL && this.transfer) this.transfer.stalled = true
      plain(offset, value)
    }
  }
  feed(endpoint) {
    const queue = this.queues.get(endpoint)
    if (!this.armed.has(endpoint) || !queue?.length) return
    const packet = queue.shift()
    check(packet.length <= this.armed.get(endpoint), `endpoint ${endpoint} waits for ${this.armed.get(endpoint)} bytes, not ${packet.length}`)
    this.armed.delete(endpoint)
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
    this.was_reset = false
    this.usb.resetDevice()
    check(this.pico.run(() => this.was_reset, 100), 'the bus reset is not taken')
    this.pico.run(() => false, 1)
  }
  // A control transfer; data to send, or how many bytes to get. null: STALL.
  control(type, request, value, index, data) {
    const out = !(type & 0x80)
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
