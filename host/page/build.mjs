// SPDX-License-Identifier: MIT
// build NPM FOLDER: one HTML file from FOLDER/src (a copy of src/ with exports.ts made from page.h), FOLDER/module.wasm and the
// table of costs; and FOLDER/engine.mjs, the engine for tests in node. The page fetches nothing when it runs.
import { readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { deflateRawSync } from 'node:zlib'

const here = dirname(fileURLToPath(import.meta.url))
const [npm, folder] = process.argv.slice(2).map(path => resolve(path))
const { build } = createRequire(`${npm}/package.json`)('esbuild')

// Of the table what costs.ts asks for: these kinds, of these builds and cores, at its n.
const kinds = ['pixel', 'frame pixel', 'linked', 'library', 'fill', 'frame', 'memory', 'stack', 'counted', 'counted frame', 'counted picture']
const builds = ['O2', 'Os', 'asm', 'cortex-m3', 'cortex-m4f', 'cortex-m33f', 'rv32imc', 'atmega2560']
const costs = readFileSync(`${here}/../../tests/bench/costs.tsv`, 'utf8').split('\n')
    .filter(line => line && !line.startsWith('#')).map(line => line.split('\t'))
    .filter(([kind, , build, n]) => kinds.includes(kind) && builds.includes(build) && (n === '60' || n === ''))
const version = readFileSync(`${here}/../../lib/glint.h`, 'utf8').match(/GLINT_VERSION_STRING "(.*)"/)[1]

/** What the module says that can be chosen by name. */
function lists() {
    const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(`${folder}/module.wasm`)), { wasi_snapshot_preview1: new Proxy({}, { get: () => () => 0 }) })
    exports._initialize()
    const bytes = new Uint8Array(exports.memory.buffer), at = exports.page_lists(), found = {}
    for (const line of new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at))).split('\n').slice(0, -1)) {
        const [list, name, title, meaning, formula] = line.split('\t')
        found[list] = [...found[list] ?? [], { name, title, meaning, formula }]
    }
    return found
}

const values = {
    lists,
    module: () => deflateRawSync(readFileSync(`${folder}/module.wasm`), { level: 9 }).toString('base64'),
    costs: () => costs,
    version: () => version,
    worker: async () => (await bundle(`${folder}/src/worker.ts`, 'iife')),
}
const inline = {
    name: 'inline',
    setup(esbuild) {
        esbuild.onResolve({ filter: /^glint:/ }, ({ path }) => ({ path: path.slice(6), namespace: 'inlined' }))
        esbuild.onLoad({ filter: /.*/, namespace: 'inlined' }, async ({ path }) => ({ contents: JSON.stringify(await values[path]()), loader: 'json' }))
    },
}

async function bundle(entry, format) {
    const result = await build({
        entryPoints: [entry], bundle: true, minify: true, write: false, format, target: 'es2022', charset: 'utf8',
        plugins: [inline], legalComments: 'none',
    })
    return result.outputFiles[0].text
}

writeFileSync(`${folder}/engine.mjs`, await bundle(`${folder}/src/node.ts`, 'esm'))
const script = (await bundle(`${folder}/src/main.ts`, 'iife')).replaceAll('</script', '<\\/script')
const style = readFileSync(`${here}/style.css`, 'utf8')
const page = readFileSync(`${here}/index.html`, 'utf8')
    .replace('<link rel="stylesheet" href="style.css">', () => `<style>\n${style}</style>`)
    .replace('<script type="module" src="src/main.ts"></script>', () => `<script>${script}</script>`)
    .replaceAll('GLINT_VERSION', version)
const bytes = Buffer.byteLength(page)
if (bytes > 500_000)
    throw new Error(`the page has ${bytes} bytes; at most 500,000 are allowed`)
writeFileSync(`${folder}/index.html`, page)
