/* SPDX-License-Identifier: MIT
 * vectors PART PARTS PIXELS: lines "model n c_min c f" for the netlist's test, in runs of one material; the library's answers. Of every
 * run a third lies near the peak, a third anywhere, a third about the cutoff and beyond the ends. Most runs are in order of c: the
 * fewer bits change from pixel to pixel, the sooner the simulator is done. */
#include <stdio.h>
#include <stdlib.h>

#include "glint.h"

enum { RUN = 512, UNORDERED = 8 /* one of so many */ };

static uint32_t state;

static uint32_t random_below(uint32_t n)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state % n;
}

static int by_value(const void *a, const void *b)
{
    return *(const int32_t *)a - *(const int32_t *)b;
}

static void run(enum glint_model model, uint32_t n, uint32_t c_min, bool in_order)
{
    int32_t cosines[RUN];
    for (int i = 0; i < RUN; i++) {
        int32_t c;
        if (i % 3 == 0)
            c = GLINT_C_ONE - (int32_t)random_below(1 + 200000 / n);
        else if (i % 3 == 1)
            c = (int32_t)random_below((uint32_t)GLINT_C_ONE + 1);
        else
            c = i % 2 ? (int32_t)c_min - 2 + (int32_t)random_below(5) : (int32_t)random_below(1 << 18) - (1 << 17);
        if (c < -(1 << 17))
            c = -(1 << 17);
        cosines[i] = c;
    }
    if (in_order)
        qsort(cosines, RUN, sizeof cosines[0], by_value);
    for (int i = 0; i < RUN; i++) {
        const int32_t c = cosines[i];
        const uint32_t f = c < (int32_t)c_min ? 0 : glint_eval(model, n, c);
        printf("%d %u %u %d %u\n", model == GLINT_SCHLICK, (unsigned)n, (unsigned)c_min, (int)c, (unsigned)f);
    }
}

int main(int argc, char **argv)
{
    if (argc != 4)
        return 2;
    const uint32_t part = (uint32_t)atoi(argv[1]), parts = (uint32_t)atoi(argv[2]);
    const long pixels = atol(argv[3]);
    state = 1234567 + part;
    long sent = 0;
    for (uint32_t i = part; sent < pixels; i += parts, sent += RUN) {
        const enum glint_model model = i % 4 == 3 ? GLINT_SCHLICK : GLINT_MSH;
        /* Small shininess is rich in large F; the limits come first. */
        const uint32_t n = i < 4 ? 1000 : i < 8 ? 1 : 1 + random_below(i % 2 ? 1000 : 60);
        run(model, n, glint_cutoff(model, n, random_below(GLINT_Q_MAX + 1)), i / parts % UNORDERED != 0);
    }
    return 0;
}
