// SPDX-License-Identifier: MIT
// test_browser.mjs PACKAGES PAGE GLINT BROWSER STATES: the page in a browser, from a file, against the command.
import { readFileSync } from 'node:fs'
import { inflateSync } from 'node:zlib'
import { check, equal, run } from '../pico/tap.mjs'
import { Browser } from './browser.mjs'
import { Command, difference } from './glint.mjs'
import { extras, surfaces } from './maps.mjs'
import { paths, randomly, randomWords } from './states.mjs'

const [packages, folder, glint, name, count] = process.argv.slice(2)
const { commandLine, fragmentOf, stateOfFragment, stateOfWords, readPng, wordsOf } = await import(`${process.cwd()}/${folder}/engine.mjs`)
const command = new Command(glint)
for (const [file, bytes] of [...Object.entries(surfaces).map(([file, { bytes }]) => [file, bytes]), ...Object.entries(extras)])
    command.put(file, bytes)
const browser = await Browser.open(packages, name, `${folder}/index.html`)
const { page } = browser
const isFirefox = name === 'firefox'

const fragment = words => fragmentOf(stateOfWords(words))

/** Draws all, and compares each with the command's picture or refusal. Returns how many were pictures. */
async function same(list, unseen = false) {
    let pictures = 0
    for (let from = 0; from < list.length; from += 25) {
        const part = list.slice(from, from + 25)
        const [drawn, expected] = await Promise.all([browser.draw(part.map(fragment), unseen), Promise.all(part.map(words =>
            command.renderLater(words).catch(() => ({ refusal: command.refusal(['render', ...words, '-o', 'no.png']) }))))])
        part.forEach((words, i) => {
            equal(drawn[i].refusal, expected[i].refusal ?? '', words.join(' '))
            if (expected[i].refusal)
                return
            pictures++
            const wrong = difference(drawn[i].rgba, drawn[i].width, drawn[i].height, expected[i])
            check(!wrong, `${words.join(' ')}: ${wrong}`)
        })
    }
    return pictures
}

/** The state that the page has now is what its canvas shows. */
async function shownIsDrawn() {
    const now = await browser.now()
    const words = wordsOf(stateOfFragment(now.fragment))
    const wrong = difference(now.rgba, now.width, now.height, command.render(words))
    check(!wrong, `${words.join(' ')}: ${wrong}`)
    return words
}

const start = 'scene=coin&size=64x48&format=rgb565&light=-1,1,1.2'

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
    ['the page opens from a file and shows a picture, the lobe, errors and costs', async () => {
        await browser.go()
        await shownIsDrawn()
        await browser.until(() => document.body.dataset.rested !== undefined && document.querySelectorAll('#extent dt').length === 5)
        equal(await page.evaluate(() => document.querySelectorAll('#curve polyline').length), 3, 'curves')
        check((await browser.text('errors')).includes('msh in double'), 'no errors')
        const costs = await browser.text('costs')
        check(/exact albedo, n = 60.*M0\+, cycles a covered pixel[\d,]+ \(assembly [\d,]+\)/.test(costs) && /M3[\d,]+ instructions/.test(costs) && !/\D0 bytes|\D0,/.test(costs), costs)
    }],
    ['every model, format, space and path gives the command\'s pixels on the canvas', async () => {
        await browser.go(start)
        const list = []
        for (const model of ['msh', 'schlick', 'blinn', 'phong', 'gauss', 'cayley', 'lyon'])
            for (const format of ['rgb565', 'rgb565-swapped', 'rgb888', 'grey8', 'mono'])
                list.push(['--scene=dial', '--size=48x40', `--model=${model}`, `--format=${format}`, ...list.length % 2 ? ['--space=linear'] : [], ...list.length % 3 ? ['--dither'] : []])
        for (const path of paths)
            list.push(['--scene=sphere', '--size=48x40', '--format=rgb565', '--ambient=.1', '--diffuse=.8', `--path=${path}`])
        equal(await same(list), 35 + 16, 'pictures')
    }],
    ['dropped maps of every kind of PNG give the command\'s pixels', async () => {
        const some = Object.entries(surfaces).filter((_, i) => !isFirefox || i % 3 === 0)
        await browser.go(start)
        for (const [file, { bytes, words }] of some) {
            await browser.draw([start])
            await browser.drop({ [words[0] === '--normals' ? `normals ${file}` : file]: bytes })
            const dropped = words[0] === '--normals' ? `normals ${file}` : file
            command.put(dropped, bytes)
            await browser.until(file => document.body.dataset.drawn?.includes(encodeURIComponent(file)), dropped)
            await same([[`${words[0]}=${dropped}`, ...words.slice(1), '--format=rgb565'], [`${words[0]}=${dropped}`, ...words.slice(1), '-n9', '--light=1,0,1']])
        }
    }],
    ['maps that go with a surface can be dropped together and chosen one by one', async () => {
        await browser.go(start)
        await browser.drop({ 'albedo.png': extras['albedo.png'], 'grey16.png': surfaces['grey16.png'].bytes, 'gloss.png': extras['gloss.png'] })
        await browser.until(() => document.body.dataset.drawn?.includes('gloss.png'))
        const words = await shownIsDrawn()
        check(['--height=grey16.png', '--albedo=albedo.png', '--gloss=gloss.png'].every(word => words.includes(word)), words.join(' '))
        const input = await page.$('#map-mask')
        await input.uploadFile(`${command.folder}/mask.png`)
        await browser.until(() => document.body.dataset.drawn?.includes('mask.png'))
        await shownIsDrawn()
        await browser.set('map-scale', '30')
        check((await shownIsDrawn()).includes('--scale=30'), 'no --scale')
    }],
    ['a wrong file gives a sentence, and the picture stays', async () => {
        await browser.go(start)
        for (const [file, bytes, sentence] of [['photo.jpg', Buffer.from('\xff\xd8\xff\xe0', 'latin1'), 'photo.jpg: this is a JPEG, not a PNG; convert it to PNG'],
            ['cut.png', surfaces['rgb8.png'].bytes.subarray(0, 300), /^cut\.png: damaged PNG: .*; save it again$/]]) {
            await browser.drop({ [file]: bytes })
            await browser.until(file => !document.getElementById('refusal').hidden && document.getElementById('refusal').textContent.startsWith(file), file)
            const said = await browser.text('refusal')
            check(sentence.test ? sentence.test(said) : said === sentence, said)
        }
        await shownIsDrawn()
    }],
    ['every control sets its option, changes the picture and the command line', async () => {
        await browser.go(start)
        for (const [id, value, word] of [['control-model', 'gauss', '--model=gauss'], ['control-n', '300', '-n300'], ['control-q', '2', '-q2'],
            ['control-color', '#3060c0', '--color=48,96,192'], ['control-ambient', '0.5', '--ambient=0.5'], ['control-diffuse', '0.3', '--diffuse=0.3'],
            ['control-specular', '0.1', '--specular=0.1,0.091,0.067'], ['control-format', 'rgb888', ''], ['control-format', 'mono', '--format=mono'],
            ['control-dither', true, '--dither'], ['control-space', 'linear', '--space=linear'], ['control-path', 'span', '--path=span'],
            ['control-size', '61x47', '--size=61x47'], ['control-view', '.2,.1,1', '--view=.2,.1,1']])
            await (word ? sets(id, value, word) : Promise.resolve())
        await browser.go(start.replace('coin', 'sphere'))
        await browser.set('control-clamp-peak', true)
        check((await shownIsDrawn()).includes('--clamp-peak'), 'no --clamp-peak')
    }],
    ['presets, scenes, lights, undo and redo do what they say', async () => {
        await browser.go(start)
        const press = text => page.evaluate(text => [...document.querySelectorAll('button')].find(button => button.textContent === text).click(), text)
        const words = []
        for (const text of ['Dial', 'Gold', 'Steel', 'Add a light']) {
            await press(text)
            words.push((await shownIsDrawn()).join(' '))
        }
        check(words[0].includes('--scene=dial') && words[1].includes('--specular=1,.86,.55') && words[2].includes('--model=cayley') && words[3].includes('--point='), words.join('\n'))
        await press('Undo')
        equal((await shownIsDrawn()).join(' '), words[2], 'undone')
        await press('Undo')
        equal((await shownIsDrawn()).join(' '), words[1], 'undone twice')
        await press('Redo')
        equal((await shownIsDrawn()).join(' '), words[2], 'done again')
        await press('Reset')
        const materials = []
        for (const text of ['Satin', 'Plastic', 'Steel', 'Gold', 'Glass']) {
            await press(text)
            materials.push((await shownIsDrawn()).join(' '))
        }
        equal(new Set(materials).size, 5, 'materials')
        await press('Reset')
        equal((await shownIsDrawn()).join(' '), '--scene=coin --size=240x240 --format=rgb565 --light=-1,1,1.2', 'reset')
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
        await page.focus('#handle')
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
        await page.focus('#handle')
        await page.keyboard.press('ArrowUp')
        equal((await turn())[0], Math.round(10 * (x + 5)) / 10, 'x after an arrow key for the light')
        await browser.set('control-zoom', '1.4')
        check((await shownIsDrawn()).includes('--zoom=1.4'), 'no --zoom')
        await browser.until(() => document.querySelectorAll('#extent dt').length === 5)
        check((await browser.text('errors')).includes('msh in double'), 'no errors')
        const saved = await browser.save('file-mesh', 2), expected = command.files(['bake', '--scene=teapot', '-o', 'mesh.c'])
        check(Object.keys(expected).every(file => saved[file]?.equals(expected[file])), 'the saved mesh is not the command\'s')
        check(await page.evaluate(() => document.getElementById('file-int8').hidden && !document.getElementById('file-material').hidden), 'files of a map are offered')
    }],
    ['the address restores the state, with controls that show it', async () => {
        const words = ['--scene=watchface', '--size=50x40', '--model=cayley', '-n77', '-q9', '--ambient=.3', '--format=rgb565', '--dither', '--light=.5,.5,1', '--point=10,20,30,90,1,.5,.25']
        await browser.go(fragment(words))
        equal((await shownIsDrawn()).join(' '), wordsOf(stateOfWords(words)).join(' '), 'the state')
        const shown = await page.evaluate(() => ['model', 'n', 'q', 'ambient', 'format', 'size'].map(option => document.getElementById(`control-${option}`).value).join(' ') + ' ' + document.getElementById('control-dither').checked)
        equal(shown, 'cayley 77 9 0.3 rgb565 50x40 true', 'the controls')
        await page.evaluate(fragment => { location.hash = fragment }, start)
        equal((await shownIsDrawn()).join(' '), wordsOf(stateOfFragment(start)).join(' '), 'the state of another address')
        await browser.go('scene=coins&n=5000')
        check((await browser.text('refusal')).startsWith('--scene: unknown scene \'coins\''), await browser.text('refusal'))
    }],
    ['the Connect button says why a page from a file reaches no device, and where one does', async () => {
        await browser.go(start)
        await page.click('#connect')
        equal(await browser.text('device-status'), isFirefox ? 'This browser does not reach USB devices. Open the page in Chrome, Edge or Opera on a computer.'
            : 'Chrome loses a device that is chosen in a page from a file. Run "glint page", open http://localhost:8016/ and connect there.', 'the sentence')
        await shownIsDrawn()
    }],
    ['saved files are the command\'s, and the PNG has its pixels', async () => {
        const words = ['--scene=dial', '--size=60x60', '--format=rgb565', '-n50', '--ambient=.2', '--diffuse=.7', '--light=-1,1,1.2']
        await browser.go(fragment(words))
        await shownIsDrawn()
        for (const [id, count] of [['material', 1], ['colour', 2], ['small', 2], ['albedo', 2], ['int8', 2], ['int10', 2], ['int16', 2], ['palette', 2], ['raw', 1], ['uf2', 1]]) {
            const saved = await browser.save(`file-${id}`, count)
            const line = (await browser.text('file-status')).match(/as (glint .*) writes them/)[1]
            const expected = command.files(line.split(' ').slice(1))
            equal(Object.keys(saved).sort().join(), Object.keys(expected).sort().join(), line)
            for (const file of Object.keys(saved))
                check(saved[file].equals(expected[file]), `${line}: ${file} differs`)
        }
        const { 'glint.png': file } = await browser.save('file-png', 1)
        const png = readPng('glint.png', file), { samples } = command.render(words)
        check(samples.every((value, i) => png.samples[i] === 257 * value), 'the PNG has other pixels')
    }],
    [`${count} random states give the command's pictures or refusals`, async () => {
        const random = randomly(isFirefox ? 2 : 1)
        await browser.go(start)
        const pictures = await same(Array.from({ length: Number(count) }, () => randomWords(random)), true)
        check(pictures > count / 2, `only ${pictures} pictures`)
    }],
    ['it fits phones, laptops and 4K screens, light and dark, and axe finds nothing serious', async () => {
        const axe = readFileSync(`${packages}/node_modules/axe-core/axe.min.js`, 'utf8')
        for (const [screen, width, height, dark] of [['phone', 360, 740, true], ['laptop', 1366, 768, false], ['4k', 3840, 2160, true]]) {
            await browser.resize(width, height)
            if (!isFirefox)
                await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }])
            await browser.go()
            await browser.until(() => document.body.dataset.rested !== undefined && document.querySelectorAll('#extent dt').length === 5 &&
                [...document.querySelectorAll('#beside figcaption')].every(caption => caption.textContent))
            const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)
            check(wide <= 0, `${screen}: ${wide} pixels too wide`)
            await page.screenshot({ path: `${folder}/${name}-${screen}.png`, fullPage: true })
            await page.addScriptTag({ content: axe }) // no eval, which the page's policy refuses
            const found = await page.evaluate(async () => (await axe.run()).violations.filter(({ impact }) => impact === 'serious' || impact === 'critical').map(({ id, nodes }) => `${id}: ${nodes[0].html}`))
            equal(found.join('\n'), '', `${screen}: axe`)
        }
    }],
    ['nothing was written to the console as an error', () => equal(browser.wrong.join('\n'), '', 'errors')],
], () => browser.close())
