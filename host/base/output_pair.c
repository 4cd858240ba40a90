/* SPDX-License-Identifier: MIT */
#include "base/output_pair.h"

#include <string.h>

struct output_pair output_pair_open(const char *source, const char *header)
{
    const struct output_pair pair = {source ? output_open(source) : NULL, header ? output_open(header) : NULL};
    return pair;
}

void output_pair_end_standard(struct output_pair *pair)
{
    if (!pair->source || strcmp(pair->source->path, "-") != 0)
        return;
    output_close(pair->source);
    pair->source = NULL;
}

void output_pair_close(struct output_pair *pair)
{
    if (pair->header)
        output_close(pair->header);
    if (pair->source)
        output_close(pair->source);
}
