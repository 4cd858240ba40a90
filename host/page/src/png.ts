// SPDX-License-Identifier: MIT
// PNG files into the samples that the host's image/read.c gives: not by a canvas, which cuts 16 bits, applies gamma and
// changes colours under alpha. Every sample becomes 16 bits, 65535 = 1.0.
import { convertIndexedToRgb, decode, encode } from 'fast-png'
import type { DecodedPng } from 'fast-png'
import { Unzlib } from 'fflate'
import { joined } from './packed'

export interface Map16 {
    width: number
    height: number
    /** 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA. */
    channels: number
    /** Of a sample in the file. */
    bits: number
    palette: boolean
    samples: Uint16Array
}

/** Is it a shape, of two levels or cut out by its alpha, and not a surface with heights? */
export function isLogo({ channels, samples }: Map16): boolean {
    const hasAlpha = channels === 2 || channels === 4, levels: number[] = []
    for (let i = 0; i < samples.length; i += channels)
        if (!hasAlpha || samples[i + channels - 1] > 32767)
            levels.push(channels < 3 ? samples[i] : (samples[i] + samples[i + 1] + samples[i + 2]) / 3)
    const low = levels.reduce((a, b) => Math.min(a, b), 65535), high = levels.reduce((a, b) => Math.max(a, b), 0), isCut = levels.length > 0 && levels.length < samples.length / channels
    return (isCut || high - low > 32767) && levels.filter(level => level - low > 2621 && high - level > 2621).length < levels.length / 10
}

const others: [string, string][] = [
    ['\xff\xd8\xff', 'a JPEG'], ['GIF8', 'a GIF'], ['BM', 'a BMP'], ['RIFF', 'a WebP or other RIFF file'], ['qoif', 'a QOI'],
    ['II*', 'a TIFF'], ['MM', 'a TIFF'], ['DDS ', 'a DDS texture'], ['\x76\x2f\x31\x01', 'an OpenEXR'], ['8BPS', 'a PSD'],
    ['<svg', 'an SVG'], ['<?xml', 'an SVG or other XML file'],
]
const signature = '\x89PNG\r\n\x1a\n'
const sideMax = 16384
export const pixelsMax = 1 << 25

/** Throws an Error whose message is a sentence. */
export function readPng(name: string, bytes: Uint8Array): Map16 {
    const head = String.fromCharCode(...bytes.subarray(0, 8))
    if (!bytes.length)
        throw new Error(`${name}: this file is empty; choose a PNG picture`)
    if (head !== signature) {
        const other = others.find(([magic]) => head.startsWith(magic))
        throw new Error(`${name}: this is ${other ? other[1] + ', not a PNG' : 'not a PNG picture'}; convert it to PNG`)
    }
    const view = new DataView(bytes.buffer, bytes.byteOffset)
    const [width, height] = bytes.length >= 24 ? [view.getUint32(16), view.getUint32(20)] : [1, 1]
    const damaged = (why: string): never => { throw new Error(`${name}: damaged PNG: ${why}; save it again`) }
    if (!width || !height)
        damaged(`it has ${width}x${height} pixels`)
    if (width > sideMax || height > sideMax || width * height > pixelsMax)
        throw new Error(`${name}: ${width}x${height} pixels; at most ${sideMax} a side and ${pixelsMax} in all are allowed`)
    if (bytes[28] && bytes[24] < 8)
        throw new Error(`${name}: an interlaced PNG with ${bytes[24]} bits a sample; save it without interlacing`)
    let png: DecodedPng
    try {
        png = decode(withoutBombs(bytes, 8 * (width + 1) * (height + 8)), { checkCrc: true })
    } catch (error) {
        return damaged((error as Error).message.replace(/(: undefined)?\W*$/, ''))
    }
    if (png.width !== width || png.height !== height) // by another chunk than the first
        damaged('it says twice how large it is')
    try {
        return widen(png, bytes[25] === 3)
    } catch { // the decoder believes that there is a palette
        return damaged('its palette is not there, or too short')
    }
}

/** Only what makes the samples: of the rest the decoder would inflate a profile. Throws where more is behind the pixels than they can be. */
function withoutBombs(bytes: Uint8Array, most: number): Uint8Array {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length), kept: Uint8Array[] = [bytes.subarray(0, 8)]
    const inflater = new Unzlib(piece => { most -= piece.length }), step = 1 << 16
    let isWhole = true
    for (let at = 8, length; at < bytes.length; at += 12 + length) {
        length = at + 8 <= bytes.length ? view.getUint32(at) : 0
        const kind = String.fromCharCode(...bytes.subarray(at + 4, at + 8)), end = at + 8 + length
        if (/^[A-Z]|^tRNS$/.test(kind))
            kept.push(bytes.subarray(at, end + 4))
        for (let from = at + 8; isWhole && kind === 'IDAT' && from < Math.min(end, bytes.length); from += step) {
            try {
                inflater.push(bytes.subarray(from, Math.min(end, from + step)))
            } catch { // the decoder says so
                isWhole = false
            }
            if (most < -(1 << 20)) // a little more is no harm
                throw new Error('there is more in it than its pixels')
        }
    }
    return joined(kept)
}

/** Only indices look into the palette: true colours suggest one, for screens that have few. */
function widen(png: DecodedPng, isIndexed: boolean): Map16 {
    const { width, height, depth } = png
    if (isIndexed) {
        const rgb = convertIndexedToRgb(png)
        return { width, height, channels: png.palette![0].length, bits: depth, palette: true, samples: Uint16Array.from(rgb, v => 257 * v) }
    }
    const values = depth < 8 ? unpack(png) : png.data
    const scale = 65535 / (2 ** depth - 1) // whole for each depth
    const key = png.transparency // one value or colour that is transparent
    if (!key)
        return { width, height, channels: png.channels, bits: depth, palette: false, samples: Uint16Array.from(values, v => scale * v) }
    const from = png.channels, channels = from + 1
    const samples = new Uint16Array(width * height * channels)
    for (let i = 0; i < width * height; i++) {
        let hit = true
        for (let k = 0; k < from; k++) {
            hit &&= values[from * i + k] === (key[k] & 2 ** depth - 1) // its other bits tell nothing
            samples[channels * i + k] = scale * values[from * i + k]
        }
        samples[channels * i + from] = hit ? 0 : 65535
    }
    return { width, height, channels, bits: depth, palette: false, samples }
}

/** Greys of 1, 2 or 4 bits, whose lines begin with a byte. */
function unpack({ width, height, depth, data }: DecodedPng): Uint8Array {
    const line = Math.ceil(width * depth / 8)
    const out = new Uint8Array(width * height)
    for (let y = 0; y < height; y++)
        for (let x = 0; x < width; x++) {
            const bit = x * depth
            out[y * width + x] = data[y * line + (bit >> 3)] >> 8 - depth - (bit & 7) & (1 << depth) - 1
        }
    return out
}

/** A picture as a PNG: of three equal samples one, colours, or all four. */
export function writePng(width: number, height: number, rgba: Uint8Array, channels: 1 | 3 | 4): Uint8Array<ArrayBuffer> {
    const data = new Uint8Array(width * height * channels)
    for (let i = 0; i < width * height; i++)
        for (let k = 0; k < channels; k++)
            data[channels * i + k] = rgba[4 * i + k]
    return encode({ width, height, channels, depth: 8, data }) as Uint8Array<ArrayBuffer>
}

/** A normal map with 16 bits a sample, of what `glint bake --to=int16` writes; transparent where there is no surface. */
export function writeNormals(width: number, height: number, baked: Uint8Array): Uint8Array<ArrayBuffer> {
    const normals = new Int16Array(baked.slice(0, 6 * width * height).buffer), data = new Uint16Array(4 * width * height)
    for (let i = 0; i < width * height; i++) {
        const normal = normals.subarray(3 * i, 3 * i + 3)
        normal.forEach((v, k) => { data[4 * i + k] = Math.round((v / 32767 + 1) / 2 * 65535) })
        data[4 * i + 3] = normal.some(v => v) ? 65535 : 0
    }
    return encode({ width, height, channels: 4, depth: 16, data }) as Uint8Array<ArrayBuffer>
}
