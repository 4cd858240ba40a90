// SPDX-License-Identifier: MIT
// The list of lights: kind, numbers as the command line has them, colour.
import { byId, make, short } from './dom'
import { lastDrawn, onDrawn, selectedLight, selectLight } from './picture'
import { change, current, onChange } from './store'
import { lightKinds } from './words'
import type { Light, LightKind } from './words'

const list = byId('lights'), add = byId<HTMLButtonElement>('add-light')
/** Numbers before the colour. */
const counts: Record<LightKind, number> = { light: 3, point: 4, spot: 8 }
const titles: Record<LightKind, string> = { light: 'Directional', point: 'Point', spot: 'Spot' }
const forms: Record<LightKind, string> = { light: 'x,y,z to the light', point: 'x,y,z,range in pixels', spot: 'x,y,z,target x,y,range,inner°,outer°' }
const lightsMax = 4

function fresh(kind: LightKind): string {
    const { width, height } = lastDrawn() ?? { width: 240, height: 240 }
    const side = Math.min(width, height)
    const x = Math.round(width * .3), y = Math.round(height * .3), z = Math.round(side * .3)
    return { light: '1,1,1', point: `${x},${y},${z},${2 * side}`, spot: `${x},${y},${2 * z},${Math.round(width / 2)},${Math.round(height / 2)},${3 * side},15,30` }[kind]
}

function put(i: number, light?: Light, kind = ''): void {
    const lights = current().lights.slice()
    lights.splice(i, 1, ...light ? [light] : [])
    change({ lights }, kind)
}

const toHex = (values: number[]) => '#' + values.map(v => Math.round(255 * Math.min(1, v)).toString(16).padStart(2, '0')).join('')
const ofHex = (hex: string) => [1, 3, 5].map(at => short(parseInt(hex.slice(at, at + 2), 16) / 255))

/** The rows stay while lights keep their kinds, so that focus stays, too. */
let built = ''
const updates: (() => void)[] = []

function build(): void {
    updates.length = 0
    list.replaceChildren(...current().lights.map((light, i) => {
        const { kind } = light, name = `Light ${i + 1}`
        const now = () => current().lights[i]
        const choose = make('select', { aria: { label: `${name}: kind` } }, ...lightKinds.map(k => make('option', { value: k, textContent: titles[k], selected: k === kind })))
        choose.onchange = () => put(i, { kind: choose.value as LightKind, text: fresh(choose.value as LightKind) })
        const text = make('input', { type: 'text', spellcheck: false, aria: { label: `${name}: ${forms[kind]}` } })
        text.onchange = () => put(i, { kind, text: text.value.replace(/\s/g, '') })
        const color = make('input', { type: 'color', aria: { label: `${name}: colour` } })
        color.oninput = () => {
            const values = now().text.split(',').slice(0, counts[kind])
            put(i, { kind, text: [...values, ...color.value === '#ffffff' ? [] : ofHex(color.value)].join(',') }, `color${i}`)
        }
        const move = make('button', { type: 'button', textContent: 'Move', aria: { label: `${name}: move it in the picture` }, onclick: () => { selectLight(i); update() } })
        const remove = make('button', { type: 'button', textContent: '×', aria: { label: `${name}: remove` }, onclick: () => put(i) })
        const number = make('output', { className: 'number' })
        updates.push(() => {
            const values = now().text.split(',').map(Number)
            if (document.activeElement !== text)
                text.value = now().text
            color.value = toHex(values.length > counts[kind] ? values.slice(counts[kind], counts[kind] + 3) : [1, 1, 1])
            move.setAttribute('aria-pressed', String(selectedLight() === i))
            remove.disabled = current().lights.length === 1
            const facts = lastDrawn()?.facts
            number.value = current().lights.length === 1 && kind === 'light' && values.length === 3 && facts
                ? `l = {${facts.l_q15.join(', ')}}, h = {${facts.h_q15.join(', ')}} in Q1.15` : ''
        })
        return make('div', { className: 'row' }, make('div', { className: 'line' }, choose, text, color, move, remove),
            make('div', { className: 'note' }, number, make('span', { className: 'meaning', textContent: forms[kind] })))
    }))
}

function update(): void {
    const kinds = current().lights.map(light => light.kind).join()
    if (kinds !== built) {
        built = kinds
        build()
    }
    updates.forEach(work => work())
    add.disabled = current().lights.length >= lightsMax
}
add.onclick = () => change({ lights: [...current().lights, { kind: 'point', text: fresh('point') }] })
onChange(update)
onDrawn(update)
