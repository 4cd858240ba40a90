/* SPDX-License-Identifier: MIT
 * What Eva leaves open and is finite, run whole; built with -fsanitize=undefined, which ends it at the first overflow, index or
 * shift that C does not define. */

/* Their static functions, too: the sources under names of their own. */
#define glint_grain_sines finite_grain_sines
#define glint_grain_sample finite_grain_sample
#define glint_grain_sample_sine finite_grain_sample_sine
#define glint_use_mesh_grain finite_use_mesh_grain
#define glint_grain_begin finite_grain_begin
#define glint_grain_f finite_grain_f
#define glint_grain_exactly finite_grain_exactly
#define glint_grain_edge finite_grain_edge
#define glint_grain_draw finite_grain_draw
#define glint_grain_check finite_grain_check
#define glint_grain_light finite_grain_light

/* Loops of C for RISC-V, which any computer compiles. */
#define GLINT_RISCV 1
#define glint_colour_int8 finite_colour_int8

#include <stdio.h>

#include "glint.h"
#include "glint_lobe.h"
#include "glint_math.h"
#include "glint_mesh_triangle.h"

#define glint_unit_q30 finite_unit_q30
#define glint_vec_of_q30 finite_vec_of_q30
#define glint_vec_normalize finite_vec_normalize
#define glint_half_q30 finite_half_q30
#define glint_unit_near finite_unit_near
#define glint_unit_front finite_unit_front
#include "math_vector.c"
#define glint_use_msh finite_use_msh
#define glint_msh finite_msh
#define glint_msh_t finite_msh_t
#define glint_msh_cutoff finite_msh_cutoff
#define glint_msh_cutoff_t finite_msh_cutoff_t
#define glint_use_msh_grain finite_use_msh_grain
extern const struct glint_use_model glint_use_msh, glint_use_msh_grain;
#include "lobe_msh.c"
#include "grain.c"
#include "fused_riscv.c"

/* A product in MSH's quotient grows with u, so that the largest u stands for all. */
static uint32_t mantissas(void)
{
    uint32_t sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (uint32_t m = (uint32_t)1 << 27; m < (uint32_t)1 << 28; m++)
        sum += glint_reciprocal(m) + msh_quotient((uint32_t)1 << 24, m);
    return sum;
}

static uint32_t cosines(void)
{
    uint32_t sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (uint32_t n = 1; n <= GLINT_N_MAX; n++)
        for (int32_t c = 0; c <= 65536; c++)
            sum += glint_msh(n, c) + glint_cayley(n, c);
    return sum;
}

static uint32_t bytes(void)
{
    uint32_t sum = 0;
    for (uint32_t v = 0; v < 65536; v++)
        sum += glint_srgb_encode((uint16_t)v) + glint_srgb_decode((uint8_t)v);
    return sum;
}

/* r of every a: more than 2 above 2^46 / sqrt(a)? */
static uint32_t inverses(void)
{
    uint32_t beyond = 0;
#pragma omp parallel for reduction(+ : beyond)
    for (uint32_t i = 0; i < UINT32_C(3) << 14; i++)
        for (uint32_t low = 0; low < 65536; low++) {
            const uint32_t a = ((i + (1 << 14)) << 16) + low, r = unit_inverse(a) - 2;
            beyond += (unsigned __int128)r * r * a > (unsigned __int128)1 << 92;
        }
    return beyond;
}

/* Is a mesh's inverse 2^15..2^16, 2^16 for a power of two, and the reciprocal that it is cut from 2^30..2^31 + 15? */
static uint32_t mesh_inverses(void)
{
    uint32_t beyond = glint_mesh_inverse((uint32_t)1 << 27) != 65536;
#pragma omp parallel for reduction(+ : beyond)
    for (uint32_t m = (uint32_t)1 << 27; m < (uint32_t)1 << 28; m++) {
        const uint32_t inverse = glint_mesh_inverse(m), whole = glint_reciprocal(m);
        beyond += inverse < 32768 || inverse > 65536 || whole < (uint32_t)1 << 30 || whole > ((uint32_t)1 << 31) + 15;
    }
    return beyond;
}

static void fold(struct glint_paint *paint, uint32_t n, uint32_t t_end)
{
    paint->of.exact.t_end = t_end;
    paint->of.exact.f_max = UINT32_MAX;
    paint->of.exact.n = n;
    msh_fold(paint);
}

/* The same by the loop for RISC-V, whose m, and so its index, is the other's. */
static uint32_t riscv_of(struct glint_paint *paint, uint32_t t)
{
    struct glint_line_loop loop;
    paint->model = &glint_use_msh;
    paint->output.format = GLINT_RGB565;
    paint->output.dither = false;
    paint->of.exact.shift = GLINT_LINE_SHIFT;
    if (!glint_line_begin(&loop, paint, false))
        return 0;
    if (riscv_high(t << loop.up, loop.factor) + loop.addend !=
        msh_m(paint->of.exact.k[GLINT_MSH_FACTOR], paint->of.exact.k[GLINT_MSH_ADDEND], t))
        __builtin_trap();
    return riscv_msh(&loop, t);
}

/* MSH from below with every n: as the shift grows with 1 - t_end, of each shift the first and last t_end; as m grows with t, 0,
 * t_end - 1, and t whose lower 14 bits are greatest or least beside them. m outside 2^27 .. 2^28 would be an index beyond the table. */
static uint32_t below_of(uint32_t n, uint32_t t_end)
{
    struct glint_paint paint;
    fold(&paint, n, t_end);
    uint32_t sum = 0;
    const uint32_t last = t_end - 1, ts[] = {0, 1, 0x3fff, last & ~UINT32_C(0x3fff), (last | 0x3fff) - 0x4000, last};
    for (unsigned i = 0; i < sizeof ts / sizeof *ts; i++)
        if (ts[i] < t_end)
            sum += msh_near(&paint, ts[i]) + riscv_of(&paint, ts[i]);
    return sum;
}

static int32_t shift_of(uint32_t n, uint32_t t_end)
{
    struct glint_paint paint;
    fold(&paint, n, t_end);
    return paint.of.exact.k[GLINT_MSH_SHIFT];
}

static uint32_t below(void)
{
    uint32_t sum = 0;
    for (uint32_t n = 1; n <= GLINT_N_MAX; n++) {
        uint32_t end = 0; /* the last t_end: F > 0 before it */
        for (uint32_t bit = GLINT_T_ONE; bit; bit >>= 1)
            if (end + bit <= GLINT_T_ONE && glint_msh_t(n, end + bit))
                end += bit;
        end++;
        for (uint32_t first = 1; first <= end;) { /* to the last t_end with this shift */
            uint32_t at = first;
            for (uint32_t bit = GLINT_T_ONE; bit; bit >>= 1)
                if (at + bit <= end && shift_of(n, at + bit) == shift_of(n, first))
                    at += bit;
            sum += below_of(n, first) + below_of(n, at);
            first = at + 1;
        }
    }
    return sum;
}

/* Grain's divisor: all that differ. */
static uint32_t divisors(void)
{
    uint32_t sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (uint32_t d = 0; d <= (uint32_t)1 << 28; d++)
        sum += grain_half_square(GLINT_T_ONE - 1, d, d);
    return sum;
}

int main(void)
{
    const uint32_t sums[] = {mantissas(), cosines(), bytes(), below(), divisors()}, beyond = inverses(),
                   outside = mesh_inverses();
    printf("%s 1 - no inverse of a root is high by more than 2\n", beyond ? "not ok" : "ok");
    printf("%s 2 - a mesh's inverses are 2^15 to 2^16, and their reciprocals 2^30 to 2^31 + 15\n",
           outside ? "not ok" : "ok");
    printf("ok 3 - what Eva leaves open and is finite has no undefined behaviour: sums %u %u %u %u %u\n1..3\n",
           (unsigned)sums[0], (unsigned)sums[1], (unsigned)sums[2], (unsigned)sums[3], (unsigned)sums[4]);
    return beyond || outside;
}
