/* SPDX-License-Identifier: MIT */
#include "glint_math_reciprocal.h"

/* Printed by tests/exact/reciprocals.py. */
/* clang-format off */
const uint8_t glint_reciprocals[64] GLINT_FLASH = {
    254, 250, 246, 243, 239, 236, 232, 229, 226, 223, 220, 217, 214, 211, 209, 206,
    204, 201, 199, 196, 194, 192, 189, 187, 185, 183, 181, 179, 177, 175, 173, 172,
    170, 168, 166, 165, 163, 161, 160, 158, 157, 155, 154, 152, 151, 150, 148, 147,
    146, 144, 143, 142, 141, 139, 138, 137, 136, 135, 134, 133, 132, 131, 130, 128,
};
/* clang-format on */
