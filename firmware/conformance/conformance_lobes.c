/* SPDX-License-Identifier: MIT
 * The functions of the cosine, and sRGB's. */
#include "conformance_lobes.h"

#include "conformance_random.h"
#include "glint.h"

static const uint16_t shininess[] = {60, 0, 1, 2, 1000, 3, 4, 5, 17, 7, 10, 35, 200, 100, 255, 513, 704, 999, 5000};
enum { SHININESS_COUNT = sizeof shininess / sizeof *shininess };
/* The functions' own limits, and the arguments' types'. */
static const int32_t c_limits[] = {INT32_MIN,        -1,       0, 1, GLINT_C_ONE - 1, GLINT_C_ONE, GLINT_C_ONE + 1,
                                   INT32_C(1) << 30, INT32_MAX};
static const uint32_t t_limits[] = {0, 1, GLINT_T_ONE - 1, GLINT_T_ONE, GLINT_T_ONE + 1, UINT32_C(1) << 31, UINT32_MAX};
enum { C_LIMITS = sizeof c_limits / sizeof *c_limits, T_LIMITS = sizeof t_limits / sizeof *t_limits };

/* Each model by its own functions. No table of pointers: the stack's bound follows calls by name. */
#define ADD_MODEL(model)                                                                                               \
    for (int32_t c = -1000; c <= GLINT_C_ONE + 1000; c += size->c_step)                                                \
        conform_add(glint_##model(n, c));                                                                              \
    for (uint16_t k = 0; k < size->t_count; k++) /* ever nearer to the peak, where lobes are */                        \
        conform_add(glint_##model##_t(n, conform_random_bits() >> (1 + k % 16)));                                      \
    for (uint8_t k = 0; k < C_LIMITS; k++)                                                                             \
        conform_add(glint_##model(n, c_limits[k]));                                                                    \
    for (uint8_t k = 0; k < T_LIMITS; k++)                                                                             \
        conform_add(glint_##model##_t(n, t_limits[k]));                                                                \
    for (unsigned q = 0; q <= GLINT_Q_MAX + 1; q += size->q_step) {                                                    \
        const uint32_t c = glint_##model##_cutoff(n, q), t = glint_##model##_cutoff_t(n, q);                           \
        conform_add(c);                                                                                                \
        conform_add(t);                                                                                                \
        for (int32_t k = -1; k <= 1; k++) {                                                                            \
            conform_add(glint_##model(n, (int32_t)c + k));                                                             \
            conform_add(glint_##model##_t(n, t + (uint32_t)k));                                                        \
        }                                                                                                              \
    }                                                                                                                  \
    break

void conform_model(unsigned check, const struct conformance_size *size)
{
    for (uint16_t i = 0; i < SHININESS_COUNT; i += size->n_stride) {
        const uint32_t n = shininess[i];
        switch (check) {
#define CONFORMANCE_IF_own(name)                                                                                       \
    case CONFORMANCE_##name:                                                                                           \
        ADD_MODEL(name);
            GLINT_MODELS(CONFORMANCE_MODELS)
#undef CONFORMANCE_IF_own
        }
    }
}

static void add_lobe(unsigned model, uint16_t n, const struct conformance_size *size)
{
    struct glint_lobe lobe;
    glint_lobe_init(&lobe, (enum glint_model)model, n, n % 17u);
    conform_add(lobe.c_min_q16);
    conform_add(lobe.t_max_q30);
    for (int32_t k = -1; k <= 1; k++) {
        conform_add(glint_lobe_eval(&lobe, (int32_t)lobe.c_min_q16 + k));
        conform_add(glint_lobe_eval_t(&lobe, lobe.t_max_q30 + (uint32_t)k));
    }
    for (uint16_t k = 0; k < size->t_count; k++) {
        const uint32_t t = conform_random_bits() >> (1 + k % 16);
        const int32_t c = GLINT_C_ONE - (int32_t)(t >> 14);
        conform_add(glint_eval((enum glint_model)model, n, c));
        conform_add(glint_eval_t((enum glint_model)model, n, t));
        conform_add(glint_lobe_eval(&lobe, c));
        conform_add(glint_lobe_eval_t(&lobe, t));
    }
    conform_add(glint_cutoff((enum glint_model)model, n, n % 18u));
    conform_add(glint_cutoff_t((enum glint_model)model, n, n % 18u));
}

void conform_lobes(const struct conformance_size *size)
{
    for (uint16_t i = 0; i < SHININESS_COUNT; i += size->n_stride)
        for (unsigned model = 0; model <= GLINT_MODEL_COUNT; model++) /* one more than there are */
            add_lobe(model, shininess[i], size);
}

void conform_every_c(unsigned check)
{
    static const uint16_t every[CONFORMANCE_CHECKS - CONFORMANCE_EVERY_C_1] = {1, 2, 3, 5, 10, 60, 100, 317, 1000};
    const uint32_t n = every[check - CONFORMANCE_EVERY_C_1];
    for (int32_t c = 0; c <= GLINT_C_ONE; c++) {
        conform_add(glint_msh(n, c));
        conform_add(glint_schlick(n, c));
    }
}

void conform_srgb(const struct conformance_size *size)
{
    for (uint16_t i = 0; i < 256; i++)
        conform_add(glint_srgb_decode((uint8_t)i));
    for (uint32_t i = 0; i < 65536; i += size->c_step)
        conform_add(glint_srgb_encode((uint16_t)i));
}
