/* SPDX-License-Identifier: MIT
 * Fuzzes the light device with what a host may send. Input: width, height (1 each; from 0x80 on it holds a mesh), then steps: what (1), and what it needs. */
#include <string.h>

#include "fuzz.h"
#include "light_device.h"

enum { INTERFACE = 1, SIDE_MAX = 16, WORD_BYTES = 4 };

static struct gud_device gud;
static struct light_device device;
static const struct light_mesh mesh = {1, 2, 3, 180};

/* A sensor that answers anything. */
static enum light_sense sense(int32_t to_light[3])
{
    to_light[device.first % 3] = device.count % 2 ? INT32_MIN : INT32_MAX;
    return (enum light_sense)(device.count % 3);
}

static unsigned status(void)
{
    uint8_t reply[GUD_REPLY_BYTES];
    const struct gud_setup setup = {GUD_TYPE_IN, LIGHT_GET_STATUS, 0, INTERFACE, 1};
    check(light_device_setup(&device, &setup, reply) == 1);
    check(reply[0] <= GUD_ERROR);
    return reply[0];
}

static void request(const struct gud_setup *setup, struct input *input)
{
    uint8_t *const reply = malloc(GUD_REPLY_BYTES);
    const int length = light_device_setup(&device, setup, reply);
    check(length >= GUD_STALL && length <= setup->length);
    if (length == GUD_STALL) {
        check(setup->index != INTERFACE || status() != GUD_OK);
    } else if (setup->type == GUD_TYPE_OUT) {
        size_t count = (size_t)length;
        uint8_t *const data = next_bytes(input, &count);
        if (count == (size_t)length) {
            const bool good = light_device_set(&device, setup, data);
            /* With lights in its queue it tells BUSY all the same. */
            check(good ? status() == GUD_OK || device.count : status() != GUD_OK);
        }
        free(data);
    }
    free(reply);
}

/* As a host sends them, so that the fuzzer need not find each byte. */
static void proper(uint8_t number, uint16_t length, struct input *input)
{
    const struct gud_setup setup = {GUD_TYPE_OUT, number, 0, INTERFACE, length};
    request(&setup, input);
}

/* As boards do: what the device takes can be painted with, and lit where the light is a direction. By an exact paint, as filling tables
 * takes long. */
static void paint(const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    struct glint_output output;
    struct glint_paint paint;
    struct glint_light light;
    light_material_output(&output, &device.material);
    check(glint_paint_exact(&paint, &device.material.material, &output) == GLINT_OK);
    if (glint_light_directional(&light, to_light) == GLINT_OK) {
        const enum glint_err error = glint_paint_light(&paint, &light, 1, to_viewer);
        check(error == GLINT_OK || error == GLINT_ERR_VECTOR); /* straight behind */
    }
}

static void use(void)
{
    int32_t to_light[3] = {0, 0, 1};
    struct light_pose pose;
    check(device.count <= LIGHT_QUEUE);
    if (light_device_next(&device, to_light))
        check(device.has_material && device.has_map);
    if (light_device_next_pose(&device, &pose)) {
        check(device.has_material && device.has_mesh && !device.has_map && device.mesh);
        for (int i = 0; i < 3; i++)
            to_light[i] = pose.to_light[i];
    }
    if (device.has_material)
        paint(to_light);
}

static void step(struct input *input)
{
    const unsigned what = next_byte(input);
    switch (what % 8) {
    case 0: {
        const struct gud_setup setup = next_setup(input);
        request(&setup, input);
        break;
    }
    case 1:
        proper(LIGHT_SET_ENABLE, 1, input);
        break;
    case 2:
        proper(LIGHT_SET_MATERIAL, LIGHT_MATERIAL_BYTES, input);
        break;
    case 3:
        proper(what / 8 % 2 ? LIGHT_SET_MESH : LIGHT_SET_MAP, 0, input);
        break;
    case 4:
    case 5: {
        size_t count = what % 8 == 4 ? what / 8 : next_word(input) % 2048;
        uint8_t *const bytes = next_bytes(input, &count);
        if (light_device_has_room(&device, count) || what & 0x80) /* a board asks first, but bugs should not spread */
            light_device_bulk(&device, bytes, count);
        check(device.map_bytes <= WORD_BYTES * (uint32_t)device.width * device.height);
        free(bytes);
        break;
    }
    case 6:
        use();
        break;
    default:
        if (what / 8 % 4 == 0)
            light_device_reset(&device);
        gud.open = what / 8 % 4 == 1; /* a rectangle of the display's is being drawn */
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    memset(&gud, 0, sizeof gud);
    const unsigned width = next_byte(&input), height = next_byte(&input);
    device = (struct light_device){.width = (uint16_t)(1 + width % SIDE_MAX),
                                   .sense = height & 1 ? sense : NULL,
                                   .height = (uint16_t)(1 + height % SIDE_MAX),
                                   .mesh = height & 0x80 ? &mesh : NULL,
                                   .interface = INTERFACE,
                                   .gud = &gud};
    device.map = malloc(WORD_BYTES * (size_t)device.width * device.height);
    while (input.at < input.end)
        step(&input);
    free(device.map);
    return 0;
}
