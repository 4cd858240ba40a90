/* SPDX-License-Identifier: MIT
 * host: Mpixel/s of each method over 16K elements, which stay in cache, and 16M, which do not, and these by two threads; methods in
 * turn, several runs. Lines with tabs: method, what it is, largest error in 2^-16, elements, threads, Mpixel/s of each run. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "models/batch.h"
#include "methods.h"

enum { N = 60, RUNS = 7, IN_CACHE = 1 << 14, IN_MEMORY = 1 << 24, COSINES = GLINT_C_ONE / 2 + 1 };

static method copy, batch_msh, batch_schlick, batch_cayley, batch_lyon, batch_ggx, batch_blinn, batch_gauss, batch_sg,
    scalar_msh, scalar_schlick;

static void copy(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    (void)n;
    memcpy(out, in, count * sizeof(uint32_t));
}

static void batch_msh(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    batch_eval(GLINT_MSH, n, in, out, count);
}

static void batch_schlick(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    batch_eval(GLINT_SCHLICK, n, in, out, count);
}

static void batch_cayley(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    batch_eval(GLINT_CAYLEY, n, in, out, count);
}

static void batch_lyon(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    batch_eval(GLINT_LYON, n, in, out, count);
}

static void batch_ggx(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    batch_eval(GLINT_GGX, n, in, out, count);
}

static void batch_blinn(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    batch_eval(GLINT_BLINN, n, in, out, count);
}

static void batch_gauss(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    batch_eval(GLINT_GAUSS, n, in, out, count);
}

static void batch_sg(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    batch_eval(GLINT_SG, n, in, out, count);
}

static void each(enum glint_model model, uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    for (size_t i = 0; i < count; i++)
        f_q16[i] = glint_eval(model, n, c_q16[i]);
}

static void scalar_msh(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    each(GLINT_MSH, n, in, out, count);
}

static void scalar_schlick(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    each(GLINT_SCHLICK, n, in, out, count);
}

static double real_msh(double c)
{
    return 2 * c / (1.25 * pow(N - N * c + 1.25 * c, 2));
}

static double real_schlick(double c)
{
    return c / (N - N * c + c);
}

static double real_blinn(double c)
{
    return pow(c, N);
}

static double real_gauss(double c)
{
    return exp(-N * acos(c) * acos(c) / 2);
}

static double real_cayley(double c)
{
    return pow(fmax(0, 4 * (1 + c) - N * (1 - c)) / (4 * (1 + c) + N * (1 - c)), 4);
}

static double real_lyon(double c)
{
    return pow(fmax(0, 1 - N * (1 - c) / 4), 4);
}

static double real_ggx(double c)
{
    return 1 / pow(1 + N * (1 - c * c) / 2, 2);
}

static double real_sg(double c)
{
    return exp(-N * (1 - c));
}

static const struct row {
    const char *name, *what;
    method *run;
    double (*real)(double c); /* NULL: none */
    enum { Q16, FLOAT } type;
    enum { BOTH, CACHE } where; /* CACHE: too slow for memory to matter */
} rows[] = {
    {"copy", "memcpy: the limit of memory", copy, NULL, Q16, BOTH},
    {"batch_msh", "exact", batch_msh, real_msh, Q16, BOTH},
    {"float_msh", "float, vectorised", float_msh, real_msh, FLOAT, BOTH},
    {"batch_schlick", "exact", batch_schlick, real_schlick, Q16, BOTH},
    {"float_schlick", "float, vectorised", float_schlick, real_schlick, FLOAT, BOTH},
    {"batch_cayley", "exact", batch_cayley, real_cayley, Q16, BOTH},
    {"batch_lyon", "exact", batch_lyon, real_lyon, Q16, BOTH},
    {"batch_ggx", "exact", batch_ggx, real_ggx, Q16, BOTH},
    {"batch_gauss", "exact; by a table from 65,537 elements on", batch_gauss, real_gauss, Q16, BOTH},
    {"batch_sg", "the same", batch_sg, real_sg, Q16, BOTH},
    {"batch_blinn", "exact; by a table from 1,048,592 elements on", batch_blinn, real_blinn, Q16, BOTH},
    {"float_blinn", "float, vectorised: libmvec's powf", float_blinn, real_blinn, FLOAT, BOTH},
    {"glint_eval_msh", "exact, one by one", scalar_msh, real_msh, Q16, CACHE},
    {"glint_eval_schlick", "exact, one by one", scalar_schlick, real_schlick, Q16, CACHE},
    {"fixmath_msh", "libfixmath", fixmath_msh, real_msh, Q16, CACHE},
    {"fixmath_schlick", "libfixmath", fixmath_schlick, real_schlick, Q16, CACHE},
    {"fixmath_blinn", "libfixmath", fixmath_blinn, real_blinn, Q16, CACHE},
};
enum { ROWS = sizeof rows / sizeof *rows };

static int32_t *c_q16;
static float *c_float;
static void *out;

static void *allocate(void)
{
    void *memory = aligned_alloc(4096, IN_MEMORY * sizeof(uint32_t));
    if (!memory) {
        fputs("make bench: no memory for the host's part (192 MB)\n", stderr);
        exit(1);
    }
    return memory;
}

/* Cosines from 1/2 to 1, all of them, scattered: powers of smaller ones are too small for powf's fast path. The output
 * is touched, so that its pages are there. */
static void prepare(void)
{
    c_q16 = allocate();
    c_float = allocate();
    out = memset(allocate(), 1, IN_MEMORY * sizeof(uint32_t));
    for (uint32_t i = 0; i < IN_MEMORY; i++) {
        c_q16[i] = (int32_t)(GLINT_C_ONE - i * UINT64_C(2654435761) % COSINES);
        c_float[i] = (float)c_q16[i] / GLINT_C_ONE;
    }
}

static void run(const struct row *row, size_t count, size_t threads)
{
    const size_t part = count / threads;
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
    for (size_t i = 0; i < threads; i++) {
        const size_t at = i * part;
        row->run(N, row->type == FLOAT ? (const void *)(c_float + at) : c_q16 + at, (uint32_t *)out + at, part);
    }
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Repeated until at least 20 ms have passed. */
static double measure(const struct row *row, size_t count, size_t threads)
{
    run(row, count < IN_CACHE ? count : IN_CACHE, threads);
    double elements = 0, seconds = 0;
    for (const double start = now(); seconds < 0.02; seconds = now() - start) {
        run(row, count, threads);
        elements += (double)count;
    }
    return elements / seconds / 1e6;
}

static double worst_error(const struct row *row)
{
    double worst = 0;
    if (!row->real)
        return 0;
    run(row, COSINES, 1);
    for (uint32_t i = 0; i < COSINES; i++) {
        const double found = row->type == FLOAT ? 65536.0 * (double)((float *)out)[i] : (double)((int32_t *)out)[i];
        worst = fmax(worst, fabs(found - 65536 * row->real(c_q16[i] / 65536.0)));
    }
    return worst;
}

int main(void)
{
    enum { PLACES = 3 };
    static double speeds[PLACES][ROWS][RUNS];
    static const size_t counts[PLACES] = {IN_CACHE, IN_MEMORY, IN_MEMORY}, threads[PLACES] = {1, 1, 2};
    prepare();
    for (int k = 0; k < RUNS; k++)
        for (int i = 0; i < ROWS; i++)
            for (int where = 0; where < (rows[i].where == BOTH ? PLACES : 1); where++) /* by one thread, then by two */
                speeds[where][i][k] = measure(&rows[i], counts[where], threads[where]);
    for (int i = 0; i < ROWS; i++)
        for (int where = 0; where < (rows[i].where == BOTH ? PLACES : 1); where++) {
            printf("%s\t%s\t%.3f\t%zu\t%zu", rows[i].name, rows[i].what, worst_error(&rows[i]), counts[where],
                   threads[where]);
            for (int k = 0; k < RUNS; k++)
                printf("\t%.4g", speeds[where][i][k]);
            putchar('\n');
        }
    return 0;
}
