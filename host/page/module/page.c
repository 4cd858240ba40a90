/* SPDX-License-Identifier: MIT
 * The picture: the words of `glint render` into pixels, keeping what a moving light does not change. */
#include "page.h"

#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/message.h"
#include "draw/canvas.h"
#include "draw/paths.h"
#include "files.h"
#include "image/format.h"
#include "image/levels.h"
#include "image/picture.h"
#include "mesh.h"
#include "options/drawing_options.h"
#include "options/shading_options.h"
#include "scene/scenes.h"
#include "state.h"
#include "words.h"

static struct page_state state;

const struct page_state *page_state(void)
{
    return &state;
}

void *page_allocate(size_t bytes)
{
    return allocate(bytes, 1);
}

void page_image(char *name, uint32_t width, uint32_t height, uint32_t channels, uint32_t bits, uint32_t palette,
                uint16_t *samples)
{
    const struct image image = {.width = width,
                                .height = height,
                                .channels = channels,
                                .bits = bits,
                                .palette = palette != 0,
                                .samples = samples};
    files_add_image(name, &image);
    free(name);
}

void page_mesh_file(char *name, uint8_t *bytes, size_t len)
{
    files_add_mesh(name, bytes, len);
    free(name);
}

void page_forget(char *name)
{
    files_remove(name);
    free(name);
}

/* ---- the options of glint render, but for its outputs ---- */

static error_t parse_option(int key, char *text, struct argp_state *argp_state)
{
    (void)text;
    struct shading_options *look = argp_state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        argp_state->child_inputs[0] = look;
        return 0;
    case ARGP_KEY_END:
        shading_options_check(argp_state, look, &look->shading);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

struct shading_options page_parse(char *text, size_t bytes)
{
    static const struct argp_child children[] = {{&drawing_options_argp, 0, NULL, 0}, {NULL, 0, NULL, 0}};
    static const struct argp argp = {NULL, parse_option, NULL, NULL, children, NULL, NULL};
    struct shading_options look = {.has_color = false};
    struct words words;
    words_split(&words, text, bytes);
    parse_command(&argp, 0, words.count, words.list, &look);
    return look;
}

/* Without a scene, which a map of shininess and a metal's grain refuse each other for. */
void page_check(char *text, size_t bytes)
{
    const struct shading_options look = page_parse(text, bytes);
    const struct scene_options *scene = &look.scene;
    if (!scene->mesh.name) {
        const struct shading shading = shading_of_options(&look, look.shading.format, scene_finish(scene->scene));
        const char *refusal = path_refusal(&shading);
        if (!refusal)
            refusal = path_material_refusal(&shading);
        if (!refusal && scene->filter && shading.n_across && shading.n_across != shading.n)
            refusal = "a surface with grain takes no map of shininess";
        if (refusal)
            fail("%s", refusal);
    }
    free(text);
}

/* ---- the picture ---- */

static void draw(void)
{
    if (page_mesh())
        mesh_draw_again(state.pixels);
    else
        canvas_draw(state.canvas, &state.shading, state.pixels);
}

static void show(void)
{
    levels_free(state.levels);
    free(state.rgba);
    state.levels = levels_of_pixels(state.width, state.height, state.shading.format, state.pixels);
    struct picture *picture = levels_picture(state.levels, WIDEN_NEAREST);
    picture_add_alpha(picture, state.shading.format, state.pixels);
    state.rgba = rgba_of_picture(picture);
    picture_free(picture);
}

uint8_t *rgba_of_picture(const struct picture *picture)
{
    const size_t pixels = (size_t)picture->width * picture->height;
    const unsigned channels = picture->channels;
    uint8_t *rgba = allocate(pixels, 4);
    for (size_t i = 0; i < pixels; i++) {
        for (unsigned k = 0; k < 3; k++)
            rgba[4 * i + k] = picture->samples[channels * i + (channels > 1 ? k : 0)];
        rgba[4 * i + 3] = channels == 4 ? picture->samples[4 * i + 3] : 255;
    }
    return rgba;
}

static void forget_canvas(void)
{
    canvas_free(state.canvas);
    free(state.pixels);
    state.canvas = NULL;
    state.pixels = NULL;
}

/* Black where a mask leaves it. */
static void make_pixels(uint32_t width, uint32_t height, enum glint_format format)
{
    state.width = width;
    state.height = height;
    state.pixels_bytes = height * format_line_bytes(format, width);
    if (!state.pixels)
        state.pixels = allocate(state.pixels_bytes, 1);
}

static void draw_scene(const struct shading_options *look, uint32_t keep)
{
    if (keep < PAGE_KEEP_SCENE) {
        mesh_forget();
        scene_free(state.scene);
        struct scene_maps *maps = scene_maps_read(&look->scene);
        state.scene = scene_of_shading_options(look, maps, 0, 0);
        scene_maps_free(maps);
    }
    state.shading = shading_of_options(look, look->shading.format, &state.scene->finish);
    if (!state.canvas)
        state.canvas = canvas_new(state.scene, &state.shading);
    make_pixels(state.scene->width, state.scene->height, state.shading.format);
    draw();
}

static void draw_mesh(const struct shading_options *look, uint32_t keep)
{
    const uint32_t width = look->scene.width ? look->scene.width : SCENE_SIDE;
    const uint32_t height = look->scene.width ? look->scene.height : SCENE_SIDE;
    scene_free(state.scene);
    state.scene = NULL;
    make_pixels(width, height, look->shading.format);
    state.shading = mesh_draw(look, width, height, keep, state.pixels);
}

void page_draw(char *text, size_t bytes, uint32_t keep)
{
    const struct shading_options look = page_parse(text, bytes);
    if (keep < PAGE_KEEP_CANVAS)
        forget_canvas();
    (look.scene.mesh.name ? draw_mesh : draw_scene)(&look, keep);
    free(text); /* the options point into it; scene and mesh do not */
    show();
}

void page_again(uint32_t times)
{
    for (uint32_t i = 0; i < times; i++)
        draw();
}

uint32_t page_width(void)
{
    return state.width;
}

uint32_t page_height(void)
{
    return state.height;
}

const uint8_t *page_pixels(void)
{
    return state.pixels;
}

size_t page_pixels_bytes(void)
{
    return state.pixels_bytes;
}

const uint8_t *page_rgba(void)
{
    return state.rgba;
}
