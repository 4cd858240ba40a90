/* SPDX-License-Identifier: MIT
 * glint render: options, and the way from files to a picture. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "base/text.h"
#include "commands/commands.h"
#include "compare/compare.h"
#include "compare/compare_json.h"
#include "compare/mesh_scene.h"
#include "draw/canvas.h"
#include "draw/mesh_canvas.h"
#include "image/format.h"
#include "image/levels.h"
#include "image/picture.h"
#include "image/write.h"
#include "models/models.h"
#include "options/render_options.h"
#include "scene/maps.h"

/* What is drawn, and what --compare takes for the truth. */
struct drawn {
    struct scene *scene;      /* of a mesh: only where it is compared */
    struct shading *shadings; /* of each of its parts */
    struct mesh_coverage coverage;
    bool is_mesh;
    uint32_t width, height;
    uint8_t *pixels;
    struct levels *levels;   /* of the pixels, where they are not drawn otherwise */
    struct levels *compared; /* what is compared, where it is not the picture: a mesh's with stepped outlines */
};

static void print_coverage(const struct drawn *drawn, FILE *stream)
{
    fprintf(
        stream,
        "the mesh covers %zu pixels; %zu, at edges, are not compared: there the double render has another triangle\n",
        drawn->coverage.drawn, drawn->coverage.different);
    if (drawn->coverage.texels)
        fprintf(stream, "%zu more show the next pixel of a texture, and are not compared either\n",
                drawn->coverage.texels);
}

static void report(const struct render_options *options, const struct drawn *drawn, const struct levels *levels,
                   struct output *error_map_output)
{
    const struct scene *scene = drawn->scene;
    const struct shading *shading = drawn->shadings;
    /* A picture on standard output leaves only standard error for words. */
    const bool to_stdout = options->output && strcmp(options->output, "-") == 0;
    FILE *stream = to_stdout ? stderr : stdout;
    struct comparison comparison;
    compare(scene, shading, levels, &comparison);
    if (options->json) {
        comparison_print_json(&comparison, shading, levels, drawn->is_mesh ? &drawn->coverage : NULL, stream);
    } else {
        if (options->output && !to_stdout) {
            text_print(stream, options->output);
            fputs(": ", stream);
        }
        comparison_print(&comparison, shading, levels, stream);
        if (drawn->is_mesh)
            print_coverage(drawn, stream);
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
        fail("standard %s: the comparison could not be written: %s", stream == stdout ? "output" : "error",
             strerror(errno));
}

static void draw_mesh(const struct render_options *options, struct drawn *drawn)
{
    const struct shading_options *look = &options->look;
    struct mesh *mesh = mesh_load(&look->scene.mesh);
    struct fitted *fitted = mesh_fit(mesh, 0);
    shading_options_grain(look, fitted);
    if (shading_options_one_color(look))
        fitted_forget_colors(fitted);
    if (look->scene.mesh.stepped)
        fitted_forget_neighbours(fitted);
    const uint32_t width = look->scene.width ? look->scene.width : SCENE_SIDE;
    const uint32_t height = look->scene.width ? look->scene.height : SCENE_SIDE;
    const struct view view = view_of_options(&look->view, width, height, look->scene.mesh.built_in);
    const struct shading shading = shading_of_options(look, look->shading.format, &plain_finish);
    *drawn = (struct drawn){.is_mesh = true, .width = width, .height = height};
    drawn->shadings = mesh_shadings(mesh, &shading, shading_options_own(look));
    struct mesh_canvas *canvas = mesh_canvas_new(fitted, drawn->shadings);
    drawn->pixels = allocate(height, format_line_bytes(shading.format, width));
    uint8_t *rgb = scene_backdrop(&look->scene, width, height);
    uint8_t *behind = backdrop_pixels(rgb, width, height, &shading);
    mesh_canvas_set_backdrop(canvas, behind);
    mesh_canvas_draw(canvas, &view, NULL, drawn->pixels);
    if (options->gouraud && fitted->mesh.textures)
        fail("%s: --gouraud draws no textures; give --no-textures", mesh->name);
    if (options->gouraud)
        drawn->levels = mesh_gouraud(mesh, fitted, &view, drawn->shadings);
    if (options->compare && !options->gouraud) {
        uint8_t *stepped = allocate(height, format_line_bytes(shading.format, width));
        mesh_canvas_draw_stepped(canvas, &view, stepped);
        drawn->compared = levels_of_pixels(width, height, shading.format, stepped);
        free(stepped);
    }
    if (options->compare)
        drawn->scene = mesh_scene(mesh, fitted, &view, drawn->shadings, &drawn->coverage);
    free(rgb);
    free(behind);
    mesh_canvas_free(canvas);
    fitted_free(fitted);
    mesh_free(mesh);
}

static void draw_map(const struct render_options *options, struct drawn *drawn)
{
    struct scene_maps *maps = scene_maps_read(&options->look.scene);
    *drawn = (struct drawn){.scene = scene_of_shading_options(&options->look, maps, 0, 0)};
    scene_maps_free(maps);
    drawn->width = drawn->scene->width;
    drawn->height = drawn->scene->height;
    drawn->shadings = allocate(1, sizeof *drawn->shadings);
    *drawn->shadings = shading_of_options(&options->look, options->look.shading.format, &drawn->scene->finish);
    drawn->pixels = shade_pixels(drawn->scene, drawn->shadings);
}

int command_render(int argc, char **argv)
{
    struct render_options options = {0};
    struct drawn drawn = {0};
    render_options_parse(&options, argc, argv);
    (options.look.scene.mesh.name ? draw_mesh : draw_map)(&options, &drawn);
    const enum glint_format format = drawn.shadings->format;
    struct levels *levels =
        drawn.levels ? drawn.levels : levels_of_pixels(drawn.width, drawn.height, format, drawn.pixels);
    /* Both are there in full before one gets its name. */
    struct output *output = options.output ? output_open(options.output) : NULL;
    struct output *error_map_output = options.error_map ? output_open(options.error_map) : NULL;
    if (output && options.raw) {
        pixels_write(drawn.pixels, drawn.height * format_line_bytes(format, drawn.width), output);
    } else if (output) {
        struct picture *picture = levels_picture(levels, options.widen);
        picture_write(picture, output, options.kind);
        picture_free(picture);
    }
    if (options.compare)
        report(&options, &drawn, drawn.compared ? drawn.compared : levels, error_map_output);
    if (output)
        output_close(output);
    if (error_map_output)
        output_close(error_map_output);
    levels_free(levels);
    if (drawn.compared)
        levels_free(drawn.compared);
    free(drawn.pixels);
    free(drawn.shadings);
    scene_free(drawn.scene);
    return EXIT_GOOD;
}
