/* SPDX-License-Identifier: MIT */
#include "stream/light.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "base/parse.h"
#include "base/stop.h"
#include "draw/shading.h"
#include "stream/iio.h"

static const double usual_orbit = 30; /* degrees */

enum { LINE_MAX_BYTES = 1000 };

struct light_path {
    unsigned lamp; /* the one that moves */
    /* an orbit: middle + cos(turn) across + sin(turn) along */
    double period;
    double middle[3], across[3], along[3];
    /* lines */
    FILE *file;
    const char *name;
    char line[LINE_MAX_BYTES + 1];
    unsigned long number; /* of the line */
    bool any;             /* a direction was read */
    struct iio *sensor;   /* instead */
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void scale_to(double v[3], double length)
{
    const double now = sqrt(dot(v, v));
    for (unsigned k = 0; k < 3; k++)
        v[k] *= length / now;
}

/* A circle about the direction to the viewer, `degrees` from it, that starts on the light's side. */
static void set_orbit(struct light_path *path, const struct shading *shading, const struct lamp *lamp, double degrees)
{
    double *axis = path->middle, *side = path->across, light[3];
    memcpy(axis, shading->view, sizeof path->middle);
    memcpy(light, lamp->direction, sizeof light);
    scale_to(axis, 1);
    scale_to(light, 1);
    const double height = dot(light, axis);
    for (unsigned k = 0; k < 3; k++)
        side[k] = light[k] - height * axis[k];
    if (sqrt(dot(side, side)) <
        1e-9) { /* straight from the viewer: start on the right or, if the viewer is there, above */
        const unsigned k = fabs(axis[0]) < .9 ? 0 : 1;
        for (unsigned i = 0; i < 3; i++)
            side[i] = (i == k) - axis[k] * axis[i];
    }
    const double angle = isnan(degrees) ? acos(fmax(-1, fmin(1, height))) : degrees * M_PI / 180;
    scale_to(side, sin(angle));
    path->along[0] = axis[1] * side[2] - axis[2] * side[1];
    path->along[1] = axis[2] * side[0] - axis[0] * side[2];
    path->along[2] = axis[0] * side[1] - axis[1] * side[0];
    for (unsigned k = 0; k < 3; k++)
        axis[k] *= cos(angle);
}

/* About the picture's middle, at its own height. */
static void set_circle(struct light_path *path, const struct lamp *lamp, uint32_t width, uint32_t height)
{
    const double x = lamp->position[0] - width / 2., y = lamp->position[1] - height / 2.;
    memcpy(path->middle, (double[3]){width / 2., height / 2., lamp->position[2]}, sizeof path->middle);
    memcpy(path->across, (double[3]){x, y, 0}, sizeof path->across);
    memcpy(path->along, (double[3]){y, -x, 0}, sizeof path->along); /* lines go down: the same sense as above */
}

/* What may keep us waiting is not read ahead, so that poll() knows all that there is. */
static FILE *open_lines(const char *name)
{
    struct stat status;
    FILE *file = strcmp(name, "-") == 0 ? stdin : fopen(name, "r");
    if (!file)
        fail("%s: cannot be read: %s", name, strerror(errno));
    if (fstat(fileno(file), &status) == 0 && !S_ISREG(status.st_mode))
        setvbuf(file, NULL, _IONBF, 0);
    return file;
}

struct light_path *light_path_new(const struct stream_options *options)
{
    const bool is_sensor = options->lights && iio_is_named(options->lights);
    FILE *file = options->lights && !is_sensor ? open_lines(options->lights) : NULL;
    struct light_path *path = allocate(1, sizeof *path);
    path->period = options->period;
    path->sensor = is_sensor ? iio_open(options->lights) : NULL;
    if (file)
        output_never(file);
    path->file = file;
    path->name = file == stdin ? "standard input" : options->lights;
    return path;
}

void light_path_start(struct light_path *path, const struct stream_options *options, const struct shading *shading,
                      uint32_t width, uint32_t height)
{
    while (path->lamp < shading->lamp_count && shading->lamps[path->lamp].kind != LAMP_DIRECTIONAL)
        path->lamp++;
    const bool directional = path->lamp < shading->lamp_count;
    if (!directional)
        path->lamp = 0;
    const struct lamp *lamp = &shading->lamps[path->lamp];
    if (path->file || path->sensor)
        return;
    if (directional)
        set_orbit(path, shading, lamp,
                  isnan(options->orbit) && !options->look.has_light ? usual_orbit : options->orbit);
    else
        set_circle(path, lamp, width, height);
}

/* ---- lines ---- */

/* Three numbers with commas or white space between. */
static bool read_direction(char *text, double direction[3])
{
    char *at = text;
    for (unsigned k = 0; k < 3; k++) {
        char *end;
        at += strspn(at, " \t");
        if (k && *at == ',')
            at += 1 + strspn(at + 1, " \t");
        if (!read_real(at, &end, &direction[k]))
            return false;
        if (k < 2 && !strchr(" \t,", *end))
            return false;
        at = end;
    }
    return at[strspn(at, " \t\r")] == '\0';
}

/* Up to its newline; longer than LINE_MAX_BYTES it is cut, which is refused. Negative: there is none. */
static ssize_t read_line(struct light_path *path)
{
    size_t length = 0;
    int byte = 0;
    while (length < LINE_MAX_BYTES && byte != '\n' && (byte = getc(path->file)) != EOF)
        path->line[length++] = (char)byte;
    path->line[length] = '\0';
    return length && !ferror(path->file) ? (ssize_t)length : -1;
}

static bool next_line(struct light_path *path, struct shading *shading)
{
    for (;;) {
        errno = 0;
        const ssize_t length = stream_stopped() ? -1 : read_line(path); /* blank lines may never end */
        if (length < 0) {
            if (ferror(path->file) && errno != EINTR)
                fail("%s: cannot be read: %s", path->name, strerror(errno));
            if (!path->any && !stream_stopped())
                fail("%s: holds no direction; write three numbers a line, X Y Z", path->name);
            return false;
        }
        path->number++;
        if (length == LINE_MAX_BYTES)
            fail("%s, line %lu: has more than %d bytes; write three numbers, \"X Y Z\" or \"X,Y,Z\"", path->name,
                 path->number, LINE_MAX_BYTES - 1);
        char *text = path->number == 1 ? after_byte_order_mark(path->line) : path->line;
        text[strcspn(text, "\n")] = '\0';
        const size_t blank = strspn(text, " \t\r");
        const bool is_blank = text + blank + 1 >= path->line + length; /* else a zero that is not its end */
        if ((!text[blank] && is_blank) || text[blank] == '#')
            continue;
        struct lamp *lamp = &shading->lamps[path->lamp];
        if (text + strlen(text) + 1 < path->line + length || !read_direction(text, lamp->direction))
            fail("%s, line %lu: '%s' is not a direction; write three numbers, \"X Y Z\" or \"X,Y,Z\"", path->name,
                 path->number, text);
        struct glint_light unused;
        if (shading_light(shading, path->lamp, &unused) != GLINT_OK)
            fail("%s, line %lu: '%s' %s", path->name, path->number, text,
                 dot(lamp->direction, lamp->direction) > 0 ? "is straight opposite to --view: there is no half vector"
                                                           : "has no direction; it must not be 0,0,0");
        path->any = true;
        return true;
    }
}

/* ---- a sensor ---- */

/* Where the viewer is not above it, the light may be straight behind. */
static bool next_tilt(struct light_path *path, struct shading *shading)
{
    struct glint_light unused;
    iio_light(path->sensor, shading->lamps[path->lamp].direction);
    if (shading_light(shading, path->lamp, &unused) != GLINT_OK)
        fail("--lights iio: the light is straight opposite to --view: there is no half vector; leave --view out");
    return true;
}

/* ---- */

bool light_path_is_ready(const struct light_path *path, int ms)
{
    struct pollfd lines = {.fd = path->file ? fileno(path->file) : -1, .events = POLLIN};
    const int ready = lines.fd < 0 ? 1 : poll(&lines, 1, ms);
    return ready > 0 || (ready < 0 && errno != EINTR) || stream_stopped();
}

bool light_path_next(struct light_path *path, double seconds, struct shading *shading)
{
    if (path->file)
        return next_line(path, shading);
    if (path->sensor)
        return next_tilt(path, shading);
    struct lamp *lamp = &shading->lamps[path->lamp];
    double *at = lamp->kind == LAMP_DIRECTIONAL ? lamp->direction : lamp->position;
    const double turn = path->period > 0 ? 2 * M_PI * fmod(seconds / path->period, 1) : 0;
    for (unsigned k = 0; k < 3; k++)
        at[k] = path->middle[k] + cos(turn) * path->across[k] + sin(turn) * path->along[k];
    return true;
}

void light_path_free(struct light_path *path)
{
    if (!path)
        return;
    if (path->file && path->file != stdin)
        fclose(path->file);
    iio_close(path->sensor);
    free(path);
}
