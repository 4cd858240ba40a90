// SPDX-License-Identifier: MIT
// A Raspberry Pi Pico (rp2040js) that runs an unmodified UF2 image, with a panel on its pins. What the emulator leaves out and
// matters here is added: the time that SPI frames take, and the XIP streamer with the time of flash.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { basename, resolve } from 'node:path'
import { SecondCore } from './second_core.mjs'

const FLASH = 0x10000000
const STACK = 0x20042000
const BOOT_ROM = 0x20041f00 // its first word, which is read through NULL
const CYCLE_NS = 8 // 125 MHz

// The board whose image lies in FOLDER, by its row of boards.def.
export function boardOf(folder, panel = '') {
  const rows = [...readFileSync(new URL('../../firmware/ports/pico/boards.def', import.meta.url), 'utf8').matchAll(/^BOARD\((.*)\)$/gm)]
  const named = basename(folder), at = named.indexOf(`-${panel}`)
  const row = rows.map(([, row]) => row.split(/, */)).find(([name]) => name === (at > 0 ? named.slice(0, at) : 'pico'))
  const [name, , chip, , ...facts] = row
  const [turn, dc, cs, clock, data, reset, backlight, , , sda, scl, ...axes] = facts.map(Number)
  return { name, chip, turn, qspi: panel.startsWith('co5300'), pins: { dc, cs, clock, data, reset, backlight }, imu: facts[8], sda, scl, axes }
}

const FUNCTION_SPI = 1, FUNCTION_PIO0 = 6
const EYE_NS = 150e3

// The blocks of a UF2 file for the RP2040, placed.
export function loadUf2(flash, file) {
  const image = readFileSync(file)
  const count = image.length / 512
  for (let i = 0; i < count; i++) {
    const word = (at) => image.readUInt32LE(512 * i + at)
    const good = word(0) === 0x0a324655 && word(4) === 0x9e5d5157 && word(508) === 0x0ab16f30 && word(28) === 0xe48bff56 &&
      word(16) === 256 && word(20) === i && word(24) === count
    if (!good) throw new Error(`${file}: block ${i} of ${count} is not one that an RP2040's boot loader takes`)
    flash.set(image.subarray(512 * i + 32, 512 * i + 288), word(12) - FLASH)
  }
}

// The addresses of an ELF file's functions and variables, by name.
export function symbolsOf(file) {
  const bytes = readFileSync(file)
  const section = (i) => {
    const at = bytes.readUInt32LE(32) + i * bytes.readUInt16LE(46)
    const word = (k) => bytes.readUInt32LE(at + 4 * k)
    return { type: word(1), offset: word(4), size: word(5), link: word(6) }
  }
  const symbols = new Map()
  for (let i = 0; i < bytes.readUInt16LE(48); i++) {
    const { type, offset, size, link } = section(i)
    if (type !== 2) continue // SHT_SYMTAB
    for (let at = offset; at < offset + size; at += 16) {
      const start = section(link).offset + bytes.readUInt32LE(at)
      symbols.set(bytes.toString('latin1', start, bytes.indexOf(0, start)), bytes.readUInt32LE(at + 4))
    }
  }
  return symbols
}

// The XIP controller's streamer: words of flash, in the background, into a FIFO of two that a DMA request empties.
class Streamer {
  static DREQ = 37
  constructor(chip, word_ns) {
    Object.assign(this, { chip, word_ns, address: 0, left: 0, fifo: [] })
    this.alarm = chip.clock.createAlarm(() => this.arrive())
    chip.peripherals[0x14000] = { readUint32: (at) => this.read(at), writeUint32Atomic: (at, value) => this.write(at, value) }
    chip.peripherals[0x50400] = { readUint32: () => this.pop(), writeUint32Atomic() { throw new Error('a write to XIP_AUX') } }
  }
  read(at) {
    if (at === 0x14) return this.address
    if (at === 0x18) return this.left
    if (at === 0x1c) return this.pop()
    throw new Error(`a read of the XIP controller's register ${at}`)
  }
  write(at, value) {
    if (at === 0x14 && value % 4 === 0 && !this.left) { this.address = value } else
    if (at === 0x18 && !this.left && !this.fifo.length) { this.left = value; this.alarm.schedule(this.word_ns) } else
    throw new Error(`a write of ${value} to the XIP controller's register ${at}, ${this.left} words being streamed`)
  }
  arrive() {
    if (this.fifo.length < 2) {
      this.fifo.push(this.chip.readUint32(this.address))
      this.address += 4
      this.left--
      this.chip.dma.setDREQ(Streamer.DREQ)
    }
    if (this.left) this.alarm.schedule(this.word_ns)
  }
  pop() {
    if (!this.fifo.length) throw new Error('the streamer is read while it is empty')
    const word = this.fifo.shift()
    if (!this.fifo.length) this.chip.dma.clearDREQ(Streamer.DREQ)
    return word
  }
}

// What a panel would see on its pins, as `judge` reads it: pairs of a letter and a byte. C command, D data, R reset and B
// backlight levels.
class Wires {
  constructor(chip, pins) {
    this.chip = chip
    this.pins = pins
    this.window = Buffer.alloc(8) // first and last column, first and last row
    this.bytes = Buffer.alloc(1 << 20)
    this.length = 0
    this.faults = [] // what a panel could misread
    this.pixels = 0 // bytes since the last RAMWR
    this.windows = 0 // how many RAMWR there were
    this.wire_ns = 0 // time that the bus was in use
    this.held = false // a bus that hangs
    this.watch()
    chip.gpio[this.pins.reset].addListener(() => {
      this.put('R', this.level('reset'))
      if (this.level('reset') && !this.clock_is_idle()) this.faults.push('the clock is not idle when the reset ends')
    })
  }
  level(name) { return this.chip.gpio[this.pins[name]].value === 1 ? 1 : 0 }
  put(kind, byte) {
    if (this.length + 2 > this.bytes.length) this.bytes = Buffer.concat([this.bytes, Buffer.alloc(this.bytes.length)])
    this.bytes[this.length++] = kind.charCodeAt(0)
    this.bytes[this.length++] = byte
  }
  take_command(value) {
    this.put('C', value)
    this.command = value
    if (value === 0x2c) this.windows++
    this.parameters = this.pixels = 0
  }
  take_data(value) {
    this.put('D', value)
    if (this.command === 0x2a || this.command === 0x2b) this.window[4 * (this.command - 0x2a) + this.parameters++ % 4] = value
    if (this.command === 0x2c) this.pixels++
  }
  // Has the last pixel of a picture of so many lines come, whatever windows it was sent in? Its first line is `top` of the memory.
  picture_done(height, first = 0) {
    const [left, right, top, bottom] = [0, 2, 4, 6].map((at) => this.window.readUInt16BE(at))
    return bottom === first + height - 1 && this.pixels === 2 * (right - left + 1) * (bottom - top + 1)
  }
  transcript() { return this.bytes.subarray(0, this.length) }
}

class SpiWires extends Wires {
  watch() {
    const { chip } = this, spi = chip.spi[1]
    const alarm = chip.clock.createAlarm(() => this.sent(spi))
    spi.onTransmit = (value) => {
      this.frame = { value, bits: spi.dataBits, dc: this.level('dc') }
      const ns = spi.dataBits * 1e9 / spi.clockFrequency
      this.wire_ns += ns
      if (!this.held) alarm.schedule(ns)
    }
    this.lit = { is: false, since: 0, ns: 0, dark: chip.clock.createAlarm(() => { this.lit.is = false; this.put('B', 0) }) }
    chip.gpio[this.pins.backlight].addListener(() => this.light(this.level('backlight')))
  }
  // An eye sees no gaps as short as a dimmed light's.
  light(level) {
    const { lit } = this, now = this.chip.clock.nanos
    if (!level) { lit.ns += now - lit.since; lit.dark.schedule(EYE_NS); return }
    lit.since = now
    lit.dark.cancel()
    if (!lit.is) { lit.is = true; this.put('B', 1) }
  }
  lit_ns() { return this.lit.ns + (this.level('backlight') ? this.chip.clock.nanos - this.lit.since : 0) }
  clock_idles_high() { return (this.chip.spi[1].readUint32(0) & 0xc0) === 0xc0 } // SPO and SPH, mode 3
  clock_is_idle() { return this.clock_idles_high() }
  sent(spi) {
    const { value, bits, dc } = this.frame
    const { gpio } = this.chip
    const fault = (what) => this.faults.push(`${what}, frame 0x${value.toString(16)} of ${bits} bits`)
    if (dc !== this.level('dc')) fault('D/C changes while a frame is sent')
    if (bits !== 8 && bits !== 16) fault('not whole bytes')
    if (bits === 16 && !dc) fault('a command of 16 bits')
    if (gpio[this.pins.clock].functionSelect !== FUNCTION_SPI || gpio[this.pins.data].functionSelect !== FUNCTION_SPI) fault('the pins are not the SPI\'s')
    if (!this.clock_idles_high()) fault('not SPI mode 3')
    if (this.level('cs') !== 0) fault('CS is high')
    if (!dc) this.take_command(value & 255)
    else {
      if (bits === 16) this.take_data(value >> 8)
      this.take_data(value & 255)
    }
    spi.completeTransmit(0)
  }
}

// Four lines by the first PIO, whose state machine has no clock of its own in the emulator: run() advances it as the processor's cycles
// pass. What the lines say is read where the clock rises, as a CO5300 does: after select falls a byte that says by how many lines the
// data come, 24 bits with the command in their middle, data until select rises. Frames are judged: what that panel does not take is a fault.
const BY_ONE_LINE = 0x02, PIXELS_BY_FOUR = 0x32, FEWEST_BYTES = 72
class QspiWires extends Wires {
  watch() {
    const { chip } = this, pio = chip.pio[0]
    pio.run = () => {} // by a timer of the machine that emulates
    Object.assign(this, { pio, machine: pio.machines[0], left: 0, clock: 0, open: false, small: Infinity })
    chip.gpio[this.pins.cs].addListener(() => this.select(chip.gpio[this.pins.cs].value === 0))
  }
  clock_is_idle() { return !this.chip.gpio[this.pins.clock].outputValue }
  advance(cycles) {
    const { machine, pio } = this
    if (!machine.enabled || this.held) return
    for (this.left += cycles; this.left >= machine.clockDivInt; this.left -= machine.clockDivInt) {
      if (machine.waiting && machine.txFIFO.empty) { this.left = 0; break }
      machine.step()
      this.wire_ns += CYCLE_NS * machine.clockDivInt
      const clock = pio.pinValues >> this.pins.clock & 1
      if (clock && !this.clock) this.rise()
      this.clock = clock
    }
    const lines = 0xf << this.pins.data | 1 << this.pins.clock
    if ((pio.pinDirections & lines) !== lines) this.faults.push('the lines are not driven')
  }
  rise() {
    const { gpio } = this.chip, { data, clock } = this.pins
    for (const pin of [clock, data, data + 1, data + 2, data + 3]) if (gpio[pin].functionSelect !== FUNCTION_PIO0) this.faults.push(`pin ${pin} is not the PIO's`)
    if (!this.open) { this.faults.push('the clock rises while select is high'); return }
    const nibble = this.pio.pinValues >> data & 0xf
    this.bits = (this.by_four ? this.bits << 4 | nibble : this.bits << 1 | nibble & 1) & 0xff
    this.count += this.by_four ? 4 : 1
    if (this.count % 8 === 0) this.byte(this.bits)
  }
  byte(value) {
    const at = this.count / 8 - 1
    const fault = (what) => this.faults.push(`${what}, byte ${at} of a frame is 0x${value.toString(16)}`)
    if (at === 0) {
      if (value !== BY_ONE_LINE && value !== PIXELS_BY_FOUR) fault('neither a command nor pixels')
      this.pixels_follow = value === PIXELS_BY_FOUR
    } else if (at === 1 || at === 3) {
      if (value) fault('an address that is not 0')
      this.by_four = at === 3 && this.pixels_follow
    } else if (at === 2) {
      if (this.pixels_follow !== (value === 0x2c || value === 0x3c)) fault('pixels and commands are exchanged')
      this.take_command(value)
      if (value === 0x2c) this.check_window()
    } else this.take_data(value)
  }
  check_window() {
    const [left, right, top, bottom] = [0, 2, 4, 6].map((at) => this.window.readUInt16BE(at))
    if (left % 2 || top % 2 || right % 2 === 0 || bottom % 2 === 0) this.faults.push(`an odd window, ${left}..${right}, ${top}..${bottom}`)
  }
  select(open) {
    if (open === this.open) return
    if (!open && (this.count % 8 || this.count < 32)) this.faults.push(`select rises after ${this.count} bits`)
    if (!open && this.pixels_follow) {
      this.small = Math.min(this.small, this.pixels)
      if (this.pixels < FEWEST_BYTES) this.faults.push(`a write of ${this.pixels} bytes of pixels`)
    }
    if (this.clock) this.faults.push('select changes while the clock is high')
    Object.assign(this, { open, count: 0, bits: 0, by_four: false, pixels_follow: false })
  }
}

// Why the chip was started, for the processor to read: the supply, or the RUN pin.
export const STARTED_BY = { supply: 1 << 8, pin: 1 << 16 }

// The chip would start again; here the run ends.
export class WatchdogBite extends Error {}

export class Pico {
  // flash_word: cycles of a 32-bit word from flash (125 MHz, a quad read at half of it).
  constructor(packages, { flash_word = 40, pins = boardOf('').pins, qspi = false } = {}) {
    const { RP2040 } = createRequire(resolve(packages, 'x'))('rp2040js')
    this.chip = new RP2040()
    this.chip.bootrom[0] = BOOT_ROM // all that it has of one
    this.chip.logger = { debug() {}, info() {}, warn() {}, error: (_, message) => { throw new Error(message) } }
    this.uart = ''
    this.chip.uart[0].onByte = (byte) => { this.uart += String.fromCharCode(byte) }
    this.watchdog = this.chip.peripherals[0x40058]
    this.watchdog.onWatchdogTrigger = () => { throw new WatchdogBite() }
    this.chip_reset = STARTED_BY.supply
    this.chip.peripherals[0x40064] = { readUint32: (at) => at === 8 ? this.chip_reset : 0, writeUint32Atomic() {} }
    this.streamer = new Streamer(this.chip, flash_word * CYCLE_NS)
    this.wires = qspi ? new QspiWires(this.chip, pins) : new SpiWires(this.chip, pins)
    this.qspi = qspi ? this.wires : undefined
    this.probes = new Map() // by address: what to call when the processor is there
  }
  load(uf2) {
    loadUf2(this.chip.flash, uf2)
    const { core } = this.chip
    core.SP = STACK
    core.PC = FLASH // the second stage, as the boot ROM leaves it
    core.LR = 0
    return this
  }
  // The same board, started again: flash and RAM are as they were, and where the watchdog did it, what that keeps.
  static after({ chip, watchdog }, packages, uf2, { by, watchdog: bitten = false }) {
    const pico = new Pico(packages).load(uf2)
    pico.chip.flash.set(chip.flash)
    pico.chip.sram.set(chip.sram)
    pico.chip_reset = by
    if (!bitten) return pico
    pico.watchdog.reason = 1
    pico.watchdog.scratchData.set(watchdog.scratchData)
    return pico
  }
  // With a second core, by our model of it.
  with_second_core() {
    this.second = new SecondCore(this.chip)
    return this
  }
  get cycles() { return this.chip.clock.nanos / CYCLE_NS }
  // Of the backlight, in percent of the time.
  brightness() {
    const begin = this.chip.clock.nanos, before = this.wires.lit_ns()
    this.run(() => false, 4)
    return 100 * (this.wires.lit_ns() - before) / (this.chip.clock.nanos - begin)
  }
  // Runs until done() or the time is over; whether it was done().
  run(done, ms = 2000) {
    const { second, qspi, chip: { core, clock } } = this
    const end = clock.nanos + ms * 1e6
    while (clock.nanos < end) {
      if (done()) return true
      for (let i = 0; i < 32; i++) {
        if (core.waiting && !second?.awake) { clock.tick(Math.max(clock.nanosToNextAlarm, CYCLE_NS)); continue }
        if (this.probes.size) this.probes.get(core.PC)?.()
        if (core.waiting) { const cycles = second.execute(); qspi?.advance(cycles); clock.tick(cycles * CYCLE_NS); continue }
        const cycles = core.executeInstruction()
        second?.catch_up(cycles)
        qspi?.advance(cycles)
        clock.tick(cycles * CYCLE_NS)
      }
    }
    return done()
  }
}
