// SPDX-License-Identifier: MIT
// test_files.mjs PACKAGES PAGE GLINT BROWSER: maps, logos and meshes of the user's own in the page: dropped, set, kept,
// missing, refused.
import { readFile } from 'node:fs/promises'
import { check, equal, run, until } from '../pico/tap.mjs'
import { asked, browser, command, fragment, page, press, shownIsDrawn, start, stateOfFragment, stateOfWords, wordsOf } from './beside.mjs'
import { difference } from './glint.mjs'
import { extras, png, surfaces } from './maps.mjs'
import { ball, clothed, gltf, meshes } from './meshes.mjs'

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
        check(await page.evaluate(() => document.getElementById('control-fit').checkVisibility()), 'a logo has no size')
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
    ['a dropped STL is drawn, turned, set and baked as the command does', async () => {
        const name = 'ring.stl', bytes = meshes[name]
        command.put(name, bytes)
        await browser.go(start)
        await browser.drop({ [name]: bytes })
        await browser.until(name => document.body.dataset.drawn?.includes(name), name)
        equal((await shownIsDrawn()).join(' '), '--mesh=ring.stl --size=64x48 --turn=25,-35,0 --format=rgb565 --light=-1,1,1.2', 'the state')
        await page.click('#turn')
        await page.focus('#handle-1')
        await page.keyboard.press('ArrowDown')
        for (const [id, value, word] of [['control-split', '7', '--split=7'], ['control-axes', 'y-up', '--axes=y-up'], ['control-crease', '10', '--crease=10']]) {
            const { rgba } = await browser.now()
            await browser.set(id, value)
            const words = await shownIsDrawn()
            check(words.includes(word) && words.includes('--turn=30,-35,0'), words.join(' '))
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
    ['an OBJ wears the materials and the picture that are dropped with it; materials alone are refused with a word', async () => {
        const texts = clothed(png({ width: 8, height: 8, type: 2, depth: 8, sample: (x, y, k) => 20 * (x ^ y) + 30 * k }))
        const files = Object.fromEntries(Object.entries(texts).map(([name, bytes]) => [name, Buffer.from(bytes)]))
        for (const name in files)
            command.put(name, name === 'clothed.obj' ? Buffer.from(texts[name].replace('things/', '')) : files[name])
        await browser.go(start)
        await browser.drop(files)
        await browser.until(() => document.body.dataset.drawn?.includes('clothed.obj'))
        check((await shownIsDrawn()).includes('--mesh=clothed.obj'), 'the state')
        equal(await browser.text('warnings'), '', 'warnings')
        const state = (await shownIsDrawn()).join(' ')
        await browser.drop({ 'clothed.mtl': files['clothed.mtl'] })
        await browser.until(() => document.getElementById('refusal').textContent.startsWith('clothed.mtl: these are materials'))
        equal((await shownIsDrawn()).join(' '), state, 'the state after it')
        await page.evaluate(() => { // as that of a folder does
            const { arrayBuffer } = Blob.prototype
            Blob.prototype.arrayBuffer = function () { return this.name === 'folder.mtl' ? Promise.reject(new Error('no file')) : arrayBuffer.call(this) }
        })
        await browser.drop({ ...files, 'folder.mtl': '' })
        await browser.until(() => document.getElementById('refusal').textContent === 'folder.mtl: cannot be read (no file); is it a folder?')
        equal((await shownIsDrawn()).join(' '), state, 'the state after a folder')
    }],
    ['two files for one row in one drop are refused with a word, and nothing of the drop is taken', async () => {
        const triangle = Buffer.from('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'), grey = surfaces['grey8.png'].bytes
        await browser.go(start)
        const state = (await shownIsDrawn()).join(' ')
        for (const [files, row] of [[{ 'a.obj': triangle, 'b.obj': triangle }, 'Mesh'], [{ 'a.png': grey, 'b.png': grey, 'normals.png': grey }, 'Height or logo']]) {
            const names = Object.keys(files).slice(0, 2).join(', ')
            await browser.drop(files)
            await browser.until(text => document.getElementById('refusal').textContent === text, `${names}: each of these would be "${row}"; drop one of them, or choose each in its row`)
            equal((await shownIsDrawn()).join(' '), state, `the state after ${names}`)
        }
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
            ['texture of gamma 1.png', png({ width: 4, height: 4, type: 0, depth: 8, sample: () => 99, extra: [['gAMA', [0, 1, 0x86, 0xa0]]] }), /a gamma or colour profile of its own/],
            ['texture of gamma 1 behind a comment.png', png({ width: 4, height: 4, type: 0, depth: 8, sample: () => 99, extra: [['tEXt', Array(9000).fill(65, 1).fill(0, 20, 21)], ['gAMA', [0, 1, 0x86, 0xa0]]] }), /a gamma or colour profile of its own/]]) {
            await browser.drop({ [name]: bytes })
            await browser.until(name => document.getElementById('refusal').textContent.startsWith(name), name)
            check(sentence.test(await browser.text('refusal')), await browser.text('refusal'))
            equal((await shownIsDrawn()).join(' '), words.join(' '), `the state after ${name}`)
        }
        await press('Coin')
        check(!(await shownIsDrawn()).some(word => /texture|nearest/.test(word)), 'the texture stays')
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
            await until(async () => !(await browser.now()).rgba.equals(rgba), () => 'it is not drawn')
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
    ['a logo of any size becomes a bevelled shape in the middle of the panel at once, made of what was there', async () => {
        const start = scene => `scene=${scene}&size=64x64&panel=round&light=-1,1,1.2`
        for (const [i, side] of [40, 9, 300].entries()) {
            const disc = (x, y) => (x / side - .45) ** 2 + (y / side - .6) ** 2 < .1, of = { width: side, height: side, depth: 8 }
            for (const [name, bytes] of [[`cut ${i}.png`, png({ ...of, type: 6, sample: (x, y, k) => k === 3 && disc(x, y) ? 255 : 0 })], [`black ${i}.png`, png({ ...of, type: 0, sample: (x, y) => disc(x, y) ? 0 : 255 })]]) {
                command.put(name, bytes)
                await browser.go(start('knob'))
                await browser.drop({ [name]: bytes })
                await browser.until(name => document.body.dataset.kept === name, name)
                equal((await shownIsDrawn()).join(' '), `--height=${name} --bevel=6 --fit=70 --grain=spun --size=64x64 --material=brushed-steel --light=-1,1,1.2`, name)
                equal(await page.evaluate(() => document.querySelectorAll('#warnings li').length), 0, `warnings of ${name}`)
            }
        }
        const { rgba } = await browser.now()
        await browser.set('control-fit', '30')
        const words = await shownIsDrawn()
        check(words.includes('--fit=30') && !(await browser.now()).rgba.equals(rgba), words.join(' '))
        const saved = await browser.save('file-int8', 2), expected = command.files(['bake', ...words.filter(word => /^--(height|bevel|fit|size)/.test(word)), '--to=int8', '-o', 'normals.c'])
        check(Object.keys(expected).every(file => saved[file]?.equals(expected[file])), 'the saved normals are not the command\'s')
        await browser.set('control-bevel', '') // without which the command refuses to fit
        check(!(await shownIsDrawn()).some(word => word.startsWith('--fit')), 'no longer a logo, and fitted')
        await browser.drop({ 'cut 0.png': (await readFile(`${command.folder}/cut 0.png`)) })
        await browser.until(() => document.body.dataset.kept === 'cut 0.png')
        await browser.set('control-size', '')
        check(!(await shownIsDrawn()).some(word => word.startsWith('--fit')), 'fitted to no size')
    }],
    ['a height map is no logo, and a logo keeps the material that was chosen', async () => {
        const hills = png({ width: 40, height: 40, depth: 8, type: 0, sample: x => 6 * x }), disc = png({ width: 40, height: 40, depth: 8, type: 0, sample: (x, y) => Math.hypot(x - 20, y - 20) < 12 ? 255 : 0 })
        command.put('hills.png', hills)
        command.put('disc.png', disc)
        await browser.go('scene=coin&size=64x64&material=jade&light=-1,1,1.2')
        await browser.drop({ 'disc.png': disc })
        await browser.until(() => document.body.dataset.kept === 'disc.png')
        equal((await shownIsDrawn()).join(' '), '--height=disc.png --bevel=6 --fit=70 --size=64x64 --material=jade --light=-1,1,1.2', 'a logo')
        await browser.drop({ 'hills.png': hills })
        await browser.until(() => document.body.dataset.kept === 'hills.png')
        equal((await shownIsDrawn()).join(' '), '--height=hills.png --material=jade --light=-1,1,1.2', 'a height map')
        await browser.set('control-panel', 'round')
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
    ['a file that an option beside it refuses is named', async () => {
        await browser.go('scene=teapot&size=40x40')
        await browser.drop({ 'gloss.png': extras['gloss.png'] })
        await browser.until(() => /^gloss\.png: --gloss/.test(document.getElementById('refusal').textContent))
    }],
    ['what is refused of a drop is said when the rest is taken; of two drops at once the second counts', async () => {
        const tooSmall = png({ width: 9, height: 9, type: 0, depth: 8, sample: () => 200 })
        await browser.go(start)
        command.put('hills.png', surfaces['grey8.png'].bytes)
        await browser.drop({ 'hills.png': surfaces['grey8.png'].bytes })
        await browser.until(() => document.body.dataset.kept === 'hills.png')
        const { width, height } = await browser.now(), fits = png({ width, height, type: 0, depth: 8, sample: x => 9 * x & 255 })
        command.put('mask.png', fits)
        await browser.drop({ 'gloss.png': tooSmall, 'mask.png': fits })
        await browser.until(() => document.body.dataset.kept === 'mask.png')
        await browser.until(() => document.getElementById('refusal').textContent.startsWith('gloss.png: 9x9 pixels, but'))
        check((await shownIsDrawn()).join(' ').startsWith('--height=hills.png --mask=mask.png'), await browser.text('command'))
        command.put('gloss.png', fits)
        await Promise.all([browser.drop({ 'mask.png': tooSmall }), browser.drop({ 'gloss.png': fits })])
        await browser.until(() => document.body.dataset.kept === 'gloss.png')
        const words = (await shownIsDrawn()).join(' ')
        check(/^--height=hills\.png --mask=mask\.png --gloss=gloss\.png/.test(words), words)
    }],
    ['a drop is taken while the light moves; one that is refused leaves a mesh, its pose and its steps to undo as they were', async () => {
        const hills = surfaces['grey8.png'].bytes, name = 'ring.stl'
        command.put(name, meshes[name])
        command.put('moving.png', hills)
        await browser.go(start)
        await page.click('#orbit')
        await browser.drop({ 'moving.png': hills })
        await browser.until(() => document.body.dataset.kept === 'moving.png')
        await page.click('#orbit')
        check((await shownIsDrawn()).includes('--height=moving.png'), 'a height map')
        await browser.drop({ [name]: meshes[name] })
        await browser.until(name => document.body.dataset.kept === name, name)
        await shownIsDrawn()
        await page.click('#orbit')
        await page.click('#turn')
        for (const [i, bytes] of [Buffer.from('no'), extras['albedo.png']].entries()) { // before it is tried, and by the worker
            const bad = `gloss ${i}.png`
            await page.evaluate(() => { // the mesh is turned while the file is read
                const { arrayBuffer } = Blob.prototype
                Blob.prototype.arrayBuffer = async function () {
                    Blob.prototype.arrayBuffer = arrayBuffer
                    document.getElementById('handle-1').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true }))
                    await new Promise(requestAnimationFrame)
                    await new Promise(requestAnimationFrame)
                    return arrayBuffer.call(this)
                }
            })
            await browser.drop({ [bad]: bytes })
            await browser.until(said => document.getElementById('refusal').textContent.startsWith(said), i ? `${bad}: --gloss` : bad)
            await browser.until(i => document.body.dataset.state.includes(`turn=25,${5 * i - 30},0`), i)
        }
        await page.click('#orbit')
        await shownIsDrawn()
        for (let i = 0; i < 8; i++) {
            await press('Undo')
            const words = (await shownIsDrawn()).join(' ')
            check(!words.includes('gloss'), `undone: ${words}`)
        }
    }],
    ['of many files the oldest are forgotten, also where the browser keeps none, and those in use stay', async () => {
        const { identifier } = await page.evaluateOnNewDocument(() => {
            Object.defineProperty(globalThis, 'indexedDB', { get() { throw new DOMException('no storage', 'SecurityError') } })
        })
        await browser.go(start)
        const drop = async (name, bytes) => {
            command.put(name, bytes)
            await browser.drop({ [name]: bytes })
            await browser.until(name => document.body.dataset.kept === name, name)
        }
        await drop('old.png', surfaces['grey8.png'].bytes)
        const { width, height } = await browser.now()
        for (let i = 0; i < 33; i++)
            await drop(`gloss ${i}.png`, png({ width, height, type: 0, depth: 8, sample: x => 9 * x & 255 }))
        check((await shownIsDrawn()).includes('--height=old.png'), 'the height map that is in use')
        const said = []
        for (const i of [0, 32])
            said.push((await browser.draw([`height=old.png&gloss=gloss%20${i}.png`]))[0].refusal)
        equal(said.join('; '), 'gloss 0.png: this map is not here; drop or choose the file; ', 'what it says')
        await shownIsDrawn()
        const told = await page.evaluate(async () => { // by both engines of the worker
            const worker = globalThis.workers.at(-1), told = []
            for (const [id, method] of [[-1, 'draw'], [-2, 'aside']])
                for (const i of [0, 32]) {
                    const answer = new Promise(resolve => worker.addEventListener('message', ({ data }) => { if (data.id === id) resolve(data.error ?? '') }))
                    worker.postMessage({ id, method, args: [['--height=old.png', `--gloss=gloss ${i}.png`]] })
                    told.push(await answer)
                }
            return told
        })
        equal(told.join('; '), Array(2).fill('gloss 0.png: this map is not here; drop or choose the file; ').join('; '), 'what the worker says')
        await browser.drop({ 'normals.png': surfaces['grey8.png'].bytes }) // a surface, refused once it is drawn
        await browser.until(() => document.getElementById('refusal').textContent.startsWith('normals.png: '))
        check((await shownIsDrawn()).includes('--height=old.png'), 'the oldest file, which the refused one stood for')
        await browser.set('control-n', '8')
        await shownIsDrawn()
        equal(await browser.text('refusal'), '', 'what it says')
        await page.evaluate(() => document.getElementById('stop').click()) // another worker has them, too
        await browser.set('control-n', '9')
        await shownIsDrawn()
        await page.removeScriptToEvaluateOnNewDocument(identifier)
    }],
    ['a folder, or a file that is gone, is refused by its name', async () => {
        await browser.go(start)
        await page.evaluate(() => { Blob.prototype.arrayBuffer = () => Promise.reject(new DOMException('it is gone', 'NotFoundError')) })
        for (const [name, files] of [['textures', ['textures']], ['quad.obj', ['quad.obj']], ['quad.mtl', ['quad.obj', 'quad.mtl']]]) {
            await browser.drop(Object.fromEntries(files.map(file => [file, Buffer.from('v 0 0 0\n')])))
            await browser.until(text => document.getElementById('refusal').textContent === text, `${name}: cannot be read (it is gone); is it a folder?`)
        }
        await shownIsDrawn()
    }],
    ['where the browser never answers what it keeps, an address is drawn or said to lack its file, and drops are taken', async () => {
        const { identifier } = await page.evaluateOnNewDocument(() => { IDBFactory.prototype.open = () => ({}) })
        await browser.go('height=never.png')
        equal(await browser.text('refusal'), 'never.png: this map is not here; drop or choose the file', 'what it says')
        for (const name of ['grey8.png', 'grey16.png']) {
            await browser.drop({ [name]: surfaces[name].bytes })
            await browser.until(name => document.body.dataset.kept === name, name)
            check((await shownIsDrawn()).includes(`--height=${name}`), name)
        }
        await page.removeScriptToEvaluateOnNewDocument(identifier)
    }],
    ['a browser that fails to open its store once keeps the next file; where the store is full that is said', async () => {
        const { identifier } = await page.evaluateOnNewDocument(() => {
            const { open } = IDBFactory.prototype
            IDBFactory.prototype.open = function () {
                IDBFactory.prototype.open = open
                const request = { error: new DOMException('not now', 'UnknownError') }
                setTimeout(() => request.onerror(), 1)
                return request
            }
            const { setTimeout: plain, clearTimeout: clear } = globalThis, late = globalThis.late = new Map() // what is called after 4 s
            let last = 0
            globalThis.setTimeout = (then, ms, ...rest) => ms === 4000 ? late.set(--last, then) && last : plain(then, ms, ...rest)
            globalThis.clearTimeout = id => late.delete(id) || clear(id)
        })
        await browser.go(start)
        await page.removeScriptToEvaluateOnNewDocument(identifier)
        for (const name of ['grey8.png', 'grey16.png']) {
            await browser.drop({ [`once ${name}`]: surfaces[name].bytes })
            await browser.until(name => document.body.dataset.kept === name, `once ${name}`)
            await page.evaluate(() => globalThis.late.forEach(then => then()))
        }
        await browser.until(() => location.hash.slice(1) === document.body.dataset.state)
        await page.reload()
        await browser.until(() => document.body.dataset.drawn !== undefined)
        equal(await browser.text('refusal'), '', 'what it says after a reload')
        command.put('once grey16.png', surfaces['grey16.png'].bytes)
        check((await shownIsDrawn()).includes('--height=once grey16.png'), await browser.text('command'))
        await page.evaluate(() => {
            const { put } = IDBObjectStore.prototype
            IDBObjectStore.prototype.put = function (value) {
                const request = put.call(this, value), { transaction } = this
                request.onsuccess = () => transaction.abort()
                Object.defineProperty(transaction, 'error', { value: new DOMException('full', 'QuotaExceededError') })
                return request
            }
        })
        command.put('full.png', surfaces['grey8.png'].bytes)
        await browser.drop({ 'full.png': surfaces['grey8.png'].bytes })
        await browser.until(() => document.getElementById('refusal').textContent === 'full.png: the browser has no room to keep it; it is gone when the page is closed')
        check((await shownIsDrawn()).includes('--height=full.png'), await browser.text('command'))
    }],
    ['two tabs keep files by name as one folder does: what one forgets or replaces another shows until it is loaded again; a new file is kept whatever the clock says', async () => {
        const other = Object.assign(Object.create(browser), { page: await browser.browser.newPage() }), [old, newer] = ['grey8.png', 'grey16.png'].map(name => surfaces[name].bytes)
        const drop = async (tab, name, bytes) => {
            await tab.page.bringToFront()
            await tab.page.evaluate(() => { delete document.body.dataset.kept })
            await tab.drop({ [name]: bytes })
            await tab.until(name => document.body.dataset.kept === name, name)
        }
        const shows = async bytes => {
            command.put('shared.png', bytes)
            check((await shownIsDrawn()).includes('--height=shared.png'), await browser.text('command'))
        }
        const again = async n => {
            await page.bringToFront()
            await page.evaluate(() => document.getElementById('stop').click()) // another worker
            await browser.set('control-n', n)
            await browser.until(n => document.body.dataset.drawn.includes(`n=${n}`), n)
            await shows(old)
        }
        const load = async () => {
            await browser.until(() => location.hash.slice(1) === document.body.dataset.state)
            await page.reload()
            await browser.until(() => document.body.dataset.drawn !== undefined)
        }
        await browser.go(start)
        await other.go(start)
        await drop(browser, 'shared.png', old)
        await drop(other, 'shared.png', newer)
        await again('11')
        await load()
        await shows(newer)
        await drop(browser, 'shared.png', old)
        for (let i = 0; i < 32; i++)
            await drop(other, `many ${i}.png`, newer)
        await again('12')
        await load()
        equal(await browser.text('refusal'), 'shared.png: this map is not here; drop or choose the file', 'what it says')
        await page.evaluate(() => { Date.now = () => 0 }) // the clock is set back
        await drop(browser, 'shared.png', old)
        await load()
        await shows(old)
        await other.page.close()
    }],
    ['nothing was written to the console as an error', () => equal(browser.wrong.join('\n'), '', 'errors')],
], () => browser.close())
