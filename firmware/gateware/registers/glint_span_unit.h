/* SPDX-License-Identifier: MIT
 * Written by firmware/gateware/registers/generate from registers.tsv.
 * The registers of glint_span_wb, and a material and a span written to them. Define GLINT_UNIT_WRITE and GLINT_UNIT_READ before
 * where registers are not reached by a plain volatile access. */
/* clang-format off */
#ifndef GLINT_SPAN_UNIT_H
#define GLINT_SPAN_UNIT_H

#include "glint.h"

/* X(NAME, name, offset in bytes, bits, largest value, 1 where it can be written). */
#define GLINT_UNIT_REGISTERS(X) \
    X(ID, id, 0x00, 32, 4294967295u, 0) \
    X(STATUS, status, 0x04, 2, 3u, 0) \
    X(MODEL, model, 0x08, 1, 1u, 1) \
    X(N, n, 0x0c, 10, 1000u, 1) \
    X(C_MIN, c_min, 0x10, 17, 65536u, 1) \
    X(CLAMP_PEAK, clamp_peak, 0x14, 1, 1u, 1) \
    X(AMBIENT_RED, ambient_red, 0x18, 17, 65536u, 1) \
    X(AMBIENT_GREEN, ambient_green, 0x1c, 17, 65536u, 1) \
    X(AMBIENT_BLUE, ambient_blue, 0x20, 17, 65536u, 1) \
    X(DIFFUSE_RED, diffuse_red, 0x24, 17, 65536u, 1) \
    X(DIFFUSE_GREEN, diffuse_green, 0x28, 17, 65536u, 1) \
    X(DIFFUSE_BLUE, diffuse_blue, 0x2c, 17, 65536u, 1) \
    X(SPECULAR_RED, specular_red, 0x30, 17, 65536u, 1) \
    X(SPECULAR_GREEN, specular_green, 0x34, 17, 65536u, 1) \
    X(SPECULAR_BLUE, specular_blue, 0x38, 17, 65536u, 1) \
    X(T, t, 0x3c, 32, 4294967295u, 1) \
    X(DT, dt, 0x40, 32, 4294967295u, 1) \
    X(DDT, ddt, 0x44, 32, 4294967295u, 1) \
    X(NL, nl, 0x48, 32, 4294967295u, 1) \
    X(DNL, dnl, 0x4c, 32, 4294967295u, 1) \
    X(W, w, 0x50, 13, 4096u, 1)

enum {
    GLINT_UNIT_ID = 0x00,
    GLINT_UNIT_STATUS = 0x04,
    GLINT_UNIT_MODEL = 0x08,
    GLINT_UNIT_N = 0x0c,
    GLINT_UNIT_C_MIN = 0x10,
    GLINT_UNIT_CLAMP_PEAK = 0x14,
    GLINT_UNIT_AMBIENT_RED = 0x18,
    GLINT_UNIT_AMBIENT_GREEN = 0x1c,
    GLINT_UNIT_AMBIENT_BLUE = 0x20,
    GLINT_UNIT_DIFFUSE_RED = 0x24,
    GLINT_UNIT_DIFFUSE_GREEN = 0x28,
    GLINT_UNIT_DIFFUSE_BLUE = 0x2c,
    GLINT_UNIT_SPECULAR_RED = 0x30,
    GLINT_UNIT_SPECULAR_GREEN = 0x34,
    GLINT_UNIT_SPECULAR_BLUE = 0x38,
    GLINT_UNIT_T = 0x3c,
    GLINT_UNIT_DT = 0x40,
    GLINT_UNIT_DDT = 0x44,
    GLINT_UNIT_NL = 0x48,
    GLINT_UNIT_DNL = 0x4c,
    GLINT_UNIT_W = 0x50
};
#define GLINT_UNIT_ID_VALUE 0x676c696eu
#define GLINT_UNIT_IDLE 1u  /* of STATUS */
#define GLINT_UNIT_WAITS 2u /* of STATUS */

#ifndef GLINT_UNIT_WRITE
#define GLINT_UNIT_WRITE(unit, offset, value) (*(volatile uint32_t *)((unit) + (offset)) = (value))
#define GLINT_UNIT_READ(unit, offset) (*(volatile uint32_t *)((unit) + (offset)))
#endif

/* Waits until the unit is idle, since its registers belong to all pixels inside; pixels must be taken meanwhile.
 * What it does not draw is refused, and nothing is written: GLINT_ERR_ARG: another model than MSH and Schlick, n = 0, an n_across that
 * is neither 0 nor n, an albedo that is not 255; GLINT_ERR_FORMAT: another format than RGB565, linear space, dither. */
static inline enum glint_err glint_unit_set_material(uintptr_t unit, const struct glint_material *material,
                                                     const struct glint_output *output)
{
    const uint8_t *const albedo = material->albedo;
    const uint32_t n = material->n < GLINT_N_MAX ? material->n : GLINT_N_MAX, q = material->q ? material->q : 6;
    if ((material->model != GLINT_MSH && material->model != GLINT_SCHLICK) || n == 0 ||
        (material->n_across && material->n_across != material->n) || (albedo[0] & albedo[1] & albedo[2]) != 255)
        return GLINT_ERR_ARG;
    if (output->format != GLINT_RGB565 || output->space != GLINT_GAMMA || output->dither)
        return GLINT_ERR_FORMAT;
    const uint32_t c_min = material->model == GLINT_MSH ? glint_msh_cutoff(n, q) : glint_schlick_cutoff(n, q);
    while (!(GLINT_UNIT_READ(unit, GLINT_UNIT_STATUS) & GLINT_UNIT_IDLE)) {
    }
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_MODEL, (uint32_t)(material->model == GLINT_SCHLICK));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_N, (uint32_t)(n));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_C_MIN, (uint32_t)(c_min));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_CLAMP_PEAK, (uint32_t)(material->clamp_peak));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_AMBIENT_RED, (uint32_t)(material->ambient_q16[0]));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_AMBIENT_GREEN, (uint32_t)(material->ambient_q16[1]));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_AMBIENT_BLUE, (uint32_t)(material->ambient_q16[2]));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_DIFFUSE_RED, (uint32_t)(material->diffuse_q16[0]));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_DIFFUSE_GREEN, (uint32_t)(material->diffuse_q16[1]));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_DIFFUSE_BLUE, (uint32_t)(material->diffuse_q16[2]));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_SPECULAR_RED, (uint32_t)(material->specular_q16[0]));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_SPECULAR_GREEN, (uint32_t)(material->specular_q16[1]));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_SPECULAR_BLUE, (uint32_t)(material->specular_q16[2]));
    return GLINT_OK;
}

/* Waits until the span before is taken, and offers this one. GLINT_ERR_VECTOR, and nothing is written: of more than 4096 pixels. */
static inline enum glint_err glint_unit_shade_span(uintptr_t unit, const struct glint_span *span)
{
    if (span->w > 4096)
        return GLINT_ERR_VECTOR;
    while (GLINT_UNIT_READ(unit, GLINT_UNIT_STATUS) & GLINT_UNIT_WAITS) {
    }
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_T, (uint32_t)(span->t_q30));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_DT, (uint32_t)(span->dt_q30));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_DDT, (uint32_t)(span->ddt_q30));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_NL, (uint32_t)(span->nl_q30));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_DNL, (uint32_t)(span->dnl_q30));
    GLINT_UNIT_WRITE(unit, GLINT_UNIT_W, (uint32_t)(span->w));
    return GLINT_OK;
}

#endif
