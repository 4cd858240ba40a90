// SPDX-License-Identifier: MIT
// The light by hand: a sun for each in the picture, dragging anywhere, keys, an orbit, and the device's tilt.
import { byId, make, short } from './dom'
import type { Facts } from './engine'
import { lastDrawn, onDrawn } from './picture'
import { change, current, onChange } from './store'
import { isTurning, offerTurn, turnBy } from './turn'
import type { Light } from './words'

const canvas = byId<HTMLCanvasElement>('canvas'), stage = byId('stage'), handles = byId('handles'), horizon = byId('horizon')
const usual: Light = { kind: 'light', text: '-1,1,1' }
let selected = 0

/** The command's own where the state names none. */
export const lights = () => current().lights.length ? current().lights : [usual]
export const selectedLight = () => Math.min(selected, lights().length - 1)
export function selectLight(i: number): void {
    selected = i
    place()
}

/** Of what is refused, too. */
const numbers = (text: string) => [0, 1, 2].map(i => Number(text.split(',')[i])).map(v => Number.isFinite(v) ? v : 0)

/** Where a light stands in the picture, 0..1 from the upper left; a direction as on a ball that fills the shorter side. */
function placeOf(light: Light): [number, number] {
    const [x, y, z] = numbers(light.text)
    if (light.kind !== 'light')
        return [x / canvas.width, y / canvas.height]
    const length = Math.hypot(x, y, z) || 1, ball = Math.min(canvas.width, canvas.height)
    return [.5 + x / length * ball / 2 / canvas.width, .5 - y / length * ball / 2 / canvas.height]
}

const rays = Array.from({ length: 8 }, (_, i) => i * Math.PI / 4).map(a => [13, 17].map(r => `${(22 + r * Math.cos(a)).toFixed(1)} ${(22 + r * Math.sin(a)).toFixed(1)}`)).map(([from, to]) => `M${from}L${to}`).join('')

/** Handles stay while there are as many lights, so that focus stays, too. */
function place(): void {
    const all = lights()
    while (handles.childElementCount > all.length)
        handles.lastElementChild!.remove()
    while (handles.childElementCount < all.length) {
        const i = handles.childElementCount, handle = make('button', { type: 'button', id: `handle-${i + 1}`, onkeydown: byKey })
        handle.innerHTML = `<svg viewBox="0 0 44 44" aria-hidden="true"><circle cx="22" cy="22" r="9"/><path d="${rays}"/></svg>`
        handle.onfocus = () => { if (i !== selectedLight()) selectLight(i) }
        handles.append(handle)
    }
    all.forEach((light, i) => {
        const handle = handles.children[i] as HTMLElement, [x, y] = placeOf(light)
        handle.className = `handle${i === selectedLight() ? ' chosen' : ''}`
        handle.style.left = `${100 * Math.max(0, Math.min(1, x))}%`
        handle.style.top = `${100 * Math.max(0, Math.min(1, y))}%`
        handle.setAttribute('aria-label', `Light ${i + 1}, ${light.kind === 'light' ? 'direction' : 'place'} ${light.text.split(',').slice(0, 3).join(', ')}. Arrow keys move it, page up and down raise and lower it`)
    })
    const ball = Math.min(canvas.width, canvas.height)
    horizon.hidden = all[selectedLight()].kind !== 'light'
    horizon.style.width = `${100 * ball / canvas.width}%`
    horizon.style.height = `${100 * ball / canvas.height}%`
}

function put(light: Light, i = selectedLight()): void {
    change({ lights: lights().map((other, k) => k === i ? light : other) }, 'light')
}

/** The light, put there. */
export function movedTo({ kind, text }: Light, x: number, y: number): Light {
    const values = text.split(',')
    if (kind === 'light') {
        const ball = Math.min(canvas.width, canvas.height)
        let right = (x - .5) * canvas.width / ball * 2, up = (.5 - y) * canvas.height / ball * 2
        const r = Math.hypot(right, up)
        if (r > .98) {
            right *= .98 / r
            up *= .98 / r
        }
        values.splice(0, 3, short(right), short(up), short(Math.sqrt(1 - right * right - up * up)))
    } else {
        values.splice(0, 2, short(x * canvas.width, 1), short(y * canvas.height, 1))
    }
    return { kind, text: values.join(',') }
}
const moveTo = (x: number, y: number) => put(movedTo(lights()[selectedLight()], x, y))

function raise(by: number): void {
    const { kind, text } = lights()[selectedLight()], values = text.split(','), all = numbers(text), [, , z] = all
    const [x, y] = all.map((v, i) => values[i] && v === Number(values[i]) ? values[i] : String(v))
    values.splice(0, 3, x, y, kind === 'light' ? short(Math.max(.02, z + by / 20)) : short(Math.max(1, z + by * 4), 1))
    put({ kind, text: values.join(',') })
}

// ---- by pointer and keys ----

function follow(event: PointerEvent): void {
    const box = canvas.getBoundingClientRect()
    moveTo((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height)
}
stage.onpointerdown = event => {
    if (event.button !== 0 || event.target === stage && (event.offsetX > stage.clientWidth || event.offsetY > stage.clientHeight)) // its scroll bars
        return
    const handle = (event.target as Element).closest('.handle')
    if (handle)
        selectLight([...handles.children].indexOf(handle))
    stage.setPointerCapture(event.pointerId)
    ;(handles.children[selectedLight()] as HTMLElement).focus({ preventScroll: true })
    last = [event.clientX, event.clientY]
    if (!isTurning() && !handle)
        follow(event)
    event.preventDefault()
}
stage.onpointermove = event => {
    const drawn = lastDrawn()
    if (!stage.hasPointerCapture(event.pointerId))
        return
    if (isTurning() && drawn)
        turnAlong(event, drawn.facts)
    else
        follow(event)
}

/** Where the pointer was when the mesh was drawn; half a turn is the picture's width. */
let last = [0, 0]
let turned: Facts | undefined
function turnAlong({ clientX, clientY }: PointerEvent, facts: Facts): void {
    if (turned === facts)
        return
    turned = facts
    const degrees = 180 / canvas.clientWidth
    turnBy((clientX - last[0]) * degrees, (clientY - last[1]) * degrees, facts)
    last = [clientX, clientY]
}

function byKey(event: KeyboardEvent): void {
    const drawn = lastDrawn()
    const turns: Record<string, [number, number]> = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5] }
    if (isTurning() && turns[event.key] && drawn) {
        turnBy(...turns[event.key], drawn.facts)
        event.preventDefault()
        return
    }
    const step = event.shiftKey ? .1 : .02, [x, y] = placeOf(lights()[selectedLight()])
    const moves: Record<string, () => void> = {
        ArrowLeft: () => moveTo(x - step, y), ArrowRight: () => moveTo(x + step, y), ArrowUp: () => moveTo(x, y - step),
        ArrowDown: () => moveTo(x, y + step), PageUp: () => raise(1), PageDown: () => raise(-1),
    }
    if (!moves[event.key])
        return
    moves[event.key]()
    event.preventDefault()
}

// ---- the orbit: only when it is asked for; where motion is unwelcome, a step a press ----

let turning = 0
const orbit = byId('orbit'), isStill = matchMedia('(prefers-reduced-motion: reduce)')
export const orbitAt = (turn: number): [number, number] => [.5 + .36 * Math.cos(2 * Math.PI * turn), .5 - .36 * Math.sin(2 * Math.PI * turn)]
const isOn = (button: HTMLElement) => button.getAttribute('aria-pressed') === 'true'
/** One motion at a time moves the light: the others end; all of them, where it is moved otherwise. */
export function beginMotion(button?: HTMLElement): void {
    for (const other of ['orbit', 'tilt', 'board-light'].map(id => byId(id)))
        if (other !== button && isOn(other))
            other.click()
}
orbit.onclick = () => {
    const on = !isOn(orbit)
    if (on && isStill.matches) {
        const [x, y] = placeOf(lights()[selectedLight()])
        moveTo(...orbitAt(Math.atan2(.5 - y, x - .5) / 2 / Math.PI + 1 / 24))
        return
    }
    orbit.setAttribute('aria-pressed', String(on))
    if (on)
        beginMotion(orbit)
    if (on)
        turning = requestAnimationFrame(turn)
    else
        cancelAnimationFrame(turning)
}
isStill.onchange = () => { if (isStill.matches && isOn(orbit)) orbit.click() }
function turn(time: number): void {
    moveTo(...orbitAt(time / 4000 % 1))
    turning = requestAnimationFrame(turn)
}

// ---- tilt: the light stays where it is in the room ----

export type Vector = [number, number, number]
interface WithPermission { requestPermission?: () => Promise<string> }
const tilt = byId('tilt'), note = byId('motion-note')
tilt.hidden = !('DeviceOrientationEvent' in window)
/** What was up in the device's own axes, and where the light stood, when the tilt began. */
let began: { up: Vector, light: Vector } | undefined
let silence: number | undefined

/** Of the device's axes: x right, y up along the screen, z out of it, turned with the picture on it. */
function upOf({ beta, gamma }: DeviceOrientationEvent): Vector {
    const b = (beta ?? 0) * Math.PI / 180, g = (gamma ?? 0) * Math.PI / 180, a = (screen.orientation?.angle ?? 0) * Math.PI / 180
    const [x, y, z] = [-Math.cos(b) * Math.sin(g), Math.sin(b), Math.cos(b) * Math.cos(g)]
    return [x * Math.cos(a) - y * Math.sin(a), x * Math.sin(a) + y * Math.cos(a), z]
}

/** v, turned as a is turned to b, both of length 1 (Rodrigues). */
function turnedWith(v: Vector, a: Vector, b: Vector): Vector {
    const k = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]], c = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    const along = (k[0] * v[0] + k[1] * v[1] + k[2] * v[2]) / (1 + c || 1)
    return [0, 1, 2].map(i => v[i] * c + k[(i + 1) % 3] * v[(i + 2) % 3] - k[(i + 2) % 3] * v[(i + 1) % 3] + k[i] * along) as Vector
}

function byTilt(event: DeviceOrientationEvent): void {
    if (event.beta === null)
        return
    clearTimeout(silence)
    note.textContent = 'The light stays where it is in the room: tilt the device.'
    const up = upOf(event), { kind, text } = lights()[selectedLight()], values = numbers(text)
    const length = Math.hypot(...values.slice(0, 3)) || 1
    began ??= { up, light: kind === 'light' ? values.slice(0, 3).map(v => v / length) as Vector : [0, 0, 1] }
    pointTo(turnedWith(began.light, began.up, up))
}

/** Moves the light towards where it is in the room, and keeps it before the picture. */
export function pointTo([x, y, z]: Vector): void {
    const { kind, text } = lights()[selectedLight()], values = numbers(text), length = Math.hypot(...values.slice(0, 3)) || 1
    const held = Math.max(z, .1), size = Math.hypot(x, y, held), next = [x, y, held].map(v => v / size)
    if (kind !== 'light') // a place: as far beside the middle as the light is tilted
        moveTo(.5 + next[0] / 2, .5 - next[1] / 2)
    else if (next.some((v, i) => Math.abs(v - values[i] / length) > .006)) // still hands give a still picture
        put({ kind, text: [...next.map(v => short(v)), ...text.split(',').slice(3)].join(',') })
}

/** Where the selected light is, of length 1; of a place, as far beside the middle as it is. */
export function towards(): Vector {
    const light = lights()[selectedLight()], [x, y] = placeOf(light), at: Vector = light.kind === 'light' ? numbers(light.text).slice(0, 3) as Vector : [2 * x - 1, 1 - 2 * y, 1]
    const length = Math.hypot(...at) || 1
    return at.map(v => v / length) as Vector
}

function endTilt(why: string): void {
    removeEventListener('deviceorientation', byTilt)
    clearTimeout(silence)
    tilt.setAttribute('aria-pressed', 'false')
    note.textContent = why
}

tilt.onclick = async () => {
    if (isOn(tilt)) {
        endTilt('')
        return
    }
    const allowed = await (DeviceOrientationEvent as unknown as WithPermission).requestPermission?.().catch(() => 'denied') ?? 'granted'
    if (allowed !== 'granted') {
        endTilt('The browser does not let the page see how the device is tilted.')
        return
    }
    began = undefined
    beginMotion(tilt)
    tilt.setAttribute('aria-pressed', 'true')
    addEventListener('deviceorientation', byTilt)
    silence = window.setTimeout(() => endTilt('No sensor tells how this device is tilted. On a phone or tablet one does.'), 1500)
}

onChange(place)
onDrawn(({ facts }) => {
    offerTurn(facts)
    place()
})
place()
