/* SPDX-License-Identifier: MIT
 * The firmware's LZ4 decoder: against liblz4, in pieces, with small windows, and with what the format forbids. */
#include <lz4.h>
#include <lz4hc.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "unit.h"

#include "lz4_block.h"

enum { OUTPUT_MAX = 300000, GUARD = 64, FRESH = 0xa5 };

static uint32_t seed;
static uint32_t random_below(uint32_t limit)
{
    seed = seed * 1664525 + 1013904223;
    return (uint32_t)((uint64_t)seed * limit >> 32);
}

/* The whole block by pieces of at most `piece` bytes (0: random); its output to `out`. False where it is refused. */
static bool decode(const uint8_t *in, size_t count, uint8_t *out, uint32_t output_bytes, uint32_t window_bytes,
                   size_t piece)
{
    uint8_t *memory = malloc(window_bytes + 2 * GUARD);
    assert_non_null(memory);
    memset(memory, FRESH, window_bytes + 2 * GUARD);
    struct lz4_block block = {.window = memory + GUARD, .window_bytes = window_bytes};
    lz4_block_begin(&block, output_bytes);
    size_t made = 0;
    for (size_t at = 0; at < count;) {
        size_t length = piece ? piece : 1 + random_below(100);
        length = length < count - at ? length : count - at;
        const uint8_t *from = in + at, *run;
        for (size_t n; (n = lz4_block_next(&block, &from, in + at + length, &run)) != 0; made += n) {
            assert_true(run >= block.window && run + n <= block.window + window_bytes);
            assert_true(made + n <= output_bytes);
            memcpy(out + made, run, n);
        }
        assert_ptr_equal(from, in + at + length);
        at += length;
    }
    for (unsigned i = 0; i < GUARD; i++) {
        assert_int_equal(memory[i], FRESH);
        assert_int_equal(memory[GUARD + window_bytes + i], FRESH);
    }
    const bool complete = lz4_block_complete(&block);
    assert_true(!complete || made == output_bytes);
    free(memory);
    return complete;
}

static uint8_t original[OUTPUT_MAX], output[OUTPUT_MAX], block[LZ4_COMPRESSBOUND(OUTPUT_MAX)];

/* Runs, repeats from near and far, and noise. */
static void fill_original(uint32_t bytes)
{
    for (uint32_t at = 0; at < bytes;) {
        uint32_t length = 1 + random_below(random_below(8) ? 40 : 3000);
        length = length < bytes - at ? length : bytes - at;
        const uint32_t kind = random_below(3), back = 1 + random_below(random_below(2) ? 8 : 70000);
        for (; length; length--, at++)
            original[at] = kind == 0 || back > at ? (uint8_t)random_below(256) : original[at - back];
    }
}

static void what_liblz4_compresses_comes_back_whatever_the_pieces_and_the_window(void **state)
{
    (void)state;
    static const uint32_t sizes[] = {1, 4, 5, 12, 13, 14, 64, 1000, 65535, 65536, 65537, 115200, OUTPUT_MAX};
    static const size_t pieces[] = {0, 1, 64, SIZE_MAX};
    for (unsigned s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        seed = s;
        fill_original(sizes[s]);
        for (unsigned hard = 0; hard < 2; hard++) {
            const int size = (int)sizes[s], room = (int)sizeof block;
            const int count = hard ? LZ4_compress_HC((char *)original, (char *)block, size, room, LZ4HC_CLEVEL_MAX)
                                   : LZ4_compress_default((char *)original, (char *)block, size, room);
            assert_true(count > 0);
            for (unsigned p = 0; p < sizeof pieces / sizeof *pieces; p++) {
                const uint32_t window = sizes[s] < LZ4_BLOCK_REACH && p % 2 ? sizes[s] : LZ4_BLOCK_REACH + p;
                memset(output, 0, sizes[s]);
                assert_true(decode(block, (size_t)count, output, sizes[s], window, pieces[p]));
                assert_memory_equal(output, original, sizes[s]);
            }
        }
    }
}

static void a_block_that_is_cut_short_or_goes_on_is_refused(void **state)
{
    (void)state;
    fill_original(1000);
    const int count = LZ4_compress_default((char *)original, (char *)block, 1000, (int)sizeof block);
    for (size_t cut = 0; cut < (size_t)count; cut++)
        assert_false(decode(block, cut, output, 1000, 1000, 64));
    block[count] = 0;
    assert_false(decode(block, (size_t)count + 1, output, 1000, 1000, 64));
    assert_true(decode(block, (size_t)count, output, 1000, 1000, 64));
    assert_false(decode(block, (size_t)count, output, 999, 1000, 64));
    assert_false(decode(block, (size_t)count, output, 1001, 1001, 64));
}

static const struct wrong_block {
    const char *what;
    uint32_t output_bytes;
    bool good;
    uint8_t bytes[24];
    size_t count;
} wrong_blocks[] = {
    {"eight literals, a match of 7, five literals", 20, true,
     "\x83"
     "abcdefgh"
     "\x08\0"
     "\x50"
     "vwxyz",
     17},
    {"an offset of 0", 20, false,
     "\x83"
     "abcdefgh"
     "\0\0"
     "\x50"
     "vwxyz",
     17},
    {"an offset before the first byte", 20, false,
     "\x83"
     "abcdefgh"
     "\x09\0"
     "\x50"
     "vwxyz",
     17},
    {"a match that ends 4 bytes before the end", 19, false,
     "\x83"
     "abcdefgh"
     "\x08\0"
     "\x40"
     "vwxy",
     16},
    {"a long match that ends 4 bytes before the end", 24, false,
     "\x88"
     "abcdefgh"
     "\x08\0"
     "\x40"
     "vwxy",
     16},
    {"a long match that ends 5 bytes before the end", 25, true,
     "\x88"
     "abcdefgh"
     "\x08\0"
     "\x50"
     "vwxyz",
     17},
    {"a match that starts 12 bytes before the end", 15, true,
     "\x33"
     "abc"
     "\x03\0"
     "\x50"
     "vwxyz",
     12},
    {"a match that starts 11 bytes before the end", 14, false,
     "\x32"
     "abc"
     "\x03\0"
     "\x50"
     "vwxyz",
     12},
    {"a block that ends with a match", 12, false,
     "\x30"
     "abc"
     "\x03\0",
     6},
    {"a match before any literal", 20, false,
     "\x00\x01\0\x50"
     "vwxyz",
     9},
    {"more literals than output", 4, false,
     "\x50"
     "vwxyz",
     6},
    {"a length of literals beyond all output", 40, false, "\xf0\xff\xff\xff\xff", 5},
    {"a length of a match beyond all output", 40, false,
     "\x3f"
     "abc"
     "\x03\0\xff\xff",
     8},
    {"nothing", 1, false, "", 0},
    {"a low nibble in the last token", 5, true,
     "\x57"
     "vwxyz",
     6},
};

static void what_the_format_forbids_is_refused(void **state)
{
    (void)state;
    for (unsigned i = 0; i < sizeof wrong_blocks / sizeof *wrong_blocks; i++) {
        const struct wrong_block *w = &wrong_blocks[i];
        for (size_t piece = 1; piece < 20; piece += 18)
            if (decode(w->bytes, w->count, output, w->output_bytes, 64, piece) != w->good)
                fail_msg("%s: %s", w->what, w->good ? "refused" : "taken");
    }
}

static void after_a_wrong_block_the_next_is_decoded(void **state)
{
    (void)state;
    uint8_t window[64];
    struct lz4_block decoder = {.window = window, .window_bytes = sizeof window};
    for (unsigned turn = 0; turn < 3; turn++) {
        const struct wrong_block *w = &wrong_blocks[turn % 2];
        const uint8_t *in = w->bytes, *run;
        lz4_block_begin(&decoder, w->output_bytes);
        while (lz4_block_next(&decoder, &in, w->bytes + w->count, &run))
            ;
        assert_int_equal(lz4_block_complete(&decoder), w->good);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_liblz4_compresses_comes_back_whatever_the_pieces_and_the_window),
        cmocka_unit_test(a_block_that_is_cut_short_or_goes_on_is_refused),
        cmocka_unit_test(what_the_format_forbids_is_refused),
        cmocka_unit_test(after_a_wrong_block_the_next_is_decoded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
