// SPDX-License-Identifier: MIT
// How it works: with MSH, Cayley and Blinn beside each other, at the n of the picture.
import { ask } from './client'
import lists from 'glint:lists'
import { byId, make, show, typeset } from './dom'
import { lastDrawn } from './picture'

const side = 200
const places = ['msh', 'cayley', 'blinn'].map(model => lists.models.find(({ name }) => name === model)!).map(({ name, title, formula }) => {
    const canvas = make('canvas', { width: side, height: side, role: 'img', aria: { label: `A sphere under ${title}` } })
    const caption = make('figcaption')
    byId('beside').append(make('figure', {}, canvas, caption, make('p', { className: 'of-model', textContent: typeset(formula) })))
    return { model: name, title, canvas, caption }
})

const how = byId<HTMLDialogElement>('how')
let drawnN = 0
byId('show-how').onclick = async () => {
    how.showModal()
    const n = lastDrawn()?.facts.n[0] ?? 60
    if (n === drawnN)
        return
    drawnN = 0
    for (const { model, title, canvas, caption } of places) {
        const picture = await ask('aside', ['--scene=sphere', `--size=${side}x${side}`, `--model=${model}`, `-n${n}`, '--light=-1,1,1.5']).catch(() => undefined)
        if (!picture) // stopped
            return
        show(canvas, picture.width, picture.height, picture.rgba)
        caption.textContent = `${title}, n = ${n}`
    }
    drawnN = n
}
byId('close-how').onclick = () => how.close()

// The fragment is the state, so a link within the page only moves the focus.
byId('skip').onclick = event => {
    event.preventDefault()
    byId('tools').focus()
}
