/* SPDX-License-Identifier: MIT
 * A triangle's pixels: which they are, how well t and nl follow the definition, and what clipping leaves. */
#include "meshes.h"

#include "glint_mesh_strip.h"

enum { GRID = 40 };

static struct glint_mesh_vertex vertex_at(double x, double y)
{
    const struct glint_mesh_vertex vertex = {(int16_t)floor(x), (int16_t)floor(y), 5, 0, 0, 1};
    return vertex;
}

static bool triangle_columns(struct glint_mesh_triangle *triangle, int32_t w, int32_t *left, int32_t *right)
{
    const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, triangle->y_end);
    return glint_mesh_columns(part.left, part.right, w, left, right);
}

/* Counts the pixels of a triangle in lines from..to - 1. */
static void count_pixels(uint8_t *count, const struct glint_mesh_vertex *const v[3], int32_t from, int32_t to)
{
    struct glint_mesh_triangle triangle;
    const struct glint_mesh_corner corner[3] = {{v[0], 0}, {v[1], 0}, {v[2], 0}};
    if (!glint_mesh_triangle_set(&triangle, corner, GLINT_MESH_GLOSSY, UINT32_MAX))
        return;
    if (triangle.y < from)
        glint_mesh_triangle_skip(&triangle, from);
    for (; triangle.y < triangle.y_end && triangle.y < to; glint_mesh_triangle_skip(&triangle, triangle.y + 1)) {
        int32_t left, right;
        if (triangle_columns(&triangle, MESH_W, &left, &right))
            for (int32_t x = left; x < right; x++)
                count[triangle.y * MESH_W + x]++;
    }
}

static void a_triangle_without_area_has_no_lines(void **state)
{
    (void)state;
    const struct glint_mesh_vertex a = vertex_at(16, 16), b = vertex_at(160, 160), c = vertex_at(320, 320);
    const struct glint_mesh_vertex *const flat[3] = {&a, &b, &c};
    uint8_t count[GRID * MESH_W] = {0};
    count_pixels(count, flat, 0, GRID);
    for (size_t i = 0; i < sizeof count; i++)
        assert_int_equal(count[i], 0);
}

/* Half of a 256th of a pixel, either way round: it may hold a pixel's middle. */
static void the_least_triangle_is_one(void **state)
{
    (void)state;
    const struct glint_mesh_vertex a = vertex_at(16, 16), b = vertex_at(17, 32), c = vertex_at(17, 33),
                                   d = vertex_at(18, 49);
    const struct glint_mesh_corner least[2][3] = {{{&a, 0}, {&b, 0}, {&c, 0}}, {{&b, 0}, {&c, 0}, {&d, 0}}};
    bool is_left[2];
    for (int i = 0; i < 2; i++) {
        struct glint_mesh_triangle triangle;
        assert_true(glint_mesh_triangle_set(&triangle, least[i], GLINT_MESH_GLOSSY, UINT32_MAX));
        is_left[i] = triangle.long_is_left;
    }
    assert_true(is_left[0] != is_left[1]);
}

static void a_skip_by_no_line_changes_nothing(void **state)
{
    (void)state;
    const struct glint_mesh_vertex a = vertex_at(16, 16), b = vertex_at(400, 100), c = vertex_at(50, 320);
    const struct glint_mesh_corner corner[3] = {{&a, 0}, {&c, 0}, {&b, 0}};
    struct glint_mesh_triangle triangle, before;
    memset(&triangle, 0, sizeof triangle);
    assert_true(glint_mesh_triangle_set(&triangle, corner, GLINT_MESH_GLOSSY, UINT32_MAX));
    before = triangle;
    glint_mesh_triangle_skip(&triangle, triangle.y);
    assert_memory_equal(&triangle, &before, sizeof triangle);
}

static double unit_random(void)
{
    return below(1 << 24) / (double)(1 << 24);
}

static void triangles_that_share_edges_cover_each_pixel_once(void **state)
{
    (void)state;
    static struct glint_mesh_vertex grid[GRID + 1][GRID + 1];
    static uint8_t count[MESH_H * MESH_W];
    for (int round = 0; round < 90; round++) {
        const int cells = round % 3 == 0 ? 4 : round % 3 == 1 ? 13 : GRID;
        const double step = 16. * MESH_W * 1.1 / cells;
        for (int j = 0; j <= cells; j++)
            for (int i = 0; i <= cells; i++) { /* inner corners move by less than would turn a triangle over */
                const bool inner = i > 0 && j > 0 && i < cells && j < cells;
                const double dx = inner ? .4 * (unit_random() - .5) : 0, dy = inner ? .4 * (unit_random() - .5) : 0;
                grid[j][i] = vertex_at(-60 + (i + dx) * step, -60 + (j + dy) * step);
                if (round & 1) { /* corners in the middles of pixels and on their borders */
                    grid[j][i].x = (int16_t)(grid[j][i].x & ~7);
                    grid[j][i].y = (int16_t)(grid[j][i].y & ~7);
                }
            }
        memset(count, 0, sizeof count);
        for (int strip = 0; strip < MESH_H; strip += 10 + round % 7)
            for (int j = 0; j < cells; j++)
                for (int i = 0; i < cells; i++) {
                    const struct glint_mesh_vertex *a = &grid[j][i], *b = &grid[j][i + 1], *c = &grid[j + 1][i],
                                                   *d = &grid[j + 1][i + 1];
                    const bool way = (i * 7 + j * 5 + round) % 3;
                    const struct glint_mesh_vertex *const one[3] = {a, c, way ? d : b}, *const two[3] = {way ? a : b,
                                                                                                         way ? d : c,
                                                                                                         way ? b : d};
                    const int32_t end = strip + 10 + round % 7 < MESH_H ? strip + 10 + round % 7 : MESH_H;
                    count_pixels(count, one, strip, end);
                    count_pixels(count, two, strip, end);
                }
        for (int p = 0; p < MESH_H * MESH_W; p++)
            if (count[p] != 1)
                fail_msg("round %d: pixel %d, %d is covered %d times", round, p % MESH_W, p / MESH_W, count[p]);
    }
}

static struct glint_vec unit_near(const double middle[3], double reach)
{
    double v[3], length = 0;
    for (int k = 0; k < 3; k++) {
        v[k] = middle[k] + reach * (2 * unit_random() - 1) / sqrt(3);
        length += v[k] * v[k];
    }
    const struct glint_vec n = {(int16_t)lrint(32767 * v[0] / sqrt(length)),
                                (int16_t)lrint(32767 * v[1] / sqrt(length)),
                                (int16_t)lrint(32767 * v[2] / sqrt(length))};
    return n;
}

/* Over triangles of up to 240 pixels whose normals are up to 30 degrees apart. */
static void t_and_nl_follow_the_interpolated_normal(void **state)
{
    (void)state;
    static const double sizes[] = {4, 8, 16, 32, 64, 120, 240};
    double t_most = 0, nl_most = 0;
    for (int round = 0; round < 30000; round++) {
        const double size = 16 * sizes[round % 7], v[3] = {unit_random() - .5, unit_random() - .5, .3 + unit_random()};
        const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]),
                     middle[3] = {v[0] / length, v[1] / length, v[2] / length};
        struct glint_mesh_corner c[3];
        struct glint_mesh_vertex vertex[3];
        struct glint_vec normal[3];
        const struct glint_vec h = unit_near(middle, .5), l = unit_near(middle, 1.);
        for (int i = 0; i < 3; i++) {
            vertex[i] = vertex_at(unit_random() * size, unit_random() * size);
            c[i].v = &vertex[i];
            normal[i] = unit_near(middle, .25);
            const double d[3] = {normal[i].x - h.x, normal[i].y - h.y, normal[i].z - h.z};
            vertex[i].t_q30 = (uint32_t)((d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / 2);
            vertex[i].nl_q30 = (int32_t)dot(normal[i], l);
        }
        for (int i = 0; i < 3; i++)
            c[i].side = glint_mesh_side(&normal[(i + 1) % 3], &normal[(i + 2) % 3]);
        const double area = (double)(c[1].v->x - c[0].v->x) * (c[2].v->y - c[0].v->y) -
                            (double)(c[2].v->x - c[0].v->x) * (c[1].v->y - c[0].v->y);
        struct glint_mesh_triangle triangle;
        if (fabs(area) < size * size / 8 ||
            !glint_mesh_triangle_set(&triangle, c, GLINT_MESH_GLOSSY, UINT32_MAX)) /* no slivers */
            continue;
        for (; triangle.y < triangle.y_end; glint_mesh_triangle_skip(&triangle, triangle.y + 1)) {
            const struct glint_mesh_values *at = &triangle.values;
            int32_t left, right;
            if (!triangle_columns(&triangle, 240, &left, &right))
                continue;
            for (int32_t x = left; x < right; x += 1 + (right - left) / 5) {
                const int32_t k = x - at->x;
                const uint32_t t = at->t + (uint32_t)k * at->tx + (uint32_t)(k * (k - 1) / 2) * at->txx;
                const int32_t nl = (int32_t)(at->nl + (uint32_t)k * at->nlx);
                const double px = 16 * x + 8, py = 16 * triangle.y + 8;
                const double b1 =
                    ((px - c[0].v->x) * (c[2].v->y - c[0].v->y) - (c[2].v->x - c[0].v->x) * (py - c[0].v->y)) / area;
                const double b2 =
                    ((c[1].v->x - c[0].v->x) * (py - c[0].v->y) - (px - c[0].v->x) * (c[1].v->y - c[0].v->y)) / area;
                double t_true = 0, nl_true = 0;
                const double n[3] = {normal[0].x + b1 * (normal[1].x - normal[0].x) + b2 * (normal[2].x - normal[0].x),
                                     normal[0].y + b1 * (normal[1].y - normal[0].y) + b2 * (normal[2].y - normal[0].y),
                                     normal[0].z + b1 * (normal[1].z - normal[0].z) + b2 * (normal[2].z - normal[0].z)};
                t_true = ((n[0] - h.x) * (n[0] - h.x) + (n[1] - h.y) * (n[1] - h.y) + (n[2] - h.z) * (n[2] - h.z)) / 2;
                nl_true = n[0] * l.x + n[1] * l.y + n[2] * l.z;
                const double t_error = fabs((int32_t)(t - (uint32_t)llrint(t_true)) / 1073741824.);
                const double nl_error = fabs(nl - nl_true) / 1073741824.;
                t_most = t_error > t_most ? t_error : t_most;
                nl_most = nl_error > nl_most ? nl_error : nl_most;
            }
        }
    }
    print_message("largest errors: t %.2g, nl %.2g\n", t_most, nl_most);
    assert_true(t_most < 6e-5 && nl_most < 1.2e-4);
}

/* A floor that runs from behind the camera to far away, as 2 x 20 x 20 faces: below the horizon each pixel is covered once. */
static void a_plane_through_the_camera_leaves_no_hole(void **state)
{
    (void)state;
    static struct made_mesh mesh;
    static uint8_t out[MESH_H][MESH_W];
    struct look look = random_look(GLINT_GREY8, GLINT_GAMMA);
    struct glint_paint paint;
    static const unsigned whole[] = {MESH_H};
    set_model(&look, GLINT_MSH, 10, 6);
    for (int k = 0; k < 3; k++) {
        look.material.ambient_q16[k] = 65536;
        look.material.albedo[k] = 255;
    }
    paint_of(&paint, &look);
    for (int round = 0; round < 20; round++) {
        mesh_made(&mesh, 441, 800);
        for (int j = 0; j <= 20; j++)
            for (int i = 0; i <= 20; i++) {
                int16_t *place = mesh.places[21 * j + i], *normal = mesh.normals[21 * j + i];
                place[0] = (int16_t)(3200 * (i - 10));
                place[1] = 0;
                place[2] = (int16_t)(3200 * (j - 10));
                normal[0] = normal[2] = 0;
                normal[1] = 32767;
            }
        for (int j = 0; j < 20; j++)
            for (int i = 0; i < 20; i++) {
                const unsigned a = 21 * (unsigned)j + (unsigned)i;
                const uint16_t two[2][3] = {{(uint16_t)a, (uint16_t)(a + 21), (uint16_t)(a + 22)},
                                            {(uint16_t)a, (uint16_t)(a + 22), (uint16_t)(a + 1)}};
                memcpy(mesh.faces[2 * (20 * j + i)], two, sizeof two);
            }
        mesh.pose.scale = (uint16_t)(30000 + below(30000));
        mesh.pose.position[1] = (int16_t)(200 + below(1000)); /* below the eye */
        mesh.distance = (uint16_t)(1500 + below(1500));
        memset(out, 0, sizeof out);
        mesh_picture(&mesh, &paint, &out[0][0], 1, whole, 1, false);
        for (unsigned x = 0; x < MESH_W; x++) {
            unsigned top = 0;
            while (top < MESH_H && !out[top][x])
                top++;
            assert_in_range(top, MESH_H / 2 - 1, MESH_H - 10); /* the horizon is in the middle */
            for (unsigned y = top; y < MESH_H; y++)
                if (!out[y][x])
                    fail_msg("round %d: a hole at %u, %u", round, x, y);
        }
    }
}

static unsigned free_places(const struct glint_mesh_frame *frame)
{
    const struct glint_mesh_kept *const kept = (const struct glint_mesh_kept *)frame->kept;
    unsigned count = 0;
    for (uint16_t at = frame->free; at != GLINT_MESH_NONE && count < 1000; at = kept[at].next)
        count++;
    return count;
}

/* Each place is used for one triangle after the other: GLINT_MESH_KEPT_BYTES a triangle that goes on are enough. */
static void places_for_triangles_that_go_on_are_free_again_where_these_end(void **state)
{
    (void)state;
    enum { PLACES = 50 };
    static struct made_mesh mesh;
    static uint32_t memory[8000], work[4000];
    static uint8_t out[3 * MESH_W * MESH_H];
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    struct glint_paint paint;
    set_model(&look, GLINT_MSH, 10, 6);
    paint_of(&paint, &look);
    mesh_ball(&mesh, 8, 12);
    mesh.pose.scale = 16 * 40; /* all of it in the picture */
    const size_t bytes = glint_mesh_frame_bytes(MESH_W, 4) + PLACES * GLINT_MESH_KEPT_BYTES;
    assert_true(bytes <= sizeof memory);
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, 4, 0, memory, bytes), GLINT_OK);
    const unsigned places = free_places(&frame);
    assert_in_range(places, PLACES, 999);
    assert_int_equal(glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, &paint, work, sizeof work), GLINT_OK);
    unsigned least = places;
    for (uint16_t y = 0; y < MESH_H; y = (uint16_t)(y + 4)) {
        const struct glint_surface surface = {out, 3 * MESH_W, 0, y};
        assert_int_equal(glint_mesh_strip(&frame, y, (uint16_t)(MESH_H - y < 4 ? MESH_H - y : 4), &surface), GLINT_OK);
        least = free_places(&frame) < least ? free_places(&frame) : least;
    }
    assert_in_range(least, 1, places - 10);
    assert_int_equal(free_places(&frame), places);
}

/* The last band may be of one line. Lists lie in memory that holds anything before. */
static void a_picture_of_any_height_is_the_same_whatever_its_memory_held(void **state)
{
    (void)state;
    enum { LINES = 2 * GLINT_MESH_BAND + 2 };
    static struct made_mesh mesh;
    static uint8_t drawn[2][MESH_W * LINES * 3];
    static _Alignas(8) uint8_t depths[MESH_W * LINES * 2 + 4096];
    static uint32_t work[(MESH_VERTICES * 16 + MESH_FACES * 2 + 256) / 4];
    const struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    paint_of(&paint, &look);
    mesh_ball(&mesh, 9, 12);
    for (uint16_t h = 1; h <= LINES; h++) {
        const size_t bytes = glint_mesh_bytes(&mesh.mesh, h);
        assert_true(bytes <= sizeof work && glint_mesh_frame_bytes(MESH_W, h) <= sizeof depths);
        for (int i = 0; i < 2; i++) {
            const struct glint_surface surface = {drawn[i], 3 * MESH_W, 0, 0};
            struct glint_mesh_frame frame;
            struct glint_mesh_drawn shown;
            memset(drawn[i], GUARD, sizeof drawn[i]);
            memset(work, i ? 0 : 0xff, sizeof work);
            assert_int_equal(glint_mesh_begin(&frame, MESH_W, h, h, 0, depths, glint_mesh_frame_bytes(MESH_W, h)),
                             GLINT_OK);
            assert_int_equal(glint_mesh_add(&frame, &shown, &mesh.mesh, &mesh.pose, &paint, work, bytes), GLINT_OK);
            assert_int_equal(glint_mesh_strip(&frame, 0, h, &surface), GLINT_OK);
        }
        assert_memory_equal(drawn[0], drawn[1], sizeof *drawn);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_of_any_height_is_the_same_whatever_its_memory_held),
        cmocka_unit_test(a_triangle_without_area_has_no_lines),
        cmocka_unit_test(the_least_triangle_is_one),
        cmocka_unit_test(a_skip_by_no_line_changes_nothing),
        cmocka_unit_test(triangles_that_share_edges_cover_each_pixel_once),
        cmocka_unit_test(t_and_nl_follow_the_interpolated_normal),
        cmocka_unit_test(a_plane_through_the_camera_leaves_no_hole),
        cmocka_unit_test(places_for_triangles_that_go_on_are_free_again_where_these_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
