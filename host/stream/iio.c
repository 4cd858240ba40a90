/* SPDX-License-Identifier: MIT
 * The kernel's Documentation/ABI/testing/sysfs-bus-iio: in_accel_x_raw plus in_accel_offset (or in_accel_x_offset), where there is one,
 * times in_accel_scale (or in_accel_x_scale, or scale) is m/s^2; in_accel_mount_matrix, in_mount_matrix or mount_matrix turns the sensor's
 * axes into the device's: right, up and towards the viewer. A name without "in" is of all channels of a driver's. */
#include "stream/iio.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/parse.h"
#include "base/stop.h"
#include "tilt.h"

static const char usual_folder[] = "/sys/bus/iio/devices";
static const double one_g = 9.80665; /* m/s^2 */

/* A frame counts for as many samples: the light is two fifths of the way there after one. */
enum { SAMPLES_A_FRAME = 4 };

struct iio {
    char *folder; /* the device's */
    double offset[3], scale[3], mount[9];
    struct tilt tilt;
};

bool iio_is_named(const char *lights)
{
    return strcmp(lights, "iio") == 0 || strncmp(lights, "iio:", 4) == 0;
}

/* The first line of a file in the folder, without its end; NULL: there is none, or errno is EINTR. */
static char *read_file(const char *folder, const char *name)
{
    char *path = formatted("%s/%s", folder, name), *line = NULL;
    size_t room = 0;
    FILE *file = fopen(path, "r");
    free(path);
    if (!file)
        return NULL;
    errno = 0;
    const ssize_t length = getline(&line, &room, file);
    const int error = errno;
    fclose(file);
    if (length < 0) {
        free(line);
        errno = error;
        return NULL;
    }
    line[strcspn(line, "\r\n")] = '\0';
    return line;
}

/* As many numbers with commas, semicolons or blanks between; false where the text is something else. */
static bool read_numbers(const char *text, double *numbers, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        char *end;
        text += strspn(text, " \t,;");
        if (!read_real(text, &end, &numbers[i]))
            return false;
        text = end;
    }
    return text[strspn(text, " \t;")] == '\0';
}

static bool read_value(const char *folder, const char *name, double *numbers, unsigned count)
{
    char *text = read_file(folder, name);
    if (!text)
        return false;
    if (!read_numbers(text, numbers, count))
        fail("%s/%s: '%s' is not what the kernel writes there", folder, name, text);
    free(text);
    return true;
}

static bool read_axis(const struct iio *iio, unsigned axis, double *raw)
{
    const char *const names[] = {"in_accel_x_raw", "in_accel_y_raw", "in_accel_z_raw"};
    return read_value(iio->folder, names[axis], raw, 1);
}

/* error: why one that is there cannot be read, if it was 0. */
static bool is_accelerometer(const struct iio *iio, int *error)
{
    double raw;
    errno = 0;
    if (read_axis(iio, 0, &raw) && read_axis(iio, 1, &raw) && read_axis(iio, 2, &raw))
        return true;
    if (*error == 0 && errno != ENOENT && errno != ENOTDIR && errno != EINTR)
        *error = errno;
    return false;
}

static int by_name(const void *a, const void *b)
{
    return strverscmp(*(char *const *)a, *(char *const *)b);
}

/* The devices in the folder, in order; sets the first accelerometer's folder. */
static bool find_device(struct iio *iio, const char *folder, int *error)
{
    DIR *entries = opendir(folder);
    char **names = NULL;
    size_t count = 0;
    bool found = false;
    for (struct dirent *entry; entries && (entry = readdir(entries));) {
        if (strncmp(entry->d_name, "iio:device", 10) != 0)
            continue;
        names = enlarge(names, count + 1, sizeof *names);
        names[count++] = formatted("%s/%s", folder, entry->d_name);
    }
    if (entries)
        closedir(entries);
    if (count)
        qsort(names, count, sizeof *names, by_name);
    for (size_t i = 0; i < count; i++) {
        iio->folder = names[i];
        if (found || !is_accelerometer(iio, error))
            free(names[i]);
        else {
            found = true;
            names[0] = names[i];
        }
    }
    iio->folder = found ? names[0] : NULL;
    free(names);
    return found;
}

/* An axis's own value, or that of all. */
static bool read_either(const struct iio *iio, const char *own, const char *shared, double *value)
{
    return read_value(iio->folder, own, value, 1) || read_value(iio->folder, shared, value, 1);
}

static void read_scale(struct iio *iio)
{
    const char *const names[] = {"in_accel_x_scale", "in_accel_y_scale", "in_accel_z_scale"};
    for (unsigned i = 0; i < 3; i++)
        if (!read_either(iio, names[i], "in_accel_scale", &iio->scale[i]) &&
            !read_value(iio->folder, "scale", &iio->scale[i], 1))
            fail("%s: has no in_accel_scale: what its numbers mean is not known", iio->folder);
}

/* Most have none: then it is 0. */
static void read_offset(struct iio *iio)
{
    const char *const names[] = {"in_accel_x_offset", "in_accel_y_offset", "in_accel_z_offset"};
    for (unsigned i = 0; i < 3; i++)
        (void)read_either(iio, names[i], "in_accel_offset", &iio->offset[i]);
}

static void read_mount(struct iio *iio)
{
    static const double upright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (!read_value(iio->folder, "in_accel_mount_matrix", iio->mount, 9) &&
        !read_value(iio->folder, "in_mount_matrix", iio->mount, 9) &&
        !read_value(iio->folder, "mount_matrix", iio->mount, 9))
        memcpy(iio->mount, upright, sizeof upright);
}

static _Noreturn void fail_open(const char *lights, const char *folder, int error)
{
    if (error)
        fail("--lights %s: the accelerometer in %s cannot be read: %s%s", lights, folder, strerror(error),
             error == EBUSY ? "; stop the program that reads it, iio-sensor-proxy perhaps" : "");
    fail("--lights %s: no accelerometer is in %s; where it is elsewhere: --lights iio:FOLDER", lights, folder);
}

struct iio *iio_open(const char *lights)
{
    const char *folder = lights[3] ? lights + 4 : usual_folder;
    struct iio *iio = allocate(1, sizeof *iio);
    int error = 0;
    iio->folder = (char *)folder;
    if (is_accelerometer(iio, &error))
        iio->folder = copied(folder);
    else if (!find_device(iio, folder, &error))
        fail_open(lights, folder, error);
    read_offset(iio);
    read_scale(iio);
    read_mount(iio);
    return iio;
}

void iio_light(struct iio *iio, double direction[3])
{
    double g[3];
    int16_t sample[3];
    int32_t to_light[3];
    for (unsigned i = 0; i < 3; i++) {
        while (!read_axis(iio, i, &g[i])) {
            if (errno != EINTR)
                fail("%s: cannot be read any more: was the sensor removed?", iio->folder);
            if (stream_stopped())
                return;
        }
        g[i] = (g[i] + iio->offset[i]) * iio->scale[i] / one_g;
    }
    for (unsigned i = 0; i < 3; i++) {
        const double *row = &iio->mount[(size_t)3 * i], value = row[0] * g[0] + row[1] * g[1] + row[2] * g[2];
        sample[i] = (int16_t)lrint(fmax(-32768, fmin(32767, TILT_ONE_G * value)));
    }
    for (unsigned i = 0; i < SAMPLES_A_FRAME; i++)
        (void)tilt_add(&iio->tilt, sample);
    (void)tilt_light(&iio->tilt, to_light);
    for (unsigned i = 0; i < 3; i++)
        direction[i] = to_light[i] / 32768.;
}

void iio_close(struct iio *iio)
{
    if (!iio)
        return;
    free(iio->folder);
    free(iio);
}
