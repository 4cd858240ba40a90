// SPDX-License-Identifier: MIT
// PNG files of every kind that people drop, from formulas: no encoder is in between that could choose another kind.
import { deflateSync } from 'node:zlib'

export function crc(bytes) { // node 18's zlib has none
    let value = ~0
    for (const byte of bytes) {
        value ^= byte
        for (let i = 0; i < 8; i++)
            value = value >>> 1 ^ (value & 1 ? 0xedb88320 : 0)
    }
    return ~value >>> 0
}

function chunk(name, data) {
    const body = Buffer.concat([Buffer.from(name, 'latin1'), data])
    const out = Buffer.alloc(body.length + 8)
    out.writeUInt32BE(data.length)
    body.copy(out, 4)
    out.writeUInt32BE(crc(body), body.length + 4)
    return out
}

const channelsOf = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 }

/** type: PNG's colour type; sample(x, y, channel): a whole number of `depth` bits; extra: chunks before the data; behind: so many zeros behind it. */
export function png({ width, height, type, depth, sample, extra = [], filter = 0, behind = 0 }) {
    const channels = channelsOf[type], lineBytes = Math.ceil(width * channels * depth / 8), step = Math.max(1, channels * depth / 8)
    const lines = []
    let above = Buffer.alloc(lineBytes)
    for (let y = 0; y < height; y++) {
        const line = Buffer.alloc(lineBytes)
        for (let i = 0; i < width * channels; i++) {
            const value = sample(Math.floor(i / channels), y, i % channels)
            if (depth === 16)
                line.writeUInt16BE(value, 2 * i)
            else
                line[i * depth >> 3] |= value << 8 - depth - (i * depth & 7)
        }
        const filtered = Buffer.from(line)
        if (filter === 1)
            for (let i = step; i < lineBytes; i++)
                filtered[i] = line[i] - line[i - step]
        if (filter === 2)
            for (let i = 0; i < lineBytes; i++)
                filtered[i] = line[i] - above[i]
        lines.push(Buffer.from([filter]), filtered)
        above = line
    }
    const head = Buffer.alloc(13)
    head.writeUInt32BE(width)
    head.writeUInt32BE(height, 4)
    head.set([depth, type, 0, 0, 0], 8)
    return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head),
        ...extra.map(([name, data]) => chunk(name, Buffer.from(data))), chunk('IDAT', deflateSync(Buffer.concat([...lines, Buffer.alloc(behind)]))), chunk('IEND', Buffer.alloc(0))])
}

const width = 45, height = 33
/** Hills, 0..1. */
const hill = (x, y) => (Math.sin(x / 5) * Math.cos(y / 4) + 1) / 2
const slopes = (x, y) => [-Math.cos(x / 5) * Math.cos(y / 4) / 3, -Math.sin(x / 5) * Math.sin(y / 4) / 3]
/** A normal's channel, 0..1; y up. */
function normal(x, y, k) {
    const [right, up] = slopes(x, y), length = Math.hypot(right, up, 1)
    return ([right, up, 1][k] / length + 1) / 2
}
const bits = (depth) => (value) => Math.round(value * (2 ** depth - 1))
const gamma = ['gAMA', [0, 0, 0xb1, 0x8f]] // 1 / 2.2: to be left alone
const palette = Array.from({ length: 16 }, (_, i) => [17 * i, 255 - 12 * i, 40 + 13 * i]).flat()
const suggested = Array.from({ length: 256 }, (_, i) => [255 - i, i, 7 * i & 255]).flat()
const disc = (x, y) => Math.max(0, Math.min(1, 12 - Math.hypot(x - width / 2, y - height / 2)))

/** name: [bytes, the words that use it as a surface]. */
export const surfaces = Object.fromEntries([
    ['grey8', { type: 0, depth: 8, sample: (x, y) => bits(8)(hill(x, y)) }, ['--height']],
    ['grey16', { type: 0, depth: 16, sample: (x, y) => bits(16)(hill(x, y)), filter: 1 }, ['--height', '--scale=5']],
    ['grey16 with gamma', { type: 0, depth: 16, sample: (x, y) => bits(16)(hill(x, y)), extra: [gamma] }, ['--height', '--wrap']],
    ['grey4', { type: 0, depth: 4, sample: (x, y) => bits(4)(hill(x, y)) }, ['--height', '--scale=20']],
    ['grey2', { type: 0, depth: 2, sample: (x, y) => bits(2)(hill(x, y)) }, ['--height', '--size=64x48']],
    ['grey1', { type: 0, depth: 1, sample: (x, y) => Math.round(disc(x, y)) }, ['--height', '--bevel=6']],
    ['palette4', { type: 3, depth: 4, sample: (x, y) => bits(4)(hill(x, y)), extra: [['PLTE', palette]] }, ['--height']],
    ['palette8 with alpha', { type: 3, depth: 8, sample: (x, y) => bits(4)(hill(x, y)), extra: [['PLTE', palette], ['tRNS', [0, 128, 255, 0]]] }, ['--height']],
    ['a transparent grey', { type: 0, depth: 8, sample: (x, y) => bits(3)(hill(x, y)), extra: [['tRNS', [0, 5]]] }, ['--height', '--bevel=4']],
    ['a transparent grey of 4 bits', { type: 0, depth: 4, sample: (x, y) => bits(3)(hill(x, y)), extra: [['tRNS', [255, 0xf5]]] }, ['--height', '--bevel=4']],
    ['a logo', { type: 6, depth: 8, sample: (x, y, k) => k === 3 ? bits(8)(disc(x, y)) : 30 * k }, ['--height', '--bevel=6']],
    ['rgb8', { type: 2, depth: 8, sample: (x, y, k) => bits(8)(normal(x, y, k)), filter: 2 }, ['--normals']],
    ['rgb16', { type: 2, depth: 16, sample: (x, y, k) => bits(16)(normal(x, y, k)), extra: [gamma] }, ['--normals']],
    ['rgba8', { type: 6, depth: 8, sample: (x, y, k) => k === 3 ? bits(8)(disc(x, y)) : bits(8)(normal(x, y, k)) }, ['--normals']],
    ['rgba16', { type: 6, depth: 16, sample: (x, y, k) => k === 3 ? bits(16)(disc(x, y)) : bits(16)(normal(x, y, k)) }, ['--normals', '--flip-y']],
    ['rgb8 that suggests a palette', { type: 2, depth: 8, sample: (x, y, k) => bits(8)(normal(x, y, k)), extra: [['PLTE', suggested]] }, ['--normals']],
    ['rgb16 that suggests a palette', { type: 2, depth: 16, sample: (x, y, k) => bits(16)(normal(x, y, k)), extra: [['PLTE', suggested]] }, ['--normals']],
    ['grey and alpha', { type: 4, depth: 8, sample: (x, y, k) => bits(8)(normal(x, y, k)) }, ['--normals']],
].map(([name, kind, words]) => [`${name.replaceAll(' ', '-')}.png`, { bytes: png({ width, height, ...kind }), words }]))

/** Maps of the same size that go with them. */
export const extras = {
    'albedo.png': png({ width, height, type: 6, depth: 8, sample: (x, y, k) => (5 * x + 90 * k + 3 * y) & 255, extra: [gamma] }),
    'albedo16.png': png({ width, height, type: 2, depth: 16, sample: (x, y, k) => (1411 * x + 9001 * k + 377 * y) & 65535 }),
    'grain.png': png({ width, height, type: 0, depth: 8, sample: (x, y) => (3 * x + 7 * y) & 255 }),
    'gloss.png': png({ width, height, type: 0, depth: 8, sample: (x, y) => (9 * x + y) & 255 }),
    'mask.png': png({ width, height, type: 0, depth: 1, sample: (x, y) => (x + y) >> 3 & 1 ^ 1 }),
}
