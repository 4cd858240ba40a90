// SPDX-License-Identifier: MIT
// test_hostile.mjs PAGE: what the page does with devices that answer anything and with files that hold anything: in node, without a
// browser. SEED (1), DEVICES (400), FILES (300).
import { readFileSync } from 'node:fs'
import { check, equal, run } from '../pico/tap.mjs'
import { crc, png } from './maps.mjs'
import { ball, gltf, meshes } from './meshes.mjs'
import { randomly } from './states.mjs'

const [folder] = process.argv.slice(2)
const { Engine, Pico, readPng, sentences, together, Trouble, white } = await import(`${process.cwd()}/${folder}/engine.mjs`)
const engine = new Engine(new WebAssembly.Module(readFileSync(`${folder}/module.wasm`)))
const random = randomly(Number(process.env.SEED ?? 1))
const below = count => Math.floor(random() * count), pick = list => list[below(list.length)]
const count = Number(process.env.DEVICES ?? 400), patience = 20, sideMax = 16384, pixelsMax = 1 << 25
const descriptor = (width, height) => Uint8Array.of(0x67, 0x6c, 0x6e, 0x74, 1, 0, 0, 0, width, width >> 8, height, height >> 8)
const bytes = length => Uint8Array.from({ length }, () => below(256))
const oddNumbers = [0, 1, 8, 240, 4096, 16384, 16385, 32768, 65535]

/** An answer of any kind: one in `odd` is not what was asked for. */
function answer(odd, good) {
    switch (below(odd)) {
    case 0: return Promise.reject(pick([new DOMException('A transfer error has occurred.', 'NetworkError'), 'a text', undefined, new TypeError('x')]))
    case 1: return new Promise(() => undefined)
    case 2: return Promise.resolve({ status: pick(['stall', 'babble', 'none', undefined]) })
    case 3: return Promise.resolve({ status: 'ok' })
    case 4: return Promise.resolve({ status: 'ok', data: new DataView(bytes(below(64)).buffer) })
    case 5: return Promise.resolve({ status: pick(['ok', 'stall']), data: new DataView(bytes(good.length).buffer) })
    default: return Promise.resolve({ status: 'ok', data: new DataView(Uint8Array.from(good).buffer) })
    }
}

function hostile() {
    const odd = pick([6, 8, 20, 100, 1000]) // of 6 all are
    const settle = odd => below(odd) ? Promise.resolve() : below(2) ? new Promise(() => undefined) : Promise.reject(new DOMException('Unable.', 'InvalidStateError'))
    const endpoint = () => ({ endpointNumber: below(16), direction: pick(['out', 'out', 'in']), type: pick(['bulk', 'bulk', 'interrupt']) })
    const alternate = () => ({ interfaceClass: pick([255, 255, 255, 3, 0]), endpoints: Array.from({ length: below(4) }, endpoint) })
    const good = { interfaces: [{ interfaceNumber: 1, alternates: [{ interfaceClass: 255, endpoints: [{ endpointNumber: 2, direction: 'out', type: 'bulk' }] }] }] }
    const configuration = below(2) ? good : { interfaces: Array.from({ length: below(5) }, (_, interfaceNumber) =>
        ({ interfaceNumber, alternates: Array.from({ length: below(8) ? 1 + below(2) : 0 }, alternate) })) }
    const size = descriptor(pick([240, pick(oddNumbers)]), pick([240, pick(oddNumbers)]))
    return {
        productName: pick(['A board', '', undefined, '\u001b[31m<b>x']), serialNumber: pick(['17', undefined]), closed: 0,
        configuration: below(10) ? configuration : null,
        async open() { await settle(odd) },
        async close() { this.closed++; await settle(odd) },
        async selectConfiguration() { await settle(odd); this.configuration = pick([configuration, null]) },
        claimInterface: () => settle(odd),
        releaseInterface: () => settle(odd),
        clearHalt: () => settle(odd),
        controlTransferIn: ({ request }) => answer(odd, request === 0xa0 ? size : request === 0xa4 ? bytes(12) : request === 0xa6 ? bytes(16) : [below(odd) ? 0 : below(256)]),
        controlTransferOut: () => answer(odd, []),
        transferOut: () => answer(odd, []),
    }
}

const isSentence = error => error instanceof Trouble && (Object.values(sentences).includes(error.message) || error.message.startsWith('The device refused '))
const stray = []
process.on('unhandledRejection', error => stray.push(error))

/** A device's whole life with the page; what is wrong with that, or ''. Counts what became of it. */
async function live(device, became) {
    const usb = { getDevices: () => pick([async () => [device], async () => [], async () => { throw new Error('no') }])() }
    let pico
    try {
        pico = await Pico.connect(usb, device, bytes => engine.deviceSize(bytes), patience)
        if (!(pico.width >= 1 && pico.width <= sideMax && pico.height >= 1 && pico.height <= sideMax && pico.width * pico.height <= pixelsMax))
            return `a size of ${pico.width}x${pico.height}`
        became.connected++
        if (pico.mesh) {
            const split = engine.deviceMesh(pico.mesh, ['--scene=teapot'])
            if (split !== 0)
                return `a mesh that is not the teapot: ${split}`
            await pico.useMesh()
            await pico.sendPose(bytes(20))
        }
        await pico.sendMap(bytes(4 * below(9000)))
        await pico.sendMaterial(bytes(48))
        await pico.sendLight(bytes(16))
        await pico.close()
        became.served++
    } catch (error) {
        if (!isSentence(error))
            return `not a sentence: ${error?.stack ?? error}`
        became.refused++
    }
    return device.closed ? '' : 'it was not closed'
}

// ---- files ----

const files = Number(process.env.FILES ?? 300)
const { places, normals, uv, colors, indices } = ball([0, 0, 0], 1, 8, 5)
const picture = png({ width: 8, height: 8, type: 2, depth: 8, sample: () => below(256) })
const texts = [false, true].flatMap(isText => [gltf([{ places, normals, indices, material: 0 }], { materials: [{ pbrMetallicRoughness: { baseColorFactor: [.5, .6, .7, 1] } }] }, [], isText),
    gltf([{ places, normals, uv, colors, indices, material: 0 }, { places, normals, uv, colors, indices }],
        { materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }], textures: [{ source: 0, sampler: 0 }], samplers: [{ wrapS: 33071 }], placed: [{ translation: [1, 0, 0], children: [2] }, { rotation: [0, 0, 1, 0], scale: [1, 2, 1] }, {}] }, [picture], isText)])

/** The file with its numbers, names and values, or any bytes, changed. */
function changed(file) {
    let text = Buffer.from(file).toString('latin1')
    const part = /-?[0-9][0-9.e+-]*|"[A-Za-z_0-9]+"|\[[^[\]]*\]|\{[^{}]*\}/g
    for (let left = pick([1, 1, 2, 5]); left--;) {
        const at = below(text.length), head = text.slice(0, at)
        if (below(3)) {
            const found = [...text.slice(0, 8000).matchAll(part)], { 0: old, index } = pick(found) ?? { 0: '', index: 0 }
            const value = pick(['0', '-1', '1.5', '1e308', '4294967296', '1e9', '5126', 'null', '[]', '{}', '""', '"a"', '[0,0]', 'true', old + old])
            text = text.slice(0, index) + value + text.slice(index + old.length)
        } else {
            text = pick([head, head + String.fromCharCode(below(256)) + text.slice(at + 1), head + text.slice(at + below(30)), head + head.slice(-below(30)) + text.slice(at)])
        }
        text ||= ' '
    }
    return Uint8Array.from(Buffer.from(text, 'latin1'))
}

/** Draws what the file's bytes are, or says why not. */
function drawn(name, file, words) {
    try {
        name.endsWith('.png') ? engine.addMap(name, readPng(name, file)) : engine.addMesh(name, file)
        engine.draw([words + name, '--size=12x12'])
        return ''
    } catch (error) {
        return error.message
    }
}

run([
    [`${count} devices that answer anything are served or refused in a sentence, and closed`, async () => {
        const became = { connected: 0, served: 0, refused: 0 }
        const wrong = await Promise.all(Array.from({ length: count }, () => live(hostile(), became)))
        equal(wrong.filter(text => text).slice(0, 3).join('; '), '', 'devices')
        check(became.served && became.refused && became.connected < count, JSON.stringify(became))
        console.log(`# ${JSON.stringify(became)}`)
        equal(stray.length, 0, `rejections that nobody awaits: ${stray[0]}`)
    }],
    ['a page that stood still for longer than it has patience takes the answers that came meanwhile', async () => {
        const later = answer => new Promise(resolve => { // behind the page's own timers
            setImmediate(resolve, answer)
            queueMicrotask(() => { for (const end = performance.now() + 2 * patience; performance.now() < end;); })
        })
        const statuses = [1, 0] // busy at first
        const device = { open: async () => {}, close: async () => {}, claimInterface: async () => {}, releaseInterface: async () => {},
            configuration: { interfaces: [{ interfaceNumber: 1, alternates: [{ interfaceClass: 255, endpoints: [{ endpointNumber: 2, direction: 'out', type: 'bulk' }] }] }] },
            controlTransferIn: ({ request }) => later(request === 0xa4 || request === 0xa6 ? { status: 'stall' } : { status: 'ok', data: new DataView(Uint8Array.from(request === 0xa0 ? descriptor(240, 240) : [statuses.shift()]).buffer) }),
            transferOut: () => later({ status: 'ok' }), controlTransferOut: () => later({ status: 'ok' }) }
        const pico = await Pico.connect({ getDevices: async () => [device] }, device, bytes => engine.deviceSize(bytes), patience)
        await pico.sendLight(new Uint8Array(16))
        equal(statuses.length, 0, 'statuses that are left')
    }],
    ['a device that opens after it was given up is closed then, unless it is connected again', async () => {
        for (const again of [false, true]) {
            let open, isOpen = false
            const device = hostile()
            Object.assign(device, { open: () => new Promise(resolve => { open = () => { isOpen = true; resolve() } }), close: async () => { isOpen = false },
                claimInterface: async () => {}, releaseInterface: async () => {}, configuration: { interfaces: [{ interfaceNumber: 1, alternates: [{ interfaceClass: 255, endpoints: [{ endpointNumber: 2, direction: 'out', type: 'bulk' }] }] }] },
                controlTransferIn: async ({ request }) => request === 0xa4 ? { status: 'stall' } : { status: 'ok', data: new DataView(Uint8Array.from(request === 0xa0 ? descriptor(240, 240) : [0]).buffer) },
                controlTransferOut: async () => ({ status: 'ok' }) })
            const connect = () => Pico.connect({ getDevices: async () => [device] }, device, bytes => engine.deviceSize(bytes), patience)
            equal(await connect().then(() => '', error => error.message), sentences.notOpened, 'what it says')
            const late = open
            const pico = again ? (device.open = async () => { isOpen = true }, await connect()) : undefined
            late()
            await new Promise(setImmediate)
            equal(isOpen, again, `whether it is open, connected again: ${again}`)
            await pico?.close()
            equal(isOpen, false, 'whether it is open at the end')
        }
    }],
    ['any descriptor is a size that glint shades, or none', () => {
        equal(engine.deviceSize(descriptor(240, 320)), 240 << 16 | 320, 'a display')
        equal(engine.deviceSize(descriptor(sideMax, pixelsMax / sideMax)), (sideMax << 16 | pixelsMax / sideMax) >>> 0, 'the largest')
        for (const [width, height] of [[sideMax, pixelsMax / sideMax + 1], [sideMax + 1, 1], [1, sideMax + 1], [65535, 65535]])
            equal(engine.deviceSize(descriptor(width, height)), 0, `${width}x${height}`)
        for (let i = 0; i < 10000; i++) {
            const at = descriptor(pick(oddNumbers), pick(oddNumbers)), size = (at[below(12)] = below(256), engine.deviceSize(at.subarray(0, below(8) ? 12 : below(12))))
            const width = size >>> 16, height = size & 0xffff
            check(width <= sideMax && height <= sideMax && width * height <= pixelsMax, `${at}: ${width}x${height}`)
        }
    }],
    [`${files} meshes and pictures that hold anything are drawn or refused in a sentence that names them`, () => {
        const became = { drawn: 0, refused: 0 }
        for (let i = 0; i < files; i++) {
            const [name, file, words] = below(4) ? ['a.glb', changed(pick(texts)), '--mesh='] : below(2) ? ['a.stl', changed(meshes['coloured.stl']), '--mesh='] : ['a.png', changed(picture), '--height=']
            const said = drawn(name, file, words)
            check(!said || said.startsWith(`${name}: `), `${said}; the file in base64: ${Buffer.from(file).toString('base64').slice(0, 4000)}`)
            became[said ? 'refused' : 'drawn']++
        }
        check(became.drawn && became.refused, JSON.stringify(became))
        console.log(`# ${JSON.stringify(became)}`)
    }],
    ['nodes that have each other, or a mesh\'s parts or vertices, many times over are refused, not followed', () => {
        const nodes = Array.from({ length: 40 }, (_, i) => i < 39 ? { children: [i + 1, i + 1] } : { mesh: 0 })
        const json = { ...JSON.parse(texts[2].toString()), nodes, scenes: [{ nodes: [0] }] }
        check(drawn('a.gltf', Uint8Array.from(Buffer.from(JSON.stringify(json))), '--mesh=').includes('nodes'), 'it does not say so')
        const { meshes: [{ primitives: [primitive] }] } = json, many = { ...json, meshes: [{ primitives: Array(10000).fill(primitive) }], nodes: Array(8).fill({ mesh: 0 }), scenes: [{ nodes: [0, 1, 2, 3, 4, 5, 6, 7] }] }
        check(drawn('a.gltf', Uint8Array.from(Buffer.from(JSON.stringify(many))), '--mesh=').includes('parts'), 'it does not say so of parts')
        const shared = { ...json, nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }], meshes: [{ primitives: Array(200).fill(primitive) }] }
        shared.accessors = shared.accessors.map(accessor => ({ ...accessor, count: accessor.type === 'SCALAR' ? accessor.count : 1 << 20, byteOffset: 0 }))
        shared.bufferViews = shared.bufferViews.map(view => ({ ...view, byteStride: 0 }))
        check(drawn('a.gltf', Uint8Array.from(Buffer.from(JSON.stringify(shared))), '--mesh=').includes('vertices'), 'it does not say so of vertices')
        const worn = { ...json, nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }], materials: Array(5000).fill({}), meshes: [{ primitives: Array.from({ length: 5000 }, (_, material) => ({ ...primitive, material })) }] }
        check(drawn('a.gltf', Uint8Array.from(Buffer.from(JSON.stringify(worn))), '--mesh=').includes('has 5000 materials'), 'it does not say so of materials')
    }],
    ['a picture whose palette is too short, or is not there, is damaged', () => {
        for (const extra of [[['PLTE', [1, 2, 3]]], []]) {
            const said = drawn('a.png', Uint8Array.from(png({ width: 4, height: 4, type: 3, depth: 8, sample: () => 200, extra })), '--height=')
            equal(said, 'a.png: damaged PNG: its palette is not there, or too short; save it again', 'what it says')
        }
    }],
    ['a picture that has fewer lines than it says is damaged, in words', () => {
        const short = png({ width: 4, height: 4, type: 0, depth: 8, sample: () => 200 })
        short[23] = 9
        short.writeUInt32BE(crc(short.subarray(12, 29)), 29)
        equal(drawn('a.png', Uint8Array.from(short), '--height='), 'a.png: damaged PNG: Unsupported filter; save it again', 'what it says')
    }],
    ['a picture that inflates to more than its pixels is damaged, and is not inflated to its end', () => {
        const bomb = png({ width: 4, height: 4, type: 0, depth: 8, sample: () => 200, behind: 1 << 28 })
        check(bomb.length < 1 << 19, `the file has ${bomb.length} bytes`)
        equal(drawn('a.png', Uint8Array.from(bomb), '--height='), 'a.png: damaged PNG: there is more in it than its pixels; save it again', 'what it says')
        const little = png({ width: 4, height: 4, type: 0, depth: 8, sample: x => 60 * x, behind: 9 })
        equal(drawn('a.png', Uint8Array.from(little), '--height='), '', 'what it says of a few bytes')
    }],
    ['a picture of few bits that is interlaced is told to be so, whatever its lines are', () => {
        const laced = png({ width: 9, height: 9, type: 0, depth: 1, sample: () => 1 })
        laced[28] = 1
        laced.writeUInt32BE(crc(laced.subarray(12, 29)), 29)
        equal(drawn('a.png', Uint8Array.from(laced), '--height='), 'a.png: an interlaced PNG with 1 bits a sample; save it without interlacing', 'what it says')
    }],
    ['a picture that says twice how large it is is damaged', () => {
        const wide = png({ width: 100000, height: 2, type: 0, depth: 8, sample: () => 200 }), small = Buffer.from(wide.subarray(8, 33))
        small.writeUInt32BE(2, 8)
        small.writeUInt32BE(crc(small.subarray(4, 21)), 21)
        equal(drawn('a.png', Uint8Array.from([...wide.subarray(0, 8), ...small, ...wide.subarray(8)]), '--height='), 'a.png: damaged PNG: it says twice how large it is; save it again', 'what it says')
    }],
    ['a colour profile is not inflated, whatever the pixels are', () => {
        const bomb = png({ width: 4, height: 4, type: 0, depth: 8, sample: () => 200, extra: [['iCCP', Buffer.concat([Buffer.from('a\0\0'), Buffer.from('no profile')])]] })
        equal(drawn('a.png', Uint8Array.from(bomb), '--height='), '', 'what it says of a profile')
        const at = bomb.lastIndexOf('IDAT')
        bomb[at + 4] = 255 // no zlib stream begins so
        bomb.writeUInt32BE(crc(bomb.subarray(at, -16)), bomb.length - 16)
        equal(drawn('a.png', Uint8Array.from(bomb), '--height='), 'a.png: damaged PNG: Error while decompressing the data; save it again', 'what it says of pixels')
    }],
    ['textures that are too large together are refused, those of a glTF and those beside an OBJ', () => {
        const half = png({ width: 4097, height: 4096, type: 0, depth: 1, sample: () => 0 }), materials = [0, 1].map(index => ({ pbrMetallicRoughness: { baseColorTexture: { index } } }))
        const part = material => ({ places, normals, uv, indices, material })
        const of = textures => Uint8Array.from(gltf([part(0), part(1)], { materials, textures }, [half, half]))
        const sentence = 'its textures have more than 33554432 pixels together'
        check(drawn('a.glb', of([{ source: 0 }, { source: 1 }]), '--mesh=').startsWith(`a.glb: ${sentence}`), 'a glTF')
        const texts = { 'a.obj': 'mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 'a.mtl': 'newmtl a\nmap_Kd a.png\nnewmtl b\nmap_Kd b.png\n', 'a.png': half, 'b.png': half }
        const obj = together(Object.entries(texts).map(([name, bytes]) => ({ name, bytes: Uint8Array.from(Buffer.from(bytes)) })))
        check(drawn('a.obj', obj, '--mesh=').startsWith(`a.obj: ${sentence}`), 'an OBJ')
    }],
    ['after all that it draws what it drew before', () => {
        engine.addWhite(white, 8, 8)
        const words = ['--scene=coin', '--size=30x20'], before = new Engine(new WebAssembly.Module(readFileSync(`${folder}/module.wasm`))).draw(words)
        equal(Buffer.compare(Buffer.from(engine.draw(words).rgba), Buffer.from(before.rgba)), 0, 'the picture')
    }],
])
