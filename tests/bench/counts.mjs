// SPDX-License-Identifier: MIT
// What the machines of machine/ have counted (counts.txt, by count), and the sizes (sizes.txt, by sizes).
import { readFileSync } from 'node:fs'
import { line } from './print.mjs'

// Heads of columns, from a core's name: M3, RV32, AVR.
const short = (target) => target.replace(/^cortex-m0plus/, 'M0+').replace('cortex-', '').replace(/^atmega.*/, 'AVR')
  .replace(/^rv32.*/, 'RV32').replace(/^m/, 'M').replace(/f$/, 'F')
const unitOf = (target) => short(target) === 'AVR' ? 'cycles' : 'instructions'
const emulatorOf = (target) => short(target) === 'AVR' ? 'simavr' : 'QEMU -icount shift=0'

export function readCounts(file, q) {
  const figures = []
  for (const record of readFileSync(file, 'utf8').trim().split('\n')) {
    const [target, kind, name, ...fields] = record.split(';')
    const [n, ...numbers] = fields.map(Number)
    const common = { target, flags: '-O2', n, q, unit: unitOf(target), label: 'emulated', emulator: emulatorOf(target) }
    if (kind === 'evaluation') {
      const [samples, count] = numbers
      figures.push({ function: name, ...common, samples, mean: count / samples })
    } else if (kind === 'loop') {
      const [fill, frame, shade, pixels, covered] = numbers
      figures.push({ loop: name, ...common, per_frame_pixel: shade / pixels, per_covered_pixel: shade / covered,
        fill_per_material: fill, per_frame: frame })
    } else if (kind === 'mesh') {
      figures.push({ mesh: name, ...common, per_picture: numbers[0] })
    }
  }
  return figures
}

export function printCounts(figures) {
  const find = (wanted) => figures.find((x) => Object.entries(wanted).every(([key, value]) => x[key] === value))
  const heads = [...new Set(figures.map((x) => x.target))].flatMap((target) =>
    (['M3', 'AVR'].includes(short(target)) ? [10, 60, 1000] : [60]).map((n) => [target, n, `${short(target)} ${n}`]))
  const table = (key, figure) => {
    line('', heads.map(([, , head]) => head), '', 10)
    for (const name of new Set(figures.map((x) => x[key]).filter((x) => x))) {
      line(name, heads.map(([target, n]) => {
        const found = find({ [key]: name, target, n })
        return found ? figure(found).toFixed(figure(found) < 100 ? 1 : 0) : '-'
      }), '', 10)
    }
  }
  console.log('\nOther cores, -O2, by n. M3, M4F, RV32: instructions, not cycles [emulated: QEMU -icount]: a division, a load or a taken')
  console.log('branch counts as 1 (on M3 and M4F a 32-bit division takes 2-12 cycles, a float one 14, a load 2, a taken branch 2-4).')
  console.log('M4F has float in hardware. AVR: cycles of an ATmega2560 [emulated: simavr]. Every clock is checked by a loop counted by')
  console.log('hand. One evaluation, without its call and return:')
  table('function', (x) => x.mean)
  console.log('\nA pixel of the sphere:')
  table('loop', (x) => x.per_covered_pixel)
  console.log('\nA picture of the teapot, as on the Cortex-M0+, in thousands:')
  table('mesh', (x) => x.per_picture / 1000)
}

export function readSizes(file) {
  return readFileSync(file, 'utf8').trim().split('\n').map((record) => {
    const [target, flags, bytes, name] = record.split(' ')
    return { function: name, target, flags, unit: 'bytes', label: 'linked', bytes: Number(bytes) }
  })
}

export function printSizes(sizes) {
  console.log('\nBytes of code and constants, linked alone with all it needs of the library, libgcc and libc [linked]')
  const columns = [...new Set(sizes.map((x) => `${x.target} ${x.flags}`))].map((x) => x.split(' '))
  line('', columns.map(([target, flags]) => short(target) + flags), '', 8, 64)
  for (const name of new Set(sizes.map((x) => x.function))) {
    line(name, columns.map(([target, flags]) =>
      sizes.find((x) => x.function === name && x.target === target && x.flags === flags).bytes), '', 8, 64)
  }
}
