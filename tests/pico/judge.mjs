// SPDX-License-Identifier: MIT
// The program judge: what a panel shows after a transcript of its pins, and what the demo should show.
import { execFileSync } from 'node:child_process'
import { check } from './tap.mjs'

export class Judge {
  constructor(program, panel) {
    const [, controller, width, height] = /^(\w+)-(\d+)x(\d+)$/.exec(panel)
    Object.assign(this, { program, controller, width: +width, height: +height })
  }
  call(args, input) {
    return execFileSync(this.program, args.map(String), { input, maxBuffer: 1 << 26 })
  }
  look(transcript) { return this.call(['look', this.controller, this.width, this.height], transcript) }
  demo(frame) { return this.call(['demo', this.width, this.height, frame], '') }
  lit(frame) { return this.call(['lit', this.width, this.height, frame], '') }
  exact(frame) { return this.call(['exact', this.width, this.height, frame], '') }
  teapot(frame) { return this.call(['teapot', this.width, this.height, frame], '') }
  fault(number) { return this.call(['fault', this.width, this.height, number], '') }
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
