/* SPDX-License-Identifier: MIT */
#include <zephyr/device.h>
