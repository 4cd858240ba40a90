// SPDX-License-Identifier: MIT
// The worker as functions that return promises.
import source from 'glint:worker'
import type { Methods } from './worker'

type Reply = { id: number, result?: unknown, error?: string }
const worker = new Worker(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })))
const waiting = new Map<number, { resolve: (value: never) => void, reject: (error: Error) => void }>()
let last = 0

worker.onmessage = ({ data }: MessageEvent<Reply>) => {
    const call = waiting.get(data.id)
    waiting.delete(data.id)
    if (data.error === undefined)
        call?.resolve(data.result as never)
    else
        call?.reject(new Error(data.error))
}

export function ask<M extends keyof Methods>(method: M, ...args: Parameters<Methods[M]>): Promise<ReturnType<Methods[M]>> {
    return new Promise((resolve, reject) => {
        waiting.set(++last, { resolve, reject })
        worker.postMessage({ id: last, method, args })
    })
}
