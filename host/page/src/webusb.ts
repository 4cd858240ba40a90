// SPDX-License-Identifier: MIT
// Of WebUSB what the page calls: navigator.usb in Chrome, Edge and Opera, the package `usb` in node.

export interface UsbDevice {
    readonly productName?: string | null
    readonly serialNumber?: string | null
    readonly opened: boolean
    readonly configuration?: { interfaces: UsbInterface[] } | null
    open(): Promise<void>
    close(): Promise<void>
    selectConfiguration(value: number): Promise<void>
    claimInterface(number: number): Promise<void>
    releaseInterface(number: number): Promise<void>
    clearHalt(direction: 'in' | 'out', endpoint: number): Promise<void>
    controlTransferIn(setup: UsbSetup, length: number): Promise<{ status?: string, data?: DataView }>
    controlTransferOut(setup: UsbSetup, data?: Uint8Array<ArrayBuffer>): Promise<{ status?: string }>
    transferOut(endpoint: number, data: Uint8Array<ArrayBuffer>): Promise<{ status?: string }>
}
export interface UsbInterface {
    interfaceNumber: number
    alternates: { interfaceClass: number, endpoints: { endpointNumber: number, direction: string, type: string }[] }[]
}
export interface UsbSetup {
    requestType: 'vendor'
    recipient: 'interface'
    request: number
    value: number
    index: number
}
export interface Usb {
    requestDevice(options: { filters: { vendorId: number, productId: number }[] }): Promise<UsbDevice>
    getDevices(): Promise<UsbDevice[]>
    addEventListener(type: 'connect' | 'disconnect', listener: (event: { device: UsbDevice }) => void): void
}
