/* SPDX-License-Identifier: MIT
 * What hand.c takes of the Pico SDK's timer; fuzz_imu.c stands in for it. */
#ifndef LAB_SDK_TIMER_H
#define LAB_SDK_TIMER_H

#include <stdint.h>

void busy_wait_us(uint64_t us);

#endif
