/* SPDX-License-Identifier: MIT
 * How smooth outlines are: pixels within 2 of an outline that is seen, beside the mean of 16 x 16 samples a pixel in double
 * precision, in six turns over a light and a dark ground. The figures of lib/COSTS.md. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "solids.h"

#include "glint_mesh.h"
#include "mesh/fit.h"
#include "mesh/load.h"

enum { SIDE = 240, PIXELS = SIDE * SIDE, FINE = 16, SAMPLES = FINE * FINE, WIDE = SIDE * FINE, LINES = 16 };
enum { LIGHT = 235, DARK = 8 };

static const double turns[6][3] = {{25, -30, 0}, {-20, 100, 0}, {50, 215, 0}, {10, 0, 0}, {35, 60, 20}, {75, 140, -35}};
static const struct glint_material material = {
    GLINT_MSH, 0, 60, 0, {6554, 6554, 6554}, {52429, 52429, 52429}, {28270, 28270, 28270}, {205, 105, 60}, true};

/* ---- meshes ---- */

static size_t vertex(struct mesh *mesh, const double place[3], const double normal[3])
{
    const size_t i = mesh->vertex_count++;
    memcpy(mesh->places[i], place, sizeof mesh->places[i]);
    memcpy(mesh->normals[i], normal, sizeof mesh->normals[i]);
    assert_true(mesh_normalize(mesh->normals[i]));
    mesh->at[i] = (uint32_t)i;
    for (size_t j = 0; j < i; j++)
        if (fabs(mesh->places[j][0] - place[0]) + fabs(mesh->places[j][1] - place[1]) +
                fabs(mesh->places[j][2] - place[2]) <
            1e-6)
            mesh->at[i] = mesh->at[j];
    return i;
}

static void face(struct mesh *mesh, size_t a, size_t b, size_t c)
{
    const uint32_t corners[3] = {(uint32_t)a, (uint32_t)b, (uint32_t)c};
    memcpy(mesh->faces[mesh->face_count++], corners, sizeof corners);
}

static struct mesh *mesh_empty(size_t vertices, size_t faces)
{
    struct mesh *mesh = calloc(1, sizeof *mesh);
    assert_non_null(mesh);
    mesh->name = strdup("made");
    mesh->places = calloc(vertices, sizeof *mesh->places);
    mesh->normals = calloc(vertices, sizeof *mesh->normals);
    mesh->at = calloc(vertices, sizeof *mesh->at);
    mesh->faces = calloc(faces, sizeof *mesh->faces);
    mesh->part_count = 1;
    mesh->ends = calloc(1, sizeof *mesh->ends);
    mesh->materials = calloc(1, sizeof *mesh->materials);
    return mesh;
}

static void knot_place(double t, double p[3])
{
    const double r = .55 + .22 * cos(3 * t);
    p[0] = r * cos(2 * t);
    p[1] = r * sin(2 * t);
    p[2] = .3 * sin(3 * t);
}

static struct mesh *knot(void)
{
    enum { AROUND = 96, TUBE = 10 };
    struct mesh *mesh = mesh_empty(AROUND * TUBE, 2 * AROUND * TUBE);
    for (int i = 0; i < AROUND; i++) {
        const double t = 2 * M_PI * i / AROUND, up[3] = {0, 0, 1};
        double p[3], q[3], d[3], u[3], w[3];
        knot_place(t, p);
        knot_place(t + 1e-4, q);
        for (int k = 0; k < 3; k++)
            d[k] = q[k] - p[k];
        mesh_normalize(d);
        mesh_cross(up, d, u);
        mesh_normalize(u);
        mesh_cross(d, u, w);
        for (int j = 0; j < TUBE; j++) {
            const double a = 2 * M_PI * j / TUBE;
            double place[3], normal[3];
            for (int k = 0; k < 3; k++) {
                normal[k] = cos(a) * u[k] + sin(a) * w[k];
                place[k] = p[k] + .11 * normal[k];
            }
            vertex(mesh, place, normal);
        }
    }
    for (size_t i = 0; i < AROUND; i++)
        for (size_t j = 0; j < TUBE; j++) {
            const size_t a = i * TUBE + j, b = i * TUBE + (j + 1) % TUBE, c = (i + 1) % AROUND * TUBE + j,
                         d = (i + 1) % AROUND * TUBE + (j + 1) % TUBE;
            face(mesh, a, b, c);
            face(mesh, b, d, c);
        }
    mesh->ends[0] = mesh->face_count;
    return mesh;
}

static void box(struct mesh *mesh, const double c[3], const double half[3], double turn)
{
    const double co = cos(turn), si = sin(turn);
    for (int axis = 0; axis < 3; axis++)
        for (int s = -1; s <= 1; s += 2) {
            const int u = (axis + 1) % 3, w = (axis + 2) % 3;
            size_t first = 0;
            for (int q = 0; q < 4; q++) {
                double p[3], n[3] = {0, 0, 0};
                p[axis] = s * half[axis];
                p[u] = (q == 1 || q == 2 ? 1 : -1) * half[u] * s;
                p[w] = (q >= 2 ? 1 : -1) * half[w];
                n[axis] = s;
                const double place[3] = {c[0] + co * p[0] - si * p[1], c[1] + si * p[0] + co * p[1], c[2] + p[2]},
                             normal[3] = {co * n[0] - si * n[1], si * n[0] + co * n[1], n[2]};
                const size_t i = vertex(mesh, place, normal);
                first = q ? first : i;
            }
            face(mesh, first, first + 1, first + 2);
            face(mesh, first, first + 2, first + 3);
        }
}

static struct mesh *boxes(void)
{
    static const struct {
        double middle[3], half[3], turn;
    } all[] = {{{0, 0, 0}, {.6, .12, .2}, .3},
               {{0, .1, 0}, {.1, .65, .12}, .1},
               {{.1, -.3, .1}, {.4, .25, .35}, -.5},
               {{-.5, .4, 0}, {.015, .3, .2}, .6}, /* 3.4 pixels */
               {{.5, .5, .1}, {.25, .004, .2}, .4} /* 0.9 */};
    struct mesh *mesh = mesh_empty(24 * 12, 12 * 12);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        box(mesh, all[i].middle, all[i].half, all[i].turn);
    for (int i = 0; i < 7; i++) {
        const double middle[3] = {-.6 + .1 * i, -.75, 0}, half[3] = {.02, .1, .3};
        box(mesh, middle, half, .05 * i);
    }
    mesh->ends[0] = mesh->face_count;
    return mesh;
}

/* ---- the picture ---- */

struct picture {
    uint8_t pixels[PIXELS][3];
};

static struct glint_pose pose_of(const double turn[3])
{
    /* About y, then x, then z. */
    double q[4] = {1, 0, 0, 0};
    static const int axes[3] = {1, 0, 2};
    for (int i = 0; i < 3; i++) {
        const int axis = axes[i];
        const double half = turn[axis] * M_PI / 360, r[4] = {cos(half), axis == 0 ? sin(half) : 0,
                                                             axis == 1 ? sin(half) : 0, axis == 2 ? sin(half) : 0};
        const double p[4] = {r[0] * q[0] - r[1] * q[1] - r[2] * q[2] - r[3] * q[3],
                             r[0] * q[1] + r[1] * q[0] + r[2] * q[3] - r[3] * q[2],
                             r[0] * q[2] - r[1] * q[3] + r[2] * q[0] + r[3] * q[1],
                             r[0] * q[3] + r[1] * q[2] - r[2] * q[1] + r[3] * q[0]};
        memcpy(q, p, sizeof q);
    }
    struct glint_pose pose = {.scale = 112 * 16};
    for (int k = 0; k < 4; k++)
        pose.turn[k] = (int16_t)lrint(32767 * q[k]);
    return pose;
}

/* What is drawn with, and where the library placed the vertices. */
struct sight {
    const struct glint_mesh *mesh;
    struct glint_mesh_drawn drawn;
    void *work;
    struct glint_paint paint;
    struct glint_light light;
};

static void draw(struct sight *sight, const struct glint_pose *pose, bool outlines, uint8_t ground,
                 struct picture *picture)
{
    static const struct glint_output output = {GLINT_RGB888, GLINT_GAMMA, false};
    static const int32_t to_light[3] = {-1, 1, 1}, to_viewer[3] = {0, 0, 1};
    const size_t bytes = glint_mesh_frame_bytes(SIDE, LINES) + 40 * GLINT_MESH_KEPT_BYTES,
                 work = glint_mesh_bytes(sight->mesh, SIDE);
    void *memory = malloc(bytes);
    struct glint_mesh_frame frame;
    assert_non_null(memory);
    memset(picture, ground, sizeof *picture);
    assert_int_equal(glint_paint_exact(&sight->paint, &material, &output), GLINT_OK);
    assert_int_equal(glint_light_directional(&sight->light, to_light), GLINT_OK);
    assert_int_equal(glint_paint_light(&sight->paint, &sight->light, 1, to_viewer), GLINT_OK);
    assert_int_equal(glint_mesh_begin(&frame, SIDE, SIDE, LINES, 0, memory, bytes), GLINT_OK);
    frame.outlines = outlines ? &glint_outlines : NULL;
    free(sight->work);
    sight->work = malloc(work);
    assert_int_equal(glint_mesh_add(&frame, &sight->drawn, sight->mesh, pose, &sight->paint, sight->work, work),
                     GLINT_OK);
    for (uint16_t y = 0; y < SIDE; y = (uint16_t)(y + LINES)) {
        const struct glint_surface surface = {picture->pixels[y * SIDE], 3 * SIDE, 0, y};
        assert_int_equal(glint_mesh_strip(&frame, y, LINES, &surface), GLINT_OK);
    }
    free(memory);
}

/* ---- double precision ---- */

/* The nearest face at each sample and its depth; 0: none. */
struct truth {
    float depth[WIDE * WIDE];
    uint16_t face[WIDE * WIDE];
    bool is_near[PIXELS]; /* within 2 of an outline */
};

static const struct glint_mesh_vertex *corner(const struct sight *sight, unsigned face, unsigned k)
{
    return &sight->drawn.vertices[sight->mesh->faces[3 * face + k % 3]];
}

static bool is_front(const struct sight *sight, unsigned face)
{
    const struct glint_mesh_vertex *a = corner(sight, face, 0), *b = corner(sight, face, 1),
                                   *c = corner(sight, face, 2);
    return (b->x - a->x) * (c->y - a->y) < (c->x - a->x) * (b->y - a->y);
}

/* The shares of a face's corners at a place, 1/16 pixel. */
static void shares(const struct sight *sight, unsigned face, double x, double y, double part[3])
{
    double all = 0;
    for (unsigned k = 0; k < 3; k++) {
        const struct glint_mesh_vertex *a = corner(sight, face, k + 1), *b = corner(sight, face, k + 2);
        part[k] = (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
        all += part[k];
    }
    for (unsigned k = 0; k < 3; k++)
        part[k] /= all;
}

static int held(double x)
{
    return x < 0 ? 0 : x > WIDE ? WIDE : (int)x;
}

static void sample(const struct sight *sight, struct truth *truth)
{
    memset(truth->face, 0, sizeof truth->face);
    for (unsigned f = 0; f < sight->mesh->face_count; f++) {
        double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
        if (!is_front(sight, f))
            continue;
        for (unsigned k = 0; k < 3; k++) {
            const double at[2] = {corner(sight, f, k)->x, corner(sight, f, k)->y};
            for (int i = 0; i < 2; i++) {
                low[i] = fmin(low[i], at[i]);
                high[i] = fmax(high[i], at[i]);
            }
        }
        /* 16 samples a pixel: sample i lies at i + 1/2. */
        for (int y = held(low[1]); y < held(high[1] + 1); y++)
            for (int x = held(low[0]); x < held(high[0] + 1); x++) {
                double part[3], depth = 0;
                shares(sight, f, x + .5, y + .5, part);
                if (part[0] < -1e-12 || part[1] < -1e-12 || part[2] < -1e-12)
                    continue;
                for (unsigned k = 0; k < 3; k++)
                    depth += part[k] * corner(sight, f, k)->z;
                const size_t i = (size_t)y * WIDE + (size_t)x;
                if (truth->face[i] && (float)depth >= truth->depth[i])
                    continue;
                truth->depth[i] = (float)depth;
                truth->face[i] = (uint16_t)(f + 1);
            }
    }
}

static double depth_at(const struct truth *truth, int x, int y)
{
    if (x < 0 || y < 0 || x >= SIDE || y >= SIDE)
        return 0;
    const size_t i = (size_t)(FINE * y + FINE / 2) * WIDE + (size_t)(FINE * x + FINE / 2);
    return truth->face[i] ? (double)truth->depth[i] : 65535;
}

/* Pixels within 2 of an outline that something farther lies beside. */
static void find_outlines(const struct sight *sight, struct truth *truth)
{
    memset(truth->is_near, 0, sizeof truth->is_near);
    for (unsigned f = 0; f < sight->mesh->face_count; f++)
        for (unsigned k = 0; k < 3 && is_front(sight, f); k++) {
            const unsigned beside = sight->mesh->neighbours[3 * f + k];
            if (beside < sight->mesh->face_count ? is_front(sight, beside) : beside == GLINT_MESH_SEAM)
                continue;
            const struct glint_mesh_vertex *a = corner(sight, f, k), *b = corner(sight, f, k + 1);
            const int count = (abs(a->x - b->x) + abs(a->y - b->y)) / 8 + 1;
            for (int i = 0; i <= count; i++) {
                const double s = (double)i / count, z = a->z + (b->z - a->z) * s;
                const int x = (int)floor((a->x + (b->x - a->x) * s) / 16),
                          y = (int)floor((a->y + (b->y - a->y) * s) / 16);
                bool is_seen = false;
                for (int j = 0; j < 9; j++)
                    is_seen |= depth_at(truth, x + j % 3 - 1, y + j / 3 - 1) > z + 100;
                for (int j = 0; is_seen && j < 25; j++) {
                    const int u = x + j % 5 - 2, v = y + j / 5 - 2;
                    if (u >= 0 && u < SIDE && v >= 0 && v < SIDE)
                        truth->is_near[v * SIDE + u] = true;
                }
            }
        }
}

/* Of a sample of a face, levels. */
static void shade(const struct sight *sight, unsigned face, double x, double y, double out[3])
{
    const struct glint_vec *l = &sight->paint.l, *h = &sight->paint.h;
    static const double unit = 32768;
    double part[3], n[3] = {0}, turned[3], nl, t = 0;
    shares(sight, face, x, y, part);
    for (unsigned k = 0; k < 3; k++)
        for (unsigned i = 0; i < 3; i++)
            n[i] += part[k] * sight->mesh->normals[3 * sight->mesh->faces[3 * face + k] + i] / unit;
    for (unsigned i = 0; i < 3; i++) {
        const int16_t *row = sight->drawn.turn[i];
        turned[i] = (row[0] * n[0] + row[1] * n[1] + row[2] * n[2]) / 16384;
    }
    const double light[3] = {l->x / unit, l->y / unit, l->z / unit}, half[3] = {h->x / unit, h->y / unit, h->z / unit};
    nl = mesh_dot(turned, light);
    for (unsigned i = 0; i < 3; i++)
        t += (turned[i] - half[i]) * (turned[i] - half[i]) / 2;
    const double f =
        nl > 0 ? fmin(1, glint_eval_t(GLINT_MSH, material.n, (uint32_t)fmin(4e9, t * 1073741824)) / 65536.) : 0;
    for (unsigned k = 0; k < 3; k++)
        out[k] =
            fmin(255, material.albedo[k] * (material.ambient_q16[k] + material.diffuse_q16[k] * fmax(0, nl)) / 65536. +
                          255 * f * material.specular_q16[k] / 65536.);
}

struct error {
    double squares, sum, most;
    size_t count;
};

static double decibels(const struct error *error)
{
    return 10 * log10(255 * 255 / (error->squares / (double)error->count));
}

/* The mesh's colours times its coverage, and its coverage, of a pixel. */
static void mean(const struct sight *sight, const struct truth *truth, int x, int y, double out[4])
{
    memset(out, 0, 4 * sizeof *out);
    for (int i = 0; i < SAMPLES; i++) {
        const int u = FINE * x + i % FINE, v = FINE * y + i / FINE;
        const unsigned face = truth->face[(size_t)v * WIDE + (size_t)u];
        double value[3];
        if (!face)
            continue;
        shade(sight, face - 1, u + .5, v + .5, value);
        for (int k = 0; k < 3; k++)
            out[k] += value[k] / SAMPLES;
        out[3] += 1. / SAMPLES;
    }
}

static void add_error(struct error *error, const uint8_t pixel[3], const double mean_of[4], uint8_t ground)
{
    for (int k = 0; k < 3; k++) {
        const double e = fabs(pixel[k] - mean_of[k] - (1 - mean_of[3]) * ground);
        error->squares += e * e;
        error->sum += e;
        error->most = fmax(error->most, e);
        error->count++;
    }
}

/* Errors of stepped and smooth outlines over both grounds. */
static void measure(const struct fitted *fitted, const char *name, double least_light, double least_dark)
{
    static struct truth truth;
    static struct picture pictures[2][2];
    struct error errors[2][2] = {{{0}}};
    struct sight sight = {.mesh = &fitted->mesh};
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        const struct glint_pose pose = pose_of(turns[i]);
        for (int smooth = 0; smooth < 2; smooth++)
            for (int dark = 0; dark < 2; dark++)
                draw(&sight, &pose, smooth, dark ? DARK : LIGHT, &pictures[smooth][dark]);
        sample(&sight, &truth);
        find_outlines(&sight, &truth);
        for (int p = 0; p < PIXELS; p++) {
            double of[4];
            if (!truth.is_near[p])
                continue;
            mean(&sight, &truth, p % SIDE, p / SIDE, of);
            for (int j = 0; j < 4; j++)
                add_error(&errors[j / 2][j % 2], pictures[j / 2][j % 2].pixels[p], of, j % 2 ? DARK : LIGHT);
        }
    }
    free(sight.work);
    for (int dark = 0; dark < 2; dark++) {
        const struct error *stepped = &errors[0][dark], *smooth = &errors[1][dark];
        print_message(
            "%s, %s ground: stepped %.2f dB (mean %.2f, at most %.0f), smooth %.2f dB (mean %.2f, at most %.0f)\n",
            name, dark ? "dark" : "light", decibels(stepped), stepped->sum / (double)stepped->count, stepped->most,
            decibels(smooth), smooth->sum / (double)smooth->count, smooth->most);
    }
    assert_true(decibels(&errors[1][0]) >= least_light);
    assert_true(decibels(&errors[1][1]) >= least_dark);
}

/* Most of what is left over the light ground is where three faces or more and the ground meet, slivers and corners of the rim: there each face's share of a
 * pixel is found by its own edges alone. */
static void the_teapots_outlines_are_near_to_the_mean_of_many_samples(void **state)
{
    (void)state;
    const struct mesh_source source = {
        .name = "teapot", .built_in = true, .crease = -1, .split = 180, .axes = AXES_USUAL};
    struct mesh *mesh = mesh_load(&source);
    struct fitted *fitted = mesh_fit(mesh, 0);
    measure(fitted, "teapot", 32.9, 36.4);
    fitted_free(fitted);
    mesh_free(mesh);
}

static void a_knots_outlines_are_near_to_the_mean_of_many_samples(void **state)
{
    (void)state;
    struct mesh *mesh = knot();
    struct fitted *fitted = mesh_fit(mesh, 0);
    measure(fitted, "knot", 35.8, 42.4);
    fitted_free(fitted);
    mesh_free(mesh);
}

static void outlines_of_boxes_are_near_to_the_mean_of_many_samples(void **state)
{
    (void)state;
    struct mesh *mesh = boxes();
    struct fitted *fitted = mesh_fit(mesh, 0);
    measure(fitted, "boxes", 33.2, 34.2);
    fitted_free(fitted);
    mesh_free(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_teapots_outlines_are_near_to_the_mean_of_many_samples),
        cmocka_unit_test(a_knots_outlines_are_near_to_the_mean_of_many_samples),
        cmocka_unit_test(outlines_of_boxes_are_near_to_the_mean_of_many_samples),
    };
    return cmocka_run_group_tests_name("mesh outlines", tests, NULL, NULL);
}
