// SPDX-License-Identifier: MIT
// test_screens.mjs PACKAGES PAGE GLINT BROWSER: the page on screens of all sizes, for the keyboard and for axe.
import { readFileSync } from 'node:fs'
import { check, equal, run } from '../pico/tap.mjs'
import { asked, browser, command, folder, frames, isFirefox, name, packages, page, shownIsDrawn, start } from './beside.mjs'
import { difference } from './glint.mjs'

const groups = ['scene', 'material', 'light', 'output', 'expert']
const sizes = [[320, 568, true], [360, 740, false], [740, 360, true], [768, 1024, false], [1366, 768, true], [2560, 1440, false]]

run([
    ['pixels are zoomed by whole numbers of the screen\'s, and by halves where they are blended', async () => {
        await browser.resize(800, 600)
        await browser.go(start)
        const zoom = async () => [Number((await browser.text('zoom')).replace('×', '')), ...await page.evaluate(() => {
            const canvas = document.getElementById('canvas'), { width } = canvas.getBoundingClientRect()
            return [width * devicePixelRatio / canvas.width, canvas.classList.contains('smooth')]
        })]
        const [fit] = await zoom()
        for (const [id, expected] of [['zoom-in', fit + 1], ['zoom-out', fit], ['zoom-out', fit - 1], ...[3, 2.5, 2, 1.75, 1.5].filter(scale => scale < fit - 1).map(scale => ['zoom-out', scale]), ['zoom-fit', fit]]) {
            for (let said; (said = (await zoom())[0]) !== expected;) {
                await page.click(`#${id}`)
                check((await zoom())[0] !== said, `${id} changes nothing`)
            }
            const [, real, isBlended] = await zoom()
            check(Math.abs(real - expected) < 1e-3, `${id}: it draws ${real}, not ${expected}`)
            equal(isBlended, expected % 1 !== 0, `${expected}: blended`)
        }
    }],
    ['the explanation has N, L, H and t in a picture, and MSH, Cayley and Blinn at the picture\'s n with their formulas', async () => {
        await browser.go(start + '&n=77')
        await page.click('#show-how')
        await browser.until(() => [...document.querySelectorAll('#beside figcaption')].every(caption => caption.textContent.endsWith('n = 77')))
        const [names, formulas] = await page.evaluate(() => ['.diagram .names text', '#beside .of-model'].map(of => [...document.querySelectorAll(of)].map(element => element.textContent)))
        check(['N', 'L', 'H', 't'].every(name => names.includes(name)), names.join())
        equal(new Set(formulas.filter(formula => formula)).size, 3, 'formulas')
        for (const [i, model] of ['msh', 'cayley', 'blinn'].entries()) {
            const drawn = await page.evaluate(i => {
                const canvas = document.querySelectorAll('#beside canvas')[i]
                return [...canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data]
            }, i)
            const wrong = difference(drawn, 200, 200, command.render(['--scene=sphere', '--size=200x200', `--model=${model}`, '-n77', '--light=-1,1,1.5']))
            check(!wrong, `${model}: ${wrong}`)
        }
    }],
    ...[[360, 740], [800, 600], [1366, 768]].map(([width, height]) => [`by the keyboard alone every control is reached, in the order in which it stands, and its focus is seen, at ${width}x${height}`, async () => {
        await browser.resize(width, height)
        await browser.go(start)
        for (const group of groups) {
            await browser.tab(group)
            if (group === 'expert')
                await browser.expert()
            await asked()
            const all = await page.evaluate(() => {
                document.activeElement.blur()
                const list = [...document.querySelectorAll('body > :not(dialog) :is(button, input, select, a[href], summary), body > a')].filter(control => !control.disabled && control.tabIndex >= 0 && control.checkVisibility())
                list.forEach((control, i) => { control.dataset.place = i })
                return list.length
            })
            const reached = []
            await page.focus('#skip')
            for (let first = true; reached.length < all; first = false) {
                if (!first)
                    await page.keyboard.press('Tab')
                if (await page.evaluate(() => document.activeElement.matches('div'))) // browsers stop at what scrolls
                    continue
                const [place, ring, name] = await page.evaluate(() => {
                    const control = document.activeElement, seen = control.classList.contains('hidden') ? control.nextElementSibling : control
                    const { outlineStyle, outlineWidth } = getComputedStyle(seen), box = seen.getBoundingClientRect(), scroller = document.getElementById('scroller'), fold = scroller.contains(seen) ? scroller.getBoundingClientRect().bottom : innerHeight
                    return [Number(control.dataset.place), outlineStyle === 'solid' && parseFloat(outlineWidth) >= 2 && box.width > 8 && box.height > 8 && box.top >= 0 && box.bottom <= fold, `${control.outerHTML.slice(0, 90)}: ${outlineStyle} ${outlineWidth}, ${box.top} to ${box.bottom} of ${fold}`]
                })
                check(ring || first, `the focus is not seen on ${name}`)
                reached.push(place)
            }
            equal(reached.join(), Array.from({ length: all }, (_, i) => i).join(), `${group}: places in the order of Tab`)
        }
    }]),
    ['what has the focus comes into view from far above, each time', async () => { // Firefox went back one time in ten
        await browser.resize(360, 740)
        await browser.go('scene=teapot')
        await browser.expert()
        const isAt = () => page.evaluate(() => document.activeElement.matches('.legend summary'))
        for (let i = 0; i < 20; i++) {
            await page.evaluate(() => {
                document.getElementById('scroller').scrollTop = 0
                document.getElementById('tab-expert').focus()
            })
            for (let tabs = 0; tabs < 20 && !await isAt(); tabs++)
                await page.keyboard.press('Tab')
            await frames(5)
            const { top, bottom } = await page.evaluate(() => document.activeElement.getBoundingClientRect().toJSON())
            check(await isAt() && top > 0 && bottom <= 740, `round ${i}: it is at ${top} to ${bottom} of 740`)
        }
    }],
    ...sizes.map(([width, height, dark]) => [`at ${width}x${height} nothing covers anything, and what is touched is large enough`, async () => {
        await browser.resize(width, height)
        await browser.go(start.replace('coin', 'teapot') + '&background=9,9,9')
        await browser.until(() => !document.getElementById('turn').hidden)
        const isTouched = width < 600
        for (const group of groups) {
            await browser.tab(group)
            await asked()
            const wrong = await page.evaluate(async isTouched => {
                const scroller = document.getElementById('scroller'), wrong = new Set()
                const shown = [...document.querySelectorAll('header :is(button, a), .bar button, .tabs button, .stage, #scroller :is(button, select, input:not(.hidden), label.file, summary, a)')].filter(control => control.checkVisibility())
                for (const control of shown) {
                    const { width, height } = control.getBoundingClientRect()
                    if (isTouched && !control.matches('.stage, a') && (width < 43.5 || height < 43.5))
                        wrong.add(`${control.outerHTML.slice(0, 80)} has ${width} x ${height}`)
                }
                for (let at = 0; ; at += 16) {
                    scroller.scrollTop = at
                    const place = scroller.getBoundingClientRect()
                    for (const control of shown) {
                        const box = control.getBoundingClientRect(), x = box.x + box.width / 2, y = box.y + box.height / 2
                        if (scroller.contains(control) && (y < place.top || y > place.bottom - 1))
                            continue
                        const top = document.elementFromPoint(x, y)
                        if (!control.contains(top))
                            wrong.add(`at ${at}: ${control.outerHTML.slice(0, 80)} is below ${top?.outerHTML.slice(0, 80)}`)
                    }
                    if (at > scroller.scrollHeight - scroller.clientHeight)
                        break
                }
                const whole = document.documentElement
                if (whole.scrollWidth > whole.clientWidth || whole.scrollHeight > whole.clientHeight || scroller.scrollWidth > scroller.clientWidth)
                    wrong.add(`it is ${whole.scrollWidth - whole.clientWidth} too wide, ${whole.scrollHeight - whole.clientHeight} too high, its controls ${scroller.scrollWidth - scroller.clientWidth} too wide`)
                return [...wrong].join('\n')
            }, isTouched)
            equal(wrong, '', group)
        }
        const share = await page.evaluate(() => document.getElementById('stage').clientHeight / innerHeight)
        check(share >= .4, `the stage has ${share} of the height`)
    }]),
    ['in windows so low that the controls are beside a small picture, none of them is cut off', async () => {
        for (const [width, height] of [[427, 240], [568, 320]])
            for (const scene of ['knob', 'teapot']) {
                await browser.resize(width, height)
                await browser.go(start.replace('coin', scene))
                await asked()
                for (const group of groups) {
                    await browser.tab(group)
                    equal(await page.evaluate(() => document.getElementById('scroller').scrollWidth - document.getElementById('scroller').clientWidth), 0, `${scene}, ${width}x${height}, ${group}: too wide by`)
                }
            }
    }],
    ['with letters of twice the size nothing but what lies below the picture is scrolled sideways', async () => {
        for (const [width, height] of [[800, 600], [1366, 768]]) {
            await browser.resize(width, height)
            await browser.go(start.replace('coin', 'teapot') + '&background=9,9,9')
            await browser.until(() => !document.getElementById('turn').hidden)
            await page.evaluate(() => { document.documentElement.style.fontSize = '30px' })
            for (const group of groups) {
                await browser.tab(group)
                const wide = await page.evaluate(() => ['html', 'body', 'header', '#scroller', '#tabs'].map(of => document.querySelector(of)).map(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth).join())
                equal(wide, '0,0,0,0,0', `${width}x${height}, ${group}: too wide by`)
            }
        }
    }],
    ['every button below the picture is reached in windows of any width, while work goes on', async () => {
        for (const width of [320, 400, 560, 600, 640, 700, 800, 1000]) {
            await browser.resize(width, 480)
            await browser.go(start.replace('coin', 'teapot'))
            await browser.until(() => !document.getElementById('turn').hidden)
            await page.evaluate(() => globalThis.workers.forEach(worker => { worker.isHeld = true }))
            await browser.set('control-zoom', '2')
            await browser.until(() => !document.getElementById('busy').hidden)
            equal(await page.evaluate(() => [...document.querySelectorAll('.bar button')].filter(button => button.checkVisibility()).filter(button => {
                button.scrollIntoView()
                const { x, y, width, height } = button.getBoundingClientRect()
                return !button.contains(document.elementFromPoint(x + width / 2, y + height / 2))
            }).map(({ id }) => id).join()), '', `out of reach at ${width}`)
        }
    }],
    ...isFirefox ? [] : [['in the user\'s own colours what is switched on, pressed or chosen looks other than what is not', async () => {
        const session = await page.createCDPSession(), forced = value => session.send('Emulation.setEmulatedMedia', { features: [{ name: 'forced-colors', value }] })
        await browser.resize(800, 600)
        await browser.go(start)
        await forced('active')
        const looks = async (of, change) => {
            const one = async () => (await page.$(of)).screenshot({ encoding: 'base64' }), before = await one()
            await page.evaluate(change, of)
            await page.mouse.move(1, 1)
            check(await one() !== before, `${of} looks the same`)
        }
        await browser.tab('output')
        await looks('#control-dither', of => { document.querySelector(of).checked = true })
        await looks('#code', of => document.querySelector(of).setAttribute('aria-pressed', 'true'))
        await looks('#tab-scene', of => document.querySelector(of).setAttribute('aria-selected', 'true'))
        await forced('none')
        await session.detach()
    }]], // puppeteer cannot tell Firefox so
    ['an address with ?embed shows the stage alone, and why the picture is another one', async () => {
        await page.goto('about:blank')
        await page.goto(`${browser.url}?embed#${start}`)
        await browser.until(() => document.body.dataset.drawn !== undefined)
        await shownIsDrawn()
        const seen = await page.evaluate(() => ['header', '.tools', '.bar', '.stage'].map(of => document.querySelector(of).checkVisibility()).join())
        equal(seen, 'false,false,false,true', 'what is seen')
        await page.evaluate(() => { location.hash = 'height=none.png' })
        await browser.until(() => document.getElementById('refusal').checkVisibility())
        const [said, stage, width, height] = await page.evaluate(() =>
            [...['refusal', 'stage'].map(id => document.getElementById(id).getBoundingClientRect().toJSON()), innerWidth, innerHeight])
        const isBelow = said.top >= stage.bottom - 1 && said.bottom <= height + 1 && said.width > .9 * width && stage.bottom > 200
        check(isBelow, `it stands at ${JSON.stringify([said, stage, width, height])}`)
        check((await browser.text('refusal')).startsWith('none.png: this map is not here'), await browser.text('refusal'))
    }],
    ['on phones, laptops and large screens, light and dark, axe finds nothing in any group', async () => {
        const axe = readFileSync(`${packages}/node_modules/axe-core/axe.min.js`, 'utf8')
        for (const [width, height, dark] of sizes) {
            await browser.resize(width, height)
            if (!isFirefox)
                await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }])
            await browser.go()
            await page.addScriptTag({ content: axe }) // no eval, which the page's policy refuses
            for (const group of groups) {
                await browser.tab(group)
                if (group === 'expert')
                    await browser.expert()
                await asked()
                const small = await page.evaluate(() => [...document.querySelectorAll('#curve text, #histogram text')].filter(text => text.checkVisibility() && text.getBoundingClientRect().height < 10).map(text => text.textContent).join())
                equal(small, '', `${width}x${height}, ${group}: letters too small to read`)
                await page.screenshot({ path: `${folder}/${name}-${width}x${height}-${group}.png` })
                const found = await page.evaluate(async () => (await axe.run()).violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`))
                equal(found.join('\n'), '', `${width}x${height}, ${group}: axe`)
            }
            await page.click('#show-how')
            await browser.until(() => [...document.querySelectorAll('#beside figcaption')].every(caption => caption.textContent))
            const found = await page.evaluate(async () => (await axe.run()).violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`))
            equal(found.join('\n'), '', `${width}x${height}, how it works: axe`)
        }
    }],
    ['nothing was written to the console as an error', () => equal(browser.wrong.join('\n'), '', 'errors')],
], () => browser.close())
