/* SPDX-License-Identifier: MIT
 * Fuzzes meshes: any vertices, faces, parts, colours, textures, neighbours, grain, pose and lights that glint_mesh_check lets through are drawn within
 * their memory, by any paint, with outlines or without, once or twice in a picture, and in strips as at once. Input: see next_mesh, next_look and draw; then strips: y, height (1 each). */
#include <string.h>

#include "fuzz.h"
#include "glint_mesh.h"

enum { VERTICES_MAX = 32, FACES_MAX = 64, PARTS_MAX = 3, SIDE_MAX = 48 };

/* Each array in a block of its own, so that reading beyond it is noticed. */
struct made {
    struct glint_mesh mesh;
    int16_t *places, *normals;
    int8_t *normals8;
    uint16_t *faces, *ends, *neighbours;
    uint8_t *of_vertices, *of_faces;
    uint16_t *uv, *palette;
    struct glint_texture *textures; /* of each part */
    void *texels;                   /* which all of them have */
};

static void *block(size_t bytes)
{
    void *memory = calloc(1, bytes ? bytes : 1);
    check(memory);
    return memory;
}

static uint8_t *next_colours(struct input *input, unsigned count)
{
    uint8_t *const colours = block(3 * count);
    for (unsigned i = 0; i < 3 * count; i++)
        colours[i] = (uint8_t)next_byte(input);
    return colours;
}

/* A texture for each part that there may be, of the same texels; sizes, levels and uv_bits also such as are refused. */
static void next_textures(struct made *m, struct input *input)
{
    const unsigned how = next_byte(input), w = next_byte(input) % 40, h = next_byte(input) % 40,
                   levels = next_byte(input) % 14;
    const unsigned parts = m->mesh.part_count ? m->mesh.part_count : 1;
    size_t count = 0;
    for (unsigned i = 0, x = w, y = h; i<levels; i++, x = x> 1 ? x / 2 : 1, y = y > 1 ? y / 2 : 1)
        count += (size_t)x * y;
    const size_t size = how % 2 ? 1 : 2;
    uint8_t *const texels = block(count * size);
    for (size_t i = 0; i < count * size; i++)
        texels[i] = (uint8_t)(i * 37 + how);
    m->texels = texels;
    m->palette = block(512);
    m->textures = block(parts * sizeof *m->textures);
    for (unsigned i = 0; i < parts; i++)
        if (i == 0 || how / 4 % 2)
            m->textures[i] = (struct glint_texture){
                texels, how % 2 ? m->palette : NULL, (uint16_t)w, (uint16_t)h, (uint8_t)levels, how / 2 % 2};
    m->uv = block(4 * (size_t)m->mesh.vertex_count);
    for (unsigned i = 0; i < 2u * m->mesh.vertex_count; i++)
        m->uv[i] = (uint16_t)next_word(input);
    m->mesh.uv = m->uv;
    m->mesh.uv_bits = (uint8_t)(7 + how / 8 % 10);
    m->mesh.textures = m->textures;
}

/* The face that has edge i the other way, or none. */
static uint16_t beyond(const struct made *m, unsigned i)
{
    const uint16_t a = m->faces[i], b = m->faces[i % 3 == 2 ? i - 2 : i + 1];
    for (unsigned j = 0; j < 3u * m->mesh.face_count; j++)
        if (m->faces[j] == b && m->faces[j % 3 == 2 ? j - 2 : j + 1] == a)
            return (uint16_t)(j / 3);
    return GLINT_MESH_RIM;
}

/* As they are; or faces, rims, seams, and numbers that are refused. */
static void next_neighbours(struct made *m, struct input *input)
{
    static const uint16_t others[] = {GLINT_MESH_RIM, GLINT_MESH_RIM, GLINT_MESH_SEAM, FACES_MAX + 1};
    const bool fit = next_byte(input) % 2;
    m->mesh.neighbours = m->neighbours = block(6 * (size_t)m->mesh.face_count);
    for (unsigned i = 0; i < 3u * m->mesh.face_count; i++) {
        const unsigned number = fit ? 0 : next_byte(input);
        m->neighbours[i] = fit                                    ? beyond(m, i)
                           : number % 2 && number / 2 < FACES_MAX ? (uint16_t)(number / 2)
                                                                  : others[number / 2 % 4];
    }
}

static struct made next_mesh(struct input *input)
{
    const unsigned vertices = next_byte(input) % (VERTICES_MAX + 1), faces = next_byte(input) % (FACES_MAX + 1);
    const unsigned how = next_byte(input), parts = how / 2 % (PARTS_MAX + 1);
    struct made m = {.places = block(6 * vertices), .faces = block(6 * faces), .ends = block(2 * parts)};
    m.mesh = (struct glint_mesh){.places = m.places,
                                 .faces = m.faces,
                                 .ends = parts ? m.ends : NULL,
                                 .vertex_count = (uint16_t)vertices,
                                 .face_count = (uint16_t)faces,
                                 .part_count = (uint8_t)parts};
    if (how % 2)
        m.mesh.normals8 = m.normals8 = block(3 * vertices);
    else
        m.mesh.normals = m.normals = block(6 * vertices);
    for (unsigned i = 0; i < 3 * vertices; i++) {
        m.places[i] = (int16_t)next_word(input);
        if (how % 2)
            m.normals8[i] = (int8_t)next_byte(input);
        else
            m.normals[i] = (int16_t)next_word(input);
    }
    for (unsigned i = 0; i < 3 * faces; i++)
        m.faces[i] = (uint16_t)(next_byte(input) % (VERTICES_MAX + 1));
    for (unsigned i = 0; i < parts; i++)
        m.ends[i] = (uint16_t)(i + 1 < parts || how / 8 % 2 ? next_byte(input) : faces);
    if (how / 16 % 2)
        m.mesh.of_vertices = m.of_vertices = next_colours(input, vertices);
    if (how / 32 % 2)
        m.mesh.of_faces = m.of_faces = next_colours(input, faces);
    m.mesh.use = &glint_use_mesh_albedo;
    if (how / 64 % 2)
        next_textures(&m, input);
    if (how / 128)
        next_neighbours(&m, input);
    return m;
}

static void made_free(struct made *m)
{
    free(m->places);
    free(m->normals);
    free(m->normals8);
    free(m->faces);
    free(m->ends);
    free(m->neighbours);
    free(m->of_vertices);
    free(m->of_faces);
    free(m->uv);
    free(m->palette);
    free(m->textures);
    free(m->texels);
}

static bool is_good(const struct glint_mesh *mesh)
{
    bool good = mesh->vertex_count > 0 && !(mesh->of_vertices && mesh->of_faces);
    for (unsigned i = 0; i < 3u * mesh->face_count; i++)
        good = good && mesh->faces[i] < mesh->vertex_count;
    for (unsigned i = 0; mesh->neighbours && i < 3u * mesh->face_count; i++)
        good = good && (mesh->neighbours[i] < mesh->face_count || mesh->neighbours[i] >= GLINT_MESH_SEAM);
    for (unsigned i = 0; !mesh->normals && i < 3u * mesh->vertex_count; i++)
        good = good && mesh->normals8[i] != -128;
    for (unsigned i = 0; i < mesh->part_count; i++)
        good = good && mesh->ends[i] >= (i ? mesh->ends[i - 1] : 0) && mesh->ends[i] <= mesh->face_count;
    for (unsigned i = 0; mesh->textures && (i == 0 || i < mesh->part_count); i++) {
        const struct glint_texture *t = &mesh->textures[i];
        good = good && (!t->pixels || (t->w && t->h && t->levels && t->levels <= 12));
    }
    good = good &&
           (!mesh->textures || (mesh->uv_bits >= 8 && mesh->uv_bits <= 15 && !mesh->of_vertices && !mesh->of_faces));
    return good && (mesh->part_count == 0 || mesh->ends[mesh->part_count - 1] == mesh->face_count);
}

enum { LIGHTS_MAX = 4 };
static const int32_t to_viewer[3] = {0, 0, 1};

struct look {
    struct glint_pose pose;
    struct glint_light lights[LIGHTS_MAX];
    uint16_t w, h, distance;
    size_t line;    /* bytes of the picture's */
    size_t more;    /* bytes of a frame, for lights */
    bool is_twice;  /* in the picture, the second one elsewhere */
    uint8_t ground; /* of its pixels */
    uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
    struct glint_paint paints[PARTS_MAX];
};

static void next_directions(int32_t direction[3], struct input *input)
{
    for (int i = 0; i < 3; i++)
        direction[i] = (int32_t)(next_word(input) << 16 | 1);
}

static void next_place(int32_t place[3], struct input *input)
{
    for (int i = 0; i < 3; i++)
        place[i] = (int16_t)next_word(input);
}

/* One of any kind. */
static enum glint_err next_light(struct glint_light *light, struct input *input)
{
    const unsigned kind = next_byte(input);
    int32_t at[3], target[3];
    if (kind % 4 == 0) {
        next_directions(at, input);
        return glint_light_directional(light, at);
    }
    next_place(at, input);
    const uint32_t range = 1 + next_word(input);
    if (kind % 4 == 1)
        return glint_light_point(light, at, range);
    next_place(target, input);
    const int32_t inner = (int16_t)next_word(input), outer = (int16_t)next_word(input); /* cosines, Q15 */
    return glint_light_spot(light, at, target, range, inner * 32768, outer * 32768);
}

/* At most `count` lights, 0: a directional one; up to the first that the library refuses. */
static unsigned next_lights(struct look *look, unsigned count, struct input *input)
{
    int32_t to_light[3];
    unsigned good = 0;
    if (count == 0) {
        next_directions(to_light, input);
        return glint_light_directional(look->lights, to_light) == GLINT_OK;
    }
    while (good < count && next_light(&look->lights[good], input) == GLINT_OK)
        good++;
    return good;
}

static size_t line_bytes(unsigned format, unsigned w)
{
#define FORMAT_BITS(number, name, bits, channels, red, green, blue) bits,
    static const uint8_t bits[] = {GLINT_FORMATS(FORMAT_BITS)};
#undef FORMAT_BITS
    return (bits[format] * w + 7) / 8;
}

/* Grain along an axis of any length: an exact paint's under a directional light. */
static void next_grain(struct look *look, struct made *m, struct glint_material *material, struct input *input)
{
    material->model = GLINT_MSH;
    material->n_across = (uint16_t)(1 + next_byte(input));
    for (int i = 0; i < 3; i++)
        m->mesh.grain[i] = (int16_t)next_word(input);
    m->mesh.use_grain = &glint_use_mesh_grain;
    look->more = GLINT_MESH_LIGHTS_BYTES;
}

/* Paints of the parts: exact, or by tables and the second one exact, and what has no texture where others have one. */
static void next_look(struct look *look, struct made *m, struct input *input)
{
    const bool coloured = m->of_vertices || m->of_faces || m->textures;
    static const uint8_t formats[] = {GLINT_RGB888, GLINT_RGB565_SWAPPED, GLINT_RGB565, GLINT_GREY8};
    const unsigned how = next_byte(input);
    const bool several = how / 128 % 2, tables = !several && how / 4 % 4 && how % 4 % 3;
    look->w = (uint16_t)(1 + next_byte(input) % SIDE_MAX);
    look->h = (uint16_t)(1 + next_byte(input) % SIDE_MAX);
    look->distance = (uint16_t)(how / 16 % 2 ? next_word(input) : 0);
    for (int i = 0; i < 4; i++)
        look->pose.turn[i] = (int16_t)next_word(input);
    for (int i = 0; i < 3; i++)
        look->pose.position[i] = (int16_t)next_word(input);
    look->pose.scale = (uint16_t)next_word(input);
    const unsigned which = several ? next_byte(input) : 0;
    struct glint_material material = {.model = how / 64 % 2    ? GLINT_BLINN
                                               : which / 4 % 2 ? GLINT_PHONG
                                                               : GLINT_MSH,
                                      .n = (uint16_t)(1 + next_word(input) % 1000),
                                      .q = 6};
    struct glint_output output = {.format = formats[how % 4], .dither = how / 32 % 2 && !(tables && coloured)};
    /* Where what is there counts, any format, and the space. */
    const unsigned blended = m->neighbours ? next_byte(input) : 0;
    if (!tables && blended % 16 < GLINT_FORMAT_COUNT && blended) {
        output.format = (uint8_t)(blended % 16);
        output.space = blended / 16 % 2;
    }
    look->is_twice = blended / 32 % 2;
    look->ground = (uint8_t)(blended / 64 % 2 ? 0x5a : 0);
    for (int k = 0; k < 3; k++) {
        material.ambient_q16[k] = 13000;
        material.diffuse_q16[k] = 40000;
        material.specular_q16[k] = 30000;
        material.albedo[k] = 200;
    }
    look->line = line_bytes(output.format, look->w);
    look->more = several ? GLINT_MESH_LIGHTS_BYTES : 0;
    if (!several && !tables && how / 4 % 4 == 3)
        next_grain(look, m, &material, input);
    const unsigned lights = next_lights(look, several ? 1 + which % LIGHTS_MAX : 0, input);
    for (int i = 0; i < PARTS_MAX; i++) {
        struct glint_paint *paint = &look->paints[i];
        const bool is_bare = m->textures && i < m->mesh.part_count && !m->textures[i].pixels;
        check((tables && i != 1 && !is_bare
                   ? glint_paint_tables(paint, coloured ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR, &material, &output,
                                        look->memory, sizeof look->memory)
                   : glint_paint_exact(paint, &material, &output)) == GLINT_OK);
        if (glint_paint_light(paint, look->lights, lights, to_viewer) != GLINT_OK) /* straight behind */
            check(glint_paint_light(paint, NULL, 0, to_viewer) == GLINT_OK);
    }
}

/* A picture with its memory, of which `more` bytes are beyond what it needs. False where the library refused the quaternion. */
struct picture {
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn[2];
    void *memory, *work[2];
};

static bool picture_begin(struct picture *p, const struct made *m, const struct look *look, uint16_t lines, size_t more)
{
    const size_t bytes = glint_mesh_frame_bytes(look->w, lines) + look->more + more,
                 work = glint_mesh_bytes(&m->mesh, look->h);
    struct glint_pose pose = look->pose;
    const int16_t *q = pose.turn;
    const bool good = q[0] || q[1] || q[2] || q[3];
    p->memory = block(bytes);
    check(glint_mesh_begin(&p->frame, look->w, look->h, lines, look->distance, p->memory, bytes) == GLINT_OK);
    p->frame.outlines = m->neighbours ? &glint_outlines : NULL;
    for (int i = 0; i < 2; i++) {
        p->work[i] = i == 0 || look->is_twice ? block(work) : NULL;
        if (p->work[i])
            check(glint_mesh_add(&p->frame, &p->drawn[i], &m->mesh, &pose, look->paints, p->work[i], work) ==
                  (good ? GLINT_OK : GLINT_ERR_VECTOR));
        pose.position[0] = (int16_t)(pose.position[0] / 2 + 60);
        pose.position[2] = (int16_t)(pose.position[2] / 2);
    }
    return good;
}

static void picture_end(struct picture *p)
{
    free(p->memory);
    free(p->work[0]);
    free(p->work[1]);
}

static enum glint_err strip(struct picture *p, const struct look *look, unsigned y, unsigned h, uint8_t *pixels)
{
    const struct glint_surface surface = {pixels, (ptrdiff_t)look->line, 0, (uint16_t)y};
    return glint_mesh_strip(&p->frame, (uint16_t)y, (uint16_t)h, &surface);
}

static void draw(const struct made *m, const struct look *look, struct input *input)
{
    const uint16_t lines = (uint16_t)(1 + next_byte(input) % look->h);
    const size_t more = next_byte(input) % 8 * (size_t)GLINT_MESH_KEPT_BYTES, line = look->line;
    struct picture whole, cut;
    uint8_t *all = block(line * look->h);
    memset(all, look->ground, line * look->h);
    const bool good = picture_begin(&whole, m, look, look->h, 0);
    if (good)
        check(strip(&whole, look, 0, look->h, all) == GLINT_OK);
    picture_end(&whole);
    picture_begin(&cut, m, look, lines, more);
    while (good && input->at < input->end) {
        const unsigned y = next_byte(input) % (look->h + 1u), h = next_byte(input) % (lines + 2u);
        uint8_t *pixels = block(line * h);
        memset(pixels, look->ground, line * h);
        const bool fits = h > 0 && h <= lines && y < look->h && y + h <= look->h;
        check(strip(&cut, look, y, h, pixels) == (fits ? GLINT_OK : GLINT_ERR_ARG));
        check(!fits || memcmp(pixels, all + line * y, line * h) == 0);
        free(pixels);
    }
    picture_end(&cut);
    free(all);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    static struct look look;
    struct made m = next_mesh(&input);
    const bool good = glint_mesh_check(&m.mesh) == GLINT_OK;
    check(good == is_good(&m.mesh));
    if (good) {
        next_look(&look, &m, &input);
        draw(&m, &look, &input);
    }
    made_free(&m);
    return 0;
}
