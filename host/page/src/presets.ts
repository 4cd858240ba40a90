// SPDX-License-Identifier: MIT
// Scenes and materials to choose by their pictures, which are drawn when they are first seen.
import lists from 'glint:lists'
import { ask, Stopped } from './client'
import { byId, capital, make, show, typeset } from './dom'
import { onDrawn } from './picture'
import { change, current, onChange } from './store'
import { onShown, shownGroup } from './tabs'
import type { Group } from './tabs'
import { noSurface } from './words'
import type { State } from './words'

const side = 72
/** What a material sets where no option does. */
const ofMaterial: Partial<State> = { n: undefined, roughness: undefined, across: undefined, ambient: undefined, diffuse: undefined, specular: undefined, color: undefined, albedo: undefined }

interface Preset { name: string, title: string, meaning: string, words: () => string[], press: () => void }
const sized = [`--size=${side}x${side}`, '--light=-1,1,1.2']
const scenes: Preset[] = lists.scenes.map(({ name }) => ({
    name, title: capital(name), meaning: '', words: () => [`--scene=${name}`, ...sized],
    press: () => change({ ...noSurface, scene: name, size: current().size ?? '240x240' }),
}))
/** A map on a round panel: scratches run round its middle, unless the user says otherwise. */
const isKnob = ({ panel, scene, mesh, grain }: State) => panel === 'round' && scene === undefined && mesh === undefined && grain === undefined
const spins = (material?: string) => material?.startsWith('brushed') ? { grain: 'spun' } : {}
/** A logo is made of what was there. */
const scenesOf: Record<string, string> = { coin: 'gold', knob: 'brushed-steel', sunray: 'brushed-steel' }
export function lookOfLogo(before: State): Partial<State> {
    const material = before.material ?? scenesOf[before.scene ?? '']
    return { material, ...before.panel === 'round' || before.material === undefined ? spins(material) : {} }
}
/** It takes the place of what was set by hand; what is set afterwards overrides it. */
const materials: Preset[] = [{ name: '', title: 'As it comes', meaning: 'The surface\'s own material', words: () => [`--scene=${current().scene ?? 'sphere'}`, ...sized], press: () => change({ ...ofMaterial, material: undefined }) },
    ...lists.materials.map(({ name, meaning }) => ({
        name, title: capital(name.replaceAll('-', ' ')), meaning: capital(typeset(meaning)), words: () => [`--scene=${name.startsWith('brushed') ? 'knob' : 'sphere'}`, `--material=${name}`, ...sized],
        press: () => change({ ...ofMaterial, material: name, ...isKnob(current()) ? spins(name) : {} }),
    }))]

function build(group: Group, into: string, presets: Preset[], chosen: (state: State) => string | undefined): void {
    const canvases = presets.map(() => make('canvas', { width: side, height: side, aria: { hidden: 'true' } }))
    const buttons = presets.map(({ title, meaning, press }, i) => make('button', { type: 'button', title: meaning, onclick: press }, canvases[i], title))
    byId(into).append(...buttons)
    const update = () => buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(presets[i].name === chosen(current()))))
    onChange(update)
    update()
    const drawn = presets.map(() => '')
    const draw = async () => {
        if (shownGroup() !== group)
            return
        for (const [i, { words }] of presets.entries()) {
            const line = words()
            if (drawn[i] === line.join())
                continue
            drawn[i] = line.join()
            const picture = await ask('aside', line).catch(error => {
                if (error instanceof Stopped)
                    drawn[i] = ''
            })
            if (picture)
                show(canvases[i], picture.width, picture.height, picture.rgba)
        }
        byId(into).dataset.drawn = ''
    }
    onShown(draw)
    onDrawn(draw) // after the first picture
}
build('scene', 'scenes', scenes, ({ scene }) => scene)
build('material', 'materials', materials, ({ material }) => material ?? '')
