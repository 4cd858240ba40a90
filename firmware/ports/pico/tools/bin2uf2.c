/* SPDX-License-Identifier: MIT
 * bin2uf2 IMAGE.bin IMAGE.uf2: a flash image for the boot loader, from the flash's beginning. */
#include <stdlib.h>

#include "bake.h"
#include "uf2.h"

int main(int argc, char **argv)
{
    static uint8_t bytes[FLASH_END - FLASH_BASE];
    FILE *in = argc == 3 ? fopen(argv[1], "rb") : NULL;
    const size_t len = in ? fread(bytes, 1, sizeof bytes, in) : 0;
    FILE *out = len ? fopen(argv[2], "wb") : NULL;
    if (out)
        uf2_write(bytes, len, FLASH_BASE, out);
    if (!out || ferror(in) || ferror(out) || fclose(out) != 0) {
        fprintf(stderr, "bin2uf2: %s was not made from %s\n", argc == 3 ? argv[2] : "a UF2 file",
                argc == 3 ? argv[1] : "an image: name both");
        if (argc == 3)
            remove(argv[2]);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
