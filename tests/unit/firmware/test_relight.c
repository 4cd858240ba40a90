/* SPDX-License-Identifier: MIT
 * The display loop draws what the library's rectangle draws, in whatever order bus and flash are ready. */
#include <signal.h>
#include <stdlib.h>
#if defined __x86_64__
#include <x86intrin.h>
#endif

#include "alarm.h"
#include "demo.h"
#include "orbit.h"
#include "relight.h"
#include "relight_board.h"
#include "unit.h"

enum { BACKGROUND = 0x1234 };

/* ---- a map and a loop over it ---- */

static uint32_t map[WIDTH * HEIGHT];
static uint8_t coverage[WIDTH * HEIGHT];
static bool has_coverage;
static const struct panel panel = {.bus = &hal.bus, .controller = PANEL_ST7789, .width = WIDTH, .height = HEIGHT};
static uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4], normals[2][WIDTH];
static uint16_t pixels[2][WIDTH];
static struct relight_extent extents[HEIGHT];
static struct relight relight;
static struct glint_paint paint;
static bool by_exact_pixels, is_dithered; /* exact ones alone */

static void put_normal(unsigned x, unsigned y)
{
    const int32_t v[3] = {(int32_t)x * 3 - 50, 30 - (int32_t)y * 5, 60};
    struct glint_vec normal;
    assert_int_equal(glint_vec_normalize(&normal, v), GLINT_OK);
    map[y * WIDTH + x] = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
}

/* Lines that are full or empty; the middle, one pixel, a hole, the sides. */
static bool has_surface(unsigned x, unsigned y)
{
    const unsigned kind = y % 6;
    return kind == 0 || (kind == 2 && x > 5 && x < 30) || (kind == 3 && x == 17) || (kind == 4 && (x < 9 || x > 15)) ||
           (kind == 5 && (x == 0 || x == WIDTH - 1));
}

static void make_map(void)
{
    for (unsigned y = 0; y < HEIGHT; y++) {
        uint32_t gap = 0;
        for (unsigned x = WIDTH; x-- > 0;) {
            gap = has_surface(x, y) ? 0 : gap + 1;
            if (gap)
                map[y * WIDTH + x] = gap; /* how many pixels have none from here on */
            else
                put_normal(x, y);
        }
    }
}

static const struct hal *hal_in_use = &hal;

static void make_paint(struct glint_paint *made, void *memory)
{
    struct glint_output output = demo_output;
    output.dither = by_exact_pixels && is_dithered;
    assert_int_equal(by_exact_pixels ? glint_paint_exact(made, &demo_gold, &output)
                                     : glint_paint_tables(made, GLINT_TABLES_COLOUR, &demo_gold, &output, memory,
                                                          GLINT_TABLES_COLOUR_BYTES),
                     GLINT_OK);
}

static void start_with_map(bool from_flash)
{
    memset(&board, 0, sizeof board);
    memset(&flash, 0, sizeof flash);
    memset(&frames, 0, sizeof frames);
    make_paint(&paint, tables);
    relight = (struct relight){.hal = hal_in_use,
                               .panel = &panel,
                               .map = map,
                               .coverage = has_coverage ? coverage : NULL,
                               .background = BACKGROUND,
                               .paint = &paint,
                               .pixels = {pixels[0], pixels[1]},
                               .extents = extents};
    for (unsigned i = 0; i < 2 && from_flash; i++)
        relight.normals[i] = normals[i];
    relight_start(&relight);
}

static void start(bool from_flash)
{
    make_map();
    start_with_map(from_flash);
}

/* One rectangle of the whole map, by a paint of its own. */
static void check_screen(const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    static uint32_t own_tables[GLINT_TABLES_COLOUR_BYTES / 4];
    uint16_t wanted[WIDTH * HEIGHT];
    struct glint_paint own;
    struct glint_light light;
    const struct glint_maps maps = {.normals = map,
                                    .normals_stride = 4 * WIDTH,
                                    .normals_format = GLINT_NORMALS_INT8,
                                    .coverage = has_coverage ? coverage : NULL,
                                    .coverage_stride = WIDTH};
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        wanted[i] = BACKGROUND;
    make_paint(&own, own_tables);
    assert_int_equal(glint_light_directional(&light, to_light), GLINT_OK);
    assert_int_equal(glint_paint_light(&own, &light, 1, to_viewer), GLINT_OK);
    assert_int_equal(
        glint_draw_rect(&own, &maps, WIDTH, HEIGHT, &(struct glint_surface){wanted, 2 * WIDTH, 0, 0}, NULL), GLINT_OK);
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
        assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
        unsigned steps = 0;
        while (relight.in_frame) {
            relight_step(&relight);
            if (rand() % 3 == 0)
                end_flush();
            if (rand() % 3 == 0)
                end_fetch();
            assert_true(++steps < 10000);
        }
        while (relight_step(&relight) == RELIGHT_BUSY)
            end_flush();
        check_screen(to_light);
    }
}

/* ---- tests ---- */

static void frames_are_the_librarys_whatever_ends_first(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed < 40; seed++) {
        start(true);
        run_frames(seed);
    }
}

static void exact_frames_are_the_exact_rectangle_without_memory_for_tables(void **state)
{
    (void)state;
    by_exact_pixels = true;
    for (unsigned seed = 1; seed < 20; seed++) {
        start(seed & 1);
        run_frames(seed);
    }
    by_exact_pixels = false;
}

static void a_map_in_ram_is_read_where_it_is(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed < 20; seed++) {
        start(false);
        run_frames(seed);
        assert_null(flash.to);
    }
}

static void two_cores_draw_what_one_does_whichever_is_first(void **state)
{
    (void)state;
    hal_in_use = &two_cores;
    for (unsigned seed = 1; seed < 40; seed++) {
        other.late = seed & 1;
        other.jobs = 0;
        start(seed & 2);
        run_frames(seed);
        assert_int_equal(other.jobs, 5 * HEIGHT);
    }
    hal_in_use = &hal;
}

static void what_has_no_surface_is_the_background_whatever_its_coverage(void **state)
{
    (void)state;
    has_coverage = true;
    memset(coverage, 255, sizeof coverage);
    start(false);
    run_frames(1);
    has_coverage = false;
}

/* At the ends of a surface, within it, at every pixel, at none. */
static void soft_edges_are_drawn_over_the_background_with_either_paint_on_one_core_or_two(void **state)
{
    (void)state;
    has_coverage = true;
    for (unsigned seed = 1; seed < 40; seed++) {
        srand(seed);
        for (unsigned i = 0; i < WIDTH * HEIGHT; i++) {
            const unsigned kind = i / WIDTH % 5, x = i % WIDTH;
            const bool is_edge = kind == 1 ? x < 8 || x > 27 : kind == 2 ? rand() % 9 == 0 : kind > 2;
            coverage[i] = !has_surface(x, i / WIDTH) ? 0 : is_edge ? (uint8_t)(1 + rand() % 255) : 255;
        }
        by_exact_pixels = seed % 3 == 0;
        is_dithered = seed % 2;
        hal_in_use = seed & 4 ? &two_cores : &hal;
        other.late = seed & 1;
        start(seed & 2);
        run_frames(seed);
    }
    by_exact_pixels = is_dithered = has_coverage = false;
    hal_in_use = &hal;
}

static void a_surface_all_over_with_a_soft_edge_is_drawn_over_the_background_anew_in_each_frame(void **state)
{
    (void)state;
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++) {
        put_normal(i % WIDTH, i / WIDTH);
        coverage[i] = i % WIDTH == WIDTH - 1 ? 100 : 255;
    }
    has_coverage = true;
    start_with_map(false);
    run_frames(8);
    has_coverage = false;
}

static void a_line_is_not_overwritten_while_it_is_sent(void **state)
{
    (void)state;
    start(false);
    int32_t to_light[3];
    orbit_light(to_light, 0, ORBIT_FRAMES);
    assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
    uint16_t before[WIDTH];
    relight_step(&relight); /* line 0 is sent */
    memcpy(before, board.pixels, sizeof before);
    for (unsigned i = 0; i < 10; i++) /* line 1 is shaded, and then it waits */
        assert_int_equal(relight_step(&relight), RELIGHT_BUSY);
    assert_memory_equal(before, board.pixels, sizeof before);
    assert_int_equal(board.windows, 1);
}

static void an_abandoned_frame_disturbs_no_other(void **state)
{
    (void)state;
    int32_t to_light[3];
    orbit_light(to_light, 7, ORBIT_FRAMES);
    start(true);
    assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
    end_fetch();
    relight_step(&relight); /* its first line is shaded; the second is being fetched, or the one after */
    end_fetch();
    relight_step(&relight);
    assert_non_null(flash.to);
    while (board.done)
        end_flush();
    relight_start(&relight);
    assert_int_equal(relight_step(&relight), RELIGHT_DONE); /* no frame was begun */
    flash.polls = 5;
    assert_int_equal(relight_frame(&relight, to_light), GLINT_OK); /* waits for the abandoned frame's fetch */
    assert_int_equal(flash.polls, 0);
    end_fetch();
    run_frames(3);
}

static void a_frame_begins_when_the_board_allows_it_and_asks_once(void **state)
{
    (void)state;
    start(false);
    int32_t to_light[3];
    orbit_light(to_light, 0, ORBIT_FRAMES);
    assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
    frames.waits = 7;
    for (unsigned i = 0; i < 6; i++)
        assert_int_equal(relight_step(&relight), RELIGHT_BUSY);
    assert_true(board.windows == 0 && !board.done && frames.asked == 6);
    while (relight_step(&relight) == RELIGHT_BUSY)
        end_flush();
    assert_true(board.windows == 1 && frames.asked == 7);
    check_screen(to_light);
}

static void send_line(void *unused)
{
    (void)unused;
    end_flush();
}

static void a_start_waits_for_the_interrupt_that_ends_the_last_line(void **state)
{
    (void)state;
    int32_t to_light[3];
    start(false);
    orbit_light(to_light, 0, ORBIT_FRAMES);
    assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
    while (!board.done)
        relight_step(&relight);
    set_alarm(send_line, NULL);
    relight_start(&relight);
    assert_null(board.done);
}

#if defined __x86_64__
static unsigned interrupts;

/* The line before has been sent, and then the one that waits, before the loop looks whether it has to send that. */
static void send_both(int number)
{
    (void)number;
    if (!relight.is_waiting || !board.done)
        return;
    while (end_flush())
        ;
    interrupts++;
}

static void a_line_that_interrupts_have_sent_is_not_sent_again(void **state)
{
    enum { TRAP = 0x100 /* after each instruction */ };
    (void)state;
    int32_t to_light[3];
    start(false);
    orbit_light(to_light, 3, ORBIT_FRAMES);
    assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
    signal(SIGTRAP, send_both);
    while (relight.in_frame) {
        __writeeflags(__readeflags() | TRAP);
        relight_step(&relight);
        __writeeflags(__readeflags() & ~(unsigned long long)TRAP);
    }
    signal(SIGTRAP, SIG_DFL);
    end_flush();
    assert_int_equal(relight_step(&relight), RELIGHT_DONE);
    assert_true(interrupts >= HEIGHT / 2);
    check_screen(to_light);
}
#endif

static void a_map_without_gaps_is_drawn_without_the_background(void **state)
{
    (void)state;
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++)
            put_normal(x, y);
    start_with_map(false);
    assert_false(relight.has_gaps);
    run_frames(5);
    by_exact_pixels = true;
    start_with_map(false);
    run_frames(6);
    by_exact_pixels = false;
}

static void an_impossible_light_is_refused_and_no_frame_begins(void **state)
{
    (void)state;
    static const int32_t none[3] = {0, 0, 0}, behind[3] = {0, 0, -1};
    start(true);
    assert_int_equal(relight_frame(&relight, none), GLINT_ERR_VECTOR);
    assert_int_equal(relight_frame(&relight, behind), GLINT_ERR_VECTOR);
    assert_int_equal(relight_step(&relight), RELIGHT_DONE);
    assert_int_equal(board.windows, 0);
}

static void a_paint_that_is_none_or_of_another_format_is_refused_and_no_frame_begins(void **state)
{
    (void)state;
    const struct glint_output grey = {.format = GLINT_GREY8};
    int32_t to_light[3];
    orbit_light(to_light, 0, ORBIT_FRAMES);
    start(false);
    paint = (struct glint_paint){0};
    assert_int_equal(relight_frame(&relight, to_light), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact(&paint, &demo_gold, &grey), GLINT_OK);
    assert_int_equal(relight_frame(&relight, to_light), GLINT_ERR_FORMAT);
    assert_int_equal(relight_step(&relight), RELIGHT_DONE);
    assert_int_equal(board.windows, 0);
}

/* The pattern goes by the place on the screen, of which each line draws a part. */
static void a_dithered_paint_is_dithered_across_lines_and_cores(void **state)
{
    (void)state;
    const struct glint_output dithered = {.format = GLINT_RGB565_SWAPPED, .dither = true};
    const struct glint_maps maps = {.normals = map, .normals_stride = 4 * WIDTH, .normals_format = GLINT_NORMALS_INT8};
    uint16_t wanted[WIDTH * HEIGHT];
    int32_t to_light[3];
    hal_in_use = &two_cores;
    start(true);
    hal_in_use = &hal;
    assert_int_equal(glint_paint_exact(&paint, &demo_gold, &dithered), GLINT_OK);
    orbit_light(to_light, 99, ORBIT_FRAMES);
    assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
    for (unsigned steps = 0; relight_step(&relight) == RELIGHT_BUSY; steps++) {
        end_flush();
        end_fetch();
        assert_true(steps < 1000);
    }
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        wanted[i] = BACKGROUND;
    assert_int_equal(
        glint_draw_rect(&paint, &maps, WIDTH, HEIGHT, &(struct glint_surface){wanted, 2 * WIDTH, 0, 0}, NULL),
        GLINT_OK);
    assert_memory_equal(board.screen, wanted, sizeof wanted);
}

static void a_bus_that_fails_is_reported(void **state)
{
    (void)state;
    int32_t to_light[3];
    start(false);
    board.broken = true;
    orbit_light(to_light, 0, ORBIT_FRAMES);
    assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
    assert_int_equal(relight_step(&relight), RELIGHT_BUS_FAILED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_the_librarys_whatever_ends_first),
        cmocka_unit_test(exact_frames_are_the_exact_rectangle_without_memory_for_tables),
        cmocka_unit_test(a_map_in_ram_is_read_where_it_is),
        cmocka_unit_test(two_cores_draw_what_one_does_whichever_is_first),
        cmocka_unit_test(what_has_no_surface_is_the_background_whatever_its_coverage),
        cmocka_unit_test(soft_edges_are_drawn_over_the_background_with_either_paint_on_one_core_or_two),
        cmocka_unit_test(a_surface_all_over_with_a_soft_edge_is_drawn_over_the_background_anew_in_each_frame),
        cmocka_unit_test(a_line_is_not_overwritten_while_it_is_sent),
        cmocka_unit_test(an_abandoned_frame_disturbs_no_other),
        cmocka_unit_test(a_frame_begins_when_the_board_allows_it_and_asks_once),
        cmocka_unit_test(a_start_waits_for_the_interrupt_that_ends_the_last_line),
#if defined __x86_64__
        cmocka_unit_test(a_line_that_interrupts_have_sent_is_not_sent_again),
#endif
        cmocka_unit_test(a_map_without_gaps_is_drawn_without_the_background),
        cmocka_unit_test(an_impossible_light_is_refused_and_no_frame_begins),
        cmocka_unit_test(a_paint_that_is_none_or_of_another_format_is_refused_and_no_frame_begins),
        cmocka_unit_test(a_dithered_paint_is_dithered_across_lines_and_cores),
        cmocka_unit_test(a_bus_that_fails_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
