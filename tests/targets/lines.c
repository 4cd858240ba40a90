/* SPDX-License-Identifier: MIT
 * For cores with an exact line of their own: rectangles, and where it takes them spans, that it draws, beside the same ones by the stages
 * in C, byte for byte. An output at an odd address, for the DSP extension's loops a map of gloss, is what leads to those in the same
 * program. The linker's --wrap=glint_line_begin leads here, where calls are counted.
 * LINES_FAULT: the loop takes W for 1 / LINES_FAULT of what it is, which must show: the first pixel that is unlike ends that run. */
#include "glint_fused.h"
#include "glint_mesh.h"
#include "machine.h"

#ifndef LINES_FAULT
#define LINES_FAULT 1
#endif
enum { GRAIN_NONE, GRAIN_BRUSHED, GRAIN_SPUN, GRAIN_SUNRAY, GRAIN_MAP, GRAIN_SHININESS, GRAINS };
#define LINES_ALBEDO GLINT_CORTEX_M0PLUS_ASM                  /* does it take maps of albedo? */
#define LINES_GRAIN GLINT_CORTEX_M0PLUS_ASM                   /* and grain? */
#define LINES_SPANS (GLINT_CORTEX_M0PLUS_ASM || GLINT_HELIUM) /* and exact spans? */
/* By the DSP extension without an albedo map and a clamped peak alone: fewer cases have one. More cases, as QEMU is quick. */
#ifndef LINES_CASES
#define LINES_CASES (GLINT_DSP || GLINT_HELIUM || GLINT_RISCV ? 20000 : 1500)
#endif
enum {
    CASES = LINES_CASES,
    SPANS = GLINT_HELIUM ? CASES : CASES / 4,
    ALBEDO = GLINT_DSP ? 16 : 2,
    W = 95,
    H = 2,
    STRIDE = (GLINT_DSP ? 3 : 2) * W + (GLINT_DSP ? 5 : 4),
    GUARD = 0x5a
};

bool __real_glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo);
bool __wrap_glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo);

static uint32_t taken; /* rectangles that the line drew */

bool __wrap_glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo)
{
    const bool whole = __real_glint_line_begin(loop, paint, albedo);
#if GLINT_CORTEX_M0PLUS_ASM || GLINT_RISCV
    if (whole)
        loop->limit = 0 - (0 - loop->limit) / LINES_FAULT;
#elif GLINT_HELIUM
    for (int k = 0; k < 6; k++)
        loop->width[k / 3][k % 3] = (uint16_t)(loop->width[k / 3][k % 3] / LINES_FAULT);
#else
    if (whole)
        loop->shine[6] /= LINES_FAULT, loop->plain[6] /= LINES_FAULT;
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
static bool make_paint(struct glint_paint *paint, uint32_t number, uint32_t grain)
{
    static const uint16_t shininess[] = {1, 2, 3, 5, 10, 60, 200, 1000};
    static const int32_t v[3] = {0, 0, 1};
    const int32_t l[3] = {(int32_t)below(201) - 100, (int32_t)below(201) - 100, (int32_t)below(120)};
    static const uint8_t models[] = {GLINT_MSH, GLINT_SCHLICK, GLINT_GGX, GLINT_CAYLEY},
                         formats[] = {GLINT_RGB565, GLINT_RGB565_SWAPPED, GLINT_RGB888, GLINT_BGR888};
    struct glint_material m = {.model = models[GLINT_DSP ? number / 4 % 4 : 0]};
    struct glint_output output = {.format = formats[below(GLINT_DSP && m.model == GLINT_MSH ? 4 : 2)]};
    struct glint_light light;
    m.n = (uint16_t)(below(3) ? shininess[below(8)] : 1 + below(1000));
    m.q = (uint8_t)(1 + below(grain ? 11 : 16)); /* beyond 11 grain is drawn by C */
    if (grain && grain != GRAIN_SHININESS)
        m.n_across = (uint16_t)(below(3) ? shininess[below(8)] : 1 + below(1000));
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
static uint8_t albedo[3 * W * H + 4], grains[(W + 1) * H + 4], mask[(W + 1) * H + 4];
static uint16_t out[2][STRIDE * H / 2 + 2]; /* by the line, and by stages */
static uint8_t before[sizeof out[0]];       /* what is blended over */

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
        } else if (kind == 10) {
            const int32_t to[3] = {any(), any(), any()};
            (void)glint_vec_normalize(&n, to);
        } else if (kind == 11) { /* along a direction of grain */
            const struct glint_vec flat[] = {{32767, 0, 0}, {0, -32767, 0}, {-23170, 23170, 60}, {32760, 500, 500}};
            n = flat[below(4)];
        } else if (kind == 9) {
            n = light->l;
            n.z = (int16_t)(n.z ^ -(int32_t)below(2));
        } else if (kind == 12) { /* N.L = 0, and in a wide lobe */
            n.x = n.y = n.z = 0;
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
    for (uint16_t i = 0; i < sizeof grains; i++)
        grains[i] = (uint8_t)below(256);
    for (uint16_t i = 0; i < sizeof albedo; i++)
        albedo[i] = (uint8_t)(below(4) ? below(256) : 255);
    for (uint16_t i = 0; i < sizeof before; i++)
        before[i] = mask_kind == 2 ? GUARD : (uint8_t)below(256);
}

/* As the case says, into out[c]. */
static struct glint_box draw(const struct glint_paint *paint, const struct glint_maps *maps, uint16_t w, uint8_t c)
{
    struct glint_box box = {0, 0, 0, 0};
    uint8_t *bytes = (uint8_t *)out[c];
    for (uint16_t i = 0; i < sizeof out[c]; i++)
        bytes[i] = i < c ? GUARD : before[i - c];
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
    const uint8_t *line = (const uint8_t *)out[0], *c = (const uint8_t *)out[1] + 1;
    for (uint16_t i = 0; i + 1u < sizeof out[0]; i++)
        if (line[i] != c[i])
            return false;
    return a->x == b->x && a->y == b->y && a->w == b->w && a->h == b->h;
}

static uint16_t tables[GLINT_TABLES_COLOUR_BYTES / 2];

static bool case_is_same(uint32_t number)
{
    static const uint8_t widths[] = {0, 1, 2, 3, 15, 16, 17, W};
    struct glint_paint paint;
    const uint32_t grain = !LINES_GRAIN || number / 16 % 3 ? 0 : 1 + number / 48 % (GRAINS - 1);
    if (!make_paint(&paint, number, grain))
        return true; /* a light of length 0 */
    make_normals(&paint);
    make_maps(number % 5);
    const int32_t far_off = (int32_t)1 << below(21);
    const struct glint_maps maps = {
        .normals = normals,
        .normals_stride = sizeof normals / H,
        .grain = grain == GRAIN_MAP ? grains + below(4) : 0,
        .grain_stride = W + 1,
        .shininess = grain == GRAIN_SHININESS ? grains + below(4) : 0,
        .shininess_stride = W + 1,
        .grain_kind = (uint8_t)(grain == GRAIN_SPUN     ? GLINT_GRAIN_SPUN
                                : grain == GRAIN_SUNRAY ? GLINT_GRAIN_SUNRAY
                                                        : GLINT_GRAIN_BRUSHED),
        .grain_at = {(int32_t)below(2048) - far_off, (int32_t)below(256) + far_off - 1},
        .albedo =
            (LINES_ALBEDO || GLINT_DSP) && number % (GLINT_DSP ? 4 : ALBEDO) == 1 && !grain ? albedo + below(4) : 0,
        .albedo_stride = 3 * W,
        .albedo_format = GLINT_RGB888,
        .coverage = number % 5 ? mask + below(4) : 0,
        .coverage_stride = W + 1};
    const uint16_t w = GLINT_DSP && number / 16 % 2 ? W : widths[number / 2 % 8];
    struct glint_paint fast = paint;
    if (GLINT_CORTEX_M0PLUS_ASM && !grain && number % 8 >= 6 && glint_paint_steps(&fast, tables, sizeof tables))
        return false;
    const struct glint_box box = draw(&fast, &maps, w, 0), expected = draw(&paint, &maps, w, 1);
    if (same(&box, &expected))
        return true;
    say("# case ");
    say_number(number);
    say(" differs, width ");
    say_number(w);
    say("\n");
    return false;
}

/* ---- COLOUR tables: lines of INT8 normals, and spans, by the fused loops; an odd address leads to the general way ---- */

static uint32_t words[W * H];

/* Runs of the like, of any that can be packed, of any z; gaps that say their length. */
static void make_words(const struct glint_paint *paint)
{
    make_normals(paint);
    for (uint32_t i = 0, gap = 0; i < W * H; i++) {
        if (gap == 0 && below(24) == 0)
            gap = 1 + below(40);
        if (i % W == 0 || gap > W - i % W)
            gap = gap < W - i % W ? gap : W - i % W;
        words[i] = gap ? gap : glint_normals_pack(GLINT_NORMALS_INT8, &normals[i]);
        if (!gap && below(16) == 0)
            words[i] = (words[i] & 0xffff) | (1 + below(65535)) << 16;
        gap -= gap > 0;
    }
}

static uint32_t spanned; /* pixels of spans that were compared */

/* A span, or lines of words. */
static struct glint_box draw_words(const struct glint_paint *paint, const struct glint_span *span, uint16_t w,
                                   uint8_t c, bool seeks)
{
    const struct glint_maps maps = {.normals = words, .normals_format = GLINT_NORMALS_INT8, .normals_stride = 4 * W};
    struct glint_box box = {0, 0, 0, 0};
    uint8_t *bytes = (uint8_t *)out[c];
    for (uint16_t i = 0; i < sizeof out[c]; i++)
        bytes[i] = GUARD;
    const struct glint_surface surface = {bytes + 2 + c, STRIDE, 3, 5};
    if (span ? glint_draw_span(paint, span, NULL, &surface, seeks ? &box : NULL)
             : glint_draw_rect(paint, &maps, w, H, &surface, seeks ? &box : NULL))
        say("# refused\n");
    return box;
}

static bool words_are_same(const struct glint_paint *fast, const struct glint_paint *paint,
                           const struct glint_span *span, uint16_t w, bool seeks, uint32_t number)
{
    const struct glint_box box = draw_words(fast, span, w, 0, seeks), expected = draw_words(paint, span, w, 1, seeks);
    spanned += span ? w : 0;
    if (same(&box, &expected))
        return true;
    say(span ? "# span " : "# INT8 ");
    say_number(number);
    say(" differs, width ");
    say_number(w);
    say("\n");
    return false;
}

/* Between the first two normals; or one whose steps and sums are anything, or lead to where the highlight and the light end. */
static bool make_span(struct glint_span *span, const struct glint_paint *paint, uint16_t w)
{
    const int32_t spread = 1 << below(15);
    struct glint_vec last = normals[0];
    last.x = (int16_t)(last.x + (int32_t)below((uint32_t)spread) - spread / 2);
    last.z = (int16_t)(last.z + (int32_t)below((uint32_t)spread) - spread / 2);
    if (glint_span_init(span, paint, &normals[0], below(3) ? &last : &normals[1], w))
        return false;
    const uint32_t kind = below(8);
    if (kind == 0) {
        span->t_q30 = below(2) ? below(65536) << below(17) : 0 - (below(65536) << below(12)); /* or a little below 0 */
        span->dt_q30 = (uint32_t)(int32_t)any() << below(17);
        span->ddt_q30 = below(65536) << below(17);
        span->nl_q30 = (int32_t)((uint32_t)any() << below(17));
    } else if (kind == 1 || kind == 2) {
        const bool is_exact = glint_paint_is_exact(paint);
        const uint32_t up =
            is_exact || below(2) ? below(10) : paint->of.tables.filled.shift; /* steps of whole columns */
        const uint32_t dt = (uint32_t)(int32_t)any() << (up < 16 ? up : 16), on = below(w);
        const uint32_t dnl = (uint32_t)(int32_t)any() << below(10);
        const uint32_t end = is_exact ? paint->of.exact.t_end : paint->of.tables.filled.t_max_q30;
        span->t_q30 = (below(2) ? 0 : end) - on * dt + below(3) - 1;
        span->dt_q30 = dt;
        span->ddt_q30 = below(2) ? 0 : below(65536) >> below(16);
        span->nl_q30 = (int32_t)((below(2) ? below(65536) << 15 : below(3) << 13) - on * dnl);
        span->dnl_q30 = (int32_t)dnl;
    }
    return true;
}

/* A light of the paint's, or none. */
static bool light_tables(struct glint_paint *paint)
{
    static const int32_t v[3] = {0, 0, 1};
    const int32_t l[3] = {(int32_t)below(201) - 100, (int32_t)below(201) - 100, (int32_t)below(130) - 10};
    struct glint_light light;
    return !glint_light_directional(&light, l) && !glint_paint_light(paint, &light, 1, v);
}

static bool table_case_is_same(struct glint_paint *paint, uint32_t number)
{
    static const uint8_t widths[] = {1, 2, 3, 7, 8, 9, 17, 33, W};
    const uint16_t w = widths[number / 2 % 9];
    struct glint_span span;
    make_words(paint);
    return (number & 1 && !make_span(&span, paint, w)) ||
           words_are_same(paint, paint, number & 1 ? &span : NULL, w, false, number);
}

/* Exactly, with the highlight's box. */
static bool exact_span_is_same(uint32_t number)
{
    struct glint_paint paint;
    struct glint_span span;
    const uint16_t w = (uint16_t)(1 + below(below(8) < 3 ? 24 : W));
    if (!make_paint(&paint, number, 0))
        return true;
    make_normals(&paint);
    if (!make_span(&span, &paint, w))
        return true;
    struct glint_paint fast = paint;
    if (GLINT_CORTEX_M0PLUS_ASM && number % 4 == 3 && glint_paint_steps(&fast, tables, sizeof tables))
        return false;
    return words_are_same(&fast, &paint, &span, w, true, number);
}

/* ---- Meshes by COLOUR tables, by the fused routine; an odd address leads to the general way ---- */

enum { VERTICES = 24, FACES = 30, MESH_W = 48, MESH_H = 40, MESH_LINES = 11, MESH_STRIDE = 2 * MESH_W + 6, KEPT = 7 };

static uint32_t frame_memory[2048], mesh_memory[1024];

/* Places near each other or anywhere, normals too. */
static void make_mesh(int16_t *places, int8_t *normals8, uint16_t *faces)
{
    const uint32_t reach = 1 << (9 + below(7));
    for (uint16_t i = 0; i < 3 * VERTICES; i++) {
        places[i] = (int16_t)((int32_t)below(2 * reach) - (int32_t)reach);
        normals8[i] = (int8_t)(below(3) || i < 3 ? (int32_t)below(255) - 127 : normals8[i - 3] / 2);
    }
    for (uint16_t i = 0; i < 3 * FACES; i++)
        faces[i] = (uint16_t)below(VERTICES);
}

static uint32_t meshes_shown;

static bool mesh_is_same(const struct glint_paint *paint, uint32_t number)
{
    static int16_t places[3 * VERTICES];
    static int8_t normals8[3 * VERTICES];
    static uint16_t faces[3 * FACES], pictures[2][MESH_STRIDE * MESH_LINES / 2 + 2];
    static const struct glint_mesh mesh = {
        .places = places, .normals8 = normals8, .faces = faces, .vertex_count = VERTICES, .face_count = FACES};
    struct glint_mesh_frame frame[2];
    struct glint_mesh_drawn drawn[2];
    const struct glint_pose pose = {{any(), any(), any(), 1},
                                    {(int16_t)((int32_t)below(600) - 300), (int16_t)((int32_t)below(600) - 300), any()},
                                    (uint16_t)(1 + below(1u << (9 + below(8))))};
    const uint16_t w = (uint16_t)(1 + below(MESH_W)), lines = (uint16_t)(1 + below(MESH_LINES));
    const uint16_t distance = (uint16_t)(below(3) ? 0 : 200 + below(8000));
    bool shows = false;
    make_mesh(places, normals8, faces);
    for (unsigned c = 0; c < 2; c++)
        if (glint_mesh_begin(&frame[c], w, MESH_H, lines, distance, frame_memory + c * 1024,
                             glint_mesh_frame_bytes(w, lines) + KEPT * GLINT_MESH_KEPT_BYTES) ||
            glint_mesh_add(&frame[c], &drawn[c], &mesh, &pose, paint, mesh_memory + c * 512, 2048))
            return false;
    for (uint16_t y = 0; y < MESH_H; y = (uint16_t)(y + lines)) {
        const uint16_t h = lines < MESH_H - y ? lines : (uint16_t)(MESH_H - y);
        for (unsigned c = 0; c < 2; c++) {
            uint8_t *bytes = (uint8_t *)pictures[c];
            for (unsigned i = 0; i < sizeof pictures[c]; i++)
                bytes[i] = GUARD;
            const struct glint_surface surface = {bytes + 2 + c, MESH_STRIDE, 0, y};
            if (glint_mesh_strip(&frame[c], y, h, &surface))
                return false;
        }
        const uint8_t *fused = (const uint8_t *)pictures[0], *other = (const uint8_t *)pictures[1] + 1;
        for (unsigned i = 0; i + 1 < sizeof pictures[0]; i++) {
            shows |= fused[i] != GUARD;
            if (fused[i] != other[i]) {
                say("# mesh ");
                say_number(number);
                say(" differs\n");
                return false;
            }
        }
    }
    meshes_shown += shows;
    return true;
}

/* Is there more to draw? */
static bool goes_on(uint32_t number, uint32_t cases, uint32_t differ)
{
    return number < cases && (LINES_FAULT == 1 || differ == 0);
}

static uint32_t tables_differ(void)
{
    uint32_t differ = 0;
    struct glint_paint paint;
    bool is_made = false;
    for (uint32_t number = 0; goes_on(number, CASES, differ); number++) {
        if (number % 512 == 0) {
            struct glint_material m = {
                .model = GLINT_MSH, .n = (uint16_t)(1 + below(1000)), .q = (uint8_t)(1 + below(16))};
            const struct glint_output output = {.format = (uint8_t)below(2)};
            make_material(&m);
            is_made = !glint_paint_tables(&paint, GLINT_TABLES_COLOUR, &m, &output, tables, sizeof tables);
        }
        if (!is_made || !light_tables(&paint))
            continue;
        if (paint.of.tables.is_frontal)
            differ += !table_case_is_same(&paint, number);
        if ((GLINT_DSP || GLINT_RISCV) && number % 8 == 0)
            differ += !mesh_is_same(&paint, number);
    }
    return differ;
}

bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    uint32_t differ = 0;
    for (uint32_t number = 0; goes_on(number, CASES, differ); number++)
        differ += !case_is_same(number);
    const uint32_t rectangles = taken;
    for (uint32_t number = 0; LINES_SPANS && goes_on(number, SPANS, differ); number++)
        differ += !exact_span_is_same(number);
    differ += LINES_FAULT == 1 ? tables_differ() : 0;
    say_number(rectangles);
    say(" of ");
    say_number(CASES);
    say(" rectangles by the line, ");
    if (LINES_SPANS) {
        say_number(taken - rectangles);
        say(" exact spans by it, ");
        say_number(spanned);
        say(" pixels of spans, ");
    }
    say_number(differ);
    say(" unlike C\n");
    return differ == 0 && (!(GLINT_DSP || GLINT_RISCV) || meshes_shown > CASES / 16) &&
           rectangles > (GLINT_DSP ? CASES / 3 : CASES / 4 * 3) && (!LINES_SPANS || taken - rectangles > SPANS / 2);
}
