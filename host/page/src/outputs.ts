// SPDX-License-Identifier: MIT
// What is taken along: files as the command writes them, and the command line; of what a board draws, while one is connected.
import { ask } from './client'
import { byId, make } from './dom'
import { lastDrawn, onDrawn, viewed } from './picture'
import { link } from './store'
import { commandLine, wordsOf } from './words'
import type { Option, State } from './words'

const status = byId('file-status')
const scene: Option[] = ['height', 'normals', 'scene', 'bevel', 'scale', 'wrap', 'flip-y', 'mask', 'cut-out', 'filter', 'grain', 'size']

function only(options: Option[], state: State): string[] {
    return wordsOf({ ...Object.fromEntries(options.filter(name => state[name] !== undefined).map(name => [name, state[name]])), lights: [] })
}

function save(name: string, bytes: Uint8Array<ArrayBuffer>): void {
    const url = URL.createObjectURL(new Blob([bytes]))
    make('a', { href: url, download: name }).click()
    setTimeout(() => URL.revokeObjectURL(url), 10000)
}

/** Without maps and what else a material has not; of a scene its finish counts. */
const look = (state: State) => wordsOf({ ...state, height: undefined, normals: undefined, albedo: undefined, gloss: undefined, mask: undefined, 'cut-out': undefined, grain: undefined, background: undefined,
    bevel: undefined, scale: undefined, wrap: undefined, 'flip-y': undefined, size: undefined, path: undefined, mesh: undefined, crease: undefined, axes: undefined, split: undefined, turn: undefined, zoom: undefined, perspective: undefined, 'no-outlines': undefined, filter: undefined })
const tables = (state: State, kind: string) => ['glint table', `--kind=${kind}`, ...look({ ...state, lights: [] }), '-o', `${kind}_tables.c`]
/** RGB565 colours go beside normals, not beside a palette's offsets. */
const baked = (state: State, to: string, name: string) => ['glint bake', ...only(to.startsWith('palette') || name.endsWith('.uf2') ? scene : [...scene, 'albedo'], cutOut(state)), `--to=${to}`, '-o', name]
/** What has a background is drawn without what lies around it. */
const cutOut = (state: State): State => state.background !== undefined && (state.scene ?? state.bevel) !== undefined ? { ...state, 'cut-out': '' } : state

/** of: what the surface must be, a map or a mesh. */
const files: { title: string, name: string, words: (state: State) => string[], of?: 'map' | 'mesh' }[] = [
    { title: 'Material, C', name: 'material', words: state => ['glint material', ...look(state), '-o', 'material.h'] },
    { title: 'Tables, 20 KB', name: 'colour', words: state => tables(state, 'colour') },
    { title: 'Tables over a map', name: 'albedo', words: state => tables(state, 'albedo') },
    { title: 'Normals, 8 bits, C', name: 'int8', words: state => baked(state, 'int8', 'normals.c'), of: 'map' },
    { title: 'Normals, 16 bits, C', name: 'int16', words: state => baked(state, 'int16', 'normals.c'), of: 'map' },
    { title: 'Palette, C', name: 'palette', words: state => baked(state, 'palette', 'normals.c'), of: 'map' },
    { title: 'Normals, raw', name: 'raw', words: state => baked(state, 'int8', 'normals.bin'), of: 'map' },
    { title: 'Normals, UF2', name: 'uf2', words: state => baked(state, 'int8', 'normals.uf2'), of: 'map' },
    { title: 'Mesh, C', name: 'mesh', words: state => ['glint bake', ...only(['scene', 'mesh', 'crease', 'axes', 'split', 'no-outlines'], state), '-o', 'mesh.c'], of: 'mesh' },
]

async function run(wordsFor: (state: State) => string[]): Promise<void> {
    status.textContent = 'Working…'
    try {
        const words = wordsFor((await viewed()).state)
        const { files, printed, warnings } = await ask('run', words)
        for (const { name, bytes } of files)
            save(name, bytes)
        const [first, ...rest] = words
        status.textContent = `${files.map(file => file.name).join(' and ')}: as ${commandLine(first, rest)} writes them. ${[...warnings, ...printed.split('\n').filter(line => line.startsWith('such a picture'))].join(' ')}`
    } catch (error) {
        status.textContent = (error as Error).message
    }
}

async function savePicture(): Promise<void> {
    const drawn = lastDrawn()
    if (!drawn)
        return
    const grey = /^(grey\d|mono)$/.test(drawn.state.format ?? '')
    save('glint.png', await ask('png', drawn.width, drawn.height, drawn.rgba, grey))
    status.textContent = `glint.png: the pixels of ${line(drawn.state)}`
}

/** The map that the command line of a board's picture names. */
async function saveGloss(): Promise<void> {
    const drawn = lastDrawn()
    if (!drawn?.white)
        return
    save(drawn.white, await ask('png', drawn.width, drawn.height, new Uint8Array(4 * drawn.width * drawn.height).fill(255), true))
    status.textContent = `${drawn.white}: the map by which all of the surface has full gloss, as on the board; the command line above reads it`
}

const line = (state: State) => commandLine('glint render', [...wordsOf(state), '-o', 'glint.png'])

byId('files').append(make('button', { type: 'button', textContent: 'Picture, PNG', id: 'file-png', onclick: () => void savePicture() }),
    make('button', { type: 'button', textContent: 'Full gloss, PNG', id: 'file-gloss', hidden: true, onclick: () => void saveGloss() }),
    ...files.map(({ title, name, words }) => make('button', { type: 'button', textContent: title, id: `file-${name}`, onclick: () => void run(words) })))

async function copy(text: string, button: HTMLElement): Promise<void> {
    const title = button.textContent
    try {
        await navigator.clipboard.writeText(text)
        button.textContent = 'Copied'
    } catch { // a page from a file may not be allowed to
        const area = make('textarea', { value: text })
        document.body.append(area)
        area.select()
        button.textContent = document.execCommand('copy') ? 'Copied' : 'Select and copy it'
        area.remove()
    }
    setTimeout(() => { button.textContent = title }, 1500)
}
byId('copy').onclick = event => void copy(byId('command').textContent ?? '', event.currentTarget as HTMLElement)
byId('copy-link').onclick = event => void copy(link(), event.currentTarget as HTMLElement)

onDrawn(({ facts, state, isBoards, white }) => {
    byId('command').textContent = line(state)
    byId('out-board').hidden = !isBoards
    byId('file-gloss').hidden = !white
    for (const { name, of } of files)
        byId(`file-${name}`).hidden = of !== undefined && of !== (facts.turn ? 'mesh' : 'map')
})
