/* SPDX-License-Identifier: MIT
 * What LVGL 9.5.0 keeps from those who include lvgl.h alone, as far as the examples read it. */
#ifndef STUB_LVGL_PRIVATE_H
#define STUB_LVGL_PRIVATE_H

#include "lvgl.h"

struct _lv_hit_test_info_t {
    const lv_point_t *point;
    bool res;
};

#endif
