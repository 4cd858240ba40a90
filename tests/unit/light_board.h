/* SPDX-License-Identifier: MIT
 * A light device with a small map, for tests of light_device.c: begin and end are set-up and teardown of each test. */
#ifndef GLINT_LIGHT_BOARD_H
#define GLINT_LIGHT_BOARD_H

#include <stdlib.h>

#include "light_device.h"
#include "unit.h"

enum { WIDTH = 6, HEIGHT = 5, PIXELS = WIDTH * HEIGHT, INTERFACE = 1 };

static uint32_t *map; /* on the heap, so that the sanitizers see its ends */
static struct gud_device gud;
static struct light_device device;
static uint8_t reply[GUD_REPLY_BYTES];

static int begin(void **state)
{
    (void)state;
    map = calloc(PIXELS, sizeof *map);
    gud = (struct gud_device){0};
    device = (struct light_device){.width = WIDTH, .height = HEIGHT, .interface = INTERFACE, .map = map, .gud = &gud};
    return !map;
}

static int end(void **state)
{
    (void)state;
    free(map);
    return 0;
}

static struct gud_setup request(uint8_t type, uint8_t number, size_t length)
{
    return (struct gud_setup){type, number, 0, INTERFACE, (uint16_t)length};
}

static bool set(uint8_t number, const void *data, size_t length)
{
    const struct gud_setup setup = request(GUD_TYPE_OUT, number, length);
    const int wanted = light_device_setup(&device, &setup, reply);
    return wanted != GUD_STALL && wanted == (int)length && light_device_set(&device, &setup, data);
}

static uint8_t status(void)
{
    const struct gud_setup setup = request(GUD_TYPE_IN, LIGHT_GET_STATUS, 1);
    assert_int_equal(light_device_setup(&device, &setup, reply), 1);
    return reply[0];
}

static bool enable(uint8_t value)
{
    return set(LIGHT_SET_ENABLE, &value, 1);
}

static bool set_material(const struct light_material *what)
{
    uint8_t bytes[LIGHT_MATERIAL_BYTES];
    light_material_pack(bytes, what);
    return set(LIGHT_SET_MATERIAL, bytes, sizeof bytes);
}

#endif
