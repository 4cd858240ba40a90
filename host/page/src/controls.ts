// SPDX-License-Identifier: MIT
// The controls: a table. Each sets one option of the command line; it shows the number that C gets and says what it means. To add
// one: its option in words.ts, a line here.
import lists from 'glint:lists'
import { ask } from './client'
import { byId, make, short, typeset } from './dom'
import type { Facts } from './engine'
import { onDrawn } from './picture'
import { shapes } from './stage'
import { canRedo, canUndo, change, current, onChange, redo, reset, undo } from './store'
import { beginMotion } from './sun'
import { explainAgain, onShown, shownGroup } from './tabs'
import type { Group } from './tabs'
import { isGrainMap, isMesh, wordsOf } from './words'
import type { Option, State } from './words'

interface Row {
    option: Option
    group: Group
    /** In a designer's words. */
    title: string
    /** Builds the inputs and returns what updates them. */
    build: (id: string, line: HTMLElement) => (state: State, facts: Facts | undefined) => void
    number: (state: State, facts: Facts) => string
    meaning: (state: State, facts: Facts) => string
    /** There is only something to set where this holds. */
    only?: (state: State, facts: Facts | undefined) => boolean
}

/** What says the same, or cannot be beside it: the last counts. */
const other: { [name in Option]?: Partial<State> } = { n: { roughness: undefined }, roughness: { n: undefined }, color: { albedo: undefined }, bevel: { wrap: undefined } }
/** What cannot be without it. */
const needing: { [name in Option]?: Partial<State> } = { bevel: { fit: undefined }, size: { fit: undefined } }
const patchOf = (option: Option, text: string | undefined): Partial<State> => ({ ...other[option], ...text === undefined ? needing[option] : {}, [option]: text })
const set = (option: Option, text: string | undefined, kind = '') => change(patchOf(option, text), kind)

// ---- what would be refused is disabled, with the command's reason ----

interface Question { patch: Partial<State>, show: (refusal: string) => void }
const questions: (() => Question[])[] = []
let asking: number | undefined
/** The reason stands where the control is, if it has a place for it. */
function askRefusals(): void {
    clearTimeout(asking)
    asking = window.setTimeout(async () => {
        if (!facts) // nothing is drawn yet
            return
        show()
        const state = current(), all = questions.flatMap(list => list())
        const lines = all.map(({ patch }) => wordsOf({ ...state, ...patch }))
        const [now, ...refusals] = await ask('refusals', [wordsOf(state), ...lines]).catch(() => [''])
        if (state !== current())
            return
        all.forEach(({ show }, i) => show(now ? '' : typeset(refusals[i] ?? ''))) // refused as it is, it takes any way out
        document.body.dataset.asked = document.body.dataset.state
    }, 120)
}
/** Lists the questions of a control each time that the state has changed. */
export function onRefusals(list: () => Question[]): void {
    questions.push(list)
}

/** A control that is disabled, and why, below it. */
export function disable(input: HTMLInputElement | HTMLSelectElement | HTMLButtonElement, place: HTMLElement, refusal: string): void {
    let why = place.querySelector<HTMLElement>('.why')
    input.disabled = refusal !== ''
    if (!why)
        place.append(why = make('p', { className: 'why' }))
    why.hidden = !refusal
    why.textContent = refusal && `Not now: ${refusal.replace(/--([a-z-]+)/g, (word, option) => table.find(row => row.option === option)?.title ?? word)}`
}

// ---- kinds of inputs ----


const choice = (option: Option, choices: readonly { name: string, title: string }[], standard: string): Row['build'] => (id, line) => {
    const input = make('select', { id }, ...choices.map(({ name, title }) => make('option', { value: name, textContent: title })))
    const textOf = (name: string) => name === standard ? undefined : name
    input.onchange = () => set(option, textOf(input.value))
    line.append(input)
    onRefusals(() => [...input.options].filter(item => item.value !== input.value).map(item => ({
        patch: patchOf(option, textOf(item.value)),
        show: refusal => {
            item.disabled = refusal !== ''
            item.title = refusal
            item.textContent = choices.find(({ name }) => name === item.value)!.title + (refusal && ` – ${refusal.replace(/^--[a-z]+( [\w-]+)?: /, '')}`)
        },
    })))
    return state => {
        input.value = state[option] ?? standard
        input.selectedOptions[0]?.removeAttribute('disabled')
        if (input.selectedOptions[0])
            input.selectedOptions[0].textContent = choices[input.selectedIndex].title
    }
}

/** `off`: the option switches off what is checked. */
const flag = (option: Option, off = false): Row['build'] => (id, line) => {
    const input = make('input', { type: 'checkbox', id })
    const textOf = (checked: boolean) => checked !== off ? '' : undefined
    input.onchange = () => set(option, textOf(input.checked))
    line.append(input)
    onRefusals(() => [{ patch: patchOf(option, textOf(!input.checked)), show: refusal => disable(input, line.parentElement!, input.checked ? '' : refusal) }])
    return state => { input.checked = (state[option] !== undefined) !== off }
}

/** A slider and a number. The slider runs 0..steps, `at` and `of` bend it. */
const slider = (option: Option, low: number, high: number, steps: number, of: (step: number) => number, at: (value: number) => number): Row['build'] => (id, line) => {
    const title = line.querySelector('label')!.textContent!
    const range = make('input', { type: 'range', min: '0', max: String(steps), aria: { label: `${title}, slider` } })
    const number = make('input', { type: 'number', id, min: String(low), max: String(high), step: '1' })
    range.oninput = () => set(option, String(of(Number(range.value))), option)
    number.onchange = () => set(option, number.value || undefined)
    line.append(range, number)
    if (option === 'across')
        onRefusals(() => [{
            patch: { across: '999' },
            show: refusal => {
                range.disabled = refusal !== '' && current().across === undefined
                disable(number, line.parentElement!, range.disabled ? refusal : '')
            },
        }])
    return (state, facts) => {
        const value = Number(state[option] ?? facts?.[option]?.[0] ?? low)
        range.value = String(at(value))
        range.setAttribute('aria-valuetext', String(value))
        if (document.activeElement !== number)
            number.value = String(value)
    }
}

/** glTF's, of the shininess n: n = 2 / r^4 - 2. */
const roughnessOf = (n: number) => (2 / (n + 2)) ** .25
const roughness: Row['build'] = (id, line) => {
    const input = make('input', { type: 'range', id, min: '.21', max: '1', step: '.01' })
    const value = make('output')
    input.oninput = () => set('roughness', input.value, 'roughness')
    line.append(input, value)
    return (state, facts) => {
        input.value = state.roughness ?? String(roughnessOf(facts?.n[0] ?? 60))
        value.value = Number(input.value).toFixed(2)
    }
}

/** How much of the picture a logo takes; where nothing says so it is as it is. */
const fit: Row['build'] = (id, line) => {
    const input = make('input', { type: 'range', id, min: '5', max: '100', step: '1' })
    const own = make('button', { type: 'button', textContent: 'Own', title: 'The picture\'s own size, from its upper left corner' })
    const value = make('output')
    input.oninput = () => change({ fit: input.value, size: current().size ?? '240x240' }, 'fit')
    own.onclick = () => set('fit', undefined)
    line.append(input, own, value)
    return state => {
        if (document.activeElement !== input)
            input.value = state.fit ?? '100'
        value.value = state.fit === undefined ? '' : `${state.fit} %`
        own.setAttribute('aria-pressed', String(state.fit === undefined))
    }
}

const hex = (values: number[]) => '#' + values.map(v => Math.round(Math.max(0, Math.min(255, v))).toString(16).padStart(2, '0')).join('')
const ofHex = (text: string) => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16))

/** A strength 0..1 and its tint: one number, or three. */
const coefficient = (option: 'ambient' | 'diffuse' | 'specular'): Row['build'] => (id, line) => {
    const title = line.querySelector('label')!.textContent!
    const range = make('input', { type: 'range', id, min: '0', max: '1', step: '0.01' })
    const tint = make('input', { type: 'color', value: '#ffffff', aria: { label: `${title}: tint` } }) // white where nothing has told one
    const put = () => {
        const strength = Number(range.value), color = ofHex(tint.value), most = Math.max(...color, 1)
        const values = color.map(v => short(strength * v / most))
        set(option, values.every(v => v === values[0]) ? values[0] : values.join(','), option)
    }
    const value = make('output')
    range.oninput = tint.oninput = put
    line.append(range, tint, value)
    return (_state, facts) => {
        const values = facts?.[`${option}_q16`]
        if (!values)
            return
        const most = Math.max(...values)
        value.value = (most / 65536).toFixed(2)
        if (document.activeElement !== range)
            range.value = String(most / 65536)
        if (most && document.activeElement !== tint)
            tint.value = hex(values.map(v => 255 * v / most))
    }
}

const background: Row['build'] = (id, line) => {
    const input = make('input', { type: 'color', id })
    const none = make('button', { type: 'button', textContent: 'None' })
    input.oninput = () => change({ background: ofHex(input.value).join(',') }, 'background')
    none.onclick = () => set('background', undefined)
    line.append(input, none)
    return state => {
        const values = state.background?.split(',').map(Number) ?? [0, 0, 0]
        if (document.activeElement !== input && values.length === 3)
            input.value = hex(values)
        none.setAttribute('aria-pressed', String(state.background === undefined))
    }
}

const grainKinds = [['', 'The surface\'s own'], ['brushed', 'Brushed one way'], ['spun', 'Spun about a point'], ['sunray', 'Rays from a point']]
/** A kind, and its angle or centre; a map of directions is dropped. */
const grain: Row['build'] = (id, line) => {
    const input = make('select', { id }, ...grainKinds.map(([value, textContent]) => make('option', { value, textContent })))
    const map = make('option', { value: 'map', textContent: 'A map' })
    const at = make('input', { type: 'text', id: `${id}-at`, spellcheck: false })
    const put = () => set('grain', input.value ? input.value + (at.value.trim() && `:${at.value.replace(/\s/g, '')}`) : undefined)
    input.append(map)
    onRefusals(() => [...input.options].filter(item => item.value && item.value !== 'map' && item.value !== input.value).map(item => ({ patch: { grain: item.value }, show: refusal => { item.disabled = refusal !== '' } })))
    input.onchange = () => {
        at.value = ''
        put()
    }
    at.onchange = put
    line.append(input, at)
    return ({ grain = '' }) => {
        const isMap = grain !== '' && isGrainMap(grain), [kind, where = ''] = isMap ? ['map'] : grain.split(':')
        input.value = kind
        map.hidden = map.disabled = !isMap
        at.hidden = isMap || kind === ''
        at.placeholder = kind === 'brushed' ? 'degrees' : 'x,y'
        at.setAttribute('aria-label', kind === 'brushed' ? 'Grain: degrees from the right' : 'Grain: the point, x,y')
        if (document.activeElement !== at)
            at.value = where
    }
}

const color: Row['build'] = (id, line) => {
    const input = make('input', { type: 'color', id })
    const own = make('button', { type: 'button', textContent: 'Own', title: 'The surface\'s own' })
    input.oninput = () => change({ color: ofHex(input.value).join(','), albedo: undefined }, 'color')
    own.onclick = () => set('color', undefined)
    line.append(input, own)
    return (state, facts) => {
        if (facts && document.activeElement !== input)
            input.value = hex(facts.albedo)
        own.setAttribute('aria-pressed', String(state.color === undefined))
    }
}

const size: Row['build'] = (id, line) => {
    const input = make('input', { type: 'text', id, spellcheck: false, placeholder: 'the map\'s own' })
    const list = make('datalist', { id: 'sizes' }, ...['128x128', '135x240', '160x80', '170x320', '240x135', '240x240', '240x280', '320x240', '480x320'].map(value => make('option', { value })))
    input.setAttribute('list', 'sizes')
    input.onchange = () => set('size', input.value.replace(/\s|×/g, c => c === '×' ? 'x' : '') || undefined)
    line.append(input, list)
    return state => {
        if (document.activeElement !== input)
            input.value = state.size ?? ''
    }
}

/** Of a mesh. */
const text = (option: Option, standard: (facts: Facts) => string, placeholder = ''): Row['build'] => (id, line) => {
    const input = make('input', { type: 'text', id, spellcheck: false, placeholder })
    input.onchange = () => set(option, input.value.replace(/\s/g, '') || undefined)
    line.append(input)
    return (state, facts) => {
        if (facts && document.activeElement !== input)
            input.value = state[option] ?? standard(facts)
    }
}

const view: Row['build'] = (id, line) => {
    const input = make('input', { type: 'text', id, spellcheck: false })
    input.onchange = () => set('view', input.value.replace(/\s/g, '') || undefined)
    line.append(input)
    return state => {
        if (document.activeElement !== input)
            input.value = state.view ?? '0,0,1'
    }
}

// ---- the table ----

const meaningOf = (list: typeof lists.models, name: string) => typeset(list.find(one => one.name === name)?.meaning ?? '')
const constant = (text: string) => `GLINT_${text.toUpperCase().replaceAll('-', '_')}`
const q16 = (facts: Facts, name: string) => `${name}_q16 = {${facts[`${name}_q16`].join(', ')}}`
const degrees = (radians: number) => `${(radians * 180 / Math.PI).toFixed(1)}°`
const hasGrain = (facts: Facts) => facts.across[0] !== facts.n[0]
/** Where Blinn's highlight has fallen to half. */
const half = (n: number) => Math.acos(2 ** (-1 / n))

const log = (option: Option) => slider(option, 1, 1000, 300, step => Math.round(1000 ** (step / 300)), n => Math.round(300 * Math.log(n) / Math.log(1000)))
const ofMesh = (_: State, facts?: Facts) => facts?.turn !== undefined
const ofMap = (state: State) => !isMesh(state)
const table: Row[] = [
    { option: 'size', group: 'scene', title: 'Panel size', build: size, number: s => s.size ?? 'the map\'s', meaning: s => s.height || s.normals ? 'A map is cut or repeated to this size; a logo is scaled by Logo size' : 'Width × height in pixels' },
    { option: 'panel', group: 'scene', title: 'Panel shape', build: choice('panel', shapes.map(name => ({ name, title: { square: 'Square', round: 'Round', none: 'No bezel' }[name] })), 'square'), number: () => 'the page\'s alone', meaning: () => 'How the panel is cut; pixels outside a round one are drawn, and not seen' },
    { option: 'background', group: 'scene', title: 'Background', build: background, number: s => s.background === undefined ? 'none' : `{${s.background.replaceAll(',', ', ')}}`, meaning: s => s.background === undefined ? 'What soft edges are drawn over; with one a scene is cut out of its wall' : 'What the buffer holds before: soft edges are mixed with it' },
    { option: 'turn', group: 'scene', title: 'Turn', only: ofMesh, build: text('turn', f => f.turn?.join() ?? ''), number: (_, f) => `--turn ${f.turn}`, meaning: () => 'Degrees about x, y and z; the button below the picture lets you drag it' },
    { option: 'zoom', group: 'scene', title: 'Zoom', only: ofMesh, build: text('zoom', f => String(f.zoom ?? '')), number: (_, f) => `--zoom ${f.zoom}`, meaning: () => '1: whatever its turn, the mesh fills the picture' },
    { option: 'perspective', group: 'scene', title: 'Perspective', only: ofMesh, build: text('perspective', () => '', 'none; try 4'), number: s => s.perspective === undefined ? 'parallel' : `--perspective=${s.perspective || 4}`, meaning: () => 'The camera\'s distance in radii of the mesh, 1.5 to 100; empty: from infinitely far' },
    { option: 'axes', group: 'scene', title: 'Up', only: s => s.mesh !== undefined, build: choice('axes', [{ name: '', title: 'As usual' }, { name: 'z-up', title: 'z' }, { name: 'y-up', title: 'y' }], ''), number: s => s.axes ? `--axes ${s.axes}` : 'the usual one', meaning: () => 'Which axis of the file points up: z in most STL files, y in a glTF' },
    { option: 'crease', group: 'scene', title: 'Sharp edges', only: ofMesh, build: text('crease', () => '', 'as usual'), number: s => s.crease === undefined ? 'the usual ones' : `--crease ${s.crease}`, meaning: s => `Edges that turn by more degrees stay sharp; empty: ${!s.mesh ? 'none' : /\.stl$/i.test(s.mesh) ? '60' : 'as the file says, or 60'}` },
    { option: 'nearest', group: 'scene', title: 'Hard texels', only: s => s.texture !== undefined, build: flag('nearest'), number: s => `is_smooth = ${s.nearest === undefined}`, meaning: () => 'The nearest pixel of the texture, faster; else the four around are blended' },
    { option: 'no-outlines', group: 'scene', title: 'Smooth outline', only: ofMesh, build: flag('no-outlines', true), number: s => `outlines = ${s['no-outlines'] === undefined ? '&glint_outlines' : 'NULL'}`, meaning: () => 'Pixels at the outline are mixed with what lies behind; else it is stepped' },

    {
        option: 'n', group: 'material', title: 'Sharpness', build: log('n'),
        number: (_, f) => `n = ${f.n}`, meaning: (_, f) => `The shininess: a cosine to the power ${f.n} falls to half at ${degrees(half(f.n[0]))}`,
    },
    { option: 'roughness', group: 'material', title: 'Roughness', build: roughness, number: (_, f) => `r = ${roughnessOf(f.n[0]).toFixed(3)}`, meaning: () => 'The same in the words of glTF, Blender and game engines: n = 2 ⁄ r⁴ − 2' },
    {
        option: 'across', group: 'material', title: 'Across grain', build: log('across'),
        number: (_, f) => `n_across = ${hasGrain(f) ? f.across : 0}`, meaning: (_, f) => hasGrain(f) ? 'Sharpness across the scratches; the one above is along them' : 'Sharpness across scratches. As above: there are none. Brushed metal has a lower one',
    },
    {
        option: 'grain', group: 'material', title: 'Scratches', build: grain, number: (s, f) => !hasGrain(f) ? 'none' : s.grain && isGrainMap(s.grain) ? 'maps.grain' : `grain_kind = GLINT_GRAIN_${['BRUSHED', 'SPUN', 'SUNRAY'][f.grain[0]]}`,
        meaning: (_, f) => hasGrain(f) ? 'Which way they run; empty: to the right, or about the middle' : 'Which way they run; it shows where Across grain differs from Sharpness',
    },
    {
        option: 'color', group: 'material', title: 'Colour', build: color, number: (_, f) => `albedo = {${f.albedo.join(', ')}}`,
        meaning: (s, f) => f.has_albedo[0] ? s.albedo ? `From ${s.albedo}, pixel for pixel` : 'The scene has colours of its own; choose one instead' : 'The same everywhere',
    },
    { option: 'specular', group: 'material', title: 'Highlight', build: coefficient('specular'), number: (_, f) => q16(f, 'specular'), meaning: () => 'How strong it is; metals tint it' },
    { option: 'diffuse', group: 'material', title: 'Body', build: coefficient('diffuse'), number: (_, f) => q16(f, 'diffuse'), meaning: () => 'What the surface scatters, by N·L' },
    { option: 'ambient', group: 'material', title: 'Shadow side', build: coefficient('ambient'), number: (_, f) => q16(f, 'ambient'), meaning: () => 'Light from everywhere; 65536 is 1.0' },

    { option: 'format', group: 'output', title: 'Pixels', build: choice('format', lists.formats, 'rgb888'), number: s => constant(s.format ?? 'rgb888'), meaning: s => meaningOf(lists.formats, s.format ?? 'rgb888') },
    { option: 'dither', group: 'output', title: 'Dither', build: flag('dither'), number: s => `dither = ${s.dither !== undefined}`, meaning: () => 'Ordered, 4 × 4: hides the steps of few levels' },

    { option: 'model', group: 'expert', title: 'Model', build: choice('model', lists.models, 'msh'), number: s => constant(s.model ?? 'msh'), meaning: s => meaningOf(lists.models, s.model ?? 'msh') },
    { option: 'path', group: 'expert', title: 'Path', build: choice('path', lists.paths, 'exact'), number: s => s.path ? `--path ${s.path}` : 'glint_paint_exact', meaning: s => pathMeaning(s.path ?? 'exact') },
    { option: 'space', group: 'expert', title: 'Light adds up', build: choice('space', [{ name: 'gamma', title: 'As encoded (gamma)' }, { name: 'linear', title: 'Linearly' }], 'gamma'), number: s => constant(s.space ?? 'gamma'), meaning: s => s.space === 'linear' ? 'Light is summed linearly, then encoded as sRGB' : 'Light is summed as encoded: faster, and what most small renderers do' },
    {
        option: 'q', group: 'expert', title: 'Cutoff', build: slider('q', 1, 16, 15, step => step + 1, q => q - 1), number: (_, f) => `q = ${f.q}, t_q30 ≤ ${f.cutoff_t_q30}`,
        meaning: (_, f) => `Below 2⁻${[...String(f.q)].map(d => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(d)]).join('')} a highlight counts as 0: beyond ${f.cutoff_degrees[0].toFixed(2)}°`,
    },
    { option: 'clamp-peak', group: 'expert', title: 'Clamp peak', build: flag('clamp-peak'), number: s => `clamp_peak = ${s['clamp-peak'] !== undefined}`, meaning: () => 'Holds the highlight to 1: MSH reaches 1.024' },
    { option: 'view', group: 'expert', title: 'Viewer', build: view, number: s => `to_viewer = ${s.view ?? '0,0,1'}`, meaning: () => 'The direction to you: x right, y up, z out of the panel' },
    { option: 'split', group: 'expert', title: 'Split', only: ofMesh, build: text('split', f => String(f.split?.[0] ?? '')), number: (_, f) => `--split ${f.split}, ${f.faces} triangles`, meaning: () => 'Edges over which the normal turns by more degrees are cut in half: highlights lie better on more triangles' },
    { option: 'filter', group: 'expert', title: 'Filter', only: ofMap, build: text('filter', () => '', 'none'), number: s => s.filter ? `--filter ${s.filter}` : 'none', meaning: () => 'At 1/N of the size, 2 to 64: what is lost of the normals makes the highlight wider and weaker, so that nothing glitters' },
    { option: 'fit', group: 'scene', title: 'Logo size', only: s => s.bevel !== undefined, build: fit, number: s => s.fit === undefined ? 'its own' : `--fit ${s.fit}`, meaning: s => s.fit === undefined ? 'As it is in its picture; move the slider to have it in the middle' : 'In the middle, as large a part of the width or of the height' },
    { option: 'scale', group: 'scene', title: 'Relief', only: s => s.height !== undefined, build: text('scale', () => '', '8, or as the bevel'), number: s => `--scale ${s.scale ?? s.bevel ?? 8}`, meaning: () => 'The height of white above black, in pixels; negative turns hills into hollows' },
    { option: 'bevel', group: 'scene', title: 'Bevel', only: s => s.height !== undefined, build: text('bevel', () => '', 'none; for a logo try 6'), number: s => s.bevel ? `--bevel ${s.bevel}` : 'none', meaning: () => 'The height map is a logo: a rounded edge rises over so many pixels' },
    { option: 'wrap', group: 'scene', title: 'Seamless', only: s => s.height !== undefined, build: flag('wrap'), number: s => s.wrap === undefined ? 'no' : '--wrap', meaning: () => 'Slopes are taken across the edges' },
    { option: 'cut-out', group: 'scene', title: 'Cut out', only: s => s.height !== undefined || s.scene !== undefined && !isMesh(s), build: flag('cut-out'), number: s => s['cut-out'] === undefined ? 'no' : '--cut-out', meaning: () => 'Only the thing, with a soft edge, without what lies around it' },
    { option: 'flip-y', group: 'scene', title: 'Flip green', only: s => s.normals !== undefined, build: flag('flip-y'), number: s => s['flip-y'] === undefined ? 'no' : '--flip-y', meaning: () => 'Green points down, as in maps for DirectX' },
]

function pathMeaning(path: string): string {
    const [by, normals] = path.split('-')
    const how: Record<string, string> = {
        exact: 'Every pixel by the function itself: right to the last bit', span: 'Normals between the ends of spans: two additions a pixel',
        colour: '20 KB of finished pixels in tables (RGB565)', albedo: '9 KB of tables over a colour map (RGB565)', palette: '4096 normals drawn once a frame, one load a pixel',
    }
    return (how[by] ?? '') + (/int\d/.test(normals ?? '') ? `; normals of ${normals.slice(3)} bits` : normals === 'span' ? '; along spans' : '')
}

const updates = table.map(row => {
    const id = `control-${row.option}`
    const line = make('div', { className: 'line' }, make('label', { htmlFor: id, textContent: row.title }))
    const update = row.build(id, line)
    const number = make('output', { className: 'number' }), meaning = make('span', { className: 'meaning', id: `${id}-meaning` })
    line.querySelector(`#${id}`)?.setAttribute('aria-describedby', meaning.id)
    const whole = make('div', { className: 'row' }, line, make('div', { className: 'note' }, number, meaning))
    byId(`rows-${row.group}`).append(whole)
    const work = (state: State, facts: Facts | undefined) => {
        whole.hidden = row.only !== undefined && !row.only(state, facts)
        update(state, facts)
        if (!facts || whole.hidden)
            return
        number.value = row.number(state, facts)
        meaning.textContent = row.meaning(state, facts)
    }
    return { group: row.group, work }
})

const undoButton = byId<HTMLButtonElement>('undo'), redoButton = byId<HTMLButtonElement>('redo')
/** What moves would move on from there at once. */
const still = (work: () => void) => () => {
    beginMotion()
    work()
}
const [undoStill, redoStill] = [undo, redo].map(still)
undoButton.onclick = undoStill
redoButton.onclick = redoStill
byId('reset').onclick = still(reset)
addEventListener('keydown', event => {
    if (!(event.ctrlKey || event.metaKey) || event.target instanceof HTMLInputElement && /text|number/.test(event.target.type))
        return
    const key = event.key.toLowerCase()
    if (key !== 'z' && key !== 'y')
        return
    event.preventDefault()
    if (key === 'y' || event.shiftKey)
        redoStill()
    else
        undoStill()
})

let facts: Facts | undefined
/** Of one group, or of all. */
function show(only?: Group): void {
    updates.forEach(({ group, work }) => { if (!only || group === only) work(current(), facts) })
}
/** What is not seen waits until the state rests. */
function update(): void {
    show(shownGroup())
    undoButton.disabled = !canUndo()
    redoButton.disabled = !canRedo()
    askRefusals()
}
onChange(update)
onDrawn(drawn => {
    facts = drawn.facts
    update()
    explainAgain()
})
onShown(() => show())
show()
update()
