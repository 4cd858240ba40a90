/* SPDX-License-Identifier: MIT */
#include "files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "image/read.h"

/* ---- pictures that are read ---- */

static struct held {
    struct image image;
    struct held *next;
} * held;

static struct held *find(const char *name)
{
    struct held *at = held;
    while (at && strcmp(at->image.name, name) != 0)
        at = at->next;
    return at;
}

void files_add_image(const char *name, const struct image *image)
{
    struct held *place = find(name);
    if (!place) {
        place = allocate(1, sizeof *place);
        place->next = held;
        held = place;
    }
    free(place->image.samples);
    free(place->image.name);
    place->image = *image;
    if (!(place->image.name = strdup(name)))
        fail("out of memory");
}

bool files_has_image(const char *name)
{
    return find(name) != NULL;
}

struct image *image_read_sized(const char *path, uint32_t width, uint32_t height)
{
    (void)width; /* for SVG, which the page does not read */
    (void)height;
    const struct held *from = find(path);
    if (!from)
        fail("%s: this map is not here; drop or choose the file", path);
    const size_t samples = (size_t)from->image.width * from->image.height * from->image.channels;
    struct image *image = allocate(1, sizeof *image);
    *image = from->image;
    image->name = strdup(path);
    image->samples = allocate(samples, sizeof *image->samples);
    if (!image->name)
        fail("out of memory");
    memcpy(image->samples, from->image.samples, samples * sizeof *image->samples);
    return image;
}

struct image *image_read(const char *path)
{
    return image_read_sized(path, 0, 0);
}

/* ---- meshes that are read ---- */

static struct held_mesh {
    char *name;
    uint8_t *bytes;
    size_t len;
    struct held_mesh *next;
} * meshes;

static struct held_mesh *find_mesh(const char *name)
{
    struct held_mesh *at = meshes;
    while (at && strcmp(at->name, name) != 0)
        at = at->next;
    return at;
}

void files_add_mesh(const char *name, uint8_t *bytes, size_t len)
{
    struct held_mesh *place = find_mesh(name);
    if (!place) {
        place = allocate(1, sizeof *place);
        *place = (struct held_mesh){.name = strdup(name), .next = meshes};
        if (!place->name)
            fail("out of memory");
        meshes = place;
    }
    free(place->bytes);
    place->bytes = bytes;
    place->len = len;
}

const uint8_t *files_mesh(const char *name, size_t *len)
{
    const struct held_mesh *place = find_mesh(name);
    *len = place ? place->len : 0;
    return place ? place->bytes : NULL;
}

void files_remove(const char *name)
{
    for (struct held **at = &held, *gone; (gone = *at) != NULL;) {
        if (strcmp(gone->image.name, name) != 0) {
            at = &gone->next;
            continue;
        }
        *at = gone->next;
        free(gone->image.samples);
        free(gone->image.name);
        free(gone);
    }
    for (struct held_mesh **at = &meshes, *gone; (gone = *at) != NULL;) {
        if (strcmp(gone->name, name) != 0) {
            at = &gone->next;
            continue;
        }
        *at = gone->next;
        free(gone->bytes);
        free(gone->name);
        free(gone);
    }
}

/* ---- files that are written ---- */

enum { WRITTEN_MAX = 4 };
static struct file written[WRITTEN_MAX];
static unsigned written_count;
static struct opened {
    struct output output;
    char *bytes;
    size_t len;
} opened[WRITTEN_MAX];

unsigned files_written(void)
{
    return written_count;
}

const struct file *files_get(unsigned i)
{
    return i < written_count ? &written[i] : NULL;
}

void files_forget(void)
{
    while (written_count) {
        free(written[--written_count].name);
        free(written[written_count].bytes);
    }
}

struct output *output_open(const char *path)
{
    for (unsigned i = 0; i < WRITTEN_MAX; i++) {
        struct opened *file = &opened[i];
        if (file->output.path)
            continue;
        file->output.path = strdup(path);
        file->output.stream = open_memstream(&file->bytes, &file->len);
        if (!file->output.path || !file->output.stream)
            fail("out of memory");
        return &file->output;
    }
    fail("%s: more than %d files are open", path, WRITTEN_MAX);
}

/* Memory does not fail at the end. */
void output_check_written(struct output *output)
{
    (void)output;
}

bool output_is_standard(const char *path)
{
    return strcmp(path, "-") == 0;
}

bool output_same(const char *a, const char *b)
{
    return strcmp(a, b) == 0;
}

void output_close(struct output *output)
{
    struct opened *file = (struct opened *)output;
    if (written_count == WRITTEN_MAX)
        fail("%s: more than %d files", output->path, WRITTEN_MAX);
    if (fclose(output->stream) != 0)
        fail("%s: out of memory", output->path);
    written[written_count++] = (struct file){output->path, file->bytes, file->len};
    *file = (struct opened){.bytes = NULL};
}
