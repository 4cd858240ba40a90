/* SPDX-License-Identifier: MIT
 * For a port's start.c: its reset leads to bare_run, its exceptions to bare_fault, on a stack that begins at stack_top. */
#ifndef BARE_RUN_H
#define BARE_RUN_H

#include <stdint.h>

extern uint8_t stack_floor[], stack_top[]; /* from the linker script */

__attribute__((noreturn)) void bare_run(void);   /* static data, then the program */
__attribute__((noreturn)) void bare_fault(void); /* prints "fault"; exit status 1 */

#endif
