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
