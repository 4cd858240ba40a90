/* SPDX-License-Identifier: MIT
 * For Eva: textures and colours set over a triangle of any corners, clipped or not, by textures of any size and up to four levels; the check of a
 * texture. Texels and lines are not here.
 * eva: -eva-precision 1 -eva-min-loop-unroll 12 -eva-slevel 40 */
#define glint_mesh_pair_of header_pair_of
#define glint_mesh_area header_area
#define glint_mesh_slopes_set header_slopes_set
#include "eva_meshes.h"
#include "glint_mesh_rows.h"
#undef glint_mesh_pair_of
#undef glint_mesh_area
#undef glint_mesh_slopes_set
#define glint_mesh_pair_of of_pair
#define glint_mesh_area of_area
#define glint_mesh_slopes_set of_slopes

/* What stands for them is shown by test_mesh_words, as for eva_gradients.c. */
static struct glint_mesh_pair of_pair(int32_t p, int32_t q)
{
    const bool is_small = -65535 <= p && p <= 65535 && -65535 <= q && q <= 65535;
    const struct glint_mesh_pair pair = {any_signed % 32769, any_signed % 32769, any % (is_small ? 2 : 17)};
    return pair;
}
static int32_t of_area(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                       const struct glint_mesh_vertex *c)
{
    (void)a, (void)b, (void)c;
    return any_signed;
}
static void of_slopes(struct glint_mesh_slopes *slopes, const struct glint_mesh_vertex *a,
                      const struct glint_mesh_vertex *b, const struct glint_mesh_vertex *c)
{
    const struct glint_mesh_slopes of = {any_signed % 32768, any_signed % 32768, any_signed % 32768, any_signed % 32768,
                                         any_signed % 23553, any_signed % 23553, (int)(any % 47) - 5};
    (void)a, (void)b, (void)c;
    *slopes = of;
}
#include "mesh_texture.c" /* in its place */

enum { LEVELS = 4 };
static uint16_t texels[8];
static uint8_t numbers[8];
static struct glint_texture texture;
static struct glint_mesh_bench bench;
static struct glint_mesh_frame frame;
static struct glint_mesh_vertex vertices[3];
static uint16_t faces[3], uv[6];
static uint8_t colours[9];
static struct glint_mesh mesh;
static struct glint_mesh_drawn drawn;
static struct glint_mesh_laid laid;

/* Of `out` any bits: then the corners are the polygon's. */
static void corners_set(void)
{
    struct glint_mesh_corner corner[3];
    any_triangle(corner);
    ANY_BYTES(bench.polygon.list);
    ANY_BYTES(uv);
    ANY_BYTES(colours);
    for (unsigned i = 0; i < 3; i++) {
        vertices[i] = any_corners[i];
        vertices[i].out = (uint16_t)any;
        bench.vertex[i] = any_corners[i];
        faces[i] = (uint16_t)(any % 3);
    }
    for (unsigned i = 0; i < GLINT_MESH_POLYGON; i++)
        for (unsigned k = 0; k < 2; k++)
            bench.polygon.list[0].corner[i].weight[k] = (uint16_t)(any % 32769);
    bench.polygon.now = 0;
    bench.fan = (uint8_t)(2 + any % (GLINT_MESH_POLYGON - 2));
    frame.memory = &bench;
    drawn.mesh = &mesh;
    drawn.vertices = vertices;
    mesh.faces = faces;
    mesh.uv = uv;
}

/* A triangle's texture, or its colours, and the same laid behind it. */
static void set(const struct glint_texture *of)
{
    static struct glint_mesh_kept kept;
    struct glint_mesh_over over;
    const struct glint_mesh_target target = {NULL, NULL, 1, 0, 1, NULL, &frame, &drawn, NULL};
    corners_set();
    kept.face = 0;
    kept.triangle.y = (int16_t)any;
    kept.triangle.values.x = any_signed % 2048;
    over_set(&over, &target, 0, of);
    if (over.is_far) {
        /*@ assert 16 <= over.down[0] <= 33 && 16 <= over.down[1] <= 33; */
    }
    frame.distance = 0;
    over_lay(&laid, &target, &kept.triangle, of);
    over_lay_any(&laid, &target, &kept.triangle, of);
}
static void set_texture(uint16_t w, uint16_t h, bool has_palette, uint16_t distance)
{
    for (mesh.uv_bits = 8; mesh.uv_bits <= 15; mesh.uv_bits++)
        for (texture.levels = 1; texture.levels <= LEVELS; texture.levels += LEVELS - 1) {
            texture.pixels = has_palette ? (const void *)numbers : (const void *)texels;
            texture.palette = has_palette ? texels : NULL;
            texture.w = w;
            texture.h = h;
            texture.is_smooth = mesh.uv_bits & 1;
            frame.distance = distance;
            set(&texture);
        }
}
void eva_texture_set(void)
{
    set_texture((uint16_t)(1 + any % 2048), (uint16_t)(1 + any % 2048), false, 0);
}
void eva_texture_set_far(void)
{
    set_texture(3, 2, true, (uint16_t)(1 + any % 65535));
}
void eva_texture_colours(void)
{
    mesh.of_vertices = colours;
    set(NULL);
    mesh.of_vertices = NULL;
    mesh.of_faces = colours;
    set(NULL);
}

/* Every pair that can be set, and those that cannot. */
int eva_texture_can(void)
{
    const struct glint_texture of = {
        any & 1 ? texels : NULL, any & 1 ? texels : NULL, (uint16_t)any, (uint16_t)any, (uint8_t)any, any & 1};
    const struct glint_mesh any_mesh = {
        .uv = any & 1 ? uv : NULL, .uv_bits = (uint8_t)any, .textures = &of, .part_count = any & 1};
    return over_can(&any_mesh);
}
