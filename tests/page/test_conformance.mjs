// SPDX-License-Identifier: MIT
// test_conformance.mjs CONFORMANCE EXPECTED: the module's objects of the library have its results in the checks of the
// conformance image.
import { readFileSync } from 'node:fs'
import { check, equal, run } from '../pico/tap.mjs'

const [conformance, expected] = process.argv.slice(2)

/** What a program for WASI prints. */
function output(path) {
    let text = '', memory
    const ended = new Error('ended')
    const none = (count, bytes) => { // no words
        new DataView(memory.buffer).setUint32(count, 0, true)
        new DataView(memory.buffer).setUint32(bytes, 0, true)
        return 0
    }
    const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(path)), {
        wasi_snapshot_preview1: {
            fd_write(fd, vectors, count, written) {
                const view = new DataView(memory.buffer)
                let total = 0
                for (let i = 0; i < count; i++) {
                    const at = view.getUint32(vectors + 8 * i, true), length = view.getUint32(vectors + 8 * i + 4, true)
                    text += Buffer.from(memory.buffer, at, length).toString()
                    total += length
                }
                view.setUint32(written, total, true)
                return 0
            },
            args_get: () => 0, args_sizes_get: none, environ_get: () => 0, environ_sizes_get: none,
            fd_close: () => 0, fd_seek: () => 29, fd_fdstat_get: () => 8, proc_exit: () => { throw ended },
        },
    })
    memory = exports.memory
    try {
        exports._start()
    } catch (error) {
        if (error !== ended)
            throw error
    }
    return text
}

run([
    ['the conformance checks give the host\'s hashes in WebAssembly', () => {
        const text = output(conformance)
        check((text.match(/0x[0-9a-f]{16}/g) ?? []).length >= 26, `it prints ${text}`)
        equal(text, readFileSync(expected, 'utf8'), 'hashes')
    }],
])
