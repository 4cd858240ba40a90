/* SPDX-License-Identifier: MIT
 * A part of a picture is the picture of a window: its middle is another, by a whole number of sixteenths of a pixel, so that the mesh's place there
 * is exact, and its pixels are the same. The window begins where LVGL's strip does in which the box begins: so strips come in order from the first one
 * on, which spares sorting faces again, and where they are whole bands, they are glint's. */
#include "glint_lvgl_mesh.h"
#include <lvgl_private.h> /* lv_hit_test_info_t */

/* ---- which pixels a mesh may touch ---- */

/* Right and up in the mesh's axes, Q14. */
static void rows_of(const struct glint_pose *pose, int32_t rows[2][3])
{
    const int64_t w = pose->turn[0], x = pose->turn[1], y = pose->turn[2], z = pose->turn[3];
    const int64_t length = w * w + x * x + y * y + z * z; /* > 0 */
    const int64_t of[2][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                              {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)}};
    for (unsigned i = 0; i < 2; i++)
        for (unsigned k = 0; k < 3; k++)
            rows[i][k] = (int32_t)(of[i][k] * 16384 / length);
}

/* Pixels from..to of at most `size`, with one beside them for what is rounded. Sixteenths of a pixel from the middle. */
static void range(int64_t from, int64_t to, int32_t size, uint16_t *first, uint16_t *count)
{
    const int64_t low = (from + 8 * (int64_t)size) / 16 - 2, high = (to + 8 * (int64_t)size) / 16 + 2;
    const int64_t begin = low < 0 ? 0 : low > size ? size : low, end = high < 0 ? 0 : high > size ? size : high;
    *first = (uint16_t)begin;
    *count = (uint16_t)(end - begin);
}

static struct glint_box box_of(const struct glint_lvgl_mesh *mesh, const struct glint_pose *pose, int32_t w, int32_t h)
{
    int32_t rows[2][3], least[2] = {INT32_MAX, INT32_MAX}, most[2] = {INT32_MIN, INT32_MIN};
    const int16_t *place = mesh->mesh->places;
    struct glint_box box;
    rows_of(pose, rows);
    for (unsigned left = mesh->mesh->vertex_count; left; left--, place += 3) {
        for (unsigned i = 0; i < 2; i++) {
            const int32_t at = rows[i][0] * place[0] + rows[i][1] * place[1] + rows[i][2] * place[2]; /* < 2^30 */
            least[i] = at < least[i] ? at : least[i];
            most[i] = at > most[i] ? at : most[i];
        }
    }
    const int64_t scale = pose->scale, one = 16384 * (int64_t)32768;
    range(pose->position[0] + least[0] * scale / one, pose->position[0] + most[0] * scale / one, w, &box.x, &box.w);
    range(pose->position[1] - most[1] * scale / one, pose->position[1] - least[1] * scale / one, h, &box.y, &box.h);
    return box;
}

static void size_of(const struct glint_lvgl_mesh *mesh, int32_t *w, int32_t *h)
{
    lv_area_t at;
    lv_obj_get_coords(mesh->object, &at);
    *w = at.x2 - at.x1 + 1;
    *h = at.y2 - at.y1 + 1;
}

static void invalidate(const struct glint_lvgl_mesh *mesh)
{
    lv_area_t at;
    if (!mesh->object || !mesh->box.w || !mesh->box.h)
        return;
    lv_obj_get_coords(mesh->object, &at);
    const lv_area_t area = {at.x1 + mesh->box.x, at.y1 + mesh->box.y, at.x1 + mesh->box.x + mesh->box.w - 1,
                            at.y1 + mesh->box.y + mesh->box.h - 1};
    lv_obj_invalidate_area(mesh->object, &area);
}

/* ---- drawing ---- */

/* Lines above the part that LVGL's strip has, up to a band of them: in the object, if the box begins in this strip. */
static uint16_t lead_of(const struct glint_lvgl_mesh *mesh, const lv_layer_t *layer, const struct glint_box *part)
{
    lv_area_t at;
    lv_obj_get_coords(mesh->object, &at);
    const int32_t clip = layer->_clip_area.y1, buffer = layer->buf_area.y1;
    const int32_t above = at.y1 + part->y - (clip > buffer ? clip : buffer), lead = above % (int32_t)GLINT_MESH_BAND;
    return (uint16_t)(part->y != mesh->box.y ? 0 : lead < part->y ? lead : part->y);
}

static enum glint_err begin(struct glint_lvgl_mesh *mesh, const struct glint_paint *paints,
                            const struct glint_box *part, uint16_t lead, int32_t w, int32_t h)
{
    struct glint_pose pose = mesh->pose;
    const int32_t x = pose.position[0] + 8 * (w - part->w) - 16 * part->x;
    const uint16_t top = (uint16_t)(mesh->box.y - lead), lines = (uint16_t)(mesh->box.h + lead);
    const int32_t y = pose.position[1] + 8 * (h - lines) - 16 * top;
    if (x < INT16_MIN || x > INT16_MAX || y < INT16_MIN || y > INT16_MAX)
        return GLINT_ERR_ARG;
    pose.position[0] = (int16_t)x;
    pose.position[1] = (int16_t)y;
    mesh->begun = NULL;
    enum glint_err err = glint_mesh_begin(&mesh->frame, part->w, lines, GLINT_MESH_BAND, 0,
                                          (char *)mesh->memory + mesh->mesh_bytes, mesh->bytes - mesh->mesh_bytes);
    if (err == GLINT_OK)
        err = glint_mesh_add(&mesh->frame, &mesh->drawn, mesh->mesh, &pose, paints, mesh->memory, mesh->mesh_bytes);
    if (err != GLINT_OK)
        return err;
    mesh->begun = paints;
    mesh->x = part->x;
    mesh->y = top;
    mesh->w = part->w;
    mesh->h = (uint16_t)h;
    return GLINT_OK;
}

static enum glint_err draw(struct glint_lvgl_mesh *mesh, lv_layer_t *layer)
{
    const bool is_own_layer = mesh->layer_paints && layer->color_format == LV_COLOR_FORMAT_ARGB8888 &&
                              mesh->paints->output.format != GLINT_ARGB8888;
    const struct glint_paint *paints = is_own_layer ? mesh->layer_paints : mesh->paints;
    struct glint_box part;
    struct glint_surface surface;
    uint16_t lead = 0;
    int32_t w, h;
    size_of(mesh, &w, &h);
    enum glint_err err = glint_lvgl_part(mesh->object, layer, &mesh->box, paints->output.format, &part, &surface);
    if (err != GLINT_OK || part.w == 0)
        return err;
    if (mesh->begun != paints || mesh->x != part.x || mesh->w != part.w || mesh->h != h) {
        lead = lead_of(mesh, layer, &part);
        err = begin(mesh, paints, &part, lead, w, h);
    }
    surface.pixels = (char *)surface.pixels - surface.stride * (ptrdiff_t)lead; /* where it draws nothing */
    surface.y = (uint16_t)(surface.y - lead);
    for (unsigned y = (unsigned)part.y - lead - mesh->y, end = y + lead + part.h; y < end && err == GLINT_OK;) {
        const unsigned left = end - y, next = y + GLINT_MESH_BAND - (left > GLINT_MESH_BAND ? y % GLINT_MESH_BAND : 0);
        const unsigned stop = next < end ? next : end; /* where there are several, whole bands cost least */
        err = glint_mesh_strip(&mesh->frame, (uint16_t)y, (uint16_t)(stop - y), &surface);
        surface.pixels = (char *)surface.pixels + surface.stride * (ptrdiff_t)(stop - y);
        surface.y = (uint16_t)(surface.y + stop - y);
        y = stop;
    }
    return err;
}

/* ---- events ---- */

/* Is the point, in sixteenths of a pixel, on the triangle or its edges, whichever way it faces? */
static bool covers(const struct glint_mesh_vertex *vertices, const uint16_t *face, int32_t x, int32_t y)
{
    bool is_left = false, is_right = false;
    for (unsigned i = 0; i < 3; i++) {
        const struct glint_mesh_vertex *a = &vertices[face[i]], *b = &vertices[face[(i + 1) % 3]];
        const int64_t side = (int64_t)(b->x - a->x) * (y - a->y) - (int64_t)(b->y - a->y) * (x - a->x);
        if (a->out)
            return false;
        is_left |= side < 0;
        is_right |= side > 0;
    }
    return is_left != is_right; /* seen from its edge it has neither */
}

/* By the vertices of the picture that was drawn last. */
static bool is_hit(const struct glint_lvgl_mesh *mesh, const lv_point_t *point)
{
    lv_area_t at;
    lv_obj_get_coords(mesh->object, &at);
    const int32_t x = 16 * (point->x - at.x1 - mesh->x) + 8, y = 16 * (point->y - at.y1 - mesh->y) + 8;
    for (unsigned i = 0; mesh->begun && i < mesh->mesh->face_count; i++)
        if (covers(mesh->drawn.vertices, mesh->mesh->faces + 3 * i, x, y))
            return true;
    return false;
}

static void on_draw(lv_event_t *event)
{
    struct glint_lvgl_mesh *mesh = (struct glint_lvgl_mesh *)lv_event_get_user_data(event);
    mesh->err = draw(mesh, lv_event_get_layer(event));
}

static void on_hit_test(lv_event_t *event)
{
    lv_hit_test_info_t *info = lv_event_get_hit_test_info(event);
    info->res = is_hit((const struct glint_lvgl_mesh *)lv_event_get_user_data(event), info->point);
}

/* LVGL redraws all of an object whose size changes. */
static void on_size(lv_event_t *event)
{
    struct glint_lvgl_mesh *mesh = (struct glint_lvgl_mesh *)lv_event_get_user_data(event);
    int32_t w, h;
    size_of(mesh, &w, &h);
    mesh->begun = NULL;
    mesh->box = box_of(mesh, &mesh->pose, w, h);
}

/* With its screen, or by another's call: what users call must not reach what is gone. */
static void on_delete(lv_event_t *event)
{
    struct glint_lvgl_mesh *mesh = (struct glint_lvgl_mesh *)lv_event_get_user_data(event);
    mesh->object = NULL;
}

/* ---- what users call ---- */

size_t glint_lvgl_mesh_bytes(const struct glint_mesh *mesh, uint16_t w, uint16_t h)
{
    return ((glint_mesh_bytes(mesh, h) + 7) & ~(size_t)7) + glint_mesh_frame_bytes(w, GLINT_MESH_BAND);
}

lv_obj_t *glint_lvgl_mesh_create(struct glint_lvgl_mesh *mesh, lv_obj_t *parent, uint16_t w, uint16_t h, void *memory,
                                 size_t bytes)
{
    static const struct glint_pose unseen = {{1, 0, 0, 0}, {0, 0, 0}, 0};
    mesh->err = glint_mesh_check(mesh->mesh);
    if (mesh->err == GLINT_OK && bytes < glint_lvgl_mesh_bytes(mesh->mesh, w, h))
        mesh->err = GLINT_ERR_ARG;
    mesh->object = mesh->err == GLINT_OK ? lv_obj_create(parent) : NULL;
    if (!mesh->object)
        return NULL;
    mesh->pose = unseen;
    mesh->begun = NULL;
    mesh->memory = memory;
    mesh->bytes = bytes;
    mesh->mesh_bytes = (glint_mesh_bytes(mesh->mesh, h) + 7) & ~(size_t)7;
    mesh->box.w = mesh->box.h = 0;
    lv_obj_remove_style_all(mesh->object);
    lv_obj_set_size(mesh->object, w, h);
    lv_obj_add_flag(mesh->object, LV_OBJ_FLAG_ADV_HITTEST);
    lv_obj_add_event_cb(mesh->object, on_draw, LV_EVENT_DRAW_MAIN, mesh);
    lv_obj_add_event_cb(mesh->object, on_hit_test, LV_EVENT_HIT_TEST, mesh);
    lv_obj_add_event_cb(mesh->object, on_size, LV_EVENT_SIZE_CHANGED, mesh);
    lv_obj_add_event_cb(mesh->object, on_delete, LV_EVENT_DELETE, mesh);
    return mesh->object;
}

enum glint_err glint_lvgl_mesh_set_pose(struct glint_lvgl_mesh *mesh, const struct glint_pose *pose)
{
    int32_t w, h;
    if (!(pose->turn[0] | pose->turn[1] | pose->turn[2] | pose->turn[3]))
        return GLINT_ERR_VECTOR;
    if (!mesh->object)
        return GLINT_ERR_ARG;
    size_of(mesh, &w, &h);
    invalidate(mesh);
    mesh->pose = *pose;
    mesh->begun = NULL;
    mesh->box = box_of(mesh, pose, w, h);
    invalidate(mesh);
    return GLINT_OK;
}

enum glint_err glint_lvgl_mesh_set_light(struct glint_lvgl_mesh *mesh, const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    const unsigned parts = mesh->mesh->part_count ? mesh->mesh->part_count : 1;
    struct glint_light light;
    enum glint_err err = glint_light_directional(&light, to_light);
    for (unsigned i = 0; i < parts && err == GLINT_OK; i++) {
        err = glint_paint_light(&mesh->paints[i], &light, 1, to_viewer);
        if (err == GLINT_OK && mesh->layer_paints)
            err = glint_paint_light(&mesh->layer_paints[i], &light, 1, to_viewer);
    }
    mesh->begun = NULL;
    invalidate(mesh);
    return err;
}

void glint_lvgl_mesh_set_paint(struct glint_lvgl_mesh *mesh, struct glint_paint *paints,
                               struct glint_paint *layer_paints)
{
    mesh->paints = paints;
    mesh->layer_paints = layer_paints;
    mesh->begun = NULL;
    invalidate(mesh);
}
