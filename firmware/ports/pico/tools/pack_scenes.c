/* SPDX-License-Identifier: MIT
 * pack_scenes WIDTHxHEIGHT MAP.bin...: baked maps as a C header that shown_map.c includes: the normals of each as one LZ4 block, its coverage, if
 * it has one, as it is, and the checksum of all that. */
#include <lz4hc.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "cksum.h"

static uint8_t map[1 << 20], packed[LZ4_COMPRESSBOUND(sizeof map)];

static void print_bytes(const char *name, int scene, const uint8_t *bytes, size_t count)
{
    printf("static const uint8_t demo_%s_%d[] = {", name, scene);
    for (size_t i = 0; i < count; i++)
        printf("%s%u,", i % 32 ? "" : "\n", bytes[i]);
    printf("};\n");
}

int main(int argc, char **argv)
{
    unsigned width, height;
    uint32_t sum = 0;
    size_t all = 0;
    if (argc < 3 || sscanf(argv[1], "%ux%u", &width, &height) != 2 || (size_t)width * height > sizeof map / 5) {
        fprintf(stderr, "pack_scenes: give a size and the baked maps\n");
        return EXIT_FAILURE;
    }
    const size_t pixels = (size_t)width * height;
    bool has_coverage[16] = {false};
    for (int i = 2; i < argc && i < 18; i++) {
        FILE *in = fopen(argv[i], "rb");
        const size_t length = in ? fread(map, 1, sizeof map, in) : 0;
        has_coverage[i - 2] = length == 5 * pixels;
        const int count =
            length == 4 * pixels || length == 5 * pixels
                ? LZ4_compress_HC((const char *)map, (char *)packed, (int)(4 * pixels), sizeof packed, LZ4HC_CLEVEL_MAX)
                : 0;
        if (!in || count <= 0 || fclose(in) != 0) {
            fprintf(stderr, "pack_scenes: %s is not a map of %s\n", argv[i], argv[1]);
            return EXIT_FAILURE;
        }
        print_bytes("scene", i - 2, packed, (size_t)count);
        sum = cksum_add(sum, packed, (size_t)count);
        if (length == 5 * pixels) {
            print_bytes("coverage", i - 2, map + 4 * pixels, pixels);
            sum = cksum_add(sum, map + 4 * pixels, pixels);
        }
        all += (size_t)count + length - 4 * pixels;
    }
    printf("static const struct demo_scene {\n    const uint8_t *packed;\n    uint32_t bytes;\n    const uint8_t "
           "*coverage;\n"
           "    uint32_t coverage_bytes;\n} demo_scenes[] = {\n");
    for (int i = 0; i < argc - 2; i++)
        if (has_coverage[i])
            printf("    {demo_scene_%d, sizeof demo_scene_%d, demo_coverage_%d, sizeof demo_coverage_%d},\n", i, i, i,
                   i);
        else
            printf("    {demo_scene_%d, sizeof demo_scene_%d, NULL, 0},\n", i, i);
    printf("};\nenum { DEMO_SCENES = %d };\n#define DEMO_SCENES_CKSUM %uu\n", argc - 2, (unsigned)cksum_end(sum, all));
    return EXIT_SUCCESS;
}
