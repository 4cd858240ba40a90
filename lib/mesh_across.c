/* SPDX-License-Identifier: MIT
 * A number is linear over a triangle: a step to the right or down is a sum of products of sides and differences, over twice the area.
 * One reciprocal of that, of 31 bits, serves all six steps. Where a sliver is so thin that this is too coarse, a pixel still has
 * something between its corners. */
#include "glint_mesh_rows.h"
#include "glint_math.h"
#include "glint_mesh_strip.h"

void glint_mesh_corners_of(struct glint_mesh_corners *corners, const struct glint_mesh_target *target, unsigned face)
{
    const struct glint_mesh_drawn *drawn = target->drawn;
    const uint16_t *const of = drawn->mesh->faces + 3 * (size_t)face;
    if (!glint_mesh_face_is_out(drawn, of)) {
        for (unsigned i = 0; i < 3; i++) {
            corners->at[i] = &drawn->vertices[of[i]];
            corners->clipped[i] = NULL;
        }
        return;
    }
    const struct glint_mesh_bench *bench = (const struct glint_mesh_bench *)target->frame->memory;
    const struct glint_mesh_clipped *polygon = bench->polygon.list[bench->polygon.now].corner;
    for (unsigned i = 0; i < 3; i++) {
        corners->at[i] = &bench->vertex[i];
        corners->clipped[i] = &polygon[i == 0 ? 0 : bench->fan + i - 2u];
    }
}

/* |difference| < 2^16, weight <= 2^15: their product fits. */
void glint_mesh_corners_weigh(const struct glint_mesh_corners *corners, int16_t of[3][3])
{
    if (!corners->clipped[0])
        return;
    for (unsigned k = 0; k < 3; k++) {
        const int32_t first = of[0][k], second = of[1][k] - first, third = of[2][k] - first;
        for (unsigned i = 0; i < 3; i++) {
            const uint16_t *weight = corners->clipped[i]->weight;
            of[i][k] =
                (int16_t)(first + (int32_t)(((int64_t)second * weight[0] + (int64_t)third * weight[1] + 16384) >> 15));
        }
    }
}

/* d over the area, a pixel, where |d| < 2^32 and the reciprocal is <= 2^31 + 15 and rounded: their product fits. */
static int64_t across_step(int64_t d, uint32_t reciprocal, unsigned down)
{
    return (d * (int64_t)reciprocal) >> down;
}

void glint_mesh_across_set(struct glint_mesh_across *across, const struct glint_mesh_corners *corners, int16_t of[3][3])
{
    const struct glint_mesh_vertex *a = corners->at[0], *b = corners->at[1], *c = corners->at[2];
    const int32_t x1 = b->x - a->x, y1 = b->y - a->y, x2 = c->x - a->x, y2 = c->y - a->y;
    const uint32_t size = 0 - (uint32_t)glint_mesh_area(a, b, c); /* the face shows */
    const unsigned left = glint_mesh_zeros(size),
                   down = 44 - left; /* 1 / size = reciprocal 2^(left - 62); 16 2^14 of it */
    const uint32_t reciprocal = glint_reciprocal(size << left >> 4);
    across->x = a->x >> 4;
    across->y = a->y >> 4;
    for (unsigned k = 0; k < 3; k++) {
        struct glint_mesh_slope *const slope = &across->of[k];
        const int32_t first = of[0][k], second = of[1][k], third = of[2][k];
        const int64_t p = first - second, q = first - third; /* the area is below 0 */
        const int64_t x = across_step(p * y2 - q * y1, reciprocal, down),
                      y = across_step(q * x1 - p * x2, reciprocal, down);
        slope->x = (uint32_t)x;
        slope->y = (uint32_t)y;
        slope->at = ((uint32_t)first << 14) + (uint32_t)((x * (8 - (a->x & 15)) + y * (8 - (a->y & 15))) >> 4);
        slope->least = (int16_t)(first < second ? first : second);
        slope->least = (int16_t)(third < slope->least ? third : slope->least);
        slope->most = (int16_t)(first > second ? first : second);
        slope->most = (int16_t)(third > slope->most ? third : slope->most);
    }
}
