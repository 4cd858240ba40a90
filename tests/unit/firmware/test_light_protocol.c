/* SPDX-License-Identifier: MIT
 * The messages of light_protocol.h, byte for byte. */
#include <string.h>

#include "light.h"

static void what_is_packed_unpacks_to_the_same(void **state)
{
    (void)state;
    uint8_t bytes[LIGHT_MATERIAL_BYTES];
    struct light_material again;
    light_material_pack(bytes, &material);
    memset(&again, 0xee, sizeof again);
    assert_true(light_material_unpack(&again, bytes));
    assert_int_equal(again.material.n_across, 0);
    assert_int_equal(again.space, material.space);
    assert_int_equal(again.background, material.background);
    assert_same(&again.material, &material.material);
    struct light_descriptor descriptor = {240, 320};
    light_descriptor_pack(bytes, &descriptor);
    descriptor = (struct light_descriptor){0, 0};
    assert_true(light_descriptor_unpack(&descriptor, bytes));
    assert_int_equal(descriptor.width, 240);
    assert_int_equal(descriptor.height, 320);
    bytes[4]++;
    assert_false(light_descriptor_unpack(&descriptor, bytes));
}

/* As documented for other hosts, which a change of both sides at once would break. */
static void the_bytes_on_the_wire_are_those_documented(void **state)
{
    (void)state;
    static const uint8_t fields[] = {GLINT_MSH,       6, 60, 0, GLINT_LINEAR,
                                     LIGHT_CLAMP_PEAK};                 /* model, q, n, space, flags */
    static const char others[] = "\xcd\xab"                             /* background */
                                 "\x09\x0a\x0b\0"                       /* albedo */
                                 "\1\0\0\0\2\0\0\0\3\0\0\0"             /* ambient */
                                 "\x40\x9c\0\0\x50\xc3\0\0\x60\xea\0\0" /* diffuse */
                                 "\0\0\1\0\7\0\0\0\x08\0\0"; /* specular; the literal's end is its last byte */
    uint8_t bytes[LIGHT_MATERIAL_BYTES];
    memset(bytes, 0xee, sizeof bytes);
    light_material_pack(bytes, &material);
    assert_int_equal(sizeof fields + sizeof others, LIGHT_MATERIAL_BYTES);
    assert_memory_equal(bytes, fields, sizeof fields);
    assert_memory_equal(bytes + sizeof fields, others, sizeof others);
    light_message_pack(bytes, 0x01020304, (const int32_t[]){-2, 0x0a0b0c0d, INT32_MIN});
    assert_memory_equal(bytes, "\x04\x03\x02\x01\xfe\xff\xff\xff\x0d\x0c\x0b\x0a\0\0\0\x80", LIGHT_MESSAGE_BYTES);
    struct light_descriptor descriptor = {0x0102, 0x0304};
    light_descriptor_pack(bytes, &descriptor);
    assert_memory_equal(bytes, "glnt\1\0\0\0\2\1\4\3", LIGHT_DESCRIPTOR_BYTES);
    bytes[3]++;
    assert_false(light_descriptor_unpack(&descriptor, bytes));
    const struct light_mesh mesh = {.cksum = 0x01020304, .vertices = 0x0506, .faces = 0x0708, .split = 9};
    light_mesh_pack(bytes, &mesh);
    assert_memory_equal(bytes, "\x04\x03\x02\x01\x06\x05\x08\x07\x09\0\0\0", LIGHT_MESH_BYTES);
}

static void what_goes_over_the_wire_is_taken_from_a_material_and_an_output(void **state)
{
    (void)state;
    struct glint_material from = material.material;
    const struct glint_output output = {.format = GLINT_RGB565, .space = GLINT_LINEAR};
    from.model = GLINT_LYON;
    from.n = from.n_across = 300;
    from.q = 7;
    struct light_material of_both;
    light_material_of(&of_both, &from, &output);
    assert_same(&of_both.material, &from);
    assert_int_equal(of_both.material.n_across, 0);
    assert_int_equal(of_both.space, GLINT_LINEAR);
    assert_int_equal(of_both.background, 0);
}

static void flags_that_there_are_not_are_told(void **state)
{
    (void)state;
    uint8_t bytes[LIGHT_MATERIAL_BYTES];
    struct light_material again;
    light_material_pack(bytes, &material);
    bytes[5] = 0;
    assert_true(light_material_unpack(&again, bytes));
    assert_false(again.material.clamp_peak);
    bytes[5] = LIGHT_CLAMP_PEAK << 1;
    assert_false(light_material_unpack(&again, bytes));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_packed_unpacks_to_the_same),
        cmocka_unit_test(the_bytes_on_the_wire_are_those_documented),
        cmocka_unit_test(what_goes_over_the_wire_is_taken_from_a_material_and_an_output),
        cmocka_unit_test(flags_that_there_are_not_are_told),
    };
    return cmocka_run_group_tests_name("light protocol", tests, NULL, NULL);
}
