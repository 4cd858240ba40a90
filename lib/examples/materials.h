/* SPDX-License-Identifier: MIT
 * Materials by name, written by `glint material --all`, version 0.3.0: make a paint of one by glint_paint_exact.
 * One with n_across has a grain: say its direction in struct glint_maps. */
#ifndef GLINT_EXAMPLES_MATERIALS_H
#define GLINT_EXAMPLES_MATERIALS_H

#include "glint.h"

/* clang-format off */

/* polished gold: n, k of refractiveindex.info at red, green and blue, as physicallybased.info lists them: gold. */
static const struct glint_material material_gold = {
    GLINT_MSH, 0, 40, 0, /* model, q, n, n_across */
    {18350, 18350, 18350}, /* ambient */
    {40632, 40632, 40632}, /* diffuse */
    {51122, 46885, 33808}, /* specular */
    {236, 182, 65}, /* albedo */
    false /* clamp_peak */
};

/* polished brass: n, k of refractiveindex.info at red, green and blue, as physicallybased.info lists them: brass. */
static const struct glint_material material_brass = {
    GLINT_MSH, 0, 34, 0, /* model, q, n, n_across */
    {16384, 16384, 16384}, /* ambient */
    {40632, 40632, 40632}, /* diffuse */
    {44763, 42498, 32559}, /* specular */
    {225, 198, 103}, /* albedo */
    false /* clamp_peak */
};

/* polished copper: n, k of refractiveindex.info at red, green and blue, as physicallybased.info lists them: copper. */
static const struct glint_material material_copper = {
    GLINT_MSH, 0, 28, 0, /* model, q, n, n_across */
    {17039, 17039, 17039}, /* ambient */
    {43254, 43254, 43254}, /* diffuse */
    {44348, 39706, 33860}, /* specular */
    {230, 165, 100}, /* albedo */
    false /* clamp_peak */
};

/* polished steel: n, k of refractiveindex.info at red, green and blue, as physicallybased.info lists them: iron. */
static const struct glint_material material_steel = {
    GLINT_MSH, 0, 60, 0, /* model, q, n, n_across */
    {15729, 15729, 15729}, /* ambient */
    {31457, 31457, 31457}, /* diffuse */
    {49517, 48722, 48012}, /* specular */
    {193, 190, 187}, /* albedo */
    false /* clamp_peak */
};

/* steel with a grain: n, k of refractiveindex.info at red, green and blue, as physicallybased.info lists them: iron. */
static const struct glint_material material_brushed_steel = {
    GLINT_MSH, 0, 150, 10, /* model, q, n, n_across */
    {15729, 15729, 15729}, /* ambient */
    {27525, 27525, 27525}, /* diffuse */
    {44565, 43850, 43211}, /* specular */
    {193, 190, 187}, /* albedo */
    false /* clamp_peak */
};

/* chromium plate, a near mirror: n, k of refractiveindex.info at red, green and blue, as physicallybased.info lists them: chromium. */
static const struct glint_material material_chrome = {
    GLINT_MSH, 0, 120, 0, /* model, q, n, n_across */
    {9175, 9175, 9175}, /* ambient */
    {32768, 32768, 32768}, /* diffuse */
    {53726, 54217, 54658}, /* specular */
    {209, 211, 213}, /* albedo */
    false /* clamp_peak */
};

/* blued steel: not measured: a grey of .20, as dark as magnetite. */
static const struct glint_material material_gunmetal = {
    GLINT_MSH, 0, 40, 0, /* model, q, n, n_across */
    {16384, 16384, 16384}, /* ambient */
    {32768, 32768, 32768}, /* diffuse */
    {24904, 24904, 24904}, /* specular */
    {122, 124, 127}, /* albedo */
    false /* clamp_peak */
};

/* red plastic: red plastic of Kilgard's teapots.c, Silicon Graphics 1994. */
static const struct glint_material material_plastic = {
    GLINT_MSH, 0, 40, 0, /* model, q, n, n_across */
    {16384, 16384, 16384}, /* ambient */
    {65536, 65536, 65536}, /* diffuse */
    {39322, 39322, 39322}, /* specular */
    {128, 0, 0}, /* albedo */
    false /* clamp_peak */
};

/* black rubber: a tire measured for physicallybased.info: .023 linear. */
static const struct glint_material material_rubber = {
    GLINT_MSH, 0, 5, 0, /* model, q, n, n_across */
    {26214, 26214, 26214}, /* ambient */
    {65536, 65536, 65536}, /* diffuse */
    {10486, 10486, 10486}, /* specular */
    {42, 42, 42}, /* albedo */
    false /* clamp_peak */
};

/* white glazed porcelain: porcelain measured for physicallybased.info: .745, .745, .723 linear. */
static const struct glint_material material_porcelain = {
    GLINT_MSH, 0, 250, 0, /* model, q, n, n_across */
    {24904, 24904, 24904}, /* ambient */
    {40632, 40632, 40632}, /* diffuse */
    {52429, 52429, 52429}, /* specular */
    {224, 224, 221}, /* albedo */
    false /* clamp_peak */
};

/* black piano lacquer: charcoal black of physicallybased.info: .02 linear. */
static const struct glint_material material_lacquer = {
    GLINT_MSH, 0, 400, 0, /* model, q, n, n_across */
    {13107, 13107, 13107}, /* ambient */
    {52429, 52429, 52429}, /* diffuse */
    {62259, 62259, 62259}, /* specular */
    {39, 39, 39}, /* albedo */
    false /* clamp_peak */
};

/* polished jade: jade of Kilgard's teapots.c, Silicon Graphics 1994. */
static const struct glint_material material_jade = {
    GLINT_MSH, 0, 60, 0, /* model, q, n, n_across */
    {14418, 14418, 14418}, /* ambient */
    {32768, 32768, 32768}, /* diffuse */
    {26214, 26214, 26214}, /* specular */
    {138, 227, 161}, /* albedo */
    false /* clamp_peak */
};

/* dark green bottle glass, seen against the dark: not measured: a deep bottle green of .004, .05, .018 linear. */
static const struct glint_material material_glass = {
    GLINT_MSH, 0, 300, 0, /* model, q, n, n_across */
    {29491, 29491, 29491}, /* ambient */
    {52429, 52429, 52429}, /* diffuse */
    {62259, 62259, 62259}, /* specular */
    {13, 63, 36}, /* albedo */
    false /* clamp_peak */
};

/* red car paint under a clear coat: RAL 3020, traffic red, as its sRGB is usually listed: 204, 6, 5. */
static const struct glint_material material_car_paint = {
    GLINT_MSH, 0, 160, 0, /* model, q, n, n_across */
    {13107, 13107, 13107}, /* ambient */
    {52429, 52429, 52429}, /* diffuse */
    {58982, 58982, 58982}, /* specular */
    {204, 6, 5}, /* albedo */
    false /* clamp_peak */
};

#endif
