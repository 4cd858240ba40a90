// SPDX-License-Identifier: MIT
// The stage: the panel's pixels at a clean scale, its bezel, full screen; alone in an address with ?embed.
import { byId, make } from './dom'
import { onDrawn } from './picture'
import { current, onChange } from './store'

const canvas = byId<HTMLCanvasElement>('canvas'), stage = byId('stage'), bezel = byId('bezel')
/** The screen's pixels to one of the panel's; where that is no whole number pixels are blended. */
const scales = [1 / 8, 1 / 4, 1 / 3, 1 / 2, 3 / 4, 1, 1.25, 1.5, 1.75, 2, 2.5, ...Array.from({ length: 30 }, (_, i) => i + 3)]
let chosen: number | undefined // none: as large as fits

export const shapes = ['square', 'round', 'none'] as const
const shape = () => shapes.find(name => name === current().panel) ?? 'square' // else an address could name any class

function fitting(): number {
    const { paddingLeft, marginLeft } = getComputedStyle(bezel), around = 2 * (parseFloat(paddingLeft) + parseFloat(marginLeft))
    const room = Math.min((stage.clientWidth - around) / canvas.width, (stage.clientHeight - around) / canvas.height) * devicePixelRatio
    return scales.findLast(scale => scale <= room) ?? scales[0]
}

function layOut(): void {
    bezel.className = `bezel ${shape()}`
    const scale = chosen ?? fitting()
    canvas.style.width = `${canvas.width * scale / devicePixelRatio}px`
    canvas.style.height = `${canvas.height * scale / devicePixelRatio}px`
    canvas.classList.toggle('smooth', scale % 1 !== 0)
    byId('zoom').textContent = `${scale === .75 ? '3/4' : scale < 1 ? `1/${Math.round(1 / scale)}` : scale}×`
}

const step = (by: number) => {
    const at = scales.indexOf(chosen ?? fitting())
    chosen = scales[Math.max(0, Math.min(scales.length - 1, at + by))]
    layOut()
}
byId('zoom-in').onclick = () => step(1)
byId('zoom-out').onclick = () => step(-1)
byId('zoom-fit').onclick = () => { chosen = undefined; layOut() }
new ResizeObserver(layOut).observe(stage)
let laidOut = ''
function layOutNew(): void {
    const now = `${canvas.width} ${canvas.height} ${shape()}`
    if (now !== laidOut)
        layOut()
    laidOut = now
}
onDrawn(layOutNew)
onChange(layOutNew)

if (new URLSearchParams(location.search).has('embed'))
    document.documentElement.className = 'embed'

const full = byId('full')
full.hidden = !document.fullscreenEnabled
full.onclick = () => void (document.fullscreenElement ? document.exitFullscreen() : byId('view').requestFullscreen())

/** The panel in its bezel, its pixels as large as on the screen and at least twice. */
export function stagePicture(): Promise<Blob | null> {
    const scale = Math.max(2, Math.floor(chosen ?? fitting())), [w, h] = [canvas.width * scale, canvas.height * scale]
    const rim = shape() === 'none' ? 0 : Math.round(Math.max(w, h) / 28), margin = rim && Math.round(1.6 * rim)
    const out = make('canvas', { width: w + 2 * (rim + margin), height: h + 2 * (rim + margin) }), draw = out.getContext('2d')!
    const outline = (grow: number) => {
        draw.beginPath()
        if (shape() === 'round')
            draw.ellipse(out.width / 2, out.height / 2, w / 2 + grow, h / 2 + grow, 0, 0, 2 * Math.PI)
        else
            draw.roundRect(margin + rim - grow, margin + rim - grow, w + 2 * grow, h + 2 * grow, grow && 1.2 * grow)
    }
    if (rim) {
        const light = draw.createLinearGradient(0, 0, out.width, out.height)
        ;[[0, '#54585e'], [.45, '#232527'], [1, '#101112']].forEach(([at, color]) => light.addColorStop(at as number, color as string))
        draw.shadowColor = 'rgb(0 0 0 / .45)'
        draw.shadowBlur = rim
        draw.shadowOffsetY = rim / 3
        draw.fillStyle = light
        outline(rim)
        draw.fill()
    }
    draw.shadowColor = 'transparent'
    draw.fillStyle = '#000' // as on the screen
    outline(0)
    draw.fill()
    draw.clip()
    draw.imageSmoothingEnabled = false
    draw.drawImage(canvas, rim + margin, rim + margin, w, h)
    return new Promise(resolve => out.toBlob(resolve))
}
