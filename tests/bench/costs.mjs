// SPDX-License-Identifier: MIT
// costs FOLDER PART PARTS [PATTERN]: the figures of the committed table (tests/bench/costs.tsv) that are emulated on the Cortex-M0+, or
// one part of them, so that parts run side by side. PATTERN: of rows that it matches as "loop exact rect asm" (call, loop, mesh, worst)
// alone. Lines: number, kind, name, build, n, value; the number is the line's place
// in the whole, 10 apart. Emulated cycles are the same on every computer, however busy it is.
import { boot } from './m0plus.mjs'
import { readScene } from './scene.mjs'
import { evaluationRows, measureEvaluation, measureInput } from './evaluations.mjs'
import { HAS_SCENES, hasSides, loopRows, measureLoop, measureScene } from './loops.mjs'
import { LIT_MESHES, MESHES, WIDGETS, hasAssembly, measureLitMesh, measureMesh, measureWidget } from './mesh.mjs'
import { measureOpen, measureWorst, readWorst, worstRows } from './worst.mjs'

process.on('uncaughtException', (error) => {
  console.error(`costs: ${error.message}`)
  process.exit(1)
})

// What the library has assembly for, and of which loops other n than 60 are stated.
const ASSEMBLY = /^(exact (rect( steps)?|albedo|brushed|spun|grain map|shininess|coverage( all)?|span 16|span 64( steps)?)|colour (int8|span 16|span 64)( dither| coverage| coverage all)?|albedo (int8|span 16)|palette|exact linear( 888| steps)?)$/
const SHININESSES = { 'exact rect': [5, 1000], 'exact rect steps': [1000], 'albedo int8': [5] }

const [folder, part, parts, match] = [process.argv[2], Number(process.argv[3]), Number(process.argv[4]), new RegExp(process.argv[5] ?? '')]
const scene = readScene(`${folder}/scene`)
const worst = readWorst()
const machines = Object.fromEntries(['O2', 'asm'].map((build) => [build, boot(`${folder}/npm`, `${folder}/m0plus-${build}.elf`)]))

function evaluation(row, n) {
  machines.O2.call('evaluation_begin', [n])
  const { mean, max } = measureEvaluation(machines.O2, row, n, scene.samples.get(n), true)
  const input = worst.get(row.name)
  return [['call', mean.toFixed(0)], ['slowest', max], ...input ? [['worst input', Math.max(max, measureInput(machines.O2, row, n, input[0]))]] : []]
}

function loop(build, row, n) {
  const { fill, frame, shade, pixels, covered, flash, quality } = measureLoop(machines[build], scene, row, n, true)
  const figures = [['pixel', (shade / covered).toFixed(1)]]
  if (n !== 60) return figures
  figures.push(['frame pixel', (shade / pixels).toFixed(1)])
  if (hasSides(row))
    for (const side of ['outside', 'inside']) figures.push([side, measureScene(machines[build], scene, row, n, side).toFixed(1)])
  if (flash) figures.push(['tables in flash', flash.tables.toFixed(1)], ['maps in flash', flash.maps.toFixed(1)])
  if (build === 'asm') return figures
  if (fill) figures.push(['fill', fill])
  if (frame) figures.push(['frame', frame])
  return [...figures, ['largest', quality.largest.toFixed(1)], ['mean', quality.mean.toFixed(2)]]
}

function worstLine(row) {
  if (!worst.has(row.name)) throw new Error(`${row.name} is not in worst.tsv: make costs`)
  return [['open', (100 * measureOpen(machines.O2, scene, row)).toFixed(2)],
    ['worst', measureWorst(machines.O2, row, worst.get(row.name)).toFixed(0)]]
}

const jobs = evaluationRows(machines.O2).filter(({ name }) => !name.endsWith('_fixmath')).map((row) => ['call', row.name, 'O2', 60, () => evaluation(row, 60)])
for (const build of ['O2', 'asm']) {
  for (const row of loopRows(machines[build])) {
    if (build === 'asm' && !ASSEMBLY.test(row.name)) continue
    for (const n of HAS_SCENES.test(row.name) ? scene.sceneN : [])
      jobs.push(['scene', row.name, build, n, () => scene.scenes.filter((which) => !which.endsWith('side')).map((which) =>
        [which, measureScene(machines[build], scene, row, n, which).toFixed(1)])])
    for (const n of [60, ...SHININESSES[row.name] ?? []]) jobs.push(['loop', row.name, build, n, () => loop(build, row, n)])
  }
}
for (const build of ['O2', 'asm']) {
  const machine = boot(`${folder}/npm`, `${folder}/mesh-${build}.elf`)
  for (const row of MESHES.filter((row) => hasAssembly(row) || build === 'O2')) {
    jobs.push(['mesh', row[0], build, 60, () => {
      const { cycles, memory } = measureMesh(machine, row)
      return build === 'O2' ? [['frame', cycles], ['memory', memory]] : [['frame', cycles]]
    }])
  }
  for (const row of WIDGETS.filter((row) => hasAssembly(row) || build === 'O2')) {
    jobs.push(['mesh', row[0], build, 60, () => {
      const { widget, bare } = measureWidget(boot(`${folder}/npm`, `${folder}/lvgl-${build}.elf`), row)
      return [['frame', widget], ['bare', bare]]
    }])
  }
  for (const row of build === 'O2' ? LIT_MESHES : []) {
    jobs.push(['mesh', row[0], build, 60, () => {
      const { light, rect } = measureLitMesh(machine, row)
      return [['light', light.toFixed(1)], ['rect', rect.toFixed(1)]]
    }])
  }
}
for (const row of worstRows(machines.O2)) jobs.push(['worst', row.name, 'O2', 60, () => worstLine(row)])
jobs.forEach(([group, name, build, n, run], i) => {
  if (i % parts !== part || !match.test(`${group} ${name} ${build}`)) return
  run().forEach(([kind, value], k) => console.log([10 * i + k, kind, name, build, n, value].join('\t')))
})
