/* SPDX-License-Identifier: MIT
 * What a paint folds to: by how much V may be low is at most W, and it is never high. And pixels where a unit of V, or of t, would show. */
#include "shading.h"

#include "glint_lobe.h"

static const double luma[3] = {54 / 256., 183 / 256., 19 / 256.};

/* Of a channel: what it is, and the paint with its light. */
struct channel {
    const struct glint_paint *paint;
    int k;
    double part, max; /* of a level; the largest one */
    bool maps;
};

static double color_of(const struct channel *c)
{
    const uint32_t color = c->paint->color_q16[c->k];
    return color < GLINT_LIGHT_COLOR_MAX ? color : GLINT_LIGHT_COLOR_MAX;
}

/* Of a light that is not white nl and F are rounded: by a half each. */
static double half_a_unit(const struct channel *c)
{
    return color_of(c) == 65536 ? 0 : .5;
}

/* By how much V of all of a sample's levels may be low at the largest nl and F, in units of V. */
static double low_by(const struct channel *c)
{
    const struct glint_paint *p = c->paint;
    const struct glint_material *m = &p->material;
    const int k = c->k;
    const double one = ldexp(1, (int)p->of.exact.shift),
                 taken_off = ldexp(p->of.exact.high, (int)p->of.exact.shift - 15);
    const double a = clamped(m->ambient_q16[k]) / 65536., d = clamped(m->diffuse_q16[k]) / 65536.;
    const double unit = one * c->max * c->part, s = clamped(m->specular_q16[k]) / 65536., nl = 65536, f = 67109;
    const double lit = color_of(c) / 65536 * nl + half_a_unit(c);
    const double shine = unit * s * (color_of(c) / 65536 * (f + p->of.exact.slack) + half_a_unit(c)) / 65536;
    if (!c->maps) {
        const bool has_threshold = c->part == 1 && !p->output.dither; /* is it in P? */
        const double albedo = m->albedo[k] / 255., threshold = has_threshold ? one / 2 : taken_off;
        return unit * albedo * (a + d * lit / 65536) + threshold - p->of.exact.p[k] - (double)p->of.exact.q[k] * nl +
               shine - (double)p->of.exact.r[k] * f;
    }
    const double found = floor(255 * (p->of.exact.ambient[k] + (double)p->of.exact.diffuse[k] * nl) / 128);
    const double high = f - 1 - 1. / 64; /* F gloss / 255 may be so low: glint_by_255 */
    return unit * (a + d * lit / 65536) - found + shine - (double)p->of.exact.r[k] * high + taken_off;
}

/* By how much it may be high where nl and F are as little as they can be, the rounding excepted. */
static double high_by(const struct channel *c)
{
    const struct glint_paint *p = c->paint;
    const struct glint_material *m = &p->material;
    const double unit = ldexp(c->max * c->part, (int)p->of.exact.shift);
    const double albedo = c->maps ? 1 : m->albedo[c->k] / 255.;
    return half_a_unit(c) / 65536 * unit * (albedo * clamped(m->diffuse_q16[c->k]) + clamped(m->specular_q16[c->k])) /
           65536;
}

/* By how much V may be lower than V + W, in units of 2^(shift - 16); never more than 0. */
static double beyond(const struct look *look, bool maps)
{
    const enum glint_format format = (enum glint_format)look->output.format;
    const bool grey = is_grey(format);
    struct glint_paint p;
    paint_of(&p, look);
    const double one = ldexp(1, (int)p.of.exact.shift), taken_off = ldexp(p.of.exact.high, (int)p.of.exact.shift - 15);
    double sum = 0, largest = 0, high = 0;
    for (int k = 0; k < 3; k++) {
        const double max = max_of(format, (unsigned)k);
        const struct channel channel = {&p, k, grey ? luma[k] : 1, max, maps};
        const double low = low_by(&channel);
        sum += low;
        largest = low > largest ? low : largest;
        high = grey ? high + high_by(&channel) : fmax(high, high_by(&channel));
    }
    if (grey)
        sum -= 2 * taken_off; /* of three channels' sums once */
    if (high > taken_off)
        fail_msg("V is high by %.3f: format %u, maps %d", (high - taken_off) * 65536 / one, format, maps);
    return ((grey ? sum : largest) - (maps ? p.of.exact.w_maps : p.of.exact.w)) * 65536 / one;
}

static uint32_t any_size(void)
{
    return below(UINT32_C(1) << below(18));
}

/* From random materials and lights uphill, to those of which the most is cut off. */
static double uphill(struct look best, bool maps, bool colored)
{
    double most = -1e9;
    for (int step = 0; step < 4000; step++) {
        struct look next = best;
        const unsigned k = below(3);
        switch (below(colored ? 5 : 4)) {
        case 0:
            next.material.ambient_q16[k] = any_size();
            break;
        case 1:
            next.material.diffuse_q16[k] = any_size();
            break;
        case 2:
            next.material.specular_q16[k] = any_size();
            break;
        case 3:
            next.material.albedo[k] = (uint8_t)below(256);
            break;
        default:
            next.light.color_q16[k] = below(8) ? below(UINT32_C(1) << below(22)) : UINT32_C(65536) << below(5);
        }
        const double found = beyond(&next, maps);
        if (found > 0)
            fail_msg("V + W is low by %.3f: format %u, maps %d", found, next.output.format, maps);
        if (found >= most) {
            most = found;
            best = next;
        }
    }
    return most;
}

static void v_is_low_by_at_most_w_in_gamma_space_and_never_high(void **state)
{
    (void)state;
    double worst[2] = {-1e9, -1e9};
    for (int i = 0; i < 400; i++) {
        const bool colored = i & 2;
        struct look look = random_look(format_number(i / 4), GLINT_GAMMA);
        look.material.model = GLINT_MSH;
        worst[colored] = fmax(worst[colored], uphill(look, i & 1, colored));
    }
    print_message(
        "V + W is never low, and high by %.3f of 2^(shift - 16) at the least, by %.3f under coloured lights\n",
        -worst[0], -worst[1]);
    assert_true(worst[0] > -5); /* else the search has seen nothing */
}

/* f <= F <= f + slack, by how much ever E is shifted up, while m < 2^28: the fold chooses what is quickest. */
static void msh_is_low_by_at_most_its_slack_however_it_is_scaled(void **state)
{
    (void)state;
    for (uint32_t n = 1; n <= 1000; n++) {
        const int64_t k = 4 * (int64_t)n - 5;
        for (int up = 0; up < 9 && k * (1 << up) < 1 << 17; up++) {
            struct glint_paint paint = {0};
            paint.of.exact.n = n;
            paint.of.exact.t_end = 1 << 30;
            paint.of.exact.f_max = UINT32_MAX;
            paint.of.exact.k[GLINT_MSH_FACTOR] = (int32_t)(k * (1 << up));
            paint.of.exact.k[GLINT_MSH_ADDEND] = 5 * 65536 << up;
            paint.of.exact.k[GLINT_MSH_SHIFT] = 32 - 2 * up;
            for (int i = 0; i < 300; i++) {
                struct glint_sample sample = {below(UINT32_C(1) << below(31)), 65536, 0};
                const int64_t m = (k * (1 << up) * sample.t_q30 >> 14) + ((int64_t)5 * 65536 << up);
                const uint32_t f = glint_msh_t(n, sample.t_q30);
                if (m >= 1 << 28 || f == 0)
                    continue;
                glint_use_msh.run(&paint, &sample, 1);
                assert_in_range(f - sample.f_q16, 0, glint_use_msh.slack);
            }
        }
    }
}

/* An albedo of 255 is 1.0: then nothing is cut off in RGB. */
static void a_white_albedo_leaves_the_coefficients_as_they_are(void **state)
{
    (void)state;
    for (int i = 0; i < 1000; i++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        struct glint_paint p;
        memset(look.material.albedo, 255, sizeof look.material.albedo);
        paint_of(&p, &look);
        const uint32_t half = look.output.dither
                                  ? 0
                                  : (uint32_t)1 << (p.of.exact.shift - 1); /* the threshold where all pixels have one */
        for (int k = 0; k < 3; k++) {
            assert_int_equal(p.of.exact.p[k], (look.material.ambient_q16[k] * 255 << (p.of.exact.shift - 16)) + half);
            assert_int_equal(p.of.exact.q[k], look.material.diffuse_q16[k] * 255 >> (32 - p.of.exact.shift));
        }
    }
}

static void draw_pixel(const struct look *look, struct glint_vec normal, uint8_t out[4])
{
    const struct glint_maps maps = {.normals = &normal};
    const struct glint_surface surface = {out, 4, 0, 0};
    assert_int_equal(draw_rect(look, &maps, 1, 1, &surface, NULL), GLINT_OK);
}

static struct look matt_from_above(enum glint_format format, enum glint_space space)
{
    struct look look;
    memset(&look, 0, sizeof look);
    set_model(&look, GLINT_MSH, 10, 6);
    assert_int_equal(look_light(&look, in_front, in_front), GLINT_OK);
    memset(look.material.albedo, 255, sizeof look.material.albedo);
    look.output.format = (uint8_t)format;
    look.output.space = (uint8_t)space;
    return look;
}

/* Sums that are exact in V, and a unit of V below a level: 2^-25 of one in RGB565, 2^-23 in 24 bits. */
static void a_pixel_a_unit_below_a_level_is_below_it(void **state)
{
    (void)state;
    static const struct {
        enum glint_format format;
        unsigned channel, max, shift;
    } cases[] = {{GLINT_RGB565, 0, 31, 25}, {GLINT_RGB565, 1, 63, 25}, {GLINT_RGB888, 2, 255, 23}};
    for (int i = 0; i < 3; i++) {
        const uint32_t max = cases[i].max, unit = UINT32_C(1) << (32 - cases[i].shift);
        uint32_t inverse = max; /* modulo 2^32 */
        for (int step = 0; step < 5; step++)
            inverse *= 2 - max * inverse;
        const uint32_t value = (0 - (UINT32_C(1) << 31) - unit) * inverse; /* value max + 2^31 = -unit modulo 2^32 */
        unsigned found = 0;
        for (int16_t z = 32767; z > 16384 && found < 100; z--) {
            const uint32_t nl = ((uint32_t)z * 32767 + 8192) >> 14;
            for (uint32_t d = unit; d < 40000; d += unit) { /* value = a 2^16 + d nl */
                const uint32_t left = value - d * nl, a = left >> 16;
                if (left & 0xffff || a > 25000 || value < d * nl)
                    continue;
                struct look look = matt_from_above(cases[i].format, GLINT_GAMMA);
                look.material.ambient_q16[cases[i].channel] = a;
                look.material.diffuse_q16[cases[i].channel] = d;
                uint8_t out[4] = {0};
                unsigned levels[3];
                draw_pixel(&look, (struct glint_vec){0, 0, z}, out);
                stored_levels(cases[i].format, out, 0, levels);
                assert_int_equal(levels[cases[i].channel], ((uint64_t)value * max + (UINT64_C(1) << 31)) >> 32);
                found++;
            }
        }
        assert_true(found > 10);
    }
}

/* Without N.L the light is the ambient part alone: every one of it, at every threshold. */
static void in_linear_space_a_dark_pixel_is_its_ambient_light_encoded(void **state)
{
    (void)state;
    static const uint8_t max[3] = {31, 63, 31};
    static const struct glint_vec below_it[16] = {{0, 0, -32767}};
    for (uint32_t ambient = 0; ambient <= 65536; ambient++) {
        struct look look = matt_from_above(ambient & 1 ? GLINT_RGB565_SWAPPED : GLINT_RGB565, GLINT_LINEAR);
        look.output.dither = ambient % 3 == 0;
        for (int k = 0; k < 3; k++)
            look.material.ambient_q16[k] = ambient;
        uint8_t out[32];
        const uint16_t y = (uint16_t)(ambient & 3);
        const struct glint_maps maps = {.normals = below_it};
        const struct glint_surface surface = {out, sizeof out, 0, y};
        assert_int_equal(draw_rect(&look, &maps, 4, 1, &surface, NULL), GLINT_OK);
        const uint64_t encoded = glint_srgb_encode((uint16_t)((65535 * (uint64_t)ambient + 32768) >> 16));
        for (unsigned x = 0; x < 4; x++) {
            const uint64_t weight = look.output.dither ? 2 * (uint64_t)bayer[4 * y + x] + 1 : 16;
            unsigned levels[3];
            stored_levels((enum glint_format)look.output.format, out, x, levels);
            for (int k = 0; k < 3; k++)
                assert_int_equal(levels[k], (32 * encoded * max[k] + 65535 * weight) / (32 * 65535));
        }
    }
}

/* Normals that are not of length 1 lead to a w of up to 5: its square takes more than 32 bits, but not to a highlight. */
static void phong_shows_nothing_where_the_mirrored_light_is_far(void **state)
{
    (void)state;
    struct look look = matt_from_above(GLINT_RGB888, GLINT_GAMMA);
    set_model(&look, GLINT_PHONG, 2, 16);
    for (int k = 0; k < 3; k++)
        look.material.specular_q16[k] = 65536;
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int16_t aside = -19700; aside < -18900; aside += 4) {
                /* L and N against V along the axis, V.L = -0.9: w is 1.9 there and 1.5 on the others, |w|^2 about 8 */
                int32_t l[3] = {0, 0, 0}, v[3];
                int16_t n[3];
                for (int k = 0; k < 3; k++) {
                    v[k] = k == axis ? sign * 29491 : 10092;
                    n[k] = k == axis ? (int16_t)(sign * -32767) : aside;
                }
                l[axis] = -sign;
                assert_int_equal(look_light(&look, l, v), GLINT_OK);
                uint8_t out[4];
                draw_pixel(&look, (struct glint_vec){n[0], n[1], n[2]}, out);
                assert_true(out[0] == 0 && out[1] == 0 && out[2] == 0);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(v_is_low_by_at_most_w_in_gamma_space_and_never_high),
        cmocka_unit_test(msh_is_low_by_at_most_its_slack_however_it_is_scaled),
        cmocka_unit_test(a_white_albedo_leaves_the_coefficients_as_they_are),
        cmocka_unit_test(a_pixel_a_unit_below_a_level_is_below_it),
        cmocka_unit_test(in_linear_space_a_dark_pixel_is_its_ambient_light_encoded),
        cmocka_unit_test(phong_shows_nothing_where_the_mirrored_light_is_far),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
