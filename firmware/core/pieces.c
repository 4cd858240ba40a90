/* SPDX-License-Identifier: MIT */
#include "pieces.h"

static void send_next(struct pieces *pieces);

/* From an interrupt, mostly. */
static void on_sent(void *argument)
{
    struct pieces *pieces = argument;
    const volatile struct piece *piece = &pieces->queue[pieces->sent % PIECES_MAX];
    if (pieces->panel->round && ++pieces->line < piece->lines) {
        send_next(pieces);
        return;
    }
    pieces->line = 0;
    __atomic_store_n(&pieces->sent, pieces->sent + 1, __ATOMIC_RELEASE); /* no other core writes it */
    pieces->is_sending = false;
    if (pieces->sent != pieces->added)
        send_next(pieces);
}

/* A piece; or a line of it, whose window is its band's as far as the piece has it. */
static void send_next(struct pieces *pieces)
{
    const volatile struct piece *piece = &pieces->queue[pieces->sent % PIECES_MAX];
    const struct panel *panel = pieces->panel;
    const unsigned line = pieces->line, begin = piece->y, y = begin + line;
    const uint16_t *pixels = piece->pixels + (size_t)panel->width * line;
    size_t count = (size_t)panel->width * piece->lines;
    pieces->is_sending = true;
    if (panel->round) {
        const unsigned band = y - y % PANEL_BAND, first = band > begin ? band : begin;
        const unsigned in_piece = begin + piece->lines - first, in_band = panel_band(panel, first);
        const unsigned lines = in_band < in_piece ? in_band : in_piece;
        const struct panel_columns seen = panel_visible(panel, first, lines);
        if (y == first && !panel_window(panel, seen.first, (uint16_t)y, seen.count, (uint16_t)lines))
            pieces->has_failed = true;
        pixels += seen.first;
        count = seen.count;
    } else if (begin == 0 && !panel_window(panel, 0, 0, panel->width, panel->height)) {
        pieces->has_failed = true;
    }
    pieces->hal->flush(pieces->hal->context, pixels, count, on_sent, pieces);
}

/* The piece is entered before it is counted: the interrupt sends what it finds counted. */
uint32_t pieces_add(struct pieces *pieces, const uint16_t *pixels, unsigned y, unsigned lines)
{
    volatile struct piece *piece = &pieces->queue[pieces->added % PIECES_MAX];
    piece->pixels = pixels;
    piece->y = (uint16_t)y;
    piece->lines = (uint16_t)lines;
    const uint32_t end = ++pieces->added;
    if (!pieces->is_sending && !pieces_are_sent(pieces, end))
        send_next(pieces);
    return end;
}

bool pieces_are_sent(const struct pieces *pieces, uint32_t count)
{
    return (int32_t)(__atomic_load_n(&pieces->sent, __ATOMIC_ACQUIRE) - count) >= 0;
}
