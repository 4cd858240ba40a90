/* SPDX-License-Identifier: MIT
 * Time as streams count it. */
#ifndef GLINT_BASE_CLOCK_H
#define GLINT_BASE_CLOCK_H

double seconds_now(void); /* of a clock that only runs forward */
/* Until then, or until stream_stopped(). */
void wait_until(double seconds);

#endif
