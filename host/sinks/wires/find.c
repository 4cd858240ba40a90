/* SPDX-License-Identifier: MIT */
#include "sinks/wires/find.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "sinks/wires/chips.h"
#include "sinks/wires/device.h"

/* ---- chips ---- */

static struct gpio_chips chips_open(const struct gpio_line_wish *wish)
{
    struct gpio_chips chips = gpio_chips_open();
    if (chips.count == 0)
        fail("%s: %s=%s: no GPIO chip: this machine has no /dev/gpiochip0", wish->origin, wish->role, wish->text);
    return chips;
}

static _Noreturn void fail_denied(const struct gpio_line_wish *wish, const char *name)
{
    char path[PATH_ROOM];
    snprintf(path, sizeof path, "/dev/%s", name);
    fail("%s: %s=%s: %s: %s", wish->origin, wish->role, wish->text, path, device_permission(path));
}

static bool is_number(const char *text)
{
    return *text && !text[strspn(text, "0123456789")];
}

/* By name, number, path or label. */
static bool is_chip(const struct gpio_chips *chips, unsigned i, const char *text)
{
    const char *name = chips->names[i], *file = strncmp(text, "/dev/", 5) == 0 ? text + 5 : text;
    return strcmp(file, name) == 0 || (is_number(text) && strcmp(text, name + strlen("gpiochip")) == 0) ||
           (chips->open[i] && strcmp(text, gpio_chip_label(chips->open[i])) == 0);
}

/* chips->count if there is none. */
static unsigned chip_called(const struct gpio_chips *chips, const char *text)
{
    unsigned i = 0;
    while (i < chips->count && !is_chip(chips, i, text))
        i++;
    return i;
}

static _Noreturn void fail_chip(const struct gpio_chips *chips, const struct gpio_line_wish *wish, const char *text)
{
    char *known = NULL;
    size_t size;
    FILE *stream = open_memstream(&known, &size);
    for (unsigned i = 0; stream && i < chips->count && i < 6; i++)
        fprintf(stream, "%s%s%s%s%s", i ? ", " : "", chips->names[i], chips->open[i] ? " (" : "",
                chips->open[i] ? gpio_chip_label(chips->open[i]) : "", chips->open[i] ? ")" : "");
    if (stream)
        fclose(stream);
    fail("%s: %s=%s: no GPIO chip is named '%s'; choose from %s", wish->origin, wish->role, wish->text, text,
         known ? known : chips->names[0]);
}

/* ---- names ---- */

unsigned letters_apart(const char *a, const char *b)
{
    /* Rows of the usual table, for names as short as the kernel's. */
    enum { MAX = GPIO_NAME_MAX };
    unsigned rows[3][MAX + 1] = {{0}};
    const size_t m = strnlen(a, MAX), n = strnlen(b, MAX);
    for (unsigned k = 0; k <= n; k++)
        rows[0][k] = k;
    for (unsigned i = 1; i <= m; i++) {
        unsigned *row = rows[i % 3];
        const unsigned *above = rows[(i + 2) % 3], *two_above = rows[(i + 1) % 3];
        row[0] = i;
        for (unsigned k = 1; k <= n; k++) {
            const int x = tolower((unsigned char)a[i - 1]), y = tolower((unsigned char)b[k - 1]);
            unsigned least = above[k - 1] + (x != y);
            least = above[k] + 1 < least ? above[k] + 1 : least;
            least = row[k - 1] + 1 < least ? row[k - 1] + 1 : least;
            if (i > 1 && k > 1 && x == tolower((unsigned char)b[k - 2]) && y == tolower((unsigned char)a[i - 2]) &&
                two_above[k - 2] + 1 < least)
                least = two_above[k - 2] + 1;
            row[k] = least;
        }
    }
    return rows[m % 3][n];
}

struct search {
    const char *name;
    unsigned found; /* how many have that name */
    unsigned chip[2], offset[2];
    unsigned apart; /* of the nearest other name */
    char near[GPIO_NAME_MAX];
};

static void search_chip(const struct gpio_chips *chips, unsigned i, struct search *search)
{
    for (unsigned offset = 0; chips->open[i] && offset < gpio_chip_lines(chips->open[i]); offset++) {
        struct gpio_line line;
        if (!gpio_chip_line(chips->open[i], offset, &line) || !*line.name)
            continue;
        if (strcmp(line.name, search->name) == 0) {
            if (search->found < 2) {
                search->chip[search->found] = i;
                search->offset[search->found] = offset;
            }
            search->found++;
            continue;
        }
        const unsigned apart = letters_apart(line.name, search->name);
        if (apart < search->apart) {
            search->apart = apart;
            strcpy(search->near, line.name);
        }
    }
}

static _Noreturn void fail_name(const struct gpio_chips *chips, const struct gpio_line_wish *wish,
                                const struct search *search)
{
    for (unsigned i = 0; i < chips->count; i++)
        if (chips->reasons[i] == EACCES)
            fail_denied(wish, chips->names[i]);
    if (is_number(search->name))
        fail("%s: %s=%s: no GPIO line has that name; if %s is an offset, name its chip: gpiochip0:%s, or --chip",
             wish->origin, wish->role, wish->text, search->name, search->name);
    if (search->apart < 3 && search->apart < strlen(search->name))
        fail("%s: %s=%s: no GPIO line has the name '%s'; did you mean %s? (`glint list` shows all)", wish->origin,
             wish->role, wish->text, search->name, search->near);
    fail("%s: %s=%s: no GPIO line has the name '%s'; `glint list` shows all, and lines without a name are CHIP:OFFSET",
         wish->origin, wish->role, wish->text, search->name);
}

static struct gpio_found found_by_name(struct gpio_chips *chips, const struct gpio_line_wish *wish, const char *name,
                                       unsigned first, unsigned end)
{
    struct search search = {.name = name, .apart = UINT32_MAX};
    for (unsigned i = first; i < end; i++)
        if (i == first || !gpio_chips_is_again(chips, i)) /* first: it may be the link that is asked for */
            search_chip(chips, i, &search);
    if (search.found == 0)
        fail_name(chips, wish, &search);
    if (search.found > 1)
        fail("%s: %s=%s: %u lines have that name; choose one: %s:%u, %s:%u%s", wish->origin, wish->role, wish->text,
             search.found, chips->names[search.chip[0]], search.offset[0], chips->names[search.chip[1]],
             search.offset[1], search.found > 2 ? " ..." : "");
    return (struct gpio_found){chips->open[search.chip[0]], search.offset[0]};
}

/* ---- lines ---- */

static struct gpio_found found_on(struct gpio_chips *chips, const struct gpio_line_wish *wish, unsigned i,
                                  const char *text)
{
    if (!chips->open[i] && chips->reasons[i] == EACCES)
        fail_denied(wish, chips->names[i]);
    if (!chips->open[i])
        fail("%s: %s=%s: /dev/%s cannot be opened: %s", wish->origin, wish->role, wish->text, chips->names[i],
             strerror(chips->reasons[i]));
    if (!is_number(text))
        return found_by_name(chips, wish, text, i, i + 1);
    const unsigned long offset = strtoul(text, NULL, 10);
    const unsigned lines = gpio_chip_lines(chips->open[i]);
    if (offset >= lines)
        fail("%s: %s=%s: %s has the lines 0 to %u", wish->origin, wish->role, wish->text, chips->names[i], lines - 1);
    return (struct gpio_found){chips->open[i], (unsigned)offset};
}

struct gpio_found gpio_find(const char *chip, const struct gpio_line_wish *wish)
{
    const char *text = wish->text + (*wish->text == '!');
    struct gpio_chips chips = chips_open(wish);
    const char *colon = strrchr(text, ':'); /* a path or label may hold one, too */
    char *before = colon ? copied_part(text, (size_t)(colon - text)) : NULL;
    const unsigned named = before ? chip_called(&chips, before) : chips.count;
    const unsigned given = chip ? chip_called(&chips, chip) : chips.count;
    struct gpio_found found;
    if (named < chips.count)
        found = found_on(&chips, wish, named, colon + 1);
    else if (before && is_number(colon + 1))
        fail_chip(&chips, wish, before);
    else if (given < chips.count)
        found = found_on(&chips, wish, given, text);
    else if (chip)
        fail_chip(&chips, wish, chip);
    else
        found = found_by_name(&chips, wish, text, 0, chips.count);
    free(before);
    gpio_chips_close(&chips, found.chip);
    return found;
}
