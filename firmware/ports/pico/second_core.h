/* SPDX-License-Identifier: MIT
 * The RP2040's other core, where SECOND_CORE is 1: struct hal's fork and join. */
#ifndef SECOND_CORE_H
#define SECOND_CORE_H

void second_core_start(void); /* once, when no code reads flash behind its back any more */
void second_core_fork(void *context, void (*job)(void *), void *argument);
void second_core_join(void *context);

#endif
