/* SPDX-License-Identifier: MIT
 * The kernel's SPI devices. */
#ifndef GLINT_GPIO_SPIDEV_H
#define GLINT_GPIO_SPIDEV_H

#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* Mode 3 where the clock rests high, else 0, with 8 bits. A descriptor; `chunk` becomes how many bytes it takes at once.
 * Ends the program through fail(). */
int spidev_open(const char *path, uint32_t hz, bool rests_high, size_t *chunk);

json_t *spidev_list(void);
void spidev_print(const json_t *devices, FILE *stream);

#endif
