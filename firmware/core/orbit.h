/* SPDX-License-Identifier: MIT
 *
 * A light that circles about the viewer's axis: the same integers on the device and on the host. */
#ifndef ORBIT_H
#define ORBIT_H

#include <stdint.h>

enum { ORBIT_FRAMES = 240 }; /* a turn, where nothing else is asked for: 4 s at 60 frames a second */

/* Towards the light, 30 degrees from the viewer, frame/frames of a turn after straight right, counter-clockwise; length
 * 2^15 within 5. frames: 1..65535. */
void orbit_light(int32_t to_light[3], uint32_t frame, uint32_t frames);

/* sin(2 pi turn), Q15, within 2^-12.5; turn modulo 1. */
int32_t orbit_sine_q15(uint32_t turn_q16);

#endif
