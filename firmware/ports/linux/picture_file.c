/* SPDX-License-Identifier: MIT
 * A picture is written beside its place under a name that nobody else has, and then renamed. The program runs as root,
 * perhaps in a folder of others: the name is made by mkstemp, which follows no link and opens no file that exists. */
#include "picture_file.h"

#include <errno.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "message.h"

#define PART ".part-XXXXXX"
enum { NUMBER_LEN = 7 + 4 /* -000001, and room for more digits */ };

/* The file's mode is what the umask allows, as fopen would have it; mkstemp's is 0600. */
static FILE *open_part(const char *path, char part[PATH_ROOM])
{
    snprintf(part, PATH_ROOM, "%s" PART, path);
    const int file = mkstemp(part);
    if (file < 0)
        return NULL;
    const mode_t mask = umask(0);
    umask(mask);
    FILE *stream = fchmod(file, 0666 & ~mask) == 0 ? fdopen(file, "w") : NULL;
    if (!stream) {
        close(file);
        unlink(part);
    }
    return stream;
}

void picture_file_check(const char *path)
{
    struct stat there;
    if (!*path)
        fail("-o: the file name is empty");
    if (strlen(path) + NUMBER_LEN + sizeof PART > PATH_ROOM)
        fail("-o: the path has %zu bytes; at most %zu are possible", strlen(path),
             PATH_ROOM - NUMBER_LEN - sizeof PART);
    /* Only files: a picture in the place of a device would be in everybody's way. */
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode))
        fail("-o: %s is not a file: choose a file, or a new name", path);
    char part[PATH_ROOM];
    FILE *stream = open_part(path, part);
    if (!stream)
        fail("-o: %s cannot be written: %s", path, strerror(errno));
    fclose(stream);
    unlink(part);
}

static const char *suffix(const char *path)
{
    const char *name = strrchr(path, '/');
    const char *dot = strrchr(name ? name : path, '.');
    return dot ? dot : path + strlen(path);
}

void picture_file_number(char numbered[PATH_ROOM], const char *path, unsigned number)
{
    const char *kind = suffix(path);
    snprintf(numbered, PATH_ROOM, "%.*s-%06u%s", (int)(kind - path), path, number, kind);
}

static bool write_pixels(const char *kind, uint16_t width, uint16_t height, const uint8_t *rgb, FILE *stream)
{
    if (strcmp(kind, ".png") == 0) {
        png_image image = {.version = PNG_IMAGE_VERSION, .width = width, .height = height, .format = PNG_FORMAT_RGB};
        return png_image_write_to_stdio(&image, stream, 0, rgb, 0, NULL);
    }
    if (strcmp(kind, ".ppm") == 0)
        fprintf(stream, "P6 %u %u 255\n", width, height);
    const size_t count = (size_t)width * height;
    return fwrite(rgb, 3, count, stream) == count;
}

bool picture_file_write(const char *path, uint16_t width, uint16_t height, const uint8_t *rgb)
{
    char part[PATH_ROOM];
    FILE *stream = open_part(path, part);
    if (!stream) {
        warn("%s: %s", path, strerror(errno));
        return false;
    }
    const bool good = write_pixels(suffix(path), width, height, rgb, stream) && !ferror(stream);
    if (fclose(stream) == 0 && good && rename(part, path) == 0)
        return true;
    warn("%s: could not be written: %s", path, strerror(errno));
    unlink(part);
    return false;
}
