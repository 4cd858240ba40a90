/* SPDX-License-Identifier: MIT
 * Tables, and what they draw. */
#include "conformance_tables.h"

#include "conformance_random.h"
#include "conformance_scenes.h"

#if CONFORMANCE_TABLES && !CONFORMANCE_MODELS_ONLY

/* Not filled, and nothing is drawn: the paint's numbers for INT8 normals. Along the axes and beside them they have the most bits. */
void conform_tables_lit(void)
{
    static const struct glint_use_tables *const uses[] = {&glint_use_colour, &glint_use_albedo};
    const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    struct glint_paint *const paint = &conform_paint;
    for (uint8_t i = 0; i < 64; i++) {
        struct glint_tables tables = {.kind = i & 1, .format = GLINT_RGB565, .n = 60, .use = uses[i & 1]};
        struct glint_light light;
        int32_t to_light[3] = {0, 0, 0};
        to_light[i >> 1 & 1 ? 2 : 1] = 1000;
        for (uint8_t k = 0; k < 3 && i > 3; k++)
            to_light[k] += conform_random_within(i < 32 ? 40 : 900);
        tables.t_max_q30 = conform_random_bits() >> 3;
        tables.shift = (uint8_t)(20 + i % 8);
        conform_add((uint32_t)glint_light_directional(&light, to_light));
        conform_add((uint32_t)glint_paint_tables_filled(paint, &tables, &output));
        conform_light(paint, &light);
        conform_add((uint32_t)paint->of.tables.x);
        conform_add((uint32_t)paint->of.tables.y);
        conform_add((uint32_t)paint->of.tables.z);
        conform_add((uint32_t)paint->of.tables.cut);
        conform_add(paint->of.tables.r);
    }
}

/* Full, none, or a part of a pixel. */
static uint8_t soft_edged(void)
{
    const uint32_t bits = conform_random_bits();
    return (uint8_t)(bits % 4 == 0 ? 0 : bits % 4 == 1 ? bits >> 8 & 255 : 255);
}

bool conform_fill(struct glint_paint *paint, enum glint_tables_kind kind, const struct glint_material *material,
                  const struct glint_output *output)
{
    static uint32_t memory[(CONFORMANCE_ALBEDO_ONLY ? GLINT_TABLES_ALBEDO_BYTES : GLINT_TABLES_DITHER_BYTES) / 4];
    for (uint16_t i = 0; i < sizeof memory / sizeof *memory; i++)
        memory[i] = 0;
#if CONFORMANCE_ALBEDO_ONLY /* of MSH's, for flash */
    const enum glint_err err = glint_paint_tables_for(paint, &glint_use_albedo_maps, material, output, memory,
                                                      sizeof memory, &glint_use_msh, &glint_use_rgb565);
#else
    const enum glint_err err = glint_paint_tables(paint, kind, material, output, memory, sizeof memory);
#endif
    conform_add((uint32_t)err);
    if (!err)
        conform_add_bytes((const uint8_t *)memory, (uint16_t)glint_tables_bytes(kind, output->dither));
    return !err;
}

enum { WIDE = 319 };
typedef char conform_wide_fits[CONFORMANCE_ALBEDO_ONLY || (int)CONFORM_WORDS >= (int)WIDE ? 1 : -1];
static uint16_t wide_out[WIDE + 1];

static void add_wide_out(uint32_t err)
{
    conform_add(err);
    conform_add_bytes((const uint8_t *)wide_out, sizeof wide_out);
}

/* In and about the lobe; t at t_max or 0 to the unit, or nl at 0, at pixel k; steps larger than the loops take for small;
 * any at all. */
static void tricky_span(struct glint_span *span, uint32_t t_max, uint8_t kind)
{
    const uint32_t k = conform_random_bits() % (span->w + 1u), fine = 1 + conform_random_bits() % 16;
    const uint32_t step = UINT32_C(1) << (kind == 1 ? 23 + fine % 6 : 25 - fine);
    const uint32_t ddt = UINT32_C(1) << (kind == 1 ? 14 + 3 * fine % 12 : 20 - fine);
    span->dt_q30 = kind ? (uint32_t)conform_random_within((int32_t)step) : conform_random_bits();
    span->ddt_q30 = kind ? conform_random_bits() % ddt : conform_random_bits();
    span->dnl_q30 = kind ? conform_random_within((int32_t)step) : (int32_t)conform_random_bits();
    span->nl_q30 = (int32_t)(conform_random_bits() >> (kind == 1 ? 0 : 2));
    span->t_q30 = kind == 1 ? conform_random_bits() >> 1 : conform_random_bits() % (t_max + 100000);
    if (kind >= 5) { /* the lowest t at pixel k */
        span->dt_q30 = 0 - k * span->ddt_q30;
        span->dnl_q30 >>= 6;
    }
    const uint32_t to_k = k * span->dt_q30 + k * (k - 1) / 2 * span->ddt_q30, one = (uint32_t)conform_random_within(1);
    if (kind == 2 || kind == 5)
        span->t_q30 = t_max + one - to_k;
    else if (kind == 3)
        span->nl_q30 = (int32_t)(one - k * (uint32_t)span->dnl_q30);
    else if (kind >= 6)
        span->t_q30 = (kind == 6 ? 3 * one : UINT32_C(0xf8000000) + one) - to_k;
}

/* The paint's tables with a highlight that ends elsewhere. */
static void end_at(struct glint_paint *paint, const struct glint_paint *of, uint32_t t_max,
                   const struct glint_light *light)
{
    struct glint_tables tables = of->of.tables.filled;
    if (t_max < tables.t_max_q30)
        tables.t_max_q30 = t_max;
    conform_add((uint32_t)glint_paint_tables_filled(paint, &tables, &of->output));
    conform_light(paint, light);
}

static uint32_t t_of(const struct glint_vec *n, const struct glint_vec *h)
{
    const int32_t x = n->x - h->x, y = n->y - h->y, z = n->z - h->z;
    return ((uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z)) / 2;
}

/* Spans, packed normals and a palette, wider than what a loop takes at once, at every width where it might turn. */
static void add_wide(const struct glint_paint *paint, const struct glint_light *light)
{
    static const uint16_t widths[] = {0, 1, 2, 3, 4, 5, 15, 16, 17, 31, 32, 33, 64, 65, 96, WIDE};
    static struct glint_paint at;
    uint32_t *const words = conform_words;
    static uint16_t offsets[WIDE];
    struct glint_surface line = {wide_out, 0, 0, 0};
    for (uint16_t i = 0; i < 512; i++) {
        line.x = i & 3;
        line.y = i >> 2 & 3;
        struct glint_span span = {0, 0, 0, 0, 0, widths[i / 32u], {{0, 0}, {0, 0}}};
        tricky_span(&span, paint->of.tables.filled.t_max_q30, i % 8u);
        add_wide_out((uint32_t)glint_draw_span(paint, &span, 0, &line, 0));
    }
    for (uint8_t i = 0; i < 32; i++) {
        line.x = i >> 1 & 3;
        line.y = i >> 3 & 3;
        for (uint16_t x = 0; x < WIDE; x++) {
            struct glint_vec normal;
            conform_random_normal(&normal, &paint->h);
            words[x] = x % 11u == 10 ? conform_random_bits() : glint_normals_pack(GLINT_NORMALS_INT8, &normal);
            if (x % 17u == 16) /* without surface */
                words[x] = conform_random_bits() % 9;
        }
        const struct glint_vec n = glint_normals_unpack(GLINT_NORMALS_INT8, words[i & 6]);
        end_at(&at, paint, i & 1 ? UINT32_MAX : t_of(&n, &paint->h), light);
        const struct glint_maps maps = {.normals = words, .normals_format = GLINT_NORMALS_INT8};
        add_wide_out((uint32_t)glint_draw_rect(&at, &maps, widths[i / 2u], 1, &line, 0));
    }
    for (uint16_t i = 0; i < WIDE; i++)
        offsets[i] = (uint16_t)(conform_random_bits() & 0x3ffe);
    for (uint8_t i = 0; i < 16; i++)
        add_wide_out(
            (uint32_t)glint_draw_palette(paint->of.tables.filled.colour.colours, offsets, 0, widths[i], 1, &line));
}

/* Both kinds of normals, side by side and with holes, at an even address and not, with the box and without. */
static void add_rects(const struct glint_paint *paint, const struct glint_vec *normals)
{
    static uint8_t coverage[W * H];
    uint32_t *const words = conform_words;
    uint8_t *const out = (uint8_t *)conform_pixels;
    for (uint8_t i = 0; i < W * H; i++)
        coverage[i] = soft_edged();
    for (uint8_t kind = 0; kind < 4; kind++) {
        const bool packed = kind & 1, plain = kind & 2;
        for (uint8_t i = 0; i < W * H; i++)
            words[i] = i % 7 == 6 ? conform_random_bits() : glint_normals_pack(GLINT_NORMALS_INT8, &normals[i]);
        for (uint8_t i = 0; i < LINE * H; i++)
            out[i] = i;
        struct glint_box box = {0, 0, 0, 0};
        struct glint_maps maps = {.normals = normals, .normals_stride = W * sizeof *normals, .coverage_stride = W};
        if (packed) {
            maps.normals = words;
            maps.normals_stride = W * sizeof *words;
            maps.normals_format = GLINT_NORMALS_INT8;
        }
        maps.coverage = plain ? 0 : coverage;
        const struct glint_surface surface = {out + (plain ? 0 : packed), LINE, 1, 2};
        conform_add((uint32_t)glint_draw_rect(paint, &maps, W - 1, H, &surface, plain ? 0 : &box));
        conform_add_box(&box);
        conform_add_bytes(out, LINE * H);
    }
    struct glint_span span = {0, 0, 0, 0, 0, 0, {{0, 0}, {0, 0}}};
    struct glint_box box = {0, 0, 0, 0};
    const struct glint_maps maps = {.coverage = coverage};
    const struct glint_surface even = {out, 0, 0, 0}, odd = {out + LINE + 1, 0, 1, 1};
    conform_add((uint32_t)glint_span_init(&span, paint, &normals[0], &normals[1], W));
    conform_add((uint32_t)glint_draw_span(paint, &span, 0, &even, 0));
    conform_add((uint32_t)glint_draw_span(paint, &span, &maps, &odd, &box));
    conform_add_box(&box);
    conform_add_bytes(out, LINE * H);
}

/* A fill takes seconds in an emulator, so each has one of the two formats; the sum of bits makes it another one for models that have
 * the other flags alike. */
static void add_colours(const struct conformance_size *size, bool dither)
{
    struct glint_paint *const paint = &conform_paint;
    static struct glint_vec normals[W * H];
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        for (uint8_t scene = 0; scene < size->scenes; scene++) {
            const unsigned flags = model + scene, odd = (flags ^ flags >> 1 ^ flags >> 2 ^ scene) & 1;
            struct glint_material material;
            struct glint_light light;
            conform_random_material(&material, &light, model);
            material.clamp_peak = flags & 1;
            const struct glint_output output = {odd ? GLINT_RGB565_SWAPPED : GLINT_RGB565, dither ? 0 : flags >> 1 & 1,
                                                dither};
            if (!conform_fill(paint, GLINT_TABLES_COLOUR, &material, &output))
                continue;
            conform_light(paint, &light);
            for (uint8_t i = 0; i < W * H; i++)
                conform_random_normal(&normals[i], &paint->h);
            add_rects(paint, normals);
            add_wide(paint, &light);
        }
}

void conform_colours(const struct conformance_size *size)
{
    add_colours(size, false);
}

void conform_dithered(const struct conformance_size *size)
{
    add_colours(size, true);
}

/* Both kinds of normals over a map, in rows longer than the loops unroll, and a span; where the map is the output, too. */
static void add_albedo(unsigned model, unsigned flags)
{
    enum { LONG = 75 };
    struct glint_paint *const paint = &conform_paint;
    static uint32_t words[LONG];
    static struct glint_vec normals[LONG];
    static uint16_t map[LONG], pixels[LONG + 1];
    static uint8_t coverage[LONG];
    struct glint_material material;
    struct glint_light light;
    const struct glint_output output = {flags & 1, GLINT_GAMMA, false};
    conform_random_material(&material, &light, model);
    material.clamp_peak = flags >> 1 & 1;
    for (uint8_t k = 0; k < 3; k++) {
        material.ambient_q16[k] = material.ambient_q16[0];
        material.diffuse_q16[k] = 45000;
    }
    if (!conform_fill(paint, GLINT_TABLES_ALBEDO, &material, &output))
        return;
    conform_light(paint, &light);
    const bool in_place = flags & 4;
    struct glint_maps maps = {.albedo = (const uint8_t *)map, .albedo_format = GLINT_RGB565};
    struct glint_box box = {0, 0, 0, 0};
    for (uint8_t kind = 0; kind < 4; kind++) {
        const bool packed = kind & 1, plain = kind & 2;
        struct glint_vec near = {0, 0, 0};
        for (uint8_t i = 0; i < LONG; i++) {
            if (conform_random_bits() % 4 == 0) /* runs of the like: in the lobe, out of it, dark */
                conform_random_normal(&near, &paint->h);
            normals[i] = near;
            if (conform_random_bits() % 8 == 0)
                normals[i].z = (int16_t)-near.z;
            words[i] =
                conform_random_bits() % 16 ? glint_normals_pack(GLINT_NORMALS_INT8, &near) : conform_random_bits() % 5;
            map[i] = (uint16_t)conform_random_bits();
            coverage[i] = soft_edged();
            pixels[i] = i;
        }
        maps.normals = packed ? (const void *)words : (const void *)normals;
        maps.normals_format = packed ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT16;
        maps.coverage = plain ? 0 : coverage;
        const struct glint_surface line = {
            in_place ? (uint8_t *)map : (uint8_t *)pixels + (plain ? 0 : kind & flags & 1), 0, 0, 0};
        conform_add((uint32_t)glint_draw_rect(paint, &maps, (uint16_t)(LONG - flags % 8), 1, &line, plain ? 0 : &box));
        conform_add_box(&box);
        conform_add_bytes(in_place ? (const uint8_t *)map : (const uint8_t *)pixels, sizeof map);
    }
    struct glint_span span = {0, 0, 0, 0, 0, 0, {{0, 0}, {0, 0}}};
    const struct glint_surface line = {pixels, 0, 0, 0};
    conform_add((uint32_t)glint_span_init(&span, paint, &normals[0], &normals[1], LONG));
    for (uint8_t kind = 0; kind < 2; kind++) {
        maps.coverage = kind ? coverage : 0;
        conform_add((uint32_t)glint_draw_span(paint, &span, &maps, &line, kind ? &box : 0));
        conform_add_box(&box);
        conform_add_bytes((const uint8_t *)pixels, sizeof map);
    }
}

void conform_albedo(const struct conformance_size *size)
{
    unsigned flags = 0;
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        for (uint8_t scene = 0; scene < 2 * size->scenes; scene++)
            add_albedo(model, flags++);
}

#elif !CONFORMANCE_MODELS_ONLY

bool conform_fill(struct glint_paint *paint, enum glint_tables_kind kind, const struct glint_material *material,
                  const struct glint_output *output)
{
    (void)paint, (void)kind, (void)material, (void)output;
    return false;
}

void conform_colours(const struct conformance_size *size)
{
    (void)size;
}

void conform_dithered(const struct conformance_size *size)
{
    (void)size;
}

void conform_albedo(const struct conformance_size *size)
{
    (void)size;
}

#endif
