/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_FIGURE_H
#define GLINT_PAPER_FIGURE_H

#include "paper/paper.h"

/* Keeps the script as PART.gp, runs gnuplot on it, keeps the picture, and enters the figure with PART.csv, which is
 * written already. The script's terminal is set in front of it: size in pixels. */
void paper_figure(struct paper *paper, const char *part, const char *title, int width, int height, const char *script,
                  json_t *caption);

#endif
