/* SPDX-License-Identifier: MIT */
#include "mesh/soup.h"

#include <stdlib.h>

void soup_free(struct soup *soup)
{
    if (!soup)
        return;
    free(soup->name);
    free(soup->faces);
    free(soup->materials);
    free(soup);
}
