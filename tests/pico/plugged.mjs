// SPDX-License-Identifier: MIT
// The emulated board, plugged into the lab's kernel by USB/IP: emulated and served while something is awaited. Emulator, kernel and
// programs take turns here, so nothing may wait for the board without serve. The guest's time passes as they work (guest --time basic), so
// that no limit of the kernel's or of a program's is reached because the machine stands still.
import { spawn } from 'node:child_process'
import { createServer, connect } from 'node:net'
import { writeFileSync } from 'node:fs'
import { Pico } from './pico.mjs'
import { HANGS, check, equal } from './tap.mjs'
import { UsbHost } from './usb_host.mjs'
import { UsbIp } from './usbip.mjs'

const VHCI = '/sys/devices/platform/vhci_hcd.0', PORT = 0, DEVICE_ID = 1, SPEED_FULL = 2

export class Plugged {
  // done(endpoint) is called after each bulk transfer; fit(pico) puts on the board, before it runs, what is on it beside the panel.
  constructor(packages, folder, judge, done, fit = () => {}) {
    Object.assign(this, { judge, done, pico: new Pico(packages, { pins: judge.board.pins }).load(`${folder}/glint.uf2`) })
    fit(this.pico)
    this.host = new UsbHost(this.pico)
    this.start()
  }
  start() {
    const { pico, host } = this
    check(pico.run(() => /relighting|turning a mesh/.test(pico.uart), 3000), pico.uart)
    check(pico.run(() => host.pulled_up, 100), 'the device does not pull up')
    host.reset()
  }
  // On the socket that the program attach has plugged in already.
  attached(socket = 3) {
    this.bridge = new UsbIp(this.host, socket, this.done)
    return this
  }
  // Plugs it in, as attach does; the kernel takes one end of a socket pair.
  async plug() {
    const path = `${process.env.TMPDIR ?? '/tmp'}/usbip`, server = createServer()
    const end = await new Promise((resolve) => {
      server.once('connection', resolve)
      server.listen(path, () => { this.kernels = connect(path).pause() })
    })
    server.close()
    this.attached(end)
    writeFileSync(`${VHCI}/attach`, `${PORT} ${this.kernels._handle.fd} ${DEVICE_ID} ${SPEED_FULL}`)
    this.kernels.destroy() // the kernel holds it
  }
  unplug() {
    writeFileSync(`${VHCI}/detach`, `${PORT}`)
    this.host.reset()
  }
  // What the panel shows.
  look() {
    this.pico.run(() => false, 1)
    return this.judge.look(this.pico.wires.transcript())
  }
  // Emulates and serves the kernel until done().
  async serve(done, what) {
    const end = Date.now() + 1000 * HANGS
    for (;;) {
      if (await done()) return
      check(Date.now() < end, `${what}: not in ${HANGS} s; the board says ${JSON.stringify(this.pico.uart)}`)
      // Virtual time passes by timers; in real time a millisecond's timer waits for the kernel's tick, ten times as long.
      if (!this.bridge.step()) this.pico.run(() => false, this.in_real_time ? 0.5 : 1)
      await new Promise((resolve) => this.in_real_time ? setImmediate(resolve) : setTimeout(resolve, 1))
    }
  }
  // The same until a promise is kept; its value or its error.
  async during(promise, what) {
    let outcome
    promise.then((value) => { outcome = { value } }, (error) => { outcome = { error } })
    await this.serve(() => outcome, what)
    if (outcome.error) throw outcome.error
    return outcome.value
  }
  // A program that runs meanwhile: { child, text, status }.
  start_command(words) {
    const child = spawn(words[0], words.slice(1), { stdio: ['ignore', 'pipe', 'pipe'] })
    const command = { child, text: '', status: undefined }
    child.stdout.on('data', (bytes) => { command.text += bytes })
    child.stderr.on('data', (bytes) => { command.text += bytes })
    child.on('close', (code) => { command.status = code })
    return command
  }
  async command(words, status = 0) {
    const command = this.start_command(words)
    try { await this.serve(() => command.status !== undefined, words.join(' ')) } finally { if (command.status === undefined) command.child.kill() }
    equal(command.status, status, `the exit status of ${words.join(' ')}, which says ${JSON.stringify(command.text)}`)
    return command.text
  }
}
