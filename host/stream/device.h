/* SPDX-License-Identifier: MIT
 * A stream to a device that shades by itself: the scene once, then lights. */
#ifndef GLINT_STREAM_DEVICE_H
#define GLINT_STREAM_DEVICE_H

#include "options/shading_options.h"
#include "plan/plan.h"

enum sink_result device_send_scene(struct sink *sink, const struct scene *scene, const struct shading *shading);
/* Moves the light to where the device's own sensor has it. */
enum sink_result device_read_light(struct sink *sink, struct shading *shading);
enum sink_result device_send_light(struct sink *sink, const struct shading *shading, struct plan_result *result);

#endif
