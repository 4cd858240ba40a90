/* SPDX-License-Identifier: MIT
 *
 * Light that stays where the room's is while the panel is tilted: straight above, as gravity tells. Integers only.
 *
 * Gravity is the mean of samples, each an eighth of the way there: a turn arrives 7 samples (28 ms) later, nine tenths of a step after 17 (69 ms). A still hand
 * gives a still picture: the light rests until the mean is MOVES away from where it was (.7 degrees), and then follows it until
 * that has been within RESTS of one place for REST_SAMPLES. A sensor of 200 ug/sqrt(Hz) at 250 Hz has 2.2 mg of noise, the mean .6 mg:
 * MOVES is 20 times that, RESTS 6 times. */
#ifndef TILT_H
#define TILT_H

#include <stdbool.h>
#include <stdint.h>

enum {
    TILT_ONE_G = 8192,
    TILT_MOVES = 98,         /* 12 mg */
    TILT_RESTS = 30,         /* 3.7 mg */
    TILT_REST_SAMPLES = 32,  /* 128 ms at 250 Hz */
    TILT_STEP = 2048,        /* a sample counts for no more than this away from the mean: a knock is no turn */
    TILT_KNOCK = 4915,       /* .6 g away from it is a tap or a shake */
    TILT_KNOCK_SAMPLES = 175 /* .7 s until the next one counts */
};

/* State, ours; zeros at first. */
struct tilt {
    int32_t mean_q8[3]; /* of TILT_ONE_G */
    int32_t held_q8[3]; /* the light's; or while it moves, where it may come to rest */
    int32_t shown_q8[3];
    uint8_t quiet; /* samples near there */
    uint8_t waits; /* until a knock counts */
    bool has_samples, moves;
};

/* A sample towards the picture's right, up and the viewer: what a sensor at rest gives, 1 g upwards. True: a tap or a shake. */
bool tilt_add(struct tilt *tilt, const int16_t sample[3]);
/* Towards the light, about 2^15 long; at least a quarter of that towards the viewer, so that the panel is lit at any tilt. After the first
 * sample. True: it has moved since this was called before. */
bool tilt_light(struct tilt *tilt, int32_t to_light[3]);
/* The same, for one who only asks. */
void tilt_look(const struct tilt *tilt, int32_t to_light[3]);

/* The axes of a board as those of a picture: `axes` names for right, up and viewer the sensor's axis, 1..3, negative: against it; the
 * picture is turned clockwise by quarter turns. */
void tilt_turn(int16_t turned[3], const int16_t sample[3], const int8_t axes[3], unsigned quarter_turns);

#endif
