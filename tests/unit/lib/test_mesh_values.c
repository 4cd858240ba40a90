/* SPDX-License-Identifier: MIT
 * A triangle's values beside lib/sequence.md, step by step; where the near plane lies, and how what it cuts is lit. */
#include "meshes.h"

#include "glint_mesh_pose.h"
#include "glint_mesh_strip.h"
#include "glint_mesh_texture.h"

static unsigned bits_of(uint64_t x)
{
    unsigned bits = 0;
    for (; x; x >>= 1)
        bits++;
    return bits;
}

/* `slopes` of sequence.md, of corners from the upper one down. */
struct slopes {
    int64_t x[2], y[2],
        at[2]; /* of u and v: a pixel to the right, a line down, times 2^e; at the first pixel, times 2^(e - 1) */
    int e;
};
static struct slopes slopes_of(const struct glint_mesh_vertex *const v[3])
{
    const int64_t x1 = v[1]->x - v[0]->x, y1 = v[1]->y - v[0]->y, x2 = v[2]->x - v[0]->x, y2 = v[2]->y - v[0]->y;
    const int64_t area = x1 * y2 - x2 * y1, size = llabs(area);
    const unsigned left = 32 - bits_of((uint64_t)size);
    const int64_t i = (int64_t)glint_mesh_inverse((uint32_t)(size << left >> 4)) * (area < 0 ? -1 : 1);
    struct slopes s = {{y2 * i, -y1 * i}, {-x2 * i, x1 * i}, {0, 0}, 0};
    uint64_t most = 0;
    for (int k = 0; k < 2; k++)
        most |= (uint64_t)(s.x[k] < 0 ? -s.x[k] - 1 : s.x[k]) | (uint64_t)(s.y[k] < 0 ? -s.y[k] - 1 : s.y[k]);
    const unsigned down = bits_of(most + (most >> 14)) - 15; /* room to round up */
    const int64_t half = (int64_t)1 << (down - 1), fx = 8 - (v[0]->x & 15),
                  fy = 16 * ((v[0]->y + 7) >> 4) + 8 - v[0]->y;
    for (int k = 0; k < 2; k++) {
        s.x[k] = (s.x[k] + half) >> down;
        s.y[k] = (s.y[k] + half) >> down;
        s.at[k] = (s.x[k] * fx + s.y[k] * fy + 16) >> 5;
    }
    s.e = 43 - (int)left - (int)down;
    return s;
}

/* `linear`: p u + q v, u and v times 2^e, in units of 2^-17. */
static uint32_t linear(int64_t p, int64_t q, const int64_t uv[2], int e)
{
    const int64_t sum = p * uv[0] + q * uv[1];
    return (uint32_t)(e > 17 ? sum >> (e - 17) : sum * ((int64_t)1 << (17 - e)));
}

/* Of triangles from a sixteenth of a pixel up: with sides of 1/16, too. */
static void nl_and_depth_of_a_triangle_are_the_sequence_s(void **state)
{
    (void)state;
    unsigned steep = 0, slivers = 0;
    for (int round = 0; round < 200000; round++) {
        const uint32_t size = round & 1 ? 5 : 2 + below(4000);
        struct glint_mesh_vertex vertex[3];
        const struct glint_mesh_vertex *v[3] = {&vertex[0], &vertex[1], &vertex[2]};
        for (int i = 0; i < 3; i++)
            vertex[i] = (struct glint_mesh_vertex){(int16_t)(103 + below(size)),
                                                   (int16_t)(103 + below(size)),
                                                   (uint16_t)below(65536),
                                                   0,
                                                   0,
                                                   (int32_t)(below(65536) << 15) - (1 << 30)};
        const struct glint_mesh_corner corner[3] = {{v[0], 0}, {v[1], 0}, {v[2], 0}};
        struct glint_mesh_triangle triangle;
        if (!glint_mesh_triangle_set(&triangle, corner, GLINT_MESH_MATT, 0))
            continue;
        for (int i = 0; i < 3; i++) /* from the upper one down, of equal ones the earlier first */
            for (int k = 0; k < 2; k++)
                if (v[k + 1]->y < v[k]->y) {
                    const struct glint_mesh_vertex *const upper = v[k + 1];
                    v[k + 1] = v[k];
                    v[k] = upper;
                }
        const struct slopes s = slopes_of(v);
        const struct glint_mesh_values *found = &triangle.values;
        if (s.e < 12) {
            assert_int_equal((int32_t)found->nl, (v[0]->nl_q30 >> 2) + (v[1]->nl_q30 >> 1) + (v[2]->nl_q30 >> 2));
            assert_int_equal(found->z, (v[0]->z + (uint32_t)v[1]->z + v[2]->z) * 21845);
            assert_true(found->nlx == 0 && found->nly == 0 && found->zx == 0 && found->zy == 0);
            steep++;
            continue;
        }
        const int64_t nl = (v[0]->nl_q30 >> 2) - (1 << 14), z = v[0]->z - 1;
        const int64_t p = ((v[1]->nl_q30 >> 2) - nl) >> 15, q = ((v[2]->nl_q30 >> 2) - nl) >> 15;
        const int64_t zp = (v[1]->z - z) >> 1, zq = (v[2]->z - z) >> 1;
        assert_int_equal(found->nl, (uint32_t)v[0]->nl_q30 + linear(p, q, s.at, s.e - 1));
        assert_int_equal(found->nlx, linear(p, q, s.x, s.e));
        assert_int_equal(found->nly, linear(p, q, s.y, s.e));
        assert_int_equal(found->z, ((uint32_t)v[0]->z << 16) + linear(zp, zq, s.at, s.e - 1));
        assert_int_equal(found->zx, linear(zp, zq, s.x, s.e));
        assert_int_equal(found->zy, linear(zp, zq, s.y, s.e));
        slivers += size == 5;
    }
    assert_true(steep > 100 && slivers > 1000);
}

/* `shine` of sequence.md, of a triangle that is not far beyond. */
static bool is_matt(const struct glint_mesh_corner c[3], uint32_t t_end)
{
    const struct glint_mesh_vertex *const v[3] = {c[0].v, c[1].v, c[2].v};
    int64_t side = 0;
    unsigned m = 0;
    for (unsigned i = 0; i < 3; i++) {
        m = v[i]->t_q30 < v[m]->t_q30 ? i : m;
        side = c[i].side > side ? c[i].side : side;
    }
    if ((int64_t)v[m]->t_q30 - t_end > side)
        return true;
    for (unsigned i = 0; i < 3; i++)
        if ((int64_t)v[i]->t_q30 - (i == m ? 0 : 2 * (int64_t)c[3 - i - m].side) - t_end <= side >> 3)
            return false;
    return slopes_of(v).e >= 15;
}

static void t_of_a_triangle_is_2_where_nothing_of_it_can_shine(void **state)
{
    (void)state;
    unsigned matt = 0, glossy = 0;
    for (int round = 0; round < 20000; round++) {
        const struct glint_mesh_vertex at[3] = {{100, 100, 5, 0, 0, 1}, {900, 150, 5, 0, 0, 1}, {300, 800, 5, 0, 0, 1}};
        struct glint_mesh_vertex vertex[3];
        struct glint_mesh_corner corner[3];
        const uint32_t t_end = below(1 << 20);
        for (int i = 0; i < 3; i++) {
            vertex[i] = at[i];
            vertex[i].t_q30 = below(1 << 22);
            corner[i] = (struct glint_mesh_corner){&vertex[i], below(1 << 21)};
        }
        struct glint_mesh_triangle triangle;
        assert_true(glint_mesh_triangle_set(&triangle, corner, GLINT_MESH_GLOSSY, t_end));
        if (is_matt(corner, t_end)) {
            assert_true(triangle.values.t == UINT32_C(1) << 31 && triangle.values.tx == 0 && triangle.values.ty == 0);
            matt++;
        } else {
            assert_true(triangle.values.t < UINT32_C(1) << 31 || triangle.values.t >= UINT32_C(0xf8000000));
            glossy++;
        }
    }
    assert_true(matt > 1000 && glossy > 1000);
}

/* Drawn as a glossy one, it would look the same. */
static void no_pixel_of_a_matt_triangle_lies_in_the_highlight(void **state)
{
    (void)state;
    unsigned matt = 0, pixels = 0;
    for (int round = 0; round < 60000; round++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        struct glint_mesh_vertex vertex[3];
        struct glint_mesh_corner corner[3];
        struct glint_vec n[3];
        const struct glint_vec first = random_normal(&look);
        const uint32_t size = round & 1 ? 400 : 3000, far = 1000 << below(6);
        uint32_t least = UINT32_MAX;
        for (int i = 0; i < 3; i++) {
            const double x = first.x + (double)below(2 * far) - far, y = first.y + (double)below(2 * far) - far,
                         z = first.z + (double)below(2 * far) - far, length = sqrt(x * x + y * y + z * z) / 32767;
            n[i] = (struct glint_vec){(int16_t)(x / length), (int16_t)(y / length), (int16_t)(z / length)};
            const int64_t dx = n[i].x - look.h.x, dy = n[i].y - look.h.y, dz = n[i].z - look.h.z;
            vertex[i] = (struct glint_mesh_vertex){
                (int16_t)below(size), (int16_t)below(size), 5, 0, (uint32_t)((dx * dx + dy * dy + dz * dz) >> 1), 1};
            least = vertex[i].t_q30 < least ? vertex[i].t_q30 : least;
        }
        for (int i = 0; i < 3; i++)
            corner[i] = (struct glint_mesh_corner){&vertex[i], glint_mesh_side(&n[(i + 1) % 3], &n[(i + 2) % 3])};
        const uint32_t t_end = least - below(least >> below(12));
        struct glint_mesh_triangle triangle;
        if (!glint_mesh_triangle_set(&triangle, corner, GLINT_MESH_GLOSSY, t_end) || triangle.shine != GLINT_MESH_MATT)
            continue;
        assert_true(glint_mesh_triangle_set(&triangle, corner, GLINT_MESH_GLOSSY, UINT32_MAX));
        assert_int_equal(triangle.shine, GLINT_MESH_GLOSSY);
        matt++;
        for (; triangle.y < triangle.y_end; triangle.y++) {
            const struct glint_mesh_part part = glint_mesh_triangle_part(&triangle, triangle.y_end);
            const struct glint_mesh_values *v = &triangle.values;
            for (int32_t x = part.left->x >> 16; x < part.right->x >> 16; x++, pixels++) {
                const int32_t k = x - v->x;
                const uint32_t t = v->t + (uint32_t)k * v->tx + (uint32_t)(k * (k - 1) / 2) * v->txx;
                assert_true(t >= t_end);
            }
            glint_mesh_edge_next(part.left);
            glint_mesh_edge_next(part.right);
            glint_mesh_values_next(&triangle.values);
        }
    }
    assert_true(matt > 1000 && pixels > 100000);
}

static void a_triangle_is_matt_from_2_to_the_29_beyond_the_highlight_and_dark_behind(void **state)
{
    (void)state;
    const uint32_t t_end = 1000, far = (UINT32_C(1) << 29) + t_end;
    struct glint_mesh_vertex v[3] = {{0, 0, 5, 0, far, 1}, {90, 0, 5, 0, far, -1}, {0, 90, 5, 0, far + 7, -1}};
    const struct glint_mesh_corner corner[3] = {{&v[0], 0}, {&v[1], 0}, {&v[2], 0}};
    assert_int_equal(glint_mesh_shine(corner, t_end), GLINT_MESH_MATT);
    assert_int_equal(glint_mesh_shine(corner, t_end + 1), GLINT_MESH_GLOSSY);
    v[1].t_q30--;
    assert_int_equal(glint_mesh_shine(corner, t_end), GLINT_MESH_GLOSSY);
    v[0].nl_q30 = -1;
    assert_int_equal(glint_mesh_shine(corner, t_end), GLINT_MESH_DARK);
}

/* |a - b|^2 / 2 of its normals is 2^29 there: what is flat does not change across the triangle. */
static void a_glossy_triangle_is_flat_where_its_normals_are_more_than_90_degrees_apart(void **state)
{
    (void)state;
    const struct glint_mesh_vertex v[3] = {
        {100, 100, 5, 0, 1 << 20, 0}, {900, 150, 5, 0, 1 << 21, 1 << 28}, {300, 800, 5, 0, 1 << 22, 1 << 29}};
    for (unsigned i = 0; i < 3; i++)
        for (uint32_t beyond = 0; beyond < 2; beyond++) {
            struct glint_mesh_corner corner[3] = {{&v[0], 1 << 20}, {&v[1], 1 << 20}, {&v[2], 1 << 20}};
            struct glint_mesh_triangle triangle;
            corner[i].side = (UINT32_C(1) << 29) + beyond;
            assert_true(glint_mesh_triangle_set(&triangle, corner, GLINT_MESH_GLOSSY, UINT32_MAX));
            assert_int_equal(triangle.values.nlx == 0, beyond);
        }
}

static struct made_mesh mesh;

/* One face whose corners have the normal n, drawn with the look over pixels of 0. */
static void draw_face(const struct look *look, const int16_t places[3][3], struct glint_vec n, int16_t z,
                      uint16_t scale, uint16_t distance, uint8_t *out)
{
    static const unsigned whole[] = {MESH_H};
    struct glint_paint paint;
    paint_of(&paint, look);
    mesh_made(&mesh, 3, 1);
    for (int i = 0; i < 3; i++) {
        const int16_t normal[3] = {n.x, n.y, n.z};
        memcpy(mesh.places[i], places[i], sizeof mesh.places[i]);
        memcpy(mesh.normals[i], normal, sizeof normal);
        mesh.faces[0][i] = (uint16_t)i;
    }
    mesh.pose.position[2] = z;
    mesh.pose.scale = scale;
    mesh.distance = distance;
    memset(out, 0, 3 * MESH_W * MESH_H);
    mesh_picture(&mesh, &paint, out, 3, whole, 1, false);
}

/* 8 (distance - z) >= distance: of a face with a corner at the last such z nothing is left if the others are a sixteenth of a pixel
 * nearer to the camera, as the sides are cut where they begin. */
static void the_near_plane_lies_an_eighth_of_the_distance_before_the_camera(void **state)
{
    (void)state;
    static const int16_t at[3][3] = {{-160, -160, 0}, {160, -160, 0}, {0, 160, 0}},
                         nearer[3][3] = {{-160, -160, 0}, {160, -160, 4}, {0, 160, 4}};
    static uint8_t out[3 * MESH_W * MESH_H];
    const struct glint_vec n = {0, 0, 32767};
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    set_model(&look, GLINT_MSH, 10, 6);
    look.material.ambient_q16[1] = 65536;
    look.material.albedo[1] = 255;
    for (int round = 0; round < 64; round++) {
        const uint16_t distance = (uint16_t)(400 + round);
        int16_t last = (int16_t)distance;
        while (8 * (distance - last) < distance)
            last--;
        draw_face(&look, at, n, last, 8192, distance, out);
        assert_int_equal(out[3 * (MESH_W * (MESH_H / 2) + MESH_W / 2) + 1], 255);
        draw_face(&look, nearer, n, last, 8192, distance, out);
        for (size_t i = 0; i < sizeof out; i++)
            assert_int_equal(out[i], 0);
    }
}

/* Corners beyond the guard band, of one normal: each pixel is that of a span with the corners' t and nl. */
static void what_is_clipped_is_lit_by_its_normals(void **state)
{
    (void)state;
    static const int16_t places[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}};
    static uint8_t out[3 * MESH_W * MESH_H], line[3 * MESH_W];
    for (int round = 0; round < 200; round++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        if (look.material.model == GLINT_PHONG)
            set_model(&look, GLINT_MSH, 60, 8);
        look.output.dither = false;
        const struct glint_vec n = random_normal(&look), h = look.h;
        const int64_t x = n.x - h.x, y = n.y - h.y, z = n.z - h.z;
        const struct glint_span span = {(uint32_t)((x * x >> 1) + (y * y >> 1) + (z * z >> 1)),
                                        0,
                                        0,
                                        (int32_t)dot(n, look.l),
                                        0,
                                        MESH_W,
                                        {{0, 0}, {0, 0}}};
        if (span.t_q30 >= UINT32_C(1) << 31)
            continue;
        const struct glint_surface surface = {line, sizeof line, 0, 0};
        assert_int_equal(draw_span(&look, &span, &surface, NULL), GLINT_OK);
        draw_face(&look, places, n, 0, 32768, round & 1 ? 2000 : 0, out);
        for (size_t i = 0; i < MESH_H; i++)
            assert_memory_equal(out + i * sizeof line, line, sizeof line);
    }
}

/* The line of a face in parallel projection as a span of its corners' normals, which are linear between them. */
static struct glint_span span_of_face(const struct glint_paint *paint, int y)
{
    const int16_t l[3] = {paint->l.x, paint->l.y, paint->l.z}, h[3] = {paint->h.x, paint->h.y, paint->h.z};
    double at[3][2], t[3], nl[3];
    for (int i = 0; i < 3; i++) {
        at[i][0] = 8 * MESH_W + mesh.places[mesh.faces[0][i]][0];
        at[i][1] = 8 * MESH_H - mesh.places[mesh.faces[0][i]][1];
    }
    const double ux = at[1][0] - at[0][0], uy = at[1][1] - at[0][1], vx = at[2][0] - at[0][0], vy = at[2][1] - at[0][1];
    for (int x = 0; x < 3; x++) {
        const double px = 16 * x + 8 - at[0][0], py = 16 * y + 8 - at[0][1], area = ux * vy - vx * uy,
                     b = (px * vy - vx * py) / area, c = (ux * py - px * uy) / area;
        t[x] = nl[x] = 0;
        for (int k = 0; k < 3; k++) {
            const double n = (1 - b - c) * mesh.normals[mesh.faces[0][0]][k] + b * mesh.normals[mesh.faces[0][1]][k] +
                             c * mesh.normals[mesh.faces[0][2]][k];
            t[x] += (n - h[k]) * (n - h[k]) / 2;
            nl[x] += n * l[k];
        }
    }
    return (struct glint_span){
        (uint32_t)lrint(t[0]), (uint32_t)lrint(t[1] - t[0]),  (uint32_t)lrint(t[2] - 2 * t[1] + t[0]),
        (int32_t)lrint(nl[0]), (int32_t)lrint(nl[1] - nl[0]), MESH_W,
        {{0, 0}, {0, 0}}};
}

/* Whichever of its corners is beyond the guard band, or two. */
static void what_is_clipped_shines_between_its_corners_as_if_it_were_not(void **state)
{
    (void)state;
    static const int16_t places[2][3][3] = {{{9000, -2000, 0}, {-1100, 32000, 0}, {-1100, -2000, 0}},
                                            {{32000, -1200, 0}, {-32000, 32000, 0}, {-8000, -32000, 0}}};
    static uint8_t out[3 * MESH_W * MESH_H], line[3 * MESH_W];
    static const unsigned whole[] = {MESH_H};
    for (int round = 0; round < 60; round++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        struct glint_paint paint;
        set_model(&look, GLINT_MSH, 30, 8);
        look.output.dither = false;
        paint_of(&paint, &look);
        mesh_made(&mesh, 3, 1);
        mesh.pose.scale = 32768;
        memcpy(mesh.places, places[round % 2], sizeof places[0]);
        for (int i = 0; i < 3; i++) {
            struct glint_vec n;
            const int32_t about[3] = {look.h.x + (int32_t)below(40000) - 20000,
                                      look.h.y + (int32_t)below(40000) - 20000,
                                      look.h.z + (int32_t)below(40000) - 20000};
            assert_int_equal(glint_vec_normalize(&n, about), GLINT_OK);
            mesh.normals[i][0] = n.x, mesh.normals[i][1] = n.y, mesh.normals[i][2] = n.z;
            mesh.faces[0][i] = (uint16_t)((i + round / 2) % 3);
        }
        memset(out, 0, sizeof out);
        mesh_picture(&mesh, &paint, out, 3, whole, 1, false);
        for (int y = 0; y < MESH_H; y++) {
            const struct glint_span span = span_of_face(&paint, y);
            const struct glint_surface surface = {line, sizeof line, 0, 0};
            assert_int_equal(glint_draw_span(&paint, &span, NULL, &surface, NULL), GLINT_OK);
            for (int x = 0; x < 3 * MESH_W; x++)
                assert_in_range(out[3 * MESH_W * y + x] - line[x] + 6, 0, 12);
        }
    }
}

/* It is flat: its values would have too steep a slope. */
static void a_face_within_a_pixel_has_the_light_of_its_normals(void **state)
{
    (void)state;
    static const int16_t large[3][3] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}},
                         small[3][3] = {{3584, 3584, 0}, {4608, 3584, 0}, {4096, 4608, 0}}; /* about a pixel's middle */
    static uint8_t out[3 * MESH_W * MESH_H], expected[3 * MESH_W * MESH_H];
    const size_t at = 3 * ((MESH_H / 2 - 1) * MESH_W + MESH_W / 2);
    unsigned lit = 0;
    for (int round = 0; round < 400; round++) {
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        look.output.dither = false;
        const struct glint_vec n = random_normal(&look);
        draw_face(&look, large, n, 0, 32768, 0, expected);
        draw_face(&look, small, n, 0, 64, 0, out);
        for (int k = 0; k < 3; k++)
            assert_true(abs(out[at + (size_t)k] - expected[at + (size_t)k]) <= 1);
        lit += memcmp(expected + at, out, 3) != 0; /* out's first pixel is black */
    }
    assert_true(lit > 100);
}

/* (it + 2^13) >> 14, held between the least and the most of the corners, modulo 2^32. */
static void a_number_across_a_triangle_is_held_between_its_corners(void **state)
{
    (void)state;
    const struct glint_mesh_slope slope = {0, 5 << 14, 0, -3, 7};
    static const struct {
        int32_t now;
        int16_t held;
    } cases[] = {{-4 * 16384, -3}, {-3 * 16384, -3}, {-8193, -1},   {-8192, 0},
                 {6 * 16384, 6},   {7 * 16384, 7},   {8 * 16384, 7}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        uint32_t now = (uint32_t)cases[i].now;
        assert_int_equal(glint_mesh_across_next(&slope, &now), cases[i].held);
        assert_int_equal(now, (uint32_t)cases[i].now + (5 << 14));
    }
}

/* Where it would leave them, a line of 5 pixels has the nearest colour there is; where it reaches the last one, it changes. */
static void a_colour_is_held_to_what_there_is(void **state)
{
    (void)state;
    for (unsigned k = 0; k < 3; k++) {
        const uint32_t end = (k == 1 ? 64u : 32u) << 21, last = end - 1;
        const struct {
            uint32_t now, step, held, held_step;
        } cases[] = {{0, 0, 0, 0},      {last, 0, last, 0},        {last - 4, 1, last - 4, 1}, {end - 4, 1, end - 4, 0},
                     {end, 0, last, 0}, {4, 0u - 1, 4, 0u - 1},    {3, 0u - 1, 3, 0},          {0u - 1, 0, 0, 0},
                     {0u - 4, 1, 0, 0}, {end + 9, 0u - 9, last, 0}};
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            uint32_t now = cases[i].now, step = cases[i].step;
            glint_mesh_hold(&now, &step, k, 4);
            assert_int_equal(now, cases[i].held);
            assert_int_equal(step, cases[i].held_step);
        }
    }
}

/* w1 and w2 of sequence.md: what is not cut keeps all of its own, and of the two others nothing. */
static void a_corner_that_is_not_cut_is_wholly_itself(void **state)
{
    (void)state;
    static const int16_t places[3][3] = {{-40, -40, 0}, {32767, -40, 0}, {0, 40, 0}};
    static uint8_t out[3 * MESH_W * MESH_H];
    static uint32_t depths[8000], work[100];
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    const struct glint_vec n = {0, 0, 32767};
    set_model(&look, GLINT_MSH, 10, 6);
    paint_of(&paint, &look);
    for (uint16_t first = 0; first < 3; first++) {
        struct glint_mesh_frame frame;
        struct glint_mesh_drawn drawn;
        struct glint_mesh_polygon polygon;
        draw_face(&look, places, n, 0, 32768, 0, out);
        for (uint16_t i = 0; i < 3; i++)
            mesh.faces[0][i] = (uint16_t)((i + first) % 3);
        assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 16, 0, depths, sizeof depths), GLINT_OK);
        assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
        const unsigned count = glint_mesh_clip(&polygon, &frame, &drawn, mesh.faces[0]);
        assert_int_equal(count, 4);
        assert_ptr_not_equal(glint_mesh_polygon_samples(&polygon, &frame), polygon.list[polygon.now].samples);
        for (unsigned i = 0; i < count; i++) {
            const struct glint_mesh_clipped *at = &polygon.list[polygon.now].corner[i];
            if (at->at.x < GLINT_MESH_GUARD) {
                const unsigned number = (at->at.x < 0 ? 0 : 2) + 3u - first;
                assert_int_equal(at->weight[0], number % 3 == 1 ? 32768 : 0);
                assert_int_equal(at->weight[1], number % 3 == 2 ? 32768 : 0);
            }
        }
        assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 16, 60000, depths, sizeof depths), GLINT_OK);
        assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
        assert_int_not_equal(glint_mesh_clip(&polygon, &frame, &drawn, mesh.faces[0]), 0);
        assert_ptr_not_equal(glint_mesh_polygon_samples(&polygon, &frame), polygon.list[polygon.now].samples);
    }
}

/* It is linear there in perspective, too: by the weights of its corners a cut of one that is 1,500 pixels wide is where it is. */
static void the_texture_of_a_face_parallel_to_the_picture_is_cut_to_a_quarter_of_a_pixel(void **state)
{
    (void)state;
    static uint32_t depths[8000], work[100];
    static const struct glint_texture texture = {.pixels = work, .w = 1, .h = 1, .levels = 1};
    const struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    unsigned cut = 0;
    assert_int_equal(glint_paint_exact(&paint, &look.material, &look.output), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, NULL, 0, in_front), GLINT_OK);
    for (int round = 0; round < 2000; round++) {
        struct glint_mesh_frame frame;
        struct glint_mesh_drawn drawn;
        struct glint_mesh_polygon polygon;
        struct glint_mesh_place at[3];
        mesh_made(&mesh, 3, 1);
        mesh.mesh.textures = &texture;
        mesh.mesh.uv = &mesh.uv[0][0];
        mesh.mesh.uv_bits = 15;
        mesh.pose.scale = 65535;
        mesh.pose.position[0] = (int16_t)(round % 2 ? 32767 : -32767);
        mesh.pose.position[2] = (int16_t) - (int)(9000 + below(100));
        for (uint16_t i = 0; i < 3; i++) {
            for (int k = 0; k < 2; k++)
                mesh.places[i][k] = (int16_t)((int)below(65535) - 32767);
            mesh.places[i][2] = 0;
            mesh.faces[0][i] = i;
        }
        assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 16, 3100, depths, sizeof depths), GLINT_OK);
        assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
        for (unsigned i = 0; i < 3; i++)
            at[i] = glint_mesh_project(&frame, glint_mesh_place_of(&drawn, i));
        const unsigned count = glint_mesh_clip(&polygon, &frame, &drawn, mesh.faces[0]);
        for (unsigned i = 0; i < count; i++) {
            const struct glint_mesh_clipped *const corner = &polygon.list[polygon.now].corner[i];
            const double b = corner->weight[0] / 32768., c = corner->weight[1] / 32768.;
            const double x = (1 - b - c) * at[0].x + b * at[1].x + c * at[2].x;
            assert_true(fabs(x - corner->at.x) <= 4);
            cut += abs(corner->at.x) == GLINT_MESH_GUARD;
        }
    }
    assert_true(cut > 1000);
}

/* Whichever corner that is, in strips, too: the same pixels, and the same colours between the corners. */
static void any_one_corner_of_a_face_may_be_beyond_the_guard_band(void **state)
{
    (void)state;
    static const int16_t low[3][3] = {{0, -600, 0}, {30, -600, 0}, {0, -500, 0}},
                         places[3][3] = {{32767, -300, 0}, {-600, 600, 0}, {-600, -600, 0}};
    static const uint8_t colours[3][3] = {{255, 40, 20}, {30, 255, 10}, {50, 15, 255}};
    static const unsigned heights[] = {MESH_H, 5, 1};
    static uint8_t out[2][3 * MESH_W * MESH_H];
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    set_model(&look, GLINT_MSH, 10, 6);
    look.output.dither = false;
    for (int k = 0; k < 3; k++) {
        look.material.ambient_q16[k] = 65536;
        look.material.diffuse_q16[k] = look.material.specular_q16[k] = 0;
    }
    paint_of(&paint, &look);
    for (uint16_t first = 0; first < 3; first++)
        for (int height = 0; height < 3; height++) {
            unsigned drawn = 0, other = 0;
            draw_face(&look, low, (struct glint_vec){0, 0, 32767}, 0, 32768, 0,
                      out[0]); /* whose places stay in memory */
            draw_face(&look, places, (struct glint_vec){0, 0, 32767}, 0, 32768, 0, out[0]);
            mesh.mesh.of_vertices = &colours[0][0];
            for (int turned = 0; turned < 2; turned++) {
                for (uint16_t i = 0; i < 3; i++)
                    mesh.faces[0][i] = (uint16_t)((i + first * turned) % 3);
                memset(out[turned], 0, sizeof out[turned]);
                mesh_picture(&mesh, &paint, out[turned], 3, &heights[turned ? height : 0], 1, height & 1);
            }
            for (size_t i = 0; i < sizeof out[0]; i++) {
                drawn += out[0][i] != 0;
                other += abs(out[0][i] - out[1][i]) > 2;
            }
            assert_true(drawn > 3 * 500);
            assert_in_range(other, 0, 9); /* another fan may round a side another way */
        }
}

/* As cores with a divider have it, glint_mesh_height_inverse. */
static void a_height_s_inverse_is_the_quotient_below_512_pixels(void **state)
{
    (void)state;
    for (uint32_t dy = 1; dy < 8192; dy++) {
        const unsigned up = glint_mesh_zeros(dy);
        assert_int_equal(glint_mesh_inverse(dy << up >> 4), GLINT_MESH_QUOTIENT(dy, up));
    }
}

static void a_shift_by_more_than_a_number_s_bits_leaves_nothing(void **state)
{
    (void)state;
    for (int down = -70; down <= 70; down++)
        for (unsigned i = 0; i < 100; i++) {
            const int32_t r = (int32_t)below(UINT32_MAX) >> below(31);
            const double shifted = floor(ldexp(r, -down) + .5), whole = 4294967296.;
            assert_true(glint_mesh_shift(r, down) == (uint32_t)(shifted - whole * floor(shifted / whole)));
        }
}

static void a_place_at_the_viewer_or_behind_is_projected_as_the_nearest(void **state)
{
    (void)state;
    struct glint_mesh_frame frame = {.distance = 4000};
    const struct glint_mesh_place nearest = glint_mesh_project(&frame, (struct glint_mesh_place){3, -5, 3999});
    for (int32_t z = 4000; z < 4003; z++) {
        const struct glint_mesh_place at = glint_mesh_project(&frame, (struct glint_mesh_place){3, -5, z});
        assert_int_equal(at.x, nearest.x);
        assert_int_equal(at.y, nearest.y);
        assert_int_equal(at.z, nearest.z);
    }
}

/* The direction (1, 1, 1), rounded to 16 bits, has a length of 32768.7. */
static void a_light_that_a_turn_brings_to_an_axis_is_held_to_16_bits(void **state)
{
    (void)state;
    const struct glint_paint paint = {.l = {18919, 18919, 18919}, .h = {-18919, -18919, -18919}};
    struct glint_mesh_drawn drawn;
    const struct glint_pose pose = {{29100, -10652, 10652, 0}, {0, 0, 0}, 1};
    assert_true(glint_pose_set(&drawn, &pose, &paint));
    assert_in_range(drawn.l.x + 3, 0, 6);
    assert_in_range(drawn.l.y + 3, 0, 6);
    assert_int_equal(drawn.l.z, 32767);
    assert_int_equal(drawn.h.z, -32767);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_at_the_viewer_or_behind_is_projected_as_the_nearest),
        cmocka_unit_test(a_height_s_inverse_is_the_quotient_below_512_pixels),
        cmocka_unit_test(a_shift_by_more_than_a_number_s_bits_leaves_nothing),
        cmocka_unit_test(nl_and_depth_of_a_triangle_are_the_sequence_s),
        cmocka_unit_test(t_of_a_triangle_is_2_where_nothing_of_it_can_shine),
        cmocka_unit_test(no_pixel_of_a_matt_triangle_lies_in_the_highlight),
        cmocka_unit_test(a_triangle_is_matt_from_2_to_the_29_beyond_the_highlight_and_dark_behind),
        cmocka_unit_test(a_glossy_triangle_is_flat_where_its_normals_are_more_than_90_degrees_apart),
        cmocka_unit_test(the_near_plane_lies_an_eighth_of_the_distance_before_the_camera),
        cmocka_unit_test(what_is_clipped_is_lit_by_its_normals),
        cmocka_unit_test(what_is_clipped_shines_between_its_corners_as_if_it_were_not),
        cmocka_unit_test(a_face_within_a_pixel_has_the_light_of_its_normals),
        cmocka_unit_test(a_number_across_a_triangle_is_held_between_its_corners),
        cmocka_unit_test(a_colour_is_held_to_what_there_is),
        cmocka_unit_test(a_corner_that_is_not_cut_is_wholly_itself),
        cmocka_unit_test(the_texture_of_a_face_parallel_to_the_picture_is_cut_to_a_quarter_of_a_pixel),
        cmocka_unit_test(a_light_that_a_turn_brings_to_an_axis_is_held_to_16_bits),
        cmocka_unit_test(any_one_corner_of_a_face_may_be_beyond_the_guard_band),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
