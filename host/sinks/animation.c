/* SPDX-License-Identifier: MIT */
#include "sinks/animation.h"

#include <math.h>
#include <string.h>

#include "sinks/write.h"

struct sink animation_sink(const struct sink_wish *wish)
{
    struct sink sink = {.format = wish->format < 0 ? GLINT_RGB888 : (enum glint_format)wish->format,
                        .align_x = 1,
                        .whole_frames = true,
                        .max_bytes = SIZE_MAX,
                        .name = strcmp(wish->output, "-") == 0 ? "standard output" : wish->output};
    sink_size(&sink, wish);
    return sink;
}

void animation_open(struct animation *animation, const struct sink_wish *wish)
{
    animation->output = output_open(wish->output);
    animation->fps = wish->fps;
}

long animation_time(const struct animation *animation, unsigned long frame, unsigned unit)
{
    return lround((double)frame * unit / animation->fps);
}

void animation_write(struct animation *animation, const struct sink *sink, const void *bytes, size_t count)
{
    struct output *output = animation->output;
    if (sink_write(fileno(output->stream), sink->name, bytes, count) != SINK_SENT)
        return; /* stopped: close discards it */
    animation->output = NULL;
    output_close(output);
}

void animation_discard(struct animation *animation)
{
    if (animation->output)
        output_discard(animation->output);
}
