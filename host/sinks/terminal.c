/* SPDX-License-Identifier: MIT
 * Sink terminal: frames on standard output by libchafa, as pixels where the terminal takes them, else as symbols. */
#include <chafa.h>
#include <langinfo.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "image/levels.h"
#include "image/picture.h"
#include "sinks/sink.h"

static const char show_start[] = "\033[?25l\033[2J", show_end[] = "\033[?25h\033[0m\n"; /* the cursor; clear; colours */

struct terminal {
    struct sink sink;
    ChafaTermInfo *info;
    ChafaSymbolMap *symbols;
    ChafaCanvas *canvas;
    struct winsize size; /* the canvas's */
    bool started;        /* the cursor is hidden */
};

static ChafaPixelMode pixel_mode(ChafaTermInfo *info)
{
    if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_BEGIN_KITTY_IMMEDIATE_IMAGE_V1))
        return CHAFA_PIXEL_MODE_KITTY;
    if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_BEGIN_SIXELS))
        return CHAFA_PIXEL_MODE_SIXELS;
    return CHAFA_PIXEL_MODE_SYMBOLS;
}

static ChafaCanvasMode canvas_mode(ChafaTermInfo *info)
{
    const char *no_color = getenv("NO_COLOR");
    if (no_color && *no_color)
        return CHAFA_CANVAS_MODE_FGBG;
    if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_DIRECT))
        return CHAFA_CANVAS_MODE_TRUECOLOR;
    if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_256))
        return CHAFA_CANVAS_MODE_INDEXED_256;
    if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_16))
        return CHAFA_CANVAS_MODE_INDEXED_16;
    return CHAFA_CANVAS_MODE_FGBG;
}

/* The terminal's size now; 80 x 24 with cells of 8 x 16 where it does not say. */
static struct winsize terminal_size(void)
{
    struct winsize size = {0};
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    if (!size.ws_col || !size.ws_row) {
        size.ws_col = 80;
        size.ws_row = 24;
    }
    if (!size.ws_xpixel || !size.ws_ypixel) {
        size.ws_xpixel = (unsigned short)(8 * size.ws_col);
        size.ws_ypixel = (unsigned short)(16 * size.ws_row);
    }
    return size;
}

static void make_canvas(struct terminal *terminal)
{
    const struct winsize *size = &terminal->size;
    const int cell_width = size->ws_xpixel / size->ws_col, cell_height = size->ws_ypixel / size->ws_row;
    int columns = size->ws_col, rows = size->ws_row > 1 ? size->ws_row - 1 : 1; /* one for the shell's next prompt */
    const bool no_color = canvas_mode(terminal->info) == CHAFA_CANVAS_MODE_FGBG;
    chafa_calc_canvas_geometry(terminal->sink.width, terminal->sink.height, &columns, &rows,
                               (gfloat)cell_width / (gfloat)(cell_height ? cell_height : 1), TRUE, FALSE);
    ChafaCanvasConfig *config = chafa_canvas_config_new();
    chafa_canvas_config_set_geometry(config, columns > 0 ? columns : 1, rows > 0 ? rows : 1);
    chafa_canvas_config_set_cell_geometry(config, cell_width ? cell_width : 8, cell_height ? cell_height : 16);
    chafa_canvas_config_set_canvas_mode(config, canvas_mode(terminal->info));
    chafa_canvas_config_set_pixel_mode(config, no_color ? CHAFA_PIXEL_MODE_SYMBOLS : pixel_mode(terminal->info));
    chafa_canvas_config_set_symbol_map(config, terminal->symbols);
    if (terminal->canvas)
        chafa_canvas_unref(terminal->canvas);
    terminal->canvas = chafa_canvas_new(config);
    chafa_canvas_config_unref(config);
}

static struct sink *open_terminal(const struct sink_wish *wish)
{
    if (!isatty(STDOUT_FILENO))
        fail("--to terminal: standard output is no terminal; use --to png or --to raw");
    struct terminal *terminal = allocate(1, sizeof *terminal);
    terminal->sink = (struct sink){.kind = &sink_terminal,
                                   .width = wish->width ? wish->width : wish->default_width,
                                   .height = wish->height ? wish->height : wish->default_height,
                                   .format = wish->format < 0 ? GLINT_RGB888 : (enum glint_format)wish->format,
                                   .align_x = 1,
                                   .whole_frames = true,
                                   .max_bytes = SIZE_MAX,
                                   .name = "the terminal"};
    stop_last_words(show_end);
    char **environment = g_get_environ();
    terminal->info = chafa_term_db_detect(chafa_term_db_get_default(), environment);
    g_strfreev(environment);
    setlocale(LC_CTYPE, "");
    terminal->symbols = chafa_symbol_map_new();
    chafa_symbol_map_add_by_tags(terminal->symbols,
                                 strcmp(nl_langinfo(CODESET), "UTF-8") == 0
                                     ? CHAFA_SYMBOL_TAG_SPACE | CHAFA_SYMBOL_TAG_BLOCK | CHAFA_SYMBOL_TAG_BORDER
                                     : CHAFA_SYMBOL_TAG_ASCII);
    terminal->size = terminal_size();
    make_canvas(terminal);
    return &terminal->sink;
}

static enum sink_result send_terminal(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                      size_t count)
{
    (void)pieces;
    (void)count;
    struct terminal *terminal = (struct terminal *)sink;
    const struct winsize size = terminal_size();
    const bool resized = memcmp(&size, &terminal->size, sizeof size) != 0;
    if (resized) {
        terminal->size = size;
        make_canvas(terminal);
    }
    struct picture *picture = frame_picture(frame);
    uint8_t *rgb = picture_rgb(picture);
    chafa_canvas_draw_all_pixels(terminal->canvas, CHAFA_PIXEL_RGB8, rgb, frame->width, frame->height,
                                 3 * frame->width);
    free(rgb);
    picture_free(picture);
    GString *text = chafa_canvas_print(terminal->canvas, terminal->info);
    enum sink_result result = SINK_SENT;
    if (resized || !terminal->started)
        result = standard_output_write(show_start, sizeof show_start - 1);
    terminal->started = true;
    if (result == SINK_SENT)
        result = standard_output_write("\033[H", 3);
    if (result == SINK_SENT)
        result = standard_output_write(text->str, text->len);
    g_string_free(text, TRUE);
    return result;
}

/* Whatever happened: the cursor comes back, below the picture. */
static void close_terminal(struct sink *sink)
{
    struct terminal *terminal = (struct terminal *)sink;
    if (terminal->started && write(STDOUT_FILENO, show_end, sizeof show_end - 1) < 0)
        warn("%s: could not be restored; `reset` does that", sink->name);
    stop_last_words(NULL);
    chafa_canvas_unref(terminal->canvas);
    chafa_symbol_map_unref(terminal->symbols);
    chafa_term_info_unref(terminal->info);
    free(terminal);
}

static char *library(void)
{
    char *text = NULL;
    return asprintf(&text, "libchafa %d.%d.%d", CHAFA_MAJOR_VERSION, CHAFA_MINOR_VERSION, CHAFA_MICRO_VERSION) < 0
               ? NULL
               : text;
}

const struct sink_kind sink_terminal = {
    .name = "terminal",
    .summary = "this terminal, in pixels (kitty, sixel) or symbols; heeds NO_COLOR",
    .nature = SINK_DEVICE,
    .takes_standard_output = true,
    .examples = "  glint stream coin --to terminal --point 240,80,60,300,1,.7,.3\n",
    .open = open_terminal,
    .send = send_terminal,
    .close = close_terminal,
    .library = library,
};
