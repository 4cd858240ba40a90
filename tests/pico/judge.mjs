// SPDX-License-Identifier: MIT
// The program judge: what a panel shows after a transcript of its pins, and what the demo should show.
import { execFileSync } from 'node:child_process'
import { boardOf } from './pico.mjs'
import { check } from './tap.mjs'

// FOLDER: the image's, whose name says how its picture is turned; none: it is upright on its board.
export class Judge {
  constructor(program, panel, folder = '') {
    const [, controller, ...sides] = /^(\w+)-(\d+)x(\d+)$/.exec(panel)
    const turned = Number(/-turned-(\d+)/.exec(folder)?.[1] ?? 0) / 90
    const [width, height] = (turned % 2 ? sides.reverse() : sides).map(Number)
    const board = boardOf(folder, panel)
    const rotation = (turned + (turned % 2 ? height > width : width > height) + board.turn) % 4
    Object.assign(this, { program, controller, width, height, rotation, board, is_round: controller === 'gc9a01' || panel === 'co5300-466x466' })
  }
  call(args, input) {
    return execFileSync(this.program, args.map(String), { input, maxBuffer: 1 << 26 })
  }
  look(transcript) { return this.call(['look', this.controller, this.width, this.height, this.rotation], transcript) }
  // All of the glass, of which the picture is the middle.
  look_around(transcript, width, height) { return this.call(['look', this.controller, width, height, 0], transcript) }
  picture(args) { return this.seen(this.call(args, '')) }
  // What is seen of a picture: of a round glass the pixels that its circle touches.
  seen(rgb) {
    if (!this.is_round) return rgb
    const { width } = this, edge = (at) => Math.abs(2 * at + 1 - width) - 1
    for (let i = 0; i < rgb.length / 3; i++) {
      if (edge(i % width) ** 2 + edge(Math.floor(i / width)) ** 2 >= width ** 2) rgb.fill(0, 3 * i, 3 * i + 3)
    }
    return rgb
  }
  demo(frame) { return this.picture(['demo', this.width, this.height, frame]) }
  lit(frame) { return this.picture(['lit', this.width, this.height, frame]) }
  exact(frame) { return this.picture(['exact', this.width, this.height, frame]) }
  teapot(frame) { return this.picture(['teapot', this.width, this.height, frame]) }
  scene(name, to_light) { return this.picture(['scene', name, this.width, this.height, ...to_light]) }
  palette(name, to_light) { return this.picture(['palette', name, this.width, this.height, ...to_light]) }
  fault(number) { return this.picture(['fault', this.width, this.height, number]) }
  lz4(bytes) { return this.call(['lz4'], bytes) }
  map() { return this.call(['map', this.width, this.height], '') }
  material() { return this.call(['material'], '') }
  light(frame) { return this.call(['light', frame], '') }
  // The first difference told.
  same(found, expected, what) {
    check(found.length === expected.length, `${what}: ${found.length} bytes, expected ${expected.length}`)
    let count = 0, first = -1
    for (let i = 0; i < found.length; i += 3) {
      if (found.compare(expected, i, i + 3, i, i + 3) === 0) continue
      if (count++ === 0) first = i / 3
    }
    check(count === 0, `${what}: ${count} pixels differ, the first at ${first % this.width}, ${Math.floor(first / this.width)}`)
  }
}
