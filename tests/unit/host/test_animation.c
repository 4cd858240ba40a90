/* SPDX-License-Identifier: MIT
 * --to webp and --to gif, read by libwebp's decoder and giflib, against the frames of --to png. */
#include <png.h>
#include <signal.h>

#include "files.h"
#if GLINT_WITH_WEBP
#include <webp/demux.h>
#endif
#if GLINT_WITH_GIF
#include <gif_lib.h>
#endif

#define COIN "$GLINT stream coin --size 60x40 "
enum { WIDTH = 60, HEIGHT = 40, PIXELS = WIDTH * HEIGHT, FRAMES_MAX = 8 };

/* What a viewer shows, frame by frame, and when each ends. */
struct shown {
    unsigned frames;
    uint8_t rgb[FRAMES_MAX][3 * PIXELS], alpha[FRAMES_MAX][PIXELS];
    int end_ms[FRAMES_MAX];
    unsigned loops; /* 0: without end */
};

static void read_png_frame(unsigned number, uint8_t *rgb)
{
    char name[32];
    snprintf(name, sizeof name, "f%u.png", number);
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_file(&image, name) != 0);
    image.format = PNG_FORMAT_RGB;
    assert_int_equal(image.width * image.height, PIXELS);
    assert_true(png_image_finish_read(&image, NULL, rgb, 0, NULL) != 0);
}

/* The largest difference of all frames from those of --to png with the same options. */
static unsigned largest_difference(const char *options, const struct shown *shown)
{
    char line[300];
    unsigned largest = 0;
    snprintf(line, sizeof line, COIN "--to png %s -o f%%d.png", options);
    assert_quiet(line);
    for (unsigned i = 0; i < shown->frames; i++) {
        static uint8_t wanted[3 * PIXELS];
        read_png_frame(i, wanted);
        for (size_t k = 0; k < 3 * PIXELS; k++) {
            const unsigned off = (unsigned)abs(shown->rgb[i][k] - wanted[k]);
            largest = off > largest ? off : largest;
        }
    }
    return largest;
}

#if GLINT_WITH_WEBP
static void show_webp(const char *path, struct shown *shown)
{
    static uint8_t bytes[1 << 20];
    WebPData data = {bytes, read_file(path, bytes, sizeof bytes)};
    WebPAnimDecoder *decoder = WebPAnimDecoderNew(&data, NULL);
    assert_non_null(decoder);
    WebPAnimInfo info;
    assert_true(WebPAnimDecoderGetInfo(decoder, &info));
    assert_int_equal(info.canvas_width, WIDTH);
    assert_int_equal(info.canvas_height, HEIGHT);
    *shown = (struct shown){.loops = info.loop_count};
    while (WebPAnimDecoderHasMoreFrames(decoder)) {
        uint8_t *rgba;
        assert_true(shown->frames < FRAMES_MAX);
        assert_true(WebPAnimDecoderGetNext(decoder, &rgba, &shown->end_ms[shown->frames]));
        for (size_t i = 0; i < PIXELS; i++)
            memcpy(&shown->rgb[shown->frames][3 * i], &rgba[4 * i], 3);
        for (size_t i = 0; i < PIXELS; i++)
            shown->alpha[shown->frames][i] = rgba[4 * i + 3];
        shown->frames++;
    }
    WebPAnimDecoderDelete(decoder);
}

static void a_webp_shows_the_pixels_of_the_png_sink_each_frame_in_its_time(void **state)
{
    (void)state;
    static const char *const formats[] = {"rgb888", "rgb565 --dither", "mono"};
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        static struct shown shown;
        char options[100], line[300];
        snprintf(options, sizeof options, "--frames 6 --fps 7 --format %s", formats[f]);
        snprintf(line, sizeof line, COIN "--to webp %s -o a.webp", options);
        assert_quiet(line);
        show_webp("a.webp", &shown);
        assert_int_equal(shown.frames, 6);
        assert_int_equal(shown.loops, 0);
        for (unsigned i = 0; i < 6; i++)
            assert_int_equal(shown.end_ms[i], (2000 * (i + 1) + 7) / 14);
        assert_int_equal(largest_difference(options, &shown), 0);
    }
}

static void a_webp_of_argb8888_has_its_alpha(void **state)
{
    (void)state;
    static struct shown shown;
    static uint8_t pixels[5 * 4 * PIXELS];
    assert_quiet(COIN "--frames 5 --format argb8888 --cut-out --to webp -o a.webp && " COIN
                      "--frames 5 --format argb8888 --cut-out --to raw >a.raw");
    show_webp("a.webp", &shown);
    assert_int_equal(read_file("a.raw", pixels, sizeof pixels), sizeof pixels);
    for (size_t i = 0; i < 5 * PIXELS; i++) {
        const uint8_t *pixel = &pixels[4 * i], *seen = &shown.rgb[i / PIXELS][3 * (i % PIXELS)];
        assert_int_equal(shown.alpha[i / PIXELS][i % PIXELS], pixel[3]);
        if (pixel[3]) /* what is not seen may have any colour */
            assert_true(seen[0] == pixel[2] && seen[1] == pixel[1] && seen[2] == pixel[0]);
    }
}

static void a_lower_quality_takes_fewer_bytes(void **state)
{
    (void)state;
    assert_quiet(COIN "--frames 4 --to webp -o a.webp && " COIN "--frames 4 --to webp --quality 60 -o b.webp && "
                      "test $(wc -c <b.webp) -lt $(($(wc -c <a.webp) * 2 / 3))");
    assert_refused(COIN "--to webp --quality 101 -o out/a.webp", "--quality");
    assert_refused(COIN "--to png --frames 1 --quality 60 -o out/a.png", "--quality: is for --to webp");
    assert_int_equal(files_in("out"), 0);
}

static void a_frame_of_a_lower_quality_shows_nothing_of_the_frames_before(void **state)
{
    (void)state;
    static struct shown all, alone;
    assert_quiet("for i in 0 1 2 3 4 5 6 7; do echo 0.$i 0.4 1; done >lights && tail -n 1 lights >last && "
                 "for of in lights last; do "
                 "$GLINT stream sunray --size 60x40 --to webp --quality 70 --lights $of -o $of.webp; done");
    show_webp("lights.webp", &all);
    show_webp("last.webp", &alone);
    assert_int_equal(all.frames, 8);
    assert_int_equal(alone.frames, 1);
    assert_memory_equal(all.rgb[7], alone.rgb[0], sizeof alone.rgb[0]);
}

static void a_size_that_a_webp_cannot_have_is_refused(void **state)
{
    (void)state;
    assert_fails("$GLINT stream coin --size 16384x1 --to webp --frames 1 -o out/a.webp",
                 "--size: 16384x1 is more than the 16383 pixels a side of a WebP");
    assert_int_equal(
        run("$GLINT stream coin --size 16383x1 --to webp --frames 1 -o out/a.webp && rm out/a.webp")->status, 0);
}

static void a_rate_that_a_webp_cannot_have_is_refused(void **state)
{
    (void)state;
    assert_fails(COIN "--to webp --fps .00005 -o out/a.webp", "--fps: 5e-05 is no rate of a WebP, whose frames last");
    assert_quiet(COIN "--to webp --fps .00006 --frames 2 -o out/a.webp && rm out/a.webp");
    assert_fails("$GLINT stream coin --size 1x1 --to webp --fps .00006 --frames 200 -o out/a.webp",
                 "--fps: 200 frames at 6e-05 a second last longer than the 24 days of a WebP; give a higher --fps");
    assert_fails("$GLINT stream coin --size 1x1 --to webp --fps .001 --frames 1000000000 -o out/a.webp",
                 "--fps: 1000000000 frames at 0.001 a second last longer"); /* before the first is drawn */
    assert_fails(
        "yes 0,0,1 | head -200 | $GLINT stream coin --size 1x1 --to webp --fps .00006 --lights - -o out/a.webp",
        "--fps: a WebP lasts at most 24 days; give a higher one");
    assert_int_equal(files_in("out"), 0);
}
#endif

#if GLINT_WITH_GIF
static void show_gif(const char *path, struct shown *shown)
{
    int error;
    GifFileType *file = DGifOpenFileName(path, &error);
    assert_non_null(file);
    assert_int_equal(DGifSlurp(file), GIF_OK);
    assert_int_equal(file->SWidth, WIDTH);
    assert_int_equal(file->SHeight, HEIGHT);
    *shown = (struct shown){.frames = (unsigned)file->ImageCount};
    assert_true(shown->frames <= FRAMES_MAX);
    for (unsigned i = 0; i < shown->frames; i++) {
        const SavedImage *image = &file->SavedImages[i];
        const GifImageDesc *at = &image->ImageDesc;
        GraphicsControlBlock control;
        assert_int_equal(DGifSavedExtensionToGCB(file, (int)i, &control), GIF_OK);
        shown->end_ms[i] = (i ? shown->end_ms[i - 1] : 0) + 10 * control.DelayTime;
        if (i)
            memcpy(shown->rgb[i], shown->rgb[i - 1], sizeof *shown->rgb);
        for (int p = 0; p < at->Width * at->Height; p++) {
            const GifColorType *color = &at->ColorMap->Colors[image->RasterBits[p]];
            uint8_t *to = &shown->rgb[i][3 * ((at->Top + p / at->Width) * WIDTH + at->Left + p % at->Width)];
            to[0] = color->Red;
            to[1] = color->Green;
            to[2] = color->Blue;
        }
    }
    DGifCloseFile(file, &error);
}

static void a_gif_shows_the_pixels_of_the_png_sink_in_256_colours_of_rgb565_each_frame_in_its_time(void **state)
{
    (void)state;
    static const struct {
        const char *format;
        unsigned most;
    } formats[] = {{"mono", 0}, {"rgb565 --model msh", 16}, {"rgb888", 20}};
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        static struct shown shown;
        char options[100], line[300];
        snprintf(options, sizeof options, "--frames 6 --fps 7 --format %s", formats[f].format);
        snprintf(line, sizeof line, COIN "--to gif %s -o a.gif", options);
        assert_quiet(line);
        show_gif("a.gif", &shown);
        assert_int_equal(shown.frames, 6);
        for (unsigned i = 0; i < 6; i++)
            assert_int_equal(shown.end_ms[i], 10 * ((200 * (i + 1) + 7) / 14));
        assert_in_range(largest_difference(options, &shown), 0, formats[f].most);
    }
    assert_quiet("grep -aq NETSCAPE2.0 a.gif"); /* it repeats */
}

static void a_picture_that_stands_still_is_a_frame_a_time_too(void **state)
{
    (void)state;
    static struct shown shown;
    assert_quiet(COIN "--to gif --frames 4 --period 0 --fps 10 -o a.gif");
    show_gif("a.gif", &shown);
    assert_int_equal(shown.frames, 4);
    assert_int_equal(shown.end_ms[3], 400);
    assert_memory_equal(shown.rgb[0], shown.rgb[3], sizeof shown.rgb[0]);
}

static void a_rate_that_a_gif_cannot_have_is_refused(void **state)
{
    (void)state;
    assert_fails(COIN "--to gif --fps 60 -o out/a.gif", "--fps: 60 is no rate of a GIF");
    assert_int_equal(files_in("out"), 0);
}
#endif

static void a_file_is_whole_or_there_is_none(void **state)
{
    (void)state;
    static const char *const names[] = {"webp", "gif"};
    static const bool there[] = {GLINT_WITH_WEBP, GLINT_WITH_GIF};
    assert_quiet("printf '1 1 1\\n1\\n' >lights.txt"); /* fails after a frame */
    for (size_t i = 0; i < 2; i++) {
        char line[400], message[100];
        if (!there[i])
            continue;
        snprintf(line, sizeof line, COIN "--to %s", names[i]);
        snprintf(message, sizeof message, "-o: --to %s writes a file; name it: -o FILE.%s", names[i], names[i]);
        assert_refused(line, message);
        snprintf(line, sizeof line, COIN "--to %s --lights lights.txt -o out/a", names[i]);
        assert_fails(line, "line 2");
        assert_int_equal(files_in("out"), 0);
        snprintf(line, sizeof line, COIN "--to %s --frames 2 -o a && " COIN "--to %s --frames 2 -o - | cmp - a",
                 names[i], names[i]);
        assert_quiet(line);
        /* A signal ends it after a whole frame, with what there is. The frame of the first light is there when more is read than a buffer
         * holds. */
        snprintf(line, sizeof line,
                 "mkfifo held; " COIN "--to %s --lights held -o out/a & exec 3>held; "
                 "{ echo 1 1 1; yes '# no light' | head -c 200000; } >&3; kill -%d $!; wait $!; test $? = %d && "
                 "test -s out/a && rm out/a held",
                 names[i], SIGTERM, 128 + SIGTERM);
        assert_quiet(line);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
#if GLINT_WITH_WEBP
        cmocka_unit_test(a_webp_shows_the_pixels_of_the_png_sink_each_frame_in_its_time),
        cmocka_unit_test(a_webp_of_argb8888_has_its_alpha),
        cmocka_unit_test(a_lower_quality_takes_fewer_bytes),
        cmocka_unit_test(a_frame_of_a_lower_quality_shows_nothing_of_the_frames_before),
        cmocka_unit_test(a_size_that_a_webp_cannot_have_is_refused),
        cmocka_unit_test(a_rate_that_a_webp_cannot_have_is_refused),
#endif
#if GLINT_WITH_GIF
        cmocka_unit_test(a_gif_shows_the_pixels_of_the_png_sink_in_256_colours_of_rgb565_each_frame_in_its_time),
        cmocka_unit_test(a_picture_that_stands_still_is_a_frame_a_time_too),
        cmocka_unit_test(a_rate_that_a_gif_cannot_have_is_refused),
#endif
        cmocka_unit_test(a_file_is_whole_or_there_is_none),
    };
    return cmocka_run_group_tests(tests, make_maps, scratch_remove);
}
