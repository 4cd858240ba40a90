/* SPDX-License-Identifier: MIT
 * --shade device: what a device is sent, and what it cannot draw. */
#include "files.h"

#include "bake/bake.h"
#include "draw/shading_device.h"
#include "scene/scene.h"
#if GLINT_WITH_USB
#include "gud_protocol.h"
#include "sinks/usb/find.h"
#include "sinks/usb/light.h"
#endif
#include "stream/device.h"

enum { WIDTH = 12, HEIGHT = 7, PIXELS = WIDTH * HEIGHT };

static struct scene *scene;
static struct shading shading;

static int begin(void **state)
{
    (void)state;
    scene = scene_new(WIDTH, HEIGHT);
    shading = (struct shading){.model = GLINT_MSH,
                               .n = 60,
                               .q = 6,
                               .lamps = {{.kind = LAMP_DIRECTIONAL, .direction = {-1, .5, 2}, .color = {1, 1, 1}}},
                               .lamp_count = 1,
                               .view = {0, 0, 1},
                               .ambient = {.1, .1, .1},
                               .diffuse = {.5, .5, .5},
                               .specular = {.25, .5, 1},
                               .color = {1, 2, 3},
                               .format = GLINT_RGB565};
    return 0;
}

static int end(void **state)
{
    (void)state;
    scene_free(scene);
    return 0;
}

static void assert_unfit(const char *part)
{
    struct light_material material;
    const char *refusal = device_refusal(scene, &shading, &material);
    assert_non_null(refusal);
    assert_contains(refusal, part);
}

/* ---- a device ---- */

static struct light_material got;
static uint32_t words[PIXELS];
static int32_t to[3];

static enum sink_result take_scene(struct sink *sink, const struct light_material *material, const uint32_t *normals)
{
    (void)sink;
    got = *material;
    memcpy(words, normals, sizeof words);
    return SINK_SENT;
}

static enum sink_result take_light(struct sink *sink, const int32_t to_light[3], size_t *bytes)
{
    (void)sink;
    memcpy(to, to_light, sizeof to);
    *bytes = 16;
    return SINK_SENT;
}

static enum sink_result tell_light(struct sink *sink, int32_t to_light[3])
{
    (void)sink;
    memcpy(to_light, (int32_t[]){-16384, 0, 28378}, 3 * sizeof *to_light);
    return SINK_SENT;
}

static const struct sink_shader shading_device = {
    .send_scene = take_scene, .send_light = take_light, .read_light = tell_light};
static const struct sink_kind kind = {.name = "test", .shader = &shading_device};
static struct sink device = {.kind = &kind, .width = WIDTH, .height = HEIGHT, .format = GLINT_RGB565};

/* ---- tests ---- */

static void a_device_gets_the_normals_the_material_and_the_light(void **state)
{
    (void)state;
    struct plan_result result;
    assert_int_equal(device_send_scene(&device, scene, &shading), SINK_SENT);
    struct baked *baked = bake(scene, BAKE_INT8, 0);
    assert_memory_equal(words, baked->words, sizeof words);
    baked_free(baked);
    assert_int_equal(got.material.n, 60);
    assert_int_equal(got.material.specular_q16[0], 16384);
    assert_int_equal(got.material.albedo[2], 3);
    assert_int_equal(got.space, GLINT_GAMMA);
    assert_int_equal(device_send_light(&device, &shading, &result), SINK_SENT);
    assert_int_equal(to[0], -(1 << 29));
    assert_int_equal(to[1], 1 << 28);
    assert_int_equal(to[2], 1 << 30);
    assert_int_equal(result.bytes, 16);
    assert_int_equal(result.whole_bytes, 2 * PIXELS);
}

static void a_device_that_tells_the_light_gets_it_back(void **state)
{
    (void)state;
    struct plan_result result;
    assert_int_equal(device_read_light(&device, &shading), SINK_SENT);
    assert_int_equal(device_send_light(&device, &shading, &result), SINK_SENT);
    assert_true(to[1] == 0 && to[2] > 0 && llabs((int64_t)to[0] * 28378 + (int64_t)to[2] * 16384) < 65536);
}

static void one_colour_may_come_from_the_albedo(void **state)
{
    (void)state;
    static uint8_t albedo[3 * PIXELS], mask[PIXELS];
    struct light_material material;
    for (size_t i = 0; i < PIXELS; i++) {
        const bool drawn = i % 3 != 0;
        mask[i] = drawn ? 255 : 0;
        memcpy(&albedo[3 * i], drawn ? (uint8_t[]){7, 8, 9} : (uint8_t[]){(uint8_t)i, 0, 0}, 3);
    }
    scene->albedo = albedo;
    scene->mask = mask;
    const char *refusal = device_refusal(scene, &shading, &material);
    albedo[3 * 4] = 6;
    struct light_material unused;
    const char *other = device_refusal(scene, &shading, &unused);
    scene->albedo = NULL; /* not the scene's to free */
    scene->mask = NULL;
    assert_null(refusal);
    assert_memory_equal(material.material.albedo, ((uint8_t[]){7, 8, 9}), 3);
    assert_non_null(other);
    assert_contains(other, "one colour");
}

static void a_gloss_map_is_refused_unless_it_is_white(void **state)
{
    (void)state;
    static uint8_t gloss[PIXELS];
    struct light_material material;
    memset(gloss, 255, sizeof gloss);
    scene->gloss = gloss;
    const char *white = device_refusal(scene, &shading, &material);
    gloss[PIXELS - 1] = 254;
    const char *grey = device_refusal(scene, &shading, &material);
    scene->gloss = NULL;
    assert_null(white);
    assert_non_null(grey);
    assert_contains(grey, "gloss");
}

static void soft_edges_a_background_and_what_filter_makes_are_refused(void **state)
{
    (void)state;
    static uint8_t shininess[PIXELS], mask[PIXELS], backdrop[3 * PIXELS];
    struct light_material material;
    memset(mask, 255, sizeof mask);
    mask[0] = 0;
    scene->mask = mask;
    const char *hard = device_refusal(scene, &shading, &material);
    mask[1] = 254;
    const char *soft = device_refusal(scene, &shading, &material);
    mask[1] = 0;
    scene->backdrop = backdrop;
    const char *over = device_refusal(scene, &shading, &material);
    scene->mask = NULL;
    const char *whole = device_refusal(scene, &shading, &material); /* none is seen */
    scene->backdrop = NULL;
    scene->shininess = shininess;
    const char *filtered = device_refusal(scene, &shading, &material);
    scene->shininess = NULL;
    assert_null(hard);
    assert_null(whole);
    assert_contains(soft, "soft edges");
    assert_contains(over, "--background");
    assert_contains(filtered, "--filter");
}

static void what_the_tables_cannot_do_is_refused(void **state)
{
    (void)state;
    shading.model = GLINT_PHONG;
    assert_unfit("phong");
    shading.model = GLINT_MSH;
    shading.dither = true;
    assert_unfit("dither");
    shading.dither = false;
    shading.view[0] = 1;
    assert_unfit("--view");
    shading.view[0] = 0;
    shading.lamps[0].color[1] = .5;
    assert_unfit("--light");
    shading.lamps[0].color[1] = 1;
    shading.path = 1;
    assert_unfit("--path");
}

#if GLINT_WITH_USB
static void the_name_of_a_device_keeps_within_its_room(void **state)
{
    (void)state;
    static const uint8_t ports[8] = {255, 255, 255, 255, 255, 255, 255, 255};
    char text[USB_PATH_ROOM + 4];
    memset(text, 'x', sizeof text);
    assert_true(usb_path_text(1, (uint8_t[]){3, 1}, 2, text, USB_PATH_ROOM));
    assert_string_equal(text, "1-3.1");
    assert_true(usb_path_text(255, ports, 7, text, USB_PATH_ROOM)); /* the most that USB has */
    assert_string_equal(text, "255-255.255.255.255.255.255.255");
    assert_false(usb_path_text(255, ports, 8, text, USB_PATH_ROOM));
    assert_memory_equal(text + USB_PATH_ROOM, "xxxx", 4);
    for (size_t size = 1; size < USB_PATH_ROOM; size++) {
        memset(text, 'x', sizeof text);
        assert_false(usb_path_text(255, ports, 7, text, size));
        assert_int_equal(text[size], 'x');
    }
    assert_false(usb_path_text(1, ports, 0, text, USB_PATH_ROOM)); /* a root hub */
}

static void a_device_of_more_pixels_than_glint_shades_is_refused(void **state)
{
    (void)state;
    char line[200];
    const struct sink_wish wish = {.format = -1};
    const struct light_descriptor largest = {.width = 8192, .height = 4096}, wide = {.width = 16385, .height = 1},
                                  many = {.width = 8192, .height = 4097}, most = {.width = 65535, .height = 65535};
    assert_true(usb_light_fits(&largest, &wish, "usb 1-1", line, sizeof line));
    assert_false(usb_light_fits(&wide, &wish, "usb 1-1", line, sizeof line));
    assert_false(usb_light_fits(&many, &wish, "usb 1-1", line, sizeof line));
    assert_false(usb_light_fits(&most, &wish, "usb 1-1", line, sizeof line));
    assert_string_equal(line,
                        "usb 1-1: its 65535x65535 pixels are too many; the most is 16384 a side and 33554432 in all");
}

static void a_board_that_knows_no_light_is_refused_with_a_reason(void **state)
{
    (void)state;
    int32_t to_light[3];
    uint8_t bytes[LIGHT_MESSAGE_BYTES];
    light_message_pack(bytes, LIGHT_SENSED, (int32_t[]){-5, 1 << 20, 8192});
    assert_null(usb_light_refusal(to_light, sizeof bytes, bytes));
    assert_true(to_light[0] == -5 && to_light[1] == 1 << 20 && to_light[2] == 8192);
    assert_contains(usb_light_refusal(to_light, -1, bytes), "too old"); /* STALL */
    assert_contains(usb_light_refusal(to_light, 4, bytes), "too old");
    for (uint32_t sense = 0; sense < 5; sense++) { /* the last two are none that there is; SENSED without a light */
        light_message_pack(bytes, sense, (int32_t[]){sense > LIGHT_SENSED, 0, 0});
        assert_contains(usb_light_refusal(to_light, sizeof bytes, bytes),
                        sense ? "does not answer" : "no accelerometer");
    }
}

static void a_board_that_takes_no_light_for_its_own_picture_is_refused_with_a_reason(void **state)
{
    (void)state;
    assert_null(usb_demo_refusal(GUD_BUSY));
    assert_contains(usb_demo_refusal(GUD_UNSUPPORTED), "too old");
    assert_contains(usb_demo_refusal(GUD_PROTOCOL), "another program");
    assert_contains(usb_demo_refusal(GUD_PARAMETER), "straight from behind");
    assert_contains(usb_demo_refusal(99), "refuses");
}
#endif

static void what_does_not_reach_the_boards_own_picture_is_refused_by_its_name(void **state)
{
    (void)state;
    static const char *const options[][2] = {{"--material gold", "leave --material out"},
                                             {"--mat=gold", "leave --material out"},
                                             {"-n 9", "leave -n out"},
                                             {"-q8", "leave -q out"},
                                             {"--serial -q8 -n 9", "leave -n out"}, /* a value is no option */
                                             {"-o --albedo -n 9", "leave -n out"},
                                             {"--color 1,2,3", "leave --color out"},
                                             {"--view 0,1,1", "leave --view out"},
                                             {"--size 20x20", "leave --size out"},
                                             {"--background red.png", "leave --background out"},
                                             {"--turn 1,2,3", "leave --turn out"}, /* also where it lacks a mesh */
                                             {"--bevel 3", "leave --bevel out"},
                                             {"--albedo no.png --color 1,2,3", "leave --albedo out"},
                                             {"--turn 1,2,3 --mesh a.stl", "leave the scene out"},
                                             {"--cut-out coin", "leave the scene out"},
                                             {"--lights board", "leave --lights board out"},
                                             {"--albedo no.png", "leave --albedo out"},
                                             {"--light=1,2,3,1,.5,1", "leave the colour of --light out"}};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT stream --to usb --shade demo --orbit 9 --frames 2 %s", options[i][0]);
        assert_one_line(assert_ends(line, 2, options[i][1])->err);
    }
    assert_ends("$GLINT stream --to none --shade demo --light 0,1,1 --lights - --stats --fps 9", 2, "no device of");
}

static void the_command_line_tells_what_can_shade(void **state)
{
    (void)state;
    assert_one_line(assert_ends("$GLINT stream coin --to none --shade device", 2, "--to usb")->err);
    assert_one_line(assert_ends("$GLINT stream coin --to none --shade gpu", 2, "host, device, demo")->err);
    assert_one_line(assert_ends("$GLINT stream coin --to usb --shade demo", 2, "leave the scene out")->err);
    assert_one_line(assert_ends("$GLINT stream --to usb --shade demo --lights board", 2, "--shade device")->err);
    assert_one_line(
        assert_ends("$GLINT stream --to usb --shade demo --light=1,2,3 --light=-1,2,3", 2, "one --light")->err);
    assert_one_line(assert_ends("$GLINT stream --to none --frames 1 --shade demo", 2, "--to usb")->err);
    assert_one_line(
        assert_ends("$GLINT stream --to usb --shade demo --fps .5", 2, "may come late; give --fps 1 or more")->err);
    assert_one_line(assert_ends("$GLINT stream --to none --frames 1", 2, "no surface")->err);
    assert_one_line(assert_ends("$GLINT stream coin --to none --frames 1 --lights board", 2, "--shade device")->err);
    assert_one_line(
        assert_ends("$GLINT stream coin --to usb --shade device --lights board --orbit 9", 2, "--orbit")->err);
    assert_quiet("$GLINT stream sphere --size 20x20 --to ppm -o s%d.ppm --frames 1 --shade host");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_device_gets_the_normals_the_material_and_the_light, begin, end),
        cmocka_unit_test_setup_teardown(a_device_that_tells_the_light_gets_it_back, begin, end),
        cmocka_unit_test_setup_teardown(one_colour_may_come_from_the_albedo, begin, end),
        cmocka_unit_test_setup_teardown(a_gloss_map_is_refused_unless_it_is_white, begin, end),
        cmocka_unit_test_setup_teardown(soft_edges_a_background_and_what_filter_makes_are_refused, begin, end),
        cmocka_unit_test_setup_teardown(what_the_tables_cannot_do_is_refused, begin, end),
#if GLINT_WITH_USB
        cmocka_unit_test(the_name_of_a_device_keeps_within_its_room),
        cmocka_unit_test(a_device_of_more_pixels_than_glint_shades_is_refused),
        cmocka_unit_test(a_board_that_knows_no_light_is_refused_with_a_reason),
        cmocka_unit_test(a_board_that_takes_no_light_for_its_own_picture_is_refused_with_a_reason),
#endif
        cmocka_unit_test(what_does_not_reach_the_boards_own_picture_is_refused_by_its_name),
        cmocka_unit_test(the_command_line_tells_what_can_shade),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
