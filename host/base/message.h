/* SPDX-License-Identifier: MIT
 * What the program says on standard error, and its exit statuses. */
#ifndef GLINT_BASE_MESSAGE_H
#define GLINT_BASE_MESSAGE_H

enum { EXIT_GOOD = 0, EXIT_FAILED = 1, EXIT_USAGE = 2 };

/* Prints "glint: " and one line (what failed, on what, what to do), then exits with EXIT_FAILED. */
_Noreturn void fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* One line on standard error that begins with "glint: ". */
void warn(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* text_clean(), and the middle of a long text becomes "..."; in place. */
char *one_line(char *text);
/* A line that overwrites itself, only where standard error is a terminal. */
void progress(const char *format, ...) __attribute__((format(printf, 1, 2)));
void progress_end(void);

#endif
