/* SPDX-License-Identifier: MIT
 * The display loop of a palette draws what the library's palette draws, in whatever order bus and flash are ready. */
#include <stdlib.h>

#include "demo.h"
#include "orbit.h"
#include "recolour.h"
#include "relight_board.h"
#include "unit.h"

enum { ENTRIES = 300, LINE = WIDTH - 1 /* even */, PIXELS = LINE * HEIGHT, BACKGROUND = 0x1234 };

static const struct panel panel = {.bus = &hal.bus, .controller = PANEL_ST7789, .width = LINE, .height = HEIGHT};
static struct glint_vec normals[ENTRIES];
static uint32_t places[PIXELS / 2], fetched[2][LINE / 2];
static uint16_t colours[ENTRIES], bands[2][PANEL_BAND * LINE];
static struct glint_paint paint;
static struct recolour recolour;

static void start(void)
{
    memset(&board, 0, sizeof board);
    memset(&flash, 0, sizeof flash);
    for (int i = 1; i < ENTRIES; i++) { /* the first is no surface */
        const int32_t v[3] = {i % 17 - 8, i % 23 - 11, 9};
        assert_int_equal(glint_vec_normalize(&normals[i], v), GLINT_OK);
    }
    for (unsigned i = 0; i < PIXELS; i++) {
        const uint16_t place = (uint16_t)(i * 7919 % ENTRIES * 2);
        memcpy((uint16_t *)(void *)places + i, &place, sizeof place);
    }
    assert_int_equal(glint_paint_exact(&paint, &demo_gold, &demo_output), GLINT_OK);
    recolour = (struct recolour){.pieces = {.hal = &hal, .panel = &panel},
                                 .normals = normals,
                                 .entries = ENTRIES,
                                 .places = places,
                                 .background = BACKGROUND,
                                 .paint = &paint,
                                 .colours = colours,
                                 .fetched = {fetched[0], fetched[1]},
                                 .bands = {bands[0], bands[1]}};
}

static void check_screen(const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    uint16_t own_colours[ENTRIES], wanted[PIXELS];
    const struct glint_surface line = {own_colours, 0, 0, 0}, all = {wanted, 2 * LINE, 0, 0};
    const struct glint_maps maps = {.normals = normals};
    struct glint_paint own;
    struct glint_light light;
    assert_int_equal(glint_paint_exact(&own, &demo_gold, &demo_output), GLINT_OK);
    assert_int_equal(glint_light_directional(&light, to_light), GLINT_OK);
    assert_int_equal(glint_paint_light(&own, &light, 1, to_viewer), GLINT_OK);
    assert_int_equal(glint_draw_rect(&own, &maps, ENTRIES, 1, &line, NULL), GLINT_OK);
    own_colours[0] = BACKGROUND;
    assert_int_equal(
        glint_draw_palette(own_colours, (const uint16_t *)(const void *)places, 2 * LINE, LINE, HEIGHT, &all),
        GLINT_OK);
    assert_memory_equal(board.screen, wanted, sizeof wanted);
}

/* Frames back to back, transfers end in an order that the seed decides. */
static void run_frames(unsigned seed)
{
    srand(seed);
    for (uint32_t frame = 0; frame < 5; frame++) {
        int32_t to_light[3];
        orbit_light(to_light, frame * 50 + seed, ORBIT_FRAMES);
        end_fetch();
        assert_int_equal(recolour_frame(&recolour, to_light), GLINT_OK);
        unsigned steps = 0;
        while (recolour.in_frame) {
            assert_int_equal(recolour_step(&recolour), RECOLOUR_BUSY);
            if (rand() % 3 == 0)
                end_flush();
            if (rand() % 3 == 0)
                end_fetch();
            assert_true(++steps < 10000);
        }
        while (recolour_step(&recolour) == RECOLOUR_BUSY)
            end_flush();
        check_screen(to_light);
    }
}

/* ---- tests ---- */

static void frames_are_the_librarys_whatever_ends_first(void **state)
{
    (void)state;
    for (unsigned seed = 0; seed < 200; seed++) {
        start();
        run_frames(seed);
    }
}

static void an_abandoned_frame_disturbs_no_other(void **state)
{
    (void)state;
    for (unsigned lines = 0; lines < HEIGHT; lines++) {
        start();
        int32_t to_light[3];
        orbit_light(to_light, 7, ORBIT_FRAMES);
        assert_int_equal(recolour_frame(&recolour, to_light), GLINT_OK);
        for (unsigned i = 0; i < lines; i++) {
            end_fetch();
            while (end_flush())
                ;
            assert_int_equal(recolour_step(&recolour), RECOLOUR_BUSY);
        }
        while (end_flush())
            ;
        recolour_stop(&recolour);
        assert_int_equal(recolour_step(&recolour), RECOLOUR_DONE);
        flash.polls = 3;
        assert_int_equal(recolour_frame(&recolour, to_light), GLINT_OK); /* waits for the abandoned frame's fetch */
        flash.polls = 0;
        run_frames(lines);
    }
}

static void what_cannot_be_lit_or_is_not_plain_rgb565_begins_no_frame(void **state)
{
    (void)state;
    const struct glint_output grey = {.format = GLINT_GREY8}, dithered = {.format = GLINT_RGB565, .dither = true};
    start();
    assert_int_equal(recolour_frame(&recolour, (int32_t[]){0, 0, 0}), GLINT_ERR_VECTOR);
    assert_int_equal(recolour_frame(&recolour, (int32_t[]){0, 0, -1}), GLINT_ERR_VECTOR);
    recolour.normals = NULL;
    assert_int_equal(recolour_frame(&recolour, (int32_t[]){0, 0, 1}), GLINT_ERR_ARG);
    recolour.normals = normals;
    assert_int_equal(glint_paint_exact(&paint, &demo_gold, &grey), GLINT_OK);
    assert_int_equal(recolour_frame(&recolour, (int32_t[]){0, 0, 1}), GLINT_ERR_FORMAT);
    assert_int_equal(glint_paint_exact(&paint, &demo_gold, &dithered), GLINT_OK);
    assert_int_equal(recolour_frame(&recolour, (int32_t[]){0, 0, 1}), GLINT_ERR_FORMAT);
    paint = (struct glint_paint){0};
    assert_int_equal(recolour_frame(&recolour, (int32_t[]){0, 0, 1}), GLINT_ERR_ARG);
    assert_int_equal(recolour_step(&recolour), RECOLOUR_DONE);
    assert_true(!flash.to && board.windows == 0);
}

static void a_bus_that_fails_is_told(void **state)
{
    (void)state;
    start();
    board.broken = true;
    assert_int_equal(recolour_frame(&recolour, (int32_t[]){0, 0, 1}), GLINT_OK);
    enum recolour_step step = RECOLOUR_BUSY;
    for (unsigned i = 0; i < 2 * HEIGHT && step == RECOLOUR_BUSY; i++) {
        end_fetch();
        end_flush();
        step = recolour_step(&recolour);
    }
    assert_int_equal(step, RECOLOUR_BUS_FAILED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_the_librarys_whatever_ends_first),
        cmocka_unit_test(an_abandoned_frame_disturbs_no_other),
        cmocka_unit_test(what_cannot_be_lit_or_is_not_plain_rgb565_begins_no_frame),
        cmocka_unit_test(a_bus_that_fails_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
