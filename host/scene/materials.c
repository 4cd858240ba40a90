/* SPDX-License-Identifier: MIT
 * Colours are published measurements, made into sRGB here; how strongly a surface mirrors one lamp beside what it scatters is
 * chosen by eye, on the sphere and the knob.
 *
 * A metal has no colour but that of its mirror, the reflectance at normal incidence, ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2). Light
 * that comes to it from all around is drawn as ambient and diffuse; yellow and red metals deepen, because on its way that light met
 * the metal several times. Other materials mirror white. */
#include "scene/materials.h"

#include <math.h>

/* Measured n and k at red, green and blue. "Physically Based" (physicallybased.info) lists them so from refractiveindex.info. */
struct indices {
    double n[3], k[3];
};
static const struct indices of_gold = {{.18299, .42108, 1.3734}, {3.4242, 2.3459, 1.7704}};
static const struct indices of_brass = {{.444, .527, 1.094}, {3.695, 2.765, 1.829}};
static const struct indices of_copper = {{.27105, .67693, 1.3164}, {3.6092, 2.6248, 2.2921}};
static const struct indices of_iron = {{2.9114, 2.9497, 2.5845}, {3.0893, 2.9318, 2.7670}};
static const struct indices of_chromium = {{3.4256, 2.7891, 2.0246}, {4.2730, 4.1976, 3.8586}};

#define INDICES "n, k of refractiveindex.info at red, green and blue, as physicallybased.info lists them: "

struct recipe {
    const char *meaning, *source;
    const struct indices *metal; /* NULL: the two below */
    double color[3];             /* reflectance, linear; as it is encoded where is_encoded */
    bool is_encoded, is_metal;
    double times; /* how often what a metal scatters has met it */
    unsigned n, n_across;
    double ambient, diffuse, mirror; /* mirror: of a metal times its colour, of others white */
};

static const struct recipe gold = {.meaning = "polished gold",
                                   .source = INDICES "gold",
                                   .metal = &of_gold,
                                   .times = 3,
                                   .n = 40,
                                   .ambient = 0.28,
                                   .diffuse = 0.62,
                                   .mirror = 0.8};
static const struct recipe brass = {.meaning = "polished brass",
                                    .source = INDICES "brass",
                                    .metal = &of_brass,
                                    .times = 2.4,
                                    .n = 34,
                                    .ambient = 0.25,
                                    .diffuse = 0.62,
                                    .mirror = 0.72};
static const struct recipe copper = {.meaning = "polished copper",
                                     .source = INDICES "copper",
                                     .metal = &of_copper,
                                     .times = 3,
                                     .n = 28,
                                     .ambient = 0.26,
                                     .diffuse = 0.66,
                                     .mirror = 0.7};
static const struct recipe steel = {.meaning = "polished steel",
                                    .source = INDICES "iron",
                                    .metal = &of_iron,
                                    .times = 1,
                                    .n = 60,
                                    .ambient = 0.24,
                                    .diffuse = 0.48,
                                    .mirror = 1};
static const struct recipe brushed_steel = {.meaning = "steel with a grain",
                                            .source = INDICES "iron",
                                            .metal = &of_iron,
                                            .times = 1,
                                            .n = 150,
                                            .n_across = 10,
                                            .ambient = 0.24,
                                            .diffuse = 0.42,
                                            .mirror = 0.9};
static const struct recipe chrome = {.meaning = "chromium plate, a near mirror",
                                     .source = INDICES "chromium",
                                     .metal = &of_chromium,
                                     .times = 1,
                                     .n = 120,
                                     .ambient = 0.14,
                                     .diffuse = 0.5,
                                     .mirror = 1};
static const struct recipe gunmetal = {.meaning = "blued steel",
                                       .source = "not measured: a grey of .20, as dark as magnetite",
                                       .color = {.196, .201, .212},
                                       .is_metal = true,
                                       .n = 40,
                                       .ambient = 0.25,
                                       .diffuse = 0.5,
                                       .mirror = 0.38};
static const struct recipe plastic = {.meaning = "red plastic",
                                      .source = "red plastic of Kilgard's teapots.c, Silicon Graphics 1994",
                                      .color = {.5, 0, 0},
                                      .is_encoded = true,
                                      .n = 40,
                                      .ambient = 0.25,
                                      .diffuse = 1,
                                      .mirror = 0.6};
static const struct recipe rubber = {.meaning = "black rubber",
                                     .source = "a tire measured for physicallybased.info: .023 linear",
                                     .color = {.023, .023, .023},
                                     .n = 5,
                                     .ambient = 0.4,
                                     .diffuse = 1,
                                     .mirror = 0.16};
static const struct recipe porcelain = {.meaning = "white glazed porcelain",
                                        .source =
                                            "porcelain measured for physicallybased.info: .745, .745, .723 linear",
                                        .color = {.745, .745, .723},
                                        .n = 250,
                                        .ambient = 0.38,
                                        .diffuse = 0.62,
                                        .mirror = 0.8};
static const struct recipe lacquer = {.meaning = "black piano lacquer",
                                      .source = "charcoal black of physicallybased.info: .02 linear",
                                      .color = {.02, .02, .02},
                                      .n = 400,
                                      .ambient = 0.2,
                                      .diffuse = 0.8,
                                      .mirror = 0.95};
static const struct recipe jade = {.meaning = "polished jade",
                                   .source = "jade of Kilgard's teapots.c, Silicon Graphics 1994",
                                   .color = {.54, .89, .63},
                                   .is_encoded = true,
                                   .n = 60,
                                   .ambient = 0.22,
                                   .diffuse = 0.5,
                                   .mirror = 0.4};
static const struct recipe glass = {.meaning = "dark green bottle glass, seen against the dark",
                                    .source = "not measured: a deep bottle green of .004, .05, .018 linear",
                                    .color = {.004, .05, .018},
                                    .n = 300,
                                    .ambient = 0.45,
                                    .diffuse = 0.8,
                                    .mirror = 0.95};
static const struct recipe car_paint = {.meaning = "red car paint under a clear coat",
                                        .source = "RAL 3020, traffic red, as its sRGB is usually listed: 204, 6, 5",
                                        .color = {.8, .0235, .0196},
                                        .is_encoded = true,
                                        .n = 160,
                                        .ambient = 0.2,
                                        .diffuse = 0.8,
                                        .mirror = 0.9};

#define NAME(name, recipe) name,
const char *const preset_names[] = {PRESETS(NAME) NULL};

#define RECIPE(name, recipe) &recipe,
static const struct recipe *const recipes[] = {PRESETS(RECIPE)};

/* IEC 61966-2-1 */
static double srgb_encode(double linear)
{
    return linear <= .0031308 ? linear * 12.92 : 1.055 * pow(linear, 1 / 2.4) - .055;
}

static double reflectance(const struct indices *metal, unsigned k)
{
    const double n = metal->n[k], absorbed = metal->k[k] * metal->k[k];
    return ((n - 1) * (n - 1) + absorbed) / ((n + 1) * (n + 1) + absorbed);
}

struct preset preset_of(unsigned place)
{
    const struct recipe *r = recipes[place];
    struct preset preset = {preset_names[place],    r->meaning, r->source, {.n = r->n, .n_across = r->n_across}, {0},
                            r->metal || r->is_metal};
    for (unsigned k = 0; k < 3; k++) {
        const double mirrored = r->metal ? reflectance(r->metal, k) : 1;
        const double scattered = r->metal ? pow(mirrored, r->times) : r->color[k];
        preset.finish.ambient[k] = r->ambient;
        preset.finish.diffuse[k] = r->diffuse;
        preset.finish.specular[k] = r->mirror * srgb_encode(mirrored);
        preset.color[k] = (uint8_t)lround(255 * (r->is_encoded ? scattered : srgb_encode(scattered)));
    }
    return preset;
}
