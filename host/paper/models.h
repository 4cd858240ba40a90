/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PAPER_MODELS_H
#define GLINT_PAPER_MODELS_H

#include "paper/paper.h"

void paper_models(struct paper *paper);

#endif
