/* SPDX-License-Identifier: MIT */
#ifndef GLINT_SCENE_KNOB_H
#define GLINT_SCENE_KNOB_H

#include "scene/shapes.h"

struct relief relief_knob(double x, double y, double pixel, const double body[3]);
struct relief knob_panel(double x, double y); /* behind it, with its shadow */

#endif
