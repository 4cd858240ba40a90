// SPDX-License-Identifier: MIT
// picture.mjs NPM PAGE OUT.png: the page in Chromium at 1366x900, with a watch dial, as the READMEs show it.
import { Browser } from './browser.mjs'

const [packages, folder, out] = process.argv.slice(2)
const browser = await Browser.open(packages, 'chromium', `${folder}/index.html`)
await browser.resize(1366, 900)
await browser.go('scene=sunray&size=240x240&format=rgb565&light=-.45,.6,.66&panel=round')
await browser.tab('material')
await browser.until(() => document.getElementById('materials').dataset.drawn !== undefined)
await browser.page.screenshot({ path: out })
await browser.close()
