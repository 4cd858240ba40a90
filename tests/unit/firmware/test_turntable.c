/* SPDX-License-Identifier: MIT
 * The display loop of a mesh draws what the library draws in one strip, in whatever order the bus and another core are ready. */
#include "demo.h"
#include "meshes.h"
#include "turntable.h"

enum { WIDTH = 37, HEIGHT = 69 };
#include "alarm.h"
#include "panel_board.h"

enum { STRIPS = 5, LOWER_Y = 32, BACKGROUND = 0x1234, CORE_BYTES = 16384 };

/* ---- another core, which runs as early or as late as it can ---- */

static struct {
    void (*job)(void *);
    void *argument;
    bool late, is_forked;
    unsigned jobs;
} other;

/* It waits for strips of the last picture, which are sent meanwhile. */
static bool waits_by_itself;

static void run_other(void)
{
    while (!waits_by_itself && end_flush())
        ;
    other.job(other.argument);
    other.jobs++;
}

static void on_fork(void *context, void (*job)(void *), void *argument)
{
    (void)context;
    assert_false(other.is_forked);
    other.is_forked = true;
    other.job = job;
    other.argument = argument;
    if (!other.late)
        run_other();
}

static void on_join(void *context)
{
    (void)context;
    assert_true(other.is_forked);
    other.is_forked = false;
    if (other.late)
        run_other();
}

static const struct hal one_core = {.bus = {.command = on_command, .data = on_data}, .flush = on_flush},
                        two_cores = {.bus = {.command = on_command, .data = on_data},
                                     .flush = on_flush,
                                     .fork = on_fork,
                                     .join = on_join};

/* ---- a ball that turns ---- */

static struct made_mesh ball;
static uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4], memory[2][CORE_BYTES / 4],
    strips[STRIPS * WIDTH * TURNTABLE_LINES / 2];
static struct panel panel = {.controller = PANEL_ST7789, .width = WIDTH, .height = HEIGHT};
static struct glint_paint paint;
static struct turntable turntable;

static void set_up(const struct hal *hal)
{
    memset(&board, 0, sizeof board);
    memset(&other, 0, sizeof other);
    mesh_ball(&ball, 9, 14);
    panel.bus = &hal->bus;
    turntable = (struct turntable){.pieces = {.hal = hal, .panel = &panel},
                                   .mesh = &ball.mesh,
                                   .paint = &paint,
                                   .memory_bytes = CORE_BYTES,
                                   .strips = strips,
                                   .strip_count = hal->fork ? STRIPS : 2,
                                   .lower_y = hal->fork ? LOWER_Y : HEIGHT,
                                   .background = BACKGROUND,
                                   .core = {{.memory = memory[0]}, {.memory = memory[1]}}};
}

static void make_paint(struct glint_paint *made, void *at)
{
    assert_int_equal(
        glint_paint_tables(made, GLINT_TABLES_COLOUR, &demo_gold, &demo_output, at, GLINT_TABLES_COLOUR_BYTES),
        GLINT_OK);
}

/* By a paint of its own. */
static void check_screen(const struct glint_pose *pose)
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    static uint32_t of_frame[8192], of_mesh[4096], own_tables[GLINT_TABLES_COLOUR_BYTES / 4];
    uint16_t wanted[WIDTH * HEIGHT];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    struct glint_paint own;
    struct glint_light light;
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        wanted[i] = BACKGROUND;
    make_paint(&own, own_tables);
    assert_int_equal(glint_light_directional(&light, demo_mesh_light), GLINT_OK);
    assert_int_equal(glint_paint_light(&own, &light, 1, to_viewer), GLINT_OK);
    assert_int_equal(glint_mesh_begin(&frame, WIDTH, HEIGHT, HEIGHT, 0, of_frame, sizeof of_frame), GLINT_OK);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &ball.mesh, pose, &own, of_mesh, sizeof of_mesh), GLINT_OK);
    assert_int_equal(glint_mesh_strip(&frame, 0, HEIGHT, &(struct glint_surface){wanted, 2 * WIDTH, 0, 0}), GLINT_OK);
    assert_memory_equal(board.screen, wanted, sizeof wanted);
}

static void start(const struct hal *hal)
{
    set_up(hal);
    make_paint(&paint, tables);
    assert_int_equal(turntable_start(&turntable), GLINT_OK);
}

/* Frames back to back; transfers end at random. At the end of each its picture is complete. */
static void run_frames(unsigned run)
{
    srand(run);
    for (uint32_t frame = 0; frame < 6; frame++) {
        struct glint_pose pose;
        demo_pose(&pose, frame * 37 + run, WIDTH);
        assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
        for (unsigned steps = 0; turntable.in_frame; steps++) {
            assert_int_equal(turntable_step(&turntable), TURNTABLE_BUSY);
            if (rand() % 3 == 0)
                end_flush();
            assert_true(steps < 1000);
        }
        if (frame % 2) /* else the next one follows while this one is sent */
            continue;
        while (turntable_step(&turntable) == TURNTABLE_BUSY)
            end_flush();
        check_screen(&pose);
    }
}

/* ---- tests ---- */

static void frames_are_the_librarys_however_slow_the_bus_is(void **state)
{
    (void)state;
    for (unsigned run = 1; run < 30; run++) {
        start(&one_core);
        run_frames(run);
        assert_int_equal(board.windows, 6);
    }
}

static void two_cores_draw_what_one_does_whichever_is_first(void **state)
{
    (void)state;
    for (unsigned run = 1; run < 30; run++) {
        start(&two_cores);
        other.late = run & 1;
        run_frames(run);
        assert_int_equal(other.jobs, 6);
    }
}

static void a_ball_of_the_demo_is_lit_from_the_left_above(void **state)
{
    (void)state;
    struct glint_pose pose;
    uint32_t left = 0, right = 0, above = 0, below = 0;
    start(&one_core);
    demo_pose(&pose, 0, WIDTH);
    assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
    while (turntable_step(&turntable) == TURNTABLE_BUSY)
        end_flush();
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            const uint16_t pixel = board.screen[y * WIDTH + x];
            const uint32_t green = pixel == BACKGROUND ? 0 : pixel >> 5 & 63;
            *(x < WIDTH / 2 ? &left : &right) += green;
            *(y < HEIGHT / 2 ? &above : &below) += green;
        }
    assert_true(left > right + right / 4);
    assert_true(above > below + below / 4);
}

static void a_stop_waits_for_the_other_core_and_the_bus(void **state)
{
    (void)state;
    struct glint_pose pose;
    for (unsigned drawn = 1; drawn < LOWER_Y / TURNTABLE_LINES; drawn++) {
        start(&two_cores);
        demo_pose(&pose, 0, WIDTH);
        assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
        while (turntable.line < drawn * TURNTABLE_LINES) {
            turntable_step(&turntable);
            end_flush();
        }
        assert_true(other.is_forked);
        turntable_stop(&turntable);
        assert_false(other.is_forked);
        assert_false(turntable.in_frame);
        assert_int_equal(turntable_step(&turntable), TURNTABLE_DONE);
        run_frames(3);
    }
}

static void a_stop_after_a_frame_does_not_wait_for_a_core_that_is_done(void **state)
{
    (void)state;
    start(&two_cores);
    run_frames(2);
    while (turntable_step(&turntable) == TURNTABLE_BUSY)
        end_flush();
    turntable_stop(&turntable); /* on_join fails where nothing was forked */
    turntable_stop(&turntable);
    run_frames(3);
    assert_int_equal(other.jobs, 12);
}

static void send_all(void *unused)
{
    (void)unused;
    while (end_flush())
        ;
}

static void a_stop_waits_for_the_interrupt_that_ends_the_last_transfer(void **state)
{
    (void)state;
    struct glint_pose pose;
    start(&one_core);
    demo_pose(&pose, 0, WIDTH);
    assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
    while (turntable.pieces.added == 0)
        turntable_step(&turntable);
    assert_non_null(board.done);
    set_alarm(send_all, NULL);
    turntable_stop(&turntable);
    assert_null(board.done);
}

/* As on the board, where the bus sends on while the other core waits for memory of the picture before. */
static void the_other_core_waits_for_the_interrupt_that_ends_its_last_strip(void **state)
{
    (void)state;
    struct glint_pose pose;
    start(&two_cores);
    waits_by_itself = true;
    for (uint32_t frame = 0; frame < 2; frame++) {
        demo_pose(&pose, frame * 37, WIDTH);
        assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
        while (turntable.in_frame) {
            if (turntable.is_begun)
                send_all(NULL); /* for the core that does not wait */
            else if (frame)
                set_alarm(send_all, NULL);
            turntable_step(&turntable);
            stop_alarm(); /* it would come in the middle of send_all */
        }
    }
    waits_by_itself = false;
    send_all(NULL);
    check_screen(&pose);
}

static void a_quaternion_of_zero_leaves_the_last_picture(void **state)
{
    (void)state;
    const struct glint_pose none = {{0, 0, 0, 0}, {0, 0, 0}, 100};
    start(&one_core);
    assert_int_equal(turntable_frame(&turntable, &none, demo_mesh_light), GLINT_ERR_VECTOR);
    assert_int_equal(turntable_step(&turntable), TURNTABLE_DONE);
    assert_int_equal(board.windows, 0);
    for (int i = 0; i < 4; i++) {
        struct glint_pose pose = none;
        pose.turn[i] = 1;
        assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
    }
}

static void memory_of_just_its_bytes_is_enough(void **state)
{
    (void)state;
    set_up(&one_core);
    make_paint(&paint, tables);
    const uint32_t bytes = (uint32_t)(((glint_mesh_bytes(&ball.mesh, HEIGHT) + 3) & ~(size_t)3) +
                                      glint_mesh_frame_bytes(WIDTH, TURNTABLE_LINES));
    turntable.memory_bytes = bytes;
    assert_int_equal(turntable_start(&turntable), GLINT_OK);
    turntable.memory_bytes = bytes - 1;
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
}

static void what_it_cannot_draw_is_refused_at_the_start(void **state)
{
    (void)state;
    uint16_t ends[2] = {1, 0};
    set_up(&one_core);
    ball.faces[7][1] = ball.mesh.vertex_count;
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
    set_up(&one_core);
    ends[1] = ball.mesh.face_count;
    ball.mesh.ends = ends;
    ball.mesh.part_count = 2;
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
    set_up(&one_core);
    turntable.memory_bytes = 2048;
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
    set_up(&two_cores);
    turntable.strip_count = STRIPS - 1;
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
    turntable.strip_count = TURNTABLE_STRIPS_MAX + 1;
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
    set_up(&two_cores);
    turntable.core[1].memory = NULL;
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
    set_up(&two_cores);
    turntable.pieces.hal = &one_core; /* half of the picture for a core that is not there */
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
}

static void two_cores_have_a_strip_for_a_last_line_by_itself(void **state)
{
    (void)state;
    struct panel short_panel;
    set_up(&two_cores);
    short_panel = panel;
    short_panel.height = TURNTABLE_LINES * (STRIPS - 2) + 1;
    turntable.pieces.panel = &short_panel;
    turntable.lower_y = TURNTABLE_LINES;
    turntable.strip_count = STRIPS - 1;
    assert_int_equal(turntable_start(&turntable), GLINT_OK);
    turntable.strip_count = STRIPS - 2;
    assert_int_equal(turntable_start(&turntable), GLINT_ERR_ARG);
}

static void a_light_or_a_paint_that_cannot_be_is_refused_and_nothing_begins(void **state)
{
    (void)state;
    static const int32_t none[3] = {0, 0, 0}, behind[3] = {0, 0, -1};
    const struct glint_output grey = {.format = GLINT_GREY8};
    struct glint_pose pose;
    start(&one_core);
    demo_pose(&pose, 0, WIDTH);
    assert_int_equal(turntable_frame(&turntable, &pose, none), GLINT_ERR_VECTOR);
    assert_int_equal(turntable_frame(&turntable, &pose, behind), GLINT_ERR_VECTOR);
    paint = (struct glint_paint){0};
    assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_exact(&paint, &demo_gold, &grey), GLINT_OK);
    assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_ERR_FORMAT);
    assert_int_equal(turntable_step(&turntable), TURNTABLE_DONE);
    assert_int_equal(board.windows, 0);
}

static void a_bus_that_fails_is_reported(void **state)
{
    (void)state;
    struct glint_pose pose;
    start(&one_core);
    board.broken = true;
    demo_pose(&pose, 0, WIDTH);
    assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
    assert_int_equal(turntable_step(&turntable), TURNTABLE_BUSY);
    assert_int_equal(turntable_step(&turntable), TURNTABLE_BUSY);
    assert_int_equal(turntable_step(&turntable), TURNTABLE_BUS_FAILED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_the_librarys_however_slow_the_bus_is),
        cmocka_unit_test(two_cores_draw_what_one_does_whichever_is_first),
        cmocka_unit_test(a_ball_of_the_demo_is_lit_from_the_left_above),
        cmocka_unit_test(a_stop_waits_for_the_other_core_and_the_bus),
        cmocka_unit_test(a_stop_after_a_frame_does_not_wait_for_a_core_that_is_done),
        cmocka_unit_test(a_stop_waits_for_the_interrupt_that_ends_the_last_transfer),
        cmocka_unit_test(the_other_core_waits_for_the_interrupt_that_ends_its_last_strip),
        cmocka_unit_test(a_quaternion_of_zero_leaves_the_last_picture),
        cmocka_unit_test(memory_of_just_its_bytes_is_enough),
        cmocka_unit_test(what_it_cannot_draw_is_refused_at_the_start),
        cmocka_unit_test(two_cores_have_a_strip_for_a_last_line_by_itself),
        cmocka_unit_test(a_light_or_a_paint_that_cannot_be_is_refused_and_nothing_begins),
        cmocka_unit_test(a_bus_that_fails_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
