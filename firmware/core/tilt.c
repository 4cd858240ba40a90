/* SPDX-License-Identifier: MIT */
#include "tilt.h"

static int32_t magnitude(int32_t value)
{
    return value < 0 ? -value : value;
}

/* The largest of the three differences. */
static int32_t distance(const int32_t a[3], const int32_t b[3])
{
    int32_t largest = 0;
    for (unsigned i = 0; i < 3; i++)
        if (magnitude(a[i] - b[i]) > largest)
            largest = magnitude(a[i] - b[i]);
    return largest;
}

static void copy(int32_t to[3], const int32_t from[3])
{
    for (unsigned i = 0; i < 3; i++)
        to[i] = from[i];
}

/* How far the sample is from the mean before it. */
static int32_t add_to_mean(struct tilt *tilt, const int16_t sample[3])
{
    int32_t farthest = 0;
    for (unsigned i = 0; i < 3; i++) {
        const int32_t away_q8 = sample[i] * 256 - tilt->mean_q8[i]; /* |.| < 2^24 */
        const int32_t most = TILT_STEP * 256;
        const int32_t counts = away_q8 > most ? most : away_q8 < -most ? -most : away_q8;
        farthest = magnitude(away_q8) > farthest ? magnitude(away_q8) : farthest;
        tilt->mean_q8[i] += counts / 8;
    }
    return farthest;
}

bool tilt_add(struct tilt *tilt, const int16_t sample[3])
{
    if (!tilt->has_samples) {
        for (unsigned i = 0; i < 3; i++)
            tilt->mean_q8[i] = sample[i] * 256;
        copy(tilt->held_q8, tilt->mean_q8);
        tilt->has_samples = tilt->moves = true;
        tilt->waits = TILT_KNOCK_SAMPLES;
    }
    const bool is_far = add_to_mean(tilt, sample) > TILT_KNOCK * 256;
    const bool is_knock = is_far && tilt->waits == 0;
    tilt->waits = is_knock ? TILT_KNOCK_SAMPLES : (uint8_t)(tilt->waits - (tilt->waits > 0));
    const int32_t away = distance(tilt->mean_q8, tilt->held_q8);
    if (!tilt->moves && away > TILT_MOVES * 256)
        tilt->moves = true;
    else if (!tilt->moves || (away <= TILT_RESTS * 256 && ++tilt->quiet < TILT_REST_SAMPLES))
        return is_knock;
    tilt->moves = tilt->quiet < TILT_REST_SAMPLES;
    tilt->quiet = 0;
    copy(tilt->held_q8, tilt->mean_q8); /* it rests here, or may */
    return is_knock;
}

static const int32_t *where(const struct tilt *tilt)
{
    return tilt->moves ? tilt->mean_q8 : tilt->held_q8;
}

void tilt_look(const struct tilt *tilt, int32_t to_light[3])
{
    const int32_t *at = where(tilt);
    for (unsigned i = 0; i < 3; i++)
        to_light[i] = at[i] / 64;
    if (to_light[2] < TILT_ONE_G)
        to_light[2] = TILT_ONE_G; /* a quarter of 2^15 */
}

bool tilt_light(struct tilt *tilt, int32_t to_light[3])
{
    const bool has_moved = distance(where(tilt), tilt->shown_q8) != 0;
    copy(tilt->shown_q8, where(tilt));
    tilt_look(tilt, to_light);
    return has_moved;
}

void tilt_turn(int16_t turned[3], const int16_t sample[3], const int8_t axes[3], unsigned quarter_turns)
{
    for (unsigned i = 0; i < 3; i++) {
        const unsigned axis = (unsigned)(axes[i] < 0 ? -axes[i] : axes[i]) - 1;
        const int32_t value = axes[i] < 0 ? -sample[axis] : sample[axis];
        turned[i] = (int16_t)(value > 32767 ? 32767 : value);
    }
    for (; quarter_turns; quarter_turns--) { /* what pointed up points to the left now */
        const int16_t right = turned[0];
        turned[0] = (int16_t)(turned[1] == -32768 ? 32767 : -turned[1]);
        turned[1] = right;
    }
}
