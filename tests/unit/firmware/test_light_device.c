/* SPDX-License-Identifier: MIT
 * The device's side of light_protocol.h: what it takes, what it refuses, and that it writes to its map only. */
#include <stdlib.h>
#include <string.h>

#include "light.h"
#include "light_board.h"

static void send_map(size_t piece)
{
    uint8_t bytes[4 * PIXELS];
    const struct glint_vec normal = {0, 8192, 31727};
    const uint32_t word = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
    for (unsigned i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(word >> 8 * (i % 4));
    assert_true(set(LIGHT_SET_MAP, NULL, 0));
    for (size_t at = 0; at < sizeof bytes; at += piece)
        light_device_bulk(&device, bytes + at, piece < sizeof bytes - at ? piece : sizeof bytes - at);
}

static void send_light(int32_t x)
{
    uint8_t bytes[LIGHT_MESSAGE_BYTES];
    const int32_t to_light[3] = {x, -2, 3};
    light_message_pack(bytes, 99, to_light);
    light_device_bulk(&device, bytes, sizeof bytes);
}

/* ---- tests ---- */

static void material_and_map_in_pieces_of_any_size_make_it_ready(void **state)
{
    for (size_t piece = 1; piece < 4 * PIXELS + 9; piece++) {
        int32_t to_light[3];
        assert_true(enable(1));
        assert_true(set_material(&material));
        send_map(piece);
        assert_true(device.has_map && device.is_new);
        send_light(-7);
        assert_true(light_device_next(&device, to_light));
        assert_int_equal(to_light[0], -7);
        assert_int_equal(to_light[1], -2);
        assert_false(light_device_next(&device, to_light));
        end(state);
        begin(state);
    }
}

static void the_board_draws_the_material_to_the_space_that_came_with_it(void **state)
{
    (void)state;
    struct glint_output output;
    struct glint_paint paint;
    assert_true(enable(1) && set_material(&material));
    light_material_output(&output, &device.material);
    assert_int_equal(output.format, GLINT_RGB565);
    assert_int_equal(output.space, GLINT_LINEAR);
    assert_false(output.dither);
    assert_same(&device.material.material, &material.material);
    assert_int_equal(glint_paint_exact(&paint, &device.material.material, &output), GLINT_OK);
}

static void a_request_with_anything_wrong_is_refused(void **state)
{
    (void)state;
    uint8_t bytes[64] = {1};
    assert_true(enable(1));
    assert_false(set(LIGHT_SET_ENABLE, bytes, 2));
    assert_int_equal(status(), GUD_PROTOCOL);
    assert_false(set(LIGHT_SET_MATERIAL, bytes, LIGHT_MATERIAL_BYTES - 1));
    assert_int_equal(status(), GUD_PROTOCOL);
    assert_false(set(0x7f, bytes, 0));
    assert_int_equal(status(), GUD_UNSUPPORTED);
    struct gud_setup setup = request(GUD_TYPE_IN, GUD_GET_DESCRIPTOR, GUD_DESCRIPTOR_BYTES);
    assert_int_equal(light_device_setup(&device, &setup, reply), GUD_STALL);
    setup = request(GUD_TYPE_IN, LIGHT_SET_MAP, 1);
    assert_int_equal(light_device_setup(&device, &setup, reply), GUD_STALL);
    setup = request(GUD_TYPE_IN, LIGHT_GET_DESCRIPTOR, 0);
    assert_int_equal(light_device_setup(&device, &setup, reply), GUD_STALL);
    assert_int_equal(status(), GUD_PROTOCOL);
    setup = request(0xa1, LIGHT_GET_STATUS, 1); /* of class, not vendor */
    assert_int_equal(light_device_setup(&device, &setup, reply), GUD_STALL);
    setup = request(GUD_TYPE_OUT, LIGHT_SET_MAP, 0);
    setup.value = 1;
    assert_int_equal(light_device_setup(&device, &setup, reply), GUD_STALL);
    setup.value = 0;
    setup.index = 0;
    assert_int_equal(light_device_setup(&device, &setup, reply), GUD_STALL);
    assert_false(enable(2));
    assert_int_equal(status(), GUD_PARAMETER);
    assert_true(device.enabled);
    struct light_material wrong[4] = {material, material, material, material};
    wrong[0].material.model = GLINT_PHONG;
    wrong[1].material.model = GLINT_MODEL_COUNT;
    wrong[2].material.n = 0; /* of which the library makes no paint */
    wrong[3].space = GLINT_LINEAR + 1;
    for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_false(set_material(&wrong[i]));
        assert_int_equal(status(), GUD_PARAMETER);
        assert_false(device.has_material);
    }
    light_material_pack(bytes, &material);
    bytes[5] |= LIGHT_CLAMP_PEAK << 1; /* a flag that there is not */
    assert_false(set(LIGHT_SET_MATERIAL, bytes, LIGHT_MATERIAL_BYTES));
    assert_int_equal(status(), GUD_PARAMETER);
    assert_false(device.has_material);
}

static void any_other_material_makes_a_paint(void **state)
{
    (void)state;
    assert_true(enable(1));
    srand(3);
    for (unsigned round = 0; round < 20000; round++) {
        uint8_t bytes[LIGHT_MATERIAL_BYTES];
        for (unsigned i = 0; i < sizeof bytes; i++)
            bytes[i] = (uint8_t)rand();
        bytes[0] %= 8; /* model, space and flags, or most would be refused */
        bytes[4] %= 3;
        bytes[5] %= 2;
        device.has_material = false;
        if (!set(LIGHT_SET_MATERIAL, bytes, sizeof bytes))
            continue;
        struct glint_output output;
        struct glint_paint paint;
        light_material_output(&output, &device.material);
        assert_int_equal(glint_paint_exact(&paint, &device.material.material, &output), GLINT_OK);
        assert_true(paint.model && device.material.material.model != GLINT_PHONG);
    }
}

static void before_it_is_enabled_it_takes_nothing(void **state)
{
    (void)state;
    assert_false(set_material(&material));
    assert_int_equal(status(), GUD_PROTOCOL);
    assert_false(set(LIGHT_SET_MAP, NULL, 0));
    assert_int_equal(status(), GUD_PROTOCOL);
    light_device_bulk(&device, (uint8_t[]){1, 2, 3, 4}, 4);
    assert_int_equal(map[0], 0);
    assert_false(device.has_material || device.in_map);
}

static void enabled_again_it_forgets_map_and_material(void **state)
{
    (void)state;
    assert_true(enable(1) && set_material(&material));
    send_map(64);
    send_light(1);
    assert_true(enable(1));
    assert_true(device.enabled && !device.has_map && !device.has_material && !device.count);
    assert_true(enable(0));
    assert_false(device.enabled);
}

static void lights_wait_for_material_and_map(void **state)
{
    (void)state;
    int32_t to_light[3];
    assert_true(enable(1));
    send_light(1); /* without a map it is lost, and the status says so */
    assert_int_equal(status(), GUD_PROTOCOL);
    send_map(64);
    send_light(2);
    assert_false(light_device_next(&device, to_light)); /* without a material */
    assert_true(set_material(&material));
    assert_true(light_device_next(&device, to_light));
    assert_int_equal(to_light[0], 2);
}

static void a_new_map_drops_lights_for_the_old_one(void **state)
{
    (void)state;
    int32_t to_light[3];
    assert_true(enable(1) && set_material(&material));
    send_map(64);
    send_light(1);
    light_device_bulk(&device, (uint8_t[5]){0}, 5); /* a third of a light */
    assert_true(set(LIGHT_SET_MAP, NULL, 0));
    assert_false(device.has_map);
    assert_true(light_device_has_room(&device, 2 * LIGHT_QUEUE * LIGHT_MESSAGE_BYTES)); /* a map always has room */
    assert_false(light_device_next(&device, to_light));
    send_map(64);
    assert_false(light_device_next(&device, to_light));
    send_light(2);
    assert_true(light_device_next(&device, to_light));
    assert_int_equal(to_light[0], 2);
}

static void the_board_learns_of_another_material(void **state)
{
    (void)state;
    struct light_material other = material;
    assert_true(enable(1) && set_material(&material));
    send_map(64);
    device.is_new = false;
    other.material.clamp_peak = false;
    assert_true(set_material(&other));
    assert_true(device.is_new);
    assert_false(device.material.material.clamp_peak);
}

static void it_cannot_be_enabled_within_a_rectangle_of_gud(void **state)
{
    (void)state;
    gud.open = true;
    assert_false(enable(1));
    assert_int_equal(status(), GUD_BUSY);
    gud.open = false;
    assert_true(enable(1));
    gud.open = true; /* does not happen; enabling again is harmless */
    assert_true(enable(1));
}

static void a_map_with_a_normal_far_from_unit_length_is_refused(void **state)
{
    (void)state;
    static const uint32_t wrong[] = {0x7fff7f7f, 0x80000001, 0x7fff4000, 0x80018181, 0x00007f7f};
    for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        uint8_t bytes[4 * PIXELS] = {0}; /* no surface */
        for (unsigned k = 0; k < 4; k++)
            bytes[4 * (PIXELS - 1) + k] = (uint8_t)(wrong[i] >> 8 * k);
        assert_true(enable(1));
        assert_true(set(LIGHT_SET_MAP, NULL, 0));
        light_device_bulk(&device, bytes, sizeof bytes);
        /* A normal of length 1 within 2^-15 that looks away is allowed, and so is any word with z = 0: no surface. */
        assert_int_equal(device.has_map, wrong[i] == 0x80000001 || wrong[i] >> 16 == 0);
    }
}

/* Of about unit length: up to sqrt(1 + 1/32). x and y over 128, z over 32768. */
static void each_number_of_each_normal_of_a_map_counts(void **state)
{
    (void)state;
    static const struct {
        int32_t x, y, z;
        bool is_taken;
    } normals[] = {{127, 0, 1, true},     {0, 127, 1, true},      {0, 0, 32767, true},     {-128, 22, 1, true},
                   {-128, -22, 1, true},  {22, -128, 1, true},    {-128, 23, 1, false},    {-128, -23, 1, false},
                   {-23, -128, 1, false}, {127, 0, 23100, false}, {0, 127, 23100, false},  {22, 0, 32767, true},
                   {0, 23, 32767, false}, {-128, 16, 4096, true}, {-128, 16, 4097, false}, {127, 127, 0, true}};
    for (size_t i = 0; i < sizeof normals / sizeof *normals; i++)
        for (uint32_t at = 0; at < PIXELS; at += PIXELS - 1) {
            const uint32_t word = ((uint32_t)normals[i].z << 16) + (uint16_t)(256 * normals[i].y + normals[i].x);
            uint8_t bytes[4 * PIXELS] = {0};
            for (unsigned k = 0; k < 4; k++)
                bytes[4 * at + k] = (uint8_t)(word >> 8 * k);
            assert_true(enable(1) && set(LIGHT_SET_MAP, NULL, 0));
            light_device_bulk(&device, bytes, sizeof bytes);
            assert_int_equal(device.has_map, normals[i].is_taken);
        }
}

static void every_normal_that_the_library_packs_is_taken(void **state)
{
    (void)state;
    srand(1);
    for (unsigned round = 0; round < 2000; round++) {
        const int32_t v[3] = {rand() % 2001 - 1000, rand() % 2001 - 1000, rand() % 1001 - (round % 3 ? 0 : 500)};
        struct glint_vec normal;
        if (glint_vec_normalize(&normal, v) != GLINT_OK)
            continue;
        const uint32_t word = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
        assert_true(enable(1) && set(LIGHT_SET_MAP, NULL, 0));
        for (unsigned i = 0; i < 4 * PIXELS; i++)
            light_device_bulk(&device, &(uint8_t){(uint8_t)(word >> 8 * (i % 4))}, 1);
        assert_true(device.has_map);
    }
}

static void lights_queue_up_and_wait_where_there_is_no_room(void **state)
{
    (void)state;
    int32_t to_light[3];
    assert_true(enable(1) && set_material(&material));
    send_map(64);
    for (int32_t i = 0; i < LIGHT_QUEUE; i++) {
        assert_true(light_device_has_room(&device, LIGHT_MESSAGE_BYTES));
        send_light(i);
    }
    assert_false(light_device_has_room(&device, LIGHT_MESSAGE_BYTES));
    assert_true(light_device_has_room(&device, LIGHT_MESSAGE_BYTES - 1));
    send_light(99); /* a stack that does not wait loses it */
    assert_int_equal(status(), GUD_PROTOCOL);
    for (int32_t i = 0; i < LIGHT_QUEUE; i++) {
        assert_true(light_device_next(&device, to_light));
        assert_int_equal(to_light[0], i);
    }
    assert_false(light_device_next(&device, to_light));
}

static void the_status_is_busy_until_the_last_frame_is_drawn(void **state)
{
    (void)state;
    int32_t to_light[3];
    assert_true(enable(1) && set_material(&material));
    send_map(64);
    assert_int_equal(status(), GUD_OK);
    send_light(1);
    assert_int_equal(status(), GUD_BUSY);
    assert_true(light_device_next(&device, to_light));
    device.is_drawing = true;
    assert_int_equal(status(), GUD_BUSY);
    device.is_drawing = false;
    assert_int_equal(status(), GUD_OK);
}

static void a_reset_forgets_everything(void **state)
{
    (void)state;
    int32_t to_light[3];
    assert_true(enable(1) && set_material(&material));
    send_map(64);
    send_light(1);
    light_device_bulk(&device, (uint8_t[5]){0}, 5);
    light_device_reset(&device);
    assert_int_equal(device.message_bytes, 0);
    assert_false(device.enabled || device.has_map || device.has_material || device.is_new);
    assert_false(light_device_next(&device, to_light));
}

/* So that a board knows of a host that came and went at once. */
static void that_it_was_enabled_outlives_a_reset(void **state)
{
    (void)state;
    assert_true(enable(0));
    assert_false(device.was_enabled);
    assert_true(enable(1));
    light_device_reset(&device);
    assert_true(device.was_enabled && !device.enabled);
    device.was_enabled = false;
    light_device_reset(&device);
    assert_false(device.was_enabled);
}

static void whatever_arrives_only_the_map_is_written(void **state)
{
    (void)state;
    srand(2);
    for (unsigned round = 0; round < 20000; round++) {
        uint8_t bytes[200];
        int32_t to_light[3];
        for (unsigned i = 0; i < sizeof bytes; i++)
            bytes[i] = (uint8_t)rand();
        const struct gud_setup setup = {rand() % 2 ? GUD_TYPE_IN : GUD_TYPE_OUT, (uint8_t)(0x9f + rand() % 6),
                                        rand() % 9 == 0, INTERFACE, (uint16_t)(rand() % 3 ? 1 : rand() % 70)};
        bytes[0] = bytes[0] % 3;
        if (light_device_setup(&device, &setup, reply) != GUD_STALL && setup.type == GUD_TYPE_OUT)
            light_device_set(&device, &setup, bytes);
        light_device_bulk(&device, bytes, (size_t)rand() % sizeof bytes);
        assert_true(device.count <= LIGHT_QUEUE && device.message_bytes < LIGHT_MESSAGE_BYTES);
        light_device_next(&device, to_light);
    }
}

static enum light_sense answer;
static enum light_sense sensed(int32_t to_light[3])
{
    if (answer == LIGHT_SENSED)
        to_light[0] = -5, to_light[1] = 1 << 20, to_light[2] = 8192;
    return answer;
}

static void a_host_that_asks_for_the_rooms_light_changes_nothing(void **state)
{
    (void)state;
    const struct gud_setup ask = request(GUD_TYPE_IN, LIGHT_GET_LIGHT, LIGHT_MESSAGE_BYTES);
    int32_t to_light[3] = {7, 7, 7};
    assert_int_equal(light_device_setup(&device, &ask, reply), LIGHT_MESSAGE_BYTES);
    assert_int_equal(light_message_unpack(to_light, reply), LIGHT_NO_SENSOR);
    device.sense = sensed;
    for (answer = LIGHT_NO_SENSOR; answer <= LIGHT_SENSED; answer++) {
        const bool is_sensed = answer == LIGHT_SENSED;
        assert_int_equal(light_device_setup(&device, &ask, reply), LIGHT_MESSAGE_BYTES);
        assert_int_equal(light_message_unpack(to_light, reply), answer);
        assert_true(to_light[0] == (is_sensed ? -5 : 0) && to_light[1] == (is_sensed ? 1 << 20 : 0));
        assert_true(!device.enabled && !device.was_enabled && status() == GUD_OK);
    }
    struct gud_setup wrong = ask;
    wrong.length = 3; /* as much as is asked for */
    assert_int_equal(light_device_setup(&device, &wrong, reply), 3);
    wrong.value = 1;
    assert_int_equal(light_device_setup(&device, &wrong, reply), GUD_STALL);
    assert_int_equal(status(), GUD_PARAMETER);
    wrong = request(GUD_TYPE_OUT, LIGHT_GET_LIGHT, LIGHT_MESSAGE_BYTES);
    assert_int_equal(light_device_setup(&device, &wrong, reply), GUD_STALL);
    assert_false(light_device_set(&device, &wrong, reply));
}

/* ---- the light of what the board shows by itself ---- */

static bool give(uint32_t first, int32_t x, int32_t y, int32_t z)
{
    uint8_t bytes[LIGHT_MESSAGE_BYTES];
    const int32_t to_light[3] = {x, y, z};
    light_message_pack(bytes, first, to_light);
    return set(LIGHT_SET_LIGHT, bytes, sizeof bytes);
}

static void a_light_that_is_given_holds_for_its_time_after_the_last_and_the_clock_may_wrap(void **state)
{
    (void)state;
    enum { HELD_US = 1000 * LIGHT_HELD_MS };
    uint32_t now_us = (uint32_t)-HELD_US / 2 + HELD_US - 7; /* wraps on the way */
    light_device_time(&device, now_us);
    assert_false(device.is_given);
    assert_true(give(0, INT32_MIN, -2, INT32_MAX) && status() == GUD_OK);
    assert_true(device.is_given && device.given[0] == INT32_MIN && device.given[2] == INT32_MAX);
    assert_true(!device.enabled && !device.was_enabled && !device.is_new);
    light_device_time(&device, now_us += 5);
    light_device_time(&device, now_us += HELD_US - 1);
    assert_true(device.is_given);
    assert_true(give(0, 1, 2, 3));
    light_device_time(&device, now_us);
    light_device_time(&device, now_us += HELD_US - 1);
    assert_true(device.is_given && device.given[2] == 3);
    light_device_time(&device, now_us += 1);
    assert_false(device.is_given);
}

/* So often do the timers of a page come that is not seen. */
static void a_light_that_comes_once_a_second_is_held_even_where_one_is_missing(void **state)
{
    (void)state;
    uint32_t now_us = 7;
    assert_true(give(0, 1, 2, 3));
    light_device_time(&device, now_us);
    light_device_time(&device, now_us += 2400000);
    assert_true(device.is_given);
    light_device_time(&device, now_us += 100000);
    assert_false(device.is_given);
}

static void no_light_is_given_to_a_panel_that_is_a_hosts_nor_one_without_a_direction(void **state)
{
    (void)state;
    assert_true(!give(1, 1, 2, 3) && status() == GUD_PARAMETER);
    assert_true(!give(0, 0, 0, 0) && status() == GUD_PARAMETER);
    assert_true(!give(0, 0, 0, -1) && status() == GUD_PARAMETER);            /* straight from behind */
    assert_true(!give(0, 64, -64, -(1 << 30)) && status() == GUD_PARAMETER); /* 2^-24 beside it, and a little more */
    assert_true(give(0, 65, 0, -(1 << 30)));
    assert_true(!give(0, 1, 0, INT32_MIN) && status() == GUD_PARAMETER);
    assert_true(give(0, 0, 0, 1) && give(0, 0, 1, -1) && give(0, 1, 0, -(1 << 23)) && give(0, 1, 0, 0));
    light_device_reset(&device);
    assert_true(enable(1));
    assert_true(!give(0, 1, 2, 3) && status() == GUD_PROTOCOL);
    assert_true(enable(0));
    gud.open = true;
    assert_true(!give(0, 1, 2, 3) && status() == GUD_BUSY && !device.is_given);
    gud.open = false;
    assert_true(give(0, 1, 2, 3));
    struct gud_setup wrong = request(GUD_TYPE_OUT, LIGHT_SET_LIGHT, LIGHT_MESSAGE_BYTES - 1);
    assert_int_equal(light_device_setup(&device, &wrong, reply), GUD_STALL);
    wrong = request(GUD_TYPE_IN, LIGHT_SET_LIGHT, LIGHT_MESSAGE_BYTES);
    assert_int_equal(light_device_setup(&device, &wrong, reply), GUD_STALL);
    assert_true(device.is_given && device.given[2] == 3);
    light_device_reset(&device);
    assert_false(device.is_given);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(material_and_map_in_pieces_of_any_size_make_it_ready, begin, end),
        cmocka_unit_test_setup_teardown(the_board_draws_the_material_to_the_space_that_came_with_it, begin, end),
        cmocka_unit_test_setup_teardown(a_request_with_anything_wrong_is_refused, begin, end),
        cmocka_unit_test_setup_teardown(before_it_is_enabled_it_takes_nothing, begin, end),
        cmocka_unit_test_setup_teardown(enabled_again_it_forgets_map_and_material, begin, end),
        cmocka_unit_test_setup_teardown(lights_wait_for_material_and_map, begin, end),
        cmocka_unit_test_setup_teardown(a_new_map_drops_lights_for_the_old_one, begin, end),
        cmocka_unit_test_setup_teardown(the_board_learns_of_another_material, begin, end),
        cmocka_unit_test_setup_teardown(it_cannot_be_enabled_within_a_rectangle_of_gud, begin, end),
        cmocka_unit_test_setup_teardown(a_map_with_a_normal_far_from_unit_length_is_refused, begin, end),
        cmocka_unit_test_setup_teardown(each_number_of_each_normal_of_a_map_counts, begin, end),
        cmocka_unit_test_setup_teardown(every_normal_that_the_library_packs_is_taken, begin, end),
        cmocka_unit_test_setup_teardown(lights_queue_up_and_wait_where_there_is_no_room, begin, end),
        cmocka_unit_test_setup_teardown(the_status_is_busy_until_the_last_frame_is_drawn, begin, end),
        cmocka_unit_test_setup_teardown(a_reset_forgets_everything, begin, end),
        cmocka_unit_test_setup_teardown(any_other_material_makes_a_paint, begin, end),
        cmocka_unit_test_setup_teardown(that_it_was_enabled_outlives_a_reset, begin, end),
        cmocka_unit_test_setup_teardown(whatever_arrives_only_the_map_is_written, begin, end),
        cmocka_unit_test_setup_teardown(a_host_that_asks_for_the_rooms_light_changes_nothing, begin, end),
        cmocka_unit_test_setup_teardown(a_light_that_is_given_holds_for_its_time_after_the_last_and_the_clock_may_wrap,
                                        begin, end),
        cmocka_unit_test_setup_teardown(a_light_that_comes_once_a_second_is_held_even_where_one_is_missing, begin, end),
        cmocka_unit_test_setup_teardown(no_light_is_given_to_a_panel_that_is_a_hosts_nor_one_without_a_direction, begin,
                                        end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
