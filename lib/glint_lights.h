/* SPDX-License-Identifier: MIT
 * Internal. Several lights: the run of pixels at hand, and what lamps add to it. */
#ifndef GLINT_LIGHTS_H
#define GLINT_LIGHTS_H

#include "glint_lamp.h"
#include "glint_pixel_prepared.h"
#include "glint_rect.h"

/* Samples in all: fewer than might be, for the stack. */
enum { GLINT_LIGHTS_SLOTS = 8 };

/* So that what two functions hold is not on the stack together. */
#define GLINT_LIGHTS_ALONE __attribute__((noinline))

struct glint_lights {
    struct glint_prepared *prepared; /* its light: of a lamp that has a place, at the pixel at hand */
    const struct glint_lamp *lamps;
    uint8_t count, channels; /* channels = 1: all lamps are white */
    uint8_t length;          /* pixels in a run, and from a channel's sums to the next's */
    bool boxed;              /* is the highlight's box asked for? */
    uint32_t most;           /* the format takes sums of nl to this, and of F to 33/32 of it */
    struct glint_reach reach[GLINT_LAMPS_MAX];
    struct glint_sight sight;
    struct glint_run run; /* the one at hand */
    const struct glint_vec *normals;
    struct glint_bounds bounds;
    uint8_t pixels;                        /* in the run; here it fills a gap */
    uint32_t shines;                       /* which pixels of the run do */
    uint16_t arriving[GLINT_LIGHTS_SLOTS]; /* of the lamp at hand: att - 1 */
    /* Sums, channel by channel, then the lamp's samples; of one lamp red's sums are both. A sum's t is UINT32_MAX where F is 0
     * under every lamp, else 0. */
    struct glint_sample slots[GLINT_LIGHTS_SLOTS];
};

static inline uint32_t glint_lights_color(const struct glint_lamp *lamp, unsigned k)
{
    return lamp->color_q16[k] < GLINT_LAMP_COLOR_MAX ? lamp->color_q16[k] : GLINT_LAMP_COLOR_MAX;
}

/* The brightest channel. */
static inline uint32_t glint_lights_peak(const struct glint_lamp *lamp)
{
    uint32_t peak = 0;
    for (unsigned k = 0; k < 3; k++)
        peak = glint_lights_color(lamp, k) > peak ? glint_lights_color(lamp, k) : peak;
    return peak;
}

/* For single pixels: prepares *prepared and *lights, which keeps pointers to it and to the lamps. Errors as glint_shade_lights. */
enum glint_err glint_lights_init(struct glint_lights *lights, struct glint_prepared *prepared,
                                 const struct glint_shader *shader, const struct glint_lamp *lamps, unsigned count);
/* Draws pixel run.x of lights->run, which is set. */
void glint_lights_pixel(struct glint_lights *lights, const struct glint_vec *normal);

/* Steps 1 and 2 under lamp number `at` for pixels from the run's pixel `from` on. */
void glint_lights_sample(struct glint_lights *lights, unsigned at, unsigned from, unsigned count,
                         struct glint_sample *sample);
/* Adds what the lamp sends to the sums; the first lamp's are the sums. */
void glint_lights_add(struct glint_lights *lights, unsigned at, unsigned count, const struct glint_sample *sample);

#endif
