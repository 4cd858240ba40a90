// SPDX-License-Identifier: MIT
// Elements in few words.

export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
    return document.getElementById(id) as T
}

type Properties<T> = { [K in keyof T]?: T[K] } & { role?: string, aria?: Record<string, string> }

export function make<K extends keyof HTMLElementTagNameMap>(tag: K, properties: Properties<HTMLElementTagNameMap[K]> = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
    const element = document.createElement(tag)
    const { role, aria, ...rest } = properties
    Object.assign(element, rest)
    if (role)
        element.setAttribute('role', role)
    for (const [name, value] of Object.entries(aria ?? {}))
        element.setAttribute(`aria-${name}`, value)
    element.append(...children)
    return element
}

/** A row of buttons of which one may be pressed. */
export function buttons<T extends string>(into: HTMLElement, names: readonly T[], title: (name: T) => string, press: (name: T) => void): (pressed?: string) => void {
    const list = names.map(name => make('button', { type: 'button', textContent: title(name), onclick: () => press(name) }))
    into.append(...list)
    return pressed => list.forEach((button, i) => button.setAttribute('aria-pressed', String(names[i] === pressed)))
}

export function rows(list: HTMLElement, entries: [string, string][]): void {
    list.replaceChildren(...entries.flatMap(([term, text]) => [make('dt', { textContent: term }), make('dd', { textContent: text })]))
}

export function show(canvas: HTMLCanvasElement, width: number, height: number, rgba: Uint8Array<ArrayBuffer>): void {
    if (canvas.width !== width || canvas.height !== height) { // even the same sizes would lay the page out again
        canvas.width = width
        canvas.height = height
    }
    canvas.getContext('2d')!.putImageData(new ImageData(new Uint8ClampedArray(rgba.buffer, rgba.byteOffset, rgba.length), width, height), 0, 0)
}

const raised: Record<string, string> = { n: 'ⁿ', 2: '²', 4: '⁴' }
/** A formula, or words with one, that C has in ASCII. */
export const typeset = (text: string) => text.replace(/\^([n24])/g, (_, power: string) => raised[power]).replace(/ \/ /g, ' ⁄ ').replaceAll('<=', '≤')
    .replace(/(?<=[ (])-(?=[ n\d])|(?<=[\dn)])-(?=[\dcn(])/g, '−').replaceAll("'", '’')
export const capital = (text: string) => text[0].toUpperCase() + text.slice(1)
/** At most so many decimals, as people write options. */
export const short = (value: number, decimals = 3) => String(Number(value.toFixed(decimals)))
