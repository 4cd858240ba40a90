/* SPDX-License-Identifier: MIT
 * For cores with the assembly, or the DSP extension: rectangles that it draws, beside the same ones by the stages in C, byte for byte. An output at an
 * odd address, for the DSP extension's loops a map of gloss, is what leads to C in the same program. The linker's --wrap=glint_line_begin leads here, where calls are counted.
 * LINES_FAULT: the loop takes W for 1 / LINES_FAULT of what it is, which must show. */
#include "glint_fused.h"
#include "machine.h"

#ifndef LINES_FAULT
#define LINES_FAULT 1
#endif
/* By the DSP extension without an albedo map and a clamped peak alone: fewer cases have one. More cases, as QEMU is quick. */
#ifndef LINES_CASES
#define LINES_CASES (GLINT_DSP ? 40000 : 2000)
#endif
enum {
    CASES = LINES_CASES,
    ALBEDO = GLINT_DSP ? 16 : 2,
    W = 95,
    H = 2,
    STRIDE = (GLINT_DSP ? 3 : 2) * W + (GLINT_DSP ? 5 : 4),
    GUARD = 0x5a
};

bool __real_glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo);
bool __wrap_glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo);

static uint32_t taken; /* rectangles that the assembly drew */

bool __wrap_glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo)
{
    const bool whole = __real_glint_line_begin(loop, paint, albedo);
    if (whole)
#if GLINT_DSP
        loop->shine[6] /= LINES_FAULT, loop->plain[6] /= LINES_FAULT;
#else
        loop->limit = 0 - (0 - loop->limit) / LINES_FAULT;
#endif
    taken += whole;
    return whole;
}

static void say(const char *text)
{
    while (*text)
        machine_put(*text++);
}

static void say_number(uint32_t n)
{
    if (n > 9)
        say_number(n / 10);
    machine_put((char)('0' + n % 10));
}

#ifndef LINES_SEED
#define LINES_SEED 1
#endif
static uint32_t seed = LINES_SEED;

static uint32_t below(uint32_t limit)
{
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 16) * limit >> 16;
}

static int16_t any(void)
{
    static const int16_t extreme[] = {-32768, 32767, 0, 1, -1, 23170};
    return below(3) ? (int16_t)(below(65536) - 32768) : extreme[below(6)];
}

static struct glint_vec any_vector(void)
{
    struct glint_vec v;
    v.x = any();
    v.y = any();
    v.z = any();
    return v;
}

/* Coefficients: dim; up to more than full; or so that all pixels lie about the step between two levels. */
static void make_material(struct glint_material *m)
{
    const uint32_t kind = below(3);
    for (uint8_t k = 0; k < 3; k++) {
        const uint32_t max = k == 1 ? 63 : 31, level = below(max);
        const uint32_t step = ((2 * level + 1) * 65536 + max) / (2 * max);
        m->albedo[k] = (uint8_t)(kind == 2 ? 255 : below(256));
        m->ambient_q16[k] = kind == 0 ? below(6000) : kind == 1 ? below(40000) : step - below(3);
        m->diffuse_q16[k] = below(kind == 0 ? 40000 : kind == 1 ? 65537 : 1u << below(8));
        m->specular_q16[k] = below(kind == 0 ? 30000 : kind == 1 ? 65537 : 1u << below(8));
    }
}

/* A paint of any light: as the library makes it, or, once in a while, with any vectors, N.L of which fits. */
static bool make_paint(struct glint_paint *paint, uint32_t number)
{
    static const uint16_t shininess[] = {1, 2, 3, 5, 10, 60, 200, 1000};
    static const int32_t v[3] = {0, 0, 1};
    const int32_t l[3] = {(int32_t)below(201) - 100, (int32_t)below(201) - 100, (int32_t)below(120)};
    static const uint8_t models[] = {GLINT_MSH, GLINT_SCHLICK, GLINT_GGX},
                         formats[] = {GLINT_RGB565, GLINT_RGB565_SWAPPED, GLINT_RGB888, GLINT_BGR888};
    struct glint_material m = {.model = models[GLINT_DSP ? number / 4 % 3 : 0]};
    struct glint_output output = {.format = formats[below(GLINT_DSP && m.model == GLINT_MSH ? 4 : 2)]};
    struct glint_light light;
    m.n = (uint16_t)(below(3) ? shininess[below(8)] : 1 + below(1000));
    m.q = (uint8_t)(1 + below(16));
    m.clamp_peak = below(ALBEDO) == 0;
    make_material(&m);
    output.dither = GLINT_DSP && output.format <= GLINT_RGB565_SWAPPED && below(4) == 0;
    if (glint_paint_exact(paint, &m, &output) || glint_light_directional(&light, l))
        return false;
    for (uint8_t k = 0; k < 3 && number % 3 == 0; k++)
        light.color_q16[k] = below(4) ? below(65536) : below(65536) << below(5);
    if (glint_paint_light(paint, &light, 1, v) || below(16) == 0) {
        paint->light_count = 1;
        paint->v = paint->h = any_vector();
        paint->l = any_vector();
        paint->l.x = (int16_t)(paint->l.x / 3);
        paint->l.y = (int16_t)(paint->l.y / 3);
        paint->l.z = (int16_t)(paint->l.z / 3);
    }
    return true;
}

static struct glint_vec normals[W * H];
static const uint8_t *gloss; /* 255 everywhere */
static uint8_t albedo[3 * W * H + 4], mask[(W + 1) * H + 4];
static uint16_t out[2][STRIDE * H / 2 + 2]; /* by the assembly, and in C */

/* Runs of the like: near the half vector, away from the light, anything. */
static void make_normals(const struct glint_paint *light)
{
    const int32_t spread = 1 << below(15);
    struct glint_vec n = any_vector();
    for (uint16_t i = 0; i < W * H; i++) {
        const uint32_t kind = below(16);
        if (kind < 8) {
            n.x = (int16_t)(light->h.x + (int32_t)below((uint32_t)spread) - spread / 2);
            n.y = (int16_t)(light->h.y + (int32_t)below((uint32_t)spread) - spread / 2);
            n.z = light->h.z;
        } else if (kind == 8) {
            n = any_vector();
        } else if (kind == 9) {
            n = light->l;
            n.z = (int16_t)(n.z ^ -(int32_t)below(2));
        }
        normals[i] = n;
    }
}

static void make_maps(uint32_t mask_kind)
{
    static uint8_t full[(W + 1) * H];
    for (uint16_t i = 0; GLINT_DSP && i < sizeof full; i++)
        full[i] = 255;
    gloss = GLINT_DSP ? full : 0;
    uint8_t held = 0;
    for (uint16_t i = 0; i < sizeof mask; i++) {
        if (below(mask_kind == 1 ? 2 : 12) == 0)
            held = (uint8_t)(below(3) == 0 ? 0 : below(3) ? 255 : below(256));
        mask[i] = held;
    }
    for (uint16_t i = 0; i < sizeof albedo; i++)
        albedo[i] = (uint8_t)(below(4) ? below(256) : 255);
}

/* As the case says, into out[c]. */
static struct glint_box draw(const struct glint_paint *paint, const struct glint_maps *maps, uint16_t w, uint8_t c)
{
    struct glint_box box = {0, 0, 0, 0};
    uint8_t *bytes = (uint8_t *)out[c];
    for (uint16_t i = 0; i < sizeof out[c]; i++)
        bytes[i] = GUARD;
    const struct glint_surface surface = {bytes + 2 + c, STRIDE, 3, 5};
    struct glint_maps in_c = *maps;
    if (c) { /* nor does the loop take gloss */
        in_c.gloss = gloss;
        in_c.gloss_stride = W + 1;
    }
    if (glint_draw_rect(paint, &in_c, w, H, &surface, &box))
        say("# refused\n");
    return box;
}

static bool same(const struct glint_box *a, const struct glint_box *b)
{
    const uint8_t *assembly = (const uint8_t *)out[0], *c = (const uint8_t *)out[1] + 1;
    for (uint16_t i = 0; i + 1u < sizeof out[0]; i++)
        if (assembly[i] != c[i])
            return false;
    return a->x == b->x && a->y == b->y && a->w == b->w && a->h == b->h;
}

static bool case_is_same(uint32_t number)
{
    static const uint8_t widths[] = {0, 1, 2, 3, 15, 16, 17, W};
    struct glint_paint paint;
    if (!make_paint(&paint, number))
        return true; /* a light of length 0 */
    make_normals(&paint);
    make_maps(number % 5);
    const struct glint_maps maps = {.normals = normals,
                                    .normals_stride = sizeof normals / H,
                                    .albedo = number % ALBEDO == 1 ? albedo + below(4) : 0,
                                    .albedo_stride = 3 * W,
                                    .albedo_format = GLINT_RGB888,
                                    .coverage = number % 5 ? mask + below(4) : 0,
                                    .coverage_stride = W + 1};
    const uint16_t w = GLINT_DSP && number / 16 % 2 ? W : widths[number / 2 % 8];
    const struct glint_box box = draw(&paint, &maps, w, 0), expected = draw(&paint, &maps, w, 1);
    if (same(&box, &expected))
        return true;
    say("# case ");
    say_number(number);
    say(" differs, width ");
    say_number(w);
    say("\n");
    return false;
}

bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    uint32_t differ = 0;
    for (uint32_t number = 0; number < CASES; number++)
        differ += !case_is_same(number);
    say_number(taken);
    say(" of ");
    say_number(CASES);
    say(" rectangles in assembly, ");
    say_number(differ);
    say(" unlike C\n");
    return differ == 0 && taken > (GLINT_DSP ? CASES / 3 : CASES / 4 * 3);
}
