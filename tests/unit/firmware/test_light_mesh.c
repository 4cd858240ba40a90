/* SPDX-License-Identifier: MIT
 * light_device.c with a mesh: poses, and what a device without a mesh or without maps answers. */
#include <string.h>

#include "light.h"
#include "light_board.h"

static void poses_of_28_bytes_turn_the_mesh_that_it_holds(void **state)
{
    (void)state;
    static const struct light_mesh mesh = {0xfedcba98, 530, 992, 180};
    const struct light_pose pose = {{{1, -2, 32767, -32768}, {5, -6, 32767}, 65535}, {-32768, 8, 9}};
    struct light_mesh told;
    struct light_pose taken;
    struct {
        uint8_t message[LIGHT_POSE_BYTES], behind[4];
    } packed = {.behind = "123"};
    uint8_t *const message = packed.message;
    int32_t to_light[3];
    device.mesh = &mesh;
    const struct gud_setup ask = request(GUD_TYPE_IN, LIGHT_GET_MESH, LIGHT_MESH_BYTES);
    assert_int_equal(light_device_setup(&device, &ask, reply), LIGHT_MESH_BYTES);
    light_mesh_unpack(&told, reply);
    assert_true(told.cksum == mesh.cksum && told.vertices == 530 && told.faces == 992 && told.split == 180);
    assert_false(set(LIGHT_SET_MESH, "", 0));
    assert_true(enable(1));
    assert_true(set_material(&material));
    assert_true(set(LIGHT_SET_MESH, "", 0));
    light_pose_pack(message, 77, &pose);
    assert_memory_equal(packed.behind, "123", 4);
    for (unsigned i = 0; i < LIGHT_POSE_BYTES; i++) /* byte by byte */
        light_device_bulk(&device, &message[i], 1);
    assert_false(light_device_next(&device, to_light));
    assert_true(light_device_next_pose(&device, &taken));
    assert_memory_equal(taken.pose.turn, pose.pose.turn, sizeof pose.pose.turn);
    assert_memory_equal(taken.pose.position, pose.pose.position, sizeof pose.pose.position);
    assert_memory_equal(taken.to_light, pose.to_light, sizeof pose.to_light);
    assert_int_equal(taken.pose.scale, 65535);
    assert_false(light_device_next_pose(&device, &taken));
    message[LIGHT_POSE_BYTES - 1] = 1;
    light_device_bulk(&device, message, LIGHT_POSE_BYTES);
    assert_int_equal(status(), GUD_PARAMETER);
    assert_false(light_device_next_pose(&device, &taken));
}

static void a_device_without_a_mesh_or_without_maps_refuses_them(void **state)
{
    (void)state;
    const struct gud_setup ask = request(GUD_TYPE_IN, LIGHT_GET_MESH, LIGHT_MESH_BYTES);
    assert_true(enable(1));
    assert_int_equal(light_device_setup(&device, &ask, reply), GUD_STALL);
    assert_int_equal(status(), GUD_UNSUPPORTED);
    assert_false(set(LIGHT_SET_MESH, "", 0));
    device.map = NULL;
    assert_false(set(LIGHT_SET_MAP, "", 0));
    assert_int_equal(status(), GUD_UNSUPPORTED);
    struct gud_setup setup = request(GUD_TYPE_OUT, LIGHT_SET_MESH, 0); /* a stack that did not ask first */
    assert_false(light_device_set(&device, &setup, reply));
    setup.request = LIGHT_GET_STATUS;
    assert_int_equal(light_device_setup(&device, &setup, reply), GUD_STALL);
    assert_false(light_device_set(&device, &setup, reply));
    assert_int_equal(status(), GUD_UNSUPPORTED);
}

static void a_pose_waits_for_the_material_and_a_light_is_no_pose(void **state)
{
    (void)state;
    static const struct light_mesh mesh = {1, 2, 3, 180};
    struct light_pose pose = {{{1, 0, 0, 0}, {0, 0, 0}, 100}, {0, 0, 1}};
    uint8_t message[LIGHT_POSE_BYTES], light[LIGHT_MESSAGE_BYTES];
    device.mesh = &mesh;
    assert_true(enable(1) && set(LIGHT_SET_MESH, "", 0));
    light_pose_pack(message, 1, &pose);
    light_device_bulk(&device, message, sizeof message);
    assert_int_equal(device.count, 1);
    assert_false(light_device_next_pose(&device, &pose));
    assert_true(set_material(&material));
    assert_true(light_device_next_pose(&device, &pose));
    assert_true(set(LIGHT_SET_MAP, "", 0));
    for (unsigned i = 0; i < PIXELS; i++)
        light_device_bulk(&device, (const uint8_t[4]){0}, 4);
    light_message_pack(light, 2, (const int32_t[3]){0, 0, 1});
    light_device_bulk(&device, light, sizeof light);
    assert_int_equal(device.count, 1);
    assert_false(light_device_next_pose(&device, &pose));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(poses_of_28_bytes_turn_the_mesh_that_it_holds, begin, end),
        cmocka_unit_test_setup_teardown(a_device_without_a_mesh_or_without_maps_refuses_them, begin, end),
        cmocka_unit_test_setup_teardown(a_pose_waits_for_the_material_and_a_light_is_no_pose, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
