/* SPDX-License-Identifier: MIT */
/* A display's lines, and the bytes that the program bitbang sends to it. */
#ifndef LAB_KNOWN_H
#define LAB_KNOWN_H

#include "lab.h"

enum spi_line { SPI_SCK, SPI_MOSI, SPI_CS, SPI_DC, SPI_RST, SPI_LINES };
enum i80_line { I80_D0, I80_WR = 8, I80_CS, I80_DC, I80_RST, I80_LINES };
extern const char *const SPI_NAMES[SPI_LINES], *const I80_NAMES[I80_LINES];

/* Of the pixels, which are never two alike in a row. */
uint16_t known_pixel(size_t index);
/* Start-up, a window of the whole screen, and its pixels; to be freed. */
bus_byte *known_bytes(unsigned width, unsigned height, size_t *count);

#endif
