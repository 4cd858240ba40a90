/* SPDX-License-Identifier: MIT
 * scene write FOLDER: what the measurements take: normals.bin (Q1.15, 6 bytes a pixel, 0 beside the sphere), albedo.bin (RGB888),
 *     lines.bin (the normals of one line in SCENE_STEP), samples.txt (n, c, t of pixels of the highlight), samples.h (fewer
 *     of them, as C), scene.json.
 * scene exact MODEL N FORMAT ALBEDO DITHER: the exact path's picture on stdout; the numbers are those of glint.h, or 0 and 1. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../scene.h"

static const double RADIUS = 120.9;
enum { SAMPLES = 2000, FEW = 24 };

static struct glint_vec normals[SCENE_H][SCENE_W];
static uint8_t mask[SCENE_H][SCENE_W], albedo[SCENE_H][SCENE_W][3];

static int16_t q15(double x)
{
    return (int16_t)fmin(32767, floor(x * 32768 + .5));
}

static unsigned draw_normals(void) /* how many pixels are covered */
{
    unsigned covered = 0;
    for (int j = 0; j < SCENE_H; j++)
        for (int i = 0; i < SCENE_W; i++) {
            const double x = (i + .5 - SCENE_W / 2) / RADIUS, y = (SCENE_H / 2 - j - .5) / RADIUS;
            const double z2 = 1 - x * x - y * y;
            /* a smooth pattern with every level in it, so that no loop can hold it in a table */
            albedo[j][i][0] = (uint8_t)(128 + 127 * sin(i / 9.));
            albedo[j][i][1] = (uint8_t)(128 + 127 * sin(j / 7.));
            albedo[j][i][2] = (uint8_t)(128 + 127 * sin((i + j) / 11.));
            if (z2 <= 0)
                continue;
            normals[j][i] = (struct glint_vec){q15(x), q15(y), q15(sqrt(z2))};
            mask[j][i] = 255;
            covered++;
        }
    return covered;
}

static FILE *create(const char *folder, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    if (!file) {
        perror(path);
        exit(1);
    }
    return file;
}

static void write_file(const char *folder, const char *name, const void *bytes, size_t size, size_t stride,
                       size_t count)
{
    FILE *file = create(folder, name);
    for (size_t i = 0; i < count; i++)
        fwrite((const char *)bytes + i * stride, 1, size, file);
    fclose(file);
}

struct sample {
    uint32_t c_q16, t_q30;
};
static struct sample samples[SCENE_W * SCENE_H];

/* c and t as glint.h forms them, of the pixels inside MSH's lobe; returns how many. */
static unsigned find_samples(uint32_t n)
{
    struct glint_shader shader;
    scene_shader(&shader, GLINT_MSH, n, GLINT_RGB565, false);
    const struct glint_vec *h = &shader.light.h;
    unsigned count = 0;
    for (int j = 0; j < SCENE_H; j++)
        for (int i = 0; i < SCENE_W; i++) {
            const struct glint_vec *v = &normals[j][i];
            const int64_t dot = (int64_t)v->x * h->x + (int64_t)v->y * h->y + (int64_t)v->z * h->z;
            const int64_t x = v->x - h->x, y = v->y - h->y, z = v->z - h->z;
            const int64_t c = (dot + (1 << 13)) >> 14;
            if (mask[j][i] && c >= shader.lobe.c_min_q16)
                samples[count++] =
                    (struct sample){c < 65536 ? (uint32_t)c : 65536, (uint32_t)((x * x + y * y + z * z) / 2)};
        }
    return count;
}

/* Evenly chosen: the k-th of `wanted` out of `count`. */
static const struct sample *chosen(unsigned k, unsigned wanted, unsigned count)
{
    return &samples[wanted < count ? (uint64_t)k * count / wanted : k];
}

static void write_samples(const char *folder)
{
    FILE *text = create(folder, "samples.txt"), *code = create(folder, "samples.h");
    fprintf(code, "enum { SAMPLES = %d };\nstatic const uint32_t samples[%d][%d][2] = { /* c_q16, t_q30 */\n", FEW,
            SCENE_N_COUNT, FEW);
    for (int k = 0; k < SCENE_N_COUNT; k++) {
        const unsigned count = find_samples(scene_n[k]), wanted = count < SAMPLES ? count : SAMPLES;
        for (unsigned i = 0; i < wanted; i++) {
            const struct sample *s = chosen(i, wanted, count);
            fprintf(text, "%u %u %u\n", (unsigned)scene_n[k], s->c_q16, s->t_q30);
        }
        fprintf(code, "    {");
        for (unsigned i = 0; i < FEW; i++) {
            const struct sample *s = chosen(i, FEW, count);
            fprintf(code, "{%u, %uu}, ", s->c_q16, s->t_q30);
        }
        fprintf(code, "},\n");
    }
    fprintf(code, "};\n");
    fclose(text);
    fclose(code);
}

static void write_scene(const char *folder, unsigned covered)
{
    write_file(folder, "normals.bin", normals, sizeof normals, 0, 1);
    write_file(folder, "albedo.bin", albedo, sizeof albedo, 0, 1);
    write_file(folder, "lines.bin", normals[SCENE_STEP / 2], sizeof *normals, SCENE_STEP * sizeof *normals,
               SCENE_LINES);
    write_samples(folder);
    FILE *json = create(folder, "scene.json");
    fprintf(json, "{\"width\": %d, \"height\": %d, \"q\": %d, \"covered\": %u, \"n\": [", SCENE_W, SCENE_H, SCENE_Q,
            covered);
    for (int k = 0; k < SCENE_N_COUNT; k++)
        fprintf(json, "%s%u", k ? ", " : "", (unsigned)scene_n[k]);
    fprintf(json, "]}\n");
    fclose(json);
}

static int write_exact(char **words)
{
    static uint8_t picture[SCENE_H][SCENE_W][3];
    const enum glint_format format = (enum glint_format)atoi(words[2]);
    const size_t line[] = {SCENE_W * 2, SCENE_W * 2, SCENE_W * 3, SCENE_W, SCENE_W / 8};
    struct glint_shader shader;
    scene_shader(&shader, (enum glint_model)atoi(words[0]), (uint32_t)atoi(words[1]), format, atoi(words[4]));
    const struct glint_source source = {.normals = normals[0],
                                        .normals_stride = sizeof *normals,
                                        .albedo = atoi(words[3]) ? albedo[0][0] : NULL,
                                        .albedo_stride = sizeof *albedo,
                                        .mask = mask[0],
                                        .mask_stride = sizeof *mask};
    const struct glint_surface surface = {picture, (ptrdiff_t)line[format], 0, 0};
    if (glint_shade_rect(&shader, &source, SCENE_W, SCENE_H, &surface, NULL))
        return 1;
    return fwrite(picture, line[format], SCENE_H, stdout) != SCENE_H;
}

int main(int argc, char **argv)
{
    const unsigned covered = draw_normals();
    if (argc == 3 && strcmp(argv[1], "write") == 0)
        write_scene(argv[2], covered);
    else if (argc == 7 && strcmp(argv[1], "exact") == 0)
        return write_exact(argv + 2);
    else
        return 2;
    return 0;
}
