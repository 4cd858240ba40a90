/* SPDX-License-Identifier: MIT
 * Materials by name: the one list, for --material, `glint material --preset`, the page and lib/examples/materials.h. */
#ifndef GLINT_SCENE_MATERIALS_H
#define GLINT_SCENE_MATERIALS_H

#include <stdbool.h>

#include "scene/scene.h"

struct preset {
    const char *name;    /* as options take it: "brushed-steel" */
    const char *meaning; /* half a sentence */
    const char *source;  /* where its colour was measured or published */
    struct finish finish;
    uint8_t color[3]; /* sRGB: the albedo where there is no map */
    bool is_metal;
};

/* X(name, recipe): the recipe is materials.c's. */
/* clang-format off */
#define PRESETS(X) \
    X("gold", gold) \
    X("brass", brass) \
    X("copper", copper) \
    X("steel", steel) \
    X("brushed-steel", brushed_steel) \
    X("chrome", chrome) \
    X("gunmetal", gunmetal) \
    X("plastic", plastic) \
    X("rubber", rubber) \
    X("porcelain", porcelain) \
    X("lacquer", lacquer) \
    X("jade", jade) \
    X("glass", glass) \
    X("car-paint", car_paint)
/* clang-format on */
/* "gold, brass, ..., ", for help. */
#define PRESET_WORD(name, recipe) name ", "
#define PRESET_WORDS PRESETS(PRESET_WORD)
extern const char *const preset_names[]; /* ends with NULL */
/* By its place in preset_names. */
struct preset preset_of(unsigned place);

#endif
