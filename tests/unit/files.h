/* SPDX-License-Identifier: MIT
 * Files in a test: made for it, compared, counted. */
#ifndef GLINT_FILES_H
#define GLINT_FILES_H

#include <stdbool.h>
#include <sys/stat.h>

#include "made_png.h"
#include "run.h"

static inline size_t read_file(const char *path, uint8_t *bytes, size_t room)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t len = fread(bytes, 1, room, file);
    fclose(file);
    return len;
}

static inline void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

/* With a 0 at its end; the caller frees it. */
static inline char *whole_file(const char *path)
{
    struct stat status;
    assert_int_equal(stat(path, &status), 0);
    const size_t len = (size_t)status.st_size;
    char *text = malloc(len + 1);
    assert_non_null(text);
    assert_int_equal(read_file(path, (uint8_t *)text, len), len);
    text[len] = 0;
    return text;
}

static inline bool same_file(const char *a, const char *b)
{
    static uint8_t in_a[1 << 20], in_b[1 << 20];
    const size_t len = read_file(a, in_a, sizeof in_a);
    assert_true(len > 0 && len < sizeof in_a);
    return read_file(b, in_b, sizeof in_b) == len && memcmp(in_a, in_b, len) == 0;
}

static inline void assert_same_file(const char *a, const char *b)
{
    if (!same_file(a, b))
        fail_msg("%s and %s differ", a, b);
}

static inline bool exists(const char *path)
{
    return access(path, F_OK) == 0;
}

/* Files in a directory, hidden ones counted. */
static inline int files_in(const char *directory)
{
    char line[200];
    snprintf(line, sizeof line, "ls -A '%s' | wc -l", directory);
    FILE *pipe = popen(line, "r");
    assert_non_null(pipe);
    int count = -1;
    assert_int_equal(fscanf(pipe, "%d", &count), 1);
    pclose(pipe);
    return count;
}

/* Exit 0 and not a word. */
static inline void assert_quiet(const char *command)
{
    const struct run *result = run(command);
    if (result->status != 0 || *result->out || *result->err)
        fail_msg("%s: status %d, %s%s", command, result->status, result->out, result->err);
}

/* A small height map and an albedo of its size, an albedo of another, and one line of a tall map. */
static inline int make_maps(void **state)
{
    if (scratch_make(state) != 0)
        return -1;
    uint16_t heights[12 * 8], colors[12 * 8 * 3];
    for (int i = 0; i < 12 * 8; i++)
        heights[i] = (uint16_t)(i * i * 31 % 256);
    for (int i = 0; i < 12 * 8 * 3; i++)
        colors[i] = (uint16_t)(100 + i % 150);
    make_png("heights.png", &(struct made_png){.width = 12, .height = 8, .bits = 8, .samples = heights});
    make_png(
        "colors.png",
        &(struct made_png){.width = 12, .height = 8, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = colors});
    make_png("small.png", &(struct made_png){
                              .width = 4, .height = 4, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = colors});
    make_png("line.png", &(struct made_png){.width = 1, .height = 8, .bits = 8, .samples = heights});
    for (int i = 0; i < 12 * 8; i++)
        heights[i] &= 1;
    make_png("bits.png", &(struct made_png){.width = 12, .height = 8, .bits = 1, .samples = heights});
    return mkdir("out", 0777);
}

#endif
