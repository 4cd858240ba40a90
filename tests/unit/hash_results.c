/* SPDX-License-Identifier: MIT
 * Prints the sweep's number, to be compared between compilers: hash_results [small] */
#include <stdio.h>
#include <string.h>

#include "../targets/sweep.h"

static void put(char c)
{
    putchar(c);
}

int main(int argc, char **argv)
{
    sweep_print(sweep(argc > 1 && strcmp(argv[1], "small") == 0 ? &sweep_small : &sweep_whole), put);
    return fflush(stdout) != 0;
}
