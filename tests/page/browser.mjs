// SPDX-License-Identifier: MIT
// A page in a headless browser, and what tests ask of it.
import { createRequire } from 'node:module'
import { resolve } from 'node:path'
import { pathToFileURL } from 'node:url'
import { HANGS, until } from '../pico/tap.mjs'

const programs = { chromium: ['chromium'], firefox: ['firefox-esr'] }
// Firefox 140 compiles to AVX and SSE instructions mixed. Where the C library's copies have used wide registers, that code takes up to
// 100 times as long on some processors, so the copies are to use none.
const narrow = { ...process.env, GLIBC_TUNABLES: 'glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX512BW,-AVX2' }

export class Browser {
    /** Console errors and exceptions so far. */
    wrong = []

    static async open(packages, name, file) {
        const puppeteer = createRequire(resolve(packages, 'package.json'))('puppeteer-core')
        const it = new Browser()
        it.browser = await puppeteer.launch({
            browser: name === 'firefox' ? 'firefox' : 'chrome', executablePath: `/usr/bin/${programs[name][0]}`, headless: true,
            timeout: 1000 * HANGS, protocolTimeout: 1000 * HANGS, env: name === 'firefox' ? narrow : process.env,
            args: name === 'firefox' ? [] : ['--no-sandbox', '--disable-dev-shm-usage'], // the tests may run as root
        })
        it.page = await it.browser.newPage()
        it.page.setDefaultTimeout(1000 * HANGS)
        it.page.on('console', message => message.type() === 'error' && it.wrong.push(message.text()))
        it.page.on('pageerror', error => it.wrong.push(error.message))
        it.url = pathToFileURL(file).href
        // What would be downloaded, in place of a folder; workers, whose answers stay away once one isHeld.
        await it.page.evaluateOnNewDocument(() => {
            globalThis.workers = []
            globalThis.Worker = class extends Worker {
                constructor(...of) {
                    super(...of)
                    globalThis.workers.push(this)
                }
                set onmessage(then) {
                    super.onmessage = event => this.isHeld || then(event)
                }
            }
            const { setTimeout: plain } = globalThis // that of a tilt that no sensor tells never ends, so that tests tell it when they do
            globalThis.setTimeout = (then, ms, ...rest) => ms === 1500 ? 0 : plain(then, ms, ...rest)
            globalThis.saved = []
            const make = URL.createObjectURL
            const blobs = new Map()
            URL.createObjectURL = blob => {
                const url = make.call(URL, blob)
                blobs.set(url, blob)
                return url
            }
            const click = HTMLAnchorElement.prototype.click
            HTMLAnchorElement.prototype.click = function () {
                if (!this.download)
                    return click.call(this)
                blobs.get(this.href).arrayBuffer().then(bytes => {
                    let text = ''
                    for (const byte of new Uint8Array(bytes))
                        text += String.fromCharCode(byte)
                    globalThis.saved.push({ name: this.download, base64: btoa(text) })
                })
            }
        })
        return it
    }

    /** Until it holds in the page; puppeteer's own wait is text to eval there, which the page's policy refuses in Firefox before 150. */
    until(condition, ...values) {
        return until(() => this.page.evaluate(condition, ...values), () => condition)
    }

    /** Firefox before 150 knows sizes, but not orientations, which puppeteer sets with them. */
    async resize(width, height) {
        await this.page.setViewport({ width, height }).catch(error => {
            if (!error.message.includes('setScreenOrientationOverride'))
                throw error
        })
        await this.until((width, height) => innerWidth === width && innerHeight === height, width, height)
    }

    async go(fragment = '') {
        await this.page.goto('about:blank')
        await this.page.goto(this.url + (fragment && '#' + fragment))
        await this.until(() => document.body.dataset.drawn !== undefined)
    }

    /** Draws each fragment in turn: { width, height, rgba, refusal }. Told by the event alone, since to go there takes longer than to
     *  draw; unseen also saves the browser's painting, which takes longer still: the canvas has the same pixels. */
    async draw(fragments, unseen = false) {
        const pictures = await this.page.evaluate(async (fragments, unseen) => {
            const out = []
            document.body.style.display = unseen ? 'none' : ''
            for (const fragment of fragments) {
                if (document.body.dataset.drawn !== fragment) {
                    dispatchEvent(new HashChangeEvent('hashchange', { newURL: location.href.replace(/#.*/, '') + '#' + fragment }))
                    while (document.body.dataset.drawn !== fragment)
                        await new Promise(resolve => setTimeout(resolve, 1))
                }
                const canvas = document.getElementById('canvas'), { width, height } = canvas
                const { data } = canvas.getContext('2d').getImageData(0, 0, width, height)
                let text = ''
                for (let i = 0; i < data.length; i += 8192)
                    text += String.fromCharCode(...data.subarray(i, i + 8192))
                const refusal = document.getElementById('refusal')
                out.push({ width, height, base64: btoa(text), refusal: refusal.hidden ? '' : refusal.textContent })
            }
            document.body.style.display = ''
            return out
        }, fragments, unseen)
        return pictures.map(({ base64, ...rest }) => ({ ...rest, rgba: Buffer.from(base64, 'base64') }))
    }

    /** Shows a group of controls. */
    async tab(name) {
        await this.page.evaluate(name => document.getElementById(`tab-${name}`).click(), name)
    }

    /** Shows what experts are told, once all of it is there. */
    async expert() {
        await this.tab('expert')
        await this.until(() => document.body.dataset.rested !== undefined && document.querySelectorAll('#extent dt').length === 5)
    }

    /** What the canvas shows, once the state that the page has is drawn. */
    async now() {
        await this.until(() => document.body.dataset.drawn === document.body.dataset.state)
        const fragment = await this.page.evaluate(() => document.body.dataset.drawn)
        const [picture] = await this.draw([fragment])
        return { ...picture, fragment }
    }

    /** Drops files: name -> bytes. */
    async drop(files) {
        const list = Object.entries(files).map(([name, bytes]) => ({ name, base64: Buffer.from(bytes).toString('base64') }))
        await this.page.evaluate(list => {
            const transfer = new DataTransfer()
            for (const { name, base64 } of list)
                transfer.items.add(new File([Uint8Array.from(atob(base64), c => c.charCodeAt(0))], name))
            for (const type of ['dragover', 'drop'])
                document.body.dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }))
        }, list)
    }

    /** Presses a button and returns the files that it saves. */
    async save(id, count) {
        await this.page.evaluate(id => {
            globalThis.saved = []
            document.getElementById(id).click()
        }, id)
        await this.until(count => globalThis.saved.length === count, count)
            .catch(async () => { throw new Error(`${id}: ${await this.text('file-status')}`) })
        const saved = await this.page.evaluate(() => globalThis.saved)
        return Object.fromEntries(saved.map(({ name, base64 }) => [name, Buffer.from(base64, 'base64')]))
    }

    text(id) {
        return this.page.evaluate(id => document.getElementById(id).textContent, id)
    }

    /** Sets an input as a user does. */
    set(id, value) {
        return this.page.evaluate((id, value) => {
            const input = document.getElementById(id)
            if (typeof value === 'boolean')
                input.checked = value
            else
                input.value = value
            input.dispatchEvent(new Event('input', { bubbles: true }))
            input.dispatchEvent(new Event('change', { bubbles: true }))
        }, id, value)
    }

    close() {
        return this.browser.close()
    }
}
