/* SPDX-License-Identifier: MIT
 *
 * Does the library give the host's results here? Every public function over a spread of arguments, a hash a check: equal
 * hashes mean equal results. An image prints a line a check and `N passed, N failed`, by itself on any board: what the
 * host finds, by the same code, is compiled in (conformance_expected.h, which expected.c writes while the image is built). */
#ifndef CONFORMANCE_H
#define CONFORMANCE_H

#include <stdbool.h>
#include <stdint.h>

#include "glint.h"

/* 0: without tables and outlines, for machines whose RAM is less than COLOUR's 20 KB and an outline's 2. */
#ifndef CONFORMANCE_TABLES
#define CONFORMANCE_TABLES 1
#endif
/* 0: without MSH and Schlick at every c, for machines that would take minutes. */
#ifndef CONFORMANCE_EVERY_C
#define CONFORMANCE_EVERY_C 1
#endif
/* 1: tables under a light, and meshes by ALBEDO tables, alone: for machines of 128 KB of flash and 16 KB of RAM. */
#ifndef CONFORMANCE_ALBEDO_ONLY
#define CONFORMANCE_ALBEDO_ONLY 0
#endif
/* 1: models and prepared lobes alone, for machines of 32 KB of flash and 2 KB of RAM. */
#ifndef CONFORMANCE_MODELS_ONLY
#define CONFORMANCE_MODELS_ONLY 0
#endif

/* Text for each model that has functions of its own; those that share another's are left out. */
#define CONFORMANCE_MODELS(number, name, function, use, grain) CONFORMANCE_IF_##use(name)
#define CONFORMANCE_IF_shared(name)

#define CONFORMANCE_IF_own(name) CONFORMANCE_##name,
enum conformance_check {
    /* clang-format off */
    GLINT_MODELS(CONFORMANCE_MODELS) /* values from c and from t: a grid, every limit, every cutoff and its neighbours */
    CONFORMANCE_LOBES, /* models by number, prepared lobes on both sides of their cutoff */
    /* clang-format on */
    CONFORMANCE_VECTORS,
    CONFORMANCE_SRGB,
    CONFORMANCE_FORMATS, /* one each: rectangles of both kinds of normals, under one light and several, and spans */
    CONFORMANCE_NO_FORMAT = CONFORMANCE_FORMATS + GLINT_FORMAT_COUNT, /* one more than there are */
    CONFORMANCE_MESHES,
    CONFORMANCE_MESHES_ALBEDO,
    CONFORMANCE_MESHES_LIT,
    CONFORMANCE_MESHES_OUTLINED,
    CONFORMANCE_MESHES_TEXTURED,
    CONFORMANCE_MESHES_GRAINED,
    CONFORMANCE_TABLES_LIT, /* not filled */
    CONFORMANCE_COLOURS,    /* tables as filled, and every source that they draw */
    CONFORMANCE_DITHERED,
    CONFORMANCE_MESHES_COLOUR,
    CONFORMANCE_MESHES_ALBEDO_TABLES,
    CONFORMANCE_MESHES_TEXTURED_TABLES,
    CONFORMANCE_MESHES_OUTLINED_TABLES,
    CONFORMANCE_ALBEDO,
    CONFORMANCE_EVERY_C_1, /* MSH and Schlick at every c: n = 1, 2, 3, 5, 10, 60, 100, 317, 1000 */
    CONFORMANCE_CHECKS = CONFORMANCE_EVERY_C_1 + 9,
    /* Of how many the image holds names and hashes: the first ones. */
    CONFORMANCE_HELD = CONFORMANCE_MODELS_ONLY ? CONFORMANCE_LOBES + 1 : CONFORMANCE_CHECKS
};
#undef CONFORMANCE_IF_own

struct conformance_size {
    uint16_t n_stride; /* of the list of shininess values */
    uint16_t c_step;   /* Q16.16 */
    uint16_t t_count;  /* random arguments a model and shininess */
    uint8_t q_step;
    uint8_t scenes; /* random rectangles and spans a format, space, dither and model */
    uint16_t random_vectors;
};
extern const struct conformance_size conformance_large; /* for a desktop: some millions of values */
extern const struct conformance_size conformance_small; /* for a microcontroller: some thousands */

const char *conformance_name(unsigned check); /* of those held; in flash, where that is apart */
bool conformance_fits(unsigned check);        /* false: left out here, see above */
uint64_t conformance_hash(unsigned check, const struct conformance_size *size);

/* The small size. Prints a line a check by machine_put; `expected`: the host's hashes. */
struct conformance_sum {
    unsigned passed, failed, skipped;
};
struct conformance_sum conformance_run(const uint64_t expected[CONFORMANCE_HELD]);

/* For further lines of the report. */
void conformance_say(const char *text);
void conformance_say_number(uint32_t number);

#endif
