// SPDX-License-Identifier: MIT
// The state of the page: with undo, in the URL's fragment, and told to who asked.
import { fragmentOf, stateOfFragment } from './words'
import type { State } from './words'

export const start = stateOfFragment('scene=coin&size=240x240&format=rgb565&light=-1,1,1.2')
const ofHash = (hash: string) => hash.length > 1 ? stateOfFragment(hash) : start
let state = ofHash(location.hash)
let undone: State[] = [], done: State[] = []
/** Changes of one kind in quick succession are one step to undo. */
let lastKind = '', lastTime = 0
let toWrite: number | undefined, wrote = -Infinity
const listeners: (() => void)[] = []

export function current(): State {
    return state
}

export function onChange(listener: () => void): void {
    listeners.push(listener)
}

function tell(): void {
    listeners.forEach(listener => listener())
}

/** Browsers limit how often. While a light circles, too. */
function writeFragment(): void {
    toWrite ??= window.setTimeout(() => {
        toWrite = undefined
        wrote = performance.now()
        history.replaceState(null, '', '#' + fragmentOf(state))
    }, Math.max(0, wrote + 350 - performance.now()))
}

function cleared(next: State): State {
    for (const name of Object.keys(next) as (keyof State)[])
        if (next[name] === undefined)
            delete next[name]
    return next
}

export function change(patch: Partial<State>, kind = ''): void {
    const now = performance.now()
    if (!kind || kind !== lastKind || now - lastTime > 1000)
        done.push(state)
    done = done.slice(-200)
    undone = []
    lastKind = kind
    lastTime = now
    state = cleared({ ...state, ...patch })
    writeFragment()
    tell()
}

function step(from: State[], to: State[]): void {
    const next = from.pop()
    if (!next)
        return
    to.push(state)
    state = next
    lastKind = ''
    writeFragment()
    tell()
}

/** What was tried and refused: as it was before, and nothing of it to undo. Of what was tried alone, what has changed besides stays. */
export function takeBack(before: State, tried?: Partial<State>): void {
    const names = Object.keys(tried ?? {}) as (keyof State)[]
    const back = (state: State) => cleared({ ...state, ...Object.fromEntries(names.map(name => [name, before[name]])) })
    const at = done.lastIndexOf(before), since = at < 0 ? [] : done.splice(at).slice(1)
    if (tried)
        done.push(...since.map(back))
    state = tried ? back(state) : before
    lastKind = ''
    writeFragment()
    tell()
}

export const undo = () => step(done, undone)
export const redo = () => step(undone, done)
export const canUndo = () => done.length > 0
export const canRedo = () => undone.length > 0

export function reset(): void {
    replace(start)
}

function replace(next: State): void {
    done.push(state)
    undone = []
    state = next
    writeFragment()
    tell()
}

/** A link to this very state. */
export function link(): string {
    return location.href.replace(/#.*/, '') + '#' + fragmentOf(state)
}

// The event's own address: what writeFragment does in between may have replaced it already.
addEventListener('hashchange', event => {
    const { hash } = new URL(event.newURL)
    if (hash.slice(1) !== fragmentOf(state))
        replace(ofHash(hash))
})
