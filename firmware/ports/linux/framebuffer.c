/* SPDX-License-Identifier: MIT
 * All sizes come from a driver: each is checked before a pixel is written. */
#include "framebuffer.h"

enum { CHANNELS = 3, CHANNEL_MAX = 16 };

/* Each channel lies in the pixel, and no two of them share a bit. */
static bool channels_fit(const struct fb_bitfield fields[CHANNELS], unsigned bits)
{
    uint64_t taken = 0;
    for (unsigned k = 0; k < CHANNELS; k++) {
        const struct fb_bitfield *f = &fields[k];
        if (f->length < 1 || f->length > CHANNEL_MAX || f->offset >= bits || f->length > bits - f->offset ||
            f->msb_right)
            return false;
        const uint64_t mask = ((UINT64_C(1) << f->length) - 1) << f->offset;
        if (taken & mask)
            return false;
        taken |= mask;
    }
    return true;
}

const char *framebuffer_layout(struct framebuffer *framebuffer, const struct fb_var_screeninfo *screen,
                               const struct fb_fix_screeninfo *memory, unsigned width, unsigned height)
{
    const unsigned bits = screen->bits_per_pixel;
    const struct fb_bitfield fields[CHANNELS] = {screen->red, screen->green, screen->blue};
    if (bits != 16 && bits != 24 && bits != 32)
        return "it does not have 16, 24 or 32 bits a pixel";
    if (memory->type != FB_TYPE_PACKED_PIXELS || screen->grayscale ||
        (memory->visual != FB_VISUAL_TRUECOLOR && memory->visual != FB_VISUAL_DIRECTCOLOR) ||
        !channels_fit(fields, bits))
        return "its pixels are not made up of red, green and blue";
    if (screen->xres < width || screen->yres < height)
        return "it has fewer pixels than the display; choose another --size";
    const uint64_t left = (uint64_t)screen->xoffset * (bits / 8), right = left + (uint64_t)width * (bits / 8);
    const uint64_t lines = (uint64_t)screen->yoffset + height; /* < 2^33 */
    if (!memory->line_length || right > memory->line_length || lines > memory->smem_len / memory->line_length)
        return "its driver states less memory than the picture takes";
    *framebuffer = (struct framebuffer){.offset = (size_t)((uint64_t)screen->yoffset * memory->line_length + left),
                                        .bytes = memory->smem_len,
                                        .line = memory->line_length,
                                        .pixel = bits / 8};
    for (unsigned k = 0; k < CHANNELS; k++) {
        framebuffer->channels[k].offset = (uint8_t)fields[k].offset;
        framebuffer->channels[k].length = (uint8_t)fields[k].length;
    }
    return NULL;
}

void framebuffer_put(const struct framebuffer *framebuffer, unsigned x, unsigned y, unsigned width, const uint8_t *rgb)
{
    uint8_t *out = framebuffer->pixels + (size_t)y * framebuffer->line + (size_t)x * framebuffer->pixel;
    for (unsigned i = 0; i < width; i++) {
        uint32_t value = 0;
        for (unsigned k = 0; k < CHANNELS; k++) {
            const unsigned both = *rgb++ * 0x101u; /* 16 bits, of which the channel has the highest */
            value |= (uint32_t)(both >> (CHANNEL_MAX - framebuffer->channels[k].length))
                     << framebuffer->channels[k].offset;
        }
        for (unsigned b = 0; b < framebuffer->pixel; b++)
            *out++ = (uint8_t)(value >> 8 * b); /* little-endian */
    }
}
