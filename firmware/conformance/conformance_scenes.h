/* SPDX-License-Identifier: MIT
 * Checks of geometry, and of exact paints over rectangles and spans; and random materials and lights, which other checks use, too. */
#ifndef CONFORMANCE_SCENES_H
#define CONFORMANCE_SCENES_H

#include "conformance.h"
#include "glint.h"

enum { W = 11, H = 3, LINE = 4 * W + 2 }; /* of a rectangle */
/* For a mesh and its picture. Outlines take most: where there is too little for them the library refuses the mesh. */
enum {
    CONFORM_WORDS = CONFORMANCE_ALBEDO_ONLY || !CONFORMANCE_TABLES ? 160
                    : sizeof(void *) > 4                           ? 716
                                                                   : 523,
    CONFORM_PIXELS = 19 * 9
};

extern const int32_t conform_to_viewer[3];
/* Of the check at hand: one for all of them, for RAM. */
extern struct glint_paint conform_paint;
extern struct glint_light conform_lights[GLINT_LIGHTS_MAX];
extern uint32_t conform_words[CONFORM_WORDS], conform_pixels[CONFORM_PIXELS];

/* A material, and a directional light for it. */
void conform_random_material(struct glint_material *material, struct glint_light *light, unsigned model);
/* The paint under this light alone; into the hash where it is refused. */
void conform_light(struct glint_paint *paint, const struct glint_light *light);
/* Of any kind, near the surface; one above it where the library refuses what was chosen. */
void conform_random_light(struct glint_light *light);
/* About the half vector, so that the highlight is met. */
void conform_random_normal(struct glint_vec *normal, const struct glint_vec *h);

void conform_add_box(const struct glint_box *box);

void conform_vectors(const struct conformance_size *size);
void conform_scenes(unsigned format, const struct conformance_size *size);

#endif
