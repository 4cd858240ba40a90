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

#endif
