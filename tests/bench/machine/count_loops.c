/* SPDX-License-Identifier: MIT
 * Counts loops over pixels, on some of the sphere's lines. Records: loop; name; n; fill; frame; shade; pixels; covered pixels. */
#include "clock.h"

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

static void measure(const struct bench_loop *loop, uint32_t n)
{
    bench_begin(loop, n);
    const uint32_t fill = count(loop->fill);
    sphere_line((enum bench_map)loop->map, 0); /* a frame may begin with its palette */
    uint32_t frame = count(loop->frame), shade = 0, covered = 0;
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

/* Is it to be counted? COUNT_ROWS: how its name begins. */
static bool is_wanted(const char *name)
{
#ifdef COUNT_ROWS
    for (const char *at = COUNT_ROWS; *at; at++)
        if (*at != *name++)
            return false;
#else
    (void)name;
#endif
    return true;
}

bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    clock_begin();
    print_calibration();
    for (const struct bench_loop *loop = bench_loops; loop->name; loop++)
        for (unsigned k = 0; k < SPHERE_N_COUNT; k++)
            if ((!loop->once || sphere_n[k] == 60) && is_wanted(loop->name))
                measure(loop, sphere_n[k]);
    return true;
}
