/* SPDX-License-Identifier: MIT
 * native WORD...: milliseconds that one thread needs to shade the picture of `glint render WORD...` again, the best of many:
 * what the page's module does, by the same functions. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "base/argp.h"
#include "draw/canvas.h"
#include "image/format.h"
#include "options/drawing_options.h"
#include "options/shading_options.h"

enum { ROUNDS = 25 };

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    (void)text;
    if (key != ARGP_KEY_INIT)
        return ARGP_ERR_UNKNOWN;
    state->child_inputs[0] = state->input;
    return 0;
}

int main(int argc, char **argv)
{
    static const struct argp_child children[] = {{&drawing_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {NULL, parse_option, NULL, NULL, children, NULL, NULL};
    struct shading_options look = {.has_color = false};
    parse_command(&argp, 0, argc, argv, &look);
    struct scene *scene = scene_of_options(&look.scene);
    const struct shading shading = shading_of_options(&look, look.shading.format, &scene->finish);
    struct canvas *canvas = canvas_new(scene, &shading);
    uint8_t *pixels = calloc(scene->height, format_line_bytes(shading.format, scene->width));
    double best = 1e9; /* of processor time */
    for (int i = 0; i < ROUNDS; i++) {
        const clock_t start = clock();
        canvas_draw(canvas, &shading, pixels);
        const double took = (double)(clock() - start) / CLOCKS_PER_SEC;
        best = took < best ? took : best;
    }
    printf("%.4f\n", 1000 * best);
    free(pixels);
    canvas_free(canvas);
    scene_free(scene);
    return 0;
}
