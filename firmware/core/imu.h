/* SPDX-License-Identifier: MIT
 *
 * The QMI8658 and QMI8658C, an accelerometer (and gyroscope, which stays off) on I2C: found, set up and read without ever waiting. What
 * goes wrong on its bus is told once, and it is looked for again.
 *
 * Registers: QMI8658C data sheet 13-52-27 rev. A (QST, 2022). As drivers in use do (Waveshare's QMI8658.c, ESPHome's qmi8658): CTRL1 = 0x60, and
 * the low byte comes first. */
#ifndef IMU_H
#define IMU_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    IMU_ONE_G = 8192,      /* a sample's: +-4 g in 16 bits */
    IMU_PERIOD_US = 4000,  /* it samples, and is read, 250 times a second */
    IMU_ASK_US = 500,      /* between looks whether there is a new sample */
    IMU_BYTES_MAX = 6,     /* that are read at once */
    IMU_TIMEOUT_US = 2000, /* a transfer takes .25 ms at 400 kHz */
    IMU_RETRY_US = 250000, /* until it is looked for again */
    IMU_START_US = 2000000 /* it may take to answer after power-up: 15 ms, 150 ms or 1.75 s, by its data sheet's age */
};

enum imu_transfer { IMU_UNDER_WAY, IMU_ENDED, IMU_FAILED };

/* What imu.c needs of a board. */
struct imu_bus {
    /* Begins to write bytes to the device at `address` (7 bits), then to read `wanted` ones, and returns at once. One at a time. */
    void (*begin)(void *context, uint8_t address, const uint8_t *bytes, size_t count, size_t wanted);
    /* How it stands; IMU_ENDED: the bytes that were read are in `read`. */
    enum imu_transfer (*ask)(void *context, uint8_t *read);
    /* Gives a transfer up that does not end, and frees the bus as far as that can be done. */
    void (*stop)(void *context);
    void *context;
};

struct imu {
    /* Config, set by you. */
    const struct imu_bus *bus;

    /* State, ours; zeros at first. */
    uint32_t since_us; /* of the transfer, or when the next one is due */
    uint8_t step, failures, address;
    uint8_t unready; /* looks that found no new sample */
    uint8_t looks;   /* for it that found nothing */
    bool is_under_way, is_lost, has_samples;
    uint16_t odd;      /* samples that no sensor at rest or in a hand gives, in a row */
    int16_t before[3]; /* the last sample */
};

enum imu_news {
    IMU_NOTHING,
    IMU_SAMPLE, /* its x, y and z */
    IMU_LOST    /* it does not answer, or what it says makes no sense; once until there are samples again */
};
/* Call it often. */
enum imu_news imu_poll(struct imu *imu, uint32_t now_us, int16_t sample[3]);

#endif
