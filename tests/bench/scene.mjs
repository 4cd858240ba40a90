// SPDX-License-Identifier: MIT
// A sphere of 60 % of 320x240 pixels, lit from (1, 1, 1), seen from far in front: its Q1.15 normals, as a shader has them.
const W = 320, H = 240, RADIUS = 120.9
const SAMPLES = 2000

const q15 = (v) => {
  const length = Math.hypot(...v)
  return v.map((x) => Math.min(32767, Math.round(x / length * 32768)))
}
const LIGHT = [1, 1, 1].map((x) => x / Math.sqrt(3))
const HALF = q15([LIGHT[0], LIGHT[1], LIGHT[2] + 1])

// c and t as glint.h forms them, of pixels where c >= cMin: evenly chosen ones where there are very many.
export function highlight(cMin) {
  const pixels = []
  for (let j = 0; j < H; j++) {
    for (let i = 0; i < W; i++) {
      const x = (i + .5 - W / 2) / RADIUS, y = (H / 2 - j - .5) / RADIUS, z2 = 1 - x * x - y * y
      if (z2 <= 0) continue
      const normal = q15([x, y, Math.sqrt(z2)])
      const dot = normal.reduce((sum, v, k) => sum + v * HALF[k], 0)
      const c = Math.min(65536, Math.round(dot / 16384))
      const t = Math.floor(normal.reduce((sum, v, k) => sum + (v - HALF[k]) ** 2, 0) / 2)
      if (c >= cMin) pixels.push({ c, t })
    }
  }
  const step = Math.max(1, pixels.length / SAMPLES)
  return Array.from({ length: Math.floor(pixels.length / step) }, (_, k) => pixels[Math.floor(k * step)])
}
