// SPDX-License-Identifier: MIT
// picture.mjs NPM PAGE OUT.png: the page in Chromium at 1366x900, with the coin, as the READMEs show it.
import { Browser } from './browser.mjs'

const [packages, folder, out] = process.argv.slice(2)
const browser = await Browser.open(packages, 'chromium', `${folder}/index.html`)
await browser.resize(1366, 900)
await browser.go('scene=coin&size=240x240&format=rgb565')
await browser.until(() => document.body.dataset.rested !== undefined && document.querySelectorAll('#extent dt').length === 5)
await browser.page.screenshot({ path: out })
await browser.close()
