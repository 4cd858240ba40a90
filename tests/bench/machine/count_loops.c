/* SPDX-License-Identifier: MIT
 * Counts loops over pixels, on the scene's lines.bin. Records: loop; name; n; fill; frame; shade; pixels; covered pixels. */
#include "clock.h"
#include "loops.h"

#include "../../targets/machine/machine.h"

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
    uint32_t frame = count(loop->frame), shade = 0, covered = 0;
    for (unsigned k = 0; k < SCENE_LINES; k++) {
        scene_line(k, bench_line.normals);
        bench_line_begin((uint16_t)(SCENE_STEP * k + SCENE_STEP / 2));
        if (loop->pack)
            loop->pack();
        frame += SCENE_STEP * count(loop->prepare);
        shade += count(loop->shade);
        covered += (uint32_t)(bench_line.to - bench_line.from);
    }
    if (bench_error) {
        print_text("error");
        print_text(loop->name);
        print_end();
        return;
    }
    print_text("loop");
    print_text(loop->name);
    print_number(n);
    print_number(fill);
    print_number(frame);
    print_number(shade);
    print_number((uint32_t)SCENE_LINES * SCENE_W);
    print_number(covered);
    print_end();
}

void machine_run(volatile uint8_t *floor)
{
    (void)floor;
    clock_begin();
    print_calibration();
    for (const struct bench_loop *loop = bench_loops; loop->name; loop++)
        for (unsigned k = 0; k < SCENE_N_COUNT; k++)
            measure(loop, scene_n[k]);
}
