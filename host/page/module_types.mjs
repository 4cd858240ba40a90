// SPDX-License-Identifier: MIT
// module_types HEADER WIRE...: the TypeScript interface of the module, from its C declarations, and the constants of the headers of what
// goes over USB, on standard output.
import { readFileSync } from 'node:fs'

const [path, ...wire] = process.argv.slice(2)
const header = readFileSync(path, 'utf8')
const declaration = /^([a-z][\w ]*[ *]+)PAGE_EXPORT\((\w+)\)\(([^)]*)\);/gm
const lines = []
for (const [, result, name, parameters] of header.matchAll(declaration)) {
    const list = parameters.trim() === 'void' ? [] : parameters.split(',').map(text => `${text.trim().match(/\w+$/)[0]}: number`)
    lines.push(`    ${name}(${list.join(', ')}): ${result.trim() === 'void' ? 'void' : 'number'}`)
}
const expected = header.match(/^[^#\n].*PAGE_EXPORT\(/gm).length
if (lines.length !== expected)
    throw new Error(`${path}: ${expected} declarations, but only ${lines.length} could be read`)

/** Of an enum an entry is a name, one more than that before, or NAME = VALUE; of macros those that are a number. */
function constantsOf(path) {
    const text = readFileSync(path, 'utf8').replace(/\/\*[^]*?\*\//g, ''), found = []
    for (const [, body] of text.matchAll(/enum\s*\w*\s*\{([^}]*)\}/g)) {
        let next = 0
        for (const entry of body.split(',').map(entry => entry.trim()).filter(entry => entry)) {
            const [, name, value] = entry.match(/^(\w+)(?:\s*=\s*(.*))?$/s)
            next = value === undefined ? next : valueOf(value)
            found.push([name, next++])
        }
    }
    for (const [, name, value] of text.matchAll(/^#define (\w+) (\(.*\))\s*$/gm))
        found.push([name, valueOf(value)])
    return found

    function valueOf(text) {
        const plain = text.replace(/\(\w+_t\)/g, '').replace(/\b[A-Z]\w+/g, name => found.find(([other]) => other === name)?.[1] ?? name)
        if (!/^[\da-fx()<\s*+-]+$/.test(plain))
            throw new Error(`${path}: the value ${text} could not be read`)
        return Number(new Function(`return ${plain}`)())
    }
}

const bins = header.match(/PAGE_BINS = (\d+)/)[1]
console.log(`// Made from page.h and the headers of what goes over USB.\nexport const PAGE_BINS = ${bins}\n` +
    wire.flatMap(constantsOf).map(([name, value]) => `export const ${name} = ${value}\n`).join('') +
    `export interface Exports {\n    memory: WebAssembly.Memory\n    _initialize(): void\n${lines.join('\n')}\n}`)
