/* SPDX-License-Identifier: MIT */
#ifndef GLINT_SCENE_WATCHFACE_H
#define GLINT_SCENE_WATCHFACE_H

#include "scene/shapes.h"

struct relief relief_watchface(double x, double y, double pixel, const double body[3]);
struct relief relief_dial(double x, double y, double pixel,
                          const double body[3]); /* the same without numerals and minutes */
/* A flat dial for sunray grain, with hour marks set on it. */
struct relief relief_sunray(double x, double y, double pixel, const double body[3]);
extern const struct relief watch_wall; /* behind them */

#endif
