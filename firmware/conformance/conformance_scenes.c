/* SPDX-License-Identifier: MIT
 * Geometry, and exact paints over rectangles and spans. */
#include "conformance_scenes.h"

#include "conformance_random.h"

#if !CONFORMANCE_MODELS_ONLY /* a part that is too small for these is refused at compile time */

const int32_t conform_to_viewer[3] = {0, 0, 1};
struct glint_paint conform_paint;
struct glint_light conform_lights[GLINT_LIGHTS_MAX];
uint32_t conform_words[CONFORM_WORDS], conform_pixels[CONFORM_PIXELS];

/* ---- geometry and colour ---- */

/* A paint keeps l, v and h of the one light that it has. */
void conform_vectors(const struct conformance_size *size)
{
    const struct glint_material material = {.n = 1};
    const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    static const struct glint_vec none = {0, 0, 0};
    struct glint_paint *const paint = &conform_paint;
    conform_add((uint32_t)glint_paint_exact(paint, &material, &output));
    for (uint16_t k = 0; k < size->random_vectors; k++) {
        const int32_t limit = k & 1 ? INT32_C(0x3fffffff) : INT32_C(40);
        int32_t a[3], b[3];
        conform_random_vector(a, limit);
        conform_random_vector(b, limit);
        struct glint_vec v = none;
        struct glint_light light;
        paint->l = paint->v = paint->h = none;
        conform_add((uint32_t)glint_vec_normalize(&v, a));
        enum glint_err err = glint_light_directional(&light, a);
        if (err == GLINT_OK)
            err = glint_paint_light(paint, &light, 1, b);
        conform_add((uint32_t)err);
        conform_add((uint16_t)v.x | (uint32_t)(uint16_t)v.y << 16);
        conform_add((uint16_t)v.z | (uint32_t)(uint16_t)paint->l.x << 16);
        conform_add((uint16_t)paint->v.y | (uint32_t)(uint16_t)paint->h.x << 16);
        conform_add((uint16_t)paint->h.y | (uint32_t)(uint16_t)paint->h.z << 16);
    }
}

/* ---- materials, lights, normals ---- */

void conform_random_material(struct glint_material *material, struct glint_light *light, unsigned model)
{
    static const int32_t in_front[3] = {0, 0, 1};
    int32_t to_light[3];
    conform_random_vector(to_light, 100);
    (void)glint_light_directional(light, in_front);
    if (glint_light_directional(light, to_light) != GLINT_OK)
        conform_add(1);
    material->model = (uint8_t)model;
    material->n = (uint16_t)(1 + conform_random_bits() % 100);
    material->q = (uint8_t)(conform_random_bits() % 17); /* 0: the format's */
    material->n_across = 0;
    material->clamp_peak = false;
    for (uint8_t k = 0; k < 3; k++) {
        material->ambient_q16[k] = conform_random_bits() % 20000;
        material->diffuse_q16[k] = conform_random_bits() % 70000;
        material->specular_q16[k] = conform_random_bits() % 70000;
        material->albedo[k] = (uint8_t)conform_random_bits();
    }
}

void conform_light(struct glint_paint *paint, const struct glint_light *light)
{
    if (glint_paint_light(paint, light, 1, conform_to_viewer) != GLINT_OK)
        conform_add(1);
}

/* Some calls are refused. */
void conform_random_light(struct glint_light *light)
{
    static const int32_t above[3] = {100, 20, 150};
    int32_t a[3], b[3];
    (void)glint_light_point(light, above, 1000);
    conform_random_vector(a, 400);
    conform_random_vector(b, 200);
    const int32_t inner = conform_random_within(INT32_C(0x40000000)),
                  outer = conform_random_within(INT32_C(0x40000000));
    const uint32_t range = conform_random_bits() % 2000;
    a[2] = a[2] < 0 ? -a[2] : a[2];
    switch (conform_random_bits() % 4) {
    case 0:
        conform_add((uint32_t)glint_light_directional(light, a));
        break;
    case 1:
        conform_add((uint32_t)glint_light_point(light, a, range));
        break;
    default:
        conform_add((uint32_t)glint_light_spot(light, a, b, range, inner, outer));
    }
    for (uint8_t k = 0; k < 3; k++)
        light->color_q16[k] = conform_random_bits() % 140000;
}

void conform_random_normal(struct glint_vec *normal, const struct glint_vec *h)
{
    int32_t v[3];
    conform_random_vector(v, 9000);
    v[0] += h->x;
    v[1] += h->y;
    v[2] = h->z;
    if (glint_vec_normalize(normal, v) != GLINT_OK)
        conform_add(2);
}

void conform_add_box(const struct glint_box *box)
{
    conform_add(box->x | (uint32_t)box->y << 16);
    conform_add(box->w | (uint32_t)box->h << 16);
}

/* ---- exact paints ---- */

static uint8_t *const out = (uint8_t *)conform_pixels;

static void add_rect(const struct glint_paint *paint, const struct glint_maps *maps,
                     const struct glint_surface *surface)
{
    struct glint_box box = {0, 0, 0, 0};
    conform_add((uint32_t)glint_draw_rect(paint, maps, W, H, surface, &box));
    conform_add_box(&box);
    conform_add_bytes(out, LINE * H);
}

/* One without maps, one with. */
static void add_spans(const struct glint_paint *paint, const struct glint_vec *normals, const struct glint_maps *maps,
                      struct glint_surface *surface)
{
    struct glint_span span = {0, 0, 0, 0, 0, 0, {{0, 0}, {0, 0}}};
    struct glint_box box = {0, 0, 0, 0};
    conform_add((uint32_t)glint_span_init(&span, paint, &normals[0], &normals[1], W));
    surface->pixels = out + LINE;
    conform_add((uint32_t)glint_draw_span(paint, &span, 0, surface, &box));
    conform_add_box(&box);
    surface->pixels = out;
    conform_add((uint32_t)glint_draw_span(paint, &span, maps, surface, &box));
    conform_add(span.t_q30);
    conform_add(span.dt_q30);
    conform_add(span.ddt_q30);
    conform_add((uint32_t)span.dnl_q30);
    conform_add_box(&box);
    conform_add_bytes(out, LINE * H);
}

/* Grain of each kind and by a map, and a map of shininess, turn by turn; of models without grain all is refused. */
static void add_grain(struct glint_material *material, const struct glint_light *light,
                      const struct glint_output *output, struct glint_maps *maps, const uint8_t *bytes,
                      const struct glint_surface *surface, unsigned turn)
{
    material->n_across = (uint16_t)(turn % 5 == 4 ? 0 : 1 + conform_random_bits() % 100);
    conform_add((uint32_t)glint_paint_exact(&conform_paint, material, output));
    conform_light(&conform_paint, light);
    maps->grain_kind = (uint8_t)(turn % 5 < 3 ? turn % 5 : 0);
    maps->grain = turn % 5 == 3 ? bytes : 0;
    maps->shininess = turn % 5 == 4 ? bytes : 0;
    maps->grain_stride = maps->shininess_stride = W;
    for (uint8_t k = 0; k < 2; k++)
        maps->grain_at[k] = conform_random_within(200);
    add_rect(&conform_paint, maps, surface);
    conform_add((uint32_t)glint_paint_light(&conform_paint, conform_lights, turn % 3, conform_to_viewer));
    add_rect(&conform_paint, maps, surface);
}

/* Where there is no such format the paint is of zeros, and all calls are refused. */
static void add_scene(unsigned model, unsigned format, unsigned space, unsigned flags)
{
    struct glint_paint *const paint = &conform_paint;
    static struct glint_vec normals[W * H];
    uint32_t *const words = conform_words;
    static uint8_t albedo[3 * W * H], byte_map[W * H];
    struct glint_material material;
    struct glint_light light;
    const struct glint_output output = {(uint8_t)format, (uint8_t)space, flags & 1};
    conform_random_material(&material, &light, model);
    material.clamp_peak = flags >> 1 & 1;
    for (uint16_t i = 0; i < sizeof *paint; i++)
        ((uint8_t *)paint)[i] = 0;
    conform_add((uint32_t)glint_paint_exact(paint, &material, &output));
    conform_light(paint, &light);
    for (uint8_t i = 0; i < W * H; i++) {
        conform_random_normal(&normals[i], &paint->h);
        words[i] = i % 7 == 6 ? 0 : glint_normals_pack(GLINT_NORMALS_INT8, &normals[i]);
        byte_map[i] = (uint8_t)conform_random_bits();
        byte_map[i] = byte_map[i] & 1 ? 255 : byte_map[i] & 8 ? 0 : byte_map[i];
    }
    for (uint8_t i = 0; i < 3 * W * H; i++)
        albedo[i] = (uint8_t)conform_random_bits();
    for (uint8_t i = 0; i < LINE * H; i++)
        out[i] = i;

    struct glint_maps maps = {.normals = normals,
                              .normals_stride = W * sizeof *normals,
                              .albedo_stride = 3 * W,
                              .gloss_stride = W,
                              .coverage_stride = W,
                              .albedo_format = GLINT_RGB888};
    maps.albedo = flags & 4 ? albedo : 0;
    maps.gloss = flags & 8 ? byte_map : 0;
    maps.coverage = flags & 1 ? byte_map : 0;
    const uint16_t phase = conform_random_bits() & 15;
    struct glint_surface surface = {out, LINE, phase & 3, phase >> 2};
    add_rect(paint, &maps, &surface);

    const unsigned count = flags % (GLINT_LIGHTS_MAX + 1);
    for (unsigned i = 0; i < count; i++)
        conform_random_light(&conform_lights[i]);
    conform_add((uint32_t)glint_paint_light(paint, conform_lights, count, conform_to_viewer));
    add_rect(paint, &maps, &surface);

    conform_light(paint, &light);
    add_spans(paint, normals, &maps, &surface);
    maps.normals = words;
    maps.normals_stride = W * sizeof *words;
    maps.normals_format = GLINT_NORMALS_INT8;
    add_rect(paint, &maps, &surface);
    add_grain(&material, &light, &output, &maps, byte_map, &surface, flags);
}

void conform_scenes(unsigned format, const struct conformance_size *size)
{
    unsigned flags = format;
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        for (unsigned space = GLINT_GAMMA; space <= GLINT_LINEAR; space++)
            for (uint8_t scene = 0; scene < size->scenes; scene++)
                add_scene(model, format, space, flags++);
}

#endif
