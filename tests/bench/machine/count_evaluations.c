/* SPDX-License-Identifier: MIT
 * Counts single evaluations, without their call and return: those of an empty function are taken off. Records:
 * evaluation; name; n; evaluations; count of all. */
#include "clock.h"
#include "evaluations.h"
#include "samples.h"

#include "machine.h"

#ifdef __AVR__
enum { REPEAT = 1 }; /* the clock is exact */
#else
enum { REPEAT = 50 }; /* on Cortex-M it steps by 40 */
#endif

/* Only returns, whatever it is called as. */
static void nothing(void)
{
}
static const struct evaluation empty = {
    "",
    "",
    (uint32_t(*)(uint32_t, uint32_t))nothing,
    (uint32_t(*)(const struct glint_lobe *, uint32_t))nothing,
    (float (*)(float, float))nothing,
    0,
    0,
};

/* The same code for the functions and for the empty ones. */
static __attribute__((noinline)) uint32_t run(const struct evaluation *e, enum evaluation_takes takes, unsigned n_index)
{
    const uint32_t n = sphere_n[n_index];
    float c[SAMPLES];
    for (unsigned i = 0; i < SAMPLES; i++)
        c[i] = (float)samples[n_index][i][0] / 65536;
    const float n_float = (float)n;
    const uint32_t start = clock_now();
    for (unsigned k = 0; k < REPEAT; k++)
        for (unsigned i = 0; i < SAMPLES; i++)
            switch (takes) {
            case TAKES_C:
            case TAKES_T:
                e->run(n, samples[n_index][i][takes]);
                break;
            case TAKES_LOBE:
                e->run_lobe(&evaluation_lobe, samples[n_index][i][1]);
                break;
            case TAKES_FLOAT:
                e->run_float(n_float, c[i]);
                break;
            }
    return clock_now() - start;
}

bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    clock_begin();
    print_calibration();
    for (unsigned k = 0; k < SPHERE_N_COUNT; k++) {
        evaluation_begin(sphere_n[k]);
        for (const struct evaluation *e = evaluations; e->name; e++) {
            const enum evaluation_takes takes = (enum evaluation_takes)e->takes;
            const uint32_t around = run(&empty, takes, k);
            const uint32_t counted = run(e, takes, k) - around;
            print_text("evaluation");
            print_text(e->name);
            print_number(sphere_n[k]);
            print_number(REPEAT * SAMPLES);
            print_number(counted);
            print_end();
        }
    }
    return true;
}
