// SPDX-License-Identifier: MIT
// module_types HEADER: the TypeScript interface of the module, from its C declarations, on standard output.
import { readFileSync } from 'node:fs'

const header = readFileSync(process.argv[2], 'utf8')
const declaration = /^([a-z][\w ]*[ *]+)PAGE_EXPORT\((\w+)\)\(([^)]*)\);/gm
const lines = []
for (const [, result, name, parameters] of header.matchAll(declaration)) {
    const list = parameters.trim() === 'void' ? [] : parameters.split(',').map(text => `${text.trim().match(/\w+$/)[0]}: number`)
    lines.push(`    ${name}(${list.join(', ')}): ${result.trim() === 'void' ? 'void' : 'number'}`)
}
const expected = header.match(/^[^#\n].*PAGE_EXPORT\(/gm).length
if (lines.length !== expected)
    throw new Error(`${process.argv[2]}: ${expected} declarations, but only ${lines.length} could be read`)
const bins = header.match(/PAGE_BINS = (\d+)/)[1]
console.log(`// Made from page.h.\nexport const PAGE_BINS = ${bins}\nexport interface Exports {\n    memory: WebAssembly.Memory\n    _initialize(): void\n${lines.join('\n')}\n}`)
