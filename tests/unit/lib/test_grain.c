/* SPDX-License-Identifier: MIT
 * Grain and maps of shininess. The bits are the exact tier's affair: here is how near pictures come to double precision, what must not matter,
 * and what is refused. */
#include "grained.h"
#include "glint_grain.h"
#include "meshes.h"

/* ---- Beside double precision ---- */

enum { SIDE = 48 };
struct vec {
    double x, y, z;
};

static double dotted(struct vec a, struct vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static double lobe(enum glint_model model, double m, double c)
{
    const double r = (4 * (1 + c) - m) / (4 * (1 + c) + m);
    switch (model) {
    case GLINT_MSH:
        return c <= 0 ? 0 : 2 * c / (1.25 * (m + 1.25 * c) * (m + 1.25 * c));
    case GLINT_SCHLICK:
        return c / (m + c);
    case GLINT_CAYLEY:
        return r > 0 ? r * r * r * r : 0;
    case GLINT_LYON:
        return m < 4 ? (1 - m / 4) * (1 - m / 4) * (1 - m / 4) * (1 - m / 4) : 0;
    default:
        return 1 / ((1 + m) * (1 + m));
    }
}

static struct vec unit_vec(double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    return (struct vec){x / length, y / length, z / length};
}

static struct vec real_of(struct glint_vec v)
{
    return unit_vec(v.x, v.y, v.z);
}

/* A disc with a slight dome, a sphere, a plate with bevels and noise. */
static bool surface_at(int scene, int x, int y, struct glint_vec *n)
{
    const double u = (x + .5) / SIDE * 2 - 1, v = 1 - (y + .5) / SIDE * 2, r = hypot(u, v);
    double at[3] = {u * .15, v * .15, 1};
    if (scene == 1) {
        at[0] = u / .97, at[1] = v / .97;
        at[2] = sqrt(fmax(0, 1 - at[0] * at[0] - at[1] * at[1]));
    } else if (scene == 2) {
        at[0] = fabs(u) > .8 ? copysign(.8, u) : .03 * sin(90 * v), at[1] = fabs(v) > .7 ? copysign(.8, v) : 0;
    }
    const int32_t wide[3] = {(int32_t)(at[0] * 1e8), (int32_t)(at[1] * 1e8), (int32_t)(at[2] * 1e8)};
    return (scene == 2 || r < .97) && glint_vec_normalize(n, wide) == GLINT_OK;
}

/* (H.T)^2 / 2, as the header's formula has it; t / 2 where U is along N. */
static double half_square(struct vec h, struct vec n, double ux, double uy, double t)
{
    const struct vec u = {ux, uy, 0};
    const double c = dotted(n, h), nu = dotted(n, u), rest = dotted(u, u) - nu * nu, ht = dotted(h, u) - c * nu;
    return rest < 1e-9 ? t / 2 : ht * ht / rest / 2;
}

static void direction_at(const struct glint_maps *maps, int x, int y, double *ux, double *uy)
{
    const double right = 16. * x + 8 - maps->grain_at[0], up = maps->grain_at[1] - 16. * y - 8;
    const double angle = maps->grain ? maps->grain[y * SIDE + x] * M_PI / 256 : 0;
    *ux = maps->grain                              ? cos(angle)
          : maps->grain_kind == GLINT_GRAIN_SPUN   ? -up
          : maps->grain_kind == GLINT_GRAIN_SUNRAY ? right
                                                   : maps->grain_at[0];
    *uy = maps->grain                              ? sin(angle)
          : maps->grain_kind == GLINT_GRAIN_SPUN   ? right
          : maps->grain_kind == GLINT_GRAIN_SUNRAY ? up
                                                   : maps->grain_at[1];
    if (*ux == 0 && *uy == 0)
        *ux = maps->grain_kind == GLINT_GRAIN_BRUSHED;
}

static struct glint_vec normals[SIDE * SIDE];
static uint8_t pixels[SIDE * SIDE * 3], bytes[SIDE * SIDE], covered[SIDE * SIDE];

static struct glint_maps maps_of(int scene)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        covered[i] = surface_at(scene, i % SIDE, i / SIDE, &normals[i]) ? 255 : 0;
        bytes[i] = (uint8_t)(3 * (i % SIDE) + 5 * (i / SIDE));
    }
    const struct glint_maps maps = {.normals = normals,
                                    .normals_stride = SIDE * sizeof *normals,
                                    .coverage = covered,
                                    .coverage_stride = SIDE,
                                    .grain_stride = SIDE,
                                    .shininess_stride = SIDE};
    return maps;
}

static struct glint_surface whole(void)
{
    return (struct glint_surface){pixels, SIDE * 3, 0, 0};
}

/* The largest distance of a level from the value in double precision, from the same normals and half vector, which are of length 1 here. */
static double largest_difference(const struct look *look, const struct glint_maps *maps)
{
    const struct glint_surface surface = whole();
    const struct vec h = real_of(look->h), l = real_of(look->l);
    double largest = 0;
    assert_int_equal(draw_rect(look, maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
    for (int i = 0; i < SIDE * SIDE; i++) {
        if (!covered[i])
            continue;
        const struct vec n = real_of(normals[i]);
        const double c = dotted(n, h), t = 1 - c, nl = fmax(0, dotted(n, l));
        double ux, uy;
        direction_at(maps, i % SIDE, i / SIDE, &ux, &uy);
        const double across = maps->shininess ? glint_shininess_n(maps->shininess[i]) : look->material.n_across;
        const double more = maps->shininess ? 0 : look->material.n - across;
        const double s = look->material.model == GLINT_GGX ? t * (2 - t) / 2 : t;
        const double m = across * s + more * fmin(half_square(h, n, ux, uy, s), s);
        const double f = nl > 1e-4 && c > 0 ? lobe((enum glint_model)look->material.model, m, c) : 0;
        const double value = 200 / 255. * (4000 / 65536. + 9000 / 65536. * nl) + 52000 / 65536. * f;
        if (nl > 1e-4)
            largest = fmax(largest, fabs(pixels[3 * i] - 255 * fmin(value, 1)));
    }
    return largest;
}

static void pictures_are_within_six_tenths_of_a_level_of_double_precision(void **state)
{
    (void)state;
    static const uint16_t pairs[][2] = {{60, 8},   {200, 10}, {1000, 40}, {8, 60},
                                        {20, 400}, {5, 2},    {300, 299}, {10, 1}};
    double all = 0;
    for (int scene = 0; scene < 3; scene++) {
        struct glint_maps maps = maps_of(scene);
        for (int k = 0; k < GRAINED; k++)
            for (size_t p = 0; p < sizeof pairs / sizeof *pairs; p++)
                for (int kind = 0; kind < 5; kind++) {
                    const bool by_place = kind == GLINT_GRAIN_SPUN || kind == GLINT_GRAIN_SUNRAY;
                    struct look look = metal((enum glint_model)grained[k], pairs[p][0], pairs[p][1]);
                    maps.grain_kind = (uint8_t)(by_place ? kind : GLINT_GRAIN_BRUSHED);
                    maps.grain = kind == 3 ? bytes : NULL;
                    maps.shininess = kind == 4 ? bytes : NULL;
                    maps.grain_at[0] = by_place ? 8 * SIDE : 3;
                    maps.grain_at[1] = by_place ? 8 * SIDE : 1;
                    if (kind == 4)
                        look.material.n_across = 0;
                    const double largest = largest_difference(&look, &maps);
                    if (largest > .6)
                        fail_msg("scene %d, model %u, n %u, across %u, kind %d: %f", scene, grained[k], pairs[p][0],
                                 pairs[p][1], kind, largest);
                    all = fmax(all, largest);
                }
    }
    print_message("# at most %.3f of a level beyond the rounding\n", all - .5);
}

/* ---- What must not matter ---- */

static void n_across_of_0_or_n_draws_what_it_did(void **state)
{
    (void)state;
    static struct scene plain, same;
    for (int i = 0; i < 400; i++) {
        struct glint_box boxes[2];
        scene_init(&plain, (enum glint_format)(i % GLINT_FORMAT_COUNT), (enum glint_space)(i / 8 % 2));
        plain.look.material.model = grained[below(GRAINED)];
        scene_copy(&same, &plain);
        same.look.material.n_across = same.look.material.n;
        same.maps.grain = same.gloss;
        same.maps.grain_stride = W;
        assert_int_equal(draw_scene(&plain, &boxes[0]), GLINT_OK);
        assert_int_equal(draw_scene(&same, &boxes[1]), GLINT_OK);
        assert_memory_equal(plain.out, same.out, sizeof plain.out);
        assert_true(same_box(&boxes[0], &boxes[1]));
    }
}

/* Spun grain, too, as its centre is on the screen. */
static void pixels_do_not_depend_on_how_a_picture_is_cut(void **state)
{
    (void)state;
    struct glint_maps maps = maps_of(1);
    uint8_t drawn[sizeof pixels];
    for (int kind = 0; kind < 5; kind++) {
        struct look look = metal((enum glint_model)grained[kind], 60, (uint16_t)(kind < 4 ? 8 : 0));
        struct glint_paint paint;
        paint_of(&paint, &look);
        maps.grain_kind = (uint8_t)(kind < 3 ? kind : 0);
        maps.grain = kind == 3 ? bytes : NULL;
        maps.shininess = kind == 4 ? bytes : NULL;
        maps.grain_at[0] = 333, maps.grain_at[1] = 444;
        const struct glint_surface surface = whole();
        assert_int_equal(glint_draw_rect(&paint, &maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
        memcpy(drawn, pixels, sizeof pixels);
        memset(pixels, 0, sizeof pixels);
        for (unsigned y = 0; y < SIDE; y++)
            for (unsigned x = 0, w; x < SIDE; x += w) {
                const size_t at = y * SIDE + x;
                w = 1 + below(SIDE - x < 9 ? SIDE - x : 9);
                struct glint_maps part = maps;
                part.normals = normals + at;
                part.coverage = covered + at;
                part.grain = maps.grain ? bytes + at : NULL;
                part.shininess = maps.shininess ? bytes + at : NULL;
                const struct glint_surface to = {pixels + 3 * at, SIDE * 3, (uint16_t)x, (uint16_t)y};
                assert_int_equal(glint_draw_rect(&paint, &part, (uint16_t)w, 1, &to, NULL), GLINT_OK);
            }
        for (int i = 0; i < SIDE * SIDE; i++)
            if (covered[i])
                assert_memory_equal(drawn + 3 * i, pixels + 3 * i, 3);
    }
}

/* Leaves all to the 64-bit sequence. */
static uint32_t decide_nothing(const struct glint_paint *paint, const struct glint_run *run,
                               const struct glint_sample *samples, unsigned count)
{
    (void)paint, (void)run, (void)samples;
    return (UINT32_C(1) << count) - 1;
}

/* Grain shines far from where the light is mirrored, also where that grazes it: of a lamp so far that of N.L nothing is left. */
static void a_coloured_lamp_that_grazes_grain_has_the_pixels_of_64_bits(void **state)
{
    (void)state;
    static const int32_t position[3] = {8 * SIDE + 2000, 8 * SIDE - 3464, 0};
    const struct glint_maps maps = {
        .normals = normals, .normals_stride = SIDE * sizeof *normals, .grain = bytes, .grain_stride = SIDE};
    const struct glint_surface surface = whole();
    unsigned shining = 0;
    for (int i = 0; i < 4 * GRAINED; i++) {
        struct look look = metal((enum glint_model)grained[i % GRAINED], 1000, (uint16_t)(1 + below(40)));
        uint8_t drawn[sizeof pixels];
        struct glint_light lamp;
        struct glint_paint paint;
        look.output.space = GLINT_LINEAR;
        for (int k = 0; k < 3; k++)
            look.material.ambient_q16[k] = 0;
        for (int p = 0; p < SIDE * SIDE; p++) {
            normals[p] = (struct glint_vec){1, 0, 32767};
            bytes[p] = (uint8_t)below(256);
        }
        assert_int_equal(glint_light_point(&lamp, position, 6900), GLINT_OK);
        lamp.color_q16[0] = 1 << 18;
        assert_int_equal(glint_paint_exact(&paint, &look.material, &look.output), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, &lamp, 1, in_front), GLINT_OK);
        assert_int_equal(glint_draw_rect(&paint, &maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
        memcpy(drawn, pixels, sizeof pixels);
        struct glint_use_format slow = *paint.format;
        slow.levels = decide_nothing;
        paint.format = &slow;
        assert_int_equal(glint_draw_rect(&paint, &maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
        assert_memory_equal(drawn, pixels, sizeof pixels);
        for (int p = 0; p < SIDE * SIDE; p++)
            shining += pixels[3 * p] > 1;
    }
    assert_true(shining > 1000);
}

static int level_of(const struct look *look, const struct glint_maps *maps)
{
    uint8_t pixel[3];
    const struct glint_surface one = {pixel, 3, 0, 0};
    assert_int_equal(draw_rect(look, maps, 1, 1, &one, NULL), GLINT_OK);
    return pixel[0];
}

/* Within a level, since m has 22 bits. */
static void the_centre_and_a_normal_along_the_grain_take_the_mean_of_both(void **state)
{
    (void)state;
    const struct glint_vec along = {32767, 0, 0}, any = {-4000, 9000, 31000};
    for (int k = 0; k < GRAINED; k++) {
        struct look look = metal((enum glint_model)grained[k], 60, 20),
                    mean = metal((enum glint_model)grained[k], 40, 0);
        static const int32_t to_light[3] = {3, 1, 1};
        assert_int_equal(look_light(&look, to_light, in_front), GLINT_OK);
        assert_int_equal(look_light(&mean, to_light, in_front), GLINT_OK);
        struct glint_maps maps = {.normals = &along};
        assert_in_range(level_of(&look, &maps) - level_of(&mean, &maps) + 1, 0, 2);
        maps.normals = &any;
        maps.grain_kind = GLINT_GRAIN_SPUN;
        maps.grain_at[0] = maps.grain_at[1] = 8;
        assert_in_range(level_of(&look, &maps) - level_of(&mean, &maps) + 1, 0, 2);
    }
}

static void a_map_of_one_angle_is_that_direction(void **state)
{
    (void)state;
    static const uint8_t angles[] = {0, 64, 128, 192};
    static const int32_t directions[][2] = {{1, 0}, {INT32_MAX, INT32_MAX}, {0, 5}, {-7, 7}};
    struct glint_maps maps = maps_of(1);
    uint8_t drawn[sizeof pixels];
    const struct glint_surface surface = whole();
    for (int i = 0; i < 4; i++) {
        const struct look look = metal(GLINT_MSH, 60, 8);
        memset(bytes, angles[i], sizeof bytes);
        maps.grain = bytes;
        assert_int_equal(draw_rect(&look, &maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
        memcpy(drawn, pixels, sizeof pixels);
        maps.grain = NULL;
        memcpy(maps.grain_at, directions[i], sizeof maps.grain_at);
        assert_int_equal(draw_rect(&look, &maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
        for (size_t p = 0; p < sizeof pixels; p++)
            assert_in_range(drawn[p] - pixels[p] + 1, 0, 2);
    }
}

/* ---- Shininess ---- */

static void codes_of_shininess_rise_from_1_to_997_and_come_back(void **state)
{
    (void)state;
    assert_int_equal(glint_shininess_n(0), 1);
    assert_int_equal(glint_shininess_n(255), 997);
    assert_int_equal(glint_shininess_n(224), 432); /* the one that is nearest to a half */
    for (unsigned code = 0; code < 256; code++) {
        const uint32_t n = glint_shininess_n((uint8_t)code);
        const double meant = exp2(code * 5 / 128.);
        assert_true(fabs(n - meant) <= .5 + .004 * meant);
        assert_true(code == 0 || n >= glint_shininess_n((uint8_t)(code - 1)));
        assert_int_equal(glint_shininess_n(glint_shininess_code(n)), n);
    }
    for (uint32_t n = 0; n < 2000; n++) {
        const uint8_t code = glint_shininess_code(n);
        const double off = fabs(glint_shininess_n(code) - (double)n);
        for (int other = -1; other < 2; other += 2)
            if (code + other >= 0 && code + other < 256)
                assert_true(off <= fabs(glint_shininess_n((uint8_t)(code + other)) - (double)n));
    }
}

static void a_map_of_shininess_is_the_material_of_that_n(void **state)
{
    (void)state;
    struct glint_maps maps = maps_of(1);
    uint8_t drawn[sizeof pixels];
    const struct glint_surface surface = whole();
    for (int i = 0; i < 20; i++) {
        struct look look = metal((enum glint_model)grained[i % GRAINED], 7, 0);
        memset(bytes, 13 * i, sizeof bytes);
        if (look.material.model == GLINT_CAYLEY && glint_shininess_n(bytes[0]) <= 4)
            continue; /* its power is a fraction here */
        maps.shininess = bytes;
        assert_int_equal(draw_rect(&look, &maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
        memcpy(drawn, pixels, sizeof pixels);
        maps.shininess = NULL;
        look.material.n = (uint16_t)glint_shininess_n(bytes[0]);
        assert_int_equal(draw_rect(&look, &maps, SIDE, SIDE, &surface, NULL), GLINT_OK);
        for (size_t p = 0; p < sizeof pixels; p++)
            assert_in_range(drawn[p] - pixels[p] + 1, 0, 2);
    }
}

/* ---- Spans ---- */

static void a_span_has_the_grain_of_its_interpolated_normals(void **state)
{
    (void)state;
    enum { COUNT = 40 };
    const struct glint_vec first = {-3000, 5000, 32240}, last = {4000, 2000, 32460};
    struct glint_vec between[COUNT];
    uint8_t by_rect[COUNT * 3], by_span[COUNT * 3];
    const struct glint_surface rect = {by_rect, 0, 0, 0}, line = {by_span, 0, 0, 0};
    for (int i = 0; i < COUNT; i++) {
        const int32_t at[3] = {(first.x * (COUNT - 1 - i) + last.x * i), (first.y * (COUNT - 1 - i) + last.y * i),
                               (first.z * (COUNT - 1 - i) + last.z * i)};
        assert_int_equal(glint_vec_normalize(&between[i], at), GLINT_OK);
    }
    for (int k = 0; k < GRAINED; k++)
        for (int turn = 0; turn < 8; turn++) {
            const struct look look =
                metal((enum glint_model)grained[k], (uint16_t)(turn & 1 ? 60 : 8), (uint16_t)(turn & 1 ? 8 : 60));
            const struct glint_maps maps = {.normals = between, .grain_at = {turn - 4, 2}};
            struct glint_paint paint;
            struct glint_span span;
            paint_of(&paint, &look);
            assert_int_equal(glint_span_init(&span, &paint, &first, &last, COUNT), GLINT_OK);
            assert_int_equal(glint_draw_rect(&paint, &maps, COUNT, 1, &rect, NULL), GLINT_OK);
            assert_int_equal(glint_draw_span(&paint, &span, &maps, &line, NULL), GLINT_OK);
            for (int i = 0; i < 3 * COUNT; i++)
                assert_in_range(by_rect[i] - by_span[i] + 4, 0, 8);
        }
}

/* N.U goes through more than 2^31 from one end to the other; sanitizers watch. */
static void a_span_from_one_side_along_the_grain_to_the_other_is_drawn_alike_both_ways(void **state)
{
    (void)state;
    enum { COUNT = 57 };
    const struct look look = metal(GLINT_MSH, 60, 8);
    const struct glint_maps maps = {.grain_at = {1, 1}};
    uint8_t there[COUNT * 3], back[COUNT * 3];
    const struct glint_surface to[2] = {{there, 0, 0, 0}, {back, 0, 0, 0}};
    struct glint_paint paint;
    paint_of(&paint, &look);
    for (int way = 0; way < 2; way++) {
        const int16_t end = way ? -32767 : 32767;
        const struct glint_span span = {1 << 20, 0, 0, 1 << 29, 0, COUNT, {{end, end}, {(int16_t)-end, (int16_t)-end}}};
        assert_int_equal(glint_draw_span(&paint, &span, &maps, &to[way], NULL), GLINT_OK);
    }
    for (int i = 0; i < COUNT; i++)
        for (int k = 0; k < 3; k++)
            assert_in_range(there[3 * i + k] - back[3 * (COUNT - 1 - i) + k] + 1, 0, 2);
}

/* ---- What is refused ---- */

static enum glint_err drawn_by(const struct look *look, const struct glint_use_model *model,
                               const struct glint_maps *maps)
{
    struct glint_paint paint;
    const struct glint_surface surface = whole();
    memset(pixels, GUARD, sizeof pixels);
    enum glint_err err = glint_paint_exact_for(&paint, &look->material, &look->output, model, &glint_use_rgb888);
    if (!err)
        err = glint_paint_light(&paint, &look->light, 1, in_front);
    if (!err)
        err = glint_draw_rect(&paint, maps, SIDE, SIDE, &surface, NULL);
    for (size_t i = 0; err && i < sizeof pixels; i++)
        assert_int_equal(pixels[i], GUARD);
    return err;
}

static void a_program_that_names_the_plain_model_has_no_grain(void **state)
{
    (void)state;
    struct glint_maps maps = maps_of(1);
    struct look look = metal(GLINT_MSH, 60, 8);
    assert_int_equal(drawn_by(&look, &glint_use_msh, &maps), GLINT_ERR_ARG);
    assert_int_equal(drawn_by(&look, &glint_use_msh_grain, &maps), GLINT_OK);
    look.material.n_across = 0;
    maps.grain = bytes;
    assert_int_equal(drawn_by(&look, &glint_use_msh, &maps), GLINT_ERR_ARG);
    assert_int_equal(drawn_by(&look, &glint_use_msh_grain, &maps), GLINT_OK);
    maps.grain = NULL;
    maps.shininess = bytes;
    assert_int_equal(drawn_by(&look, &glint_use_msh, &maps), GLINT_ERR_ARG);
    assert_int_equal(drawn_by(&look, &glint_use_msh_grain, &maps), GLINT_OK);
}

static void models_without_grain_refuse_n_across_and_its_maps(void **state)
{
    (void)state;
    static const uint8_t models[] = {GLINT_BLINN, GLINT_PHONG, GLINT_GAUSS, GLINT_SG};
    struct glint_maps maps = maps_of(1);
    const struct glint_surface surface = whole();
    struct glint_paint paint;
    for (int i = 0; i < 4; i++) {
        struct look look = metal((enum glint_model)models[i], 60, 8);
        assert_int_equal(glint_paint_exact(&paint, &look.material, &look.output), GLINT_ERR_ARG);
        look.material.n_across = 60;
        maps.grain = i & 1 ? bytes : NULL;
        maps.shininess = i & 1 ? NULL : bytes;
        assert_int_equal(draw_rect(&look, &maps, SIDE, SIDE, &surface, NULL), GLINT_ERR_ARG);
    }
}

static void maps_that_make_no_sense_are_refused(void **state)
{
    (void)state;
    const struct glint_maps good = maps_of(1);
    struct glint_maps bad[7];
    struct look look = metal(GLINT_MSH, 60, 8);
    const struct glint_surface surface = whole();
    for (int i = 0; i < 7; i++)
        bad[i] = good;
    bad[0].grain_kind = GLINT_GRAIN_SUNRAY + 1;
    bad[1].grain_kind = GLINT_GRAIN_SPUN, bad[1].grain_at[1] = GLINT_LIGHT_FAR + 1;
    bad[2].grain_kind = GLINT_GRAIN_SUNRAY, bad[2].grain_at[0] = -GLINT_LIGHT_FAR - 1;
    bad[3].grain = bytes, bad[3].grain_stride = SIDE - 1;
    bad[4].shininess = bytes; /* with n_across */
    bad[5].shininess = bytes, bad[5].grain = bytes;
    bad[6].grain = bytes, bad[6].grain_stride = 1 - SIDE;
    for (int i = 0; i < 7; i++)
        assert_int_equal(draw_rect(&look, &bad[i], SIDE, SIDE, &surface, NULL), GLINT_ERR_ARG);
    for (int i = 0; i < 4; i++) { /* a centre as far as one may be */
        struct glint_maps far = good;
        far.grain_kind = GLINT_GRAIN_SPUN;
        far.grain_at[i / 2] = i % 2 ? GLINT_LIGHT_FAR : -GLINT_LIGHT_FAR;
        assert_int_equal(draw_rect(&look, &far, SIDE, SIDE, &surface, NULL), GLINT_OK);
    }
    look.material.n_across = 0;
    bad[4].shininess_stride = SIDE - 1;
    assert_int_equal(draw_rect(&look, &bad[4], SIDE, SIDE, &surface, NULL), GLINT_ERR_ARG);
}

static void spans_take_one_direction_and_tables_no_grain(void **state)
{
    (void)state;
    static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
    struct look look = metal(GLINT_MSH, 60, 8);
    const struct glint_surface surface = whole();
    const struct glint_vec n = {0, 0, 32767};
    struct glint_paint paint;
    struct glint_span span;
    struct glint_maps maps = {.grain_kind = GLINT_GRAIN_SPUN};
    paint_of(&paint, &look);
    assert_int_equal(glint_span_init(&span, &paint, &n, &n, 4), GLINT_OK);
    assert_int_equal(glint_draw_span(&paint, &span, &maps, &surface, NULL), GLINT_ERR_ARG);
    maps.grain_kind = GLINT_GRAIN_BRUSHED;
    maps.grain = bytes;
    assert_int_equal(glint_draw_span(&paint, &span, &maps, &surface, NULL), GLINT_ERR_ARG);
    look.output.format = GLINT_RGB565;
    assert_int_equal(
        glint_paint_tables(&paint, GLINT_TABLES_COLOUR, &look.material, &look.output, memory, sizeof memory),
        GLINT_ERR_ARG);
    look.material.n_across = 0;
    assert_int_equal(
        glint_paint_tables(&paint, GLINT_TABLES_COLOUR, &look.material, &look.output, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &look.light, 1, in_front), GLINT_OK);
    maps.normals = normals;
    maps.normals_stride = 6 * SIDE;
    assert_int_equal(glint_draw_rect(&paint, &maps, 4, 1, &surface, NULL), GLINT_ERR_ARG);
}

/* Also of those few that are so near a half that 32 bits leave them open. */
static void the_grain_s_one_direction_is_to_nearest(void **state)
{
    (void)state;
    for (int i = 0; i < 30000; i++) {
        const struct glint_maps maps = {.grain_at = {(int32_t)below(2000) - 1000, (int32_t)below(2000) - 1000}};
        const int32_t v[3] = {maps.grain_at[0], maps.grain_at[1], 0};
        struct glint_vec unit = {32767, 0, 0};
        (void)glint_vec_normalize(&unit, v);
        struct glint_lines lines = {.maps = &maps};
        glint_grain_begin(&lines);
        assert_true(lines.grain[0] == unit.x && lines.grain[1] == unit.y);
    }
}

static void beyond_the_largest_m_nothing_is_left_of_grain(void **state)
{
    (void)state;
    struct look look = metal(GLINT_MSH, 60, 8);
    struct glint_paint paint;
    paint_of(&paint, &look);
    assert_true(glint_grain_f(&paint, 0, 0) >= 65536);
    assert_int_equal(glint_grain_f(&paint, GLINT_GRAIN_MOST + 1, 0), 0);
    assert_int_equal(glint_grain_f(&paint, 0, GLINT_T_ONE + 1), 0);
}

static void sines_of_grain_are_to_nearest(void **state)
{
    (void)state;
    for (int i = 0; i <= 128; i++)
        assert_int_equal(glint_grain_sines[i], lround(32768 * sin(i * acos(-1) / 256)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(beyond_the_largest_m_nothing_is_left_of_grain),
        cmocka_unit_test(sines_of_grain_are_to_nearest),
        cmocka_unit_test(the_grain_s_one_direction_is_to_nearest),
        cmocka_unit_test(pictures_are_within_six_tenths_of_a_level_of_double_precision),
        cmocka_unit_test(n_across_of_0_or_n_draws_what_it_did),
        cmocka_unit_test(pixels_do_not_depend_on_how_a_picture_is_cut),
        cmocka_unit_test(a_coloured_lamp_that_grazes_grain_has_the_pixels_of_64_bits),
        cmocka_unit_test(the_centre_and_a_normal_along_the_grain_take_the_mean_of_both),
        cmocka_unit_test(a_map_of_one_angle_is_that_direction),
        cmocka_unit_test(codes_of_shininess_rise_from_1_to_997_and_come_back),
        cmocka_unit_test(a_map_of_shininess_is_the_material_of_that_n),
        cmocka_unit_test(a_span_has_the_grain_of_its_interpolated_normals),
        cmocka_unit_test(a_span_from_one_side_along_the_grain_to_the_other_is_drawn_alike_both_ways),
        cmocka_unit_test(a_program_that_names_the_plain_model_has_no_grain),
        cmocka_unit_test(models_without_grain_refuse_n_across_and_its_maps),
        cmocka_unit_test(maps_that_make_no_sense_are_refused),
        cmocka_unit_test(spans_take_one_direction_and_tables_no_grain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
