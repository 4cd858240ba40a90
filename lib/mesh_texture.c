/* SPDX-License-Identifier: MIT
 * What is linear over a triangle, and what becomes the albedo of its pixels: u and v, which lead to texels, or for ALBEDO tables colours of
 * vertices. Set up from the slopes that t takes, too. In perspective u and v are linear over the depth R: u = base + numerator / R,
 * found at every eighth pixel of a line and at its last one, so that nothing is asked beyond the triangle. */
#include "glint_mesh_texture.h"
#include "glint_math.h"
#include "glint_mesh_strip.h"
#include "glint_port.h"
#include "glint_tables.h"

/* Is there none, or can it be drawn? */
static bool over_is_texture(const struct glint_texture *texture)
{
    enum { SIDE_MAX = 2048, LEVELS_MAX = 12 };
    if (!texture->pixels)
        return true;
    return texture->w && texture->w <= SIDE_MAX && texture->h && texture->h <= SIDE_MAX && texture->levels &&
           texture->levels <= LEVELS_MAX && !GLINT_MISALIGNED(texture->palette, 16) &&
           (texture->palette || !GLINT_MISALIGNED(texture->pixels, 16));
}

static bool over_can(const struct glint_mesh *mesh)
{
    if (!mesh->uv || GLINT_MISALIGNED(mesh->uv, 16) || mesh->uv_bits < 8 || mesh->uv_bits > 15 || mesh->of_vertices ||
        mesh->of_faces)
        return false;
    for (unsigned i = 0; i == 0 || i < mesh->part_count; i++)
        if (!over_is_texture(&mesh->textures[i]))
            return false;
    return true;
}

/* ---- Set ---- */

/* How much of the chain is passed: until there are less than two texels a pixel, by the areas of both. p, q: of u and v, in units of
 * 2^-bits of the texture; at: the triangle's corners. */
static unsigned over_level(const struct glint_texture *texture, const struct glint_mesh_pair of[2], unsigned bits,
                           const struct glint_mesh_vertex *const at[3])
{
    if (texture->levels < 2)
        return 0;
    const int32_t area = glint_mesh_area(at[0], at[1], at[2]);
    const uint32_t size = area < 0 ? 0 - (uint32_t)area : (uint32_t)area;
    const int64_t cross = (int64_t)of[0].p * of[1].q - (int64_t)of[0].q * of[1].p; /* <= 2^31 */
    /* < 2^31 2^22 2^4; an area of 2 is 512 in 1/16 pixel, and counts twice */
    uint64_t texels = (uint64_t)(cross < 0 ? -cross : cross) * ((uint32_t)texture->w * texture->h)
                      << (of[0].shift + of[1].shift);
    const uint64_t pixels = (uint64_t)size << (2 * bits - 7);
    unsigned level = 0;
    for (; level + 1u < texture->levels && texels >= pixels; texels >>= 2)
        level++;
    return level;
}

static void over_picture(struct glint_mesh_picture *picture, const struct glint_texture *texture, unsigned level)
{
    uint32_t w = texture->w, h = texture->h, skip = 0;
    for (; level; level--) {
        skip += w * h;
        w = w > 1 ? w / 2 : 1;
        h = h > 1 ? h / 2 : 1;
    }
    picture->palette = texture->palette;
    picture->pixels = (const uint8_t *)texture->pixels + (texture->palette ? skip : 2 * skip);
    picture->w = w;
    picture->h = h;
}

/* u or v at corner a, less half a texel where the middle of the first one is the first. */
static inline uint32_t over_first(const struct glint_texture *texture, const struct glint_mesh_picture *picture,
                                  uint32_t at, unsigned k)
{
    return texture->is_smooth ? at - UINT32_C(0x80000000) / (k ? picture->h : picture->w) : at;
}

/* R / 2^16 at a corner. */
static int32_t over_away(const struct glint_mesh_vertex *vertex)
{
    return 65535 - (int32_t)vertex->z;
}

/* One of u and v in perspective: numerators below 2^30 at the corners. |p|, |q| <= 2^15, R / 2^16 < 2^16. */
static void over_far(struct glint_mesh_over *over, unsigned k, const struct glint_mesh_slopes *slopes,
                     const struct glint_mesh_corners *corners, struct glint_mesh_pair of)
{
    const struct glint_mesh_pair far =
        glint_mesh_pair_of(of.p * over_away(corners->at[1]), of.q * over_away(corners->at[2]));
    glint_mesh_linear_set(&over->of[k], slopes, far, 15 - (int)far.shift);
    over->down[k] = (uint8_t)(33 - far.shift - of.shift); /* >= 16: shifts are at most 16 and 1 */
}

/* A corner's u and v, or red, green and blue. */
static void over_corner(int16_t of[3], const struct glint_mesh *mesh, unsigned face, unsigned vertex, bool has_texture)
{
    if (has_texture) {
        const uint16_t *uv = mesh->uv + 2 * (size_t)vertex;
        of[0] = (int16_t)(uv[0] - 32768);
        of[1] = (int16_t)(uv[1] - 32768);
    } else {
        const uint8_t *colour =
            mesh->of_faces ? mesh->of_faces + 3 * (size_t)face : mesh->of_vertices + 3 * (size_t)vertex;
        of[0] = colour[0];
        of[1] = colour[1];
        of[2] = colour[2];
    }
}

#define OVER_HALF ((int32_t)1 << GLINT_MESH_OVER_HALF_LOG)

static void over_colours(struct glint_mesh_over *over, const struct glint_mesh_slopes *slopes,
                         const int16_t *const of[3])
{
    over->count = 3;
    for (unsigned k = 0; k < 3; k++) {
        const int32_t one = k == 1 ? (int32_t)GLINT_MESH_OVER_GREEN : (int32_t)GLINT_MESH_OVER_RED, first = of[0][k];
        glint_mesh_linear_set(&over->of[k], slopes,
                              glint_mesh_pair_of((of[1][k] - first) * one, (of[2][k] - first) * one), 0);
        over->of[k].at += (uint32_t)(first * one + OVER_HALF);
    }
}

/* Corners from the upper one down, and what they have; equal ones stay. */
static void over_order(struct glint_mesh_corners *corners, const int16_t **of, unsigned first)
{
    const struct glint_mesh_vertex *const upper = corners->at[first];
    const int16_t *const numbers = of[first];
    if (corners->at[first + 1]->y >= upper->y)
        return;
    corners->at[first] = corners->at[first + 1];
    corners->at[first + 1] = upper;
    of[first] = of[first + 1];
    of[first + 1] = numbers;
}

static void over_set(struct glint_mesh_over *over, const struct glint_mesh_target *target, unsigned face,
                     const struct glint_texture *texture)
{
    const struct glint_mesh *mesh = target->drawn->mesh;
    const uint16_t *const vertex = mesh->faces + 3 * (size_t)face;
    struct glint_mesh_corners corners;
    struct glint_mesh_slopes slopes;
    int16_t numbers[3][3];
    const int16_t *of[3] = {numbers[0], numbers[1], numbers[2]};
    glint_mesh_corners_of(&corners, target, face);
    for (unsigned i = 0; i < 3; i++) {
        numbers[i][2] = 0;
        over_corner(numbers[i], mesh, face, vertex[i], texture);
    }
    glint_mesh_corners_weigh(&corners, numbers);
    over_order(&corners, of, 0);
    over_order(&corners, of, 1);
    over_order(&corners, of, 0);
    const struct glint_mesh_vertex *const a = corners.at[0], *const b = corners.at[1], *const c = corners.at[2];
    glint_mesh_slopes_set(&slopes, a, b, c);
    over->x = a->x >> 4;
    over->y = glint_mesh_first(a->y);
    over->is_far = false;
    if (!texture) {
        over_colours(over, &slopes, of);
        return;
    }
    const unsigned bits = mesh->uv_bits;
    const struct glint_mesh_pair pair[2] = {
        glint_mesh_pair_of((int32_t)of[1][0] - of[0][0], (int32_t)of[2][0] - of[0][0]),
        glint_mesh_pair_of((int32_t)of[1][1] - of[0][1], (int32_t)of[2][1] - of[0][1])};
    over_picture(&over->picture, texture, over_level(texture, pair, bits, corners.at));
    over->is_smooth = texture->is_smooth;
    over->count = 2;
    over->is_far = target->frame->distance != 0;
    over->up = (uint8_t)(19 - bits);
    for (unsigned k = 0; k < 2; k++) {
        const uint32_t first = over_first(texture, &over->picture, (uint32_t)(of[0][k] + 32768) << (32 - bits), k);
        if (over->is_far) {
            over_far(over, k, &slopes, &corners, pair[k]);
            over->base[k] = first;
        } else {
            glint_mesh_linear_set(&over->of[k], &slopes, pair[k], (int)(32 - bits));
            over->of[k].at += first;
        }
    }
}

static void over_room(struct glint_mesh_frame *frame, const struct glint_mesh *mesh, const struct glint_paint *paints)
{
    bool is_laid = false;
    for (unsigned i = 0; i == 0 || i < mesh->part_count; i++)
        is_laid |= !glint_paint_is_exact(&paints[i]);
    if (!is_laid || (mesh->textures && frame->distance) || frame->y || frame->kept_bytes == GLINT_MESH_LAID_SIZE)
        return; /* some may be in use */
    frame->kept_bytes = GLINT_MESH_LAID_SIZE;
    glint_mesh_places(frame);
}

/* To the triangle's line and the column of its values. */
static __attribute__((noinline)) void over_lay_any(struct glint_mesh_laid *laid, const struct glint_mesh_target *target,
                                                   const struct glint_mesh_triangle *triangle,
                                                   const struct glint_texture *texture)
{
    struct glint_mesh_over *const over = &((struct glint_mesh_bench *)target->frame->memory)->of.over;
    over_set(over, target, glint_mesh_face_of(triangle), texture);
    const uint32_t n = (uint32_t)(triangle->values.x - over->x), lines = (uint32_t)(triangle->y - over->y);
    for (unsigned k = 0; k < over->count; k++) {
        const struct glint_mesh_linear of = over->of[k];
        const uint32_t at = of.at + n * of.x + lines * of.y;
        uint32_t *const to = &laid->of[k < 2 ? k : GLINT_MESH_LAID_BLUE];
        const unsigned stride = k < 2 ? 2 : 1;
        to[0] = at;
        to[stride] = of.y;
        to[2 * stride] = of.x;
    }
    if (texture) {
        laid->of[GLINT_MESH_LAID_BLUE] = (uint32_t)((uintptr_t)over->picture.pixels - (uintptr_t)texture->pixels);
        laid->of[GLINT_MESH_LAID_BLUE + 1] = over->picture.w | glint_mesh_height_of(texture, &over->picture) << 16;
    }
}

#if !GLINT_CORTEX_M0PLUS_ASM /* which lays such faces by itself */
/* A face that is not clipped, its corners from the upper one down, as over_order has them; and how many lines its triangle went on. */
struct over_laying {
    struct glint_mesh_slopes slopes;
    const struct glint_mesh_vertex *at[3];
    uint16_t of[3];
    uint32_t lines;
};

static inline void laying_order(struct over_laying *laying, unsigned first)
{
    const struct glint_mesh_vertex *const upper = laying->at[first];
    const uint16_t of = laying->of[first];
    if (laying->at[first + 1]->y >= upper->y)
        return;
    laying->at[first] = laying->at[first + 1];
    laying->at[first + 1] = upper;
    laying->of[first] = laying->of[first + 1];
    laying->of[first + 1] = of;
}

/* One number: its differences to corners b and c times 2^up, and what it is at a. stride: from it to its step down, and from that to the one
 * to the right. */
static __attribute__((noinline)) void laying_number(const struct over_laying *laying, uint32_t *to, unsigned stride,
                                                    struct glint_mesh_pair pair, int up, uint32_t first)
{
    struct glint_mesh_linear of;
    glint_mesh_linear_set(&of, &laying->slopes, pair, up);
    to[0] = of.at + first + laying->lines * of.y;
    to[stride] = of.y;
    to[2 * stride] = of.x;
}

static void laying_colours(const struct over_laying *laying, struct glint_mesh_laid *laid,
                           const struct glint_mesh *mesh, unsigned face)
{
    const bool is_of_faces = mesh->of_faces;
    const uint8_t *const colours = is_of_faces ? mesh->of_faces + 3 * (size_t)face : mesh->of_vertices, *of[3];
    for (unsigned i = 0; i < 3; i++)
        of[i] = is_of_faces ? colours : colours + 3 * (size_t)laying->of[i];
    for (unsigned k = 0; k < 3; k++) {
        const int32_t one = k == 1 ? (int32_t)GLINT_MESH_OVER_GREEN : (int32_t)GLINT_MESH_OVER_RED, first = of[0][k];
        laying_number(laying, &laid->of[k < 2 ? k : GLINT_MESH_LAID_BLUE], k < 2 ? 2 : 1,
                      glint_mesh_pair_of((of[1][k] - first) * one, (of[2][k] - first) * one), 0,
                      (uint32_t)(first * one + OVER_HALF));
    }
}

static void laying_texture(const struct over_laying *laying, struct glint_mesh_laid *laid,
                           const struct glint_mesh *mesh, const struct glint_texture *texture)
{
    const unsigned bits = mesh->uv_bits;
    const uint16_t *const a = mesh->uv + 2 * (size_t)laying->of[0], *const b = mesh->uv + 2 * (size_t)laying->of[1],
                          *const c = mesh->uv + 2 * (size_t)laying->of[2];
    const struct glint_mesh_pair pair[2] = {glint_mesh_pair_of((int32_t)b[0] - a[0], (int32_t)c[0] - a[0]),
                                            glint_mesh_pair_of((int32_t)b[1] - a[1], (int32_t)c[1] - a[1])};
    struct glint_mesh_picture picture;
    over_picture(&picture, texture, over_level(texture, pair, bits, laying->at));
    laid->of[GLINT_MESH_LAID_BLUE] = (uint32_t)((uintptr_t)picture.pixels - (uintptr_t)texture->pixels);
    laid->of[GLINT_MESH_LAID_BLUE + 1] = picture.w | glint_mesh_height_of(texture, &picture) << 16;
    for (unsigned k = 0; k < 2; k++)
        laying_number(laying, &laid->of[k], 2, pair[k], (int)(32 - bits),
                      over_first(texture, &picture, (uint32_t)a[k] << (32 - bits), k));
}

/* Each by itself, for the stack. */
static __attribute__((noinline)) void over_lay_face(struct glint_mesh_laid *laid, const struct glint_mesh_drawn *drawn,
                                                    const struct glint_mesh_triangle *triangle,
                                                    const struct glint_texture *texture)
{
    const struct glint_mesh *const mesh = drawn->mesh;
    const unsigned face = glint_mesh_face_of(triangle);
    const uint16_t *const of = mesh->faces + 3 * (size_t)face;
    struct over_laying laying;
    for (unsigned i = 0; i < 3; i++) {
        laying.of[i] = of[i];
        laying.at[i] = &drawn->vertices[of[i]];
    }
    laying_order(&laying, 0);
    laying_order(&laying, 1);
    laying_order(&laying, 0);
    glint_mesh_slopes_set(&laying.slopes, laying.at[0], laying.at[1], laying.at[2]);
    laying.lines = (uint32_t)(triangle->y - glint_mesh_first(laying.at[0]->y));
    if (texture)
        laying_texture(&laying, laid, mesh, texture);
    else
        laying_colours(&laying, laid, mesh, face);
}

#endif

/* To the triangle's line; the column is that of its values. */
static void over_lay(struct glint_mesh_laid *laid, const struct glint_mesh_target *target,
                     const struct glint_mesh_triangle *triangle, const struct glint_texture *texture)
{
#if !GLINT_CORTEX_M0PLUS_ASM
    const struct glint_mesh_drawn *const drawn = target->drawn;
    if (!glint_mesh_face_is_out(drawn, drawn->mesh->faces + 3 * (size_t)glint_mesh_face_of(triangle))) {
        over_lay_face(laid, drawn, triangle, texture);
        return;
    }
#endif
    over_lay_any(laid, target, triangle, texture);
}

/* ---- Lines ---- */

/* x y 2^-down, y <= 2^16, modulo 2^32. */
static inline uint32_t over_product(int32_t x, uint32_t y, unsigned down)
{
#if GLINT_THUMB1
    const uint32_t low = (uint32_t)(x & 0xffff) * y;
    const int32_t high = (x >> 16) * (int32_t)y + (int32_t)(low >> 16); /* from -2^31 to 2^31 - 1 */
    return down < 16 ? (uint32_t)high << (16 - down) | (low & 0xffff) >> down : (uint32_t)(high >> (down - 16));
#else
    return (uint32_t)(((int64_t)x * y) >> down);
#endif
}

/* u and v at a pixel of the line, less those at corner a, Q13 of the mesh's units: numerators are up to 2^30 in size, 1 / R is inverse
 * 2^(zeros - 47). */
static void over_off(const struct glint_mesh_over *over, int32_t x, int32_t off[2])
{
    const uint32_t n = (uint32_t)(x - over->left), most = (uint32_t)65535 << 16, z = over->z + n * over->dz;
    const uint32_t away = z < most - 65536 ? most - z : 65536;
    const unsigned zeros = glint_mesh_zeros(away); /* 0..15 */
    const uint32_t inverse = glint_mesh_inverse(away << zeros >> 4);
    for (unsigned k = 0; k < 2; k++) {
        off[k] = (int32_t)over_product((int32_t)(over->line[k] + n * over->of[k].x), inverse, over->down[k] - zeros);
    }
}

/* The part that begins at pixel from, where off is known. */
static void over_part(struct glint_mesh_over *over)
{
    static const uint16_t parts[9] GLINT_FLASH = {0, 65535, 32768, 21845, 16384, 13107, 10923, 9362, 8192};
    const int32_t last = over->right - 1, end = over->from + 8 < last ? over->from + 8 : last;
    const uint32_t part = GLINT_FLASH_U16(parts[end - over->from]);
    int32_t off[2];
    over_off(over, end, off);
    for (unsigned k = 0; k < 2; k++) {
        const int32_t change = (int32_t)((uint32_t)off[k] - (uint32_t)over->off[k]);
        over->now[k] = over->base[k] + ((uint32_t)over->off[k] << over->up);
        over->step[k] = over_product(change, part, 16) << over->up;
        over->off[k] = off[k];
    }
    over->to = end == last ? over->right : end;
}

static void over_line(struct glint_mesh_over *over, int32_t y, int32_t left, int32_t right, uint32_t z, uint32_t dz)
{
    const uint32_t n = (uint32_t)(left - over->x), lines = (uint32_t)(y - over->y);
    over->from = over->left = left;
    over->to = over->right = right;
    for (unsigned k = 0; k < over->count; k++) {
        const struct glint_mesh_linear *of = &over->of[k];
        over->now[k] = of->at + n * of->x + lines * of->y;
        over->step[k] = of->x;
        if (over->count == 3)
            glint_mesh_hold(&over->now[k], &over->step[k], k, (uint32_t)(right - 1 - left));
    }
    if (!over->is_far)
        return;
    over->line[0] = over->now[0];
    over->line[1] = over->now[1];
    over->z = z;
    over->dz = dz;
    over_off(over, left, over->off);
    over_part(over);
}

static void over_next(struct glint_mesh_over *over)
{
    over->from = over->to;
    over_part(over);
}

/* The numbers at pixel x of the line. */
static void over_at(struct glint_mesh_over *over, int32_t x, uint32_t now[3])
{
    while (x >= over->to)
        over_next(over);
    for (unsigned k = 0; k < over->count; k++)
        now[k] = over->now[k] + (uint32_t)(x - over->from) * over->step[k];
}

/* ---- Texels ---- */

/* 2^16 levels of 31 or 63 to the nearest of 255: of whole ones this is the nearest, too. */
static inline uint8_t over_level8(uint32_t x, bool is_green)
{
    return (uint8_t)(is_green ? (x * 259 + ((uint32_t)33 << 16)) >> 22 : (x * 527 + ((uint32_t)23 << 16)) >> 22);
}

static uint32_t over_channel(uint32_t texel, unsigned k)
{
    return k == 0 ? texel >> 11 : k == 1 ? texel >> 5 & 63 : texel & 31;
}

static void over_rgb888(struct glint_mesh_over *over, int32_t x, uint8_t *out, unsigned count)
{
    const struct glint_mesh_picture *const picture = &over->picture;
    for (; count; count--, x++, out += 3) {
        uint32_t now[3];
        over_at(over, x, now);
        if (!over->is_smooth) {
            const uint32_t texel = glint_mesh_texel(picture, glint_mesh_nearest(picture, now[0], now[1]));
            for (unsigned k = 0; k < 3; k++)
                out[k] = over_level8(over_channel(texel, k) << 16, k == 1);
            continue;
        }
        struct glint_mesh_around a;
        glint_mesh_around_set(&a, picture, now[0], now[1], 8);
        for (unsigned k = 0; k < 3; k++) {
            const uint32_t above = over_channel(a.of[0][0], k) * (256 - a.x) + over_channel(a.of[0][1], k) * a.x,
                           below = over_channel(a.of[1][0], k) * (256 - a.x) + over_channel(a.of[1][1], k) * a.x;
            out[k] = over_level8(above * (256 - a.y) + below * a.y, k == 1);
        }
    }
}

static void over_rgb565(struct glint_mesh_over *over, int32_t x, uint8_t *bytes, unsigned count)
{
    uint16_t *out = (uint16_t *)(void *)bytes;
    const struct glint_mesh_picture *const picture = &over->picture;
    for (; count; count--, x++, out++) {
        uint32_t now[3];
        over_at(over, x, now);
        if (over->count == 3)
            *out = glint_packed(glint_mesh_colour_fields(now[0], now[1], now[2]), false);
        else if (over->is_smooth)
            *out = glint_packed(glint_mesh_smooth_fields(picture, now[0], now[1]), false);
        else
            *out = glint_mesh_texel(picture, glint_mesh_nearest(picture, now[0], now[1]));
    }
}

#if GLINT_FUSED && GLINT_CORTEX_M0PLUS_ASM
#define OVER_BEGIN glint_mesh_albedo_begin
#else
#define OVER_BEGIN NULL
#endif
const struct glint_use_mesh glint_use_mesh_albedo GLINT_FLASH = {
    over_can,    over_set,    over_line,
    over_rgb888, over_rgb565, over_next,
    over_room,   over_lay,    GLINT_TABLES_FUSED(glint_mesh_albedo_lines),
    OVER_BEGIN};
