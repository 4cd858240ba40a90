// SPDX-License-Identifier: MIT
// The picture: drawn by the worker, the latest state first; zoom by whole pixels; the light follows the pointer.
import { ask } from './client'
import { byId, show, short } from './dom'
import type { Facts } from './engine'
import { change, current, onChange } from './store'
import { isTurning, offerTurn, turnBy } from './turn'
import { fragmentOf, wordsOf } from './words'
import type { State } from './words'

const canvas = byId<HTMLCanvasElement>('canvas'), panel = byId('panel'), stage = byId('stage'), handle = byId<HTMLButtonElement>('handle')
/** What is drawn of a state: the page's own, or what a device makes of it. */
export interface Viewed {
    state: State
    isBoards?: boolean
    /** The map by which a board's surface has full gloss, where its command line names it. */
    white?: string
}
export interface Drawn extends Viewed {
    width: number
    height: number
    rgba: Uint8Array<ArrayBuffer>
    facts: Facts
}
let drawn: Drawn | undefined
let zoom = 0 // 0: as large as fits
let selected = 0
let busy = false, again = false
const listeners: ((drawn: Drawn) => void)[] = []

export const lastDrawn = () => drawn
export function onDrawn(listener: (drawn: Drawn) => void): void {
    listeners.push(listener)
}

// ---- drawing ----

type View = (state: State) => Viewed | Promise<Viewed>
const itself: View = state => ({ state })
let view = itself
/** What is drawn, or would be, of the state that the page has now. */
export const viewed = () => view(current())
export function setView(next = itself): void {
    view = next
}

/** While the worker draws, changes wait, and only the last counts. */
export async function redraw(): Promise<void> {
    document.body.dataset.state = fragmentOf(current()) // for tests: drawn where dataset.drawn is the same
    placeHandle()
    if (busy) {
        again = true
        return
    }
    busy = true
    do {
        again = false
        const now = current()
        try {
            const seen = await view(now), { state } = seen
            const picture = { ...await ask('draw', wordsOf(state)), ...seen }
            drawn = picture
            show(canvas, picture.width, picture.height, picture.rgba)
            say('', picture.warnings)
            byId('status').textContent = `${picture.width} × ${picture.height}, ${state.format ?? 'rgb888'}${state.dither !== undefined ? ', dithered' : ''}; ${picture.kept ? 'drawn' : 'prepared and drawn'} in ${picture.milliseconds.toFixed(1)} ms`
            layOut()
            offerTurn(picture.facts)
            listeners.forEach(listener => listener(picture))
        } catch (error) {
            say((error as Error).message, [])
        }
        document.body.dataset.drawn = fragmentOf(now)
    } while (again)
    busy = false
}

function say(refusal: string, warnings: string[]): void {
    byId('refusal').textContent = refusal
    byId('refusal').hidden = !refusal
    byId('warnings').replaceChildren(...warnings.map(text => Object.assign(document.createElement('li'), { textContent: text })))
}

// ---- zoom: device pixels, whole ----

function scale(): number {
    const room = stage.clientWidth - 8
    const fits = Math.max(1, Math.floor(room * devicePixelRatio / canvas.width))
    const tall = Math.max(1, Math.floor(innerHeight * .62 * devicePixelRatio / canvas.height))
    return zoom || Math.min(fits, tall)
}

function layOut(): void {
    const z = scale()
    canvas.style.width = `${canvas.width * z / devicePixelRatio}px`
    canvas.style.height = `${canvas.height * z / devicePixelRatio}px`
    byId('zoom').textContent = `${z}×`
    placeHandle()
}

byId('zoom-in').onclick = () => { zoom = Math.min(32, scale() + 1); layOut() }
byId('zoom-out').onclick = () => { zoom = Math.max(1, scale() - 1); layOut() }
byId('zoom-fit').onclick = () => { zoom = 0; layOut() }
new ResizeObserver(layOut).observe(stage)

// ---- the light ----

export const selectedLight = () => Math.min(selected, current().lights.length - 1)
export function selectLight(i: number): void {
    selected = i
    placeHandle()
}

const numbers = (text: string) => text.split(',').map(Number)

/** Where the light stands in the picture, 0..1 from the upper left; a direction as on a ball that fills the shorter side. */
function place(): [number, number] {
    const light = current().lights[selectedLight()]
    const [x, y, z] = light ? numbers(light.text) : [-1, 1, 1]
    if (light && light.kind !== 'light')
        return [x / canvas.width, y / canvas.height]
    const length = Math.hypot(x, y, z) || 1, ball = Math.min(canvas.width, canvas.height)
    return [.5 + x / length * ball / 2 / canvas.width, .5 - y / length * ball / 2 / canvas.height]
}

function placeHandle(): void {
    const [x, y] = place()
    handle.style.left = `${100 * Math.max(0, Math.min(1, x))}%`
    handle.style.top = `${100 * Math.max(0, Math.min(1, y))}%`
    const light = current().lights[selectedLight()]
    handle.setAttribute('aria-label', `Light ${selectedLight() + 1}, ${light?.kind === 'light' || !light ? 'direction' : 'place'} ${(light?.text ?? '-1,1,1').split(',').slice(0, 3).join(', ')}. Arrow keys move it, page up and down raise and lower it`)
}

/** Puts the light there. */
function moveTo(x: number, y: number): void {
    const { lights } = current(), i = selectedLight()
    const light = lights[i] ?? { kind: 'light', text: '-1,1,1' }
    const values = light.text.split(',')
    if (light.kind === 'light') {
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
    const next = lights.length ? lights.slice() : [light]
    next[Math.max(0, i)] = { kind: light.kind, text: values.join(',') }
    change({ lights: next }, 'light')
}

function raise(by: number): void {
    const { lights } = current(), light = lights[selectedLight()]
    if (!light)
        return
    const values = light.text.split(',')
    const z = Number(values[2])
    values[2] = light.kind === 'light' ? short(Math.max(.02, z + by / 20)) : short(Math.max(1, z + by * 4), 1)
    change({ lights: lights.map(other => other === light ? { ...light, text: values.join(',') } : other) }, 'light')
}

function follow(event: PointerEvent): void {
    const box = canvas.getBoundingClientRect()
    moveTo((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height)
}
panel.onpointerdown = event => {
    if (event.button !== 0)
        return
    panel.setPointerCapture(event.pointerId)
    handle.focus({ preventScroll: true })
    last = [event.clientX, event.clientY]
    if (!isTurning())
        follow(event)
    event.preventDefault()
}
panel.onpointermove = event => {
    if (!panel.hasPointerCapture(event.pointerId))
        return
    if (isTurning() && drawn)
        turnAlong(event, drawn.facts)
    else
        follow(event)
}

/** Where the pointer was when the mesh was drawn; half a turn is the picture's width. */
let last = [0, 0]
function turnAlong({ clientX, clientY }: PointerEvent, facts: Facts): void {
    if (busy)
        return
    const degrees = 180 / canvas.clientWidth
    turnBy((clientX - last[0]) * degrees, (clientY - last[1]) * degrees, facts)
    last = [clientX, clientY]
}
handle.onkeydown = event => {
    const turns: Record<string, [number, number]> = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5] }
    if (isTurning() && turns[event.key] && drawn) {
        turnBy(...turns[event.key], drawn.facts)
        event.preventDefault()
        return
    }
    const step = event.shiftKey ? .1 : .02, [x, y] = place()
    const moves: Record<string, () => void> = {
        ArrowLeft: () => moveTo(x - step, y), ArrowRight: () => moveTo(x + step, y), ArrowUp: () => moveTo(x, y - step),
        ArrowDown: () => moveTo(x, y + step), PageUp: () => raise(1), PageDown: () => raise(-1),
    }
    if (!moves[event.key])
        return
    moves[event.key]()
    event.preventDefault()
}

// ---- the orbit: only when it is asked for ----

let turning = 0
const orbit = byId('orbit')
orbit.onclick = () => {
    const on = orbit.getAttribute('aria-pressed') !== 'true'
    orbit.setAttribute('aria-pressed', String(on))
    if (on)
        turning = requestAnimationFrame(turn)
    else
        cancelAnimationFrame(turning)
}
function turn(time: number): void {
    const angle = time / 4000 * 2 * Math.PI
    moveTo(.5 + .36 * Math.cos(angle), .5 - .36 * Math.sin(angle))
    turning = requestAnimationFrame(turn)
}

onChange(() => void redraw())
