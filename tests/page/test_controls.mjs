// SPDX-License-Identifier: MIT
// test_controls.mjs PACKAGES PAGE GLINT BROWSER: what a user does with the page in a browser, by mouse, finger and keyboard, and what is
// told there.
import { readFileSync } from 'node:fs'
import { check, equal, run } from '../pico/tap.mjs'
import { browser, command, folder, fragment, isFirefox, name, packages, page, press, shownIsDrawn, start, stateOfFragment, stateOfWords, wordsOf } from './beside.mjs'
import { difference } from './glint.mjs'
import { extras, png, surfaces } from './maps.mjs'
import { ball, gltf, meshes } from './meshes.mjs'
import { randomly, randomWords } from './states.mjs'

const measured = readFileSync(new URL('../bench/costs.tsv', import.meta.url), 'utf8').split('\n')

/** So many frames: what moves by itself has moved by then. */
const frames = count => page.evaluate(async count => {
    for (let i = 0; i < count; i++)
        await new Promise(requestAnimationFrame)
}, count)

/** Once it is known what would be refused. */
const asked = () => browser.until(() => document.body.dataset.asked === document.body.dataset.state)

/** Sets a control and finds its word in the command line. */
async function sets(id, value, word) {
    const [before] = await browser.draw([start])
    await browser.set(id, value)
    const words = await shownIsDrawn()
    check(words.includes(word), `${id} = ${value} gives ${words.join(' ')}, not ${word}`)
    check((await browser.text('command')).includes(word.replace(/^(--[a-z-]+)$/, '$1')), `the command line lacks ${word}: ${await browser.text('command')}`)
    const { rgba } = await browser.now()
    check(!rgba.equals(before.rgba), `${id} = ${value} does not change the picture`)
}

const groups = ['scene', 'material', 'light', 'output', 'expert']
const sizes = [[320, 568, true], [360, 740, false], [740, 360, true], [768, 1024, false], [1366, 768, true], [2560, 1440, false]]

run([
    ['a logo rises by Bevel, a height map is seamless, green is flipped, and a map is taken away, by their controls; warnings are listed', async () => {
        const changes = async (id, value, word) => {
            const { rgba } = await browser.now()
            await browser.set(id, value)
            const words = await shownIsDrawn()
            check(words.includes(word), `${id} gives ${words.join(' ')}`)
            check(!(await browser.now()).rgba.equals(rgba), `${id} changes nothing`)
        }
        const drop = async file => {
            const bytes = surfaces[file.replace(/^normals /, '')].bytes
            command.put(file, bytes)
            await browser.drop({ [file]: bytes })
            await browser.until(file => document.body.dataset.drawn?.includes(encodeURIComponent(file)), file)
        }
        const shown = () => page.evaluate(() => ['scale', 'bevel', 'wrap', 'flip-y'].filter(option => document.getElementById(`control-${option}`).closest('.row').checkVisibility()).join())
        await browser.go(start)
        await drop('a-logo.png')
        equal(await shown(), 'scale,bevel,wrap', 'controls of a height map')
        await changes('control-bevel', '9', '--bevel=9')
        await asked()
        const why = await page.evaluate(() => [document.getElementById('control-wrap').disabled, document.getElementById('control-wrap').closest('.row').querySelector('.why').textContent].join(': '))
        equal(why, 'true: Not now: Seamless cannot be used with Bevel: a logo has no seams', 'Seamless beside a bevel')
        await drop('grey16.png')
        check(!(await shownIsDrawn()).some(word => word.startsWith('--bevel')), 'another map keeps the bevel')
        await changes('control-wrap', true, '--wrap')
        await drop('normals rgba8.png')
        equal(await shown(), 'flip-y', 'controls of a normal map')
        check(/its alpha is the mask/.test(await browser.text('warnings')), `the warnings are ${await browser.text('warnings')}`)
        await changes('control-flip-y', true, '--flip-y')
        await browser.drop({ 'albedo.png': extras['albedo.png'] })
        await browser.until(() => document.body.dataset.drawn?.includes('albedo.png'))
        await shownIsDrawn()
        await page.evaluate(() => document.querySelector('[aria-label="Colours: remove"]').click())
        check(!(await shownIsDrawn()).some(word => word.startsWith('--albedo')), 'the albedo stays')
        await press('Coin')
        equal(await shown(), '', 'controls of a map for a scene')
    }],
    ['every control sets its option, changes the picture and the command line', async () => {
        await browser.go(start)
        await browser.tab('material') // what is not seen waits for its values until the state rests
        for (const [id, value, word] of [['control-model', 'gauss', '--model=gauss'], ['control-across', '5', '--across=5'], ['control-background', '#30c060', '--background=48,192,96'], ['control-n', '300', '-n300'], ['control-roughness', '0.4', '--roughness=0.4'], ['control-q', '2', '-q2'],
            ['control-color', '#3060c0', '--color=48,96,192'], ['control-ambient', '0.5', '--ambient=0.5'], ['control-diffuse', '0.3', '--diffuse=0.3'],
            ['control-specular', '0.1', '--specular=0.1,0.091,0.067'], ['control-format', 'rgb888', ''], ['control-format', 'mono', '--format=mono'],
            ['control-dither', true, '--dither'], ['control-space', 'linear', '--space=linear'], ['control-path', 'span', '--path=span'],
            ['control-size', '61x47', '--size=61x47'], ['control-view', '.2,.1,1', '--view=.2,.1,1']])
            await (word ? sets(id, value, word) : Promise.resolve())
        await browser.go(start.replace('coin', 'sphere'))
        await browser.set('control-clamp-peak', true)
        check((await shownIsDrawn()).includes('--clamp-peak'), 'no --clamp-peak')
    }],
    ['materials, scenes, lights, undo and redo do what they say', async () => {
        await browser.go(start)
        const words = []
        for (const step of [() => press('Dial'), () => press('Gold'), () => browser.set('control-n', '77'), () => press('Add a light')]) {
            await step()
            words.push((await shownIsDrawn()).join(' '))
        }
        check(words[0].includes('--scene=dial') && words[1].includes('--material=gold') && words[2].includes('--material=gold -n77') && words[3].includes('--point='), words.join('\n'))
        await press('Undo')
        equal((await shownIsDrawn()).join(' '), words[2], 'undone')
        await press('Undo')
        equal((await shownIsDrawn()).join(' '), words[1], 'undone twice')
        await press('Redo')
        equal((await shownIsDrawn()).join(' '), words[2], 'done again')
        await press('Reset')
        const materials = []
        for (const name of ['Plastic', 'Steel', 'Brushed steel', 'Gold', 'Jade']) {
            await browser.set('control-n', '9')
            await press(name)
            materials.push((await shownIsDrawn()).join(' '))
            check(!materials.at(-1).includes('-n9'), `${name} leaves what was set by hand`)
        }
        equal(new Set(materials).size, 5, 'materials')
        await press('Reset')
        equal((await shownIsDrawn()).join(' '), '--scene=coin --size=240x240 --format=rgb565 --light=-1,1,1.2', 'reset')
        await page.keyboard.down('Control')
        await page.keyboard.press('z')
        equal((await shownIsDrawn()).join(' '), materials[4], 'undone by Ctrl-Z')
        await page.keyboard.press('y')
        await page.keyboard.up('Control')
        equal((await shownIsDrawn()).join(' '), '--scene=coin --size=240x240 --format=rgb565 --light=-1,1,1.2', 'done again by Ctrl-Y')
    }],
    ['grain is set by its kind, and by an angle or a point', async () => {
        await browser.go(start + '&across=4')
        for (const [id, value, word] of [['control-grain', 'spun', '--grain=spun'], ['control-grain-at', '20, 10', '--grain=spun:20,10'], ['control-grain', 'brushed', '--grain=brushed'], ['control-grain-at', '60', '--grain=brushed:60']]) {
            const { rgba } = await browser.now()
            await browser.set(id, value)
            check((await shownIsDrawn()).includes(word), `no ${word}`)
            check(word === '--grain=brushed' || !(await browser.now()).rgba.equals(rgba), `${word} changes nothing`)
        }
        await browser.set('control-grain', '')
        check(!(await shownIsDrawn()).some(word => word.startsWith('--grain')), 'the grain stays')
    }],
    ['each control shows the number that C gets, and says what it means', async () => {
        await browser.go(start)
        await asked()
        const rows = await page.evaluate(() => [...document.querySelectorAll('[id^=rows-] .row')].filter(row => !row.hidden).map(row => [row.querySelector('.number').value, row.querySelector('.meaning').textContent]))
        check(rows.length === 21 && rows.every(([number, meaning]) => number && meaning), JSON.stringify(rows))
        const numbers = rows.map(([number]) => number)
        for (const number of ['GLINT_MSH', 'n = 30', 'ambient_q16 = {9830, 9830, 9830}', 'GLINT_RGB565', 'clamp_peak = false'])
            check(numbers.includes(number), `${number} is not in ${numbers.join('; ')}`)
        check(/^l = \{-?\d+, .* in Q1\.15$/.test(await page.evaluate(() => document.querySelector('#lights .number').value)), 'the light')
        const isSeen = () => page.evaluate(() => document.querySelector('#rows-scene .note').checkVisibility())
        check(!await isSeen(), 'code is shown before it is asked for')
        await page.focus('#control-size')
        check((await browser.text('help')).startsWith('64x48'), `of a focused control it says ${await browser.text('help')}`)
        await page.click('#code')
        check(await isSeen(), 'no code is shown')
        await page.click('#code')
    }],
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
    ['nothing moves by itself, and with reduced motion no control fades', async () => {
        await browser.go(start)
        const { rgba } = await browser.now()
        await frames(20)
        check((await browser.now()).rgba.equals(rgba), 'the picture moves')
        await page.click('#orbit')
        await browser.until(before => document.body.dataset.drawn !== before, start)
        await page.click('#orbit')
        await shownIsDrawn()
        if (isFirefox) // which cannot be told so by puppeteer
            return
        const fades = () => page.evaluate(() => getComputedStyle(document.getElementById('orbit')).transitionDuration)
        await page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'no-preference' }])
        check(parseFloat(await fades()) > 0, 'nothing fades otherwise')
        await page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }])
        equal(parseFloat(await fades()), 0, 'seconds')
        const before = (await shownIsDrawn()).at(-1)
        await page.click('#orbit') // a step
        const after = (await shownIsDrawn()).at(-1)
        check(after !== before, 'Orbit does nothing')
        await frames(20)
        equal((await shownIsDrawn()).at(-1), after, 'the light after a step')
    }],
    ['the light moves by dragging and by arrow keys', async () => {
        await browser.go(start)
        const box = await (await page.$('#canvas')).boundingBox()
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
        await page.mouse.down()
        await page.mouse.move(box.x + box.width * .75, box.y + box.height * .5, { steps: 4 })
        await page.mouse.up()
        const [x, y] = (await shownIsDrawn()).find(word => word.startsWith('--light=')).slice(8).split(',').map(Number)
        check(Math.abs(x - .667) < .02 && Math.abs(y) < .02, `dragged to ${x}, ${y}`)
        await page.focus('#handle-1')
        await page.keyboard.press('ArrowUp')
        const [, up] = (await shownIsDrawn()).find(word => word.startsWith('--light=')).slice(8).split(',').map(Number)
        check(up > y + .02, `an arrow key moves it from ${y} to ${up}`)
    }],
    ['the light moves by a finger', async () => {
        await browser.go(start)
        const box = await (await page.$('#canvas')).boundingBox()
        await page.touchscreen.touchStart(box.x + box.width / 2, box.y + box.height / 2)
        await page.touchscreen.touchMove(box.x + box.width / 2, box.y + box.height * .4)
        await page.touchscreen.touchMove(box.x + box.width / 2, box.y + box.height / 4)
        await page.touchscreen.touchEnd()
        const [x, y] = (await shownIsDrawn()).find(word => word.startsWith('--light=')).slice(8).split(',').map(Number)
        check(Math.abs(x) < .02 && Math.abs(y - .5) < .02, `dragged to ${x}, ${y}`)
    }],
    ['the teapot turns by dragging and by arrow keys, while the button is pressed', async () => {
        const turn = async () => (await shownIsDrawn()).find(word => word.startsWith('--turn='))?.slice(7).split(',').map(Number)
        await browser.go(start)
        check(await page.evaluate(() => document.getElementById('turn').hidden), 'the coin can be turned')
        await page.evaluate(() => [...document.querySelectorAll('button')].find(button => button.textContent === 'Teapot').click())
        equal(await turn(), undefined, 'its turn')
        await browser.until(() => !document.getElementById('turn').hidden)
        await page.click('#turn')
        const box = await (await page.$('#canvas')).boundingBox()
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
        await page.mouse.down()
        await page.mouse.move(box.x + box.width * .75, box.y + box.height / 2)
        await page.mouse.up()
        const [x, y] = await turn()
        check(Math.abs(x - 25) < 3 && Math.abs(y - 15) < 3, `dragged to ${x}, ${y}`)
        await page.keyboard.press('ArrowDown')
        equal((await turn())[0], Math.round(10 * (x + 5)) / 10, 'x after an arrow key')
        await page.click('#turn')
        await page.focus('#handle-1')
        await page.keyboard.press('ArrowUp')
        equal((await turn())[0], Math.round(10 * (x + 5)) / 10, 'x after an arrow key for the light')
        for (const [id, value, word] of [['control-zoom', '1.4', '--zoom=1.4'], ['control-turn', '10,20,30', '--turn=10,20,30'], ['control-perspective', '3', '--perspective=3'], ['control-no-outlines', false, '--no-outlines'], ['control-split', '180', '--split=180']]) {
            const { rgba } = await browser.now()
            await browser.set(id, value)
            check((await shownIsDrawn()).includes(word), `no ${word}`)
            check(!(await browser.now()).rgba.equals(rgba), `${word} changes nothing`)
        }
        await browser.expert()
        const shown = await browser.text('costs'), cycles = Number(measured.find(row => row.startsWith('frame\tmesh teapot exact\tO2\t60\t')).split('\t')[4])
        check(cycles > 1e6 && shown.includes('exact, n = 60, split none') && shown.includes(`M0+, cycles a picture${cycles.toLocaleString('en')} (emulated)`), `the costs are ${shown}`)
        check((await browser.text('errors')).includes('msh in double'), 'no errors')
        check(/interpolated normals/.test(await browser.text('errors-note')) && (await browser.text('legend')).includes('msh in double'), 'errors are not explained')
        const saved = await browser.save('file-mesh', 2), expected = command.files(['bake', '--scene=teapot', '--split=180', '--no-outlines', '-o', 'mesh.c'])
        check(Object.keys(expected).every(file => saved[file]?.equals(expected[file])), 'the saved mesh is not the command\'s')
        check(await page.evaluate(() => document.getElementById('file-int8').hidden && !document.getElementById('file-material').hidden), 'files of a map are offered')
    }],
    ['a dropped STL is drawn, turned, set and baked as the command does', async () => {
        const name = 'ring.stl', bytes = meshes[name]
        command.put(name, bytes)
        await browser.go(start)
        await browser.drop({ [name]: bytes })
        await browser.until(name => document.body.dataset.drawn?.includes(name), name)
        equal((await shownIsDrawn()).join(' '), '--mesh=ring.stl --size=64x48 --format=rgb565 --light=-1,1,1.2', 'the state')
        await page.click('#turn')
        await page.focus('#handle-1')
        await page.keyboard.press('ArrowDown')
        for (const [id, value, word] of [['control-split', '7', '--split=7'], ['control-axes', 'y-up', '--axes=y-up'], ['control-crease', '10', '--crease=10']]) {
            const { rgba } = await browser.now()
            await browser.set(id, value)
            const words = await shownIsDrawn()
            check(words.includes(word) && words.includes('--turn=5,0,0'), words.join(' '))
            check(!(await browser.now()).rgba.equals(rgba), `${word} changes nothing`)
        }
        const saved = await browser.save('file-mesh', 2), expected = command.files(['bake', '--mesh=ring.stl', '--crease=10', '--axes=y-up', '--split=7', '-o', 'mesh.c'])
        check(Object.keys(expected).every(file => saved[file]?.equals(expected[file])), 'the saved mesh is not the command\'s')
        check(/such a picture takes a Cortex-M0\+ [\d.]+ million cycles/.test(await browser.text('file-status')), await browser.text('file-status'))
        await press('Coin')
        equal((await shownIsDrawn()).join(' '), '--scene=coin --size=64x48 --format=rgb565 --light=-1,1,1.2', 'the coin after it')
        await press('Undo')
        check((await shownIsDrawn()).includes('--mesh=ring.stl'), 'undone')
    }],
    ['a mesh wears a dropped PNG as the command draws it; other pictures are refused with a word', async () => {
        await browser.go(start.replace('coin', 'teapot'))
        for (const [i, [file, { bytes }]] of Object.entries(surfaces).filter(([file]) => !/16|gamma/.test(file)).entries()) {
            const name = `texture ${i}.png`
            command.put(name, bytes)
            await browser.drop({ [name]: bytes })
            await browser.until(name => document.body.dataset.kept === name, name)
            check((await shownIsDrawn()).includes(`--texture=${name}`), file)
        }
        await browser.set('control-nearest', true)
        const words = await shownIsDrawn()
        check(words.includes('--nearest'), words.join(' '))
        const saved = await browser.save('file-mesh', 2), expected = command.files(['bake', ...words.filter(word => /^--(scene|texture|nearest)/.test(word)), '-o', 'mesh.c'])
        check(Object.keys(expected).every(file => saved[file]?.equals(expected[file])), 'the saved mesh is not the command\'s')
        for (const [name, bytes, sentence] of [['texture.jpg.png', Buffer.from('\xff\xd8\xff\xe0', 'latin1'), /a JPEG, not a PNG; convert it/], ['texture16.png', surfaces['grey16.png'].bytes, /16 bits a sample/],
            ['texture of gamma 1.png', png({ width: 4, height: 4, type: 0, depth: 8, sample: () => 99, extra: [['gAMA', [0, 1, 0x86, 0xa0]]] }), /a gamma or colour profile of its own/]]) {
            await browser.drop({ [name]: bytes })
            await browser.until(name => document.getElementById('refusal').textContent.startsWith(name), name)
            check(sentence.test(await browser.text('refusal')), await browser.text('refusal'))
            equal((await shownIsDrawn()).join(' '), words.join(' '), `the state after ${name}`)
        }
        await press('Coin')
        check(!(await shownIsDrawn()).some(word => /texture|nearest/.test(word)), 'the texture stays')
    }],
    ['the address restores the state, with controls that show it', async () => {
        const words = ['--scene=watchface', '--size=50x40', '--model=cayley', '-n77', '-q9', '--ambient=.3', '--format=rgb565', '--dither', '--light=.5,.5,1', '--point=10,20,30,90,1,.5,.25']
        await browser.go(fragment(words))
        equal((await shownIsDrawn()).join(' '), wordsOf(stateOfWords(words)).join(' '), 'the state')
        await asked()
        const shown = await page.evaluate(() => ['model', 'n', 'q', 'ambient', 'format', 'size'].map(option => document.getElementById(`control-${option}`).value).join(' ') + ' ' + document.getElementById('control-dither').checked)
        equal(shown, 'cayley 77 9 0.3 rgb565 50x40 true', 'the controls')
        await page.evaluate(fragment => { location.hash = fragment }, start)
        equal((await shownIsDrawn()).join(' '), wordsOf(stateOfFragment(start)).join(' '), 'the state of another address')
        await page.evaluate(() => { navigator.clipboard.writeText = async text => { globalThis.copied = text } })
        for (const [id, expected] of [['copy-link', (await page.url()).replace(/#.*/, '') + '#' + start], ['copy', await browser.text('command')]]) {
            await browser.tab('output')
            await page.click(`#${id}`)
            equal(await page.evaluate(() => globalThis.copied), expected, id)
        }
        await browser.go('scene=coins&n=5000')
        check((await browser.text('refusal')).startsWith('--scene: unknown scene \'coins\''), await browser.text('refusal'))
    }],
    ['an address that names a map which is not here says so over a working scene, and draws it as the address says when it comes; so does a newer file of that name', async () => {
        const words = ['--height=not-here.png', '--bevel=5', '--color=90,140,200', '--size=40x30', '-n50']
        await browser.go(fragment(words))
        const standIn = await browser.now()
        equal(standIn.refusal, 'not-here.png: this map is not here; drop or choose the file', 'what it says')
        const wrong = difference(standIn.rgba, standIn.width, standIn.height, command.render(['--scene=coin', '--size=40x30', '-n50']))
        check(!wrong, `in its place: ${wrong}`)
        check((await browser.text('command')).includes('--height=not-here.png'), 'the command line is of another picture')
        await browser.expert()
        check(!/\b0\.000°/.test(await browser.text('extent')), 'false values')
        const drawnAgain = async (bytes, { rgba } = { rgba: Buffer.alloc(0) }) => {
            command.put('not-here.png', bytes)
            await browser.drop({ 'not-here.png': bytes })
            await browser.until(() => document.getElementById('refusal').hidden)
            for (let tries = 0; (await browser.now()).rgba.equals(rgba); tries++) {
                check(tries < 600, 'it is not drawn')
                await frames(1)
            }
            equal((await shownIsDrawn()).join(' '), wordsOf(stateOfWords(words)).join(' '), 'the state')
        }
        await drawnAgain(surfaces['a-logo.png'].bytes)
        await drawnAgain(surfaces['grey1.png'].bytes, await browser.now())
        await browser.go('normals=rgb8.png&flip-y') // whose name does not tell what it is
        await browser.drop({ 'rgb8.png': surfaces['rgb8.png'].bytes })
        await browser.until(() => document.getElementById('refusal').hidden)
        equal((await shownIsDrawn()).join(' '), '--normals=rgb8.png --flip-y', 'the state')
    }],
    ['dropped maps and meshes are here after a reload', async () => {
        for (const [name, bytes, word] of [['kept.png', surfaces['grey16.png'].bytes, '--height=kept.png'], ['kept.stl', meshes['ring.stl'], '--mesh=kept.stl'], ['kept.glb', gltf([{ ...ball(), material: 0 }], { materials: [{}] }), '--mesh=kept.glb']]) {
            command.put(name, bytes)
            await browser.go(start)
            await browser.drop({ [name]: bytes })
            await browser.until(name => document.body.dataset.drawn?.includes(name), name)
            const now = await shownIsDrawn()
            check(now.includes(word), now.join(' '))
            await browser.until(name => document.body.dataset.kept === name && location.hash.includes(name), name)
            await page.reload()
            await browser.until(() => document.body.dataset.drawn !== undefined)
            equal(await browser.text('refusal'), '', 'what it says')
            equal((await shownIsDrawn()).join(' '), now.join(' '), 'the state')
        }
    }],
    ['a logo becomes a bevelled shape at once, and brushed metal runs round the middle of a round panel', async () => {
        const disc = (x, y) => (x - 20) ** 2 + (y - 20) ** 2 < 150, side = { width: 40, height: 40, depth: 8 }
        const logos = { 'cut.png': png({ ...side, type: 6, sample: (x, y, k) => k === 3 && disc(x, y) ? 255 : 0 }), 'black.png': png({ ...side, type: 0, sample: (x, y) => disc(x, y) ? 0 : 255 }), 'hills.png': png({ ...side, type: 0, sample: (x, y) => 6 * x }) }
        for (const [name, bytes] of Object.entries(logos)) {
            command.put(name, bytes)
            await browser.go('scene=knob&size=64x48&panel=round&light=-1,1,1.2')
            await browser.drop({ [name]: bytes })
            await browser.until(name => document.body.dataset.drawn?.includes(name), name)
            equal((await shownIsDrawn()).includes('--bevel=6'), name !== 'hills.png', `a bevel of ${name}`)
            equal(await page.evaluate(() => document.querySelectorAll('#warnings li').length), 0, `warnings of ${name}`)
        }
        await browser.tab('material')
        await press('Brushed steel')
        check((await shownIsDrawn()).join(' ').includes('--grain=spun --material=brushed-steel'), await browser.text('command'))
    }],
    ['a file that is refused leaves the address, the rows and the picture as they were', async () => {
        const logo = surfaces['a-logo.png'].bytes
        command.put('good.png', logo)
        await browser.go(start)
        await browser.drop({ 'good.png': logo })
        await browser.until(() => document.body.dataset.drawn?.includes('good.png'))
        const before = await shownIsDrawn()
        const rows = () => page.evaluate(() => [...document.querySelectorAll('.file-name')].map(({ textContent }) => textContent).join())
        const had = await rows(), big = png({ width: 9, height: 9, type: 0, depth: 8, sample: () => 9 })
        for (const [name, bytes, sentence] of [['gloss-of-9.png', big, /9x9 pixels, but/], ['good.png', Buffer.from('no'), /not a PNG/], ['my normals.png', surfaces['grey8.png'].bytes, /has one channel/], ['bad.stl', Buffer.alloc(90), /not a whole binary STL/]]) {
            await browser.drop({ [name]: bytes })
            await browser.until(name => document.getElementById('refusal').textContent.startsWith(name), name)
            check(sentence.test(await browser.text('refusal')), await browser.text('refusal'))
            equal((await shownIsDrawn()).join(' '), before.join(' '), `the state after ${name}`)
            equal(await rows(), had, `the rows after ${name}`)
        }
        check(await page.evaluate(() => !document.getElementById('undo').disabled), 'nothing can be undone')
        await page.click('#undo')
        equal((await shownIsDrawn()).join(' '), wordsOf(stateOfFragment(start)).join(' '), 'undone')
    }],
    ['what the command would refuse cannot be chosen, and says why', async () => {
        const random = randomly(77)
        let offered = 0
        for (let i = 0; i < (isFirefox ? 4 : 16);) {
            const words = randomWords(random, command)
            const [{ refusal }] = await browser.draw([fragment(words)])
            if (refusal)
                continue
            i++
            await asked()
            const list = await page.evaluate(() => ['model', 'path', 'format', 'space'].flatMap(id => [...document.getElementById(`control-${id}`).options].map(option => [id, option.value, option.disabled, option.textContent])))
            for (const [id, value, isDisabled, text] of list) {
                const state = { ...stateOfWords(words), [id]: value }
                const said = await command.renderLater(wordsOf(state)).then(() => '', error => error.message)
                check(isDisabled === (said !== ''), `${words.join(' ')}: ${id} ${value} is ${isDisabled ? '' : 'not '}disabled (${text}); the command says ${said}`)
                offered++
            }
        }
        check(offered > 100, `${offered} choices`)
    }],
    ['several lights have a sun each; the chosen one is dragged, from anywhere', async () => {
        await browser.resize(1366, 768)
        await browser.go('scene=sphere&size=240x240&light=-.5,.5,.7&point=180,60,60,480')
        equal(await page.evaluate(() => document.querySelectorAll('.handle').length), 2, 'suns')
        const box = await (await page.$('#canvas')).boundingBox()
        const drag = async (x, y, to, at) => {
            await page.mouse.move(box.x + box.width * x, box.y + box.height * y)
            await page.mouse.down()
            await page.mouse.move(box.x + box.width * to, box.y + box.height * at, { steps: 3 })
            await page.mouse.up()
            return shownIsDrawn()
        }
        const lampIsAt = (words, x, y) => {
            const [a, b, ...rest] = words.find(word => word.startsWith('--point=')).slice(8).split(',').map(Number)
            check(Math.hypot(a - x, b - y) < .6 && rest.join() === '60,480', `the lamp is at ${a}, ${b}, not at ${x}, ${y}`)
        }
        lampIsAt(await drag(.75, .25, .5, .75), 120, 180) // by its sun
        const away = await drag(-.12, .5, -.1, .25) // from beside the panel
        equal(away.find(word => word.startsWith('--light=')), '--light=-.5,.5,.7', 'the other light')
        lampIsAt(away, -24, 60)
    }],
    ['tilting the device moves the light, which stays where it is in the room', async () => {
        await browser.go('scene=sphere&size=64x64&light=0,0,1')
        const told = () => page.evaluate(() => globalThis.tilts)
        const tilt = async (beta, gamma) => {
            const before = await told()
            if (!isFirefox)
                await cdp.send('DeviceOrientation.setDeviceOrientationOverride', { alpha: 0, beta, gamma })
            else
                await page.evaluate((beta, gamma) => dispatchEvent(new DeviceOrientationEvent('deviceorientation', { alpha: 0, beta, gamma })), beta, gamma)
            await browser.until(before => globalThis.tilts > before, before)
        }
        const cdp = isFirefox ? undefined : await page.createCDPSession()
        await page.click('#tilt')
        await page.evaluate(() => { // told after the page's own listener
            globalThis.tilts = 0
            addEventListener('deviceorientation', () => globalThis.tilts++)
        })
        await tilt(0, .01)
        await browser.until(() => document.getElementById('motion-note').textContent.startsWith('The light stays'))
        for (const [beta, gamma, x, y] of [[20, 0, 0, Math.sin(20 * Math.PI / 180)], [0, 30, -.5, 0]]) {
            await tilt(beta, gamma)
            await browser.until((x, y) => {
                const [a, b] = (document.body.dataset.drawn.match(/light=([^&]*)/)?.[1] ?? '').split(',').map(Number)
                return Math.hypot(a - x, b - y) < .01
            }, x, y)
            await shownIsDrawn()
        }
        const before = (await shownIsDrawn()).join()
        await tilt(.2, 30.2) // a hand that is still
        equal((await shownIsDrawn()).join(), before, 'still')
        await page.click('#tilt')
        await tilt(40, 0)
        equal((await shownIsDrawn()).join(), before, 'after the button')
        if (!isFirefox)
            await cdp.send('DeviceOrientation.clearDeviceOrientationOverride')
    }],
    ['long work shows at once that it goes on, and can be stopped', async () => {
        await browser.go(start)
        const before = (await shownIsDrawn()).join(' ')
        await browser.set('control-size', '3000x3000')
        await browser.until(() => !document.getElementById('busy').hidden || document.body.dataset.drawn === document.body.dataset.state)
        check(await page.evaluate(() => document.body.dataset.drawn !== document.body.dataset.state), 'it is drawn before a sign of work')
        await page.click('#stop')
        equal((await shownIsDrawn()).join(' '), before, 'the state after it was stopped')
        await browser.until(() => document.getElementById('busy').hidden)
        await browser.set('control-n', '9')
        check((await shownIsDrawn()).includes('-n9'), 'nothing is drawn after that')
    }],
    ['an address with ?embed shows the stage alone', async () => {
        await page.goto('about:blank')
        await page.goto(`${browser.url}?embed#${start}`)
        await browser.until(() => document.body.dataset.drawn !== undefined)
        await shownIsDrawn()
        const seen = await page.evaluate(() => ['header', '.tools', '.bar', '.stage'].map(of => document.querySelector(of).checkVisibility()).join())
        equal(seen, 'false,false,false,true', 'what is seen')
    }],
    ['the Connect button says why a page from a file reaches no device, and where one does', async () => {
        await browser.go(start)
        await browser.tab('output')
        await page.click('#connect')
        equal(await browser.text('device-status'), isFirefox ? 'This browser does not reach USB devices. Open the page in Chrome, Edge or Opera on a computer.'
            : 'Chrome loses a device that is chosen in a page from a file. Run "glint page", open http://localhost:8016/ and connect there.', 'the sentence')
        await shownIsDrawn()
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
