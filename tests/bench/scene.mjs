// SPDX-License-Identifier: MIT
// What scene/scene.c has written, and the exact pictures that it draws.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'

// As glint.h lists them.
const header = readFileSync(new URL('../../lib/glint.h', import.meta.url), 'utf8')
export const MODELS = [...header.matchAll(/^ +X\(GLINT_\w+, (\w+), /mg)].map((match) => match[1])
export const SPACES = ['gamma', 'linear']
export const FORMATS = ['rgb565', 'rgb565 swapped', 'rgb888', 'grey8', 'mono', 'bgr888', 'xrgb8888', 'argb8888', 'grey4', 'grey2']
const MAPS = ['int16', 'int8', 'palette-offsets'] // enum bench_map
export const LINE_BYTES = [2, 2, 3, 1, 1 / 8, 3, 4, 4, 1 / 2, 1 / 4]

export function readScene(folder) {
  const { width, height, q, covered, n, scenes, scene_n: sceneN, side_lines: sideLines } = JSON.parse(readFileSync(`${folder}/scene.json`, 'utf8'))
  const maps = MAPS.map((name) => readFileSync(`${folder}/${name}.bin`))
  const palette = readFileSync(`${folder}/palette.bin`), normals = maps[0]
  // A scene's lines: of int16 normals and, for map 1, of int8.
  const stored = MAPS.slice(0, 2).map((name) => readFileSync(`${folder}/lines-${name}.bin`))
  const lines = (which, map) => stored.slice(0, 1 + map).map((bytes, i) => {
    const line = (i ? 4 : 6) * width, count = bytes.length / line / scenes.length, first = scenes.indexOf(which) * count
    return Array.from({ length: count }, (_, k) => bytes.subarray((first + k) * line, (first + k + 1) * line))
  })
  const samples = new Map(n.map((k) => [k, []]))
  for (const line of readFileSync(`${folder}/samples.txt`, 'utf8').trim().split('\n')) {
    const [k, c, t] = line.split(' ').map(Number)
    samples.get(k).push({ c, t })
  }
  const covers = (x, y) => normals.readInt32LE(6 * (y * width + x)) !== 0 || normals.readInt16LE(6 * (y * width + x) + 4) !== 0
  const pictures = new Map()
  const exact = (...choice) => { // n, and a look's fields (sphere.h)
    const key = choice.join(' ')
    if (!pictures.has(key)) pictures.set(key, execFileSync(`${folder}/scene`, ['exact', ...choice.map(String)]))
    return pictures.get(key)
  }
  const real = (n, model, ts) => { // the model's place in the list; in double precision, at each t
    const input = ts.map((t) => `${t * 2 ** 30}\n`).join('')
    return execFileSync(`${folder}/scene`, ['real', n, model].map(String), { input, encoding: 'utf8' }).trim().split('\n').map(Number)
  }
  return { width, height, q, covered, n, scenes, sceneN, sideLines, lines, maps, palette, samples, covers, exact, real }
}

// A pixel's levels of 255: three, or one.
export function levels(format, line, x) {
  if (format === 2) return [line[3 * x], line[3 * x + 1], line[3 * x + 2]]
  if (format === 3) return [line[x]]
  if (format === 8) return [(line[x >> 1] >> (x & 1 ? 0 : 4) & 15) * 17]
  if (format === 4) return [line[x >> 3] & 128 >> (x & 7) ? 255 : 0]
  const v = format === 0 ? line.readUInt16LE(2 * x) : line.readUInt16BE(2 * x)
  return [(v >> 11) * 255 / 31, (v >> 5 & 63) * 255 / 63, (v & 31) * 255 / 31]
}
