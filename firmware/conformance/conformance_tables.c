/* SPDX-License-Identifier: MIT
 * Tables and their loops. */
#include "conformance_tables.h"

#include "conformance_random.h"
#include "conformance_scenes.h"

#if !CONFORMANCE_MODELS_ONLY /* a part that is too small for these is refused at compile time */

enum { TABLES_BYTES = CONFORMANCE_COLOUR ? GLINT_TABLES_DITHER_BYTES : GLINT_TABLES_SMALL_BYTES };
static union {
    uint32_t words[TABLES_BYTES / 4];
    void *aligned;
} memory;

void *conform_memory(size_t *bytes)
{
    *bytes = sizeof memory;
    return &memory;
}

bool conform_fill(struct glint_tables *tables, enum glint_tables_kind kind, const struct glint_shader *shader)
{
    for (uint16_t i = 0; i < TABLES_BYTES / 4; i++)
        memory.words[i] = 0;
    const enum glint_err err = glint_tables_fill(tables, kind, shader, memory.words, sizeof memory.words);
    conform_add((uint32_t)err);
    if (!err)
        conform_add_bytes((const uint8_t *)memory.words,
                          (uint16_t)(kind == GLINT_TABLES_COLOUR && shader->dither ? GLINT_TABLES_DITHER_BYTES
                                                                                   : glint_tables_bytes(kind)));
    return !err;
}

#if CONFORMANCE_COLOUR
enum { WIDE = 319 };
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

/* Spans, packed normals and a palette, wider than what a loop takes at once, at every width where it might turn. */
static void add_wide(const struct glint_tables *tables, const struct glint_tables_light *light,
                     const struct glint_light *from)
{
    static const uint16_t widths[] = {0, 1, 2, 3, 4, 5, 15, 16, 17, 31, 32, 33, 64, 65, 96, WIDE};
    static uint32_t words[WIDE];
    static uint16_t offsets[WIDE];
    struct glint_surface line = {wide_out, sizeof wide_out, 0, 0};
    for (uint16_t i = 0; i < 512; i++) {
        line.x = i & 3;
        line.y = i >> 2 & 3;
        struct glint_span span = {0, 0, 0, 0, 0, widths[i / 32u]};
        tricky_span(&span, tables->t_max_q30, i % 8u);
        add_wide_out((uint32_t)glint_tables_span(tables, &span, &line));
    }
    for (uint8_t i = 0; i < 32; i++) {
        line.x = i >> 1 & 3;
        line.y = i >> 3 & 3;
        const enum glint_normals held = i & 1 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT10;
        for (uint16_t x = 0; x < WIDE; x++) {
            struct glint_vec normal;
            conform_random_normal(&normal, from);
            words[x] = x % 11u == 10 ? conform_random_bits() : glint_normals_pack(held, &normal);
            if (x % 17u == 16) /* without surface */
                words[x] = conform_random_bits() % 9 << (i & 1 ? 0 : 12);
        }
        struct glint_tables at = *tables; /* t_max at a pixel's t, to the unit */
        const struct glint_vec n = glint_normals_unpack(GLINT_NORMALS_INT10, words[i & 6]);
        const int32_t x = (n.x >> 1) - ((light->h.x + 1) >> 1), y = (n.y >> 1) - ((light->h.y + 1) >> 1),
                      z = (n.z >> 1) - ((light->h.z + 1) >> 1);
        const uint32_t t = 2 * ((uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z));
        if ((i & 1) == 0 && t < at.t_max_q30)
            at.t_max_q30 = t;
        add_wide_out((uint32_t)glint_tables_rect(&at, light, held, words, 0, widths[i / 2u], 1, &line));
    }
    for (uint16_t i = 0; i < WIDE; i++)
        offsets[i] = (uint16_t)(conform_random_bits() & 0x3ffe);
    for (uint8_t i = 0; i < 16; i++)
        add_wide_out((uint32_t)glint_palette_rect(tables->colour.colours, offsets, 0, widths[i], 1, &line));
}

/* Every kind of normals over a map, in rows longer than the loops unroll, and a span; where the map is the output, too. */
static void add_albedo(unsigned model, unsigned flags)
{
    enum { LONG = 75 };
    static uint32_t words[LONG];
    static struct glint_vec normals[LONG];
    static uint16_t map[LONG], pixels[LONG + 1];
    struct glint_shader shader;
    conform_random_shader(&shader, model);
    shader.format = flags & 1;
    shader.space = GLINT_GAMMA;
    shader.dither = false;
    shader.clamp_peak = flags >> 1 & 1;
    for (uint8_t k = 0; k < 3; k++) {
        shader.material.ambient_q16[k] = shader.material.ambient_q16[0];
        shader.material.diffuse_q16[k] = 45000;
    }
    struct glint_tables tables;
    struct glint_tables_light light;
    if (!conform_fill(&tables, GLINT_TABLES_ALBEDO, &shader))
        return;
    conform_add((uint32_t)glint_tables_light_init(&light, &tables, &shader.light));
    for (unsigned held = GLINT_NORMALS_INT16; held <= GLINT_NORMALS_INT8; held++) {
        struct glint_vec near = {0, 0, 0};
        for (uint8_t i = 0; i < LONG; i++) {
            if (conform_random_bits() % 4 == 0) /* runs of the like: in the lobe, out of it, dark */
                conform_random_normal(&near, &shader.light);
            normals[i] = near;
            if (conform_random_bits() % 8 == 0)
                normals[i].z = (int16_t)-near.z;
            words[i] = conform_random_bits() % 16 ? glint_normals_pack((enum glint_normals)held, &near)
                                                  : conform_random_bits() % 5;
            map[i] = (uint16_t)conform_random_bits();
            pixels[i] = i;
        }
        const bool packed = held != GLINT_NORMALS_INT16, in_place = flags & 4;
        const struct glint_surface line = {in_place ? (uint8_t *)map : (uint8_t *)pixels + (held & flags & 1), 0, 0, 0};
        conform_add((uint32_t)glint_tables_albedo_rect(&tables, &light, (enum glint_normals)held,
                                                       packed ? (const void *)words : (const void *)normals, 0, map, 0,
                                                       (uint16_t)(LONG - flags % 8), 1, &line));
        conform_add_bytes(in_place ? (const uint8_t *)map : (const uint8_t *)pixels, sizeof map);
    }
    struct glint_span span = {0, 0, 0, 0, 0, 0};
    conform_add((uint32_t)glint_span_init(&span, &shader.light, &normals[0], &normals[1], LONG));
    const struct glint_surface line = {pixels, 0, 0, 0};
    conform_add((uint32_t)glint_tables_albedo_span(&tables, &span, map, &line));
    conform_add_bytes((const uint8_t *)pixels, sizeof map);
}
#endif

/* dither: of COLOUR tables, whose space is then gamma. */
static void add_tables(unsigned kind, unsigned model, unsigned format, unsigned flags, bool dither)
{
    static uint32_t words[W * H];
    static struct glint_vec normals[W * H];
    static uint8_t out[LINE * H];
    struct glint_shader shader;
    conform_random_shader(&shader, model);
    shader.format = (uint8_t)format;
    shader.space = kind == GLINT_TABLES_COLOUR && !dither ? flags >> 1 & 1 : 0;
    shader.dither = kind == GLINT_TABLES_SMALL ? flags & 1 : dither;
    shader.clamp_peak = flags & 1;
    struct glint_tables tables;
    struct glint_tables_light light;
    if (!conform_fill(&tables, (enum glint_tables_kind)kind, &shader))
        return;
    conform_add((uint32_t)glint_tables_light_init(&light, &tables, &shader.light));
    for (uint8_t i = 0; i < W * H; i++)
        conform_random_normal(&normals[i], &shader.light);
    for (unsigned held = GLINT_NORMALS_INT16; held <= GLINT_NORMALS_INT8; held++) {
        for (uint8_t i = 0; i < W * H; i++)
            words[i] = i % 7 == 6 ? conform_random_bits() : glint_normals_pack((enum glint_normals)held, &normals[i]);
        for (uint8_t i = 0; i < LINE * H; i++)
            out[i] = i;
        const struct glint_surface surface = {out + (held & 1), LINE, 1, 2};
        const bool packed = held != GLINT_NORMALS_INT16;
        conform_add((uint32_t)glint_tables_rect(
            &tables, &light, (enum glint_normals)held, packed ? (const void *)words : (const void *)normals,
            (ptrdiff_t)(W * (packed ? sizeof *words : sizeof *normals)), W - 1, H, &surface));
        conform_add_bytes(out, LINE * H);
    }
    struct glint_span span = {0, 0, 0, 0, 0, 0};
    conform_add((uint32_t)glint_span_init(&span, &shader.light, &normals[0], &normals[1], W));
    const struct glint_surface line = {out, LINE, 0, 0};
    conform_add((uint32_t)glint_tables_span(&tables, &span, &line));
    conform_add_bytes(out, LINE);
#if CONFORMANCE_COLOUR
    if (kind == GLINT_TABLES_COLOUR)
        add_wide(&tables, &light, &shader.light);
#endif
}

void conform_small(const struct conformance_size *size)
{
    unsigned flags = 0;
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        for (unsigned format = GLINT_RGB565; format < GLINT_FORMAT_COUNT; format++)
            for (uint8_t scene = 0; scene < size->scenes; scene++)
                add_tables(GLINT_TABLES_SMALL, model, format, flags++, false);
}

/* A fill takes seconds in an emulator, so each has one of the two formats; the sum of bits makes it another one for models that have
 * the other flags alike. */
static void add_colours(const struct conformance_size *size, bool dither)
{
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        for (uint8_t scene = 0; scene < size->scenes; scene++) {
            const unsigned flags = model + scene, odd = (flags ^ flags >> 1 ^ flags >> 2 ^ scene) & 1;
            add_tables(GLINT_TABLES_COLOUR, model, odd ? GLINT_RGB565_SWAPPED : GLINT_RGB565, flags, dither);
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

void conform_albedo(const struct conformance_size *size)
{
#if CONFORMANCE_COLOUR
    unsigned flags = 0;
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        for (uint8_t scene = 0; scene < 2 * size->scenes; scene++)
            add_albedo(model, flags++);
#else
    (void)size;
#endif
}

#endif
