/* SPDX-License-Identifier: MIT
 * Rows of logic cells as a function of a (BITS bits) and x (16 bits), for each argument there is, beside the product. A wire is a word
 * of 256 lanes, a lane an x. */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef uint64_t word __attribute__((vector_size(32)));
#include FLAT

enum { X_BITS = 16, BITS = INPUTS - X_BITS };

int main(void)
{
    for (uint32_t a = 0; a < 1u << BITS; a++)
        for (uint32_t from = 0; from < 1u << X_BITS; from += 256) {
            word in[INPUTS] = {{0}}, out[OUTPUTS], wanted[OUTPUTS] = {{0}};
            for (unsigned i = 0; i < BITS; i++)
                in[i] -= (word){} + (a >> i & 1);
            for (uint32_t lane = 0; lane < 256; lane++) {
                for (unsigned i = 0; i < X_BITS; i++)
                    in[BITS + i][lane / 64] |= (uint64_t)((from + lane) >> i & 1) << lane % 64;
                for (unsigned i = 0; i < OUTPUTS; i++)
                    wanted[i][lane / 64] |= (uint64_t)(a * (from + lane) >> i & 1) << lane % 64;
            }
            flat(in, out);
            for (unsigned i = 0; i < OUTPUTS; i++)
                for (unsigned part = 0; part < 4; part++)
                    if (out[i][part] != wanted[i][part]) {
                        printf("# a = %u, x from %u on: another product\n", (unsigned)a, (unsigned)from);
                        return 1;
                    }
        }
    return 0;
}
