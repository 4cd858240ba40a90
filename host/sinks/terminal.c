/* SPDX-License-Identifier: MIT
 * Sink terminal: frames on standard output by libchafa, as pixels where the terminal takes them, else as symbols. */
#include <chafa.h>
#include <langinfo.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "sinks/frames.h"
#include "sinks/outputs.h"
#include "sinks/write.h"

static const char name[] = "the terminal";
static const char show_start[] = "\033[?25l\033[2J", show_end[] = "\033[?25h\033[0m\n"; /* the cursor; clear; colours */

struct cells {
    int columns, rows, width, height; /* the terminal in cells, and a cell in pixels */
};

struct terminal {
    struct sink sink;
    ChafaTermInfo *info;
    ChafaSymbolMap *symbols;
    ChafaCanvas *canvas;
    struct cells cells; /* that the canvas was made for */
    bool started;       /* the cursor is hidden */
    unsigned resumed;   /* stop_resumed() at the last frame */
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

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* The size of the terminal now: 80 x 24 where it does not say, cells of 8 x 16 pixels where it does not say or cannot mean
 * what it says. libchafa computes pixels in 32 bits and holds 64 of them a cell even for symbols: so no more cells than any
 * screen has, and no side of more than CANVAS_MAX pixels. */
static struct cells terminal_cells(void)
{
    enum { CELL_MAX = 128, COLUMNS_MAX = 1024, ROWS_MAX = 512, CANVAS_MAX = 8192 };
    struct winsize size = {0};
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    const bool known = size.ws_col && size.ws_row;
    struct cells cells = {.columns = known ? size.ws_col : 80, .rows = known ? size.ws_row : 24};
    cells.width = size.ws_xpixel / cells.columns;
    cells.height = size.ws_ypixel / cells.rows;
    if (!cells.width || !cells.height || cells.width > CELL_MAX || cells.height > CELL_MAX) {
        cells.width = 8;
        cells.height = 16;
    }
    cells.columns = least(cells.columns, least(COLUMNS_MAX, CANVAS_MAX / cells.width));
    cells.rows = least(cells.rows, least(ROWS_MAX, CANVAS_MAX / cells.height));
    return cells;
}

static void make_canvas(struct terminal *terminal)
{
    const struct cells *cells = &terminal->cells;
    int columns = cells->columns, rows = cells->rows > 1 ? cells->rows - 1 : 1; /* one for the shell's next prompt */
    const bool no_color = canvas_mode(terminal->info) == CHAFA_CANVAS_MODE_FGBG;
    chafa_calc_canvas_geometry(terminal->sink.width, terminal->sink.height, &columns, &rows,
                               (gfloat)cells->width / (gfloat)cells->height, TRUE, FALSE);
    ChafaCanvasConfig *config = chafa_canvas_config_new();
    chafa_canvas_config_set_geometry(config, columns > 0 ? columns : 1, rows > 0 ? rows : 1);
    chafa_canvas_config_set_cell_geometry(config, cells->width, cells->height);
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
        fail("--to terminal: standard output is not a terminal; choose another sink");
    frames_without_alpha(wish, "terminal");
    struct terminal *terminal = allocate(1, sizeof *terminal);
    terminal->sink = (struct sink){.format = wish->format < 0 ? GLINT_RGB888 : (enum glint_format)wish->format,
                                   .align_x = 1,
                                   .whole_frames = true,
                                   .max_bytes = SIZE_MAX,
                                   .name = name};
    sink_size(&terminal->sink, wish);
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
    terminal->cells = terminal_cells();
    make_canvas(terminal);
    return &terminal->sink;
}

static enum sink_result send_terminal(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                      size_t count)
{
    (void)pieces;
    (void)count;
    struct terminal *terminal = (struct terminal *)sink;
    const struct cells cells = terminal_cells();
    const bool resized = memcmp(&cells, &terminal->cells, sizeof cells) != 0;
    const bool resumed = terminal->resumed != stop_resumed();
    terminal->resumed = stop_resumed();
    if (resized) {
        terminal->cells = cells;
        make_canvas(terminal);
    }
    uint8_t *rgb = frame_rgb(frame);
    sigset_t before;
    /* The threads that libchafa leaves waiting hold them, too: the first alone takes them. */
    signals_hold_but_faults(&before);
    chafa_canvas_draw_all_pixels(terminal->canvas, CHAFA_PIXEL_RGB8, rgb, frame->width, frame->height,
                                 3 * frame->width);
    GString *text = chafa_canvas_print(terminal->canvas, terminal->info);
    signals_release(&before);
    free(rgb);
    enum sink_result result = SINK_SENT;
    if (resized || resumed || !terminal->started)
        result = sink_write(STDOUT_FILENO, name, show_start, sizeof show_start - 1);
    terminal->started = true;
    if (result == SINK_SENT)
        result = sink_write(STDOUT_FILENO, name, "\033[H", 3);
    if (result == SINK_SENT)
        result = sink_write(STDOUT_FILENO, name, text->str, text->len);
    g_string_free(text, TRUE);
    return result;
}

/* Whatever happened: the cursor comes back, below the picture. */
static void close_terminal(struct sink *sink)
{
    struct terminal *terminal = (struct terminal *)sink;
    stop_last_words(NULL);
    if (terminal->started && sink_write_error(STDOUT_FILENO, show_end, sizeof show_end - 1) != 0)
        warn("%s: its cursor could not be restored; run `reset`", sink->name);
    chafa_canvas_unref(terminal->canvas);
    chafa_symbol_map_unref(terminal->symbols);
    chafa_term_info_unref(terminal->info);
    free(terminal);
}

static char *library(void)
{
    return formatted("libchafa %d.%d.%d", CHAFA_MAJOR_VERSION, CHAFA_MINOR_VERSION, CHAFA_MICRO_VERSION);
}

const struct sink_kind sink_terminal = {
    .name = "terminal",
    .summary = "this terminal, in pixels (kitty, sixel) or symbols; obeys NO_COLOR",
    .output = &output_terminal,
    .paced = true,
    .examples = "  glint stream coin --to terminal --point 240,80,60,300,1,.7,.3\n",
    .pixels = {.open = open_terminal, .send = send_terminal, .close = close_terminal},
    .library = library,
};
