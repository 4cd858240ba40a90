/* SPDX-License-Identifier: MIT
 * What is sent of a frame: that it makes the new frame of the old one, bit for bit, within the sink's limits and at the
 * least cost. */
#include <lz4.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "image/format.h"
#include "plan/plan.h"
#include "unit.h"

enum { WIDTH = 93, HEIGHT = 61, BYTES = 4 * WIDTH * HEIGHT };

/* ---- a device that knows what it shows ---- */

static uint32_t random_state;

static uint32_t random_below(uint32_t limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)(random_state >> 8) * limit >> 24);
}

static struct frame frame_of(const struct sink *sink, const uint8_t *pixels)
{
    return (struct frame){sink->width, sink->height, sink->format, format_line_bytes(sink->format, sink->width),
                          pixels};
}

static unsigned bit_of(const uint8_t *line, size_t x)
{
    return line[x / 8] >> (7 - x % 8) & 1;
}

/* Puts one uncompressed piece, rows packed, onto the device's picture. */
static void put(const struct sink *sink, const struct piece *piece, const uint8_t *rows, uint8_t *shown)
{
    const size_t stride = format_line_bytes(sink->format, sink->width),
                 bytes = format_line_bytes(sink->format, piece->box.w);
    for (size_t y = 0; y < piece->box.h; y++) {
        uint8_t *to = &shown[(piece->box.y + y) * stride];
        const size_t bits = 8 / format_byte_pixels(sink->format);
        if (bits == 8) {
            memcpy(&to[format_line_bytes(sink->format, piece->box.x)], &rows[y * bytes], bytes);
            continue;
        }
        for (size_t x = 0; x < bits * piece->box.w; x++) {
            const size_t at = bits * piece->box.x + x;
            to[at / 8] = (uint8_t)((to[at / 8] & ~(0x80u >> at % 8)) | bit_of(&rows[y * bytes], x) << (7 - at % 8));
        }
    }
}

static void receive(const struct sink *sink, const struct plan_result *result, uint8_t *shown)
{
    static uint8_t rows[BYTES];
    size_t bytes = 0;
    for (size_t i = 0; i < result->count; i++) {
        const struct piece *piece = &result->pieces[i];
        bytes += piece->bytes;
        assert_true(piece->box.w > 0 && piece->box.x + piece->box.w <= sink->width);
        assert_true(piece->box.h > 0 && piece->box.y + piece->box.h <= sink->height);
        assert_int_equal(piece->length, format_line_bytes(sink->format, piece->box.w) * piece->box.h);
        assert_true(piece->length <= sink->max_bytes);
        if (sink->align_x) {
            assert_int_equal(piece->box.x % sink->align_x, 0);
            if (piece->box.x + piece->box.w < sink->width)
                assert_int_equal((piece->box.x + piece->box.w) % sink->align_x, 0);
        }
        if (piece->lz4) {
            assert_true(sink->lz4 && piece->bytes < piece->length);
            assert_int_equal(LZ4_decompress_safe((const char *)piece->data, (char *)rows, (int)piece->bytes, BYTES),
                             (int)piece->length);
            put(sink, piece, rows, shown);
        } else {
            assert_int_equal(piece->bytes, piece->length);
            put(sink, piece, piece->data, shown);
        }
    }
    assert_int_equal(bytes, result->bytes);
}

static double seconds_of(const struct sink *sink, const struct plan_result *result)
{
    return (double)result->count * sink->cost.rectangle_s + (double)result->bytes / sink->cost.bytes_per_s;
}

/* ---- changes ---- */

static void change(const struct sink *sink, uint8_t *pixels, unsigned kind)
{
    const size_t stride = format_line_bytes(sink->format, sink->width), all = stride * sink->height;
    const uint32_t x = random_below((uint32_t)stride), y = random_below(sink->height);
    switch (kind) {
    case 0: /* nothing */
        return;
    case 1: /* a byte */
        pixels[y * stride + x] ^= 1;
        return;
    case 2: /* some here and there */
        for (int i = 0; i < 40; i++)
            pixels[random_below((uint32_t)all)] ^= 0x10;
        return;
    case 3: /* a block of noise */
        for (uint32_t line = y; line < sink->height && line < y + 20; line++)
            for (uint32_t i = x; i < stride && i < x + 30; i++)
                pixels[line * stride + i] = (uint8_t)random_below(256);
        return;
    case 4: /* all noise */
        for (size_t i = 0; i < all; i++)
            pixels[i] = (uint8_t)random_below(256);
        return;
    case 5: /* all one colour */
        memset(pixels, (int)random_below(256), all);
        return;
    default: /* two far corners */
        pixels[0] ^= 3;
        pixels[all - stride + format_line_bytes(sink->format, sink->width - 1u) - 1] ^= 0x80;
    }
}

static const struct sink_kind plain_kind = {.name = "test"};

static struct sink sink_of(enum glint_format format, bool lz4, uint16_t align, size_t max_bytes)
{
    return (struct sink){.kind = &plain_kind,
                         .width = WIDTH,
                         .height = HEIGHT,
                         .format = format,
                         .align_x = align,
                         .lz4 = lz4,
                         .max_bytes = max_bytes,
                         .cost = {.4e-3, 800e3}};
}

/* Frames in a row: what the device shows after each is the frame. */
static void stream(const struct sink *sink, int frames)
{
    static uint8_t pixels[2][BYTES], shown[BYTES];
    memset(pixels, 0, sizeof pixels);
    memset(shown, 0x5a, sizeof shown);
    struct plan *plan = plan_new(sink);
    const size_t all = format_line_bytes(sink->format, sink->width) * sink->height;
    for (int i = 0; i < frames; i++) {
        uint8_t *now = pixels[i % 2], *last = pixels[(i + 1) % 2];
        memcpy(now, last, all);
        change(sink, now, i ? (unsigned)i % 7 : 4);
        const struct frame frame = frame_of(sink, now);
        const struct plan_result result = plan_frame(plan, i ? last : NULL, &frame);
        assert_int_equal(result.whole_bytes, all);
        receive(sink, &result, shown);
        const size_t bits = 8 / format_byte_pixels(sink->format);
        if (bits == 8)
            assert_memory_equal(shown, now, all);
        for (size_t y = 0; y < sink->height; y++)
            for (size_t x = 0; x < bits * sink->width && bits < 8; x++)
                assert_int_equal(bit_of(&shown[y * frame.line_bytes], x), bit_of(&now[y * frame.line_bytes], x));
    }
    plan_free(plan);
}

static void pieces_make_the_new_frame_of_the_last_bit_for_bit(void **state)
{
    (void)state;
    for (unsigned format = GLINT_RGB565; format < GLINT_FORMAT_COUNT; format++)
        for (unsigned lz4 = 0; lz4 < 2; lz4++) {
            struct sink sink = sink_of((enum glint_format)format, lz4, 1, SIZE_MAX);
            sink.align_x = (uint16_t)format_byte_pixels(sink.format);
            for (int rate = 0; rate < 3; rate++) { /* each its own level of LZ4 */
                sink.cost.bytes_per_s = rate == 0 ? 800e3 : rate == 1 ? 8e6 : 80e6;
                stream(&sink, 42);
            }
        }
}

/* A few small rectangles in a small picture often cost by boxes what they cost otherwise, but for a rounding. */
static void no_change_is_lost_where_two_plans_cost_the_same(void **state)
{
    (void)state;
    static uint8_t pixels[2][BYTES], shown[BYTES];
    struct sink sink = sink_of(GLINT_RGB565, false, 1, SIZE_MAX);
    sink.width = 32;
    sink.height = 24;
    sink.cost.bytes_per_s = 10e6 / 8;
    sink.cost.rectangle_s = 11 / sink.cost.bytes_per_s;
    struct plan *plan = plan_new(&sink);
    const size_t all = 2u * sink.width * sink.height;
    memset(pixels, 0, sizeof pixels);
    memset(shown, 0, sizeof shown);
    for (unsigned i = 0; i < 30000; i++) {
        uint8_t *now = pixels[i % 2], *last = pixels[(i + 1) % 2];
        memcpy(now, last, all);
        for (uint32_t rectangles = 1 + random_below(8); rectangles; rectangles--) {
            const uint32_t x = random_below(sink.width), y = random_below(sink.height);
            const uint32_t w = 1 + random_below(6), h = 1 + random_below(6);
            for (uint32_t line = y; line < y + h && line < sink.height; line++)
                for (uint32_t column = x; column < x + w && column < sink.width; column++)
                    now[2 * (line * sink.width + column)] ^= 1;
        }
        const struct frame frame = frame_of(&sink, now);
        const struct plan_result result = plan_frame(plan, last, &frame);
        receive(&sink, &result, shown);
        assert_memory_equal(shown, now, all);
    }
    plan_free(plan);
}

static void pieces_keep_the_sinks_limit_and_alignment(void **state)
{
    (void)state;
    static const uint16_t alignments[] = {1, 2, 8, 5, 64};
    static const size_t lines[] = {1, 2, 7};
    for (size_t a = 0; a < 5; a++)
        for (size_t l = 0; l < 3; l++) {
            const struct sink sink = sink_of(GLINT_RGB565, l == 1, alignments[a], lines[l] * 2 * WIDTH + l);
            stream(&sink, 28);
        }
}

static void nothing_changed_is_nothing_sent(void **state)
{
    (void)state;
    static uint8_t pixels[BYTES];
    const struct sink sink = sink_of(GLINT_RGB888, true, 1, SIZE_MAX);
    const struct frame frame = frame_of(&sink, pixels);
    struct plan *plan = plan_new(&sink);
    assert_int_equal(plan_frame(plan, pixels, &frame).count, 0);
    assert_int_equal(plan_frame(plan, pixels, &frame).changed, 0);
    const struct plan_result first = plan_frame(plan, NULL, &frame);
    assert_int_equal(first.changed, WIDTH * HEIGHT); /* not known is changed */
    assert_true(first.count > 0);
    plan_free(plan);
}

static void a_sink_of_whole_frames_gets_each_in_one_piece(void **state)
{
    (void)state;
    static uint8_t pixels[BYTES];
    struct sink sink = sink_of(GLINT_RGB565, false, 1, SIZE_MAX);
    sink.whole_frames = true;
    const struct frame frame = frame_of(&sink, pixels);
    struct plan *plan = plan_new(&sink);
    for (int i = 0; i < 3; i++) {
        const struct plan_result result = plan_frame(plan, i ? pixels : NULL, &frame);
        assert_int_equal(result.count, 1);
        assert_int_equal(result.bytes, 2 * WIDTH * HEIGHT);
    }
    plan_free(plan);
}

/* What is under way while the next frame is planned. */
static void data_stay_while_the_next_frame_is_planned(void **state)
{
    (void)state;
    static uint8_t pixels[2][BYTES], shown[BYTES];
    const struct sink sink = sink_of(GLINT_RGB565, true, 1, 512);
    struct plan *plan = plan_new(&sink);
    struct plan_result before = {0};
    struct piece kept[HEIGHT];
    for (int i = 0; i < 40; i++) {
        uint8_t *now = pixels[i % 2];
        change(&sink, now, i % 5 == 4 ? 0 : 3 + (unsigned)i % 2);
        if (i % 5 == 4)
            memcpy(now, pixels[(i + 1) % 2], BYTES); /* and through one where nothing is sent */
        const struct frame frame = frame_of(&sink, now);
        const struct plan_result result = plan_frame(plan, i ? pixels[(i + 1) % 2] : NULL, &frame);
        before.pieces = kept;
        receive(&sink, &before, shown);
        if (!result.count)
            continue; /* the one before is still under way */
        if (before.count)
            assert_memory_equal(shown, pixels[(i + 1) % 2], 2 * WIDTH * HEIGHT);
        assert_true(result.count <= HEIGHT);
        before = result;
        memcpy(kept, result.pieces, result.count * sizeof *kept);
    }
    plan_free(plan);
}

/* (By more than LZ4's chance, where it is long.) */
static void a_frame_never_costs_more_than_the_whole_one(void **state)
{
    (void)state;
    static uint8_t pixels[2][BYTES];
    for (unsigned lz4 = 0; lz4 < 2; lz4++) {
        const struct sink sink = sink_of(GLINT_RGB565, lz4, 1, SIZE_MAX);
        struct plan *plan = plan_new(&sink), *whole_plan = plan_new(&sink);
        for (int i = 0; i < 70; i++) {
            uint8_t *now = pixels[i % 2], *last = pixels[(i + 1) % 2];
            memcpy(now, last, BYTES);
            change(&sink, now, (unsigned)i % 7);
            const struct frame frame = frame_of(&sink, now);
            const struct plan_result result = plan_frame(plan, last, &frame),
                                     whole = plan_frame(whole_plan, NULL, &frame);
            if (seconds_of(&sink, &result) > seconds_of(&sink, &whole) * (lz4 && result.bytes > 2048 ? 1.01 : 1))
                fail_msg("frame %d: %zu bytes in %zu pieces, whole %zu", i, result.bytes, result.count, whole.bytes);
        }
        plan_free(plan);
        plan_free(whole_plan);
    }
}

/* Two pixels, far apart, changed in a noisy picture. */
static struct plan_result two_corners(const struct sink *sink, struct plan **plan)
{
    static uint8_t last[BYTES], now[BYTES];
    change(sink, last, 4);
    memcpy(now, last, BYTES);
    change(sink, now, 6);
    const struct frame frame = frame_of(sink, now);
    *plan = plan_new(sink);
    return plan_frame(*plan, last, &frame);
}

static void the_cost_of_a_rectangle_decides_how_many_there_are(void **state)
{
    (void)state;
    struct plan *plan;
    struct sink sink = sink_of(GLINT_RGB565, false, 1, SIZE_MAX);
    sink.cost = (struct sink_cost){1e-6, 1e6};
    struct plan_result result = two_corners(&sink, &plan);
    assert_int_equal(result.count, 2);
    assert_int_equal(result.bytes, 4);
    assert_int_equal(result.changed, 2);
    plan_free(plan);
    sink.cost.rectangle_s = 1;
    assert_int_equal(two_corners(&sink, &plan).count, 1);
    plan_free(plan);
}

static void far_blocks_go_as_tiles_where_all_between_is_dear(void **state)
{
    (void)state;
    static uint8_t last[BYTES], now[BYTES];
    const struct sink sink = sink_of(GLINT_RGB565, true, 1, SIZE_MAX); /* a rectangle costs 320 bytes */
    change(&sink, last, 4);
    memcpy(now, last, BYTES);
    for (size_t y = 0; y < 10; y++)
        for (size_t x = 0; x < 20; x++) {
            now[(y * WIDTH + x) * 2] ^= 1;
            now[((HEIGHT - 1 - y) * WIDTH + WIDTH - 1 - x) * 2] ^= 1;
        }
    struct plan *plan = plan_new(&sink);
    const struct frame frame = frame_of(&sink, now);
    const struct plan_result result = plan_frame(plan, last, &frame);
    assert_int_equal(result.count, 2);
    assert_true(result.bytes <= 2 * 2 * 200);
    plan_free(plan);
}

/* ---- steps, counted by the prices that are asked for ---- */

static size_t prices;

static size_t counted_bytes(const struct sink *sink, const struct glint_box *box)
{
    prices++;
    return format_line_bytes(sink->format, box->w) * box->h;
}

/* A column that changed beside pixels that did, each dearer to join than to send. */
static void a_frame_of_many_spans_asks_for_few_prices_a_pixel(void **state)
{
    (void)state;
    enum { SIDE = 256 };
    static const struct sink_kind kind = {.name = "test", .pixels = {.box_bytes = counted_bytes}};
    static uint8_t last[SIDE * SIDE], now[SIDE * SIDE];
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            now[SIDE * y + x] = x == 0 || (x % 2 == 0 && y % 2 == 0);
    const struct sink sink = {.kind = &kind,
                              .width = SIDE,
                              .height = SIDE,
                              .format = GLINT_GREY8,
                              .max_bytes = SIZE_MAX,
                              .cost = {.5e-6, 1e6}};
    const struct frame frame = frame_of(&sink, now);
    struct plan *plan = plan_new(&sink);
    prices = 0;
    const struct plan_result result = plan_frame(plan, last, &frame);
    assert_int_equal(result.bytes, SIDE + (SIDE / 2 - 1) * SIDE / 2);
    print_message("# %.1f prices a pixel\n", (double)prices / (SIDE * SIDE));
    assert_true(prices < 200u * SIDE * SIDE);
    plan_free(plan);
}

/* ---- a sink with a form of its own: one byte a pixel ---- */

static size_t byte_a_pixel(const struct sink *sink, const struct glint_box *box)
{
    (void)sink;
    return (size_t)box->w * box->h;
}

static void pack_low_bytes(const struct sink *sink, const struct frame *frame, const struct glint_box *box,
                           uint8_t *out)
{
    (void)sink;
    for (unsigned y = 0; y < box->h; y++)
        for (unsigned x = 0; x < box->w; x++)
            *out++ = frame->pixels[(box->y + y) * frame->line_bytes + 2 * (box->x + x)];
}

static void a_sinks_own_form_is_what_is_sent(void **state)
{
    (void)state;
    static const struct sink_kind kind = {.name = "own", .pixels = {.box_bytes = byte_a_pixel, .pack = pack_low_bytes}};
    static uint8_t last[BYTES], now[BYTES], rows[BYTES];
    struct sink sink = sink_of(GLINT_RGB565, true, 1, 10 * WIDTH);
    sink.kind = &kind;
    change(&sink, now, 4);
    struct plan *plan = plan_new(&sink);
    const struct frame frame = frame_of(&sink, now);
    const struct plan_result result = plan_frame(plan, last, &frame);
    assert_int_equal(result.whole_bytes, WIDTH * HEIGHT);
    assert_true(result.count >= (HEIGHT + 9) / 10);
    for (size_t i = 0; i < result.count; i++) {
        const struct piece *piece = &result.pieces[i];
        assert_true(piece->length <= sink.max_bytes);
        pack_low_bytes(&sink, &frame, &piece->box, rows);
        assert_false(piece->lz4); /* noise */
        assert_memory_equal(piece->data, rows, piece->length);
    }
    plan_free(plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_make_the_new_frame_of_the_last_bit_for_bit),
        cmocka_unit_test(no_change_is_lost_where_two_plans_cost_the_same),
        cmocka_unit_test(pieces_keep_the_sinks_limit_and_alignment),
        cmocka_unit_test(nothing_changed_is_nothing_sent),
        cmocka_unit_test(a_sink_of_whole_frames_gets_each_in_one_piece),
        cmocka_unit_test(data_stay_while_the_next_frame_is_planned),
        cmocka_unit_test(a_frame_never_costs_more_than_the_whole_one),
        cmocka_unit_test(the_cost_of_a_rectangle_decides_how_many_there_are),
        cmocka_unit_test(far_blocks_go_as_tiles_where_all_between_is_dear),
        cmocka_unit_test(a_frame_of_many_spans_asks_for_few_prices_a_pixel),
        cmocka_unit_test(a_sinks_own_form_is_what_is_sent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
