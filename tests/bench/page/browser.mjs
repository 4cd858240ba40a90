// SPDX-License-Identifier: MIT
// browser.mjs NPM PAGE: what a user waits for, in headless Chromium: from opening the page to the first picture, from a press to a sign of
// work where that takes long, and redraws a second while the light moves. Medians of several turns.
import { Browser } from '../../page/browser.mjs'

const [packages, folder] = process.argv.slice(2)
const browser = await Browser.open(packages, 'chromium', `${folder}/index.html`)
const { page } = browser
const median = values => values.sort((a, b) => a - b)[values.length >> 1]

async function several(measure) {
    const values = []
    for (let i = 0; i < 5; i++)
        values.push(await measure())
    return median(values)
}

const first = await several(async () => {
    await browser.go()
    return page.evaluate(() => performance.getEntriesByName('first picture')[0].startTime)
})
const sign = await several(async () => {
    await browser.go()
    const time = await page.evaluate(async () => {
        const input = document.getElementById('control-size'), start = performance.now()
        input.value = '3000x3000'
        input.dispatchEvent(new Event('change', { bubbles: true }))
        while (document.getElementById('busy').hidden)
            await new Promise(requestAnimationFrame)
        return performance.now() - start
    })
    await page.evaluate(() => document.getElementById('stop').click()) // it may be done already
    return time
})
const redraws = await several(async () => {
    await browser.go()
    await page.click('#orbit')
    return page.evaluate(async () => {
        let count = 0
        new MutationObserver(list => { count += list.length }).observe(document.body, { attributeFilter: ['data-drawn'] })
        await new Promise(resolve => setTimeout(resolve, 2000))
        return count / 2
    })
})
console.log(`\nThe page in Chromium, the coin of 240x240: ${(first / 1000).toFixed(2)} s to the first picture, ${sign.toFixed(0)} ms from a press to a sign of work, ${redraws.toFixed(0)} redraws a second (measured on this computer)`)
await browser.close()
