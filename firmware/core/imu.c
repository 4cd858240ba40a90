/* SPDX-License-Identifier: MIT */
#include "imu.h"

enum { WHO_AM_I = 0x00, CTRL1 = 0x02, CTRL2 = 0x03, CTRL5 = 0x06, CTRL7 = 0x08, STATUS0 = 0x2e, AX_L = 0x35 };
enum { IS_QMI8658 = 0x05, HAS_NEW_SAMPLE = 0x01 };

/* SA0 is low on the boards that we know; the other address is tried in turn. */
enum { ADDRESS = 0x6b, OTHER_ADDRESS = 0x6a };

/* The bytes of each step. The last two go on and on: a sample is read as soon as there is a new one, since of a read that meets the next
 * one the bytes may be of both (the data sheet promises otherwise of SyncSample alone): of a board that lies flat, near 0, one part in 32 of g. */
static const struct step {
    uint8_t bytes[2], count, wanted;
} steps[] = {
    {{WHO_AM_I}, 1, 1},    {{CTRL7, 0x00}, 2, 0}, /* off while it is set up */
    {{CTRL1, 0x60}, 2, 0},                        /* addresses count up */
    {{CTRL2, 0x15}, 2, 0},                        /* +-4 g, 250 Hz */
    {{CTRL5, 0x00}, 2, 0},                        /* its own filters off: ours has a known delay */
    {{CTRL7, 0x01}, 2, 0},                        /* the accelerometer on */
    {{STATUS0}, 1, 1},     {{AX_L}, 1, 6},
};
enum {
    STEP_WHO,
    STEP_READ = sizeof steps / sizeof *steps - 1,
    STEP_STATUS = STEP_READ - 1,
    FAILURES_MAX = 5,
    ODD_MAX = 250,
    UNREADY_MAX = 8,
    LOOKS = IMU_START_US / IMU_RETRY_US
};

static bool is_due(uint32_t now_us, uint32_t at_us)
{
    return (int32_t)(now_us - at_us) >= 0;
}

/* It is news where it was set up, or where nobody has answered for so long that it cannot be on its way up. */
static enum imu_news lose(struct imu *imu, uint32_t now_us)
{
    const bool is_other_left = imu->step == STEP_WHO && imu->address == ADDRESS;
    imu->looks = (uint8_t)(imu->looks + (!is_other_left && imu->looks < LOOKS));
    const bool is_news = !imu->is_lost && (imu->step >= STEP_STATUS || imu->looks == LOOKS);
    imu->address = is_other_left ? OTHER_ADDRESS : imu->step == STEP_WHO ? ADDRESS : imu->address;
    imu->since_us = now_us + (is_other_left ? IMU_PERIOD_US : IMU_RETRY_US);
    imu->is_lost |= is_news;
    imu->has_samples = false;
    imu->step = STEP_WHO;
    imu->failures = 0;
    imu->unready = 0;
    imu->odd = 0;
    return is_news ? IMU_LOST : IMU_NOTHING;
}

/* A hand may throw it, and it may fall, but not for a second; and no two samples of a real one are alike for so long. */
static bool is_odd(const struct imu *imu, const int16_t sample[3])
{
    uint32_t square = 0;
    bool is_same = true;
    for (unsigned i = 0; i < 3; i++) {
        square += (uint32_t)((int32_t)sample[i] * sample[i]) / 4; /* < 3 * 2^28 */
        is_same &= sample[i] == imu->before[i];
    }
    const uint32_t one = (uint32_t)IMU_ONE_G * IMU_ONE_G / 4;
    return is_same || square < one / 4 || square > 4 * one;
}

static enum imu_news take_sample(struct imu *imu, const uint8_t *bytes, uint32_t now_us, int16_t sample[3])
{
    for (unsigned i = 0; i < 3; i++)
        sample[i] = (int16_t)(uint16_t)(bytes[2 * i] | bytes[2 * i + 1] << 8);
    const unsigned periods = imu->unready < UNREADY_MAX ? 1 : 2; /* it was waited for that long */
    imu->unready = 0;
    imu->odd = is_odd(imu, sample) ? (uint16_t)(imu->odd + periods) : 0;
    for (unsigned i = 0; i < 3; i++)
        imu->before[i] = sample[i];
    if (imu->odd >= ODD_MAX)
        return lose(imu, now_us);
    if (!imu->has_samples && imu->odd) /* it has to make sense first: a part that has just been turned on tells zeros */
        return IMU_NOTHING;
    imu->has_samples = true;
    imu->is_lost = false;
    imu->looks = 0;
    return IMU_SAMPLE;
}

static enum imu_news fail(struct imu *imu, uint32_t now_us)
{
    imu->since_us = now_us + IMU_PERIOD_US;
    return imu->step < STEP_STATUS || ++imu->failures == FAILURES_MAX ? lose(imu, now_us) : IMU_NOTHING;
}

static enum imu_news finish(struct imu *imu, const uint8_t *bytes, uint32_t now_us, int16_t sample[3])
{
    if (imu->step == STEP_WHO && bytes[0] != IS_QMI8658)
        return fail(imu, now_us);
    if (imu->step == STEP_READ) {
        imu->failures = 0;
        imu->step = STEP_STATUS;
        imu->since_us += IMU_PERIOD_US - IMU_ASK_US; /* of the transfer's beginning */
        return take_sample(imu, bytes, now_us, sample);
    }
    /* One that never says so is read all the same: it may be lost, or another part. */
    if (imu->step == STEP_STATUS && !(bytes[0] & HAS_NEW_SAMPLE) && ++imu->unready < UNREADY_MAX) {
        imu->since_us = now_us + IMU_ASK_US;
        return IMU_NOTHING;
    }
    imu->since_us = now_us;
    imu->step++;
    return IMU_NOTHING;
}

enum imu_news imu_poll(struct imu *imu, uint32_t now_us, int16_t sample[3])
{
    const struct imu_bus *bus = imu->bus;
    const struct step *step = &steps[imu->step];
    if (!imu->is_under_way) {
        if (imu->since_us && !is_due(now_us, imu->since_us))
            return IMU_NOTHING;
        imu->address = imu->address ? imu->address : ADDRESS;
        imu->is_under_way = true;
        imu->since_us = now_us;
        bus->begin(bus->context, imu->address, step->bytes, step->count, step->wanted);
        return IMU_NOTHING;
    }
    uint8_t read[IMU_BYTES_MAX];
    const enum imu_transfer state = bus->ask(bus->context, read);
    if (state == IMU_UNDER_WAY && !is_due(now_us, imu->since_us + IMU_TIMEOUT_US))
        return IMU_NOTHING;
    imu->is_under_way = false;
    if (state == IMU_ENDED)
        return finish(imu, read, now_us, sample);
    if (state == IMU_UNDER_WAY)
        bus->stop(bus->context);
    return fail(imu, now_us);
}
