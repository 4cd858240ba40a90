/* SPDX-License-Identifier: MIT
 * All sizes come from a driver: each is checked before a pixel is written. */
#include <unistd.h>

#include "framebuffer.h"

enum { CHANNELS = 3, CHANNEL_MAX = 16 };

/* The bits of a channel; 0 where it does not lie in the pixel. */
static uint32_t field_mask(const struct fb_bitfield *f, unsigned bits)
{
    if (f->length < 1 || f->length > CHANNEL_MAX || f->offset >= bits || f->length > bits - f->offset || f->msb_right)
        return 0;
    return ((UINT32_C(1) << f->length) - 1) << f->offset;
}

/* Of all channels; 0 where one does not lie in the pixel, or two of them share a bit. */
static uint32_t channels_mask(const struct fb_bitfield fields[CHANNELS], unsigned bits)
{
    uint32_t taken = 0;
    for (unsigned k = 0; k < CHANNELS; k++) {
        const uint32_t mask = field_mask(&fields[k], bits);
        if (!mask || taken & mask)
            return 0;
        taken |= mask;
    }
    return taken;
}

const char *framebuffer_layout(struct framebuffer *framebuffer, const struct fb_var_screeninfo *screen,
                               const struct fb_fix_screeninfo *memory, unsigned width, unsigned height)
{
    const unsigned bits = screen->bits_per_pixel;
    const struct fb_bitfield fields[CHANNELS] = {screen->red, screen->green, screen->blue};
    if (bits != 16 && bits != 24 && bits != 32)
        return "it does not have 16, 24 or 32 bits a pixel";
    const uint32_t colors = channels_mask(fields, bits);
    if (memory->type != FB_TYPE_PACKED_PIXELS || screen->grayscale ||
        (memory->visual != FB_VISUAL_TRUECOLOR && memory->visual != FB_VISUAL_DIRECTCOLOR) || !colors)
        return "its pixels are not made up of red, green and blue";
    if (screen->xres < width || screen->yres < height)
        return "it has fewer pixels than the display; choose another --size";
    const uint64_t left = (uint64_t)screen->xoffset * (bits / 8), right = left + (uint64_t)width * (bits / 8);
    const uint64_t lines = (uint64_t)screen->yoffset + height; /* < 2^33 */
    const uint32_t before = (uint32_t)(memory->smem_start & ((unsigned long)sysconf(_SC_PAGESIZE) - 1));
    if (!memory->line_length || right > memory->line_length || lines > memory->smem_len / memory->line_length ||
        memory->smem_len > UINT32_MAX - before)
        return "its driver states less memory than the picture takes";
    const uint64_t first = (uint64_t)screen->yoffset * memory->line_length + left;
    *framebuffer = (struct framebuffer){.offset = before + (size_t)first,
                                        .bytes = before + memory->smem_len,
                                        .line = memory->line_length,
                                        .pixel = bits / 8,
                                        .opaque = field_mask(&screen->transp, bits) & ~colors};
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
        uint32_t value = framebuffer->opaque;
        for (unsigned k = 0; rgb && k < CHANNELS; k++) {
            const unsigned both = *rgb++ * 0x101u; /* 16 bits, of which the channel has the highest */
            value |= (uint32_t)(both >> (CHANNEL_MAX - framebuffer->channels[k].length))
                     << framebuffer->channels[k].offset;
        }
        for (unsigned b = 0; b < framebuffer->pixel; b++)
            *out++ = (uint8_t)(value >> 8 * b); /* little-endian */
    }
}
