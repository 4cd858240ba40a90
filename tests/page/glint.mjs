// SPDX-License-Identifier: MIT
// The command, to compare with.
import { execFile, execFileSync, spawnSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pictureOf } from './packed.mjs'

/** The kind of picture that has all that a format has. */
const kind = words => words.includes('--format=argb8888') ? 'png' : 'ppm'
const picture = bytes => bytes[0] === 0x89 ? pictureOf(bytes) : ppm(bytes)

/** A folder that is removed at the end, with the files in it; commands run there. */
export class Command {
    constructor(glint) {
        this.glint = glint
        this.lists = {}
        this.folder = mkdtempSync(join(tmpdir(), 'glint-page-'))
        process.on('exit', () => rmSync(this.folder, { recursive: true, force: true }))
    }

    /** What an option of `glint render` takes by name, as completion gets it: the command's own list. */
    choices(option) {
        return this.lists[option] ??= execFileSync(this.glint, ['render', '--_choices', `${option}=`], { encoding: 'utf8' }).trimEnd().split('\n')
    }

    put(name, bytes) {
        writeFileSync(join(this.folder, name), bytes)
    }

    /** The picture that `glint render` writes, as samples of 8 bits: { width, height, channels, samples }. */
    render(words) {
        const { status, stdout, stderr } = spawnSync(this.glint, ['render', ...words, '--image', kind(words), '-o', '-'], { cwd: this.folder, maxBuffer: 1 << 28 })
        if (status !== 0)
            throw new Error(`glint render ${words.join(' ')}: ${stderr}`)
        return picture(stdout)
    }

    renderLater(words) {
        return new Promise((resolve, reject) => execFile(this.glint, ['render', ...words, '--image', kind(words), '-o', '-'],
            { cwd: this.folder, encoding: 'buffer', maxBuffer: 1 << 28 }, (error, stdout) => error ? reject(error) : resolve(picture(stdout))))
    }

    raw(words) {
        const { stdout } = spawnSync(this.glint, ['render', ...words, '--image', 'raw', '-o', '-'], { cwd: this.folder, maxBuffer: 1 << 28 })
        return stdout
    }

    /** What a board says of the teapot that it holds: its cksum, vertices and triangles, and at how many degrees edges are split. */
    teapotHeld() {
        return this.held(this.files(['bake', '--scene=teapot', '--split=180', '--to=int8', '-o', 'teapot.bin'])['teapot.bin'], 180)
    }

    /** The same of a mesh that is baked so. */
    held(raw, split) {
        const [vertices, triangles] = [raw.readUInt16LE(0), raw.readUInt16LE(2)]
        const summed = raw.subarray(8, 8 + 6 * vertices + 3 * vertices + 3 * vertices % 2 + 6 * triangles)
        const held = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, split, 0, 0, 0])
        held.writeUInt32LE(Number(execFileSync('cksum', { input: summed, encoding: 'utf8' }).split(' ')[0]))
        held.writeUInt16LE(vertices, 4)
        held.writeUInt16LE(triangles, 6)
        return held
    }

    /** What it says when it fails, without its name and where its help is. */
    refusal(words) {
        const { stderr } = spawnSync(this.glint, words, { cwd: this.folder, encoding: 'utf8' })
        return stderr.trim().split('\n').pop().replace(/^glint( [a-z]+)?: /, '').replace(/; see `.*$/, '')
    }

    /** The files that a command writes: name -> bytes. */
    files(words) {
        const before = new Set(readdirSync(this.folder))
        const { status, stderr } = spawnSync(this.glint, words, { cwd: this.folder, encoding: 'utf8' })
        if (status !== 0)
            throw new Error(`glint ${words.join(' ')}: ${stderr}`)
        const made = readdirSync(this.folder).filter(name => !before.has(name))
        const files = Object.fromEntries(made.map(name => [name, readFileSync(join(this.folder, name))]))
        for (const name of made)
            rmSync(join(this.folder, name))
        return files
    }
}

/** P6, P5 or P4. */
function ppm(bytes) {
    const head = bytes.subarray(0, 40).toString('latin1').match(/^P([456])\n(\d+) (\d+)\n(255\n)?/)
    const [kind, width, height] = head.slice(1, 4).map(Number)
    const data = bytes.subarray(head[0].length)
    if (kind !== 4)
        return { width, height, channels: kind === 6 ? 3 : 1, samples: data }
    const line = Math.ceil(width / 8)
    const samples = Buffer.alloc(width * height)
    for (let i = 0; i < samples.length; i++)
        samples[i] = data[Math.floor(i / width) * line + (i % width >> 3)] >> 7 - i % width % 8 & 1 ? 0 : 255
    return { width, height, channels: 1, samples }
}

/** Pixels of a canvas against that: a sentence about the first that differs, or ''. A canvas holds colours times alpha, and rounds them. */
export function difference(rgba, width, height, picture) {
    if (width !== picture.width || height !== picture.height)
        return `${width}x${height} pixels, the command has ${picture.width}x${picture.height}`
    let count = 0, first = ''
    for (let i = 0; i < width * height; i++)
        for (let k = 0; k < 4; k++) {
            const { channels, samples } = picture, alpha = channels === 4 ? samples[4 * i + 3] : 255
            const expected = k === 3 ? alpha : samples[channels * i + (channels > 1 ? k : 0)], near = k < 3 && alpha < 255 ? 255 : 0
            if (Math.abs(rgba[4 * i + k] - expected) * (near ? alpha : 1) > near && !count++)
                first = `at ${i % width},${Math.floor(i / width)} channel ${k} is ${rgba[4 * i + k]}, not ${expected}`
        }
    return count ? `${count} samples differ; ${first}` : ''
}
