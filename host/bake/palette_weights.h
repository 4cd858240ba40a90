/* SPDX-License-Identifier: MIT
 * How much an error of a normal matters, by how far the normal is tilted from the viewer. */
#ifndef GLINT_PALETTE_WEIGHTS_H
#define GLINT_PALETTE_WEIGHTS_H

enum { PALETTE_TILTS = 181 }; /* whole degrees, 0 to 180 */

/* 1 for normals towards the viewer, less for others, never 0. */
void palette_weights(double weights[PALETTE_TILTS]);

#endif
