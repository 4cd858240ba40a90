/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_LOBES_H
#define GLINT_PAPER_LOBES_H

#include "paper/paper.h"

void paper_figure3(struct paper *paper);
void paper_figure4(struct paper *paper);

#endif
