// SPDX-License-Identifier: MIT
// The user's files, kept in the browser over a reload: IndexedDB, which pages from a file have, too. Tabs share what is kept, by name, as
// programs share a folder: what another tab replaces or forgets lasts here as long as the page.
import { forget, give, Stopped } from './client'
import { fileOf, isSurface, kinds } from './words'
import type { Kind, State } from './words'

interface Kept { name: string, bytes: Uint8Array<ArrayBuffer>, time: number }
const keepsAtMost = 32
/** What the worker has, the newest last, and the bytes that it takes there, at least smallBytes. */
const here = new Map<string, { bytes: Uint8Array<ArrayBuffer>, takes: number }>()
const smallBytes = 1 << 23, takesAtMost = keepsAtMost * smallBytes
let version = 0

/** Another one where a file may have another content under its name. */
export const filesVersion = () => version
export const isHere = (name: string) => here.has(name)
export const bytesOf = (name: string) => here.get(name)?.bytes
export const methodOf = (kind: Kind) => kind === 'mesh' ? 'mesh' : 'map'

/** Is it a logo? Throws where the file is refused; what had its name then stays. */
export async function putFile(name: string, kind: Kind, bytes: Uint8Array<ArrayBuffer>): Promise<boolean> {
    const told = await give(name, methodOf(kind), bytes)
    here.delete(name)
    here.set(name, { bytes, takes: Math.max(smallBytes, told ? 2 * told.width * told.height * told.channels : bytes.length) })
    version++
    return told?.isLogo ?? false
}

export function forgetFile(name: string): void {
    here.delete(name)
    forget(name)
    version++
}

/** Where they take too much, the oldest go that the drawn state does not name; undo finds those that the browser keeps. */
export function forgetOld(state: State): void {
    const named = kinds.map(kind => fileOf(state, kind))
    let sum = 0
    for (const [name, { takes }] of [...here].reverse())
        if ((sum += takes) > takesAtMost && !named.includes(name)) {
            sum -= takes
            forgetFile(name)
        }
}

function finished<T>(request: IDBRequest<T>): Promise<T> {
    return new Promise((resolve, reject) => {
        request.onsuccess = () => resolve(request.result)
        request.onerror = () => reject(request.error)
    })
}

let opening: Promise<IDBDatabase> | undefined
/** In milliseconds; some browsers never answer, for whom it is not waited again. */
let patience = 4000
/** Where that fails, or ends, it is tried again the next time. */
function open(): Promise<IDBDatabase> {
    const again = () => { opening = undefined }
    if (!opening) {
        opening = new Promise((resolve, reject) => {
            const request = indexedDB.open('glint', 1)
            request.onupgradeneeded = () => request.result.createObjectStore('files', { keyPath: 'name' })
            request.onsuccess = () => {
                request.result.onclose = again // the browser's data were cleared
                resolve(request.result)
            }
            request.onerror = () => reject(request.error)
        })
        opening.catch(again)
    }
    let timer: ReturnType<typeof setTimeout>
    const late = new Promise<never>((_, reject) => {
        timer = setTimeout(() => {
            patience = 0
            reject(new Error('no answer'))
        }, patience)
    })
    return Promise.race([opening, late]).finally(() => clearTimeout(timer))
}

/** Where a browser keeps nothing (a private window), a file lasts as long as the page. False: it has no room left for it. */
export async function keepFile(name: string): Promise<boolean> {
    const bytes = bytesOf(name)
    if (!bytes) // undone meanwhile
        return true
    try {
        const work = (await open()).transaction('files', 'readwrite'), store = work.objectStore('files')
        const isKept = new Promise<void>((resolve, reject) => {
            work.oncomplete = () => resolve()
            work.onabort = () => reject(work.error)
        })
        store.put({ name, bytes, time: Date.now() })
        const times: [string, number][] = []
        store.openCursor().onsuccess = ({ target }) => { // one after the other: together they may be large
            const { result } = target as IDBRequest<IDBCursorWithValue | null>
            if (result) {
                times.push([(result.value as Kept).name, (result.value as Kept).time])
                result.continue()
            } else {
                times.filter(([of]) => of !== name) // this one is the newest, even by a clock that was set back
                    .sort(([, a], [, b]) => b - a).slice(keepsAtMost - 1).forEach(([old]) => store.delete(old))
            }
        }
        await isKept
        return true
    } catch (error) {
        return (error as Error | null)?.name !== 'QuotaExceededError'
    }
}

async function keptBytes(name: string): Promise<Uint8Array<ArrayBuffer> | undefined> {
    try {
        const store = (await open()).transaction('files').objectStore('files')
        return ((await finished(store.get(name))) as Kept | undefined)?.bytes
    } catch {
        return undefined
    }
}

/** Gives the worker the files that the state names; returns those which are nowhere. Throws where it is stopped. */
export async function missingOf(state: State): Promise<Kind[]> {
    const missing: Kind[] = []
    for (const kind of kinds) {
        const name = fileOf(state, kind)
        if (name === undefined || here.has(name))
            continue
        const bytes = await keptBytes(name)
        const isGiven = bytes && await putFile(name, kind, bytes).then(() => true, error => {
            if (error instanceof Stopped)
                throw error
        })
        if (!isGiven)
            missing.push(kind)
    }
    return missing.sort((a, b) => Number(isSurface(b)) - Number(isSurface(a)))
}
