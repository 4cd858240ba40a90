/* SPDX-License-Identifier: MIT
 * A rectangle: from its request by its bulk bytes to the board's lines. */
#include "gud_rectangle.h"
#include "gud_pixels.h"

uint32_t gud_output_line_bytes(const struct gud_device_config *c)
{
    return (c->output == GLINT_RGB888 ? 3u : 2u) * c->width;
}

/* ---- beginning and end ---- */

void gud_rectangle_close(struct gud_device *d)
{
    const bool whole = d->lines_left == 0;
    d->bulk_left = 0;
    if (!d->open)
        return;
    d->open = false;
    d->config->ops->end(d->config->context, whole);
}

static bool lies_inside(const struct gud_device_config *c, const struct gud_rectangle *r)
{
    return r->width && r->height && r->x < c->width && r->y < c->height && r->width <= c->width - r->x &&
           r->height <= c->height - r->y && (!c->whole_frames || (r->width == c->width && r->height == c->height));
}

/* Of a rectangle that lies inside. One larger than max_buffer is taken where memory allows: Linux (6.1) aligns the left side
 * of R1 and XRGB1111 after it has counted the bytes. */
static bool bytes_are_right(const struct gud_device *d, const struct gud_rectangle *r)
{
    const struct gud_device_config *c = d->config;
    const enum gud_format format = (enum gud_format)d->committed.format;
    const unsigned in_a_byte = format == GUD_R1 ? 8 : format == GUD_XRGB1111 ? 2 : 1;
    if (r->x % in_a_byte || r->length > INT32_MAX ||
        r->length != (uint64_t)gud_line_bytes(format, r->width) * r->height)
        return false;
    if (r->compression == 0)
        return r->compressed_length == 0;
    /* The last line is the length of an LZ4 block that holds literals only. */
    return r->compression == GUD_COMPRESSION_LZ4 && c->window &&
           (c->window_bytes >= LZ4_BLOCK_REACH || c->window_bytes >= r->length) && r->compressed_length &&
           r->compressed_length <= r->length + r->length / 255 + 16;
}

static void begin(struct gud_device *d, const struct gud_rectangle *r)
{
    d->compressed = r->compression != 0;
    d->bulk_left = d->compressed ? r->compressed_length : r->length;
    d->columns = (uint16_t)r->width;
    d->lines_left = (uint16_t)r->height;
    d->line_bytes = r->length / r->height;
    d->line_filled = 0;
    d->has_moved = true;
}

void gud_rectangle_open_whole(struct gud_device *d)
{
    const struct gud_device_config *c = d->config;
    if (!c->whole_frames || d->bulk_left || !d->controller || !d->committed.format)
        return;
    const size_t line = gud_line_bytes((enum gud_format)d->committed.format, c->width);
    const struct gud_rectangle r = {.width = c->width, .height = c->height, .length = (uint32_t)line * c->height};
    begin(d, &r);
    d->open = !c->ops->busy || !c->ops->busy(c->context);
    if (d->open)
        c->ops->window(c->context, 0, 0, c->width, c->height);
}

enum gud_status gud_rectangle_open(struct gud_device *d, const uint8_t *data)
{
    const struct gud_device_config *c = d->config;
    struct gud_rectangle r;
    gud_rectangle_unpack(&r, data);
    if (!d->controller || !d->committed.format)
        return GUD_PROTOCOL;
    if (!lies_inside(c, &r) || !bytes_are_right(d, &r))
        return GUD_PARAMETER;
    if (c->ops->busy && c->ops->busy(c->context))
        return GUD_BUSY;
    gud_rectangle_close(d); /* a whole picture may have begun between the request and its data */
    begin(d, &r);
    d->open = true;
    if (d->compressed)
        lz4_block_begin(&d->lz4, r.length);
    c->ops->window(c->context, (uint16_t)r.x, (uint16_t)r.y, d->columns, d->lines_left);
    return GUD_OK;
}

/* ---- bulk ---- */

static void draw_line(struct gud_device *d, const uint8_t *in)
{
    const struct gud_device_config *c = d->config;
    const uint32_t bytes = gud_output_line_bytes(c);
    uint8_t *out = c->lines + (d->half ? bytes : 0);
    d->half = !d->half;
    gud_pixels_convert(out, (enum glint_format)c->output, in, (enum gud_format)d->committed.format, d->columns);
    d->lines_left--;
    c->ops->line(c->context, out, bytes / c->width * d->columns);
}

/* Uncompressed bytes; bulk_left and the decoder keep them within the rectangle. */
static void take(struct gud_device *d, const uint8_t *bytes, size_t count)
{
    uint8_t *const gathered = d->config->lines + 2 * (size_t)gud_output_line_bytes(d->config);
    while (count) {
        if (d->line_filled == 0 && count >= d->line_bytes) {
            draw_line(d, bytes);
            bytes += d->line_bytes;
            count -= d->line_bytes;
            continue;
        }
        const uint32_t room = d->line_bytes - d->line_filled, some = count < room ? (uint32_t)count : room;
        uint8_t *const to = gathered + d->line_filled; /* locals only, so that compilers may make it a memcpy */
        for (uint32_t i = 0; i < some; i++)
            to[i] = bytes[i];
        bytes += some;
        count -= some;
        d->line_filled += some;
        if (d->line_filled == d->line_bytes) {
            d->line_filled = 0;
            draw_line(d, gathered);
        }
    }
}

enum gud_status gud_rectangle_bulk(struct gud_device *d, const uint8_t *bytes, size_t count)
{
    enum gud_status status = GUD_OK;
    if (count > d->bulk_left) {
        count = d->bulk_left;
        status = GUD_PROTOCOL;
    }
    if (count == 0)
        return status;
    d->bulk_left -= (uint32_t)count;
    d->has_moved = true;
    if (d->compressed) {
        const uint8_t *run, *const end = bytes + count;
        for (size_t length; (length = lz4_block_next(&d->lz4, &bytes, end, &run)) != 0;)
            take(d, run, length);
    } else if (d->open) {
        take(d, bytes, count);
    } else {
        status = GUD_BUSY;
    }
    if (d->bulk_left)
        return status;
    if (d->compressed && !lz4_block_complete(&d->lz4))
        status = GUD_ERROR;
    gud_rectangle_close(d);
    return status;
}
