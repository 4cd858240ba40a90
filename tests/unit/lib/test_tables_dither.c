/* SPDX-License-Identifier: MIT
 * COLOUR tables with dither, pixel by pixel as lib/sequence.md has them, from the material and without tables. */
#include "tables_model.h"

enum { LONG = 75 };
static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];

static const unsigned most[3] = {31, 63, 31};

/* The nearest sixteenths of a level. */
static unsigned sixteenths(const struct glint_shader *s, int k, unsigned albedo, uint32_t nl, uint32_t f)
{
    return gamma_level(value_of(s, k, albedo, nl, f), 16 * most[k], 16);
}

static bool shows(const struct glint_shader *s, uint32_t t)
{
    for (int k = 0; k < 3; k++)
        if (sixteenths(s, k, 0, 0, f_at(s, t)))
            return true;
    return false;
}

/* A shader, and what the tables' columns are. */
struct model {
    struct glint_shader shader;
    uint32_t u;
    unsigned shift;
};

static struct model model_of(struct glint_tables *tables, struct glint_tables_light *light)
{
    struct model m = {random_shader((enum glint_format)below(2), GLINT_GAMMA), 0, 0};
    m.shader.dither = true;
    if (m.shader.lobe.model == GLINT_PHONG)
        m.shader.lobe.model = GLINT_MSH;
    assert_int_equal(glint_tables_fill(tables, GLINT_TABLES_COLOUR, &m.shader, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_tables_light_init(light, tables, &m.shader.light), GLINT_OK);
    m.u = last_t(&m.shader, shows);
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
        const unsigned albedo = m->shader.material.albedo[k];
        if (nl_q30 < 0 || column < 0) {
            levels[k] = gamma_level(value_of(&m->shader, k, albedo, nl, 0), most[k], 2 * b + 1);
            continue;
        }
        const uint32_t f = f_at(&m->shader, middle(m->u, m->shift, (uint32_t)column));
        const unsigned sum = sixteenths(&m->shader, k, albedo, nl, 0) + b + sixteenths(&m->shader, k, 0, 0, f);
        levels[k] = sum / 16 < most[k] ? sum / 16 : most[k];
    }
    return in_order(&m->shader, levels[0] << 11 | levels[1] << 5 | levels[2]);
}

static int64_t column_at(const struct model *m, int64_t t)
{
    return t > (int64_t)m->u ? -1 : ((int64_t)m->u - t) >> m->shift;
}

static struct glint_vec unit_normal(const struct glint_light *light)
{
    struct glint_vec n;
    do
        n = random_normal(light);
    while (llabs(dot(n, n) - (INT64_C(1) << 30)) > 1 << 16);
    return n;
}

static uint16_t by_vectors(const struct model *m, struct glint_vec n, unsigned x, unsigned y)
{
    const struct glint_vec h = m->shader.light.h;
    const int64_t tx = n.x - h.x, ty = n.y - h.y, tz = n.z - h.z;
    return expected(m, dot(n, m->shader.light.l), column_at(m, (tx * tx + ty * ty + tz * tz) >> 1), x, y);
}

static uint16_t by_int8(const struct model *m, const struct glint_tables_light *light, uint32_t word, unsigned x,
                        unsigned y)
{
    const int64_t z = (int16_t)(word >> 16);
    const int64_t d = (int8_t)word * (int64_t)light->x + (int16_t)word * (int64_t)light->y + z * light->z;
    const int64_t e = d + z * (1 << 14) - light->cut;
    return expected(m, 2 * d, e < 0 ? -1 : (int64_t)((uint32_t)(e >> light->a) * light->r >> 21), x, y);
}

static uint16_t by_int10(const struct model *m, const struct glint_tables_light *light, uint32_t word, unsigned at_x,
                         unsigned at_y)
{
    const int64_t x = 32 * (int64_t)((int32_t)word >> 22) - ((light->h.x + 1) >> 1);
    const int64_t y = 32 * (int64_t)((int32_t)(word << 10) >> 22) - ((light->h.y + 1) >> 1);
    const int64_t z = (int32_t)(word << 20) >> 20, from = 8 * z - ((light->h.z + 1) >> 1);
    const int64_t v = x * x + y * y + from * from, d = light->peak - (light->peak >> 15) * (v >> 14) - z * (1 << 18);
    return expected(m, 2 * d, v > m->u >> 1 ? -1 : ((m->u >> 1) - v) >> (m->shift - 1), at_x, at_y);
}

static void dithered_lines_have_the_pixels_of_their_sequence_wherever_they_lie(void **state)
{
    (void)state;
    struct glint_tables tables;
    struct glint_tables_light light;
    struct model m;
    for (unsigned i = 0; i < 600; i++) {
        if (i % 20 == 0)
            m = model_of(&tables, &light);
        const enum glint_normals held = (enum glint_normals)(i % 3);
        uint32_t words[LONG];
        struct glint_vec normals[LONG];
        uint16_t pixels[LONG + 2];
        for (unsigned x = 0; x < LONG; x++) {
            normals[x] = unit_normal(&m.shader.light);
            words[x] = glint_normals_pack(held, &normals[x]);
            if (below(30) == 0) { /* no surface; at odd addresses lines are drawn in pieces, which a run ends with */
                words[x] = below(i % 5 ? 9 : 2) << (held == GLINT_NORMALS_INT10 ? 12 : 0);
                normals[x] = (struct glint_vec){0, 0, 0};
            }
        }
        memset(pixels, GUARD, sizeof pixels);
        const uint16_t left = pixels[0], w = (uint16_t)below(LONG + 1);
        uint8_t *const start = (uint8_t *)(pixels + 1) - (i % 5 == 0);
        const struct glint_surface surface = {start, 0, (uint16_t)below(320), (uint16_t)below(240)};
        const bool packed = held != GLINT_NORMALS_INT16;
        assert_int_equal(glint_tables_rect(&tables, &light, held, packed ? (const void *)words : (const void *)normals,
                                           0, w, 1, &surface),
                         GLINT_OK);
        for (unsigned x = 0, none = 0; x < w; x++) {
            const uint32_t word = words[x];
            const unsigned at = surface.x + x;
            if (packed && none == 0 && (held == GLINT_NORMALS_INT8 ? word >> 16 : word << 20) == 0) {
                none = held == GLINT_NORMALS_INT8 ? word : word >> 12;
                none += none == 0;
            }
            const bool empty = packed ? none > 0 : !(normals[x].x | normals[x].y | normals[x].z);
            const uint16_t wanted = empty                        ? left
                                    : held == GLINT_NORMALS_INT8 ? by_int8(&m, &light, word, at, surface.y)
                                    : packed                     ? by_int10(&m, &light, word, at, surface.y)
                                                                 : by_vectors(&m, normals[x], at, surface.y);
            uint16_t found;
            memcpy(&found, start + 2 * x, 2);
            if (found != wanted)
                fail_msg("%u, normals %d, pixel %u of %u: %#x, not %#x", i, (int)held, x, w, found, wanted);
            none -= none > 0;
        }
        assert_memory_equal(start + 2 * w, &left, 1);
    }
}

/* No surface is left out as in a line of a viewer in front. */
static void dithered_lines_of_10_bits_are_those_of_their_vectors_for_a_viewer_aside(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 60; i++) {
        struct glint_tables tables;
        struct glint_tables_light light;
        struct model m = model_of(&tables, &light);
        const int32_t to_light[3] = {(int32_t)below(200) - 100, (int32_t)below(200) - 100, 100};
        const int32_t to_viewer[3] = {40 + (int32_t)below(100), (int32_t)below(100), 100};
        assert_int_equal(glint_light_init(&m.shader.light, to_light, to_viewer), GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &m.shader.light), GLINT_OK);
        uint32_t words[LONG];
        uint16_t pixels[LONG];
        for (unsigned x = 0; x < LONG; x++) {
            const struct glint_vec n = unit_normal(&m.shader.light);
            words[x] = x % 10 > 6 ? (10 - x % 10) << 12 : glint_normals_pack(GLINT_NORMALS_INT10, &n); /* a gap of 3 */
        }
        memset(pixels, GUARD, sizeof pixels);
        const uint16_t left = pixels[0];
        const struct glint_surface surface = {pixels, 0, (uint16_t)below(320), (uint16_t)below(240)};
        assert_int_equal(glint_tables_rect(&tables, &light, GLINT_NORMALS_INT10, words, 0, LONG, 1, &surface),
                         GLINT_OK);
        for (unsigned x = 0; x < LONG; x++)
            assert_int_equal(pixels[x], x % 10 > 6 ? left
                                                   : by_vectors(&m, glint_normals_unpack(GLINT_NORMALS_INT10, words[x]),
                                                                surface.x + x, surface.y));
    }
}

/* No surface is a normal of which all is 0. */
static void dithered_normals_along_an_axis_are_surfaces(void **state)
{
    (void)state;
    static const struct glint_vec normals[] = {{32767, 0, 0}, {0, 32767, 0}, {0, 0, 32767}, {-32767, 0, 0}, {0, 0, 0}};
    enum { COUNT = sizeof normals / sizeof *normals };
    struct glint_tables tables;
    struct glint_tables_light light;
    const struct model m = model_of(&tables, &light);
    uint16_t pixels[COUNT];
    const struct glint_surface surface = {pixels, 0, 1, 2};
    memset(pixels, GUARD, sizeof pixels);
    const uint16_t left = pixels[0];
    assert_int_equal(glint_tables_rect(&tables, &light, GLINT_NORMALS_INT16, normals, 0, COUNT, 1, &surface), GLINT_OK);
    for (unsigned x = 0; x < COUNT; x++)
        assert_int_equal(pixels[x], x + 1 == COUNT ? left : by_vectors(&m, normals[x], surface.x + x, surface.y));
}

static void a_dithered_span_has_the_pixels_of_its_sequence_wherever_it_lies(void **state)
{
    (void)state;
    struct glint_tables tables;
    struct glint_tables_light light;
    struct model m;
    for (unsigned i = 0; i < 3000; i++) {
        if (i % 100 == 0)
            m = model_of(&tables, &light);
        const unsigned fine = below(12), w = below(LONG + 1);
        struct glint_span span = {below(m.u + (1u << 22)),
                                  (below(1 << 26) - (1u << 25)) >> fine,
                                  below(1 << 20) >> fine,
                                  (int32_t)below(1u << 30),
                                  0,
                                  (uint16_t)w};
        span.dnl_q30 = ((int32_t)below(1 << 26) - (1 << 25)) >> fine;
        if (i % 4 == 0) /* about t = 0 in the middle */
            span.dt_q30 = 0 - w / 2 * span.ddt_q30, span.t_q30 = w / 2 * (w / 2) / 2 * span.ddt_q30 + below(7) - 3;
        uint16_t pixels[LONG + 2];
        uint8_t *const start = (uint8_t *)(pixels + 1) - (i % 7 == 0);
        const struct glint_surface surface = {start, 0, (uint16_t)below(320), (uint16_t)below(240)};
        assert_int_equal(glint_tables_span(&tables, &span, &surface), GLINT_OK);
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

/* For the sanitizers. */
static void garbage_reads_nothing_outside_the_dithered_tables(void **state)
{
    (void)state;
    uint32_t *tight = malloc(GLINT_TABLES_DITHER_BYTES), words[300];
    assert_non_null(tight);
    for (int i = 0; i < 200; i++) {
        struct glint_shader shader = random_shader((enum glint_format)below(2), GLINT_GAMMA);
        struct glint_tables tables;
        struct glint_tables_light light;
        uint16_t out[150];
        shader.dither = true;
        shader.lobe.model = (uint8_t)below(3);
        assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, tight, GLINT_TABLES_DITHER_BYTES),
                         GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
        for (int k = 0; k < 300; k++)
            words[k] = below(UINT32_MAX);
        const struct glint_surface surface = {out, 0, (uint16_t)below(4), (uint16_t)below(4)};
        for (int format = 0; format < 3; format++)
            assert_int_equal(glint_tables_rect(&tables, &light, (enum glint_normals)format, words, 0, 100, 1, &surface),
                             GLINT_OK);
        const struct glint_span span = {words[0], words[1], words[2], (int32_t)words[3], (int32_t)words[4], 150};
        assert_int_equal(glint_tables_span(&tables, &span, &surface), GLINT_OK);
    }
    free(tight);
}

static void dithered_tables_need_their_bytes_and_gamma_space(void **state)
{
    (void)state;
    struct glint_tables tables;
    struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
    shader.dither = true;
    shader.lobe.model = GLINT_MSH;
    const enum glint_tables_kind colour = GLINT_TABLES_COLOUR, albedo = GLINT_TABLES_ALBEDO;
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, memory, sizeof memory - 1), GLINT_ERR_ARG);
    shader.space = GLINT_LINEAR;
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, memory, sizeof memory), GLINT_ERR_FORMAT);
    shader.space = GLINT_GAMMA;
    for (int k = 0; k < 3; k++)
        shader.material.ambient_q16[k] = shader.material.diffuse_q16[k] = 30000;
    assert_int_equal(glint_tables_fill(&tables, albedo, &shader, memory, sizeof memory), GLINT_ERR_FORMAT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dithered_lines_have_the_pixels_of_their_sequence_wherever_they_lie),
        cmocka_unit_test(dithered_lines_of_10_bits_are_those_of_their_vectors_for_a_viewer_aside),
        cmocka_unit_test(dithered_normals_along_an_axis_are_surfaces),
        cmocka_unit_test(a_dithered_span_has_the_pixels_of_its_sequence_wherever_it_lies),
        cmocka_unit_test(garbage_reads_nothing_outside_the_dithered_tables),
        cmocka_unit_test(dithered_tables_need_their_bytes_and_gamma_space),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
