// SPDX-License-Identifier: MIT
// What the picture costs: the row of the committed table that is nearest to the state, emulated; frames/s are predicted from it.
import table from 'glint:costs'
import type { Facts } from './engine'
import { isGrainMap } from './words'
import type { State } from './words'

const clock = 125e6 // the RP2040's
// Other cores (build.mjs takes their rows): the table's name, a usual clock, and what was counted.
const coreOfAvr = 'atmega2560', avrRam = 8192
const cores: [string, string, number, string][] = [['M3', 'cortex-m3', 72e6, 'instructions'], ['M4', 'cortex-m4f', 168e6, 'instructions'],
    ['M33', 'cortex-m33f', 150e6, 'instructions'],
    ['RV32', 'rv32imc', 160e6, 'instructions'], ['AVR', coreOfAvr, 16e6, 'cycles']]
const paletteBytes = 8192 // 4096 colours
const normalBytes: Record<string, number> = { int16: 6, int8: 4, span: 0 }

function value(kind: string, name: string, build = 'O2', n = '60'): number | undefined {
    const row = table.find(([k, what, b, at]) => k === kind && what === name && b === build && (at === n || at === ''))
    return row && Number(row[4])
}

/** Of a program that links these functions and constants, among others: the smallest there is. */
function linked(...parts: string[]): number | undefined {
    const sizes = table.filter(([kind, what, build]) => kind === 'linked' && build === 'Os' && parts.every(part => what.split('+').includes(part))).map(row => Number(row[4]))
    return sizes.length ? Math.min(...sizes) : undefined
}

/** The table's name for the state, or why there is none. */
function rowOf(state: State, facts: Facts): string | undefined {
    const path = state.path ?? 'exact', model = state.model ?? 'msh', format = state.format ?? 'rgb888'
    const dither = state.dither !== undefined ? ' dither' : ''
    if (path === 'span')
        return 'exact span 16'
    if (path === 'palette')
        return 'palette'
    if (!path.startsWith('exact'))
        return path.replace('-', ' ').replace(/span$/, 'span 16') + dither
    const kinds = state.lights.map(light => light.kind)
    const coloured = state.lights.some(({ kind, text }) => kind === 'light' && text.split(',').length > 3)
    if (kinds.length > 1)
        return 'exact four points'
    if (kinds[0] === 'spot' || kinds[0] === 'point')
        return `exact ${kinds[0]}`
    if (coloured)
        return 'exact directional'
    if (facts.across[0] !== facts.n[0])
        return state.grain && isGrainMap(state.grain) ? 'exact grain map' : facts.grain[0] === 0 ? 'exact brushed' : 'exact spun'
    const grey = /^(grey\d|mono)$/.test(format), deep = /888/.test(format)
    if (state.space === 'linear')
        return `exact linear${grey ? ' grey' : deep ? ' 888' : ''}`
    if (grey)
        return format === 'mono' ? 'exact mono' : 'exact grey'
    if (facts.has_albedo?.[0])
        return `exact albedo${deep ? ' 888' : ''}`
    if (deep)
        return 'exact rgb888'
    if (facts.has_gloss?.[0])
        return 'exact gloss'
    if (model !== 'msh')
        return `exact ${model}`
    return dither ? 'exact dither' : 'exact rect'
}

/** Of a mesh; the rows are of the teapot. */
function meshRow(state: State, facts: Facts): string | undefined {
    if (state.mesh)
        return undefined
    const path = (state.path ?? 'exact').replace('exact-int8', 'exact'), split = facts.split[0]
    if (path !== 'exact' && path !== 'colour-int8')
        return undefined
    return `mesh teapot${split < 180 ? ' split' : ''}${path === 'exact' ? ' exact' : ''}`
}

function meshCosts(state: State, facts: Facts): [string, string][] {
    const row = meshRow(state, facts), picture = row ? value('frame', row) : undefined
    if (!row || !picture)
        return [['Cycles', state.mesh ? 'of a mesh of yours are told when it is saved' : 'not in the table for this path'], ['Flash, the mesh', `${commas(facts.mesh_bytes[0])} bytes`]]
    const asm = value('frame', row, 'asm')
    const split = row.includes('split') ? '30°' : 'none'
    const best = asm ?? picture
    const out: [string, string][] = [['Nearest measured case', `the teapot, 240×240, RGB565, ${row.includes('exact') ? 'exact' : 'colour-int8'}, n = 60, split ${split}`],
        ['M0+, cycles a picture', `${commas(picture)}${asm ? ` (assembly ${commas(asm)})` : ''} (emulated)`],
        ['M0+, frames/s at 125 MHz', `${(clock / best).toPrecision(3)}${asm ? ', in assembly' : ''} (predicted)`]]
    for (const [title, core, hertz, unit] of cores) {
        const all = value('counted picture', row, core)
        out.push([title, all ? `${commas(all)} ${unit} a picture (emulated); at most ${(hertz / all).toPrecision(3)} frames/s at ${hertz / 1e6} MHz (predicted)`
            : core === coreOfAvr ? 'a strip of the picture takes more than its 8 KB of RAM' : 'not counted for this case'])
    }
    out.push(['RAM', `${commas(value('memory', row) ?? 0)} bytes, in strips of 16 lines`])
    out.push(['Flash, the mesh', `${commas(facts.mesh_bytes[0])} bytes`])
    const code = linked('glint_mesh_strip', ...row.includes('exact') ? ['glint_paint_exact_for', 'glint_use_rgb565', 'glint_use_msh'] : ['glint_use_colour'])
    if (code)
        out.push(['Flash, code', `${commas(code)} bytes`])
    return out
}

const commas = (x: number) => Math.round(x).toLocaleString('en')

export function costs(state: State, facts: Facts, width: number, height: number): [string, string][] {
    if (facts.turn)
        return meshCosts(state, facts)
    const row = rowOf(state, facts), path = state.path ?? 'exact'
    const pixel = row && value('pixel', row), frame = row && value('frame pixel', row)
    const asm = row && value('pixel', row, 'asm')
    const out: [string, string][] = []
    const tables = path === 'palette' ? paletteBytes : facts[`${path.split('-')[0]}_bytes`]?.[0]
    if (row && pixel && frame) {
        out.push(['Nearest measured case', `${row}, n = 60`])
        out.push(['M0+, cycles a covered pixel', `${commas(pixel)}${asm ? ` (assembly ${commas(asm)})` : ''} (emulated)`])
        out.push([`M0+, frames/s, ${width}×${height} at 125 MHz`, `${(clock / (frame * width * height)).toPrecision(3)} (predicted)`])
        for (const [title, core, hertz, unit] of cores) {
            const one = value('counted', row, core), all = value('counted frame', row, core)
            out.push([title, one && all ? `${commas(one)} ${unit} a covered pixel (emulated); ${unit === 'cycles' ? '' : 'at most '}` +
                `${(hertz / (all * width * height)).toPrecision(3)} frames/s at ${hertz / 1e6} MHz (predicted)`
                : core === coreOfAvr && tables && tables > avrRam ? 'its tables take more than the 8 KB of RAM' : 'not counted for this case'])
        }
        const fill = path.startsWith('exact') ? undefined : value('fill', row)
        if (fill)
            out.push(['Filling the tables, once', `${commas(fill)} cycles`])
    } else {
        out.push(['Cycles', 'not in the table for this path'])
    }
    const normals = path.match(/int16|int8|span/)?.[0] ?? 'int16'
    out.push(['RAM', tables ? `${commas(tables)} bytes of tables` : `${facts.paint_bytes[0]} bytes, the paint`])
    out.push(['Normals', path === 'palette' ? `${commas(2 * width * height)} bytes` : `${commas(normalBytes[normals] * width * height)} bytes`])
    const format = state.format ?? 'rgb888'
    const group = state.space === 'linear' ? 'linear' : /565/.test(format) ? 'rgb565' : /888/.test(format) ? 'rgb888' : 'grey'
    const code = path.startsWith('exact') ? linked('glint_draw_rect', 'glint_paint_exact_for', `glint_use_${group}`, `glint_use_${state.model ?? 'msh'}`) : undefined
    out.push(code ? ['Flash, this model and format', `${commas(code)} bytes`]
        : ['Flash, the whole library', `${commas(value('library', 'cortex-m0plus', 'Os', '') ?? 0)} bytes`])
    const others = { M3: 'cortex-m3', RV32: 'rv32imc', ESP8266: 'lx106', AVR: coreOfAvr }
    out.push(['The library on other cores', Object.entries(others).map(([title, core]) => `${title} ${commas(value('library', core, 'Os', '') ?? 0)}`).join(', ')])
    out.push(['Stack', `${commas(value('stack', 'cortex-m0plus', 'Os', '') ?? 0)} bytes`])
    return out
}
