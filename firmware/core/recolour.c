/* SPDX-License-Identifier: MIT */
#include "recolour.h"

static bool is_fetched(const struct recolour *recolour)
{
    const struct hal *hal = recolour->pieces.hal;
    return hal->fetched(hal->context);
}

/* Line y, into the buffer of its parity. Within a band the columns are those of the line before. */
static void fetch(struct recolour *recolour, unsigned y)
{
    const struct panel *panel = recolour->pieces.panel;
    const struct hal *hal = recolour->pieces.hal;
    struct panel_columns *seen = &recolour->seen[y % 2];
    if (y >= panel->height)
        return;
    *seen = y % PANEL_BAND ? recolour->seen[!(y % 2)] : panel_visible(panel, y, panel_band(panel, y));
    hal->fetch(hal->context, recolour->fetched[y % 2], recolour->next, seen->count / 2u);
    recolour->next += seen->count / 2u;
}

static enum glint_err colour(struct recolour *recolour)
{
    const struct glint_maps maps = {.normals = recolour->normals};
    const struct glint_surface line = {recolour->colours, 0, 0, 0};
    const enum glint_err error = glint_draw_rect(recolour->paint, &maps, recolour->entries, 1, &line, NULL);
    recolour->colours[0] = recolour->background;
    return error;
}

enum glint_err recolour_frame(struct recolour *recolour, const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    struct glint_light light;
    enum glint_err error = glint_light_directional(&light, to_light);
    const struct glint_output *output = &recolour->paint->output;
    if (error == GLINT_OK && (output->format > GLINT_RGB565_SWAPPED || output->dither))
        error = GLINT_ERR_FORMAT;
    if (error == GLINT_OK)
        error = glint_paint_light(recolour->paint, &light, 1, to_viewer);
    if (error != GLINT_OK)
        return error;
    error = colour(recolour);
    if (error != GLINT_OK)
        return error;
    while (!is_fetched(recolour)) /* of a frame that was abandoned */
        ;
    recolour->next = recolour->places;
    fetch(recolour, 0);
    recolour->line = 0;
    recolour->in_frame = true;
    return GLINT_OK;
}

void recolour_stop(struct recolour *recolour)
{
    recolour->in_frame = false;
    while (!pieces_are_sent(&recolour->pieces, recolour->pieces.added))
        ;
}

enum recolour_step recolour_step(struct recolour *recolour)
{
    struct pieces *const pieces = &recolour->pieces;
    const unsigned y = recolour->line, in_band = y % PANEL_BAND, band = y / PANEL_BAND % 2;
    if (pieces->has_failed)
        return RECOLOUR_BUS_FAILED;
    if (!recolour->in_frame)
        return pieces_are_sent(pieces, pieces->added) ? RECOLOUR_DONE : RECOLOUR_BUSY;
    if (!is_fetched(recolour) || !pieces_are_sent(pieces, recolour->sent[band]))
        return RECOLOUR_BUSY;
    fetch(recolour, y + 1);
    const struct panel_columns seen = recolour->seen[y % 2];
    uint16_t *const pixels = recolour->bands[band];
    const struct glint_surface line = {pixels + (size_t)pieces->panel->width * in_band + seen.first, 0, 0, 0};
    (void)glint_draw_palette(recolour->colours, (const uint16_t *)(const void *)recolour->fetched[y % 2], 0, seen.count,
                             1, &line);
    recolour->line++;
    recolour->in_frame = recolour->line < pieces->panel->height;
    if (recolour->line % PANEL_BAND == 0 || !recolour->in_frame)
        recolour->sent[band] = pieces_add(pieces, pixels, y - in_band, in_band + 1);
    return RECOLOUR_BUSY;
}
