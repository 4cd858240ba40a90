// SPDX-License-Identifier: MIT
// page.mjs PAGE NATIVE JSON: milliseconds that the page's module needs to shade a picture again in node, and the same
// functions natively in one thread, in one run; a table, and JSON.
import { spawnSync } from 'node:child_process'
import { readFileSync, writeFileSync } from 'node:fs'

const [folder, native, json] = process.argv.slice(2)
const { Engine } = await import(`${process.cwd()}/${folder}/engine.mjs`)
const engine = new Engine(new WebAssembly.Module(readFileSync(`${folder}/module.wasm`)))
const BY_TABLES = ['--scene=dial', '--format=rgb565', '--ambient=.1', '--diffuse=.8', '--color=200,150,60']
const PICTURES = [
    ['exact RGB565', ['--scene=dial', '--format=rgb565']],
    ['exact RGB888, linear space', ['--scene=sphere', '--format=rgb888', '--space=linear']],
    ['exact RGB565, Gauss', ['--scene=coin', '--format=rgb565', '--model=gauss']],
    ['COLOUR tables, INT8', [...BY_TABLES, '--path=colour-int8']],
    ['Exact, INT8', [...BY_TABLES, '--path=exact-int8']],
    ['ALBEDO tables, INT8', [...BY_TABLES, '--path=albedo-int8']],
    ['COLOUR spans', [...BY_TABLES, '--path=colour-span']],
]

/** Both by processor time, since other work on the machine takes turns; the best of several turns, one after the other. */
function measure([name, words]) {
    words = [...words, '--size=320x240']
    engine.draw(words)
    engine.again(20) // until node's compiler has optimised it
    let page = Infinity, host = Infinity
    for (let turn = 0; turn < 5; turn++) {
        for (let i = 0; i < 6; i++) {
            const start = process.cpuUsage()
            engine.again(5)
            const { user, system } = process.cpuUsage(start)
            page = Math.min(page, (user + system) / 5000)
        }
        const { status, stdout } = spawnSync(native, words, { encoding: 'utf8', env: { ...process.env, OMP_NUM_THREADS: '1' } })
        if (status !== 0)
            throw new Error(`${native} ${words.join(' ')} ended with ${status}`)
        host = Math.min(host, Number(stdout))
    }
    return { name, page_ms: page, native_ms: host, times: page / host }
}

const rows = PICTURES.map(measure)
console.log('\nThe page, 320x240, shaded again: milliseconds in node, natively in one thread (measured on this computer)')
for (const { name, page_ms, native_ms, times } of rows)
    console.log(`${name.padEnd(28)}${page_ms.toFixed(2).padStart(8)}${native_ms.toFixed(2).padStart(8)}${times.toFixed(2).padStart(7)} times`)
writeFileSync(json, JSON.stringify(rows, null, 2) + '\n')
