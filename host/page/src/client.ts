// SPDX-License-Identifier: MIT
// The worker as functions that return promises. It can be stopped, or fail: another one then begins with the user's files.
import source from 'glint:worker'
import type { Methods } from './worker'

type Reply = { id: number, result?: unknown, error?: string }
type Call = { method: string, resolve: (value: never) => void, reject: (error: Error) => void, since: number }
export const stopped = 'stopped'
export class Stopped extends Error {}

const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }))
let worker = begin()
const waiting = new Map<number, Call>()
let last = 0
/** What a worker is told first. */
const files = new Map<string, { method: 'map' | 'mesh', bytes: Uint8Array<ArrayBuffer> }>()

/** Why no worker runs at all. */
let neverBegins: Error | undefined

function begin(): Worker {
    const fresh = new Worker(url)
    let hasAnswered = false
    fresh.onmessage = ({ data }: MessageEvent<Reply>) => {
        hasAnswered = true
        const call = waiting.get(data.id)
        waiting.delete(data.id)
        if (data.error === undefined)
            call?.resolve(data.result as never)
        else
            call?.reject(new Error(data.error))
    }
    fresh.onerror = event => { // it ran out of memory, or could not begin: then the next one could not either
        event.preventDefault()
        if (fresh !== worker)
            return
        if (!hasAnswered)
            neverBegins = new Error(`this browser does not run the page's worker (${event.message}); load the page again, or open it in another browser`)
        renew(neverBegins ?? new Error(`the page failed (${event.message}); a smaller --size may help`))
    }
    return fresh
}

export function ask<M extends keyof Methods>(method: M, ...args: Parameters<Methods[M]>): Promise<ReturnType<Methods[M]>> {
    return new Promise((resolve, reject) => {
        if (neverBegins)
            throw neverBegins
        waiting.set(++last, { method, resolve, reject, since: performance.now() })
        worker.postMessage({ id: last, method, args })
    })
}

/** Gives a file to this worker and those after it; it is refused where it cannot be read. */
export async function give(name: string, method: 'map' | 'mesh', bytes: Uint8Array<ArrayBuffer>): Promise<ReturnType<Methods['map']> | void> {
    const told = await ask(method, name, bytes)
    files.set(name, { method, bytes })
    return told
}

/** Neither this worker nor those after it have it from now on. */
export function forget(name: string): void {
    files.delete(name)
    void ask('forget', name).catch(() => undefined) // the worker may have taken one that it refused
}

/** What nobody waits for. */
const aside: readonly string[] = ['forget', 'aside', 'box', 'curve', 'compare', 'moving', 'refusals'] satisfies (keyof Methods)[]
/** How many milliseconds the oldest question waits, of those that somebody waits for; 0: none does. */
export function waits(): number {
    const first = [...waiting.values()].find(({ method }) => !aside.includes(method))
    return first ? performance.now() - first.since : 0
}

/** Another one after each stop: what only the last one was told is gone. */
export const workersSoFar = () => workers
let workers = 0

/** What waits is told why it waits no longer. */
function renew(why: Error): void {
    worker.terminate()
    workers++
    const calls = [...waiting.values()]
    waiting.clear()
    if (!neverBegins) {
        worker = begin()
        for (const [name, { method, bytes }] of files)
            worker.postMessage({ id: 0, method, args: [name, bytes] })
    }
    calls.forEach(({ reject }) => reject(why))
}

export function stop(): void {
    renew(new Stopped(stopped))
}
