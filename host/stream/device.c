/* SPDX-License-Identifier: MIT */
#include "stream/device.h"

#include "bake/bake.h"
#include "base/message.h"
#include "draw/shading_device.h"
#include "image/format.h"

enum sink_result device_send_scene(struct sink *sink, const struct scene *scene, const struct shading *shading)
{
    struct light_material material;
    const char *refusal = device_refusal(scene, shading, &material);
    if (refusal)
        fail("--shade device: %s", refusal);
    struct baked *baked = bake(scene, BAKE_INT8, 0);
    const enum sink_result result = sink->kind->shader->send_scene(sink, &material, baked->words);
    baked_free(baked);
    return result;
}

enum sink_result device_read_light(struct sink *sink, struct shading *shading)
{
    int32_t to_light[3];
    const enum sink_result result = sink->kind->shader->read_light(sink, to_light);
    for (unsigned k = 0; k < 3 && result == SINK_SENT; k++)
        shading->lamps[0].direction[k] = to_light[k] / 32768.;
    return result;
}

enum sink_result device_send_light(struct sink *sink, const struct shading *shading, struct plan_result *result)
{
    int32_t to_light[3];
    direction_integers(shading->lamps[0].direction, to_light);
    *result = (struct plan_result){.count = 1,
                                   .changed = (size_t)sink->width * sink->height,
                                   .whole_bytes = format_line_bytes(sink->format, sink->width) * sink->height};
    return sink->kind->shader->send_light(sink, to_light, &result->bytes);
}
