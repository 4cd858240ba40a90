/* SPDX-License-Identifier: MIT */
#include "paper/family.h"

json_t *family_text(const double values[5])
{
    return json_sprintf("%g %g %g %g %g", values[0], values[1], values[2], values[3], values[4]);
}

void family_write(FILE *stream, const struct family *family)
{
    for (int i = 0; i < 5; i++)
        fprintf(stream, "%g,", family->b[i]);
    for (int i = 0; i < 5; i++)
        fprintf(stream, "%g,", family->a[i]);
}
