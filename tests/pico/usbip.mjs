// SPDX-License-Identifier: MIT
// USB/IP, the device's side: requests of a real kernel on a socket become transfers on the emulated board.
import { Socket } from 'node:net'

const HEADER = 48, SUBMIT = 1, UNLINK = 2, RET_SUBMIT = 3, RET_UNLINK = 4, IN = 1
const EPIPE = -32, ECONNRESET = -104

export class UsbIp {
  // The socket, or its file descriptor. After each bulk transfer done(endpoint) is called. `stalls` of them are refused.
  constructor(host, socket, done = () => {}) {
    Object.assign(this, { host, done, received: Buffer.alloc(0), queue: [], stalls: 0 })
    this.socket = typeof socket === 'number' ? new Socket({ fd: socket }) : socket
    this.socket.on('data', (bytes) => { this.received = Buffer.concat([this.received, bytes]); this.parse() })
    this.socket.on('error', () => {})
  }
  parse() {
    while (this.received.length >= HEADER) {
      const word = (at) => this.received.readUInt32BE(at)
      const urb = { command: word(0), seqnum: word(4), direction: word(12), endpoint: word(16) }
      if (urb.command === UNLINK) {
        const victim = word(20), waiting = this.queue.findIndex((other) => other.seqnum === victim)
        if (waiting >= 0) this.queue.splice(waiting, 1)
        this.reply(RET_UNLINK, urb, waiting >= 0 ? ECONNRESET : 0)
        this.received = this.received.subarray(HEADER)
        continue
      }
      if (urb.command !== SUBMIT) throw new Error(`USB/IP command ${urb.command}`)
      urb.length = word(24)
      urb.setup = Buffer.from(this.received.subarray(40, 48))
      const out = urb.direction === IN ? 0 : urb.length
      if (this.received.length < HEADER + out) return
      urb.data = Buffer.from(this.received.subarray(HEADER, HEADER + out))
      this.received = this.received.subarray(HEADER + out)
      this.queue.push(urb)
    }
  }
  reply(command, { seqnum }, status, length = 0, data = Buffer.alloc(0)) {
    const header = Buffer.alloc(HEADER)
    header.writeUInt32BE(command, 0)
    header.writeUInt32BE(seqnum, 4)
    header.writeInt32BE(status, 20)
    header.writeUInt32BE(length, 24)
    this.socket.write(Buffer.concat([header, data]))
  }
  // One transfer that waits, if any does; whether there was one.
  step() {
    const urb = this.queue.shift()
    if (!urb) return false
    if (urb.endpoint === 0) this.control(urb)
    else if (this.stalls && this.stalls--) this.reply(RET_SUBMIT, urb, EPIPE)
    else {
      this.host.bulk(urb.endpoint, urb.data, 5000)
      this.reply(RET_SUBMIT, urb, 0, urb.data.length)
      this.done(urb.endpoint)
    }
    return true
  }
  control(urb) {
    const { setup } = urb
    const [type, request] = setup
    const [value, index, length] = [2, 4, 6].map((at) => setup.readUInt16LE(at))
    const data = this.host.control(type, request, value, index, type & 0x80 ? length : urb.data)
    if (data === null) this.reply(RET_SUBMIT, urb, EPIPE)
    else this.reply(RET_SUBMIT, urb, 0, type & 0x80 ? data.length : urb.data.length, type & 0x80 ? data : undefined)
  }
}
