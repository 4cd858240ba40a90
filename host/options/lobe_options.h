/* SPDX-License-Identifier: MIT
 * The options of the commands that print values of lobes as rows. */
#ifndef GLINT_LOBE_OPTIONS_H
#define GLINT_LOBE_OPTIONS_H

#include <argp.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/rows.h"
#include "glint.h"

struct lobe_options {
    bool model_given[GLINT_MODEL_COUNT];
    long *shininess; /* the caller frees it */
    size_t shininess_count;
    enum rows_format format;
    const char *path;
};

/* A child for a command's argp: sets the defaults and parses. Its input is a struct lobe_options. */
extern const struct argp lobe_options_argp;

#endif
