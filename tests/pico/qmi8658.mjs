// SPDX-License-Identifier: MIT
// A QMI8658C on the emulated I2C: a model of its registers after its data sheet (13-52-27 rev. A), as far as its accelerometer goes, with the time that bytes take,
// the noise of a real one, and faults.
const WHO_AM_I = 0x00, REVISION = 0x01, CTRL1 = 0x02, CTRL2 = 0x03, CTRL7 = 0x08, STATUS0 = 0x2e, AX_L = 0x35
const BYTE_NS = 9e9 / 400e3, START_NS = 1e9 / 400e3
export const NOISE_G = 200e-6 // over the root of a hertz

// Seeded: mulberry32, and a normal distribution of it by Box and Muller.
export function gaussian(seed) {
  const uniform = () => {
    seed = seed + 0x6d2b79f5 | 0
    let t = Math.imul(seed ^ seed >>> 15, 1 | seed)
    t = t + Math.imul(t ^ t >>> 7, 61 | t) ^ t
    return ((t ^ t >>> 14) >>> 0) / 4294967296
  }
  return () => Math.sqrt(-2 * Math.log(1 - uniform())) * Math.cos(2 * Math.PI * uniform())
}

export class Qmi8658 {
  // gravity: what it feels, in g along its axes; may be changed at any time.
  constructor(chip, block, { gravity = [0, 0, 1], seed = 1, address = 0x6b } = {}) {
    Object.assign(this, { chip, i2c: chip.i2c[block], gravity, address, normal: gaussian(seed), fault: 'none', reads: 0, samples: 0, log: [] })
    this.registers = new Uint8Array(256)
    this.registers.set([5, 0x7c, 0x20], WHO_AM_I)
    this.pending = () => {}
    this.alarm = chip.clock.createAlarm(() => this.pending())
    const later = (ns, what) => { if (this.fault !== 'hangs') { this.pending = what; this.alarm.schedule(ns) } }
    const { i2c } = this
    i2c.onStart = () => later(START_NS, () => i2c.completeStart())
    i2c.onStop = () => later(START_NS, () => i2c.completeStop())
    i2c.onConnect = (called, mode) => {
      this.is_first = mode === 0
      later(BYTE_NS, () => i2c.completeConnect(called === this.address && this.fault !== 'absent'))
    }
    i2c.onWriteByte = (value) => later(BYTE_NS, () => {
      if (this.fault === 'nacks') { i2c.completeWrite(false); return }
      if (this.is_first) this.pointer = value
      else { this.write(this.pointer, value); this.advance() }
      this.is_first = false
      i2c.completeWrite(true)
    })
    i2c.onReadByte = () => later(BYTE_NS, () => {
      const value = this.read(this.pointer)
      this.advance()
      i2c.completeRead(value)
    })
    this.sampling = chip.clock.createAlarm(() => this.sample())
  }
  // As after nine clocks and a reset of the block, which the emulator's I2C has not.
  free() {
    this.fault = 'none'
    const { i2c } = this
    Object.assign(i2c, { busy: false, stop: false, state: 0, abortSource: 0 })
    i2c.txFIFO.reset()
    i2c.rxFIFO.reset()
  }
  advance() { if (this.registers[CTRL1] & 0x40) this.pointer = this.pointer + 1 & 255 }
  get rate() { return [7174.4, 3587.2, 1793.6, 1000, 500, 250, 125, 62.5, 31.25][this.registers[CTRL2] & 15] }
  write(at, value) {
    this.log.push([at, value])
    const was_on = this.registers[CTRL7] & 1
    if (at >= CTRL1 && at <= 0x0a) this.registers[at] = value
    if (at === CTRL7 && !was_on && value & 1) this.sampling.schedule(1e9 / this.rate)
  }
  read(at) {
    if (at === AX_L) { this.reads++; this.registers[STATUS0] &= ~1 }
    if (this.fault === 'nonsense') return 0xff
    return at === REVISION || at <= AX_L + 5 ? this.registers[at] : 0
  }
  // A read that meets a new sample has bytes of both: the data sheet promises otherwise of SyncSample's locked reads only.
  sample() {
    if (!(this.registers[CTRL7] & 1)) return
    const one = 16384 >> (this.registers[CTRL2] >> 4 & 3), sigma = NOISE_G * Math.sqrt(this.rate / 2)
    this.gravity.forEach((g, i) => {
      const noisy = this.fault === 'stuck' ? g : g + sigma * this.normal()
      const value = Math.max(-32768, Math.min(32767, Math.round(noisy * one)))
      this.registers[AX_L + 2 * i] = value & 255
      this.registers[AX_L + 2 * i + 1] = value >> 8 & 255
    })
    this.registers[STATUS0] |= 1
    this.samples++
    this.sampling.schedule(1e9 / this.rate)
  }
}
