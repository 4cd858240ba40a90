/* SPDX-License-Identifier: MIT */
#ifndef BARE_MEMORY_H
#define BARE_MEMORY_H

void bare_memory(void); /* initial values into RAM, the rest of static data 0 */

#endif
