/* SPDX-License-Identifier: MIT
 * For Eva: strips of a picture with any kept triangles and lists of faces, of up to three faces in two parts, and rows of any triangle.
 * What draws rows is left out. Vertices, triangles and what is clipped: eva_meshes.c, eva_triangles.c, eva_clips.c.
 * eva: -eva-precision 1 -eva-min-loop-unroll 8 -eva-slevel 60 -eva-split-return auto -eva-use-spec glint_mesh_triangle_set,glint_mesh_clip,glint_mesh_clip_vertex,glint_mesh_side,glint_pose_set,glint_mesh_vertices,glint_mesh_rows,glint_mesh_t_end */
#include "eva_meshes.h"
#include "glint_mesh_strip.h"

/*@ assigns *triangle, \result \from shine, t_end;
    ensures \result == 0 || \result == 1;
    ensures \initialized(triangle); */
bool glint_mesh_triangle_set(struct glint_mesh_triangle *triangle, const struct glint_mesh_corner corner[3],
                             enum glint_mesh_shine shine, uint32_t t_end);

/* Corners of what is left of a face, which are at most 8, in one of the two lists. */
/*@ assigns *polygon, \result \from face[0 .. 2];
    ensures 0 <= \result <= 8;
    ensures 0 <= polygon->now <= 1;
    ensures \initialized(&polygon->list[0].corner[0 .. 7]) && \initialized(&polygon->list[1].corner[0 .. 7]) && \initialized(&polygon->now); */
unsigned glint_mesh_clip(struct glint_mesh_polygon *polygon, const struct glint_mesh_frame *frame,
                         const struct glint_mesh_drawn *drawn, const uint16_t face[3]);
/*@ assigns *vertex \from clipped->weight[0]; ensures \initialized(vertex); */
void glint_mesh_clip_vertex(struct glint_mesh_vertex *vertex, const struct glint_mesh_frame *frame,
                            const struct glint_mesh_drawn *drawn, const struct glint_mesh_clipped *clipped);
/*@ assigns \result \from *a, *b; */
uint32_t glint_mesh_side(const struct glint_vec *a, const struct glint_vec *b);

/*@ assigns drawn->l, drawn->h, drawn->turn[0 .. 2][0 .. 2], drawn->position[0 .. 2], drawn->scale, \result \from *pose, *paint; ensures \result == 0 || \result == 1; */
bool glint_pose_set(struct glint_mesh_drawn *drawn, const struct glint_pose *pose, const struct glint_paint *paint);
/*@ assigns drawn->vertices[0 .. 3], \result \from frame->w, frame->h, frame->distance; ensures \result == 0 || \result == 1;
    ensures \initialized(drawn->vertices + (0 .. 3)); */
bool glint_mesh_vertices(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn);

/* It stands where the strip or the triangle ends. */
/*@ assigns *triangle \from *triangle, target->end; ensures \initialized(triangle); */
void glint_mesh_rows(const struct glint_paint *paint, struct glint_mesh_triangle *triangle,
                     const struct glint_mesh_target *target);
/*@ assigns \result \from paint->light_count; */
uint32_t glint_mesh_t_end(const struct glint_paint *paint);

enum { FACES = 3, VERTICES = 4, HIGH = 20, WIDE = 5, KEPT = 3 };
static struct {
    struct glint_mesh_bench bench;
    uint16_t depth[WIDE * HIGH];
} memory;
static struct glint_mesh_kept kept[KEPT];
static struct glint_mesh_vertex vertices[VERTICES];
static struct glint_mesh_drawn drawn;
static struct glint_mesh_frame frame;
static uint16_t faces[3 * FACES], links[FACES], bands[2], ends[2];
static int8_t normals8[3 * VERTICES];
static uint8_t pixels[WIDE * HIGH];

/* A strip. */
static uint16_t any_of(uint16_t count)
{
    const uint16_t number = (uint16_t)(any % (count + 1u));
    return number == count ? GLINT_MESH_NONE : number;
}

static struct glint_paint paints[2];

static struct glint_mesh_triangle any_lines(void)
{
    const struct glint_mesh_values values = {
        any, any, any, any, any, any, any, any, any, any, any, any, any_signed % 2048};
    const struct glint_mesh_triangle triangle = {values,
                                                 {any_signed, any_signed},
                                                 {any_signed, any_signed},
                                                 {any_signed, any_signed},
                                                 (int16_t)(any_signed % 2048),
                                                 (int16_t)any,
                                                 (int16_t)any,
                                                 (uint8_t)(any % 3),
                                                 any & 1};
    return triangle;
}

static void strip(uint8_t parts, uint16_t y, uint16_t h)
{
    const struct glint_mesh mesh = {NULL, NULL, normals8, faces, ends, VERTICES, FACES, parts, NULL, NULL};
    ANY_BYTES(normals8);
    ANY_BYTES(vertices);
    for (unsigned i = 0; i < 3 * FACES; i++)
        faces[i] = (uint16_t)(any % VERTICES);
    ends[0] = (uint16_t)(any % (FACES + 1));
    ends[1] = FACES;
    for (unsigned i = 0; i < FACES; i++)
        links[i] = any_of(FACES);
    bands[0] = any_of(FACES);
    bands[1] = any_of(FACES);
    for (unsigned i = 0; i < KEPT; i++) {
        kept[i].triangle = any_lines();
        kept[i].face = (uint16_t)(any % FACES);
        kept[i].next = any_of(KEPT);
    }
    drawn.mesh = &mesh;
    drawn.paints = paints;
    drawn.vertices = vertices;
    drawn.links = links;
    drawn.bands = bands;
    drawn.kept = any_of(KEPT);
    frame.first = &drawn;
    frame.memory = &memory;
    frame.kept = kept;
    frame.w = WIDE;
    frame.h = frame.lines = HIGH;
    frame.distance = (uint16_t)any;
    frame.y = any & 1 ? y : 0;
    frame.free = any_of(KEPT);
    const struct glint_surface surface = {pixels, WIDE, (uint16_t)any, (uint16_t)any};
    (void)glint_mesh_strip(&frame, y, h, &surface);
}
void eva_mesh_strip(void)
{
    for (uint8_t parts = 0; parts <= 2; parts++) {
        strip(parts, 0, HIGH);
        strip(parts, 0, 3);
        strip(parts, 3, 13);
        strip(parts, 3, 17);
        strip(parts, 16, 4);
    }
}

/* A picture begun and a mesh added, with memory to spare. */
void eva_mesh_add(void)
{
    static uint32_t picture_memory[1500], mesh_memory[64];
    static struct glint_mesh_frame picture = {NULL, &picture.first, NULL, NULL, 1, 1, 1, 0, 0, 0, 0, NULL};
    paints[0].format = &glint_use_rgb565;
    paints[0].model = &glint_use_lyon;
    paints[0].light_count = (uint8_t)any;
    const struct glint_mesh mesh = {NULL, NULL, normals8, faces, NULL, VERTICES, FACES, 0, NULL, NULL};
    for (unsigned i = 0; i < 3 * FACES; i++)
        faces[i] = (uint16_t)(any % VERTICES);
    for (uint16_t w = 1; w <= 64; w = (uint16_t)(4 * w))
        for (uint16_t lines = 1; lines <= 33; lines = (uint16_t)(lines + 16)) {
            const struct glint_pose pose = {{(int16_t)any, (int16_t)any, (int16_t)any, (int16_t)any},
                                            {(int16_t)any, (int16_t)any, (int16_t)any},
                                            (uint16_t)any};
            (void)glint_mesh_begin(&picture, w, lines, lines, (uint16_t)any, picture_memory, sizeof picture_memory);
            (void)glint_mesh_add(&picture, &drawn, &mesh, &pose, paints, mesh_memory, sizeof mesh_memory);
            (void)glint_mesh_begin(&picture, (uint16_t)any, (uint16_t)any, (uint16_t)any, (uint16_t)any, NULL, 0);
        }
}

/* Rows, by the library's static functions. */
#define glint_mesh_lit_begin of_lit_begin
#define glint_mesh_t_end of_t_end
#define glint_mesh_is_colour of_is_colour
#define glint_mesh_rows of_rows
#include "mesh_rows.c"
void eva_mesh_rows(void)
{
    struct glint_mesh_triangle triangle;
    struct glint_mesh_row row;
    ANY_BYTES(memory.depth);
    for (int32_t y = 0; y < 3; y++) {
        const struct glint_mesh_values values = {
            any, any, any, any, any, any, any, any, any, any, any, any, any_signed % 2048};
        triangle.values = values;
        triangle.long_edge.x = any_signed;
        triangle.long_edge.step = any_signed;
        triangle.upper = triangle.lower = triangle.long_edge;
        triangle.y = (int16_t)y;
        triangle.y_middle = (int16_t)any;
        triangle.y_end = (int16_t)any;
        triangle.shine = (uint8_t)(any % 3);
        triangle.long_is_left = any & 1;
        const struct glint_surface surface = {pixels, WIDE, (uint16_t)any, (uint16_t)any};
        const struct glint_mesh_target target = {&surface, memory.depth, WIDE, 0, 3, NULL, NULL, NULL};
        (void)row_next(&row, &triangle, &target);
        glint_mesh_triangle_skip(&triangle, any_signed % 2048);
    }
}
/* Pixels in front, from each to each. */
void eva_mesh_in_front(void)
{
    for (uint32_t end = 0; end <= WIDE; end++)
        for (uint32_t x = 0; x <= end; x++) {
            struct glint_mesh_row row = {{pixels, x, any, any, NULL, NULL, NULL, 0}, memory.depth, end, any, any,
                                         {any, any, any, any_signed, any_signed, 0}};
            ANY_BYTES(memory.depth);
            (void)row_in_front(&row, 1 + any % GLINT_RUN);
        }
}
