/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_JOINT_H
#define GLINT_PAPER_JOINT_H

#include "paper/paper.h"

/* A slice of the joint search, and how long the whole would take. */
void paper_joint(struct paper *paper);

#endif
