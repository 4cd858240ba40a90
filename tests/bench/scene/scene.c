/* SPDX-License-Identifier: MIT
 * scene write FOLDER: what the measurements take: the sphere's normals as `glint bake` makes them (int16.bin,
 *     int8.bin, palette.bin and palette-offsets.bin; lines-*.bin, one line in SPHERE_STEP of each scene in turn), samples.txt (n, c, t of
 *     the highlight's pixels), samples.h (fewer of them, as C), scene.json.
 * scene real N MODEL: the model in double precision, a line for each t_q30 of a line on standard input, which may be a fraction.
 * scene exact N MODEL FORMAT SPACE DITHER ALBEDO GLOSS LAMPS GRAIN: the exact path's picture on stdout; what follows N is a look as
 *     sphere.h has it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../sphere.h"
#include "bake/bake.h"
#include "base/memory.h"
#include "models/models.h"

static const double RADIUS = 120.9;
enum { FEW = 24, LOOK_WORDS = 8 };

static struct scene *scene;
static struct glint_vec *normals; /* 0 beside the sphere */

static bool on_sphere(double x, double y, double normal[3]) /* from its middle, in pixels */
{
    const double z2 = 1 - (x * x + y * y) / RADIUS / RADIUS;
    const double at[3] = {x / RADIUS, y / RADIUS, z2 > 0 ? sqrt(z2) : 0};
    memcpy(normal, at, sizeof at);
    return z2 > 0;
}

static void towards(double normal[3], double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z), at[3] = {x / length, y / length, z / length};
    memcpy(normal, at, sizeof at);
}

/* A patch around the half vector, or around what lies `away` degrees from it across the plane of light and viewer; so many degrees to each side. */
static void patch(double normal[3], double away, double right, double down)
{
    static const double half[3] = {.3250576, .3250576, .8880738}, across[3] = {-.7071068, .7071068, 0};
    const double degree = acos(-1) / 180, a = (away + right) * degree, slope = tan(down * degree);
    double along[3], at[3]; /* the third axis */
    for (int k = 0; k < 3; k++)
        along[k] = half[(k + 1) % 3] * across[(k + 2) % 3] - half[(k + 2) % 3] * across[(k + 1) % 3];
    for (int k = 0; k < 3; k++)
        at[k] = cos(a) * half[k] + sin(a) * across[k] + slope * along[k];
    towards(normal, at[0], at[1], at[2]);
}

/* A pixel's normal. Is it covered? */
static bool place(enum bench_scene which, int column, int row, double normal[3])
{
    const double x = column + .5 - SPHERE_W / 2, y = SPHERE_H / 2 - row - .5;
    switch (which) {
    case SCENE_WAVES:
        towards(normal, .7 * sin(x / 6), .7 * sin(y / 6), 1);
        return true;
    case SCENE_DOME:
        towards(normal, x / SPHERE_W, y / SPHERE_W, 1);
        return true;
    case SCENE_CHECKS:
        return on_sphere(x, y, normal) && (column / 4 + row / 4) % 2;
    case SCENE_INSIDE:
        patch(normal, 9, x / SPHERE_W * 16, y / SPHERE_W * 16);
        return true;
    case SCENE_OUTSIDE:
        patch(normal, 84, x / SPHERE_W * 6, y / SPHERE_W * 6);
        return true;
    default:
        return on_sphere(x, y, normal);
    }
}

/* How many pixels are covered. */
static unsigned draw(enum bench_scene which)
{
    unsigned covered = 0;
    scene = scene_new(SPHERE_W, SPHERE_H);
    scene->mask = allocate(SPHERE_W * SPHERE_H, 1);
    for (int i = 0; i < SPHERE_W * SPHERE_H; i++) {
        double normal[3];
        scene->mask[i] = place(which, i % SPHERE_W, i / SPHERE_W, normal) ? 255 : 0;
        if (scene->mask[i]) {
            memcpy(scene->normals[i], normal, sizeof normal);
            covered++;
        }
    }
    struct baked *baked = bake(scene, BAKE_INT16, 0);
    normals = baked->normals;
    return covered;
}

static FILE *create(const char *folder, const char *name, const char *mode)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, mode);
    if (!file) {
        perror(path);
        exit(1);
    }
    return file;
}

static void write_bytes(const char *folder, const char *name, const char *mode, const void *bytes, size_t size,
                        size_t stride, size_t count)
{
    FILE *file = create(folder, name, mode);
    for (size_t i = 0; i < count; i++)
        fwrite((const char *)bytes + i * stride, 1, size, file);
    fclose(file);
}

/* One line in SPHERE_STEP; after the sphere's come other scenes'. */
static void write_lines(const char *folder, const char *name, const char *mode, const void *pixels, size_t pixel)
{
    const size_t line = SPHERE_W * pixel;
    char file[64];
    snprintf(file, sizeof file, "lines-%s.bin", name);
    write_bytes(folder, file, mode, (const char *)pixels + SPHERE_STEP / 2 * line, line, SPHERE_STEP * line,
                SPHERE_LINES);
}

/* The sphere's, all lines too. */
static void write_map(const char *folder, const char *name, const void *pixels, size_t pixel)
{
    char file[64];
    snprintf(file, sizeof file, "%s.bin", name);
    write_bytes(folder, file, "wb", pixels, SPHERE_W * pixel, SPHERE_W * pixel, SPHERE_H);
    write_lines(folder, name, "wb", pixels, pixel);
}

static void write_maps(const char *folder)
{
    write_map(folder, "int16", normals, sizeof *normals);
    write_map(folder, "int8", bake(scene, BAKE_INT8, 0)->words, sizeof(uint32_t));
    const struct baked *palette = bake(scene, BAKE_PALETTE, SPHERE_PALETTE);
    write_bytes(folder, "palette.bin", "wb", palette->normals, palette->entries * sizeof *normals, 0, 1);
    write_map(folder, "palette-offsets", palette->offsets, sizeof *palette->offsets);
}

static void write_scenes(const char *folder)
{
    for (int which = SCENE_SPHERE + 1; which < SCENE_COUNT; which++) {
        draw((enum bench_scene)which);
        write_lines(folder, "int16", "ab", normals, sizeof *normals);
        write_lines(folder, "int8", "ab", bake(scene, BAKE_INT8, 0)->words, sizeof(uint32_t));
    }
}

struct sample {
    uint32_t c_q16, t_q30;
};
static struct sample samples[SPHERE_W * SPHERE_H];

static struct glint_light lights[GLINT_LIGHTS_MAX];

static bool paint_of(struct glint_paint *paint, const struct sphere_look *look, uint32_t n)
{
    struct glint_material material;
    struct glint_output output;
    sphere_material(&material, &output, look, n);
    const int count = sphere_lights(lights, (enum sphere_lights)look->lights);
    return count < 0 || glint_paint_exact(paint, &material, &output) ||
           glint_paint_light(paint, lights, (unsigned)count, sphere_viewer);
}

/* c and t as lib/sequence.md forms them, of the pixels inside MSH's lobe; returns how many. */
static unsigned find_samples(uint32_t n)
{
    const struct sphere_look look = {.model = GLINT_MSH};
    const int64_t c_min = glint_msh_cutoff(n, SPHERE_Q);
    struct glint_paint paint;
    if (paint_of(&paint, &look, n))
        return 0;
    const struct glint_vec *h = &paint.h;
    unsigned count = 0;
    for (int i = 0; i < SPHERE_W * SPHERE_H; i++) {
        const struct glint_vec *v = &normals[i];
        const int64_t dot = (int64_t)v->x * h->x + (int64_t)v->y * h->y + (int64_t)v->z * h->z;
        const int64_t x = v->x - h->x, y = v->y - h->y, z = v->z - h->z;
        const int64_t c = (dot + (1 << 13)) >> 14;
        if (scene->mask[i] && c >= c_min)
            samples[count++] =
                (struct sample){c < 65536 ? (uint32_t)c : 65536, (uint32_t)((x * x + y * y + z * z) / 2)};
    }
    return count;
}

static void write_samples(const char *folder)
{
    FILE *text = create(folder, "samples.txt", "wb"), *code = create(folder, "samples.h", "wb");
    fprintf(code, "enum { SAMPLES = %d };\nstatic const uint32_t samples[%d][%d][2] = { /* c_q16, t_q30 */\n", FEW,
            SPHERE_N_COUNT, FEW);
    for (int k = 0; k < SPHERE_N_COUNT; k++) {
        const unsigned count = find_samples(sphere_n[k]);
        for (unsigned i = 0; i < count; i++)
            fprintf(text, "%u %u %u\n", (unsigned)sphere_n[k], samples[i].c_q16, samples[i].t_q30);
        fprintf(code, "    {");
        for (unsigned i = 0; i < FEW; i++) {
            const struct sample *s = &samples[(uint64_t)i * count / FEW];
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
    write_maps(folder);
    write_samples(folder);
    write_scenes(folder);
    FILE *json = create(folder, "scene.json", "wb");
    fprintf(json, "{\"width\": %d, \"height\": %d, \"q\": %d, \"covered\": %u, \"n\": [", SPHERE_W, SPHERE_H, SPHERE_Q,
            covered);
    for (int k = 0; k < SPHERE_N_COUNT; k++)
        fprintf(json, "%s%u", k ? ", " : "", (unsigned)sphere_n[k]);
    fprintf(json, "], \"scenes\": [");
    for (int i = 0; i < SCENE_COUNT; i++)
        fprintf(json, "%s\"%s\"", i ? ", " : "", scene_names[i]);
    fprintf(json, "], \"scene_n\": [");
    for (int i = 0; i < SCENE_N_COUNT; i++)
        fprintf(json, "%s%u", i ? ", " : "", (unsigned)scene_n[i]);
    fprintf(json, "], \"side_lines\": %d}\n", SCENE_SIDE_LINES);
    fclose(json);
}

static int write_exact(char **words)
{
    static uint8_t picture[SPHERE_H][SPHERE_W][3], albedo[SPHERE_H * SPHERE_W][3], gloss[SPHERE_H * SPHERE_W];
    static uint8_t grain[SPHERE_H * SPHERE_W];
    uint8_t n[LOOK_WORDS];
    for (int i = 0; i < LOOK_WORDS; i++)
        n[i] = (uint8_t)atoi(words[1 + i]);
    const struct sphere_look look = {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]};
    for (int i = 0; i < SPHERE_W * SPHERE_H; i++) {
        const uint16_t x = (uint16_t)(i % SPHERE_W), y = (uint16_t)(i / SPHERE_W);
        sphere_expand(albedo[i], sphere_albedo(x, y));
        gloss[i] = sphere_gloss(x, y);
        grain[i] = sphere_grain_byte(&look, x, y);
    }
    const size_t line[] = {SPHERE_W * 2, SPHERE_W * 2, SPHERE_W * 3, SPHERE_W,     SPHERE_W / 8,
                           SPHERE_W * 3, SPHERE_W * 4, SPHERE_W * 4, SPHERE_W / 2, SPHERE_W / 4};
    struct glint_paint paint;
    struct glint_maps maps = {.normals = normals,
                              .normals_stride = SPHERE_W * sizeof *normals,
                              .albedo = look.albedo ? albedo[0] : NULL,
                              .albedo_stride = SPHERE_W * sizeof *albedo,
                              .albedo_format = GLINT_RGB888,
                              .gloss = look.gloss ? gloss : NULL,
                              .gloss_stride = SPHERE_W,
                              .coverage = scene->mask,
                              .coverage_stride = SPHERE_W};
    sphere_grain(&maps, &look, grain, SPHERE_W);
    const struct glint_surface surface = {picture, (ptrdiff_t)line[look.format], 0, 0};
    if (paint_of(&paint, &look, (uint32_t)atoi(words[0])) ||
        glint_draw_rect(&paint, &maps, SPHERE_W, SPHERE_H, &surface, NULL))
        return 1;
    return fwrite(picture, line[look.format], SPHERE_H, stdout) != SPHERE_H;
}

static int write_real(double n, enum glint_model model)
{
    double t_q30;
    while (scanf("%lf", &t_q30) == 1)
        printf("%.17g\n", model_double(model, n, 1 - ldexp(t_q30, -30)));
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 4 && strcmp(argv[1], "real") == 0)
        return write_real(atof(argv[2]), (enum glint_model)atoi(argv[3]));
    const unsigned covered = draw(SCENE_SPHERE);
    if (argc == 3 && strcmp(argv[1], "write") == 0)
        write_scene(argv[2], covered);
    else if (argc == 3 + LOOK_WORDS && strcmp(argv[1], "exact") == 0)
        return write_exact(argv + 2);
    else
        return 2;
    return 0;
}
