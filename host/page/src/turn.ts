// SPDX-License-Identifier: MIT
// A mesh that is turned by dragging, where the light is moved otherwise.
import { byId, short } from './dom'
import type { Facts } from './engine'
import { change } from './store'

const button = byId<HTMLButtonElement>('turn')

export const isTurning = () => !button.hidden && button.getAttribute('aria-pressed') === 'true'

/** By degrees: to the right about the vertical axis, down about the horizontal one. */
export function turnBy(right: number, down: number, { turn }: Facts): void {
    const within = (angle: number) => short(((angle + 180) % 360 + 360) % 360 - 180, 1)
    change({ turn: [within(turn[0] + down), within(turn[1] + right), turn[2]].join() }, 'turn')
}

/** Whether there is something to turn. */
export function offerTurn(facts: Facts): void {
    button.hidden = !facts.turn
}

button.onclick = () => button.setAttribute('aria-pressed', String(!isTurning()))
