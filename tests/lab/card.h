/* SPDX-License-Identifier: MIT
 * The display that the kernel's own driver makes of a GUD device, by the calls of its DRM device. What fails fails the test. */
#ifndef LAB_CARD_H
#define LAB_CARD_H

#include <drm.h>
#include <drm_fourcc.h>
#include <stddef.h>
#include <stdint.h>

extern struct card {
    int file;
    uint32_t crtc, connector, frame, pitch, fourcc;
    struct drm_mode_modeinfo mode;
    uint8_t *pixels;
    size_t bytes;
} card;

void card_open(unsigned width, unsigned height); /* waits for it; it has this one mode */
void card_show(uint32_t fourcc);                 /* a frame buffer of this format on the display */
void card_dirty(unsigned x, unsigned y, unsigned width, unsigned height);
void card_close(void);
unsigned card_pixel_bytes(uint32_t fourcc);

#endif
