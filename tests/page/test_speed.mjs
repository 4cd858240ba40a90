// SPDX-License-Identifier: MIT
// test_speed.mjs PAGE NATIVE CONFORMANCE EXPECTED: the module has the library's results in the checks of the conformance
// image, and shades at a comparable rate.
import { spawnSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { check, equal, run } from '../pico/tap.mjs'

const [folder, native, conformance, expected] = process.argv.slice(2)
const { Engine } = await import(`${process.cwd()}/${folder}/engine.mjs`)

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

/** By processor time, since other work on the machine takes turns; the best of several turns of both, one after the other,
 *  and of more where it seems too slow, since that work also takes cache. */
function ratio(engine, words, most) {
    engine.draw(words)
    engine.again(20) // until the engine's compiler has optimised it
    let page = Infinity, host = Infinity
    for (let turn = 0; turn < 5 || turn < 25 && page > most * host; turn++) {
        for (let i = 0; i < 6; i++) {
            const start = process.cpuUsage()
            engine.again(5)
            const { user, system } = process.cpuUsage(start)
            page = Math.min(page, (user + system) / 5000)
        }
        const { stdout } = spawnSync(native, words, { encoding: 'utf8', env: { ...process.env, OMP_NUM_THREADS: '1' } })
        host = Math.min(host, Number(stdout))
    }
    console.log(`# ${words.join(' ')}: ${page.toFixed(2)} ms, natively ${host.toFixed(2)}, ${(page / host).toFixed(2)} times`)
    return page / host
}

run([
    ['the conformance checks give the host\'s hashes in WebAssembly', () => {
        const text = output(conformance)
        check((text.match(/0x[0-9a-f]{16}/g) ?? []).length >= 26, `it prints ${text}`)
        equal(text, readFileSync(expected, 'utf8'), 'hashes')
    }],
    ['exact pictures take at most twice the native time', () => {
        const engine = new Engine(new WebAssembly.Module(readFileSync(`${folder}/module.wasm`)))
        for (const words of [['--scene=dial', '--format=rgb565'], ['--scene=sphere', '--format=rgb888', '--space=linear'], ['--scene=coin', '--format=rgb565', '--model=gauss']])
            check(ratio(engine, [...words, '--size=320x240'], 2) <= 2, words.join(' '))
    }],
    ['pictures by tables take at most twice the native time', () => {
        const engine = new Engine(new WebAssembly.Module(readFileSync(`${folder}/module.wasm`)))
        for (const path of ['colour-int8', 'small-int16', 'albedo-int8', 'colour-span'])
            check(ratio(engine, ['--scene=dial', '--size=320x240', '--format=rgb565', '--ambient=.1', '--diffuse=.8', '--color=200,150,60', `--path=${path}`], 2) <= 2, path)
    }],
])
