// SPDX-License-Identifier: MIT
// An OBJ and what it names, materials (MTL) and their pictures, as one file, since the page keeps a mesh in one: the first line, a comment, tells
// names and lengths.

export interface Part { name: string, bytes: Uint8Array<ArrayBuffer> }
const mark = '#glint ', partsMost = 1 << 13 // more than an OBJ can name with as many materials as the command takes

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
            if (list.length && list.length <= partsMost && list.every(([, length]) => Number.isInteger(length) && length >= 0) && list.reduce((sum, [, length]) => sum + length, at) === file.length)
                return list.map(([of, length]) => ({ name: String(of), bytes: file.slice(at, at += length) }))
        } catch { /* a comment of its own */ }
    return [{ name, bytes: file }]
}

/** The files that an MTL names, without folders: behind a line's first word and its options. */
function namesIn(mtl: string): string[] {
    const options = /^(?:(?:-(?:mm|[ost])(?:\s+[-+.\de]+(?=\s))+|-\w+\s+\S+)\s+)*/i
    return mtl.replace(/^[ \t]*#.*/gm, '').replace(/\\(\r\n?|\n)/g, ' ').split(/[\r\n]+/).map(line => line.trim().replace(/^\S+\s*/, '').replace(options, '').replace(/^.*[/\\]/, ''))
}

/** A file that cannot be read is refused by its name. */
export async function bytesIn(file: File): Promise<Uint8Array<ArrayBuffer>> {
    try {
        return new Uint8Array(await file.arrayBuffer())
    } catch (error) {
        throw new Error(`${file.name}: cannot be read (${(error as Error).message}); is it a folder?`)
    }
}

const libraryBytes = 1 << 24 // as the command has it
async function textOf(file: File): Promise<string> {
    if (file.size > libraryBytes)
        throw new Error(`${file.name}: has more than 16 MB; choose the OBJ without it`)
    return new TextDecoder().decode(await bytesIn(file))
}

/** Of the files beside an OBJ: its materials, and the pictures that they name. Throws where two have one name. */
export async function namedBy(files: File[]): Promise<File[]> {
    const libraries = files.filter(({ name }) => /\.mtl$/i.test(name)), names = new Set((await Promise.all(libraries.map(textOf))).flatMap(namesIn))
    const named = [...libraries, ...files.filter(({ name }) => /\.png$/i.test(name) && names.has(name))], had = new Set<string>()
    for (const { name } of named) {
        if (had.has(name))
            throw new Error(`${name}: two of the files have this name; rename one, and change its name in the ${/\.mtl$/i.test(name) ? 'OBJ' : 'MTL'}`)
        had.add(name)
    }
    return named
}
