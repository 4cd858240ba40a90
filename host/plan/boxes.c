/* SPDX-License-Identifier: MIT */
#include "plan/boxes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan.h"

void boxes_add(struct boxes *boxes, struct glint_box box)
{
    if (boxes->count == boxes->room) {
        boxes->room = boxes->room ? 2 * boxes->room : 64;
        boxes->list = enlarge(boxes->list, boxes->room, sizeof *boxes->list);
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

/* Boxes that a span may join: the last of them that end at most LINES above it. */
enum { NEAR_LINES = 8, NEAR_MAX = 128 };

struct near {
    size_t list[NEAR_MAX], count; /* places in the list of boxes, rising */
};

static void near_drop_above(struct near *near, const struct boxes *boxes, unsigned y)
{
    size_t kept = 0;
    for (size_t i = 0; i < near->count; i++) {
        const struct glint_box *box = &boxes->list[near->list[i]];
        if ((unsigned)box->y + box->h + NEAR_LINES >= y)
            near->list[kept++] = near->list[i];
    }
    near->count = kept;
}

static void near_add(struct near *near, size_t box)
{
    if (near->count == NEAR_MAX)
        memmove(near->list, &near->list[1], --near->count * sizeof *near->list);
    near->list[near->count++] = box;
}

/* Joins a span to the box for which that saves most, or makes it a box where joining any costs more than a rectangle of
 * its own. What that adds to the price, which is never less than 0. */
static double add_span(const struct box_price *price, const struct glint_box *span, struct near *near,
                       struct boxes *boxes)
{
    size_t best = boxes->count;
    double most = 0;
    for (size_t i = 0; i < near->count; i++) {
        const double saved = saving(price, &boxes->list[near->list[i]], span);
        if (saved >= most) {
            most = saved;
            best = near->list[i];
        }
    }
    if (best < boxes->count) {
        boxes->list[best] = box_join(&boxes->list[best], span);
    } else {
        near_add(near, best);
        boxes_add(boxes, *span);
    }
    return price->rectangle_bytes + price->bytes(price->context, span) - most;
}

double boxes_of_spans(const struct changes *changes, const struct box_price *price, double limit, struct boxes *boxes)
{
    struct boxes spans = {0};
    struct near near = {.count = 0};
    double bytes = 0;
    const unsigned end = (unsigned)changes->bounds.y + changes->bounds.h;
    unsigned y = changes->bounds.y;
    for (; y < end && bytes < limit; y++) {
        near_drop_above(&near, boxes, y);
        add_spans(changes, price, (uint16_t)y, &spans);
        for (size_t i = 0; i < spans.count; i++)
            bytes += add_span(price, &spans.list[i], &near, boxes);
    }
    free(spans.list);
    return y < end ? INFINITY : bytes;
}
