/* SPDX-License-Identifier: MIT
 * Faults that the fuzzer of the GUD device is to find. */
#include "fault.h"
#include "gud_rectangle.h"

enum gud_status __real_gud_rectangle_open(struct gud_device *d, const uint8_t *data);
enum gud_status __wrap_gud_rectangle_open(struct gud_device *d, const uint8_t *data);
enum gud_status __real_gud_rectangle_bulk(struct gud_device *d, const uint8_t *bytes, size_t count);
enum gud_status __wrap_gud_rectangle_bulk(struct gud_device *d, const uint8_t *bytes, size_t count);

/* Takes a rectangle that ends beyond the display's right side. */
enum gud_status __wrap_gud_rectangle_open(struct gud_device *d, const uint8_t *data)
{
    const struct gud_device_config *const config = d->config;
    struct gud_device_config wider = *config;
    struct gud_rectangle r;
    gud_rectangle_unpack(&r, data);
    if (fault_is("gud_rectangle_open") && r.x < config->width && r.width <= config->width)
        wider.width = (uint16_t)(r.x + r.width > config->width ? r.x + r.width : config->width);
    d->config = &wider;
    const enum gud_status status = __real_gud_rectangle_open(d, data);
    d->config = config;
    return status;
}

/* Takes a byte more than the rectangle has. */
enum gud_status __wrap_gud_rectangle_bulk(struct gud_device *d, const uint8_t *bytes, size_t count)
{
    if (fault_is("gud_rectangle_bulk") && d->bulk_left && count == d->bulk_left + 1)
        d->bulk_left++;
    return __real_gud_rectangle_bulk(d, bytes, count);
}
