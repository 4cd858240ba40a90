/* SPDX-License-Identifier: MIT
 * A lamp as a pixel sees it; internal. */
#ifndef GLINT_LAMP_H
#define GLINT_LAMP_H

#include "glint.h"

/* GLINT_OK or GLINT_ERR_ARG. */
enum glint_err glint_lamp_check(const struct glint_lamp *lamp);

/* Steps 1a and 1b for a point or spot, which glint_lamp_check has seen, at pixel x, y of the screen: att; *light only
 * where it is not 0. */
uint32_t glint_lamp_reach(const struct glint_lamp *lamp, int32_t x, int32_t y, const int32_t v_q30[3],
                          struct glint_light *light);

#endif
