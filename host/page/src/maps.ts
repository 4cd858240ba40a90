// SPDX-License-Identifier: MIT
// The user's files: PNG maps, or a mesh, that are chosen or dropped.
import { stopped } from './client'
import { disable } from './controls'
import { byId, make } from './dom'
import { checkTexture, isGltf } from './gltf'
import { bytesIn, isObj, namedBy, together } from './obj'
import { bytesOf, forgetFile, keepFile, putFile } from './kept'
import { redraw, say, settled } from './picture'
import { lookOfLogo } from './presets'
import { change, current, onChange, takeBack } from './store'
import { showGroup } from './tabs'
import { fileOf, isMesh, isSurface, kinds, noSurface } from './words'
import type { Kind, State } from './words'

/** A file that is refused leaves all as it was: address, rows and picture, and what had its name. Why it is refused, or ''. */
async function take(file: File, kind: Kind, named: File[] = []): Promise<string> {
    const name = file.name.replace(/[/\\\0-\x1f\x7f]/g, '_') // in the command line it must not look like a path, nor hold keys
    const had = bytesOf(name)
    let before = current(), tried: Partial<State> | undefined, refusal = ''
    try {
        if (/\.mtl$/i.test(name))
            throw new Error(`${name}: these are materials; drop or choose them together with their OBJ`)
        if (kind === 'mesh' && !/\.(stl|obj)$/i.test(name) && !isGltf(name))
            throw new Error(`${name}: the page reads meshes from OBJ, binary STL and glTF files; glint render --mesh reads others, too`)
        const parts = await Promise.all([file, ...named].map(async file => ({ name: file.name, bytes: await bytesIn(file) })))
        const bytes = named.length ? together(parts) : parts[0].bytes
        if (kind === 'texture')
            checkTexture(name, bytes)
        const isLogo = await putFile(name, kind, bytes)
        before = current() // what moves has moved meanwhile
        if (before[kind] === name) { // an address asked for it, or it is a newer one: what is set stays
            await redraw()
        } else {
            const size = before.size ?? '240x240'
            const surface: Partial<State> = !isSurface(kind) ? kind === 'albedo' ? { color: undefined } : {}
                : kind === 'mesh' ? { ...noSurface, size, turn: '25,-35,0' } // not flat from the side
                    : kind === 'height' && isLogo ? { ...noSurface, size, bevel: '6', fit: '70', ...lookOfLogo(before) }
                        : { ...noSurface, size: undefined }
            change(tried = { ...surface, [kind]: name })
        }
        refusal = await settled()
    } catch (error) {
        refusal = (error as Error).message
    }
    if (refusal === stopped)
        refusal = `${name}: stopped before it was drawn; drop or choose it again`
    else if (refusal.startsWith('--')) // an option
        refusal = `${name}: ${refusal}`
    if (!refusal) {
        const isKept = await keepFile(name)
        document.body.dataset.kept = name
        return isKept ? '' : `${name}: the browser has no room to keep it; it is gone when the page is closed`
    }
    if (had)
        await putFile(name, kind, had).catch(() => undefined)
    else
        forgetFile(name)
    if (tried)
        takeBack(before, tried)
    else if (before[kind] === name)
        void redraw()
    await settled()
    say(refusal)
    return refusal
}

/** What the state names it for, or by its name, as artists call them. */
function kindOf(name: string): Kind {
    if (/\.(stl|obj|mtl|ply|gltf|glb)$/i.test(name))
        return 'mesh'
    const words: [RegExp, Kind][] = [...isMesh(current()) ? [[/tex/i, 'texture'] as [RegExp, Kind]] : [], [/grain|aniso|brush/i, 'grain'], [/norm|nrm|_n\b/i, 'normals'], [/gloss|rough|spec/i, 'gloss'], [/mask|opacity/i, 'mask'], [/albedo|colou?r|diff|base/i, 'albedo']]
    return kinds.find(kind => current()[kind] === name) ?? words.find(([pattern]) => pattern.test(name))?.[1] ?? 'height'
}

const titles: Record<Kind, string> = { height: 'Height or logo', normals: 'Normals', mesh: 'Mesh', texture: 'Texture', albedo: 'Colours', gloss: 'Gloss', mask: 'Mask', grain: 'Scratches' }

/** An OBJ with what it names; of the others each for itself, or the first one, for a row. Two for one row are not guessed at. */
async function takeEach(all: File[], row?: Kind): Promise<void> {
    const obj = all.find(({ name }) => isObj(name))
    let named: File[] = [], files: { file: File, kind: Kind }[]
    try {
        named = obj ? await namedBy(all) : []
        files = all.filter(file => !named.includes(file)).map(file => ({ file, kind: row ?? kindOf(file.name) }))
        files.sort((a, b) => kinds.indexOf(a.kind) - kinds.indexOf(b.kind)) // the surface first, which clears the others
        const twice = row ? undefined : files.find(({ kind }, i) => kind === files[i - 1]?.kind)
        if (twice)
            throw new Error(`${files.filter(({ kind }) => kind === twice.kind).map(({ file }) => file.name).join(', ')}: each of these would be "${titles[twice.kind]}"; drop one of them, or choose each in its row`)
    } catch (error) {
        await settled()
        say((error as Error).message)
        return
    }
    const refusals: string[] = []
    for (const { file, kind } of row ? obj ? [{ file: obj, kind: row }] : files.slice(0, 1) : files)
        refusals.push(await take(file, kind, file === obj ? named : []))
    const said = refusals.filter(refusal => refusal).join('\n')
    if (said) // the picture with the others said that all is well
        say(said)
}
/** One drop after the other: each is taken back to what was there before it. */
let taking = Promise.resolve()
function takeAll(all: File[], row?: Kind): Promise<void> {
    const take = () => takeEach(all, row)
    return taking = taking.then(take, take)
}

const updates: (() => void)[] = []
for (const kind of kinds) {
    const input = make('input', { type: 'file', accept: kind === 'mesh' ? '.obj,.mtl,.png,.stl,.glb,.gltf' : 'image/png,.png', multiple: kind === 'mesh', className: 'hidden', id: `map-${kind}` })
    input.onchange = () => {
        void takeAll([...input.files ?? []], kind)
        input.value = ''
    }
    const label = make('label', { htmlFor: input.id, className: 'file', textContent: 'Choose', aria: { label: `Choose: ${titles[kind]}` } })
    const name = make('span', { className: 'file-name' })
    const clear = make('button', { type: 'button', textContent: '×', aria: { label: `${titles[kind]}: remove` }, onclick: () => {
        change({ [kind]: undefined })
        input.focus() // for it is hidden itself
    } })
    const row = make('div', { className: 'row' }, make('div', { className: 'line' }, make('span', { className: 'name', textContent: titles[kind] }), name, clear, make('span', {}, input, label)))
    updates.push(() => {
        const file = fileOf(current(), kind)
        name.textContent = name.title = file ?? '—'
        clear.hidden = file === undefined || isSurface(kind)
        row.hidden = kind === 'texture' && !isMesh(current())
        disable(input, row, !isSurface(kind) && kind !== 'texture' && isMesh(current()) ? `${titles[kind]} is for maps; a mesh has none` : '')
        label.hidden = input.disabled
    })
    byId('map-rows').append(row)
}

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
    const files = [...event.dataTransfer?.files ?? []]
    if (files.length)
        showGroup('scene')
    await takeAll(files)
})

function update(): void {
    updates.forEach(work => work())
}
onChange(update)
update()
