// SPDX-License-Identifier: MIT
// bench FOLDER: calls the functions in FOLDER's programs for the pixels of a highlight, counts, and prints a table.
import { readFileSync, writeFileSync } from 'node:fs'
import { boot } from './m0plus.mjs'
import { highlight } from './scene.mjs'
import { real } from './real.mjs'

process.on('uncaughtException', ({ message }) => {
  console.error(`bench: ${message}`)
  process.exit(1)
})

const folder = process.argv[2]
const Q = 8
const SHININESS = [60, 10, 200, 1000]
const LEVELS = ['O2', 'Os']

// [function, what it takes, the model it stands for, what it is]
const FUNCTIONS = [
  ['glint_msh', 'c', 'msh', 'exact'],
  ['glint_msh_t', 't', 'msh', 'exact'],
  ['glint_schlick', 'c', 'schlick', 'exact'],
  ['glint_schlick_t', 't', 'schlick', 'exact'],
  ['glint_cayley', 'c', 'cayley', 'exact'],
  ['glint_cayley_t', 't', 'cayley', 'exact'],
  ['glint_blinn', 'c', 'blinn', 'exact'],
  ['glint_blinn_t', 't', 'blinn', 'within .501 ulp'],
  ['glint_gauss', 'c', 'gauss', 'exact'],
  ['glint_gauss_t', 't', 'gauss', 'within .501 ulp'],
  ['glint_lobe_eval_t', 'lobe', 'msh', 'MSH, with its cutoff'],
  ['peer_msh_float', 'float', 'msh', 'float, libgcc'],
  ['peer_schlick_float', 'float', 'schlick', 'float, libgcc'],
  ['peer_blinn_powf', 'float', 'blinn', 'float, newlib'],
  ['peer_table', 'c', 'blinn', '256 powers, the nearest below']
]

const floatBits = (x) => new Uint32Array(Float32Array.of(x).buffer)[0]
const floatOf = (bits) => new Float32Array(Uint32Array.of(bits).buffer)[0]

function measure(machine, [name, takes, model], n, pixels) {
  const first = takes === 'float' ? floatBits(n) : takes === 'lobe' ? machine.address('bench_lobe') : n
  const cycles = []
  let worst = 0
  for (const { c, t } of pixels) {
    const second = takes === 'float' ? floatBits(c / 65536) : takes === 'c' ? c : t
    const result = machine.call(name, first, second)
    cycles.push(result.cycles)
    const value = takes === 'float' ? 65536 * floatOf(result.value) : result.value
    const t_true = takes === 'c' || takes === 'float' ? 1 - c / 65536 : t / 2 ** 30
    worst = Math.max(worst, Math.abs(value - 65536 * real[model](n, t_true)))
  }
  const mean = cycles.reduce((sum, x) => sum + x, 0) / cycles.length
  return { mean, min: Math.min(...cycles), max: Math.max(...cycles), samples: cycles.length, worst_ulp: worst }
}

const figures = []
for (const level of LEVELS) {
  const machine = boot(`${folder}/npm`, `${folder}/m0plus-${level}.elf`)
  for (const n of SHININESS) {
    const pixels = highlight(machine.call('glint_msh_cutoff', n, Q).value)
    machine.call('glint_lobe_init', machine.address('bench_lobe'), 0, n, Q)
    machine.call('peer_table_fill', n)
    for (const row of FUNCTIONS) {
      const figure = measure(machine, row, n, pixels)
      figures.push({ function: row[0], what: row[3], target: 'cortex-m0plus', flags: `-${level}`, n, q: Q, unit: 'cycles', label: 'emulated', ...figure })
    }
  }
}

const sizes = readFileSync(`${folder}/sizes.txt`, 'utf8').trim().split('\n').map((line) => {
  const [core, level, bytes, name] = line.split(' ')
  return { function: name, target: `cortex-${core}`, flags: `-${level}`, unit: 'bytes', label: 'linked', bytes: Number(bytes) }
})

const write = (name, data) => writeFileSync(`${folder}/${name}.json`, JSON.stringify(data, null, 1) + '\n')
write('cycles', figures)
write('sizes', sizes)

// ---- the table ----

const find = (list, wanted) => list.find((x) => Object.entries(wanted).every(([key, value]) => x[key] === value))
const line = (first, cells, last) => console.log(first.padEnd(36) + cells.map((x) => String(x).padStart(8)).join('') + '  ' + last)

console.log(`Cycles of one evaluation on Cortex-M0+ [emulated: rp2040js 1.4.1], without its call and return; code and data in`)
console.log(`SRAM. Over the pixels of a 320x240 sphere inside MSH's lobe, q = ${Q}. Worst: the largest error at n = 60, 2^-16.`)
line('n', ['60', 'min', 'max', '10', '200', '1000', '60 -Os', 'worst'], '')
for (const [name, , , what] of FUNCTIONS) {
  const at = (n, flags = '-O2') => find(figures, { function: name, n, flags })
  const { mean, min, max, worst_ulp } = at(60)
  const cells = [mean, min, max, at(10).mean, at(200).mean, at(1000).mean, at(60, '-Os').mean].map((x) => x.toFixed(0))
  line(name, [...cells, worst_ulp < 100 ? worst_ulp.toFixed(3) : worst_ulp.toFixed(0)], what)
}
console.log(`\nBytes of code and constants, linked alone with all it needs [linked]`)
const columns = ['m0plus', 'm3', 'm4'].flatMap((core) => ['Os', 'O2'].map((level) => ({ target: `cortex-${core}`, flags: `-${level}` })))
line('', columns.map(({ target, flags }) => target.replace('cortex-', '').replace('m0plus', 'm0+') + flags), '')
for (const name of new Set(sizes.map((x) => x.function))) {
  line(name, columns.map((column) => find(sizes, { function: name, ...column }).bytes), '')
}
console.log(`\nNot modelled: wait states of flash and cache misses (about 40 cycles an uncached word), contention on the bus.`)
