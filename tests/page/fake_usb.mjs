// SPDX-License-Identifier: MIT
// navigator.usb with one board in it, for pages in a browser that has no device: fakeUsb runs in the page, and keeps what it is sent in
// globalThis.board; with board.room it knows its light, with board.takesLight = false it takes none for its own picture (board.given), with board.mesh it holds a mesh, whose poses are kept as lights are; what it is sent takes board.delay ms, and board.rounds
// counts what the page gives lights by: its pauses of 33 ms. While board.held is a list, requests wait for what they put there, and fail then; board.choosing is awaited before one is chosen. While board.waits is a list, bulk transfers wait for the status that what they put there is called with, and nothing else comes of them. A real board, or the firmware, is in tests/pico.
export function fakeUsb(width, height) {
    const gone = () => { throw new DOMException('A transfer error has occurred.', 'NetworkError') }
    const board = globalThis.board = { isPlugged: true, isHeld: false, isBusy: false, stalls: false, isChosen: true, choosing: null, opens: 0, held: null, mesh: null, room: null, takesMaps: true, takesLight: true, given: [], delay: 0, status: 0, waits: null, inMesh: false, enabled: 0, material: [], map: [], lights: [], reports: 0, rounds: 0 }
    const { setTimeout: plain } = globalThis
    globalThis.setTimeout = (then, ms, ...rest) => {
        board.rounds += ms === 33
        return plain(then, ms, ...rest)
    }
    const listeners = { connect: [], disconnect: [] }
    const answer = status => ({ status })
    const refused = () => { // which is the status until a request is carried out
        board.status = 2
        return answer('stall')
    }
    const device = {
        productName: 'A board', serialNumber: '17', opened: false,
        configuration: { interfaces: [0, 1].map(interfaceNumber => ({ interfaceNumber,
            alternates: [{ interfaceClass: 255, endpoints: [{ endpointNumber: interfaceNumber + 1, direction: 'out', type: 'bulk' }] }] })) },
        async open() {
            board.isPlugged || gone()
            board.opens++
        },
        async close() {},
        async claimInterface(number) { board.isPlugged && number === 1 && !board.isHeld || gone() },
        async releaseInterface() {},
        async clearHalt() { board.stalls = false },
        async controlTransferIn({ request }) {
            board.isPlugged || gone()
            if (request === 0xa0)
                return { status: 'ok', data: new DataView(Uint8Array.of(0x67, 0x6c, 0x6e, 0x74, 1, 0, 0, 0, width, width >> 8, height, height >> 8).buffer) }
            if (request === 0xa4)
                return board.mesh ? { status: 'ok', data: new DataView(Uint8Array.from(board.mesh).buffer) } : refused()
            if (request === 0xa6)
                return board.room ? { status: 'ok', data: new DataView(Int32Array.from(board.room).buffer) } : refused()
            return { status: 'ok', data: new DataView(Uint8Array.of(board.status ? board.status : board.isBusy || board.reports++ % 2 ? 1 : 0).buffer) }
        },
        async controlTransferOut({ request }, data) {
            if (board.held) {
                await new Promise(resolve => board.held.push(resolve))
                gone()
            }
            if (board.delay)
                await new Promise(resolve => setTimeout(resolve, board.delay))
            board.isPlugged || gone()
            if (request === 0xa1 && data[0] && board.isBusy)
                return answer('stall')
            board.status = 0
            if (request === 0xa1)
                board.enabled = data[0]
            if (request === 0xa2)
                board.material = [...data]
            if (request === 0xa3 && !board.takesMaps || request === 0xa5 && !board.mesh || request === 0xa7 && (!board.takesLight || board.enabled))
                return refused()
            if (request === 0xa7)
                board.given.push([...data])
            if (request === 0xa3)
                board.map = []
            if (request === 0xa3 || request === 0xa5)
                board.inMesh = request === 0xa5
            return answer('ok')
        },
        async transferOut(endpoint, data) {
            if (board.waits)
                return answer(await new Promise(resolve => board.waits.push(resolve)))
            board.isPlugged || gone()
            if (board.stalls)
                return answer('stall')
            if (!board.inMesh && board.map.length < 4 * width * height)
                board.map.push(...data)
            else
                board.lights.push([...data])
            return answer('ok')
        },
    }
    board.plug = isPlugged => {
        board.isPlugged = isPlugged
        listeners[isPlugged ? 'connect' : 'disconnect'].forEach(listener => listener({ device }))
    }
    Object.defineProperty(navigator, 'usb', { value: {
        async requestDevice() { await board.choosing; return board.isChosen ? device : Promise.reject(new DOMException('No device selected.', 'NotFoundError')) },
        async getDevices() { return board.isPlugged ? [device] : [] },
        addEventListener(type, listener) { listeners[type].push(listener) },
    } })
}
