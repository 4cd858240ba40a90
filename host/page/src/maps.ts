// SPDX-License-Identifier: MIT
// The surface: built-in scenes, and PNG files, or the mesh of an STL, that are chosen or dropped.
import lists from 'glint:lists'
import { ask } from './client'
import { buttons, byId, capital, make } from './dom'
import { redraw } from './picture'
import { change, current, onChange } from './store'
import { isGrainMap, isMesh } from './words'
import type { Option, State } from './words'

const scenes = lists.scenes.map(({ name }) => name)
const kinds = ['height', 'normals', 'mesh', 'albedo', 'gloss', 'mask', 'grain'] as const
type Kind = typeof kinds[number]
const without: Partial<State> = { height: undefined, normals: undefined, mesh: undefined, crease: undefined, axes: undefined, mask: undefined, 'cut-out': undefined, filter: undefined, grain: undefined, albedo: undefined, gloss: undefined, scale: undefined, bevel: undefined, wrap: undefined, 'flip-y': undefined, color: undefined, split: undefined, turn: undefined, zoom: undefined, perspective: undefined, 'no-outlines': undefined }

const press = buttons(byId('scenes'), scenes, capital, scene => change({ ...without, scene, size: current().size ?? '240x240' }))

/** Of the user's maps so far. */
export const mapNames = new Set<string>()
let meshesSoFar = 0
/** Another one where a mesh may have another content under its name. */
export const meshVersion = () => meshesSoFar

async function read(file: File, name: string, kind: Kind): Promise<void> {
    const bytes = new Uint8Array(await file.arrayBuffer())
    if (kind === 'mesh') {
        if (!/\.stl$/i.test(name))
            throw new Error(`${name}: the page reads meshes from binary STL files alone; glint render --mesh reads others, too`)
        await ask('mesh', name, bytes)
        meshesSoFar++
        return
    }
    mapNames.add(name)
    await ask('map', name, bytes)
}

/** The name in the command line, which must not look like a path. */
async function take(file: File, kind: Kind): Promise<void> {
    try {
        const name = file.name.replace(/[/\\]/g, '_')
        await read(file, name, kind)
        if (current()[kind] === name) { // an address asked for it, or it is a newer one: what is set stays
            void redraw()
            return
        }
        const surface: Partial<State> = !isSurface(kind) ? {}
            : { ...without, scene: undefined, size: kind === 'mesh' ? current().size ?? '240x240' : undefined }
        if (kind === 'albedo')
            surface.color = undefined
        change({ ...surface, [kind]: name })
    } catch (error) {
        byId('refusal').textContent = (error as Error).message
        byId('refusal').hidden = false
    }
}

/** What the state names it for, or by its name, as artists call them. */
function kindOf(name: string): Kind {
    if (/\.(stl|obj|ply|gltf|glb)$/i.test(name))
        return 'mesh'
    const words: [RegExp, Kind][] = [[/grain|aniso|brush/i, 'grain'], [/norm|nrm|_n\b/i, 'normals'], [/gloss|rough|spec/i, 'gloss'], [/mask|opacity/i, 'mask'], [/albedo|colou?r|diff|base/i, 'albedo']]
    return kinds.find(kind => current()[kind] === name) ?? words.find(([pattern]) => pattern.test(name))?.[1] ?? 'height'
}

const updates: (() => void)[] = []
const isSurface = (kind: Kind) => kind === 'height' || kind === 'normals' || kind === 'mesh'
const titles: Record<Kind, string> = { height: 'Height', normals: 'Normals', mesh: 'Mesh', albedo: 'Albedo', gloss: 'Gloss', mask: 'Mask', grain: 'Grain' }
/** The file's name; a grain may be of a kind instead. */
const fileOf = (kind: Kind, name = current()[kind]) => kind === 'grain' && name !== undefined && !isGrainMap(name) ? undefined : name
for (const kind of kinds) {
    const input = make('input', { type: 'file', accept: kind === 'mesh' ? '.stl' : 'image/png,.png', className: 'hidden', id: `map-${kind}` })
    input.onchange = () => {
        if (input.files?.[0])
            void take(input.files[0], kind)
        input.value = ''
    }
    const label = make('label', { htmlFor: input.id, className: 'file', textContent: 'Choose', aria: { label: `Choose: ${titles[kind]}` } })
    const name = make('span', { className: 'name' })
    const clear = make('button', { type: 'button', textContent: '×', aria: { label: `${titles[kind]}: remove` }, onclick: () => change({ [kind]: undefined }) })
    updates.push(() => {
        name.textContent = fileOf(kind) ?? '—'
        clear.hidden = fileOf(kind) === undefined || isSurface(kind)
    })
    byId('map-rows').append(make('div', { className: 'map' }, make('span', { textContent: titles[kind] }), name,
        make('span', { className: 'group' }, make('span', {}, input, label), clear)))
}

function field(option: Option, title: string, meaning: string, needs: () => boolean, flag: boolean): void {
    const input = make('input', flag ? { type: 'checkbox', id: `map-${option}` } : { type: 'text', id: `map-${option}`, inputMode: 'decimal' })
    input.onchange = () => change({ [option]: flag ? input.checked ? '' : undefined : input.value.trim() || undefined })
    const row = make('div', { className: 'row' }, make('div', { className: 'line' }, make('label', { htmlFor: input.id, textContent: title }), input),
        make('span', { className: 'meaning', textContent: meaning }))
    updates.push(() => {
        row.hidden = !needs()
        if (flag)
            input.checked = current()[option] !== undefined
        else if (document.activeElement !== input)
            input.value = current()[option] ?? ''
    })
    byId('map-rows').append(row)
}
field('scale', 'Scale', 'The height of white above black, in pixels; negative turns hills into hollows', () => current().height !== undefined, false)
field('bevel', 'Bevel', 'The height map is a logo: a rounded edge rises over so many pixels', () => current().height !== undefined, false)
field('wrap', 'Seamless', 'Slopes are taken across the edges', () => current().height !== undefined && current().bevel === undefined, true)
field('filter', 'Filter', 'At 1/N of the size, 2 to 64: what is lost of the normals makes the highlight wider and weaker, so that nothing glitters', () => !isMesh(current()), false)
field('cut-out', 'Cut out', 'Only the logo, with a soft edge, without what lies around it', () => current().bevel !== undefined, true)
field('flip-y', 'Flip green', 'Green points down, as in maps for DirectX', () => current().normals !== undefined, true)

// ---- dropped ----

const drop = byId('drop')
addEventListener('dragover', event => {
    event.preventDefault()
    drop.hidden = false
})
addEventListener('dragleave', event => {
    if (!event.relatedTarget)
        drop.hidden = true
})
addEventListener('drop', async event => {
    event.preventDefault()
    drop.hidden = true
    const files = [...event.dataTransfer?.files ?? []].map(file => ({ file, kind: kindOf(file.name) }))
    files.sort((a, b) => kinds.indexOf(a.kind) - kinds.indexOf(b.kind)) // the surface first, which clears the others
    for (const { file, kind } of files)
        await take(file, kind)
    byId<HTMLDetailsElement>('maps').open = files.length > 0
})

function update(): void {
    press(current().scene)
    updates.forEach(work => work())
}
onChange(update)
update()
