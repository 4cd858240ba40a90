/* SPDX-License-Identifier: MIT
 * The sine by a polynomial of degree 5, within 2^-12.5: no finer circle is visible. */
#include "orbit.h"

/* sin(x pi / 2), x and the result Q15, x = 0..2^15: x (pi/2 - x^2 (pi - 5/2 - x^2 (pi - 3) / 2)); exact at both ends. */
static int32_t quarter_sine_q15(uint32_t x)
{
    const uint32_t square = x * x >> 15;
    const uint32_t inner = 21024 - (2320 * square >> 15);
    return (int32_t)(x * (51472 - (inner * square >> 15)) >> 15); /* < 2^31 */
}

int32_t orbit_sine_q15(uint32_t turn_q16)
{
    const uint32_t at = turn_q16 & 0x3fff, back = turn_q16 & 0x4000 ? 0x4000 - at : at;
    const int32_t sine = quarter_sine_q15(2 * back);
    return turn_q16 & 0x8000 ? -sine : sine;
}

void orbit_light(int32_t to_light[3], uint32_t frame, uint32_t frames)
{
    const uint32_t turn_q16 = (frame % frames << 16) / frames;
    to_light[0] = orbit_sine_q15(turn_q16 + 0x4000) / 2; /* sin 30 degrees */
    to_light[1] = orbit_sine_q15(turn_q16) / 2;
    to_light[2] = 28378; /* cos 30 degrees, Q15 */
}
