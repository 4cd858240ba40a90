/* SPDX-License-Identifier: MIT
 * COLOUR tables with dither, pixel by pixel as lib/sequence.md has them, from the material and without tables. */
#include "tables_model.h"

enum { LONG = 75 };
static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];

static const unsigned most[3] = {31, 63, 31};

/* The nearest sixteenths of a level. */
static unsigned sixteenths(const struct look *s, int k, unsigned albedo, uint32_t nl, uint32_t f)
{
    return gamma_level(value_of(s, k, albedo, nl, f), 16 * most[k], 16);
}

static bool shows(const struct look *s, uint32_t t)
{
    for (int k = 0; k < 3; k++)
        if (sixteenths(s, k, 0, 0, f_at(s, t)))
            return true;
    return false;
}

/* A look, and what its tables' columns are. */
struct model {
    struct look look;
    uint32_t u;
    unsigned shift;
};

static struct model model_of(struct glint_paint *paint)
{
    struct model m = {random_look((enum glint_format)below(2), GLINT_GAMMA), 0, 0};
    m.look.output.dither = true;
    if (m.look.material.model == GLINT_PHONG)
        m.look.material.model = GLINT_MSH;
    paint_of_tables(paint, GLINT_TABLES_COLOUR, &m.look, memory);
    m.u = last_t(&m.look, shows);
    m.shift = least_shift(m.u, 2032);
    return m;
}

/* nl in Q30, < 0 dark; column -1: past the highlight. */
static uint16_t expected(const struct model *m, int64_t nl_q30, int64_t column, unsigned x, unsigned y)
{
    static const int64_t eighths[4] = {7, 5, 1, 3};
    const unsigned b = (unsigned)bayer[(y & 3) * 4 + (x & 3)];
    const int64_t row = (nl_q30 + (eighths[y & 3] << 20)) / (1 << 23);
    const uint32_t nl = nl_q30 < 0 ? 0 : (uint32_t)(512 * row);
    unsigned levels[3];
    for (int k = 0; k < 3; k++) {
        const unsigned albedo = m->look.material.albedo[k];
        if (nl_q30 < 0 || column < 0) {
            levels[k] = gamma_level(value_of(&m->look, k, albedo, nl, 0), most[k], 2 * b + 1);
            continue;
        }
        const uint32_t f = f_at(&m->look, middle(m->u, m->shift, (uint32_t)column));
        const unsigned sum = sixteenths(&m->look, k, albedo, nl, 0) + b + sixteenths(&m->look, k, 0, 0, f);
        levels[k] = sum / 16 < most[k] ? sum / 16 : most[k];
    }
    return in_order(&m->look, levels[0] << 11 | levels[1] << 5 | levels[2]);
}

static int64_t column_at(const struct model *m, int64_t t)
{
    return t > (int64_t)m->u ? -1 : ((int64_t)m->u - t) >> m->shift;
}

static struct glint_vec unit_normal(const struct look *look)
{
    struct glint_vec n;
    do
        n = random_normal(look);
    while (llabs(dot(n, n) - (INT64_C(1) << 30)) > 1 << 16);
    return n;
}

static uint16_t by_vectors(const struct model *m, struct glint_vec n, unsigned x, unsigned y)
{
    return expected(m, dot(n, m->look.l), column_at(m, t_of(n, m->look.h)), x, y);
}

static uint16_t by_int8(const struct model *m, const struct glint_paint *p, uint32_t word, unsigned x, unsigned y)
{
    const int64_t z = (int16_t)(word >> 16);
    const int64_t d =
        (int8_t)word * (int64_t)p->of.tables.x + (int16_t)word * (int64_t)p->of.tables.y + z * p->of.tables.z;
    const int64_t e = d + z * (1 << 14) - p->of.tables.cut;
    return expected(m, 2 * d, e < 0 ? -1 : (int64_t)((uint32_t)(e >> p->of.tables.a) * p->of.tables.r >> 21), x, y);
}

static void dithered_lines_have_the_pixels_of_their_sequence_wherever_they_lie(void **state)
{
    (void)state;
    struct glint_paint paint;
    struct model m;
    for (unsigned i = 0; i < 600; i++) {
        if (i % 20 == 0)
            m = model_of(&paint);
        const enum glint_normals held = (enum glint_normals)(i % 2);
        const bool packed = held == GLINT_NORMALS_INT8;
        uint32_t words[LONG];
        struct glint_vec normals[LONG];
        uint16_t pixels[LONG + 2];
        for (unsigned x = 0, none = 0; x < LONG; x++) {
            normals[x] = unit_normal(&m.look);
            words[x] = glint_normals_pack(held, &normals[x]);
            if (none == 0 && below(30) == 0)
                none = 1 + below(9);
            if (none) { /* no surface */
                words[x] = below(2) ? none : below(none);
                normals[x] = (struct glint_vec){0, 0, 0};
                none--;
            }
        }
        memset(pixels, GUARD, sizeof pixels);
        const uint16_t left = pixels[0], w = (uint16_t)below(LONG + 1);
        uint8_t *const start = (uint8_t *)(pixels + 1) - (i % 5 == 0);
        const struct glint_surface surface = {start, 0, (uint16_t)below(320), (uint16_t)below(240)};
        const struct glint_maps maps = {.normals = packed ? (const void *)words : normals,
                                        .normals_format = (uint8_t)held};
        assert_int_equal(glint_draw_rect(&paint, &maps, w, 1, &surface, NULL), GLINT_OK);
        for (unsigned x = 0; x < w; x++) {
            const unsigned at = surface.x + x;
            const uint16_t wanted = !is_surface(normals[x]) ? left
                                    : packed                ? by_int8(&m, &paint, words[x], at, surface.y)
                                                            : by_vectors(&m, normals[x], at, surface.y);
            uint16_t found;
            memcpy(&found, start + 2 * x, 2);
            if (found != wanted)
                fail_msg("%u, normals %d, pixel %u of %u: %#x, not %#x", i, (int)held, x, w, found, wanted);
        }
        assert_memory_equal(start + 2 * w, &left, 1);
    }
}

/* No surface is a normal of which all is 0. */
static void dithered_normals_along_an_axis_are_surfaces(void **state)
{
    (void)state;
    static const struct glint_vec normals[] = {{32767, 0, 0}, {0, 32767, 0}, {0, 0, 32767}, {-32767, 0, 0}, {0, 0, 0}};
    enum { COUNT = sizeof normals / sizeof *normals };
    struct glint_paint paint;
    const struct model m = model_of(&paint);
    uint16_t pixels[COUNT];
    const struct glint_surface surface = {pixels, 0, 1, 2};
    memset(pixels, GUARD, sizeof pixels);
    const uint16_t left = pixels[0];
    assert_int_equal(glint_draw_rect(&paint, &(struct glint_maps){.normals = normals}, COUNT, 1, &surface, NULL),
                     GLINT_OK);
    for (unsigned x = 0; x < COUNT; x++)
        assert_int_equal(pixels[x], x + 1 == COUNT ? left : by_vectors(&m, normals[x], surface.x + x, surface.y));
}

static void a_dithered_span_has_the_pixels_of_its_sequence_wherever_it_lies(void **state)
{
    (void)state;
    struct glint_paint paint;
    struct model m;
    for (unsigned i = 0; i < 3000; i++) {
        if (i % 100 == 0)
            m = model_of(&paint);
        const unsigned fine = below(12), w = below(LONG + 1);
        struct glint_span span = {below(m.u + (1u << 22)),
                                  (below(1 << 26) - (1u << 25)) >> fine,
                                  below(1 << 20) >> fine,
                                  (int32_t)below(1u << 30),
                                  0,
                                  (uint16_t)w,
                                  {{0, 0}, {0, 0}}};
        span.dnl_q30 = ((int32_t)below(1 << 26) - (1 << 25)) >> fine;
        if (i % 4 == 0) /* about t = 0 in the middle */
            span.dt_q30 = 0 - w / 2 * span.ddt_q30, span.t_q30 = w / 2 * (w / 2) / 2 * span.ddt_q30 + below(7) - 3;
        uint16_t pixels[LONG + 2];
        uint8_t *const start = (uint8_t *)(pixels + 1) - (i % 7 == 0);
        const struct glint_surface surface = {start, 0, (uint16_t)below(320), (uint16_t)below(240)};
        assert_int_equal(glint_draw_span(&paint, &span, NULL, &surface, NULL), GLINT_OK);
        uint32_t t = span.t_q30, dt = span.dt_q30, nl = (uint32_t)span.nl_q30;
        for (unsigned x = 0; x < w; x++) {
            uint16_t found;
            memcpy(&found, start + 2 * x, 2);
            const int64_t column = column_at(&m, t >= UINT32_C(0xf8000000) ? 0 : t);
            if ((int32_t)nl <= 1 << 30 && found != expected(&m, (int32_t)nl, column, surface.x + x, surface.y))
                fail_msg("%u, pixel %u of %u: t %#x, nl %#x", i, x, w, (unsigned)t, (unsigned)nl);
            t += dt;
            dt += span.ddt_q30;
            nl += (uint32_t)span.dnl_q30;
        }
    }
}

static void dithered_tables_need_their_bytes_and_gamma_space(void **state)
{
    (void)state;
    struct glint_paint paint;
    struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
    look.output.dither = true;
    look.material.model = GLINT_MSH;
    const struct glint_material *m = &look.material;
    const struct glint_output *o = &look.output;
    const enum glint_tables_kind colour = GLINT_TABLES_COLOUR, albedo = GLINT_TABLES_ALBEDO;
    assert_int_equal(glint_tables_bytes(colour, true), sizeof memory);
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, memory, sizeof memory - 1), GLINT_ERR_ARG);
    look.output.space = GLINT_LINEAR;
    assert_int_equal(glint_paint_tables(&paint, colour, m, o, memory, sizeof memory), GLINT_ERR_FORMAT);
    look.output.space = GLINT_GAMMA;
    for (int k = 0; k < 3; k++)
        look.material.ambient_q16[k] = look.material.diffuse_q16[k] = 30000;
    assert_int_equal(glint_paint_tables(&paint, albedo, m, o, memory, sizeof memory), GLINT_ERR_FORMAT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dithered_lines_have_the_pixels_of_their_sequence_wherever_they_lie),
        cmocka_unit_test(dithered_normals_along_an_axis_are_surfaces),
        cmocka_unit_test(a_dithered_span_has_the_pixels_of_its_sequence_wherever_it_lies),
        cmocka_unit_test(dithered_tables_need_their_bytes_and_gamma_space),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
