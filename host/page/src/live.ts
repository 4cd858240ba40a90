// SPDX-License-Identifier: MIT
// A Pico on the desk that follows the page. While one is connected the picture is what it draws: its size, RGB565 without dither, by
// its tables from 8-bit normals; or the mesh that it holds.
import { ask, workersSoFar } from './client'
import { byId } from './dom'
import type { ForDevice } from './engine'
import { filesVersion, isHere } from './kept'
import { NotHere, onDrawn, redraw, setView } from './picture'
import type { Viewed } from './picture'
import { filters, Pico, sentences, Trouble } from './pico'
import { beginMotion, pointTo, towards } from './sun'
import type { Usb, UsbDevice } from './webusb'
import { isMesh, meshOnDevice, onDevice, whiteName, wordsOf } from './words'
import type { State } from './words'

const button = byId<HTMLButtonElement>('connect'), status = byId('device-status')
const usb = (navigator as Navigator & { usb?: Usb }).usb
let pico: Pico | undefined
/** What the device has; '' nothing. */
let has = { map: '', material: '' }
let frames: number[] = []
let isLost = false

/** What changes with each frame is not read out. */
function say(text: string, isOften = false): void {
    status.setAttribute('aria-live', isOften ? 'off' : 'polite')
    status.textContent = text
}

function whyNot(): string {
    if (!usb && !isSecureContext)
        return 'Over plain http a page reaches no USB device. Open it by https, or run "glint page" and open http://localhost:8016/, in Chrome, Edge or Opera.'
    if (!usb)
        return 'This browser does not reach USB devices. Open the page in Chrome, Edge or Opera on a computer.'
    if (location.protocol === 'file:')
        return 'Chrome loses a device that is chosen in a page from a file. Run "glint page", open http://localhost:8016/ and connect there.'
    return ''
}

// ---- connecting ----

async function choose(): Promise<void> {
    const reason = whyNot()
    if (reason) {
        say(reason)
        return
    }
    button.disabled = true // one that comes back meanwhile is not connected beside it
    const device = await usb!.requestDevice({ filters }).catch(() => undefined)
    button.disabled = false
    if (device)
        await connect(device)
    else
        say(sentences.notChosen)
}

async function connect(device: UsbDevice): Promise<void> {
    button.disabled = true
    say('Connecting…')
    try {
        pico = await Pico.connect(usb!, device, bytes => ask('deviceSize', bytes).catch(() => ask('deviceSize', bytes))) // stopped: another worker
        isLost = false
        follows(pico)
        button.textContent = 'Disconnect'
        fromBoard.hidden = own.hidden = false
    } catch (error) {
        lose(error as Error)
    }
    button.disabled = false
}

/** It draws the page's picture, from now on. */
function follows(to: Pico): void {
    const { width, height, mesh, takesMaps } = to
    has = { map: '', material: '' }
    frames = []
    setView(async state => {
        if (isMesh(state)) {
            if (!mesh)
                throw new NotHere(sentences.noMesh)
            const split = await splitOf(mesh, state)
            if (!split)
                throw new NotHere(sentences.otherMesh)
            return { state: meshOnDevice(state, width, height, split), isBoards: true }
        }
        if (!takesMaps)
            throw new NotHere(sentences.onlyMesh)
        return mapOnDevice(state, width, height)
    })
    say(`${to.name} is connected. It keeps its picture until it is sent one.`) // the first may be refused, or stopped
    void redraw()
}

let held = { of: '', split: 0 }
/** At how many degrees the edges of the mesh that the board holds are split, if that is the state's; else 0. */
async function splitOf(mesh: Uint8Array, { scene, mesh: file, crease, axes }: State): Promise<number> {
    const words = wordsOf({ scene, mesh: file, crease, axes, lights: [] }), of = [mesh.join(), filesVersion(), ...words].join('\0')
    if (of !== held.of)
        held = { of, split: await ask('deviceMesh', mesh, words) }
    return held.split
}

let white = ''
async function mapOnDevice(state: State, width: number, height: number): Promise<Viewed> {
    const name = whiteName({ has: isHere }), size = `${name} ${width}x${height} ${workersSoFar()} ${filesVersion()}`, color = await colourOf(state)
    if (size !== white)
        await ask('white', name, width, height)
    white = size
    return { state: onDevice(state, width, height, color, name), isBoards: true, white: state.scene === undefined ? undefined : name }
}

let colour = { surface: '', text: '' }
/** The colour where the state names none, for a surface that has several: maps beside one have the size that it is drawn at. */
async function colourOf({ scene, height, normals, albedo, mask, material, color, ...state }: State): Promise<string> {
    if (color !== undefined)
        return color
    const { size, bevel, fit, filter } = albedo ?? mask ? state : {} as Partial<State>
    const words = wordsOf({ scene, height, normals, albedo, mask, material, size, bevel, fit, filter, lights: [] }), surface = [filesVersion(), ...words].join('\0')
    if (surface !== colour.surface)
        colour = { surface, text: await ask('colour', words) }
    return colour.text
}

function forget(): void {
    pico = undefined
    endLight()
    fromBoard.hidden = own.hidden = true
    own.setAttribute('aria-pressed', 'false')
    own.disabled = gives = false // what still waits is the old one's
    given = Promise.resolve()
    button.textContent = 'Connect a Pico'
    setView()
    void redraw()
}

function lose(error: Error): void {
    isLost = error.message === sentences.unplugged
    say(error.message)
    forget()
}

button.onclick = async () => {
    if (!pico) {
        await choose()
        return
    }
    const was = pico
    forget()
    button.disabled = true // to close it would close what is connected meanwhile
    await was.close()
    button.disabled = false
    say('Disconnected. The device shows its own demo again.')
}

usb?.addEventListener('disconnect', ({ device }) => {
    if (pico?.device === device)
        lose(new Trouble(sentences.unplugged))
})
usb?.addEventListener('connect', ({ device }) => {
    if (!pico && isLost && !button.disabled)
        void connect(device)
})

// ---- the light from the board's accelerometer ----

const fromBoard = byId('board-light'), note = byId('motion-note')
let asking = 0 // which press of the button is at work

function endLight(why = ''): void {
    if (fromBoard.getAttribute('aria-pressed') === 'true')
        note.textContent = why
    fromBoard.setAttribute('aria-pressed', 'false')
    asking++
}

async function takeLight(from: Pico): Promise<void> {
    const mine = ++asking
    beginMotion(fromBoard)
    fromBoard.setAttribute('aria-pressed', 'true')
    while (mine === asking) {
        const light = await from.room().catch((error: Error) => error)
        if (mine !== asking)
            return
        if (light instanceof Error) {
            lose(light)
        } else if (typeof light === 'string') {
            endLight(light)
        } else {
            note.textContent = 'The light stays where it is in the room: tilt the board.'
            const length = Math.hypot(...light)
            pointTo(light.map(v => v / length) as typeof light)
            await new Promise(resolve => setTimeout(resolve, 16))
        }
    }
}

fromBoard.onclick = () => {
    if (fromBoard.getAttribute('aria-pressed') === 'true')
        endLight()
    else if (pico)
        void takeLight(pico)
}

// ---- the board's own picture under the page's light ----

const own = byId<HTMLButtonElement>('board-own')
const isOwn = () => own.getAttribute('aria-pressed') === 'true'

let gives = false, given = Promise.resolve()
/** Of a point or spot, as far beside the middle as it is in the picture; what a board would refuse is not sent. */
async function giveLights(to: Pico): Promise<void> {
    while (pico === to && gives) {
        const at = towards()
        if (at.every(isFinite) && (at[0] || at[1] || at[2] > 0))
            await to.giveLight(at)
        await new Promise(resolve => setTimeout(resolve, 33))
    }
}

own.onclick = async () => {
    const to = pico
    if (!to)
        return
    own.disabled = true
    const begins = !isOwn()
    try {
        if (begins) {
            setView()
            own.setAttribute('aria-pressed', 'true')
            while (following === to) // the picture that is on its way
                await new Promise(resolve => setTimeout(resolve, 10))
        } else {
            gives = false
        }
        await given // a light behind what comes now would be refused
        if (pico !== to)
            return
        await to.showOwn(begins)
        if (pico !== to)
            return
        if (begins) {
            say(`${to.name} shows its own picture under the light of this page: drag, Orbit or Tilt.`)
            gives = true
            given = giveLights(to).catch(error => {
                if (pico === to)
                    lose(error)
            })
            void redraw()
        } else {
            own.setAttribute('aria-pressed', 'false')
            follows(to)
        }
    } catch (error) {
        if (pico === to)
            lose(error as Error)
    } finally {
        if (pico === to)
            own.disabled = false
    }
}

// ---- following ----

/** What is being sent to; one that is gone may still wait for its answer. */
let following: Pico | undefined, again = false
/** While the device draws, changes wait, and only the last counts. */
async function follow(): Promise<void> {
    const to = pico
    again = true
    if (!to || following === to)
        return
    following = to
    while (again && pico === to && !isOwn()) {
        again = false
        await send(to).catch(error => {
            if (pico !== to)
                return
            if (error instanceof Trouble)
                lose(error)
            else
                say(`${to.name} keeps its picture: ${error.message}`)
        })
    }
    if (following === to)
        following = undefined
}

async function send(to: Pico): Promise<void> {
    const scene = await ask('device', to.width, to.height, has)
    if (!scene || pico !== to) // drawn before it was connected
        return
    if (scene.map)
        await to.sendMap(scene.map)
    if (scene.material)
        await to.sendMaterial(scene.material)
    if (scene.mesh)
        await to.useMesh()
    if (pico !== to)
        return
    has = scene.has
    if (scene.light)
        await to.sendLight(scene.light)
    if (scene.pose)
        await to.sendPose(scene.pose)
    if (pico !== to)
        return
    frames.push(performance.now())
    tell(to, scene)
}

function tell(to: Pico, { pose, light }: ForDevice): void {
    const now = performance.now()
    frames = frames.filter(time => time > now - 1000)
    const rate = frames.length > 1 ? (frames.length - 1) * 1000 / (frames[frames.length - 1] - frames[0]) : 0
    say(`${to.name} draws ${to.width} × ${to.height}, RGB565: ${frames.length > 1 ? `${rate.toFixed(0)} frames/s, ` : ''}${(pose ?? light)!.length} bytes a frame. The picture here is the same, bit for bit: ${pose ? 'parallel projection, stepped outline' : 'one colour, full gloss'}, no dither, over black.`, frames.length > 1)
}

onDrawn(({ isBoards }) => {
    if (isBoards)
        void follow()
})
