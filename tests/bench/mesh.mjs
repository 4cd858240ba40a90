// SPDX-License-Identifier: MIT
// Meshes on the emulated Cortex-M0+: cycles of a frame, strip by strip.
const SIZE = 240, LINES = 16, EMPTY = 0x5a // no pixel of the material is 5a5a

// Rows of costs.tsv: mesh.c's meshes and ways; the assembly is for tables.
const TABLES = 0, EXACT = 1, GOURAUD = 2, DARK = 3, POINT = 4, TEXTURED = 8, SMOOTH = 9, TEXTURED_EXACT = 10, TEXTURED_FAR = 11, COLOURED = 12
export const MESHES = [['mesh teapot', 0, TABLES], ['mesh teapot split', 1, TABLES], ['mesh teapot exact', 0, EXACT],
  ['mesh teapot split exact', 1, EXACT], ['mesh teapot gouraud', 0, GOURAUD], ['mesh teapot split gouraud', 1, GOURAUD], ['mesh bunny', 3, TABLES],
  ['mesh teapot, 18 kept', 2, TABLES], ['mesh teapot exact, 18 kept', 2, EXACT],
  ['mesh teapot outlines', 4, TABLES], ['mesh teapot exact outlines', 4, EXACT],
  ['mesh teapot textured', 0, TEXTURED], ['mesh teapot textured, bilinear', 0, SMOOTH], ['mesh teapot coloured', 0, COLOURED],
  ['mesh teapot textured, perspective', 0, TEXTURED_FAR], ['mesh teapot textured exact', 0, TEXTURED_EXACT]]
// Under points: beside no light, and beside rectangles of the same normals.
export const LIT_MESHES = [['mesh teapot point', 0, POINT], ['mesh teapot two points', 0, POINT + 1],
  ['mesh teapot three points', 0, POINT + 2], ['mesh teapot four points', 0, POINT + 3],
  ['mesh teapot split point', 1, POINT]]
// LVGL's object beside glint's own calls with the same strips: lines of a strip, by tables, exactly.
export const WIDGETS = [['mesh teapot in LVGL', 16, TABLES], ['mesh teapot in LVGL, strips of 10', 10, TABLES], ['mesh teapot exact in LVGL', 16, EXACT]]
export const hasAssembly = ([, , way]) => way === TABLES || way === TEXTURED || way === SMOOTH || way === TEXTURED_FAR || way === COLOURED

const caller = (machine, name, which) => (step, argument) => {
  const { cycles, value } = machine.call(step, [argument])
  if (value) throw new Error(`${name}: ${step} returned an error${which === 3 ? '; has make setup-rp2040js installed the bunny?' : ''}`)
  return cycles
}

export function measureMesh(machine, [name, which, way]) {
  const call = caller(machine, name, which)
  const out = machine.bytes(machine.address('mesh_out'), 2 * SIZE * LINES)
  call('mesh_begin', way)
  call('mesh_clothe', which)
  let cycles = call('mesh_frame', which), covered = 0
  for (let y = 0; y < SIZE; y += LINES) {
    out.fill(EMPTY)
    cycles += call('mesh_strip', y)
    for (let i = 0; i < out.length; i += 2) covered += out[i] !== EMPTY || out[i + 1] !== EMPTY
  }
  return { cycles, covered: covered / SIZE / SIZE, memory: machine.call('mesh_memory_bytes', [way, which]).value }
}

// Cycles a covered pixel: what a frame takes more under the lights than under none, and glint_draw_rect under them for the same normals.
export function measureLitMesh(machine, [name, which, way]) {
  const call = caller(machine, name, which)
  const dark = measureMesh(machine, [name, which, DARK]), lit = measureMesh(machine, [name, which, way])
  const pixels = lit.covered * SIZE * SIZE
  call('mesh_frame', which)
  let rect = 0
  for (let y = 0; y < SIZE; y += LINES) {
    call('mesh_normals', y)
    rect += call('mesh_rect', y)
  }
  return { light: (lit.cycles - dark.cycles) / pixels, rect: rect / pixels }
}

// Cycles of a frame, whose pixels must be the same.
export function measureWidget(machine, [name, lines, way]) {
  const call = (step, ...args) => {
    const { cycles, value } = machine.call(step, args)
    if (value) throw new Error(`${name}: ${step} returned error ${value}`)
    return cycles
  }
  const out = machine.bytes(machine.address('lvgl_out'), 2 * SIZE * lines)
  const frame = (which) => {
    const strips = []
    let cycles = call(`${which}_frame`)
    for (let y = 0; y < SIZE; y += lines) {
      out.fill(EMPTY)
      cycles += call(`${which}_strip`, y, lines)
      strips.push(Buffer.from(out))
    }
    return { cycles, picture: Buffer.concat(strips) }
  }
  call('lvgl_begin', way)
  const widget = frame('lvgl'), bare = frame('lvgl_bare')
  if (!widget.picture.equals(bare.picture)) throw new Error(`${name}: LVGL's object draws other pixels`)
  return { widget: widget.cycles, bare: bare.cycles }
}

export function printWidgets(machines, rows) {
  console.log('\nLVGL\'s object glint_lvgl_mesh on Cortex-M0+ [emulated: rp2040js], LVGL itself left out: thousands of cycles a frame, a new pose, and a')
  console.log('strip an event, beside glint\'s own calls with the same strips and the same memory, with places for all triangles that go on; and what it takes more.')
  for (const [build, machine] of Object.entries(machines))
    for (const row of rows.filter((row) => build !== 'asm' || hasAssembly(row))) {
      const { widget, bare } = measureWidget(machine, row), name = build === 'asm' ? `${row[0]}, asm` : row[0]
      console.log(`${name.padEnd(38)} ${(widget / 1000).toFixed(0).padStart(7)} ${(bare / 1000).toFixed(0).padStart(7)} ${(100 * (widget / bare - 1)).toFixed(2).padStart(7)} %`)
    }
}

export function printMeshes(machines, rows) {
  console.log('\nMeshes on Cortex-M0+ [emulated: rp2040js], code and meshes in SRAM, no hardware divider, -O2: 240x240 RGB565, n = 60, strips of 16')
  console.log('lines, clearing of depths included, of pixels not. Thousands of cycles a frame; frames a second at 125 MHz for these alone;')
  console.log('KB of RAM with two strips, depths and places for 50 triangles that go on, or 18. Gouraud: grey, one brightness a vertex.')
  for (const [build, machine] of Object.entries(machines))
    for (const row of rows.filter((row) => build !== 'asm' || hasAssembly(row))) {
      const { cycles, covered, memory } = measureMesh(machine, row)
      const name = build === 'asm' ? `${row[0]}, asm` : row[0]
      console.log(`${name.padEnd(30)} ${(cycles / 1000).toFixed(0).padStart(7)} ${(125e6 / cycles).toFixed(1).padStart(6)}   on ${(100 * covered).toFixed(0)} %, ${(memory / 1000).toFixed(1)} KB`)
    }
}

export function printLitMeshes(machine, rows) {
  console.log('\nMeshes under lights, exactly, -O2: cycles a covered pixel that a frame takes more than under no light, beside those of')
  console.log('glint_draw_rect for the same normals and lights, over a coverage map.')
  for (const row of rows) {
    const { light, rect } = measureLitMesh(machine, row)
    console.log(`${row[0].padEnd(30)} ${light.toFixed(0).padStart(7)} ${rect.toFixed(0).padStart(7)}   ${(light / rect).toFixed(2)}`)
  }
}
