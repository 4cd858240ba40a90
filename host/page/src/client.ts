// SPDX-License-Identifier: MIT
// The worker as functions that return promises. It can be stopped: another one then begins with the user's files.
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

function begin(): Worker {
    const fresh = new Worker(url)
    fresh.onmessage = ({ data }: MessageEvent<Reply>) => {
        const call = waiting.get(data.id)
        waiting.delete(data.id)
        if (data.error === undefined)
            call?.resolve(data.result as never)
        else
            call?.reject(new Error(data.error))
    }
    return fresh
}

export function ask<M extends keyof Methods>(method: M, ...args: Parameters<Methods[M]>): Promise<ReturnType<Methods[M]>> {
    return new Promise((resolve, reject) => {
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

export function stop(): void {
    worker.terminate()
    workers++
    const calls = [...waiting.values()]
    waiting.clear()
    worker = begin()
    for (const [name, { method, bytes }] of files)
        worker.postMessage({ id: 0, method, args: [name, bytes] })
    calls.forEach(({ reject }) => reject(new Stopped(stopped)))
}
