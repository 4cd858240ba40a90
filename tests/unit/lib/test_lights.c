/* SPDX-License-Identifier: MIT
 * Several lights: the value of every pixel, against a reference in doubles that is written from the formula. */
#include "lamps.h"

#include "models/models.h"

/* ---- against one light ---- */

/* So one directional light, which folds into the material, gives the sums' pixels, whatever its colour is, and where its direction lies in the
 * middle of two of Q1.15. Of one that is so dim that a highlight may round to none the box is where F is, not the sum. */
static void a_light_of_colour_0_changes_nothing(void **state)
{
    (void)state;
    static struct scene a, b;
    for (int i = 0; i < 2000; i++) {
        scene_init(&a, format_number(i), (enum glint_space)below(2));
        scene_copy(&b, &a);
        struct glint_light lights[GLINT_LIGHTS_MAX];
        struct glint_box box_a, box_b;
        const unsigned count = i % 4 ? 1 : below(GLINT_LIGHTS_MAX), at = below(count + 1);
        random_lights(lights);
        if (i % 4) {
            lights[0] = a.look.light;
            for (int k = 0; k < 3 && i & 16; k++)
                lights[0].direction_q30[k] = (lights[0].direction_q30[k] | 0x7fff) - 0x3fff;
            for (int k = 0; k < 3 && i % 4 > 1; k++)
                lights[0].color_q16[k] = below(UINT32_C(1) << (10 + below(13)));
        }
        draw_scene_under(&a, lights, count, &box_a);
        memmove(lights + at + 1, lights + at, (count - at) * sizeof *lights);
        lights[at] = i & 8 ? random_light() : a.look.light;
        memset(lights[at].color_q16, 0, sizeof lights[at].color_q16);
        draw_scene_under(&b, lights, count + 1, &box_b);
        assert_memory_equal(a.out, b.out, sizeof a.out);
        bool is_dim = count < 2;
        for (int k = 0; k < 3 && count == 1; k++)
            is_dim = is_dim && lights[at == 0].color_q16[k] < 32768;
        if (!is_dim)
            assert_true(same_box(&box_a, &box_b));
    }
}

/* Bit by bit, in 128-bit fractions: directional lights have no rounding but the sequence's. */
static void directional_lights_are_summed_as_the_sequence_says(void **state)
{
    (void)state;
    static struct scene s;
    for (int i = 0; i < 1500; i++) {
        scene_init(&s, format_number(i), GLINT_GAMMA);
        s.maps.coverage = NULL;
        struct glint_light lights[GLINT_LIGHTS_MAX];
        struct look looks[GLINT_LIGHTS_MAX];
        const unsigned count = below(GLINT_LIGHTS_MAX + 1);
        for (unsigned k = 0; k < count; k++) {
            looks[k] = s.look;
            look_any_light(&looks[k]);
            lights[k] = looks[k].light;
            for (int c = 0; c < 3; c++)
                lights[k].color_q16[c] = below(below(4) ? 65537 : 1 << 20);
        }
        draw_scene_under(&s, lights, count, NULL);
        for (unsigned p = 0; p < W * H; p++) {
            uint64_t lit[3] = {0}, shine[3] = {0};
            for (unsigned k = 0; k < count; k++) {
                uint32_t nl;
                const uint32_t f = lobe_at(&looks[k], s.normals[p], &nl);
                for (int c = 0; c < 3; c++) {
                    lit[c] += colored(lights[k].color_q16[c], nl);
                    shine[c] += colored(lights[k].color_q16[c], f);
                }
            }
            unsigned wanted[3], found[3];
            double real[3];
            levels_of(&s.look, lit, shine, &s.albedo[3 * p], s.gloss[p], s.surface.x + p % W, s.surface.y + p / W,
                      wanted, real);
            stored_levels((enum glint_format)s.look.output.format, s.out + LINE * (1 + p / W), p % W, found);
            assert_memory_equal(found, wanted, sizeof found);
        }
    }
}

/* ---- against doubles ---- */

struct vector {
    double x, y, z;
};

static struct vector plus(struct vector a, struct vector b, double times)
{
    return (struct vector){a.x + times * b.x, a.y + times * b.y, a.z + times * b.z};
}

static double product(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vector unit(struct vector a)
{
    return plus((struct vector){0, 0, 0}, a, 1 / sqrt(product(a, a)));
}

static struct vector real_vector(struct glint_vec v)
{
    return (struct vector){v.x / 32768., v.y / 32768., v.z / 32768.};
}

static struct vector q30_vector(const int32_t v[3])
{
    return (struct vector){(double)v[0], (double)v[1], (double)v[2]};
}

/* Towards the lamp, and how much of it arrives. */
static double arrives(const struct glint_light *lamp, double x, double y, struct vector *l)
{
    if (kind_of(lamp) == DIRECTIONAL) {
        *l = unit(q30_vector(lamp->direction_q30));
        return 1;
    }
    *l = (struct vector){0, 0, 1};
    const struct vector e = {lamp->position[0] / 16. - x, y - lamp->position[1] / 16., lamp->position[2] / 16.};
    if (product(e, e) == 0)
        return 0; /* by definition */
    const double u = product(e, e) * 256 / lamp->range / lamp->range;
    *l = unit(e);
    double att = u < 1 ? (1 - u) * (1 - u) : 0;
    if (kind_of(lamp) == SPOT) {
        const double c = -product(unit(q30_vector(lamp->direction_q30)), *l) * ONE_Q30;
        const double p = fmin(1, fmax(0, (c - lamp->cos_outer_q30) / (lamp->cos_inner_q30 - lamp->cos_outer_q30)));
        att *= p * p * (3 - 2 * p);
    }
    return att;
}

/* F at N, unrounded: N is the integers', of which the length is off by up to 2^-15; t takes it as it is. */
static double lobe(const struct look *s, struct vector n, struct vector l, struct vector v)
{
    const struct vector off = s->material.model == GLINT_PHONG ? plus(plus(l, v, 1), n, -2 * product(n, l))
                                                               : plus(n, unit(plus(l, v, 1)), -1);
    const double t = product(off, off) / 2;
    const double f = t >= 1 ? 0 : model_double((enum glint_model)s->material.model, s->material.n, 1 - t);
    return s->material.clamp_peak ? fmin(1, f) : f;
}

/* Of length 1, and half of the time within some degrees of the half vector. */
static struct glint_vec normal_near_a_highlight(const struct scene *s, const struct glint_light *lamp, unsigned pixel)
{
    struct vector h = {0, 0, 1}, l;
    const double spread = below(2) ? 1 : exp2(-(double)below(10));
    (void)arrives(lamp, pixel % W + s->surface.x + .5, pixel / W + s->surface.y + .5, &l);
    h = plus(unit(plus(h, l, 1)), (struct vector){within(1000) / 1e3, within(1000) / 1e3, within(1000) / 1e3}, spread);
    struct glint_vec normal = {0, 0, 32767};
    (void)glint_vec_normalize(&normal, (int32_t[]){(int32_t)(h.x * 1e6), (int32_t)(h.y * 1e6), (int32_t)(h.z * 1e6)});
    return normal;
}

/* The three channels in levels of 255; false where a lamp grazes the surface, is straight behind or has a hard edge here,
 * on either side of which pixels differ. */
static bool reference(const struct scene *s, const struct glint_light *lamps, unsigned count, unsigned pixel,
                      double levels[3])
{
    const struct vector n = real_vector(s->normals[pixel]), v = unit(real_vector(s->look.v));
    double lit[3] = {0, 0, 0}, shine[3] = {0, 0, 0};
    for (unsigned i = 0; i < count; i++) {
        struct vector l;
        const double att = arrives(&lamps[i], pixel % W + s->surface.x + .5, pixel / W + s->surface.y + .5, &l);
        const double nl = product(n, l);
        const bool has_edge = kind_of(&lamps[i]) == SPOT && lamps[i].cos_inner_q30 - lamps[i].cos_outer_q30 < 10000;
        const bool behind = product(plus(l, v, 1), plus(l, v, 1)) < 1e-8;
        if (has_edge || behind || fabs(nl) < 1e-4)
            return false;
        if (nl < 0)
            continue;
        const double f = lobe(&s->look, n, l, v);
        for (int k = 0; k < 3; k++) {
            lit[k] += lamps[i].color_q16[k] / 65536. * att * fmin(1, nl);
            shine[k] += lamps[i].color_q16[k] / 65536. * att * f;
        }
    }
    const struct glint_material *m = &s->look.material;
    for (int k = 0; k < 3; k++) {
        const double albedo = s->albedo[3 * pixel + (unsigned)k] / 255., gloss = s->gloss[pixel] / 255.;
        const double value = albedo * (clamped(m->ambient_q16[k]) + clamped(m->diffuse_q16[k]) * lit[k]) +
                             clamped(m->specular_q16[k]) * gloss * shine[k];
        levels[k] = 255 * fmin(1, value / 65536);
    }
    return true;
}

/* Beyond the rounding, half a level, there are L, V and H in Q1.15: each component is off by 2^-16 (2^-15 where 1.0 is
 * held as 32767), 2.6e-5 in length; the steepest lobe, n = 1000, has a slope of 20 a radian: .13 level for each lamp. The
 * cutoff is 2^-16, no level at all. */
static void pixels_of_up_to_four_lights_are_within_their_rounding_of_doubles(void **state)
{
    (void)state;
    static struct scene s;
    unsigned compared = 0, lit = 0;
    double worst = 0;
    for (int i = 0; i < 3000; i++) {
        scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
        s.look.output.dither = false;
        s.look.material.q = 16;
        s.maps.coverage = NULL;
        struct glint_light lamps[GLINT_LIGHTS_MAX];
        random_lights(lamps);
        const unsigned count = below(GLINT_LIGHTS_MAX + 1);
        for (unsigned p = 0; p < W * H; p++)
            s.normals[p] = normal_near_a_highlight(&s, &lamps[below(GLINT_LIGHTS_MAX)], p);
        assert_int_equal(draw_under(&s.look, lamps, count, &s.maps, W, H, &s.surface, NULL), GLINT_OK);
        for (unsigned p = 0; p < W * H; p++) {
            double wanted[3];
            if (!reference(&s, lamps, count, p, wanted))
                continue;
            for (unsigned k = 0; k < 3; k++) {
                const double beyond = fabs(s.out[LINE * (1 + p / W) + 3 * (p % W) + k] - wanted[k]) - .5;
                worst = fmax(worst, beyond);
                if (beyond > .001 + .13 * count)
                    fail_msg("model %d, n %d, %u lamps: wanted %g, off by %g beyond the rounding",
                             s.look.material.model, s.look.material.n, count, wanted[k], beyond);
                compared++;
                lit += wanted[k] > 0 && wanted[k] < 255;
            }
        }
    }
    printf("# at most %.3f of a level beyond the rounding, %u samples\n", worst, compared);
    assert_true(compared > 1000000 && lit > compared / 2);
}

/* ---- what the sums promise ---- */

static void the_order_of_the_lights_does_not_matter(void **state)
{
    (void)state;
    static struct scene a, b;
    for (int i = 0; i < 300; i++) {
        scene_init(&a, format_number(i), (enum glint_space)below(2));
        scene_copy(&b, &a);
        struct glint_light lamps[GLINT_LIGHTS_MAX], others[GLINT_LIGHTS_MAX];
        random_lights(lamps);
        const unsigned turn = 1 + below(3);
        for (unsigned k = 0; k < GLINT_LIGHTS_MAX; k++)
            others[k] = lamps[i & 1 ? 3 - k : (k + turn) % GLINT_LIGHTS_MAX];
        struct glint_box box_a, box_b;
        draw_scene_under(&a, lamps, 4, &box_a);
        draw_scene_under(&b, others, 4, &box_b);
        assert_memory_equal(a.out, b.out, sizeof a.out);
        assert_true(same_box(&box_a, &box_b));
    }
}

static void without_lights_the_ambient_part_is_left(void **state)
{
    (void)state;
    static struct scene a, b;
    for (int i = 0; i < 100; i++) {
        scene_init(&a, format_number(i), (enum glint_space)below(2));
        scene_copy(&b, &a);
        for (int k = 0; k < 3; k++)
            b.look.material.diffuse_q16[k] = b.look.material.specular_q16[k] = 0;
        struct glint_box box = {9, 9, 9, 9};
        draw_scene_under(&a, NULL, 0, &box);
        assert_int_equal(draw_scene(&b, NULL), GLINT_OK);
        assert_memory_equal(a.out, b.out, sizeof a.out);
        assert_true(box.x == 0 && box.y == 0 && box.w == 0 && box.h == 0);
    }
}

/* Of lights of a colour by which F of k is the least that does not round to 0, where the model's loop may have k - 1; the second has none. */
static void a_pixel_is_in_the_box_of_several_lights_where_exact_f_is_not_0(void **state)
{
    (void)state;
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    unsigned shine = 0;
    set_model(&look, GLINT_MSH, 3, 16);
    assert_int_equal(look_light(&look, in_front, in_front), GLINT_OK);
    struct glint_light lights[2] = {look.light, look.light};
    for (int i = 0; i < 5000; i++) {
        const uint32_t k = 1 + below(60), color = (32768 + k - 1) / k;
        const int32_t to[3] = {32768, within(2000), (int32_t)(14 * k / 5) + within(9)}; /* F is near k */
        uint8_t out[3];
        uint32_t nl;
        struct glint_vec normal;
        struct glint_box box;
        assert_int_equal(glint_vec_normalize(&normal, to), GLINT_OK);
        for (int c = 0; c < 3; c++) {
            lights[0].color_q16[c] = color;
            lights[1].color_q16[c] = 0;
        }
        const struct glint_maps maps = {.normals = &normal};
        const struct glint_surface surface = {out, sizeof out, 0, 0};
        assert_int_equal(draw_under(&look, lights, 2, &maps, 1, 1, &surface, &box), GLINT_OK);
        assert_int_equal(box.w, colored(color, lobe_at(&look, normal, &nl)) > 0);
        shine += box.w;
    }
    assert_in_range(shine, 1000, 4000);
}

/* ---- one light over a plane ---- */

/* A line of pixels that all face the lamp, white, without a highlight: what arrives, times 255. */
enum { LONG = 320 };
static void draw_line(const struct glint_light *lamp, uint8_t out[LONG])
{
    struct glint_vec normals[LONG];
    for (int x = 0; x < LONG; x++) {
        const int32_t to_lamp[3] = {lamp->position[0] - PIXEL * x - 8, 8 - lamp->position[1], lamp->position[2]};
        assert_int_equal(glint_vec_normalize(&normals[x], to_lamp), GLINT_OK);
    }
    struct look look = {.output = {.format = GLINT_GREY8}, .to_viewer = {0, 0, 1}};
    set_model(&look, GLINT_MSH, 60, 8);
    for (int k = 0; k < 3; k++) {
        look.material.diffuse_q16[k] = 65536;
        look.material.albedo[k] = 255;
    }
    const struct glint_maps maps = {.normals = normals};
    const struct glint_surface surface = {out, LONG, 0, 0};
    assert_int_equal(draw_under(&look, lamp, 1, &maps, LONG, 1, &surface, NULL), GLINT_OK);
}

static const int32_t overhead[3] = {8, 8, 640};

static void light_falls_smoothly_to_nothing_at_its_range(void **state)
{
    (void)state;
    struct glint_light lamp;
    uint8_t out[LONG];
    const uint32_t range = 4000;
    assert_int_equal(glint_light_point(&lamp, overhead, range), GLINT_OK);
    for (int bright = 0; bright < 2; bright++) {
        for (int k = 0; k < 3; k++)
            lamp.color_q16[k] = bright ? 16 * 65536 : 65536;
        draw_line(&lamp, out);
        for (int x = 0; x < LONG; x++) {
            const double u = (16. * 16 * x * x + 640 * 640) / range / range;
            assert_near(out[x], fmin(255, (bright ? 16 * 255 : 255) * (u < 1 ? (1 - u) * (1 - u) : 0)), .55);
            assert_true(x == 0 || (out[x] <= out[x - 1] && out[x - 1] - out[x] < (bright ? 30 : 3)));
            if (16. * 16 * x * x + 640 * 640 >= (double)range * range)
                assert_int_equal(out[x], 0);
        }
        assert_true(out[0] > 240 && out[LONG - 1] == 0);
    }
}

static void a_colour_beyond_sixteen_counts_as_sixteen(void **state)
{
    (void)state;
    struct glint_light lamp;
    uint8_t most[LONG], beyond[LONG];
    assert_int_equal(glint_light_point(&lamp, overhead, 4000), GLINT_OK);
    for (int k = 0; k < 3; k++)
        lamp.color_q16[k] = 1 << 20;
    draw_line(&lamp, most);
    for (int k = 0; k < 3; k++)
        lamp.color_q16[k] = UINT32_MAX;
    draw_line(&lamp, beyond);
    assert_memory_equal(most, beyond, LONG);
}

static void a_spot_is_the_point_light_in_its_inner_cone_and_nothing_beyond_the_outer(void **state)
{
    (void)state;
    static const double cones[][2] = {{20, 40}, {30, 30}, {0, 60}, {1, 2}, {0, 0}};
    const int32_t below_it[3] = {8, 8, 0};
    for (int i = 0; i < 5; i++) {
        struct glint_light point, spot;
        uint8_t full[LONG], out[LONG];
        assert_int_equal(glint_light_point(&point, overhead, 8000), GLINT_OK);
        assert_int_equal(glint_light_spot(&spot, overhead, below_it, 8000, cosine(cones[i][0]), cosine(cones[i][1])),
                         GLINT_OK);
        draw_line(&point, full);
        draw_line(&spot, out);
        int inside = 0, between = 0, outside = 0;
        for (int x = 0; x < LONG; x++) {
            const double angle = atan2(16 * x, 640) * 180 / M_PI;
            if (angle < cones[i][0] || x == 0) {
                assert_int_equal(out[x], full[x]);
                inside++;
            } else if (angle > cones[i][1]) {
                assert_int_equal(out[x], 0);
                outside++;
            } else {
                assert_in_range(out[x], 0, full[x]);
                assert_true(out[x] <= out[x - 1]);
                between++;
            }
        }
        assert_true(inside && outside && (between || cones[i][0] == cones[i][1]));
    }
}

static void a_light_at_a_pixel_or_straight_behind_gives_nothing_there(void **state)
{
    (void)state;
    struct look look = random_look(GLINT_GREY8, GLINT_GAMMA);
    memset(look.material.ambient_q16, 0, sizeof look.material.ambient_q16);
    look.output.dither = false;
    const struct glint_vec back = {0, 0, -32768}, front = {0, 0, 32767};
    const int32_t at_pixel[3] = {8, 8, 0}, behind[3] = {8, 8, -100};
    const struct {
        const int32_t *position;
        const struct glint_vec *normal;
    } cases[] = {{at_pixel, &front}, {at_pixel, &back}, {behind, &back}};
    for (int i = 0; i < 3; i++) {
        for (int model = 0; model < GLINT_MODEL_COUNT; model++) {
            struct glint_light lamp;
            uint8_t out = GUARD;
            set_model(&look, (enum glint_model)model, 3, 8);
            assert_int_equal(glint_light_point(&lamp, cases[i].position, 1000), GLINT_OK);
            const struct glint_maps maps = {.normals = cases[i].normal};
            const struct glint_surface surface = {&out, 1, 0, 0};
            assert_int_equal(draw_under(&look, &lamp, 1, &maps, 1, 1, &surface, NULL), GLINT_OK);
            assert_int_equal(out, 0);
        }
    }
}

/* Of 16 as of 1, of a material that is dark in turn: the sums are the same, but for their last units. */
static void bright_lights_on_a_dark_material_are_dim_ones_on_a_bright_one(void **state)
{
    (void)state;
    static struct scene a, b;
    for (int i = 0; i < 200; i++) {
        scene_init(&a, GLINT_RGB888, GLINT_GAMMA);
        a.look.output.dither = false;
        for (int k = 0; k < 3; k++) {
            a.look.material.diffuse_q16[k] = 16 * below(4097);
            a.look.material.specular_q16[k] = 16 * below(4097);
        }
        scene_copy(&b, &a);
        struct glint_light lamps[GLINT_LIGHTS_MAX];
        const unsigned count = 1 + below(4);
        random_lights(lamps);
        draw_scene_under(&a, lamps, count, NULL);
        const uint32_t times = 2u << below(4);
        for (int k = 0; k < 3; k++) {
            b.look.material.diffuse_q16[k] /= times;
            b.look.material.specular_q16[k] /= times;
            for (unsigned l = 0; l < count; l++)
                lamps[l].color_q16[k] *= times;
        }
        draw_scene_under(&b, lamps, count, NULL);
        for (size_t p = 0; p < sizeof a.out; p++)
            assert_in_range(a.out[p] - b.out[p] + 1, 0, 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_light_of_colour_0_changes_nothing),
        cmocka_unit_test(directional_lights_are_summed_as_the_sequence_says),
        cmocka_unit_test(pixels_of_up_to_four_lights_are_within_their_rounding_of_doubles),
        cmocka_unit_test(the_order_of_the_lights_does_not_matter),
        cmocka_unit_test(without_lights_the_ambient_part_is_left),
        cmocka_unit_test(a_pixel_is_in_the_box_of_several_lights_where_exact_f_is_not_0),
        cmocka_unit_test(light_falls_smoothly_to_nothing_at_its_range),
        cmocka_unit_test(a_colour_beyond_sixteen_counts_as_sixteen),
        cmocka_unit_test(a_spot_is_the_point_light_in_its_inner_cone_and_nothing_beyond_the_outer),
        cmocka_unit_test(a_light_at_a_pixel_or_straight_behind_gives_nothing_there),
        cmocka_unit_test(bright_lights_on_a_dark_material_are_dim_ones_on_a_bright_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
