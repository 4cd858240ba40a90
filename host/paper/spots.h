/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_SPOTS_H
#define GLINT_PAPER_SPOTS_H

#include "paper/paper.h"

void paper_figure7a(struct paper *paper);
void paper_figure7b(struct paper *paper);

#endif
