// SPDX-License-Identifier: MIT
// test_module.mjs PAGE GLINT: the page's module and engine in node, against the command.
import { File } from 'node:buffer' // node 18 has no other
import { execFileSync, spawn, spawnSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { request } from 'node:http'
import { inflateRawSync } from 'node:zlib'
import { check, equal, run } from '../pico/tap.mjs'
import { Command, difference } from './glint.mjs'
import { extras, png, surfaces } from './maps.mjs'
import { ball, clothed, gltf, meshes, objs, ring, stl } from './meshes.mjs'
import { randomly, randomWords } from './states.mjs'

const [folder, glint] = process.argv.slice(2)
const { Engine, lists, namedBy, readPng, commandLine, stateOfFragment, stateOfWords, together, whiteName, wordsOf } = await import(`${process.cwd()}/${folder}/engine.mjs`)
const program = new WebAssembly.Module(readFileSync(`${folder}/module.wasm`))
const command = new Command(glint)
const [models, formats, paths, materials, scenes] = ['--model', '--format', '--path', '--material', '--scene'].map(option => command.choices(option))

function same(engine, words) {
    const picture = engine.draw(words)
    const wrong = difference(picture.rgba, picture.width, picture.height, command.render(words))
    check(!wrong, `${words.join(' ')}: ${wrong}`)
    return picture
}

function engineWithMaps() {
    const engine = new Engine(program)
    for (const [name, bytes] of [...Object.entries(surfaces).map(([name, { bytes }]) => [name, bytes]), ...Object.entries(extras)]) {
        command.put(name, bytes)
        engine.addMap(name, readPng(name, bytes))
    }
    return engine
}

/** status and body of a request to a server of this machine. */
function ask(port, path, method = 'GET') {
    return new Promise((resolve, reject) => request({ host: '127.0.0.1', port, path, method }, answer => {
        const parts = []
        answer.on('data', part => parts.push(part)).on('end', () => resolve({ status: answer.statusCode, body: Buffer.concat(parts) }))
    }).on('error', reject).end())
}

/** The sentence with which it refuses. */
function refusal(work) {
    try {
        work()
    } catch (error) {
        return error.message
    }
    return 'nothing was refused'
}

/** The command's picture, or its refusal. */
async function sameAnswer(engine, words) {
    const expected = await command.renderLater(words).catch(() => undefined)
    if (!expected) {
        equal(refusal(() => engine.draw(words)), command.refusal(['render', ...words, '-o', 'no.png']), words.join(' '))
        return
    }
    const { rgba, width, height } = engine.draw(words), wrong = difference(rgba, width, height, expected)
    check(!wrong, `${words.join(' ')}: ${wrong}`)
}

run([
    ['the page offers the models, formats, paths, materials and scenes that the command takes, with a title and, but for paths and scenes, what it means', () => {
        for (const [list, names] of Object.entries({ models, formats, paths, materials, scenes })) {
            equal(lists[list].map(({ name }) => name).join(), names.join(), list)
            for (const { name, title, meaning } of lists[list])
                check(title && (meaning || list === 'paths' || list === 'scenes'), `${name}: '${title}', '${meaning}'`)
        }
    }],
    ['the curve of every model, asked for by its name, is what the command prints', () => {
        const engine = new Engine(program), angles = [0, 5, 10, 15, 20]
        for (const model of models) {
            const { library, double } = engine.curve(model, 60, angles.length, 20)
            const printed = execFileSync(glint, ['eval', '--csv', `--model=${model}`, '-n60', ...angles.map(x => String(Math.cos(x * Math.PI / 180)))], { encoding: 'utf8' })
            const rows = printed.trimEnd().split('\n').slice(1).map(row => row.split(',').map(Number))
            rows.forEach((row, i) => {
                check(Math.abs(library[i] - row[5]) < 2e-3 && Math.abs(double[i] - row[6]) < 2e-3, `${model} at ${angles[i]} degrees: ${library[i]}, ${double[i]}; the command: ${row}`)
            })
        }
        check(refusal(() => engine.curve('none', 60, 5, 20)).includes('unknown model'), 'a model that there is not')
    }],
    ['every model, format and space, dithered or not, gives the command\'s pixels', () => {
        const engine = new Engine(program)
        for (const model of models)
            for (const format of formats)
                for (const space of ['gamma', 'linear'])
                    for (const dither of [[], ['--dither']])
                        same(engine, ['--scene=coin', '--size=64x48', `--model=${model}`, `--format=${format}`, `--space=${space}`, ...dither, '--light=-1,1,1.5'])
    }],
    ['the bytes of tables that the page states are those of glint.h', () => {
        const header = readFileSync('lib/glint.h', 'utf8'), engine = new Engine(program)
        const stated = kind => Number(header.match(new RegExp(`GLINT_TABLES_${kind}_BYTES (\\d+)u`))[1])
        for (const [words, colour] of [[[], 'COLOUR'], [['--dither'], 'DITHER']]) {
            engine.draw(['--scene=coin', '--size=9x9', ...words])
            const facts = engine.facts()
            equal([facts.colour_bytes, facts.albedo_bytes].join(), [colour, 'ALBEDO'].map(stated).join(), colour)
        }
    }],
    ['every path gives the command\'s pixels, with the same warning', () => {
        const engine = new Engine(program)
        for (const path of paths)
            for (const scene of ['sphere', 'dial']) {
                const words = [`--scene=${scene}`, '--size=80x60', '--format=rgb565', '--ambient=.1', '--diffuse=.8', `--path=${path}`]
                same(engine, words)
                same(engine, [...words, '--light=1,1,2'])
            }
        // Filled from memory that was not set, once: a fresh module, where that is seldom 0.
        for (const space of ['gamma', 'linear'])
            same(new Engine(program), ['--scene=watchface', '--size=51x26', '--model=blinn', '--format=rgb565', `--space=${space}`, '--path=colour-int16'])
        const { warnings } = engine.draw(['--scene=coin', '--size=64x48', '--format=rgb565', '--path=colour-int8'])
        check(/^--path colour-int8: draws one colour, \d+ of \d+ pixels/.test(warnings[0]), `it says ${warnings[0]}`)
    }],
    ['every built-in scene is the command\'s, at several sizes', () => {
        const engine = new Engine(program)
        for (const scene of scenes)
            for (const size of ['320x240', '240x240', '135x240', '61x47', '39x38', '20x58', '1x1']) // 39 and 20: where a step of a height, or a question about it, stood at a pixel's corner
                same(engine, [`--scene=${scene}`, `--size=${size}`])
    }],
    ['the teapot is the command\'s, by every path that draws meshes, and as it turns from what was kept', () => {
        const engine = new Engine(program)
        for (const path of ['exact', 'exact-int8', 'colour-int16', 'colour-int8'])
            for (const turn of ['25,-30,0', '-70,140,10'])
                same(engine, ['--scene=teapot', '--size=90x70', `--turn=${turn}`, '--format=rgb565', '--ambient=.1', '--diffuse=.8', `--path=${path}`])
        for (const more of [[], ['--perspective=3'], ['--perspective=3', '--zoom=1.5'], ['--light=1,1,1'], ['-n9', '--color=30,90,200', '--space=linear'], ['--split=180'], ['--split=12'], ['--dither', '--format=mono']])
            same(engine, ['--scene=teapot', '--size=61x47', ...more])
        check(engine.draw(['--scene=teapot', '--size=61x47', '--turn=1,2,3']).kept === false, 'kept, though the format is another')
        check(engine.draw(['--scene=teapot', '--size=61x47', '--turn=4,5,6']).kept, 'a turn is not drawn from what was kept')
        same(engine, ['--scene=coin', '--size=61x47'])
        same(engine, ['--scene=teapot', '--size=61x47', '--turn=4,5,6'])
    }],
    ['every material is the command\'s, on a scene, on a map and on the teapot, alone and with options beside it', async () => {
        const engine = engineWithMaps()
        for (const material of materials)
            for (const surface of ['--scene=coin', '--scene=teapot', '--height=grey16.png'])
                for (const more of [[], ['-n9', '--across=90', '--specular=.4'], ['--color=9,90,200']])
                    await sameAnswer(engine, [surface, '--size=45x33', `--material=${material}`, ...more])
        check(!engine.draw(['--scene=coin', '--size=45x33', '--material=gold']).kept && !engine.draw(['--scene=coin', '--size=45x33', '--material=jade']).kept, 'kept, though the material is another')
    }],
    ['grain of every kind, backgrounds, what is cut out and what is filtered give the command\'s pixels', async () => {
        const engine = engineWithMaps()
        for (const grain of ['brushed:30', 'spun', 'spun:10,20', 'sunray', 'sunray:10,20.5'])
            for (const surface of [['--scene=dial'], ['--scene=coin', '--cut-out'], ['--scene=coin', '--background=200,10,90'], ['--normals=rgba8.png', '--background=0,90,200']])
                same(engine, [...surface, '--size=45x33', '-n90', '--across=8', `--grain=${grain}`])
        same(engine, ['--height=grey16.png', '--grain=grain.png', '-n90', '--across=8'])
        for (const more of [['-n90'], ['-n300'], ['-n300', '--color=9,90,200'], ['--roughness=.3'], ['--roughness=.1']])
            same(engine, ['--height=grey16.png', '--wrap', '--filter=3', ...more])
        same(engine, ['--scene=coin', '--size=45x33', '--filter=2'])
        same(engine, ['--height=a-logo.png', '--bevel=6', '--cut-out', '--format=rgb565'])
        for (const [fit, size] of [[100, '45x33'], [70, '90x90'], [33.3, '31x200'], [9, '20x20']])
            same(engine, ['--height=a-logo.png', '--bevel=6', `--fit=${fit}`, `--size=${size}`, '--cut-out'])
        same(engine, ['--height=a-logo.png', '--bevel=6', '--background=9,200,90', '--format=mono', '--dither'])
        same(engine, ['--scene=teapot', '--size=45x33', '--background=9,200,90'])
        await sameAnswer(engine, ['--scene=teapot', '--size=45x33', '-n90', '--across=8', '--grain=brushed:90'])
    }],
    ['points, spots and coloured lights give the command\'s pixels', () => {
        const engine = new Engine(program)
        same(engine, ['--scene=coin', '--size=96x96', '--light=-1,1,2,.5,.5,.5', '--point=80,20,30,120,1,.7,.3', '--spot=10,90,60,48,48,200,20,40,.2,.4,1'])
        same(engine, ['--scene=coin', '--size=96x96', '--point=40.25,30.5,20,90', '--clamp-peak', '--view=.1,.2,1'])
    }],
    ['maps of every kind of PNG give the command\'s pixels, with the same warnings', () => {
        const engine = engineWithMaps()
        for (const [name, { words }] of Object.entries(surfaces))
            same(engine, [`${words[0]}=${name}`, ...words.slice(1), '-n20'])
        same(engine, ['--height=grey8.png', '--albedo=albedo.png', '--gloss=gloss.png', '--mask=mask.png'])
        same(engine, ['--normals=rgb8.png', '--albedo=albedo16.png', '--format=rgb565', '--dither'])
        const { warnings } = engine.draw(['--normals=rgba8.png'])
        equal(warnings.join(), 'rgba8.png: its alpha is the mask: transparent pixels are not drawn', 'the warning')
    }],
    ['a light that moves is drawn from what was kept, and so are other materials', () => {
        const engine = engineWithMaps()
        for (const light of ['-1,1,1', '1,0,1', '0,1,.2'])
            for (const rest of [[], ['-n300'], ['--path=span'], ['--color=9,90,200'], ['--format=mono'], ['--point=20,20,30,60']])
                same(engine, ['--height=grey16.png', ...rest, `--light=${light}`])
        same(engine, ['--height=grey16.png', '--point=20,20,30,60', '--light=1,1,1'])
        same(engine, ['--scene=coin', '--size=40x40', '--color=9,90,200'])
        same(engine, ['--scene=coin', '--size=40x40'])
    }],
    ['after a look at moving lights, the last picture is there for a board, and so it is where a step is refused', () => {
        const engine = new Engine(program)
        engine.addWhite('white', 60, 44)
        const other = ['--scene=coin', '--size=40x30']
        engine.draw(['--scene=coin', '--size=60x44', '--gloss=white', '--color=9,90,200', '--format=rgb565', '--path=colour-int8'])
        const pixels = engine.pixels(), has = { map: '', material: '' }
        const { changed } = engine.moving([other, [...other, '--light=1,0,1']])
        check(changed > 0, 'the moving light changes nothing')
        check(engine.device(60, 44, has), 'the board gets nothing')
        check(Buffer.from(engine.pixels()).equals(Buffer.from(pixels)), 'another picture')
        refusal(() => engine.moving([other, ['--scene=coin', '-n1001']]))
        check(engine.device(60, 44, has), 'the board gets nothing after a refusal')
    }],
    ['a board gets the last picture where another file came since, or one could not be made', () => {
        const engine = engineWithMaps(), words = ['--height=grey16.png', '--size=40x30', '--format=rgb565', '--path=colour-int8', '--color=9,9,9'], none = { map: '', material: '' }
        engine.draw(words)
        const { map, material } = engine.device(40, 30, none)
        for (const work of [() => refusal(() => engine.run(['glint table', '--kind=colour', '-n5000', '-o', 'a.c'])), () => engine.addMesh('ring.stl', meshes['ring.stl'])]) {
            work()
            const again = engine.device(40, 30, none)
            check(again && Buffer.from(map).equals(again.map) && Buffer.from(material).equals(again.material), 'the board gets nothing, or another picture')
        }
    }],
    ['a file that is forgotten is gone, with what came with it, and the last picture stays', () => {
        const engine = engineWithMaps(), words = ['--scene=dial', '--size=40x40'], texts = Object.entries(clothed(png({ width: 8, height: 8, type: 2, depth: 8, sample: x => 30 * x })))
        engine.addMesh('clothed.obj', together(texts.map(([name, bytes]) => ({ name, bytes: new Uint8Array(Buffer.from(bytes)) }))))
        engine.draw(['--mesh=clothed.obj', '--size=20x20'])
        engine.draw(words)
        const pixels = Buffer.from(engine.pixels())
        for (const name of ['grey8.png', 'clothed.obj'])
            engine.forget(name)
        check(pixels.equals(engine.pixels()), 'another picture')
        check(refusal(() => engine.draw(['--height=grey8.png'])).startsWith('grey8.png: this map is not here'), 'the map is there')
        check(refusal(() => engine.draw(['--mesh=clothed.obj'])).startsWith('clothed.obj: '), 'the mesh is there')
        same(engine, ['--height=grey16.png', '--size=40x30'])
        same(engine, words)
    }],
    ['files that come, change and go take no more memory and no other engine, and leave what a board follows', () => {
        const engine = engineWithMaps(), words = ['--height=grey16.png', '--size=40x30'], { Instance } = WebAssembly
        const map = { width: 500, height: 500, channels: 1, bits: 8, palette: false, samples: new Uint16Array(250000).fill(999) }
        const parts = Object.entries(clothed(png({ width: 8, height: 8, type: 2, depth: 8, sample: x => 30 * x }))).map(([name, bytes]) => ({ name, bytes: new Uint8Array(Buffer.from(bytes)) }))
        same(engine, words)
        let count = 0
        WebAssembly.Instance = class extends Instance {
            constructor(...of) {
                super(...of)
                count++
            }
        }
        const round = i => {
            for (let twice = 2; twice--;) {
                engine.addMap(`many ${i}.png`, map)
                engine.addMesh('clothed.obj', together(parts))
            }
            engine.forget(`many ${i}.png`)
            engine.forget('clothed.obj')
        }
        round(0)
        const before = engine.module.bytes().length
        for (let i = 1; i < 100; i++)
            round(i)
        WebAssembly.Instance = Instance
        equal(count, 0, 'other engines')
        equal(engine.module.bytes().length, before, 'bytes of memory')
        const { width, height } = same(engine, words)
        engine.addMap('one more.png', map)
        engine.draw(words)
        engine.forget('one more.png')
        same(engine, words)
        engine.draw([...words, '--format=rgb565', '--path=colour-int8', '--color=9,9,9'])
        engine.forget('grey8.png')
        check(engine.device(width, height, { map: '', material: '' }), 'the board gets nothing after a file is forgotten')
        engine.draw(words)
        engine.forget('grey16.png')
        check(refusal(() => engine.draw(words)).startsWith('grey16.png: this map is not here'), 'what was drawn last is drawn again without its file')
    }],
    ['a board gets the map of a file that another of its name replaces', () => {
        const engine = engineWithMaps(), words = ['--height=grey16.png', '--size=40x30', '--format=rgb565', '--path=colour-int8', '--color=9,9,9']
        engine.draw(words)
        const { has } = engine.device(40, 30, { map: '', material: '' })
        engine.draw(words)
        check(!engine.device(40, 30, has).map, 'it gets the same map again')
        engine.addMap('grey16.png', readPng('grey8.png', surfaces['grey8.png'].bytes))
        engine.draw(words)
        check(engine.device(40, 30, has).map, 'it keeps the map of the file that was replaced')
    }],
    ['a warning is said once, and no longer than it holds', () => {
        const engine = new Engine(program), warnings = (...words) => engine.draw(['--scene=sphere', '--size=20x20', ...words]).warnings
        equal(warnings('--roughness=1').length, 1, 'warnings')
        equal(warnings('--roughness=1', '--specular=.3').length, 1, 'warnings with another highlight')
        equal(warnings('--roughness=.5', '--specular=.3').length, 0, 'warnings of what is in range')
    }],
    ['what a file says many times is said once, and of what it says in thousands of ways the first ones', () => {
        const engine = new Engine(program), text = lines => new Uint8Array(Buffer.from(lines.join('\n') + '\n')), shape = ['v 0 0 0', 'v 1 0 0', 'v 0 1 0', 'f 1 2 3']
        const said = (mtl, ...lines) => {
            engine.addMesh('a.obj', together([{ name: 'a.obj', bytes: text([...lines, ...shape]) }, { name: 'a.mtl', bytes: text(mtl) }]))
            return engine.draw(['--mesh=a.obj', '--size=9x9']).warnings
        }
        equal(said(Array.from({ length: 50 }, (_, i) => `newmtl m${i}\nmap_Kd -t 1 a.png`), 'mtllib a.mtl').join(), 'a.obj: the option -t of a map_Kd is left out,a.obj: names a.png, which is not here: drop or choose it together with the mesh', 'one option')
        const many = said(['newmtl a'], ...Array.from({ length: 5000 }, (_, i) => `mtllib ${i}/a.mtl`))
        check(many.length < 100 && / more of these$/.test(many.at(-1)), `${many.length} lines, at last ${many.at(-1)}`)
    }],
    ['an OBJ whose first line tells of thousands of files is an OBJ with a comment', () => {
        const engine = new Engine(program), body = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', list = JSON.stringify([['a.obj', body.length], ...Array.from({ length: 200000 }, (_, i) => [`${i}`, 0])])
        engine.addMesh('a.obj', new Uint8Array(Buffer.from(`#glint ${list}\n${body}`)))
        check(!engine.meshes.has('a.obj/1'), 'each is a file')
        check(engine.draw(['--mesh=a.obj', '--size=9x9']).width === 9, 'it is not drawn')
    }],
    ['a link brings no control characters into a command', () => {
        const line = commandLine('glint render', wordsOf(stateOfFragment('height=a%15%0Aid%0A%7f.png')))
        check(!/[\0-\x1f\x7f]/.test(line), JSON.stringify(line))
    }],
    ['a file for which there is no memory is refused by its name, and every other one stays', () => {
        const engine = engineWithMaps(), none = { buffer: new ArrayBuffer(8), byteOffset: 0, byteLength: 2 ** 40, length: 2 ** 40 }
        same(engine, ['--height=grey8.png'])
        for (const name of ['huge.png', 'grey8.png'])
            check(refusal(() => engine.addMap(name, { width: 4, height: 4, channels: 1, bits: 8, palette: false, samples: none })).startsWith(`${name}: there is no room for this file`), name)
        for (const words of [['--height=grey8.png'], ['--height=grey16.png', '--size=40x30'], ['--scene=coin', '--size=40x40']])
            same(engine, words)
        check(refusal(() => engine.draw(['--height=huge.png'])).startsWith('huge.png: this map is not here'), 'it is there')
    }],
    ['meshes of binary STL files are drawn and baked as the command does, by every path that draws meshes', () => {
        const engine = new Engine(program)
        for (const [name, bytes] of Object.entries(meshes)) {
            command.put(name, bytes)
            engine.addMesh(name, bytes)
        }
        const words = ['--mesh=ring.stl', '--size=90x70', '--turn=25,-30,0']
        for (const path of ['exact', 'exact-int8', 'colour-int16', 'colour-int8'])
            same(engine, [...words, '--format=rgb565', '--ambient=.1', '--diffuse=.8', `--path=${path}`])
        for (const more of [[], ['--crease=10'], ['--crease=120'], ['--axes=y-up'], ['--split=8'], ['--color=30,90,200'], ['--zoom=2', '--perspective=2']])
            same(engine, [...words, ...more])
        for (const name of ['coloured.stl', 'facets.stl'])
            same(engine, [`--mesh=${name}`, '--size=61x47'])
        for (const list of [['bake', '--mesh=ring.stl', '-o', 'mesh.c'], ['bake', '--mesh=ring.stl', '--crease=20', '--split=9', '--to=int16', '-o', 'mesh.bin']]) {
            const expected = command.files(list), { files } = engine.run([`glint ${list[0]}`, ...list.slice(1)])
            equal(files.map(file => file.name).sort().join(), Object.keys(expected).sort().join(), `${list.join(' ')}: names`)
            for (const { name, bytes } of files)
                check(expected[name].equals(bytes), `${list.join(' ')}: ${name} differs`)
        }
        const { 'mesh.bin': raw } = command.files(['bake', '--mesh=ring.stl', '--split=90', '--to=int8', '-o', 'mesh.bin'])
        equal(engine.deviceMesh(command.held(raw, 90), ['--mesh=ring.stl']), 90, 'a board that holds it')
        equal(engine.deviceMesh(command.held(raw, 90), ['--mesh=coloured.stl']), 0, 'a board that holds another one')
    }],
    ['OBJ files are drawn, baked and refused as the command does, in every spelling', () => {
        const engine = new Engine(program)
        for (const [name, text] of Object.entries(objs)) {
            command.put(name, text)
            engine.addMesh(name, new Uint8Array(Buffer.from(text)))
            for (const more of [['--format=rgb565', '--turn=20,-50,10', '--perspective=3'], ['--turn=70,10,0', '--crease=30', '-n90', '--light=1,1,1']])
                same(engine, [`--mesh=${name}`, '--size=80x70', ...more])
            const list = ['bake', `--mesh=${name}`, '-o', 'mesh.c'], expected = command.files(list), { files } = engine.run([`glint ${list[0]}`, ...list.slice(1)])
            for (const file of files)
                check(expected[file.name].equals(Buffer.from(file.bytes)), `${name}: ${file.name} differs`)
        }
        const library = 'mtllib a b.mtl\nusemtl red\n' + objs['plain.obj']
        engine.addMesh('named.obj', new Uint8Array(Buffer.from(library)))
        const { rgba, warnings } = engine.draw(['--mesh=named.obj', '--size=40x40'])
        check(warnings.join() === 'named.obj: names a b.mtl, which is not here: drop or choose it together with the mesh', warnings.join())
        check(Buffer.from(rgba).equals(Buffer.from(engine.draw(['--mesh=plain.obj', '--size=40x40']).rgba)), 'it is not drawn without')
        const files = clothed(png({ width: 24, height: 17, type: 2, depth: 8, sample: (x, y, k) => ((x ^ y) & 4 ? 200 : 40 + 7 * x) + 13 * k & 255 }))
        for (const name in files)
            command.put(name, name === 'clothed.obj' ? files[name].replace('things/', '') : files[name])
        const given = without => together(Object.entries(files).filter(([name]) => name !== without).map(([name, bytes]) => ({ name, bytes: new Uint8Array(Buffer.from(bytes)) })))
        engine.addMesh('clothed.obj', given())
        for (const more of [['--format=rgb565'], ['--turn=20,-50,10', '--nearest'], ['--no-textures'], ['--color=200,60,30'], ['--material=gold'], ['--nearest']]) // in one colour it wears none, and then it does again
            same(engine, ['--mesh=clothed.obj', '--size=80x70', ...more])
        const said = without => {
            engine.addMesh('clothed.obj', given(without))
            return engine.draw(['--mesh=clothed.obj', '--size=40x40']).warnings.join()
        }
        for (const [without, named] of [['cloth.png', 'cloth.png'], ['clothed.mtl', 'things/clothed.mtl']])
            equal(said(without), `clothed.obj: names ${named}, which is not here: drop or choose it together with the mesh`, `without ${without}`)
        for (const text of ['', '#glint [["a.obj",3]]\nv 0 0\n', 'v 0 0\n', 'v 0 0 0\nf 1 2 3\n', 'v 0 0 0\nv nan 1 0\nv 1 1 0\nf 1 2 3\n', `v 0 0 0\nv 1 0 0\nv 0 1 0\n${'f 1 2 3\n'.repeat(65535)}`]) {
            command.put('wrong.obj', text || '#')
            engine.addMesh('wrong.obj', new Uint8Array(Buffer.from(text || '#')))
            equal(refusal(() => engine.draw(['--mesh=wrong.obj', '--size=20x20'])), command.refusal(['render', '--mesh=wrong.obj', '--size=20x20', '-o', 'no.png']), text.slice(0, 40))
        }
    }],
    ['a first line whose lengths are not those of parts of the file is a comment', () => {
        const engine = new Engine(program), obj = objs['plain.obj'], len = obj.length, half = obj.indexOf('\nf ', len / 2) + 1
        command.put('comment.obj', obj)
        for (const lengths of [[half, -half, len], [half, len - half - .5, .5], [len, 0, '0'], [half, 1e300], [len, null], ['', len], [len + 1], [len - 1]]) {
            engine.addMesh('comment.obj', new Uint8Array(Buffer.from(`#glint ${JSON.stringify(lengths.map((length, i) => [`${i}.mtl`, length]))}\n${obj}`)))
            same(engine, ['--mesh=comment.obj', '--size=40x40'])
        }
    }],
    ['of the files beside an OBJ go with it its materials, and the pictures whose whole names they have', async () => {
        const file = (name, text = '') => new File([text], name)
        const mtl = file('a.mtl', 'newmtl x # b.png\n# c.png \\\nmap_Kd -s 2 2 2 -clamp on maps\\la va.png\r\nmap_Kd lava.png\n  map_Bump -bm .5 two/n.png \nnorm -o 1 2.png')
        const named = async (...names) => (await namedBy([mtl, ...names.map(name => file(name))])).map(({ name }) => name).join()
        equal(await named('la va.png', 'lava.png', 'n.png', '2.png'), 'a.mtl,la va.png,lava.png,n.png,2.png', 'named')
        equal(await named('a.png', 'va.png', 'b.png', 'c.png', 'ava.png', '.png', 'x.obj'), 'a.mtl', 'not named')
        const refused = async files => namedBy(files).then(() => 'nothing was refused', error => error.message)
        for (const [name, where] of [['a.mtl', 'OBJ'], ['lava.png', 'MTL']])
            equal(await refused([mtl, file('lava.png'), file(name)]), `${name}: two of the files have this name; rename one, and change its name in the ${where}`, name)
        equal(await named('a.png', 'a.png'), 'a.mtl', 'two that it does not name')
        equal(await refused([Object.assign(file('folder.mtl'), { arrayBuffer: () => Promise.reject(new Error('no file')) })]), 'folder.mtl: cannot be read (no file); is it a folder?', 'a folder')
        const large = size => refused([new File([new Uint8Array(size)], 'large.mtl')])
        equal(await large(2 ** 24), 'nothing was refused', 'the largest that is read')
        equal(await large(2 ** 24 + 1), 'large.mtl: has more than 16 MB; choose the OBJ without it', 'one that is too large')
    }],
    ['two names of an OBJ that are one file without their folders are warned of', () => {
        const engine = new Engine(program), texts = Object.entries(clothed(png({ width: 8, height: 8, type: 2, depth: 8, sample: x => 30 * x })))
        const warnings = (mtl, libraries = 'mtllib a/clothed.mtl') => {
            const files = texts.map(([name, bytes]) => ({ name, bytes: new Uint8Array(Buffer.from(name === 'clothed.mtl' ? mtl : name === 'clothed.obj' ? bytes.replace(/.*/, libraries) : bytes)) }))
            engine.addMesh('clothed.obj', together(files))
            return engine.draw(['--mesh=clothed.obj', '--size=40x40']).warnings.join()
        }
        const materials = (one, two) => `newmtl cloth\nmap_Kd ${one}\nnewmtl red\nmap_Kd ${two}\n`
        const said = (one, two, where = 'MTL') => `clothed.obj: names ${one} and ${two}, which the page takes for one file, since it knows no folders; rename one, and change its name in the ${where}`
        for (const two of ['blue/cloth.png', 'blue\\cloth.png', 'cloth.png'])
            equal(warnings(materials('red/cloth.png', two)), said('red/cloth.png', two), two)
        equal(warnings('', 'mtllib a/clothed.mtl\nmtllib b/clothed.mtl'), said('a/clothed.mtl', 'b/clothed.mtl', 'OBJ'), 'libraries')
        equal(warnings(materials('./red/cloth.png', 'red\\cloth.png'), 'mtllib clothed.mtl\nmtllib ./clothed.mtl'), '', 'spellings of one name')
    }],
    ['of an OBJ\'s picture that is no PNG the page says so, not that it is to be dropped', () => {
        const engine = new Engine(program)
        for (const [name, sentence] of [...['w.jpg', 'w', 'w.png/w.tga'].map(name => [name, 'but the page reads PNG textures only; convert it to PNG, and change its name in the MTL']), ['w.PNG', 'which is not here: drop or choose it together with the mesh']]) {
            const files = { ...clothed(''), 'clothed.mtl': `newmtl cloth\nmap_Kd ${name}\n` }
            delete files['cloth.png']
            engine.addMesh('clothed.obj', together(Object.entries(files).map(([name, bytes]) => ({ name, bytes: new Uint8Array(Buffer.from(bytes)) }))))
            equal(engine.draw(['--mesh=clothed.obj', '--size=40x40']).warnings.join(), `clothed.obj: names ${name}, ${sentence}`, name)
        }
    }],
    ['glTF files that hold all they need are drawn and baked as the command does: colours, materials, textures', () => {
        const engine = new Engine(program), { places, normals, uv, colors, indices } = ball(), another = ball([1.2, .4, .3], .7, 11, 7)
        const picture = (type, channels) => png({ width: 24, height: 17, type, depth: 8, sample: (x, y, k) => ((x ^ y) & 4 ? 200 : 40 + 7 * x) + 13 * k * (channels > 2) & 255 })
        const textured = (more = {}, sampler = {}) => ({ materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, ...more } }], textures: [{ source: 0, sampler: 0 }], samplers: [sampler] })
        const files = {
            'plain.glb': gltf([{ places, normals, indices }]),
            'flat.glb': gltf([{ places: ring(9, 5).flat() }]),
            'bytes.glb': gltf([{ places, normals, indices: indices.slice(0, 240), indexKind: 5121 }]),
            'base.glb': gltf([{ places, normals, indices, material: 0 }], { materials: [{ pbrMetallicRoughness: { baseColorFactor: [.8, .3, .05, 1], roughnessFactor: .35, metallicFactor: .8 } }] }),
            'two.glb': gltf([{ ...another, uv: undefined, colors: undefined, material: 1 }, { places, normals, indices, material: 0 }], { materials: [{ pbrMetallicRoughness: { baseColorFactor: [.1, .2, .7, 1], metallicFactor: 0, roughnessFactor: .5 } }, { pbrMetallicRoughness: { baseColorFactor: [.9, .6, .1, 1] }, extensions: { KHR_materials_unlit: {} } }], extensionsUsed: ['KHR_materials_unlit'] }),
            'colours.glb': gltf([{ places, normals, indices, colors, material: 0 }], { materials: [{ pbrMetallicRoughness: { baseColorFactor: [.5, 1, .9, 1] } }] }),
            'colours of bytes.glb': gltf([{ places, normals, indices, colors: colors.map(color => [...color.map(v => Math.round(255 * v)), 255]), colorKind: 5121 }]),
            'textured.glb': gltf([{ places, normals, uv, indices, material: 0 }], textured({ roughnessFactor: .6 }), [picture(2, 3)]),
            'nearest.glb': gltf([{ places, normals, uv, indices, material: 0 }], textured({ baseColorFactor: [.9, .5, .5, 1] }, { magFilter: 9728, wrapS: 33071, wrapT: 33071 }), [picture(6, 4)]),
            'grey.glb': gltf([{ places, uv, indices, material: 0 }], textured(), [picture(0, 1)]),
            'look.glb': gltf([{ places, normals, uv, indices, material: 0 }], { materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 1 }, metallicRoughnessTexture: { index: 0 }, roughnessFactor: .7 } }], textures: [{ source: 0 }, { source: 1 }] }, [picture(2, 3), picture(0, 1)]),
            'moved.glb': gltf([{ ...another, uv: undefined, colors: undefined, material: 0 }, { places, normals, indices, material: 0 }], { materials: [{}], placed: [{ translation: [.3, 1.7, -.45], rotation: [.18257418, .36514837, .54772256, .73029674], scale: [.7, 1.3, .9] }, { matrix: [.8, .1, .2, 0, -.3, 1.1, .05, 0, .02, .4, .9, 0, -1.5, .2, .3, 1], children: [2] }, { mesh: 0, translation: [0, -2, 0], rotation: [0, .6, 0, .8] }] }),
            'a little moved.glb': gltf([{ places, normals, indices, material: 0 }], { materials: [{}], placed: [{ translation: [.004, .004, -.003] }] }),
            'text.gltf': gltf([{ places, normals, uv, indices, material: 0 }], textured(), [picture(2, 3)], true),
        }
        for (const [name, bytes] of Object.entries(files)) {
            command.put(name, bytes)
            engine.addMesh(name, new Uint8Array(bytes))
            for (const more of [['--format=rgb565'], ['--turn=20,-50,10', '--perspective=3'], ['--color=200,60,30'], ['--material=gold', '--path=exact-int8'], ['--turn=70,10,0', '--no-outlines', '--crease=30', '-n90', '--light=1,1,1']])
                same(engine, [`--mesh=${name}`, '--size=80x70', ...more])
            const list = ['bake', `--mesh=${name}`, '-o', 'mesh.c'], expected = command.files(list), { files: saved } = engine.run([`glint ${list[0]}`, ...list.slice(1)])
            equal(saved.map(file => file.name).sort().join(), Object.keys(expected).sort().join(), name)
            for (const file of saved)
                check(expected[file.name].equals(Buffer.from(file.bytes)), `${name}: ${file.name} differs`)
        }
    }],
    ['parts of a glTF stand where libassimp puts them, to the bit: moved, turned and scaled below each other', () => {
        const engine = new Engine(program), random = randomly(5), real = (low, high) => low + random() * (high - low), list = ['bake', '--mesh=placed.glb', '--split=180', '--to=int16', '-o', 'placed.bin']
        const place = () => {
            const turn = [0, 0, 0, 0].map(() => real(-1, 1)), length = Math.hypot(...turn), three = (low, high) => [0, 0, 0].map(() => real(low, high))
            return { ...random() < .7 && { translation: three(-2, 2) }, ...random() < .7 && { rotation: turn.map(v => v / length) }, ...random() < .7 && { scale: three(.3, 2) } }
        }
        for (let i = 0; i < 15; i++) {
            const { places, normals, indices } = ball([real(-1, 1), 0, 0], real(.3, 2), 13, 8), part = { places, normals, indices }
            const bytes = gltf([{ ...part, material: 0 }, { ...part, material: 1 }], { materials: [{}, {}], placed: [{ ...place(), children: [2] }, place(), { mesh: 1, ...place() }] })
            command.put('placed.glb', bytes)
            engine.addMesh('placed.glb', new Uint8Array(bytes))
            const { files: [{ bytes: baked }] } = engine.run([`glint ${list[0]}`, ...list.slice(1)])
            check(command.files(list)['placed.bin'].equals(Buffer.from(baked)), `scene ${i} stands otherwise`)
        }
    }],
    ['a glTF that the page cannot draw as the command does is refused with a word', () => {
        const engine = new Engine(program), { places, normals, uv, indices } = ball(), part = { places, normals, uv, indices, material: 0 }
        const textured = { materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }], textures: [{ source: 0 }] }
        for (const [bytes, sentence] of [[gltf([part], { ...textured, placed: [{ scale: [1, -1, 1] }] }, [png({ width: 4, height: 4, type: 0, depth: 8, sample: () => 9 })]), /mirrored parts/],
            [gltf([part], textured, [Buffer.from('\xff\xd8\xff\xe0 and more', 'latin1')]), /its texture 1: this is a JPEG, not a PNG/], [gltf([part], textured, [png({ width: 4, height: 4, type: 0, depth: 16, sample: () => 9 })]), /16 bits a sample/],
            [gltf([part], { materials: [{ pbrMetallicRoughness: { baseColorFactor: [1, .2] } }] }), /damaged/],
            [gltf([part, { ...part, uv: undefined }], { materials: [{}] }), /parts of different kinds/], [gltf([part], { materials: [{}], extensionsRequired: ['KHR_draco_mesh_compression'] }), /needs KHR_draco/],
            [Buffer.from('{"buffers":[{"uri":"a.bin","byteLength":9}]}'), /names other files/], [Buffer.from('glTF nothing more'), /damaged/], [gltf([part], { materials: [{}] }).subarray(0, 900), /damaged/]]) {
            const said = refusal(() => engine.addMesh('wrong.glb', new Uint8Array(bytes)))
            check(sentence.test(said) && said.startsWith('wrong.glb: '), `it says ${said}, not ${sentence}`)
        }
        check(engine.draw(['--scene=teapot', '--size=20x20']).width === 20, 'the next picture')
    }],
    ['a glTF that says what libassimp does not make of it is refused by the command and by the page', () => {
        const engine = new Engine(program), { places, normals, indices } = ball(), target = json => { json.meshes[0].primitives[0].targets = [{ POSITION: 0 }] }
        const changes = [[json => { json.extensionsRequired = ['EXT_meshopt_compression'] }, /needs EXT_meshopt_compression; export it without/],
            [json => { json.nodes[0].skin = 0 }, /has a skeleton; export it without/], [json => { json.accessors[1].componentType = 5123 }, /has numbers of a kind .*; export it with floats/],
            [json => { json.accessors[1].count-- }, /is damaged; export it again/], [json => { json.accessors[0].byteOffset = 12 }, /is damaged; export it again/],
            [json => { json.accessors[0].count = json.accessors[1].count -= 9 }, /is damaged; export it again|names a vertex that the file does not have/],
            [json => { target(json), json.meshes[0].weights = [.5] }, /has parts of different kinds|its morph targets have weights/]]
        for (const [change, sentence] of changes) {
            const json = JSON.parse(gltf([{ places, normals, indices }], {}, [], true))
            change(json)
            const bytes = Buffer.from(JSON.stringify(json))
            command.put('wrong.gltf', bytes)
            for (const said of [command.refusal(['render', '--mesh=wrong.gltf', '--size=20x20', '-o', 'no.png']), refusal(() => engine.addMesh('wrong.gltf', new Uint8Array(bytes)))])
                check(sentence.test(said) && said.startsWith('wrong.gltf: '), `it says ${said}, not ${sentence}`)
        }
    }],
    ['a wrong mesh gives a sentence, where the command has one the same', () => {
        const engine = new Engine(program), whole = meshes['ring.stl']
        const nan = Buffer.from(whole)
        nan.writeFloatLE(NaN, 84 + 12)
        const says = (bytes, ...more) => {
            engine.addMesh('a.stl', bytes)
            return refusal(() => engine.draw(['--mesh=a.stl', '--size=20x20', ...more]))
        }
        const asPassedOn = Buffer.alloc(200) // begins as the page's own numbers of a glTF
        asPassedOn.writeDoubleLE(20260001)
        const part = 'a.stl: this is not a whole binary STL; export the mesh as one, or use glint render --mesh'
        for (const bytes of [Buffer.alloc(0), whole.subarray(0, 83), whole.subarray(0, 200), Buffer.concat([whole, Buffer.of(0)]), Buffer.from('solid a\n'.repeat(30)), asPassedOn])
            equal(says(bytes), part, `${bytes.length} bytes`)
        equal(says(stl([])), 'a.stl: has no triangles; name another mesh', 'none')
        const many = stl(Array.from({ length: 65535 }, (_, i) => [[i, 0, 0], [i, 1, 0], [i, 0, 1]]))
        for (const bytes of [many, nan]) {
            command.put('a.stl', bytes)
            equal(says(bytes), command.refusal(['render', '--mesh=a.stl', '--size=20x20', '-o', 'no.png']), `${bytes.length} bytes`)
        }
        equal(refusal(() => engine.draw(['--mesh=none.stl', '--size=20x20'])), 'none.stl: this mesh is not here; drop or choose the file', 'a file that is not there')
        command.put('a.stl', whole)
        equal(says(whole, '--gloss=white.png'), command.refusal(['render', '--mesh=a.stl', '--size=20x20', '--gloss=white.png', '-o', 'no.png']), 'a map on a mesh')
        check(engine.draw(['--mesh=a.stl', '--size=20x20']).width === 20, 'the next mesh')
    }],
    ['of a mesh that a board holds it is told whether that is the teapot, and a pose a frame is what the board is sent', () => {
        const engine = new Engine(program)
        const held = command.teapotHeld()
        const teapot = ['--scene=teapot']
        equal(engine.deviceMesh(held, teapot), 180, 'the teapot')
        equal(engine.deviceMesh(held, ['--scene=coin']), 0, 'the coin')
        for (const at of [0, 4, 6, 8]) {
            const other = Buffer.from(held)
            other[at] ^= 1
            equal(engine.deviceMesh(other, teapot), 0, `the teapot, but for byte ${at}`)
        }
        const words = ['--scene=teapot', '--split=180', '--size=60x44', '--format=rgb565', '--path=colour-int8']
        const sent = (has, ...more) => {
            engine.draw([...words, ...more])
            return engine.device(60, 44, has)
        }
        const first = sent({ map: '', material: '' })
        equal(`${first.mesh} ${first.map} ${first.light} ${first.material.length} ${first.pose.length}`, 'true undefined undefined 48 28', 'at first')
        const second = sent(first.has, '--turn=3,4,5')
        equal(`${second.mesh} ${second.material} ${second.pose.length}`, 'undefined undefined 28', 'as it turns')
        check(!second.pose.subarray(4).every((byte, i) => byte === first.pose[4 + i]), 'the same pose')
        const map = ['--scene=sphere', '--size=60x44', '--gloss=white', '--color=9,90,200', '--format=rgb565', '--path=colour-int8']
        engine.addWhite('white', 60, 44)
        engine.draw(map)
        const third = engine.device(60, 44, second.has)
        equal(`${third.mesh} ${third.map.length} ${third.light.length} ${third.pose}`, `undefined ${4 * 60 * 44} 16 undefined`, 'a map after the mesh')
        equal(sent(third.has).mesh, true, 'the mesh after a map')
        equal(refusal(() => sent(third.has, '--perspective=3')), 'the device draws by parallel projection; leave out --perspective', 'in perspective')
        equal(refusal(() => sent(third.has, '--background=9,9,9')), 'the device draws over black; leave out --background', 'over a background')
    }],
    ['60 random states give the command\'s pictures or refusals', async () => {
        const engine = new Engine(program), random = randomly(3)
        for (let i = 0; i < 60; i++)
            await sameAnswer(engine, randomWords(random, command))
    }],
    ['a wrong value is refused in the command\'s words, and the next picture is right', () => {
        const engine = new Engine(program)
        for (const words of [['--scene=coin', '-n1001'], ['--scene=coins'], ['--scene=coin', '--path=palette'], ['--scene=coin', '--light=0,0,0'],
            [], ['--scene=coin', '--ambient=2'], ['--scene=coin', '--light=0,0,-1'], ['--scene=coin', '--format=rgb565', '--path=palette', '--dither']])
            equal(refusal(() => engine.draw(words)), command.refusal(['render', ...words, '-o', 'no.png']), words.join(' '))
        // A picture in the page is held whole, as a baked map is; the command draws larger ones in parts.
        equal(refusal(() => engine.draw(['--scene=coin', '--size=0x5'])), command.refusal(['bake', '--scene=coin', '--size=0x5', '-o', 'no.bin']), 'a size')
        same(engine, ['--scene=coin', '--size=40x40'])
        equal(refusal(() => engine.draw(['--height=none.png'])), 'none.png: this map is not here; drop or choose the file', 'a file that is not there')
        same(engine, ['--scene=dial', '--size=40x40'])
    }],
    ['a wrong file gives a sentence', () => {
        const good = surfaces['rgb16.png'].bytes
        const damaged = Buffer.from(good)
        damaged[good.length - 20] ^= 255
        const sentence = bytes => refusal(() => readPng('a.png', bytes))
        equal(sentence(Buffer.alloc(0)), 'a.png: this file is empty; choose a PNG picture', 'nothing')
        equal(sentence(Buffer.from('\xff\xd8\xff\xe0 and more', 'latin1')), 'a.png: this is a JPEG, not a PNG; convert it to PNG', 'a JPEG')
        equal(sentence(Buffer.from('hello')), 'a.png: this is not a PNG picture; convert it to PNG', 'a text')
        for (const bytes of [damaged, good.subarray(0, 20), good.subarray(0, good.length - 30)])
            check(/^a\.png: damaged PNG: .*\w; save it again$/.test(sentence(bytes)), sentence(bytes))
        const wide = png({ width: 20000, height: 1, type: 0, depth: 8, sample: () => 0 })
        equal(sentence(wide), 'a.png: 20000x1 pixels; at most 16384 a side and 33554432 in all are allowed', 'a wide one')
        equal(sentence(png({ width: 0, height: 40, type: 0, depth: 8, sample: () => 0 })), 'a.png: damaged PNG: it has 0x40 pixels; save it again', 'one without pixels')
    }],
    ['material, tables and baked maps are byte for byte the command\'s files', () => {
        const engine = engineWithMaps()
        const look = ['--ambient=.3', '--diffuse=.6', '--format=rgb565', '-n90']
        for (const words of [
            ['material', '--scene=coin', '--name=coin_init', '-o', 'look.h'], ['material', ...look, '--model=cayley', '-o', 'look.h'],
            ['material', '--point=9,8,30,90,1,.5,.25', '--light=1,1,1', '--spot=9,8,30,20,20,90,10,30', '-o', 'lights.h'],
            ['table', '--kind=colour', ...look, '-o', 'look_tables.c'], ['table', '--kind=albedo', ...look, '-o', 'look_tables.h'],
            ['table', '--kind=albedo', '--ambient=.1', '-o', 'albedo.c'], ['table', '--model=gauss', '-n', '200', '--of=c', '--bits=8', '-o', 'shine.c'],
            ['bake', '--scene=dial', '--size=64x64', '--strip=16', '-o', 'dial.c'], ['bake', '--height=grey16.png', '--albedo=albedo.png', '--to=int16', '-o', 'wall.c'],
            ['bake', '--normals=rgba8.png', '--to=palette:300', '-o', 'map.c'], ['bake', '--height=a-logo.png', '--bevel=5', '--to=int16', '-o', 'map.bin'],
            ['bake', '--scene=dial', '--size=64x64', '-o', 'dial.uf2']]) {
            const expected = command.files(words)
            const { files } = engine.run([`glint ${words[0]}`, ...words.slice(1)])
            equal(files.map(file => file.name).sort().join(), Object.keys(expected).sort().join(), `${words.join(' ')}: names`)
            for (const { name, bytes } of files)
                check(expected[name].equals(bytes), `${words.join(' ')}: ${name} differs`)
        }
        equal(refusal(() => engine.run(['glint bake', '--scene=dial', '-o', 'a.txt'])), command.refusal(['bake', '--scene=dial', '-o', 'a.txt']), 'a wrong name')
        equal(refusal(() => engine.run(['glint bake', '--scene=dial', '--json'])), '--json: only the command writes JSON', '--json')
    }],
    ['words, state and command line say the same', () => {
        equal([[], ['full-gloss.png'], ['a.png', 'full-gloss.png', 'full-gloss-2.png']].map(taken => whiteName(new Set(taken))).join(),
            'full-gloss.png,full-gloss-2.png,full-gloss-3.png', 'names beside the user\'s')
        const words = ['--scene=coin', '--size=64x48', '-n60', '--clamp-peak', '--dither', '--light=-1,1,1', '--point=1,2,3,4']
        equal(wordsOf(stateOfWords(words)).sort().join(' '), [...words].sort().join(' '), 'there and back')
        const odd = new Engine(program), { words: two, model } = (state => ({ words: wordsOf(state), model: state.model }))(stateOfFragment('scene=coin&model=msh%00--grain%3D<b>%00--grain%3Dbrushed'))
        check(!model.includes('\0') && refusal(() => odd.draw(two)).startsWith('--model: unknown model'), 'a link\'s word that ends before its end')
        equal(commandLine('glint render', ['--height=my map.png', '-n60']), 'glint render \'--height=my map.png\' -n60', 'quoted')
    }],
    ['the page has the module, deflated, and stays under 500 KB', () => {
        const page = readFileSync(`${folder}/index.html`, 'utf8')
        check(page.length < 500_000, `${page.length} bytes`)
        const packed = page.match(/[A-Za-z0-9+/]{10000,}={0,2}/)
        check(inflateRawSync(Buffer.from(packed[0], 'base64')).equals(readFileSync(`${folder}/module.wasm`)), 'another module')
        check(!/(src|href)\s*=\s*["']?(https?:)?\/\//.test(page.replace(/<a [^>]*>/g, '')), 'something is fetched')
    }],
    ['glint page serves this very file to this machine, and ends by a signal', async () => {
        const server = spawn(glint, ['page', '--port', '0', '--file', `${folder}/index.html`])
        const ended = new Promise(resolve => server.on('exit', (code, signal) => resolve(signal ?? code)))
        const line = await new Promise(resolve => server.stdout.once('data', resolve))
        const port = Number(String(line).match(/^http:\/\/localhost:(\d+)\/ until Ctrl-C\n$/)?.[1])
        check(port > 0, `it says ${line}`)
        const page = readFileSync(`${folder}/index.html`)
        for (const path of ['/', '/index.html', '/?a'])
            check((await ask(port, path)).body.equals(page), `${path} is another file`)
        equal((await ask(port, '/', 'HEAD')).body.length, 0, 'bytes after HEAD')
        for (const [path, method, status] of [['/other', 'GET', 404], ['/../Makefile', 'GET', 404], ['/', 'POST', 405], ['/' + 'a'.repeat(9000), 'GET', 404]])
            equal((await ask(port, path, method).catch(() => ({ status }))).status, status, `${method} ${path.slice(0, 20)}`)
        const taken = spawnSync(glint, ['page', '--port', String(port), '--file', `${folder}/index.html`], { encoding: 'utf8' })
        equal(`${taken.status} ${taken.stderr}`, `1 glint: port ${port}: Address already in use; choose another with --port, or --port 0\n`, 'a port that is taken')
        server.kill('SIGTERM')
        check(['SIGTERM', 143].includes(await ended), `it ends with ${await ended}`)
    }],
])
