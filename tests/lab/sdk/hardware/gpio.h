/* SPDX-License-Identifier: MIT
 * What hand.c takes of the Pico SDK's GPIO; fuzz_imu.c stands in for it. */
#ifndef LAB_SDK_GPIO_H
#define LAB_SDK_GPIO_H

#include <stdbool.h>

enum { GPIO_FUNC_I2C = 3, GPIO_IN = 0, GPIO_OUT = 1 };

void gpio_init(unsigned pin);
void gpio_set_function(unsigned pin, unsigned function);
void gpio_pull_up(unsigned pin);
bool gpio_get(unsigned pin);
void gpio_set_dir(unsigned pin, bool out);

#endif
