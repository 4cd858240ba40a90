/* SPDX-License-Identifier: MIT
 * The cores share nothing that either writes, but for the fork and the join: each has a frame of its own and places the vertices again,
 * which costs a thirtieth of the picture. A strip's memory is drawn to again as soon as it has been sent. */
#include "turntable.h"

static size_t pixels_of(const struct turntable *turntable, unsigned lines)
{
    return (size_t)turntable->pieces.panel->width * lines;
}

/* A core's memory: what belongs to the mesh, then to the frame. */
static size_t mesh_bytes(const struct turntable *turntable)
{
    return (glint_mesh_bytes(turntable->mesh, turntable->pieces.panel->height) + 3) & ~(size_t)3;
}

static bool has_memory(const struct turntable *turntable)
{
    const struct panel *panel = turntable->pieces.panel;
    const size_t bytes = mesh_bytes(turntable) + glint_mesh_frame_bytes(panel->width, TURNTABLE_LINES);
    const bool one_core = turntable->lower_y == panel->height;
    const unsigned strips = one_core ? 2 : (panel->height + TURNTABLE_LINES - 1u) / TURNTABLE_LINES;
    return turntable->memory_bytes >= bytes && turntable->strip_count >= strips &&
           turntable->strip_count <= TURNTABLE_STRIPS_MAX &&
           (one_core || (turntable->core[1].memory && turntable->pieces.hal->fork));
}

enum glint_err turntable_start(struct turntable *turntable)
{
    const enum glint_err error = glint_mesh_check(turntable->mesh);
    if (error == GLINT_OK && (turntable->mesh->part_count > 1 || !has_memory(turntable)))
        return GLINT_ERR_ARG;
    return error;
}

enum glint_err turntable_frame(struct turntable *turntable, const struct glint_pose *pose, const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    struct glint_light light;
    if (!(pose->turn[0] | pose->turn[1] | pose->turn[2] | pose->turn[3]))
        return GLINT_ERR_VECTOR;
    if (turntable->paint->output.format > GLINT_RGB565_SWAPPED)
        return GLINT_ERR_FORMAT;
    enum glint_err error = glint_light_directional(&light, to_light);
    if (error == GLINT_OK) /* here, before both cores draw with it */
        error = glint_paint_light(turntable->paint, &light, 1, to_viewer);
    if (error != GLINT_OK)
        return error;
    turntable->pose = *pose;
    turntable->line = 0;
    turntable->is_begun = false;
    turntable->in_frame = true;
    return GLINT_OK;
}

/* Arguments are those that turntable_start and turntable_frame have seen: nothing is refused here. */
static void begin(const struct turntable *turntable, struct turntable_core *core)
{
    const struct panel *panel = turntable->pieces.panel;
    const size_t bytes = mesh_bytes(turntable);
    glint_mesh_begin(&core->frame, panel->width, panel->height, TURNTABLE_LINES, 0, core->memory + bytes / 4,
                     turntable->memory_bytes - bytes);
    glint_mesh_add(&core->frame, &core->drawn, turntable->mesh, &turntable->pose, turntable->paint, core->memory,
                   bytes);
}

static unsigned strip_lines(unsigned y, unsigned end)
{
    return end - y < TURNTABLE_LINES ? end - y : TURNTABLE_LINES;
}

static uint16_t *strip_of(const struct turntable *turntable, unsigned strip)
{
    return (uint16_t *)(void *)turntable->strips + pixels_of(turntable, TURNTABLE_LINES) * strip;
}

/* Two pixels at a time. */
static void draw(const struct turntable *turntable, struct turntable_core *core, unsigned y, unsigned lines,
                 uint16_t *pixels)
{
    const size_t count = pixels_of(turntable, lines);
    const struct glint_surface surface = {pixels, (ptrdiff_t)(pixels_of(turntable, 1) * sizeof *pixels), 0, 0};
    const uint32_t pair = turntable->background * (uint32_t)0x10001;
    uint32_t *at = (uint32_t *)(void *)pixels;
    for (const uint32_t *const end = at + (count + 1) / 2; at != end; at++)
        *at = pair;
    glint_mesh_strip(&core->frame, (uint16_t)y, (uint16_t)lines, &surface);
}

static unsigned first_lower(const struct turntable *turntable)
{
    return turntable->lower_y / TURNTABLE_LINES;
}

/* On the other core. */
static void draw_lower(void *argument)
{
    struct turntable *turntable = argument;
    const unsigned end = turntable->pieces.panel->height;
    unsigned strip = first_lower(turntable);
    begin(turntable, &turntable->core[1]);
    for (unsigned y = turntable->lower_y; y < end; y += TURNTABLE_LINES, strip++) {
        while (!pieces_are_sent(&turntable->pieces, turntable->sent[strip]))
            ;
        draw(turntable, &turntable->core[1], y, strip_lines(y, end), strip_of(turntable, strip));
    }
}

static void begin_frame(struct turntable *turntable)
{
    const struct hal *hal = turntable->pieces.hal;
    turntable->is_forked = turntable->lower_y < turntable->pieces.panel->height;
    if (turntable->is_forked)
        hal->fork(hal->context, draw_lower, turntable);
    begin(turntable, &turntable->core[0]);
    turntable->is_begun = true;
}

static void join(struct turntable *turntable)
{
    const struct hal *hal = turntable->pieces.hal;
    if (turntable->is_forked)
        hal->join(hal->context);
    turntable->is_forked = false;
}

static void send(struct turntable *turntable, unsigned strip, unsigned y, unsigned lines)
{
    turntable->sent[strip] = pieces_add(&turntable->pieces, strip_of(turntable, strip), y, lines);
}

/* After the last strip of this core. */
static void end_frame(struct turntable *turntable)
{
    const unsigned end = turntable->pieces.panel->height;
    unsigned strip = first_lower(turntable);
    join(turntable);
    for (unsigned y = turntable->lower_y; y < end; y += TURNTABLE_LINES)
        send(turntable, strip++, y, strip_lines(y, end));
    turntable->in_frame = false;
}

void turntable_stop(struct turntable *turntable)
{
    join(turntable);
    turntable->in_frame = false;
    turntable->strip = 0; /* the next frame's first; those behind are the other core's */
    while (!pieces_are_sent(&turntable->pieces, turntable->pieces.added))
        ;
}

enum turntable_step turntable_step(struct turntable *turntable)
{
    struct pieces *const pieces = &turntable->pieces;
    const unsigned strip = turntable->strip, y = turntable->line;
    if (pieces->has_failed)
        return TURNTABLE_BUS_FAILED;
    if (!turntable->in_frame)
        return pieces_are_sent(pieces, pieces->added) ? TURNTABLE_DONE : TURNTABLE_BUSY;
    if (!turntable->is_begun) {
        begin_frame(turntable);
        return TURNTABLE_BUSY;
    }
    if (!pieces_are_sent(pieces, turntable->sent[strip]))
        return TURNTABLE_BUSY;
    const unsigned lines = strip_lines(y, turntable->lower_y);
    draw(turntable, &turntable->core[0], y, lines, strip_of(turntable, strip));
    send(turntable, strip, y, lines);
    turntable->line = (uint16_t)(y + lines);
    if (turntable->line < turntable->lower_y || !turntable->is_forked)
        turntable->strip = (uint8_t)(strip + 1u < turntable->strip_count ? strip + 1u : 0);
    else
        turntable->strip = 0;
    if (turntable->line == turntable->lower_y)
        end_frame(turntable);
    return TURNTABLE_BUSY;
}
