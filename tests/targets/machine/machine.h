/* SPDX-License-Identifier: MIT
 * A bare machine that runs the sweep. */
#ifndef GLINT_MACHINE_H
#define GLINT_MACHINE_H

#include <stdint.h>

void machine_put(char c); /* where the emulator shows it */

/* Prints the small sweep's number, then the bytes of stack that it used. `floor`: the first address above static data,
 * from where the stack may use all. */
void machine_run(volatile uint8_t *floor);

#endif
