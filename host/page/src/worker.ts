// SPDX-License-Identifier: MIT
// The worker: an engine that answers messages, so that the page stays responsive while it shades.
import { inflateSync } from 'fflate'
import base64 from 'glint:module'
import { Engine } from './engine'
import type { Had } from './engine'
import { isLogo, readPng, writeNormals, writePng } from './png'

const program = new WebAssembly.Module(inflateSync(Uint8Array.from(atob(base64), c => c.charCodeAt(0))) as Uint8Array<ArrayBuffer>)
const engine = new Engine(program)
/** For pictures beside the main one, whose scene stays prepared. */
const other = new Engine(program)

export const methods = {
    map(name: string, bytes: Uint8Array) {
        const map = readPng(name, bytes)
        engine.addMap(name, map)
        other.addMap(name, map)
        return { width: map.width, height: map.height, channels: map.channels, bits: map.bits, isLogo: isLogo(map) }
    },
    mesh(name: string, bytes: Uint8Array<ArrayBuffer>) {
        engine.addMesh(name, bytes)
        other.addMesh(name, bytes)
    },
    forget(name: string) {
        try {
            engine.forget(name)
        } finally {
            other.forget(name)
        }
    },
    draw: (words: string[]) => ({ ...engine.draw(words), facts: engine.facts() }),
    aside: (words: string[]) => other.draw(words),
    refusals: (lines: string[][]) => other.refusals(lines),
    box: () => engine.box(),
    compare: () => engine.compare(),
    curve: (model: string, n: number, count: number, degrees: number) => engine.curve(model, n, count, degrees),
    run: (words: string[]) => engine.run(words),
    moving: (steps: string[][]) => engine.moving(steps),
    /** The one colour that stands for the surface's. */
    colour(words: string[]) {
        other.draw(words)
        return other.facts().colour.join()
    },
    white(name: string, width: number, height: number) {
        engine.addWhite(name, width, height)
        other.addWhite(name, width, height) // which saves animations
    },
    deviceSize: (descriptor: Uint8Array) => engine.deviceSize(descriptor),
    deviceMesh: (held: Uint8Array, words: string[]) => engine.deviceMesh(held, words),
    device: (width: number, height: number, has: Had) => engine.device(width, height, has),
    raw: () => engine.pixels(),
    again: (times: number) => engine.again(times),
    normals: (width: number, height: number, baked: Uint8Array) => writeNormals(width, height, baked),
    png: (width: number, height: number, rgba: Uint8Array, channels: 1 | 3 | 4) => writePng(width, height, rgba, channels),
}
export type Methods = typeof methods

onmessage = ({ data: { id, method, args } }: MessageEvent<{ id: number, method: keyof Methods, args: never[] }>) => {
    try {
        const result = (methods[method] as (...args: never[]) => unknown)(...args)
        postMessage({ id, result })
    } catch (error) {
        postMessage({ id, error: (error as Error).message })
    }
}
