/* SPDX-License-Identifier: MIT */
#include "pieces.h"

static void send_next(struct pieces *pieces);

/* From an interrupt, mostly. */
static void on_sent(void *argument)
{
    struct pieces *pieces = argument;
    __atomic_store_n(&pieces->sent, pieces->sent + 1, __ATOMIC_RELEASE); /* no other core writes it */
    pieces->is_sending = false;
    if (pieces->sent != pieces->added)
        send_next(pieces);
}

static void send_next(struct pieces *pieces)
{
    const volatile struct piece *piece = &pieces->queue[pieces->sent % PIECES_MAX];
    const struct panel *panel = pieces->panel;
    pieces->is_sending = true;
    if (piece->is_first && !panel_window(panel, 0, 0, panel->width, panel->height))
        pieces->has_failed = true;
    pieces->hal->flush(pieces->hal->context, piece->pixels, piece->count, on_sent, pieces);
}

/* The piece is entered before it is counted: the interrupt sends what it finds counted. */
uint32_t pieces_add(struct pieces *pieces, const uint16_t *pixels, size_t count, bool is_first)
{
    volatile struct piece *piece = &pieces->queue[pieces->added % PIECES_MAX];
    piece->pixels = pixels;
    piece->count = count;
    piece->is_first = is_first;
    const uint32_t end = ++pieces->added;
    if (!pieces->is_sending && !pieces_are_sent(pieces, end))
        send_next(pieces);
    return end;
}

bool pieces_are_sent(const struct pieces *pieces, uint32_t count)
{
    return (int32_t)(__atomic_load_n(&pieces->sent, __ATOMIC_ACQUIRE) - count) >= 0;
}
