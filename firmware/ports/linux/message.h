/* SPDX-License-Identifier: MIT
 * One line on standard error, "glint-gadget: ...". */
#ifndef MESSAGE_H
#define MESSAGE_H

/* And exit 1. */
_Noreturn void fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
void warn(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
