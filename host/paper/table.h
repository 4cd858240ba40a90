/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_TABLE_H
#define GLINT_PAPER_TABLE_H

#include "paper/paper.h"

void paper_table1(struct paper *paper);
void paper_wider(struct paper *paper);

#endif
