/* SPDX-License-Identifier: MIT
 * `glint stream` and `glint list`: the frames are those of `glint render`, and how the stream ends. */
#include <fcntl.h>
#include <jansson.h>
#include <signal.h>

#include "files.h"

#include "sinks/sinks.h"

#define SPHERE "$GLINT stream sphere --size 60x40 --to png "

/* ---- the frames ---- */

static void the_first_frame_is_what_render_draws(void **state)
{
    (void)state;
    static const char *const looks[] = {
        "--light=-1,2,3",
        "--light 0,0,1 -n 200",
        "--light=-1,2,3 --format rgb565 --dither",
        "--light 1,1,1,.5,1,2 --point 20,20,30,50",
        "--point 20,20,30,50",
        "--light=-1,2,3 --format rgb565 --path colour-int8 2>/dev/null",
        "--light=-1,2,3 --path exact-int8 --dither",
        "--light=-1,2,3 --path span 2>/dev/null",
        "--light 1,1,1 --format mono --dither --space linear --model gauss",
        "--light 1,1,1 --format grey8 --view 1,0,2",
    };
    for (size_t i = 0; i < sizeof looks / sizeof *looks; i++) {
        char line[300];
        snprintf(line, sizeof line, SPHERE "--frames 1 -o s.png %s", looks[i]);
        assert_quiet(line);
        snprintf(line, sizeof line, "$GLINT render --scene sphere --size 60x40 -o r.png %s", looks[i]);
        assert_quiet(line);
        assert_same_file("s.png", "r.png");
        unlink("s.png");
    }
}

static void each_line_of_lights_is_a_frame(void **state)
{
    (void)state;
    assert_quiet("printf '\\357\\273\\2771 1 1\\n\\n  # a remark\\n-1,2, 3\\r\\n  0,0 .5' >lights.txt");
    assert_quiet("$GLINT stream --height heights.png --albedo colors.png --to ppm -o l%d.ppm --lights lights.txt");
    assert_quiet("$GLINT render --height heights.png --albedo colors.png -o a.ppm --light=-1,2,3");
    assert_same_file("a.ppm", "l1.ppm");
    assert_quiet("$GLINT render --height heights.png --albedo colors.png -o a.ppm --light 0,0,.5");
    assert_same_file("a.ppm", "l2.ppm");
    assert_true(exists("l0.ppm") && !exists("l3.ppm"));
    assert_quiet("$GLINT stream --height heights.png --albedo colors.png --to ppm -o m%d.ppm --lights - <lights.txt");
    assert_same_file("l2.ppm", "m2.ppm");
}

static void a_mesh_stands_still_under_a_file_of_lights_if_its_period_is_0(void **state)
{
    (void)state;
    assert_quiet("printf '1 1 1\\n-1 .5 1\\n1 1 1\\n' >lights.txt && "
                 "$GLINT stream teapot --size 24x20 --to ppm -o still%d.ppm --lights lights.txt --period 0 && "
                 "$GLINT render teapot --size 24x20 --light 1,1,1 -o one.ppm && "
                 "$GLINT render teapot --size 24x20 --light=-1,.5,1 -o other.ppm");
    assert_same_file("still0.ppm", "one.ppm");
    assert_same_file("still1.ppm", "other.ppm");
    assert_same_file("still2.ppm", "one.ppm");
    assert_quiet("$GLINT stream teapot --size 24x20 --to ppm -o turned%d.ppm --lights lights.txt --period 6 --fps 1 && "
                 "$GLINT render teapot --size 24x20 --turn 25,30,0 --light=-1,.5,1 -o other.ppm");
    assert_same_file("turned1.ppm", "other.ppm");
}

static void files_get_one_turn_of_the_light_unless_frames_says_more(void **state)
{
    (void)state;
    assert_quiet(SPHERE "--fps 10 --period .8 -o out/f-%03d.png");
    assert_int_equal(files_in("out"), 8);
    assert_true(exists("out/f-000.png") && exists("out/f-007.png"));
    assert_quiet("rm out/*");
    assert_quiet(SPHERE "--fps 10 --period .8 -o out/%d%%.png --frames 9");
    assert_int_equal(files_in("out"), 9);
    assert_same_file("out/0%.png", "out/8%.png"); /* once around */
    assert_false(same_file("out/0%.png", "out/4%.png"));
    assert_quiet("rm out/*");
}

static void the_orbit_keeps_its_angle(void **state)
{
    (void)state;
    assert_quiet(SPHERE "--light 1,0,0 --orbit 30 --fps 4 --period 1 -o o%d.png");
    assert_quiet("$GLINT render --scene sphere --size 60x40 -o a.png --light 0.5,0,0.8660254037844386");
    assert_same_file("a.png", "o0.png");
    assert_quiet("$GLINT render --scene sphere --size 60x40 -o a.png --light 0,0.5,0.8660254037844386");
    assert_same_file("a.png", "o1.png");
    assert_quiet(SPHERE "--orbit 0 --frames 2 -o o%d.png"); /* straight from the viewer */
    assert_same_file("o0.png", "o1.png");
}

static void a_point_circles_in_the_sense_of_the_orbit(void **state)
{
    (void)state;
    assert_quiet(SPHERE "--point 40,20,30,90 --fps 4 --period 1 -o o%d.png"); /* about 30,20 */
    assert_quiet("$GLINT render --scene sphere --size 60x40 -o a.png --point 30,10,30,90");
    assert_same_file("a.png", "o1.png");
    assert_quiet("$GLINT render --scene sphere --size 60x40 -o a.png --point 20,20,30,90");
    assert_same_file("a.png", "o2.png");
}

static void raw_frames_are_packed_lines_of_the_format(void **state)
{
    (void)state;
    static const struct {
        const char *options;
        long bytes;
    } formats[] = {
        {"", 2 * 60 * 40}, {"--format rgb888", 3 * 60 * 40}, {"--format grey8", 60 * 40}, {"--format mono", 8 * 40}};
    for (size_t i = 0; i < 4; i++) {
        char line[200];
        struct stat status;
        snprintf(line, sizeof line, SPHERE "--to raw --frames 3 %s >raw", formats[i].options);
        assert_quiet(line);
        assert_int_equal(stat("raw", &status), 0);
        assert_int_equal(status.st_size, 3 * formats[i].bytes);
    }
    assert_quiet(SPHERE "--to raw --frames 1 --format rgb565 >a");
    assert_quiet(SPHERE "--to raw --frames 1 --format rgb565-swapped | dd conv=swab status=none >b");
    assert_same_file("a", "b");
    assert_quiet("$GLINT stream coin --to raw --frames 1 | test $(wc -c) = 153600"); /* 320x240 by itself */
}

static void a_map_is_streamed_at_its_own_size_or_repeated(void **state)
{
    (void)state;
    assert_quiet("$GLINT stream --height heights.png --light=-1,1,1 --frames 1 --to png -o s.png");
    assert_quiet("$GLINT render --height heights.png -o r.png");
    assert_same_file("s.png", "r.png");
    assert_quiet("$GLINT stream --height - --size 30x20 --light=-1,1,1 --frames 1 --to png -o s.png <heights.png");
    assert_quiet("$GLINT render --height heights.png --size 30x20 -o r.png");
    assert_same_file("s.png", "r.png");
}

/* A sink that is sent only changes, and whose files are of every frame all the same. */
static void the_virtual_panel_shows_the_frames_that_png_files_hold(void **state)
{
    (void)state;
    assert_quiet("$GLINT stream coin --size 240x240 --format rgb565-swapped --frames 3 --fps 5 --to png -o w%d.png");
    assert_quiet("$GLINT stream coin --size 240x240 --frames 3 --fps 5 --to panel -o p%d.png");
    assert_same_file("w0.png", "p0.png");
    assert_same_file("w2.png", "p2.png");
    assert_quiet("$GLINT stream coin --size 240x240 --frames 3 --period 0 --to panel -o q%d.png");
    assert_same_file("q0.png", "q2.png");
}

/* ---- the figures ---- */

static json_t *figures(const char *command)
{
    const struct run *result = run(command);
    assert_int_equal(result->status, 0);
    json_t *figures = json_loads(result->out, 0, NULL);
    assert_non_null(figures);
    return figures;
}

static double figure(const json_t *figures, const char *group, const char *name)
{
    const json_t *value = json_object_get(group ? json_object_get(figures, group) : figures, name);
    assert_true(json_is_number(value));
    return json_number_value(value);
}

static void figures_tell_what_was_sent(void **state)
{
    (void)state;
    json_t *moving = figures(SPHERE "--to none --json --frames 20 -q 6");
    assert_int_equal((int)figure(moving, NULL, "frames"), 20);
    assert_int_equal((int)figure(moving, NULL, "frames_unchanged"), 0);
    assert_int_equal((int)figure(moving, "frame_bytes", "before_mean"), 2 * 60 * 40);
    assert_true(figure(moving, "frame_bytes", "mean") < 1200);
    assert_true(figure(moving, "frame_bytes", "mean") <= figure(moving, "frame_bytes", "worst"));
    assert_true(figure(moving, NULL, "changed_share") > 0 && figure(moving, NULL, "changed_share") < .5);
    const json_t *slow = json_array_get(json_object_get(moving, "predicted"), 0);
    const double wanted =
        1 / (.4e-3 * figure(moving, "rectangles", "mean") + figure(moving, "frame_bytes", "mean") / 600e3);
    const double fps = figure(slow, NULL, "fps_mean");
    assert_true(fps > .999 * wanted && fps < 1.001 * wanted);
    json_decref(moving);
    json_t *still = figures(SPHERE "--to none --json --frames 20 --period 0");
    assert_int_equal((int)figure(still, NULL, "frames_unchanged"), 19);
    assert_int_equal((int)figure(still, "frame_bytes", "worst"), 0);
    json_decref(still);
    assert_contains(run(SPHERE "--to none --stats --frames 2")->out, "600 KB/s");
    assert_contains(run(SPHERE "--to none --stats --frames 2 --period 0")->out, "any number of frames/s over USB");
    json_t *link = figures(SPHERE "--to none --json --frames 9 --link-raw --link-rate 50 --link-rectangle 0");
    const json_t *own = json_array_get(json_object_get(link, "predicted"), 2);
    const double product = figure(own, NULL, "fps_mean") * figure(link, "frame_bytes", "mean");
    assert_true(product > 49950 && product < 50050);
    json_decref(link);
    const struct run *beside = run(SPHERE "--to raw --json --frames 1 >frames");
    json_t *on_error = json_loads(beside->err, 0, NULL);
    assert_non_null(on_error);
    json_decref(on_error);
    json_t *odd = figures("$GLINT stream sphere --size 60x40 --to png --json --frames 1 -o 'out/\xff%d.png'");
    assert_string_equal(json_string_value(json_object_get(odd, "device")), "out/?%d.png");
    json_decref(odd);
    assert_quiet("rm out/*");
}

/* ---- how it ends ---- */

static void where_it_cannot_write_there_is_one_line(void **state)
{
    (void)state;
    assert_fails(SPHERE "--to raw >/dev/full", "standard output: could not be written: No space left");
    assert_fails(SPHERE "--to raw >&-", "standard output: could not be written");
    assert_fails(SPHERE "--to raw 2>err.txt | head -c 1 >/dev/null; wait; cat err.txt >&2; exit 1", "Broken pipe");
    assert_fails(SPHERE "-o none/%d.png", "none/0.png: cannot create a file there");
    assert_fails("mkdir -p out/1.png; " SPHERE "-o out/%d.png", "out/1.png: this is a folder");
    assert_true(exists("out/0.png"));
    assert_int_equal(files_in("out"), 2); /* nothing half-written */
    assert_fails("rm -r out/*; " SPHERE "--frames 1 -o /dev/full", "/dev/full: could not be written: No space left");
    assert_fails(SPHERE "--to none --json >/dev/full", "the figures could not be written: No space left");
    assert_fails("$GLINT list >/dev/full", "standard output: could not be written");
    assert_int_equal(files_in("out"), 0);
}

/* Starts a stream without end, waits for its second frame, sends the signal; the exit status. */
static int interrupted(int number)
{
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        signal(number, SIG_DFL); /* the caller may have it ignored */
        execl(getenv("GLINT"), "glint", "stream", "sphere", "--size", "60x40", "--frames", "1000000000", "--to", "png",
              "-o", "out/%d.png", (char *)NULL);
        _exit(127);
    }
    while (!exists("out/1.png") && lives(child))
        usleep(10000);
    kill(child, number);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void signals_end_it_after_a_whole_frame(void **state)
{
    (void)state;
    static const int signals[] = {SIGHUP,  SIGINT,  SIGQUIT,   SIGTERM, SIGPIPE, SIGUSR1,
                                  SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF, SIGXCPU, SIGXFSZ};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        assert_int_equal(interrupted(signals[i]), 128 + signals[i]);
        assert_true(exists("out/1.png"));
        assert_int_equal(run("ls -A out | grep -v '^[0-9]*.png$'")->status, 1); /* nothing else there */
        assert_quiet("rm out/*");
    }
}

static void a_signal_that_the_caller_ignores_is_ignored(void **state)
{
    (void)state;
    /* As nohup does. The second light comes after the signal. */
    const struct run *result =
        run("mkfifo hup; trap '' HUP; $GLINT stream sphere --size 60x40 --to raw --lights hup >frames & exec 3>hup;"
            "echo 1 1 1 >&3; until [ -s frames ] || ! kill -0 $!; do sleep .02; done; kill -HUP $!;"
            "echo 1 1 2 >&3; exec 3>&-; wait $! && stat -c %s frames");
    assert_int_equal(result->status, 0);
    assert_string_equal(result->out, "9600\n");
}

/* A stream that cannot go on: nobody reads its frames, or nobody writes its lights. */
static int interrupted_while_it_waits(const char *option, const char *value, bool reads)
{
    int frames[2], lights[2];
    assert_true(pipe(frames) == 0 && pipe(lights) == 0);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        signal(SIGINT, SIG_DFL);
        dup2(lights[0], STDIN_FILENO);
        dup2(frames[1], STDOUT_FILENO);
        execl(getenv("GLINT"), "glint", "stream", "sphere", "--to", "raw", option, value, (char *)NULL);
        _exit(127);
    }
    char byte;
    if (reads)
        assert_int_equal(write(lights[1], "1 1 1\n", 6), 6);
    assert_int_equal(read(frames[0], &byte, 1), 1); /* it has begun */
    kill(child, SIGINT);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    for (int i = 0; i < 2; i++) {
        close(frames[i]);
        close(lights[i]);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void a_signal_ends_it_while_a_file_is_waited_for(void **state)
{
    (void)state;
    assert_quiet("mkfifo never");
    static const char *const waits[] = {
        "sphere --to none --lights never",
        "--height never",
#if GLINT_WITH_GPIO
        "sphere --to gpio --bus-config never"
#endif
    };
    for (size_t i = 0; i < sizeof waits / sizeof *waits; i++) {
        char line[200];
        snprintf(line, sizeof line, "timeout --foreground -s INT --preserve-status 1 $GLINT stream %s", waits[i]);
        const struct run *result = run(line);
        assert_int_equal(result->status, 130);
        assert_string_equal(result->err, "");
    }
}

static void a_stream_that_waits_ends_by_a_signal(void **state)
{
    (void)state;
    assert_int_equal(interrupted_while_it_waits("--period", "1000", false), 130);
    assert_int_equal(interrupted_while_it_waits("--lights", "-", true), 130);
}

static void every_sink_is_listed_with_what_it_is_and_its_devices(void **state)
{
    (void)state;
    json_t *list = json_loads(run("$GLINT list --json")->out, 0, NULL), *sinks = json_object_get(list, "sinks");
    size_t left_out = 0;
    while (sinks_left_out[left_out].name)
        left_out++;
    unsigned i = 0;
    for (; sink_kinds[i]; i++) {
        const json_t *sink = json_array_get(sinks, i);
        assert_string_equal(json_string_value(json_object_get(sink, "name")), sink_kinds[i]->name);
        assert_string_equal(json_string_value(json_object_get(sink, "summary")), sink_kinds[i]->summary);
        assert_int_equal(json_object_get(list, sink_kinds[i]->name) != NULL, sink_kinds[i]->list != NULL);
        char line[120];
        snprintf(line, sizeof line, "$GLINT list | grep -q '^%s  *%.20s'", sink_kinds[i]->name, sink_kinds[i]->summary);
        assert_quiet(line);
    }
    assert_int_equal(json_array_size(sinks), i + left_out);
    json_decref(list);
}

static void the_list_is_json_on_demand(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT list --json");
    assert_int_equal(result->status, 0);
    json_t *list = json_loads(result->out, 0, NULL);
    assert_true(json_is_object(list));
    const char *kind;
    json_t *devices;
    json_object_foreach(list, kind, devices) assert_true(json_is_array(devices));
    json_decref(list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_frame_is_what_render_draws),
        cmocka_unit_test(each_line_of_lights_is_a_frame),
        cmocka_unit_test(a_mesh_stands_still_under_a_file_of_lights_if_its_period_is_0),
        cmocka_unit_test(files_get_one_turn_of_the_light_unless_frames_says_more),
        cmocka_unit_test(the_orbit_keeps_its_angle),
        cmocka_unit_test(a_signal_that_the_caller_ignores_is_ignored),
        cmocka_unit_test(a_point_circles_in_the_sense_of_the_orbit),
        cmocka_unit_test(raw_frames_are_packed_lines_of_the_format),
        cmocka_unit_test(a_map_is_streamed_at_its_own_size_or_repeated),
        cmocka_unit_test(the_virtual_panel_shows_the_frames_that_png_files_hold),
        cmocka_unit_test(figures_tell_what_was_sent),
        cmocka_unit_test(where_it_cannot_write_there_is_one_line),
        cmocka_unit_test(signals_end_it_after_a_whole_frame),
        cmocka_unit_test(a_signal_ends_it_while_a_file_is_waited_for),
        cmocka_unit_test(a_stream_that_waits_ends_by_a_signal),
        cmocka_unit_test(the_list_is_json_on_demand),
        cmocka_unit_test(every_sink_is_listed_with_what_it_is_and_its_devices),
    };
    return cmocka_run_group_tests(tests, make_maps, scratch_remove);
}
