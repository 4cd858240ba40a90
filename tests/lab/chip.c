/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { CHIPS_MAX = 4 };
static struct chip made[CHIPS_MAX];

#define CONFIG "/sys/kernel/config/gpio-sim"

static char *path_of(const char *format, va_list arguments)
{
    static char path[256];
    vsnprintf(path, sizeof path, format, arguments);
    return path;
}

__attribute__((format(printf, 2, 3))) static void write_file(const char *value, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const char *path = path_of(format, arguments);
    va_end(arguments);
    FILE *file = fopen(path, "w");
    if (!file || fputs(value, file) < 0 || fclose(file) != 0)
        fail_msg("%s: writing %s: %s", path, value, strerror(errno));
}

__attribute__((format(printf, 1, 2))) static void make_folder(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const char *path = path_of(format, arguments);
    va_end(arguments);
    if (mkdir(path, 0755) != 0)
        fail_msg("%s: %s", path, strerror(errno));
}

__attribute__((format(printf, 1, 2))) static void remove_folder(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const char *path = path_of(format, arguments);
    va_end(arguments);
    if (rmdir(path) != 0)
        fail_msg("%s: %s", path, strerror(errno));
}

/* The kernel lists "gpiochip0: GPIOs 504-511, parent: platform/gpio-sim.0, LABEL:". */
static void find(struct chip *chip)
{
    FILE *file = fopen("/sys/kernel/debug/gpio", "r");
    assert_non_null(file);
    char line[256], found[64] = "";
    while (strcmp(found, chip->label) != 0 && fgets(line, sizeof line, file))
        if (sscanf(line, "%31[^:]: GPIOs %u-%*u, parent: %*[^,], %63[^:,]", chip->name, &chip->base, found) != 3)
            found[0] = 0;
    fclose(file);
    if (strcmp(found, chip->label) != 0)
        fail_msg("the kernel has no GPIO chip %s", chip->label);
    snprintf(chip->path, sizeof chip->path, "/dev/%s", chip->name);
}

void chip_find(struct chip *chip, const char *label, const char *const lines[], unsigned count)
{
    assert_true(count <= LAB_LINES_MAX && strlen(label) < sizeof chip->label);
    *chip = (struct chip){.lines = lines, .count = count};
    strcpy(chip->label, label);
    find(chip);
}

/* For chips_remove, before anything of it is made. */
static void note(const struct chip *chip)
{
    for (size_t i = 0; i < CHIPS_MAX; i++)
        if (!made[i].count) {
            made[i] = *chip;
            return;
        }
    fail_msg("more than %d chips", CHIPS_MAX);
}

void chip_create(struct chip *chip, const char *label, const char *const lines[], unsigned count)
{
    assert_true(count <= LAB_LINES_MAX && strlen(label) < sizeof chip->label);
    *chip = (struct chip){.lines = lines, .count = count};
    strcpy(chip->label, label);
    note(chip);
    make_folder(CONFIG "/%s", label);
    make_folder(CONFIG "/%s/bank", label);
    char number[16];
    snprintf(number, sizeof number, "%u", count);
    write_file(number, CONFIG "/%s/bank/num_lines", label);
    write_file(label, CONFIG "/%s/bank/label", label);
    for (unsigned i = 0; i < count; i++) {
        make_folder(CONFIG "/%s/bank/line%u", label, i);
        write_file(lines[i], CONFIG "/%s/bank/line%u/name", label, i);
    }
    write_file("1", CONFIG "/%s/live", label);
    find(chip);
}

void chip_remove(const struct chip *chip)
{
    write_file("0", CONFIG "/%s/live", chip->label);
    for (unsigned i = 0; i < chip->count; i++)
        remove_folder(CONFIG "/%s/bank/line%u", chip->label, i);
    remove_folder(CONFIG "/%s/bank", chip->label);
    remove_folder(CONFIG "/%s", chip->label);
    for (size_t i = 0; i < CHIPS_MAX; i++)
        if (strcmp(made[i].label, chip->label) == 0)
            made[i] = (struct chip){0};
}

void chips_remove(void)
{
    for (size_t i = 0; i < CHIPS_MAX; i++)
        if (made[i].count)
            chip_remove(&made[i]);
}

unsigned chip_line(const struct chip *chip, const char *name)
{
    for (unsigned i = 0; i < chip->count; i++)
        if (strcmp(chip->lines[i], name) == 0)
            return i;
    fail_msg("chip %s has no line %s", chip->label, name);
    return 0;
}
