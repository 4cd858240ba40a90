/* SPDX-License-Identifier: MIT
 * Where streamed frames go: one file a sink, behind this interface. A sink knows its device; what changed, how it is cut
 * into pieces and when to send belong to the stream (stream/, plan/). To add a sink: its file defines `const struct
 * sink_kind sink_NAME`, and sinks.def names it; help, list and checks of the command line come from the data here. */
#ifndef GLINT_SINK_H
#define GLINT_SINK_H

#include <argp.h>
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "glint.h"
#include "sinks/cost.h"

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

/* What a user asked for; 0 or negative where the sink decides. */
struct sink_wish {
    uint16_t width, height;
    int format;                             /* enum glint_format, or -1 */
    uint16_t default_width, default_height; /* the scene's own, for sinks that take any size */
    double fps;                             /* frames a second; 0: as fast as the sink takes them */
    unsigned long frames;                   /* 0: until stopped, or until the lights end */
    bool demo;                              /* of a device that shades: what it shows by itself */
    const char *output;                     /* -o; NULL only where the sink's output has none */
};

enum sink_result {
    SINK_SENT,
    SINK_INTERRUPTED, /* a signal came: see base/stop.h */
    SINK_GONE         /* the device went away; opening it again may find it */
};

struct sink_kind;

/* Where the bytes go, which decides what -o means. sinks/outputs.h has the usual kinds. */
struct sink_output {
    const char *word;    /* as glint list --json has it */
    const char *written; /* what -o names: "a file"; NULL: there is no -o */
    const char *example; /* of -o; where it ends with a dot, the sink's name follows */
    bool dash;           /* -o - is standard output */
    bool piped;          /* it writes frames to standard output, which must be a pipe or a file */
    bool shown;          /* it writes frames to standard output, which must be a terminal */
    /* More checks of -o, as a part of the command line's, and before anything is done to a device. NULL: none. */
    void (*check)(const struct argp_state *state, const struct sink_kind *kind, const char *output,
                  unsigned long frames);
    void (*begin)(const char *output, unsigned long frames);
};

/* An open sink. Each sink embeds it as its first member. */
struct sink {
    const struct sink_kind *kind; /* set by sink_open, as is the next */
    bool shades;                  /* it takes a scene and lights, not pixels */
    uint16_t width, height;
    enum glint_format format; /* that frames must have */
    uint16_t align_x;         /* boxes start at, and end at, a multiple of it (or at the edge); 1: anywhere */
    bool whole_frames;        /* each frame is sent as one piece, changed or not */
    bool lz4;                 /* does it take compressed pieces? */
    size_t max_bytes;         /* of a piece uncompressed; at least a line; SIZE_MAX: no limit */
    struct sink_cost cost;
    const char *name; /* of the device, for messages: "usb 1-3.1", "gpiochip0" */
};

/* Frames as pixels. */
struct sink_pixels {
    /* Ends the program through fail() with one line where it cannot. Returns NULL only where interrupted. */
    struct sink *(*open)(const struct sink_wish *wish);
    /* Bytes of a box in the sink's own form, and the box's pixels in it. NULL: rows as the library wrote them, packed. */
    size_t (*box_bytes)(const struct sink *sink, const struct glint_box *box);
    void (*pack)(const struct sink *sink, const struct frame *frame, const struct glint_box *box, uint8_t *out);
    /* The pieces of one frame, in order; none only for a sink of every_frame. Their data stay until the next send or
     * close. Returns when they are sent or safely under way. */
    enum sink_result (*send)(struct sink *sink, const struct frame *frame, const struct piece *pieces, size_t count);
    /* All frames are sent, or a signal ended the stream after a whole one: what was written gets its name. May fail().
     * NULL: nothing to do. Close follows. */
    void (*finish)(struct sink *sink);
    /* Waits for what is under way, leaves the device in a defined state, discards an output that was not finished, frees.
     * Also called when interrupted or failing: must not fail(), only warn(). */
    void (*close)(struct sink *sink);
};

struct light_material; /* light_protocol.h */
struct light_mesh;
struct light_pose;

/* A device that shades by itself gets the scene once, then a light a frame. */
struct sink_shader {
    struct sink *(*open)(const struct sink_wish *wish); /* as above */
    /* Normals as GLINT_NORMALS_INT8. */
    enum sink_result (*send_scene)(struct sink *sink, const struct light_material *material, const uint32_t *normals);
    /* Where it shows its own, that one's light. */
    enum sink_result (*send_light)(struct sink *sink, const int32_t to_light[3], size_t *bytes);
    /* The mesh that lies in the device, if it holds one. Then its material, and poses instead of lights. */
    enum sink_result (*find_mesh)(struct sink *sink, struct light_mesh *mesh, bool *holds_one);
    enum sink_result (*send_mesh)(struct sink *sink, const struct light_material *material);
    enum sink_result (*send_pose)(struct sink *sink, const struct light_pose *pose, size_t *bytes);
    /* Where the room's light is, as the device's own sensor has it: about 2^15 long. Ends the program where it has none. */
    enum sink_result (*read_light)(struct sink *sink, int32_t to_light[3]);
    void (*close)(struct sink *sink); /* as above */
};

/* What a kind of sink is and can do. */
struct sink_kind {
    const char *name;                 /* as --to takes it */
    const char *summary;              /* one line for the help and the list */
    const struct sink_output *output; /* NULL: a device, or nowhere; no -o */
    const char
        *usual_output; /* -o where none is given; then a name without a number is one picture, the last. NULL: none */
    bool paced;        /* --fps sets the pace, and frames go on until stopped; else one turn of the light, unpaced */
    bool every_frame;  /* send is called for a frame that changed nothing, too */
    bool may_go;       /* unplugged or reset, which only what is sent to it tells */
    bool wants_fps;    /* what it writes states the frame rate: --fps 0 is refused */
    const struct argp *const *options; /* its own, some perhaps shared with other sinks; ends with NULL. NULL: none */
    const char *help, *examples;       /* for the end of the help, whole lines; or NULL */
    struct sink_pixels pixels;
    const struct sink_shader *shader; /* NULL: no device of this kind shades */
    /* The devices there are, as a JSON array of objects, and the same as text (glint list). NULL: it has no devices. */
    json_t *(*list)(void);
    void (*list_print)(const json_t *devices, FILE *stream);
    /* The library behind it and its version, malloc'd, for --version. NULL: none. */
    char *(*library)(void);
};

/* Opens for pixels or, where `shades`, for a scene and lights; NULL only where interrupted. */
struct sink *sink_open(const struct sink_kind *kind, bool shades, const struct sink_wish *wish);
void sink_finish(struct sink *sink); /* close follows */
void sink_close(struct sink *sink);
/* The size of a sink that takes any: as the user asked, else the scene's own. */
void sink_size(struct sink *sink, const struct sink_wish *wish);
/* Do frames to this output go to standard output? Then words go to standard error. */
bool sink_takes_standard_output(const struct sink_kind *kind, const char *output);

#endif
