/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_GRAIN_H
#define GLINT_PAPER_GRAIN_H

#include "paper/paper.h"

void paper_grain(struct paper *paper);

#endif
