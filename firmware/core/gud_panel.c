/* SPDX-License-Identifier: MIT */
#include "gud_panel.h"

static void wait_until_sent(const struct gud_panel *gud)
{
    while (gud->is_sending)
        ;
}

static void window(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    struct gud_panel *gud = context;
    wait_until_sent(gud);
    if (!panel_window(gud->panel, x, y, width, height))
        gud->has_failed = true;
    gud->is_open = true;
}

static void sent(void *argument)
{
    ((struct gud_panel *)argument)->is_sending = false;
}

static void line(void *context, const uint8_t *pixels, size_t bytes)
{
    struct gud_panel *gud = context;
    wait_until_sent(gud);
    gud->is_sending = true;
    gud->hal->flush(gud->hal->context, (const uint16_t *)(const void *)pixels, bytes / 2, sent, gud);
}

static void end(void *context, bool whole)
{
    ((struct gud_panel *)context)->is_open = false;
    (void)whole; /* the next window ends what was cut short */
}

uint8_t gud_panel_percent(bool on, uint8_t brightness)
{
    const unsigned square = (brightness * (unsigned)brightness + PANEL_BRIGHTEST / 2) / PANEL_BRIGHTEST;
    return !on ? PANEL_OFF : square ? (uint8_t)square : 1;
}

static void display(void *context, bool on, uint8_t brightness)
{
    struct gud_panel *gud = context;
    wait_until_sent(gud);
    if (!panel_show(gud->panel, gud_panel_percent(on, brightness)))
        gud->has_failed = true;
    const struct panel_bus *bus = gud->panel->bus;
    if (gud->is_open && !bus->command(bus->context, PANEL_MEMORY_CONTINUE)) /* any command ends a write */
        gud->has_failed = true;
}

const struct gud_device_ops gud_panel_ops = {window, line, end, display, NULL};
