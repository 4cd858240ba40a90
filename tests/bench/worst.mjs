// SPDX-License-Identifier: MIT
// The exact rectangle's worst lines (worst.h) on the emulated Cortex-M0+, and single functions' slowest inputs. worst FOLDER PART PARTS
// [PATTERN]: searches for those that worst.tsv does not have, or whose pixels are open no more, and prints what it holds: row, ambient red,
// green and blue, and x, y and z of a normal, or of four that pixels take in turn; under other lights, of each pixel its column and normal;
// of a function its input.
import { readFileSync } from 'node:fs'
import { boot } from './m0plus.mjs'
import { readScene } from './scene.mjs'
import { evaluationRows, slowestInput } from './evaluations.mjs'
import { loopRows } from './loops.mjs'

const N = 60, WIDTH = 320, SLOWEST = 80, MATERIALS = 2000, APART = 8, AMONG = 40, LINES = 400
const hasLights = (row) => row.look[6] !== 0
const phasesOf = (row) => row.look[3] ? 4 : 1 // dithered, a pixel's threshold is one of four in a line

// Exact rectangles of INT16 normals. Not searched: lines of soft edges, whose pixels are of two kinds, and the greys of
// few levels, of whose pixels too few are open.
export const worstRows = (machine) => loopRows(machine).filter(({ name, fill, shade, map, look }) =>
  fill === (machine.address('exact_fill') | 1) && shade === (machine.address('bench_rect') | 1) && !/coverage|grey4/.test(name) && map === 0 && look[7] === 0)
export const worstCalls = (machine) => evaluationRows(machine).filter(({ name }) => name.startsWith('glint'))

function begin(machine, row) {
  machine.call('bench_begin', [row.at, N])
  machine.call('worst_begin')
  machine.call('exact_fill')
  machine.call('bench_light')
}

const normalsOf = (machine) => machine.bytes(machine.address('bench_line'), 6 * WIDTH)
const put = (normals, x, [a, b, c]) => [a, b, c].forEach((value, k) => normals.writeInt16LE(value, 6 * x + 2 * k))

// The scene's normals, and the cycles of the lobe there, the most first.
function lobes(machine, scene) {
  const normals = normalsOf(machine), found = []
  for (let y = 0; y < scene.height; y++) {
    scene.maps[0].copy(normals, 0, 6 * y * WIDTH)
    for (let x = 0; x < WIDTH; x++) {
      if (!scene.covers(x, y)) continue
      const { cycles, value } = machine.call('worst_lobe', [machine.call('worst_t', [x]).value])
      if (value) found.push({ cycles, normal: [0, 2, 4].map((k) => normals.readInt16LE(6 * x + k)) })
    }
  }
  return found.sort((a, b) => b.cycles - a.cycles)
}

// For some ambient light, one of the slow normals for each place of the dither whose pixel is open.
function searchAmong(machine, phases, slow) {
  const normals = normalsOf(machine), open = machine.bytes(machine.address('worst_open'), WIDTH)
  const mask = machine.bytes(machine.address('bench_line') + 9 * WIDTH, WIDTH).fill(0, phases * slow.length)
  slow.forEach((normal, i) => { for (let phase = 0; phase < phases; phase++) put(normals, phases * i + phase, normal) })
  for (let i = 0; i < MATERIALS; i++) {
    const ambient = [1000 + 37 * i % 9973, 1000 + 53 * i % 9967, 1000 + 71 * i % 9949]
    machine.call('worst_material', ambient)
    machine.call('worst_count')
    const chosen = Array.from({ length: phases }, (_, phase) => slow.find((_, k) => open[phases * k + phase]))
    if (!chosen.every((x) => x)) continue
    mask.fill(255)
    return [...ambient, ...chosen.flat()]
  }
  mask.fill(255)
}

// What a light has of a pixel depends on its place: columns that are open with the normal that they have by chance.
function searchPlaces(machine, scene, row) {
  const covered = []
  for (let i = 0; i < scene.width * scene.height; i++) if (scene.covers(i % scene.width, i / scene.width | 0)) covered.push(i)
  const normals = normalsOf(machine), open = machine.bytes(machine.address('worst_open'), WIDTH), found = new Map()
  machine.call('worst_material', [1074, 1106, 1142])
  for (let line = 0, state = 1; line < LINES && found.size < AMONG; line++) {
    for (let x = 0; x < WIDTH; x++) {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0
      scene.maps[0].copy(normals, 6 * x, 6 * covered[Math.floor(state / 2 ** 32 * covered.length)])
    }
    machine.call('worst_count')
    for (let x = 0; x < WIDTH; x++) if (open[x] && found.size < AMONG) found.set(x, [0, 2, 4].map((k) => normals.readInt16LE(6 * x + k)))
  }
  if (found.size < APART) throw new Error(`${row.name}: ${found.size} of ${APART} open pixels were found`)
  const line = (pixels) => [1074, 1106, 1142, ...pixels.flat(2)]
  const cost = new Map([...found].map((pixel) => [pixel, measureWorst(machine, row, line([pixel]))]))
  return line([...cost].sort((a, b) => b[1] - a[1]).slice(0, APART).map(([pixel]) => pixel))
}

// Among the slowest first, then among more.
function search(machine, scene, row) {
  begin(machine, row)
  if (hasLights(row)) return searchPlaces(machine, scene, row)
  const found = lobes(machine, scene)
  for (const least of [.95, .8, .5, 0]) {
    const slow = found.filter(({ cycles }) => cycles >= least * found[0].cycles).slice(0, SLOWEST).map(({ normal }) => normal)
    const line = searchAmong(machine, phasesOf(row), slow)
    if (line) return line
  }
  throw new Error(`${row.name}: no line was found whose every pixel is open`)
}

export function readWorst() {
  const lines = readFileSync(new URL('worst.tsv', import.meta.url), 'utf8').trim().split('\n').filter((line) => line[0] !== '#')
  return new Map(lines.map((line) => line.split('\t')).map(([name, ...numbers]) => [name, numbers.map(Number)]))
}

// Puts the worst line there. Its pixels; are all of them open?
function place(machine, row, [red, green, blue, ...rest]) {
  begin(machine, row)
  machine.call('worst_material', [red, green, blue])
  const normals = normalsOf(machine), phases = phasesOf(row), mask = machine.bytes(machine.address('bench_line') + 9 * WIDTH, WIDTH)
  if (hasLights(row)) mask.fill(0)
  for (let i = 0; hasLights(row) && i < rest.length; i += 4) {
    put(normals, rest[i], rest.slice(i + 1, i + 4))
    mask[rest[i]] = 255
  }
  for (let x = 0; !hasLights(row) && x < WIDTH; x++) put(normals, x, rest.slice(3 * (x % phases), 3 * (x % phases) + 3))
  const pixels = hasLights(row) ? rest.length / 4 : WIDTH
  return { pixels, mask, holds: machine.call('worst_count').value === pixels }
}

// Cycles a pixel of the worst line; where its pixels are apart, without what the line takes with none.
export function measureWorst(machine, row, line) {
  const { pixels, mask, holds } = place(machine, row, line)
  if (!holds) throw new Error(`${row.name}: not all pixels of the worst line are open: make costs searches again`)
  const { cycles } = machine.call(row.shade)
  mask.fill(0)
  return (cycles - (hasLights(row) ? machine.call(row.shade).cycles : 0)) / pixels
}

// The share of the scene's pixels that are open.
export function measureOpen(machine, scene, row) {
  machine.call('bench_begin', [row.at, N])
  machine.call('exact_fill')
  machine.call('bench_light')
  let open = 0, covered = 0
  for (let y = 2; y < scene.height; y += 4) {
    scene.maps[0].copy(normalsOf(machine), 0, 6 * y * WIDTH)
    machine.call('bench_line_begin', [y])
    open += machine.call('worst_count').value
    for (let x = 0; x < WIDTH; x++) covered += scene.covers(x, y)
  }
  return open / covered
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const [folder, part, parts, match] = [process.argv[2], Number(process.argv[3]), Number(process.argv[4]), new RegExp(process.argv[5] ?? '')]
  const machine = boot(`${folder}/npm`, `${folder}/m0plus-O2.elf`), scene = readScene(`${folder}/scene`)
  const stored = readWorst(), mine = (row, i) => i % parts === part && match.test(`worst ${row.name} O2`)
  const print = (row, numbers) => console.log([row.name, ...numbers].join('\t'))
  for (const row of worstRows(machine).filter(mine))
    if (!stored.has(row.name) || !place(machine, row, stored.get(row.name)).holds) print(row, search(machine, scene, row))
  machine.call('evaluation_begin', [N])
  for (const row of worstCalls(machine).filter(mine)) if (!stored.has(row.name)) print(row, [slowestInput(machine, row, N)])
}
