// SPDX-License-Identifier: MIT
// twins.mjs FOLDER: a mesh's functions in assembly beside those of C, in FOLDER's programs mesh-asm.elf and mesh-O2.elf, on an
// emulated Cortex-M0+. Random arguments, also at the ends of their ranges. A line each: name, calls, calls whose memory was unlike
// C's; then the same where the assembly gets another argument than C.
import { readFileSync } from 'node:fs'
import { load, RAM, RETURN } from '../bench/m0plus.mjs'

const folder = process.argv[2]
const [c, assembly] = ['O2', 'asm'].map((build) => load(`${folder}/npm`, `${folder}/mesh-${build}.elf`))
// Arguments and results: in an array that frames of meshes need and these functions do not, at one address in both programs.
const AT = Math.max(...[c, assembly].map((machine) => machine.address('mesh_memory'))) + 15 & ~15
// Where structs have their fields: GLINT_AT_DRAWN_MESH is FIELD.DRAWN_MESH.
const OFFSETS = readFileSync(new URL('../../lib/glint_offsets.h', import.meta.url), 'latin1')
const FIELD = Object.fromEntries([...OFFSETS.matchAll(/^#define GLINT_AT_(\w+) (\d+)\b/gm)].map(([, name, at]) => [name, +at]))
let seed = 1
function below(n) {
  seed = (Math.imul(seed, 1103515245) + 12345) >>> 0
  return Math.floor((seed >>> 8) / 16777216 * n)
}
const one = (...of) => of[below(of.length)]
const bits = (n) => below(2 ** Math.min(n, 16)) + 65536 * below(2 ** Math.max(n - 16, 0)) - 2 ** (n - 1) // signed
const int16 = () => one(below(65536) - 32768, below(65536) - 32768, 32767, -32768)

const RETURNS = /_triangle_set$|_vertices$|_strip$/ // a bool, or an error
function run(machine, name, args) {
  machine.enter(name, args.slice(0, 4))
  args.slice(4).forEach((value, i) => machine.memory.writeUInt32LE(value >>> 0, machine.core.SP - RAM + 4 * i))
  const end = machine.core.cycles + 1e8
  while (machine.core.PC !== RETURN) {
    machine.core.executeInstruction()
    if (machine.core.cycles > end) throw new Error(`${name} does not return`)
  }
  return machine.core.registers[0]
}

// Where what begins in mesh_memory may end: frame_memory lies behind it, and these functions do not use that.
function room(machine) {
  const end = machine.address('mesh_memory') + machine.size('mesh_memory'), frame = machine.address('frame_memory')
  return frame >= end && frame < end + 16 ? frame + machine.size('frame_memory') : end
}

// before: calls that have to return 0, or functions of a program and where the memory lies in it. unread: parts that need not be alike, from and to, or a function that lists some. change: of the memory, what is other in each
// program.
function after(machine, name, args, bytes, fault, { before = [], unread = [], change = () => {} } = {}) {
  if (AT + bytes.length > room(machine)) throw new Error('mesh_memory is too small')
  const at = AT - RAM
  bytes.copy(machine.memory, at)
  change(machine, at)
  if (fault >= 0) machine.memory[at + fault] ^= 0x11
  for (const call of before) {
    if (typeof call === 'function') call(machine, at)
    else if (run(machine, ...call)) throw new Error(`${call[0]} returned an error`)
  }
  const value = run(machine, name, args)
  if (fault >= 0) machine.memory[at + fault] ^= 0x11
  for (const [from, to] of unread.flatMap((part) => typeof part === 'function' ? part(machine, at) : [part])) machine.memory.fill(0, at + from, at + to)
  return `${RETURNS.test(name) ? value & 1 : ''} ${machine.memory.toString('latin1', at, at + bytes.length)}`
}

// A triangle's corners, and what is set up.
const V = 0x100, CORNERS = 0x200
function triangle() {
  const bytes = Buffer.alloc(0x1400), size = one(8, 40, 300, 4000, 32766), first = below(32767 - size)
  for (let k = 0; k < 3; k++) {
    const middle = below(3) ? (place) => place : (place) => place & ~15 | 8
    bytes.writeInt16LE(middle(first + below(size)), V + 16 * k)
    bytes.writeInt16LE(k && !below(8) ? bytes.readInt16LE(V + 2) : middle(first + below(size)), V + 16 * k + 2)
    bytes.writeUInt16LE(below(65536), V + 16 * k + 4)
    bytes.writeUInt32LE(below(2 ** one(20, 30)), V + 16 * k + 8)
    bytes.writeInt32LE(below(2 ** 31) - 2 ** 30, V + 16 * k + 12)
    bytes.writeUInt32LE(AT + V + 16 * k, CORNERS + 8 * k)
    bytes.writeUInt32LE(one(below(2 ** one(20, 28, 32)), below(2 ** 24), 2 ** 29), CORNERS + 8 * k + 4)
  }
  return [bytes, [AT, AT + CORNERS, below(3), below(2 ** one(28, 31))], V + 2]
}

// A frame, a mesh drawn, and the mesh.
const DRAWN = 0x40, MESH = 0xa0, FACES = 0x200, PLACES = 0x500, NORMALS = 0x700, VERTICES = 0x900, LINKS = 0xe00, BANDS = 0xf00, NORMALS16 = 0x1000
function frame(height, vertices, faces) {
  const bytes = Buffer.alloc(0x1400), address = (at, to) => bytes.writeUInt32LE(AT + to, at)
  bytes.writeUInt16LE(1 + below(2040), FIELD.FRAME_W)
  bytes.writeUInt16LE(height, FIELD.FRAME_W + 2)
  address(DRAWN + FIELD.DRAWN_MESH, MESH)
  address(DRAWN + FIELD.DRAWN_VERTICES, VERTICES)
  address(DRAWN + FIELD.DRAWN_LINKS, LINKS)
  address(DRAWN + FIELD.DRAWN_LINKS + 4, BANDS)
  address(MESH + FIELD.MESH_PLACES, PLACES)
  address(MESH + FIELD.MESH_NORMALS8, NORMALS)
  address(MESH + FIELD.MESH_FACES, FACES)
  bytes.writeUInt16LE(vertices, MESH + FIELD.MESH_VERTEX_COUNT)
  bytes.writeUInt16LE(faces, MESH + FIELD.MESH_VERTEX_COUNT + 2)
  for (let k = 0; k < 3 * faces; k++) bytes.writeUInt16LE(below(vertices), FACES + 2 * k)
  for (let k = 0; k < 3 * vertices; k++) {
    bytes.writeInt16LE(int16(), PLACES + 2 * k)
    bytes.writeInt8(below(255) - 127, NORMALS + k)
  }
  return bytes
}

function vertices() {
  const bytes = frame(1 + below(2040), 1 + below(20), 0)
  for (let k = 0; k < 6; k++) bytes.writeInt16LE(below(65535) - 32767, DRAWN + FIELD.DRAWN_LIGHT + 2 * k)
  for (let k = 0; k < 9; k++) bytes.writeInt16LE(one(below(18919) - 9459, 0), DRAWN + FIELD.DRAWN_LIGHT + 12 + 2 * k)
  for (let k = 0; k < 3; k++) bytes.writeInt16LE(one(int16(), below(200)), DRAWN + FIELD.DRAWN_LIGHT + 30 + 2 * k)
  bytes.writeUInt16LE(one(below(65536), below(4000), 16383, 16384, 65535), DRAWN + FIELD.DRAWN_SCALE)
  return [bytes, [AT, AT + DRAWN], PLACES + 1]
}

// Faces that have lines and an area, as those in lists have; some are of 16-bit normals.
function faces() {
  const bytes = frame(240, 20, 1), size = one(40, 300, 4000), first = below(4000)
  bytes.writeUInt32LE(below(2) && AT + NORMALS16, MESH + FIELD.MESH_NORMALS)
  for (let k = 0; k < 60; k++) bytes.writeInt16LE(below(65535) - 32767, NORMALS16 + 2 * k)
  for (let k = 0; k < 20; k++) {
    bytes.writeInt16LE(first + below(size), VERTICES + 16 * k)
    bytes.writeInt16LE(first + below(size), VERTICES + 16 * k + 2)
    bytes.writeUInt16LE(below(65536), VERTICES + 16 * k + 4)
    bytes.writeUInt32LE(below(2 ** one(20, 30)), VERTICES + 16 * k + 8)
    bytes.writeInt32LE(below(2 ** 31) - 2 ** 30, VERTICES + 16 * k + 12)
  }
  const [a, b, c] = [0, 1, 2].map((k) => [0, 2].map((field) => bytes.readInt16LE(VERTICES + 16 * bytes.readUInt16LE(FACES + 2 * k) + field)))
  const lines = new Set([a, b, c].map(([, y]) => (y + 7) >> 4)).size, area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
  return lines < 2 || area === 0 ? faces() : [bytes, [AT + NORMALS16 + 0x80, AT + DRAWN, AT + FACES, below(2 ** one(20, 28, 30))], VERTICES + 16 * bytes.readUInt16LE(FACES) + 2]
}

function lists() {
  const height = 1 + below(one(240, 2040)), count = 3 + below(40), size = Math.min(32766, one(32766, 16 * height + 200))
  const bytes = frame(height, count, below(100)), clipped = below(2)
  bytes.writeUInt8(clipped, DRAWN + FIELD.DRAWN_IS_CUT)
  for (let k = 0; k < count; k++) {
    bytes.writeInt16LE(below(size), VERTICES + 16 * k)
    bytes.writeInt16LE(below(size) - (size === 32766 ? 0 : 100), VERTICES + 16 * k + 2)
    bytes.writeUInt16LE(clipped && !below(4) ? one(1, 2, 4, 8, 16, 5, 9) : 0, VERTICES + 16 * k + 6)
  }
  return [bytes, [AT, AT + DRAWN, one(0, below(height))], VERTICES + 3]
}

// A triangle's lines, or a part of them, in a strip of w by 8, by tables: edges in and around it, t anywhere and near t_max. Steps of all
// sizes, since it is by these that a line is known to miss the highlight; and steps by which t wraps between the ends of a line that are past
// t_max. Pixels are aligned, as these lines need them.
const SURFACE = 0x20, TARGET = 0x30, TRIANGLE = 0x60, DEPTH = 0x100, OUT = 0x400, COLUMNS = 0x800, COLOURS = 0x1800, COLOURS_END = 0x5800
const UPPER = TRIANGLE + FIELD.TRIANGLE_LONG + 8
const tables = Uint8Array.from({ length: COLOURS_END - COLUMNS }, (_, i) => below(256) & (i < COLOURS - COLUMNS ? 0x7e : 0xff))
function colours() {
  const bytes = Buffer.alloc(COLOURS_END), word = (at, ...values) => values.forEach((value, k) => bytes.writeInt32LE(value | 0, at + 4 * k))
  const wraps = !below(8), shift = wraps ? 18 : below(19), tMax = 2 ** (shift + 12) - 1 - below(2 ** (shift + 10))
  const w = 1 + below(40), y = below(100), shine = wraps ? 2 : one(0, 1, 2, 2), size = one(8, 16, 20, 22, 24, 26, 27, 28, 30, 32)
  const step = () => bits(one(size, size, Math.max(8, size - 3)))
  bytes.set(tables, COLUMNS)
  word(FIELD.TABLES_COLUMNS, AT + COLUMNS, AT + COLOURS, tMax)
  bytes.writeUInt16LE(0x1234, FIELD.TABLES_DARK)
  bytes.writeUInt8(shift, FIELD.TABLES_SHIFT)
  const stride = one(1, 1, -1) * one(2 * w, 80 + 2 * below(20))
  word(SURFACE, AT + OUT + 2 * below(2) - Math.min(0, 7 * stride), stride)
  word(TARGET, AT + SURFACE, AT + DEPTH, w, y, y + 8)
  for (let i = 0; i < 320; i++) bytes.writeUInt16LE(one(65535, 65535, below(65536)), DEPTH + 2 * i)
  const z = below(2) ? below(65536) * 65536 : bits(32), nl = shine === 0 ? -1 : below(8) ? below(2 ** 31) : bits(32)
  const nlSteps = [0, 0].map(() => shine && bits(one(20, 28)))
  word(TRIANGLE, z, nl, below(3) ? tMax + bits(size) : bits(32), step(), step(), bits(20), nlSteps[0], step(), step(), bits(24), nlSteps[1],
    step() >> below(8), below(w))
  for (let k = 0; k < 3; k++) word(TRIANGLE + FIELD.TRIANGLE_LONG + 8 * k, below(65536 * (w + 8)) - 65536 * 4, bits(20))
  if (wraps) { // t, its step and that one's; long edges left and right of all
    const [past, first, second] = one([1 + below(1000), below(100), 2 ** one(29, 30, 31)], [2 ** 31 - below(100), 2 ** 26 - 1 - below(2 ** 20), 0])
    word(TRIANGLE + FIELD.TRIANGLE_T, tMax + past, first)
    word(TRIANGLE + FIELD.TRIANGLE_TXX, second, 0, w * 65536, 0, 0, 0, 0, 0)
  }
  const lines = [below(8), below(10), below(10)].sort((a, b) => a - b)
  lines.forEach((line, k) => bytes.writeUInt16LE(y + line, TRIANGLE + FIELD.TRIANGLE_Y + 2 * k))
  bytes.writeUInt8(shine, TRIANGLE + FIELD.TRIANGLE_SHINE)
  bytes.writeUInt8(wraps ? 0 : below(2), TRIANGLE + FIELD.TRIANGLE_LONG_IS_LEFT)
  // A triangle is read again where it goes on in the next strip, its upper edge where that does.
  const goesOn = lines[2] > 8, unread = goesOn && lines[1] >= 8 ? [] : [goesOn ? [UPPER, UPPER + 4] : [TRIANGLE, TRIANGLE + FIELD.TRIANGLE_SHINE]]
  return [bytes, [AT, AT + TRIANGLE, AT + TARGET], TRIANGLE + 3, { unread }]
}

// What mesh_begin paints with: by tables and exactly, and by tables of a smaller highlight and other dark pixels. Of each program its own,
// since a paint has addresses.
function paints(machine) {
  const [tables, exact] = [0, 1].map((way) => {
    if (run(machine, 'mesh_begin', [way])) throw new Error('mesh_begin returned an error')
    return Buffer.from(machine.memory.subarray(machine.address('paint') - RAM, machine.address('paint') - RAM + machine.size('paint')))
  })
  const other = Buffer.from(tables)
  other.writeUInt32LE(tables.readUInt32LE(FIELD.TABLES_T_MAX) >>> 1, FIELD.TABLES_T_MAX)
  other.writeUInt16LE(0x1234, FIELD.TABLES_DARK)
  return { tables, exact, other }
}
const PAINTS_OF = new Map([c, assembly].map((machine) => [machine, paints(machine)])), PAINT_SIZE = c.size('paint')

// A picture of a mesh in strips of all heights, a part of it by tables and one exactly, or both by tables, with places for few triangles that
// go on. Lines of pixels that are not aligned are drawn, too.
const POSE = 0x140, TO_LIGHT = 0x150, TO_VIEWER = 0x160, LIGHT = 0x170, LIGHT_END = 0x1b0, PARTS = 0x1b0, SURFACES = 0x1100, PICTURE = 0x1400
const NEIGHBOURS = 0x2c00, MESH_MEMORY = 0x3000, FRAME_MEMORY = 0x4000, POLYGON = FIELD.BENCH_FACE - 3 * 16 /* with padding */, PAINTS = 0x6000
// Of places for triangles that go on those that are free, but for the next free one; and of the others an upper edge that has ended.
function ended(machine, at) {
  const { memory } = machine, word = (place) => memory.readUInt16LE(at + place), first = memory.readUInt32LE(at + FIELD.FRAME_KEPT) - AT
  const size = word(FIELD.FRAME_KEPT_BYTES), places = Array.from({ length: word(FIELD.FRAME_KEPT_BYTES - 2) }, (_, i) => first + size * i), kept = new Set()
  for (let i = word(DRAWN + FIELD.DRAWN_KEPT); i !== 65535; i = word(places[i] + FIELD.KEPT_FACE + 2)) kept.add(places[i])
  return places.map((place) => !kept.has(place) ? [place, place + FIELD.KEPT_FACE + 2]
    : word(place + FIELD.TRIANGLE_Y) >= word(place + FIELD.TRIANGLE_Y_MIDDLE) ? [place + FIELD.TRIANGLE_LONG + 8, place + FIELD.TRIANGLE_LONG + 12] : [place, place])
}
function strips(outlined) {
  const w = outlined ? 40 - below(8) : 1 + below(40), h = 1 + below(64), odd = !below(10), lines = one(16, 16, 1 + below(20)), vertices = 3 + below(30)
  const faces = outlined ? 64 - below(one(60, 10)) : 1 + below(64)
  const stride = 2 * w + (below(10) ? 2 * below(2) : 1), bytes = Buffer.concat([frame(h, vertices, faces), Buffer.alloc(0x4c00 + 2 * PAINT_SIZE)])
  const word = (at, ...values) => values.forEach((value, k) => bytes.writeInt32LE(value | 0, at + 4 * k))
  bytes.fill(0, 0, MESH)
  for (let k = 0; k < 4; k++) bytes.writeInt16LE(bits(16) || 1, POSE + 2 * k)
  for (let k = 0; k < 2; k++) bytes.writeInt16LE(bits(one(6, 9)), POSE + 8 + 2 * k)
  bytes.writeUInt16LE(one(16 * w, 16 * w, below(4000), 65535), POSE + 14)
  word(TO_LIGHT, bits(15), bits(15), bits(15))
  word(TO_VIEWER, bits(15), bits(15), bits(15))
  const painted = one(['tables', outlined ? 'other' : 'exact'], ['exact', 'tables'], ['tables', 'other'], ['tables', 'other'])
  const swapped = outlined && !painted.includes('exact') && below(2)
  const change = (machine, at) => painted.forEach((name, k) => {
    PAINTS_OF.get(machine)[name].copy(machine.memory, at + PAINTS + PAINT_SIZE * k)
    if (swapped) machine.memory[at + PAINTS + PAINT_SIZE * k + FIELD.PAINT_FORMAT] = 1 // GLINT_RGB565_SWAPPED
  })
  if (below(2)) {
    word(MESH + FIELD.MESH_FACES + 4, AT + PARTS)
    bytes.writeUInt16LE(below(faces), PARTS)
    bytes.writeUInt16LE(faces, PARTS + 2)
    bytes.writeUInt8(2, MESH + FIELD.MESH_VERTEX_COUNT + 4)
  }
  const calls = [['glint_light_directional', [AT + LIGHT, AT + TO_LIGHT]],
    ...painted.map((_, k) => ['glint_paint_light_by', [AT + PAINTS + PAINT_SIZE * k, AT + LIGHT, 1, AT + TO_VIEWER, 0]]),
    ['glint_mesh_begin', [AT, w, h, lines, one(0, 0, 2000 + below(8000)), AT + FRAME_MEMORY, 4 * below(400) + 2 * w * lines + 1100]],
    ['glint_mesh_add', [AT, AT + DRAWN, AT + MESH, AT + POSE, AT + PAINTS, AT + MESH_MEMORY, 0x1000]]]
  const end = one(h, 1 + below(h)) // triangles go on
  for (let y = below(4) ? 0 : below(end), count = 0; y < end; count++) {
    const height = Math.min(h - y, one(lines, lines, 1 + below(lines))), surface = SURFACES + 12 * count
    calls.push(['glint_mesh_strip', [AT, y, height, AT + surface]])
    word(surface, AT + PICTURE + stride * y + odd, stride)
    y += height
  }
  // A triangle that has ended, too.
  const unread = [[LIGHT, LIGHT_END], [PAINTS, PAINTS + 2 * PAINT_SIZE], [FRAME_MEMORY, FRAME_MEMORY + POLYGON],
    [FRAME_MEMORY + FIELD.BENCH_FACE, FRAME_MEMORY + FIELD.BENCH_FACE + FIELD.KEPT_FACE], ended]
  if (outlined) {
    // In the picture's middle, and as large as it.
    for (let k = 0; k < 3 * vertices; k++) bytes.writeInt16LE(bits(16), PLACES + 2 * k)
    ;[w, h].forEach((size, k) => bytes.writeInt16LE(8 * size + bits(6), POSE + 8 + 2 * k))
    bytes.writeUInt16LE(8 * Math.min(w, h) + below(400), POSE + 14)
    // Neighbours at random; or none, so that there are more outlines than a strip keeps. Only the picture need be alike.
    const alone = !below(3)
    for (let k = 0; k < 3 * faces; k++) bytes.writeUInt16LE(alone ? 65535 : one(65535, 65534, below(faces), (Math.floor(k / 3) ^ 1) % faces), NEIGHBOURS + 2 * k)
    word(MESH + FIELD.MESH_NEIGHBOURS, AT + NEIGHBOURS)
    calls.splice(-1 - calls.filter(([name]) => name === 'glint_mesh_strip').length, 0,
      (machine, at) => machine.memory.writeUInt32LE(machine.address('glint_outlines'), at + FIELD.FRAME_KEPT_BYTES + 6))
    unread.push([0, MESH], [MESH_MEMORY, PAINTS])
  }
  return [bytes, calls.at(-1)[1], PLACES + 1, { before: calls.slice(0, -1), change, unread }]
}

// Pixels side by side on a line by ALBEDO tables, from any numbers: of colours, and of textures of any size.
const PALETTE = COLOURS_END, TEXELS = PALETTE + 512, TEXELS_END = TEXELS + 2048, PIXELS_PICTURE = FIELD.PIXELS_DDT + 40
function pixels() {
  const bytes = Buffer.alloc(TEXELS_END), word = (at, ...values) => values.forEach((value, k) => bytes.writeInt32LE(value | 0, at + 4 * k))
  const shift = below(20), tMax = 2 ** (shift + 11) - 1 - below(2 ** (shift + 9)), count = 1 + below(16), size = one(16, 22, 26, 30)
  const loop = 4 + below(16), square = loop >> 2 === 2 && 1 + below(5) // of 2^square by 2^square: assembly takes 32 less that for h
  const h = square ? 32 - square : 1 + below(100), w = square ? 2 ** square : 1 + below(Math.min(100, Math.floor(1024 / h)))
  bytes.set(tables, COLUMNS)
  for (let k = COLUMNS; k < COLUMNS + 400; k++) bytes[k] = below(33)
  for (let k = COLOURS; k < COLOURS + 8192; k += 4) word(k, (below(65536) + 65536 * below(65536)) & 0x07e0f81f)
  for (let k = PALETTE; k < TEXELS_END; k++) bytes[k] = below(256)
  word(0, bits(32), below(2) ? below(2 ** 31) : bits(32), below(2 ** 26), below(2 ** 27), below(2 ** 26), below(3) ? bits(size) : bits(32), bits(size))
  word(FIELD.PIXELS_DZ, bits(size), bits(one(16, 28)), bits(one(20, 32)), bits(one(20, 32)), bits(one(20, 32)))
  word(FIELD.PIXELS_DDT, bits(size), AT + DEPTH, AT + DEPTH + 2 * count, OUT - DEPTH, AT + COLUMNS + 392, AT + COLOURS, tMax, (tMax + 2 ** 27) | 0, shift,
    below(33), AT + TEXELS, 0, w, h)
  if (loop >> 2 === 3 || (loop >> 2 === 4 && below(2))) word(PIXELS_PICTURE + 4, AT + PALETTE)
  bytes[PIXELS_PICTURE + 16] = loop
  for (let k = 0; k < 16; k++) bytes.writeUInt16LE(one(65535, below(65536)), DEPTH + 2 * k)
  const change = (machine, at) => square && machine === c && machine.memory.writeUInt32LE(w, at + PIXELS_PICTURE + 12)
  return [bytes, [AT], 3, { change, unread: [[PIXELS_PICTURE + 12, PIXELS_PICTURE + 16]] }]
}

const TWINS = [['glint_mesh_colour', colours, 3000], ['glint_mesh_triangle_set', triangle, 5000], ['glint_mesh_face_set', faces, 2500],
  ['glint_mesh_vertices', vertices, 200], ['glint_mesh_sort', lists, 500], ['glint_mesh_strip', () => strips(false), 200],
  ['glint_mesh_albedo_pixels', pixels, 3000], ['glint_mesh_strip', () => strips(true), 200, 'glint_outlines']]
for (const [name, make, calls, label = name] of TWINS) {
  const unlike = [0, 0]
  for (let i = 0; i < calls; i++) {
    const [bytes, args, fault, more] = make(), wanted = after(c, name, args, bytes, -1, more)
    unlike[0] += after(assembly, name, args, bytes, -1, more) !== wanted
    unlike[1] += i % 10 === 0 && after(assembly, name, args, bytes, fault, more) !== wanted
  }
  console.log(label, calls, ...unlike)
}

// Frames of a mesh with a texture or colours by ALBEDO tables, in both orders of bytes, strip by strip: mesh.h's ways. alone: with outlines of every
// face, which are more than a face hides at once.
function albedo(machine, way, swapped, fault, colours, alone) {
  const call = (name, ...args) => { if (run(machine, name, args)) throw new Error(`${name} returned an error`) }
  const at = (name) => machine.address(name) - RAM, strips = []
  call('mesh_begin', way)
  call('mesh_clothe', 0)
  machine.memory[at('paint') + FIELD.TABLES_SHIFT - 1] = swapped
  // struct cloth of tests/bench/mesh/mesh.c: u, v and colours of 600 vertices, at the end of mesh_memory
  if (colours) colours.copy(machine.memory, at('mesh_memory') + machine.size('mesh_memory') - 1800)
  for (const part of [0, 2400]) machine.memory[at('mesh_memory') + machine.size('mesh_memory') - 4200 + part + 400] ^= fault
  if (alone) {
    machine.memory.fill(255, at('mesh_out'), at('mesh_out') + machine.size('mesh_out'))
    machine.memory.writeUInt32LE(machine.address('mesh_out'), at('clothed') + FIELD.MESH_NEIGHBOURS)
  }
  call('mesh_frame', alone ? 4 : 0)
  for (let y = 0; y < 240; y += 16) {
    machine.memory.fill(0, at('mesh_out'), at('mesh_out') + machine.size('mesh_out'))
    call('mesh_strip', y)
    strips.push(machine.memory.toString('latin1', at('mesh_out'), at('mesh_out') + machine.size('mesh_out')))
  }
  return strips
}
const WAYS = readFileSync(new URL('../bench/mesh/mesh.h', import.meta.url), 'latin1').match(/enum mesh_way {([^}]*)}/)[1].match(/\w+/g)
const ALBEDO = ['MESH_TEXTURED', 'MESH_SMOOTH', 'MESH_TEXTURED_FAR', 'MESH_COLOURED'].flatMap((way) => [0, 1].map((swapped) => [WAYS.indexOf(way), swapped])), unlike = [0, 0]
// Colours of any kind, too: most at an end of their range, which lines leave.
for (let i = 0; i < 4; i++) ALBEDO.push([WAYS.indexOf('MESH_COLOURED'), i & 1, Buffer.from(Array.from({ length: 1800 }, () => one(0, 255, below(256))))])
for (const way of ['MESH_TEXTURED', 'MESH_SMOOTH', 'MESH_COLOURED']) ALBEDO.push([WAYS.indexOf(way), 0, undefined, true])
// What the fault is put into, a texture's places, is not drawn by colours.
for (const [way, swapped, colours, alone] of ALBEDO) {
  const wanted = albedo(c, way, swapped, 0, colours, alone)
  for (const fault of way === WAYS.indexOf('MESH_COLOURED') ? [0] : [0, 0x41]) albedo(assembly, way, swapped, fault, colours, alone).forEach((strip, k) => { unlike[fault && 1] += strip !== wanted[k] })
}
console.log('glint_mesh_albedo_lines', 15 * ALBEDO.length, ...unlike)

// Levels in linear space beside the sequence, undithered: every argument under both largest levels, and a W of up to 9 steps; then arguments from any products. A level that is
// not called near is that of each.
function linear() {
  const machine = load(`${folder}/npm`, `${folder}/m0plus-asm.elf`), table = machine.address('encodings'), at = machine.address('bench_memory') + 3 & ~3
  const encodings = Array.from({ length: 289 }, (_, i) => machine.memory.readUInt16LE(table - RAM + 2 * i))
  const level = (x, max) => {
    const bits = 26 - Math.clz32(x), chord = (x >> bits) - 32, i = 32 * (bits - 2) + chord, rest = x & (1 << bits) - 1
    const encoded = x < 128 ? x * 3308 + 128 >> 8 : encodings[i] + Math.floor((encodings[i + 1] - encodings[i]) * rest / 2 ** bits + 1 / 2)
    return Math.floor((encoded * max + 32767) / 65535)
  }
  const PIXELS = at, SAMPLES = at + 80, CHANNELS = at + 320, COUNT = 20, found = [0, 0, 0]
  let near = 0
  for (let i = 0; i < 8000; i++) {
    const steps = 1 + i % 9, grows = i < 2 * 3277, maxima = i & 1 ? [31, 63, 31] : [255, 255, 255]
    const samples = Array.from({ length: COUNT }, (_, k) => [grows ? 0 : one(0, below(65537)), grows ? Math.min(20 * (i >> 1) + k, 65535) : one(0, 0, below(67110))])
    const channels = maxima.map((max) => [(grows ? 0 : below(2 ** 28)), grows ? 0 : below(2 ** one(20, 29)), grows ? 2 ** 28 : below(2 ** one(20, 29)), max])
    for (const fault of i % 10 ? [0] : [0, 1]) {
      samples.forEach(([nl, f], k) => [0, nl, f].forEach((value, j) => machine.memory.writeUInt32LE(value, SAMPLES - RAM + 12 * k + 4 * j)))
      const words = [CHANNELS + 24, steps, table, ...maxima, ...channels.map(([p]) => p), ...channels.map(([, q]) => q), ...channels.map(([, , r]) => fault ? r ^ 2 ** 25 : r)]
      words.forEach((value, j) => machine.memory.writeUInt32LE(value, CHANNELS - RAM + 4 * j))
      run(machine, 'glint_linear_levels', [PIXELS, SAMPLES, COUNT, CHANNELS])
      let wrong = 0
      channels.forEach(([p, q, r, max], k) => samples.forEach(([nl, f], j) => {
        const v = 8192 + p + (q >>> 14) * nl + (r >>> 14) * f + Math.floor(((q & 16383) * nl + (r & 16383) * f) / 16384)
        const x = Math.min(Math.floor(v / 16384), 65535), most = Math.min(x + steps, 65535)
        if (v >= 2 ** 32) return
        if (machine.memory.readUInt32LE(CHANNELS - RAM + 12 + 4 * k) >>> j & 1) near += !fault
        else wrong += [x, most].some((argument) => level(argument, max) !== machine.memory[PIXELS - RAM + 4 * j + k])
      }))
      found[1 + fault] += wrong > 0
    }
    found[0]++
  }
  return near < .1 * found[0] * 3 * COUNT ? found : [found[0], found[0], 0] // most are decided
}
console.log('glint_linear_levels', ...linear())
