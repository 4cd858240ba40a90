/* SPDX-License-Identifier: MIT
 * The display loops on a round panel, seen through the virtual one: the picture inside the circle is the library's at every turn, and what
 * lies outside is neither shaded nor sent. */
#include <stdlib.h>

#include "demo.h"
#include "meshes.h"
#include "orbit.h"
#include "relight.h"
#include "sinks/panel/virtual_panel.h"
#include "turntable.h"
#include "unit.h"

enum { SIDE = 240, BACKGROUND = 0x2345, CORE_BYTES = 65536 };

/* ---- a bus to a virtual panel, whose transfers end late ---- */

static struct virtual_panel screen;
static struct panel_bus glass;
static struct {
    const uint16_t *pixels;
    size_t count, sent, windows;
    bool broken;
    void (*done)(void *);
    void *argument;
} bus;

static bool end_flush(void)
{
    void (*const done)(void *) = bus.done;
    for (size_t i = 0; done && i < bus.count; i++) {
        const uint8_t bytes[] = {(uint8_t)(bus.pixels[i] >> 8), (uint8_t)bus.pixels[i]};
        virtual_panel_data(&screen, bytes, 2);
    }
    bus.done = NULL;
    if (done)
        done(bus.argument);
    return done;
}

static void on_flush(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    assert_null(bus.done);
    bus.pixels = pixels;
    bus.count = count;
    bus.done = done;
    bus.argument = argument;
    bus.sent += count;
}

/* As on a board: what is on its way goes first. It may begin a transfer itself. */
static bool on_command(void *context, uint8_t command)
{
    (void)context;
    while (end_flush())
        ;
    bus.windows += command == PANEL_MEMORY_WRITE;
    return !bus.broken && glass.command(glass.context, command);
}

static bool on_data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    return glass.data(glass.context, bytes, count);
}

static void on_wait(void *context, unsigned ms)
{
    (void)context;
    (void)ms;
}

static const struct hal hal = {.bus = {.command = on_command, .data = on_data, .wait_ms = on_wait}, .flush = on_flush};
static struct panel panel = {.bus = &hal.bus};

static void start_panel(unsigned rotation)
{
    assert_true(panel_defaults(&panel, PANEL_GC9A01, (uint8_t)rotation, SIDE, SIDE));
    const struct virtual_glass kind = virtual_glass_of(&panel);
    virtual_panel_init(&screen, &kind);
    glass = virtual_panel_bus(&screen);
    memset(&bus, 0, sizeof bus);
    assert_true(panel_start(&panel) && panel_show(&panel, PANEL_BRIGHTEST));
}

static bool is_outside(unsigned x, unsigned y)
{
    const int across = x < 120 ? 119 - (int)x : (int)x - 120, down = y < 120 ? 119 - (int)y : (int)y - 120;
    return across * across + down * down >= 120 * 120;
}

static void check_seen(const uint16_t *wanted)
{
    static uint8_t seen[SIDE * SIDE * 3];
    virtual_panel_look(&screen, panel.rotation, seen);
    for (unsigned i = 0; i < SIDE * SIDE; i++) {
        const unsigned color = is_outside(i % SIDE, i / SIDE) ? 0 : wanted[i];
        assert_int_equal(seen[3 * i], ((color >> 11) * 255 + 15) / 31);
        assert_int_equal(seen[3 * i + 1], ((color >> 5 & 63) * 255 + 31) / 63);
        assert_int_equal(seen[3 * i + 2], ((color & 31) * 255 + 15) / 31);
    }
}

/* ---- tests ---- */

static uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4], map[SIDE * SIDE];
static uint16_t pixels[2][SIDE], wanted[SIDE * SIDE];
static struct relight_extent extents[SIDE];
static struct glint_paint paint;
static const int32_t to_viewer[3] = {0, 0, 1};

static void light_paint(const int32_t to_light[3])
{
    struct glint_light light;
    assert_int_equal(glint_paint_tables(&paint, GLINT_TABLES_COLOUR, &demo_gold, &demo_output, tables, sizeof tables),
                     GLINT_OK);
    assert_int_equal(glint_light_directional(&light, to_light), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &light, 1, to_viewer), GLINT_OK);
    for (unsigned i = 0; i < SIDE * SIDE; i++)
        wanted[i] = BACKGROUND;
}

/* Everywhere, with holes, or nowhere near the rim. */
static void make_map(unsigned kind)
{
    for (unsigned i = 0; i < SIDE * SIDE; i++) {
        const int32_t x = (int32_t)(i % SIDE) - 120, y = (int32_t)(i / SIDE) - 120, v[3] = {x, -y, 150};
        struct glint_vec normal;
        assert_int_equal(glint_vec_normalize(&normal, v), GLINT_OK);
        const bool is_gap = (kind == 1 && (i / 7) % 5 == 0) || (kind == 2 && x * x + y * y > 100 * 100);
        map[i] = is_gap ? 1 : glint_normals_pack(GLINT_NORMALS_INT8, &normal);
    }
}

static void maps_are_the_librarys_at_every_turn_and_nothing_outside_is_shaded_or_sent(void **state)
{
    (void)state;
    for (unsigned run = 0; run < 12; run++) {
        const unsigned kind = run / 4;
        struct relight relight = {.hal = &hal,
                                  .panel = &panel,
                                  .map = map,
                                  .background = BACKGROUND,
                                  .paint = &paint,
                                  .pixels = {pixels[0], pixels[1]},
                                  .extents = extents};
        int32_t to_light[3];
        make_map(kind);
        start_panel(run % 4);
        orbit_light(to_light, run * 19, ORBIT_FRAMES);
        light_paint(to_light);
        relight_start(&relight);
        for (unsigned frame = 0; frame < 2; frame++) {
            bus.sent = bus.windows = 0;
            assert_int_equal(relight_frame(&relight, to_light), GLINT_OK);
            srand(run);
            while (relight.in_frame) {
                relight_step(&relight);
                if (rand() % 3 == 0)
                    end_flush();
            }
            while (end_flush())
                ;
        }
        const struct glint_maps maps = {
            .normals = map, .normals_stride = 4 * SIDE, .normals_format = GLINT_NORMALS_INT8};
        assert_int_equal(
            glint_draw_rect(&paint, &maps, SIDE, SIDE, &(struct glint_surface){wanted, 2 * SIDE, 0, 0}, NULL),
            GLINT_OK);
        check_seen(wanted);
        assert_int_equal(bus.windows, SIDE / PANEL_BAND);
        assert_int_equal(bus.sent * 2 + bus.windows * 11, 94410); /* of 115211: 18 % are not sent */
        unsigned shaded = 0;
        for (unsigned y = 0; y < SIDE; y++) {
            shaded += extents[y].count;
            assert_true(extents[y].count == 0 ||
                        (!is_outside(extents[y].first, y) && !is_outside(extents[y].first + extents[y].count - 1u, y)));
        }
        assert_true(kind || shaded == 45692); /* of 57600: 20.7 % are not shaded */
    }
}

static void meshes_are_the_librarys_at_every_turn_and_nothing_outside_is_sent(void **state)
{
    (void)state;
    static struct made_mesh ball;
    static uint32_t memory[CORE_BYTES / 4], strips[2 * SIDE * TURNTABLE_LINES / 2], of_frame[1 << 16];
    mesh_ball(&ball, 9, 14);
    for (unsigned rotation = 0; rotation < 4; rotation++) {
        struct turntable turntable = {.pieces = {.hal = &hal, .panel = &panel},
                                      .mesh = &ball.mesh,
                                      .paint = &paint,
                                      .memory_bytes = CORE_BYTES,
                                      .strips = strips,
                                      .strip_count = 2,
                                      .lower_y = SIDE,
                                      .background = BACKGROUND,
                                      .core = {{.memory = memory}}};
        struct glint_mesh_frame frame;
        struct glint_mesh_drawn drawn;
        struct glint_pose pose;
        start_panel(rotation);
        light_paint(demo_mesh_light);
        assert_int_equal(turntable_start(&turntable), GLINT_OK);
        demo_pose(&pose, 31 * rotation, SIDE);
        for (unsigned i = 0; i < 2; i++) {
            bus.sent = 0;
            assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
            srand(rotation);
            while (turntable_step(&turntable) == TURNTABLE_BUSY)
                if (rand() % 3 == 0)
                    end_flush();
        }
        assert_int_equal(glint_mesh_begin(&frame, SIDE, SIDE, SIDE, 0, of_frame, sizeof of_frame), GLINT_OK);
        assert_int_equal(glint_mesh_add(&frame, &drawn, &ball.mesh, &pose, &paint, memory, sizeof memory), GLINT_OK);
        assert_int_equal(glint_mesh_strip(&frame, 0, SIDE, &(struct glint_surface){wanted, 2 * SIDE, 0, 0}), GLINT_OK);
        check_seen(wanted);
        assert_int_equal(bus.sent * 2, 94410 - 11 * SIDE / PANEL_BAND);
    }
}

static void a_bus_that_fails_is_told(void **state)
{
    (void)state;
    static struct made_mesh ball;
    static uint32_t memory[CORE_BYTES / 4], strips[2 * SIDE * TURNTABLE_LINES / 2];
    mesh_ball(&ball, 9, 14);
    struct turntable turntable = {.pieces = {.hal = &hal, .panel = &panel},
                                  .mesh = &ball.mesh,
                                  .paint = &paint,
                                  .memory_bytes = CORE_BYTES,
                                  .strips = strips,
                                  .strip_count = 2,
                                  .lower_y = SIDE,
                                  .core = {{.memory = memory}}};
    struct glint_pose pose;
    start_panel(0);
    light_paint(demo_mesh_light);
    demo_pose(&pose, 0, SIDE);
    assert_int_equal(turntable_start(&turntable), GLINT_OK);
    assert_int_equal(turntable_frame(&turntable, &pose, demo_mesh_light), GLINT_OK);
    bus.broken = true;
    enum turntable_step step;
    while ((step = turntable_step(&turntable)) == TURNTABLE_BUSY)
        end_flush();
    assert_int_equal(step, TURNTABLE_BUS_FAILED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_are_the_librarys_at_every_turn_and_nothing_outside_is_shaded_or_sent),
        cmocka_unit_test(meshes_are_the_librarys_at_every_turn_and_nothing_outside_is_sent),
        cmocka_unit_test(a_bus_that_fails_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
