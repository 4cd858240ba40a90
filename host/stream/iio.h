/* SPDX-License-Identifier: MIT
 * Linux's accelerometers (IIO), read through sysfs: gravity as the light, as on boards that have one (firmware/core/tilt.h). */
#ifndef GLINT_STREAM_IIO_H
#define GLINT_STREAM_IIO_H

#include <stdbool.h>

/* Does --lights name a sensor rather than a file? "iio", or "iio:FOLDER": a device's, or one with devices in it. */
bool iio_is_named(const char *lights);

struct iio;
/* The first device that has three axes. Fails where there is none. */
struct iio *iio_open(const char *lights);
/* Where the light is now. */
void iio_light(struct iio *iio, double direction[3]);
void iio_close(struct iio *iio);

#endif
