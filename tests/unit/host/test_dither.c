/* SPDX-License-Identifier: MIT
 * Dithered table loops beside the exact dithered path: how much of the rings each leaves. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "compare/reference.h"
#include "draw/canvas.h"
#include "draw/paths.h"
#include "scene/scenes.h"
#include "unit.h"

enum { SIDE = 160, BOX = 4 };

static double square(double x)
{
    return x * x;
}

/* The PSNR in dB of means over boxes of 4x4 pixels, from those of the double render: what an eye sees that does not resolve the
 * pixels. */
static double boxed_psnr(const struct scene *scene, const struct shading *shading)
{
    static double render[SIDE][3 * SIDE];
    struct levels *levels = shade_scene(scene, shading);
    for (uint32_t y = 0; y < SIDE; y++)
        reference_line(scene, shading, shading->model, y, render[y]);
    double sum = 0;
    unsigned count = 0;
    for (int y = 0; y + BOX <= SIDE; y++)
        for (int x = 0; x + BOX <= SIDE; x++) {
            double off[3] = {0, 0, 0};
            bool whole = true;
            for (int i = 0; i < BOX * BOX; i++) {
                const int line = y + i / BOX, at = x + i % BOX;
                whole = whole && (!scene->mask || scene->mask[line * SIDE + at]);
                for (int k = 0; k < 3; k++)
                    off[k] +=
                        (double)levels->values[3 * (line * SIDE + at) + k] / levels->max[k] - render[line][3 * at + k];
            }
            for (int k = 0; whole && k < 3; k++, count++)
                sum += square(off[k] / (BOX * BOX));
        }
    levels_free(levels);
    assert_true(count > 3 * SIDE * SIDE / 4);
    return 10 * log10(count / sum);
}

static unsigned path_number(const char *name)
{
    for (unsigned i = 0; path_names[i]; i++)
        if (strcmp(path_names[i], name) == 0)
            return i;
    fail_msg("no path %s", name);
    return 0;
}

/* The scene as the path stores its normals, without its maps. */
static struct scene *stored_scene(const char *name, enum glint_normals held)
{
    struct scene *scene = scene_draw(name, SIDE, SIDE);
    struct glint_vec *normals = scene_normals_q15(scene);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const struct glint_vec n = held == GLINT_NORMALS_INT16
                                       ? normals[i]
                                       : glint_normals_unpack(held, glint_normals_pack(held, &normals[i]));
        scene->normals[i][0] = n.x / 32768.;
        scene->normals[i][1] = n.y / 32768.;
        scene->normals[i][2] = n.z / 32768.;
    }
    free(normals);
    free(scene->albedo);
    free(scene->gloss);
    scene->albedo = scene->gloss = NULL;
    return scene;
}

static struct shading shading_of(const struct scene *scene, const uint8_t color[3])
{
    struct shading s = {.model = GLINT_MSH,
                        .n = scene->finish.n,
                        .q = 8,
                        .lamps = {{.kind = LAMP_DIRECTIONAL, .direction = {-1, 1, 1}, .color = {1, 1, 1}}},
                        .lamp_count = 1,
                        .view = {0, 0, 1},
                        .format = GLINT_RGB565,
                        .dither = true};
    memcpy(s.ambient, scene->finish.ambient, sizeof s.ambient);
    memcpy(s.diffuse, scene->finish.diffuse, sizeof s.diffuse);
    memcpy(s.specular, scene->finish.specular, sizeof s.specular);
    memcpy(s.color, color, 3);
    return s;
}

static void dithered_tables_are_within_a_decibel_of_the_exact_dithered_path(void **state)
{
    (void)state;
    static const char *const scenes[] = {"sphere", "dial"};
    static const uint8_t colors[][3] = {{200, 200, 200}, {205, 30, 25}, {12, 32, 90}};
    static const struct {
        const char *name;
        enum glint_normals held;
    } ways[] = {{"colour-int16", GLINT_NORMALS_INT16}, {"colour-int8", GLINT_NORMALS_INT8}};
    for (unsigned i = 0; i < 2 * 2 * 3; i++) {
        struct scene *scene = stored_scene(scenes[i % 2], ways[i / 2 % 2].held);
        struct shading shading = shading_of(scene, colors[i / 4]);
        const char *const name = ways[i / 2 % 2].name;
        shading.path = 0;
        const double exact = boxed_psnr(scene, &shading);
        shading.path = path_number(name);
        const double found = boxed_psnr(scene, &shading);
        shading.dither = false;
        const double plain = boxed_psnr(scene, &shading);
        if (found < exact - 1 || found < plain + 10)
            fail_msg("%s, colour %u, %s: %.1f dB, exact %.1f, undithered %.1f", scenes[i % 2], i / 4, name, found,
                     exact, plain);
        scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dithered_tables_are_within_a_decibel_of_the_exact_dithered_path),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
