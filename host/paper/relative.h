/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_RELATIVE_H
#define GLINT_PAPER_RELATIVE_H

#include "paper/paper.h"

void paper_figure9(struct paper *paper);

#endif
