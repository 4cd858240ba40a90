/* SPDX-License-Identifier: MIT
 * The light is turned into the mesh's directions once a picture, so that normals are never turned. */
#include "glint_mesh_pose.h"
#include "glint_port.h"

/* The rotation of a quaternion of length s: its products of two components over s^2, no root. */
static bool pose_rotation(int32_t m_q30[3][3], const int16_t q[4])
{
    const int64_t w = q[0], x = q[1], y = q[2], z = q[3], s = w * w + x * x + y * y + z * z; /* <= 2^32 */
    if (s == 0)
        return false;
    const int64_t product[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                   {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                                   {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m_q30[i][j] = (int32_t)(product[i][j] * ((int64_t)1 << 30) / s); /* |product| <= s: <= 2^30, 2^62 before */
    return true;
}

/* A direction back through the rotation, Q1.15, nearest. */
static struct glint_vec pose_back(int32_t m_q30[3][3], const struct glint_vec *v)
{
    int16_t out[3];
    for (int i = 0; i < 3; i++) {
        const int64_t sum = (int64_t)m_q30[0][i] * v->x + (int64_t)m_q30[1][i] * v->y + (int64_t)m_q30[2][i] * v->z;
        out[i] = glint_mesh_held((int32_t)((sum + ((int64_t)1 << 29)) >> 30));
    }
    const struct glint_vec back = {out[0], out[1], out[2]};
    return back;
}

bool glint_pose_set(struct glint_mesh_drawn *drawn, const struct glint_pose *pose, const struct glint_paint *paint)
{
    int32_t m_q30[3][3];
    if (!pose_rotation(m_q30, pose->turn))
        return false;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            drawn->turn[i][j] = (int16_t)((m_q30[i][j] + ((int32_t)1 << 15)) >> 16); /* |.| <= 2^14 */
        drawn->position[i] = pose->position[i];
    }
    drawn->l = pose_back(m_q30, &paint->l);
    drawn->h = pose_back(m_q30, &paint->h);
    drawn->scale = pose->scale;
    return true;
}

/* A row of the turn times a place: |.| < 2^30.8, since a row's length is 1. */
static int32_t pose_row(const int16_t row[3], const int16_t place[3])
{
    return (int32_t)row[0] * place[0] + (int32_t)row[1] * place[1] + (int32_t)row[2] * place[2];
}

/* To 1/16 pixel, to nearest, from 2^29 units of 32768. The factors are cut to 17 and 14 bits or to 15 and 16, so that the product fits 32. */
static inline int32_t pose_scaled(int32_t sum, int32_t scale)
{
    const bool is_small = scale < 16384;
    return (((sum >> (is_small ? 14 : 16)) * scale >> (is_small ? 14 : 12)) + 1) >> 1;
}

static inline struct glint_mesh_place pose_place(const struct glint_mesh_drawn *drawn, unsigned vertex)
{
    const int16_t *place = drawn->mesh->places + 3 * vertex;
    const int32_t scale = drawn->scale;
    const struct glint_mesh_place at = {drawn->position[0] + pose_scaled(pose_row(drawn->turn[0], place), scale),
                                        drawn->position[1] +
                                            pose_scaled(-pose_row(drawn->turn[1], place), scale), /* y down */
                                        drawn->position[2] + pose_scaled(pose_row(drawn->turn[2], place), scale)};
    return at;
}

struct glint_mesh_place glint_mesh_place_of(const struct glint_mesh_drawn *drawn, unsigned vertex)
{
    return pose_place(drawn, vertex);
}

static inline void pose_normal(struct glint_vec *normal, const struct glint_mesh *mesh, unsigned vertex)
{
    if (mesh->normals) {
        const int16_t *n = mesh->normals + 3 * vertex;
        normal->x = n[0];
        normal->y = n[1];
        normal->z = n[2];
    } else { /* 127 to 32766 */
        const int8_t *n = mesh->normals8 + 3 * vertex;
        normal->x = (int16_t)((int32_t)n[0] * 258);
        normal->y = (int16_t)((int32_t)n[1] * 258);
        normal->z = (int16_t)((int32_t)n[2] * 258);
    }
}

void glint_mesh_normal(struct glint_vec *normal, const struct glint_mesh *mesh, unsigned vertex)
{
    pose_normal(normal, mesh, vertex);
}

uint32_t glint_mesh_side(const struct glint_vec *a, const struct glint_vec *b)
{
    const int32_t x = (int32_t)a->x - b->x, y = (int32_t)a->y - b->y, z = (int32_t)a->z - b->z;
    return ((uint32_t)x * (uint32_t)x >> 2) + ((uint32_t)y * (uint32_t)y >> 2) + ((uint32_t)z * (uint32_t)z >> 2);
}

#if !GLINT_CORTEX_M0PLUS_ASM
/* In assembly a part of glint_mesh_face_set. (258 d)^2 >> 2 is 129^2 d^2, so the squares are added first; |d| <= 254. */
void glint_mesh_sides8(struct glint_mesh_corner corner[3], const int8_t *normals, const uint16_t face[3])
{
    const int8_t *a = normals + 3 * face[0], *b = normals + 3 * face[1], *c = normals + 3 * face[2];
    uint32_t ab = 0, bc = 0, ca = 0;
    for (unsigned k = 0; k < 3; k++) {
        const int32_t p = (int32_t)a[k] - b[k], q = (int32_t)b[k] - c[k], r = p + q;
        ab += (uint32_t)(p * p);
        bc += (uint32_t)(q * q);
        ca += (uint32_t)(r * r);
    }
    corner[0].side = bc * (129 * 129);
    corner[1].side = ca * (129 * 129);
    corner[2].side = ab * (129 * 129);
}
#endif

void glint_mesh_sides16(struct glint_mesh_corner corner[3], const struct glint_mesh *mesh, const uint16_t face[3])
{
    struct glint_vec normal[3];
    for (unsigned i = 0; i < 3; i++)
        glint_mesh_normal(&normal[i], mesh, face[i]);
    for (unsigned i = 0; i < 3; i++)
        corner[i].side = glint_mesh_side(&normal[(i + 1) % 3], &normal[(i + 2) % 3]);
}

bool glint_mesh_is_near(const struct glint_mesh_frame *frame, int32_t z)
{
    return frame->distance && 8 * ((int32_t)frame->distance - z) < (int32_t)frame->distance;
}

/* r = distance / (distance - z), Q13, <= 2^16 up to the near plane. Depth is linear in z, and under perspective in r: each is linear
 * on the screen. */
static __attribute__((noinline)) struct glint_mesh_place pose_far(const struct glint_mesh_frame *frame,
                                                                  struct glint_mesh_place place)
{
    const int32_t away = (int32_t)frame->distance - place.z; /* > 0: distance / 8 at least */
    const uint32_t r = (((uint32_t)frame->distance << 14) / (uint32_t)(away > 0 ? away : 1) + 1) >> 1;
    place.x = (int32_t)(((int64_t)place.x * r + (1 << 12)) >> 13);
    place.y = (int32_t)(((int64_t)place.y * r + (1 << 12)) >> 13);
    place.z = r > 65535 ? 0 : (int32_t)(65535 - r);
    return place;
}

static inline struct glint_mesh_place pose_project(const struct glint_mesh_frame *frame, struct glint_mesh_place place)
{
    if (frame->distance)
        return pose_far(frame, place);
    place.z = place.z > 32767 ? 0 : place.z < -32767 ? 65534 : 32767 - place.z;
    return place;
}

struct glint_mesh_place glint_mesh_project(const struct glint_mesh_frame *frame, struct glint_mesh_place place)
{
    return pose_project(frame, place);
}

/* 32 bits are enough: with |N|, |H| <= 1.0 t is at most 2^31; of others it is what is left modulo 2^32. */
void glint_mesh_light(struct glint_mesh_vertex *vertex, const struct glint_mesh_drawn *drawn,
                      const struct glint_vec *normal)
{
    const int32_t nx = normal->x, ny = normal->y, nz = normal->z;
    const int32_t x = nx - drawn->h.x, y = ny - drawn->h.y, z = nz - drawn->h.z;
    const uint32_t xx = (uint32_t)x * (uint32_t)x, yy = (uint32_t)y * (uint32_t)y, zz = (uint32_t)z * (uint32_t)z;
    vertex->t_q30 = (xx >> 1) + (yy >> 1) + (zz >> 1);
    vertex->nl_q30 = (int32_t)((uint32_t)(nx * drawn->l.x) + (uint32_t)(ny * drawn->l.y) + (uint32_t)(nz * drawn->l.z));
}

static uint16_t pose_out(const struct glint_mesh_place *at)
{
    const int32_t guard = GLINT_MESH_GUARD;
    return (uint16_t)((at->x < -guard  ? GLINT_MESH_LEFT
                       : at->x > guard ? GLINT_MESH_RIGHT
                                       : 0) |
                      (at->y < -guard  ? GLINT_MESH_ABOVE
                       : at->y > guard ? GLINT_MESH_BELOW
                                       : 0));
}

bool glint_mesh_vertices(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn)
{
    const int32_t guard = GLINT_MESH_GUARD;
    struct glint_mesh_vertex *vertex = drawn->vertices;
    unsigned any = 0;
#if GLINT_CORTEX_M0PLUS_ASM
    if (frame->distance == 0 && !drawn->mesh->normals)
        return glint_mesh_vertices_parallel(frame, drawn);
#endif
    for (unsigned i = 0; i < drawn->mesh->vertex_count; i++, vertex++) {
        const struct glint_mesh_place place = pose_place(drawn, i);
        struct glint_vec normal;
        pose_normal(&normal, drawn->mesh, i);
        glint_mesh_light(vertex, drawn, &normal);
        if (glint_mesh_is_near(frame, place.z)) {
            any = vertex->out = GLINT_MESH_NEAR;
            continue;
        }
        const struct glint_mesh_place at = pose_project(frame, place);
        vertex->out = 0;
        if (at.x < -guard || at.x > guard || at.y < -guard || at.y > guard) /* few are */
            any = vertex->out = pose_out(&at);
        vertex->x = (int16_t)(at.x + 8 * frame->w); /* of use where it is not out */
        vertex->y = (int16_t)(at.y + 8 * frame->h);
        vertex->z = (uint16_t)at.z;
    }
    return any != 0;
}

/* Sutherland and Hodgman: plane after plane, a corner inside stays and a side that crosses leaves its crossing. First the near plane, in
 * space, then the guard band, on the screen. A crossing is found from the inner corner on, so that two triangles find the
 * same one on the side that they share. */

/* a + (b - a) part / whole, rounded down: |b - a| < 2^24, 0 <= part <= whole < 2^24. */
static int32_t clip_between(int32_t a, int32_t b, int32_t part, int32_t whole)
{
    const int64_t x = (int64_t)(b - a) * part;
    return a + (int32_t)(x < 0 ? -((-x + whole - 1) / whole) : x / whole);
}

/* in_space: weights are to be linear in space, as textures are, and this is on the screen, where depth is 65535 - r: there it is part r_out of
 * part r_out + (whole - part) r_in; both are cut to fit. */
static struct glint_mesh_clipped clip_crossing(const struct glint_mesh_clipped *in,
                                               const struct glint_mesh_clipped *out, int32_t part, int32_t whole,
                                               bool in_space)
{
    struct glint_mesh_clipped crossing = {{clip_between(in->at.x, out->at.x, part, whole),
                                           clip_between(in->at.y, out->at.y, part, whole),
                                           clip_between(in->at.z, out->at.z, part, whole)},
                                          {(int16_t)clip_between(in->normal.x, out->normal.x, part, whole),
                                           (int16_t)clip_between(in->normal.y, out->normal.y, part, whole),
                                           (int16_t)clip_between(in->normal.z, out->normal.z, part, whole)},
                                          {0, 0}};
    if (in_space) {
        for (; whole >> 16; whole >>= 1)
            part >>= 1;
        const int32_t near = part * ((65535 - out->at.z) >> 1); /* with the rest < 2^31 */
        whole = (near + (whole - part) * ((65535 - in->at.z) >> 1)) >> 7;
        part = near >> 7;
    }
    for (unsigned i = 0; i < 2; i++)
        crossing.weight[i] = whole ? (uint16_t)clip_between(in->weight[i], out->weight[i], part, whole) : in->weight[i];
    return crossing;
}

/* How far inside one of the planes: 0 and more is inside. */
static int32_t clip_inside(const struct glint_mesh_frame *frame, unsigned plane, const struct glint_mesh_place *at)
{
    switch (plane) {
    case GLINT_MESH_NEAR:
        return (int32_t)frame->distance - ((int32_t)frame->distance + 7) / 8 - at->z;
    case GLINT_MESH_LEFT:
        return at->x + GLINT_MESH_GUARD;
    case GLINT_MESH_RIGHT:
        return GLINT_MESH_GUARD - at->x;
    case GLINT_MESH_ABOVE:
        return at->y + GLINT_MESH_GUARD;
    default:
        return GLINT_MESH_GUARD - at->y; /* GLINT_MESH_BELOW */
    }
}

/* From one list to the other. A convex polygon gains one corner at most; where rounding made it something
 * else, what exceeds the place for it is left out. None or 3 at least remain: one inside and two crossings. */
static unsigned clip_plane(struct glint_mesh_polygon *polygon, unsigned count, const struct glint_mesh_frame *frame,
                           unsigned plane, bool in_space)
{
    const struct glint_mesh_clipped *from = polygon->list[polygon->now].corner;
    struct glint_mesh_clipped *to = polygon->list[1 - polygon->now].corner;
    unsigned found = 0;
    for (unsigned i = 0; i < count; i++) {
        const struct glint_mesh_clipped *a = &from[i], *b = &from[i + 1 < count ? i + 1 : 0];
        const int32_t a_in = clip_inside(frame, plane, &a->at), b_in = clip_inside(frame, plane, &b->at);
        if (a_in >= 0 && found < GLINT_MESH_POLYGON)
            to[found++] = *a;
        if ((a_in >= 0) != (b_in >= 0) && found < GLINT_MESH_POLYGON)
            to[found++] = a_in >= 0 ? clip_crossing(a, b, a_in, a_in - b_in, in_space)
                                    : clip_crossing(b, a, b_in, b_in - a_in, in_space);
    }
    polygon->now = (uint8_t)(1 - polygon->now);
    return found;
}

unsigned glint_mesh_clip(struct glint_mesh_polygon *polygon, const struct glint_mesh_frame *frame,
                         const struct glint_mesh_drawn *drawn, const uint16_t face[3])
{
    struct glint_mesh_clipped *corner = polygon->list[0].corner;
    unsigned count = 3;
    polygon->now = 0;
    for (unsigned i = 0; i < 3; i++) {
        corner[i].at = glint_mesh_place_of(drawn, face[i]);
        glint_mesh_normal(&corner[i].normal, drawn->mesh, face[i]);
        corner[i].weight[0] = i == 1 ? 32768 : 0;
        corner[i].weight[1] = i == 2 ? 32768 : 0;
    }
    if (frame->distance)
        count = clip_plane(polygon, count, frame, GLINT_MESH_NEAR, false);
    corner = polygon->list[polygon->now].corner;
    for (unsigned i = 0; i < count; i++)
        corner[i].at = glint_mesh_project(frame, corner[i].at);
    for (unsigned plane = GLINT_MESH_LEFT; plane <= GLINT_MESH_BELOW && count; plane <<= 1)
        count = clip_plane(polygon, count, frame, plane, frame->distance && drawn->mesh->textures);
    return count;
}

void glint_mesh_clip_vertex(struct glint_mesh_vertex *vertex, const struct glint_mesh_frame *frame,
                            const struct glint_mesh_drawn *drawn, const struct glint_mesh_clipped *clipped)
{
    vertex->x = (int16_t)(clipped->at.x + 8 * frame->w);
    vertex->y = (int16_t)(clipped->at.y + 8 * frame->h);
    vertex->z = (uint16_t)clipped->at.z;
    vertex->out = 0;
    glint_mesh_light(vertex, drawn, &clipped->normal);
    if (drawn->paints->light_count == 0)
        vertex->nl_q30 = -1; /* dark */
}
