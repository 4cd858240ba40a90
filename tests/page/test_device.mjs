// SPDX-License-Identifier: MIT
// test_device.mjs PACKAGES PAGE GLINT: the page, served by `glint page`, in Chromium with a board that is a stand-in: what is sent and
// shown, and what is said when the board goes away, stalls, or has another user.
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { readFileSync } from 'node:fs'
import { check, equal, run, until } from '../pico/tap.mjs'
import { Browser } from './browser.mjs'
import { fakeUsb } from './fake_usb.mjs'
import { Command, difference } from './glint.mjs'
import { png } from './maps.mjs'
import { meshes } from './meshes.mjs'

const [packages, folder, glint] = process.argv.slice(2)
const { Engine, fragmentOf, meshOnDevice, onDevice, readPng, sentences, stateOfFragment, stateOfWords, white, wordsOf, writePng } = await import(`${process.cwd()}/${folder}/engine.mjs`)
const program = new WebAssembly.Module(readFileSync(`${folder}/module.wasm`)), engine = new Engine(program)
const command = new Command(glint)
const width = 60, height = 44
engine.addWhite(white, width, height)
command.put(white, writePng(width, height, Buffer.alloc(4 * width * height, 255), 1))
const server = spawn(glint, ['page', '--port', '0', '--file', `${folder}/index.html`])
process.on('exit', () => server.kill())
const [line] = await once(server.stdout, 'data')
const browser = await Browser.open(packages, 'chromium', `${folder}/index.html`)
browser.url = String(line).match(/http:\S+/)[0]
const { page } = browser
await page.evaluateOnNewDocument(fakeUsb, width, height)

const words = ['--scene=coin', '--size=50x50', '--model=cayley', '-n77', '--format=rgb888', '--dither', '--light=-.5,.5,1']
/** The means of the scenes' albedos, with a material its own, which the module is asked for here as there. */
const means = new Engine(program), colours = {}
function colourOf({ scene, material }) {
    const words = wordsOf({ scene, material, lights: [] })
    if (!colours[words])
        means.draw(words)
    return colours[words] ??= means.facts().colour.join()
}
const board = change => page.evaluate(change => Object.assign(globalThis.board, change), change ?? {})
const connect = async () => {
    await browser.tab('output')
    await page.click('#connect')
}
const press = text => page.evaluate(text => [...document.querySelectorAll('button')].find(button => button.textContent === text).click(), text)
const refuses = async sentence => {
    await browser.until(sentence => !document.getElementById('refusal').hidden && document.getElementById('refusal').textContent.startsWith(sentence), sentence)
        .catch(async () => { throw new Error(`it says ${await browser.text('refusal')}, not ${sentence}`) })
}
const isSaid = () => page.evaluate(() => !document.getElementById('out-board').hidden)
const says = async text => {
    await browser.until(text => document.getElementById('device-status').textContent.includes(text), text)
        .catch(async () => { throw new Error(`it says ${await browser.text('device-status')}, not ${text}`) })
}

/** Until the canvas shows the command's picture of the words that the state has; the words. When a board comes or goes, the state stays
 *  as it is, so that nothing else says when the next picture is drawn. */
async function drawnAs(wordsOfState) {
    let words, wrong
    await until(async () => {
        const now = await browser.now()
        words = wordsOfState(stateOfFragment(now.fragment))
        wrong = difference(now.rgba, now.width, now.height, command.render(words))
        return !wrong
    }, () => `the picture of ${words.join(' ')}: ${wrong}`)
    return words
}
/** Until the board has all of these, of which the last comes last; what it has. */
async function has(map, material, light) {
    let sent
    const isHad = (one, bytes) => bytes !== undefined && Buffer.from(bytes).equals(Buffer.from(one))
    await until(async () => {
        sent = await board()
        return (!map || isHad(map, sent.map)) && isHad(material, sent.material) && isHad(light.subarray(4), sent.lights.at(-1)?.slice(4))
    }, () => `the board has another map, material, light or pose: ${sent.material}; ${sent.lights.at(-1)}`)
    return sent
}

/** The canvas is the command's picture of what the board draws, and the board has what makes that. Returns the words. */
async function follows(gloss = white) {
    const drawn = await drawnAs(state => wordsOf(onDevice(state, width, height, colourOf(state), gloss)))
    check(await isSaid(), 'it is not said whose picture the command line and the files are of')
    engine.draw(drawn)
    const { map, material, light } = engine.device(width, height, { map: '', material: '' })
    check((await has(map, material, light)).lights.every(bytes => bytes.length === 16), 'a light is not 16 bytes')
    return drawn
}
/** The same of the mesh that the board holds, split at so many degrees. */
async function turnsWith(degrees) {
    const drawn = await drawnAs(state => wordsOf(meshOnDevice(state, width, height, degrees)))
    engine.draw(drawn)
    const { material, pose } = engine.device(width, height, { map: '', material: '' })
    const sent = await has(undefined, material, pose)
    check(sent.inMesh && sent.lights.every(bytes => bytes.length === 28), 'a pose is not 28 bytes, or not of the mesh')
    equal(await browser.text('command'), ['glint', 'render', ...drawn, '-o', 'glint.png'].join(' '), 'the command line')
    return drawn
}
const isFree = async () => {
    equal(await browser.text('connect'), 'Connect a Pico', 'the button')
    const own = await drawnAs(wordsOf)
    equal(await browser.text('command'), ['glint', 'render', ...own, '-o', 'glint.png'].join(' '), 'the command line')
    check(await page.evaluate(() => document.getElementById('file-gloss')?.hidden), 'a map of full gloss is offered')
    check(!await isSaid(), 'it is said that the command line is of a board')
}

run([
    ['connected, the picture is what the board draws: its size, RGB565 without dither, from its map', async () => {
        await browser.go(fragmentOf(stateOfWords(words)))
        await isFree()
        await connect()
        await says('16 bytes a frame')
        const drawn = await follows()
        for (const word of ['--size=60x44', '--format=rgb565', '--path=colour-int8', '--model=cayley'])
            check(drawn.includes(word), `${word} is not in ${drawn.join(' ')}`)
        equal((await board()).enabled, 1, 'enabled')
    }],
    ['connected, the command line, saved files and the picture\'s file are of what the board draws', async () => {
        const drawn = await follows(), shown = (await browser.text('command')).split(' ')
        equal(shown.join(' '), ['glint', 'render', ...drawn, '-o', 'glint.png'].join(' '), 'the command line')
        const { [white]: gloss } = await browser.save('file-gloss', 1)
        check(gloss, 'the map by which the surface has full gloss is not saved')
        command.put(white, gloss) // what the user has; the picture is the command's by that file
        await follows()
        const { 'glint.png': file } = await browser.save('file-png', 1), { samples } = command.render(shown.slice(2, -2))
        check(samples.every((value, i) => readPng('glint.png', file).samples[i] === 257 * value), 'the PNG has other pixels')
        for (const [id, count, word] of [['material', 1, '--format=rgb565'], ['colour', 2, '--color=' + colourOf({ scene: 'coin' })], ['int8', 2, '--size=60x44']]) {
            const saved = await browser.save(`file-${id}`, count)
            const line = (await browser.text('file-status')).match(/as (glint .*) writes them/)[1]
            check(line.includes(word) && !line.includes('--dither'), line)
            const expected = command.files(line.split(' ').slice(1))
            check(Object.keys(expected).every(file => saved[file]?.equals(expected[file])), `${line}: other files`)
        }
    }],
    ['connected, what a moving light changes is counted in the board\'s picture, not in the page\'s own', async () => {
        const frame = `of ${(2 * width * height).toLocaleString('en')} bytes`
        await browser.tab('expert')
        await browser.until(frame => document.getElementById('extent').textContent.includes(frame), frame)
    }],
    ['a light that moves is 16 bytes a frame; a material, or another scene, is sent when it changes', async () => {
        const before = (await board()).lights.length
        await page.focus('#handle-1')
        for (let i = 0; i < 8; i++)
            await page.keyboard.press('ArrowRight')
        await follows()
        check((await board()).lights.length > before, 'no lights')
        await page.evaluate(() => { // a rate needs two frames within a second
            let now = performance.now()
            performance.now = () => ++now
        })
        await until(() => page.keyboard.press('ArrowRight').then(() => browser.text('device-status')).then(said => said.includes('frames/s')), () => 'no rate')
        await page.evaluate(() => { delete performance.now })
        await follows()
        await browser.set('control-n', '12')
        check((await follows()).includes('-n12'), 'another material')
        await press('Dial')
        check((await follows()).includes('--scene=dial'), 'another scene')
        await browser.set('control-background', '#30c060')
        check(!(await follows()).some(word => word.startsWith('--background')), 'the board draws over black')
    }],
    ['a named material has its own colour on the board, too', async () => {
        await press('Copper')
        const drawn = await follows()
        check(drawn.includes('--material=copper') && drawn.includes('--color=' + colourOf({ scene: 'dial', material: 'copper' })), drawn.join(' '))
        check(colourOf({ scene: 'dial' }) !== colourOf({ scene: 'dial', material: 'copper' }), 'copper is no other colour')
        await press('Undo')
        await follows()
    }],
    ['colours of the user\'s become their mean on the board, beside a scene, and beside a logo that is scaled to the panel', async () => {
        const colours = png({ width: 50, height: 50, type: 2, depth: 8, sample: (x, y, k) => [200, 2 * x, 30][k] }), logo = png({ width: 20, height: 30, type: 0, depth: 8, sample: (x, y) => x > 4 && y > 9 ? 255 : 0 })
        await browser.go(fragmentOf(stateOfWords(['--scene=coin', '--size=50x50', '--light=-.5,.5,1'])))
        await browser.drop({ 'logo.png': logo })
        await browser.until(() => document.body.dataset.drawn?.includes('logo.png'))
        await browser.drop({ 'albedo.png': colours })
        await browser.until(() => document.body.dataset.drawn?.includes('albedo.png'))
        command.put('logo.png', logo)
        command.put('albedo.png', colours)
        for (const [name, bytes] of [['logo.png', logo], ['albedo.png', colours]])
            engine.addMap(name, readPng(name, bytes))
        await connect()
        const draws = () => drawnAs(state => wordsOf(onDevice(state, width, height, '200,49,30')))
        check((await draws()).includes('--fit=70'), 'the logo is not scaled')
        await press('Coin')
        await browser.drop({ 'albedo.png': colours })
        await browser.until(() => /scene=coin.*albedo.png/.test(document.body.dataset.drawn))
        check((await draws()).includes('--scene=coin'), 'no scene')
        await connect()
        await says('Disconnected')
        await browser.go(fragmentOf(stateOfWords(words)))
        await connect()
        await follows()
    }],
    ['what the board cannot draw is said, and it keeps its picture', async () => {
        const { length } = (await board()).lights
        await page.evaluate(() => document.getElementById('add-light').click())
        await refuses('--path colour-int8')
        equal((await board()).lights.length, length, 'lights')
        await press('Undo')
        await follows()
        await press('Teapot')
        await refuses(sentences.noMesh)
        equal((await board()).inMesh, false, 'the board is told to draw a mesh')
        await press('Undo')
        await follows()
    }],
    ['a file is stopped with the view that a board has of it, and the board goes on with what it had', async () => {
        await follows()
        const { length } = await page.evaluate(() => {
            globalThis.workers.forEach(worker => {
                worker.postMessage = message => {
                    worker.isHeld ||= message.method === 'colour'
                    Worker.prototype.postMessage.call(worker, message)
                }
            })
            return globalThis.workers
        })
        await browser.drop({ 'slow.png': png({ width: 50, height: 50, type: 2, depth: 8, sample: (x, y, k) => 4 * x + y + 9 * k }) })
        await browser.until(() => globalThis.workers.at(-1).isHeld && !document.getElementById('busy').hidden)
        await page.evaluate(() => document.getElementById('stop').click())
        await refuses('slow.png: stopped before it was drawn; drop or choose it again')
        equal(await page.evaluate(() => globalThis.workers.length), length + 1, 'workers')
        await follows()
    }],
    ['a file that is refused with the view that a board has of it is not taken', async () => {
        const before = (await browser.now()).fragment
        await browser.drop({ 'mask.png': png({ width: 7, height: 5, type: 0, depth: 8, sample: () => 255 }) })
        await refuses('mask.png')
        await browser.until(before => document.body.dataset.drawn === before && location.hash.slice(1) === before, before)
        equal(await page.evaluate(() => document.body.dataset.kept === 'mask.png'), false, 'it is kept')
        await follows()
    }],
    ['a board whose first picture is stopped is said to keep its own, and follows what comes then', async () => {
        await connect()
        await says('Disconnected')
        await press('Knob')
        await isFree()
        await page.evaluate(() => {
            const worker = globalThis.workers.at(-1)
            worker.postMessage = message => {
                worker.isHeld ||= message.method === 'colour'
                Worker.prototype.postMessage.call(worker, message)
            }
        })
        await connect()
        await browser.until(() => globalThis.workers.at(-1).isHeld && !document.getElementById('busy').hidden)
        await page.evaluate(() => document.getElementById('stop').click())
        await browser.until(() => document.getElementById('busy').hidden)
        await says('A board is connected. It keeps its picture')
        await press('Dial')
        await says('16 bytes a frame')
        await follows()
    }],
    ['a board that cannot draw the first picture is said to be connected, and to keep its own, when it is connected and when its own was shown', async () => {
        await connect()
        await says('Disconnected')
        await browser.go('scene=coin&size=50x50&point=20,20,20,90')
        await connect()
        await refuses('--path colour-int8: takes only one --light')
        await says('A board is connected. It keeps its picture')
        await page.evaluate(() => document.getElementById('board-own').click())
        await says('shows its own picture')
        await page.evaluate(() => document.getElementById('board-own').click())
        await refuses('--path colour-int8: takes only one --light')
        await says('A board is connected. It keeps its picture')
        equal((await board()).lights.length, 0, 'lights')
        await page.evaluate(fragment => { location.hash = fragment }, fragmentOf(stateOfWords(words)))
        await says('16 bytes a frame')
        await follows()
    }],
    ['disconnected, the panel is given back and the picture is the page\'s own', async () => {
        await connect()
        await says('Disconnected')
        equal((await board()).enabled, 0, 'enabled')
        await isFree()
    }],
    ['an unplugged board is said, and followed again when it is back', async () => {
        await connect()
        await says('16 bytes a frame')
        await page.evaluate(() => globalThis.board.plug(false))
        await says(sentences.unplugged)
        await isFree()
        await board({ lights: [], map: [], material: [] })
        await page.evaluate(() => globalThis.board.plug(true))
        await says('16 bytes a frame')
        await follows()
    }],
    ['a board that is connected again while it is still being sent a light gets its map and material, and keeps its connection', async () => {
        for (const status of ['ok', 'stall']) {
            await board({ waits: [] })
            await page.focus('#handle-1')
            await page.keyboard.press('ArrowUp')
            await browser.until(() => globalThis.board.waits.length)
            const old = await page.evaluateHandle(() => {
                const { waits } = globalThis.board
                globalThis.board.plug(false)
                Object.assign(globalThis.board, { waits: null, lights: [], map: [], material: [] })
                return waits
            })
            await says(sentences.unplugged)
            await page.evaluate(() => globalThis.board.plug(true))
            await browser.until(() => document.getElementById('connect').textContent === 'Disconnect' && !document.getElementById('connect').disabled)
            await old.evaluate((waits, status) => waits[0](status), status)
            await browser.until(() => globalThis.board.lights.length)
            await page.keyboard.press('ArrowDown')
            await follows()
        }
    }],
    ['the light comes from the board\'s accelerometer, and the board\'s from the device\'s tilt; one motion at a time', async () => {
        const note = text => browser.until(text => document.getElementById('motion-note').textContent === text, text)
            .catch(async () => { throw new Error(`it says ${await browser.text('motion-note')}, not ${text}`) })
        const isPressed = (id) => page.evaluate(id => document.getElementById(id).getAttribute('aria-pressed') === 'true', id)
        const lightOf = (drawn) => drawn.find(word => word.startsWith('--light=')).slice(8).split(',').map(Number)
        const take = () => page.click('#board-light')
        // Either asks before it begins, and stops the other one then.
        const only = (id, other) => browser.until(([id, other]) => document.getElementById(id).getAttribute('aria-pressed') === 'true' &&
            document.getElementById(other).getAttribute('aria-pressed') === 'false', [id, other])
        await take()
        await note(sentences.oldFirmware)
        await page.focus('#handle-1')
        await page.keyboard.press('ArrowUp')
        await follows() // it keeps its connection
        await says('16 bytes a frame')
        await board({ room: [0, 0, 0, 0] })
        await connect()
        await says('Disconnected')
        await connect()
        await says('16 bytes a frame')
        for (const [room, sentence] of [[[0, 0, 0, 0], sentences.noSensor], [[1, 0, 0, 0], sentences.silentSensor]]) {
            await board({ room })
            await take()
            await note(sentence)
            check(!await isPressed('board-light'), `pressed after: ${sentence}`)
        }
        await board({ room: [2, -16384, 0, 28378] })
        await take()
        await note('The light stays where it is in the room: tilt the board.')
        const until = x => browser.until(x => Math.abs(Number((document.body.dataset.drawn.match(/light=([^&,]*)/) ?? [])[1]) - x) < .01, x)
        await until(-.5)
        await follows() // the board is sent it
        await board({ room: [2, 0, 30000, 8192] })
        await until(0)
        const [, y] = lightOf(await follows())
        check(Math.abs(y - 30000 / Math.hypot(30000, 8192)) < .01, `${y}`)
        await page.click('#tilt')
        await only('tilt', 'board-light')
        const turn = gamma => page.evaluate(gamma => dispatchEvent(new DeviceOrientationEvent('deviceorientation', { alpha: 0, beta: 0, gamma })), gamma)
        await turn(0)
        await turn(30)
        await until(-.13)
        await follows()
        await take()
        await only('board-light', 'tilt')
        await board({ room: [2, 0, 0, 32768] })
        await until(0)
        await board({ room: [1, 0, 0, 0] }) // in the middle
        await note(sentences.silentSensor)
        await board({ room: [2, 100, 0, 32768] })
        await take()
        await note('The light stays where it is in the room: tilt the board.')
        await page.evaluate(() => globalThis.board.plug(false))
        await says(sentences.unplugged)
        check(await page.evaluate(() => document.getElementById('board-light').hidden), 'a board that is gone is offered')
        await note('')
        await page.evaluate(() => globalThis.board.plug(true))
        await says('16 bytes a frame')
        await follows()
    }],
    ['the board shows its own picture under the page\'s light, which the device\'s tilt moves, and follows again', async () => {
        const last = async () => {
            const bytes = Buffer.from((await board()).given.at(-1)), words = [0, 4, 8, 12].map(at => bytes.readInt32LE(at))
            equal(words.shift(), 0, 'the first number')
            return words.map(word => word / 32768)
        }
        await page.click('#board-own')
        await says('shows its own picture')
        equal((await board()).enabled, 0, 'whether the page has the panel')
        const { lights, map } = await board({ given: [] })
        await page.click('#tilt')
        await browser.until(() => document.getElementById('tilt').getAttribute('aria-pressed') === 'true')
        const turn = (beta, gamma) => page.evaluate(([beta, gamma]) => dispatchEvent(new DeviceOrientationEvent('deviceorientation', { alpha: 0, beta, gamma })), [beta, gamma])
        await turn(0, 0)
        await browser.until(() => globalThis.board.given.length > 3)
        const [x, , z] = await last()
        await turn(0, 20)
        const angle = Math.atan2(x, z) - 20 * Math.PI / 180, length = Math.hypot(x, z)
        await browser.until(([sine]) => {
            const view = new DataView(Uint8Array.from(globalThis.board.given.at(-1)).buffer)
            return Math.abs(view.getInt32(4, true) / 32768 - sine) < .02
        }, [length * Math.sin(angle)]).catch(async () => { throw new Error(`the light is ${await last()}, not ${length * Math.sin(angle)}`) })
        await page.click('#tilt')
        const now = await board()
        equal(now.lights.length, lights.length, 'lights that are sent for the page\'s picture')
        equal(now.map.length, map.length, 'bytes of a map')
        await board({ takesLight: false })
        await says(sentences.noLight)
        await isFree()
        check(await page.evaluate(() => document.getElementById('board-own').hidden), 'its own picture is offered without a board')
        await board({ takesLight: true, lights: [], map: [], material: [] })
        await connect()
        await says('16 bytes a frame')
        await page.click('#board-own')
        await says('shows its own picture')
        await board({ lights: [], map: [], material: [] })
        await page.click('#board-own')
        await says('16 bytes a frame')
        equal((await board()).enabled, 1, 'whether the page has the panel again')
        await follows()
    }],
    ['a board that is slow keeps its connection as it shows its own picture and follows, whatever the light is', async () => {
        await board({ delay: 20 })
        const own = () => page.evaluate(() => document.getElementById('board-own').click()) // the mouse may miss it: what is said of a light moves it
        for (let i = 0; i < 8; i++) {
            await own()
            await says('shows its own picture')
            for (const text of i ? [] : ['0,0,0', '0,0,-1', '-1,1,1.2']) {
                const rounds = await page.evaluate(text => {
                    const field = document.querySelector('#lights input[type=text]')
                    field.value = text
                    field.dispatchEvent(new Event('change', { bubbles: true }))
                    return globalThis.board.rounds
                }, text)
                await browser.until(rounds => globalThis.board.rounds > rounds, rounds) // one more may give the light of before
                const { rounds: since } = await board({ given: [] })
                await browser.until(rounds => globalThis.board.rounds > rounds + 4, since)
                equal((await board()).given.length > 0, text === '-1,1,1.2', `whether the light ${text} is sent`)
            }
            await own()
            await says('16 bytes a frame')
        }
        await board({ delay: 0 })
        await follows()
    }],
    ['a board that is plugged in again shows its own picture while an earlier connection still waits', async () => {
        for (const first of ['to show it', 'with a light']) {
            if (first === 'with a light') {
                await page.click('#board-own')
                await says('shows its own picture')
            }
            await board({ held: [] })
            if (first === 'to show it')
                await page.click('#board-own')
            await browser.until(() => globalThis.board.held.length)
            const old = await page.evaluateHandle(() => {
                const { held } = globalThis.board
                globalThis.board.plug(false)
                Object.assign(globalThis.board, { held: null, lights: [], map: [], material: [] })
                globalThis.board.plug(true)
                return held
            })
            await says('16 bytes a frame')
            await follows()
            await page.click('#board-own')
            await says('shows its own picture')
            await old.evaluate(async held => {
                held.forEach(fail => fail())
                await new Promise(resolve => setTimeout(resolve, 400)) // until the page has asked whether that board is still there
                globalThis.board.given = []
            })
            await browser.until(() => globalThis.board.given.length > 2)
            await page.click('#board-own')
            await says('16 bytes a frame')
            await follows()
        }
    }],
    ['a board that comes back while one is chosen is opened once', async () => {
        await page.evaluate(() => {
            globalThis.board.plug(false)
            globalThis.board.opens = 0
            globalThis.board.choosing = new Promise(resolve => { globalThis.chosen = resolve })
        })
        await says(sentences.unplugged)
        await connect()
        await page.evaluate(() => {
            globalThis.board.plug(true)
            globalThis.chosen()
        })
        await says('16 bytes a frame')
        await follows()
        await board({ choosing: null })
        equal((await board()).opens, 1, 'how often it was opened')
    }],
    ['a stalled transfer is said, and connecting again goes on', async () => {
        await board({ stalls: true })
        await page.focus('#handle-1')
        await page.keyboard.press('ArrowUp')
        await says(sentences.stalled)
        await isFree()
        await connect()
        await says('16 bytes a frame')
        await follows()
        await connect()
        await says('Disconnected')
    }],
    ['a board that another program has, that is busy, or that nobody chooses is said', async () => {
        for (const [fault, sentence] of [['isHeld', sentences.held], ['isBusy', sentences.busy]]) {
            await board({ [fault]: true })
            await connect()
            await says(sentence)
            await board({ [fault]: false })
            await isFree()
        }
        await board({ isChosen: false })
        await connect()
        await says(sentences.notChosen)
    }],
    ['a board that holds the teapot turns it by 28 bytes a frame, and says that it takes no maps', async () => {
        await board({ isChosen: true, mesh: [...command.teapotHeld()], takesMaps: false, lights: [], map: [], material: [] })
        await connect()
        await refuses(sentences.onlyMesh)
        equal((await board()).lights.length, 0, 'lights')
        await press('Teapot')
        await says('28 bytes a frame')
        check((await turnsWith(180)).includes('--split=180'), 'no --split')
        await browser.until(() => !document.getElementById('turn').hidden)
        await page.click('#turn')
        await page.focus('#handle-1')
        for (let i = 0; i < 4; i++)
            await page.keyboard.press('ArrowRight')
        check((await turnsWith(180)).some(word => word.startsWith('--turn=')), 'it does not turn')
        await browser.set('control-perspective', '3')
        check(!(await turnsWith(180)).some(word => word.startsWith('--perspective')), 'the board draws no perspective')
        await browser.set('control-background', '#30c060')
        check((await turnsWith(180)).includes('--no-outlines'), 'the board draws stepped outlines')
        await browser.set('control-n', '9')
        await turnsWith(180)
        await press('Coin')
        await refuses(sentences.onlyMesh)
        await press('Undo')
        await turnsWith(180)
        await connect()
        await says('Disconnected')
        await isFree()
    }],
    ['a board that takes maps and holds a mesh draws both, and one that holds another mesh is told apart', async () => {
        await board({ takesMaps: true, lights: [] })
        await connect()
        await says('28 bytes a frame')
        await turnsWith(180)
        await board({ lights: [] })
        await press('Coin')
        await follows()
        await connect()
        await says('Disconnected')
        const [, ...rest] = (await board()).mesh
        await board({ mesh: [rest[0] ^ 255, ...rest] })
        await connect()
        await follows()
        await press('Teapot')
        await refuses(sentences.otherMesh)
        await connect()
        await says('Disconnected')
        const name = 'ring.stl', { 'mesh.bin': raw } = (command.put(name, meshes[name]), command.files(['bake', `--mesh=${name}`, '--split=90', '--to=int8', '-o', 'mesh.bin']))
        await board({ mesh: [...command.held(raw, 90)], lights: [] })
        await connect()
        await refuses(sentences.otherMesh)
        engine.addMesh(name, meshes[name])
        await browser.drop({ [name]: meshes[name] })
        await says('28 bytes a frame')
        check((await turnsWith(90)).includes(`--mesh=${name}`), 'another mesh')
        await browser.drop({ [name]: meshes['coloured.stl'] }) // a newer file of that name
        await refuses(sentences.otherMesh)
        await connect()
        await says('Disconnected')
        await board({ mesh: null, lights: [] })
        await press('Coin')
        await isFree()
    }],
    ['a map of the user\'s that is called as the map of full gloss is stays the user\'s', async () => {
        const own = png({ width: 50, height: 50, type: 0, depth: 8, sample: (x, y) => 4 * x + y }), other = 'full-gloss-2.png'
        command.put(other, writePng(width, height, Buffer.alloc(4 * width * height, 255), 1))
        engine.addWhite(other, width, height)
        const drop = async () => {
            command.put(white, own)
            await browser.drop({ [white]: own })
            await browser.until(name => document.body.dataset.drawn?.includes(name), white)
        }
        await drop()
        await isFree()
        await connect()
        check((await follows(other)).includes(`--gloss=${other}`), 'another name')
        equal(Object.keys(await browser.save('file-gloss', 1)).join(), other, 'what is saved')
        await connect()
        await says('Disconnected')
        await isFree()
        await browser.go(fragmentOf(stateOfWords(words))) // and dropped while connected
        command.put(white, writePng(width, height, Buffer.alloc(4 * width * height, 255), 1))
        await connect()
        await follows()
        await drop()
        check((await follows(other)).includes(`--gloss=${other}`), 'another name')
        await connect()
        await says('Disconnected')
        await isFree()
    }],
    ['a refused file that has the name of the page\'s map of full gloss leaves that map as it was', async () => {
        command.put(white, writePng(width, height, Buffer.alloc(4 * width * height, 255), 1))
        await browser.go(fragmentOf(stateOfWords(words)))
        await connect()
        await follows()
        await connect()
        await says('Disconnected')
        await browser.drop({ [white]: png({ width: 7, height: 5, type: 0, depth: 8, sample: () => 9 }) })
        await refuses(white)
        await connect()
        await follows()
        await connect()
        await says('Disconnected')
    }],
    ['an address that is refused sends nothing, before and after connecting, and what follows is drawn', async () => {
        const wrong = 'scene=coins&n=5000'
        await browser.go(wrong)
        await refuses('--scene: unknown scene \'coins\'')
        await connect()
        await browser.until(() => document.getElementById('connect').textContent === 'Disconnect' && !document.getElementById('connect').disabled)
        await refuses('--scene: unknown scene \'coins\'')
        equal((await board()).lights.length, 0, 'lights')
        await press('Reset')
        command.put(white, writePng(width, height, Buffer.alloc(4 * width * height, 255), 1))
        await follows()
        const { length } = (await board()).lights
        await page.evaluate(() => { location.hash = 'scene=coins&n=4000' })
        await refuses('--scene: unknown scene \'coins\'')
        equal((await board()).lights.length, length, 'lights after a wrong address')
        await press('Undo')
        await follows()
    }],
    ['nothing was written to the console as an error', () => equal(browser.wrong.join('\n'), '', 'errors')],
], () => { server.kill(); return browser.close() })
