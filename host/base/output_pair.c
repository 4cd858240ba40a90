/* SPDX-License-Identifier: MIT */
#include "base/output_pair.h"

#include "base/message.h"
#include "base/stop.h"

struct output_pair output_pair_open(const char *source, const char *header)
{
    if (source && header && output_same(source, header))
        fail("%s: leads to the same file as %s; remove the link", header, source);
    const struct output_pair pair = {source ? output_open(source) : NULL, header ? output_open(header) : NULL};
    return pair;
}

void output_pair_end_standard(struct output_pair *pair)
{
    if (!pair->source || pair->source->stream != stdout)
        return;
    output_close(pair->source);
    pair->source = NULL;
}

/* Neither gets its name while the other may still fail, as on a full disk, or at a signal. */
void output_pair_close(struct output_pair *pair)
{
    if (pair->header && pair->source) {
        output_check_written(pair->header);
        output_check_written(pair->source);
    }
    sigset_t before;
    signals_hold(&before);
    if (pair->header)
        output_close(pair->header);
    if (pair->source)
        output_close(pair->source);
    signals_release(&before);
}
