/* SPDX-License-Identifier: MIT
 * bin2uf2 pico|pico2|pico2-riscv IMAGE.bin IMAGE.uf2: a flash image for the boot loader, from the flash's beginning. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake/uf2.h"
#include "bake/write.h"

int main(int argc, char **argv)
{
    static uint8_t bytes[FLASH_END - FLASH_BASE];
    const char *board = argc == 4 ? argv[1] : "";
    const enum uf2_family family = strcmp(board, "pico2") == 0         ? UF2_RP2350
                                   : strcmp(board, "pico2-riscv") == 0 ? UF2_RP2350_RISCV
                                                                       : UF2_RP2040;
    FILE *in = argc == 4 ? fopen(argv[2], "rb") : NULL;
    const size_t len = in ? fread(bytes, 1, sizeof bytes, in) : 0;
    FILE *out = len ? fopen(argv[3], "wb") : NULL;
    if (out)
        uf2_write(bytes, len, FLASH_BASE, family, out);
    if (!out || ferror(in) || ferror(out) || fclose(out) != 0) {
        fprintf(stderr, "bin2uf2: %s was not made from %s\n", argc == 4 ? argv[3] : "a UF2 file",
                argc == 4 ? argv[2] : "an image: name the board and both");
        if (argc == 4)
            remove(argv[3]);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
