/* SPDX-License-Identifier: MIT
 * The files under test are included to reach what is static. GLINT_FAULT, BOUND-NAME or half-NAME: bounds that are 0 or halved, and with
 * -DNEAR_FAULTS=1 what else is wrong, for test_bounds to find. */
#include "near.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "glint_math.h"

static bool fault_is(const char *name)
{
    const char *fault = getenv("GLINT_FAULT");
    return fault && !strcmp(fault, name);
}

/* Faults in what the lobes call: all that they read of flash and multiply to 64 bits goes through these. */
#ifndef NEAR_FAULTS
#define NEAR_FAULTS 0
#endif
#if NEAR_FAULTS
static const uint32_t *wrong_constant;
static bool carry_is_lost;

static uint32_t constant_with_fault(const uint32_t *at)
{
    return at == wrong_constant ? *at + 1000 : *at;
}

static uint64_t multiply_with_fault(uint32_t a, uint32_t b)
{
    return carry_is_lost ? (uint64_t)glint_mulhi_near(a, b) << 32 | a * b : glint_multiply(a, b);
}
#undef GLINT_FLASH_U32
#define GLINT_FLASH_U32(value) constant_with_fault(&(value))
#define glint_multiply(a, b) multiply_with_fault(a, b)
#endif

#include "../../lib/lobe_blinn.c"
#include "../../lib/lobe_cayley.c"
#include "../../lib/lobe_gauss.c"
#include "../../lib/lobe_ggx.c"
#include "../../lib/lobe_schlick.c"
#include "../../lib/lobe_sg.c"
#include "chosen.h"
#include "wide.h"

enum { N = 1000 };

/* What is stated, unless GLINT_FAULT is its name: then 0, or with "half-" before it half of that. */
static double bound(const char *name, double stated)
{
    const char *fault = getenv("GLINT_FAULT");
    const bool halves = fault && !strncmp(fault, "half-", 5);
    return !fault || strcmp(fault + (halves ? 5 : 0), name) ? stated : halves ? stated / 2 : 0;
}

/* gauss_near_t without the room below 2^20: its sum wraps. */
static uint32_t gauss_near_wraps(uint32_t n, uint32_t t)
{
    const uint32_t whole = n * (t >> 14);
    if (whole >> 20)
        return 0;
    const uint32_t x = glint_mulhi_near((whole << 12) + (n * (t & 0x3fff) >> 2), gauss_exponent(t));
    return glint_exp2_near(x & 0x7ffffff) >> 4 >> (x >> 27);
}

#if NEAR_FAULTS
__attribute__((constructor)) static void make_faults(void)
{
    wrong_constant = fault_is("coefficient") ? &gauss_exponents[3] : NULL;
    carry_is_lost = fault_is("carry");
}
#endif

static uint64_t mix(uint64_t x) /* splitmix64 */
{
    x += UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

/* 0 < t < 1: a third uniform, a third uniform in the logarithm, a third where n t < 16. */
static uint32_t random_t(uint32_t n, uint32_t i)
{
    const uint64_t r = mix((uint64_t)n << 32 | i);
    uint32_t t = (uint32_t)(r >> 34);
    if (i % 3 == 1)
        t >>= (r & 31) * 28 / 31;
    else if (i % 3 == 2 && n > 16)
        t = (uint32_t)((uint64_t)t * 16 / n);
    return t ? t : 1;
}

/* What was met of an error, beside what is stated. */
struct range {
    double low, high;
};
static struct range met(struct range a, double low, double high)
{
    return (struct range){low < a.low ? low : a.low, high > a.high ? high : a.high};
}
#pragma omp declare reduction(hull                                                                                     \
                              : struct range                                                                           \
                              : omp_out = met(omp_out, omp_in.low, omp_in.high))                                       \
    initializer(omp_priv = (struct range){0, 0})

/* An error below a sixteenth of what is stated would be of a check that has seen nothing. */
static void check_range(const char *what, struct range found, double low, double high)
{
    printf("# %s: met %.2f .. %.2f, stated %.1f .. %.1f\n", what, found.low, found.high, low, high);
    assert_true(found.low > low && found.high < high);
    assert_true(found.low < low / 16 || found.high > high / 16);
}

enum { COUNT = 256 };
/* 2^32 times the errors of upper halves, which integers hold exactly; and how many whole products are wrong. */
struct errors {
    int64_t low, high, square_low, square_high, wrong;
};
WIDE static struct errors errors_of_products(const uint32_t *a, const uint32_t *b) /* and of the squares of a */
{
    struct errors e = {0, 0, 0, 0, 0};
    for (int i = 0; i < COUNT; i++) {
        const uint64_t product = (uint64_t)a[i] * b[i], square = (uint64_t)a[i] * a[i];
        const int64_t error = (int64_t)(((uint64_t)glint_mulhi_near(a[i], b[i]) << 32) - product);
        const int64_t of_square = (int64_t)(((uint64_t)glint_squarehi_near(a[i]) << 32) - square);
        e.low = error < e.low ? error : e.low;
        e.high = error > e.high ? error : e.high;
        e.square_low = of_square < e.square_low ? of_square : e.square_low;
        e.square_high = of_square > e.square_high ? of_square : e.square_high;
        e.wrong += glint_multiply(a[i], b[i]) != product;
    }
    return e;
}

/* The lower halves decide what is cut: all of them beside the largest upper halves, and mixed words. */
void check_products(uint32_t step)
{
    struct range product = {0, 0}, square = {0, 0};
    int64_t wrong = 0;
#pragma omp parallel for reduction(hull : product, square) reduction(+ : wrong)
    for (uint64_t first = 0; first < (uint64_t)1 << 32; first += COUNT * (uint64_t)step) {
        uint32_t a[3][COUNT], b[3][COUNT];
        for (uint32_t k = 0; k < COUNT; k++) {
            const uint64_t i = first + (uint64_t)step * k, r = mix(i);
            a[0][k] = (uint32_t)(i >> 16) | 0xffff0000;
            b[0][k] = (uint32_t)i | 0xffff0000;
            a[1][k] = (uint32_t)r;
            a[2][k] = (uint32_t)i;
            b[1][k] = b[2][k] = (uint32_t)(r >> 32);
        }
        for (int k = 0; k < 3; k++) {
            const struct errors e = errors_of_products(a[k], b[k]);
            product = met(product, (double)e.low * 0x1p-32, (double)e.high * 0x1p-32);
            square = met(square, (double)e.square_low * 0x1p-32, (double)e.square_high * 0x1p-32);
            wrong += e.wrong;
        }
    }
    check_range("upper half of a product", product, -3, 0x1p-20);
    check_range("upper half of a square", square, -2, 0x1p-20);
    assert_int_equal(wrong, 0);
}

void check_reciprocal(uint32_t step)
{
    struct range found = {0, 0};
    uint32_t largest = 0;
#pragma omp parallel for reduction(hull : found) reduction(max : largest)
    for (uint32_t m = UINT32_C(1) << 27; m < UINT32_C(1) << 28; m += step) {
        const double y = glint_reciprocal(m), d = (y * m - 0x1p58) * 0x1p-28; /* 2^30 d; the product is exact enough */
        found = met(found, d, d + y * 0x1p-28);
        largest = largest > (uint32_t)y ? largest : (uint32_t)y;
    }
    check_range("reciprocal, 2^-30", found, -16.1, 16.4);
    assert_true(largest <= (UINT32_C(1) << 31) + 15);
}

/* b = log2(e) (2 asin^2 sqrt(t/2)) / t: without the cancellation of acos(1 - t). */
static double exponent_of(uint32_t t)
{
    const double a = asin(sqrt(t * 0x1p-31));
    return 2 * a * a / (t * 0x1p-30) / M_LN2;
}

/* The exponents of 256 t, beside 1 / b on the line between both ends. b = log2(e) sum 2^k t^(k-1) / (k^2 binomial(2k, k)), k >= 1,
 * has positive coefficients only: on 0..1 it is 1.44 .. 1.78, b' < 0.49, 0 < b'' < 0.48. So (1 / b)'' = 2 b'^2 / b^3 - b'' / b^2
 * is between -1/4 and 1/4, and the line over h = 2^-22 is off by less than h^2 / 8 / 4 = 2^-49, relative to 1 / b < 2^-48. Doubles
 * add less than 2^-48 to that: d is good to 2^-19. */
WIDE static struct range errors_of_exponents(uint32_t first)
{
    const double from = first ? 1 / exponent_of(first) : M_LN2, to = 1 / exponent_of(first + 256);
    uint32_t b[256];
    for (uint32_t i = 0; i < 256; i++)
        b[i] = gauss_exponent(first + i);
    struct range found = {0, 0};
    for (uint32_t i = 0; i < 256; i++) {
        const double d = (b[i] * 0x1p-31 * (from + (to - from) * 0x1p-8 * i) - 1) * 0x1p28;
        found.low = d < found.low ? d : found.low;
        found.high = d > found.high ? d : found.high;
    }
    return (struct range){found.low - 0x1p-19, found.high + 0x1p-19};
}

void check_gauss_exponent(uint32_t step)
{
    struct range found = {0, 0};
#pragma omp parallel for reduction(hull : found)
    for (uint32_t first = 0; first < GLINT_T_ONE; first += 256 * step) {
        const struct range errors = errors_of_exponents(first);
        found = met(found, errors.low, errors.high);
    }
    check_range("exponent of Gauss, 2^-28", found, -14, 13);
}

void check_exp2(uint32_t step)
{
    struct range found = {0, 0};
#pragma omp parallel for reduction(hull : found)
    for (uint32_t x = 0; x < UINT32_C(1) << 27; x += step) {
        const double d = glint_exp2_near(x) - exp2(32 - x * 0x1p-27);
        found = met(found, d, d);
    }
    check_range("power of two, 2^-32", found, -32, 20);
}

/* Where 2^-32 glint_power lies above glint_power_near, in parts of what is stated for that n. */
void check_power(uint32_t per_n)
{
    const double part = bound("power-low", 1);
    double most = 0;
    long wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(max : most) reduction(+ : wrong)
    for (uint32_t n = 1; n <= N; n++)
        for (uint32_t i = 0; i < per_n; i++) {
            const uint32_t x = i % 8 ? (GLINT_T_ONE - random_t(n, i)) << 2 : (uint32_t)mix(i); /* any x will do */
            const uint32_t near = glint_power_near(x, n), power = (uint32_t)(glint_power((uint64_t)x << 32, n) >> 32);
            wrong += power < near || power - near > part * GLINT_POWER_LOW(n);
            most = fmax(most, (double)(power - near) / GLINT_POWER_LOW(n));
        }
    printf("# power, of 3n - 2: met 0 .. %.2f, %ld beyond\n", most, wrong);
    assert_int_equal(wrong, 0);
    assert_true(most > 0.1);
}

static double cayley(uint32_t n, double t) /* p and s are exact in double */
{
    const double r = (0x1p33 - (n + 4) * t) / (0x1p33 + (n - 4.0) * t);
    return r > 0 ? r * r * (r * r) : 0;
}

static double schlick(uint32_t n, double t)
{
    return (0x1p30 - t) / (0x1p30 + (n - 1) * t);
}

static double gauss(uint32_t n, double t)
{
    return exp2(-(n * (t * 0x1p-30) * exponent_of((uint32_t)t)));
}

static double ggx(uint32_t n, double t)
{
    const double x = t * 0x1p-30, e = 1 + n * x * (2 - x) / 2;
    return 1 / (e * e);
}

static double sg(uint32_t n, double t)
{
    return exp(-(n * t * 0x1p-30));
}

static struct range error_of(uint32_t (*near)(uint32_t n, uint32_t t), double (*real)(uint32_t n, double t),
                             uint32_t from_n, uint32_t per_n)
{
    struct range found = {0, 0};
#pragma omp parallel for schedule(dynamic) reduction(hull : found)
    for (uint32_t n = from_n; n <= N; n++)
        for (uint32_t i = 0; i < per_n; i++) {
            const uint32_t t = random_t(n, i);
            const double f = near(n, t), error = f - 0x1p28 * real(n, t);
            if (f > 0 || error <= -31) /* so small an F may count as 0 */
                found = met(found, error, error);
        }
    return found;
}

void check_cayley(uint32_t per_n)
{
    check_range("cayley, 2^-28", error_of(cayley_near_t, cayley, 5, per_n), -bound("cayley-low", CAYLEY_LOW),
                bound("cayley-high", CAYLEY_HIGH));
}

void check_schlick(uint32_t per_n)
{
    check_range("schlick, 2^-28", error_of(schlick_near_t, schlick, 1, per_n), -bound("schlick-low", SCHLICK_LOW),
                bound("schlick-high", SCHLICK_HIGH));
}

void check_gauss(uint32_t per_n)
{
    check_range("gauss, 2^-28", error_of(fault_is("wraps") ? gauss_near_wraps : gauss_near_t, gauss, 1, per_n),
                -bound("gauss-low", GAUSS_LOW), bound("gauss-high", GAUSS_HIGH));
}

/* What is stated from above depends on n: a part of it. */
void check_ggx(uint32_t per_n)
{
    const double low = bound("ggx-low", 1), high = bound("ggx-high", 1);
    struct range found = {0, 0};
#pragma omp parallel for schedule(dynamic) reduction(hull : found)
    for (uint32_t n = 1; n <= N; n++)
        for (uint32_t i = 0; i <= per_n; i++) {
            const uint32_t t = i ? random_t(n, i) : GLINT_T_ONE;
            const double error = ggx_near_t(n, t) - 0x1p28 * ggx(n, t);
            found = met(found, error / GGX_LOW, error / ggx_high(n));
        }
    check_range("ggx, of what is stated", found, -low, high);
}

void check_sg(uint32_t per_n)
{
    check_range("sg, 2^-28", error_of(sg_near_t, sg, 1, per_n), -bound("sg-low", SG_LOW), bound("sg-high", SG_HIGH));
}

/* ---- values ---- */

static bool blinn_is_simple(uint32_t n, uint32_t t, uint32_t f)
{
    return f == glint_power_round(blinn_power(n, t));
}

static bool gauss_is_simple(uint32_t n, uint32_t t, uint32_t f)
{
    return f == glint_power_round(gauss_power(n, t));
}

static bool sg_is_simple(uint32_t n, uint32_t t, uint32_t f)
{
    return f == glint_power_round(sg_power(n, t));
}

static bool schlick_is_simple(uint32_t n, uint32_t t, uint32_t f)
{
    const uint64_t d = GLINT_T_ONE + (uint64_t)(n - 1) * t;
    return f == (((uint64_t)(GLINT_T_ONE - t) << 17) + d) / (2 * d);
}

/* Both comparisons of the fallback, wherever t lies; the oracle of test_eval_t.c decides beside them. */
static bool cayley_is_simple(uint32_t n, uint32_t t, uint32_t f)
{
    if (n <= 4)
        return blinn_is_simple(n, t, f);
    if ((uint64_t)(n + 4) * t >> 33)
        return f == 0;
    return (f == 0 || cayley_at_least(n, t, 2 * f - 1)) && !cayley_at_least(n, t, 2 * f + 1);
}

static bool ggx_is_simple(uint32_t n, uint32_t t, uint32_t f)
{
    return (f == 0 || ggx_at_least(n, t, 2 * f - 1)) && !ggx_at_least(n, t, 2 * f + 1);
}

static bool blinn_is_open(uint32_t n, uint32_t t)
{
    const uint32_t low = (glint_power_near((GLINT_T_ONE - t) << 2, n) >> 1) + 16384;
    return (low ^ (low + (GLINT_POWER_LOW(n) + 1) / 2)) >> 15 != 0;
}

static bool open_between(uint32_t f, uint32_t low, uint32_t high)
{
    return (f + 2048 - high) >> 12 != (f + 2048 + low) >> 12;
}

static bool gauss_is_open(uint32_t n, uint32_t t)
{
    return open_between(gauss_near_t(n, t), GAUSS_LOW, GAUSS_HIGH);
}

static bool schlick_is_open(uint32_t n, uint32_t t)
{
    return open_between(schlick_near_t(n, t), SCHLICK_LOW, SCHLICK_HIGH);
}

static bool cayley_is_open(uint32_t n, uint32_t t)
{
    return n > 4 ? open_between(cayley_near_t(n, t), CAYLEY_LOW, CAYLEY_HIGH) : blinn_is_open(n, t);
}

static bool ggx_is_open(uint32_t n, uint32_t t)
{
    return open_between(ggx_near_t(n, t), GGX_LOW, ggx_high(n));
}

static bool sg_is_open(uint32_t n, uint32_t t)
{
    return open_between(sg_near_t(n, t), SG_LOW, SG_HIGH);
}

static const struct model {
    const char *name;
    uint32_t (*value)(uint32_t n, uint32_t t);
    bool (*is_simple)(uint32_t n, uint32_t t, uint32_t f), (*is_open)(uint32_t n, uint32_t t);
} models[] = {
    {"cayley", glint_cayley_t, cayley_is_simple, cayley_is_open},
    {"schlick", glint_schlick_t, schlick_is_simple, schlick_is_open},
    {"blinn", glint_blinn_t, blinn_is_simple, blinn_is_open},
    {"gauss", glint_gauss_t, gauss_is_simple, gauss_is_open},
    {"ggx", glint_ggx_t, ggx_is_simple, ggx_is_open},
    {"sg", glint_sg_t, sg_is_simple, sg_is_open},
};

struct counts {
    long wrong, open, highlight, open_60, highlight_60;
};
static void add(struct counts *sum, const struct counts *a)
{
    sum->wrong += a->wrong;
    sum->open += a->open;
    sum->highlight += a->highlight;
    sum->open_60 += a->open_60;
    sum->highlight_60 += a->highlight_60;
}

/* Two places for each draw: a random t, and, of a random value f, the last t with F >= f: there the rounding is nearest to a
 * tie, and the bound must not decide. */
static void count(struct counts *counts, const struct model *model, uint32_t n, uint32_t i)
{
    const uint32_t t = random_t(n, i), f = model->value(n, t);
    counts->wrong += !model->is_simple(n, t, f);
    if (f >= 256) { /* q = 8 */
        const bool open = model->is_open(n, t);
        counts->highlight++;
        counts->open += open;
        counts->highlight_60 += n == 60;
        counts->open_60 += n == 60 && open;
    }
    if (f == 0 || i % 4)
        return;
    uint32_t last = t;
    for (uint32_t bit = GLINT_T_ONE / 2; bit; bit >>= 1)
        if (last + bit < GLINT_T_ONE && model->value(n, last + bit) >= f)
            last += bit;
    for (uint32_t k = 0; k < 2 && last + k < GLINT_T_ONE; k++)
        counts->wrong += !model->is_simple(n, last + k, model->value(n, last + k));
}

void check_values(uint32_t per_n)
{
    for (size_t k = 0; k < sizeof models / sizeof *models; k++) {
        if (only_model() >= 0 && strcmp(models[k].name, model_functions[only_model()]))
            continue;
        struct counts counts = {0, 0, 0, 0, 0};
#pragma omp parallel for schedule(dynamic)
        for (uint32_t n = 1; n <= N; n++) {
            struct counts of_n = {0, 0, 0, 0, 0};
            for (uint32_t i = 0; i < per_n * (n == 60 ? 50 : 1); i++)
                count(&of_n, &models[k], n, i);
#pragma omp critical
            add(&counts, &of_n);
        }
        printf("# %s: %ld wrong; of %ld values >= 2^-8, %.2f %% fall back, at n = 60 %.2f %%\n", models[k].name,
               counts.wrong, counts.highlight, 100.0 * (double)counts.open / (double)counts.highlight,
               100.0 * (double)counts.open_60 / (double)counts.highlight_60);
        assert_int_equal(counts.wrong, 0);
    }
}
