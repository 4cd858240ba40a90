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

static struct relight_extent find_extent(const uint32_t *words, struct panel_columns seen, bool *has_gaps)
{
    uint16_t first = 0, end = 0, surfaces = 0;
    for (uint16_t x = seen.first; x < seen.first + seen.count; x++) {
        if (!is_surface(words[x]))
            continue;
        if (!surfaces++)
            first = x;
        end = (uint16_t)(x + 1);
    }
    const uint16_t count = (uint16_t)(end - first);
    const struct relight_extent extent = {first, count, first, count};
    *has_gaps |= surfaces != seen.count;
    return extent;
}

static void find_solid(struct relight_extent *extent, const uint32_t *words, const uint8_t *coverage)
{
    uint16_t run = 0;
    extent->solid_count = 0;
    for (uint16_t x = extent->first; x < extent->first + extent->count; x++) {
        run = coverage[x] == 255 && is_surface(words[x]) ? (uint16_t)(run + 1) : 0;
        if (run > extent->solid_count) {
            extent->solid = (uint16_t)(x + 1 - run);
            extent->solid_count = run;
        }
    }
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
        relight->extents[y] =
            find_extent(map_line(relight, y), panel_visible(relight->panel, y, 1), &relight->has_gaps);
        if (relight->coverage)
            find_solid(&relight->extents[y], map_line(relight, y), coverage_line(relight, y));
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

/* Pixels first..end - 1 of the line. */
struct run {
    unsigned first, end;
};

static unsigned run_length(const struct run *run)
{
    return run->first < run->end ? run->end - run->first : 0;
}

static const uint32_t *words_from(const struct relight *relight, unsigned x)
{
    const uint16_t y = relight->line;
    return relight->normals[0] ? relight->normals[relight->buffer] + (x - relight->extents[y].first)
                               : map_line(relight, y) + x;
}

static void shade_run(struct relight *relight, struct glint_maps *maps, const struct run *run, const uint8_t *coverage)
{
    if (!run_length(run))
        return;
    const struct glint_surface surface = {relight->pixels[relight->buffer] + run->first, 0, (uint16_t)run->first,
                                          relight->line};
    maps->normals = words_from(relight, run->first);
    maps->coverage = coverage ? coverage + run->first : NULL;
    glint_draw_rect(relight->paint, maps, (uint16_t)run_length(run), 1, &surface, NULL);
}

/* A line's two ends as one rectangle, side by side: a second one would cost a thousand cycles on a Cortex-M0+. */
enum { ENDS = 16 };
static void shade_both(struct relight *relight, struct glint_maps *maps, const struct run ends[2],
                       const uint8_t *coverage)
{
    uint32_t words[ENDS];
    uint16_t pixels[ENDS], count = 0;
    uint8_t covered[ENDS];
    const uint16_t background = relight->background;
    for (unsigned i = 0; i < 2; i++) {
        const uint32_t *word = words_from(relight, ends[i].first);
        for (unsigned x = ends[i].first; x < ends[i].end; x++, count++) {
            words[count] = *word++;
            covered[count] = coverage[x];
            pixels[count] = background;
        }
    }
    const struct glint_surface surface = {pixels, 0, 0, 0};
    maps->normals = words;
    maps->coverage = covered;
    glint_draw_rect(relight->paint, maps, count, 1, &surface, NULL);
    uint16_t *const line = relight->pixels[relight->buffer];
    const uint16_t *pixel = pixels;
    for (unsigned i = 0; i < 2; i++)
        for (unsigned x = ends[i].first; x < ends[i].end; x++)
            line[x] = *pixel++;
}

static void shade_ends(struct relight *relight, struct glint_maps *maps, const struct run ends[2],
                       const uint8_t *coverage)
{
    const unsigned lengths[] = {run_length(&ends[0]), run_length(&ends[1])};
    if (lengths[0] && lengths[1] && lengths[0] + lengths[1] <= ENDS && !relight->paint->output.dither) {
        shade_both(relight, maps, ends, coverage); /* not dithered: it is not where it is shown */
        return;
    }
    for (unsigned i = 0; i < 2; i++)
        shade_run(relight, maps, &ends[i], coverage);
}

static void fill(const struct relight *relight, unsigned first, unsigned end)
{
    uint16_t *const line = relight->pixels[relight->buffer];
    const uint16_t background = relight->background;
    for (unsigned x = first; x < end; x++)
        line[x] = background;
}

static struct run overlap(unsigned first, unsigned end, unsigned from, unsigned to)
{
    const struct run run = {first > from ? first : from, end < to ? end : to};
    return run;
}

/* Pixels first..end - 1 of the line; nothing else is written. What a band of a round panel has beyond the circle may hold anything. */
static void shade_part(struct relight *relight, struct glint_maps *maps, unsigned first, unsigned end)
{
    const struct relight_extent extent = relight->extents[relight->line];
    const uint8_t *coverage = coverage_line(relight, relight->line);
    const unsigned solid_end = extent.solid + extent.solid_count, extent_end = extent.first + extent.count;
    const struct run solid = overlap(first, end, extent.solid, solid_end);
    if (coverage) {
        fill(relight, first, end < extent.solid ? end : extent.solid);
        fill(relight, first > solid_end ? first : solid_end, end);
    } else if (relight->has_gaps) {
        fill(relight, first, end);
    }
    shade_run(relight, maps, &solid, NULL);
    if (coverage) {
        const struct run ends[] = {overlap(first, end, extent.first, extent.solid),
                                   overlap(first, end, solid_end, extent_end)};
        shade_ends(relight, maps, ends, coverage);
    }
}

static unsigned middle(const struct relight *relight)
{
    const struct relight_extent extent = relight->extents[relight->line];
    return extent.first + extent.count / 2u;
}

static void shade_right(void *argument)
{
    struct relight *relight = argument;
    shade_part(relight, &relight->maps[1], middle(relight), relight->seen.first + relight->seen.count);
}

/* With two cores each shades half of the surface: neither reads what the other writes before the join. */
static void shade(struct relight *relight)
{
    const struct hal *hal = relight->hal;
    unsigned end = relight->seen.first + relight->seen.count;
    if (hal->fork) {
        hal->fork(hal->context, shade_right, relight);
        end = middle(relight);
    }
    shade_part(relight, &relight->maps[0], relight->seen.first, end);
    if (hal->fork)
        hal->join(hal->context);
}

static void sent(void *argument);

static void send_waiting(struct relight *relight)
{
    relight->is_sending = true;
    relight->is_waiting = false;
    relight->hal->flush(relight->hal->context, relight->waiting, relight->waiting_count, sent, relight);
}

/* From an interrupt: the line that waits follows without a gap on the bus. */
static void sent(void *argument)
{
    struct relight *relight = argument;
    relight->is_sending = false;
    if (relight->is_waiting)
        send_waiting(relight);
}

/* The first line of a band. */
static bool open_window(const struct relight *relight, unsigned lines)
{
    return panel_window(relight->panel, relight->seen.first, relight->line, relight->seen.count, (uint16_t)lines);
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
    const bool is_first = relight->line == 0 || (panel->round && relight->line % PANEL_BAND == 0);
    const unsigned band = is_first ? panel_band(panel, relight->line) : 0;
    if (is_first)
        relight->seen = panel_visible(panel, relight->line, band);
    shade(relight);
    if (is_first && !open_window(relight, band)) /* after the lines that are on their way */
        return RELIGHT_BUS_FAILED;
    relight->waiting = relight->pixels[relight->buffer] + relight->seen.first;
    relight->waiting_count = relight->seen.count;
    relight->is_waiting = true;                      /* from here on an interrupt may send it */
    if (!relight->is_sending && relight->is_waiting) /* else an interrupt has sent it */
        send_waiting(relight);
    relight->buffer = !relight->buffer;
    if (++relight->line == panel->height)
        relight->in_frame = false;
    return RELIGHT_BUSY;
}
