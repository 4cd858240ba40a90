// SPDX-License-Identifier: MIT
// What the page packs, unpacked by other means: archives by unzip, pictures that move by zlib and PNG's own words.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { inflateSync } from 'node:zlib'
import { check, equal } from '../pico/tap.mjs'
import { crc } from './maps.mjs'

/** name -> bytes; Python's zipfile checks the sums. */
export function unzipped(bytes) {
    const folder = mkdtempSync(join(tmpdir(), 'glint-zip-'))
    writeFileSync(join(folder, 'a.zip'), bytes)
    const text = execFileSync('python3', ['-c', 'import base64, json, sys, zipfile\nz = zipfile.ZipFile(sys.argv[1])\nassert z.testzip() is None\nprint(json.dumps({n: base64.b64encode(z.read(n)).decode() for n in z.namelist()}))', join(folder, 'a.zip')], { maxBuffer: 1 << 28 })
    rmSync(folder, { recursive: true })
    return Object.fromEntries(Object.entries(JSON.parse(text)).map(([name, base64]) => [name, Buffer.from(base64, 'base64')]))
}

const paeth = (a, b, c) => {
    const p = a + b - c, [pa, pb, pc] = [a, b, c].map(v => Math.abs(p - v))
    return pa <= pb && pa <= pc ? a : pb <= pc ? b : c
}

/** Samples of 8 bits, w x h pixels of so many bytes, out of their filtered lines. */
function unfiltered(data, w, h, of) {
    const line = of * w, out = Buffer.alloc(line * h)
    equal(data.length, h * (line + 1), 'bytes of a frame')
    for (let y = 0; y < h; y++)
        for (let i = 0; i < line; i++) {
            const a = i < of ? 0 : out[y * line + i - of], b = y ? out[(y - 1) * line + i] : 0, c = i < of || !y ? 0 : out[(y - 1) * line + i - of]
            out[y * line + i] = data[y * (line + 1) + 1 + i] + [0, a, b, a + b >> 1, paeth(a, b, c)][data[y * (line + 1)]]
        }
    return out
}

function chunksOf(file) {
    const chunks = []
    equal(file.toString('latin1', 0, 8), '\x89PNG\r\n\x1a\n', 'signature')
    for (let at = 8; at < file.length;) {
        const length = file.readUInt32BE(at), body = file.subarray(at + 4, at + 8 + length)
        equal(file.readUInt32BE(at + 8 + length), crc(body), 'the sum of a chunk')
        chunks.push([body.toString('latin1', 0, 4), body.subarray(4)])
        at += length + 12
    }
    return chunks
}

const channelsOf = { 2: 3, 6: 4 }

/** A PNG of RGB or RGBA: { width, height, channels, samples }. */
export function pictureOf(file) {
    const chunks = chunksOf(file), [, head] = chunks[0], width = head.readUInt32BE(0), height = head.readUInt32BE(4), channels = channelsOf[head[9]]
    const data = inflateSync(Buffer.concat(chunks.filter(([name]) => name === 'IDAT').map(([, data]) => data)))
    return { width, height, channels, samples: unfiltered(data, width, height, channels) }
}

/** The pictures of an APNG: { width, height, rgba }, each as it is shown. */
export function framesOf(file) {
    const chunks = chunksOf(file), [, head] = chunks[0], width = head.readUInt32BE(0), height = head.readUInt32BE(4), of = channelsOf[head[9]], count = chunks.find(([name]) => name === 'acTL')[1].readUInt32BE(0)
    const frames = [], shown = Buffer.alloc(4 * width * height, 255)
    let control, sequence = 0
    for (const [name, data] of chunks) {
        if (name === 'fcTL' || name === 'fdAT')
            equal(data.readUInt32BE(0), sequence++, 'sequence')
        if (name === 'fcTL')
            control = { w: data.readUInt32BE(4), h: data.readUInt32BE(8), x: data.readUInt32BE(12), y: data.readUInt32BE(16) }
        if (name !== 'IDAT' && name !== 'fdAT')
            continue
        const { w, h, x, y } = control, samples = unfiltered(inflateSync(name === 'IDAT' ? data : data.subarray(4)), w, h, of)
        check(x + w <= width && y + h <= height, 'a frame is outside of the picture')
        for (let i = 0; i < w * h; i++)
            for (let k = 0; k < of; k++)
                shown[4 * ((y + Math.floor(i / w)) * width + x + i % w) + k] = samples[of * i + k]
        frames.push({ width, height, rgba: Buffer.from(shown) })
    }
    equal(frames.length, count, 'frames')
    return frames
}
