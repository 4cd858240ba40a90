/* SPDX-License-Identifier: MIT
 * A module with the ports s_valid, s_ready, s_c, s_user, m_valid, m_ready, m_f, m_user, and what must come out of it. */
#ifndef STREAM_H
#define STREAM_H

#include <cstdint>

#include "Vtop.h"

constexpr uint32_t USER = 0xffff; /* tests/gateware/tier.mk has its width */

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

class Stream
{
  public:
    Stream()
    {
        reset();
    }
    Vtop top; /* its other inputs: to be changed only after drain */

    void reset()
    {
        top.s_valid = 0;
        top.m_ready = 1;
        top.rst = 1;
        clock();
        top.rst = 0;
    }

    void offer(int32_t c, uint32_t f)
    {
        top.s_valid = 1;
        top.s_c = static_cast<uint32_t>(c) & 0x3ffff;
        top.s_user = sent & USER;
        offered_c = c;
        offered_f = f;
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
            c[sent % RING] = offered_c;
            f[sent++ % RING] = offered_f;
        }
        moved += held && (!top.m_valid || top.m_f != held_f || top.m_user != held_user);
        if (top.m_valid && top.m_ready)
            receive();
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
        for (uint64_t i = 0; i < RING && received != sent; i++)
            clock();
        for (int i = 0; i < 20; i++)
            clock();
    }

    /* Clocks from the edge that takes a cosine to the one that takes its F, when nothing waits. */
    int latency()
    {
        drain();
        offer(0, 0);
        clock();
        offer_nothing();
        int clocks = 0;
        for (const uint64_t before = received; received == before && clocks < 100; clocks++)
            clock();
        return clocks;
    }

    void forget()
    {
        sent = received = wrong = disorder = moved = 0;
    }
    /* All came out, once, in order, and right; nothing moved while it had to wait. */
    bool good() const
    {
        return !wrong && !disorder && !moved && received == sent && sent;
    }
    uint64_t wrongs() const
    {
        return wrong;
    }

  private:
    static constexpr uint64_t RING = 64;

    void receive()
    {
        const uint64_t i = received % RING;
        if (received == sent || top.m_f != f[i]) {
            if (!wrong++)
                printf("# first wrong: c %d gave %u, not %u\n", c[i], static_cast<unsigned>(top.m_f), f[i]);
        }
        disorder += top.m_user != (received & USER);
        received++;
    }

    int32_t offered_c = 0, c[RING] = {};
    uint32_t offered_f = 0, f[RING] = {};
    bool held = false;
    uint32_t held_f = 0, held_user = 0;
    uint64_t sent = 0, received = 0, wrong = 0, disorder = 0, moved = 0;
};

#endif
