/* SPDX-License-Identifier: MIT
 * The options and the file that describe a panel and its wires: what is refused, and in which words. No test comes as far as a
 * device. */
#include "files.h"

#if GLINT_WITH_GPIO
static void write_config(const char *text)
{
    FILE *file = fopen("pins.ini", "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    fclose(file);
}

static void assert_config_fails(const char *text, const char *part)
{
    write_config(text);
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini", part);
}

static void wires_that_are_missing_are_named(void **state)
{
    (void)state;
    assert_fails("$GLINT stream coin --to gpio", "--bus spi needs a line for sck, mosi, dc");
    assert_fails("$GLINT stream coin --to gpio --bus 8080 --lines d0=A,d1=B,d2=C,d3=D,d4=E,d5=F,d6=G,d7=H,dc=I",
                 "--bus 8080 needs a line for wr; give it by --lines wr=NAME or in a file by --bus-config");
    assert_fails("$GLINT stream coin --to spi", "--to spi needs a line for dc");
}

static void wires_that_the_bus_does_not_have_are_named(void **state)
{
    (void)state;
    assert_fails("$GLINT stream coin --to gpio --lines sck=A,mosi=B,dc=C,wr=D",
                 "--lines: --bus spi has no line wr; it has");
    assert_fails("$GLINT stream coin --to spi --lines dc=C,cs=D",
                 "--lines: --to spi has no line cs (the SPI device drives its own); it has dc, reset, backlight");
    assert_refused("$GLINT stream coin --to gpio --lines miso=A", "--lines: unknown line 'miso'; choose from d0, d1");
}

static void lines_are_role_and_name(void **state)
{
    (void)state;
    assert_refused("$GLINT stream coin --to gpio --lines sck", "--lines: 'sck' is not ROLE=LINE");
    assert_refused("$GLINT stream coin --to gpio --lines sck=A,,mosi=B", "--lines: '' is not ROLE=LINE");
    assert_refused("$GLINT stream coin --to gpio --lines sck=", "--lines: sck names no line");
    assert_refused("$GLINT stream coin --to gpio --lines 'sck=!'", "--lines: sck names no line");
    assert_refused("$GLINT stream coin --to gpio --lines sck=A --lines clk=B",
                   "--lines: sck is given twice, as A and B");
}

static void values_that_cannot_be_are_refused_with_those_that_can(void **state)
{
    (void)state;
    assert_refused("$GLINT stream coin --bus i2c", "--bus: unknown bus 'i2c'; choose from spi, 8080");
    assert_refused("$GLINT stream coin --panel st7735", "--panel: unknown panel 'st7735'; choose from st7789, ili9341");
    assert_refused("$GLINT stream coin --rotation 1", "--rotation: unknown rotation '1'; choose from 0, 90, 180, 270");
    assert_refused("$GLINT stream coin --bgr=maybe", "--bgr: unknown answer 'maybe'; choose from no, yes");
    assert_refused("$GLINT stream coin --spi-mode 1", "--spi-mode: unknown mode '1'; choose from 0, 3");
    assert_fails("$GLINT stream coin --to gpio --bus 8080 --spi-mode 3",
                 "--spi-mode: is for SPI; leave it out for --bus 8080");
    assert_refused("$GLINT stream coin --to spi --spi-hz 16M",
                   "--spi-hz: '16M' is not a whole number from 1000 to 200000000");
    static const char *const offsets[] = {"1", "1,", "1,2,3", "-1,2", "' 1,2'", "1x2", "321,0", "99999999999,0", "''"};
    for (size_t i = 0; i < sizeof offsets / sizeof *offsets; i++) {
        char command[100];
        snprintf(command, sizeof command, "$GLINT stream coin --offset=%s", offsets[i]);
        assert_refused(command, "is not two numbers from 0 to 320 with ',' between");
    }
    assert_refused("$GLINT stream coin --chip ''", "--chip: the name is empty");
}

static void glass_that_is_not_is_told_with_what_to_do(void **state)
{
    (void)state;
#define TO_GPIO "$GLINT stream coin --to gpio --lines sck=gpiochip999:0,mosi=gpiochip999:1,dc=gpiochip999:2 "
    assert_fails(TO_GPIO "--size 240x320 --rotation 90",
                 "--size: an st7789 glass of 240x320 shows 320x240 at --rotation 90; "
                 "give that --size, or --rotation 0 or 180");
    assert_fails(TO_GPIO "--size 320x240 --rotation 0",
                 "--size: an st7789 glass of 240x320 shows 240x320 at --rotation 0; "
                 "give that --size, or --rotation 90 or 270");
    assert_fails(TO_GPIO "--size 300x300",
                 "--size: 300x300 is more than the 320x240 pixels of st7789; choose a smaller");
    assert_fails(TO_GPIO "--size 128x128", "no st7789 glass of 128x128 is known; give the place");
    assert_fails(TO_GPIO "--size 128x128 --offset 200,0", "choose a smaller --size or --offset");
    assert_fails(TO_GPIO "--panel ili9341 --size 240x240", "no ili9341 glass of 240x240");
}

static void the_virtual_panel_has_any_size_that_has_room(void **state)
{
    (void)state;
    assert_quiet("$GLINT stream coin --to panel --frames 1 --size 60x40 -o p.png");
    assert_quiet("$GLINT stream --height heights.png --to panel --frames 1 -o p.png");
    assert_quiet("$GLINT stream watchface --to panel --panel gc9a01 --frames 1 -o p.png");
    assert_fails("$GLINT stream coin --to panel --panel gc9a01 --frames 1 --size 240x320 -o p.png",
                 "--size: 240x320 is more than the 240x240 pixels of gc9a01; choose a smaller --size, or --to png");
    assert_fails("$GLINT stream coin --to panel --panel ssd1306 --rotation 90 --frames 1 -o p.png",
                 "--rotation: an ssd1306 turns by 0 or 180 only");
    assert_fails("$GLINT stream coin --to panel --panel ssd1306 --size 128x60 --frames 1 -o p.png",
                 "--size: 128x60 does not fit an ssd1306: at most 128x64, lines a multiple of 8, offset X,0");
    assert_fails("$GLINT stream coin --to panel --panel ssd1306 --offset 0,8 --size 64x48 --frames 1 -o p.png",
                 "--size: 64x48 at --offset does not fit an ssd1306");
    assert_fails("$GLINT stream coin --to panel --panel ssd1306 --format rgb565 --frames 1 -o p.png",
                 "--format: the panel's pixels are mono, not rgb565; leave it out");
    assert_fails("$GLINT stream coin --to panel --frames 1 --size 300x300 -o p.png",
                 "--size: 300x300 is more than the 320x240 pixels of st7789; choose a smaller --size, or --to png");
}

static void a_file_s_wrong_line_is_told_with_its_number(void **state)
{
    (void)state;
    assert_config_fails("# pins\n\nbus spi\n", "pins.ini:3: neither NAME = VALUE nor [lines] nor a # comment");
    assert_config_fails("bus = spi\nspeed = 3\n", "pins.ini:2: unknown setting 'speed'; choose from bus, chip");
    assert_config_fails("spi-mode = 2\n", "pins.ini:1: spi-mode: unknown mode '2'; choose from 0, 3");
    assert_config_fails("bus = 8080\nspi-mode = 0\n", "--spi-mode: is for SPI; leave it out for --bus 8080");
    assert_config_fails("bus = i2c\n", "pins.ini:1: bus: unknown bus 'i2c'; choose from spi, 8080");
    assert_config_fails("bus = spi\n  bus = 8080\n", "pins.ini:2: bus is given twice");
    assert_config_fails("rotation = 45\n", "pins.ini:1: rotation: unknown rotation '45'; choose from");
    assert_config_fails("[pins]\nsck = A\n", "pins.ini:2: [pins]: the only section is [lines]");
    assert_config_fails("[lines]\nsck = A\nfoo = B\n", "pins.ini:3: unknown line 'foo'");
    assert_config_fails("[lines]\nsck = A\nclk = B\n", "pins.ini:3: sck is given twice, as A and B");
    assert_config_fails("[lines]\nSCK = A\nCLK = B\n", "pins.ini:3: sck is given twice, as A and B");
    assert_config_fails("[lines]\nsck =\n", "pins.ini:2: sck names no line");
    assert_config_fails("bus = spi # of wires\nchip =\t# which?\n", "pins.ini:2: chip: the name is empty");
    assert_config_fails("chip =\t# which? # any\n", "pins.ini:1: chip: the name is empty");
    assert_config_fails("\xEF\xBB\xBF"
                        "bus = spi\r\nchip =\r\n",
                        "pins.ini:2: chip: the name is empty");
    assert_config_fails("chip =\n", "pins.ini:1: chip: the name is empty");
    char text[500];
    memset(text, 'a', sizeof text);
    text[sizeof text - 1] = '\0';
    assert_config_fails(text, "pins.ini:1: the line is longer than");
    assert_fails("printf 'bus = spi\\n\\0' >pins.ini; $GLINT stream coin --to gpio --bus-config pins.ini",
                 "pins.ini:2: holds a zero byte; give a text file");
    assert_fails("$GLINT stream coin --to gpio --bus-config /dev/full", "/dev/full:1: holds a zero byte");
}

static void a_file_that_cannot_be_read_is_named(void **state)
{
    (void)state;
    assert_fails("$GLINT stream coin --to gpio --bus-config none.ini", "--bus-config: none.ini: No such file");
    assert_fails("$GLINT stream coin --to gpio --bus-config out", "--bus-config: out: this is a folder; name a file");
    assert_refused("$GLINT stream coin --to gpio --bus-config ''", "--bus-config: the file name is empty");
}

static void a_file_says_all_and_the_command_line_goes_before_it(void **state)
{
    (void)state;
    write_config("bus = 8080 ; a comment\nsize = 100x100\n  rotation = 180\n[lines]\n  dc = GPIO25\n  wr = GPIO7\n");
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini", "--bus 8080 needs a line for d0, d1");
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini --bus spi",
                 "--bus spi needs a line for sck, mosi");
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini --bus spi --lines sck=A,mosi=B",
                 "pins.ini:6: --bus spi has no line wr");
    write_config("size = 100x100\n[lines]\ndc = A\nsck = B\nmosi = C\n");
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini", "no st7789 glass of 100x100 is known");
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini --panel ili9341", "no ili9341 glass of 100x100");
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini --size 90x90",
                 "no st7789 glass of 90x90 is known");
}

static void the_example_of_the_help_is_a_file_that_is_taken(void **state)
{
    (void)state;
    assert_int_equal(run("$GLINT stream --help | sed -n '/^  # a 240x240/,/^  backlight/s/^  //p' >pins.ini")->status,
                     0);
    char text[1000];
    read_text("pins.ini", text, sizeof text);
    assert_contains(text, "backlight = ");
    /* As far as the lines, which are not there or not to be used by a test. */
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini --chip no-such-chip", "pins.ini:");
    assert_fails("$GLINT stream coin --to gpio --bus-config pins.ini --chip no-such-chip", "no GPIO chip");
}

static void an_spi_device_that_is_not_is_told(void **state)
{
    (void)state;
    assert_fails("$GLINT stream coin --to spi --lines dc=A --spidev /dev/null",
                 "--spidev: /dev/null: is not an SPI device");
    assert_fails("$GLINT stream coin --to spi --lines dc=A --spidev /dev/spidev99.9",
                 "--spidev: /dev/spidev99.9: there is no ");
}

/* ---- the virtual panel as a sink ---- */

static void the_virtual_panel_shows_what_the_png_sink_draws_on_every_glass(void **state)
{
    (void)state;
    static const char *const glasses[] = {
        "240x320", "320x240 --rotation 270 --panel ili9341",   "135x240 --rotation 180",
        "240x135", "240x240 --rotation 270 --bgr --invert=no", "160x128 --offset 3,5"};
    for (size_t i = 0; i < sizeof glasses / sizeof *glasses; i++) {
        char command[300];
        snprintf(command, sizeof command, "$GLINT stream watchface --to panel --frames 3 -o a%%d.png --size %s",
                 glasses[i]);
        assert_quiet(command);
        snprintf(command, sizeof command,
                 "$GLINT stream watchface --to png --format rgb565-swapped --frames 3 -o b%%d.png --size %.7s",
                 glasses[i]);
        assert_quiet(command);
        assert_same_file("a0.png", "b0.png");
        assert_same_file("a1.png", "b1.png");
        assert_same_file("a2.png", "b2.png");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wires_that_are_missing_are_named),
        cmocka_unit_test(wires_that_the_bus_does_not_have_are_named),
        cmocka_unit_test(lines_are_role_and_name),
        cmocka_unit_test(values_that_cannot_be_are_refused_with_those_that_can),
        cmocka_unit_test(glass_that_is_not_is_told_with_what_to_do),
        cmocka_unit_test(the_virtual_panel_has_any_size_that_has_room),
        cmocka_unit_test(a_file_s_wrong_line_is_told_with_its_number),
        cmocka_unit_test(a_file_that_cannot_be_read_is_named),
        cmocka_unit_test(a_file_says_all_and_the_command_line_goes_before_it),
        cmocka_unit_test(the_example_of_the_help_is_a_file_that_is_taken),
        cmocka_unit_test(an_spi_device_that_is_not_is_told),
        cmocka_unit_test(the_virtual_panel_shows_what_the_png_sink_draws_on_every_glass),
    };
    return cmocka_run_group_tests_name("gpio options", tests, make_maps, scratch_remove);
}
#else
int main(void)
{
    puts("ok 1 - gpio options # SKIP libgpiod or inih is not there");
    return 0;
}
#endif
