// SPDX-License-Identifier: MIT
// host FOLDER COMPILER: prints what FOLDER/host.txt says as a table, and writes FOLDER/host.json.
import { readFileSync, writeFileSync } from 'node:fs'
import { cpus, loadavg } from 'node:os'

const [folder, compiler] = process.argv.slice(2)
const N = 60
const cpu = cpus()[0].model.trim()

const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1]
const figures = readFileSync(`${folder}/host.txt`, 'utf8').trim().split('\n').map((line) => {
  const [method, what, worst, elements, threads, ...runs] = line.split('\t')
  const speeds = runs.map(Number)
  return {
    method, what, n: N, worst_ulp: Number(worst), elements: Number(elements), threads: Number(threads),
    unit: 'Mpixel/s', label: 'hardware', cpu, compiler,
    median: median(speeds), min: Math.min(...speeds), max: Math.max(...speeds), runs: speeds
  }
})
writeFileSync(`${folder}/host.json`, JSON.stringify(figures, null, 1) + '\n')

const CACHE = Math.min(...figures.map((x) => x.elements)), MEMORY = Math.max(...figures.map((x) => x.elements))
const find = (method, elements, threads = 1) => figures.find((x) => x.method === method && x.elements === elements && x.threads === threads)
const number = (x) => x < 10 ? x.toFixed(2) : x.toFixed(0)
const speed = (x) => x ? `${number(x.median)} (${number(x.min)}..${number(x.max)})` : '-'
// How much faster two threads are, in memory: of each run, which measures one right after the other.
const gains = (method) => find(method, MEMORY, 2).runs.map((speed, k) => speed / find(method, MEMORY).runs[k])
const gain = (method) => median(gains(method)).toFixed(2)
const ratio = (a, b) => (find(a, MEMORY).median / find(b, MEMORY).median).toFixed(2)

console.log(`\nMpixel/s on this host [hardware: ${cpu}; ${compiler}], one thread, n = ${N}, float`)
console.log(`for the same instructions as the batch: median (least..most) of ${figures[0].runs.length} runs in turn. x 2: by two threads, in memory.`)
console.log('Worst: the largest error, 2^-16, for cosines from 1/2 on.')
const line = (name, cache, memory, of_copy, two, worst, what) => console.log(
  name.padEnd(20) + cache.padStart(20) + memory.padStart(20) + of_copy.padStart(8) + two.padStart(6) + worst.padStart(10) + '  ' + what)
line('', `${CACHE / 1024}K, in cache`, `${MEMORY / 1024 / 1024}M, in memory`, '/ copy', 'x 2', 'worst', '')
for (const { method, what, worst_ulp } of figures.filter((x) => x.elements === CACHE)) {
  const memory = find(method, MEMORY)
  line(method, speed(find(method, CACHE)), speed(memory), memory ? ratio(method, 'copy') : '-', memory ? gain(method) : '-',
    method === 'copy' ? '-' : worst_ulp.toFixed(3), what)
}
console.log(`In memory batch_msh runs at ${ratio('batch_msh', 'float_msh')} of float_msh, ` +
  `batch_schlick at ${ratio('batch_schlick', 'float_schlick')} of float_schlick,\nbatch_blinn at ` +
  `${ratio('batch_blinn', 'float_blinn')} and batch_gauss at ${ratio('batch_gauss', 'float_blinn')} of float_blinn, libmvec's powf.`)
const range = (method) => `${gain(method)} (${Math.min(...gains(method)).toFixed(2)}..${Math.max(...gains(method)).toFixed(2)})`
console.log(`Two threads take ${range('batch_msh')} times what one does through batch_msh, memcpy ${range('copy')}; ` +
  `${cpus().length} processors, load ${loadavg()[0].toFixed(1)}: above 0.5 others were at work, too.`)
