// SPDX-License-Identifier: MIT
// Single evaluations on the emulated Cortex-M0+: cycles over the pixels of a highlight, and the largest error.
import { FLASH_WORD } from './flash.mjs'
import { line } from './print.mjs'

const TAKES = ['c', 't', 'lobe', 'float'] // enum evaluation_takes
const CYCLES = 3e6 // emulated at most, about, for a row and n: fewer samples; but for costs.tsv's all of the library's

const floatBits = (x) => new Uint32Array(Float32Array.of(x).buffer)[0]
const floatOf = (bits) => new Float32Array(Uint32Array.of(bits).buffer)[0]

// The program's evaluations[] (evaluations.h).
export function evaluationRows(machine) {
  const list = []
  for (let at = machine.address('evaluations'); machine.word(at); at += 24) {
    const [name, what] = [0, 4].map((i) => machine.text(machine.word(at + i)))
    const run = [8, 12, 16].map((i) => machine.word(at + i)).find((x) => x)
    list.push({ name, what, run, takes: TAKES[machine.byte(at + 20)], model: machine.byte(at + 21) })
  }
  return list
}

const firstOf = (machine, takes, n) => takes === 'float' ? floatBits(n) : takes === 'lobe' ? machine.address('evaluation_lobe') : n

// Cycles at an input, and the slowest input found: every cosine there is, of t their images and random ones.
export const measureInput = (machine, { run, takes }, n, input) => machine.call(run, [firstOf(machine, takes, n), input]).cycles
export function slowestInput(machine, row, n) {
  let [most, at, state] = [0, 0, 1]
  for (let c = 0; c <= 65536; c++) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    const input = row.takes === 'c' ? c : Math.min(2 ** 30, 16384 * c + (state >>> 18) * (c & 1))
    const cycles = measureInput(machine, row, n, input)
    if (cycles > most) [most, at] = [cycles, input]
  }
  return at
}

// lean: without the words that flash would deliver.
export function measureEvaluation(machine, { name, run, takes }, n, samples, lean = false) {
  const first = firstOf(machine, takes, n)
  const second = ({ c, t }) => takes === 'float' ? floatBits(c / 65536) : takes === 'c' ? c : t
  const few = machine.call(run, [first, second(samples[0])]).cycles * samples.length / CYCLES
  const step = lean && name.startsWith('glint') ? 1 : Math.max(1, Math.ceil(few))
  const cycles = []
  const [values, ts] = [[], []]
  for (const sample of samples.filter((_, i) => i % step === 0)) {
    const result = machine.call(run, [first, second(sample)])
    cycles.push(result.cycles)
    values.push(takes === 'float' ? 65536 * floatOf(result.value) : result.value | 0)
    ts.push(takes === 'c' || takes === 'float' ? 1 - sample.c / 65536 : sample.t / 2 ** 30)
  }
  const mean = cycles.reduce((sum, x) => sum + x, 0) / cycles.length
  const middle = samples[samples.length >> 1]
  const words = lean ? 0 : machine.touched((call) => call(run, [first, second(middle)]))
  return { mean, min: Math.min(...cycles), max: Math.max(...cycles), samples: cycles.length, values, ts, words }
}

// Functions whose name matches.
export function evaluations(machines, scene, match = /./, wanted = scene.n) {
  const figures = []
  for (const [flags, machine] of Object.entries(machines))
    for (const n of wanted.filter((n) => flags === '-O2' || n === 60)) {
      machine.call('evaluation_begin', [n])
      for (const row of evaluationRows(machine).filter(({ name }) => match.test(name))) {
        const { words, values, ts, ...measured } = measureEvaluation(machine, row, n, scene.samples.get(n))
        const worst_ulp = Math.max(...scene.real(n, row.model, ts).map((real, i) => Math.abs(values[i] - 65536 * real)))
        const figure = { ...measured, worst_ulp }
        const common = { function: row.name, what: row.what, target: 'cortex-m0plus', flags, n, q: scene.q, unit: 'cycles' }
        figures.push({ ...common, label: 'emulated', ...figure })
        figures.push({ ...common, label: 'predicted', words, mean: figure.mean + FLASH_WORD * words })
      }
    }
  return figures
}

export function printEvaluations(figures, scene) {
  const find = (wanted) => figures.find((x) => Object.entries(wanted).every(([key, value]) => x[key] === value))
  console.log(`Cycles of one evaluation on Cortex-M0+ [emulated: rp2040js], without its call and return; code and data in`)
  console.log(`SRAM; -O2 but where said. Over the pixels of the sphere inside MSH's lobe, q = ${scene.q}. Worst: the largest error at`)
  console.log(`n = 60, 2^-16. Cold [predicted]: n = 60, the code and constants in flash and none of them in the cache.`)
  line('n', ['60', 'min', 'max', '5', '10', '200', '1000', '60 -Os', 'worst', 'cold'])
  for (const { function: name, what } of figures.filter((x) => x.n === 60 && x.flags === '-O2' && x.label === 'emulated')) {
    const at = (n, flags = '-O2', label = 'emulated') => find({ function: name, n, flags, label })
    const { mean, min, max, worst_ulp } = at(60)
    const cells = [mean, min, max, ...[at(5), at(10), at(200), at(1000), at(60, '-Os')].map((x) => x?.mean)]
    line(name, [...cells.map((x) => x?.toFixed(0) ?? '-'), worst_ulp.toFixed(worst_ulp < 100 ? 3 : 0),
      at(60, '-O2', 'predicted').mean.toFixed(0)], what)
  }
}
