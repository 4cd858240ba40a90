// SPDX-License-Identifier: MIT
// The C module: one instance is one program, which ends where the command would end, with a line on standard error.
import type { Exports } from './exports'

/** The program ended: its last line, without its name. */
export class Refusal extends Error {}

export class Module {
    readonly call: Exports
    /** Lines on standard error so far: warnings. */
    private said = ''
    /** Standard output so far. */
    private printed = ''

    constructor(program: WebAssembly.Module) {
        const instance = new WebAssembly.Instance(program, {
            wasi_snapshot_preview1: {
                fd_write: (fd: number, vectors: number, count: number, written: number) =>
                    this.write(fd, vectors, count, written),
                fd_close: () => 0,
                fd_seek: () => 29, // ESPIPE
                fd_fdstat_get: (_fd: number, out: number) => {
                    this.bytes().fill(0, out, out + 24)
                    return 0
                },
                proc_exit: () => {
                    throw new Refusal(plain(this.said.trimEnd().split('\n').pop() ?? ''))
                },
            },
        })
        this.call = instance.exports as unknown as Exports
        this.call._initialize()
    }

    bytes(): Uint8Array {
        return new Uint8Array(this.call.memory.buffer)
    }

    copy(at: number, length: number): Uint8Array<ArrayBuffer> {
        return new Uint8Array(this.call.memory.buffer as ArrayBuffer, at, length).slice()
    }

    /** Bytes into memory that the callee frees. */
    put(bytes: Uint8Array): number {
        const at = this.call.page_allocate(bytes.length)
        this.bytes().set(bytes, at)
        return at
    }

    text(at: number): string {
        const bytes = this.bytes()
        return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)))
    }

    /** What was said since the last time, a line each, once; of a file that makes thousands the first ones. */
    takeWarnings(): string[] {
        const lines = [...new Set(this.said.split('\n').filter(line => line))], most = 40
        this.said = ''
        return [...lines.slice(0, most).map(plain), ...lines.length > most ? [`and ${lines.length - most} more of these`] : []]
    }

    takePrinted(): string {
        const text = this.printed
        this.printed = ''
        return text
    }

    private write(fd: number, vectors: number, count: number, written: number): number {
        const view = new DataView(this.call.memory.buffer)
        let total = 0
        for (let i = 0; i < count; i++) {
            const at = view.getUint32(vectors + 8 * i, true)
            const length = view.getUint32(vectors + 8 * i + 4, true)
            const text = new TextDecoder().decode(this.bytes().slice(at, at + length))
            if (fd === 2)
                this.said += text
            else
                this.printed += text
            total += length
        }
        view.setUint32(written, total, true)
        return 0
    }
}

/** "glint render: --model: ..." without the command's name. */
function plain(line: string): string {
    return line.replace(/^glint( [a-z]+)?: /, '')
}
