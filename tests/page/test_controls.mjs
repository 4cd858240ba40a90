// SPDX-License-Identifier: MIT
// test_controls.mjs PACKAGES PAGE GLINT BROWSER: what a user does with the page's controls and lights, by mouse, finger and
// keyboard, and what is told there.
import { readFileSync } from 'node:fs'
import { check, equal, run } from '../pico/tap.mjs'
import { asked, browser, command, fragment, frames, isFirefox, page, press, readPng, shownIsDrawn, start, stateOfFragment, stateOfWords, wordsOf } from './beside.mjs'
import { difference } from './glint.mjs'
import { surfaces } from './maps.mjs'
import { randomly, randomWords } from './states.mjs'

const measured = readFileSync(new URL('../bench/costs.tsv', import.meta.url), 'utf8').split('\n')

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

run([
    ['every control sets its option, changes the picture and the command line', async () => {
        await browser.go(start)
        await browser.tab('material') // what is not seen waits for its values until the state rests
        for (const [id, value, word] of [['control-model', 'gauss', '--model=gauss'], ['control-across', '5', '--across=5'], ['control-background', '#30c060', '--background=48,192,96'], ['control-n', '300', '-n300'], ['control-roughness', '0.4', '--roughness=0.4'], ['control-q', '2', '-q2'],
            ['control-color', '#3060c0', '--color=48,96,192'], ['control-ambient', '0.5', '--ambient=0.5'], ['control-diffuse', '0.3', '--diffuse=0.3'],
            ['control-specular', '0.1', '--specular=0.1,0.091,0.067'], ['control-format', 'rgb888', ''], ['control-format', 'mono', '--format=mono'],
            ['control-dither', true, '--dither'], ['control-space', 'linear', '--space=linear'], ['control-path', 'exact-int8', '--path=exact-int8'],
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
    ['nothing moves by itself, the address follows what circles, and with reduced motion no control fades', async () => {
        await browser.go(start)
        const { rgba } = await browser.now()
        await frames(20)
        check((await browser.now()).rgba.equals(rgba), 'the picture moves')
        await page.click('#orbit')
        const marks = () => page.evaluate(() => performance.getEntriesByType('mark').length), few = await marks()
        await browser.until(before => location.hash.slice(1) !== before, start)
        await page.click('#orbit')
        await shownIsDrawn()
        equal(await marks(), few, 'entries of a list that the browser never empties')
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
    }],
    ['what is set just before the page is loaded again is there then', async () => {
        await browser.go(start)
        await frames(40) // it is some time since the address was written
        await browser.set('control-n', '77')
        await page.evaluate(() => new Promise(resolve => setTimeout(resolve)))
        await page.reload()
        await browser.until(() => document.body.dataset.drawn !== undefined)
        check((await shownIsDrawn()).includes('-n77'), 'it is lost')
    }],
    ['an address that is refused shows why over a working scene, and every control leads out of it', async () => {
        for (const [hash, sentence] of [['scene=coins&n=5000', '--scene: unknown scene \'coins\''], ['scene=knob&light=a,b', '--light: \'a,b\' is not'], ['n=60', 'no surface; give --height']]) {
            await browser.go(hash)
            const standIn = await browser.now(), wrong = difference(standIn.rgba, standIn.width, standIn.height, command.render(wordsOf(stateOfFragment('scene=coin&size=240x240&format=rgb565&light=-1,1,1.2'))))
            check(standIn.refusal.startsWith(sentence), standIn.refusal)
            check(!wrong, `in its place: ${wrong}`)
            equal(standIn.fragment, hash, 'the state')
        }
        await browser.go('scene=coin&light=a,b')
        await page.focus('#handle-1')
        await page.keyboard.press('ArrowRight')
        await browser.until(() => document.getElementById('refusal').hidden)
        equal((await shownIsDrawn()).join(' '), '--scene=coin --light=0.04,0,0.999', 'the light that was moved')
        for (const [light, key, word] of [['light=a,b', 'PageUp', '--light=0,0,0.05'], ['light=.3', 'PageUp', '--light=.3,0,0.05'], ['light=1e999,.2,1e999', 'ArrowUp', '--light=0,0.98'], ['point=9,9,x,200', 'PageUp', '--point=9,9,4,200']]) {
            await browser.go(`scene=coin&${light}`)
            await page.focus('#handle-1')
            await page.keyboard.press(key)
            check((await shownIsDrawn()).join(' ').includes(word), `${light}, then ${key}: ${await browser.text('command')}`)
        }
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
        const place = () => page.evaluate(() => {
            const { x, y, width } = document.getElementById('canvas').getBoundingClientRect()
            return JSON.stringify([x, y, width])
        })
        const here = await place()
        await page.evaluate(() => globalThis.workers.forEach(worker => { worker.isHeld = true })) // long on any machine
        await browser.set('control-size', '3000x3000')
        await browser.until(() => !document.getElementById('busy').hidden)
        equal(await place(), here, 'the picture\'s place beside the sign of work')
        await page.click('#stop')
        equal((await shownIsDrawn()).join(' '), before, 'the state after it was stopped')
        await browser.until(() => document.getElementById('busy').hidden)
        await browser.set('control-n', '9')
        check((await shownIsDrawn()).includes('-n9'), 'nothing is drawn after that')
    }],
    ['an address that is refused, and why, stay when the picture in its place is stopped', async () => {
        const { identifier } = await page.evaluateOnNewDocument(() => {
            globalThis.Worker = class extends Worker {
                set onmessage(then) {
                    super.onmessage = event => {
                        then(event)
                        this.isHeld ||= event.data.error !== undefined && globalThis.workers[0] === this
                    }
                }
            }
        })
        await page.goto('about:blank')
        await page.goto(`${browser.url}#scene=coins&n=7`)
        await page.removeScriptToEvaluateOnNewDocument(identifier)
        await browser.until(() => document.getElementById('refusal')?.hidden === false && !document.getElementById('busy').hidden)
        await page.evaluate(() => document.getElementById('stop').click())
        await browser.until(() => document.body.dataset.drawn !== undefined && document.body.dataset.drawn === document.body.dataset.state)
        equal(await page.evaluate(() => document.body.dataset.state), 'scene=coins&n=7', 'the state')
        check((await browser.text('refusal')).startsWith('--scene: unknown scene'), await browser.text('refusal'))
        await press('Dial')
        equal((await shownIsDrawn()).join(' '), '--scene=dial --size=240x240 -n7', 'a surface chosen then')
    }],
    ['a file that is stopped is said to be, and the explanation that is stopped is drawn when it is opened again', async () => {
        const hold = () => page.evaluate(() => globalThis.workers.forEach(worker => { worker.isHeld = true }))
        const stop = () => page.evaluate(() => document.getElementById('stop').click())
        await browser.go(start)
        const before = (await shownIsDrawn()).join(' ')
        await hold()
        await browser.drop({ 'slow.png': surfaces['grey8.png'].bytes })
        await browser.until(() => !document.getElementById('busy').hidden)
        await stop()
        await browser.until(() => document.getElementById('refusal').textContent === 'slow.png: stopped before it was drawn; drop or choose it again')
        equal((await shownIsDrawn()).join(' '), before, 'the state')
        await hold()
        await page.click('#show-how')
        await stop()
        await page.click('#close-how')
        await page.click('#show-how')
        await browser.until(() => [...document.querySelectorAll('#beside figcaption')].every(caption => caption.textContent))
        await page.click('#close-how')
    }],
    ['an address whose file is stopped on its way to the worker gives way to what was there', async () => {
        await browser.go(start)
        await browser.drop({ 'kept.png': surfaces['grey8.png'].bytes })
        await browser.until(() => document.body.dataset.kept === 'kept.png')
        await browser.go(start)
        const before = (await shownIsDrawn()).join(' ')
        await page.evaluate(() => {
            globalThis.workers[0].postMessage = function (message) {
                this.isHeld ||= message.method === 'map'
                Worker.prototype.postMessage.call(this, message)
            }
            location.hash = 'height=kept.png'
        })
        await browser.until(() => globalThis.workers[0].isHeld && !document.getElementById('busy').hidden)
        await page.evaluate(() => document.getElementById('stop').click())
        equal((await shownIsDrawn()).join(' '), before, 'the state')
        equal(await browser.text('refusal'), '', 'what it says')
    }],
    ['a picture of a material that is stopped is drawn with the next picture', async () => {
        await browser.go(start)
        await browser.until(() => document.getElementById('scenes').dataset.drawn !== undefined)
        await page.evaluate(() => {
            globalThis.workers[0].postMessage = function (message) {
                this.isHeld ||= message.method === 'aside'
                Worker.prototype.postMessage.call(this, message)
            }
        })
        await browser.tab('material')
        await page.evaluate(() => document.getElementById('stop').click())
        await browser.set('control-n', '9')
        await browser.until(() => [...document.querySelectorAll('#materials canvas')].every(canvas => canvas.getContext('2d').getImageData(36, 36, 1, 1).data[3]))
    }],
    ['a button that copies has its own word again, however often it is pressed; a picture of the stage that cannot be made is said', async () => {
        await browser.go(start)
        const title = await browser.text('copy-link')
        await page.evaluate(() => {
            const { setTimeout: plain } = globalThis
            globalThis.ends = []
            globalThis.setTimeout = (then, ms, ...rest) => ms === 1500 ? globalThis.ends.push(then) : plain(then, ms, ...rest)
        })
        for (const i of [1, 2]) {
            await page.evaluate(() => document.getElementById('copy-link').click())
            await browser.until(i => globalThis.ends.length === i, i)
            check(await browser.text('copy-link') !== title, 'it does not say that it is copied')
        }
        await page.evaluate(() => globalThis.ends.forEach(end => end()))
        equal(await browser.text('copy-link'), title, 'its word')
        await page.evaluate(() => {
            HTMLCanvasElement.prototype.toBlob = then => then(null)
            document.getElementById('file-stage').click()
        })
        await browser.until(() => document.getElementById('file-status').textContent === 'The browser makes no picture of this size; choose a smaller panel or zoom')
    }],
    ['an address with a panel of no known shape shows a square one', async () => {
        await browser.go(start + '&panel=hidden%20drop')
        equal(await page.evaluate(() => document.getElementById('bezel').className), 'bezel square', 'its class')
        await shownIsDrawn()
    }],
    ['a light is added beside the one that an address does not name', async () => {
        await browser.go('scene=coin&size=64x48')
        await press('Add a light')
        equal((await shownIsDrawn()).filter(word => /^--(light|point)=/.test(word)).join(' '), '--light=-1,1,1 --point=19,14,14,96', 'the lights')
    }],
    ['of an address with thousands of lights no more are listed than tell why it is refused, and one that is removed leads out of it', async () => {
        await browser.go('scene=coin&size=64x48' + '&light=-1,1,1'.repeat(5000))
        check((await browser.text('refusal')).startsWith('--light: more than 4 lights'), await browser.text('refusal'))
        equal(await page.evaluate(() => [document.querySelectorAll('#lights .row').length, document.querySelectorAll('.handle').length].join()), '5,5', 'rows and suns')
        await page.evaluate(() => document.querySelector('[aria-label="Light 5: remove"]').click())
        equal((await shownIsDrawn()).filter(word => word.startsWith('--light=')).length, 4, 'lights')
    }],
    ['the focus stays in a light\'s row as its kind changes, and in the list as it is removed', async () => {
        const focused = () => page.evaluate(() => document.activeElement.getAttribute('aria-label'))
        await browser.go('scene=coin&size=64x48&light=-1,1,1&light=1,1,1&light=0,1,1')
        await browser.tab('light')
        await page.focus('[aria-label="Light 2: kind"]')
        await page.select('[aria-label="Light 2: kind"]', 'point')
        check((await shownIsDrawn()).some(word => word.startsWith('--point=')), 'its kind')
        equal(await focused(), 'Light 2: kind', 'the focus, of another kind')
        for (const expected of ['Light 2: remove', 'Light 1: move it in the picture']) {
            await page.focus('[aria-label="Light 2: remove"]')
            await page.keyboard.press('Enter')
            await shownIsDrawn()
            equal(await focused(), expected, 'the focus')
        }
    }],
    ['undo while the light circles ends that, and what was undone can be done again', async () => {
        await browser.go(start)
        await browser.set('control-n', '77')
        await shownIsDrawn()
        await page.click('#orbit')
        await frames(10)
        const pressed = () => page.evaluate(() => document.getElementById('orbit').getAttribute('aria-pressed'))
        for (const expected of [start.replace('size=64x48&', 'size=64x48&n=77&'), start]) {
            await page.click('#undo')
            await frames(10)
            equal((await shownIsDrawn()).join(' '), wordsOf(stateOfFragment(expected)).join(' '), 'the state')
            equal(await pressed(), 'false', 'whether it circles')
        }
        await page.click('#redo')
        check((await shownIsDrawn()).includes('-n77'), 'done again')
    }],
    ['files are of one picture, whatever is changed as they are saved; one that stands in for another is not saved', async () => {
        await browser.go(start)
        await browser.tab('output')
        await page.evaluate(() => {
            globalThis.saved = []
            const input = document.getElementById('control-size')
            input.value = '50x40'
            input.dispatchEvent(new Event('change', { bubbles: true }))
            document.getElementById('file-normals').click()
        })
        await browser.until(() => globalThis.saved.length) // some time after the page has said so
        const png = readPng('normals.png', Buffer.from(await page.evaluate(() => globalThis.saved[0].base64), 'base64'))
        equal(`${png.width}x${png.height}`, '50x40', 'its size')
        const { 'normals.bin': baked } = command.files(['bake', '--scene=coin', '--size=50x40', '--to=int16', '-o', 'normals.bin'])
        const wrong = png.samples.findIndex((value, i) => i % 4 < 3 && value !== Math.round((baked.readInt16LE(2 * (3 * (i - i % 4) / 4 + i % 4)) / 32767 + 1) / 2 * 65535))
        equal(wrong, -1, 'a sample that is another one')
        await browser.go('height=not-here.png&size=40x30')
        for (const id of ['png', 'stage', 'material']) {
            await page.evaluate(id => {
                globalThis.saved = []
                document.getElementById('file-status').textContent = ''
                document.getElementById(`file-${id}`).click()
            }, id)
            await browser.until(() => document.getElementById('file-status').textContent === 'not-here.png: this map is not here; drop or choose the file')
            equal(await page.evaluate(() => globalThis.saved.length), 0, `files of ${id}`)
        }
    }],
    ['an animation is of one picture, too, whose size is changed as it is saved', async () => {
        await browser.go('scene=coin&size=60x30&point=20,10,12,90')
        await shownIsDrawn()
        const { 'glint.apng': whole } = await browser.save('file-apng', 1)
        // At its first frame, which is told for as long as one takes.
        await page.evaluate(() => {
            const status = document.getElementById('file-status'), size = document.getElementById('control-size')
            new MutationObserver((_, observer) => {
                if (!status.textContent.startsWith('Frame'))
                    return
                observer.disconnect()
                size.value = '30x40'
                for (const type of ['input', 'change'])
                    size.dispatchEvent(new Event(type, { bubbles: true }))
            }).observe(status, { childList: true, characterData: true, subtree: true })
            globalThis.saved = []
            document.getElementById('file-apng').click()
        })
        await browser.until(() => globalThis.saved.length && document.getElementById('control-size').value === '30x40')
        const [{ base64 }] = await page.evaluate(() => globalThis.saved)
        check(whole.equals(Buffer.from(base64, 'base64')), 'it is another one')
    }],
    ['half of a surrogate pair in a control is refused, and undo takes it back', async () => {
        await browser.go(start)
        await browser.set('control-size', '5\ud83d')
        await browser.until(() => !document.getElementById('refusal').hidden)
        check((await browser.text('refusal')).includes('5\ufffd'), await browser.text('refusal'))
        await page.click('#undo')
        await browser.until(start => document.body.dataset.drawn === start, start)
        await shownIsDrawn()
    }],
    ['what is told of the picture is told when a file is stopped, too', async () => {
        await browser.go(start)
        await browser.expert()
        const extent = await browser.text('extent')
        await page.evaluate(() => {
            globalThis.workers.at(-1).isHeld = true
            document.getElementById('file-material').click()
        })
        await browser.until(() => !document.getElementById('busy').hidden)
        await page.evaluate(() => {
            for (const id of ['extent', 'errors'])
                document.getElementById(id).replaceChildren()
            document.getElementById('stop').click()
        })
        await browser.until(() => document.getElementById('file-status').textContent === 'Stopped; nothing was saved')
        await browser.until(extent => document.getElementById('extent').textContent === extent, extent)
        await shownIsDrawn()
    }],
    ['a worker that fails is said to, and another one draws what comes then; one that cannot begin is said, too', async () => {
        await browser.go(start)
        await page.evaluate(() => { globalThis.workers.at(-1).isHeld = true })
        await browser.set('control-size', '70x70')
        await browser.until(() => !document.getElementById('busy').hidden)
        await page.evaluate(() => globalThis.workers.at(-1).dispatchEvent(new ErrorEvent('error', { message: 'no memory', cancelable: true })))
        await browser.until(() => document.getElementById('refusal').textContent === 'the page failed (no memory); a smaller --size may help')
        await browser.tab('expert')
        await browser.until(() => document.querySelectorAll('#errors tr').length > 0) // of the last good picture, which that one has, too
        await browser.tab('scene')
        await browser.set('control-n', '9')
        check((await shownIsDrawn()).includes('-n9'), 'nothing is drawn after that')
        const { identifier } = await page.evaluateOnNewDocument(() => {
            globalThis.Worker = class extends Worker {
                constructor() {
                    super(URL.createObjectURL(new Blob(['throw new Error("no WebAssembly")'], { type: 'text/javascript' })))
                }
            }
        })
        await page.goto('about:blank')
        await page.goto(`${browser.url}#${start}`)
        await page.removeScriptToEvaluateOnNewDocument(identifier)
        await browser.until(() => /^this browser does not run the page's worker \(.*no WebAssembly.*\); load the page again/.test(document.getElementById('refusal')?.textContent))
        await browser.set('control-n', '9')
        await browser.until(() => document.body.dataset.drawn === document.body.dataset.state && document.body.dataset.drawn?.includes('n=9'))
        check((await browser.text('refusal')).startsWith('this browser does not run'), await browser.text('refusal'))
    }],
    ['over plain http the Connect button says what is in the way', async () => {
        const { identifier } = await page.evaluateOnNewDocument(() => {
            Object.defineProperty(navigator, 'usb', { value: undefined })
            Object.defineProperty(globalThis, 'isSecureContext', { value: false })
        })
        await browser.go(start)
        await page.removeScriptToEvaluateOnNewDocument(identifier)
        await browser.tab('output')
        await page.click('#connect')
        check((await browser.text('device-status')).startsWith('Over plain http a page reaches no USB device. Open it by https, or run "glint page"'), await browser.text('device-status'))
    }],
    ['the Connect button says why a page from a file reaches no device, and where one does', async () => {
        await browser.go(start)
        await browser.tab('output')
        await page.click('#connect')
        equal(await browser.text('device-status'), isFirefox ? 'This browser does not reach USB devices. Open the page in Chrome, Edge or Opera on a computer.'
            : 'Chrome loses a device that is chosen in a page from a file. Run "glint page", open http://localhost:8016/ and connect there.', 'the sentence')
        await shownIsDrawn()
    }],
    ['nothing was written to the console as an error', () => equal(browser.wrong.join('\n'), '', 'errors')],
], () => browser.close())
