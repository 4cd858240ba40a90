/* SPDX-License-Identifier: MIT
 * Two buffers for normals and two for pixels, used in turn. */
#include "relight.h"

static const uint32_t *map_line(const struct relight *relight, uint16_t y)
{
    return relight->map + (size_t)y * relight->panel->width;
}

static bool is_surface(uint32_t word)
{
    return word >> 16 != 0;
}

static const uint8_t *coverage_line(const struct relight *relight, uint16_t y)
{
    return relight->coverage ? relight->coverage + (size_t)y * relight->panel->width : NULL;
}

static struct relight_extent find_extent(const uint32_t *words, uint16_t w, bool *has_gaps)
{
    uint16_t first = w, end = 0;
    for (uint16_t x = 0; x < w; x++) {
        if (!is_surface(words[x])) {
            *has_gaps = true;
            continue;
        }
        first = first < x ? first : x;
        end = (uint16_t)(x + 1);
    }
    const uint16_t count = end ? (uint16_t)(end - first) : 0;
    const struct relight_extent extent = {first, count, first, count};
    return extent;
}

/* Gaps are no soft edges: a rectangle skips them. */
static bool find_solid(struct relight_extent *extent, const uint8_t *coverage)
{
    uint16_t run = 0;
    bool is_soft = false;
    extent->solid_count = 0;
    for (uint16_t x = extent->first; x < extent->first + extent->count; x++) {
        const bool is_edge = coverage[x] != 0 && coverage[x] != 255;
        is_soft = is_soft || is_edge;
        run = is_edge ? 0 : (uint16_t)(run + 1);
        if (run > extent->solid_count) {
            extent->solid = (uint16_t)(x + 1 - run);
            extent->solid_count = run;
        }
    }
    return is_soft;
}

void relight_start(struct relight *relight)
{
    while (relight->is_sending) /* the last lines of the picture before */
        ;
    relight->in_frame = false;
    relight->has_gaps = false;
    relight->buffer = 0;
    for (unsigned part = 0; part < 2; part++)
        relight->maps[part].normals_format = GLINT_NORMALS_INT8;
    for (uint16_t y = 0; y < relight->panel->height; y++) {
        relight->extents[y] = find_extent(map_line(relight, y), relight->panel->width, &relight->has_gaps);
        if (relight->coverage && find_solid(&relight->extents[y], coverage_line(relight, y)))
            relight->has_gaps = true; /* the background shines through */
    }
}

static void fetch(const struct relight *relight, uint16_t y, unsigned buffer)
{
    const struct hal *hal = relight->hal;
    const struct relight_extent extent = relight->extents[y];
    if (relight->normals[0] && extent.count)
        hal->fetch(hal->context, relight->normals[buffer], map_line(relight, y) + extent.first, extent.count);
}

static bool is_fetched(const struct relight *relight)
{
    return !relight->normals[0] || relight->hal->fetched(relight->hal->context);
}

enum glint_err relight_frame(struct relight *relight, const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    struct glint_light light;
    enum glint_err error = glint_light_directional(&light, to_light);
    if (error == GLINT_OK && relight->paint->output.format > GLINT_RGB565_SWAPPED)
        error = GLINT_ERR_FORMAT;
    if (error == GLINT_OK)
        error = glint_paint_light(relight->paint, &light, 1, to_viewer);
    if (error != GLINT_OK)
        return error;
    while (!is_fetched(relight)) /* of a frame that was abandoned */
        ;
    relight->line = 0;
    relight->in_frame = true;
    fetch(relight, 0, relight->buffer);
    return GLINT_OK;
}

/* Pixels of the line that are drawn at once: first..end - 1. */
struct run {
    unsigned first, end;
    const uint8_t *coverage; /* of the line, or NULL */
};

/* What of it lies in first..end - 1. */
static void shade_run(struct relight *relight, struct glint_maps *maps, const struct run *run, unsigned first,
                      unsigned end)
{
    const uint16_t y = relight->line;
    first = first > run->first ? first : run->first;
    end = end < run->end ? end : run->end;
    if (first >= end)
        return;
    const unsigned extent_first = relight->extents[y].first;
    maps->normals =
        relight->normals[0] ? relight->normals[relight->buffer] + (first - extent_first) : map_line(relight, y) + first;
    const struct glint_surface surface = {relight->pixels[relight->buffer] + first, 0, (uint16_t)first, y};
    maps->coverage = run->coverage ? run->coverage + first : NULL;
    glint_draw_rect(relight->paint, maps, (uint16_t)(end - first), 1, &surface, NULL);
}

/* Pixels first..end - 1 of the line; nothing else is written. */
static void shade_part(struct relight *relight, struct glint_maps *maps, unsigned first, unsigned end)
{
    const uint16_t y = relight->line;
    uint16_t *const pixels = relight->pixels[relight->buffer];
    const struct relight_extent extent = relight->extents[y];
    if (relight->has_gaps)
        for (unsigned x = first; x < end; x++)
            pixels[x] = relight->background;
    const uint8_t *coverage = coverage_line(relight, y);
    const unsigned solid_end = extent.solid + extent.solid_count;
    const struct run runs[] = {{extent.solid, solid_end, NULL},
                               {extent.first, extent.solid, coverage},
                               {solid_end, extent.first + extent.count, coverage}};
    for (unsigned i = 0; i < sizeof runs / sizeof *runs; i++)
        shade_run(relight, maps, &runs[i], first, end);
}

static unsigned middle(const struct relight *relight)
{
    const struct relight_extent extent = relight->extents[relight->line];
    return extent.first + extent.count / 2u;
}

static void shade_right(void *argument)
{
    struct relight *relight = argument;
    shade_part(relight, &relight->maps[1], middle(relight), relight->panel->width);
}

/* With two cores each shades half of the surface: neither reads what the other writes before the join. */
static void shade(struct relight *relight)
{
    const struct hal *hal = relight->hal;
    if (!hal->fork) {
        shade_part(relight, &relight->maps[0], 0, relight->panel->width);
        return;
    }
    hal->fork(hal->context, shade_right, relight);
    shade_part(relight, &relight->maps[0], 0, middle(relight));
    hal->join(hal->context);
}

static void sent(void *argument);

static void send(struct relight *relight, const uint16_t *pixels)
{
    relight->is_sending = true;
    relight->hal->flush(relight->hal->context, pixels, relight->panel->width, sent, relight);
}

/* From an interrupt: the line that waits follows without a gap on the bus. */
static void sent(void *argument)
{
    struct relight *relight = argument;
    relight->is_sending = false;
    if (!relight->is_waiting)
        return;
    relight->is_waiting = false;
    send(relight, relight->waiting);
}

enum relight_step relight_step(struct relight *relight)
{
    const struct panel *panel = relight->panel;
    if (!relight->in_frame)
        return relight->is_sending ? RELIGHT_BUSY : RELIGHT_DONE;
    if (relight->is_waiting || !is_fetched(relight)) /* waiting: the other buffer is on its way */
        return RELIGHT_BUSY;
    if (relight->line == 0 && relight->hal->may_begin && !relight->hal->may_begin(relight->hal->context))
        return RELIGHT_BUSY;
    if (relight->line + 1 < panel->height)
        fetch(relight, (uint16_t)(relight->line + 1), !relight->buffer);
    shade(relight);
    if (relight->line == 0 &&
        !panel_window(panel, 0, 0, panel->width, panel->height)) /* after the lines that are on their way */
        return RELIGHT_BUS_FAILED;
    relight->waiting = relight->pixels[relight->buffer];
    relight->is_waiting = true; /* from here on an interrupt may send it */
    if (!relight->is_sending) {
        relight->is_waiting = false;
        send(relight, relight->waiting);
    }
    relight->buffer = !relight->buffer;
    if (++relight->line == panel->height)
        relight->in_frame = false;
    return RELIGHT_BUSY;
}
