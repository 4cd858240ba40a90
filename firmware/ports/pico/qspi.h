/* SPDX-License-Identifier: MIT
 * A bus of four data lines and a select line, by PIO: commands by the first line, pixels by all. The caller sees to it that no DMA is on
 * its way. */
#ifndef QSPI_H
#define QSPI_H

#include <stddef.h>
#include <stdint.h>

void qspi_start(void);
/* Begins a frame, after the one before. Data follow, by four lines where the command takes pixels: even counts of bytes then. */
void qspi_command(uint8_t command);
void qspi_data(const uint8_t *bytes, size_t count);
void qspi_end(void); /* of the frame */
/* For DMA: where pixels go, 16 bits each, while a command that takes pixels is open; and its request. */
volatile void *qspi_pixels(void);
unsigned qspi_dreq(void);

#endif
