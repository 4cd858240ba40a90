// SPDX-License-Identifier: MIT
// Meshes on the emulated Cortex-M0+: cycles of a frame, strip by strip.
const SIZE = 240, LINES = 16, EMPTY = 0x5a // no pixel of the material is 5a5a

// Rows of costs.tsv: mesh.c's meshes and paths.
export const MESHES = [['mesh teapot', 0, 0], ['mesh teapot split', 1, 0], ['mesh teapot exact', 0, 1], ['mesh teapot split exact', 1, 1]]

export function measureMesh(machine, [name, which, exact]) {
  const call = (step, argument) => {
    const { cycles, value } = machine.call(step, [argument])
    if (value) throw new Error(`${name}: ${step} returned an error`)
    return cycles
  }
  const out = machine.bytes(machine.address('mesh_out'), 2 * SIZE * LINES)
  call('mesh_begin', exact)
  let cycles = call('mesh_frame', which), covered = 0
  for (let y = 0; y < SIZE; y += LINES) {
    out.fill(EMPTY)
    cycles += call('mesh_strip', y)
    for (let i = 0; i < out.length; i += 2) covered += out[i] !== EMPTY || out[i + 1] !== EMPTY
  }
  return { cycles, covered: covered / SIZE / SIZE }
}

export function printMeshes(machines, rows) {
  console.log('\nMeshes on Cortex-M0+ [emulated: rp2040js], code and meshes in SRAM, no hardware divider, -O2: 240x240 RGB565, n = 60, strips of 16')
  console.log('lines, clearing of depths included, of pixels not. Thousands of cycles a frame; frames a second at 125 MHz for these alone.')
  for (const [build, machine] of Object.entries(machines))
    for (const row of rows) {
      const { cycles, covered } = measureMesh(machine, row)
      const name = build === 'asm' ? `${row[0]}, asm` : row[0]
      console.log(`${name.padEnd(30)} ${(cycles / 1000).toFixed(0).padStart(7)} ${(125e6 / cycles).toFixed(1).padStart(6)}   on ${(100 * covered).toFixed(0)} %`)
    }
}
