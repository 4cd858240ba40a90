/* SPDX-License-Identifier: MIT */
#include "demo.h"
#include "orbit.h"

const struct glint_material demo_gold = {.model = GLINT_MSH,
                                         .n = 80, /* a wider highlight costs the coin its 60 frames a second */
                                         .ambient_q16 = {5200, 5200, 5200},
                                         .diffuse_q16 = {43000, 43000, 43000},
                                         .specular_q16 = {65536, 62000, 50000},
                                         .albedo = {230, 168, 66}};
const struct glint_output demo_output = {.format = GLINT_RGB565, .space = GLINT_GAMMA};

const int32_t demo_mesh_light[3] = {-13000, 16000, 24000};

/* (cos t + i sin t)(cos s + j sin s), t half of the tilt of 20 degrees, s half of the turn. */
void demo_pose(struct glint_pose *pose, uint32_t frame, uint16_t size)
{
    enum { TILT_COS = 32270, TILT_SIN = 5690 };
    const uint32_t half_q16 = (frame % ORBIT_FRAMES << 15) / ORBIT_FRAMES;
    const int32_t cosine = orbit_sine_q15(half_q16 + 0x4000), sine = orbit_sine_q15(half_q16); /* |.| <= 2^15 */
    const struct glint_pose turned = {.turn = {(int16_t)(TILT_COS * cosine / 32768),
                                               (int16_t)(TILT_SIN * cosine / 32768), (int16_t)(TILT_COS * sine / 32768),
                                               (int16_t)(TILT_SIN * sine / 32768)},
                                      .scale = (uint16_t)(8 * size)};
    *pose = turned;
}
