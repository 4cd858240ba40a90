// SPDX-License-Identifier: MIT
// The groups of controls, one shown at a time; what a focused control sets; the explanation.
import { byId, make } from './dom'

export const groups = ['scene', 'material', 'light', 'output', 'expert'] as const
export type Group = typeof groups[number]
const listeners: ((group: Group) => void)[] = []
let shown: Group = 'scene'

export const shownGroup = () => shown
/** Called each time that a group is shown. */
export function onShown(listener: (group: Group) => void): void {
    listeners.push(listener)
}

const tabs = groups.map(group => {
    const tab = make('button', { type: 'button', id: `tab-${group}`, role: 'tab', textContent: group[0].toUpperCase() + group.slice(1), aria: { controls: `group-${group}` } })
    const panel = byId(`group-${group}`)
    panel.setAttribute('role', 'tabpanel')
    panel.setAttribute('aria-labelledby', tab.id)
    tab.onclick = () => showGroup(group)
    tab.onkeydown = event => {
        const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key]
        if (!by)
            return
        const next = groups[(groups.indexOf(group) + by + groups.length) % groups.length]
        showGroup(next)
        byId(`tab-${next}`).focus()
        event.preventDefault()
    }
    byId('tabs').append(tab)
    return tab
})

export function showGroup(group: Group): void {
    shown = group
    groups.forEach((name, i) => {
        byId(`group-${name}`).hidden = name !== group
        tabs[i].setAttribute('aria-selected', String(name === group))
        tabs[i].tabIndex = name === group ? 0 : -1
    })
    byId('scroller').scrollTop = 0
    listeners.forEach(listener => listener(group))
}
showGroup(shown)

// ---- what a control sets, and what that means: of the focused one, or of each ----

const help = byId('help'), usual = 'Focus a control, or point at it, to see the number that C gets and what it means.'
let explained: EventTarget | null = null
function explain(target: EventTarget | null): void {
    explained = target
    const note = target instanceof Element ? target.closest('.row')?.querySelector('.note') : undefined
    help.replaceChildren(...note ? [...note.children].map(child => Object.assign(make('span', { textContent: (child as HTMLOutputElement).value ?? child.textContent }), { className: child.className })) : [usual])
}
/** With the numbers of the picture that is drawn now. */
export const explainAgain = () => explain(explained)
byId('scroller').addEventListener('focusin', event => {
    const control = event.target as HTMLElement
    explain(control)
    if (control.matches(':focus-visible'))
        keepSeen(control, 4)
})
/** Firefox leaves some of it outside, and may go back to where it was for so many frames. */
function keepSeen(control: HTMLElement, frames: number): void {
    if (document.activeElement !== control)
        return
    control.scrollIntoView({ block: 'nearest' })
    if (frames)
        requestAnimationFrame(() => keepSeen(control, frames - 1))
}
byId('scroller').addEventListener('input', event => requestAnimationFrame(() => explain(event.target)))
byId('scroller').addEventListener('pointerover', event => explain((event.target as Element).closest('.row') ? event.target : document.activeElement))
onShown(() => explain(null))
explain(null)

const code = byId('code')
code.onclick = () => code.setAttribute('aria-pressed', String(byId('scroller').classList.toggle('codes')))
