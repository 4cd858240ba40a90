// SPDX-License-Identifier: MIT
// profile FOLDER PATTERN: for the rows whose names match, the functions in which the Cortex-M0+'s cycles are spent, n = 60 [emulated].
// What the compiler put inline counts for its caller.
import { boot } from './m0plus.mjs'
import { readScene } from './scene.mjs'
import { loopRows, measureLoop } from './loops.mjs'
import { MESHES, hasAssembly, measureMesh } from './mesh.mjs'

const [, , folder, pattern] = process.argv
const match = new RegExp(pattern)
const LEAST = .005 // of all cycles: functions with less are added up

// The machine's calls of what is named count cycles by function.
function watch(machine, names) {
  const plain = machine.call, found = new Map()
  machine.call = (name, args) => names.includes(name) ? machine.profiled(found, name, args) : plain(name, args)
  return () => {
    machine.call = plain
    return [...found].sort((a, b) => b[1] - a[1])
  }
}

function print(title, found, unit, per) {
  const all = found.reduce((sum, [, cycles]) => sum + cycles, 0), small = found.filter(([, cycles]) => cycles < LEAST * all)
  const rest = small.reduce((sum, [, cycles]) => sum + cycles, 0)
  const rows = found.filter((x) => !small.includes(x)).concat(small.length ? [[`${small.length} more`, rest]] : [])
  console.log(`\n${title}: ${unit} [emulated]`)
  for (const [name, cycles] of [...rows, ['all', all]]) {
    console.log(`${(cycles / per).toFixed(1).padStart(9)} ${(100 * cycles / all).toFixed(1).padStart(5)} %  ${name}`)
  }
}

try {
  let any = false
  for (const [variant, flags] of [['O2', '-O2'], ['asm', '-O2, assembly']]) {
    const machine = boot(`${folder}/npm`, `${folder}/m0plus-${variant}.elf`), scene = readScene(`${folder}/scene`)
    for (const row of loopRows(machine).filter(({ name }) => match.test(name))) {
      const profile = watch(machine, [row.shade])
      const { covered } = measureLoop(machine, scene, row, 60, true)
      print(`${row.name}, ${flags}`, profile(), 'cycles a covered pixel', covered)
      any = true
    }
    const meshes = MESHES.filter((row) => match.test(row[0]) && (variant === 'O2' || hasAssembly(row)))
    const drawer = meshes.length && boot(`${folder}/npm`, `${folder}/mesh-${variant}.elf`)
    for (const row of meshes) {
      const profile = watch(drawer, ['mesh_frame', 'mesh_strip'])
      measureMesh(drawer, row)
      print(`${row[0]}, ${flags}`, profile(), 'thousands of cycles a frame', 1000)
      any = true
    }
  }
  if (!any) throw new Error(`no row's name matches ${pattern}`)
} catch (error) {
  console.error(`profile: ${error.message}`)
  process.exit(1)
}
