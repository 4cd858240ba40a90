/* SPDX-License-Identifier: MIT
 * pack_palette CONTROLLER-WIDTHxHEIGHT FILE: a palette that `glint bake --to palette` wrote raw, as a C header that shown_palette.c includes: its normals;
 * of each pixel that the panel shows, line by line, its place; and the checksum of both. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cksum.h"
#include "panel.h"

static uint8_t baked[1 << 20], places[1 << 20];

static enum panel_controller controller_of(const char *name, size_t length)
{
    static const char *const names[] = {
#define CONTROLLER(id, name, ...) name,
#include "panels.def"
    };
    unsigned i = 0;
    while (i < PANEL_CONTROLLERS && (strncmp(name, names[i], length) != 0 || names[i][length]))
        i++;
    return (enum panel_controller)i;
}

/* The columns of each line are those of its band. */
static size_t pick(const struct panel *panel, const uint8_t *offsets)
{
    size_t count = 0;
    struct panel_columns seen = {0, 0};
    for (unsigned y = 0; y < panel->height; y++) {
        if (y % PANEL_BAND == 0)
            seen = panel_visible(panel, y, panel_band(panel, y));
        memcpy(places + count, offsets + 2 * ((size_t)y * panel->width + seen.first), 2u * seen.count);
        count += 2u * seen.count;
    }
    return count;
}

static unsigned two(const uint8_t *bytes)
{
    return bytes[0] | (unsigned)bytes[1] << 8;
}

static void print(const uint8_t *normals, size_t entries, size_t bytes)
{
    printf("static const struct glint_vec demo_palette[] = {");
    for (size_t i = 0; i < entries; i++, normals += 6)
        printf("%s{%d,%d,%d},", i % 8 ? "" : "\n", (int16_t)two(normals), (int16_t)two(normals + 2),
               (int16_t)two(normals + 4));
    printf("};\nstatic const uint32_t demo_places[] = {");
    for (size_t i = 0; i < bytes; i += 4)
        printf("%s0x%x,", i % 64 ? "" : "\n", two(places + i) | two(places + i + 2) << 16);
    printf("};\n");
}

int main(int argc, char **argv)
{
    struct panel panel;
    char *size = argc == 3 ? strchr(argv[1], '-') : NULL, *end = size;
    const unsigned long width = size ? strtoul(size + 1, &end, 10) : 0,
                        height = size && *end == 'x' ? strtoul(end + 1, &end, 10) : 0;
    if (!size || *end || width > UINT16_MAX || height > UINT16_MAX ||
        !panel_defaults(&panel, controller_of(argv[1], (size_t)(size - argv[1])), 0, (uint16_t)width,
                        (uint16_t)height)) {
        fprintf(stderr, "pack_palette: give a panel and the baked palette\n");
        return EXIT_FAILURE;
    }
    FILE *in = fopen(argv[2], "rb");
    const size_t length = in ? fread(baked, 1, sizeof baked, in) : 0, of_offsets = 2 * (size_t)width * height;
    if (!in || fclose(in) != 0 || length <= of_offsets || length == sizeof baked || (length - of_offsets) % 6) {
        fprintf(stderr, "pack_palette: %s is not a palette of %lux%lu\n", argv[2], width, height);
        return EXIT_FAILURE;
    }
    const size_t bytes = pick(&panel, baked + length - of_offsets), of_normals = length - of_offsets;
    if (bytes % 4) {
        fprintf(stderr, "pack_palette: %s: its windows are not even\n", argv[1]);
        return EXIT_FAILURE;
    }
    print(baked, of_normals / 6, bytes);
    const uint32_t sum = cksum_add(cksum_add(0, baked, of_normals), places, bytes);
    printf("#define DEMO_PALETTE_CKSUM %uu\n", (unsigned)cksum_end(sum, of_normals + bytes));
    return EXIT_SUCCESS;
}
