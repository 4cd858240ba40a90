/* SPDX-License-Identifier: MIT
 * What every subcommand's options have in common. Not in main.c: the unit tests link all of the host but that. */
#include "host.h"

void parse_command(const struct argp *argp, int argc, char **argv, void *input)
{
    argp_parse(argp, argc, argv, 0, NULL, input);
}
