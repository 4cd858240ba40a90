/* SPDX-License-Identifier: MIT
 * The scene that is measured: a sphere on 60 % of 320x240 pixels, lit from (1, 1, 1), seen from far in front; and others, from which a user
 * adds up his own. */
#ifndef GLINT_BENCH_SPHERE_H
#define GLINT_BENCH_SPHERE_H

#include "glint.h"

enum {
    SPHERE_W = 320,
    SPHERE_H = 240,
    SPHERE_Q = 8,
    SPHERE_N_COUNT = 5,
    SPHERE_STEP = 16, /* simulated machines that are slow or small take one line in so many */
    SPHERE_LINES = SPHERE_H / SPHERE_STEP,
    SPHERE_PALETTE = 4096 /* entries at most, the one for no surface included */
};
extern const uint16_t sphere_n[SPHERE_N_COUNT];

/* Beside the sphere, all over the picture, as lines of the same light: waves, a dome, the sphere in checks of 4 pixels; and for n = 60 lit pixels
 * of the highlight of every model but Phong, and beyond each. */
enum bench_scene { SCENE_SPHERE, SCENE_WAVES, SCENE_DOME, SCENE_CHECKS, SCENE_INSIDE, SCENE_OUTSIDE, SCENE_COUNT };
enum { SCENE_PICTURES = SCENE_INSIDE, SCENE_N_COUNT = 3, SCENE_SIDE_LINES = 3 /* what is enough of the last two */ };
extern const uint16_t scene_n[SCENE_N_COUNT]; /* the pictures' */
extern const char *const scene_names[SCENE_COUNT];

/* One directional white light; other kinds; four points, also of colours 2, 4 and 16, over a material so much darker. */
enum sphere_lights {
    LIGHTS_WHITE,
    LIGHTS_DIRECTIONAL_COLOURED,
    LIGHTS_POINT,
    LIGHTS_COLOURED,
    LIGHTS_SPOT,
    LIGHTS_NARROW,
    LIGHTS_FOUR,
    LIGHTS_FOUR_2,
    LIGHTS_FOUR_4,
    LIGHTS_FOUR_16
};

/* Grain with n_across = 8, or a map of shininess. */
enum sphere_grain { GRAIN_NONE, GRAIN_BRUSHED, GRAIN_SPUN, GRAIN_MAP, GRAIN_SHININESS };

/* How it looks, but for n: what a loop draws, and the exact picture to which that is compared. */
struct sphere_look {
    uint8_t model;  /* enum glint_model */
    uint8_t format; /* enum glint_format */
    uint8_t space;  /* enum glint_space */
    bool dither, albedo, gloss;
    uint8_t lights; /* enum sphere_lights */
    uint8_t grain;  /* enum sphere_grain */
};

/* Its material and output. Under an albedo map the light is white: the diffuse part is grey. */
void sphere_material(struct glint_material *material, struct glint_output *output, const struct sphere_look *look,
                     uint32_t n);
/* Fills the lights; how many there are, negative: enum glint_err. The viewer: */
int sphere_lights(struct glint_light lights[GLINT_LIGHTS_MAX], enum sphere_lights which);
extern const int32_t sphere_viewer[3];

/* Maps over it: a smooth pattern in RGB565, and that in RGB888; and of gloss. */
uint16_t sphere_albedo(uint16_t x, uint16_t y);
void sphere_expand(uint8_t rgb[3], uint16_t rgb565);
uint8_t sphere_gloss(uint16_t x, uint16_t y);
/* A line's, or all, of grain and of shininess (`bytes`). */
void sphere_grain(struct glint_maps *maps, const struct sphere_look *look, const uint8_t *bytes, ptrdiff_t stride);
uint8_t sphere_grain_byte(const struct sphere_look *look, uint16_t x, uint16_t y);

#endif
