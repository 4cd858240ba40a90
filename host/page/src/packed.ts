// SPDX-License-Identifier: MIT
// Files that the page packs by itself: pictures that move, as APNG without loss, and archives.

const table = Uint32Array.from({ length: 256 }, (_, n) => {
    for (let i = 0; i < 8; i++)
        n = n & 1 ? 0xedb88320 ^ n >>> 1 : n >>> 1
    return n >>> 0
})
function crc32(bytes: Uint8Array): number {
    let value = ~0
    for (const byte of bytes)
        value = table[(value ^ byte) & 255] ^ value >>> 8
    return ~value >>> 0
}

/** Numbers of so many bytes each. */
function packed(isLittle: boolean, ...numbers: [value: number, bytes: 1 | 2 | 4][]): Uint8Array {
    return Uint8Array.from(numbers.flatMap(([value, bytes]) => {
        const list = Array.from({ length: bytes }, (_, i) => value >>> 8 * i & 255)
        return isLittle ? list : list.reverse()
    }))
}

export function joined(parts: Uint8Array[]): Uint8Array<ArrayBuffer> {
    const out = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0))
    let at = 0
    for (const part of parts) {
        out.set(part, at)
        at += part.length
    }
    return out
}

// ---- APNG ----

export interface Frame { width: number, height: number, rgba: Uint8Array }

function chunk(name: string, ...data: Uint8Array[]): Uint8Array {
    const body = joined([new TextEncoder().encode(name), ...data])
    return joined([packed(false, [body.length - 4, 4]), body, packed(false, [crc32(body), 4])])
}

/** Where two frames differ. */
function changed({ width, height, rgba }: Frame, before?: Frame): { x: number, y: number, w: number, h: number } {
    if (!before)
        return { x: 0, y: 0, w: width, h: height }
    const now = new Uint32Array(rgba.buffer, rgba.byteOffset, width * height), last = new Uint32Array(before.rgba.buffer, before.rgba.byteOffset, width * height)
    let left = width, right = 0, top = height, bottom = 0
    for (let y = 0; y < height; y++)
        for (let x = 0; x < width; x++)
            if (now[y * width + x] !== last[y * width + x]) {
                left = Math.min(left, x)
                right = Math.max(right, x)
                top = Math.min(top, y)
                bottom = y
            }
    return left > right ? { x: 0, y: 0, w: 1, h: 1 } : { x: left, y: top, w: right - left + 1, h: bottom - top + 1 }
}

const paeth = (a: number, b: number, c: number) => {
    const p = a + b - c, pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c)
    return pa <= pb && pa <= pc ? a : pb <= pc ? b : c
}
const filters: ((left: number, above: number, aboveLeft: number) => number)[] = [() => 0, a => a, (_, b) => b, (a, b) => a + b >> 1, paeth]

/** Lines of RGB or RGBA, each by the filter that leaves the smallest numbers. */
function filtered({ width, rgba }: Frame, { x, y, w, h }: { x: number, y: number, w: number, h: number }, of: 3 | 4): Uint8Array<ArrayBuffer> {
    const line = of * w, out = new Uint8Array(h * (line + 1)), trial = new Uint8Array(line)
    let above = new Uint8Array(line), now = new Uint8Array(line)
    for (let k = 0; k < h; k++) {
        for (let i = 0; i < w; i++)
            for (let c = 0; c < of; c++)
                now[of * i + c] = rgba[4 * ((y + k) * width + x + i) + c]
        let least = Infinity
        filters.forEach((filter, kind) => {
            let sum = 0
            for (let i = 0; i < line; i++) {
                const value = now[i] - filter(i < of ? 0 : now[i - of], above[i], i < of ? 0 : above[i - of]) & 255
                trial[i] = value
                sum += Math.min(value, 256 - value)
            }
            if (sum < least) {
                least = sum
                out[k * (line + 1)] = kind
                out.set(trial, k * (line + 1) + 1)
            }
        })
        ;[above, now] = [now, above]
    }
    return out
}

async function deflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
    return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate'))).arrayBuffer())
}

/** Each frame is shown for so many milliseconds, for ever; `next` draws frame i. */
export async function apng(count: number, milliseconds: number, channels: 3 | 4, next: (i: number) => Promise<Frame>): Promise<Uint8Array<ArrayBuffer>> {
    const parts: Uint8Array[] = []
    let before: Frame | undefined, sequence = 0
    for (let i = 0; i < count; i++) {
        const frame = await next(i), box = changed(frame, before)
        if (!before)
            parts.push(Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10), chunk('IHDR', packed(false, [frame.width, 4], [frame.height, 4], [8, 1], [channels === 4 ? 6 : 2, 1], [0, 1], [0, 1], [0, 1])),
                chunk('acTL', packed(false, [count, 4], [0, 4])))
        const data = await deflated(filtered(frame, box, channels))
        parts.push(chunk('fcTL', packed(false, [sequence++, 4], [box.w, 4], [box.h, 4], [box.x, 4], [box.y, 4], [milliseconds, 2], [1000, 2], [0, 1], [0, 1])),
            before ? chunk('fdAT', packed(false, [sequence++, 4]), data) : chunk('IDAT', data))
        before = frame
    }
    return joined([...parts, chunk('IEND')])
}

// ---- an archive ----

/** A ZIP of files as they are. */
export function zip(files: { name: string, bytes: Uint8Array }[]): Uint8Array<ArrayBuffer> {
    const parts: Uint8Array[] = [], list: Uint8Array[] = []
    let at = 0
    for (const { name, bytes } of files) {
        const text = new TextEncoder().encode(name)
        const facts = packed(true, [20, 2], [0, 2], [0, 2], [0, 2], [0x21, 2], [crc32(bytes), 4], [bytes.length, 4], [bytes.length, 4], [text.length, 2], [0, 2])
        const part = joined([packed(true, [0x04034b50, 4]), facts, text, bytes])
        list.push(packed(true, [0x02014b50, 4], [20, 2]), facts, packed(true, [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]), text)
        parts.push(part)
        at += part.length
    }
    const directory = joined(list)
    return joined([...parts, directory, packed(true, [0x06054b50, 4], [0, 2], [0, 2], [files.length, 2], [files.length, 2], [directory.length, 4], [at, 4], [0, 2])])
}
