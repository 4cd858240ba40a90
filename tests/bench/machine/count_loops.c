/* SPDX-License-Identifier: MIT
 * Counts loops over pixels, on some of the sphere's lines. Records: loop; name; n; fill; frame; shade; pixels; covered pixels. On some of other
 * scenes', and lines of open pixels: scene; name; n; scene or "open"; shade; covered pixels. */
#include <string.h>

#include "clock.h"
#include "worst.h"
#include "worst_lines.h"

#include "machine.h"

static void nothing(void)
{
}

static __attribute__((noinline)) uint32_t count_all(bench_step *step)
{
    const uint32_t start = clock_now();
    step();
    return clock_now() - start;
}

/* Without the call and the clock itself. */
static uint32_t count(bench_step *step)
{
    return step ? count_all(step) - count_all(nothing) : 0;
}

static uint32_t fill, frame;
static void begin(const struct bench_loop *loop, uint32_t n)
{
    bench_begin(loop, n);
    fill = count(loop->fill);
    sphere_line((enum bench_map)loop->map, 0); /* a frame may begin with its palette */
    frame = count(loop->frame);
}

static void measure(const struct bench_loop *loop, uint32_t n)
{
    begin(loop, n);
    uint32_t shade = 0, covered = 0;
    for (unsigned k = 0; k < SPHERE_LINES; k++) {
        sphere_line((enum bench_map)loop->map, k);
        bench_line_begin((uint16_t)(SPHERE_STEP * k + SPHERE_STEP / 2));
        if (loop->pack)
            loop->pack();
        frame += SPHERE_STEP * count(loop->prepare);
        shade += count(loop->shade);
        covered += (uint32_t)(bench_line.to - bench_line.from);
    }
    if (bench_error) {
        print_text("error");
        print_text(loop->name);
        print_number(n);
        print_number((uint32_t)-bench_error);
        print_end();
        return;
    }
    print_text("loop");
    print_text(loop->name);
    print_number(n);
    print_number(fill);
    print_number(frame);
    print_number(shade);
    print_number((uint32_t)SPHERE_LINES * SPHERE_W);
    print_number(covered);
    print_end();
}

#ifndef __AVR__
static void print_scene(const struct bench_loop *loop, uint32_t n, const char *scene, uint32_t shade, uint32_t covered)
{
    print_text(bench_error ? "error" : "scene");
    print_text(loop->name);
    print_number(n);
    print_text(scene);
    print_number(shade);
    print_number(covered);
    print_end();
}

static void measure_scene(const struct bench_loop *loop, uint32_t n, enum bench_scene scene)
{
    const unsigned lines = scene < SCENE_PICTURES ? SPHERE_LINES : SCENE_SIDE_LINES;
    uint32_t shade = 0, covered = 0;
    for (unsigned i = 0; i < lines; i++) {
        const unsigned k = (2 * i + 1) * SPHERE_LINES / (2 * lines);
        sphere_line((enum bench_map)loop->map, (unsigned)scene * SPHERE_LINES + k);
        bench_line_begin((uint16_t)(SPHERE_STEP * k + SPHERE_STEP / 2));
        if (loop->pack)
            loop->pack();
        (void)count(loop->prepare);
        shade += count(loop->shade);
        for (unsigned x = 0; x < SPHERE_W; x++)
            covered += bench_line.mask[x] != 0;
    }
    print_scene(loop, n, scene_names[scene], shade, covered);
}

/* A line whose every pixel is open, as the Cortex-M0+ has it. */
static void measure_open(const struct bench_loop *loop)
{
    const struct worst_line *line = worst_lines;
    while (line->name && strcmp(line->name, loop->name))
        line++;
    if (!line->name)
        return;
    bench_begin(loop, 60);
    worst_begin();
    worst_material(line->ambient[0], line->ambient[1], line->ambient[2]);
    for (unsigned x = 0; x < SPHERE_W; x++)
        bench_line.normals[x] = line->normals[x % line->phases];
    print_scene(loop, 60, "open", count(loop->shade), SPHERE_W);
}

/* What loops.mjs says of the same, after measure. */
static void measure_scenes(const struct bench_loop *loop, uint32_t n)
{
    static const char *const shown[] = {"exact rect", "colour int8", "float folded", "integer power", "table power"};
    for (unsigned i = 0; i < sizeof shown / sizeof *shown; i++)
        for (unsigned k = 0; !strcmp(loop->name, shown[i]) && k < SCENE_N_COUNT; k++)
            for (int scene = 0; scene_n[k] == n && scene < SCENE_PICTURES; scene++)
                measure_scene(loop, n, (enum bench_scene)scene);
    if (n != 60)
        return;
    if (loop->look.lights == LIGHTS_WHITE && loop->map != MAP_PALETTE && loop->look.model != GLINT_PHONG)
        for (int side = SCENE_PICTURES; side < SCENE_COUNT; side++)
            measure_scene(loop, n, (enum bench_scene)side);
    measure_open(loop);
}
#else
static void measure_scenes(const struct bench_loop *loop, uint32_t n)
{
    (void)loop, (void)n;
}
#endif

/* Is it to be counted? COUNT_ROWS: how their names begin, with a comma after each. */
static bool is_wanted(const char *name)
{
#ifdef COUNT_ROWS
    unsigned i = 0;
    for (const char *at = COUNT_ROWS; *at; at++) {
        if (*at == ',')
            return true;
        if (*at == name[i]) {
            i++;
            continue;
        }
        for (i = 0; *at != ','; at++) {
        }
    }
    return false;
#else
    (void)name;
    return true;
#endif
}

bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    clock_begin();
    print_calibration();
    for (const struct bench_loop *loop = bench_loops; loop->name; loop++) {
        if (!is_wanted(loop->name))
            continue;
        for (unsigned k = 0; k < SPHERE_N_COUNT; k++)
            if (!loop->once || sphere_n[k] == 60) {
                measure(loop, sphere_n[k]);
                measure_scenes(loop, sphere_n[k]);
            }
        if (!loop->once) {
            begin(loop, scene_n[0]);
            measure_scenes(loop, scene_n[0]);
        }
    }
    return true;
}
