/* SPDX-License-Identifier: MIT
 * cmocka with the headers it wants; its fail() gives way to the host's. */
#ifndef GLINT_UNIT_H
#define GLINT_UNIT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#undef fail
#undef fail_msg
#define fail_msg(...) (print_error(__VA_ARGS__), print_error("\n"), _fail(__FILE__, __LINE__))

/* In double precision; cmocka's assert_float_equal rounds both to float first. */
#define assert_near(value, wanted, tolerance)                                                                          \
    do {                                                                                                               \
        const double value_ = (value), wanted_ = (wanted);                                                             \
        if (!(value_ - wanted_ <= (tolerance) && wanted_ - value_ <= (tolerance)))                                     \
            fail_msg("%s is %.15g, not %.15g", #value, value_, wanted_);                                               \
    } while (0)

#endif
