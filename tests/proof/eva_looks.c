/* SPDX-License-Identifier: MIT
 * For Eva: loops over COLOUR and ALBEDO tables as they are filled, of any colours, lights, normals, coverage and spans, for every shift, and triangles
 * of meshes.
 * eva: -eva-precision 1 -eva-min-loop-unroll 24 -eva-slevel 8 -eva-slevel-function colour_glossy:1000,over_off:200,over_part:200,__builtin_clz:200,glint_mesh_zeros:200,glint_colour_int8:3000,fused_dither:3000,fused_albedo:3000 -split-zeros -eva-use-spec glint_mesh_inverse */
#include "eva.h"
#include "eva_meshes.h"
#include "glint_mesh_strip.h"
#include "glint_mesh_texture.h"
#include "glint_tables.h"
#define __asm__(...) (void)0 /* which tells a compiler alone */
#define __builtin_expect_with_probability(condition, as, how) (condition)
#include "fused_mesh.c" /* in its place */

enum { WIDE = 5, HIGH = 2 };
static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4], pixels[WIDE * HIGH], words[2 * WIDE * HIGH];
static uint16_t albedo[WIDE * HIGH];
static uint8_t coverage[WIDE * HIGH];
static struct glint_paint paint;
static struct glint_mesh_bench bench;
static struct glint_mesh_frame frame;
static struct glint_mesh_drawn drawn;

/* t_max is at most 1, and below what the columns of its shift hold. */
static void shift_to(uint8_t shift, unsigned columns_log)
{
    const uint32_t t_max = any % (GLINT_T_ONE + 1), most = (((uint32_t)1 << columns_log) << shift) - 1;
    paint.of.tables.filled.t_max_q30 = t_max > most ? most : t_max;
    paint.of.tables.filled.shift = shift;
}

/* As glint_paint_tables_filled and glint_paint_light leave it: x is at most 128 times a component, and y half one. */
static void lit(const struct glint_use_tables *use, unsigned columns_log, uint8_t shift, uint8_t format)
{
    struct glint_tables *const tables = &paint.of.tables.filled;
    ANY_BYTES(memory);
    ANY_BYTES(words);
    ANY_BYTES(albedo);
    ANY_BYTES(coverage);
    tables->colour.sums = memory;
    shift_to(shift, columns_log);
    tables->dark = (uint16_t)any;
    tables->kind = use->kind;
    tables->format = format;
    tables->dither = use->dither;
    tables->use = use;
    paint.output.format = format;
    paint.light_count = 1;
    paint.l = any_vector();
    paint.v = any_vector();
    paint.h = any_vector();
    paint.of.tables.x = any_signed % 4210689;
    paint.of.tables.y = any_signed % 16385;
    paint.of.tables.z = any_signed % 16385;
    paint.of.tables.cut = any_signed;
    paint.of.tables.peak = any_signed;
    paint.of.tables.r = any;
    paint.of.tables.a = any % 32;
    paint.of.tables.is_frontal = false;
}

static void of_colours(uint8_t shift)
{
    uint8_t *const columns = (uint8_t *)memory + 2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS;
    lit(&glint_use_colour, GLINT_COLOUR_COLUMNS_LOG, shift, GLINT_RGB565);
    for (unsigned i = 0; i < 1 << GLINT_COLOUR_COLUMNS_LOG; i++)
        columns[i] = (uint8_t)(2 * (any % GLINT_COLOUR_STEPS));
    paint.of.tables.filled.columns = columns;
}
static void of_dither(uint8_t shift)
{
    lit(&glint_use_colour_dithered, GLINT_DITHER_COLUMNS_LOG, shift, shift & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED);
    paint.of.tables.filled.columns = (const uint8_t *)memory + GLINT_DITHER_SHINES;
}
static void of_levels(uint8_t shift)
{
    lit(&glint_use_albedo, GLINT_ALBEDO_COLUMNS_LOG, shift, shift & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED);
    paint.of.tables.filled.columns = (const uint8_t *)memory + GLINT_ALBEDO_LEVELS;
    paint.of.tables.filled.colour.sums = memory + GLINT_ALBEDO_LEVELS / 4;
}

static struct glint_maps maps_of(bool has_albedo)
{
    const struct glint_maps maps = {.normals = words,
                                    .normals_stride = 6 * WIDE,
                                    .albedo = has_albedo ? (const uint8_t *)albedo : NULL,
                                    .albedo_stride = 2 * WIDE,
                                    .normals_format = GLINT_NORMALS_INT16,
                                    .albedo_format = GLINT_RGB565};
    return maps;
}

/* INT16 normals, with the highlight's box and without. */
static void rect(bool has_albedo)
{
    const struct glint_maps maps = maps_of(has_albedo);
    const struct glint_surface surface = {pixels, 2 * WIDE, (uint16_t)any, (uint16_t)any};
    struct glint_box box;
    (void)glint_draw_rect(&paint, &maps, WIDE, HIGH, &surface, NULL);
    (void)glint_draw_rect(&paint, &maps, WIDE, HIGH, &surface, &box);
}
#define SHIFTS(columns_log) (uint8_t shift = 0; shift <= 31 - (columns_log); shift++)
void eva_colour_int16(void)
{
    for
        SHIFTS(GLINT_COLOUR_COLUMNS_LOG)
        {
            of_colours(shift);
            rect(false);
        }
}
void eva_dither_int16(void)
{
    for
        SHIFTS(GLINT_DITHER_COLUMNS_LOG)
        {
            of_dither(shift);
            rect(false);
        }
}
void eva_albedo_int16(void)
{
    for
        SHIFTS(GLINT_ALBEDO_COLUMNS_LOG)
        {
            of_levels(shift);
            rect(true);
        }
}

/* With maps of gloss and shininess. Eva does not see that y - surface.y is the line, so that the first line's y is one number. */
static void mapped(const struct glint_use_tables *use, bool has_albedo)
{
    static uint8_t gloss[WIDE * HIGH], shininess[WIDE * HIGH];
    struct glint_maps maps = maps_of(has_albedo);
    const struct glint_surface surface = {pixels, 2 * WIDE, (uint16_t)any, UINT16_MAX};
    ANY_BYTES(gloss);
    ANY_BYTES(shininess);
    paint.of.tables.filled.use = use;
    paint.of.tables.filled.n = (uint16_t)(1 + any % GLINT_N_MAX);
    maps.gloss_stride = maps.shininess_stride = WIDE;
    maps.gloss = gloss;
    (void)glint_draw_rect(&paint, &maps, WIDE, HIGH, &surface, NULL);
    maps.shininess = shininess;
    (void)glint_draw_rect(&paint, &maps, WIDE, HIGH, &surface, NULL);
}
void eva_colour_mapped(void)
{
    of_colours(12);
    mapped(&glint_use_colour_maps, false);
}
void eva_dither_mapped(void)
{
    of_dither(12);
    mapped(&glint_use_colour_dithered_maps, false);
}
void eva_albedo_mapped(void)
{
    of_levels(12);
    mapped(&glint_use_albedo_maps, true);
}

/* The general way of INT8: samples of any words, and their pixels. */
static void words_as_pixels(void)
{
    const struct glint_use_tables *use = paint.of.tables.filled.use;
    const struct glint_run run = {
        (uint8_t *)pixels, any % 4, any % 65536, any, (const uint8_t *)albedo, NULL, NULL, 0, NULL, NULL};
    struct glint_raw raws[WIDE];
    use->raws(&paint, words, raws, WIDE);
    use->pixels(&paint, &run, raws, WIDE);
}
void eva_colour_int8(void)
{
    for
        SHIFTS(GLINT_COLOUR_COLUMNS_LOG)
        {
            of_colours(shift);
            words_as_pixels();
        }
}
void eva_dither_int8(void)
{
    for
        SHIFTS(GLINT_DITHER_COLUMNS_LOG)
        {
            of_dither(shift);
            words_as_pixels();
        }
}
void eva_albedo_int8(void)
{
    for
        SHIFTS(GLINT_ALBEDO_COLUMNS_LOG)
        {
            of_levels(shift);
            words_as_pixels();
        }
}

/* Fused: a line of any words, gaps too. Which column a normal leads to does not hang on the shift. */
void eva_colour_words(void)
{
    of_colours(12);
    for (uint32_t w = 1; w <= WIDE; w++)
        glint_colour_int8(&paint, words, w, (uint16_t *)pixels);
}
void eva_dither_words(void)
{
    of_dither(12);
    for (uint32_t w = 1; w <= WIDE; w++)
        for (uint32_t phase = 0; phase < 8; phase += 2) {
            glint_dither_int8_plain(&paint, words, w, (uint16_t *)pixels, phase, any);
            glint_dither_int8_swapped(&paint, words, w, (uint16_t *)pixels, phase, any);
        }
}
/* In Q25, as eva_tables.c shows of eva_light_albedo; levels begin with memory. */
void eva_albedo_words(void)
{
    of_levels(12);
    paint.of.tables.x = any_signed % 263169;
    paint.of.tables.y = any_signed % 1025;
    paint.of.tables.z = any_signed % 1025;
    for (uint32_t w = 1; w <= WIDE; w++) {
        glint_albedo_int8(&paint, words, albedo, w, (uint16_t *)pixels);
        glint_albedo_int8_swapped(&paint, words, albedo, w, (uint16_t *)pixels);
    }
}

/* Spans: by the fused loop where there is one, and by samples, with a highlight's box. */
static void span(uint16_t w, bool has_albedo)
{
    const struct glint_maps maps = maps_of(has_albedo);
    const struct glint_surface surface = {pixels, 0, (uint16_t)any, (uint16_t)any};
    const struct glint_span at = {any, any, any, any_signed, any_signed, w, {{0, 0}, {0, 0}}};
    struct glint_box box;
    (void)glint_draw_span(&paint, &at, has_albedo ? &maps : NULL, &surface, NULL);
    (void)glint_draw_span(&paint, &at, has_albedo ? &maps : NULL, &surface, &box);
}
void eva_colour_spans(void)
{
    for
        SHIFTS(GLINT_COLOUR_COLUMNS_LOG)
        {
            of_colours(shift);
            for (uint16_t w = 1; w <= WIDE; w++)
                span(w, false);
        }
}
void eva_dither_spans(void)
{
    for
        SHIFTS(GLINT_DITHER_COLUMNS_LOG)
        {
            of_dither(shift);
            span(WIDE, false);
        }
}
void eva_albedo_spans(void)
{
    for
        SHIFTS(GLINT_ALBEDO_COLUMNS_LOG)
        {
            of_levels(shift);
            span(WIDE, true);
        }
}

/* ---- Triangles of meshes: strips of two lines of any depths, from each column to each, those outside it, too ---- */

static struct {
    uint16_t depth[WIDE * HIGH],
        pixels[WIDE * HIGH]; /* one array to Eva, as loops go from one to the other by their distance */
} strip;
static struct {
    struct glint_mesh_kept kept;
    struct glint_mesh_laid laid;
} place;

static struct glint_mesh_edge edge_at(int32_t column, int32_t step)
{
    const struct glint_mesh_edge edge = {column * 65536 + (int32_t)(any % 65536), step * 65536};
    return edge;
}

/* Columns from `left` on before `right` in the first line, and what they move by. */
static void triangle(int32_t left, int32_t left_step, int32_t right, int32_t right_step, int16_t middle, bool is_left,
                     uint8_t shine)
{
    const struct glint_mesh_values values = {
        any, any, any, any, any, any, any, any, any, any, any, any, any_signed % 2048};
    const struct glint_mesh_edge on_left = edge_at(left, left_step), on_right = edge_at(right, right_step);
    struct glint_mesh_triangle *const of = &place.kept.triangle;
    of->values = values;
    of->long_edge = is_left ? on_left : on_right;
    of->upper = of->lower = is_left ? on_right : on_left;
    of->y = 0;
    of->y_middle = middle;
    of->y_end = (int16_t)(HIGH + any % 2);
    of->shine = shine;
    of->long_is_left = is_left;
}

/* Triangles take turns in shifts and in how they shine. */
static void strips(void (*draw)(const struct glint_mesh_target *target), unsigned columns_log, uint8_t first)
{
    const struct glint_surface surface = {strip.pixels, 2 * WIDE, (uint16_t)any, (uint16_t)any};
    const struct glint_mesh_target target = {&surface, strip.depth, WIDE, 0, HIGH, bench.polygon.list[1].samples,
                                             &frame,   &drawn,      NULL};
    unsigned turn = 0;
    ANY_BYTES(strip.depth);
    for (int32_t left = -1; left <= WIDE; left++)
        for (int32_t right = 0; right <= WIDE + 1; right++)
            for (int32_t step = -1; step <= 1; step++)
                for (uint8_t shine = first; shine <= GLINT_MESH_GLOSSY; shine++, turn++) {
                    shift_to((uint8_t)(turn % (32 - columns_log)), columns_log);
                    triangle(left, step, right, -step, (int16_t)(1 + step), step & 1, shine);
                    draw(&target);
                }
}

static void by_colours(const struct glint_mesh_target *target)
{
    glint_mesh_colour(&paint.of.tables.filled, &place.kept.triangle, target);
}
void eva_colour_triangles(void)
{
    of_colours(0);
    strips(by_colours, GLINT_COLOUR_COLUMNS_LOG, GLINT_MESH_DARK);
}

/* By ALBEDO tables: textures of 3 x 2 texels and colours of vertices, laid and in perspective, as eva_textures.c shows that they are set. */

enum { TEXTURE_WIDE = 3, TEXTURE_HIGH = 2 };
static uint16_t texels[TEXTURE_WIDE * TEXTURE_HIGH], palette[256];
static uint8_t numbers[TEXTURE_WIDE * TEXTURE_HIGH];
static struct glint_texture texture;
static struct glint_use_mesh use;
static struct glint_mesh mesh;

static void far_over(struct glint_mesh_over *over, const struct glint_mesh_target *target, unsigned face,
                     const struct glint_texture *of)
{
    (void)target, (void)face;
    over->x = any_signed % 2048;
    over->y = any_signed % 2048;
    over->picture.pixels = (const uint8_t *)of->pixels;
    over->picture.palette = of->palette;
    over->picture.w = TEXTURE_WIDE;
    over->picture.h = TEXTURE_HIGH;
    over->count = 2;
    over->is_smooth = of->is_smooth;
    over->is_far = true;
    over->up = (uint8_t)(4 + any % 8);
    for (unsigned k = 0; k < 2; k++) {
        const struct glint_mesh_linear linear = {any, any, any};
        over->of[k] = linear;
        over->down[k] = (uint8_t)(16 + any % 18);
        over->base[k] = any;
    }
}
static void lay(struct glint_mesh_laid *laid, const struct glint_mesh_target *target,
                const struct glint_mesh_triangle *of_triangle, const struct glint_texture *of)
{
    (void)target, (void)of_triangle;
    for (unsigned i = 0; i < 9; i++)
        laid->of[i] = any;
    if (!of)
        return;
    laid->of[GLINT_MESH_LAID_BLUE] = 0;
    laid->of[GLINT_MESH_LAID_BLUE + 1] = TEXTURE_WIDE | TEXTURE_HIGH << 16;
}

static void by_albedo(const struct glint_mesh_target *target)
{
    frame.kept_bytes = any & 1 ? sizeof(struct glint_mesh_kept) : sizeof place;
    use.lines(&paint.of.tables.filled, &place.kept.triangle, target, mesh.textures);
}
static void albedo_triangles(uint16_t distance)
{
    use = glint_use_mesh_albedo;
    use.set = far_over;
    use.lay = lay;
    mesh.use = &use;
    drawn.mesh = &mesh;
    frame.memory = &bench;
    frame.kept = &place.kept;
    frame.places = 1;
    frame.distance = distance;
    of_levels(distance & 1);
    strips(by_albedo, GLINT_ALBEDO_COLUMNS_LOG, GLINT_MESH_MATT);
}
void eva_albedo_triangles(void)
{
    mesh.textures = NULL;
    albedo_triangles(0);
}
static void textured(bool has_palette, bool is_smooth, uint16_t distance)
{
    ANY_BYTES(texels);
    ANY_BYTES(numbers);
    ANY_BYTES(palette);
    texture.pixels = has_palette ? (const void *)numbers : (const void *)texels;
    texture.palette = has_palette ? palette : NULL;
    texture.w = TEXTURE_WIDE;
    texture.h = TEXTURE_HIGH;
    texture.levels = 1;
    texture.is_smooth = is_smooth;
    mesh.textures = &texture;
    albedo_triangles(distance);
}
void eva_albedo_textures(void)
{
    textured(false, false, 0);
}
void eva_albedo_palette(void)
{
    textured(true, false, 0);
}
void eva_albedo_smooth(void)
{
    textured(false, true, 0);
}
void eva_albedo_far(void)
{
    textured(false, false, (uint16_t)(1 + any % 65535));
}
