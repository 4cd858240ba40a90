/* SPDX-License-Identifier: MIT
 * The core as a function, for each argument there is, beside the library. flat() has the gates that yosys makes of the
 * Verilog, without the registers (test_flat shows that they only delay); a wire is a word of 256 lanes, a lane a cosine. */
#include <stdio.h>
#include <string.h>

#include "glint.h"

typedef uint64_t word __attribute__((vector_size(32)));
#include FLAT

enum { LANES = 256, GROUPS = LANES / 32, N_BITS = 10, C_MIN_BITS = 17, C_BITS = 18, F_BITS = 17 };

/* rows[i] bit j and rows[j] bit i change places, by halves, quarters, ... */
static void transpose(uint32_t rows[32])
{
    uint32_t mask = 0x0000ffff;
    for (unsigned j = 16; j; j >>= 1, mask ^= mask << j)
        for (unsigned k = 0; k < 32; k = ((k | j) + 1) & ~j) {
            const uint32_t t = ((rows[k] >> j) ^ rows[k | j]) & mask;
            rows[k] ^= t << j;
            rows[k | j] ^= t;
        }
}

/* Bit i of every value, in lanes. */
static void in_lanes(word *planes, unsigned bits, const uint32_t values[LANES])
{
    union {
        word whole;
        uint32_t parts[GROUPS];
    } plane[32];
    for (unsigned group = 0; group < GROUPS; group++) {
        uint32_t rows[32];
        memcpy(rows, values + 32 * group, sizeof rows);
        transpose(rows);
        for (unsigned i = 0; i < bits; i++)
            plane[i].parts[group] = rows[i];
    }
    for (unsigned i = 0; i < bits; i++)
        planes[i] = plane[i].whole;
}

static bool differs(const word *a, const word *b, unsigned bits)
{
    word any = {0};
    for (unsigned i = 0; i < bits; i++)
        any |= a[i] ^ b[i];
    return any[0] || any[1] || any[2] || any[3];
}

/* All cosines of 18 bits. Below 0 and above 1 the library clamps, too; below the cutoff F is 0. */
static bool every_cosine(enum glint_model model, uint32_t n, int32_t c_min)
{
    word in[INPUTS], out[OUTPUTS];
    const word zero = {0}, one = ~zero;
    word *const n_planes = in + 1, *const c_min_planes = n_planes + N_BITS, *const c_planes = c_min_planes + C_MIN_BITS;
    in[0] = model == GLINT_SCHLICK ? one : zero;
    for (unsigned i = 0; i < N_BITS; i++)
        n_planes[i] = n >> i & 1 ? one : zero;
    for (unsigned i = 0; i < C_MIN_BITS; i++)
        c_min_planes[i] = c_min >> i & 1 ? one : zero;
    for (int32_t from = -(1 << 17); from < 1 << 17; from += LANES) {
        uint32_t c[LANES], f[LANES];
        for (int32_t i = 0; i < LANES; i++) {
            const int32_t at = from + i;
            c[i] = (uint32_t)at;
            f[i] = at < c_min ? 0 : model == GLINT_SCHLICK ? glint_schlick(n, at) : glint_msh(n, at);
        }
        word wanted[F_BITS];
        in_lanes(c_planes, C_BITS, c);
        in_lanes(wanted, F_BITS, f);
        flat(in, out);
        if (differs(out, wanted, F_BITS)) {
            printf("# n = %u, c_min = %d: a cosine of %d to %d has another F\n", (unsigned)n, (int)c_min, (int)from,
                   (int)from + LANES - 1);
            return false;
        }
    }
    return true;
}

/* The cutoff is compared with c and nothing else: each bit of it, and values beside. */
static bool cutoffs(void)
{
    bool good = true;
    for (unsigned i = 0; i <= 16 && good; i++)
        for (int32_t beside = -1; beside <= 1 && good; beside++)
            good = every_cosine(i & 1 ? GLINT_SCHLICK : GLINT_MSH, 1 + 40 * i, (1 << i) + beside);
    return good && every_cosine(GLINT_MSH, 60, (1 << 17) - 1);
}

static void result(int number, const char *sentence, bool good)
{
    printf("%sok %d - %s\n", good ? "" : "not ", number, sentence);
}

int main(int argc, char **argv)
{
    const uint32_t step = argc > 1 && strcmp(argv[1], "quick") == 0 ? 199 : 1;
    bool msh = true, schlick = true;
    for (uint32_t n = 0; n < 1 << N_BITS;
         n += step) { /* all that its register holds: others than 1 to 1000 are clamped */
        msh = msh && every_cosine(GLINT_MSH, n, 0);
        schlick = schlick && every_cosine(GLINT_SCHLICK, n, 0);
    }
    const bool cut = cutoffs();
    result(7, "MSH of all 2^18 cosines and 2^10 shininesses is the library's", msh);
    result(8, "Schlick of all 2^18 cosines and 2^10 shininesses is the library's", schlick);
    result(9, "with a cutoff F is 0 below it and the library's from it on", cut);
    return !(msh && schlick && cut);
}
