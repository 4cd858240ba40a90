/* SPDX-License-Identifier: MIT */
#include "plan/plan.h"

#include <lz4.h>
#include <lz4hc.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "image/format.h"
#include "plan/density.h"
#include "plan/tiles.h"

/* One way to send a frame. */
struct draft {
    struct piece *pieces;
    size_t count, room;
    uint8_t *data;
    size_t used, size, bytes;
    double seconds;
};

/* Three: one whose data the sink may still be sending, the best so far, and the next to try. */
enum { DRAFTS = 3 };

struct plan {
    const struct sink *sink;
    unsigned align_x;
    struct changes changes;
    struct draft drafts[DRAFTS];
    unsigned sending, best;
    struct boxes boxes;
    struct density *density; /* NULL: no LZ4 */
    uint8_t *packed;         /* a piece before compression */
    size_t packed_size;
    void *lz4_state;
};

/* How hard to compress: the next frame is drawn and compressed while this one is sent, so compressing costs nothing while it
 * is faster than sending. (150 KB on one core: level 11 takes about 5 ms, level 3 1 ms, level 0, which is plain LZ4,
 * .15 ms.) */
static int lz4_level(const struct sink_cost *cost)
{
    return cost->bytes_per_s < 2e6 ? 11 : cost->bytes_per_s < 20e6 ? 3 : 0;
}

struct plan *plan_new(const struct sink *sink)
{
    struct plan *plan = allocate(1, sizeof *plan);
    plan->sink = sink;
    plan->align_x = sink->align_x > 1 ? sink->align_x : 1;
    if (!sink->kind->pixels.pack) /* lines of a box begin on a byte */
        while (plan->align_x % format_byte_pixels(sink->format))
            plan->align_x += sink->align_x > 1 ? sink->align_x : 1u;
    changes_init(&plan->changes, sink->width, sink->height);
    if (sink->lz4)
        plan->density = density_new(sink->width, sink->height);
    const int state = lz4_level(&sink->cost) ? LZ4_sizeofStateHC() : LZ4_sizeofState();
    plan->lz4_state = allocate((size_t)state, 1);
    plan->best = 1;
    return plan;
}

void plan_free(struct plan *plan)
{
    if (!plan)
        return;
    for (unsigned i = 0; i < DRAFTS; i++) {
        free(plan->drafts[i].pieces);
        free(plan->drafts[i].data);
    }
    free(plan->changes.marks);
    free(plan->boxes.list);
    density_free(plan->density);
    free(plan->packed);
    free(plan->lz4_state);
    free(plan);
}

/* ---- boxes in the sink's form ---- */

static size_t box_bytes(const struct sink *sink, const struct glint_box *box)
{
    return sink->kind->pixels.box_bytes ? sink->kind->pixels.box_bytes(sink, box)
                                        : format_line_bytes(sink->format, box->w) * box->h;
}

static void pack(const struct sink *sink, const struct frame *frame, const struct glint_box *box, uint8_t *out)
{
    if (sink->kind->pixels.pack) {
        sink->kind->pixels.pack(sink, frame, box, out);
        return;
    }
    const size_t bytes = format_line_bytes(frame->format, box->w), before = format_line_bytes(frame->format, box->x);
    for (unsigned y = 0; y < box->h; y++)
        memcpy(&out[y * bytes], &frame->pixels[(box->y + y) * frame->line_bytes + before], bytes);
}

/* The smallest box around it that the sink takes. */
static struct glint_box align(const struct plan *plan, const struct glint_box *box)
{
    const unsigned step = plan->align_x, left = box->x / step * step;
    unsigned right = (box->x + box->w + step - 1) / step * step;
    if (right > plan->sink->width)
        right = plan->sink->width;
    return (struct glint_box){(uint16_t)left, box->y, (uint16_t)(right - left), box->h};
}

static double price_bytes(const void *context, const struct glint_box *box)
{
    const struct plan *plan = context;
    const struct glint_box aligned = align(plan, box);
    return (double)box_bytes(plan->sink, &aligned);
}

/* The same compressed, estimated from the whole frame. */
static double price_lz4(const void *context, const struct glint_box *box)
{
    const struct plan *plan = context;
    const struct glint_box aligned = align(plan, box);
    return fmin(density_bytes(plan->density, &aligned), (double)box_bytes(plan->sink, &aligned));
}

/* ---- drafts ---- */

static uint8_t *grow(uint8_t *bytes, size_t *size, size_t wanted)
{
    if (wanted <= *size)
        return bytes;
    *size = wanted + wanted / 2;
    return enlarge(bytes, *size, 1);
}

/* The bytes it takes compressed; 0 where that is not less. */
static size_t compress(struct plan *plan, const uint8_t *from, size_t length, uint8_t *to)
{
    if (length < 2 || length > LZ4_MAX_INPUT_SIZE)
        return 0;
    const int level = lz4_level(&plan->sink->cost), size = (int)length;
    const char *in = (const char *)from;
    const int bytes = level ? LZ4_compress_HC_extStateHC(plan->lz4_state, in, (char *)to, size, size - 1, level)
                            : LZ4_compress_fast_extState(plan->lz4_state, in, (char *)to, size, size - 1, 1);
    return bytes > 0 ? (size_t)bytes : 0;
}

/* Adds a box that the sink takes as it is. The pieces get their data pointers from settle(), since the draft's memory moves as
 * it grows. */
static void add_piece(struct plan *plan, struct draft *draft, const struct frame *frame, const struct glint_box *box)
{
    const size_t length = box_bytes(plan->sink, box);
    draft->data = grow(draft->data, &draft->size, draft->used + length);
    uint8_t *out = &draft->data[draft->used];
    struct piece piece = {.box = *box, .bytes = length, .length = length};
    if (plan->sink->lz4) {
        plan->packed = grow(plan->packed, &plan->packed_size, length);
        pack(plan->sink, frame, box, plan->packed);
        const size_t bytes = compress(plan, plan->packed, length, out);
        piece.lz4 = bytes > 0;
        if (bytes)
            piece.bytes = bytes;
        else
            memcpy(out, plan->packed, length);
    } else {
        pack(plan->sink, frame, box, out);
    }
    if (draft->count == draft->room) {
        draft->room = draft->room ? 2 * draft->room : 64;
        draft->pieces = enlarge(draft->pieces, draft->room, sizeof *draft->pieces);
    }
    draft->pieces[draft->count++] = piece;
    draft->used += piece.bytes;
    draft->bytes += piece.bytes;
    draft->seconds += plan->sink->cost.rectangle_s +
                      (plan->sink->cost.bytes_per_s > 0 ? (double)piece.bytes / plan->sink->cost.bytes_per_s : 0);
}

/* Cuts the box into as many pieces as the sink's limit of bytes asks for, each of as many lines as fit: the height shrinks by
 * an eighth at a time until they do. */
static void add_box(struct plan *plan, struct draft *draft, const struct frame *frame, const struct glint_box *box)
{
    struct glint_box part = align(plan, box);
    const unsigned end = part.y + part.h;
    while (part.y < end) {
        part.h = (uint16_t)(end - part.y);
        while (part.h > 1 && box_bytes(plan->sink, &part) > plan->sink->max_bytes)
            part.h = (uint16_t)(part.h - (part.h > 16 ? part.h / 8 : 1));
        add_piece(plan, draft, frame, &part);
        part.y = (uint16_t)(part.y + part.h);
    }
}

/* Packs and compresses these boxes into the draft that is neither under way nor the best so far; if it takes less time, it
 * becomes the best. The three drafts have the numbers 0, 1, 2, which add up to DRAFTS: what is left of that sum is the
 * free one. Stops as soon as the draft takes longer than the best. */
static void try_draft(struct plan *plan, const struct frame *frame, const struct glint_box *boxes, size_t count)
{
    const unsigned next = DRAFTS - plan->sending - plan->best;
    struct draft *draft = &plan->drafts[next];
    const double limit = plan->drafts[plan->best].seconds;
    draft->count = draft->used = draft->bytes = 0;
    draft->seconds = 0;
    for (size_t i = 0; i < count && draft->seconds < limit; i++)
        add_box(plan, draft, frame, &boxes[i]);
    if (draft->seconds < limit)
        plan->best = next;
}

/* ---- choosing ---- */

/* Points each piece at its data, which no longer move. */
static void settle(struct draft *draft)
{
    size_t at = 0;
    for (size_t i = 0; i < draft->count; i++) {
        draft->pieces[i].data = &draft->data[at];
        at += draft->pieces[i].bytes;
    }
}

/* Packs the boxes that were proposed if by their price they may beat the best so far. */
static void try_boxes(struct plan *plan, const struct frame *now, double bytes)
{
    const struct sink_cost *cost = &plan->sink->cost;
    if (plan->boxes.count > 1 && bytes / cost->bytes_per_s < plan->drafts[plan->best].seconds)
        try_draft(plan, now, plan->boxes.list, plan->boxes.count);
    plan->boxes.count = 0;
}

enum { SHORT_BYTES = 2048 }; /* for LZ4 */

/* Tries one box around all changes first, which gives the bytes of each part as LZ4 (density) and a time to beat. Tiles and
 * then spans are packed only where their price, estimated from that, promises less. A very short box may be beaten by the
 * whole frame, in which LZ4 finds longer matches. Spans are too short for LZ4, so they are priced uncompressed. */
static void choose(struct plan *plan, const struct frame *now, const struct glint_box *whole)
{
    const struct sink_cost *cost = &plan->sink->cost;
    const struct changes *changes = &plan->changes;
    const size_t pixels = (size_t)whole->w * whole->h;
    struct box_price price = {cost->rectangle_s * cost->bytes_per_s, price_bytes, plan};
    try_draft(plan, now, &changes->bounds, 1);
    if (plan->density && plan->drafts[plan->best].bytes < SHORT_BYTES)
        try_draft(plan, now, whole, 1);
    if (changes->count == pixels || cost->bytes_per_s <= 0)
        return;
    if (plan->density) {
        const struct draft *draft = &plan->drafts[plan->best];
        settle(&plan->drafts[plan->best]);
        density_measure(plan->density, draft->pieces, draft->count);
        price.bytes = price_lz4;
    }
    try_boxes(plan, now, boxes_of_tiles(changes, &price, plan->align_x, &plan->boxes));
    price.bytes = price_bytes;
    const double limit = plan->drafts[plan->best].seconds * cost->bytes_per_s;
    if ((double)changes->count / (double)pixels * (double)box_bytes(plan->sink, whole) < limit)
        try_boxes(plan, now, boxes_of_spans(changes, &price, limit, &plan->boxes));
}

/* The best of new drafts; the one under way stays until this frame is sent. */
static void begin(struct plan *plan)
{
    plan->sending = plan->best;
    plan->best = (plan->sending + 1) % DRAFTS;
    plan->drafts[plan->best].seconds = INFINITY;
}

static void finish(struct plan *plan, struct plan_result *result)
{
    struct draft *draft = &plan->drafts[plan->best];
    settle(draft);
    result->pieces = draft->pieces;
    result->count = draft->count;
    result->bytes = draft->bytes;
}

struct plan_result plan_frame(struct plan *plan, const uint8_t *last, const struct frame *now)
{
    const struct glint_box whole = {0, 0, now->width, now->height};
    struct plan_result result = {.whole_bytes = box_bytes(plan->sink, &whole)};
    changes_find(&plan->changes, last, now);
    result.changed = plan->changes.count;
    if (!plan->sink->whole_frames && !plan->changes.count)
        return result; /* nothing to send: the draft under way stays the last */
    begin(plan);
    if (plan->sink->whole_frames)
        try_draft(plan, now, &whole, 1);
    else
        choose(plan, now, &whole);
    finish(plan, &result);
    return result;
}

struct plan_result plan_little(struct plan *plan, const struct frame *now)
{
    const struct glint_box whole = {0, 0, now->width, now->height}, corner = {0, 0, 1, 1};
    struct plan_result result = {.whole_bytes = box_bytes(plan->sink, &whole)};
    begin(plan);
    try_draft(plan, now, &corner, 1);
    finish(plan, &result);
    return result;
}
