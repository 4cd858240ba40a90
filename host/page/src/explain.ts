// SPDX-License-Identifier: MIT
// MSH, Cayley and Blinn beside each other, at the n of the picture.
import { ask } from './client'
import lists from 'glint:lists'
import { byId, make, show, typeset } from './dom'
import { onDrawn } from './picture'

const side = 200
const places = ['msh', 'cayley', 'blinn'].map(model => lists.models.find(({ name }) => name === model)!).map(({ name, title, formula }) => {
    const canvas = make('canvas', { width: side, height: side, role: 'img', aria: { label: `A sphere under ${title}` } })
    const caption = make('figcaption')
    byId('beside').append(make('figure', {}, canvas, caption, make('p', { className: 'of-model', textContent: typeset(formula) })))
    return { model: name, title, canvas, caption }
})

let drawnN = 0
let waiting: number | undefined
onDrawn(({ facts }) => {
    const n = facts.n[0]
    if (n === drawnN)
        return
    clearTimeout(waiting)
    waiting = window.setTimeout(async () => {
        drawnN = n
        for (const { model, title, canvas, caption } of places) {
            const { width, height, rgba } = await ask('aside', ['--scene=sphere', `--size=${side}x${side}`, `--model=${model}`, `-n${n}`, '--light=-1,1,1.5'])
            show(canvas, width, height, rgba)
            caption.textContent = `${title}, n = ${n}`
        }
    }, 250)
})

// The fragment is the state, so links within the page only scroll.
for (const anchor of document.querySelectorAll<HTMLAnchorElement>('a[data-jump], a.skip'))
    anchor.onclick = event => {
        event.preventDefault()
        const target = byId(anchor.getAttribute('href')!.slice(1))
        target.scrollIntoView()
        target.focus({ preventScroll: true })
    }
