/* SPDX-License-Identifier: MIT
 * Loops over pixels, as they are measured: line by line over the scene, so that no map need fit in memory. */
#ifndef GLINT_BENCH_LOOPS_H
#define GLINT_BENCH_LOOPS_H

#include "glint.h"
#include "scene.h"

/* The line at hand: the harness fills the maps, reads the output. (loops.mjs knows where normals, out and albedo lie.) */
struct bench_line {
    struct glint_vec normals[SCENE_W]; /* 0 beside the sphere */
    uint16_t out[3 * SCENE_W / 2];     /* pixels in the loop's format */
    uint8_t mask[SCENE_W];             /* 255 on the sphere, else 0 */
    uint16_t y;
    uint16_t from, to; /* the sphere covers from .. to - 1 */
};
extern struct bench_line bench_line;
#ifndef __AVR__
extern uint8_t bench_albedo[SCENE_W][3];
#endif

/* Its light, material, lobe and format: set before fill. */
extern struct glint_shader bench_shader;

/* A scratch for what the loop at hand needs: its packed line, its tables. One loop is measured after another. */
#ifdef __AVR__
enum { BENCH_MEMORY = 1024 };
#else
enum { BENCH_MEMORY = 128 * 1024 };
#endif
extern uint32_t bench_memory[BENCH_MEMORY / 4];

/* The first error of the loop at hand, else 0: then the harness takes no figure for one. */
extern int16_t bench_error;

/* What is done once, how often it counts, and where it shows. NULL where there is nothing to do. */
struct bench_loop {
    const char *name, *what;
    void (*fill)(void);    /* once a material: the tables.                  Shown by itself, cycles */
    void (*frame)(void);   /* once a frame or a light: what does not depend on the pixels.   "          */
    void (*pack)(void);    /* a line's normals to the loop's own form, as baked on the host. Not counted */
    void (*prepare)(void); /* once a frame and line: what is sent besides, as a span's ends. As frame     */
    void (*shade)(void);   /* the line's pixels.                            Cycles a pixel */
    uint8_t model;         /* enum glint_model: the exact picture to compare with */
    uint8_t format;        /* enum glint_format */
    bool dither, albedo;
    uint8_t map_bytes; /* of the packed map a pixel: what is read where the map lies in flash */
    uint8_t step;      /* emulate one line in so many, for slow loops; 0 counts as 1 */
};
extern const struct bench_loop bench_loops[]; /* loops.c; the last one's name is NULL */

/* Sets bench_shader for a loop. */
void bench_begin(const struct bench_loop *loop, uint32_t n);
/* Finds from .. to and the mask of the normals. */
void bench_line_begin(uint16_t y);

/* peer_loops.c: whole pixels as people write them. */
typedef void bench_step(void);
bench_step peer_fill, peer_integer_power, peer_table_power;
bench_step peer_int8_fill, peer_int8_pack, peer_int8_table_power;
bench_step peer_float_powf, peer_float_msh;

#endif
