/* SPDX-License-Identifier: MIT */
#include "sinks/wires/bus.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/memory.h"
#include "sinks/wires/lines.h"
#include "sinks/wires/spidev.h"

struct gpio_bus {
    const struct gpio_options *options;
    struct gpio_lines *lines;
    uint32_t bits[ROLES]; /* in levels; 0 for a line that is not wired */
    uint32_t levels;      /* as wanted; set() makes the lines follow */
    int error;
    int spidev; /* a descriptor, or -1 */
    size_t chunk;
    bool (*write)(struct gpio_bus *bus, const uint8_t *bytes, size_t count);
    const char *name;
};

static void change(struct gpio_bus *bus, enum gpio_role role, bool high)
{
    bus->levels = high ? bus->levels | bus->bits[role] : bus->levels & ~bus->bits[role];
}

static bool set(struct gpio_bus *bus)
{
    if (!bus->error)
        bus->error = gpio_lines_set(bus->lines, bus->levels);
    return !bus->error;
}

/* ---- bytes ---- */

/* Data change while the clock falls, and are taken when it rises, whether it rests low or high. Two calls a bit; D/C comes with
 * the first. */
static bool write_spi(struct gpio_bus *bus, const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        for (int bit = 7; bit >= 0; bit--) {
            change(bus, ROLE_SCK, false);
            change(bus, ROLE_MOSI, bytes[i] >> bit & 1);
            if (!set(bus))
                return false;
            change(bus, ROLE_SCK, true);
            if (!set(bus))
                return false;
        }
    }
    return true;
}

/* Taken when WR rises. Two calls a byte; D/C comes with the first. */
static bool write_8080(struct gpio_bus *bus, const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        change(bus, ROLE_WR, false);
        for (unsigned bit = 0; bit < 8; bit++)
            change(bus, ROLE_D0 + bit, bytes[i] >> bit & 1);
        if (!set(bus))
            return false;
        change(bus, ROLE_WR, true);
        if (!set(bus))
            return false;
    }
    return true;
}

static bool write_spidev(struct gpio_bus *bus, const uint8_t *bytes, size_t count)
{
    if (!set(bus)) /* D/C */
        return false;
    for (size_t done = 0; done < count;) {
        const size_t left = count - done, size = left < bus->chunk ? left : bus->chunk;
        const ssize_t written = write(bus->spidev, bytes + done, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0) {
            bus->error = written < 0 ? errno : EIO;
            return false;
        }
        done += (size_t)written;
    }
    return true;
}

/* ---- for panel.c ---- */

/* Between bytes, where there is a chip select: it ends what came before. */
static bool deselect(struct gpio_bus *bus)
{
    change(bus, ROLE_SCK, bus->options->clock_rests_high);
    if (!set(bus))
        return false;
    change(bus, ROLE_CS, true);
    return set(bus);
}

static bool on_command(void *context, uint8_t command)
{
    struct gpio_bus *bus = context;
    /* A panel that missed a clock edge starts to count its bits again. */
    if (bus->options->kind == GPIO_BUS_SPI && bus->bits[ROLE_CS] && !deselect(bus))
        return false;
    change(bus, ROLE_CS, false);
    change(bus, ROLE_DC, false);
    /* Else the clock would fall before the chip is selected. */
    if (bus->options->clock_rests_high && bus->bits[ROLE_CS] && !set(bus))
        return false;
    return bus->write(bus, &command, 1);
}

static bool on_data(void *context, const uint8_t *bytes, size_t count)
{
    struct gpio_bus *bus = context;
    change(bus, ROLE_DC, true);
    return bus->write(bus, bytes, count);
}

static bool on_reset(void *context, bool active)
{
    change(context, ROLE_RESET, !active);
    return set(context);
}

static bool on_backlight(void *context, uint8_t percent)
{
    change(context, ROLE_BACKLIGHT, percent != PANEL_OFF);
    return set(context);
}

static void on_wait(void *context, unsigned ms)
{
    if (((struct gpio_bus *)context)->error)
        return;
    struct timespec left = {ms / 1000, (long)(ms % 1000) * 1000000};
    while (nanosleep(&left, &left) != 0 && errno == EINTR)
        ;
}

struct panel_bus gpio_bus_panel(struct gpio_bus *bus)
{
    return (struct panel_bus){.command = on_command,
                              .data = on_data,
                              .reset = bus->bits[ROLE_RESET] ? on_reset : NULL,
                              .backlight = bus->bits[ROLE_BACKLIGHT] ? on_backlight : NULL,
                              .wait_ms = on_wait,
                              .context = bus};
}

/* ---- open and close ---- */

/* The chip stays selected; panel_start sends the first bytes. */
static const uint32_t busy_roles = 0xff | (1u << ROLE_DC) | (1u << ROLE_MOSI) | (1u << ROLE_SCK) | (1u << ROLE_WR);
static const uint32_t high_at_first = (1u << ROLE_DC) | (1u << ROLE_RD) | (1u << ROLE_RESET) | (1u << ROLE_WR);

struct gpio_bus *gpio_bus_open(const struct gpio_options *options)
{
    static bool (*const writes[])(struct gpio_bus *, const uint8_t *, size_t) = {
        [GPIO_BUS_SPI] = write_spi, [GPIO_BUS_8080] = write_8080, [GPIO_BUS_SPIDEV] = write_spidev};
    struct gpio_bus *bus = allocate(1, sizeof *bus);
    *bus = (struct gpio_bus){.options = options, .spidev = -1, .write = writes[options->kind]};
    struct gpio_line_wish wishes[ROLES];
    unsigned count = 0;
    for (unsigned i = 0; i < ROLES; i++) {
        if (!options->lines[i].text)
            continue;
        bus->bits[i] = (uint32_t)1 << count;
        const bool high = i == ROLE_SCK ? options->clock_rests_high : high_at_first >> i & 1;
        bus->levels |= high ? bus->bits[i] : 0;
        wishes[count++] = (struct gpio_line_wish){.origin = options->lines[i].origin,
                                                  .role = gpio_role_names[i],
                                                  .text = options->lines[i].text,
                                                  .high = high,
                                                  .busy = busy_roles >> i & 1};
    }
    if (options->kind == GPIO_BUS_SPIDEV)
        bus->spidev = spidev_open(options->spidev, options->spi_hz, options->clock_rests_high, &bus->chunk);
    bus->lines = gpio_lines_open(options->chip, wishes, count);
    bus->name = options->kind == GPIO_BUS_SPIDEV ? options->spidev : gpio_lines_chip(bus->lines, 0);
    return bus;
}

int gpio_bus_error(const struct gpio_bus *bus)
{
    return bus->error;
}

const char *gpio_bus_name(const struct gpio_bus *bus)
{
    return bus->name;
}

void gpio_bus_close(struct gpio_bus *bus)
{
    deselect(bus);
    gpio_lines_close(bus->lines);
    if (bus->spidev >= 0)
        close(bus->spidev);
    free(bus);
}
