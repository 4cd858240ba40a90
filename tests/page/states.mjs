// SPDX-License-Identifier: MIT
// Random states of the page, as words of `glint render`, the same in each run.

export function randomly(seed) {
    let state = seed >>> 0
    return () => { // mulberry32
        state = state + 0x6d2b79f5 >>> 0
        let t = Math.imul(state ^ state >>> 15, 1 | state)
        t = t + Math.imul(t ^ t >>> 7, 61 | t) ^ t
        return ((t ^ t >>> 14) >>> 0) / 2 ** 32
    }
}

/** Some are refused, by the command, too; a Command says what there is to choose from. */
export function randomWords(random, command) {
    const [models, formats, paths, scenes, materials] = ['--model', '--format', '--path', '--scene', '--material'].map(option => command.choices(option))
    const one = list => list[Math.floor(random() * list.length)]
    const real = (low, high, decimals = 3) => String(Number((low + random() * (high - low)).toFixed(decimals)))
    const maybe = (chance, word) => random() < chance ? [word] : []
    const coefficient = () => random() < .6 ? real(0, 1, 2) : [real(0, 1, 2), real(0, 1, 2), real(0, 1, 2)].join()
    const color = () => random() < .3 ? ',' + [real(0, 2), real(0, 2), real(0, 2)].join() : ''
    const width = 20 + Math.floor(random() * 60), height = 20 + Math.floor(random() * 60)
    const grain = () => random() < .3 ? `brushed:${real(-180, 180, 1)}` : one(['brushed', 'spun', 'sunray', `spun:${real(0, width, 1)},${real(0, height, 1)}`, `sunray:${real(0, width, 1)},${real(0, height, 1)}`])
    const direction = () => `--light=${real(-1, 1)},${real(-1, 1)},${real(.05, 1.5)}`
    const light = () => random() < .75 ? direction() + color()
        : random() < .5 ? `--point=${real(0, width, 1)},${real(0, height, 1)},${real(2, 60, 1)},${real(20, 200, 1)}${color()}`
            : `--spot=${real(0, width, 1)},${real(0, height, 1)},${real(20, 90, 1)},${real(0, width, 1)},${real(0, height, 1)},${real(40, 300, 1)},${real(0, 20, 1)},${real(20, 60, 1)}${color()}`
    const scene = random() < .2 ? 'teapot' : one(scenes), rarely = scene === 'teapot' ? .1 : 1 // maps and grain, which meshes refuse
    const path = maybe(.35, `--path=${one(paths)}`), format = path.length && random() < .7 ? 'rgb565' : one(formats) // tables take one, and one light
    const stands = scene === 'teapot' ? [...maybe(.7, `--turn=${real(-180, 180, 1)},${real(-180, 180, 1)},${real(-180, 180, 1)}`), ...maybe(.4, `--zoom=${real(.5, 3)}`), ...maybe(.4, `--perspective=${real(1.5, 9)}`), ...maybe(.3, '--no-outlines'), ...maybe(.2, `--split=${real(8, 180, 1)}`)] : []
    return [`--scene=${scene}`, ...stands, `--size=${width}x${height}`, ...maybe(rarely * .15, '--cut-out'), ...maybe(rarely * .1, `--filter=${2 + Math.floor(random() * 3)}`), ...maybe(rarely * .2, `--grain=${grain()}`), ...maybe(.2, `--background=${[0, 1, 2].map(() => Math.floor(random() * 256)).join()}`), ...maybe(.3, `--material=${one(materials)}`), ...maybe(rarely * .2, `--across=${Math.round(1000 ** random())}`), `--model=${one(models)}`, `--format=${format}`,
        ...maybe(.6, random() < .2 ? `--roughness=${real(0, 1)}` : `-n${Math.round(1000 ** random())}`), ...maybe(.4, `-q${Math.floor(random() * 17)}`), ...maybe(.3, '--space=linear'), ...maybe(.4, '--dither'),
        ...maybe(.2, '--clamp-peak'), ...maybe(.5, `--ambient=${coefficient()}`), ...maybe(.5, `--diffuse=${coefficient()}`), ...maybe(.5, `--specular=${coefficient()}`),
        ...maybe(.3, `--color=${[0, 1, 2].map(() => Math.floor(random() * 256)).join()}`), ...maybe(.15, `--view=${real(-.4, .4)},${real(-.4, .4)},1`),
        ...path, ...path.length && random() < .7 ? [direction()] : [light(), ...random() < .2 ? [light()] : []]]
}
