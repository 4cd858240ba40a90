/* SPDX-License-Identifier: MIT
 * Tables: what they are made and lit for, and what they refuse. */
#include "mesh_colours.h"
#include "tables_model.h"

static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4], other_memory[GLINT_TABLES_DITHER_BYTES / 4];

static struct look look_for(enum glint_format format)
{
    struct look s = tables_look(format);
    set_model(&s, GLINT_MSH, 60, 8);
    return s;
}

static void what_tables_cannot_be_filled_for_is_refused_and_nothing_is_written(void **state)
{
    (void)state;
    struct look look = look_for(GLINT_RGB565);
    struct glint_paint paint, before;
    uint32_t guard[GLINT_TABLES_COLOUR_BYTES / 4];
    memset(guard, GUARD, sizeof guard);
    memset(&paint, GUARD, sizeof paint);
    before = paint;
    const enum glint_tables_kind colour = GLINT_TABLES_COLOUR;
    const struct glint_material *m = &look.material;
    const struct glint_output *o = &look.output;
    assert_int_equal(glint_tables_bytes(colour, false), sizeof guard);
    assert_int_equal(glint_tables_bytes((enum glint_tables_kind)2, false), 0);
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, guard, sizeof guard - 1), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, (char *)guard + 2, sizeof guard), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables(&paint, (enum glint_tables_kind)2, m, o, guard, sizeof guard), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables(&paint, colour, NULL, o, guard, sizeof guard), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables(&paint, colour, m, NULL, guard, sizeof guard), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, NULL, sizeof guard), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables(NULL, colour, m, o, guard, sizeof guard), GLINT_ERR_ARG);
    static const uint8_t models[] = {GLINT_PHONG, GLINT_MODEL_COUNT, 77, 255};
    for (int i = 0; i < 4; i++) {
        look.material.model = models[i];
        assert_int_equal(glint_paint_tables(&paint, colour, m, o, guard, sizeof guard), GLINT_ERR_ARG);
    }
    look.material.model = GLINT_MSH;
    look.material.n = 0;
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, guard, sizeof guard), GLINT_ERR_ARG);
    look.material.n = 60;
    look.material.n_across = 61;
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, guard, sizeof guard), GLINT_ERR_ARG);
    look.material.n_across = 60;
    look.output.dither = true; /* takes more bytes */
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, guard, sizeof guard), GLINT_ERR_ARG);
    look.output.dither = false;
    for (unsigned format = GLINT_RGB888; format <= GLINT_FORMAT_COUNT; format++) {
        look.output.format = (uint8_t)format;
        assert_int_equal(glint_paint_tables(&paint, colour, m, o, guard, sizeof guard), GLINT_ERR_FORMAT);
    }
    look.output.format = GLINT_RGB565;
    look.output.space = GLINT_LINEAR + 1;
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, guard, sizeof guard), GLINT_ERR_FORMAT);
    for (size_t i = 0; i < sizeof guard / 4; i++)
        assert_int_equal(guard[i], GUARD * 0x01010101u);
    memset(memory, 0, sizeof memory);
    look.output.dither = true;
    look.output.space = GLINT_LINEAR;
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, memory, sizeof memory), GLINT_ERR_FORMAT);
    look = look_for(GLINT_RGB565);
    make_grey(&look, 65537, 0); /* an albedo is scaled by 1 at most */
    assert_int_equal(glint_paint_tables(&paint, GLINT_TABLES_ALBEDO, m, o, memory, sizeof memory), GLINT_ERR_ARG);
    for (int k = 0; k < 6; k++) { /* and by one number in all channels */
        make_grey(&look, 20000, 30000);
        (k < 3 ? look.material.ambient_q16 : look.material.diffuse_q16)[k % 3]++;
        assert_int_equal(glint_paint_tables(&paint, GLINT_TABLES_ALBEDO, m, o, memory, sizeof memory), GLINT_ERR_ARG);
    }
    assert_int_equal(memory[0], 0);
    assert_memory_equal(&paint, &before, sizeof paint);
}

/* A few pixels by a lit paint. */
enum { COUNT = 64 };
static void draw(const struct glint_paint *paint, const struct glint_vec normals[COUNT], uint16_t out[COUNT])
{
    static const uint16_t albedo[COUNT] = {0x1234, 0xffff, 0x8410, 0x07e0, 0xf800};
    const bool is_albedo = paint->of.tables.filled.kind == GLINT_TABLES_ALBEDO;
    const struct glint_maps maps = {
        .normals = normals, .albedo = is_albedo ? (const uint8_t *)albedo : NULL, .albedo_format = GLINT_RGB565};
    const struct glint_surface surface = {out, 0, 1, 2};
    memset(out, GUARD, COUNT * sizeof *out);
    assert_int_equal(glint_draw_rect(paint, &maps, COUNT, 1, &surface, NULL), GLINT_OK);
}

static const struct glint_use_model *model_named(const struct look *look)
{
#define MODEL_BY_NAME(number, name, function, use, grain) [number] = &glint_use_##name,
    static const struct glint_use_model *const models[] = {GLINT_MODELS(MODEL_BY_NAME)};
#undef MODEL_BY_NAME
    return models[look->material.model];
}

static void tables_of_a_kind_model_and_format_by_name_and_filled_ones_draw_the_same_pixels(void **state)
{
    (void)state;
    for (int i = 0; i < 60; i++) {
        const enum glint_tables_kind kind = i % 4 == 3 ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR;
        struct look look = tables_look((enum glint_format)below(2));
        look.output.dither = i % 4 == 1;
        look.output.space = i % 4 == 2 ? GLINT_LINEAR : GLINT_GAMMA;
        if (kind == GLINT_TABLES_ALBEDO)
            make_grey(&look, 6000, 50000);
        const struct glint_use_tables *use = kind == GLINT_TABLES_ALBEDO ? &glint_use_albedo
                                             : look.output.dither        ? &glint_use_colour_dithered
                                                                         : &glint_use_colour;
        struct glint_paint paint, named, filled;
        struct glint_vec normals[COUNT];
        uint16_t wanted[COUNT], out[COUNT];
        for (int p = 0; p < COUNT; p++)
            normals[p] = near_normal(&look);
        paint_of_tables(&paint, kind, &look, memory);
        draw(&paint, normals, wanted);
        assert_int_equal(glint_paint_tables_for(&named, use, &look.material, &look.output, other_memory,
                                                glint_tables_bytes(kind, look.output.dither), model_named(&look),
                                                look.output.space ? &glint_use_linear : &glint_use_rgb565),
                         GLINT_OK);
        assert_int_equal(glint_paint_light_by(&named, &look.light, 1, look.to_viewer, NULL), GLINT_OK);
        draw(&named, normals, out);
        assert_memory_equal(out, wanted, sizeof out);
        const struct glint_tables tables = paint.of.tables.filled;
        assert_int_equal(glint_paint_tables_filled(&filled, &tables, &look.output), GLINT_OK);
        assert_int_equal(glint_paint_light_by(&filled, &look.light, 1, look.to_viewer, NULL), GLINT_OK);
        draw(&filled, normals, out);
        assert_memory_equal(out, wanted, sizeof out);
    }
}

static void tables_are_not_made_for_another_kind_model_or_format(void **state)
{
    (void)state;
    struct look look = look_for(GLINT_RGB565);
    struct glint_paint paint, before;
    memset(&paint, GUARD, sizeof paint);
    memset(memory, 0, sizeof memory);
    before = paint;
    const size_t bytes = sizeof memory;
#define FILL(kind, model, format)                                                                                      \
    glint_paint_tables_for(&paint, kind, &look.material, &look.output, memory, bytes, model, format)
    assert_int_equal(FILL(&glint_use_colour_dithered, &glint_use_msh, &glint_use_rgb565), GLINT_ERR_FORMAT);
    assert_int_equal(FILL(&glint_use_colour, &glint_use_lyon, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_int_equal(FILL(&glint_use_colour, &glint_use_msh, &glint_use_linear), GLINT_ERR_FORMAT);
    assert_int_equal(FILL(&glint_use_colour, &glint_use_msh, &glint_use_rgb888), GLINT_ERR_FORMAT);
    assert_int_equal(FILL(NULL, &glint_use_msh, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_int_equal(FILL(&glint_use_colour, NULL, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_int_equal(FILL(&glint_use_colour, &glint_use_msh, NULL), GLINT_ERR_ARG);
    look.output.dither = true;
    assert_int_equal(FILL(&glint_use_colour, &glint_use_msh, &glint_use_rgb565), GLINT_ERR_FORMAT);
    look.output.dither = false;
    look.material.model = GLINT_PHONG;
    assert_int_equal(FILL(&glint_use_colour, &glint_use_phong, &glint_use_rgb565), GLINT_ERR_ARG);
    assert_int_equal(FILL(&glint_use_colour, &glint_use_blinn, &glint_use_rgb565), GLINT_ERR_ARG);
#undef FILL
    assert_memory_equal(&paint, &before, sizeof paint);
    for (size_t i = 0; i < sizeof memory / 4; i++)
        assert_int_equal(memory[i], 0);
}

static void filled_tables_are_refused_for_another_output_and_where_there_are_none(void **state)
{
    (void)state;
    const struct look look = look_for(GLINT_RGB565);
    struct glint_paint paint, filled;
    paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
    const struct glint_tables tables = paint.of.tables.filled, none = {0};
    assert_int_equal(glint_paint_tables_filled(NULL, &tables, &look.output), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables_filled(&filled, NULL, &look.output), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables_filled(&filled, &tables, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_tables_filled(&filled, &none, &look.output), GLINT_ERR_ARG);
    struct glint_output output = look.output;
    output.format = GLINT_RGB565_SWAPPED;
    assert_int_equal(glint_paint_tables_filled(&filled, &tables, &output), GLINT_ERR_FORMAT);
    output.format = GLINT_FORMAT_COUNT;
    assert_int_equal(glint_paint_tables_filled(&filled, &tables, &output), GLINT_ERR_FORMAT);
    output = look.output;
    output.dither = true;
    assert_int_equal(glint_paint_tables_filled(&filled, &tables, &output), GLINT_ERR_FORMAT);
    output = look.output;
    output.space = GLINT_LINEAR + 1;
    assert_int_equal(glint_paint_tables_filled(&filled, &tables, &output), GLINT_ERR_FORMAT);
}

/* ---- Lit ---- */

/* None is the dark all over, whatever the normals are. */
static void tables_without_a_light_draw_the_ambient_part(void **state)
{
    (void)state;
    for (int i = 0; i < 40; i++) {
        struct look look = tables_look((enum glint_format)below(2));
        struct glint_paint paint;
        uint16_t out[2][COUNT];
        uint32_t words[COUNT];
        struct glint_vec vectors[COUNT];
        struct glint_box box;
        look.output.dither = i & 1;
        memset(out[0], GUARD, sizeof out[0]);
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        assert_int_equal(glint_paint_light(&paint, NULL, 0, in_front), GLINT_OK);
        for (int p = 0; p < COUNT; p++) {
            vectors[p] = near_normal(&look);
            vectors[p].z |= 1;
            words[p] = below(3) ? glint_normals_pack(GLINT_NORMALS_INT8, &vectors[p]) : 0; /* no surface */
        }
        const struct glint_surface surface = {out[0], 0, 1, 2}, exactly = {out[1], 0, 1, 2};
        struct glint_maps maps = {.normals = vectors};
        if (i & 2)
            maps.normals = words, maps.normals_format = GLINT_NORMALS_INT8;
        const struct glint_span span = {0, 0, 0, 1 << 30, 0, COUNT, {{0, 0}, {0, 0}}};
        if (i & 4)
            assert_int_equal(glint_draw_rect(&paint, &maps, COUNT, 1, &surface, &box), GLINT_OK);
        else
            assert_int_equal(glint_draw_span(&paint, &span, NULL, &surface, &box), GLINT_OK);
        assert_true(!(box.x | box.y | box.w | box.h));
        memset(look.material.diffuse_q16, 0, sizeof look.material.diffuse_q16);
        memset(look.material.specular_q16, 0, sizeof look.material.specular_q16);
        assert_int_equal(draw_span(&look, &span, &exactly, NULL), GLINT_OK);
        for (int p = 0; (i & 6) == 6 && p < COUNT; p++)
            if (words[p] == 0)
                out[1][p] = GUARD << 8 | GUARD;
        assert_memory_equal(out[0], out[1], sizeof out[0]);
    }
}

static void tables_take_one_white_directional_light_and_keep_it_after_an_error(void **state)
{
    (void)state;
    const int32_t place[3] = {0, 0, 500}, zero[3] = {0, 0, 0}, behind[3] = {0, 0, -1};
    for (int i = 0; i < 20; i++) {
        struct look look = tables_look(GLINT_RGB565);
        struct glint_light lights[2] = {look.light, look.light}, place_light, none;
        struct glint_paint paint;
        struct glint_vec normals[COUNT];
        uint16_t wanted[COUNT], out[COUNT];
        look.output.dither = i & 1;
        for (int p = 0; p < COUNT; p++)
            normals[p] = near_normal(&look);
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        draw(&paint, normals, wanted);
        assert_int_equal(glint_paint_light(&paint, lights, 2, in_front), GLINT_ERR_ARG);
        assert_int_equal(glint_light_point(&place_light, place, 1000), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, &place_light, 1, in_front), GLINT_ERR_ARG);
        for (int k = 0; k < 3; k++) {
            lights[0] = look.light;
            lights[0].color_q16[k] += i & 1 ? 1 : 0xffffffffu;
            assert_int_equal(glint_paint_light(&paint, lights, 1, in_front), GLINT_ERR_ARG);
        }
        memset(&none, 0, sizeof none);
        assert_int_equal(glint_paint_light(&paint, &none, 1, in_front), GLINT_ERR_ARG);
        assert_int_equal(glint_paint_light(&paint, &look.light, 1, zero), GLINT_ERR_VECTOR);
        assert_int_equal(glint_light_directional(&none, behind), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, &none, 1, in_front), GLINT_ERR_VECTOR);
        draw(&paint, normals, out);
        assert_memory_equal(out, wanted, sizeof out);
    }
}

/* A half vector of a light nearly straight behind has next to no length. */
static void a_light_nearly_straight_behind_leaves_the_dark(void **state)
{
    (void)state;
    static const uint16_t albedo[4] = {0x1234, 0xffff, 0, 0x8410};
    static const uint32_t normals[4] = {0x7fff0000, 0x7fff0000, 0x7fff0000, 0x7fff0000}; /* to the viewer */
    struct look look = look_for(GLINT_RGB565);
    struct glint_paint of_albedo, of_colours;
    uint16_t dark[4], unlit[4];
    make_grey(&look, 20000, 20000);
    paint_of_tables(&of_colours, GLINT_TABLES_COLOUR, &look, memory);
    paint_of_tables(&of_albedo, GLINT_TABLES_ALBEDO, &look, other_memory);
    for (int32_t x = 1; x < 5; x++) {
        struct glint_light light;
        uint16_t out[4] = {7, 7, 7, 7};
        const struct glint_surface surface = {out, 4, 0, 0};
        struct glint_maps maps = {.normals = normals, .normals_stride = 8, .normals_format = GLINT_NORMALS_INT8};
        assert_int_equal(glint_light_directional(&light, (const int32_t[]){x, 0, -20000000}), GLINT_OK);
        assert_int_equal(glint_paint_light(&of_colours, &light, 1, in_front), GLINT_OK);
        assert_int_equal(glint_draw_rect(&of_colours, &maps, 2, 2, &surface, NULL), GLINT_OK);
        if (x == 1)
            memcpy(unlit, out, sizeof unlit);
        assert_memory_equal(out, unlit, sizeof out);
        maps.albedo = (const uint8_t *)albedo;
        maps.albedo_stride = 4;
        maps.albedo_format = GLINT_RGB565;
        assert_int_equal(glint_paint_light(&of_albedo, &light, 1, in_front), GLINT_OK);
        assert_int_equal(glint_draw_rect(&of_albedo, &maps, 2, 2, &surface, NULL), GLINT_OK);
        assert_in_range(out[1] >> 11, 9, 10); /* 31 times the ambient, 0.305 */
        if (x == 1)
            memcpy(dark, out, sizeof dark);
        assert_memory_equal(out, dark, sizeof out);
    }
}

/* The peak: t is 0, and of a row of nl the table has the middle. */
static void colour_tables_of_linear_space_hold_its_pixels(void **state)
{
    (void)state;
    struct look look = look_for(GLINT_RGB565);
    look.output.space = GLINT_LINEAR;
    assert_int_equal(look_light(&look, in_front, in_front), GLINT_OK);
    const struct glint_vec normal = {0, 0, 32767};
    const struct glint_maps maps = {.normals = &normal};
    for (int i = 0; i < 20; i++) {
        struct glint_paint paint;
        uint16_t found, exact;
        const struct glint_surface to_found = {&found, 2, 0, 0}, to_exact = {&exact, 2, 0, 0};
        for (int k = 0; k < 3; k++) {
            look.material.albedo[k] = (uint8_t)below(256);
            look.material.specular_q16[k] = below(20000);
        }
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        assert_int_equal(glint_draw_rect(&paint, &maps, 1, 1, &to_found, NULL), GLINT_OK);
        assert_int_equal(draw_rect(&look, &maps, 1, 1, &to_exact, NULL), GLINT_OK);
        assert_in_range(1 + (found >> 11) - (exact >> 11), 0, 2);
        assert_in_range(1 + (found >> 5 & 63) - (exact >> 5 & 63), 0, 2);
        assert_in_range(1 + (found & 31) - (exact & 31), 0, 2);
    }
}

/* ---- Drawn ---- */

static const uint32_t words[4] = {1u << 30, 1u << 30, 1u << 30, 1u << 30};
static uint16_t out[8]; /* two lines */
static const struct glint_surface to_out = {out, 8, 0, 0};

static void assert_untouched(void)
{
    for (int i = 0; i < 8; i++)
        assert_int_equal(out[i], GUARD << 8 | GUARD);
}

static void refuses(const struct glint_paint *paint, enum glint_err err, int format, const void *normals,
                    ptrdiff_t stride)
{
    const struct glint_maps maps = {.normals = normals, .normals_stride = stride, .normals_format = (uint8_t)format};
    struct glint_box box = {9, 9, 9, 9};
    memset(out, GUARD, sizeof out);
    assert_int_equal(glint_draw_rect(paint, &maps, 2, 2, &to_out, &box), err);
    assert_untouched();
    assert_true(box.x == 9 && box.h == 9);
}

static void eight_bit_normals_require_the_viewer_in_front_of_tables(void **state)
{
    (void)state;
    static const int32_t aside[][3] = {{1, 0, 4}, {0, 0, -1}, {1, 0, 200}, {0, -1, 200}}; /* two with z = 32767 */
    static const int32_t to_light[3] = {0, 1, 1};
    for (int i = 0; i < 8; i++) {
        struct look look = look_for(GLINT_RGB565);
        struct glint_paint paint;
        look.output.dither = i / 4;
        assert_int_equal(look_light(&look, to_light, aside[i % 4]), GLINT_OK);
        paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
        refuses(&paint, GLINT_ERR_VECTOR, GLINT_NORMALS_INT8, words, 8);
        const struct glint_maps maps = {.normals = words, .normals_stride = 8, .normals_format = GLINT_NORMALS_INT8};
        paint_of(&paint, &look); /* the exact paint takes them */
        assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &to_out, NULL), GLINT_OK);
    }
}

static void eight_bit_normals_require_the_viewer_in_front_of_albedo_tables(void **state)
{
    (void)state;
    static const int32_t from[][3] = {{1, 0, 4}, {0, 1, 4}, {0, 0, -1}, {1, 0, 200}, {0, 0, 1}};
    static const int32_t to_light[3] = {0, 1, 1};
    for (int i = 0; i < 5; i++) {
        struct look look = look_for(GLINT_RGB565);
        struct glint_paint paint;
        assert_int_equal(look_light(&look, to_light, in_front), GLINT_OK);
        assert_true(paint_of_albedo(&paint, &look, memory));
        assert_int_equal(glint_paint_light(&paint, &look.light, 1, from[i]), GLINT_OK);
        const uint16_t albedo[4] = {0};
        const struct glint_maps maps = {.normals = words,
                                        .normals_stride = 8,
                                        .normals_format = GLINT_NORMALS_INT8,
                                        .albedo = (const uint8_t *)albedo,
                                        .albedo_stride = 4,
                                        .albedo_format = GLINT_RGB565};
        assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &to_out, NULL), i < 4 ? GLINT_ERR_VECTOR : GLINT_OK);
    }
}

static void eight_bit_normals_take_every_light_that_a_paint_does(void **state)
{
    (void)state;
    struct look look = look_for(GLINT_RGB565);
    struct glint_paint paint;
    const struct glint_maps maps = {.normals = words, .normals_stride = 8, .normals_format = GLINT_NORMALS_INT8};
    unsigned lit = 0;
    paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
    for (int i = 0; i < 100000; i++) {
        const int32_t near = 1 << below(31), length = 1 + (int32_t)below(100), viewer[3] = {0, 0, length};
        int32_t to_light[3] = {(int32_t)below(2001) - 1000, (int32_t)below(2001) - 1000, (int32_t)below(2001) - 1000};
        if (i % 2)
            to_light[2] = -near; /* also almost straight behind */
        struct glint_light light;
        if (glint_light_directional(&light, to_light) != GLINT_OK ||
            glint_paint_light(&paint, &light, 1, viewer) != GLINT_OK)
            continue;
        assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &to_out, NULL), GLINT_OK);
        lit++;
    }
    assert_true(lit > 90000);
}

static void rectangles_by_tables_refuse_what_cannot_be(void **state)
{
    (void)state;
    enum { INT16 = GLINT_NORMALS_INT16, INT8 = GLINT_NORMALS_INT8 };
    struct look look = look_for(GLINT_RGB565);
    struct glint_paint paint, never_lit;
    paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
    const struct glint_tables tables = paint.of.tables.filled;
    assert_int_equal(look_light(&look, (const int32_t[]){0, 1, 1}, in_front), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &look.light, 1, in_front), GLINT_OK);
    refuses(&paint, GLINT_ERR_FORMAT, 2, words, 8);
    refuses(&paint, GLINT_ERR_ARG, INT8, NULL, 8);
    refuses(&paint, GLINT_ERR_ARG, INT8, (const char *)words + 2, 8);
    refuses(&paint, GLINT_ERR_ARG, INT8, words, 6);
    refuses(&paint, GLINT_ERR_ARG, INT8, words, 4);
    refuses(&paint, GLINT_ERR_ARG, INT16, (const char *)words + 1, 12);
    refuses(&paint, GLINT_ERR_ARG, INT16, words, -13);
    refuses(&paint, GLINT_ERR_ARG, INT16, words, 10);
    assert_int_equal(glint_paint_tables_filled(&never_lit, &tables, &look.output), GLINT_OK);
    refuses(&never_lit, GLINT_ERR_ARG, INT16, words, 12);
    refuses(NULL, GLINT_ERR_ARG, INT16, words, 12);
    const struct glint_paint zeros = {0};
    refuses(&zeros, GLINT_ERR_ARG, INT16, words, 12);
    struct glint_maps maps = {.normals = words, .normals_stride = 8, .normals_format = INT8};
    const struct glint_surface nowhere = {NULL, 8, 0, 0}, narrow = {out, 3, 0, 0};
    assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &nowhere, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &narrow, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_rect(&paint, NULL, 2, 2, &to_out, NULL), GLINT_ERR_ARG);
    maps.albedo = (const uint8_t *)words; /* COLOUR has one albedo */
    maps.albedo_stride = 8;
    for (unsigned format = 0; format < 3; format++) {
        maps.albedo_format = (uint8_t)format;
        assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &to_out, NULL), GLINT_ERR_ARG);
    }
    maps.albedo = NULL;
    for (int i = 0; i < 4; i++) { /* kinds without maps; with them a stride that is too small */
        const struct glint_use_tables *const with = paint.of.tables.filled.use;
        paint.of.tables.filled.use = i < 2 ? &glint_use_colour : with;
        maps.gloss = i & 1 ? (const uint8_t *)words : NULL;
        maps.shininess = i & 1 ? NULL : (const uint8_t *)words;
        maps.gloss_stride = maps.shininess_stride = i < 2 ? 2 : 1;
        assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &to_out, NULL), GLINT_ERR_ARG);
        paint.of.tables.filled.use = with;
    }
    maps.gloss = maps.shininess = NULL;
    maps.grain = (const uint8_t *)words;
    maps.grain_stride = 2;
    assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &to_out, NULL), GLINT_ERR_ARG);
    maps.grain = NULL;
    maps.coverage = (const uint8_t *)words;
    maps.coverage_stride = 1;
    assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &to_out, NULL), GLINT_ERR_ARG);
    assert_untouched();
}

static void spans_and_palettes_refuse_what_cannot_be(void **state)
{
    (void)state;
    const struct look look = look_for(GLINT_RGB565);
    struct glint_paint paint, never_lit;
    paint_of_tables(&paint, GLINT_TABLES_COLOUR, &look, memory);
    assert_int_equal(glint_paint_tables_filled(&never_lit, &paint.of.tables.filled, &look.output), GLINT_OK);
    const struct glint_paint zeros = {0};
    const struct glint_span span = {0, 0, 0, 1 << 29, 0, 4, {{0, 0}, {0, 0}}};
    const struct glint_surface none = {NULL, 8, 0, 0}, odd = {(char *)out + 1, 8, 0, 0};
    const struct glint_surface odd_stride = {out, 7, 0, 0}, *to = &to_out;
    memset(out, GUARD, sizeof out);
    assert_int_equal(glint_draw_span(&paint, NULL, NULL, to, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_span(NULL, &span, NULL, to, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_span(&zeros, &span, NULL, to, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_span(&never_lit, &span, NULL, to, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_span(&paint, &span, NULL, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_span(&paint, &span, NULL, &none, NULL), GLINT_ERR_ARG);
    static const uint8_t map[8] = {255, 255, 255, 255, 255, 255, 255, 255};
    struct glint_maps maps = {.albedo = map, .albedo_format = GLINT_RGB565};
    assert_int_equal(glint_draw_span(&paint, &span, &maps, to, NULL), GLINT_ERR_ARG);
    paint.of.tables.filled.use = &glint_use_colour;
    maps = (struct glint_maps){.gloss = map};
    assert_int_equal(glint_draw_span(&paint, &span, &maps, to, NULL), GLINT_ERR_ARG);
    maps = (struct glint_maps){.shininess = map};
    assert_int_equal(glint_draw_span(&paint, &span, &maps, to, NULL), GLINT_ERR_ARG);
    maps = (struct glint_maps){.grain = map};
    assert_int_equal(glint_draw_span(&paint, &span, &maps, to, NULL), GLINT_ERR_ARG);
    static const uint16_t colours[3] = {1, 2, 3}, offsets[4] = {0, 2, 0, 2};
    const uint16_t *odd_colours = (const uint16_t *)(const void *)((const char *)colours + 1);
    const uint16_t *odd_offsets = (const uint16_t *)(const void *)((const char *)offsets + 1);
    assert_int_equal(glint_draw_palette(NULL, offsets, 4, 1, 2, to), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(colours, NULL, 4, 1, 2, to), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(odd_colours, offsets, 4, 1, 2, to), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(colours, odd_offsets, 4, 1, 2, to), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(colours, offsets, 3, 1, 2, to), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(colours, offsets, 2, 2, 2, to), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(colours, offsets, 4, 1, 2, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(colours, offsets, 4, 1, 2, &none), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(colours, offsets, 4, 1, 2, &odd), GLINT_ERR_ARG);
    assert_int_equal(glint_draw_palette(colours, offsets, 4, 1, 2, &odd_stride), GLINT_ERR_ARG);
    const struct glint_surface narrow = {to->pixels, 2, 0, 0};
    assert_int_equal(glint_draw_palette(colours, offsets, 4, 2, 2, &narrow), GLINT_ERR_ARG);
    assert_untouched();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_tables_cannot_be_filled_for_is_refused_and_nothing_is_written),
        cmocka_unit_test(tables_of_a_kind_model_and_format_by_name_and_filled_ones_draw_the_same_pixels),
        cmocka_unit_test(tables_are_not_made_for_another_kind_model_or_format),
        cmocka_unit_test(filled_tables_are_refused_for_another_output_and_where_there_are_none),
        cmocka_unit_test(tables_without_a_light_draw_the_ambient_part),
        cmocka_unit_test(tables_take_one_white_directional_light_and_keep_it_after_an_error),
        cmocka_unit_test(a_light_nearly_straight_behind_leaves_the_dark),
        cmocka_unit_test(colour_tables_of_linear_space_hold_its_pixels),
        cmocka_unit_test(eight_bit_normals_require_the_viewer_in_front_of_tables),
        cmocka_unit_test(eight_bit_normals_require_the_viewer_in_front_of_albedo_tables),
        cmocka_unit_test(eight_bit_normals_take_every_light_that_a_paint_does),
        cmocka_unit_test(rectangles_by_tables_refuse_what_cannot_be),
        cmocka_unit_test(spans_and_palettes_refuse_what_cannot_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
