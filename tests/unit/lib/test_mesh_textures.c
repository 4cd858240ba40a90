/* SPDX-License-Identifier: MIT
 * Meshes with textures, beside double precision: places of texels, light, chains; and what is refused. */
#include "mesh_colours.h"

static struct made_mesh mesh;
static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];
static const unsigned whole[] = {MESH_H}, odd[] = {1, 7, 16, 3, 40};

/* Any faces, many of them clipped, in perspective or not; of textures of any size, which are read nowhere else. */
static void any_texture_is_the_same_in_strips_of_any_height_and_order(void **state)
{
    (void)state;
    unsigned by_tables = 0;
    for (int i = 0; i < 16 * GLINT_FORMAT_COUNT; i++) {
        const enum glint_format format = format_number(i);
        const struct look look = random_look(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        struct glint_paint paint;
        mesh_any(&mesh, i);
        if (i % 3 == 0 && below(2))
            mesh.distance = (uint16_t)(1 + below(4000));
        struct made_texture texture = texture_at_random();
        uv_at_random(&mesh);
        mesh.mesh.textures = &texture.texture;
        assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
        paint_of(&paint, &look);
        assert_same_in_strips(&mesh, &paint, bytes_of(format, MESH_W));
        if (paint_of_albedo(&paint, &look, memory)) {
            by_tables++;
            assert_same_in_strips(&mesh, &paint, bytes_of(format, MESH_W));
        }
        texture_free(&texture);
    }
    assert_true(by_tables > 5);
}

static void a_texture_of_one_colour_has_the_pixels_of_that_albedo(void **state)
{
    (void)state;
    static uint8_t out[MESH_H * MESH_W * 3], expected[MESH_H * MESH_W * 3];
    for (int i = 0; i < 60; i++) {
        struct look look = random_look(GLINT_RGB888, (enum glint_space)(i & 1));
        struct made_texture texture = texture_at_random();
        struct glint_paint paint;
        const uint16_t colour = (uint16_t)below(65536);
        for (unsigned k = 0; texture.palette && k < 256; k++)
            texture.palette[k] = colour;
        if (!texture.palette) {
            free(texture.pixels);
            texture.texture.pixels = texture.pixels = malloc(2);
            *(uint16_t *)texture.pixels = colour;
            texture.texture.w = texture.texture.h = texture.texture.levels = 1;
        }
        look.material.albedo[0] = (uint8_t)lrint((colour >> 11) * 255 / 31.);
        look.material.albedo[1] = (uint8_t)lrint((colour >> 5 & 63) * 255 / 63.);
        look.material.albedo[2] = (uint8_t)lrint((colour & 31) * 255 / 31.);
        mesh_any(&mesh, i);
        paint_of(&paint, &look);
        memset(out, GUARD, sizeof out);
        memset(expected, GUARD, sizeof expected);
        mesh_picture(&mesh, &paint, expected, 3, whole, 1, false);
        uv_at_random(&mesh);
        mesh.mesh.textures = &texture.texture;
        mesh_picture(&mesh, &paint, out, 3, odd, 5, false);
        assert_memory_equal(out, expected, sizeof out);
        texture_free(&texture);
    }
}

/* ---- Beside double precision ---- */

enum { SIDE = 64, BITS = 12 };

/* A triangle on the screen: pixels from the middle of the upper left one, and how near it is. */
struct seen {
    double x[3], y[3], r[3], uv[3][2], area;
};

static struct seen see(unsigned face)
{
    struct seen s;
    for (int i = 0; i < 3; i++) {
        const unsigned v = mesh.faces[face][i];
        const double z = on_screen(mesh.places[v][2], mesh.pose.scale) + mesh.pose.position[2], d = mesh.distance;
        s.r[i] = d > 0 ? floor(floor(d * 16384 / (d - z) + 1) / 2) / 8192 : 1; /* as the library rounds it */
        s.x[i] = floor(on_screen(mesh.places[v][0], mesh.pose.scale) * s.r[i] + .5) / 16 + MESH_W / 2. - .5;
        s.y[i] = floor(on_screen(-mesh.places[v][1], mesh.pose.scale) * s.r[i] + .5) / 16 + MESH_H / 2. - .5;
        for (int k = 0; k < 2; k++)
            s.uv[i][k] = (double)mesh.uv[v][k] / (1 << mesh.mesh.uv_bits);
    }
    s.area = (s.x[1] - s.x[0]) * (s.y[2] - s.y[0]) - (s.x[2] - s.x[0]) * (s.y[1] - s.y[0]);
    return s;
}

/* How much of each corner there is at a pixel, on the screen; false near an edge or outside. */
static bool see_weights(const struct seen *s, int x, int y, double weight[3])
{
    const double px = x - s->x[0], py = y - s->y[0];
    weight[1] = (px * (s->y[2] - s->y[0]) - py * (s->x[2] - s->x[0])) / s->area;
    weight[2] = (py * (s->x[1] - s->x[0]) - px * (s->y[1] - s->y[0])) / s->area;
    weight[0] = 1 - weight[1] - weight[2];
    return s->area < 0 && weight[0] > .001 && weight[1] > .001 && weight[2] > .001;
}

static void see_uv(const struct seen *s, const double weight[3], double at[2])
{
    const double r = weight[0] * s->r[0] + weight[1] * s->r[1] + weight[2] * s->r[2];
    for (int k = 0; k < 2; k++)
        at[k] = (weight[0] * s->r[0] * s->uv[0][k] + weight[1] * s->r[1] * s->uv[1][k] +
                 weight[2] * s->r[2] * s->uv[2][k]) /
                r;
}

static void a_part_whose_texture_has_no_pixels_is_drawn_as_without(void **state)
{
    (void)state;
    static uint16_t out[MESH_H * MESH_W], expected[MESH_H * MESH_W];
    const struct glint_texture none = {0};
    const struct look look = bare(GLINT_RGB565);
    struct glint_paint paint;
    paint_of(&paint, &look);
    mesh_ball(&mesh, 6, 8);
    mesh_picture(&mesh, &paint, (uint8_t *)expected, 2, whole, 1, false);
    uv_at_random(&mesh);
    mesh.mesh.textures = &none;
    mesh_picture(&mesh, &paint, (uint8_t *)out, 2, whole, 1, false);
    assert_memory_equal(out, expected, sizeof out);
}

/* A texture whose texels are all different. */
static uint16_t numbers[SIDE][SIDE];
static struct glint_texture numbered(bool is_smooth)
{
    for (unsigned y = 0; y < SIDE; y++)
        for (unsigned x = 0; x < SIDE; x++)
            numbers[y][x] = (uint16_t)(y >> 1 << 11 | (x >> 5 << 5 | (y & 1) << 4) << 5 | (x & 31));
    return (struct glint_texture){.pixels = numbers, .w = SIDE, .h = SIDE, .levels = 1, .is_smooth = is_smooth};
}

/* From red, green, blue of 255: y and x. */
static void number_of(const uint8_t pixel[3], double at[2])
{
    const long red = lrint(pixel[0] * 31 / 255.), green = lrint(pixel[1] * 63 / 255.),
               blue = lrint(pixel[2] * 31 / 255.);
    at[1] = (double)(red * 2 + (green >> 4 & 1));
    at[0] = (double)((green >> 5 & 1) * 32 + blue);
}

/* One face, all of it in the picture; a range of u and v of up to `repeats`. */
static void face_at_random(double repeats)
{
    mesh_made(&mesh, 3, 1);
    mesh.pose.scale = 16 * 100;
    mesh.mesh.uv = &mesh.uv[0][0];
    mesh.mesh.uv_bits = BITS;
    for (unsigned i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            mesh.places[i][k] = (int16_t)((int32_t)below(30000) - 15000);
            mesh.normals[i][k] = k == 2 ? 32767 : 0;
        }
        mesh.faces[0][i] = (uint16_t)i;
        for (int k = 0; k < 2; k++)
            mesh.uv[i][k] = (uint16_t)below((uint32_t)(repeats * (1 << BITS)));
    }
}

/* Straight in front, and so far behind that its depth is some 50 of 65536 from the farthest. */
static void face_to_back(int16_t behind)
{
    mesh.pose.scale = 65535;
    mesh.pose.position[2] = (int16_t)-behind;
    for (unsigned i = 0; i < 3; i++) {
        mesh.places[i][0] = (int16_t)(2 * mesh.places[i][0]);
        mesh.places[i][1] = (int16_t)(2 * mesh.places[i][1]);
        mesh.places[i][2] = 0;
    }
}

/* By how much u or v, linear between two pixels of a line that are `apart` apart at most, may be off between them, in texels: those ends are
 * anywhere beside the pixel. */
static double between(const struct seen *s, int x, int y, const double at[2], int k, int apart)
{
    double worst = 0;
    for (int left = x - apart; left <= x; left++) {
        double weight[3], ends[2][2];
        (void)see_weights(s, left, y, weight);
        if (fmin(fmin(weight[0], weight[1]), weight[2]) < -.02)
            continue;
        see_uv(s, weight, ends[0]);
        (void)see_weights(s, left + apart, y, weight);
        if (fmin(fmin(weight[0], weight[1]), weight[2]) < -.02)
            continue;
        see_uv(s, weight, ends[1]);
        const double linear = ends[0][k] + (ends[1][k] - ends[0][k]) * (x - left) / apart;
        worst = fmax(worst, fabs(linear - at[k]) * SIDE);
    }
    return worst;
}

/* Is it a pixel wide? Narrower ones are of one texel (sequence.md, `flat`). */
static bool is_wide(const struct seen *s)
{
    const double width = fmax(fmax(s->x[0], s->x[1]), s->x[2]) - fmin(fmin(s->x[0], s->x[1]), s->x[2]);
    const double height = fmax(fmax(s->y[0], s->y[1]), s->y[2]) - fmin(fmin(s->y[0], s->y[1]), s->y[2]);
    return -s->area > fmax(width, height);
}

/* How far a texel is from the place that it is drawn at, in texels, beyond what perspective leaves between two pixels of a line. */
static double worst_place(uint16_t distance, int16_t behind, unsigned *pixels, unsigned *other)
{
    static uint8_t out[MESH_H][MESH_W][3];
    const struct look look = bare(GLINT_RGB888);
    const struct glint_texture texture = numbered(false);
    struct glint_paint paint;
    double worst = 0;
    paint_of(&paint, &look);
    for (int round = 0; round < 400; round++) {
        face_at_random(1);
        mesh.distance = distance;
        if (behind)
            face_to_back(behind);
        mesh.mesh.textures = &texture;
        const struct seen s = see(0);
        if (!is_wide(&s))
            continue;
        mesh_picture(&mesh, &paint, &out[0][0][0], 3, odd, 5, round & 1);
        for (int y = 0; y < MESH_H; y++)
            for (int x = 0; x < MESH_W; x++) {
                double weight[3], at[2], drawn[2];
                if (!see_weights(&s, x, y, weight))
                    continue;
                see_uv(&s, weight, at);
                number_of(out[y][x], drawn);
                bool differs = false;
                for (int k = 0; k < 2; k++) {
                    const double middle = at[k] * SIDE - drawn[k] - .5, off = fabs(remainder(middle, SIDE)) - .5;
                    double allowed = 0;
                    for (int apart = 2; distance && apart <= 8; apart++)
                        allowed = fmax(allowed, between(&s, x, y, at, k, apart));
                    worst = fmax(worst, off - allowed);
                    differs = differs || off > 0;
                }
                ++*pixels;
                *other += differs;
            }
    }
    return worst;
}

static void texels_are_those_of_double_precision(void **state)
{
    (void)state;
    unsigned pixels = 0, other = 0;
    const double worst = worst_place(0, 0, &pixels, &other);
    print_message("%u pixels, %u of them with the texel beside; %.3f texels off\n", pixels, other, worst);
    assert_true(pixels > 50000 && other * 100 < pixels);
    assert_true(worst < .05);
}

/* The nearest corner is up to 1.8 times as near as the farthest. */
static void texels_in_perspective_are_those_of_double_precision_at_every_eighth_pixel(void **state)
{
    (void)state;
    unsigned pixels = 0, other = 0;
    const double worst = worst_place(2400, 0, &pixels, &other);
    print_message("%u pixels, %u of them with other texels; %.3f texels off\n", pixels, other, worst);
    assert_true(pixels > 50000 && worst < .5);
}

static void texels_of_a_face_far_behind_are_those_of_double_precision_at_every_eighth_pixel(void **state)
{
    (void)state;
    unsigned pixels = 0, other = 0;
    const double worst = worst_place(100, 30000, &pixels, &other);
    print_message("%u pixels, %u of them with other texels; %.3f texels off\n", pixels, other, worst);
    assert_true(pixels > 5000 && worst < .05);
}

/* Three sixteenths, where one of its weights changes by 5.3 a line: less than 8, from which on a face has one texel. */
static void a_face_a_fifth_of_a_pixel_high_has_its_texture_from_end_to_end(void **state)
{
    (void)state;
    static const int16_t places[3][3] = {{-1920, -28, 0}, {-960, -40, 0}, {1920, -28, 0}};
    static uint8_t out[MESH_H][MESH_W][3];
    const struct look look = bare(GLINT_RGB888);
    const struct glint_texture texture = numbered(false);
    struct glint_paint paint;
    unsigned count = 0;
    paint_of(&paint, &look);
    face_at_random(1);
    memcpy(mesh.places, places, sizeof places);
    mesh.pose.scale = 8192;
    mesh.mesh.textures = &texture;
    for (unsigned i = 0; i < 3; i++) {
        mesh.uv[i][0] = (uint16_t)(i * i << (BITS - 2));
        mesh.uv[i][1] = 1 << (BITS - 1);
    }
    mesh_picture(&mesh, &paint, &out[0][0][0], 3, whole, 1, false);
    const struct seen s = see(0);
    for (int x = 0; x < MESH_W; x++) {
        double weight[3], at[2], drawn[2];
        if (!see_weights(&s, x, MESH_H / 2, weight))
            continue;
        see_uv(&s, weight, at);
        number_of(out[MESH_H / 2][x], drawn);
        assert_true(fabs(at[0] * SIDE - drawn[0] - .5) < 1);
        count++;
    }
    assert_in_range(count, 35, 45);
}

static double level_of(uint16_t texel, int k)
{
    return k == 0 ? (texel >> 11) * 255 / 31. : k == 1 ? (texel >> 5 & 63) * 255 / 63. : (texel & 31) * 255 / 31.;
}

static double smooth_at(const uint16_t *texels, const double at[2], int k)
{
    const double x = at[0] * SIDE - .5, y = at[1] * SIDE - .5, fx = x - floor(x), fy = y - floor(y);
    const int left = (int)floor(x) & (SIDE - 1), top = (int)floor(y) & (SIDE - 1);
    const int right = (left + 1) & (SIDE - 1), below_it = (top + 1) & (SIDE - 1);
    return (level_of(texels[top * SIDE + left], k) * (1 - fx) + level_of(texels[top * SIDE + right], k) * fx) *
               (1 - fy) +
           (level_of(texels[below_it * SIDE + left], k) * (1 - fx) +
            level_of(texels[below_it * SIDE + right], k) * fx) *
               fy;
}

struct errors {
    double sum, most;
    unsigned count;
};

static void take_error(struct errors *errors, double error)
{
    errors->sum += error;
    errors->most = fmax(errors->most, error);
    errors->count++;
}

static void assert_small(const struct errors *errors, unsigned least_count)
{
    const double mean = errors->sum / errors->count;
    print_message("%u levels of noise: mean error %.3f, largest %.1f\n", errors->count, mean, errors->most);
    assert_true(errors->count > least_count && mean < .8);
}

static void bilinear_texels_are_near_those_of_double_precision(void **state)
{
    (void)state;
    static uint8_t out[MESH_H][MESH_W][3];
    static uint16_t texels[SIDE * SIDE];
    const struct look look = bare(GLINT_RGB888);
    const struct glint_texture texture = {.pixels = texels, .w = SIDE, .h = SIDE, .levels = 1, .is_smooth = true};
    struct glint_paint paint;
    struct errors errors[2] = {0}, lines[2][SIDE] = {0}; /* by column and by row */
    paint_of(&paint, &look);
    for (unsigned i = 0; i < SIDE * SIDE; i++)
        texels[i] = (uint16_t)below(65536);
    for (int round = 0; round < 300; round++) {
        face_at_random(round % 2 ? .3 : 1); /* in perspective of about a texel a pixel */
        mesh.distance = (uint16_t)(round % 2 ? 6000 : 0);
        mesh.mesh.textures = &texture;
        const struct seen s = see(0);
        if (s.area > -20)
            continue;
        mesh_picture(&mesh, &paint, &out[0][0][0], 3, odd, 5, round & 1);
        for (int y = 0; y < MESH_H; y++)
            for (int x = 0; x < MESH_W; x++) {
                double weight[3], at[2];
                if (!see_weights(&s, x, y, weight))
                    continue;
                see_uv(&s, weight, at);
                for (int k = 0; k < 3; k++) {
                    const double error = fabs(out[y][x][k] - smooth_at(texels, at, k));
                    take_error(&errors[round % 2], error);
                    for (int i = 0; i < 2; i++)
                        take_error(&lines[i][(int)floor(at[i] * SIDE + SIDE - .5) % SIDE], error);
                }
            }
    }
    assert_small(&errors[0], 100000);
    assert_small(&errors[1], 100000);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < SIDE; k++)
            assert_true(lines[i][k].count && lines[i][k].sum < 3 * lines[i][k].count);
}

/* A ball with a highlight: by its own texels and in double precision from the normals on. */
static double lit_quality(bool is_smooth)
{
    static uint8_t out[MESH_H][MESH_W][3];
    static uint16_t texels[SIDE * SIDE];
    const struct glint_texture texture = {.pixels = texels, .w = SIDE, .h = SIDE, .levels = 1, .is_smooth = is_smooth};
    const int32_t to_light[3] = {-4, 6, 8};
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    double squares = 0;
    unsigned count = 0;
    set_model(&look, GLINT_MSH, 60, 8);
    make_grey(&look, 8000, 50000);
    for (int k = 0; k < 3; k++)
        look.material.specular_q16[k] = 40000;
    look.material.clamp_peak = true;
    look.output.dither = false;
    assert_int_equal(look_light(&look, to_light, in_front), GLINT_OK);
    paint_of(&paint, &look);
    for (unsigned y = 0; y < SIDE; y++)
        for (unsigned x = 0; x < SIDE; x++)
            texels[y * SIDE + x] = (uint16_t)(below(32) << 11 | (x ^ y) % 64 << 5 | (x / 8 + y / 8) % 2 * 20);
    enum { RINGS = 12, CORNERS = 18 };
    mesh_ball(&mesh, RINGS, CORNERS);
    mesh.pose.scale = 16 * 40;
    mesh.mesh.uv = &mesh.uv[0][0];
    mesh.mesh.uv_bits = BITS;
    mesh.mesh.textures = &texture;
    for (unsigned j = 0; j <= RINGS; j++)
        for (unsigned i = 0; i < CORNERS; i++) {
            mesh.uv[j * CORNERS + i][0] = (uint16_t)((i < CORNERS / 2 ? i : CORNERS - i) * 400);
            mesh.uv[j * CORNERS + i][1] = (uint16_t)(j * 4096 / RINGS);
        }
    mesh_picture(&mesh, &paint, &out[0][0][0], 3, odd, 5, false);
    for (unsigned f = 0; f < mesh.mesh.face_count; f++) {
        const struct seen s = see(f);
        for (int y = 0; s.area < 0 && y < MESH_H; y++)
            for (int x = 0; x < MESH_W; x++) {
                double weight[3], at[2], n[3], t = 0, nl = 0;
                if (!see_weights(&s, x, y, weight))
                    continue;
                see_uv(&s, weight, at);
                for (int k = 0; k < 2; k++) { /* at a texel's edge either is right: the library's is not known here */
                    const double in = at[k] * SIDE - floor(at[k] * SIDE);
                    if (!is_smooth && (in < .02 || in > .98))
                        at[k] = -1;
                }
                if (at[0] < 0 || at[1] < 0)
                    continue;
                const int16_t l[3] = {paint.l.x, paint.l.y, paint.l.z}, h[3] = {paint.h.x, paint.h.y, paint.h.z};
                for (int k = 0; k < 3; k++) {
                    n[k] = 0;
                    for (int i = 0; i < 3; i++)
                        n[k] += weight[i] * mesh.normals[mesh.faces[f][i]][k] / 32768.;
                    t += (n[k] - h[k] / 32768.) * (n[k] - h[k] / 32768.) / 2;
                    nl += n[k] * l[k] / 32768.;
                }
                const double c = 1 - t, e = 60 - 60 * c + 1.25 * c;
                double lobe = nl > 0 && t < 1 ? fmin(1, 2 * c / (1.25 * e * e)) : 0;
                lobe = lobe < 1 / 256. ? 0 : lobe;
                for (int k = 0; k < 3; k++) {
                    const uint16_t texel = texels[(int)(at[1] * SIDE) % SIDE * SIDE + (int)(at[0] * SIDE) % SIDE];
                    const double albedo = is_smooth ? smooth_at(texels, at, k) : level_of(texel, k);
                    const double lit = (8000 + 50000 * fmax(0, nl)) / 65536, shine = 255 * 40000 / 65536. * lobe;
                    const double error = out[y][x][k] - fmin(255, albedo * lit + shine);
                    squares += error * error;
                    count++;
                }
            }
    }
    assert_true(count > 5000);
    return 10 * log10(255. * 255 * count / squares);
}

static void a_lit_ball_is_within_42_decibels_of_double_precision(void **state)
{
    (void)state;
    const double nearest = lit_quality(false), smooth = lit_quality(true);
    print_message("nearest %.1f dB, bilinear %.1f dB\n", nearest, smooth);
    assert_true(nearest >= 42 && smooth >= 42);
}

/* Each picture of the chain has a colour of its own: a square of 64 texels that is drawn ever smaller, upright or less of it, turned,
 * also from a chain that ends sooner. */
static void assert_smaller_pictures(bool turned, unsigned levels)
{
    static uint16_t chain[SIDE * SIDE * 4 / 3 + 8], out[MESH_H][MESH_W];
    const struct look look = bare(GLINT_RGB565);
    struct glint_texture texture = {.pixels = chain, .w = SIDE, .h = SIDE, .levels = (uint8_t)levels};
    static const unsigned uv[2][3][2] = {{{0, 4}, {4, 4}, {0, 0}}, {{0, 2}, {2, 3}, {1, 0}}}; /* quarters */
    const unsigned texels = turned ? SIDE * SIDE * 5 / 16 : SIDE * SIDE;
    struct glint_paint paint;
    uint16_t *at = chain;
    for (unsigned level = 0, side = SIDE; level < 7; level++, side /= 2)
        for (unsigned i = 0; i < side * side; i++)
            *at++ = (uint16_t)(level + 1);
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    for (unsigned size = 80; size >= 4; size--) {
        mesh_made(&mesh, 3, 1);
        mesh.mesh.textures = &texture;
        mesh.mesh.uv = &mesh.uv[0][0];
        mesh.mesh.uv_bits = BITS;
        mesh.pose.scale = (uint16_t)(16 * size);
        for (unsigned i = 0; i < 3; i++) {
            mesh.places[i][0] = i == 1 ? 16384 : -16384;
            mesh.places[i][1] = i == 2 ? 16384 : -16384;
            mesh.normals[i][2] = 32767;
            mesh.faces[0][i] = (uint16_t)i;
            mesh.uv[i][0] = (uint16_t)(uv[turned][i][0] << (BITS - 2));
            mesh.uv[i][1] = (uint16_t)(uv[turned][i][1] << (BITS - 2));
        }
        memset(out, 0, sizeof out);
        mesh_picture(&mesh, &paint, (uint8_t *)out, 2, whole, 1, false);
        unsigned level = 0;
        while (level + 1 < levels && texels / (double)(size * size) >= 2 * pow(4, level))
            level++;
        const uint16_t drawn = out[MESH_H / 2][MESH_W / 2 - 1];
        const double near_step = fmod(log2(texels / (double)(size * size)) + 4, 2) - 1;
        if (fabs(near_step) > .02)
            assert_int_equal(drawn, level + 1);
        texture.levels = 1; /* without a chain */
        mesh_picture(&mesh, &paint, (uint8_t *)out, 2, whole, 1, false);
        assert_int_equal(out[MESH_H / 2][MESH_W / 2 - 1], 1);
        texture.levels = (uint8_t)levels;
    }
}

static void a_texture_that_is_drawn_smaller_takes_a_smaller_picture(void **state)
{
    (void)state;
    assert_smaller_pictures(false, 7);
    assert_smaller_pictures(false, 3);
    assert_smaller_pictures(true, 7);
    assert_smaller_pictures(true, 2);
}

/* Three faces side by side, each a part. */
static void each_part_has_the_texture_of_its_own(void **state)
{
    (void)state;
    static uint16_t texels[3] = {0x1234, 0x5678, 0x0abc}, out[MESH_H][MESH_W];
    static const uint16_t ends[3] = {1, 2, 3};
    const struct look look = bare(GLINT_RGB565);
    struct glint_texture textures[3];
    struct glint_paint paints[3];
    for (int with_tables = 0; with_tables < 2; with_tables++) {
        mesh_made(&mesh, 9, 3);
        mesh.mesh.ends = ends;
        mesh.mesh.part_count = 3;
        mesh.mesh.textures = textures;
        mesh.mesh.uv = &mesh.uv[0][0];
        mesh.mesh.uv_bits = BITS;
        mesh.pose.scale = 16 * 80;
        for (unsigned f = 0; f < 3; f++) {
            textures[f] = (struct glint_texture){.pixels = &texels[f], .w = 1, .h = 1, .levels = 1};
            if (with_tables)
                paint_of_tables(&paints[f], GLINT_TABLES_ALBEDO, &look, memory);
            else
                paint_of(&paints[f], &look);
            for (unsigned i = 0; i < 3; i++) {
                const unsigned v = 3 * f + i;
                mesh.places[v][0] = (int16_t)(8000 * ((int)f - 1) + (i == 1 ? 3000 : -3000));
                mesh.places[v][1] = i == 2 ? 9000 : -9000;
                mesh.normals[v][2] = 32767;
                mesh.faces[f][i] = (uint16_t)v;
            }
        }
        assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
        mesh_picture(&mesh, paints, (uint8_t *)out, 2, whole, 1, false);
        for (int f = 0; f < 3; f++)
            assert_int_equal(out[MESH_H / 2 + 2][MESH_W / 2 + 80 * (8000 * (f - 1) - 1200) / 32768], texels[f]);
    }
}

/* ---- Refused ---- */

static enum glint_err added(const struct glint_paint *paint)
{
    static _Alignas(8) uint8_t frame_memory[MESH_W * MESH_H * 2 + 4096];
    static uint32_t work[8000];
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    assert_int_equal(glint_mesh_begin(&frame, MESH_W, MESH_H, MESH_H, 0, frame_memory, sizeof frame_memory), GLINT_OK);
    return glint_mesh_add(&frame, &drawn, &mesh.mesh, &mesh.pose, paint, work, sizeof work);
}

static void textures_that_cannot_be_drawn_are_refused(void **state)
{
    (void)state;
    static const uint8_t colours[3 * MESH_VERTICES] = {0};
    static uint16_t texels[4], palette[257];
    static uint32_t colour_memory[GLINT_TABLES_COLOUR_BYTES / 4];
    struct glint_texture good = {.pixels = texels, .w = 2, .h = 2, .levels = 1}, bad[2];
    const struct look look = bare(GLINT_RGB565);
    struct glint_paint exact, albedo, colour;
    mesh_ball(&mesh, 4, 6);
    uv_at_random(&mesh);
    mesh.mesh.textures = &good;
    assert_int_equal(glint_mesh_check(&mesh.mesh), GLINT_OK);
#define ASSERT_REFUSED(of, change)                                                                                     \
    do {                                                                                                               \
        struct glint_mesh m = mesh.mesh;                                                                               \
        bad[0] = good;                                                                                                 \
        m.textures = bad;                                                                                              \
        of.change;                                                                                                     \
        assert_int_equal(glint_mesh_check(&m), GLINT_ERR_ARG);                                                         \
    } while (0)
    ASSERT_REFUSED(m, uv = NULL);
    ASSERT_REFUSED(m, uv = (const uint16_t *)(const void *)((const char *)mesh.uv + 1));
    ASSERT_REFUSED(m, uv_bits = 7);
    ASSERT_REFUSED(m, uv_bits = 16);
    ASSERT_REFUSED(m, use = NULL);
    ASSERT_REFUSED(m, of_vertices = colours);
    ASSERT_REFUSED(m, of_faces = colours);
    ASSERT_REFUSED(bad[0], w = 0);
    ASSERT_REFUSED(bad[0], h = 0);
    ASSERT_REFUSED(bad[0], w = 2049);
    ASSERT_REFUSED(bad[0], h = 2049);
    ASSERT_REFUSED(bad[0], levels = 0);
    ASSERT_REFUSED(bad[0], levels = 13);
    ASSERT_REFUSED(bad[0], pixels = (const char *)texels + 1);
    ASSERT_REFUSED(bad[0], palette = (const uint16_t *)(const void *)((const char *)palette + 1));
    const uint16_t ends[2] = {3, mesh.mesh.face_count};
    struct glint_mesh parts = mesh.mesh; /* each part's is looked at; one may have none */
    parts.ends = ends;
    parts.part_count = 2;
    parts.textures = bad;
    bad[0] = good;
    bad[1] = good;
    bad[1].levels = 0;
    assert_int_equal(glint_mesh_check(&parts), GLINT_ERR_ARG);
    bad[1].pixels = NULL;
    assert_int_equal(glint_mesh_check(&parts), GLINT_OK);

    paint_of(&exact, &look);
    paint_of_tables(&albedo, GLINT_TABLES_ALBEDO, &look, memory);
    paint_of_tables(&colour, GLINT_TABLES_COLOUR, &look, colour_memory);
    assert_int_equal(added(&exact), GLINT_OK);
    assert_int_equal(added(&albedo), GLINT_OK);
    assert_int_equal(added(&colour), GLINT_ERR_ARG);
    mesh.mesh.use = NULL;
    assert_int_equal(added(&exact), GLINT_ERR_ARG);
    assert_int_equal(added(&albedo), GLINT_ERR_ARG);
    mesh.mesh.textures = NULL;
    assert_int_equal(added(&exact), GLINT_OK);
    assert_int_equal(added(&colour), GLINT_OK);
    mesh.mesh.of_vertices = colours;
    assert_int_equal(added(&exact), GLINT_OK);
    assert_int_equal(added(&albedo), GLINT_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_part_whose_texture_has_no_pixels_is_drawn_as_without),
        cmocka_unit_test(any_texture_is_the_same_in_strips_of_any_height_and_order),
        cmocka_unit_test(a_texture_of_one_colour_has_the_pixels_of_that_albedo),
        cmocka_unit_test(texels_are_those_of_double_precision),
        cmocka_unit_test(texels_in_perspective_are_those_of_double_precision_at_every_eighth_pixel),
        cmocka_unit_test(texels_of_a_face_far_behind_are_those_of_double_precision_at_every_eighth_pixel),
        cmocka_unit_test(a_face_a_fifth_of_a_pixel_high_has_its_texture_from_end_to_end),
        cmocka_unit_test(bilinear_texels_are_near_those_of_double_precision),
        cmocka_unit_test(a_lit_ball_is_within_42_decibels_of_double_precision),
        cmocka_unit_test(a_texture_that_is_drawn_smaller_takes_a_smaller_picture),
        cmocka_unit_test(each_part_has_the_texture_of_its_own),
        cmocka_unit_test(textures_that_cannot_be_drawn_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
