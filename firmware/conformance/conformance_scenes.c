/* SPDX-License-Identifier: MIT
 * Geometry, rectangles and spans. */
#include "conformance_scenes.h"

#include "conformance_random.h"

#if !CONFORMANCE_MODELS_ONLY /* a part that is too small for these is refused at compile time */

/* ---- geometry and colour ---- */

void conform_vectors(const struct conformance_size *size)
{
    for (uint16_t k = 0; k < size->random_vectors; k++) {
        const int32_t limit = k & 1 ? INT32_C(0x3fffffff) : INT32_C(40);
        int32_t a[3], b[3];
        conform_random_vector(a, limit);
        conform_random_vector(b, limit);
        struct glint_vec v = {0, 0, 0};
        struct glint_light light = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        conform_add((uint32_t)glint_vec_normalize(&v, a));
        conform_add((uint32_t)glint_light_init(&light, a, b));
        conform_add((uint16_t)v.x | (uint32_t)(uint16_t)v.y << 16);
        conform_add((uint16_t)v.z | (uint32_t)(uint16_t)light.l.x << 16);
        conform_add((uint16_t)light.v.y | (uint32_t)(uint16_t)light.h.x << 16);
        conform_add((uint16_t)light.h.y | (uint32_t)(uint16_t)light.h.z << 16);
    }
}

/* ---- pixels ---- */

void conform_random_shader(struct glint_shader *shader, unsigned model)
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    int32_t to_light[3];
    conform_random_vector(to_light, 100);
    const uint32_t n = 1 + conform_random_bits() % 100;
    glint_lobe_init(&shader->lobe, (enum glint_model)model, n, (unsigned)(conform_random_bits() % 17));
    if (glint_light_init(&shader->light, to_light, to_viewer) != GLINT_OK)
        conform_add(1);
    for (uint8_t k = 0; k < 3; k++) {
        shader->material.ambient_q16[k] = conform_random_bits() % 20000;
        shader->material.diffuse_q16[k] = conform_random_bits() % 70000;
        shader->material.specular_q16[k] = conform_random_bits() % 70000;
        shader->material.albedo[k] = (uint8_t)conform_random_bits();
    }
}

/* About the half vector, so that the highlight is met. */
void conform_random_normal(struct glint_vec *normal, const struct glint_light *light)
{
    int32_t v[3];
    conform_random_vector(v, 9000);
    v[0] += light->h.x;
    v[1] += light->h.y;
    v[2] = light->h.z;
    if (glint_vec_normalize(normal, v) != GLINT_OK)
        conform_add(2);
}

static void add_box(const struct glint_box *box)
{
    conform_add(box->x | (uint32_t)box->y << 16);
    conform_add(box->w | (uint32_t)box->h << 16);
}

/* Some calls are refused. */
void conform_random_lamp(struct glint_lamp *lamp)
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    static const int32_t above[3] = {100, 20, 150};
    int32_t a[3], b[3];
    (void)glint_lamp_point(lamp, above, 1000);
    conform_random_vector(a, 400);
    conform_random_vector(b, 200);
    const int32_t inner = conform_random_within(INT32_C(0x40000000)),
                  outer = conform_random_within(INT32_C(0x40000000));
    const uint32_t range = conform_random_bits() % 2000;
    a[2] = a[2] < 0 ? -a[2] : a[2];
    switch (conform_random_bits() % 4) {
    case GLINT_DIRECTIONAL:
        conform_add((uint32_t)glint_lamp_directional(lamp, a, to_viewer));
        break;
    case GLINT_POINT:
        conform_add((uint32_t)glint_lamp_point(lamp, a, range));
        break;
    default:
        conform_add((uint32_t)glint_lamp_spot(lamp, a, b, range, inner, outer));
    }
    for (uint8_t k = 0; k < 3; k++) {
        lamp->color_q16[k] = conform_random_bits() % 140000;
        conform_add((uint32_t)lamp->axis_q30[k]);
    }
}

static void add_scene(unsigned model, unsigned format, unsigned space, unsigned flags)
{
    static struct glint_vec normals[W * H];
    static uint8_t albedo[3 * W * H], byte_map[W * H], out[LINE * H];
    struct glint_shader shader;
    conform_random_shader(&shader, model);
    shader.format = (uint8_t)format;
    shader.space = (uint8_t)space;
    shader.dither = flags & 1;
    shader.clamp_peak = flags >> 1 & 1;
    for (uint8_t i = 0; i < W * H; i++) {
        conform_random_normal(&normals[i], &shader.light);
        byte_map[i] = (uint8_t)conform_random_bits();
        byte_map[i] = byte_map[i] & 1 ? 255 : byte_map[i] & 8 ? 0 : byte_map[i];
    }
    for (uint8_t i = 0; i < 3 * W * H; i++)
        albedo[i] = (uint8_t)conform_random_bits();
    for (uint8_t i = 0; i < LINE * H; i++)
        out[i] = i;

    struct glint_source source = {normals, W * sizeof *normals, 0, 3 * W, 0, W, 0, W};
    source.albedo = flags & 4 ? albedo : 0;
    source.gloss = flags & 8 ? byte_map : 0;
    source.mask = flags & 1 ? byte_map : 0;
    const uint16_t phase = conform_random_bits() & 15;
    struct glint_surface surface = {out, LINE, phase & 3, phase >> 2};
    struct glint_box box = {0, 0, 0, 0};
    conform_add((uint32_t)glint_shade_rect(&shader, &source, W, H, &surface, &box));
    add_box(&box);
    conform_add_bytes(out, LINE * H);

    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    const unsigned lamp_count = flags % (GLINT_LAMPS_MAX + 1);
    for (unsigned i = 0; i < lamp_count; i++)
        conform_random_lamp(&lamps[i]);
    conform_add((uint32_t)glint_shade_lights(&shader, lamps, lamp_count, &source, W, H, &surface, &box));
    add_box(&box);
    conform_add_bytes(out, LINE * H);

    struct glint_span span = {0, 0, 0, 0, 0, 0};
    conform_add((uint32_t)glint_span_init(&span, &shader.light, &normals[0], &normals[1], W));
    surface.pixels = out + LINE;
    conform_add((uint32_t)glint_shade_span(&shader, &span, &surface, &box));
    surface.pixels = out;
    conform_add((uint32_t)glint_shade_span_c16(&shader, &span, &surface, &box));
    conform_add(span.t_q30);
    conform_add(span.dt_q30);
    conform_add(span.ddt_q30);
    conform_add((uint32_t)span.dnl_q30);
    add_box(&box);
    conform_add_bytes(out, LINE * H);
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
