/* SPDX-License-Identifier: MIT
 * glint stream --lights iio, by folders as Linux's sysfs has them: which sensor, its scale, its axes, and what is refused. */
#include "files.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/time.h>

#include "draw/shading.h"
#include "stream/iio.h"

static void put(const char *name, const char *text)
{
    char path[100];
    snprintf(path, sizeof path, "tree/%s", name);
    FILE *file = fopen(path, "w");
    assert_true(file && fputs(text, file) >= 0 && fclose(file) == 0);
}

static void make_tree(void)
{
    assert_int_equal(
        system("rm -rf tree && mkdir -p tree/iio:device2 tree/iio:device10 tree/iio:device0 tree/trigger0"), 0);
    put("iio:device0/in_illuminance_raw", "7\n");
    put("iio:device2/in_accel_x_raw", "0\n");
    put("iio:device2/in_accel_y_raw", "0\n");
    put("iio:device2/in_accel_z_raw", "1000\n");
    put("iio:device2/in_accel_scale", "0.00980665\n");
    put("iio:device10/in_accel_x_raw", "1000\n");
    put("iio:device10/in_accel_y_raw", "0\n");
    put("iio:device10/in_accel_z_raw", "0\n");
    put("iio:device10/in_accel_scale", "0.00980665\n");
}

static void assert_light(const char *lights, double x, double y, double z)
{
    double light[3];
    struct iio *iio = iio_open(lights);
    iio_light(iio, light);
    assert_near(light[0], x, .001);
    assert_near(light[1], y, .001);
    assert_near(light[2], z, .001);
    iio_close(iio);
}

static void the_first_accelerometer_is_taken_or_the_one_that_is_named(void **state)
{
    (void)state;
    make_tree();
    assert_light("iio:tree", 0, 0, 1);
    assert_light("iio:tree/iio:device10", 1, 0, .25); /* upright: the panel is lit from its rim */
    assert_true(iio_is_named("iio") && iio_is_named("iio:x") && !iio_is_named("iio.txt") && !iio_is_named("-"));
}

static void scales_of_each_axis_and_mount_matrices_count(void **state)
{
    (void)state;
    make_tree();
    put("iio:device2/in_accel_z_scale", "0.004903325\n");
    assert_light("iio:tree", 0, 0, .5);
    put("iio:device2/in_mount_matrix", "0, -1, 0; 1, 0, 0; 0, 0, 1\n");
    put("iio:device2/in_accel_x_raw", "600\n");
    assert_light("iio:tree", 0, .6, .5);
    put("iio:device2/in_accel_mount_matrix", "-1, 0, 0; 0, 1, 0; 0, 0, 1\n");
    assert_light("iio:tree", -.6, 0, .5);
}

/* Those of ST and InvenSense (st_accel, st_lsm6dsx, inv_icm42600) have the matrix for all channels, Chromebooks (cros_ec_sensors) the scale: the
 * kernel then leaves what names a channel out of the file's name. */
static void what_a_driver_tells_of_all_its_channels_counts(void **state)
{
    (void)state;
    make_tree();
    assert_quiet("mv tree/iio:device2/in_accel_scale tree/iio:device2/scale");
    assert_light("iio:tree", 0, 0, 1);
    put("iio:device2/mount_matrix", "0, 0, 1; 1, 0, 0; 0, 1, 0\n");
    put("iio:device2/in_accel_x_raw", "600\n");
    put("iio:device2/in_accel_y_raw", "500\n");
    assert_light("iio:tree", 1, .6, .5);
    put("iio:device2/in_accel_scale", "0.004903325\n");
    assert_light("iio:tree", .5, .3, .25);
}

/* A KXSD9 counts from 0; at rest its axes tell 2048. */
static void an_offset_is_added_before_the_scale(void **state)
{
    (void)state;
    make_tree();
    put("iio:device2/in_accel_x_raw", "2048\n");
    put("iio:device2/in_accel_y_raw", "2048\n");
    put("iio:device2/in_accel_z_raw", "3048\n");
    put("iio:device2/in_accel_offset", "-2048\n");
    assert_light("iio:tree", 0, 0, 1);
    put("iio:device2/in_accel_y_offset", "-1448\n");
    assert_light("iio:tree", 0, .6, 1);
}

static void the_light_goes_where_a_tilt_takes_it(void **state)
{
    (void)state;
    double light[3];
    make_tree();
    struct iio *iio = iio_open("iio:tree");
    iio_light(iio, light);
    put("iio:device2/in_accel_x_raw", "500\n");
    put("iio:device2/in_accel_z_raw", "866\n");
    for (unsigned frame = 0; frame < 30; frame++)
        iio_light(iio, light);
    assert_near(light[0], .5, .01);
    assert_near(light[2], .866, .01);
    iio_close(iio);
}

static void a_stream_by_a_sensor_is_that_of_the_same_line_of_lights(void **state)
{
    (void)state;
    make_tree();
    assert_quiet("$GLINT stream coin --size 60x40 --to raw --frames 2 --light-from iio:tree >a && "
                 "printf '0 0 1\\n0 0 1\\n' | $GLINT stream coin --size 60x40 --to raw --lights - >b && cmp a b");
}

static void what_is_no_accelerometer_is_refused(void **state)
{
    (void)state;
    make_tree();
    assert_fails("$GLINT stream coin --to raw --frames 1 --lights iio:none", "no accelerometer is in none");
    assert_fails("$GLINT stream coin --to raw --frames 1 --lights iio:tree/iio:device0", "no accelerometer");
    assert_refused("$GLINT stream coin --to raw --lights iio:tree", "goes on for ever; give --frames N");
    put("iio:device2/in_accel_scale", "high\n");
    assert_fails("$GLINT stream coin --to raw --frames 1 --lights iio:tree", "in_accel_scale: 'high' is not");
    assert_int_equal(remove("tree/iio:device2/in_accel_scale"), 0);
    assert_fails("$GLINT stream coin --to raw --frames 1 --lights iio:tree", "has no in_accel_scale");
}

/* Many drivers refuse with EBUSY while iio-sensor-proxy reads the sensor in its own way; here it is EISDIR. */
static void an_accelerometer_that_cannot_be_read_is_told_from_none(void **state)
{
    (void)state;
    make_tree();
    assert_quiet("cd tree/iio:device2 && rm in_accel_x_raw && mkdir in_accel_x_raw");
    assert_light("iio:tree", 1, 0, .25); /* the next one */
    assert_quiet("rm -r tree/iio:device10");
    assert_fails("$GLINT stream coin --to raw --frames 1 --lights iio:tree",
                 "the accelerometer in tree cannot be read: Is a directory");
    assert_fails("$GLINT stream coin --to raw --frames 1 --lights iio:tree/iio:device2",
                 "cannot be read: Is a directory");
}

/* A sensor that takes its time: reading it waits until something is written. */
static int pipe_end = -1;
static volatile sig_atomic_t interrupts;

static void write_at_last(int number)
{
    (void)number;
    if (++interrupts == 40) {
        pipe_end = open("tree/iio:device2/in_accel_z_raw", O_RDWR | O_NONBLOCK);
        (void)!write(pipe_end, "1000\n", 5);
    }
}

static void a_signal_that_interrupts_a_read_is_no_lost_sensor(void **state)
{
    (void)state;
    double light[3] = {0};
    make_tree();
    struct iio *iio = iio_open("iio:tree");
    assert_quiet("cd tree/iio:device2 && rm in_accel_z_raw && mkfifo in_accel_z_raw");
    sigaction(SIGALRM, &(struct sigaction){.sa_handler = write_at_last}, NULL); /* reading does not go on by itself */
    setitimer(ITIMER_REAL, &(struct itimerval){{.tv_usec = 500}, {.tv_usec = 500}}, NULL);
    iio_light(iio, light);
    setitimer(ITIMER_REAL, &(struct itimerval){.it_value = {0}}, NULL);
    close(pipe_end);
    assert_near(light[2], 1, .001);
    iio_close(iio);
}

static void a_signal_ends_a_stream_that_waits_for_its_sensor(void **state)
{
    (void)state;
    make_tree();
    assert_ends("trap : TERM; $GLINT stream coin --size 60x40 --fps 100 --frames 9999 --to raw --lights iio:tree >a & "
                "until [ -s a ] || ! kill -0 $!; do sleep .02; done; mkfifo pipe; "
                "mv pipe tree/iio:device2/in_accel_z_raw; sleep .1; kill $!; wait $!",
                143, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_accelerometer_is_taken_or_the_one_that_is_named),
        cmocka_unit_test(scales_of_each_axis_and_mount_matrices_count),
        cmocka_unit_test(what_a_driver_tells_of_all_its_channels_counts),
        cmocka_unit_test(an_offset_is_added_before_the_scale),
        cmocka_unit_test(the_light_goes_where_a_tilt_takes_it),
        cmocka_unit_test(a_stream_by_a_sensor_is_that_of_the_same_line_of_lights),
        cmocka_unit_test(what_is_no_accelerometer_is_refused),
        cmocka_unit_test(an_accelerometer_that_cannot_be_read_is_told_from_none),
        cmocka_unit_test(a_signal_that_interrupts_a_read_is_no_lost_sensor),
        cmocka_unit_test(a_signal_ends_a_stream_that_waits_for_its_sensor),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
