/* SPDX-License-Identifier: MIT
 * From triangles to a mesh that the library draws: welded, split, ordered, fitted. */
#include <sys/time.h>

#include "solids.h"

#include "compare/mesh_quality.h"
#include "compare/mesh_scene.h"
#include "draw/view.h"
#include "mesh/fit.h"
#include "mesh/load.h"
#include "mesh/order.h"
#include "mesh/split.h"
#include "mesh/weld.h"

static struct mesh *cube_with(double crease)
{
    struct soup *soup = soup_cube();
    struct mesh *mesh = mesh_weld(soup, crease);
    soup_free(soup);
    return mesh;
}

static struct mesh *teapot_split(double degrees)
{
    return mesh_load(
        &(struct mesh_source){.name = "teapot", .built_in = true, .crease = -1, .split = degrees, .axes = AXES_USUAL});
}

/* As small and as large as a file's numbers, which are floats, can be: below 10^30. */
static void a_mesh_of_any_size_has_the_same_normals(void **state)
{
    (void)state;
    static const int exponents[] = {-126, -60, 60, 99};
    struct mesh *wanted = cube_with(89);
    for (int i = 0; i < 4; i++) {
        struct soup *soup = soup_cube();
        for (size_t k = 0; k < 9 * soup->face_count; k++)
            soup->faces[k / 9].places[k / 3 % 3][k % 3] *= ldexp(1, exponents[i]);
        struct mesh *mesh = mesh_weld(soup, 89);
        assert_int_equal(mesh->place_count, 8);
        assert_int_equal(mesh->vertex_count, 24);
        assert_memory_equal(mesh->normals, wanted->normals, 24 * sizeof *mesh->normals);
        mesh_free(mesh);
        soup_free(soup);
    }
    mesh_free(wanted);
}

static void a_vector_without_a_direction_is_told(void **state)
{
    (void)state;
    double none[][3] = {{0, 0, 0}, {NAN, 1, 1}, {NAN, 0, 0}, {INFINITY, 0, 0}, {1, -INFINITY, NAN}};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_false(mesh_normalize(none[i]));
    double some[][3] = {{3e-300, 0, 4e-300}, {3e300, 0, 4e300}, {3, 0, 4}};
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        assert_true(mesh_normalize(some[i]));
        assert_near(some[i][0], .6, 1e-15);
        assert_near(some[i][2], .8, 1e-15);
    }
}

static void corners_at_one_place_are_joined_and_a_crease_parts_their_normals(void **state)
{
    (void)state;
    struct mesh *sharp = cube_with(89), *smooth = cube_with(90);
    assert_int_equal(sharp->place_count, 8);
    assert_int_equal(sharp->vertex_count, 24);
    assert_int_equal(smooth->place_count, 8);
    assert_int_equal(smooth->vertex_count, 8);
    for (size_t i = 0; i < 24; i++) {
        const double *n = sharp->normals[i];
        assert_near(fabs(n[0]) + fabs(n[1]) + fabs(n[2]), 1, 1e-12);
        assert_true(mesh_dot(n, sharp->places[i]) > .99); /* outwards */
    }
    for (size_t i = 0; i < 8; i++) /* each face counts by its angle, so that triangles of a square are no matter */
        for (int k = 0; k < 3; k++)
            assert_near(smooth->normals[i][k], smooth->places[i][k] / sqrt(3), 1e-12);
    assert_closed(sharp);
    assert_closed(smooth);
    mesh_free(sharp);
    mesh_free(smooth);
}

static void corners_a_little_apart_are_joined_wherever_cells_end(void **state)
{
    (void)state;
    for (int i = 0; i < 400; i++) {
        struct soup *soup = soup_cube();
        for (size_t j = 0; j < 3 * soup->face_count; j++)
            for (int k = 0; k < 3; k++)
                soup->faces[j / 3].places[j % 3][k] =
                    soup->faces[j / 3].places[j % 3][k] * (1 + i * 3e-7) + (double)((j + (size_t)k) % 3) * 4e-6;
        struct mesh *mesh = mesh_weld(soup, 60);
        assert_int_equal(mesh->place_count, 8);
        soup_free(soup);
        mesh_free(mesh);
    }
}

struct multiple {
    uint64_t value;
    uint16_t of;
};

static int by_value(const void *a, const void *b)
{
    const struct multiple *p = a, *q = b;
    return p->value < q->value ? -1 : p->value > q->value;
}

/* For a hash of cells by multiplication, the upper 16 bits: all corners are in one list. */
static void corners_chosen_for_one_list_are_joined_in_little_time(void **state)
{
    (void)state;
    enum { SIDE = 50000, FACES = 65000, STEPS = 1 << 16 };
    const uint64_t factor = 0x9e3779b97f4a7c15u;
    struct multiple *multiples = calloc(STEPS, sizeof *multiples);
    double(*places)[3] = calloc(3 * FACES, sizeof *places);
    int(*faces)[3] = calloc(FACES, sizeof *faces);
    assert_true(multiples && places && faces);
    for (uint64_t i = 0; i < STEPS; i++)
        multiples[i] = (struct multiple){i * factor, (uint16_t)i};
    qsort(multiples, STEPS, sizeof *multiples, by_value);
    places[0][0] = 2 * SIDE; /* beside 0, 0, 0: the mesh's size is 10^5, its tolerance 1 */
    size_t count = 2;
    for (uint64_t i = 1; count < 3 * FACES; i++) {
        const uint64_t x = i % SIDE, y = i / SIDE, rest = (x * factor ^ y) * factor, base = (rest >> 16 << 16) * factor;
        size_t low = 0, high = STEPS;
        while (low < high) {
            const size_t middle = (low + high) / 2;
            if (multiples[middle].value < -base)
                low = middle + 1;
            else
                high = middle;
        }
        const uint64_t z = low < STEPS ? multiples[low].of ^ (rest & 65535) : SIDE;
        if (z < SIDE && ((rest ^ z) * factor) >> 48 == 0)
            memcpy(places[count++], (double[]){(double)(2 * x + 1), (double)(2 * y + 1), (double)(2 * z + 1)},
                   sizeof *places);
    }
    for (int i = 0; i < 3 * FACES; i++)
        faces[i / 3][i % 3] = i;
    struct soup *soup = soup_made(places, (const int(*)[3])faces, FACES);
    setitimer(ITIMER_VIRTUAL, &(struct itimerval){.it_value.tv_sec = 10}, NULL);
    struct mesh *mesh = mesh_weld(soup, 60);
    setitimer(ITIMER_VIRTUAL, &(struct itimerval){.it_value.tv_sec = 0}, NULL);
    assert_int_equal(mesh->place_count, 3 * FACES);
    mesh_free(mesh);
    soup_free(soup);
    free(multiples);
    free(places);
    free(faces);
}

static void triangles_without_an_area_are_left_out(void **state)
{
    (void)state;
    struct soup *soup = soup_cube();
    memcpy(soup->faces[3].places[1], soup->faces[3].places[0], sizeof soup->faces[3].places[0]);
    for (int k = 0; k < 3; k++)
        soup->faces[5].places[2][k] = (soup->faces[5].places[0][k] + soup->faces[5].places[1][k]) / 2;
    struct mesh *mesh = mesh_weld(soup, 60);
    assert_int_equal(mesh->face_count, 10);
    soup_free(soup);
    mesh_free(mesh);
}

static void a_files_normals_are_kept_and_made_where_they_have_no_direction(void **state)
{
    (void)state;
    struct soup *soup = soup_cube();
    soup->has_normals = true;
    for (size_t i = 0; i < 3 * soup->face_count; i++)
        memcpy(soup->faces[i / 3].normals[i % 3], (double[3]){3, 0, 4}, sizeof(double[3]));
    memset(soup->faces[7].normals[1], 0, sizeof soup->faces[7].normals[1]);
    soup->faces[7].normals[2][0] = NAN;
    struct mesh *mesh = mesh_weld(soup, -1);
    assert_int_equal(mesh->vertex_count, 10);
    assert_false(mesh->has_own_normals);
    for (int k = 1; k < 3; k++) {
        const double *n = mesh->normals[mesh->faces[7][k]];
        assert_near(fabs(n[0]) + fabs(n[1]) + fabs(n[2]), 1, 1e-12);
    }
    assert_near(mesh->normals[mesh->faces[0][0]][2], .8, 1e-12);
    soup_free(soup);
    mesh_free(mesh);
}

/* Half of the smooth cube's edges are creases: on one side of these nothing is to be split, on the other everything. */
static void splitting_leaves_no_t_junction_also_at_creases(void **state)
{
    (void)state;
    struct soup *soup = soup_cube();
    soup->has_normals = true;
    for (size_t i = 0; i < soup->face_count; i++)
        for (int k = 0; k < 3; k++) {
            const struct soup_face *face = &soup->faces[i];
            double flat[3];
            mesh_face_normal(face->places[0], face->places[1], face->places[2], flat);
            memcpy(soup->faces[i].normals[k], i < 6 ? flat : face->places[k], sizeof flat);
        }
    struct mesh *mesh = mesh_weld(soup, -1);
    const double area = area_of(mesh);
    assert_true(mesh->has_own_normals);
    assert_true(widest_turn(mesh) > 100);
    mesh_split(mesh, 30);
    assert_true(widest_turn(mesh) <= 30 + 1e-6);
    assert_closed(mesh);
    assert_near(area_of(mesh), area, 1e-9); /* the surface is where it was */
    soup_free(soup);
    mesh_free(mesh);
}

static void the_teapot_split_turns_by_no_more_than_asked_on_its_old_surface(void **state)
{
    (void)state;
    static const double degrees[] = {180, 45, 30, 10};
    size_t before = 0;
    struct mesh *whole = teapot_split(180);
    assert_int_equal(whole->face_count, 992);
    assert_int_equal(whole->vertex_count, 530);
    for (int i = 0; i < 4; i++) {
        struct mesh *mesh = teapot_split(degrees[i]);
        assert_true(mesh->face_count > before);
        assert_true(degrees[i] == 180 || widest_turn(mesh) <= degrees[i] + 1e-6);
        assert_near(area_of(mesh), area_of(whole), 1e-6);
        before = mesh->face_count;
        mesh_free(mesh);
    }
    mesh_free(whole);
}

static void ordering_keeps_the_triangles_and_spares_the_cache(void **state)
{
    (void)state;
    struct mesh *mesh = teapot_split(30);
    const size_t count = mesh->face_count;
    const double area = area_of(mesh), ordered = misses_of(mesh, 32);
    uint32_t seed = 1;
    for (size_t i = count; i > 1; i--) { /* shuffled */
        uint32_t other[3];
        const size_t j = (seed = seed * 1664525 + 1013904223) % i;
        memcpy(other, mesh->faces[j], sizeof other);
        memcpy(mesh->faces[j], mesh->faces[i - 1], sizeof other);
        memcpy(mesh->faces[i - 1], other, sizeof other);
    }
    assert_true(misses_of(mesh, 32) > 2.5);
    mesh_order(mesh);
    assert_true(ordered < .8 && misses_of(mesh, 32) < .8); /* .5 is the least there can be */
    assert_int_equal(mesh->face_count, count);
    assert_near(area_of(mesh), area, 1e-9);
    mesh_free(mesh);
}

static void a_fitted_mesh_fills_the_range_and_a_unit_keeps_sizes(void **state)
{
    (void)state;
    struct mesh *mesh = teapot_split(30);
    struct fitted *fitted = mesh_fit(mesh, 0), *by_unit = mesh_fit(mesh, 100);
    double farthest = 0;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const int16_t *p = fitted->places[i], *q = by_unit->places[i];
        farthest = fmax(farthest, sqrt((double)p[0] * p[0] + (double)p[1] * p[1] + (double)p[2] * p[2]));
        for (int k = 0; k < 3; k++)
            assert_near(q[k], mesh->places[i][k] * 100, .5);
    }
    assert_near(farthest, 32767, 1);
    fitted_free(fitted);
    fitted_free(by_unit);
    mesh_free(mesh);
}

/* The library's picture against one in double precision, which shares nothing with it but the mesh. */
static void the_library_draws_the_same_triangles_as_double_precision_but_for_edges(void **state)
{
    (void)state;
    static const struct view views[] = {{150, 100, {0, 0, 0}, 1, 0},
                                        {100, 150, {25, -30, 10}, 1.3, 0},
                                        {120, 120, {-70, 200, 45}, 1, 2},
                                        {100, 100, {5, 95, 180}, 4, 6}};
    struct mesh *mesh = teapot_split(30);
    struct fitted *fitted = mesh_fit(mesh, 0);
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        struct mesh_coverage coverage;
        assert_null(view_refusal(&views[i]));
        struct scene *scene = mesh_scene(mesh, fitted, &views[i], NULL, &coverage);
        assert_true(coverage.drawn > 1000);
        if (coverage.different * 20 > coverage.drawn)
            fail_msg("view %zu: %zu of %zu pixels differ", i, coverage.different, coverage.drawn);
        scene_free(scene);
    }
    fitted_free(fitted);
    mesh_free(mesh);
}

/* By normals a little longer than 1: with unit ones it is 44.9 dB, mean .87. */
static void the_teapot_is_48_db_from_normalised_normals(void **state)
{
    (void)state;
    struct mesh *mesh = teapot_split(30);
    struct fitted *fitted = mesh_fit(mesh, 0);
    struct quality rows[QUALITY_ROWS];
    mesh_quality(mesh, fitted, true, rows);
    for (int i = 0; i < QUALITY_ROWS; i++) {
        assert_true(difference_psnr_db(&rows[i].difference) >= 48);
        assert_true(difference_mean(&rows[i].difference) <= .45);
    }
    fitted_free(fitted);
    mesh_free(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mesh_of_any_size_has_the_same_normals),
        cmocka_unit_test(a_vector_without_a_direction_is_told),
        cmocka_unit_test(corners_at_one_place_are_joined_and_a_crease_parts_their_normals),
        cmocka_unit_test(corners_a_little_apart_are_joined_wherever_cells_end),
        cmocka_unit_test(corners_chosen_for_one_list_are_joined_in_little_time),
        cmocka_unit_test(triangles_without_an_area_are_left_out),
        cmocka_unit_test(a_files_normals_are_kept_and_made_where_they_have_no_direction),
        cmocka_unit_test(splitting_leaves_no_t_junction_also_at_creases),
        cmocka_unit_test(the_teapot_split_turns_by_no_more_than_asked_on_its_old_surface),
        cmocka_unit_test(ordering_keeps_the_triangles_and_spares_the_cache),
        cmocka_unit_test(a_fitted_mesh_fills_the_range_and_a_unit_keeps_sizes),
        cmocka_unit_test(the_library_draws_the_same_triangles_as_double_precision_but_for_edges),
        cmocka_unit_test(the_teapot_is_48_db_from_normalised_normals),
    };
    return cmocka_run_group_tests_name("mesh steps", tests, NULL, NULL);
}
