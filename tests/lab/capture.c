/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <traceevent/kbuffer.h>
#include <unistd.h>

#define TRACING "/sys/kernel/tracing/"
#define EVENT TRACING "events/gpio/gpio_value/"
#define CPU TRACING "per_cpu/cpu0/" /* there is one */

/* As EVENT "format" says, which capture_start checks. */
struct gpio_value {
    uint16_t type;
    uint8_t flags, preempt_count;
    int32_t process;
    uint32_t gpio;
    int32_t get;
    int32_t value;
};
static const char *const FIELDS[] = {
    "field:unsigned gpio;\toffset:8;\tsize:4;",
    "field:int get;\toffset:12;\tsize:4;",
    "field:int value;\toffset:16;\tsize:4;",
};

static void write_control(const char *path, const char *value)
{
    FILE *file = fopen(path, "w");
    if (!file || fputs(value, file) < 0 || fclose(file) != 0)
        fail_msg("%s: writing %s: %s", path, value, strerror(errno));
}

static void read_control(const char *path, char *text, size_t room)
{
    FILE *file = fopen(path, "r");
    if (!file)
        fail_msg("%s: %s", path, strerror(errno));
    text[fread(text, 1, room - 1, file)] = 0;
    fclose(file);
}

void capture_start(struct capture *capture, const struct chip *chip, unsigned buffer_mib)
{
    char text[4096];
    read_control(EVENT "format", text, sizeof text);
    for (size_t i = 0; i < sizeof FIELDS / sizeof *FIELDS; i++)
        if (!strstr(text, FIELDS[i]))
            fail_msg("the kernel's gpio_value has no %s", FIELDS[i]);
    *capture = (struct capture){.chip = chip};
    snprintf(text, sizeof text, "%u", buffer_mib * 1024);
    write_control(TRACING "tracing_on", "0");
    write_control(TRACING "buffer_size_kb", text);
    write_control(TRACING "options/overwrite", "0");
    write_control(TRACING "trace", "");
    write_control(EVENT "enable", "1");
    write_control(TRACING "tracing_on", "1");
}

static size_t statistic(const char *text, const char *name)
{
    const char *at = strstr(text, name);
    if (!at)
        fail_msg("the kernel's statistics have no %s", name);
    return strtoul(at + strlen(name), NULL, 10);
}

static void keep(struct capture *capture, const struct gpio_value *event)
{
    const uint32_t line = event->gpio - capture->chip->base;
    if (!event->get && line < capture->chip->count)
        capture->sets[capture->count++] = (uint8_t)(line | (event->value ? CAPTURE_HIGH : 0));
}

static size_t read_events(struct capture *capture, int fd)
{
    struct kbuffer *buffer = kbuffer_alloc(KBUFFER_LSIZE_SAME_AS_HOST, KBUFFER_ENDIAN_SAME_AS_HOST);
    assert_non_null(buffer);
    char page[4096] __attribute__((aligned(8)));
    size_t events = 0;
    while (read(fd, page, sizeof page) > 0) {
        kbuffer_load_subbuffer(buffer, page);
        assert_false(kbuffer_missed_events(buffer));
        unsigned long long time;
        for (const void *event; (event = kbuffer_read_event(buffer, &time)); kbuffer_next_event(buffer, NULL), events++)
            keep(capture, event);
    }
    kbuffer_free(buffer);
    return events;
}

void capture_stop_lossy(struct capture *capture)
{
    char text[1024];
    write_control(TRACING "tracing_on", "0");
    write_control(EVENT "enable", "0");
    read_control(CPU "stats", text, sizeof text);
    const size_t entries = statistic(text, "entries: ");
    capture->lost =
        statistic(text, "\noverrun: ") + statistic(text, "commit overrun: ") + statistic(text, "dropped events: ");
    capture->sets = malloc(entries + 1);
    assert_non_null(capture->sets);
    const int fd = open(CPU "trace_pipe_raw", O_RDONLY | O_NONBLOCK);
    assert_true(fd >= 0);
    assert_int_equal(read_events(capture, fd), entries);
    close(fd);
    write_control(TRACING "buffer_size_kb", "64");
}

void capture_stop(struct capture *capture)
{
    capture_stop_lossy(capture);
    assert_int_equal(capture->lost, 0);
}

void capture_free(struct capture *capture)
{
    free(capture->sets);
    *capture = (struct capture){0};
}

void capture_levels(const struct capture *capture, bool high[LAB_LINES_MAX])
{
    for (unsigned i = 0; i < LAB_LINES_MAX; i++)
        high[i] = false;
    for (size_t i = capture->count; i-- > 0;)
        high[capture->sets[i] & CAPTURE_LINE] = capture->sets[i] & CAPTURE_HIGH;
}

/* A change, if it is one. */
static void write_change(FILE *file, unsigned line, bool value, bool *high, size_t *time)
{
    if (value == high[line])
        return;
    high[line] = value;
    fprintf(file, "#%zu\n%d%c\n", ++*time, value, '!' + (int)line);
}

void capture_write_vcd(const struct capture *capture, const char *path, const char *clock_name)
{
    const struct chip *chip = capture->chip;
    const unsigned clock = chip_line(chip, clock_name), dc = chip_line(chip, "DC");
    FILE *file = fopen(path, "w");
    if (!file)
        fail_msg("%s: %s", path, strerror(errno));
    fputs("$timescale 1 us $end\n$scope module panel $end\n", file);
    for (unsigned i = 0; i < chip->count; i++)
        fprintf(file, "$var wire 1 %c %s $end\n", '!' + (int)i, chip->lines[i]);
    fputs("$upscope $end\n$enddefinitions $end\n#0\n", file);
    bool high[LAB_LINES_MAX];
    capture_levels(capture, high);
    for (unsigned i = 0; i < chip->count; i++)
        fprintf(file, "%d%c\n", high[i], '!' + (int)i);
    size_t time = 0;
    bool data = high[dc];
    for (size_t i = 0; i < capture->count; i++) {
        const unsigned line = capture->sets[i] & CAPTURE_LINE;
        const bool value = capture->sets[i] & CAPTURE_HIGH;
        if (line == dc)
            data = value;
        else
            write_change(file, line, value, high, &time);
        if (line == clock)
            write_change(file, dc, data, high, &time);
    }
    write_change(file, clock, false, high, &time);
    write_change(file, clock, true, high, &time);
    fprintf(file, "#%zu\n", time + 1);
    assert_int_equal(fclose(file), 0);
}
