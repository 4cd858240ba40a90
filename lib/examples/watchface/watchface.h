/* SPDX-License-Identifier: MIT */
#ifndef WATCHFACE_H
#define WATCHFACE_H

#include "glint.h"

/* Once; then a frame for each place of the light. */
enum glint_err watchface_init(void);
enum glint_err watchface_draw(const int32_t to_light[3]);

/* Yours: sends lines y and on to the display. */
void display_send(uint16_t y, uint16_t lines, const void *pixels, size_t bytes);

#endif
