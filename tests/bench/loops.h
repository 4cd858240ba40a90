/* SPDX-License-Identifier: MIT
 * Loops over pixels, as they are measured: line by line over the scene, so that no map need fit in memory. */
#ifndef GLINT_BENCH_LOOPS_H
#define GLINT_BENCH_LOOPS_H

#include "glint.h"
#include "sphere.h"

/* The line at hand: the harness fills the maps, reads the output. (loops.mjs knows where normals and out lie.) */
struct bench_line {
    struct glint_vec normals[SPHERE_W]; /* 0 beside the sphere */
    uint16_t out[3 * SPHERE_W / 2];     /* pixels in the loop's format */
    uint8_t mask[SPHERE_W];             /* 255 on the sphere, else 0 */
    uint16_t y;
    uint16_t from, to; /* the sphere covers from .. to - 1 */
};
extern struct bench_line bench_line;

/* The line's normals as the loop's map has them, from `glint bake`. Not on AVR, which has no room. */
enum bench_map { MAP_INT16 /* bench_line.normals */, MAP_INT8, MAP_PALETTE, MAP_COUNT };
#ifndef __AVR__
extern uint32_t bench_map[SPHERE_W];
extern struct glint_vec bench_palette[SPHERE_PALETTE];
extern uint16_t bench_albedo_565[SPHERE_W];
#endif

/* Its material, output and lights: set before fill; and its paint, exact and lit until a loop makes another of it. */
extern struct glint_material bench_material;
extern struct glint_output bench_output;
extern struct glint_light bench_lights[GLINT_LIGHTS_MAX];
extern struct glint_paint bench_paint;

/* A scratch for what the loop at hand needs: its tables, then its packed line, spans, albedo or gloss. One loop
 * is measured after another. On AVR all of it must leave 1 KB of 8 for the stack: only the smallest tables have room. */
#ifdef __AVR__
enum { BENCH_TABLES = 0, BENCH_MEMORY = 3 * SPHERE_W };
#else
enum { BENCH_MEMORY = 96 * 1024, BENCH_TABLES = GLINT_TABLES_DITHER_BYTES /* the largest */ };
#endif
extern uint32_t bench_memory[BENCH_MEMORY / 4];
#define BENCH_AFTER_TABLES ((void *)(bench_memory + BENCH_TABLES / 4))

/* The line's maps beside its normals, in RGB888: a loop reads one of them. */
#ifdef __AVR__
#define bench_albedo ((uint8_t(*)[3])BENCH_AFTER_TABLES)
#define bench_gloss ((uint8_t *)BENCH_AFTER_TABLES)
#define bench_grain bench_gloss
#else
extern uint8_t bench_albedo[SPHERE_W][3], bench_gloss[SPHERE_W], bench_grain[SPHERE_W];
#endif

/* The first error of the loop at hand, else 0: then the harness takes no figure for one. */
extern int16_t bench_error;

/* What is done once, how often it counts, and where it shows. NULL where there is nothing to do. */
struct bench_loop {
    const char *name, *what;
    void (*fill)(void);      /* once a material: the tables.                  Shown by itself, cycles */
    void (*frame)(void);     /* once a frame or a light: what does not depend on the pixels.   "          */
    void (*pack)(void);      /* a line's normals to a form of the loop's own. Not counted */
    void (*prepare)(void);   /* once a frame and line: what is sent besides, as a span's ends. As frame     */
    void (*shade)(void);     /* the line's pixels.                            Cycles a pixel */
    struct sphere_look look; /* of the exact picture to compare with, too */
    uint8_t map;             /* enum bench_map */
    uint8_t map_bytes;       /* a pixel of what the loop reads: charged where it lies in flash */
    uint8_t step;            /* emulate one line in so many, for slow loops; 0 counts as 1 */
    bool once;               /* for n = 60 alone */
};
extern const struct bench_loop bench_loops[]; /* loops.c; the last one's name is NULL */

/* The one at hand. */
extern const struct bench_loop *bench_loop;
/* Sets it, and what it draws with. */
void bench_begin(const struct bench_loop *loop, uint32_t n);
/* Finds the rest of bench_line, and the albedo, from the normals. */
void bench_line_begin(uint16_t y);

/* Keeps the first error. */
void bench_check(enum glint_err err);

typedef void bench_step(void);
/* exact_loops.c */
bench_step exact_fill, bench_light, bench_rect, bench_span;
/* As `pack`: two pixels at each end of the line are blended, or all. */
bench_step bench_soft_edges, bench_soft_all;
void bench_rect_by(const struct glint_paint *paint, enum bench_map map, struct glint_box *highlight);
bench_step bench_spans_16, bench_spans_64; /* the line's spans, at bench_spans */
#define bench_spans ((struct glint_span *)BENCH_AFTER_TABLES)

/* peer_loops.c: whole pixels as people write them. */
bench_step peer_fill, peer_integer_power, peer_table_power;
bench_step peer_int8_fill, peer_int8_pack, peer_int8_table_power;
bench_step peer_float_powf, peer_float_msh;
bench_step peer_float_fold, peer_float_folded;

#endif
