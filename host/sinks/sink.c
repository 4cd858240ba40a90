/* SPDX-License-Identifier: MIT */
#include "sinks/sink.h"

#include "base/output.h"
#include "image/picture.h"

struct sink *sink_open(const struct sink_kind *kind, bool shades, const struct sink_wish *wish)
{
    struct sink *sink = (shades ? kind->shader->open : kind->pixels.open)(wish);
    if (!sink)
        return NULL;
    sink->kind = kind;
    sink->shades = shades;
    return sink;
}

void sink_finish(struct sink *sink)
{
    if (!sink->shades && sink->kind->pixels.finish)
        sink->kind->pixels.finish(sink);
}

void sink_close(struct sink *sink)
{
    (sink->shades ? sink->kind->shader->close : sink->kind->pixels.close)(sink);
}

void sink_size(struct sink *sink, const struct sink_wish *wish)
{
    sink->width = wish->width ? wish->width : wish->default_width;
    sink->height = wish->height ? wish->height : wish->default_height;
}

bool sink_takes_standard_output(const struct sink_kind *kind, const char *output)
{
    const struct sink_output *to = kind->output;
    return to && (to->piped || to->shown || (to->dash && output && output_is_standard(output)));
}
