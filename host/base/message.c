/* SPDX-License-Identifier: MIT */
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/message.h"
#include "base/text.h"

static bool progress_shown;

/* A message is longer only where it quotes much: it keeps its beginning and what follows the quoted text. */
enum { MESSAGE_MAX = 240, HEAD_BYTES = 60, TAIL_BYTES = 170 };

static bool inside_character(char byte) /* of UTF-8 */
{
    return ((unsigned char)byte & 0xC0) == 0x80;
}

static void shorten(char *text)
{
    const size_t len = strlen(text);
    if (len <= MESSAGE_MAX)
        return;
    char *head = text + HEAD_BYTES, *tail = text + len - TAIL_BYTES;
    while (head > text && inside_character(*head))
        head--;
    while (inside_character(*tail))
        tail++;
    memmove(stpcpy(head, "..."), tail, strlen(tail) + 1);
}

char *one_line(char *text)
{
    shorten(text);
    return text_clean(text, false);
}

static void line(const char *format, va_list arguments)
{
    char *text;
    progress_end();
    if (vasprintf(&text, format, arguments) < 0)
        return;
    fprintf(stderr, "glint: %s\n", one_line(text));
    free(text);
}

void fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    line(format, arguments);
    va_end(arguments);
    exit(EXIT_FAILED);
}

void warn(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    line(format, arguments);
    va_end(arguments);
}

void progress(const char *format, ...)
{
    if (!isatty(STDERR_FILENO))
        return;
    char *text;
    va_list arguments;
    va_start(arguments, format);
    if (vasprintf(&text, format, arguments) >= 0) {
        fprintf(stderr, "\r\033[K%s", text_clean(text, false));
        fflush(stderr);
        free(text);
    }
    va_end(arguments);
    progress_shown = true;
}

void progress_end(void)
{
    if (progress_shown)
        fputs("\r\033[K", stderr);
    progress_shown = false;
}
