// SPDX-License-Identifier: MIT
// The picture: drawn by the worker, the latest state first; what takes long can be stopped.
import { ask, stop, stopped, Stopped, waits, workersSoFar } from './client'
import { byId, show } from './dom'
import type { Facts } from './engine'
import { forgetOld, missingOf } from './kept'
import { current, onChange, reset, start, takeBack } from './store'
import { fragmentOf, without, wordsOf } from './words'
import type { State } from './words'

const canvas = byId<HTMLCanvasElement>('canvas')
/** What is drawn of a state: the page's own, or what a device makes of it. */
export interface Viewed {
    state: State
    isBoards?: boolean
    /** The map by which a board's surface has full gloss, where its command line names it. */
    white?: string
}
export interface Drawn extends Viewed {
    /** The page's own state. */
    asked: State
    /** Why the state is another one in its place, such as a file that is missing; '': it is not. */
    standsIn: string
    width: number
    height: number
    rgba: Uint8Array<ArrayBuffer>
    facts: Facts
}
let drawn: Drawn | undefined
let busy = false, again = false
/** Why the state of the page is not drawn, if it is not. */
let failure: Error | undefined
let waiting: ((refusal: string) => void)[] = []
const listeners: ((drawn: Drawn) => void)[] = []

export const lastDrawn = () => drawn
export function onDrawn(listener: (drawn: Drawn) => void): void {
    listeners.push(listener)
}

/** What shows the picture now does not draw such a state, which is none the worse for it. */
export class NotHere extends Error {}
/** Why the worker does not draw the state of the page; '': it does. */
const refusal = () => failure && !(failure instanceof NotHere) ? failure.message : ''

type View = (state: State) => Viewed | Promise<Viewed>
const itself: View = state => ({ state })
let view = itself
export function setView(next = itself): void {
    view = next
}

/** Once the state that the page has, or a later one, is drawn or refused: why, or ''. */
export async function settled(): Promise<string> {
    return busy ? new Promise(resolve => waiting.push(resolve)) : refusal()
}

/** What is drawn then. Throws where that is no picture of the state that was asked for. */
export async function drawnNow(): Promise<Drawn> {
    const said = await settled()
    if (said === stopped)
        throw new Stopped(stopped)
    if (failure || !drawn || drawn.standsIn)
        throw failure ?? new Error(drawn?.standsIn)
    return drawn
}

function answer(all: typeof waiting): void {
    all.forEach(resolve => resolve(refusal()))
}

async function draw(now: State): Promise<void> {
    const workers = workersSoFar()
    failure = undefined
    try {
        const missing = await missingOf(now), seen = await view(missing.length ? without(now, missing) : now)
        const picture = await ask('draw', wordsOf(seen.state))
        const standsIn = missing.length ? `${now[missing[0]]}: this ${missing[0] === 'mesh' ? 'mesh' : 'map'} is not here; drop or choose the file` : ''
        put({ ...picture, ...seen, asked: now, standsIn })
        forgetOld(now)
        if (standsIn || told !== still(now))
            print(standsIn, picture.warnings)
        else
            list(picture.warnings)
    } catch (error) {
        if (error instanceof Stopped)
            throw error
        failure = error as Error
        print(failure.message)
        const hasNone = drawn ? workersSoFar() !== workers : now !== start // no last good picture: there is none, or the worker failed
        const inPlace = hasNone && await ask('draw', wordsOf(drawn?.state ?? start)).catch(() => undefined)
        if (inPlace && !drawn)
            put({ ...inPlace, state: start, asked: start, standsIn: failure.message })
    }
}

function put(next: Drawn & { milliseconds: number }): void {
    if (!drawn)
        performance.mark('first picture') // for make bench-page; marks of all would be kept by the browser
    drawn = next
    const { width, height, rgba, milliseconds, state: { format, dither } } = next
    show(canvas, width, height, rgba)
    byId('status').textContent = `${width} × ${height}, ${format ?? 'rgb888'}${dither !== undefined ? ', dithered' : ''}; ${milliseconds.toFixed(1)} ms`
    listeners.forEach(listener => listener(next))
}

/** While the worker draws, changes wait, and only the last counts. */
export async function redraw(): Promise<void> {
    document.body.dataset.state = fragmentOf(current()) // for tests: drawn where dataset.drawn is the same
    if (busy) {
        again = true
        return
    }
    busy = true
    do {
        again = false
        const now = current(), asked = waiting
        waiting = []
        try {
            await draw(now)
        } catch {
            failure = new Stopped(stopped)
            asked.push(...waiting.splice(0)) // what they wait for is taken back
            isStopped()
        }
        document.body.dataset.drawn = fragmentOf(now)
        answer(asked)
    } while (again) // without end while something moves
    busy = false
    answer(waiting)
    waiting = []
}

/** The page then has the state whose picture it shows. */
function isStopped(): void {
    const was = drawn?.asked
    if (was && was !== current())
        takeBack(was)
    else if (!was)
        reset()
}

/** Of what somebody said of the state: it stays while only light or mesh moves. */
let told = ''
const still = (state: State) => fragmentOf({ ...state, lights: [], turn: undefined })
export function say(refusal: string): void {
    print(refusal)
    told = still(current())
}

function print(refusal: string, warnings: string[] = []): void {
    told = ''
    byId('refusal').textContent = refusal
    byId('refusal').hidden = !refusal
    list(warnings)
}

function list(warnings: string[]): void {
    byId('warnings').replaceChildren(...warnings.map(text => Object.assign(document.createElement('li'), { textContent: text })))
}

// ---- a sign of work, and its end ----

const sign = byId('busy'), status = byId('status')
let working: (() => void) | undefined
setInterval(() => {
    const time = waits(), isLong = time > 60 || working !== undefined
    if (sign.hidden !== !isLong) {
        sign.hidden = !isLong
        status.hidden = isLong
    }
    if (isLong)
        byId('busy-time').textContent = `${(time / 1000).toFixed(1)} s`
}, 40)
byId('stop').onclick = () => {
    working?.()
    stop()
    if (!busy) // the new worker has drawn nothing, and is asked about the picture
        void redraw()
}
/** Work of several steps, and what ends it. */
export function setWorking(end?: () => void): void {
    working = end
}

onChange(() => void redraw())
