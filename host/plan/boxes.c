/* SPDX-License-Identifier: MIT */
#include "plan/boxes.h"

#include <stdlib.h>

#include "base/message.h"
#include "plan/plan.h"

void boxes_add(struct boxes *boxes, struct glint_box box)
{
    if (boxes->count == boxes->room) {
        boxes->room = boxes->room ? 2 * boxes->room : 64;
        boxes->list = reallocarray(boxes->list, boxes->room, sizeof *boxes->list);
        if (!boxes->list)
            fail("out of memory");
    }
    boxes->list[boxes->count++] = box;
}

struct glint_box box_join(const struct glint_box *a, const struct glint_box *b)
{
    const int right = a->x + a->w > b->x + b->w ? a->x + a->w : b->x + b->w;
    const int bottom = a->y + a->h > b->y + b->h ? a->y + a->h : b->y + b->h;
    const uint16_t x = a->x < b->x ? a->x : b->x, y = a->y < b->y ? a->y : b->y;
    return (struct glint_box){x, y, (uint16_t)(right - x), (uint16_t)(bottom - y)};
}

/* What joining two boxes saves; negative where it costs. */
static double saving(const struct box_price *price, const struct glint_box *a, const struct glint_box *b)
{
    const struct glint_box both = box_join(a, b);
    return price->rectangle_bytes + price->bytes(price->context, a) + price->bytes(price->context, b) -
           price->bytes(price->context, &both);
}

/* The spans of line y; a span joins the one before it where one rectangle costs no more than two. */
static void add_spans(const struct changes *changes, const struct box_price *price, uint16_t y, struct boxes *spans)
{
    const uint8_t *line = &changes->marks[(size_t)y * changes->width];
    spans->count = 0;
    for (unsigned x = 0; x < changes->width;) {
        if (!line[x]) {
            x++;
            continue;
        }
        unsigned end = x + 1;
        while (end < changes->width && line[end])
            end++;
        const struct glint_box span = {(uint16_t)x, y, (uint16_t)(end - x), 1};
        struct glint_box *before = spans->count ? &spans->list[spans->count - 1] : NULL;
        if (before && saving(price, before, &span) >= 0)
            *before = box_join(before, &span);
        else
            boxes_add(spans, span);
        x = end;
    }
}

/* From the top line down, each span joins the box for which that saves most, among those that end at most NEAR lines above
 * it; where joining any of them costs more than a rectangle of its own, it becomes a new box. Boxes end in the order of
 * their start only roughly, so `open` lags behind, which costs time but loses nothing. */
double boxes_of_spans(const struct changes *changes, const struct box_price *price, struct boxes *boxes)
{
    enum { NEAR = 8 }; /* lines */
    struct boxes spans = {0};
    size_t open = 0; /* those before it ended farther up */
    for (unsigned y = changes->bounds.y; y < (unsigned)changes->bounds.y + changes->bounds.h; y++) {
        add_spans(changes, price, (uint16_t)y, &spans);
        for (size_t i = 0; i < spans.count; i++) {
            size_t best = boxes->count;
            double most = 0;
            for (size_t k = open; k < boxes->count; k++) {
                const double saved = saving(price, &boxes->list[k], &spans.list[i]);
                if (saved >= most) {
                    most = saved;
                    best = k;
                }
            }
            if (best < boxes->count)
                boxes->list[best] = box_join(&boxes->list[best], &spans.list[i]);
            else
                boxes_add(boxes, spans.list[i]);
        }
        while (open < boxes->count && boxes->list[open].y + boxes->list[open].h + NEAR <= (int)y)
            open++;
    }
    free(spans.list);
    double bytes = 0;
    for (size_t i = 0; i < boxes->count; i++)
        bytes += price->rectangle_bytes + price->bytes(price->context, &boxes->list[i]);
    return bytes;
}
