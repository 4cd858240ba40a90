// SPDX-License-Identifier: MIT
// What a GUD host says, for tests; numbers are those of firmware/core/gud_protocol.h.
export const STATUS = { ok: 0, unsupported: 2, protocol: 3, parameter: 4, error: 5 }
export const FORMAT = { r1: 0x01, rgb565: 0x40 }
const IN = 0xc1, OUT = 0x41

export class Gud {
  constructor(host, { interface_number = 0, endpoint = 1 } = {}) { Object.assign(this, { host, interface_number, endpoint }) }
  get(request, length, value = 0) { return this.host.control(IN, request, value, this.interface_number, length) }
  set(request, data = Buffer.alloc(0), value = 0) { return this.host.control(OUT, request, value, this.interface_number, data) !== null }
  status() { return this.get(0x00, 1)[0] }
  enable(controller, display) {
    return this.set(0x63, Buffer.of(controller)) && this.set(0x64, Buffer.of(display))
  }
  state(format, brightness) {
    const mode = this.get(0x55, 24)
    const property = brightness === undefined ? [] : [12, 0, brightness, 0, 0, 0, 0, 0, 0, 0]
    return this.set(0x61, Buffer.concat([mode, Buffer.of(format, 0, ...property)])) && this.set(0x62)
  }
  brightness() { return this.get(0x51, 320)[2] }
  // As the kernel's driver begins.
  begin(format) { return this.set(0x63, Buffer.of(1)) && this.state(format) && this.set(0x64, Buffer.of(1)) }
  buffer({ x, y, width, height, length, compressed = 0 }) {
    const data = Buffer.alloc(25)
    for (const [i, value] of [x, y, width, height, length].entries()) data.writeUInt32LE(value, 4 * i)
    data[20] = compressed ? 1 : 0
    data.writeUInt32LE(compressed, 21)
    return this.set(0x60, data)
  }
  draw(rectangle, bytes, block) {
    const ok = this.buffer({ ...rectangle, length: bytes.length, compressed: block?.length })
    if (ok) this.host.bulk(this.endpoint, block ?? bytes)
    return ok
  }
}

// RGB565 in memory order, and the same picture as a panel shows it: levels to the nearest of 255.
export function shown565(bytes) {
  const rgb = Buffer.alloc(bytes.length / 2 * 3)
  const level = (value, max) => Math.floor((value * 255 + (max >> 1)) / max)
  for (let i = 0; i < bytes.length / 2; i++) {
    const word = bytes.readUInt16LE(2 * i)
    rgb.set([level(word >> 11, 31), level(word >> 5 & 63, 63), level(word & 31, 31)], 3 * i)
  }
  return rgb
}

// A picture that compresses in part: bands, a gradient, noise of a small generator.
export function picture565(width, height, seed) {
  const bytes = Buffer.alloc(2 * width * height)
  let state = seed
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      state = Math.imul(state, 1664525) + 1013904223 >>> 0
      const word = y % 16 < 8 ? (x >> 3) * 2113 + seed : y % 16 < 14 ? x * 257 + y : state >>> 16
      bytes.writeUInt16LE(word & 0xffff, 2 * (y * width + x))
    }
  }
  return bytes
}
