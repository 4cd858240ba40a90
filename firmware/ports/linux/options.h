/* SPDX-License-Identifier: MIT
 * The command line. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include <argp.h>
#include <stdbool.h>
#include <stdint.h>

#include "gud_device.h"

struct options {
    uint16_t width, height;
    uint8_t formats[GUD_FORMATS_MAX], format_count;
    uint32_t max_buffer; /* 0: a whole frame */
    bool lz4, verbose;
    unsigned each; /* files, one after each rectangle, at most; 0: none */
    uint32_t vid_pid;
    const char *serial, *udc, *name, *speed, *output, *framebuffer;
};
extern const struct argp gadget_argp; /* its input is struct options, filled by options_default first */
void options_default(struct options *options);

#endif
