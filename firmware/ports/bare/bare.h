/* SPDX-License-Identifier: MIT
 * For a port's start.c. */
#ifndef BARE_H
#define BARE_H

#include "machine.h"

extern uint8_t stack_floor[], stack_top[]; /* from the linker script */

void bare_begin(void); /* first of all: initial values into RAM, the rest of static data 0 */

#endif
