/* SPDX-License-Identifier: MIT */
#include "sinks/wires/lines.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "base/message.h"
#include "sinks/wires/chips.h"
#include "sinks/wires/device.h"
#include "sinks/wires/find.h"

/* The lines of one chip that are set together. */
struct group {
    struct gpio_chip *chip;
    bool busy;
    struct gpio_request *request;
    unsigned count, offsets[GPIO_REQUEST_MAX];
    uint8_t wishes[GPIO_REQUEST_MAX]; /* whose */
    uint32_t mask;                    /* of wishes */
};

struct gpio_lines {
    unsigned groups;
    uint32_t levels, inverted;
    struct group group[GPIO_REQUEST_MAX];
};

static uint32_t gathered(const struct group *group, uint32_t levels)
{
    uint32_t own = 0;
    for (unsigned i = 0; i < group->count; i++)
        own |= (levels >> group->wishes[i] & 1) << i;
    return own;
}

int gpio_lines_set(struct gpio_lines *lines, uint32_t levels)
{
    levels ^= lines->inverted;
    const uint32_t changed = levels ^ lines->levels;
    lines->levels = levels;
    for (unsigned i = 0; i < lines->groups; i++) {
        struct group *group = &lines->group[i];
        const int error = changed & group->mask ? gpio_request_set(group->request, gathered(group, levels)) : 0;
        if (error)
            return error;
    }
    return 0;
}

/* ---- asking for them ---- */

static struct group *group_of(struct gpio_lines *lines, struct gpio_chip *chip, bool busy)
{
    for (unsigned i = 0; i < lines->groups; i++) {
        struct group *group = &lines->group[i];
        if (group->busy == busy && strcmp(gpio_chip_name(group->chip), gpio_chip_name(chip)) == 0) {
            gpio_chip_close(chip);
            return group;
        }
    }
    struct group *group = &lines->group[lines->groups++];
    group->chip = chip;
    group->busy = busy;
    return group;
}

static void check_other(const struct gpio_lines *lines, const struct gpio_line_wish *wishes,
                        const struct gpio_line_wish *wish, const struct gpio_found *found)
{
    for (unsigned i = 0; i < lines->groups; i++) {
        const struct group *group = &lines->group[i];
        if (strcmp(gpio_chip_name(group->chip), gpio_chip_name(found->chip)) != 0)
            continue;
        for (unsigned k = 0; k < group->count; k++)
            if (group->offsets[k] == found->offset)
                fail("%s: %s and %s are the same line, %s:%u; each needs its own line", wish->origin,
                     wishes[group->wishes[k]].role, wish->role, gpio_chip_name(group->chip), found->offset);
    }
}

static void add(struct gpio_lines *lines, const char *chip, const struct gpio_line_wish *wishes, unsigned i)
{
    const struct gpio_line_wish *wish = &wishes[i];
    const struct gpio_found found = gpio_find(chip, wish);
    check_other(lines, wishes, wish, &found);
    struct group *group = group_of(lines, found.chip, wish->busy);
    group->offsets[group->count] = found.offset;
    group->wishes[group->count++] = (uint8_t)i;
    group->mask |= (uint32_t)1 << i;
    lines->levels |= (uint32_t)wish->high << i;
    lines->inverted |= (uint32_t)(*wish->text == '!') << i;
}

/* Names the line that was refused, and why. */
static _Noreturn void fail_request(const struct group *group, const struct gpio_line_wish *wishes, int reason)
{
    const char *chip = gpio_chip_name(group->chip);
    for (unsigned i = 0; reason == EBUSY && i < group->count; i++) {
        const struct gpio_line_wish *wish = &wishes[group->wishes[i]];
        struct gpio_line line;
        if (gpio_chip_line(group->chip, group->offsets[i], &line) && line.used)
            fail("%s: %s=%s: line %s:%u%s%s is in use by '%s'; stop that, or choose another line (`glint list` shows "
                 "them)",
                 wish->origin, wish->role, wish->text, chip, group->offsets[i], *line.name ? " " : "", line.name,
                 *line.consumer ? line.consumer : "the kernel");
    }
    const struct gpio_line_wish *first = &wishes[group->wishes[0]];
    fail("%s: %s: the %u line%s from %s=%s on cannot become outputs: %s", first->origin, chip, group->count,
         group->count == 1 ? "" : "s", first->role, first->text, strerror(reason));
}

struct gpio_lines *gpio_lines_open(const char *chip, const struct gpio_line_wish *wishes, unsigned count)
{
    struct gpio_lines *lines = allocate(1, sizeof *lines);
    for (unsigned i = 0; i < count; i++)
        add(lines, chip, wishes, i);
    lines->levels ^= lines->inverted;
    for (unsigned i = 0; i < lines->groups; i++) {
        struct group *group = &lines->group[i];
        group->request =
            gpio_request_outputs(group->chip, group->offsets, group->count, gathered(group, lines->levels));
        if (!group->request)
            fail_request(group, wishes, errno);
    }
    return lines;
}

void gpio_lines_close(struct gpio_lines *lines)
{
    for (unsigned i = 0; i < lines->groups; i++) {
        gpio_request_release(lines->group[i].request);
        gpio_chip_close(lines->group[i].chip);
    }
    free(lines);
}

const char *gpio_lines_chip(const struct gpio_lines *lines, unsigned i)
{
    for (unsigned k = 0; k < lines->groups; k++)
        if (lines->group[k].mask >> i & 1)
            return gpio_chip_name(lines->group[k].chip);
    return "";
}

/* ---- the list ---- */

static json_t *text_or_null(const char *text)
{
    return *text ? json_text(text) : json_null();
}

static json_t *list_chip(struct gpio_chip *chip)
{
    json_t *lines = json_array();
    for (unsigned i = 0; i < gpio_chip_lines(chip); i++) {
        struct gpio_line line;
        if (gpio_chip_line(chip, i, &line))
            json_array_append_new(lines,
                                  json_pack("{s:i, s:o, s:b, s:o}", "offset", (int)i, "name", text_or_null(line.name),
                                            "used", line.used, "consumer", text_or_null(line.consumer)));
    }
    return json_pack("{s:s, s:o, s:o}", "chip", gpio_chip_name(chip), "label", text_or_null(gpio_chip_label(chip)),
                     "lines", lines);
}

static json_t *list_closed(const char *name, int reason)
{
    char path[PATH_ROOM];
    snprintf(path, sizeof path, "/dev/%s", name);
    char *why = reason == EACCES ? device_permission(path) : copied(strerror(reason));
    json_t *chip = json_pack("{s:s, s:s}", "chip", name, "error", why);
    free(why);
    return chip;
}

json_t *gpio_lines_list(void)
{
    json_t *list = json_array();
    struct gpio_chips chips = gpio_chips_open();
    for (unsigned i = 0; i < chips.count; i++)
        if (!gpio_chips_is_again(&chips, i))
            json_array_append_new(list, chips.open[i] ? list_chip(chips.open[i])
                                                      : list_closed(chips.names[i], chips.reasons[i]));
    gpio_chips_close(&chips, NULL);
    return list;
}

static void print_text(FILE *stream, const char *before, const char *text, const char *after)
{
    char *line = copied(text ? text : "");
    fprintf(stream, "%s%s%s", before, one_line(line), after);
    free(line);
}

static void print_lines(const json_t *lines, FILE *stream)
{
    size_t i;
    json_t *line;
    json_array_foreach(lines, i, line)
    {
        const char *name = json_string_value(json_object_get(line, "name"));
        const char *consumer = json_string_value(json_object_get(line, "consumer"));
        fprintf(stream, "  %3d", (int)json_integer_value(json_object_get(line, "offset")));
        print_text(stream, "  ", name ? name : "-", "");
        if (json_is_true(json_object_get(line, "used")))
            print_text(stream, "  in use by ", consumer ? consumer : "the kernel", "");
        fputc('\n', stream);
    }
}

void gpio_lines_print(const json_t *chips, FILE *stream)
{
    size_t i;
    json_t *chip;
    json_array_foreach(chips, i, chip)
    {
        const char *label = json_string_value(json_object_get(chip, "label"));
        const char *error = json_string_value(json_object_get(chip, "error"));
        print_text(stream, "", json_string_value(json_object_get(chip, "chip")), "");
        if (error)
            print_text(stream, ": ", error, "\n");
        else
            print_text(stream, label ? "  " : "", label, "\n");
        print_lines(json_object_get(chip, "lines"), stream);
    }
}
