// SPDX-License-Identifier: MIT
// test_faults.mjs PACKAGES FOLDER PANEL JUDGE: what the board shows and says when something is, or was, wrong; numbers are those of
// firmware/core/fault.h.
import { FORMAT, Gud, picture565, shown565 } from './gud.mjs'
import { Judge } from './judge.mjs'
import { Pico, STARTED_BY, symbolsOf, WatchdogBite } from './pico.mjs'
import { check, equal, run } from './tap.mjs'
import { UsbHost } from './usb_host.mjs'

const [packages, folder, panel, program] = process.argv.slice(2)
const judge = new Judge(program, panel)
const { width, height } = judge
const uf2 = `${folder}/glint.uf2`
const symbols = symbolsOf(`${folder}/glint.elf`)
const HUNG = 1, SUPPLY = 2, MAP = 3, BUS = 4
const FLASH = 0x10000000

const look = (pico) => judge.look(pico.wires.transcript())
function shows_fault(pico, number) {
  check(pico.run(() => pico.uart.endsWith('showing the error\r\n'), 1000), pico.uart)
  check(pico.run(() => pico.wires.level('backlight') === 1, 5), 'the backlight stays off')
  check(pico.uart.includes(`error ${number}: `), pico.uart)
  judge.same(look(pico), judge.fault(number), 'the picture')
}
function relights(pico, ms) {
  check(pico.run(() => pico.uart.endsWith('relighting\r\n'), ms), pico.uart)
  check(pico.run(() => pico.wires.pixels === 2 * width * height, 300), 'no whole frame')
  check(pico.run(() => pico.wires.level('backlight') === 1, 1), 'the backlight stays off')
  judge.same(look(pico), judge.demo(0), 'the first frame')
}
function until_bitten(pico) {
  try { pico.run(() => false, 1500) } catch (error) {
    if (error instanceof WatchdogBite) return
    throw error
  }
  throw new Error('the watchdog does not bite')
}
const powered_up = () => {
  const pico = new Pico(packages).load(uf2)
  pico.chip.sram.fill(0x5a)
  return pico
}

let pico = powered_up()
run([
  ['after a power-up nothing is wrong', () => {
    check(pico.run(() => pico.uart.includes('relighting'), 3000), pico.uart)
    check(!pico.uart.includes('error'), pico.uart)
  }],
  ['a bus that hangs: the watchdog restarts the board, which reports it and shows it for two seconds', () => {
    pico.wires.held = true
    until_bitten(pico)
    pico = Pico.after(pico, packages, uf2, { by: STARTED_BY.supply, watchdog: true })
    shows_fault(pico, HUNG)
    check(!pico.run(() => pico.uart.includes('relighting'), 1800), 'it is gone before')
    relights(pico, 400)
  }],
  ['a bus that fails is reported, and shown after the restart', () => {
    pico.chip.writeUint8(symbols.get('gud_panel') + 8, 1) // has_failed: a bus of our SPI's kind cannot
    until_bitten(pico)
    check(pico.uart.includes(`error ${BUS}: `), pico.uart)
    pico = Pico.after(pico, packages, uf2, { by: STARTED_BY.supply, watchdog: true })
    shows_fault(pico, BUS)
  }],
  ['a computer may draw while the fault is shown', () => {
    const host = new UsbHost(pico), gud = new Gud(host)
    host.pulled_up = true
    host.enumerate()
    check(gud.begin(FORMAT.rgb565), `refused with status ${gud.status()}`)
    const pixels = picture565(width, height, 5)
    check(gud.draw({ x: 0, y: 0, width, height }, pixels), `refused with status ${gud.status()}`)
    pico.run(() => false, 1)
    judge.same(look(pico), shown565(pixels), 'its frame')
  }],
  ['a dip of the supply is told from a power-up by RAM that kept its contents', () => {
    pico = Pico.after(pico, packages, uf2, { by: STARTED_BY.supply })
    shows_fault(pico, SUPPLY)
    relights(pico, 2200)
  }],
  ['the reset button is no fault, and nor is a loader that starts the board by the watchdog', () => {
    pico = Pico.after(pico, packages, uf2, { by: STARTED_BY.pin })
    relights(pico, 3000)
    check(!pico.uart.includes('error'), pico.uart)
    pico = Pico.after(pico, packages, uf2, { by: STARTED_BY.pin, watchdog: true })
    pico.watchdog.scratchData.fill(0)
    relights(pico, 3000)
    check(!pico.uart.includes('error'), pico.uart)
  }],
  ['one wrong bit of the map in flash is found, and shown for good', () => {
    pico = powered_up()
    pico.chip.flash[symbols.get('demo_map') - FLASH + 4 * 1234] ^= 1
    shows_fault(pico, MAP)
    check(!pico.run(() => pico.uart.includes('relighting'), 2300), 'it relights a damaged map')
    judge.same(look(pico), judge.fault(MAP), 'the picture, later')
  }],
  ['a computer may draw instead, and when it is gone the error is back', () => {
    const host = new UsbHost(pico), gud = new Gud(host)
    host.pulled_up = true
    host.enumerate()
    const pixels = picture565(width, height, 6)
    check(gud.begin(FORMAT.rgb565) && gud.draw({ x: 0, y: 0, width, height }, pixels), `refused with status ${gud.status()}`)
    pico.run(() => false, 1)
    judge.same(look(pico), shown565(pixels), 'its frame')
    host.reset()
    pico.run(() => false, 50)
    judge.same(look(pico), judge.fault(MAP), 'the picture')
  }],
  ['whatever happened, D/C never changed while a byte was sent', () => {
    equal(pico.wires.faults.length, 0, `faults, the first: ${pico.wires.faults[0]}`)
  }],
])
