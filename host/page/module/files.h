/* SPDX-License-Identifier: MIT
 * Files of the page: they are in memory. Beside image/read.h and base/output.h, whose functions files.c has. */
#ifndef GLINT_PAGE_FILES_H
#define GLINT_PAGE_FILES_H

#include <stddef.h>
#include <stdint.h>

#include "image/image.h"

/* A picture to be read under its name; takes the samples. One of the same name is replaced. */
void files_add_image(const char *name, const struct image *image);
bool files_has_image(const char *name);

/* A mesh's file; takes the bytes. One of the same name is replaced. */
void files_add_mesh(const char *name, uint8_t *bytes, size_t len);
const uint8_t *files_mesh(const char *name, size_t *len); /* NULL: there is none */

/* A picture or mesh of this name, if there is one. */
void files_remove(const char *name);

/* What was written and closed, in that order. */
struct file {
    char *name, *bytes;
    size_t len;
};
unsigned files_written(void);
const struct file *files_get(unsigned i); /* NULL: there is none */
void files_forget(void);

#endif
