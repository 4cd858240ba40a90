/* SPDX-License-Identifier: MIT
 * Normals, packed. What is lost is x and y's precision; z is chosen so that the length, and with it t, stays right. */
#include "glint_tables_normals.h"
#include "glint_math_root.h"

static uint32_t nearest_root(uint32_t square)
{
    const uint32_t floor = glint_root(square);
    return floor + (square - floor * floor > floor);
}

static int32_t nearest(int32_t value, unsigned bits, int32_t limit)
{
    const int32_t rounded = (value + ((int32_t)1 << bits >> 1)) >> bits;
    return rounded > limit ? limit : rounded < -limit ? -limit : rounded;
}

/* z > 0 and |z| at least 1, so that no normal reads as no surface. */
uint32_t glint_normals_pack(enum glint_normals format, const struct glint_vec *normal)
{
    const bool is_8 = format == GLINT_NORMALS_INT8;
    if (!(normal->x | normal->y | normal->z) || !(is_8 || format == GLINT_NORMALS_INT10))
        return 0;
    const unsigned bits = is_8 ? 8 : 6, z_bits = is_8 ? 0 : 4;
    const int32_t limit = is_8 ? 127 : 511, z_limit = is_8 ? 32767 : 2047;
    const int32_t x = nearest(normal->x, bits, limit), y = nearest(normal->y, bits, limit);
    const int32_t xq = x * ((int32_t)1 << bits), yq = y * ((int32_t)1 << bits);
    const int64_t rest = ((int64_t)1 << 30) - (int64_t)xq * xq - (int64_t)yq * yq;
    int32_t z = nearest(rest > 0 ? (int32_t)nearest_root((uint32_t)rest) : 0, z_bits, z_limit);
    z = z < 1 ? 1 : z;
    z = normal->z < 0 ? -z : z;
    if (is_8)
        return (uint32_t)z << 16 | ((uint32_t)(256 * y + x) & 0xffff);
    return (uint32_t)x << 22 | ((uint32_t)y & 1023) << 12 | ((uint32_t)z & 4095);
}

struct glint_vec glint_normals_unpack(enum glint_normals format, uint32_t word)
{
    struct glint_vec n = {0, 0, 0};
    if (format == GLINT_NORMALS_INT10 && word << 20) {
        n = glint_unpack_int10(word);
    } else if (format == GLINT_NORMALS_INT8 && word >> 16) {
        n.x = (int16_t)((int8_t)word * 256);
        n.y = (int16_t)((int32_t)(int16_t)word - (int8_t)word); /* the low half is 256 y + x */
        n.z = (int16_t)(word >> 16);
    }
    return n;
}

const void *glint_normals_window(enum glint_normals format, const void *map, ptrdiff_t stride, uint32_t x, uint32_t y)
{
    return (const uint8_t *)map + stride * (ptrdiff_t)y + glint_normals_size(format) * x;
}
