/* SPDX-License-Identifier: MIT */
#include "sweep.h"

#include "glint.h"

const struct sweep_size sweep_whole = {1, 7, 3000, 1, 40, 50000};
const struct sweep_size sweep_small = {4, 8191, 6, 8, 1, 20};

static uint64_t hash;

static void add_bytes(const uint8_t *bytes, uint16_t count)
{
    while (count--) {
        hash ^= *bytes++;
        hash *= UINT64_C(0x100000001b3);
    }
}

static void add(uint32_t value) /* the low byte first on every machine */
{
    const uint8_t bytes[4] = {(uint8_t)value, (uint8_t)(value >> 8), (uint8_t)(value >> 16), (uint8_t)(value >> 24)};
    add_bytes(bytes, 4);
}

static uint32_t state;

static uint32_t random_bits(void)
{
    state = state * UINT32_C(1664525) + UINT32_C(1013904223);
    return state ^ state >> 16;
}

static int32_t random_within(int32_t limit) /* -limit..limit */
{
    return (int32_t)(random_bits() % (2 * (uint32_t)limit + 1)) - limit;
}

/* One call a statement everywhere: within one, the compiler chooses the order. */
static void random_vector(int32_t v[3], int32_t limit)
{
    for (uint8_t i = 0; i < 3; i++)
        v[i] = random_within(limit);
}

/* ---- lobes ---- */

static const uint16_t shininess[] = {60, 0, 1, 2, 1000, 3, 4, 5, 17, 7, 10, 35, 200, 100, 255, 513, 704, 999, 5000};
enum { SHININESS_COUNT = sizeof shininess / sizeof *shininess, MODEL_COUNT = GLINT_CAYLEY + 1 };

/* No table of pointers: the stack check follows calls by name. */
#define ADD_LOBE(model)                                                                                                \
    for (int32_t c = -1000; c <= GLINT_C_ONE + 1000; c += size->c_step)                                                \
        add(glint_##model(n, c));                                                                                      \
    for (uint16_t k = 0; k < size->t_count; k++) /* ever nearer to the peak, where lobes are */                        \
        add(glint_##model##_t(n, random_bits() >> (1 + k % 16)));                                                      \
    for (unsigned q = 0; q <= GLINT_Q_MAX + 1; q += size->q_step) {                                                    \
        add(glint_##model##_cutoff(n, q));                                                                             \
        add(glint_##model##_cutoff_t(n, q));                                                                           \
    }

static void add_lobes(const struct sweep_size *size, uint16_t n)
{
    ADD_LOBE(msh)
    ADD_LOBE(schlick)
    ADD_LOBE(blinn)
    ADD_LOBE(gauss)
    ADD_LOBE(cayley)
}

static void add_dispatch(const struct sweep_size *size, uint16_t n)
{
    for (unsigned model = 0; model <= MODEL_COUNT; model++) { /* one more than there are */
        struct glint_lobe lobe;
        glint_lobe_init(&lobe, (enum glint_model)model, n, n % 17u);
        add(lobe.c_min_q16);
        add(lobe.t_max_q30);
        for (uint16_t k = 0; k < size->t_count; k++) {
            const uint32_t t = random_bits() >> (1 + k % 16);
            const int32_t c = GLINT_C_ONE - (int32_t)(t >> 14);
            add(glint_eval((enum glint_model)model, n, c));
            add(glint_eval_t((enum glint_model)model, n, t));
            add(glint_lobe_eval(&lobe, c));
            add(glint_lobe_eval_t(&lobe, t));
        }
        add(glint_cutoff((enum glint_model)model, n, n % 18u));
        add(glint_cutoff_t((enum glint_model)model, n, n % 18u));
    }
}

/* ---- geometry and colour ---- */

static void add_vectors(const struct sweep_size *size)
{
    for (uint16_t k = 0; k < size->random_vectors; k++) {
        const int32_t limit = k & 1 ? INT32_C(0x3fffffff) : INT32_C(40);
        int32_t a[3], b[3];
        random_vector(a, limit);
        random_vector(b, limit);
        struct glint_vec v = {0, 0, 0};
        struct glint_light light = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        add((uint32_t)glint_vec_normalize(&v, a));
        add((uint32_t)glint_light_init(&light, a, b));
        add((uint16_t)v.x | (uint32_t)(uint16_t)v.y << 16);
        add((uint16_t)v.z | (uint32_t)(uint16_t)light.l.x << 16);
        add((uint16_t)light.v.y | (uint32_t)(uint16_t)light.h.x << 16);
        add((uint16_t)light.h.y | (uint32_t)(uint16_t)light.h.z << 16);
    }
}

static void add_srgb(const struct sweep_size *size)
{
    for (uint16_t i = 0; i < 256; i++)
        add(glint_srgb_decode((uint8_t)i));
    for (uint32_t i = 0; i < 65536; i += size->c_step)
        add(glint_srgb_encode((uint16_t)i));
}

/* ---- pixels ---- */

enum { W = 13, H = 3, LINE = 3 * W + 2 };

static void random_shader(struct glint_shader *shader, unsigned model)
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    int32_t to_light[3];
    random_vector(to_light, 100);
    const uint32_t n = 1 + random_bits() % 100;
    glint_lobe_init(&shader->lobe, (enum glint_model)model, n, (unsigned)(random_bits() % 17));
    if (glint_light_init(&shader->light, to_light, to_viewer) != GLINT_OK)
        add(1);
    for (uint8_t k = 0; k < 3; k++) {
        shader->material.ambient_q16[k] = random_bits() % 20000;
        shader->material.diffuse_q16[k] = random_bits() % 70000;
        shader->material.specular_q16[k] = random_bits() % 70000;
        shader->material.albedo[k] = (uint8_t)random_bits();
    }
}

/* About the half vector, so that the highlight is met. */
static void random_normal(struct glint_vec *normal, const struct glint_light *light)
{
    int32_t v[3];
    random_vector(v, 9000);
    v[0] += light->h.x;
    v[1] += light->h.y;
    v[2] = light->h.z;
    if (glint_vec_normalize(normal, v) != GLINT_OK)
        add(2);
}

static void add_box(const struct glint_box *box)
{
    add(box->x | (uint32_t)box->y << 16);
    add(box->w | (uint32_t)box->h << 16);
}

/* A lamp of any kind near the rectangle; some calls are refused. */
static void random_lamp(struct glint_lamp *lamp)
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    int32_t a[3], b[3];
    random_vector(a, 400);
    random_vector(b, 200);
    const int32_t inner = random_within(INT32_C(0x40000000)), outer = random_within(INT32_C(0x40000000));
    const uint32_t range = random_bits() % 2000;
    a[2] = a[2] < 0 ? -a[2] : a[2];
    switch (random_bits() % 4) {
    case GLINT_DIRECTIONAL:
        add((uint32_t)glint_lamp_directional(lamp, a, to_viewer));
        break;
    case GLINT_POINT:
        add((uint32_t)glint_lamp_point(lamp, a, range));
        break;
    default:
        add((uint32_t)glint_lamp_spot(lamp, a, b, range, inner, outer));
    }
    for (uint8_t k = 0; k < 3; k++) {
        lamp->color_q16[k] = random_bits() % 140000;
        add((uint32_t)lamp->axis_q30[k]);
    }
}

static void add_scene(unsigned model, unsigned format, unsigned space, unsigned flags)
{
    static struct glint_vec normals[W * H];
    static uint8_t albedo[3 * W * H], byte_map[W * H], out[LINE * H];
    struct glint_shader shader;
    random_shader(&shader, model);
    shader.format = (uint8_t)format;
    shader.space = (uint8_t)space;
    shader.dither = flags & 1;
    shader.clamp_peak = flags >> 1 & 1;
    for (uint8_t i = 0; i < W * H; i++) {
        random_normal(&normals[i], &shader.light);
        byte_map[i] = (uint8_t)random_bits();
        byte_map[i] = byte_map[i] & 1 ? 255 : byte_map[i] & 8 ? 0 : byte_map[i];
    }
    for (uint8_t i = 0; i < 3 * W * H; i++)
        albedo[i] = (uint8_t)random_bits();
    for (uint8_t i = 0; i < LINE * H; i++)
        out[i] = i;

    struct glint_source source = {normals, W * sizeof *normals, 0, 3 * W, 0, W, 0, W};
    source.albedo = flags & 4 ? albedo : 0;
    source.gloss = flags & 8 ? byte_map : 0;
    source.mask = flags & 1 ? byte_map : 0;
    const uint16_t phase = random_bits() & 15;
    struct glint_surface surface = {out, LINE, phase & 3, phase >> 2};
    struct glint_box box = {0, 0, 0, 0};
    add((uint32_t)glint_shade_rect(&shader, &source, W, H, &surface, &box));
    add_box(&box);
    add_bytes(out, LINE * H);

    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    const unsigned lamp_count = flags % (GLINT_LAMPS_MAX + 1);
    for (unsigned i = 0; i < lamp_count; i++) {
        static const int32_t above[3] = {100, 20, 150};
        (void)glint_lamp_point(&lamps[i], above, 1000); /* where random_lamp is refused */
        random_lamp(&lamps[i]);
    }
    add((uint32_t)glint_shade_lights(&shader, lamps, lamp_count, &source, W, H, &surface, &box));
    add_box(&box);
    add_bytes(out, LINE * H);

    struct glint_span span = {0, 0, 0, 0, 0, 0};
    add((uint32_t)glint_span_init(&span, &shader.light, &normals[0], &normals[1], W));
    surface.pixels = out + LINE;
    add((uint32_t)glint_shade_span(&shader, &span, &surface, &box));
    add(span.t_q30);
    add(span.dt_q30);
    add(span.ddt_q30);
    add((uint32_t)span.dnl_q30);
    add_box(&box);
    add_bytes(out, LINE * H);
}

enum {
    KINDS_FROM = SWEEP_COLOUR ? GLINT_TABLES_COLOUR : GLINT_TABLES_SMALL,
    TABLES_BYTES = SWEEP_COLOUR ? GLINT_TABLES_COLOUR_BYTES : GLINT_TABLES_SMALL_BYTES
};

#if SWEEP_COLOUR
enum { WIDE = 319 };
static uint16_t wide_out[WIDE + 1];

static void add_wide_out(uint32_t err)
{
    add(err);
    add_bytes((const uint8_t *)wide_out, sizeof wide_out);
}

/* In and about the lobe; t at t_max or 0 to the unit, or nl at 0, at pixel k; steps larger than the loops take for small;
 * any at all. */
static void tricky_span(struct glint_span *span, uint32_t t_max, uint8_t kind)
{
    const uint32_t k = random_bits() % (span->w + 1u), fine = 1 + random_bits() % 16;
    const uint32_t step = UINT32_C(1) << (kind == 1 ? 23 + fine % 6 : 25 - fine);
    const uint32_t ddt = UINT32_C(1) << (kind == 1 ? 14 + 3 * fine % 12 : 20 - fine);
    span->dt_q30 = kind ? (uint32_t)random_within((int32_t)step) : random_bits();
    span->ddt_q30 = kind ? random_bits() % ddt : random_bits();
    span->dnl_q30 = kind ? random_within((int32_t)step) : (int32_t)random_bits();
    span->nl_q30 = (int32_t)(random_bits() >> (kind == 1 ? 0 : 2));
    span->t_q30 = kind == 1 ? random_bits() >> 1 : random_bits() % (t_max + 100000);
    if (kind >= 5) { /* the lowest t at pixel k */
        span->dt_q30 = 0 - k * span->ddt_q30;
        span->dnl_q30 >>= 6;
    }
    const uint32_t to_k = k * span->dt_q30 + k * (k - 1) / 2 * span->ddt_q30, one = (uint32_t)random_within(1);
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
    const struct glint_surface line = {wide_out, sizeof wide_out, 0, 0};
    for (uint16_t i = 0; i < 512; i++) {
        struct glint_span span = {0, 0, 0, 0, 0, widths[i / 32u]};
        tricky_span(&span, tables->t_max_q30, i % 8u);
        add_wide_out((uint32_t)glint_tables_span(tables, &span, &line));
    }
    for (uint8_t i = 0; i < 32; i++) {
        const enum glint_normals held = i & 1 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT10;
        for (uint16_t x = 0; x < WIDE; x++) {
            struct glint_vec normal;
            random_normal(&normal, from);
            words[x] = x % 11u == 10 ? random_bits() : glint_normals_pack(held, &normal);
            if (x % 17u == 16) /* without surface */
                words[x] = random_bits() % 9 << (i & 1 ? 0 : 12);
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
        offsets[i] = (uint16_t)(random_bits() & 0x3ffe);
    for (uint8_t i = 0; i < 16; i++)
        add_wide_out((uint32_t)glint_palette_rect(tables->colour.colours, offsets, 0, widths[i], 1, &line));
}
#endif

#if SWEEP_COLOUR
/* Every kind of normals over a map, in rows longer than the loops unroll, and a span; where the map is the output, too. */
static void add_albedo(unsigned model, unsigned flags)
{
    enum { WIDE = 75 };
    static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4], words[WIDE];
    static struct glint_vec normals[WIDE];
    static uint16_t map[WIDE], pixels[WIDE + 1];
    struct glint_shader shader;
    random_shader(&shader, model);
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
    const enum glint_err err = glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &shader, memory, sizeof memory);
    add((uint32_t)err);
    if (err)
        return;
    add((uint32_t)glint_tables_light(&light, &tables, &shader.light));
    for (unsigned held = GLINT_NORMALS_INT16; held <= GLINT_NORMALS_INT8; held++) {
        struct glint_vec near = {0, 0, 0};
        for (uint8_t i = 0; i < WIDE; i++) {
            if (random_bits() % 4 == 0) /* runs of the like: in the lobe, out of it, dark */
                random_normal(&near, &shader.light);
            normals[i] = near;
            if (random_bits() % 8 == 0)
                normals[i].z = (int16_t)-near.z;
            words[i] = random_bits() % 16 ? glint_normals_pack((enum glint_normals)held, &near) : random_bits() % 5;
            map[i] = (uint16_t)random_bits();
            pixels[i] = i;
        }
        const bool packed = held != GLINT_NORMALS_INT16, in_place = flags & 4;
        const struct glint_surface line = {in_place ? (uint8_t *)map : (uint8_t *)pixels + (held & flags & 1), 0, 0, 0};
        add((uint32_t)glint_tables_albedo_rect(&tables, &light, (enum glint_normals)held,
                                               packed ? (const void *)words : (const void *)normals, 0, map, 0,
                                               (uint16_t)(WIDE - flags % 8), 1, &line));
        add_bytes(in_place ? (const uint8_t *)map : (const uint8_t *)pixels, sizeof map);
    }
    struct glint_span span = {0, 0, 0, 0, 0, 0};
    add((uint32_t)glint_span_init(&span, &shader.light, &normals[0], &normals[1], WIDE));
    const struct glint_surface line = {pixels, 0, 0, 0};
    add((uint32_t)glint_tables_albedo_span(&tables, &span, map, &line));
    add_bytes((const uint8_t *)pixels, sizeof map);
}
#endif

static void add_tables(unsigned kind, unsigned model, unsigned format, unsigned flags)
{
    static uint32_t memory[TABLES_BYTES / 4], words[W * H];
    static struct glint_vec normals[W * H];
    static uint8_t out[LINE * H];
    struct glint_shader shader;
    random_shader(&shader, model);
    shader.format = (uint8_t)format;
    shader.space = kind == GLINT_TABLES_COLOUR ? flags >> 1 & 1 : 0;
    shader.dither = kind == GLINT_TABLES_SMALL && (flags & 1);
    shader.clamp_peak = flags & 1;
    struct glint_tables tables;
    struct glint_tables_light light;
    const enum glint_err err = glint_tables_fill(&tables, (enum glint_tables_kind)kind, &shader, memory, sizeof memory);
    add((uint32_t)err);
    if (err)
        return;
    add((uint32_t)glint_tables_light(&light, &tables, &shader.light));
    for (uint8_t i = 0; i < W * H; i++)
        random_normal(&normals[i], &shader.light);
    for (unsigned held = GLINT_NORMALS_INT16; held <= GLINT_NORMALS_INT8; held++) {
        for (uint8_t i = 0; i < W * H; i++)
            words[i] = i % 7 == 6 ? random_bits() : glint_normals_pack((enum glint_normals)held, &normals[i]);
        for (uint8_t i = 0; i < LINE * H; i++)
            out[i] = i;
        const struct glint_surface surface = {out + (held & 1), LINE, 1, 2};
        const bool packed = held != GLINT_NORMALS_INT16;
        add((uint32_t)glint_tables_rect(
            &tables, &light, (enum glint_normals)held, packed ? (const void *)words : (const void *)normals,
            (ptrdiff_t)(W * (packed ? sizeof *words : sizeof *normals)), W - 1, H, &surface));
        add_bytes(out, LINE * H);
    }
    struct glint_span span = {0, 0, 0, 0, 0, 0};
    add((uint32_t)glint_span_init(&span, &shader.light, &normals[0], &normals[1], W));
    const struct glint_surface line = {out, LINE, 0, 0};
    add((uint32_t)glint_tables_span(&tables, &span, &line));
    add_bytes(out, LINE);
#if SWEEP_COLOUR
    if (kind == GLINT_TABLES_COLOUR)
        add_wide(&tables, &light, &shader.light);
#endif
}

static void add_scenes(const struct sweep_size *size)
{
    unsigned flags = 0;
    for (unsigned model = 0; model < MODEL_COUNT; model++)
        for (unsigned format = GLINT_RGB565; format <= GLINT_MONO + 1; format++) /* one more than there are */
            for (unsigned space = GLINT_GAMMA; space <= GLINT_LINEAR; space++)
                for (uint8_t scene = 0; scene < size->scenes; scene++)
                    add_scene(model, format, space, flags++);
}

static void add_all_tables(const struct sweep_size *size)
{
    unsigned flags = 0;
    for (unsigned kind = KINDS_FROM; kind <= GLINT_TABLES_SMALL; kind++)
        for (unsigned model = 0; model < MODEL_COUNT; model++)
            for (unsigned format = GLINT_RGB565; format <= (kind ? GLINT_MONO : GLINT_RGB565_SWAPPED); format++)
                for (uint8_t scene = 0; scene < size->scenes; scene++)
                    add_tables(kind, model, format, flags++);
#if SWEEP_COLOUR
    for (unsigned model = 0; model < MODEL_COUNT; model++)
        for (uint8_t scene = 0; scene < 2 * size->scenes; scene++)
            add_albedo(model, flags++);
#endif
}

uint64_t sweep(const struct sweep_size *size)
{
    hash = UINT64_C(0xcbf29ce484222325);
    state = 1;
    for (uint16_t i = 0; i < SHININESS_COUNT; i += size->n_stride) {
        add_lobes(size, shininess[i]);
        add_dispatch(size, shininess[i]);
    }
    add_vectors(size);
    add_srgb(size);
    add_scenes(size);
    add_all_tables(size);
    return hash;
}

void sweep_print(uint64_t value, void (*put)(char))
{
    for (uint8_t digit = 0; digit < 16; digit++)
        put("0123456789abcdef"[value >> (60 - 4 * digit) & 15]);
    put('\n');
}
