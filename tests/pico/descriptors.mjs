// SPDX-License-Identifier: MIT
// What a device says to browsers, field by field: BOS (USB 3.2, 9.6.2), WebUSB's capability and address, the set by Microsoft's OS 2.0
// specification. Numbers are those of the specifications; every byte has its field.
import { check, equal } from './tap.mjs'

// This interface's own, for ever: programs on Windows find it by that.
const INTERFACE = '{431EE1A2-24A1-4FB2-9563-6735EF483444}'
const WEBUSB = '3408b638-09a9-47a0-8bfd-a0768815b665', MICROSOFT = 'd8dd60df-4589-4cc7-9cd2-659d9e648a9f'

// Takes fields from the front; a length that a descriptor states must be what its fields take.
class Fields {
  constructor(bytes, what) { Object.assign(this, { bytes, what, at: 0 }) }
  byte() { return this.take(1)[0] }
  word() { return this.take(2).readUInt16LE(0) }
  long() { return this.take(4).readUInt32LE(0) }
  take(count) {
    check(this.at + count <= this.bytes.length, `${this.what}: ${this.bytes.length} bytes end within a field`)
    this.at += count
    return this.bytes.subarray(this.at - count, this.at)
  }
  // A UUID: its first three parts are little-endian.
  uuid() {
    const hex = (bytes) => Buffer.from(bytes).toString('hex'), turned = (count) => hex(Buffer.from(this.take(count)).reverse())
    return [turned(4), turned(2), turned(2), hex(this.take(2)), hex(this.take(6))].join('-')
  }
  is(found, expected, field) { equal(found, expected, `${this.what}: ${field}`) }
  done() { equal(this.at, this.bytes.length, `${this.what}: bytes that have a field`) }
}

// { webusb: { vendorCode, landingPage }, microsoft: { vendorCode, bytes } }, and what they must be is checked.
export function bosOf(host) {
  const get = (length) => host.control(0x80, 6, 15 << 8, 0, length)
  const head = get(5)
  if (head === null) return null
  const bos = new Fields(get(head.readUInt16LE(2)), 'BOS'), found = {}
  bos.is(bos.byte(), 5, 'bLength')
  bos.is(bos.byte(), 15, 'bDescriptorType')
  bos.is(bos.word(), bos.bytes.length, 'wTotalLength')
  for (let left = bos.byte(); left > 0; left--) {
    const length = bos.bytes[bos.at], capability = new Fields(bos.take(length), 'a capability')
    capability.is(capability.byte(), length, 'bLength')
    capability.is(capability.byte(), 16, 'bDescriptorType, DEVICE CAPABILITY')
    capability.is(capability.byte(), 5, 'bDevCapabilityType, PLATFORM')
    capability.is(capability.byte(), 0, 'bReserved')
    const uuid = capability.uuid()
    if (uuid === WEBUSB) {
      capability.is(capability.word(), 0x0100, 'bcdVersion of WebUSB')
      found.webusb = { vendorCode: capability.byte(), landingPage: capability.byte() }
    } else {
      capability.is(uuid, MICROSOFT, 'PlatformCapabilityUUID')
      capability.is(capability.long(), 0x06030000, 'dwWindowsVersion')
      found.microsoft = { bytes: capability.word(), vendorCode: capability.byte() }
      capability.is(capability.byte(), 0, 'bAltEnumCode')
    }
    capability.done()
  }
  bos.done()
  return found
}

// The address that GET_URL gives for a landing page; null: STALL.
export function landingPageOf(host, vendorCode, landingPage) {
  const bytes = host.control(0xc0, vendorCode, landingPage, 2, 255)
  if (bytes === null) return null
  const url = new Fields(bytes, 'the URL')
  url.is(url.byte(), bytes.length, 'bLength')
  url.is(url.byte(), 3, 'bDescriptorType')
  const scheme = { 0: 'http://', 1: 'https://', 255: '' }[url.byte()]
  check(scheme !== undefined, 'the URL: an unknown bScheme')
  return scheme + url.take(bytes.length - 3).toString('utf8')
}

// The set: which interface WinUSB gets, and the names under which programs find it.
export function microsoftSetOf(host, { vendorCode, bytes: expected }) {
  const bytes = host.control(0xc0, vendorCode, 0, 7, 4096)
  const set = new Fields(bytes, 'the set'), utf16 = (count) => set.take(count).toString('utf16le')
  equal(bytes.length, expected, 'bytes of the set, which BOS has told')
  const head = (length, type, name) => {
    set.is(set.word(), length, `wLength of ${name}`)
    set.is(set.word(), type, `wDescriptorType of ${name}`)
  }
  head(10, 0, 'the set')
  set.is(set.long(), 0x06030000, 'dwWindowsVersion')
  set.is(set.word(), bytes.length, 'wTotalLength')
  head(8, 1, 'the configuration')
  set.is(set.byte(), 0, 'bConfigurationValue, by which Windows means the first one')
  set.is(set.byte(), 0, 'bReserved')
  set.is(set.word(), bytes.length - 10, 'wTotalLength of the configuration')
  head(8, 2, 'the function')
  const firstInterface = set.byte()
  set.is(set.byte(), 0, 'bReserved')
  set.is(set.word(), bytes.length - 18, 'wSubsetLength of the function')
  head(20, 3, 'the compatible ID')
  const compatible = set.take(8).toString('latin1'), sub = set.take(8).toString('latin1')
  head(bytes.length - 46, 4, 'the property')
  set.is(set.word(), 7, 'wPropertyDataType, a list of texts')
  const name = utf16(set.word()), guids = utf16(set.word())
  set.done()
  return { firstInterface, compatible, sub, name, guids }
}

// All that a device with an interface for light says: Windows has WinUSB for that one alone, and browsers offer the address, if any.
export function examineOffer(host, address = null) {
  const { webusb, microsoft } = bosOf(host)
  equal(webusb.vendorCode, 1, 'bVendorCode of WebUSB')
  equal(webusb.landingPage, address === null ? 0 : 1, 'iLandingPage')
  equal(landingPageOf(host, webusb.vendorCode, webusb.landingPage), address, 'the landing page')
  equal(microsoft.vendorCode, 2, 'bMS_VendorCode')
  const set = microsoftSetOf(host, microsoft)
  equal(set.firstInterface, 1, 'bFirstInterface')
  equal(set.compatible, 'WINUSB\0\0', 'the compatible ID')
  equal(set.sub, '\0'.repeat(8), 'the sub-compatible ID')
  equal(set.name, 'DeviceInterfaceGUIDs\0', 'the property')
  equal(set.guids, `${INTERFACE}\0\0`, 'the GUIDs')
}

// A test of examineOffer: replays what the device answers with one fault each time. Returns the number of faults, and those that
// it did not find: every bit of every answer, an answer that is a byte shorter, or refused.
export function faultsInOffer(host, address = null) {
  const answers = new Map(), request = (type, code, value, index) => [type, code, value, index].join(' ')
  const replay = { control: (type, code, value, index, length) => answers.get(request(type, code, value, index))?.subarray(0, length) ?? null }
  const finds = () => { try { examineOffer(replay, address); return false } catch { return true } }
  examineOffer({ control(type, code, value, index, length) {
    const bytes = host.control(type, code, value, index, length), key = request(type, code, value, index)
    if (bytes !== null && bytes.length >= (answers.get(key)?.length ?? 0)) answers.set(key, Buffer.from(bytes))
    return bytes
  } }, address)
  check(!finds(), 'what the device answered is not what is replayed')
  let count = 0
  const unseen = []
  for (const [key, right] of [...answers]) {
    const put = (what, wrong) => {
      wrong === null ? answers.delete(key) : answers.set(key, wrong)
      count++
      if (!finds()) unseen.push(`${key}: ${what}`)
      answers.set(key, right)
    }
    for (let bit = 0; bit < 8 * right.length; bit++) {
      const wrong = Buffer.from(right)
      wrong[bit >> 3] ^= 1 << (bit & 7)
      put(`bit ${bit & 7} of byte ${bit >> 3}`, wrong)
    }
    put('a byte less', right.subarray(0, -1))
    put('refused', null)
  }
  return { count, unseen }
}
