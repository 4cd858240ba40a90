// SPDX-License-Identifier: MIT
// A board that shades by itself, over WebUSB, as firmware/core/light_protocol.h says: a material and a map once, then a light a frame.
// Numbers come from that header, what is sent from the module, which packs it in C. Without a DOM: tests run it in node, too.
import * as wire from './exports'
import type { Usb, UsbDevice, UsbInterface } from './webusb'

/** What went wrong with the device, and what to do: a sentence for the user. */
export class Trouble extends Error {}

const ids = [wire.GUD_ID_OPENMOKO, wire.GUD_ID_MCS, wire.GUD_ID_PIDCODES]
export const filters = ids.map(id => ({ vendorId: id >>> 16, productId: id & 0xffff }))

export const sentences = {
    notChosen: 'No device was chosen. Plug in a Pico with a 240x240 panel and glint\'s firmware, then connect again.',
    notOpened: 'The device could not be opened. Stop other programs that use it; on Linux install glint\'s udev rule (70-glint.rules), plug the device in again, then connect again.',
    held: 'Another program or tab has the device. Stop it, then connect again.',
    noShader: 'This device does not shade by itself. Glint\'s firmware for a Pico with a 240x240 panel does.',
    noMesh: 'The board holds no mesh and keeps its picture. Choose a surface without a mesh, or disconnect to see this one here.',
    otherMesh: 'The board holds another mesh, and keeps its picture. Disconnect to see this one here.',
    onlyMesh: 'The board draws the mesh that it holds, and no maps: it keeps its picture. Choose that mesh, such as Teapot, to turn it.',
    oldFirmware: 'The board\'s firmware is too old to tell where the light is. Copy this version\'s glint.uf2 to the board, then connect again.',
    noLight: 'The board\'s firmware is too old to take a light for its own picture. Copy this version\'s glint.uf2 to the board, then connect again.',
    noSensor: 'The board has no accelerometer to take the light from.',
    silentSensor: 'The board\'s accelerometer does not answer. Unplug the board, plug it in, then connect again.',
    busy: 'The device waits for the rest of a picture that another program sends. Connect again, or plug it in again if nothing sends it.',
    unplugged: 'The device was unplugged. Plug it in, then connect again.',
    silent: 'The device does not answer. Unplug it, plug it in, then connect again.',
    stalled: 'The device stopped a transfer (STALL). Connect again.',
    failed: 'A transfer failed. Connect again; if that does not help, plug the device in again.',
} as const
const statuses: Record<number, string> = {
    [wire.GUD_UNSUPPORTED]: 'it does not know the request', [wire.GUD_PROTOCOL]: 'it has been restarted or used by another program',
    [wire.GUD_PARAMETER]: 'it does not take the values', [wire.GUD_ERROR]: 'it failed',
}
const refused = (what: string, status: number) => new Trouble(`The device refused ${what}: ${statuses[status] ?? `status ${status}`}. Connect again.`)

/** Pieces of a map: none takes long, however slow the bus. */
const pieceBytes = 8192
/** How many milliseconds a transfer, or a frame, may take. */
const usualPatience = 10000
/** Who has a device: nobody else closes it. */
const users = new WeakMap<UsbDevice, Pico>()

export class Pico {
    width = 0
    height = 0
    /** What it says of the mesh that it holds, if it holds one. */
    mesh?: Uint8Array
    takesMaps = true
    private tellsLight = false
    private number = 0
    private endpoint = 0

    private constructor(private usb: Usb, readonly device: UsbDevice, private patience: number) {}

    /** sizeOf: width << 16 | height of a descriptor, 0 where it is none. */
    static async connect(usb: Usb, device: UsbDevice, sizeOf: (descriptor: Uint8Array) => number | Promise<number>, patience = usualPatience): Promise<Pico> {
        const it = new Pico(usb, device, patience)
        users.set(device, it)
        try {
            const opening = device.open()
            await it.within(opening).catch(() => {
                opening.then(() => users.has(device) ? undefined : device.close()).catch(() => undefined) // too late
                throw new Trouble(sentences.notOpened)
            })
            if (!device.configuration)
                await it.within(device.selectConfiguration(1))
            await it.findInterface(sizeOf)
            await it.enable()
            await it.findLight()
            await it.findMesh()
            return it
        } catch (error) {
            const trouble = await it.troubleOf(error)
            await it.leave()
            throw trouble
        }
    }

    get name(): string {
        return this.device.productName ?? 'The device'
    }

    async sendMaterial(bytes: Uint8Array<ArrayBuffer>): Promise<void> {
        await this.guard(async () => {
            if (!await this.set(wire.LIGHT_SET_MATERIAL, bytes))
                throw refused('the material', await this.status())
        })
    }

    async sendMap(bytes: Uint8Array<ArrayBuffer>): Promise<void> {
        await this.guard(async () => {
            if (!await this.set(wire.LIGHT_SET_MAP))
                throw refused('the map', await this.status())
            for (let at = 0; at < bytes.length; at += pieceBytes)
                await this.bulk(bytes.subarray(at, at + pieceBytes))
            await this.expectDone('the map')
        })
    }

    /** In the place of a map: poses follow. */
    async useMesh(): Promise<void> {
        await this.guard(async () => {
            if (!await this.set(wire.LIGHT_SET_MESH))
                throw refused('the mesh', await this.status())
        })
    }

    /** Until its frame is on the panel. */
    async sendLight(bytes: Uint8Array<ArrayBuffer>, what = 'the light'): Promise<void> {
        await this.guard(async () => {
            await this.bulk(bytes)
            await this.expectDone(what)
        })
    }

    /** Of the mesh, the same. */
    sendPose(bytes: Uint8Array<ArrayBuffer>): Promise<void> {
        return this.sendLight(bytes, 'the pose')
    }

    /** Towards the room's light, as the board's accelerometer has it, of any length; else why not, a sentence. */
    async room(): Promise<[number, number, number] | string> {
        if (!this.tellsLight)
            return sentences.oldFirmware
        return this.guard(async () => {
            const { status, data } = await this.getLight()
            if (status !== 'ok' || data?.byteLength !== wire.LIGHT_MESSAGE_BYTES)
                throw new Trouble(sentences.stalled)
            const [sense, x, y, z] = [0, 4, 8, 12].map(at => data.getInt32(at, true))
            return sense === wire.LIGHT_SENSED && (x || y || z) ? [x, y, z] : sense === wire.LIGHT_NO_SENSOR ? sentences.noSensor : sentences.silentSensor
        })
    }

    /** The board shows what is its own: giveLight sets that one's light. Or what is sent again, from the map on. */
    showOwn(isOwn: boolean): Promise<void> {
        return this.guard(async () => {
            if (!isOwn)
                await this.enable()
            else if (!await this.set(wire.LIGHT_SET_ENABLE, Uint8Array.of(0)))
                throw refused('to show its own picture', await this.status())
        })
    }

    /** For LIGHT_HELD_MS, and not where the system is drawing on the board just now. */
    giveLight(towards: [number, number, number]): Promise<void> {
        return this.guard(async () => {
            const message = new DataView(new ArrayBuffer(wire.LIGHT_MESSAGE_BYTES))
            towards.forEach((v, i) => message.setInt32(4 * i + 4, Math.round(v * 32768), true))
            if (await this.set(wire.LIGHT_SET_LIGHT, new Uint8Array(message.buffer)))
                return
            const status = await this.status()
            if (status === wire.GUD_UNSUPPORTED)
                throw new Trouble(sentences.noLight)
            if (status !== wire.GUD_BUSY)
                throw refused('the light', status)
        })
    }

    /** Gives the panel back. */
    async close(): Promise<void> {
        await this.set(wire.LIGHT_SET_ENABLE, Uint8Array.of(0)).catch(() => false)
        await this.leave()
    }

    private async leave(): Promise<void> {
        if (users.get(this.device) !== this)
            return
        users.delete(this.device)
        await this.within(this.device.releaseInterface(this.number)).catch(() => undefined)
        await this.within(this.device.close()).catch(() => undefined)
    }

    /** The vendor interface that answers. The display's may have a driver, and then cannot be claimed. */
    private async findInterface(sizeOf: (descriptor: Uint8Array) => number | Promise<number>): Promise<void> {
        let claimed = 0
        const fitting = this.device.configuration?.interfaces.filter(isVendors) ?? []
        for (const { interfaceNumber, alternates } of fitting.reverse()) { // the display comes first
            if (!await this.within(this.device.claimInterface(interfaceNumber)).then(() => true, () => false))
                continue
            claimed++
            this.number = interfaceNumber
            this.endpoint = alternates[0].endpoints.find(isBulkOut)!.endpointNumber
            const { status, data } = await this.within(this.device.controlTransferIn(this.setup(wire.LIGHT_GET_DESCRIPTOR), wire.LIGHT_DESCRIPTOR_BYTES))
            const size = status === 'ok' && data?.byteLength === wire.LIGHT_DESCRIPTOR_BYTES ? await sizeOf(new Uint8Array(data.buffer, data.byteOffset, data.byteLength)) : 0
            this.width = size >>> 16
            this.height = size & 0xffff
            if (this.width && this.height)
                return
            await this.within(this.device.releaseInterface(interfaceNumber))
        }
        throw new Trouble(claimed < fitting.length && fitting.length > 1 ? sentences.held : sentences.noShader)
    }

    /** While the display's own host, the system, draws a rectangle, the panel is not handed over: that is soon done. */
    private async enable(): Promise<void> {
        for (let left = 20; !await this.set(wire.LIGHT_SET_ENABLE, Uint8Array.of(1)); left--) {
            const status = await this.status()
            if (status !== wire.GUD_BUSY)
                throw refused('to hand over the panel', status)
            if (!left)
                throw new Trouble(sentences.busy)
            await new Promise(resolve => setTimeout(resolve, 100))
        }
    }

    private getLight() {
        return this.within(this.device.controlTransferIn(this.setup(wire.LIGHT_GET_LIGHT), wire.LIGHT_MESSAGE_BYTES))
    }

    /** Older boards refuse the question, and that is their status until they are sent a map or a mesh: so it is asked before. */
    private async findLight(): Promise<void> {
        const { status, data } = await this.getLight()
        this.tellsLight = status === 'ok' && data?.byteLength === wire.LIGHT_MESSAGE_BYTES
    }

    /** Boards that hold none refuse the question; of those that hold one, some have no room for a map. */
    private async findMesh(): Promise<void> {
        const { status, data } = await this.within(this.device.controlTransferIn(this.setup(wire.LIGHT_GET_MESH), wire.LIGHT_MESH_BYTES))
        if (status !== 'ok' || data?.byteLength !== wire.LIGHT_MESH_BYTES)
            return
        this.mesh = new Uint8Array(data.buffer, data.byteOffset, data.byteLength)
        this.takesMaps = await this.set(wire.LIGHT_SET_MAP) // a map would follow; what is drawn first ends that
    }

    private setup(request: number) {
        return { requestType: 'vendor', recipient: 'interface', request, value: 0, index: this.number } as const
    }

    /** False: STALL. */
    private async set(request: number, data?: Uint8Array<ArrayBuffer>): Promise<boolean> {
        return (await this.within(this.device.controlTransferOut(this.setup(request), data ?? new Uint8Array(0)))).status === 'ok'
    }

    private async status(): Promise<number> {
        const { data } = await this.within(this.device.controlTransferIn(this.setup(wire.LIGHT_GET_STATUS), 1))
        return data?.byteLength ? data.getUint8(0) : wire.GUD_ERROR
    }

    private async bulk(bytes: Uint8Array<ArrayBuffer>): Promise<void> {
        if ((await this.within(this.device.transferOut(this.endpoint, bytes))).status !== 'ok') {
            await this.within(this.device.clearHalt('out', this.endpoint)).catch(() => undefined)
            throw new Trouble(sentences.stalled)
        }
    }

    /** GUD_BUSY: a light waits or is drawn. Asked once more at the end: it may be the page that stood still. */
    private async expectDone(what: string): Promise<void> {
        const end = performance.now() + this.patience
        for (let status, isEnd = false; (status = await this.status()) !== wire.GUD_OK; isEnd = performance.now() > end) {
            if (status !== wire.GUD_BUSY)
                throw refused(what, status)
            if (isEnd)
                throw new Trouble(sentences.silent)
        }
    }

    /** Counted in turns, of which a page that stood still has had one, however long: what came meanwhile is taken. */
    private within<T>(transfer: Promise<T>): Promise<T> {
        let timer: ReturnType<typeof setInterval>, turns = 4
        const late = new Promise<never>((_, reject) => { timer = setInterval(() => --turns || reject(new Trouble(sentences.silent)), this.patience / turns) })
        return Promise.race([transfer, late]).finally(() => clearInterval(timer))
    }

    /** After trouble the device is closed: connect again. */
    private async guard<T>(work: () => Promise<T>): Promise<T> {
        try {
            return await work()
        } catch (error) {
            const trouble = await this.troubleOf(error)
            await this.leave()
            throw trouble
        }
    }

    /** Browsers word errors differently, and a device that went away has several: is it still there? */
    private async troubleOf(error: unknown): Promise<Trouble> {
        if (error instanceof Trouble && error.message !== sentences.stalled && error.message !== sentences.silent)
            return error
        await new Promise(resolve => setTimeout(resolve, 300)) // until the system has noticed
        const devices = await this.usb.getDevices().catch(() => [])
        if (!devices.some(({ serialNumber, productName }) => serialNumber === this.device.serialNumber && productName === this.device.productName))
            return new Trouble(sentences.unplugged)
        return error instanceof Trouble ? error : new Trouble(sentences.failed, { cause: error })
    }
}

function isBulkOut({ direction, type }: { direction: string, type: string }): boolean {
    return direction === 'out' && type === 'bulk'
}

function isVendors({ alternates: [first] }: UsbInterface): boolean {
    return first.interfaceClass === wire.GUD_INTERFACE_CLASS && first.endpoints.some(isBulkOut)
}
