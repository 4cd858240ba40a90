/* SPDX-License-Identifier: MIT */
#ifndef BADGE_H
#define BADGE_H

#include "glint_lvgl.h"

#ifdef __cplusplus
extern "C" {
#endif
enum glint_err badge_create(void);
#ifdef __cplusplus
}
#endif

#endif
