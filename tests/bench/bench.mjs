// SPDX-License-Identifier: MIT
// bench FOLDER: calls the functions in FOLDER's programs, counts, prints tables, and writes FOLDER/*.json. Every figure has a
// label: emulated, predicted (from what is emulated, by a model that the table's foot states) or linked (sizes).
// bench FOLDER PATTERN: prints the Cortex-M0+'s rows whose names match, for n = 60; PATTERN N...: for these n.
import { writeFileSync } from 'node:fs'
import { boot } from './m0plus.mjs'
import { readScene } from './scene.mjs'
import { evaluations, printEvaluations } from './evaluations.mjs'
import { loops, printLoops } from './loops.mjs'
import { LIT_MESHES, MESHES, WIDGETS, printLitMeshes, printMeshes, printWidgets } from './mesh.mjs'
import { printCounts, printSizes, readCounts, readSizes } from './counts.mjs'
import { FLASH_FOOT } from './flash.mjs'

process.on('uncaughtException', (error) => {
  console.error(`bench: ${process.env.BENCH_DEBUG ? error.stack : error.message}`)
  process.exit(1)
})

const [, , folder, pattern, ...shininesses] = process.argv
const scene = readScene(`${folder}/scene`)
const machines = Object.fromEntries(Object.entries({ '-O2': 'O2', '-Os': 'Os', '-O2 asm': 'asm' }).map(([flags, name]) =>
  [flags, boot(`${folder}/npm`, `${folder}/m0plus-${name}.elf`)]))
const meshMachines = (program) => Object.fromEntries(['O2', 'asm'].map((name) => [name, boot(`${folder}/npm`, `${folder}/${program}-${name}.elf`)]))
const showMeshes = (meshes, lit, widgets) => {
  const builds = meshMachines('mesh')
  if (meshes.length) printMeshes(builds, meshes)
  if (lit.length) printLitMeshes(builds.O2, lit)
  if (widgets.length) printWidgets(meshMachines('lvgl'), widgets)
}
if (pattern !== undefined) {
  const match = new RegExp(pattern), wanted = [...new Set([60, ...shininesses.map(Number)])]
  const cycles = evaluations(machines, scene, match, wanted), pixels = loops(machines, scene, match, wanted)
  const [meshes, lit, widgets] = [MESHES, LIT_MESHES, WIDGETS].map((rows) => rows.filter(([name]) => match.test(name)))
  if (!cycles.length && !pixels.length && !meshes.length && !lit.length && !widgets.length) throw new Error(`no row's name matches ${pattern}`)
  if (cycles.length) printEvaluations(cycles, scene)
  if (pixels.length) printLoops(pixels, scene)
  if (meshes.length || lit.length || widgets.length) showMeshes(meshes, lit, widgets)
  process.exit(0)
}
const write = (name, data) => writeFileSync(`${folder}/${name}.json`, JSON.stringify(data, null, 1) + '\n')

const { '-O2': o2, '-Os': os } = machines
const cycles = evaluations({ '-O2': o2, '-Os': os }, scene)
write('cycles', cycles)
printEvaluations(cycles, scene)
const pixels = loops(machines, scene)
write('loops', pixels)
printLoops(pixels, scene)
console.log('\n' + FLASH_FOOT)
showMeshes(MESHES, LIT_MESHES, WIDGETS)
const counts = readCounts(`${folder}/counts.txt`, scene.q)
write('counts', counts)
printCounts(counts)
const sizes = readSizes(`${folder}/sizes.txt`)
write('sizes', sizes)
printSizes(sizes)
if (!cycles.some((x) => x.function.endsWith('_fixmath'))) {
  console.log("\nlibfixmath is left out on the targets: Debian's source package could not be had.")
}
