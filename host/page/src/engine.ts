// SPDX-License-Identifier: MIT
// Pictures, numbers and files by command lines: what the worker does, without being one.
import { LIGHT_DESCRIPTOR_BYTES, LIGHT_MATERIAL_BYTES, LIGHT_MESH_BYTES, LIGHT_MESSAGE_BYTES, LIGHT_POSE_BYTES, PAGE_BINS } from './exports'
import { checkTexture, isGltf, readGltf } from './gltf'
import { apart, isObj } from './obj'
import { Module } from './module'
import { pixelsMax, readPng } from './png'
import type { Map16 } from './png'

export interface Picture {
    width: number
    height: number
    /** For a canvas: what `glint render` writes into a PNG. */
    rgba: Uint8Array<ArrayBuffer>
    warnings: string[]
    milliseconds: number
    /** Only the lights' values had changed. */
    kept: boolean
}
export interface Quality {
    report: string
    errorMap: Uint8Array<ArrayBuffer>
    errorTimes: number
    /** Samples that are off by i quarters of a level of 255. */
    histogram: number[]
}
export interface Curve {
    library: number[]
    double: number[]
    blinn: number[]
}
export interface File {
    name: string
    bytes: Uint8Array<ArrayBuffer>
}
/** Names of what a device has: of its map, or of the mesh, and of the material. */
export interface Had {
    map: string
    material: string
}
export interface ForDevice {
    has: Had
    map?: Uint8Array<ArrayBuffer>
    /** In the place of a map: the device is to draw the mesh that it holds. */
    mesh?: true
    material?: Uint8Array<ArrayBuffer>
    /** A frame: of a map a light, of a mesh a pose. */
    light?: Uint8Array<ArrayBuffer>
    pose?: Uint8Array<ArrayBuffer>
}
export type Facts = Record<string, number[]>

const keepNothing = 0, keepScene = 1, keepCanvas = 2
/** Options that make the surface; a built-in scene is made of --material, --color takes its own colours away. */
const ofSurface = /^--(height|normals|scene|mask|scale|bevel|fit|wrap|flip-y|size|albedo|gloss|mesh|crease|axes|split|texture|nearest|material|grain|cut-out|filter|background|no-outlines)\b/
const isPng = (name: string) => /\.png$/i.test(name)
/** Where a mesh stands, for which no canvas is made. */
const standsBy = /^--(turn|zoom|perspective)\b/

export class Engine {
    private module: Module
    private maps = new Map<string, Map16>()
    private meshes = new Map<string, Uint8Array<ArrayBuffer>>()
    private surface = ''
    private material = ''
    private surfaceWarnings: string[] = []
    private drawn: string[] = []
    private frames = 0
    private files = 0 // how many were added, also of one name
    private checker?: Module

    constructor(private program: WebAssembly.Module) {
        this.module = new Module(program)
    }

    addMap(name: string, map: Map16): void {
        this.add(name, () => {
            this.maps.set(name, map)
            this.hand(name, map)
        })
    }

    /** A file of a mesh. */
    addMesh(name: string, bytes: Uint8Array<ArrayBuffer>): void {
        const [mesh, ...named] = isObj(name) ? apart(name, bytes) : [{ name, bytes }]
        const maps = named.filter(({ name }) => isPng(name)).map(({ name: of, bytes }): [string, Map16] => (checkTexture(of, bytes), [`${name}/${of}`, readPng(of, bytes)]))
        if (maps.reduce((sum, [, { width, height }]) => sum + width * height, 0) > pixelsMax)
            throw new Error(`${name}: its textures have more than ${pixelsMax} pixels together; make them smaller`)
        const held = isGltf(name) ? readGltf(name, bytes) : mesh.bytes
        this.add(name, () => {
            this.drop(name, false)
            for (const [of, bytes] of [[name, held], ...named.filter(({ name }) => !isPng(name)).map(({ name: of, bytes }) => [`${name}/${of}`, bytes])] as [string, Uint8Array<ArrayBuffer>][]) {
                this.meshes.set(of, bytes)
                this.handMesh(of, bytes)
            }
            for (const [of, map] of maps) {
                this.maps.set(of, map)
                this.hand(of, map)
            }
        })
    }

    /** As if it had never been added. */
    forget(name: string): void {
        this.guard(() => this.drop(name, true))
        if (this.drawn.some(word => word.endsWith(`=${name}`))) // what is kept of it must not be drawn again
            this.surface = this.material = ''
    }

    /** What came with a mesh of this name, or all of that name. */
    private drop(name: string, all: boolean): void {
        const gone = [...this.meshes.keys(), ...this.maps.keys()].filter(key => key.startsWith(`${name}/`) || all && key === name)
        gone.forEach(key => [this.meshes, this.maps].forEach(files => files.delete(key)))
        gone.forEach(key => this.module.call.page_forget(this.name(key)))
    }

    /** Where that fails, for want of memory, all files are as they were. */
    private add(name: string, work: () => void): void {
        const maps = new Map(this.maps), meshes = new Map(this.meshes)
        this.surface = this.material = ''
        this.files++
        try {
            work()
        } catch (error) {
            this.maps = maps
            this.meshes = meshes
            try {
                this.restore()
            } catch { /* no room for these either: the next draw says so */ }
            throw new Error(`${name}: there is no room for this file (${(error as Error).message}); choose a smaller one`)
        }
    }

    /** A map without anything on it. */
    addWhite(name: string, width: number, height: number): void {
        this.addMap(name, { width, height, channels: 1, bits: 8, palette: false, samples: new Uint16Array(width * height).fill(65535) })
    }

    /** By the words of `glint render`, each an option with its value. */
    draw(words: string[]): Picture {
        return this.guard(() => {
            const { call } = this.module
            const filters = words.some(word => word.startsWith('--filter')) // by the material's n and colour
            const surface = words.filter(word => ofSurface.test(word) || filters && /^(-n|--roughness|--color)/.test(word)).join('\0') + words.some(word => word.startsWith('--color'))
            const material = words.filter(word => !standsBy.test(word)).map(withoutNumbers).join('\0')
            const keep = material === this.material ? keepCanvas : surface === this.surface ? keepScene : keepNothing
            this.surface = this.material = '' // until it is drawn
            this.module.takeWarnings()
            const start = performance.now()
            this.give(['glint render', ...words], (at, bytes) => call.page_draw(at, bytes, keep))
            const milliseconds = performance.now() - start
            const warnings = this.module.takeWarnings()
            if (keep !== keepCanvas)
                this.surfaceWarnings = keep === keepScene ? [...this.surfaceWarnings.filter(w => !/^--(path|roughness|texture)/.test(w)), ...warnings] : warnings
            this.surface = surface
            this.material = material
            this.drawn = words
            const width = call.page_width(), height = call.page_height()
            const rgba = this.module.copy(call.page_rgba(), 4 * width * height)
            return { width, height, rgba, warnings: this.surfaceWarnings, milliseconds, kept: keep === keepCanvas }
        })
    }

    /** Why the command would refuse each of these lines, whatever files hold; '': it would not. */
    refusals(lines: string[][]): string[] {
        return lines.map(words => {
            const module = this.checker ??= new Module(this.program)
            try {
                const bytes = new TextEncoder().encode(['glint render', ...words].map(word => word + '\0').join(''))
                module.call.page_check(module.put(bytes), bytes.length)
                return ''
            } catch (error) {
                this.checker = undefined
                return (error as Error).message
            }
        })
    }

    /** The pixels of the last picture as `--image raw` writes them. */
    pixels(): Uint8Array<ArrayBuffer> {
        const { call } = this.module
        return this.module.copy(call.page_pixels(), call.page_pixels_bytes())
    }

    facts(): Facts {
        return this.guard(() => {
            const lines = this.module.text(this.module.call.page_facts()).trim().split('\n').map(line => line.split(' '))
            return Object.fromEntries(lines.map(([name, ...values]) => [name, values.map(Number)]))
        })
    }

    /** Where the highlight is: x, y, width, height. */
    box(): number[] {
        return this.guard(() => [...new Uint32Array(this.module.copy(this.module.call.page_box(), 16).buffer)])
    }

    compare(): Quality {
        return this.guard(() => {
            const { call } = this.module
            const report = this.module.text(call.page_compare())
            const bins = new Uint32Array(this.module.copy(call.page_histogram(), 4 * PAGE_BINS).buffer)
            return {
                report,
                errorMap: this.module.copy(call.page_error_map(), 4 * call.page_width() * call.page_height()),
                errorTimes: call.page_error_times(),
                histogram: [...bins],
            }
        })
    }

    curve(model: string, n: number, count: number, degrees: number): Curve {
        const rows = this.module.copy(this.module.call.page_curve(this.name(model), n, count, degrees), 24 * count)
        const row = (i: number) => [...new Float64Array(rows.buffer, 8 * count * i, count)]
        return { library: row(0), double: row(1), blinn: row(2) }
    }

    /** What changes between pictures that follow each other, in the mean: a share of the bytes; bytes of the rectangle, and of
     *  the lines' pieces, that hold all changes; bytes of a frame. Afterwards the last picture is drawn again, even where a step
     *  is refused; it may be newer than the one that the asker saw. */
    moving(steps: string[][]): { changed: number, box: number, lines: number, frame: number } {
        const last = this.drawn
        let before: Uint8Array | undefined
        const sum = { changed: 0, box: 0, lines: 0, frame: 0 }
        try {
            for (const step of steps) {
                const { height } = this.draw(step), now = this.pixels()
                if (before)
                    add(sum, extentOf(before, now, height), 1 / (steps.length - 1))
                before = now
            }
        } finally {
            this.draw(last)
        }
        return sum
    }

    /** Runs `glint bake`, `material` or `table`: the files that it writes, and what it prints. */
    run(words: string[]): { files: File[], printed: string, warnings: string[] } {
        return this.guard(() => {
            const { call } = this.module
            this.module.takeWarnings()
            this.module.takePrinted()
            this.give(words, (at, bytes) => call.page_run(at, bytes))
            const files: File[] = []
            for (let i = 0; i < call.page_files(); i++)
                files.push({
                    name: this.module.text(call.page_file_name(i)),
                    bytes: this.module.copy(call.page_file_bytes(i), call.page_file_length(i)),
                })
            return { files, printed: this.module.takePrinted(), warnings: this.module.takeWarnings() }
        })
    }

    /** Of a device's descriptor: width << 16 | height, 0 where it is none. */
    deviceSize(descriptor: Uint8Array): number {
        const bytes = new Uint8Array(LIGHT_DESCRIPTOR_BYTES)
        bytes.set(descriptor.subarray(0, bytes.length))
        return this.module.call.page_device_size(this.module.put(bytes)) >>> 0
    }

    /** Of a mesh that a device holds: that of the words, split at so many degrees; 0: another one. */
    deviceMesh(held: Uint8Array, words: string[]): number {
        const bytes = new Uint8Array(LIGHT_MESH_BYTES)
        bytes.set(held.subarray(0, bytes.length))
        return this.guard(() => this.give(['glint render', ...words], (at, length) => this.module.call.page_device_mesh(this.module.put(bytes), at, length)))
    }

    /** What a device of that size, which has a map and a material already, is sent to draw the last picture; nothing if that has another size. */
    device(width: number, height: number, has: Had): ForDevice | undefined {
        return this.guard(() => {
            if (!this.material && this.drawn.length) // a file came, or was refused, since it was drawn
                this.draw(this.drawn)
            const { call } = this.module, { surface, material } = this
            if (!material || call.page_width() !== width || call.page_height() !== height)
                return undefined
            const packed = this.module.copy(call.page_device_material(), LIGHT_MATERIAL_BYTES), map = `${surface}\0${this.files}`, isNew = has.map !== map
            const scene = { has: { map, material }, material: has.material === material ? undefined : packed }
            return call.page_draws_mesh() ? {
                ...scene,
                mesh: isNew || undefined,
                pose: this.module.copy(call.page_device_pose(this.frames++), LIGHT_POSE_BYTES),
            } : {
                ...scene,
                map: isNew ? this.module.copy(call.page_device_map(), 4 * width * height) : undefined,
                light: this.module.copy(call.page_device_light(this.frames++), LIGHT_MESSAGE_BYTES),
            }
        })
    }

    /** Milliseconds to shade the last picture once, from `times` of them. */
    again(times: number): number {
        const start = performance.now()
        this.module.call.page_again(times)
        return (performance.now() - start) / times
    }

    private give<T>(words: string[], call: (at: number, bytes: number) => T): T {
        const bytes = new TextEncoder().encode(words.map(word => word + '\0').join(''))
        return call(this.module.put(bytes), bytes.length)
    }

    private name(text: string): number {
        return this.module.put(new TextEncoder().encode(text + '\0'))
    }

    private handMesh(name: string, bytes: Uint8Array): void {
        const at = this.name(name)
        this.module.call.page_mesh_file(at, this.module.put(bytes), bytes.length)
    }

    private hand(name: string, map: Map16): void {
        const { module } = this
        const at = this.name(name)
        const samples = module.put(new Uint8Array(map.samples.buffer, map.samples.byteOffset, map.samples.byteLength))
        module.call.page_image(at, map.width, map.height, map.channels, map.bits, map.palette ? 1 : 0, samples)
    }

    /** Another instance, which has all files. */
    private begin(): void {
        this.module = new Module(this.program)
        this.surface = this.material = ''
        for (const [name, map] of this.maps)
            this.hand(name, map)
        for (const [name, bytes] of this.meshes)
            this.handMesh(name, bytes)
    }

    /** Another instance, which has all files and the last good picture. */
    private restore(): void {
        this.begin()
        try {
            if (this.drawn.length)
                this.give(['glint render', ...this.drawn], (at, bytes) => this.module.call.page_draw(at, bytes, keepNothing))
        } catch { // a file of the last picture has been replaced by one that cannot be drawn
            this.drawn = []
            this.begin()
        }
    }

    /** A program that ended is replaced by a fresh one. */
    private guard<T>(work: () => T): T {
        try {
            return work()
        } catch (error) {
            this.restore()
            if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)
                throw new Error(`the page failed (${error.message}); a smaller --size may help`)
            throw error
        }
    }
}

type Extent = { changed: number, box: number, lines: number, frame: number }

function add(sum: Extent, more: Extent, weight: number): void {
    for (const name of Object.keys(sum) as (keyof Extent)[])
        sum[name] += weight * more[name]
}

function extentOf(before: Uint8Array, now: Uint8Array, height: number): Extent {
    const line = now.length / height
    let changed = 0, lines = 0, top = height, bottom = -1, left = line, right = -1
    for (let y = 0; y < height; y++) {
        let first = line, last = -1
        for (let x = 0; x < line; x++)
            if (before[y * line + x] !== now[y * line + x]) {
                changed++
                first = Math.min(first, x)
                last = x
            }
        if (last < 0)
            continue
        lines += last - first + 1
        top = Math.min(top, y)
        bottom = y
        left = Math.min(left, first)
        right = Math.max(right, last)
    }
    return { changed: changed / now.length, box: right < 0 ? 0 : (right - left + 1) * (bottom - top + 1), lines, frame: now.length }
}

/** A word as what the canvas is made for: of a light its kind. */
function withoutNumbers(word: string): string {
    return word.replace(/^(--(light|point|spot))\b.*/, '$1')
}
