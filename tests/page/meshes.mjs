// SPDX-License-Identifier: MIT
// Binary STL files from formulas.

/** triangles: each three places; comment: at most 80 characters; colour(i): the two bytes after triangle i. */
export function stl(triangles, comment = '', colour = () => 0) {
    const out = Buffer.alloc(84 + 50 * triangles.length)
    out.write(comment, 'latin1')
    out.writeUInt32LE(triangles.length, 80)
    triangles.forEach((places, i) => {
        places.flat().forEach((value, k) => out.writeFloatLE(value, 84 + 50 * i + 12 + 4 * k))
        out.writeUInt16LE(colour(i), 84 + 50 * i + 48)
    })
    return out
}

/** A ring around the z axis, of so many quadrilaterals around and across, with a square side: smooth and sharp edges. */
export function ring(around = 24, across = 10) {
    const place = (i, k) => {
        const a = 2 * Math.PI * i / around, b = 2 * Math.PI * k / across
        const r = 3 + Math.max(-.8, Math.cos(b)), z = Math.min(.7, Math.sin(b))
        return [r * Math.cos(a), r * Math.sin(a), z]
    }
    const triangles = []
    for (let i = 0; i < around; i++)
        for (let k = 0; k < across; k++)
            triangles.push([place(i, k), place(i + 1, k), place(i + 1, k + 1)], [place(i, k), place(i + 1, k + 1), place(i, k + 1)])
    return triangles
}

/** Files, by name. */
export const meshes = {
    'ring.stl': stl(ring()),
    'coloured.stl': stl(ring(9, 5), 'made of COLOR=' + String.fromCharCode(30, 90, 200, 255)),
    'facets.stl': stl(ring(9, 5), 'COLOR=' + String.fromCharCode(30, 90, 200, 255), i => i % 2 ? 0x8000 | 31 * i : 0),
}

// ---- OBJ: a ball as triangles, quadrilaterals and polygons, with what a line may have ----

const lines = (word, list, more = () => '') => list.map((values, i) => `${word} ${values.map(v => v.toFixed(6)).join(' ')}${more(i)}\n`).join('')
const quads = (around, across) => Array.from({ length: around * across }, (_, i) => {
    const from = Math.floor(i / around) * (around + 1) + i % around + 1
    return [from, from + around + 1, from + around + 2, from + 1]
})
const { places, normals, uv, colors } = ball(), count = places.length
const faces = corner => quads(16, 9).map(quad => `f ${quad.map(corner).join(' ')}\n`).join('')
const gear = Array.from({ length: 40 }, (_, i) => [Math.cos(i * Math.PI / 20), Math.sin(i * Math.PI / 20), 0].map(v => v * [1, .7, .9, .5][i % 4]))
/** Files, by name. */
export const objs = {
    'plain.obj': lines('v', places) + faces(i => i),
    'whole.obj': lines('v', places) + lines('vt', uv) + lines('vn', normals) + faces(i => `${i}/${i}/${i}`),
    'colours.obj': lines('v', places, i => ` ${colors[i].join(' ')}`) + lines('vn', normals) + faces(i => `${i}//${i}`),
    'spelled.obj': '\ufeff# made\r\n' + lines('v', places, i => ['', ' # v', ' 1.', ' \\\r\n'][i % 4]).replace(/ 0\./g, ' +.').replace(/-0\./g, '-.').replace(/ (\d)\.(\d{6})/g, ' $1$2e-6').replace(/\n/g, '\r\n') + 'o a\ng b\ns off\nl 1 2\n' + faces(i => i - count - 1),
    'gear.obj': lines('v', gear) + lines('v', gear.map(([x, y]) => [x, y, -.3])) + `f ${gear.map((_, i) => i + 1).join(' ')}\nf ${gear.map((_, i) => 80 - i).join(' ')}\n` + gear.map((_, i) => `f ${i + 1} ${i + 41} ${(i + 1) % 40 + 41} ${(i + 1) % 40 + 1}\n`).join(''),
}

/** What lies together: an OBJ in two materials, of which one wears a picture, its MTL and the picture. */
export const clothed = picture => ({
    'clothed.obj': 'mtllib things/clothed.mtl\nusemtl cloth\n' + objs['whole.obj'] + 'usemtl red\n' + faces(i => `${i}/${i}/${i}`).split('\n').slice(0, 40).join('\n') + '\n',
    'clothed.mtl': 'newmtl cloth\nKd 1 1 1\nKs 1 .9 .6\nNs 80\nmap_Kd cloth.png\nnewmtl red\nKd .8 .1 .1\nNs 12\n',
    'cloth.png': picture,
})

// ---- glTF: a ball of so many quadrilaterals, with all that a primitive may have ----

const kinds = { 5121: [1, 'writeUInt8'], 5123: [2, 'writeUInt16LE'], 5125: [4, 'writeUInt32LE'], 5126: [4, 'writeFloatLE'] }

/** parts: each { material, places, and as they are wanted normals, uv, colors, colorKind, indices, indexKind }; more: of the JSON, with images as
 *  PNG files in `pictures`, and `placed`: how the nodes of parts stand, then other nodes. */
export function gltf(parts, more = {}, pictures = [], isText = false) {
    const pieces = [], json = { asset: { version: '2.0' }, bufferViews: [], accessors: [], ...more }
    let length = 0
    const view = bytes => {
        const padded = Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3)])
        json.bufferViews.push({ buffer: 0, byteOffset: length, byteLength: bytes.length })
        pieces.push(padded)
        length += padded.length
        return json.bufferViews.length - 1
    }
    const accessor = (list, kind, extra = {}) => {
        const size = Array.isArray(list[0]) ? list[0].length : 1, [width, write] = kinds[kind], bytes = Buffer.alloc(list.length * size * width)
        list.flat().forEach((value, i) => bytes[write](value, i * width))
        json.accessors.push({ bufferView: view(bytes), componentType: kind, count: list.length, type: ['', 'SCALAR', 'VEC2', 'VEC3', 'VEC4'][size], ...extra })
        return json.accessors.length - 1
    }
    const box = places => ({ min: [0, 1, 2].map(k => Math.min(...places.map(place => Math.fround(place[k])))), max: [0, 1, 2].map(k => Math.max(...places.map(place => Math.fround(place[k])))) })
    json.meshes = parts.map(({ material, places, normals, uv, colors, colorKind = 5126, indices, indexKind = 5123 }) => ({
        primitives: [{
            material, indices: indices && accessor(indices, indexKind),
            attributes: {
                POSITION: accessor(places, 5126, box(places)), ...normals && { NORMAL: accessor(normals, 5126) }, ...uv && { TEXCOORD_0: accessor(uv, 5126) },
                ...colors && { COLOR_0: accessor(colors, colorKind, colorKind === 5126 ? {} : { normalized: true }) },
            },
        }],
    }))
    const { placed = [] } = more
    delete json.placed
    json.nodes = json.meshes.map((_, mesh) => ({ mesh, ...placed[mesh] }))
    json.scenes = [{ nodes: json.nodes.map((_, i) => i) }]
    json.nodes.push(...placed.slice(json.meshes.length))
    json.scene = 0
    if (pictures.length)
        json.images = pictures.map((bytes, i) => isText ? { uri: `data:image/png;base64,${bytes.toString('base64')}` } : { bufferView: view(bytes), mimeType: 'image/png', name: `picture ${i}` })
    const held = Buffer.concat(pieces)
    json.buffers = [{ byteLength: held.length, ...isText && { uri: `data:application/octet-stream;base64,${held.toString('base64')}` } }]
    if (isText)
        return Buffer.from(JSON.stringify(json))
    const text = Buffer.from(JSON.stringify(json)), head = Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')])
    const out = Buffer.alloc(12 + 8 + head.length + 8)
    out.write('glTF')
    out.writeUInt32LE(2, 4)
    out.writeUInt32LE(out.length + held.length, 8)
    out.writeUInt32LE(head.length, 12)
    out.write('JSON', 16)
    head.copy(out, 20)
    out.writeUInt32LE(held.length, 20 + head.length)
    out.write('BIN\0', 24 + head.length, 'latin1')
    return Buffer.concat([out, held])
}

/** about: its middle; around: how fine. */
export function ball(about = [0, 0, 0], radius = 1, around = 16, across = 9) {
    const places = [], normals = [], uv = [], colors = [], indices = []
    for (let k = 0; k <= across; k++)
        for (let i = 0; i <= around; i++) {
            const a = 2 * Math.PI * i / around, b = Math.PI * k / across, normal = [Math.sin(b) * Math.sin(a), Math.cos(b), Math.sin(b) * Math.cos(a)]
            normals.push(normal)
            places.push(normal.map((v, at) => about[at] + radius * v))
            uv.push([1.7 * i / around - .2, k / across])
            colors.push([i / around, k / across, .5])
            if (i < around && k < across) {
                const from = k * (around + 1) + i
                indices.push(from, from + around + 1, from + around + 2, from, from + around + 2, from + 1)
            }
        }
    return { places, normals, uv, colors, indices }
}
