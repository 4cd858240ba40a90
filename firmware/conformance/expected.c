/* SPDX-License-Identifier: MIT
 * On the host: what an image is to find, as C; or, with a word `large`, the hashes of the large size. */
#include <inttypes.h>
#include <stdio.h>

#include "conformance.h"
#include "machine.h"

void machine_put(char c)
{
    putchar(c);
}

int main(int argc, char **argv)
{
    (void)argv;
    const bool large = argc > 1;
    if (!large)
        printf("/* Written by expected.c on the host. */\nstatic const uint64_t conformance_expected[] = {\n");
    for (unsigned check = 0; check < CONFORMANCE_CHECKS; check++) {
        const uint64_t hash = conformance_hash(check, large ? &conformance_large : &conformance_small);
        if (!large && check == CONFORMANCE_LOBES + 1)
            printf("#if !CONFORMANCE_MODELS_ONLY\n");
        if (large)
            printf("%016" PRIx64 " %s\n", hash, conformance_name(check));
        else
            printf("    UINT64_C(0x%016" PRIx64 "), /* %s */\n", hash, conformance_name(check));
    }
    if (!large)
        printf("#endif\n};\n");
    return fflush(stdout) != 0;
}
