/* SPDX-License-Identifier: MIT
 * The core against the library: every cosine and shininess, back-pressure, cutoffs, clamping, reset. An argument `quick`
 * leaves out most shininesses: for the tests of this test. */
#include <cstdlib>
#include <cstring>
#include <deque>
#include <memory>

#include "Vtop.h"
#include "tap.h"
#include "verilated.h"

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
constexpr uint32_t USER = 0xffff; /* tests/gateware/tier.mk has its width */
constexpr int MODELS = 2;

struct Random { /* xorshift */
    uint32_t state = 2463534242u;
    uint32_t operator()()
    {
        state ^= state << 13;
        state ^= state >> 17;
        return state ^= state << 5;
    }
    bool one_in(uint32_t n)
    {
        return operator()() % n == 0;
    }
};

uint32_t library(int model, uint32_t n, int32_t c)
{
    return model ? glint_schlick(n, c) : glint_msh(n, c);
}

class Core
{
  public:
    Core()
    {
        reset();
    }

    void reset()
    {
        top.s_valid = 0;
        top.m_ready = 1;
        top.rst = 1;
        clock();
        top.rst = 0;
    }

    /* Only between streams: pixels on their way must see the same. */
    void material(int model, uint32_t n, uint32_t c_min)
    {
        top.model = model;
        top.n = n;
        top.c_min = c_min;
        this->model = model;
        this->n = n < 1 ? 1 : n > GLINT_N_MAX ? GLINT_N_MAX : n;
        this->c_min = static_cast<int32_t>(c_min);
        clock();
    }

    void offer(int32_t c)
    {
        top.s_valid = 1;
        top.s_c = static_cast<uint32_t>(c) & 0x3ffff;
        top.s_user = sent & USER;
        offered = c;
    }
    void offer_nothing()
    {
        top.s_valid = 0;
    }
    void ready(bool is)
    {
        top.m_ready = is;
    }

    /* A clock; true where the pixel offered was taken. */
    bool clock()
    {
        top.clk = 0;
        top.eval();
        const bool taken = top.s_valid && top.s_ready && !top.rst;
        if (taken) {
            expected[sent++ % RING] = offered < c_min ? 0 : library(model, n, offered);
        }
        if (held && (!top.m_valid || top.m_f != held_f || top.m_user != held_user))
            moved++;
        if (top.m_valid && top.m_ready) {
            wrong += received == sent || top.m_f != expected[received % RING];
            disorder += top.m_user != (received & USER);
            received++;
        }
        held = top.m_valid && !top.m_ready && !top.rst;
        held_f = top.m_f;
        held_user = top.m_user;
        top.clk = 1;
        top.eval();
        return taken;
    }

    /* Until all has come out, and then some clocks: nothing else may. */
    void drain()
    {
        offer_nothing();
        ready(true);
        for (int i = 0; i < 3 * static_cast<int>(RING) && received != sent; i++)
            clock();
        for (int i = 0; i < 20; i++)
            clock();
    }
    /* All came out, once, in order, and right; nothing moved while it had to wait. */
    bool good() const
    {
        return !wrong && !disorder && !moved && received == sent && sent;
    }
    void forget()
    {
        sent = received = wrong = disorder = moved = 0;
    }
    uint64_t wrongs() const
    {
        return wrong;
    }
    uint64_t on_their_way() const
    {
        return sent - received;
    }

  private:
    static constexpr uint64_t RING = 64;
    Vtop top;
    int model = 0;
    uint32_t n = 1;
    int32_t c_min = 0, offered = 0;
    uint32_t expected[RING] = {};
    bool held = false;
    uint32_t held_f = 0, held_user = 0;
    uint64_t sent = 0, received = 0, wrong = 0, disorder = 0, moved = 0;
};

bool every_cosine(Core &core, int model, uint32_t step)
{
    core.forget();
    for (uint32_t n = 1; n <= GLINT_N_MAX; n += step) {
        core.material(model, n, 0);
        for (int32_t c = 0; c <= ONE; c++) {
            core.offer(c);
            core.clock();
        }
        core.drain();
    }
    printf("# %llu wrong\n", static_cast<unsigned long long>(core.wrongs()));
    return core.good();
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
    for (int i = 0; i < 200; i++) {
        const int model = i % MODELS;
        const uint32_t n = random() % GLINT_N_MAX + 1;
        const uint32_t c_min = glint_cutoff(model ? GLINT_SCHLICK : GLINT_MSH, n, random() % (GLINT_Q_MAX + 1));
        core.material(model, n, c_min);
        for (int32_t c : {0, ONE / 2, static_cast<int32_t>(c_min) - 1, static_cast<int32_t>(c_min),
                          static_cast<int32_t>(c_min) + 1, ONE}) {
            core.offer(c);
            core.clock();
        }
        for (int j = 0; j < 200; j++) {
            core.offer(static_cast<int32_t>(random() % (ONE + 1)));
            core.clock();
        }
        core.drain();
    }
    return core.good();
}

bool clamping(Core &core, Random &random)
{
    core.forget();
    for (uint32_t n : {0u, 1u, 999u, 1000u, 1001u, 1023u})
        for (int model = 0; model < MODELS; model++) {
            core.material(model, n, 0);
            for (int32_t c = -131072; c < 131072; c += 1 + random() % 64) {
                core.offer(c);
                core.clock();
            }
            for (int32_t c : {-131072, -65537, -65536, -65535, -1, 0, 1, ONE - 1, ONE, ONE + 1, 131070, 131071}) {
                core.offer(c);
                core.clock();
            }
            core.drain();
        }
    return core.good();
}

bool resets(Core &core, Random &random)
{
    core.material(0, 60, 0);
    for (int i = 0; i < 300; i++) {
        core.forget();
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
    const uint32_t step = argc > 1 && !strcmp(argv[1], "quick") ? 199 : 1;
    const auto core = std::make_unique<Core>();
    Random random;
    tap::check("MSH of every cosine and shininess is the library's, a pixel a clock", every_cosine(*core, 0, step));
    tap::check("Schlick of every cosine and shininess is the library's, a pixel a clock", every_cosine(*core, 1, step));
    tap::check("MSH under random gaps and back-pressure: each pixel once, in order, held while it waits",
               back_pressure(*core, random, 0));
    tap::check("Schlick under random gaps and back-pressure: each pixel once, in order, held while it waits",
               back_pressure(*core, random, 1));
    tap::check("below the cutoff F is 0, from it on the library's", cutoffs(*core, random));
    tap::check("cosines beyond 0..1 and shininess beyond 1..1000 are clamped", clamping(*core, random));
    tap::check("a reset leaves nothing on its way", resets(*core, random));
    return tap::done();
}
