/* SPDX-License-Identifier: MIT
 * For the fuzzers: input taken apart, and checks that end the program. */
#ifndef LAB_FUZZ_H
#define LAB_FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "gud_device.h"

#define check(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            dprintf(2, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); /* stderr may be hidden */              \
            abort();                                                                                                   \
        }                                                                                                              \
    } while (0)

struct input {
    const uint8_t *at, *end;
};

/* 0 where there is no more. */
static inline unsigned next_byte(struct input *input)
{
    return input->at < input->end ? *input->at++ : 0;
}

static inline unsigned next_word(struct input *input)
{
    const unsigned low = next_byte(input);
    return low | next_byte(input) << 8;
}

/* At most `count` bytes in a block of their own, so that reading beyond them is noticed; to be freed. */
static inline uint8_t *next_bytes(struct input *input, size_t *count)
{
    const size_t left = (size_t)(input->end - input->at);
    *count = *count < left ? *count : left;
    uint8_t *bytes = malloc(*count ? *count : 1);
    for (size_t i = 0; i < *count; i++)
        bytes[i] = *input->at++;
    return bytes;
}

/* Any request there can be. */
static inline struct gud_setup next_setup(struct input *input)
{
    struct gud_setup setup = {.type = (uint8_t)next_byte(input), .request = (uint8_t)next_byte(input)};
    setup.value = (uint16_t)next_word(input);
    setup.index = (uint16_t)next_word(input);
    setup.length = (uint16_t)next_word(input);
    return setup;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#endif
