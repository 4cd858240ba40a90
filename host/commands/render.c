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
#include "draw/paths.h"
#include "image/format.h"
#include "image/levels.h"
#include "image/picture.h"
#include "image/write.h"
#include "models/models.h"
#include "options/map_options.h"
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
    const bool to_stdout = options->output && output_is_standard(options->output);
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
        drawn->levels = mesh_gouraud(mesh, fitted, &view, drawn->shadings, behind);
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

/* ---- maps, in parts ---- */

enum { PART_PIXELS = 1 << 20, PART_LINES = 8 }; /* about, with 60 bytes each; at least */

static uint32_t part_lines(const struct render_options *options, uint32_t width, uint32_t height)
{
    const uint32_t lines = PART_PIXELS / width / PART_LINES * PART_LINES;
    if (options->compare || !path_draws_all(options->look.shading.path))
        return height;
    return lines < PART_LINES ? PART_LINES : lines < height ? lines : height;
}

/* What is written of a picture, part by part. */
struct written {
    struct output *output; /* NULL: nothing is */
    struct picture_file *file;
    uint32_t height;
};

static void write_part(const struct render_options *options, struct written *to, const uint8_t *pixels,
                       enum glint_format format, const struct levels *levels)
{
    if (!to->output)
        return;
    if (options->raw) {
        pixels_write(pixels, levels->height * format_line_bytes(format, levels->width), to->output);
        return;
    }
    struct picture *picture = levels_picture(levels, options->widen);
    if (!options->gouraud)
        picture_add_alpha(picture, format, pixels);
    if (!to->file)
        to->file = picture_file_begin(to->output, options->kind, picture, to->height);
    picture_file_add(to->file, picture);
    picture_free(picture);
}

static void write_end(struct written *to)
{
    if (to->file)
        picture_file_end(to->file);
}

/* The last part's scene stays: where it is compared, it is all. */
static struct levels *draw_map(const struct render_options *options, struct drawn *drawn, struct written *to)
{
    struct scene_maps *maps = scene_maps_read(&options->look.scene);
    struct scene_lines *lines = scene_lines_new(maps, 0, 0);
    struct levels *levels = NULL;
    uint32_t width, height;
    scene_lines_size(lines, &width, &height);
    *drawn = (struct drawn){.width = width, .height = height};
    drawn->shadings = allocate(1, sizeof *drawn->shadings);
    to->height = height;
    to->output = options->output ? output_open(options->output) : NULL; /* no input, all of which are read */
    const uint32_t count = part_lines(options, width, height);
    for (uint32_t top = 0; top < height; top += count) {
        if (levels) {
            levels_free(levels);
            scene_free(drawn->scene);
            progress("glint render: line %u of %u", top, height);
        }
        drawn->scene =
            scene_lines_of_shading_options(&options->look, lines, top, height - top < count ? height - top : count);
        *drawn->shadings = shading_of_options(&options->look, options->look.shading.format, &drawn->scene->finish);
        const enum glint_format format = drawn->shadings->format;
        uint8_t *pixels = shade_pixels(drawn->scene, drawn->shadings);
        levels = levels_of_pixels(width, drawn->scene->height, format, pixels);
        write_part(options, to, pixels, format, levels);
        free(pixels);
    }
    progress_end();
    scene_lines_end(lines);
    scene_maps_free(maps);
    return levels;
}

int command_render(int argc, char **argv)
{
    struct render_options options = {0};
    struct drawn drawn = {0};
    map_options_in_parts = true;
    render_options_parse(&options, argc, argv);
    struct written to = {0};
    struct levels *levels;
    if (options.look.scene.mesh.name) {
        draw_mesh(&options, &drawn);
        const enum glint_format format = drawn.shadings->format;
        levels = drawn.levels ? drawn.levels : levels_of_pixels(drawn.width, drawn.height, format, drawn.pixels);
        to = (struct written){.output = options.output ? output_open(options.output) : NULL, .height = drawn.height};
        write_part(&options, &to, drawn.pixels, format, levels);
    } else {
        levels = draw_map(&options, &drawn, &to);
    }
    write_end(&to);
    /* Both are there in full before one gets its name. */
    struct output *error_map_output = options.error_map ? output_open(options.error_map) : NULL;
    if (options.compare)
        report(&options, &drawn, drawn.compared ? drawn.compared : levels, error_map_output);
    if (to.output)
        output_close(to.output);
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
