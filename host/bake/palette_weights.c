/* SPDX-License-Identifier: MIT */
#include "bake/palette_weights.h"

#include <math.h>

#include "models/models.h"

/* Of the lobe of MSH with n = 60, by the central difference. */
static double slope(double angle)
{
    static const double step = 1e-3;
    const double n = 60;
    return fabs(model_double(GLINT_MSH, n, cos(angle + step)) - model_double(GLINT_MSH, n, cos(angle - step))) /
           (2 * step);
}

/* The half vector of a light in front of the screen lies within 45 degrees of the viewer, so a normal tilted by more
 * than that shows only the highlight's flank. What an error of its angle changes is the steepest slope of the lobe that
 * such a normal can show, and at least 1, the steepest slope of the diffuse part. The weight is that slope, scaled so
 * that normals towards the viewer have 1. From 180 degrees down, the running maximum is the steepest slope so far. */
void palette_weights(double weights[PALETTE_TILTS])
{
    const double degree = M_PI / 180;
    double steepest = 0;
    for (int tilt = 180; tilt >= 0; tilt--) {
        const double angle = fmax(0, tilt - 45) * degree;
        if (angle < M_PI / 2)
            steepest = fmax(steepest, slope(fmax(angle, degree / 2)));
        weights[tilt] = fmax(1, steepest);
    }
    for (int tilt = 180; tilt >= 0; tilt--)
        weights[tilt] /= weights[0];
}
