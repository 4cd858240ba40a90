// SPDX-License-Identifier: MIT
// The page in a browser, from a file, beside the command: of a test whose words are PACKAGES PAGE GLINT BROWSER.
import { check } from '../pico/tap.mjs'
import { Browser } from './browser.mjs'
import { Command, difference } from './glint.mjs'
import { extras, surfaces } from './maps.mjs'

export const [packages, folder, glint, name] = process.argv.slice(2)
export const isFirefox = name === 'firefox'
export const { fragmentOf, stateOfFragment, stateOfWords, readPng, wordsOf } = await import(`${process.cwd()}/${folder}/engine.mjs`)
export const command = new Command(glint)
for (const [file, bytes] of [...Object.entries(surfaces).map(([file, { bytes }]) => [file, bytes]), ...Object.entries(extras)])
    command.put(file, bytes)
export const browser = await Browser.open(packages, name, `${folder}/index.html`)
export const { page } = browser

export const fragment = words => fragmentOf(stateOfWords(words))
export const start = 'scene=coin&size=64x48&format=rgb565&light=-1,1,1.2'

export const press = text => page.evaluate(text => [...document.querySelectorAll('button')].find(button => button.textContent === text).click(), text)

/** So many frames: what moves by itself has moved by then. */
export const frames = count => page.evaluate(async count => {
    for (let i = 0; i < count; i++)
        await new Promise(requestAnimationFrame)
}, count)

/** Once it is known what would be refused. */
export const asked = () => browser.until(() => document.body.dataset.asked === document.body.dataset.state)

/** The state that the page has now is what its canvas shows. */
export async function shownIsDrawn() {
    const now = await browser.now()
    const words = wordsOf(stateOfFragment(now.fragment))
    const wrong = difference(now.rgba, now.width, now.height, command.render(words))
    check(!wrong, `${words.join(' ')}: ${wrong}`)
    return words
}
