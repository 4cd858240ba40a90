/* SPDX-License-Identifier: MIT
 * What a prepared shader folds to: by how much V may be low is at most W. And pixels where a unit of V, or of t, would show. */
#include "shading.h"

#include "glint_lobe_msh_near.h"
#include "glint_pixel_prepared.h"

static const double luma[3] = {54 / 256., 183 / 256., 19 / 256.};

/* By how much V of all of a sample's levels may be low at the largest nl and F, in units of V. `part`: of a channel in a level. */
static double low_by(const struct glint_prepared *p, int k, double one, double part, double max, bool maps)
{
    const struct glint_material *m = &p->shader.material;
    const double a = clamped(m->ambient_q16[k]) / 65536., d = clamped(m->diffuse_q16[k]) / 65536.;
    const double unit = one * max * part, s = clamped(m->specular_q16[k]) / 65536., nl = 65536, f = 67109;
    const double shine = unit * s * (f + p->slack) / 65536 - (double)p->r[k] * f;
    if (!maps) {
        const double albedo = m->albedo[k] / 255.,
                     half = max < 64 && max > 1 && !p->shader.dither ? one / 2 : 0; /* RGB565 */
        return unit * albedo * a + half - p->p[k] + unit * albedo * d * nl / 65536 - (double)p->q[k] * nl + shine;
    }
    const double lit = floor(255 * (p->ambient[k] + (double)p->diffuse[k] * nl) / 128);
    const double high = f - 1 - 1. / 64; /* F gloss / 255 may be so low: glint_by_255 */
    return unit * (a + d) - lit + unit * s * (f + p->slack) / 65536 - (double)p->r[k] * high;
}

/* By how much V may be lower than V + W, in units of 2^(shift - 16); never more than 0. */
static double beyond(const struct glint_shader *shader, bool maps)
{
    static const double max_565[3] = {31, 63, 31};
    const enum glint_format format = (enum glint_format)shader->format;
    const bool grey = format == GLINT_GREY8 || format == GLINT_MONO;
    struct glint_prepared p;
    assert_int_equal(glint_shade_prepare(&p, shader), GLINT_OK);
    const double one = ldexp(1, (int)p.shift);
    double sum = 0, largest = 0;
    for (int k = 0; k < 3; k++) {
        const double max = format <= GLINT_RGB565_SWAPPED ? max_565[k] : format == GLINT_MONO ? 1 : 255;
        const double low = low_by(&p, k, one, grey ? luma[k] : 1, max, maps);
        sum += low;
        largest = low > largest ? low : largest;
    }
    return ((grey ? sum : largest) - (maps ? p.w_maps : p.w)) * 65536 / one;
}

static uint32_t any_size(void)
{
    return below(UINT32_C(1) << below(18));
}

/* From random materials uphill, to those of which the most is cut off. */
static void v_is_low_by_at_most_w_in_gamma_space(void **state)
{
    (void)state;
    double worst = -1e9;
    for (int i = 0; i < 200; i++) {
        const bool maps = i & 1;
        struct glint_shader best = random_shader(format_number(i / 2), GLINT_GAMMA);
        best.lobe.model = GLINT_MSH;
        double most = -1e9;
        for (int step = 0; step < 4000; step++) {
            struct glint_shader next = best;
            const unsigned k = below(3);
            switch (below(4)) {
            case 0:
                next.material.ambient_q16[k] = any_size();
                break;
            case 1:
                next.material.diffuse_q16[k] = any_size();
                break;
            case 2:
                next.material.specular_q16[k] = any_size();
                break;
            default:
                next.material.albedo[k] = (uint8_t)below(256);
            }
            const double found = beyond(&next, maps);
            if (found > 0)
                fail_msg("V + W is low by %.3f: format %u, maps %d", found, next.format, maps);
            if (found >= most) {
                most = found;
                best = next;
            }
        }
        worst = most > worst ? most : worst;
    }
    print_message("V + W is never low, and high by %.3f of 2^(shift - 16) at the least\n", -worst);
    assert_true(worst > -5); /* else the search has seen nothing */
}

/* f <= F <= f + slack, by how much ever E is shifted up, while m < 2^28: the fold chooses what is quickest. */
static void msh_is_low_by_at_most_its_slack_however_it_is_scaled(void **state)
{
    (void)state;
    for (uint32_t n = 1; n <= 1000; n++) {
        const int64_t k = 4 * (int64_t)n - 5;
        for (int up = 0; up < 9 && k * (1 << up) < 1 << 17; up++) {
            struct glint_near near = {.n = (uint16_t)n, .t_end = 1 << 30, .f_max = UINT32_MAX};
            near.k[GLINT_MSH_FACTOR] = (int32_t)(k * (1 << up));
            near.k[GLINT_MSH_ADDEND] = 5 * 65536 << up;
            near.k[GLINT_MSH_SHIFT] = 32 - 2 * up;
            for (int i = 0; i < 300; i++) {
                struct glint_sample sample = {below(UINT32_C(1) << below(31)), 65536, 0};
                const int64_t m = (k * (1 << up) * sample.t_q30 >> 14) + ((int64_t)5 * 65536 << up);
                const uint32_t f = glint_msh_t(n, sample.t_q30);
                if (m >= 1 << 28 || f == 0)
                    continue;
                glint_shade_msh.run(&near, &sample, 1);
                assert_in_range(f - sample.f_q16, 0, glint_shade_msh.slack);
            }
        }
    }
}

/* An albedo of 255 is 1.0: then nothing is cut off in RGB. */
static void a_white_albedo_leaves_the_coefficients_as_they_are(void **state)
{
    (void)state;
    for (int i = 0; i < 1000; i++) {
        struct glint_shader shader = random_shader(GLINT_RGB888, GLINT_GAMMA);
        struct glint_prepared p;
        memset(shader.material.albedo, 255, sizeof shader.material.albedo);
        assert_int_equal(glint_shade_prepare(&p, &shader), GLINT_OK);
        const uint32_t half =
            shader.dither ? 0 : (uint32_t)1 << (p.shift - 1); /* the threshold where all pixels have one */
        for (int k = 0; k < 3; k++) {
            assert_int_equal(p.p[k], (shader.material.ambient_q16[k] * 255 << (p.shift - 16)) + half);
            assert_int_equal(p.q[k], shader.material.diffuse_q16[k] * 255 >> (32 - p.shift));
        }
    }
}

static void shade_pixel(const struct glint_shader *shader, struct glint_vec normal, uint8_t out[4])
{
    const struct glint_source source = {.normals = &normal, .normals_stride = sizeof normal};
    const struct glint_surface surface = {out, 4, 0, 0};
    assert_int_equal(glint_shade_rect(shader, &source, 1, 1, &surface, NULL), GLINT_OK);
}

static struct glint_shader matt_from_above(enum glint_format format, enum glint_space space)
{
    struct glint_shader shader;
    memset(&shader, 0, sizeof shader);
    glint_lobe_init(&shader.lobe, GLINT_MSH, 10, 6);
    const int32_t above[3] = {0, 0, 1};
    assert_int_equal(glint_light_init(&shader.light, above, above), GLINT_OK);
    memset(shader.material.albedo, 255, sizeof shader.material.albedo);
    shader.format = (uint8_t)format;
    shader.space = (uint8_t)space;
    return shader;
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
                struct glint_shader shader = matt_from_above(cases[i].format, GLINT_GAMMA);
                shader.material.ambient_q16[cases[i].channel] = a;
                shader.material.diffuse_q16[cases[i].channel] = d;
                uint8_t out[4] = {0};
                unsigned levels[3];
                shade_pixel(&shader, (struct glint_vec){0, 0, z}, out);
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
        struct glint_shader shader = matt_from_above(ambient & 1 ? GLINT_RGB565_SWAPPED : GLINT_RGB565, GLINT_LINEAR);
        shader.dither = ambient % 3 == 0;
        for (int k = 0; k < 3; k++)
            shader.material.ambient_q16[k] = ambient;
        uint8_t out[32];
        const uint16_t y = (uint16_t)(ambient & 3);
        const struct glint_source source = {.normals = below_it};
        const struct glint_surface surface = {out, sizeof out, 0, y};
        assert_int_equal(glint_shade_rect(&shader, &source, 4, 1, &surface, NULL), GLINT_OK);
        const uint64_t encoded = glint_srgb_encode((uint16_t)((65535 * (uint64_t)ambient + 32768) >> 16));
        for (unsigned x = 0; x < 4; x++) {
            const uint64_t weight = shader.dither ? 2 * (uint64_t)bayer[4 * y + x] + 1 : 16;
            unsigned levels[3];
            stored_levels((enum glint_format)shader.format, out, x, levels);
            for (int k = 0; k < 3; k++)
                assert_int_equal(levels[k], (32 * encoded * max[k] + 65535 * weight) / (32 * 65535));
        }
    }
}

/* Normals that are not of length 1 lead to a w of up to 5: its square takes more than 32 bits, but not to a highlight. */
static void phong_shows_nothing_where_the_mirrored_light_is_far(void **state)
{
    (void)state;
    struct glint_shader shader = matt_from_above(GLINT_RGB888, GLINT_GAMMA);
    glint_lobe_init(&shader.lobe, GLINT_PHONG, 2, 16);
    for (int k = 0; k < 3; k++)
        shader.material.specular_q16[k] = 65536;
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int16_t aside = -19700; aside < -18900; aside += 4) {
                /* L and N against V along the axis, V.L = -0.9: w is 1.9 there and 1.5 on the others, |w|^2 about 8 */
                int16_t l[3] = {0, 0, 0}, v[3], n[3];
                for (int k = 0; k < 3; k++) {
                    v[k] = (int16_t)(k == axis ? sign * 29491 : 10092);
                    n[k] = k == axis ? (int16_t)(sign * -32767) : aside;
                }
                l[axis] = n[axis];
                shader.light.l = (struct glint_vec){l[0], l[1], l[2]};
                shader.light.v = (struct glint_vec){v[0], v[1], v[2]};
                uint8_t out[4];
                shade_pixel(&shader, (struct glint_vec){n[0], n[1], n[2]}, out);
                assert_true(out[0] == 0 && out[1] == 0 && out[2] == 0);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(v_is_low_by_at_most_w_in_gamma_space),
        cmocka_unit_test(msh_is_low_by_at_most_its_slack_however_it_is_scaled),
        cmocka_unit_test(a_white_albedo_leaves_the_coefficients_as_they_are),
        cmocka_unit_test(a_pixel_a_unit_below_a_level_is_below_it),
        cmocka_unit_test(in_linear_space_a_dark_pixel_is_its_ambient_light_encoded),
        cmocka_unit_test(phong_shows_nothing_where_the_mirrored_light_is_far),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
