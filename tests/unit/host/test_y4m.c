/* SPDX-License-Identifier: MIT
 * --to y4m, against a reader written from the format's definition (yuv4mpeg(5)) and BT.601's inverse in doubles. */
#include <fcntl.h>
#include <math.h>
#include <png.h>
#include <poll.h>
#include <signal.h>

#include "files.h"

#define COIN "$GLINT stream coin --size 60x40 --to y4m "
enum { WIDTH = 60, HEIGHT = 40, PIXELS = WIDTH * HEIGHT };

/* ---- the reader ---- */

struct video {
    unsigned width, height, numerator, denominator, frames;
    char chroma[16];
    uint8_t *bytes;
    const uint8_t *planes[64]; /* of each frame */
};

static const char *skip_line(const char *text)
{
    return strchr(text, '\n') + 1;
}

static struct video read_video(const char *path)
{
    enum { ROOM = 1 << 20 };
    struct video video = {.bytes = malloc(ROOM)};
    const size_t size = read_file(path, video.bytes, ROOM - 1);
    video.bytes[size] = '\0';
    const char *at = (const char *)video.bytes, *end = at + size;
    assert_true(strncmp(at, "YUV4MPEG2 ", 10) == 0);
    char *head = strndup(at, strcspn(at, "\n"));
    for (char *word = strtok(head, " "); (word = strtok(NULL, " "));) {
        if (*word == 'W')
            video.width = (unsigned)atoi(word + 1);
        else if (*word == 'H')
            video.height = (unsigned)atoi(word + 1);
        else if (*word == 'F')
            assert_int_equal(sscanf(word, "F%u:%u", &video.numerator, &video.denominator), 2);
        else if (*word == 'C')
            snprintf(video.chroma, sizeof video.chroma, "%s", word + 1);
        else
            assert_true(!strcmp(word, "Ip") || !strcmp(word, "A1:1") || !strcmp(word, "XCOLORRANGE=LIMITED"));
    }
    free(head);
    const size_t planes = 3 * (size_t)video.width * video.height; /* C444 */
    for (at = skip_line(at); at < end; at += planes) {
        assert_true(strncmp(at, "FRAME", 5) == 0 && (at[5] == '\n' || at[5] == ' '));
        at = skip_line(at);
        assert_true(at + planes <= end); /* whole */
        video.planes[video.frames++] = (const uint8_t *)at;
    }
    return video;
}

/* The inverse of BT.601 in limited range. */
static void rgb_of(const struct video *video, unsigned frame, size_t pixel, double rgb[3])
{
    const size_t pixels = (size_t)video->width * video->height;
    const uint8_t *plane = video->planes[frame];
    const double y = (plane[pixel] - 16) * 255. / 219, cb = (plane[pixels + pixel] - 128) * 255. / 224,
                 cr = (plane[2 * pixels + pixel] - 128) * 255. / 224;
    rgb[0] = y + 1.402 * cr;
    rgb[1] = y - (.114 * 1.772 * cb + .299 * 1.402 * cr) / .587;
    rgb[2] = y + 1.772 * cb;
}

static void read_rgb(const char *path, uint8_t *rgb)
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_file(&image, path) != 0);
    image.format = PNG_FORMAT_RGB;
    assert_int_equal(image.width * image.height, PIXELS);
    assert_true(png_image_finish_read(&image, NULL, rgb, 0, NULL) != 0);
}

/* ---- the tests ---- */

static void frames_are_those_of_the_png_sink_within_the_rounding_of_8_bits(void **state)
{
    (void)state;
    static const char *const formats[] = {"rgb888", "rgb565", "grey8", "mono"};
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        char line[200];
        snprintf(line, sizeof line, COIN "--frames 3 --fps 4 --format %s -o v.y4m", formats[f]);
        assert_quiet(line);
        snprintf(line, sizeof line,
                 "$GLINT stream coin --size 60x40 --to png --frames 3 --fps 4 --format %s -o f%%d.png", formats[f]);
        assert_quiet(line);
        const struct video video = read_video("v.y4m");
        assert_int_equal(video.width, WIDTH);
        assert_int_equal(video.height, HEIGHT);
        assert_int_equal(video.frames, 3);
        assert_string_equal(video.chroma, "444");
        for (unsigned i = 0; i < 3; i++) {
            static uint8_t wanted[3 * PIXELS];
            snprintf(line, sizeof line, "f%u.png", i);
            read_rgb(line, wanted);
            for (size_t p = 0; p < PIXELS; p++) {
                double rgb[3];
                rgb_of(&video, i, p, rgb);
                /* Half a step of Y, Cb and Cr each: .58 + 1.402 * .57, ... below 1.62. */
                for (unsigned k = 0; k < 3; k++)
                    if (fabs(rgb[k] - wanted[3 * p + k]) > 1.62)
                        fail_msg("%s, frame %u, pixel %zu: %.2f, not %u", formats[f], i, p, rgb[k], wanted[3 * p + k]);
            }
        }
        free(video.bytes);
    }
}

static void black_white_and_the_primaries_are_bt_601s_codes(void **state)
{
    (void)state;
    /* From BT.601's table of 100 % colours in 8 bits. */
    static const struct {
        const char *color;
        uint8_t codes[3];
    } colors[] = {{"0,0,0", {16, 128, 128}},     {"255,255,255", {235, 128, 128}}, {"255,0,0", {81, 90, 240}},
                  {"0,255,0", {145, 54, 34}},    {"0,0,255", {41, 240, 110}},      {"255,255,0", {210, 16, 146}},
                  {"0,255,255", {170, 166, 16}}, {"255,0,255", {106, 202, 222}}};
    const struct made_png flat = {.width = 12, .height = 8, .bits = 8, .samples = (uint16_t[12 * 8]){0}};
    make_png("flat.png", &flat);
    for (size_t i = 0; i < sizeof colors / sizeof *colors; i++) {
        char line[300];
        snprintf(line, sizeof line,
                 "$GLINT stream --height flat.png --to y4m --frames 1 --ambient 1 --diffuse 0 --specular 0 "
                 "--color %s -o c.y4m 2>flat.txt", /* a map without heights is warned about */
                 colors[i].color);
        assert_quiet(line);
        const struct video video = read_video("c.y4m");
        for (size_t k = 0; k < 3; k++)
            assert_int_equal(video.planes[0][k * 96], colors[i].codes[k]);
        free(video.bytes);
    }
}

static void the_header_states_fps_as_a_fraction(void **state)
{
    (void)state;
    static const struct {
        const char *fps;
        unsigned numerator, denominator;
    } rates[] = {{"30", 30, 1}, {"29.97", 2997, 100}, {"23.976", 2997, 125}, {"59.94005994005994", 60000, 1001},
                 {"0.5", 1, 2}, {"1000", 1000, 1},    {"12.5", 25, 2},       {"0.000001", 1, 1000000}};
    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++) {
        char line[200];
        snprintf(line, sizeof line, COIN "--frames 1 --fps %s -o r.y4m", rates[i].fps);
        assert_quiet(line);
        const struct video video = read_video("r.y4m");
        assert_int_equal(video.numerator, rates[i].numerator);
        assert_int_equal(video.denominator, rates[i].denominator);
        free(video.bytes);
    }
    assert_quiet(COIN "--frames 1 -o r.y4m && head -c 40 r.y4m | grep -q ' F30:1 '");
    assert_refused(COIN "--fps 0 -o out/r.y4m", "--fps: --to y4m states the frame rate");
    assert_refused(COIN "--fps 1e-10 -o out/r.y4m", "--fps: '1e-10' is too small");
    assert_int_equal(files_in("out"), 0);
}

static void a_minus_is_standard_output(void **state)
{
    (void)state;
    assert_quiet(COIN "--frames 2 -o v.y4m");
    assert_quiet(COIN "--frames 2 -o - >w.y4m");
    assert_same_file("v.y4m", "w.y4m");
    assert_quiet(COIN "--frames 2 -o - | cat >w.y4m");
    assert_same_file("v.y4m", "w.y4m");
    assert_contains(run(COIN "--frames 1 -o - --stats 2>&1 >w.y4m")->out, "1 frames to standard output");
    assert_fails(COIN "-o - >/dev/full", "standard output: could not be written: No space left");
}

static void without_o_or_in_a_place_that_cannot_be_written_there_is_one_line_and_no_file(void **state)
{
    (void)state;
    assert_refused(COIN, "-o: --to y4m writes a file; name it: -o FILE.y4m");
    assert_fails(COIN "-o none/v.y4m", "none/v.y4m: cannot create a file there");
    assert_quiet("printf '1 1 1\\n1\\n' >lights.txt"); /* fails after a frame */
    assert_fails(COIN "--lights lights.txt -o out/v.y4m", "line 2");
    assert_int_equal(files_in("out"), 0);
    assert_quiet("echo before >out/v.y4m");
    assert_fails(COIN "--lights lights.txt -o out/v.y4m", "line 2");
    assert_quiet("test $(cat out/v.y4m) = before");
    assert_quiet("rm out/v.y4m");
}

/* Starts a stream without end, waits until its output is there, sends the signal; the exit status. */
static int interrupted(int number, const char *command)
{
    char line[400];
    snprintf(line, sizeof line, "%s; kill -%d $!; wait $!", command, number);
    return run(line)->status;
}

static void a_signal_ends_the_video_after_a_whole_frame(void **state)
{
    (void)state;
    static const int signals[] = {SIGTERM, SIGHUP};
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(
            interrupted(signals[i],
                        "env --default-signal=HUP " COIN "--frames 1000000 --period 1000 -o out/v.y4m & "
                        "until [ $(cat out/.glint-* | wc -c) -gt 20000 ] || ! kill -0 $!; do sleep .02; done"),
            128 + signals[i]);
        assert_int_equal(files_in("out"), 1);
        /* A frame has 7206 bytes. */
        assert_quiet("test $((($(wc -c <out/v.y4m) - $(head -1 out/v.y4m | wc -c)) % 7206)) = 0");
        assert_quiet("rm out/v.y4m");
    }
}

/* A closed terminal and timeout send a signal twice: they ask once. Both are there when the stream goes on. */
static void two_signals_at_once_end_the_video_after_a_whole_frame_too(void **state)
{
    (void)state;
    const int status = run("env --default-signal=HUP " COIN "--frames 1000000 --period 1000 -o out/v.y4m & "
                           "until [ $(cat out/.glint-* | wc -c) -gt 20000 ] || ! kill -0 $!; do sleep .02; done; "
                           "kill -STOP $!; kill -TERM $!; kill -HUP $!; kill -CONT $!; wait $!")
                           ->status;
    assert_true(status == 128 + SIGTERM || status == 128 + SIGHUP);
    assert_int_equal(files_in("out"), 1);
    assert_quiet("test $((($(wc -c <out/v.y4m) - $(head -1 out/v.y4m | wc -c)) % 7206)) = 0");
    assert_quiet("rm out/v.y4m");
}

/* In a pipe that is full. */
static pid_t video_that_nothing_reads(int ends[2])
{
    assert_int_equal(pipe(ends), 0);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        execl("/bin/sh", "sh", "-c", "exec " COIN "--frames 1000000 -o -", (char *)NULL);
        _exit(127);
    }
    while (poll(&(struct pollfd){.fd = ends[1], .events = POLLOUT}, 1, 0) > 0 && lives(child))
        usleep(1000);
    return child;
}

/* The reader lags behind: the pipe is full when the signal comes, in the middle of a frame. Then it has room, so that nothing depends on how
 * soon the reader reads. */
static void a_signal_ends_the_video_in_a_pipe_after_a_whole_frame(void **state)
{
    (void)state;
    static uint8_t bytes[1 << 18];
    int ends[2], status;
    const pid_t child = video_that_nothing_reads(ends);
    assert_int_equal(kill(child, SIGSTOP), 0);
    assert_int_equal(waitpid(child, &status, WUNTRACED), child);
    assert_true(WIFSTOPPED(status));
    assert_int_equal(kill(child, SIGTERM), 0);
    assert_true(fcntl(ends[1], F_SETPIPE_SZ, sizeof bytes / 2) > 0);
    assert_int_equal(kill(child, SIGCONT), 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(WEXITSTATUS(status), 128 + SIGTERM);
    close(ends[1]);
    size_t len = 0;
    for (ssize_t count; (count = read(ends[0], bytes + len, sizeof bytes - len)) > 0;)
        len += (size_t)count;
    close(ends[0]);
    const uint8_t *end_of_header = memchr(bytes, '\n', len);
    assert_non_null(end_of_header);
    assert_int_equal((len - (size_t)(end_of_header + 1 - bytes)) % 7206, 0);
}

/* A machine that stands still may take two signals for one: the second is sent again. */
static void a_signal_half_a_second_after_the_first_ends_a_video_that_nothing_reads(void **state)
{
    (void)state;
    int ends[2], status = 0;
    const pid_t child = video_that_nothing_reads(ends);
    assert_int_equal(kill(child, SIGTERM), 0);
    pid_t gone = 0;
    for (int tries = 0; tries < 100 && !gone; tries++) {
        usleep(600000);
        kill(child, SIGINT);
        for (int turns = 0; turns < 50 && !(gone = waitpid(child, &status, WNOHANG)); turns++)
            usleep(1000);
    }
    if (!gone) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
    }
    close(ends[0]);
    close(ends[1]);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
}

static void one_stopped_before_its_first_frame_leaves_no_file(void **state)
{
    (void)state;
    assert_int_equal(interrupted(SIGTERM, "mkfifo q; " COIN "--lights q -o out/v.y4m & exec 3>q; "
                                          "until ls out/.glint-* >/dev/null 2>&1; do sleep .02; done"),
                     128 + SIGTERM);
    assert_int_equal(files_in("out"), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_those_of_the_png_sink_within_the_rounding_of_8_bits),
        cmocka_unit_test(black_white_and_the_primaries_are_bt_601s_codes),
        cmocka_unit_test(the_header_states_fps_as_a_fraction),
        cmocka_unit_test(a_minus_is_standard_output),
        cmocka_unit_test(without_o_or_in_a_place_that_cannot_be_written_there_is_one_line_and_no_file),
        cmocka_unit_test(a_signal_ends_the_video_after_a_whole_frame),
        cmocka_unit_test(two_signals_at_once_end_the_video_after_a_whole_frame_too),
        cmocka_unit_test(a_signal_half_a_second_after_the_first_ends_a_video_that_nothing_reads),
        cmocka_unit_test(a_signal_ends_the_video_in_a_pipe_after_a_whole_frame),
        cmocka_unit_test(one_stopped_before_its_first_frame_leaves_no_file),
    };
    return cmocka_run_group_tests(tests, make_maps, scratch_remove);
}
