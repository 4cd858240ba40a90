/* SPDX-License-Identifier: MIT */
#include "stream/stats.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/message.h"

enum { LINKS_MAX = USB_RATES + 1 };

struct stream_stats {
    struct link { /* for predictions: USB's, and the sink's own where it has one */
        const char *name;
        struct sink_cost cost;
    } links[LINKS_MAX];
    unsigned link_count;
    const char *sink;
    char *device;
    unsigned pixels;
    double began, last, shown;
    unsigned long frames, unchanged;
    size_t first_bytes; /* of the first frame, which is whole and counts in nothing below unless it is the only one */
    struct sums {
        unsigned long frames;
        double whole_bytes, bytes, worst_bytes, rectangles, worst_rectangles, changed;
        struct {
            double sum, worst;
        } seconds[LINKS_MAX]; /* over each link */
    } first, rest;
};

struct stream_stats *stats_new(const struct sink *sink)
{
    struct stream_stats *stats = allocate(1, sizeof *stats);
    stats->sink = sink->kind->name;
    stats->device = copied(sink->name); /* the sink may be gone when the figures are printed */
    for (unsigned i = 0; i < USB_RATES; i++)
        stats->links[stats->link_count++] = (struct link){"USB", usb_costs[i]};
    if (sink->cost.bytes_per_s > 0)
        stats->links[stats->link_count++] = (struct link){"this link", sink->cost};
    stats->pixels = (unsigned)sink->width * sink->height;
    stats->began = seconds_now();
    return stats;
}

void stats_free(struct stream_stats *stats)
{
    if (stats)
        free(stats->device);
    free(stats);
}

static void add(const struct stream_stats *stats, struct sums *sums, const struct plan_result *result)
{
    sums->frames++;
    sums->whole_bytes += (double)result->whole_bytes;
    sums->bytes += (double)result->bytes;
    sums->worst_bytes = fmax(sums->worst_bytes, (double)result->bytes);
    sums->rectangles += (double)result->count;
    sums->worst_rectangles = fmax(sums->worst_rectangles, (double)result->count);
    sums->changed += (double)result->changed;
    for (unsigned i = 0; i < stats->link_count; i++) {
        const struct sink_cost *cost = &stats->links[i].cost;
        const double seconds = (double)result->count * cost->rectangle_s + (double)result->bytes / cost->bytes_per_s;
        sums->seconds[i].sum += seconds;
        sums->seconds[i].worst = fmax(sums->seconds[i].worst, seconds);
    }
}

void stats_add(struct stream_stats *stats, const struct plan_result *result)
{
    if (!stats->frames++)
        stats->first_bytes = result->bytes;
    stats->unchanged += !result->count;
    add(stats, stats->frames == 1 ? &stats->first : &stats->rest, result);
    stats->last = seconds_now();
}

/* From the start to the last frame that was sent. */
static double frames_a_second(const struct stream_stats *stats)
{
    const double time = stats->last - stats->began;
    return stats->frames && time > 0 ? (double)stats->frames / time : 0;
}

static const struct sums *sums_of(const struct stream_stats *stats)
{
    return stats->rest.frames ? &stats->rest : &stats->first;
}

static double mean(double sum, const struct sums *sums)
{
    return sums->frames ? sum / (double)sums->frames : 0;
}

/* Frames a second from seconds a frame; nothing to send is no limit. */
static double rate(double seconds)
{
    return seconds > 0 ? 1 / seconds : INFINITY;
}

void stats_show(struct stream_stats *stats)
{
    if (stats->last - stats->shown < .2)
        return;
    stats->shown = stats->last;
    const struct sums *sums = sums_of(stats);
    progress("%s: frame %lu, %.1f a second, %.0f of %.0f bytes each in %.1f rectangles", stats->device, stats->frames,
             frames_a_second(stats), mean(sums->bytes, sums), mean(sums->whole_bytes, sums),
             mean(sums->rectangles, sums));
}

static json_t *to_json(const struct stream_stats *stats)
{
    const struct sums *s = sums_of(stats);
    json_t *predicted = json_array();
    for (unsigned i = 0; i < stats->link_count; i++) {
        const double seconds = mean(s->seconds[i].sum, s), worst = s->seconds[i].worst;
        const struct link *link = &stats->links[i];
        json_array_append_new(predicted, json_pack("{s:s, s:f, s:f, s:o, s:o}", "link", link->name, "bytes_per_s",
                                                   link->cost.bytes_per_s, "rectangle_s", link->cost.rectangle_s,
                                                   "fps_mean", seconds > 0 ? json_real(rate(seconds)) : json_null(),
                                                   "fps_worst", worst > 0 ? json_real(rate(worst)) : json_null()));
    }
    return json_pack("{s:s, s:o, s:I, s:I, s:f, s:f, s:I, s:{s:f, s:f, s:f}, s:{s:f, s:f}, s:f, s:o}", "sink",
                     stats->sink, "device", json_text(stats->device), "frames", (json_int_t)stats->frames,
                     "frames_unchanged", (json_int_t)stats->unchanged, "seconds", stats->last - stats->began, "fps",
                     frames_a_second(stats), "first_frame_bytes", (json_int_t)stats->first_bytes, "frame_bytes",
                     "before_mean", mean(s->whole_bytes, s), "mean", mean(s->bytes, s), "worst", s->worst_bytes,
                     "rectangles", "mean", mean(s->rectangles, s), "worst", s->worst_rectangles, "changed_share",
                     mean(s->changed, s) / stats->pixels, "predicted", predicted);
}

static void print_text(const struct stream_stats *stats, FILE *stream)
{
    const struct sums *s = sums_of(stats);
    fprintf(stream, "%lu frames to %s in %.2f s, %.1f a second; %lu unchanged and not sent\n", stats->frames,
            stats->device, stats->last - stats->began, frames_a_second(stats), stats->unchanged);
    fprintf(stream, "the first frame: %zu bytes; then, a frame:\n", stats->first_bytes);
    fprintf(stream, "  bytes       mean %.0f, worst %.0f, of %.0f\n", mean(s->bytes, s), s->worst_bytes,
            mean(s->whole_bytes, s));
    fprintf(stream, "  rectangles  mean %.1f, worst %.0f\n", mean(s->rectangles, s), s->worst_rectangles);
    fprintf(stream, "  pixels      %.1f %% changed\n", 100 * mean(s->changed, s) / stats->pixels);
    for (unsigned i = 0; i < stats->link_count; i++) {
        const struct link *link = &stats->links[i];
        fprintf(stream, "  predicted   ");
        if (s->bytes > 0)
            fprintf(stream, "%.1f frames/s, worst %.1f,", rate(mean(s->seconds[i].sum, s)), rate(s->seconds[i].worst));
        else
            fprintf(stream, "any number of frames/s");
        fprintf(stream, " over %s at %.0f KB/s and %g ms a rectangle\n", link->name, link->cost.bytes_per_s / 1000,
                1000 * link->cost.rectangle_s);
    }
}

void stats_print(const struct stream_stats *stats, bool json, FILE *stream)
{
    errno = 0;
    if (json) {
        json_t *object = to_json(stats);
        json_dumpf(object, stream, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
        fputc('\n', stream);
        json_decref(object);
    } else {
        print_text(stats, stream);
    }
    if (fflush(stream) != 0 || ferror(stream))
        fail("standard %s: the figures could not be written: %s", stream == stdout ? "output" : "error",
             strerror(errno));
}
