/* SPDX-License-Identifier: MIT
 * Faults that the fuzzer of the accelerometer is to find. */
#include "fault.h"
#include "imu.h"
#include "tilt.h"

enum imu_news __real_imu_poll(struct imu *imu, uint32_t now_us, int16_t sample[3]);
enum imu_news __wrap_imu_poll(struct imu *imu, uint32_t now_us, int16_t sample[3]);
void __real_tilt_look(const struct tilt *tilt, int32_t to_light[3]);
void __wrap_tilt_look(const struct tilt *tilt, int32_t to_light[3]);

/* A sensor that is lost is not told. */
enum imu_news __wrap_imu_poll(struct imu *imu, uint32_t now_us, int16_t sample[3])
{
    const enum imu_news news = __real_imu_poll(imu, now_us, sample);
    return fault_is("imu_poll") && news == IMU_LOST ? IMU_NOTHING : news;
}

/* The light goes behind the panel. */
void __wrap_tilt_look(const struct tilt *tilt, int32_t to_light[3])
{
    __real_tilt_look(tilt, to_light);
    if (fault_is("tilt_look"))
        to_light[2] = tilt->mean_q8[2] / 64;
}
