// SPDX-License-Identifier: MIT
// The counts of calibrate.S by the manual of the Cortex-M0+. What does not agree with them is not worth measuring.
export const KNOWN = {
  calibrate_empty: 0,
  calibrate_muls: 10,
  calibrate_alu: 12,
  calibrate_memory: 17,
  calibrate_loop: 1 + 100 + 99 * 2 + 1,
  calibrate_call: 3 + 3 + 2 + 5 - 2, // it returns by its pop, not by a bx lr
  calibrate_stack: 4 + 4,
  calibrate_jump: 2 + 1 + 1 + 2,
  calibrate_multiple: 3 + 5 + 2 + 5 + 3 + 1 + 6 + 2 + 5 + 3,
  calibrate_indexed: 3 + 8 * 2,
  calibrate_sp: 4 + 6 * 2,
  calibrate_high: 12,
  calibrate_conditions: 1 + 7 * 2 + 7,
  calibrate_pointer: 3 + 2 + 2 + 2 + 5 - 2
}
