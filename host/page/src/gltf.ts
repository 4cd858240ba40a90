// SPDX-License-Identifier: MIT
// glTF files that hold all they need (GLB, or data: addresses) into what module/soup.c reads: triangles as the command has them of
// libassimp, in the same order and with the same roundings. What would have to be rounded otherwise is refused.
import { pixelsMax, readPng } from './png'

interface View { buffer: number, byteOffset?: number, byteLength: number, byteStride?: number }
interface Accessor { bufferView?: number, byteOffset?: number, componentType: number, count: number, type: string, sparse?: unknown }
interface Info { index: number, texCoord?: number, extensions?: Record<string, unknown> }
interface Material {
    pbrMetallicRoughness?: { baseColorFactor?: number[], metallicFactor?: number, roughnessFactor?: number, baseColorTexture?: Info, metallicRoughnessTexture?: Info }
    extensions?: Record<string, unknown>
}
interface Primitive { attributes: Record<string, number>, indices?: number, material?: number, mode?: number, targets?: unknown }
interface Node { mesh?: number, children?: number[], matrix?: number[], translation?: number[], rotation?: number[], scale?: number[], skin?: number }
interface Gltf {
    scene?: number, scenes?: { nodes?: number[] }[], nodes?: Node[], meshes?: { primitives: Primitive[] }[], accessors?: Accessor[], bufferViews?: View[], materials?: Material[]
    buffers?: { uri?: string, byteLength: number }[], images?: { uri?: string, bufferView?: number }[], textures?: { source?: number, sampler?: number }[], samplers?: { magFilter?: number, wrapS?: number, wrapT?: number }[]
    extensionsRequired?: string[]
}
export const soupMagic = 20260001, materialNumbers = 13, faceNumbers = 34
const { fround } = Math

export const isGltf = (name: string) => /\.(gltf|glb)$/i.test(name)

/** What of a file is read at most: nodes that have others, or parts that have vertices, many times over would have no end. */
const nodesMost = 1 << 16, trianglesMost = 1 << 18, elementsMost = 1 << 23
const materialsMost = 4096 // as the command has it
class Refused extends Error {}

/** Throws an Error whose message is a sentence. */
export function readGltf(name: string, file: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
    const refuse = (why: string): never => { throw new Refused(`${name}: ${why}, or use glint render --mesh`) }
    const damaged = () => refuse('this glTF is damaged; export it again')
    try {
        return soupOf(file, refuse, damaged)
    } catch (error) { // JSON may have anything in the place of anything
        if (!(error instanceof Refused))
            damaged()
        throw error
    }
}

function soupOf(file: Uint8Array<ArrayBuffer>, refuse: (why: string) => never, damaged: () => never): Uint8Array<ArrayBuffer> {
    const { json, held } = opened(file)
    if (json.extensionsRequired?.some(extension => extension !== 'KHR_materials_unlit'))
        refuse(`needs ${json.extensionsRequired.join(', ')}; export it without`)

    const bytesOf = (uri: string | undefined): Uint8Array => {
        const base64 = uri?.match(/^data:[^,]*;base64,(.*)$/s)?.[1]
        return base64 === undefined ? refuse('names other files, which the page cannot see; export it in one file (GLB)') : Uint8Array.from(atob(base64), c => c.charCodeAt(0))
    }
    const buffers = (json.buffers ?? []).map(({ uri }, i) => uri === undefined && i === 0 && held ? held : bytesOf(uri))
    const viewBytes = (i: number): Uint8Array => {
        const view = json.bufferViews?.[i] ?? damaged(), from = view.byteOffset ?? 0, buffer = buffers[view.buffer] ?? damaged()
        return from + view.byteLength > buffer.length ? damaged() : buffer.subarray(from, from + view.byteLength)
    }

    let elements = 0
    /** Numbers of an accessor, so many for each element. */
    function numbers(i: number, types: string[]): { values: number[], size: number, kind: number } {
        const { bufferView, byteOffset = 0, componentType: kind, count, type, sparse } = json.accessors?.[i] ?? damaged()
        const size = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[type] ?? damaged(), width = { 5121: 1, 5123: 2, 5125: 4, 5126: 4 }[kind] ?? damaged()
        if (!types.includes(`${type} ${kind}`) || sparse || bufferView === undefined)
            refuse('has numbers of a kind that the page does not read; export it with floats')
        const bytes = viewBytes(bufferView!), step = json.bufferViews![bufferView!].byteStride ?? size * width, view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
        if (!Number.isInteger(count) || count < 1 || count > 1 << 20 || byteOffset + step * (count - 1) + size * width > bytes.length)
            damaged()
        if ((elements += count) > elementsMost)
            refuse('has parts that share too many vertices; export it as one mesh')
        const read = { 5121: (at: number) => view.getUint8(at), 5123: (at: number) => view.getUint16(at, true), 5125: (at: number) => view.getUint32(at, true), 5126: (at: number) => view.getFloat32(at, true) }[kind]!
        return { values: Array.from({ length: count * size }, (_, k) => read(byteOffset + step * Math.floor(k / size) + width * (k % size))), size, kind }
    }

    // ---- primitives in the order of nodes, and their materials: of children first ----

    const found: { primitive: Primitive, matrix: Matrix }[] = [], used = new Map<number, number>()
    let visited = 0
    const visit = (i: number, depth: number, parent: Matrix): void => {
        const node = json.nodes?.[i] ?? damaged(), own = node.mesh === undefined ? [] : json.meshes?.[node.mesh]?.primitives ?? damaged()
        if (node.skin !== undefined)
            refuse('has a skeleton; export it without')
        if (depth > 1000)
            damaged()
        if (++visited > nodesMost)
            refuse(`has more than ${nodesMost} nodes; export it as one mesh`)
        const matrix = times(parent, matrixOf(node))
        if (determinant(matrix) <= 0)
            refuse('has mirrored parts; apply their transforms before you export it')
        if (found.length + own.length > nodesMost)
            refuse(`has more than ${nodesMost} parts; export it as one mesh`)
        found.push(...own.map(primitive => ({ primitive, matrix })))
        node.children?.forEach(child => visit(child, depth + 1, matrix))
        own.forEach(({ material }) => { if (material !== undefined && !used.has(material)) used.set(material, used.size) })
    }
    const scene = json.scenes?.[json.scene ?? 0]
    scene?.nodes?.forEach(node => visit(node, 0, plain))
    if (!found.length)
        refuse('has no triangles; name another mesh')
    if (used.size > materialsMost)
        refuse(`has ${used.size} materials; join some`)

    // ---- materials in the order in which libassimp meets them; after them stands the one of what names none ----

    const pictures: number[] = []
    const pictureOf = (info?: Info): number => {
        if (!info)
            return 0
        if (info.texCoord || info.extensions)
            refuse('moves its textures, or has several of their coordinates; export it without')
        const image = json.textures?.[info.index]?.source ?? damaged()
        if (!pictures.includes(image))
            pictures.push(image)
        return pictures.indexOf(image) + 1
    }
    const bases: number[][] = []
    const materials = [...[...used.keys()].map(i => json.materials?.[i] ?? damaged()), {}].map(({ pbrMetallicRoughness: pbr = {}, extensions }: Material) => {
        const factor = pbr.baseColorFactor ?? [1, 1, 1, 1]
        if (factor.length !== 4 || !factor.every(Number.isFinite))
            damaged()
        const base = factor.slice(0, 3).map(fround), look = pictureOf(pbr.metallicRoughnessTexture), picture = pictureOf(pbr.baseColorTexture)
        const texture = json.textures?.[pbr.baseColorTexture?.index ?? -1], sampler = json.samplers?.[texture?.sampler ?? -1] ?? {}
        const [metallic, rough] = [pbr.metallicFactor ?? 1, pbr.roughnessFactor ?? 1].map(fround).map(within)
        bases.push(base)
        return [...base.map(level), extensions && 'KHR_materials_unlit' in extensions ? 1 : 0, rough, metallic, look, picture,
            (sampler.wrapS ?? 10497) !== 10497 || (sampler.wrapT ?? 10497) !== 10497 ? 1 : 0, sampler.magFilter === 9728 ? 1 : 0, ...base.map(within)]
    })

    // ---- triangles ----

    const has = (name: string) => name in found[0].primitive.attributes
    if (found.some(({ primitive: { attributes, mode = 4, targets } }) => mode !== 4 || targets || ['NORMAL', 'TEXCOORD_0', 'COLOR_0'].some(name => name in attributes !== has(name))))
        refuse('has parts of different kinds; export it as triangles, all with the same attributes')
    const faces: number[] = []
    for (const { primitive: { attributes, indices, material }, matrix } of found) {
        const part = material === undefined ? used.size : used.get(material)!
        const places = moved(numbers(attributes.POSITION ?? damaged(), ['VEC3 5126']).values, matrix), count = places.length / 3
        const normals = has('NORMAL') ? turned(numbers(attributes.NORMAL, ['VEC3 5126']).values, matrix) : undefined
        const uv = has('TEXCOORD_0') ? numbers(attributes.TEXCOORD_0, ['VEC2 5126']).values : undefined
        const colors = has('COLOR_0') ? numbers(attributes.COLOR_0, ['VEC3 5126', 'VEC4 5126', 'VEC3 5121', 'VEC4 5121', 'VEC3 5123', 'VEC4 5123']) : undefined
        const corners = indices === undefined ? Array.from({ length: count }, (_, i) => i) : numbers(indices, ['SCALAR 5121', 'SCALAR 5123', 'SCALAR 5125']).values
        const most = { 5126: 1, 5121: 255, 5123: 65535 }[colors?.kind ?? 5126]!
        if (corners.some(corner => corner >= count) || [[normals, 3], [uv, 2], [colors?.values, colors?.size ?? 1]].some(([list, size]) => list && (list as number[]).length !== count * (size as number)))
            damaged()
        if (faces.length / faceNumbers + corners.length / 3 > trianglesMost)
            refuse(`has more than ${trianglesMost} triangles; simplify it`)
        for (let i = 0; i + 2 < corners.length; i += 3) {
            const three = corners.slice(i, i + 3), of = (list: number[] | undefined, size: number) => three.flatMap(corner => Array.from({ length: size }, (_, k) => list?.[size * corner + k] ?? 0))
            faces.push(...of(places, 3), ...of(normals, 3),
                ...of(uv, 2).map((value, k) => k % 2 && uv ? 1 - fround(1 - value) : value), // libassimp has v up
                ...three.flatMap(corner => bases[part].map((base, k) => colors ? level(fround(colors.values[colors.size * corner + k] / most) * base) : materials[part][k])), part)
        }
    }

    // ---- all as numbers, and the pictures' bytes ----

    let pixels = 0
    const decoded = pictures.map((image, i) => {
        const { uri, bufferView } = json.images?.[image] ?? damaged(), title = `its texture ${i + 1}`
        const bytes = bufferView !== undefined ? viewBytes(bufferView).slice() : bytesOf(uri).slice()
        const map = (() => {
            try {
                checkTexture(title, bytes as Uint8Array<ArrayBuffer>)
                return readPng(title, bytes)
            } catch (error) {
                return refuse((error as Error).message)
            }
        })()
        if (map.bits > 8)
            refuse(`${title} has ${map.bits} bits a sample; save it with 8`)
        if ((pixels += map.width * map.height) > pixelsMax)
            refuse(`its textures have more than ${pixelsMax} pixels together; make them smaller`)
        return map
    })
    const head = [soupMagic, faces.length / faceNumbers, materials.length, decoded.length, Number(has('NORMAL')), Number(has('TEXCOORD_0')), Number(has('COLOR_0')), ...materials.flat(), ...decoded.flatMap(({ width, height }) => [width, height])]
    const list = Float64Array.from([...head, ...faces])
    const out = new Uint8Array(list.byteLength + decoded.reduce((sum, { width, height }) => sum + 3 * width * height, 0))
    out.set(new Uint8Array(list.buffer))
    let at = list.byteLength
    for (const { width, height, channels, samples } of decoded)
        for (let i = 0; i < 3 * width * height; i++)
            out[at++] = samples[Math.floor(i / 3) * channels + (channels > 2 ? i % 3 : 0)] / 257
    return out
}

// ---- where parts stand: as libassimp computes it, each step rounded to a float ----

/** Rows of four. */
type Matrix = number[]
const plain: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
/** Products, added from the left. */
const sum = (...pairs: [number, number][]) => pairs.map(([a, b]) => fround(a * b)).reduce((all, one) => fround(all + one))
const times = (a: Matrix, b: Matrix): Matrix => a.map((_, i) => sum(...[0, 1, 2, 3].map((k): [number, number] => [b[4 * k + i % 4], a[i - i % 4 + k]])))

function matrixOf({ matrix, translation, rotation, scale }: Node): Matrix {
    if (matrix)
        return matrix.map((_, i) => fround(matrix[4 * (i % 4) + Math.floor(i / 4)]))
    let out = plain
    if (translation) {
        const [x, y, z] = translation.map(fround)
        out = times(out, [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1])
    }
    if (rotation) {
        const [x, y, z, w] = rotation.map(fround), one = (...pairs: [number, number][]) => fround(1 - fround(2 * sum(...pairs))), two = (...pairs: [number, number][]) => fround(2 * sum(...pairs))
        out = times(out, [one([y, y], [z, z]), two([x, y], [-z, w]), two([x, z], [y, w]), 0, two([x, y], [z, w]), one([x, x], [z, z]), two([y, z], [-x, w]), 0,
            two([x, z], [-y, w]), two([y, z], [x, w]), one([x, x], [y, y]), 0, 0, 0, 0, 1])
    }
    if (scale) {
        const [x, y, z] = scale.map(fround)
        out = times(out, [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1])
    }
    return out
}

/** It leaves as they are what it takes for this. */
const isPlain = (matrix: Matrix) => matrix.every((value, i) => Math.abs(value - plain[i]) <= fround(.01))

function determinant([a1, a2, a3, , b1, b2, b3, , c1, c2, c3]: Matrix): number {
    return [[a1, b2, c3], [-a1, b3, c2], [a2, b3, c1], [-a2, b1, c3], [a3, b1, c2], [-a3, b2, c1]].map(([a, b, c]) => fround(fround(a * b) * c)).reduce((all, one) => fround(all + one))
}

function moved(places: number[], m: Matrix): number[] {
    return isPlain(m) ? places : places.map((_, i) => {
        const from = i - i % 3, row = 4 * (i % 3)
        return fround(sum([m[row], places[from]], [m[row + 1], places[from + 1]], [m[row + 2], places[from + 2]]) + m[row + 3])
    })
}

/** By the inverse's transpose. */
function turned(normals: number[], m: Matrix): number[] {
    if (isPlain(m))
        return normals
    const [a1, a2, a3, , b1, b2, b3, , c1, c2, c3] = m, inverse = fround(1 / determinant(m)), cross = (a: number, b: number, c: number, d: number) => sum([a, b], [-c, d])
    const t = [cross(b2, c3, b3, c2), -cross(b1, c3, b3, c1), cross(b1, c2, b2, c1), -cross(a2, c3, a3, c2), cross(a1, c3, a3, c1), -cross(a1, c2, a2, c1),
        cross(a2, b3, a3, b2), -cross(a1, b3, a3, b1), cross(a1, b2, a2, b1)].map((value, i) => fround((i % 2 ? -inverse : inverse) * (i % 2 ? -value : value)))
    const out: number[] = []
    for (let i = 0; i < normals.length; i += 3) {
        const n = [0, 3, 6].map(row => sum([t[row], normals[i]], [t[row + 1], normals[i + 1]], [t[row + 2], normals[i + 2]])), length = fround(Math.sqrt(sum([n[0], n[0]], [n[1], n[1]], [n[2], n[2]])))
        out.push(...length ? n.map(value => fround(value * fround(1 / length))) : n)
    }
    return out
}

/** The command decodes a texture's own gamma, if it is another one than sRGB's; the page takes samples as they are. */
export function checkTexture(name: string, bytes: Uint8Array<ArrayBuffer>): void {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
    for (let at = 8, length, kind; at + 12 <= bytes.length && kind !== 'IDAT'; at += 12 + length) { // chunks, of which comments may be long
        length = view.getUint32(at)
        kind = String.fromCharCode(...bytes.subarray(at + 4, at + 8))
        if (kind === 'iCCP' || kind === 'gAMA' && Math.abs(view.getUint32(at + 8) - 45455) > 50)
            throw new Error(`${name}: has a gamma or colour profile of its own; save it as plain sRGB`)
    }
}

const within = (value: number) => Math.min(1, Math.max(0, value))
/** Of light a level of 255, as encoded in sRGB. */
function level(light: number): number {
    const value = within(light)
    return Math.round(255 * (value <= .0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - .055))
}

function opened(file: Uint8Array): { json: Gltf, held?: Uint8Array } {
    const view = new DataView(file.buffer, file.byteOffset, file.length), text = (bytes: Uint8Array) => JSON.parse(new TextDecoder().decode(bytes)) as Gltf
    if (view.getUint32(0, true) !== 0x46546c67)
        return { json: text(file) }
    const length = view.getUint32(12, true), at = 20 + length
    return { json: text(file.subarray(20, at)), held: at + 8 <= file.length ? file.subarray(at + 8, at + 8 + view.getUint32(at, true)) : undefined }
}
