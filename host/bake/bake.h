/* SPDX-License-Identifier: MIT
 * A scene's normals as the library draws them. */
#ifndef GLINT_BAKE_BAKE_H
#define GLINT_BAKE_BAKE_H

#include "bake/palette.h"
#include "glint.h"
#include "scene/scene.h"

enum bake_format { BAKE_INT16, BAKE_INT8, BAKE_PALETTE, BAKE_FORMATS };
extern const char *const bake_format_names[]; /* "int16" ..., by enum bake_format; ends with NULL */

/* X(name, what it is): the maps beside the normals, for struct glint_maps, where they have these names. */
#define BAKED(X)                                                                                                       \
    X(coverage, "how much of a pixel is covered")                                                                      \
    X(grain, "the way of the grain, 256 a half turn")                                                                  \
    X(shininess, "by glint_shininess_n")                                                                               \
    X(gloss, "255 full")
#define BAKED_NUMBER(name, meaning) BAKED_##name,
enum { BAKED(BAKED_NUMBER) BAKED_MAPS };
extern const char *const baked_map_names[], *const baked_map_meanings[];

/* Of one allocation a pointer; those of other formats are NULL. */
struct baked {
    enum bake_format format;
    uint32_t width, height;
    struct glint_vec *normals; /* int16: a pixel each; palette: an entry each */
    uint32_t *words;           /* int8 */
    uint16_t *offsets;         /* palette: 2 x entry */
    uint32_t entries;          /* palette */
    uint16_t *albedo;          /* RGB565, for ALBEDO tables; NULL where bake_albedo was not called */
    uint8_t *maps[BAKED_MAPS]; /* a byte a pixel; NULL where the scene has no such map, or soft edge */
};
/* `entries`: the most that a palette may have, the first one included. */
struct baked *bake(const struct scene *scene, enum bake_format format, uint32_t entries);
void bake_albedo(struct baked *baked, const struct scene *scene); /* the scene has an albedo */
void baked_free(struct baked *baked);
size_t baked_bytes(const struct baked *baked);
/* The normal that the library sees; 0, 0, 0 where there is no surface. */
struct glint_vec baked_normal(const struct baked *baked, size_t pixel);

#endif
