// SPDX-License-Identifier: MIT
// The list of lights: kind, numbers as the command line has them, colour.
import { disable, onRefusals } from './controls'
import { byId, make, short } from './dom'
import { lastDrawn, onDrawn } from './picture'
import { change, current, onChange } from './store'
import { lights, selectedLight, selectLight } from './sun'
import { lightKinds, lightsMax } from './words'
import type { Light, LightKind } from './words'

const list = byId('lights'), add = byId<HTMLButtonElement>('add-light')
/** Numbers before the colour. */
const counts: Record<LightKind, number> = { light: 3, point: 4, spot: 8 }
const titles: Record<LightKind, string> = { light: 'Sun', point: 'Lamp', spot: 'Spot' }
const forms: Record<LightKind, string> = { light: 'x,y,z to the light', point: 'x,y,z,range in pixels', spot: 'x,y,z,target x,y,range,inner°,outer°' }

function fresh(kind: LightKind): string {
    const { width, height } = lastDrawn() ?? { width: 240, height: 240 }
    const side = Math.min(width, height)
    const x = Math.round(width * .3), y = Math.round(height * .3), z = Math.round(side * .3)
    return { light: '1,1,1', point: `${x},${y},${z},${2 * side}`, spot: `${x},${y},${2 * z},${Math.round(width / 2)},${Math.round(height / 2)},${3 * side},15,30` }[kind]
}

function withLight(i: number, light?: Light): Light[] {
    const all = current().lights.slice()
    all.splice(i, 1, ...light ? [light] : [])
    return all
}
const put = (i: number, light?: Light, kind = '') => change({ lights: withLight(i, light) }, kind)

const toHex = (values: number[]) => '#' + values.map(v => Math.round(255 * Math.max(0, Math.min(1, v || 0))).toString(16).padStart(2, '0')).join('')
const ofHex = (hex: string) => [1, 3, 5].map(at => short(parseInt(hex.slice(at, at + 2), 16) / 255))

/** The rows stay while lights keep their kinds, so that focus stays, too. */
let built = ''
const updates: (() => void)[] = []
let questions: Parameters<typeof onRefusals>[0] = () => []

/** The focus stays in its row, or where that is gone in the next one, or the last. */
function build(): void {
    const rowOf = document.activeElement?.closest('#lights > .row'), row = [...list.children].indexOf(rowOf as Element)
    const place = rowOf ? [...rowOf.querySelectorAll('button, select, input')].indexOf(document.activeElement as Element) : 0
    updates.length = 0
    const asks: (typeof questions)[] = []
    list.replaceChildren(...current().lights.map((light, i) => {
        const { kind } = light, name = `Light ${i + 1}`
        const now = () => current().lights[i]
        const move = make('button', { type: 'button', textContent: String(i + 1), title: 'Dragging moves this light', aria: { label: `${name}: move it in the picture` }, onclick: () => { selectLight(i); update() } })
        const choose = make('select', { aria: { label: `${name}: kind` } }, ...lightKinds.map(k => make('option', { value: k, textContent: titles[k], selected: k === kind })))
        choose.onchange = () => put(i, { kind: choose.value as LightKind, text: fresh(choose.value as LightKind) })
        const text = make('input', { type: 'text', spellcheck: false, aria: { label: `${name}: ${forms[kind]}` } })
        text.onchange = () => put(i, { kind, text: text.value.replace(/\s/g, '') })
        const color = make('input', { type: 'color', aria: { label: `${name}: colour` } })
        color.oninput = () => {
            const values = now().text.split(',').slice(0, counts[kind])
            put(i, { kind, text: [...values, ...color.value === '#ffffff' ? [] : ofHex(color.value)].join(',') }, `color${i}`)
        }
        const remove = make('button', { type: 'button', textContent: '×', aria: { label: `${name}: remove` }, onclick: () => put(i) })
        const number = make('output', { className: 'number' })
        const row = make('div', { className: 'row' }, make('div', { className: 'line' }, move, choose, color, remove, text),
            make('div', { className: 'note' }, number, make('span', { className: 'meaning', textContent: forms[kind] })))
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
        asks.push(() => [...choose.options].filter(option => option.value !== kind).map(option => ({
            patch: { lights: withLight(i, { kind: option.value as LightKind, text: fresh(option.value as LightKind) }) },
            show: refusal => { option.disabled = refusal !== '' },
        })))
        asks.push(() => [{ patch: { lights: withLight(i, { kind, text: [...now().text.split(',').slice(0, counts[kind]), '.5', '1', '1'].join() }) }, show: refusal => disable(color, row, refusal) }])
        return row
    }))
    questions = () => asks.flatMap(ask => ask())
    updates.forEach(work => work())
    if (rowOf) {
        const controls = list.children[Math.min(row, list.childElementCount - 1)]?.querySelectorAll<HTMLButtonElement>('button, select, input')
        const wanted = controls?.[place]
        ;(wanted?.disabled ? controls?.[0] : wanted)?.focus()
    }
}

function update(): void {
    const kinds = current().lights.map(light => light.kind).join()
    if (kinds !== built) {
        built = kinds
        build()
    }
    updates.forEach(work => work())
    if (current().lights.length >= lightsMax)
        add.disabled = true
}
const withFresh = (): Light[] => [...lights(), { kind: 'point', text: fresh('point') }]
onRefusals(() => [...questions(), {
    patch: { lights: withFresh() },
    show: refusal => {
        disable(add, byId('group-light'), refusal)
        add.disabled ||= current().lights.length >= lightsMax
    },
}])
add.onclick = () => {
    change({ lights: withFresh() })
    selectLight(current().lights.length - 1)
}
onChange(update)
onDrawn(update)
