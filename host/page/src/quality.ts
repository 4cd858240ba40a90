// SPDX-License-Identifier: MIT
// For experts: curve, errors, costs, extent; while they are shown, and what takes long once the picture rests.
import { ask } from './client'
import { costs } from './costs'
import { byId, make, rows, short, show } from './dom'
import type { Curve } from './engine'
import { lastDrawn, onDrawn } from './picture'
import type { Drawn } from './picture'
import { onShown, shownGroup } from './tabs'
import { wordsOf } from './words'

const commas = (x: number) => Math.round(x).toLocaleString('en')

// ---- the curve ----

const points = 121, wide = 320, tall = 150, left = 28, bottom = 20

function polyline(values: number[], className: string, most: number): string {
    const at = values.map((v, i) => `${(left + i / (points - 1) * (wide - left)).toFixed(1)},${((tall - bottom) * (1 - v / most) + 4).toFixed(1)}`)
    return `<polyline class="${className}" points="${at.join(' ')}"/>`
}

function drawCurve(curve: Curve, reach: number, cutoff: number, model: string, n: number): void {
    const most = 1.05, y = (v: number) => (tall - bottom) * (1 - v / most) + 4
    const x = (angle: number) => left + angle / reach * (wide - left)
    const grid = [0, .5, 1].map(v => `<path class="axis" d="M${left} ${y(v)}H${wide}"/><text x="0" y="${y(v) + 4}">${v}</text>`).join('')
    const step = [1, 2, 5, 10, 15, 30].find(s => reach / s <= 6) ?? 30
    let ticks = ''
    for (let angle = 0; angle <= reach; angle += step)
        ticks += `<text x="${x(angle)}" y="${tall}" text-anchor="${angle ? 'middle' : 'start'}">${angle}°</text>`
    const cut = cutoff < reach ? `<path class="cut" d="M${x(cutoff)} 4V${tall - bottom + 4}"/>` : ''
    byId('curve').innerHTML = `<svg viewBox="0 0 ${wide} ${tall + 2}" role="img" aria-label="The lobe from 0 to ${reach} degrees: ${model}, the same in double, and Blinn, n = ${n}">${grid}${ticks}${cut}`
        + polyline(curve.blinn, 'blinn', most) + polyline(curve.library, 'ours', most) + polyline(curve.double, 'exact', most) + '</svg>'
    const worst = Math.max(...curve.library.map((v, i) => v >= 2 ** -16 ? Math.abs(v - curve.double[i]) : 0))
    byId('curve-caption').innerHTML = `<span class="key">${model}, integers</span> <span class="key double">in double</span> <span class="key other">Blinn, the same n</span><br>`
        + `By the angle between N and H. Integers are within ${(worst * 65536).toFixed(2)} of 2⁻¹⁶ of the double here`
}

async function curve({ facts, state }: Drawn): Promise<void> {
    const n = facts.n[0], cutoff = facts.cutoff_degrees[0]
    const reach = Math.min(90, Math.max(4, Math.ceil(cutoff * 1.12)))
    const model = state.model ?? 'msh'
    const values = await ask('curve', model, n, points, reach)
    drawCurve(values, reach, cutoff, model, n)
}

// ---- errors ----

function histogram(bins: number[]): void {
    const wide = 190, tall = 110 // half as wide as the curve, in letters of the same size
    const last = Math.max(8, bins.findLastIndex(v => v > 0)), most = Math.log1p(Math.max(...bins))
    const width = (wide - 4) / (last + 1)
    const bars = bins.slice(0, last + 1).map((v, i) => {
        const high = v ? Math.max(1.5, Math.log1p(v) / most * (tall - bottom)) : 0
        return `<rect class="bars" x="${(2 + i * width).toFixed(1)}" y="${(tall - bottom - high).toFixed(1)}" width="${(width * .82).toFixed(1)}" height="${high.toFixed(1)}"/>`
    })
    const step = last > 32 ? 16 : last > 12 ? 8 : 4
    const ticks = bins.slice(0, last + 1).map((_, i) => i % step ? '' : `<text x="${2 + i * width}" y="${tall - 4}">${i / 4}</text>`)
    byId('histogram').innerHTML = `<svg viewBox="0 0 ${wide} ${tall}" role="img" aria-label="Histogram of errors; the largest is under ${(last + 1) / 4} levels">${bars.join('')}${ticks.join('')}<path class="axis" d="M0 ${tall - bottom}H${wide}"/></svg>`
}

async function errors(drawn: Drawn): Promise<void> {
    const quality = await ask('compare')
    show(byId<HTMLCanvasElement>('error-map'), drawn.width, drawn.height, quality.errorMap)
    byId('error-caption').textContent = `Where the errors are: black none, brighter larger; shown ${quality.errorTimes} times as large`
    histogram(quality.histogram)
    const explained: string[] = []
    byId('errors').replaceChildren(...quality.report.split('\n').flatMap(line => {
        const row = line.match(/^(.{32})(.*)$/), name = row?.[1].trim() ?? ''
        if (!row || !/in double|rounding alone/.test(name))
            return []
        const title = name.replace('of that, the rounding alone', 'rounding alone').replace('in double, rounded', 'rounded')
        explained.push(title)
        const values = row[2].match(/^\s*([\d.]+|inf)\s+([\d.]+)\s+([\d.]+)/)?.slice(1) ?? ['same', '0', '0']
        return [make('tr', {}, make('th', { scope: 'row', textContent: title }), ...values.map(textContent => make('td', { textContent })))]
    }))
    legend(explained, drawn)
}

/** What the lines of the table compare, in words; and why a mesh's largest error alarms. */
function legend(titles: string[], { state, facts }: Drawn): void {
    const model = state.model ?? 'msh', isMesh = facts.turn !== undefined
    byId('errors-note').textContent = isMesh ? 'The largest errors of a mesh come from interpolated normals: the library interpolates t between the corners of a triangle, the comparison the normal, and a silhouette may cross a pixel. The map shows where.'
        : 'Every pixel is the correctly rounded value of its formula. What is left is the rounding to the panel\'s levels.'
    const lines: Record<string, string> = {
        [`${model} rounded`]: `beside ${model} computed in double precision, then rounded to the panel's levels: what the integers cost`,
        [`${model} in double`]: `beside ${model} in double precision without rounding: what the integers and the panel's few levels cost together`,
        'rounding alone': 'double precision beside the same, rounded: what no arithmetic can avoid on this panel',
        'blinn rounded': 'beside Blinn\'s model, rounded: how far the formula is from the one that it replaces',
        'blinn in double': 'beside Blinn\'s model without rounding',
    }
    rows(byId('legend'), [...titles.map((title): [string, string] => [title, lines[title] ?? 'the same beside another model']),
        ['PSNR', 'more is better; beyond 50 dB nobody sees a difference'], ['mean, largest', 'of all samples, in levels of 255'],
        ...isMesh ? [['interpolated normals', 'A highlight between the corners of large triangles lies better with Split']] as [string, string][] : []])
}

// ---- extent ----

/** The words with the first light turned by so many degrees. */
function turned({ state, width, height }: Drawn, degrees: number): string[] {
    const angle = degrees * Math.PI / 180, [light, ...others] = state.lights.length ? state.lights : [{ kind: 'light' as const, text: '-1,1,1' }]
    const values = light.text.split(',').map(Number)
    const [cx, cy] = light.kind === 'light' ? [0, 0] : [width / 2, height / 2]
    const dx = values[0] - cx, dy = values[1] - cy
    values[0] = Number(short(cx + dx * Math.cos(angle) - dy * Math.sin(angle), 5))
    values[1] = Number(short(cy + dx * Math.sin(angle) + dy * Math.cos(angle), 5))
    return wordsOf({ ...state, lights: [{ kind: light.kind, text: values.join(',') }, ...others] })
}

async function extent(drawn: Drawn): Promise<void> {
    const { facts } = drawn, [x, y, w, h] = await ask('box')
    const entries: [string, string][] = [
        ['Cutoff', `${facts.cutoff_degrees[0].toFixed(3)}°, c_q16 ≥ ${facts.cutoff_c_q16[0]}`],
        ['The highlight\'s box', w ? `${w} × ${h} at ${x}, ${y}` : 'no highlight'],
    ]
    rows(byId('extent'), entries)
    const steps = [0, 3, 6, 9, 12].map(degrees => turned(drawn, degrees))
    const moving = await ask('moving', steps)
    entries.push(['A light that turns by 3° changes', `${(100 * moving.changed).toFixed(0)} % of the bytes`],
        ['Sent as one rectangle a frame', `${commas(moving.box)} of ${commas(moving.frame)} bytes`],
        ['Sent as lines that changed', `${commas(moving.lines)} bytes`])
    rows(byId('extent'), entries)
}

let waiting: number | undefined
let round = 0
let told: Drawn | undefined
function tell(): void {
    const drawn = lastDrawn()
    if (!drawn || drawn === told || shownGroup() !== 'expert')
        return
    told = drawn
    rows(byId('costs'), costs(drawn.state, drawn.facts, drawn.width, drawn.height))
    const mine = ++round
    clearTimeout(waiting)
    waiting = window.setTimeout(async () => {
        try {
            await curve(drawn)
            if (mine === round)
                await errors(drawn)
            if (mine === round)
                await extent(drawn)
        } catch { /* the picture's own message says why */ }
        if (mine === round)
            document.body.dataset.rested = String(mine)
    }, 150)
}
onDrawn(tell)
onShown(tell)
