/* SPDX-License-Identifier: MIT
 * Fuzzes the words of a command line that draws: they are refused, or make a shading that the library takes. Input: the words, a line each. */
#include <string.h>

#include "base/argp.h"
#include "options/drawing_options.h"
#include "options/shading_options.h"
#include "unwind.h"

struct words {
    int count;
    char *at[40];
};

static void check_shading(const struct shading_options *options)
{
    const struct shading *given = &options->shading;
    const struct shading shading = shading_of_options(options, given->format, &plain_finish);
    check(shading.n >= 1 && shading.n <= GLINT_N_MAX && shading.q >= 1 && shading.q <= GLINT_Q_MAX);
    check(shading.lamp_count >= 1 && shading.lamp_count <= GLINT_LIGHTS_MAX);
    for (unsigned i = 0; i < shading.lamp_count; i++) {
        struct glint_light light;
        check(shading_light(&shading, i, &light) == GLINT_OK);
    }
    const struct glint_material material = shading_material(&shading);
    const struct glint_output output = shading_output(&shading);
    struct glint_paint paint;
    check(glint_paint_exact(&paint, &material, &output) == GLINT_OK);
    for (int k = 0; k < 3; k++)
        check(shading.ambient[k] >= 0 && shading.ambient[k] <= 1 && shading.diffuse[k] >= 0 &&
              shading.diffuse[k] <= 1 && shading.specular[k] >= 0 && shading.specular[k] <= 1);
    check(options->scene.heights || options->scene.normals || options->scene.scene || options->scene.mesh.name);
}

/* The C library's ends the program by itself. */
void argp_state_help(const struct argp_state *state, FILE *stream, unsigned flags)
{
    (void)state;
    (void)stream;
    (void)flags;
    exit(0);
}

static void parse(void *of)
{
    const struct argp_child children[] = {{&drawing_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    const struct argp argp = {NULL, NULL, NULL, NULL, children, NULL, NULL};
    struct words *words = of;
    struct shading_options options;
    FILE *const shown = stdout;
    stdout = stderr;
    parse_command(&argp, 0, words->count, words->at, &options);
    stdout = shown;
    check_shading(&options);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *const text = malloc(size + 1);
    struct words words = {1, {"glint"}};
    FILE *const shown = stdout;
    for (size_t i = 0; i < size; i++)
        text[i] = (char)(data[i] == '\n' ? 0 : data[i]);
    text[size] = 0;
    for (char *at = text; at < text + size && words.count < 39; at += strlen(at) + 1)
        words.at[words.count++] = at;
    unwind_run(parse, &words);
    stdout = shown;
    free(text);
    return 0;
}
