/* SPDX-License-Identifier: MIT */
#include "paper/search_order.h"

void pick_four(uint64_t index, size_t count, size_t picked[4])
{
    for (int i = 3; i >= 0; i--) {
        picked[i] = (size_t)(index % count);
        index /= count;
    }
}

uint64_t scattered_step(uint64_t total)
{
    uint64_t step = (uint64_t)((double)total * 0.6180339887) | 1;
    for (;; step += 2) {
        uint64_t a = total, b = step;
        while (b) {
            const uint64_t rest = a % b;
            a = b;
            b = rest;
        }
        if (a == 1)
            return step;
    }
}

uint64_t scattered_at(uint64_t i, uint64_t step, uint64_t total)
{
    return (uint64_t)((unsigned __int128)i * step % total);
}
