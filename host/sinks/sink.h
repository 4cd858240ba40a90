/* SPDX-License-Identifier: MIT
 * Where streamed frames go: one file a sink (sink_NAME.c), behind this interface. A sink knows its device; what changed,
 * how it is cut into pieces and when to send belongs to the stream (stream.c, plan.c). */
#ifndef GLINT_SINK_H
#define GLINT_SINK_H

#include <argp.h>
#include <jansson.h>

#include "glint.h"

/* A whole frame as the library wrote it, lines packed. */
struct frame {
    uint16_t width, height;
    enum glint_format format;
    size_t line_bytes;
    const uint8_t *pixels;
};

/* A rectangle in the sink's own form, ready to send. */
struct piece {
    struct glint_box box;
    bool lz4;             /* data is one raw LZ4 block */
    size_t bytes, length; /* of data; of the same uncompressed */
    const uint8_t *data;
};

/* What a user asked for; 0 or negative where it is left to the sink. */
struct sink_wish {
    uint16_t width, height;
    int format;                             /* enum glint_format, or -1 */
    uint16_t default_width, default_height; /* the scene's own, for sinks that take any size */
    const char *output;                     /* -o, for SINK_FILES: NULL, or a name for frame_name() */
};

/* What sending takes, for choosing the cheapest form. */
struct sink_cost {
    double rectangle_s; /* before the first byte of each piece */
    double bytes_per_s;
};

enum sink_result {
    SINK_SENT,
    SINK_INTERRUPTED, /* a signal came; see stream_stopped() */
    SINK_GONE         /* the device went away; sink_kind.open may find it again */
};

struct sink_kind;
/* Filled by open; each sink embeds it as its first member. */
struct sink {
    const struct sink_kind *kind;
    uint16_t width, height;
    enum glint_format format; /* that frames must have */
    uint16_t align_x;         /* boxes start at, and end at, a multiple of it (or at the edge); 1: anywhere */
    bool whole_frames;        /* files: each frame is sent as one piece, changed or not */
    bool lz4;                 /* does it take compressed pieces? */
    size_t max_bytes;         /* of a piece uncompressed; at least a line; SIZE_MAX: no limit */
    struct sink_cost cost;
    const char *name; /* of the device, for messages: "usb 1-3.1", "gpiochip0" */
};

enum sink_nature {
    SINK_DEVICE, /* somebody looks at it: paced by --fps, until stopped */
    SINK_PIPE,   /* as fast as it takes them; one turn of the light, unless --frames says more */
    SINK_FILES   /* likewise, and named by -o */
};

struct sink_kind {
    const char *name;    /* as --to takes it */
    const char *summary; /* one line for the help */
    enum sink_nature nature;
    bool takes_standard_output; /* so that words go to standard error */
    /* SINK_FILES: -o where none is given, and then a name without a number is one picture, the last. NULL: -o must be given,
     * with a place for the frame's number. */
    const char *usual_output;
    /* Its own options, parsed into the sink's files, or NULL; ends with NULL. Sinks may share some. (sink_options.c) */
    const struct argp *const *options;
    const char *help, *examples; /* for the end of the help, whole lines; or NULL */
    /* Ends the program through fail() with one line where it cannot. Returns NULL only where interrupted. */
    struct sink *(*open)(const struct sink_wish *wish);
    /* Bytes of a box in the sink's own form, and the box's pixels in it. NULL: rows as the library wrote them, packed. */
    size_t (*box_bytes)(const struct sink *sink, const struct glint_box *box);
    void (*pack)(const struct sink *sink, const struct frame *frame, const struct glint_box *box, uint8_t *out);
    /* The pieces of one frame, in order (none: only to SINK_FILES, which may want a file all the same); their data stays
     * until the next send or close. Returns when they are sent or safely under way. */
    enum sink_result (*send)(struct sink *sink, const struct frame *frame, const struct piece *pieces, size_t count);
    /* --shade device: a device that shades by itself is opened by open_shader, gets the scene once (normals as
     * GLINT_NORMALS_INT8, the shader's light does not matter), then a light a frame. NULL: no device of this kind does. */
    struct sink *(*open_shader)(const struct sink_wish *wish);
    enum sink_result (*send_scene)(struct sink *sink, const struct glint_shader *shader, const uint32_t *normals);
    enum sink_result (*send_light)(struct sink *sink, const int32_t to_light[3], size_t *bytes);
    /* Waits for what is under way, leaves the device in a defined state, frees. Also called when interrupted or failing:
     * must not fail() itself, only warn(). */
    void (*close)(struct sink *sink);
    /* The devices there are, as a JSON array of objects, and the same as text (glint list). NULL: nothing to list. */
    json_t *(*list)(void);
    void (*list_print)(const json_t *devices, FILE *stream);
    /* The library behind it and its version, malloc'd, for --version. NULL: none. */
    char *(*library)(void);
};

/* USB at full speed, as seen in the field, for predictions: bytes a second, and seconds to announce a rectangle.
 * (stream_stats.c) */
enum { USB_RATES = 2 };
extern const double usb_rates[USB_RATES], usb_rectangle_s;

/* Those compiled in are named in sinks.def, and nowhere else. */
#define SINK(name) extern const struct sink_kind sink_##name;
#define LEFT_OUT(name, packages)
#include "sinks/sinks.def"
#undef SINK
#undef LEFT_OUT
enum { SINKS_MAX = 16 };
/* The default first; ends with NULL (sinks.c). */
extern const struct sink_kind *const sink_kinds[];
/* Those that this build is without; ends with a NULL name (sinks.c). */
extern const struct sink_left_out {
    const char *name, *packages;
} sinks_left_out[];

/* ---- for sinks that write (frames.c) ---- */

/* The name of frame `index`, malloc'd: `pattern` with the number where it has its %d or %04d. */
char *frame_name(const char *pattern, unsigned long index);
/* Is there a place for a number in it? Refuses a pattern that has two, or a % of another kind. */
bool frame_pattern(const struct argp_state *state, const char *option, const char *pattern);
struct picture *frame_picture(const struct frame *frame); /* image/picture.h */
/* All of it, or until a signal came; else fail(). */
enum sink_result standard_output_write(const void *bytes, size_t count);

#endif
