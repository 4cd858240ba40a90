/* SPDX-License-Identifier: MIT */
#include "draw/shading_device.h"

#include <string.h>

#include "draw/paths.h"

/* All pixels that are drawn must have one albedo, which becomes the material's, and full gloss. */
static const char *colour_refusal(const struct scene *scene, uint8_t albedo[3])
{
    const size_t pixels = (size_t)scene->width * scene->height;
    bool found = !scene->albedo;
    for (size_t i = 0; i < pixels; i++) {
        if (scene->mask && !scene->mask[i])
            continue;
        if (scene->gloss && scene->gloss[i] != 255)
            return "the device has no gloss map; take a height or normal map, give --gloss a white picture, or shade "
                   "here";
        if (scene->albedo && found && memcmp(albedo, &scene->albedo[3 * i], 3) != 0)
            return "the device draws one colour; give it by --color, or shade here";
        if (scene->albedo)
            memcpy(albedo, &scene->albedo[3 * i], 3);
        found = true;
    }
    return NULL;
}

const char device_needs_black[] = "the device draws over black; leave out --background";

/* What it draws the map's pixels by, and over. */
static const char *map_refusal(const struct scene *scene)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    if (scene->shininess)
        return "the device takes no map of shininess, as --filter makes it; leave out --filter";
    for (size_t i = 0; scene->mask && i < pixels; i++)
        if (scene->mask[i] && scene->mask[i] < 255)
            return "the device draws no soft edges; give --mask a picture of black and white, or shade here";
    return scene->mask && scene->backdrop ? device_needs_black : NULL;
}

const char *device_refusal(const struct scene *scene, const struct shading *shading, struct light_material *material)
{
    struct shading by_tables = *shading;
    unsigned path = 0;
    while (strcmp(path_names[path], "colour-int8") != 0)
        path++;
    if (shading->path != 0 && shading->path != path)
        return "the device takes --path colour-int8; leave out --path";
    if (shading->dither)
        return "the device does not dither; leave out --dither";
    by_tables.path = path;
    if (path_refusal(&by_tables))
        return path_refusal(&by_tables);
    if (map_refusal(scene))
        return map_refusal(scene);
    struct glint_material of_shading = shading_material(&by_tables);
    const struct glint_output output = shading_output(&by_tables);
    const char *refusal = colour_refusal(scene, of_shading.albedo);
    light_material_of(material, &of_shading, &output);
    return refusal;
}
