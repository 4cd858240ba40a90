/* SPDX-License-Identifier: MIT */
#include "sweep_parts.h"

const struct sweep_size sweep_whole = {1, 7, 3000, 1, 40, 50000};
const struct sweep_size sweep_small = {4, 8191, 6, 8, 1, 20};

static uint64_t hash;

void sweep_add_bytes(const uint8_t *bytes, uint16_t count)
{
    while (count--) {
        hash ^= *bytes++;
        hash *= UINT64_C(0x100000001b3);
    }
}

void sweep_add(uint32_t value) /* the low byte first on every machine */
{
    const uint8_t bytes[4] = {(uint8_t)value, (uint8_t)(value >> 8), (uint8_t)(value >> 16), (uint8_t)(value >> 24)};
    sweep_add_bytes(bytes, 4);
}

static uint32_t state;

uint32_t sweep_random_bits(void)
{
    state = state * UINT32_C(1664525) + UINT32_C(1013904223);
    return state ^ state >> 16;
}

int32_t sweep_random_within(int32_t limit) /* -limit..limit */
{
    return (int32_t)(sweep_random_bits() % (2 * (uint32_t)limit + 1)) - limit;
}

/* One call a statement everywhere: within one, the compiler chooses the order. */
static void random_vector(int32_t v[3], int32_t limit)
{
    for (uint8_t i = 0; i < 3; i++)
        v[i] = sweep_random_within(limit);
}

/* ---- lobes ---- */

static const uint16_t shininess[] = {60, 0, 1, 2, 1000, 3, 4, 5, 17, 7, 10, 35, 200, 100, 255, 513, 704, 999, 5000};
enum { SHININESS_COUNT = sizeof shininess / sizeof *shininess };

/* No table of pointers: the stack check follows calls by name. */
#define ADD_LOBE(model)                                                                                                \
    for (int32_t c = -1000; c <= GLINT_C_ONE + 1000; c += size->c_step)                                                \
        sweep_add(glint_##model(n, c));                                                                                \
    for (uint16_t k = 0; k < size->t_count; k++) /* ever nearer to the peak, where lobes are */                        \
        sweep_add(glint_##model##_t(n, sweep_random_bits() >> (1 + k % 16)));                                          \
    for (unsigned q = 0; q <= GLINT_Q_MAX + 1; q += size->q_step) {                                                    \
        sweep_add(glint_##model##_cutoff(n, q));                                                                       \
        sweep_add(glint_##model##_cutoff_t(n, q));                                                                     \
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
        sweep_add(lobe.c_min_q16);
        sweep_add(lobe.t_max_q30);
        for (uint16_t k = 0; k < size->t_count; k++) {
            const uint32_t t = sweep_random_bits() >> (1 + k % 16);
            const int32_t c = GLINT_C_ONE - (int32_t)(t >> 14);
            sweep_add(glint_eval((enum glint_model)model, n, c));
            sweep_add(glint_eval_t((enum glint_model)model, n, t));
            sweep_add(glint_lobe_eval(&lobe, c));
            sweep_add(glint_lobe_eval_t(&lobe, t));
        }
        sweep_add(glint_cutoff((enum glint_model)model, n, n % 18u));
        sweep_add(glint_cutoff_t((enum glint_model)model, n, n % 18u));
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
        sweep_add((uint32_t)glint_vec_normalize(&v, a));
        sweep_add((uint32_t)glint_light_init(&light, a, b));
        sweep_add((uint16_t)v.x | (uint32_t)(uint16_t)v.y << 16);
        sweep_add((uint16_t)v.z | (uint32_t)(uint16_t)light.l.x << 16);
        sweep_add((uint16_t)light.v.y | (uint32_t)(uint16_t)light.h.x << 16);
        sweep_add((uint16_t)light.h.y | (uint32_t)(uint16_t)light.h.z << 16);
    }
}

static void add_srgb(const struct sweep_size *size)
{
    for (uint16_t i = 0; i < 256; i++)
        sweep_add(glint_srgb_decode((uint8_t)i));
    for (uint32_t i = 0; i < 65536; i += size->c_step)
        sweep_add(glint_srgb_encode((uint16_t)i));
}

/* ---- pixels ---- */

void sweep_random_shader(struct glint_shader *shader, unsigned model)
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    int32_t to_light[3];
    random_vector(to_light, 100);
    const uint32_t n = 1 + sweep_random_bits() % 100;
    glint_lobe_init(&shader->lobe, (enum glint_model)model, n, (unsigned)(sweep_random_bits() % 17));
    if (glint_light_init(&shader->light, to_light, to_viewer) != GLINT_OK)
        sweep_add(1);
    for (uint8_t k = 0; k < 3; k++) {
        shader->material.ambient_q16[k] = sweep_random_bits() % 20000;
        shader->material.diffuse_q16[k] = sweep_random_bits() % 70000;
        shader->material.specular_q16[k] = sweep_random_bits() % 70000;
        shader->material.albedo[k] = (uint8_t)sweep_random_bits();
    }
}

/* About the half vector, so that the highlight is met. */
void sweep_random_normal(struct glint_vec *normal, const struct glint_light *light)
{
    int32_t v[3];
    random_vector(v, 9000);
    v[0] += light->h.x;
    v[1] += light->h.y;
    v[2] = light->h.z;
    if (glint_vec_normalize(normal, v) != GLINT_OK)
        sweep_add(2);
}

static void add_box(const struct glint_box *box)
{
    sweep_add(box->x | (uint32_t)box->y << 16);
    sweep_add(box->w | (uint32_t)box->h << 16);
}

/* A lamp of any kind near the rectangle; some calls are refused. */
static void random_lamp(struct glint_lamp *lamp)
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    int32_t a[3], b[3];
    random_vector(a, 400);
    random_vector(b, 200);
    const int32_t inner = sweep_random_within(INT32_C(0x40000000)), outer = sweep_random_within(INT32_C(0x40000000));
    const uint32_t range = sweep_random_bits() % 2000;
    a[2] = a[2] < 0 ? -a[2] : a[2];
    switch (sweep_random_bits() % 4) {
    case GLINT_DIRECTIONAL:
        sweep_add((uint32_t)glint_lamp_directional(lamp, a, to_viewer));
        break;
    case GLINT_POINT:
        sweep_add((uint32_t)glint_lamp_point(lamp, a, range));
        break;
    default:
        sweep_add((uint32_t)glint_lamp_spot(lamp, a, b, range, inner, outer));
    }
    for (uint8_t k = 0; k < 3; k++) {
        lamp->color_q16[k] = sweep_random_bits() % 140000;
        sweep_add((uint32_t)lamp->axis_q30[k]);
    }
}

static void add_scene(unsigned model, unsigned format, unsigned space, unsigned flags)
{
    static struct glint_vec normals[W * H];
    static uint8_t albedo[3 * W * H], byte_map[W * H], out[LINE * H];
    struct glint_shader shader;
    sweep_random_shader(&shader, model);
    shader.format = (uint8_t)format;
    shader.space = (uint8_t)space;
    shader.dither = flags & 1;
    shader.clamp_peak = flags >> 1 & 1;
    for (uint8_t i = 0; i < W * H; i++) {
        sweep_random_normal(&normals[i], &shader.light);
        byte_map[i] = (uint8_t)sweep_random_bits();
        byte_map[i] = byte_map[i] & 1 ? 255 : byte_map[i] & 8 ? 0 : byte_map[i];
    }
    for (uint8_t i = 0; i < 3 * W * H; i++)
        albedo[i] = (uint8_t)sweep_random_bits();
    for (uint8_t i = 0; i < LINE * H; i++)
        out[i] = i;

    struct glint_source source = {normals, W * sizeof *normals, 0, 3 * W, 0, W, 0, W};
    source.albedo = flags & 4 ? albedo : 0;
    source.gloss = flags & 8 ? byte_map : 0;
    source.mask = flags & 1 ? byte_map : 0;
    const uint16_t phase = sweep_random_bits() & 15;
    struct glint_surface surface = {out, LINE, phase & 3, phase >> 2};
    struct glint_box box = {0, 0, 0, 0};
    sweep_add((uint32_t)glint_shade_rect(&shader, &source, W, H, &surface, &box));
    add_box(&box);
    sweep_add_bytes(out, LINE * H);

    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    const unsigned lamp_count = flags % (GLINT_LAMPS_MAX + 1);
    for (unsigned i = 0; i < lamp_count; i++) {
        static const int32_t above[3] = {100, 20, 150};
        (void)glint_lamp_point(&lamps[i], above, 1000); /* where random_lamp is refused */
        random_lamp(&lamps[i]);
    }
    sweep_add((uint32_t)glint_shade_lights(&shader, lamps, lamp_count, &source, W, H, &surface, &box));
    add_box(&box);
    sweep_add_bytes(out, LINE * H);

    struct glint_span span = {0, 0, 0, 0, 0, 0};
    sweep_add((uint32_t)glint_span_init(&span, &shader.light, &normals[0], &normals[1], W));
    surface.pixels = out + LINE;
    sweep_add((uint32_t)glint_shade_span(&shader, &span, &surface, &box));
    sweep_add(span.t_q30);
    sweep_add(span.dt_q30);
    sweep_add(span.ddt_q30);
    sweep_add((uint32_t)span.dnl_q30);
    add_box(&box);
    sweep_add_bytes(out, LINE * H);
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
    sweep_add_tables(size);
    return hash;
}

void sweep_print(uint64_t value, void (*put)(char))
{
    for (uint8_t digit = 0; digit < 16; digit++)
        put("0123456789abcdef"[value >> (60 - 4 * digit) & 15]);
    put('\n');
}
