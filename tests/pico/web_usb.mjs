// SPDX-License-Identifier: MIT
// WebUSB in node, as the page's transport has it in a browser: the package usb, on the kernel's usbfs.
import { createRequire } from 'node:module'
import { resolve } from 'node:path'
import { HANGS } from './tap.mjs'

export function webUsb(packages) {
  const { WebUSB } = createRequire(resolve(packages, 'x'))('usb')
  return new WebUSB({ allowAllDevices: true })
}

// Where the package differs from WebUSB: a STALL is an error, not the transfer's status; and a transfer ends after a second, which the
// emulated board may need, if not told otherwise.
export function conforming(device) {
  return new Proxy(device, { get(_, name) {
    const value = device[name]
    if (typeof value !== 'function') return value
    if (!/ransfer(In|Out)$/.test(name)) return value.bind(device)
    return (...args) => value.apply(device, [...args, 1000 * HANGS]).catch((error) => {
      if (/stall(ed)?$/i.test(error.message)) return { status: 'stall' }
      throw error
    })
  } })
}

// A canvas's bytes as the judge has them.
export function asRgb(rgba) {
  const pixels = rgba.length / 4, rgb = Buffer.alloc(3 * pixels)
  for (let i = 0; i < pixels; i++) rgba.subarray(4 * i, 4 * i + 3).forEach((level, k) => { rgb[3 * i + k] = level })
  return rgb
}
