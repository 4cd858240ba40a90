/* SPDX-License-Identifier: MIT
 * What counts on an emulated machine: instructions (QEMU, -icount shift=0) or cycles (simavr). */
#ifndef GLINT_BENCH_CLOCK_H
#define GLINT_BENCH_CLOCK_H

#include "loops.h"

void clock_begin(void);
uint32_t clock_now(void); /* modulo 2^32 */

/* The k-th of the scenes' lines (lines.S), of which the first SPHERE_LINES are the sphere's, goes to bench_line.normals, of another map to
 * bench_map; of MAP_PALETTE, which has the sphere's alone, bench_palette is set, too. The AVR has only the sphere's. */
void sphere_line(enum bench_map map, unsigned k);

/* Print by machine_put. A record's fields end with ';' but for the last, whose end is that of the line. */
void print_text(const char *text);
void print_number(uint32_t number);
void print_end(void);

/* calibration_loop (lines.S) is CALIBRATION instructions, on AVR cycles, counted by hand. print_calibration says what the
 * clock makes of it: calibration; by hand; by the clock. */
#ifdef __AVR__
#define CALIBRATION UINT32_C(327682)
#else
#define CALIBRATION UINT32_C(1000000)
#endif
void calibration_loop(void);
void print_calibration(void);

#endif
