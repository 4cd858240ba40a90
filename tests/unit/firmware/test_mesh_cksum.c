/* SPDX-License-Identifier: MIT
 * The sum by which a host and a device know that they hold the same mesh, bit by bit as POSIX has cksum. */
#include <string.h>

#include "unit.h"

#include "mesh_cksum.h"

static const int16_t places[9] = {1, -2, 300, -400, 32767, -32768, 0, 7, 256};
static const int8_t normals[9] = {0, 0, 127, -127, 1, -1, 5, 6, 7};
static const uint16_t faces[6] = {0, 1, 2, 2, 1, 0};
static const struct glint_mesh mesh = {
    .places = places, .normals8 = normals, .faces = faces, .vertex_count = 3, .face_count = 2};

static uint32_t posix(const uint8_t *bytes, size_t count)
{
    uint32_t sum = 0;
    for (size_t i = 0; i < 8 * count + 8 * 8; i++) { /* then its length, lowest byte first, as few bytes as it takes */
        const size_t at = i / 8;
        const size_t length = at < count ? 0 : count >> (8 * (at - count));
        if (at >= count && length == 0)
            break;
        const unsigned byte = at < count ? bytes[at] : (unsigned)(length & 255);
        const uint32_t top = sum >> 31 ^ (byte >> (7 - i % 8) & 1);
        sum = sum << 1 ^ (top ? UINT32_C(0x04c11db7) : 0);
    }
    return ~sum;
}

static void a_mesh_s_sum_is_that_of_its_file(void **state)
{
    (void)state;
    uint8_t file[9 * 2 + 10 + 6 * 2] = {0};
    for (int i = 0; i < 9; i++) {
        file[2 * i] = (uint8_t)((uint16_t)places[i] & 255);
        file[2 * i + 1] = (uint8_t)((uint16_t)places[i] >> 8);
        file[18 + i] = (uint8_t)normals[i];
    }
    for (int i = 0; i < 6; i++)
        file[28 + 2 * i] = (uint8_t)faces[i];
    assert_int_equal(mesh_cksum(&mesh), posix(file, sizeof file));
}

/* An even number of normals is followed by no byte of 0. */
static void four_vertices_have_the_sum_of_their_file(void **state)
{
    (void)state;
    static const int16_t four_places[12] = {0};
    static const int8_t four_normals[12] = {0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127};
    static const struct glint_mesh four = {
        .places = four_places, .normals8 = four_normals, .faces = faces, .vertex_count = 4, .face_count = 2};
    uint8_t file[12 * 2 + 12 + 6 * 2] = {0};
    memcpy(file + 24, four_normals, 12);
    for (int i = 0; i < 6; i++)
        file[36 + 2 * i] = (uint8_t)faces[i];
    assert_int_equal(mesh_cksum(&four), posix(file, sizeof file));
}

static void each_part_of_a_mesh_changes_its_sum(void **state)
{
    (void)state;
    const uint32_t sum = mesh_cksum(&mesh);
    struct glint_mesh other = mesh;
    int16_t other_places[9];
    int8_t other_normals[9];
    uint16_t other_faces[6];
    memcpy(other_places, places, sizeof places);
    memcpy(other_normals, normals, sizeof normals);
    memcpy(other_faces, faces, sizeof faces);
    other_places[8] ^= 256;
    other_normals[8] ^= 1;
    other_faces[5] = 1;
    other.places = other_places;
    assert_int_not_equal(mesh_cksum(&other), sum);
    other = mesh;
    other.normals8 = other_normals;
    assert_int_not_equal(mesh_cksum(&other), sum);
    other = mesh;
    other.faces = other_faces;
    assert_int_not_equal(mesh_cksum(&other), sum);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mesh_s_sum_is_that_of_its_file),
        cmocka_unit_test(four_vertices_have_the_sum_of_their_file),
        cmocka_unit_test(each_part_of_a_mesh_changes_its_sum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
