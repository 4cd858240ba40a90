// SPDX-License-Identifier: MIT
// test_browser.mjs PACKAGES PAGE GLINT BROWSER STATES: the page in a browser: its pictures, files and refusals against the command.
import { execFileSync } from 'node:child_process'
import { mkdirSync, writeFileSync } from 'node:fs'
import { dirname, resolve } from 'node:path'
import { check, equal, run } from '../pico/tap.mjs'
import { browser, command, fragment, isFirefox, page, readPng, shownIsDrawn, start } from './beside.mjs'
import { difference } from './glint.mjs'
import { extras, png, surfaces } from './maps.mjs'
import { framesOf, pictureOf, unzipped } from './packed.mjs'
import { randomly, randomWords } from './states.mjs'

const count = process.argv[6]

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

/** A map by which all has full gloss. */
const fullGloss = (width, height) => png({ width, height, type: 0, depth: 8, sample: () => 255 })
/** The direction that the page makes of where the light is put. */
const withZ = word => {
    const [x, y] = word.slice(8).split(',').map(Number)
    const r = Math.hypot(x, y), [a, b] = r > .98 ? [x * .98 / r, y * .98 / r] : [x, y]
    return `--light=${[a, b, Math.sqrt(1 - a * a - b * b)].map(v => Number(v.toFixed(3)))}`
}

run([
    ['the page opens from a file and shows a picture, the lobe, errors and costs', async () => {
        await browser.go()
        await shownIsDrawn()
        await browser.expert()
        equal(await page.evaluate(() => document.querySelectorAll('#curve polyline').length), 3, 'curves')
        check((await browser.text('errors')).includes('msh in double'), 'no errors')
        const costs = await browser.text('costs')
        check(/exact albedo, n = 60.*M0\+, cycles a covered pixel[\d,]+ \(assembly [\d,]+\)/.test(costs) && /M3[\d,]+ instructions/.test(costs) && !/\D0 bytes|\D0,/.test(costs), costs)
    }],
    ['every model, format, space and path gives the command\'s pixels on the canvas', async () => {
        await browser.go(start)
        const list = [], [models, formats, paths] = ['--model', '--format', '--path'].map(option => command.choices(option))
        for (const model of models)
            for (const format of formats)
                list.push(['--scene=dial', '--size=48x40', `--model=${model}`, `--format=${format}`, ...list.length % 2 ? ['--space=linear'] : [], ...list.length % 3 ? ['--dither'] : []])
        for (const path of paths)
            list.push(['--scene=sphere', '--size=48x40', '--format=rgb565', '--ambient=.1', '--diffuse=.8', `--path=${path}`])
        equal(await same(list), formats.length * models.length + paths.length, 'pictures')
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
        await browser.set('control-scale', '30')
        check((await shownIsDrawn()).includes('--scale=30'), 'no --scale')
    }],
    ['a wrong file gives a sentence, and the picture stays', async () => {
        await browser.go(start)
        for (const [file, bytes, sentence] of [['bunny.ply', Buffer.from('ply\n'), 'bunny.ply: the page reads meshes from OBJ, binary STL and glTF files; glint render --mesh reads others, too'], ['a.obj', Buffer.from('v 0 0\n'), 'a.obj: glint cannot read this mesh: line 1: a vertex has three numbers, or six with its colour'], ['photo.jpg', Buffer.from('\xff\xd8\xff\xe0', 'latin1'), 'photo.jpg: this is a JPEG, not a PNG; convert it to PNG'],
            ['cut.png', surfaces['rgb8.png'].bytes.subarray(0, 300), /^cut\.png: damaged PNG: .*; save it again$/]]) {
            await browser.drop({ [file]: bytes })
            await browser.until(file => !document.getElementById('refusal').hidden && document.getElementById('refusal').textContent.startsWith(file), file)
            const said = await browser.text('refusal')
            check(sentence.test ? sentence.test(said) : said === sentence, said)
        }
        await shownIsDrawn()
    }],
    ...[[['--scene=dial', '--size=60x60', '--format=rgb565', '-n50', '--ambient=.2', '--diffuse=.7', '--light=-1,1,1.2'], {}],
        [['--height=grey16.png', '--scale=9', '--mask=mask.png', '--albedo=albedo.png', '--gloss=gloss.png', '--size=40x30', '--format=rgb565', '--ambient=.2', '--diffuse=.7'],
            { 'grey16.png': surfaces['grey16.png'].bytes, 'mask.png': extras['mask.png'], 'albedo.png': extras['albedo.png'], 'gloss.png': extras['gloss.png'] }],
    ].map(([words, maps]) => [`saved files are the command's, and the PNG has its pixels: ${words[0]}`, async () => {
        await browser.go(fragment(words))
        for (const [file, bytes] of Object.entries(maps)) {
            await browser.drop({ [file]: bytes })
            await browser.until(file => !document.getElementById('refusal').textContent.startsWith(file), file)
        }
        await browser.until(() => document.getElementById('refusal').hidden)
        await shownIsDrawn()
        for (const [id, count] of [['material', 1], ['colour', 2], ['albedo', 2], ['int8', 2], ['int16', 2], ['palette', 2], ['raw', 1], ['uf2', 1]]) {
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
    }]),
    ...['--scene=sphere --size=40x36 --format=rgb565 -n20', '--scene=knob --size=44x40 --format=rgb888 --model=schlick', '--scene=coin --size=31x30 --format=grey4 --space=linear --cut-out',
        '--height=a-logo.png --bevel=6 --cut-out --format=rgb565 --dither --light=1,1,1,.5,1,1 --light=-1,0,1', '--scene=dial --size=32x32 --format=mono --dither'].map(text => [`the program in plain C draws the picture in one colour: ${text}`, async () => {
        const words = text.split(' '), file = 'a-logo.png'
        await browser.go(start)
        if (text.includes(file)) {
            await browser.drop({ [file]: surfaces[file].bytes })
            await browser.until(file => document.body.dataset.kept === file, file)
        }
        await browser.go(fragment(words))
        await shownIsDrawn()
        const { 'picture.zip': archive } = await browser.save('file-c', 1), folder = `${command.folder}/program-${Math.random()}`, lib = `${process.cwd()}/lib`
        mkdirSync(folder)
        const files = unzipped(archive)
        equal(Object.keys(files).sort().join(), ['main.c', 'material.h', 'normals.c', 'normals.h', 'picture.h'].map(name => `picture/${name}`).join(), 'files')
        for (const [name, bytes] of Object.entries(files))
            writeFileSync(`${folder}/${name.split('/')[1]}`, bytes)
        execFileSync('cc', ['-std=c99', '-Wall', '-Wextra', '-Werror', `-I${lib}`, 'main.c', 'normals.c', `${dirname(resolve(command.glint))}/libglint.a`, '-o', 'picture'], { cwd: folder })
        const pixels = execFileSync('./picture', { cwd: folder })
        const color = (await browser.text('file-status'), (files['picture/picture.h'].toString().match(/^\/\* Lines of the picture, (\d+), (\d+), (\d+)/)).slice(1).join())
        const [width, height] = (await browser.text('status')).match(/\d+/g)
        command.put('full.png', fullGloss(Number(width), Number(height)))
        const gloss = text.includes('height') ? [] : ['--gloss=full.png']
        const expected = command.raw([...words, `--color=${color}`, ...gloss, '--path=exact-int8'])
        check(pixels.equals(expected), `${pixels.length} bytes, the command's ${expected.length}; the first that differs is ${pixels.findIndex((byte, i) => byte !== expected[i])}`)
    }]),
    ['normals of a surface that is filtered are saved for the shininess of the picture', async () => {
        for (const [look, n] of [['-n77', 77], ['--roughness=.4', 76]]) {
            await browser.go(fragment(['--scene=dial', '--size=30x30', '--filter=2', look]))
            await shownIsDrawn()
            const expected = command.files(['bake', '--scene=dial', '--filter=2', '--size=30x30', `-n${n}`, '--to=int8', '-o', 'normals.c'])
            const saved = await browser.save('file-int8', 2), own = unzipped((await browser.save('file-c', 1))['picture.zip'])
            for (const [name, bytes] of Object.entries(expected))
                check(bytes.equals(saved[name]) && bytes.equals(own[`picture/${name}`]), `${look}: ${name} is for another one`)
            check((await browser.text('file-status')).includes('without how details shade each other'), 'it does not say that the program draws rough places brighter')
        }
    }],
    ['a program takes no map of scratches where they do not show, which the library refuses beside one of shininess', async () => {
        await browser.go(start)
        await browser.drop({ 'grey8.png': surfaces['grey8.png'].bytes, 'grain.png': extras['grain.png'] })
        await browser.until(() => document.body.dataset.kept === 'grain.png')
        await browser.go(fragment(['--height=grey8.png', '--filter=2', '--grain=grain.png']))
        await shownIsDrawn()
        const draws = unzipped((await browser.save('file-c', 1))['picture.zip'])['picture/picture.h'].toString()
        check(draws.includes('maps.shininess') && !draws.includes('maps.grain'), draws)
    }],
    ['programs for LVGL and Arduino hold what they include', async () => {
        await browser.go(fragment(['--scene=knob', '--size=40x40', '--format=rgb888']))
        await shownIsDrawn()
        for (const [id, name, word] of [['lvgl', 'picture.c', 'LV_COLOR_FORMAT_RGB565'], ['arduino', 'picture.ino', 'pushImage']]) {
            const files = unzipped((await browser.save(`file-${id}`, 1))['picture.zip'])
            check(files[`picture/${name}`].includes(word) && files['picture/picture.h'].includes('GLINT_GRAIN_SPUN'), `${name} lacks ${word}`)
            check(files['picture/material.h'].includes(id === 'arduino' ? 'GLINT_RGB565_SWAPPED' : 'GLINT_RGB565,'), 'the format')
        }
    }],
    ['an animation has the command\'s pixels in each of its pictures: of the light\'s orbit, and of a mesh that turns', async () => {
        for (const [words, of] of [[['--scene=coin', '--size=40x36', '--format=rgb565', '--light=0,0,1'], k => [`--light=${[Math.cos(k * Math.PI / 24) * 40 / 36, Math.sin(k * Math.PI / 24)].map(v => Number((.72 * v).toFixed(3)))}`]],
            [['--scene=teapot', '--size=40x36', '--turn=10,0,0'], k => [`--turn=10,${((360 * k / 48 + 180) % 360) - 180},0`]]]) {
            await browser.go(fragment(words))
            await shownIsDrawn()
            const { 'glint.apng': file } = await browser.save('file-apng', 1), frames = framesOf(file)
            equal(frames.length, 48, 'pictures')
            for (const k of [0, 1, 7, 24, 47]) {
                const [word] = of(k), changed = word.startsWith('--light=') ? withZ(word) : word
                const wrong = difference(frames[k].rgba, frames[k].width, frames[k].height, command.render([...words.filter(other => !other.startsWith(changed.slice(0, 6))), changed]))
                check(!wrong, `picture ${k}, ${changed}: ${wrong}`)
            }
        }
    }],
    ['PNG and APNG of argb8888 have the command\'s alpha', async () => {
        for (const words of [['--scene=coin', '--size=40x36', '--cut-out', '--format=argb8888', '--light=0,0,1'], ['--scene=teapot', '--size=40x36', '--turn=10,0,0', '--format=argb8888']]) {
            await browser.go(fragment(words))
            await shownIsDrawn()
            const { 'glint.png': png } = await browser.save('file-png', 1), expected = command.render(words), own = pictureOf(png)
            equal(own.channels, 4, `channels, ${words[0]}`)
            check(own.samples.equals(expected.samples), `${words[0]}: the PNG has other pixels`)
            if (words.includes('--cut-out')) {
                check(expected.samples.some((value, i) => i % 4 === 3 && value > 0 && value < 255), 'no soft edge')
                continue
            }
            const { 'glint.apng': file } = await browser.save('file-apng', 1)
            check(framesOf(file)[0].rgba.equals(expected.samples), 'the APNG has other pixels')
        }
    }],
    ['the normal map as PNG is drawn as the surface is, and the stage\'s picture has the panel\'s pixels in it', async () => {
        await browser.go(fragment(['--scene=coin', '--size=60x50']))
        await shownIsDrawn()
        const { 'normals.png': map } = await browser.save('file-normals', 1)
        command.put('saved normals.png', map)
        command.put('full.png', fullGloss(60, 50))
        const own = command.render(['--scene=coin', '--size=60x50', '--color=9,99,200', '--gloss=full.png', '-n30', '--ambient=.1', '--diffuse=.6', '--specular=.5'])
        const again = command.render(['--normals=saved normals.png', '--color=9,99,200', '-n30', '--ambient=.1', '--diffuse=.6', '--specular=.5'])
        const most = own.samples.reduce((most, value, i) => Math.max(most, Math.abs(value - again.samples[i])), 0)
        check(most <= 1, `samples differ by ${most}`)
        const { 'stage.png': stage } = await browser.save('file-stage', 1), picture = readPng('stage.png', stage)
        check(picture.width >= 120 && picture.height >= 100, `${picture.width}x${picture.height}`)
    }],
    [`${count} random states give the command's pictures or refusals`, async () => {
        const random = randomly(isFirefox ? 2 : 1)
        await browser.go(start)
        const pictures = await same(Array.from({ length: Number(count) }, () => randomWords(random, command)), true)
        check(pictures > count / 2, `only ${pictures} pictures`)
    }],
    ['nothing was written to the console as an error', () => equal(browser.wrong.join('\n'), '', 'errors')],
], () => browser.close())
