/* SPDX-License-Identifier: MIT
 * What baking costs: pictures of the highlight alone, at full strength on white, where an error is largest. */
#include "compare/quality.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/stop.h"
#include "draw/canvas.h"
#include "image/levels.h"

/* Straight on, then around at two heights, so that half vectors lie as the light's play puts them. */
enum { LIGHTS = 9 };

static void direct(struct shading *shading, int light)
{
    const double slope = light == 0 ? 0 : light <= 4 ? .7 : 1.7;
    const double turn = .3 + light * M_PI / 2 + (light > 4 ? M_PI / 4 : 0);
    shading->lamps[0].direction[0] = slope * cos(turn);
    shading->lamps[0].direction[1] = slope * sin(turn);
    shading->lamps[0].direction[2] = 1;
}

static void add_light(const struct scene *exact, const struct scene *lossy, unsigned n, int light,
                      struct difference *difference)
{
    struct shading shading = {.model = GLINT_MSH,
                              .n = n,
                              .q = 8,
                              .view = {0, 0, 1},
                              .lamps = {{.kind = LAMP_DIRECTIONAL, .color = {1, 1, 1}}},
                              .lamp_count = 1,
                              .specular = {1, 1, 1},
                              .color = {255, 255, 255},
                              .format = GLINT_GREY8,
                              .clamp_peak = true};
    direct(&shading, light);
    struct levels *wanted = shade_scene(exact, &shading), *found = shade_scene(lossy, &shading);
    for (size_t i = 0; i < (size_t)exact->width * exact->height; i++)
        if (!exact->mask || exact->mask[i])
            difference_add(difference, wanted->values[i] / 255., found->values[i] / 255., (uint32_t)(i % exact->width),
                           (uint32_t)(i / exact->width), 0);
    levels_free(wanted);
    levels_free(found);
}

void bake_quality(const struct scene *scene, const struct baked *baked, struct quality rows[QUALITY_ROWS])
{
    static const unsigned shininess[QUALITY_ROWS] = {10, 60, 200, 1000};
    const size_t pixels = (size_t)scene->width * scene->height;
    struct scene exact = *scene, lossy;
    exact.albedo = exact.gloss = exact.shininess = NULL;
    lossy = exact;
    lossy.normals = allocate(pixels, sizeof *lossy.normals);
    for (size_t i = 0; i < pixels; i++) {
        const struct glint_vec v = baked_normal(baked, i);
        lossy.normals[i][0] = v.x / 32768.; /* and back, unchanged */
        lossy.normals[i][1] = v.y / 32768.;
        lossy.normals[i][2] = v.z / 32768.;
    }
    for (int row = 0; row < QUALITY_ROWS; row++) {
        struct difference each[LIGHTS] = {{0}};
        sigset_t before;
        signals_hold_but_faults(&before); /* the first thread alone takes them, at once */
#pragma omp parallel
        {
#pragma omp master
            signals_release(&before);
#pragma omp for schedule(dynamic)
            for (int light = 0; light < LIGHTS; light++)
                add_light(&exact, &lossy, shininess[row], light, &each[light]);
        }
        rows[row] = (struct quality){.n = shininess[row]};
        for (int light = 0; light < LIGHTS; light++) /* in order: the same sums each time */
            difference_merge(&rows[row].difference, &each[light]);
    }
    free(lossy.normals);
}
