// SPDX-License-Identifier: MIT
// An OBJ and what it names, materials (MTL) and their pictures, as one file, since the page keeps a mesh in one: the first line, a comment, tells
// names and lengths.

export interface Part { name: string, bytes: Uint8Array<ArrayBuffer> }
const mark = '#glint '

export const isObj = (name: string) => /\.obj$/i.test(name)

/** The OBJ first. */
export function together(parts: Part[]): Uint8Array<ArrayBuffer> {
    const line = new TextEncoder().encode(`${mark}${JSON.stringify(parts.map(({ name, bytes }) => [name, bytes.length]))}\n`)
    const out = new Uint8Array(parts.reduce((sum, { bytes }) => sum + bytes.length, line.length))
    out.set(line)
    let at = line.length
    for (const { bytes } of parts) {
        out.set(bytes, at)
        at += bytes.length
    }
    return out
}

/** Of any other file it is the only part. */
export function apart(name: string, file: Uint8Array<ArrayBuffer>): Part[] {
    const end = file.indexOf(10), line = new TextDecoder().decode(file.subarray(0, Math.max(0, end)))
    if (line.startsWith(mark))
        try {
            let at = end + 1
            const list = JSON.parse(line.slice(mark.length)) as [unknown, number][]
            if (list.length && list.every(([, length]) => Number.isInteger(length) && length >= 0) && list.reduce((sum, [, length]) => sum + length, at) === file.length)
                return list.map(([of, length]) => ({ name: String(of), bytes: file.slice(at, at += length) }))
        } catch { /* a comment of its own */ }
    return [{ name, bytes: file }]
}

/** Of the files beside an OBJ: its materials, and the pictures that they name. */
export async function namedBy(files: File[]): Promise<File[]> {
    const libraries = files.filter(({ name }) => /\.mtl$/i.test(name)), texts = await Promise.all(libraries.map(file => file.text()))
    return [...libraries, ...files.filter(({ name }) => /\.png$/i.test(name) && texts.some(text => text.includes(name)))]
}
