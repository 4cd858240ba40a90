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

#endif
