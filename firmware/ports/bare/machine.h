/* SPDX-License-Identifier: MIT
 * A machine without an operating system: what a port's start.c and a program give each other. */
#ifndef MACHINE_H
#define MACHINE_H

#include <stdbool.h>
#include <stdint.h>

/* The port: a character to where it is seen. */
void machine_put(char c);
/* The port, where it has start-up code (run.h): ends the emulator with exit status 0, or 1 where not all went well. */
__attribute__((noreturn)) void machine_end(bool well);

/* The program, called by the port once. `floor`: the first address above static data, from where the stack may use all.
 * Whether all went well: the emulator's exit status where it has one. */
bool machine_run(volatile uint8_t *floor);

#endif
