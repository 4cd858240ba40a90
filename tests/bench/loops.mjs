// SPDX-License-Identifier: MIT
// Loops over pixels on the emulated Cortex-M0+: line by line over the scene, their cycles and their pictures.
import { FORMATS, LINE_BYTES, MODELS, SPACES, levels } from './scene.mjs'
import { FLASH_WORD, flashWaits } from './flash.mjs'
import { line } from './print.mjs'

const RGB888 = 2
const LOOK = 8, LIGHTS = 6 // struct sphere_look (sphere.h)'s bytes

// The program's bench_loops[] (loops.h).
export function loopRows(machine) {
  const list = []
  for (let at = machine.address('bench_loops'); machine.word(at); at += 40) {
    const [name, what] = [0, 4].map((i) => machine.text(machine.word(at + i)))
    const [fill, frame, pack, prepare, shade] = [8, 12, 16, 20, 24].map((i) => machine.word(at + i))
    const look = Array.from({ length: LOOK }, (_, i) => machine.byte(at + 28 + i))
    const [map, mapBytes, step, once] = [0, 1, 2, 3].map((i) => machine.byte(at + 28 + LOOK + i))
    list.push({ at, name, what, fill, frame, pack, prepare, shade, look, map, mapBytes, step: step || 1, once })
  }
  return list
}

// How far a picture is from another: over its channels, in levels of 255.
function difference() {
  let count = 0, sum = 0, squares = 0, largest = 0
  const add = (a, b) => a.forEach((x, k) => {
    const d = Math.abs(x - b[k])
    count++
    sum += d
    squares += d * d
    largest = Math.max(largest, d)
  })
  const result = () => ({ largest, mean: sum / count, psnr: squares ? 10 * Math.log10(255 ** 2 * count / squares) : null })
  return { add, result }
}

// The reads of a loop over tables, as if these and the maps lay in flash.
const TABLES_BYTES = 20608
const IN_FLASH = /^(colour int8( dither)?|colour span 16|albedo int8)$/ // showing each read takes time
function flashReads(machine, scene, row) {
  const mapLine = scene.maps[row.map].length / scene.height, [tables, maps] = [[], []]
  const [memory, albedo] = ['bench_memory', 'bench_albedo_565'].map(machine.address)
  const normals = machine.address(row.map === 0 ? 'bench_line' : 'bench_map'), data = Math.min(memory, normals, albedo)
  let y = -1 // no line is shaded
  const seen = (at) => {
    if (at < data || y < 0) return // an instruction: most are
    const inside = (from, length) => at >= from && at < from + length
    if (inside(memory, TABLES_BYTES)) {
      tables.push(at - memory)
      maps.push(at - memory)
    } else if (inside(normals, mapLine)) maps.push(0x10000 + y * mapLine + at - normals)
    else if (inside(albedo, 2 * scene.width)) maps.push(0x100000 + 2 * y * scene.width + at - albedo)
  }
  const line = (number, run) => {
    y = number
    try { return run() } finally { y = -1 }
  }
  return { seen, line, waits: () => [tables, maps].map(flashWaits) }
}

// lean: without the words of code that flash would deliver.
export function measureLoop(machine, scene, row, n, lean = false) {
  const { width, height } = scene
  const at = machine.address('bench_line')
  const normals = machine.bytes(at, 6 * width), out = machine.bytes(at + 6 * width, 3 * width)
  const map = scene.maps[row.map], mapLine = map.length / height
  const cycles = (step) => step ? machine.call(step).cycles : 0
  const [model, format, space, , ...maps] = row.look
  const exact = scene.exact(n, ...row.look), exact888 = scene.exact(n, model, RGB888, space, 0, ...maps)
  const same = difference(), deep = difference()
  const stride = width * LINE_BYTES[format]

  machine.call('bench_begin', [row.at, n])
  scene.palette.copy(machine.bytes(machine.address('bench_palette'), scene.palette.length))
  const fill = cycles(row.fill)
  const reads = n === 60 && IN_FLASH.test(row.name) ? flashReads(machine, scene, row) : null
  let frame = cycles(row.frame), shade = 0, pixels = 0, covered = 0
  const load = (y) => {
    scene.maps[0].copy(normals, 0, 6 * y * width)
    map.copy(machine.bytes(machine.address('bench_map'), 4 * width), 0, y * mapLine, (y + 1) * mapLine)
    machine.call('bench_line_begin', [y])
    cycles(row.pack)
  }
  const lines = () => {
    for (let y = row.step >> 1; y < height; y += row.step) {
      load(y)
      frame += row.step * cycles(row.prepare)
      shade += reads ? reads.line(y, () => cycles(row.shade)) : cycles(row.shade)
      for (let x = 0; x < width; x++) {
        pixels++
        if (!scene.covers(x, y)) continue
        covered++
        const found = levels(format, out, x)
        same.add(found, levels(format, exact.subarray(y * stride), x))
        if (found.length === 3) deep.add(found, levels(RGB888, exact888.subarray(3 * y * width), x))
      }
    }
  }
  if (reads) machine.watched(reads.seen, lines)
  else lines()
  const words = lean ? 0 : machine.touched((call) => {
    for (const y of [height / 3 | 0, height / 2]) { // through the highlight, and where it is not
      load(y)
      cycles(row.prepare)
      call(row.shade)
    }
  })
  if (machine.half(machine.address('bench_error'))) throw new Error(`${row.name}, n = ${n}: a call returned an error`)
  const [tablesWait, mapsWait] = reads?.waits() ?? [0, 0]
  const flash = reads && { tables: (shade + tablesWait) / covered, maps: (shade + mapsWait) / covered }
  return { fill, frame, shade, pixels, covered, words, flash, quality: same.result(), rgb888_psnr: deep.result().psnr }
}

// Rows whose pixels have no highlight, one that depends on their place, or one elsewhere have no sides.
export const hasSides = (row) => row.look[LIGHTS] === 0 && row.map < 2 && MODELS[row.look[0]] !== 'phong'
// Rows of which each scene is drawn.
export const HAS_SCENES = /^(exact rect|colour int8)$/

// Cycles a covered pixel of lines of a scene (sphere.h).
export function measureScene(machine, scene, row, n, which) {
  const { width } = scene, at = machine.address('bench_line'), normals = machine.bytes(at, 6 * width)
  const lines = scene.lines(which, row.map), all = lines[0].length, taken = /side$/.test(which) ? scene.sideLines : all
  const call = (step) => step ? machine.call(step).cycles : 0
  machine.call('bench_begin', [row.at, n])
  call(row.fill)
  call(row.frame)
  let cycles = 0, pixels = 0
  for (let i = 0; i < taken; i++) {
    const k = Math.floor((i + .5) * all / taken)
    lines[0][k].copy(normals)
    if (row.map) lines[1][k].copy(machine.bytes(machine.address('bench_map'), lines[1][k].length))
    machine.call('bench_line_begin', [Math.floor((k + .5) * scene.height / all)])
    call(row.pack)
    call(row.prepare)
    cycles += call(row.shade)
    pixels += machine.bytes(machine.address('bench_line') + 9 * width, width).reduce((sum, x) => sum + (x ? 1 : 0), 0)
  }
  if (machine.half(machine.address('bench_error'))) throw new Error(`${row.name}, ${which}: a call returned an error`)
  return cycles / pixels
}

function figuresOf(row, flags, n, scene, { fill, frame, shade, pixels, covered, words, flash, quality, rgb888_psnr }) {
  const [model, format, space, dither, albedo, gloss] = row.look
  const common = { loop: row.name, what: row.what, target: 'cortex-m0plus', flags, n, q: scene.q, model: MODELS[model],
    format: FORMATS[format], space: SPACES[space], albedo: !!albedo, gloss: !!gloss, dither: !!dither, unit: 'cycles' }
  const map = FLASH_WORD * row.mapBytes / 4
  const frame_pixels = scene.width * scene.height
  const cold = shade / covered + FLASH_WORD * words / scene.covered
  return [
    { ...common, label: 'emulated', per_frame_pixel: shade / pixels, per_covered_pixel: shade / covered,
      fill_per_material: fill, per_frame: frame, lines: pixels / scene.width, quality, rgb888_psnr },
    { ...common, label: 'predicted', words, map_bytes: row.mapBytes, per_covered_pixel_code_in_flash: cold,
      per_frame_pixel_code_in_flash: shade / pixels + FLASH_WORD * words / frame_pixels,
      per_covered_pixel_code_and_map_in_flash: cold + map,
      ...flash && { per_covered_pixel_tables_in_flash: flash.tables, per_covered_pixel_tables_and_maps_in_flash: flash.maps } }
  ]
}

// Rows whose name matches. -O2 for every n, or those wanted; -Os for n = 60; with assembly ("-O2 asm") what that makes another.
export function loops(machines, scene, match = /./, wanted = [60, ...scene.n.filter((x) => x !== 60)]) {
  const figures = []
  const of = (flags, row, n) => figures.find((x) => x.loop === row.name && x.flags === flags && x.n === n)
  for (const [flags, machine] of Object.entries(machines))
    for (const row of loopRows(machine).filter(({ name }) => match.test(name)))
      for (const n of flags === '-Os' || row.once ? [60] : wanted) {
        const asm = flags === '-O2 asm'
        if (asm && n !== 60 && !of(flags, row, 60)) continue
        const measured = measureLoop(machine, scene, row, n)
        if (asm && n === 60 && measured.shade / measured.pixels === of('-O2', row, 60).per_frame_pixel) continue
        figures.push(...figuresOf(row, flags, n, scene, measured))
      }
  return figures
}

export function printLoops(figures, scene) {
  const find = (wanted) => figures.find((x) => Object.entries(wanted).every(([key, value]) => x[key] === value))
  const part = (100 * scene.covered / scene.width / scene.height).toFixed(1)
  console.log(`\nCycles a pixel on Cortex-M0+ [emulated: rp2040js], code, maps and output in SRAM, -O2 but where said: a sphere on ${part} %`)
  console.log(`of ${scene.width}x${scene.height}, light (1, 1, 1), q = ${scene.q}, RGB565 but where said. /frame: by all pixels of the frame, else by those of the`)
  console.log('sphere. fill: thousands of cycles once a material; frame: thousands once a frame. Flash [predicted]: code in flash; and')
  console.log('the map, too. Difference from the exact picture of the same model and format at n = 60, in levels of 255: largest, mean,')
  console.log('PSNR; 888: PSNR from the exact picture in RGB888 (rounding to RGB565 alone: see the exact loops).')
  const out = (name, cells, what) => line(name, cells, what, 7, 21)
  out('n', ['5', '10', '60', '200', '1000', '60-Os', '/frame', 'fill', 'frame', 'flash', '+map', 'max', 'mean', 'PSNR', '888'])
  const k = (x) => x ? (x / 1000).toFixed(x < 99500 ? 1 : 0) : '-'
  const px = (x) => x.toFixed(x < 100 ? 1 : 0)
  const db = (x) => x === null ? 'same' : x.toFixed(1)
  for (const { loop, what, flags } of figures.filter((x) => x.n === 60 && x.flags !== '-Os' && x.label === 'emulated')) {
    const at = (n, level = flags, label = 'emulated') => find({ loop, n, flags: level, label })
    const { per_frame_pixel, fill_per_material, per_frame, quality, rgb888_psnr } = at(60)
    const flash = at(60, flags, 'predicted'), asm = flags === '-O2 asm'
    const pixel = (figure) => figure ? px(figure.per_covered_pixel) : '-'
    out(asm ? `${loop}, asm` : loop, [...[5, 10, 60, 200, 1000].map((n) => pixel(at(n))),
      pixel(at(60, '-Os')), px(per_frame_pixel), k(fill_per_material), k(per_frame),
      px(flash.per_covered_pixel_code_in_flash), flash.map_bytes ? px(flash.per_covered_pixel_code_and_map_in_flash) : '-',
      quality.largest.toFixed(1), quality.mean.toFixed(2), db(quality.psnr), db(rgb888_psnr)], what)
  }
  printFlash(figures)
  const off = new Set(figures.filter((x) => x.quality?.psnr).map((x) => x.loop))
  if (!off.size || !figures.some((x) => x.n !== 60)) return
  console.log('\nDifference from the exact picture, in levels of 255: largest, mean, PSNR in dB [emulated]; all other loops: same')
  line('n', scene.n, '', 20, 21)
  for (const loop of off) {
    line(loop, scene.n.map((n) => {
      const found = find({ loop, n, flags: '-O2', label: 'emulated' })
      if (!found) return '-'
      const { largest, mean, psnr } = found.quality
      return `${largest.toFixed(1)} ${mean.toFixed(2)} ${db(psnr)}`
    }), '', 20, 21)
  }
}

function printFlash(figures) {
  const rows = figures.filter((x) => x.per_covered_pixel_tables_in_flash && x.flags !== '-Os')
  if (!rows.length) return
  console.log('\nThe same, n = 60, tables filled by glint table: cycles a covered pixel with these in SRAM [emulated], in flash, and in flash')
  console.log('with the normals and the albedo [predicted]')
  line('', ['SRAM', 'flash', '+maps'], '', 7, 21)
  for (const { loop, flags, ...flash } of rows) {
    const { per_covered_pixel } = figures.find((x) => x.loop === loop && x.flags === flags && x.n === 60 && x.label === 'emulated')
    const cells = [per_covered_pixel, flash.per_covered_pixel_tables_in_flash, flash.per_covered_pixel_tables_and_maps_in_flash]
    line(flags === '-O2 asm' ? `${loop}, asm` : loop, cells.map((x) => x.toFixed(1)), '', 7, 21)
  }
}
