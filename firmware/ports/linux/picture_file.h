/* SPDX-License-Identifier: MIT
 * A picture in a file: whole or not there. */
#ifndef PICTURE_FILE_H
#define PICTURE_FILE_H

#include <stdbool.h>
#include <stdint.h>

enum { PATH_ROOM = 4096 };

/* Now, not when the first picture is there: exits with a line if path cannot become a file. */
void picture_file_check(const char *path);
/* The suffix chooses: .png, .ppm, else raw rows of r, g, b. False: it warned, and the old file stays. */
bool picture_file_write(const char *path, uint16_t width, uint16_t height, const uint8_t *rgb);
/* FILE-000001.png from FILE.png. */
void picture_file_number(char numbered[PATH_ROOM], const char *path, unsigned number);

#endif
