/* SPDX-License-Identifier: MIT */
#include "mesh/import_picture.h"

#include <errno.h>
#include <fcntl.h>
#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#if GLINT_WITH_JPEG
#include <jpeglib.h>
#endif

#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "image/picture.h"
#include "base/child.h"

/* Sent first, then the pixels. */
struct head {
    char message[200];
    uint32_t width, height;
};
struct source {
    const uint8_t *bytes;
    size_t len;
};

/* ---- the child ---- */

static bool is_allowed(struct head *head)
{
    const bool good = picture_size_fits(head->width, head->height);
    if (!good)
        snprintf(head->message, sizeof head->message, "%ux%u pixels; at most %d a side and %d in all are allowed",
                 head->width, head->height, SIDE_MAX, PIXELS_MAX);
    return good;
}

/* As encoded in sRGB, whatever the file has. */
static uint8_t *decode_png(const struct source *source, struct head *head)
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    uint8_t *pixels = NULL;
    bool good = png_image_begin_read_from_memory(&image, source->bytes, source->len) != 0;
    head->width = image.width;
    head->height = image.height;
    if (good && !is_allowed(head))
        return NULL;
    image.format = PNG_FORMAT_RGBA;
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    if (good) {
        pixels = allocate((size_t)head->width * head->height, 4);
        good = png_image_finish_read(&image, NULL, pixels, 0, NULL) != 0;
    }
    if (!good) {
        snprintf(head->message, sizeof head->message, "damaged PNG: %s; save it again", image.message);
        return NULL;
    }
    for (size_t i = 0; i < (size_t)head->width * head->height; i++) /* without alpha */
        memmove(&pixels[3 * i], &pixels[4 * i], 3);
    return pixels;
}

#if GLINT_WITH_JPEG
struct trouble {
    struct jpeg_error_mgr manager; /* first: libjpeg knows the address of this */
    jmp_buf back;
};

static void leave(j_common_ptr info)
{
    longjmp(((struct trouble *)info->err)->back, 1);
}

static void say_nothing(j_common_ptr info)
{
    (void)info;
}

static uint8_t *decode_jpeg(const struct source *source, struct head *head)
{
    struct jpeg_decompress_struct info;
    struct trouble trouble;
    char text[JMSG_LENGTH_MAX];
    uint8_t *volatile pixels = NULL;
    info.err = jpeg_std_error(&trouble.manager);
    trouble.manager.error_exit = leave;
    trouble.manager.output_message = say_nothing;
    volatile bool good = false;
    if (setjmp(trouble.back) == 0) {
        jpeg_create_decompress(&info);
        jpeg_mem_src(&info, source->bytes, (unsigned long)source->len);
        jpeg_read_header(&info, TRUE);
        info.out_color_space = JCS_RGB;
        head->width = info.image_width;
        head->height = info.image_height;
        if (!is_allowed(head))
            return NULL;
        jpeg_start_decompress(&info);
        pixels = allocate((size_t)head->width * head->height, 3);
        while (info.output_scanline < info.output_height)
            jpeg_read_scanlines(&info, (JSAMPROW[]){pixels + (size_t)3 * head->width * info.output_scanline}, 1);
        good = info.err->num_warnings == 0; /* what is missing would be grey */
    }
    if (good)
        return pixels;
    info.err->format_message((j_common_ptr)&info, text);
    snprintf(head->message, sizeof head->message, "damaged JPEG: %.120s; save it again", text);
    return NULL;
}
#endif

static void decode(const void *of, int out)
{
    const struct source *source = of;
    struct head head = {.message = ""};
    uint8_t *pixels = NULL;
    if (source->len >= 8 && png_sig_cmp(source->bytes, 0, 8) == 0)
        pixels = decode_png(source, &head);
#if GLINT_WITH_JPEG
    else if (source->len >= 3 && memcmp(source->bytes, "\xFF\xD8\xFF", 3) == 0)
        pixels = decode_jpeg(source, &head);
#else
    else if (source->len >= 3 && memcmp(source->bytes, "\xFF\xD8\xFF", 3) == 0)
        snprintf(head.message, sizeof head.message,
                 "this is a JPEG, and glint was built without libjpeg; convert it to PNG, or install libjpeg-dev and "
                 "build glint again");
#endif
    else
        snprintf(head.message, sizeof head.message, "this is not a PNG or JPEG picture; convert it to PNG");
    child_send(out, &head, sizeof head);
    if (pixels)
        child_send(out, pixels, (size_t)3 * head.width * head.height);
}

/* ---- the parent, which believes nothing ---- */

const char *import_picture_decode(struct mesh_picture *picture, const char *name, const void *bytes, size_t len)
{
    static struct head head;
    const struct source source = {bytes, len};
    struct child child;
    child_start(&child, name, "glint", decode, &source);
    const char *wrong = child_receive(&child, &head, sizeof head);
    if (wrong) {
        *picture = (struct mesh_picture){.width = PIXELS_MAX, .height = 1};
        return wrong;
    }
    head.message[sizeof head.message - 1] = 0;
    if (head.message[0] || head.width == 0 || head.height == 0 || !is_allowed(&head)) {
        child_end(&child);
        if (picture_size_fits(head.width, head.height))
            *picture = (struct mesh_picture){.width = head.width, .height = head.height};
        return head.message[0] ? head.message : "has no pixels";
    }
    *picture =
        (struct mesh_picture){copied(name), head.width, head.height, allocate((size_t)head.width * head.height, 3)};
    wrong = child_receive(&child, picture->rgb, (size_t)3 * head.width * head.height);
    if (!wrong)
        child_end(&child);
    return wrong;
}

struct mesh_picture import_picture(const char *path)
{
    struct mesh_picture picture = {0};
    struct stat status;
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0 || fstat(descriptor, &status) != 0)
        fail("%s: %s", path, strerror(errno));
    if (!S_ISREG(status.st_mode))
        fail("%s: this is not a regular file; name a PNG or JPEG picture", path);
    if (status.st_size > IMPORT_PICTURE_BYTES)
        fail("%s: this file has more than %d MB; save a smaller picture", path, IMPORT_PICTURE_BYTES >> 20);
    FILE *stream = fdopen(descriptor, "rb");
    if (!stream)
        fail("out of memory");
    output_never(stream);
    uint8_t *bytes = allocate((size_t)status.st_size + 1, 1);
    const size_t len = fread(bytes, 1, (size_t)status.st_size, stream);
    fclose(stream);
    const char *wrong = import_picture_decode(&picture, path, bytes, len);
    if (wrong)
        fail("%s: %s", path, wrong);
    free(bytes);
    return picture;
}

#if GLINT_WITH_JPEG
#define TEXT(x) #x
#define TEXT_OF(x) TEXT(x)
const char *import_picture_library(void)
{
    return "libjpeg-turbo " TEXT_OF(LIBJPEG_TURBO_VERSION);
}
#else
const char *import_picture_library(void)
{
    return NULL;
}
#endif
