/* SPDX-License-Identifier: MIT */
#ifndef GLINT_SCENE_COIN_H
#define GLINT_SCENE_COIN_H

#include "scene/shapes.h"

struct relief relief_coin(double x, double y, double pixel, const double body[3]);

#endif
