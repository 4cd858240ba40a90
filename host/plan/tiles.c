/* SPDX-License-Identifier: MIT
 *
 * A frame is cut from edge to edge, each part again, and so on; tiles without a change are not sent. Of all such ways to
 * cut along a grid this finds the one of the least price by dynamic programming: the best way to cut a box of cells is to
 * leave it whole, or one cut and the best ways for the two parts, so boxes are weighed from small to large and each looks
 * up its parts. Then each tile found gets a finer grid of its own. */
#include "plan/tiles.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan.h"

/* A grid has 12 * 13 / 2 * 9 * 10 / 2 = 3510 boxes of cells, each cut in at most 11 + 8 = 19 ways. GRIDS: how often tiles are
 * refined, the first grid counted. */
enum { COLUMNS = 12, ROWS = 9, GRIDS = 3 };

/* A box of cells: columns x0 to x1 - 1, rows y0 to y1 - 1. */
struct tile {
    struct glint_box bounds; /* of its changes, in pixels; w = 0: none */
    float bytes;             /* the least price, rectangles counted */
    int8_t cut;              /* the best: 0: none; x > 0: at column x; -y: at row y */
};

struct tiles {
    const struct changes *changes;
    const struct box_price *price;
    unsigned align_x;
    struct glint_box area;
    unsigned columns, rows, step_x, step_y;
    struct tile list[(COLUMNS + 1) * (ROWS + 1) * (COLUMNS + 1) * (ROWS + 1)]; /* by x0, y0, x1, y1 */
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

/* Grows a box around the first and the last mark of each line of the cell. */
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

/* The two parts that a cut leaves of a tile. */
static void parts(struct tiles *tiles, unsigned x0, unsigned y0, unsigned x1, unsigned y1, int cut, struct tile *out[2])
{
    const unsigned at = (unsigned)abs(cut);
    out[0] = cut > 0 ? tile_at(tiles, x0, y0, at, y1) : tile_at(tiles, x0, y0, x1, at);
    out[1] = cut > 0 ? tile_at(tiles, at, y0, x1, y1) : tile_at(tiles, x0, at, x1, y1);
}

/* The price of a tile cut as `cut` says. */
static float cut_bytes(struct tiles *tiles, unsigned x0, unsigned y0, unsigned x1, unsigned y1, int cut)
{
    struct tile *part[2];
    parts(tiles, x0, y0, x1, y1, cut, part);
    return part[0]->bytes + part[1]->bytes;
}

static void keep_cheaper(struct tile *tile, float bytes, int cut)
{
    if (bytes < tile->bytes) {
        tile->bytes = bytes;
        tile->cut = (int8_t)cut;
    }
}

/* The best way to cut a box of cells, all smaller boxes being weighed. Its changes are those of any two parts. It costs its
 * own rectangle or, if that is less, the sum of two parts: every row and every column inside it is tried as the cut, rows
 * from the bottom up, since of equal prices the first stays. */
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
    for (unsigned y = y1 - 1; y > y0; y--)
        keep_cheaper(tile, cut_bytes(tiles, x0, y0, x1, y1, -(int)y), -(int)y);
    for (unsigned x = x0 + 1; x < x1; x++)
        keep_cheaper(tile, cut_bytes(tiles, x0, y0, x1, y1, (int)x), (int)x);
}

/* Follows the best cuts down and adds the tiles that are left whole and hold changes. */
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

/* All boxes of cells in the order of their size, so that the parts of each are known; then the finer grids. */
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
