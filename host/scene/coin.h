/* SPDX-License-Identifier: MIT */
#ifndef GLINT_SCENE_COIN_H
#define GLINT_SCENE_COIN_H

#include "scene/shapes.h"

struct relief relief_coin(double x, double y, double pixel, const double body[3]);
extern const struct relief coin_cloth; /* on which it lies */

#endif
