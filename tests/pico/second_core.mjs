// SPDX-License-Identifier: MIT
// The RP2040's second core, which rp2040js lacks, after the data sheet: a processor of its own on the same buses, the two FIFOs of
// eight words between them, and the boot ROM's protocol that launches it. The cores take turns, an instruction at a time.
// What it leaves out: that they wait for each other at the same bank of RAM, and interrupts of the second one.
const CPUID = 0x00, FIFO_ST = 0x50, FIFO_WR = 0x54, FIFO_RD = 0x58, DEPTH = 8
const VALID = 1, READY = 2
const DIVIDER = ['divDividend', 'divDivisor', 'divQuotient', 'divRemainder', 'divCSR'] // each core has one

export class SecondCore {
  constructor(chip) {
    const first = chip.core
    const core = new first.constructor(chip)
    Object.assign(this, { chip, first, core, running: false, due: 0, step: 0, messages: [], lowest: 2 ** 32 })
    this.inbox = [[], []] // of each core
    this.divider = Object.fromEntries(DIVIDER.map((name) => [name, chip.sio[name]]))
    const { sio } = chip
    const read = sio.readUint32.bind(sio), write = sio.writeUint32.bind(sio)
    sio.readUint32 = (at) => {
      const me = chip.core === core ? 1 : 0
      if (at === CPUID) return me
      if (at === FIFO_ST) return (this.inbox[me].length ? VALID : 0) | (this.inbox[1 - me].length < DEPTH ? READY : 0)
      if (at === FIFO_RD) {
        if (!this.inbox[me].length) throw new Error(`core ${me} reads an empty FIFO`)
        return this.inbox[me].shift()
      }
      return read(at)
    }
    sio.writeUint32 = (at, value) => {
      const me = chip.core === core ? 1 : 0
      if (at === FIFO_ST) return
      if (at !== FIFO_WR) { write(at, value); return }
      if (me === 0 && !this.running) { this.launch(value >>> 0); return }
      if (this.inbox[1 - me].length === DEPTH) throw new Error(`core ${me} writes a full FIFO`)
      this.inbox[1 - me].push(value >>> 0)
      this.wake(me ? first : core)
    }
  }
  wake(core) {
    if (core.waiting) core.waiting = false
    else core.eventRegistered = true
  }
  // The boot ROM echoes 0, 0, 1, the vector table, the stack and the entry; a word out of turn restarts the sequence.
  launch(value) {
    const in_turn = this.step >= 3 || value === [0, 0, 1][this.step]
    this.messages[this.step] = value
    this.step = in_turn ? this.step + 1 : value === 0 ? 1 : 0
    this.inbox[0].push(value)
    this.wake(this.first)
    if (this.step < 6) return
    const [, , , vectors, stack, entry] = this.messages
    this.core.VTOR = vectors
    this.core.SP = stack
    this.core.PC = entry & ~1
    this.running = true
  }
  get awake() { return this.running && !this.core.waiting }
  // So many cycles have gone by for the first one.
  catch_up(cycles) {
    this.due += cycles
    while (this.awake && this.due > 0) this.due -= this.execute()
    if (!this.awake) this.due = 0
  }
  execute() {
    const { chip, core, divider } = this
    const others = {}
    for (const name of DIVIDER) { others[name] = chip.sio[name]; chip.sio[name] = divider[name] }
    chip.core = core
    const cycles = core.executeInstruction()
    chip.core = this.first
    for (const name of DIVIDER) { divider[name] = chip.sio[name]; chip.sio[name] = others[name] }
    if (core.SP < this.lowest) this.lowest = core.SP
    return cycles
  }
}
