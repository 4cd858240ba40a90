// SPDX-License-Identifier: MIT
// What build.mjs puts in.
/** The C module, deflated, in base64. */
declare module 'glint:module' {
    const base64: string
    export default base64
}
/** worker.ts, bundled. */
declare module 'glint:worker' {
    const source: string
    export default source
}
/** tests/bench/costs.tsv: kind, name, build, n, value. */
declare module 'glint:costs' {
    const rows: [string, string, string, string, string][]
    export default rows
}
/** What options take by name, from page_lists in module/page.h. */
declare module 'glint:lists' {
    interface Choice { name: string, title: string, meaning: string, formula: string }
    const lists: { models: Choice[], formats: Choice[], paths: Choice[], materials: Choice[], scenes: Choice[] }
    export default lists
}
declare module 'glint:version' {
    const version: string
    export default version
}
