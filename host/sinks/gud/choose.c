/* SPDX-License-Identifier: MIT */
#include "sinks/gud/choose.h"

#include <string.h>

#include "image/format.h"
#include "image/picture.h"
#include "sinks/gud/pack.h"

/* Appends to a text; what does not fit is left out. */
static void add(char *text, size_t size, const char *more)
{
    const size_t length = strlen(text);
    snprintf(text + length, size - length, "%s%s", length ? ", " : "", more);
}

static const char *formats_text(const struct gud_display *display, char *text, size_t size)
{
    *text = '\0';
    for (size_t i = 0; i < display->format_count; i++) {
        char number[16];
        const char *name = gud_format_name(display->formats[i]);
        snprintf(number, sizeof number, "GUD's %02x", display->formats[i]);
        add(text, size, name ? name : number);
    }
    return text;
}

static const char *modes_text(const struct gud_display *display, char *text, size_t size)
{
    *text = '\0';
    for (size_t i = 0; i < display->mode_count; i++) {
        char mode[32];
        snprintf(mode, sizeof mode, "%ux%u", display->modes[i].hdisplay, display->modes[i].vdisplay);
        add(text, size, mode);
    }
    return text;
}

/* The fewest bytes that are colour: RGB565, RGB888, XRGB8888; without colour as the display lists them. */
static unsigned rank(uint8_t format)
{
    const int pixels = gud_glint_format(format);
    return pixels == GLINT_GREY8 || pixels == GLINT_MONO ? 100 : (unsigned)gud_line_bytes((enum gud_format)format, 1);
}

/* By the name of its pixels in the library, or by its own, as `glint list` shows it. */
static bool is_wanted(uint8_t format, int wanted)
{
    return wanted < 0 || gud_glint_format(format) == wanted || !strcmp(gud_format_name(format), format_names[wanted]);
}

static bool choose_format(const struct gud_display *display, int wanted, struct gud_choice *choice,
                          struct gud_problem *problem)
{
    int best = -1;
    for (size_t i = 0; i < display->format_count; i++) {
        const uint8_t format = display->formats[i];
        if (gud_glint_format(format) >= 0 && is_wanted(format, wanted) &&
            (best < 0 || rank(format) < rank((uint8_t)best)))
            best = format;
    }
    if (best < 0) {
        char text[100];
        return gud_problem_is(problem, GUD_LINK_ERROR, "it does not take %s; it offers %s",
                              wanted < 0 ? "any format of glint's" : format_names[wanted],
                              formats_text(display, text, sizeof text));
    }
    choice->format = (enum gud_format)best;
    choice->pixels = (enum glint_format)gud_glint_format((uint8_t)best);
    return true;
}

static bool choose_mode(const struct gud_display *display, const struct sink_wish *wish, struct gud_choice *choice,
                        struct gud_problem *problem)
{
    const struct gud_mode *best = NULL;
    for (size_t i = 0; i < display->mode_count; i++) {
        const struct gud_mode *mode = &display->modes[i];
        if (wish->width ? mode->hdisplay != wish->width || mode->vdisplay != wish->height : false)
            continue;
        if (!best || (mode->flags & GUD_MODE_PREFERRED && !(best->flags & GUD_MODE_PREFERRED)))
            best = mode;
    }
    if (!best) {
        char text[140];
        return gud_problem_is(problem, GUD_LINK_ERROR, "it has no mode %ux%u; it has %s", wish->width, wish->height,
                              modes_text(display, text, sizeof text));
    }
    choice->mode = *best;
    return true;
}

bool gud_choose(const struct gud_display *display, const struct sink_wish *wish, struct gud_choice *choice,
                struct gud_problem *problem)
{
    if (!choose_format(display, wish->format, choice, problem) || !choose_mode(display, wish, choice, problem))
        return false;
    if (!picture_size_fits(choice->mode.hdisplay, choice->mode.vdisplay))
        return gud_problem_is(problem, GUD_LINK_ERROR,
                              "its mode %ux%u is too large; the most is %d pixels a side and %d in all",
                              choice->mode.hdisplay, choice->mode.vdisplay, SIDE_MAX, PIXELS_MAX);
    const uint32_t limit = display->descriptor.max_buffer;
    const size_t line = gud_line_bytes(choice->format, choice->mode.hdisplay), frame = line * choice->mode.vdisplay;
    if (frame > GUD_HOST_FRAME_MAX)
        return gud_problem_is(problem, GUD_LINK_ERROR, "its mode %ux%u takes %zu bytes a frame; the most is %d",
                              choice->mode.hdisplay, choice->mode.vdisplay, frame, GUD_HOST_FRAME_MAX);
    if (limit && limit < line)
        return gud_problem_is(problem, GUD_LINK_ERROR, "it takes %u bytes a rectangle, and a line has %zu", limit,
                              line);
    choice->max_bytes = limit && limit < frame ? limit : frame;
    choice->lz4 =
        display->descriptor.compression & GUD_COMPRESSION_LZ4 && !(display->descriptor.flags & GUD_FLAG_FULL_UPDATE);
    return true;
}
