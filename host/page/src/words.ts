// SPDX-License-Identifier: MIT
// The state of the page is the command line of `glint render` that gives the same picture, without -o: options with their
// texts. What is not set has the command's default. The URL's fragment is the same state: #scene=coin&n=60&light=-1,1,1.

/** In the order in which the command line has them. true: the option takes no value; null: the page's own, which the command has not. */
const options = {
    height: false, normals: false, scene: false, mesh: false, bevel: false, fit: false, scale: false, wrap: true, 'flip-y': true, mask: false, 'cut-out': true, filter: false, grain: false,
    albedo: false, color: false, gloss: false, size: false, background: false, crease: false, axes: false, split: false, texture: false, nearest: true, turn: false, zoom: false, perspective: false, 'no-outlines': true, material: false, model: false, n: false, roughness: false, across: false, q: false, view: false, ambient: false,
    diffuse: false, specular: false, 'clamp-peak': true, format: false, space: false, dither: true, path: false, panel: null,
} as const
export type Option = keyof typeof options
export const lightKinds = ['light', 'point', 'spot'] as const
export type LightKind = typeof lightKinds[number]
export const lightsMax = 4
export interface Light {
    kind: LightKind
    /** As the option's value. */
    text: string
}
export type State = { lights: Light[] } & { [name in Option]?: string }
export const noSurface: Partial<State> = { height: undefined, normals: undefined, scene: undefined, mesh: undefined, crease: undefined, axes: undefined, mask: undefined, 'cut-out': undefined, filter: undefined, grain: undefined, albedo: undefined, gloss: undefined, scale: undefined, bevel: undefined, fit: undefined, wrap: undefined, 'flip-y': undefined, color: undefined, split: undefined, texture: undefined, nearest: undefined, turn: undefined, zoom: undefined, perspective: undefined, 'no-outlines': undefined }

const names = Object.keys(options) as Option[]
const dashes = (name: string) => name.length === 1 ? `-${name}` : `--${name}`

/** Each word an option and its value: "--model=msh", "-n60". */
export function wordsOf(state: State): string[] {
    const words = names.filter(name => state[name] !== undefined && options[name] !== null).map(name =>
        options[name] ? dashes(name) : dashes(name) + (name.length === 1 ? '' : '=') + state[name])
    return [...words, ...state.lights.map(({ kind, text }) => `--${kind}=${text}`)]
}

export function stateOfWords(words: string[]): State {
    const state: State = { lights: [] }
    for (const word of words) {
        const match = word.match(/^(?:--([a-z-]+)(?:=(.*))?|-([a-z])(.*))$/s)
        const name = match?.[1] ?? match?.[3] ?? '', text = match?.[2] ?? match?.[4] ?? ''
        if (lightKinds.includes(name as LightKind))
            state.lights.push({ kind: name as LightKind, text })
        else if (Object.hasOwn(options, name))
            state[name as Option] = text
    }
    return state
}

/** A map by which all of a built-in scene has full gloss; the command line that a board is shown with names it, so it can be saved, and
 *  no map of the user's may have that name. */
export function whiteName(taken?: { has: (name: string) => boolean }): string {
    let name = 'full-gloss.png'
    for (let i = 2; taken?.has(name); i++)
        name = `full-gloss-${i}.png`
    return name
}
export const white = whiteName()

/** Is it a map of directions, not one of the kinds? */
export const isGrainMap = (grain: string) => !/^(brushed|spun|sunray|axis)(:|$)/.test(grain)

/** Options that name a file of the user's. */
export const kinds = ['height', 'normals', 'mesh', 'texture', 'albedo', 'gloss', 'mask', 'grain'] as const
export type Kind = typeof kinds[number]
export const isSurface = (kind: Kind) => kind === 'height' || kind === 'normals' || kind === 'mesh'
/** The file that the state names as that; a grain may be of a kind instead. */
export function fileOf(state: State, kind: Kind): string | undefined {
    const name = state[kind]
    return kind === 'grain' && name !== undefined && !isGrainMap(name) ? undefined : name
}

/** In the place of a state that names files which are not here: without them, the surface a built-in one. */
export function without(state: State, missing: readonly Kind[]): State {
    const scene: Partial<State> = missing.some(isSurface) ? { ...noSurface, scene: 'coin', size: state.size ?? '240x240' } : {}
    return { ...state, ...scene, ...Object.fromEntries(missing.map(kind => [kind, undefined])) }
}

const asBoardsDraw = (width: number, height: number) => ({ size: `${width}x${height}`, format: 'rgb565', path: 'colour-int8' })

/** The same as a device draws it that shades by itself: in one colour, with full gloss, over black. */
export function onDevice(state: State, width: number, height: number, color: string, gloss = white): State {
    const { dither, background, albedo, gloss: own, ...rest } = state
    return { ...rest, ...state.scene === undefined ? {} : { gloss }, color: state.color ?? color, ...asBoardsDraw(width, height) }
}

export const isMesh = (state: State) => state.scene === 'teapot' || state.mesh !== undefined

/** A mesh as a device draws it that holds it, split at so many degrees: over black, its outline stepped. */
export function meshOnDevice(state: State, width: number, height: number, split: number): State {
    const { dither, background, perspective, texture, nearest, ...rest } = state
    return { ...rest, split: String(split), 'no-outlines': '', ...asBoardsDraw(width, height) }
}

/** For a shell. */
export function commandLine(command: string, words: string[]): string {
    return [command, ...words.map(quoted)].join(' ')
}

function quoted(word: string): string {
    return /^[\w=.,:/+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`
}

export function fragmentOf(state: State): string {
    const entries: [string, string][] = names.filter(name => state[name] !== undefined).map(name => [name, state[name]!])
    entries.push(...state.lights.map(({ kind, text }): [string, string] => [kind, text]))
    return entries.map(([name, text]) => text === '' ? name : `${name}=${encodeURIComponent(text.replace(/\p{Cs}/gu, '\ufffd')).replaceAll('%2C', ',')}`).join('&') // half a pair cannot be encoded
}

export function stateOfFragment(fragment: string): State {
    const state: State = { lights: [] }
    for (const part of fragment.replace(/^#/, '').split('&').filter(part => part)) {
        const at = part.indexOf('=')
        const name = at < 0 ? part : part.slice(0, at)
        let text = at < 0 ? '' : part.slice(at + 1)
        try {
            text = decodeURIComponent(text)
        } catch { /* a cut link: as it is */ }
        text = text.replace(/[\0-\x1f\x7f]/g, '\ufffd') // 0 ends a word on its way to the module; of the others a terminal makes keys
        if (lightKinds.includes(name as LightKind)) {
            if (state.lights.length <= lightsMax) // one too many is refused as thousands are, for each of which there would be a row
                state.lights.push({ kind: name as LightKind, text })
        } else if (Object.hasOwn(options, name)) {
            state[name as Option] = text
        }
    }
    return state
}
