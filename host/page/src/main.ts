// SPDX-License-Identifier: MIT
import { ask } from './client'
import { stateOfFragment, wordsOf } from './words'

const canvas = document.querySelector('canvas')!
const context = canvas.getContext('2d', { colorSpace: 'srgb' })!

async function draw(): Promise<void> {
    const state = stateOfFragment(location.hash || '#scene=sphere')
    const picture = await ask('draw', wordsOf(state))
    canvas.width = picture.width
    canvas.height = picture.height
    context.putImageData(new ImageData(new Uint8ClampedArray(picture.rgba.buffer), picture.width, picture.height), 0, 0)
}
addEventListener('hashchange', draw)
void draw()
