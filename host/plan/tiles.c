/* SPDX-License-Identifier: MIT
 * The frame cut from edge to edge, again and again, into tiles of which those without a change are left out: of all such
 * cuts along a grid, the one that should take the least time. */
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan.h"

/* Of a grid: 3510 boxes of cells, each cut in at most 19 ways. Each tile gets a grid of its own, so often. */
enum { COLUMNS = 12, ROWS = 9, GRIDS = 3 };

/* A box of cells: columns x0 to x1 - 1, rows y0 to y1 - 1. */
struct tile {
    struct glint_box bounds; /* of its changes, in pixels; w = 0: none */
    float bytes;             /* cheapest, rectangles counted */
    int8_t cut;              /* 0: as it is; x > 0: at column x; -y: at row y */
};

struct tiles {
    const struct changes *changes;
    const struct box_price *price;
    unsigned align_x;
    struct glint_box area;
    unsigned columns, rows, step_x, step_y;
    struct tile list[(COLUMNS + 1) * (ROWS + 1) * (COLUMNS + 1) * (ROWS + 1)];
};

static struct tile *tile_at(struct tiles *tiles, unsigned x0, unsigned y0, unsigned x1, unsigned y1)
{
    return &tiles->list[((x0 * (ROWS + 1) + y0) * (COLUMNS + 1) + x1) * (ROWS + 1) + y1];
}

static struct glint_box unite(const struct glint_box *a, const struct glint_box *b)
{
    if (!a->w || !b->w)
        return a->w ? *a : *b;
    return box_join(a, b);
}

static unsigned least(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

static struct glint_box bounds_of_cell(struct tiles *tiles, unsigned x, unsigned y)
{
    struct glint_box bounds = {0, 0, 0, 0};
    const struct glint_box *area = &tiles->area;
    const unsigned left = area->x + x * tiles->step_x, top = area->y + y * tiles->step_y;
    const unsigned right = least(left + tiles->step_x, (unsigned)area->x + area->w);
    const unsigned bottom = least(top + tiles->step_y, (unsigned)area->y + area->h);
    for (unsigned line = top; line < bottom; line++) {
        const uint8_t *marks = &tiles->changes->marks[(size_t)line * tiles->changes->width];
        unsigned first = left, end = right;
        while (first < end && !marks[first])
            first++;
        while (end > first && !marks[end - 1])
            end--;
        const struct glint_box span = {(uint16_t)first, (uint16_t)line, (uint16_t)(end - first), 1};
        if (end > first)
            bounds = unite(&bounds, &span);
    }
    return bounds;
}

/* The parts of a tile's cut. */
static void parts(struct tiles *tiles, unsigned x0, unsigned y0, unsigned x1, unsigned y1, int cut, struct tile *out[2])
{
    const unsigned at = (unsigned)abs(cut);
    out[0] = cut > 0 ? tile_at(tiles, x0, y0, at, y1) : tile_at(tiles, x0, y0, x1, at);
    out[1] = cut > 0 ? tile_at(tiles, at, y0, x1, y1) : tile_at(tiles, x0, at, x1, y1);
}

static void weigh(struct tiles *tiles, unsigned x0, unsigned y0, unsigned x1, unsigned y1)
{
    struct tile *tile = tile_at(tiles, x0, y0, x1, y1), *part[2];
    if (x1 - x0 > 1 || y1 - y0 > 1) {
        parts(tiles, x0, y0, x1, y1, x1 - x0 > 1 ? (int)x0 + 1 : -(int)(y0 + 1), part);
        tile->bounds = unite(&part[0]->bounds, &part[1]->bounds);
    }
    tile->cut = 0;
    tile->bytes = 0;
    if (!tile->bounds.w)
        return;
    const struct box_price *price = tiles->price;
    tile->bytes = (float)(price->rectangle_bytes + price->bytes(price->context, &tile->bounds));
    for (int cut = -(int)y1 + 1; cut < (int)x1; cut++) {
        if (cut >= -(int)y0 && cut <= (int)x0) {
            cut = (int)x0; /* goes on behind it */
            continue;
        }
        parts(tiles, x0, y0, x1, y1, cut, part);
        if (part[0]->bytes + part[1]->bytes < tile->bytes) {
            tile->bytes = part[0]->bytes + part[1]->bytes;
            tile->cut = (int8_t)cut;
        }
    }
}

/* The tiles that are left. */
static void collect(struct tiles *tiles, unsigned x0, unsigned y0, unsigned x1, unsigned y1, struct boxes *boxes)
{
    const struct tile *tile = tile_at(tiles, x0, y0, x1, y1);
    const unsigned at = (unsigned)abs(tile->cut);
    if (tile->cut > 0) {
        collect(tiles, x0, y0, at, y1, boxes);
        collect(tiles, at, y0, x1, y1, boxes);
    } else if (tile->cut < 0) {
        collect(tiles, x0, y0, x1, at, boxes);
        collect(tiles, x0, at, x1, y1, boxes);
    } else if (tile->bounds.w) {
        boxes_add(boxes, tile->bounds);
    }
}

/* Whole steps of `align` that cover `side` in at most `most` cells. */
static unsigned step_of(unsigned side, unsigned most, unsigned align)
{
    const unsigned step = (side + most - 1) / most;
    return (step + align - 1) / align * align;
}

static double cut_area(struct tiles *tiles, const struct glint_box *area, unsigned grids, struct boxes *boxes)
{
    const size_t first = boxes->count;
    tiles->area = *area;
    tiles->step_x = step_of(area->w, COLUMNS, tiles->align_x);
    tiles->step_y = step_of(area->h, ROWS, 1);
    tiles->columns = (area->w + tiles->step_x - 1) / tiles->step_x;
    tiles->rows = (area->h + tiles->step_y - 1) / tiles->step_y;
    for (unsigned w = 1; w <= tiles->columns; w++)
        for (unsigned h = 1; h <= tiles->rows; h++)
            for (unsigned x = 0; x + w <= tiles->columns; x++)
                for (unsigned y = 0; y + h <= tiles->rows; y++) {
                    if (w == 1 && h == 1)
                        tile_at(tiles, x, y, x + 1, y + 1)->bounds = bounds_of_cell(tiles, x, y);
                    weigh(tiles, x, y, x + w, y + h);
                }
    double bytes = tile_at(tiles, 0, 0, tiles->columns, tiles->rows)->bytes;
    collect(tiles, 0, 0, tiles->columns, tiles->rows, boxes);
    if (boxes->count == first + 1 || grids == 1)
        return bytes;
    struct boxes fine = {0};
    bytes = 0;
    for (size_t i = first; i < boxes->count; i++)
        bytes += cut_area(tiles, &boxes->list[i], grids - 1, &fine);
    boxes->count = first;
    for (size_t i = 0; i < fine.count; i++)
        boxes_add(boxes, fine.list[i]);
    free(fine.list);
    return bytes;
}

double boxes_of_tiles(const struct changes *changes, const struct box_price *price, unsigned align_x,
                      struct boxes *boxes)
{
    struct tiles *tiles = allocate(1, sizeof *tiles);
    tiles->changes = changes;
    tiles->price = price;
    tiles->align_x = align_x;
    const double bytes = cut_area(tiles, &changes->bounds, GRIDS, boxes);
    free(tiles);
    return bytes;
}
