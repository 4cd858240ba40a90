/* SPDX-License-Identifier: MIT */
#include "glint_tables_colour.h"
#include "glint_math_root.h"
#include "glint_pixel.h"
#include "glint_pixel_prepared.h"
#include "glint_tables_geometry.h"

typedef char glint_colour_bytes[GLINT_TABLES_COLOUR_BYTES ==
                                        2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS + (1 << GLINT_COLOUR_COLUMNS_LOG)
                                    ? 1
                                    : -1];

static bool has_step(const struct glint_shader *shader, uint32_t f)
{
    const struct glint_peak peak = {shader, glint_pixel_lobe(shader, 0)};
    return glint_peak_step(&peak, f) != 0;
}

enum { FILL_RUN = GLINT_RUN / 2 }; /* steps at a time: samples on the stack, which is at its deepest here */
typedef char glint_colour_runs[GLINT_COLOUR_STEPS % FILL_RUN == 0 ? 1 : -1];

/* Finished pixels, a run of steps in every row: by the format's quick loop, which leaves few to the 64-bit sequence. */
static void fill_colours(const struct glint_peak *peak, uint8_t *colours)
{
    /* F is given, without slack. */
    static const struct glint_shade_model exact_f GLINT_FLASH = {0, 0, NULL, NULL, NULL, NULL};
    const struct glint_shader *shader = peak->shader;
    const struct glint_shade_format *format = shader->space == GLINT_LINEAR ? &glint_shade_linear : &glint_shade_rgb565;
    struct glint_run run = {NULL, 0, 0, 0, NULL, NULL, NULL};
    struct glint_sample samples[FILL_RUN];
    struct glint_prepared prepared;
    prepared.shader = *shader;
    prepared.model = &exact_f;
    prepared.slack = prepared.apart = prepared.high = 0;
    GLINT_FLASH_POINTER(format->fold)(&prepared);
    for (; run.x < GLINT_COLOUR_STEPS; run.x += FILL_RUN) {
        for (unsigned i = 0; i < FILL_RUN; i++)
            samples[i].f_q16 = glint_peak_f(peak, run.x + i);
        for (run.y = 0; run.y < GLINT_COLOUR_ROWS; run.y++) {
            const uint32_t nl = glint_row_nl(run.y);
            for (unsigned i = 0; i < FILL_RUN; i++)
                samples[i].nl_q16 = nl;
            run.line = colours + 2 * GLINT_COLOUR_STEPS * (ptrdiff_t)run.y;
            const uint32_t open = GLINT_FLASH_POINTER(format->levels)(&prepared, &run, samples, FILL_RUN);
            for (unsigned i = 0; open >> i; i++)
                if (open >> i & 1)
                    GLINT_FLASH_POINTER(format->exact)(shader, &run, i, nl, samples[i].f_q16);
        }
    }
}

/* Two tables, so that neither axis costs a division: t leads to a column, which holds the nearest step of F as an offset in
 * bytes; nl to a row of finished pixels, in which the offset finds the colour. Columns end where F no longer reaches half
 * a step, so that their resolution goes where the highlight is. */
void glint_colour_fill(struct glint_tables *tables, const struct glint_peak *peak, void *memory)
{
    const struct glint_shader *shader = peak->shader;
    const uint32_t columns = (uint32_t)1 << GLINT_COLOUR_COLUMNS_LOG, t_max = glint_last_t(shader, has_step);
    tables->colour.colours = (uint16_t *)memory; /* the 16-bit table first, for its alignment */
    uint8_t *const column = (uint8_t *)memory + 2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS;
    tables->columns = column;
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)glint_columns_shift(t_max, columns);
    for (uint32_t i = 0; i < columns; i++)
        column[i] = (uint8_t)(2 * glint_peak_step_at(peak, glint_column_t(t_max, tables->shift, i)));
    const struct glint_surface dark = {&tables->dark, 2, 0, 0};
    fill_colours(peak, (uint8_t *)memory);
    glint_pixel_store(shader, &dark, 0, 0, 0, 0, shader->material.albedo, 255);
}

static uint32_t square(int16_t x)
{
    return (uint32_t)((int32_t)x * x); /* <= 2^30 */
}

static bool is_unit(const struct glint_vec *v) /* or a little longer, up to 1.03 */
{
    return square(v->x) + square(v->y) + square(v->z) <= ((uint32_t)1 << 30) + ((uint32_t)1 << 26);
}

/* Do the loops for a viewer in front stay inside the tables? Their row is d >> 23, and the 128 rows end at d = 2^30, N.L = 2.
 * Packed normals are at most sqrt(3) long, so INT8 is safe with L up to 1.15. INT10 takes N.L from N.H, so H has to be the
 * half vector: H_z = |L + V| / 2, here within 2^-6. Lights from glint_light_init are far closer than that. */
static bool is_consistent(const struct glint_tables_light *light)
{
    const uint32_t margin = (uint32_t)1 << 24;
    const uint32_t off = (uint32_t)light->peak - ((uint32_t)light->h.z << 15); /* Q29, modulo 2^32: |off| < 2^31.2 */
    return is_unit(&light->l) && is_unit(&light->h) && off + margin <= 2 * margin;
}

/* N.H |L + V| = N.L + N.z for a viewer at (0, 0, 1): one dot serves both. With m = |L + V| = peak / 2^29, 1 - N.H =
 * (peak - d - z) / m, so a column's number is (d + z - cut) 2 / m >> s = ((e >> a) r) >> 20, e = d + z - cut in Q29. */
void glint_colour_light(struct glint_tables_light *light, const struct glint_tables *tables)
{
    light->y = (light->l.y + 1) >> 1; /* Q14, as z */
    light->z = (light->l.z + 1) >> 1;
    light->x = 128 * (int32_t)light->l.x - light->y; /* Q22; v holds x, too */
    const int64_t x = light->l.x, y = 2 * light->y, z = 2 * light->z + 32768;
    const uint32_t peak = glint_root((uint64_t)(x * x + y * y + z * z) << 28);          /* Q29, <= 2^30 + 2^16 */
    const uint32_t reach = (uint32_t)(((uint64_t)tables->t_max_q30 * peak) >> 30) >> 1; /* of e */
    light->peak = (int32_t)peak;
    light->cut = (int32_t)(peak - (uint32_t)(((uint64_t)tables->t_max_q30 * peak) >> 30));
    unsigned a = 0;
    while (reach >> a >= 32768)
        a++;
    const unsigned columns_log = tables->dither ? GLINT_DITHER_COLUMNS_LOG : GLINT_COLOUR_COLUMNS_LOG;
    /* e 2^30 / peak >> s: where a = 0 <= 2^31, as s >= 5 (6 if dithered) and peak >= 2^14; else < 2^18 */
    const unsigned scale = 30 + 32 - columns_log + a - tables->shift;
    const uint64_t r = peak && tables->kind == GLINT_TABLES_COLOUR ? ((uint64_t)1 << scale) / peak : 0;
    light->frontal = light->frontal && is_consistent(light);
    light->a = (uint8_t)a;
    light->r = (uint32_t)r;
}
