/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_SURFACES_H
#define GLINT_PAPER_SURFACES_H

#include "paper/paper.h"

void paper_figure5(struct paper *paper);
void paper_figure6(struct paper *paper);

#endif
