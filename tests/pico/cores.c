/* SPDX-License-Identifier: MIT
 * cores [hasty]: the display loops on two threads, under the thread sanitizer, which finds what both touch at a time. The threads
 * hand each other work as the cores do (ports/pico/second_core.c). hasty: the join does not wait, which is to be found. */
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#include "demo.h"
#include "orbit.h"
#include "relight.h"
#include "turntable.h"

enum { WIDTH = 101, HEIGHT = 64, FRAMES = 20 };

static uint16_t screen[WIDTH * HEIGHT];
static size_t at;
static bool is_hasty;
static struct {
    void (*job)(void *);
    void *argument;
    atomic_uint given, done; /* counted */
} posted;

static void *serve(void *nothing)
{
    for (unsigned next = 1;; next++) {
        while (atomic_load_explicit(&posted.given, memory_order_acquire) < next)
            ;
        if (!posted.job)
            return nothing;
        posted.job(posted.argument);
        atomic_store_explicit(&posted.done, next, memory_order_release);
    }
}

static void on_fork(void *context, void (*job)(void *), void *argument)
{
    (void)context;
    posted.job = job;
    posted.argument = argument;
    atomic_fetch_add_explicit(&posted.given, 1, memory_order_release);
}

static void on_join(void *context)
{
    (void)context;
    while (!is_hasty && atomic_load_explicit(&posted.done, memory_order_acquire) !=
                            atomic_load_explicit(&posted.given, memory_order_relaxed))
        ;
}

static bool on_command(void *context, uint8_t command)
{
    (void)context;
    at = command == PANEL_MEMORY_WRITE ? 0 : at;
    return true;
}

static bool on_data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    (void)bytes;
    (void)count;
    return true;
}

static void on_flush(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    memcpy(screen + at, pixels, count * sizeof *pixels);
    at += count;
    done(argument);
}

static const struct hal hal = {
    .bus = {.command = on_command, .data = on_data}, .flush = on_flush, .fork = on_fork, .join = on_join};
static const struct panel panel = {.bus = &hal.bus, .controller = PANEL_ST7789, .width = WIDTH, .height = HEIGHT};
static uint32_t map[WIDTH * HEIGHT], tables[GLINT_TABLES_COLOUR_BYTES / 4];
static uint16_t pixels[2][WIDTH];
static struct relight_extent extents[HEIGHT];
static struct glint_paint paint;
static struct relight relight = {.hal = &hal,
                                 .panel = &panel,
                                 .map = map,
                                 .background = 0x1234,
                                 .paint = &paint,
                                 .pixels = {pixels[0], pixels[1]},
                                 .extents = extents};

static void make_map(void) /* a disc with a hole */
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const int32_t v[3] = {x - WIDTH / 2, HEIGHT / 2 - y, 30}, r = v[0] * v[0] + v[1] * v[1];
            struct glint_vec normal;
            const bool is_there = r > 100 && r < 1000 && glint_vec_normalize(&normal, v) == GLINT_OK;
            map[y * WIDTH + x] = is_there ? glint_normals_pack(GLINT_NORMALS_INT8, &normal) : 0;
        }
}

static bool is_right(void)
{
    uint16_t wanted[WIDTH * HEIGHT];
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        wanted[i] = relight.background;
    const struct glint_surface surface = {wanted, 2 * WIDTH, 0, 0};
    const struct glint_maps maps = {.normals = map, .normals_stride = 4 * WIDTH, .normals_format = GLINT_NORMALS_INT8};
    return glint_draw_rect(&paint, &maps, WIDTH, HEIGHT, &surface, NULL) == GLINT_OK &&
           memcmp(screen, wanted, sizeof wanted) == 0;
}

/* ---- a mesh ---- */

static const int16_t places[6][3] = {{32767, 0, 0},  {-32767, 0, 0}, {0, 32767, 0},
                                     {0, -32767, 0}, {0, 0, 32767},  {0, 0, -32767}};
static const uint16_t faces[8][3] = {{4, 0, 2}, {4, 2, 1}, {4, 1, 3}, {4, 3, 0},
                                     {5, 2, 0}, {5, 1, 2}, {5, 3, 1}, {5, 0, 3}};
static const struct glint_mesh mesh = {
    .places = places[0], .normals = places[0], .faces = faces[0], .vertex_count = 6, .face_count = 8};
enum { MESH_BYTES = 16384, MESH_STRIPS = HEIGHT / TURNTABLE_LINES };
static uint32_t strips[MESH_STRIPS * TURNTABLE_LINES * WIDTH / 2], memory[2][MESH_BYTES / 4];
static struct turntable turntable = {.pieces = {.hal = &hal, .panel = &panel},
                                     .mesh = &mesh,
                                     .paint = &paint,
                                     .memory_bytes = MESH_BYTES,
                                     .strips = strips,
                                     .strip_count = MESH_STRIPS,
                                     .lower_y = HEIGHT / 2,
                                     .core = {{.memory = memory[0]}, {.memory = memory[1]}}};

static void turn(uint16_t lower_y, uint32_t frame, uint16_t picture[WIDTH * HEIGHT])
{
    struct glint_pose pose;
    turntable.lower_y = lower_y;
    demo_pose(&pose, frame * 12, HEIGHT);
    turntable_frame(&turntable, &pose, demo_mesh_light);
    while (turntable_step(&turntable) == TURNTABLE_BUSY)
        ;
    memcpy(picture, screen, sizeof screen);
}

/* With both cores as with one. */
static int wrong_turns(void)
{
    static uint16_t by_one[WIDTH * HEIGHT], by_two[WIDTH * HEIGHT];
    int wrong = turntable_start(&turntable) != GLINT_OK;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        turn(HEIGHT, frame, by_one);
        turn(HEIGHT / 2, frame, by_two);
        wrong += memcmp(by_one, by_two, sizeof by_one) != 0;
    }
    return wrong;
}

int main(int argc, char **argv)
{
    pthread_t other;
    int wrong = 0;
    is_hasty = argc > 1 && strcmp(argv[1], "hasty") == 0;
    make_map();
    if (pthread_create(&other, NULL, serve, NULL) != 0 ||
        glint_paint_tables(&paint, GLINT_TABLES_COLOUR, &demo_gold, &demo_output, tables, sizeof tables) != GLINT_OK)
        return 2;
    relight_start(&relight);
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        int32_t to_light[3];
        orbit_light(to_light, frame * 12, ORBIT_FRAMES);
        wrong += relight_frame(&relight, to_light) != GLINT_OK;
        while (relight_step(&relight) == RELIGHT_BUSY)
            ;
        wrong += !is_right();
    }
    wrong += wrong_turns();
    on_fork(NULL, NULL, NULL); /* the end */
    pthread_join(other, NULL);
    printf("%d frames of %d are wrong\n", wrong, 2 * FRAMES);
    return wrong != 0;
}
