/* SPDX-License-Identifier: MIT
 * The core in Verilator against the library: every cosine of some shininesses (test_flat has all of them), back-pressure, cutoffs,
 * clamping, reset. The argument quick leaves out most of those: for the tests of this test. */
#include <cstdio>
#include <cstring>

#include "stream.h"
#include "tap.h"

extern "C" {
#include "glint.h"
}

double sc_time_stamp()
{
    return 0;
}

namespace
{

constexpr int32_t ONE = GLINT_C_ONE;
constexpr int MODELS = 2;

class Core : public Stream
{
  public:
    void material(int model, uint32_t n, uint32_t c_min)
    {
        top.model = model;
        top.n = n;
        top.c_min = c_min;
        clock();
        this->n = n;
    }
    void offer(int32_t c)
    {
        const uint32_t f = top.model ? glint_schlick(n, c) : glint_msh(n, c);
        Stream::offer(c, c < static_cast<int32_t>(top.c_min) ? 0 : f);
    }

  private:
    uint32_t n = 1;
};

bool every_cosine(Core &core, int model, uint32_t step)
{
    core.forget();
    bool each = true; /* a clock takes one */
    for (uint32_t n = 1; n <= GLINT_N_MAX; n += step) {
        core.material(model, n, 0);
        for (int32_t c = 0; c <= ONE; c++) {
            core.offer(c);
            each &= core.clock();
        }
        core.drain();
    }
    printf("# %llu wrong\n", static_cast<unsigned long long>(core.wrongs()));
    return each && core.good();
}

bool back_pressure(Core &core, Random &random, int model)
{
    core.forget();
    for (uint32_t n : {1u, 2u, 13u, 60u, 1000u}) {
        core.material(model, n, 0);
        for (int32_t c = 0; c <= ONE;) {
            /* Rates change, so that the pipeline is now full, now empty. */
            const uint32_t rate = static_cast<uint32_t>(c >> 12) % 4 + 1;
            core.ready(random.one_in(rate));
            if (random.one_in(5 - rate))
                core.offer(c);
            else
                core.offer_nothing();
            c += core.clock();
        }
        core.drain();
    }
    return core.good();
}

bool cutoffs(Core &core, Random &random)
{
    core.forget();
    bool each = true; /* a clock takes one */
    for (int i = 0; i < 200; i++) {
        const int model = i % MODELS;
        const uint32_t n = random() % GLINT_N_MAX + 1;
        const uint32_t c_min = glint_cutoff(model ? GLINT_SCHLICK : GLINT_MSH, n, random() % (GLINT_Q_MAX + 1));
        const int32_t edge = static_cast<int32_t>(c_min);
        core.material(model, n, c_min);
        for (int32_t c : {0, ONE / 2, edge - 1, edge, edge + 1, ONE}) {
            core.offer(c);
            each &= core.clock();
        }
        for (int j = 0; j < 200; j++) {
            core.offer(static_cast<int32_t>(random() % (ONE + 1)));
            each &= core.clock();
        }
        core.drain();
    }
    return each && core.good();
}

bool clamping(Core &core, Random &random)
{
    core.forget();
    bool each = true; /* a clock takes one */
    for (uint32_t n : {0u, 1u, 999u, 1000u, 1001u, 1023u})
        for (int model = 0; model < MODELS; model++) {
            core.material(model, n, 0);
            for (int32_t c = -131072; c < 131072; c += static_cast<int32_t>(1 + random() % 64)) {
                core.offer(c);
                each &= core.clock();
            }
            for (int32_t c : {-131072, -65537, -65536, -65535, -1, 0, 1, ONE - 1, ONE, ONE + 1, 131070, 131071}) {
                core.offer(c);
                each &= core.clock();
            }
            core.drain();
        }
    return each && core.good();
}

bool resets(Core &core, Random &random)
{
    core.material(0, 60, 0);
    for (int i = 0; i < 300; i++) {
        core.offer(ONE);
        for (uint32_t clocks = random() % 40 + 1; clocks; clocks--)
            core.clock();
        core.reset();
        core.forget();
        core.drain();
        if (core.wrongs()) /* something came out */
            return false;
        core.offer(ONE / 2);
        core.clock();
        core.drain();
        if (!core.good())
            return false;
    }
    return true;
}

} // namespace

int main(int argc, char **argv)
{
    const uint32_t step = argc > 1 && !strcmp(argv[1], "quick") ? 199 : 37;
    static Core core;
    Random random;
    tap::check("MSH of every cosine, n = 1, 38, ... 1000, is the library's, a pixel a clock",
               every_cosine(core, 0, step));
    tap::check("Schlick of every cosine, n = 1, 38, ... 1000, is the library's, a pixel a clock",
               every_cosine(core, 1, step));
    tap::check("MSH under random gaps and back-pressure: each pixel once, in order, held while it waits",
               back_pressure(core, random, 0));
    tap::check("Schlick under random gaps and back-pressure: each pixel once, in order, held while it waits",
               back_pressure(core, random, 1));
    tap::check("below the cutoff F is 0, from it on the library's", cutoffs(core, random));
    tap::check("cosines beyond 0..1 and shininess beyond 1..1000 are clamped", clamping(core, random));
    tap::check("a reset leaves nothing on its way", resets(core, random));
    tap::check("F comes 12 clocks after its cosine", core.latency() == 12);
    return tap::done();
}
