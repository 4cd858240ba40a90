// SPDX-License-Identifier: MIT
// TAP from functions whose names are sentences.
export async function run(tests, at_the_end = () => {}) {
  console.log(`1..${tests.length}`)
  let failed = 0
  for (const [i, [name, test]] of tests.entries()) {
    try {
      await test()
      console.log(`ok ${i + 1} - ${name}`)
    } catch (error) {
      failed++
      console.log(`not ok ${i + 1} - ${name}\n# ${String(error.stack ?? error).split('\n').slice(0, 4).join('\n# ')}`)
    }
  }
  await Promise.race([at_the_end(), new Promise(resolve => setTimeout(resolve, 20_000))]) // a browser that does not end hides no result
  process.exit(failed ? 1 : 0)
}

// Seconds. What works is done by then on the busiest machine: the one limit of what a test waits for.
export const HANGS = 300

// Until it holds; where it never does, what() says why not.
export async function until(holds, what) {
  for (const end = Date.now() + 1000 * HANGS; !await holds();) {
    check(Date.now() < end, `not in ${HANGS} s: ${await what()}`)
    await new Promise(resolve => setTimeout(resolve, 20))
  }
}

export function check(good, message) {
  if (!good) throw new Error(message)
}

export function equal(found, expected, what) {
  check(Object.is(found, expected), `${what}: ${found}, expected ${expected}`)
}
