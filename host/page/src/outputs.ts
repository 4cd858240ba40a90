// SPDX-License-Identifier: MIT
// What is taken along: pictures, programs, files as the command writes them, and the command line; of what a board draws, while one is
// connected.
import { ask, Stopped } from './client'
import { byId, make } from './dom'
import { apng, zip } from './packed'
import { drawnNow, onDrawn, setWorking } from './picture'
import type { Drawn } from './picture'
import { pictureHeader, programs } from './programs'
import type { Kind } from './programs'
import { stagePicture } from './stage'
import { current, link } from './store'
import { movedTo, orbitAt, selectedLight } from './sun'
import { onShown } from './tabs'
import { commandLine, isGrainMap, wordsOf } from './words'
import type { Option, State } from './words'

const status = byId('file-status')
const scene: Option[] = ['height', 'normals', 'scene', 'bevel', 'fit', 'scale', 'wrap', 'flip-y', 'mask', 'cut-out', 'filter', 'grain', 'size']

/** What is baked; grain of a kind is a material's, and only of a file is there something to bake. */
function only(options: Option[], state: State): string[] {
    return wordsOf({ ...Object.fromEntries(options.filter(name => state[name] !== undefined && (name !== 'grain' || isGrainMap(state[name]))).map(name => [name, state[name]])), lights: [] })
}

function save(name: string, content: Uint8Array<ArrayBuffer> | Blob): void {
    const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content]))
    make('a', { href: url, download: name }).click()
    setTimeout(() => URL.revokeObjectURL(url), 10000)
}

/** Without maps and what else a material has not; of a scene its finish counts. */
const look = (state: State) => wordsOf({ ...state, height: undefined, normals: undefined, albedo: undefined, gloss: undefined, mask: undefined, 'cut-out': undefined, grain: undefined, background: undefined,
    bevel: undefined, fit: undefined, scale: undefined, wrap: undefined, 'flip-y': undefined, size: undefined, path: undefined, mesh: undefined, crease: undefined, axes: undefined, split: undefined, texture: undefined, nearest: undefined, turn: undefined, zoom: undefined, perspective: undefined, 'no-outlines': undefined, filter: undefined })
const tables = (state: State, kind: string) => ['glint table', `--kind=${kind}`, ...look({ ...state, lights: [] }), '-o', `${kind}_tables.c`]
/** RGB565 colours go beside normals, not beside a palette's offsets. */
const baked = ({ state, facts }: Pick<Drawn, 'state' | 'facts'>, to: string, name: string) => ['glint bake', ...only(to.startsWith('palette') || name.endsWith('.uf2') ? scene : [...scene, 'albedo'], cutOut(state)),
    ...state.filter === undefined ? [] : [`-n${facts.n}`], `--to=${to}`, '-o', name] // what is filtered is for one shininess
/** What has a background is drawn without what lies around it. */
const cutOut = (state: State): State => state.background !== undefined && (state.scene ?? state.bevel) !== undefined ? { ...state, 'cut-out': '' } : state

/** As the command writes them. */
const run = (words: (drawn: Drawn) => string[]) => async (drawn: Drawn) => {
    const line = words(drawn), { files, printed, warnings } = await ask('run', line)
    for (const { name, bytes } of files)
        save(name, bytes)
    const [first, ...rest] = line
    return `${files.map(file => file.name).join(' and ')}: as ${commandLine(first, rest)} writes them. ${[...warnings, ...printed.split('\n').filter(line => line.startsWith('such a picture'))].join(' ')}`
}

/** Samples of a pixel, where it is no grey. */
const colours = ({ format }: State) => format === 'argb8888' ? 4 : 3

async function savePicture({ width, height, rgba, state }: Drawn): Promise<string> {
    save('glint.png', await ask('png', width, height, rgba, /^(grey\d|mono)$/.test(state.format ?? '') ? 1 : colours(state)))
    return 'glint.png: the panel\'s pixels'
}

async function saveStage(): Promise<string> {
    const picture = await stagePicture()
    if (!picture)
        throw new Error('The browser makes no picture of this size; choose a smaller panel or zoom')
    save('stage.png', picture)
    return 'stage.png: the panel in its bezel'
}

async function saveNormals({ width, height, state }: Drawn): Promise<string> {
    const { files } = await ask('run', ['glint bake', ...only(scene, cutOut(state)), '--to=int16', '-o', 'normals.bin'])
    save('normals.png', await ask('normals', width, height, files[0].bytes))
    return 'normals.png: 16 bits a channel, green up, for --normals and for other programs'
}

const frames = 48
/** The words of each: the mesh goes round once, or the chosen light. At once, for a light's place is a part of the picture that is shown now. */
function frameWords({ state, facts }: Drawn): string[][] {
    const chosen = selectedLight(), [x, y, z] = facts.turn ?? []
    const lights = state.lights.length ? state.lights : [{ kind: 'light' as const, text: '-1,1,1' }]
    return Array.from({ length: frames }, (_, k) => wordsOf({ ...state, ...facts.turn ? { turn: [x, y + 360 * k / frames, z].map(v => Number((((v + 180) % 360 + 360) % 360 - 180).toFixed(1))).join() }
        : { lights: lights.map((light, at) => at === chosen ? movedTo(light, ...orbitAt(k / frames)) : light) } }))
}

async function saveAnimation(drawn: Drawn): Promise<string> {
    const lines = frameWords(drawn)
    let isStopped = false
    setWorking(() => { isStopped = true })
    try {
        const bytes = await apng(frames, 4000 / frames, colours(drawn.state), async k => {
            if (isStopped)
                throw new Stopped()
            status.textContent = `Frame ${k + 1} of ${frames}`
            return ask('aside', lines[k])
        })
        save('glint.apng', bytes)
        return `glint.apng: ${frames} pictures in 4 s, ${(bytes.length / 1e6).toFixed(1)} MB, each as the command draws it`
    } finally {
        setWorking()
    }
}

/** In one colour and with full gloss, as a board has it. */
const program = (kind: Kind) => async ({ state: now, facts }: Drawn) => {
    const { name, text, format = own => own } = programs[kind]
    const wanted = { ...now, format: format(now.format ?? 'rgb888'), color: now.color ?? (facts.has_albedo[0] ? facts.colour.join() : undefined), albedo: undefined }
    const { files: [material] } = await ask('run', ['glint material', ...look(wanted), '-o', 'material.h'])
    const { files: normals } = await ask('run', baked({ state: wanted, facts }, 'int8', 'normals.c'))
    const header = new TextDecoder().decode(normals.find(file => file.name.endsWith('.h'))!.bytes)
    const own = { 'picture.h': pictureHeader(now, { ...facts, albedo: wanted.color?.split(',').map(Number) ?? facts.albedo }, header, wanted.format), [name]: text(wanted.format) }
    save('picture.zip', zip([material, ...normals, ...Object.entries(own).map(([name, text]) => ({ name, bytes: new TextEncoder().encode(text) }))]
        .map(({ name, bytes }) => ({ name: `picture/${name}`, bytes }))))
    return `picture.zip: ${name} and what it includes; it draws the picture in one colour, with full gloss${wanted.background ? ', over black' : ''}${wanted.filter ? ', without how details shade each other' : ''}. Beside it compile glint.`
}

async function saveGloss({ white, width, height }: Drawn): Promise<string> {
    save(white!, await ask('png', width, height, new Uint8Array(4 * width * height).fill(255), 1))
    return `${white}: the map by which all of the surface has full gloss, as on the board; the command line below reads it`
}

/** of: what the surface must be, a map or a mesh. */
const groups: [string, { title: string, name: string, save: (drawn: Drawn) => Promise<string>, of?: 'map' | 'mesh' | 'board' }[]][] = [
    ['Pictures', [
        { title: 'Picture, PNG', name: 'png', save: savePicture },
        { title: 'Stage, PNG', name: 'stage', save: saveStage },
        { title: 'Animation, APNG', name: 'apng', save: saveAnimation },
        { title: 'Normal map, PNG', name: 'normals', save: saveNormals, of: 'map' },
        { title: 'Full gloss, PNG', name: 'gloss', save: saveGloss, of: 'board' },
    ]],
    ['Programs that draw it', [
        { title: 'For LVGL', name: 'lvgl', save: program('lvgl'), of: 'map' },
        { title: 'For Arduino', name: 'arduino', save: program('arduino'), of: 'map' },
        { title: 'Plain C', name: 'c', save: program('c'), of: 'map' },
    ]],
    ['Parts, as the command writes them', [
        { title: 'Material, C', name: 'material', save: run(({ state }) => ['glint material', ...look(state), '-o', 'material.h']) },
        { title: 'Tables, 20 KB', name: 'colour', save: run(({ state }) => tables(state, 'colour')) },
        { title: 'Tables for colours', name: 'albedo', save: run(({ state }) => tables(state, 'albedo')) },
        { title: 'Normals, 8 bits', name: 'int8', save: run(drawn => baked(drawn, 'int8', 'normals.c')), of: 'map' },
        { title: 'Normals, 16 bits', name: 'int16', save: run(drawn => baked(drawn, 'int16', 'normals.c')), of: 'map' },
        { title: 'Palette, C', name: 'palette', save: run(drawn => baked(drawn, 'palette', 'normals.c')), of: 'map' },
        { title: 'Normals, raw', name: 'raw', save: run(drawn => baked(drawn, 'int8', 'normals.bin')), of: 'map' },
        { title: 'Normals, UF2', name: 'uf2', save: run(drawn => baked(drawn, 'int8', 'normals.uf2')), of: 'map' },
        { title: 'Mesh, C', name: 'mesh', save: run(({ state }) => ['glint bake', ...only(['scene', 'mesh', 'crease', 'axes', 'split', 'texture', 'nearest', 'no-outlines'], state), '-o', 'mesh.c']), of: 'mesh' },
    ]],
]

/** All of a file is of one picture, whatever is changed meanwhile. */
async function work(save: (drawn: Drawn) => Promise<string>): Promise<void> {
    status.textContent = 'Working…'
    try {
        status.textContent = await save(await drawnNow())
    } catch (error) {
        status.textContent = error instanceof Stopped ? 'Stopped; nothing was saved' : (error as Error).message
    }
}
const files = groups.flatMap(([title, list]) => {
    const heading = make('h4', { textContent: title })
    byId('files').append(heading)
    return list.map(({ title, name, save, of }) => {
        const button = make('button', { type: 'button', textContent: title, id: `file-${name}`, onclick: () => void work(save), hidden: of === 'board' })
        byId('files').append(button)
        return { button, heading, of }
    })
})

const line = (state: State) => commandLine('glint render', [...wordsOf(state), '-o', 'glint.png'])

async function copy(text: string, button: HTMLElement): Promise<void> {
    const title = button.dataset.title ??= button.textContent!
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

onShown(group => { status.hidden = group !== 'output' })
onDrawn(({ facts, state, isBoards, white, standsIn }) => {
    byId('command').textContent = line(standsIn ? current() : state)
    byId('out-board').hidden = !isBoards
    const is = (of?: string) => of === undefined || of === (facts.turn ? 'mesh' : 'map') || of === 'board' && white !== undefined
    for (const { button, heading, of } of files)
        button.hidden = !is(of), heading.hidden = !files.some(file => file.heading === heading && is(file.of))
})
