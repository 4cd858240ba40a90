/* SPDX-License-Identifier: MIT
 * A fault that the fuzzer of the light device is to find. */
#include "fault.h"
#include "light_device.h"

void __real_light_device_bulk(struct light_device *d, const uint8_t *bytes, size_t count);
void __wrap_light_device_bulk(struct light_device *d, const uint8_t *bytes, size_t count);

/* A byte beyond the map, when it is whole. */
void __wrap_light_device_bulk(struct light_device *d, const uint8_t *bytes, size_t count)
{
    const bool was_in_map = d->in_map;
    __real_light_device_bulk(d, bytes, count);
    if (fault_is("light_device_bulk") && was_in_map && !d->in_map && count)
        ((uint8_t *)d->map)[d->map_bytes++] = bytes[count - 1];
}
