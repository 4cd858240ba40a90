/* SPDX-License-Identifier: MIT
 * Internal. Kinds of light, and what several of them, or one that has a place, add to a run of pixels. */
#ifndef GLINT_LIGHTS_H
#define GLINT_LIGHTS_H

#include "glint_draw.h"

/* A point or spot for many pixels: its divisors, range^2 and s_inner - s_outer, as 2^63 / (divisor 2^-exponent) rounded down,
 * that in 2^31 .. 2^32. */
struct glint_reach {
    uint32_t range_inverse, width_inverse;
    uint32_t blur; /* what place_cone does not know of its quotient, of 2^31; 0: the cone is left to the 64 bits */
    int8_t range_exponent, width_exponent;
};

/* From a pixel. */
struct glint_sight {
    int32_t v_q30[3]; /* to the viewer */
    int32_t e[3];     /* to the light, as sequence.md has it */
};
#define GLINT_REACH_OPEN UINT32_MAX

struct glint_lights;

/* Steps 1 and 2 of lights->normals from `from` up to `end`, by half vectors, under a viewer straight in front, and what arrives; the sight is
 * that of the first one, and goes along. The number of the first one that this leaves open, or end. */
typedef unsigned glint_light_front(struct glint_lights *lights, unsigned at, unsigned from, unsigned end,
                                   struct glint_sample *sample, uint16_t *arriving);

/* A kind of light. One with a place names what draws with it. */
struct glint_light_kind {
    bool is_spot;
    const struct glint_use_lights *several; /* NULL: directional */
    enum glint_err (*check)(const struct glint_light *light);
    /* Of a light that has a place: prepares it, and steps 1a and 1b: att; L and H of *view only where it is not 0. GLINT_REACH_OPEN where 32
     * bits do not tell: then `exact` does. V is there already. */
    void (*begin)(struct glint_reach *reach, const struct glint_light *light);
    uint32_t (*near)(const struct glint_reach *reach, const struct glint_light *light, const struct glint_sight *sight,
                     struct glint_view *view);
    uint32_t (*exact)(const struct glint_light *light, const struct glint_sight *sight, struct glint_view *view);
    glint_light_front *front; /* NULL: none */
};

static inline uint32_t glint_light_color(const struct glint_light *light, unsigned k)
{
    return light->color_q16[k] < GLINT_LIGHT_COLOR_MAX ? light->color_q16[k] : GLINT_LIGHT_COLOR_MAX;
}

/* The brightest channel. */
static inline uint32_t glint_light_peak(const struct glint_light *light)
{
    uint32_t peak = 0;
    for (unsigned k = 0; k < 3; k++)
        peak = glint_light_color(light, k) > peak ? glint_light_color(light, k) : peak;
    return peak;
}

/* H of unit vectors L and V; false where the light is straight behind. */
bool glint_light_half(struct glint_vec *h, const int32_t l_q30[3], const int32_t v_q30[3]);

/* Samples in all: fewer than might be, for the stack. */
enum { GLINT_LIGHTS_SLOTS = GLINT_WIDE ? 16 : 8 };

/* Several lights at work. */
struct glint_lights {
    const struct glint_paint *paint;
    uint8_t channels; /* 1: all lights are white; else 3 */
    bool is_folded;   /* the one light's colour is in the paint */
    uint8_t length;   /* pixels in a run, at most, and from a channel's sums to the next's */
    bool is_boxed;    /* is the highlight's box asked for? */
    bool is_front;    /* is the viewer straight in front, and is GLINT_WIDE set? */
    uint8_t count;    /* pixels in the run */
    uint32_t shines;  /* which of them do */
    struct glint_reach reach[GLINT_LIGHTS_MAX];
    struct glint_sight sight;
    struct glint_vec v;     /* to the viewer, of lights that have a place */
    struct glint_view view; /* of the light at hand */
    struct glint_run *run;  /* the one at hand */
    const struct glint_vec *normals;
    glint_geometry *geometry; /* steps 1 and 2 of normals, which are of those from `normals` on */
    /* Step 3 where F is of t and m, NULL elsewhere, and the lines that this is asked for: grain.c */
    void (*shade)(const struct glint_lights *lights, struct glint_sample *samples, unsigned count, bool exact);
    const struct glint_lines *grained;
    const int32_t (*places)[3];            /* of its pixels, 1/16 pixel on the screen; NULL: on the surface */
    uint16_t arriving[GLINT_LIGHTS_SLOTS]; /* of the light at hand: att - 1 */
    /* Sums, channel by channel, then the light's samples; of one light red's sums are both. A sum's t is UINT32_MAX where F is 0
     * under every light, else 0. */
    struct glint_sample slots[GLINT_LIGHTS_SLOTS];
};

/* From a channel's sums to the next's: 0 where they are the same. */
static inline uint8_t glint_lights_apart(const struct glint_lights *lights)
{
    return lights->channels == 1 ? 0 : lights->length;
}

/* What draws under several lights. */
struct glint_use_lights {
    enum glint_err (*light)(struct glint_paint *paint, const struct glint_light *lights, unsigned count,
                            const int32_t v_q30[3]);
    glint_draw_lines *draw;
    /* Of a mesh: prepares for *lights->run, and draws count pixels of it, up to lights->length, by normals and places, which are set. */
    void (*begin)(struct glint_lights *lights, const struct glint_paint *paint, bool is_boxed);
    void (*run)(struct glint_lights *lights, unsigned count);
};

#endif
