/* SPDX-License-Identifier: MIT
 * gnuplot. */
#ifndef GLINT_PAPER_PLOT_H
#define GLINT_PAPER_PLOT_H

#include <stddef.h>

/* "pngcairo" or "svg", whichever gnuplot offers; fails where there is no gnuplot. */
const char *plot_terminal(void);
/* Runs `gnuplot SCRIPT` in the directory; what it writes to standard output is returned, malloc'd. */
char *plot_run(const char *directory, const char *script, size_t *size);

#endif
