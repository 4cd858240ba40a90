/* SPDX-License-Identifier: MIT
 * glint render: options, and the way from files to a picture. */
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "base/output.h"
#include "base/text.h"
#include "commands/commands.h"
#include "compare/compare.h"
#include "compare/compare_json.h"
#include "draw/canvas.h"
#include "image/format.h"
#include "image/levels.h"
#include "image/picture.h"
#include "image/write.h"
#include "models/models.h"
#include "options/render_options.h"

static void report(const struct render_options *options, const struct scene *scene, const struct shading *shading,
                   const struct levels *levels, struct output *error_map_output)
{
    /* A picture on standard output leaves only standard error for words. */
    const bool to_stdout = options->output && strcmp(options->output, "-") == 0;
    FILE *stream = to_stdout ? stderr : stdout;
    struct comparison comparison;
    compare(scene, shading, levels, &comparison);
    if (options->json) {
        comparison_print_json(&comparison, shading, levels, stream);
    } else {
        if (options->output && !to_stdout) {
            text_print(stream, options->output);
            fputs(": ", stream);
        }
        comparison_print(&comparison, shading, levels, stream);
    }
    if (error_map_output) {
        const bool blinn = options->against_blinn;
        const unsigned times = error_map_amplification(blinn ? &comparison.blinn_unrounded : &comparison.unrounded);
        struct picture *map = error_map(scene, shading, levels, blinn ? GLINT_BLINN : shading->model, times);
        picture_write(map, error_map_output, options->error_map_kind);
        picture_free(map);
        if (!options->json) {
            text_print(stream, options->error_map);
            fprintf(stream, ": errors against %s in double, times %u\n",
                    model_names[blinn ? GLINT_BLINN : shading->model], times);
        }
    }
    if (fflush(stream) != 0 || ferror(stream))
        fail("standard %s: the comparison could not be written", stream == stdout ? "output" : "error");
}

int command_render(int argc, char **argv)
{
    struct render_options options = {0};
    render_options_parse(&options, argc, argv);
    struct scene_maps *maps = scene_maps_read(&options.look.scene);
    struct scene *scene = scene_of_shading_options(&options.look, maps, 0, 0);
    scene_maps_free(maps);
    const struct shading shading = shading_of_options(&options.look, options.look.shading.format, scene);
    uint8_t *pixels = shade_pixels(scene, &shading);
    struct levels *levels = levels_of_pixels(scene->width, scene->height, shading.format, pixels);
    /* Both are there in full before one gets its name. */
    struct output *output = options.output ? output_open(options.output) : NULL;
    struct output *error_map_output = options.error_map ? output_open(options.error_map) : NULL;
    if (output && options.raw) {
        pixels_write(pixels, scene->height * format_line_bytes(shading.format, scene->width), output);
    } else if (output) {
        struct picture *picture = levels_picture(levels);
        picture_write(picture, output, options.kind);
        picture_free(picture);
    }
    if (options.compare)
        report(&options, scene, &shading, levels, error_map_output);
    if (output)
        output_close(output);
    if (error_map_output)
        output_close(error_map_output);
    levels_free(levels);
    free(pixels);
    scene_free(scene);
    return EXIT_GOOD;
}
