/* SPDX-License-Identifier: MIT */
#include "cases.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int16_t extreme(uint64_t *seed)
{
    static const int16_t of[] = {-32768, -32767, 32767, 0, 1, -1};
    return of[BELOW(6)];
}

struct glint_vec case_vector(uint64_t *seed)
{
    struct glint_vec v = {(int16_t)(BELOW(65536) - 32768), (int16_t)(BELOW(65536) - 32768),
                          (int16_t)(BELOW(65536) - 32768)};
    if (ONE_IN(3)) {
        v.x = extreme(seed);
        v.y = extreme(seed);
        v.z = extreme(seed);
    }
    return v;
}

static uint32_t coefficient(uint64_t *seed)
{
    static const uint32_t of[] = {0, 1, 65535, 65536, 65537, UINT32_MAX, 32768, 64000};
    return BELOW(2) ? BELOW(65537) : ONE_IN(2) ? BELOW(12000) : of[BELOW(8)];
}

struct glint_shader case_shader(uint64_t *seed)
{
    static const uint16_t shininess[] = {1, 2, 3, 4, 5, 10, 60, 200, 1000};
    struct glint_shader s;
    memset(&s, 0, sizeof s);
    glint_lobe_init(&s.lobe, (enum glint_model)BELOW(GLINT_MODEL_COUNT),
                    ONE_IN(3) ? 1 + BELOW(1000) : shininess[BELOW(9)], BELOW(17));
    if (ONE_IN(8)) { /* filled by hand */
        s.lobe.t_max_q30 = ONE_IN(2) ? BELOW(UINT32_MAX) : BELOW(UINT32_C(1) << BELOW(31));
        s.lobe.n = (uint16_t)BELOW(65536);
        s.lobe.model = (uint8_t)(ONE_IN(4) ? BELOW(256) : s.lobe.model);
    }
    const int32_t l[3] = {(int32_t)BELOW(201) - 100, (int32_t)BELOW(201) - 100, (int32_t)BELOW(120)}, v[3] = {0, 0, 1};
    if (glint_light_init(&s.light, l, v) || ONE_IN(16)) {
        s.light.l = case_vector(seed);
        s.light.v = case_vector(seed);
        s.light.h = case_vector(seed);
    }
    const bool grey = ONE_IN(2), plain = ONE_IN(2);                /* plain: no level is full */
    const uint32_t dim = ONE_IN(6) ? UINT32_C(1) << BELOW(14) : 0; /* dim: V has few bits, or takes more of them */
    for (int k = 0; k < 3; k++) {
        s.material.ambient_q16[k] = dim ? BELOW(dim) : plain ? BELOW(6000) : coefficient(seed);
        s.material.diffuse_q16[k] = dim ? BELOW(dim) : plain ? BELOW(40000) : coefficient(seed);
        s.material.specular_q16[k] = dim ? BELOW(dim) : coefficient(seed);
        s.material.albedo[k] = (uint8_t)(ONE_IN(2) ? 255 : BELOW(256));
        if (grey && k) {
            s.material.ambient_q16[k] = s.material.ambient_q16[0];
            s.material.diffuse_q16[k] = s.material.diffuse_q16[0];
            s.material.specular_q16[k] = s.material.specular_q16[0];
        }
    }
    s.format = (uint8_t)BELOW(5);
    if (s.format == GLINT_RGB888 && ONE_IN(2)) /* half of these: what is found in one of them is found in all */
        s.format = (uint8_t)(GLINT_BGR888 + BELOW(GLINT_FORMAT_COUNT - GLINT_BGR888));
    s.space = (uint8_t)ONE_IN(3);
    s.dither = ONE_IN(2);
    s.clamp_peak = ONE_IN(2);
    return s;
}

struct glint_vec case_unit(const double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    struct glint_vec unit = {0, 0, 32767};
    if (length > 0) {
        unit.x = (int16_t)lrint(v[0] * 32767 / length);
        unit.y = (int16_t)lrint(v[1] * 32767 / length);
        unit.z = (int16_t)lrint(v[2] * 32767 / length);
    }
    return unit;
}

struct glint_vec case_normal(uint64_t *seed, const struct glint_light *light, int spread)
{
    if (ONE_IN(16))
        return case_vector(seed);
    if (ONE_IN(3)) {
        const double any[3] = {(double)BELOW(2001) - 1000, (double)BELOW(2001) - 1000, (double)BELOW(1000)};
        return case_unit(any);
    }
    const int32_t x = light->h.x + (int32_t)BELOW((uint32_t)spread) - spread / 2;
    const int32_t y = light->h.y + (int32_t)BELOW((uint32_t)spread) - spread / 2;
    const struct glint_vec n = {(int16_t)x, (int16_t)y, light->h.z};
    return n;
}

static uint64_t pixels_of(unsigned share)
{
    const char *set = getenv("GLINT_PIXELS");
    return UINT64_C(1000) * share * (set ? strtoul(set, NULL, 10) : 1000);
}

bool cases_pass(unsigned (*one)(uint64_t *seed, void *memory), size_t bytes, unsigned share)
{
    enum { BATCH = 64 };
    const uint64_t pixels = pixels_of(share);
    uint64_t done = 0, wrong = UINT64_MAX;
    for (uint64_t from = 0; done < pixels && wrong == UINT64_MAX; from += 4096) {
        uint64_t count = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : count) reduction(min : wrong)
        for (uint64_t batch = from; batch < from + 4096; batch += BATCH) {
            void *memory = malloc(bytes);
            for (uint64_t i = batch; i < batch + BATCH; i++) {
                uint64_t seed = i * UINT64_C(0x9e3779b97f4a7c15) + 1;
                const unsigned shaded = memory ? one(&seed, memory) : 0;
                count += shaded;
                if (!shaded && i < wrong)
                    wrong = i;
            }
            free(memory);
        }
        done += count;
    }
    if (wrong != UINT64_MAX)
        printf("# case %llu differs\n", (unsigned long long)wrong);
    printf("# %.0f million pixels\n", (double)done / 1e6);
    return wrong == UINT64_MAX;
}
