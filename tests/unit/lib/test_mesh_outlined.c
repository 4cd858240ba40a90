/* SPDX-License-Identifier: MIT
 * Smooth outlines of meshes in any colours, by any paint, under any lights: beside a model of lib/sequence.md, and how they go together.
 * What they are by themselves: test_mesh_edges.c. */
#include "lamps.h"
#include "mesh_colours.h"
#include "outlines_model.h"

static struct made_mesh meshes[2];
static struct model_picture model;
static uint8_t pictures[3][(MESH_W * 4 + 20) * MESH_H]; /* lines may lie apart */
static const unsigned whole[] = {MESH_H}, odd[] = {1, 7, 16, 3, 40};
static const struct mesh_cut at_once = {whole, 1, MESH_DOWN}, in_strips = {odd, 5, MESH_SHUFFLED};

/* How a mesh is painted; the tables' formats are two. */
enum way { EXACT, COLOUR, DITHERED, ALBEDO, WAYS };
struct painted {
    struct glint_paint paints[2]; /* of parts */
    uint32_t memory[2][GLINT_TABLES_DITHER_BYTES / 4];
    struct glint_light lights[GLINT_LIGHTS_MAX];
};

/* Not Phong's, which only exact paints have. */
static void no_phong(struct look *look)
{
    if (look->material.model == GLINT_PHONG)
        look->material.model = GLINT_SG;
}

/* Two looks under one light, or none. */
static void paint_parts(struct painted *of, enum way way, enum glint_format format, enum glint_space space)
{
    const struct look first = random_look(format, space);
    for (int part = 0; part < 2; part++) {
        struct look look = random_look(format, space);
        no_phong(&look);
        look.light = first.light;
        look.output = first.output;
        if (way != EXACT)
            look.output.dither = way == DITHERED;
        if (way == EXACT)
            paint_of(&of->paints[part], &look);
        else if (way == ALBEDO)
            assert_true(paint_of_albedo(&of->paints[part], &look, of->memory[part]));
        else
            paint_of_tables(&of->paints[part], GLINT_TABLES_COLOUR, &look, of->memory[part]);
        if (way == EXACT && below(8) == 0)
            assert_int_equal(glint_paint_light(&of->paints[part], NULL, 0, in_front), GLINT_OK);
        if (part && of->paints[0].light_count != of->paints[1].light_count)
            assert_int_equal(glint_paint_light(&of->paints[1], &look.light, of->paints[0].light_count, in_front),
                             GLINT_OK);
    }
}

/* A ball somewhere, small noise, or two that meet at an edge; in two parts or one. */
static void mesh_small(struct made_mesh *m, unsigned kind)
{
    static uint16_t ends[2][2];
    if (kind % 3 == 0)
        mesh_noise(m, 3 + below(20), 1 + below(25));
    else
        mesh_ball(m, 3 + below(4), 3 + below(6));
    for (int k = 0; k < 4; k++)
        m->pose.turn[k] = (int16_t)((int)below(65535) - 32767);
    m->pose.turn[0] |= 1;
    for (int k = 0; k < 3; k++)
        m->pose.position[k] = (int16_t)((int)below(1000) - 500);
    m->pose.scale = (uint16_t)(16 * (2 + below(80)));
    m->distance = 0;
    mesh_join_both_ways(m);
    if (below(2)) {
        uint16_t *const of = ends[m - meshes];
        of[0] = (uint16_t)below(m->mesh.face_count + 1u);
        of[1] = m->mesh.face_count;
        m->mesh.ends = of;
        m->mesh.part_count = 2;
    }
    assert_int_equal(glint_mesh_check(&m->mesh), GLINT_OK);
}

static void assert_same_pixels(const uint8_t *out, const uint8_t *wanted, enum glint_format format, int round)
{
    const unsigned line = bytes_of(format, MESH_W);
    for (unsigned y = 0; y < MESH_H; y++)
        for (unsigned x = 0; x < MESH_W; x++) {
            uint8_t is[4], should[4];
            pixel_get(is, format, out + line * y, x);
            pixel_get(should, format, wanted + line * y, x);
            if (memcmp(is, should, 4) != 0)
                fail_msg("round %d, format %d, pixel %u, %u: %02x%02x%02x%02x, not %02x%02x%02x%02x", round, format, x,
                         y, is[0], is[1], is[2], is[3], should[0], should[1], should[2], should[3]);
        }
}

/* Every pixel: which edges are outlines, which pixels they cut and how much of them, what is in front, and what is blended; of clipped faces,
 * too. */
static void outlines_are_those_of_the_sequence_by_any_paint(void **state)
{
    (void)state;
    static struct painted painted[2];
    unsigned blended = 0, clipped = 0, rounds[WAYS] = {0};
    for (int i = 0; i < 12 * GLINT_FORMAT_COUNT; i++) {
        const enum glint_format format = format_number(i);
        const enum glint_space space = (enum glint_space)(i / GLINT_FORMAT_COUNT & 1);
        const bool has_tables = format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED;
        const uint8_t ground = (uint8_t)(i / GLINT_FORMAT_COUNT % 3 ? GUARD : 0);
        struct mesh_shown shown[2];
        const unsigned count = 1 + below(2);
        for (unsigned j = 0; j < count; j++) {
            enum way way = has_tables ? (enum way)((unsigned)(i / GLINT_FORMAT_COUNT) % WAYS) : EXACT;
            way = j ? EXACT : way;
            mesh_small(&meshes[j], (unsigned)i + j);
            if (way == ALBEDO || (way == EXACT && below(2))) {
                colour_at_random(&meshes[j]);
                meshes[j].mesh.of_faces = &meshes[j].colours[0][0];
            }
            paint_parts(&painted[j], way, format, way == ALBEDO ? GLINT_GAMMA : way == DITHERED ? GLINT_GAMMA : space);
            shown[j] = (struct mesh_shown){&meshes[j], painted[j].paints};
            rounds[way]++;
        }
        meshes[0].distance = meshes[1].distance = (uint16_t)(below(3) ? 400 + below(below(2) ? 1200 : 9000) : 0);
        model_begin(&model, shown, count);
        model_draw(&model, format, ground);
        memset(pictures[0], ground, sizeof pictures[0]);
        meshes_picture(shown, count, &in_strips, pictures[0], bytes_of(format, MESH_W));
        assert_same_pixels(pictures[0], model.pixels, format, i);
        blended += model.blended;
        clipped += model.clipped;
    }
    print_message("%u pixels blended, %u of them by faces that are clipped\n", blended, clipped);
    assert_true(blended > 10000 && clipped > 300 && rounds[COLOUR] > 1 && rounds[DITHERED] > 1 && rounds[ALBEDO] > 1);
}

/* Two fronts; the second one has a corner behind the viewer, and the edge between ends about the near plane. */
static void an_edge_between_two_fronts_is_no_outline_where_it_ends_at_the_near_plane(void **state)
{
    (void)state;
    static const int16_t places[4][3] = {{-2000, 0, 0}, {2000, 500, 0}, {0, 2000, 0}, {0, -2000, 32767}};
    static const uint16_t faces[2][3] = {{0, 1, 2}, {1, 0, 3}};
    static struct painted painted;
    struct made_mesh *const m = &meshes[0];
    const struct mesh_shown shown = {m, painted.paints};
    paint_parts(&painted, EXACT, GLINT_RGB888, GLINT_GAMMA);
    for (int16_t z = 28500; z < 28800; z++) {
        mesh_made(m, 4, 2);
        memcpy(m->places, places, sizeof places);
        memcpy(m->faces, faces, sizeof faces);
        for (unsigned i = 0; i < 4; i++)
            m->normals[i][2] = 32767;
        m->places[z & 1][2] = z;
        m->pose.scale = 16 * 600;
        m->distance = 16 * 600;
        mesh_join_both_ways(m);
        model_begin(&model, &shown, 1);
        model_draw(&model, GLINT_RGB888, 0);
        memset(pictures[0], 0, sizeof pictures[0]);
        meshes_picture(&shown, 1, &in_strips, pictures[0], bytes_of(GLINT_RGB888, MESH_W));
        assert_same_pixels(pictures[0], model.pixels, GLINT_RGB888, z);
        if (!model.meshes[0].drawn.vertices[z & 1].out)
            assert_int_equal(model.meshes[0].drawn.edges[0] & 1, 0);
    }
}

/* ---- Where there is no model ---- */

enum albedo { PLAIN, OF_VERTICES, OF_FACES, TEXTURED, ALBEDOS };

/* Faces of any kind, many of them clipped. */
static void mesh_of(struct made_mesh *m, int round, enum albedo albedo, struct made_texture *texture)
{
    if (round % 3 == 0) {
        mesh_noise(m, 3 + below(30), 1 + below(40));
        m->pose.scale = (uint16_t)below(3000);
    } else {
        mesh_ball(m, 4 + below(5), 5 + below(8));
        m->pose.position[0] = (int16_t)((int)below(1000) - 500);
    }
    m->distance = (uint16_t)(below(2) ? 0 : 400 + below(below(2) ? 1200 : 5000));
    mesh_join_both_ways(m);
    colour_at_random(m);
    uv_at_random(m);
    if (albedo == OF_VERTICES)
        m->mesh.of_vertices = &m->colours[0][0];
    if (albedo == OF_FACES)
        m->mesh.of_faces = &m->colours[0][0];
    if (albedo == TEXTURED)
        m->mesh.textures = &texture->texture;
    assert_int_equal(glint_mesh_check(&m->mesh), GLINT_OK);
}

/* Lights about the picture's middle; at least one, two where the model has to have one's t. */
static unsigned lights_about(struct glint_light lights[GLINT_LIGHTS_MAX])
{
    random_lights(lights);
    for (unsigned i = 0; i < GLINT_LIGHTS_MAX; i++) {
        lights[i].position[0] += 8 * (MESH_W - W);
        lights[i].position[1] += 8 * (MESH_H - H);
        lights[i].position[2] += (int32_t)below(1500);
        lights[i].range += 600;
    }
    return 1 + below(GLINT_LIGHTS_MAX);
}

/* By tables where they have the format and the mesh's albedo; else exactly, under several lights, by Phong's model, too. */
static void paint_any(struct painted *of, int round, enum albedo albedo, enum glint_format format)
{
    const enum glint_space space = (enum glint_space)below(2);
    const bool has_tables = (format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED) && round & 1;
    struct look look = random_look(format, space);
    if (has_tables) {
        no_phong(&look);
        look.output.space = GLINT_GAMMA;
    }
    if (has_tables && albedo == PLAIN)
        paint_of_tables(of->paints, GLINT_TABLES_COLOUR, &look, of->memory[0]);
    else if (has_tables)
        assert_true(paint_of_albedo(of->paints, &look, of->memory[0]));
    else
        paint_of(of->paints, &look);
    if (!has_tables && below(2))
        assert_int_equal(glint_paint_light(of->paints, of->lights, lights_about(of->lights), in_front), GLINT_OK);
}

/* Two meshes with paints of their own. */
struct any_picture {
    struct painted painted[2];
    struct made_texture textures[2];
    struct mesh_shown shown[2];
    enum glint_format format;
};

static void picture_at_random(struct any_picture *p, int round)
{
    p->format =
        round & 1 ? (enum glint_format)(round & 2 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED) : format_number(round / 2);
    for (unsigned j = 0; j < 2; j++) {
        const enum albedo albedo = (enum albedo)below(ALBEDOS);
        p->textures[j] = texture_at_random();
        mesh_of(&meshes[j], round + (int)j, albedo, &p->textures[j]);
        paint_any(&p->painted[j], round, albedo, p->format);
        p->shown[j] = (struct mesh_shown){&meshes[j], p->painted[j].paints};
    }
    meshes[1].distance = meshes[0].distance;
}

static void picture_free(struct any_picture *p)
{
    texture_free(&p->textures[0]);
    texture_free(&p->textures[1]);
}

static void outlines_of_any_meshes_do_not_depend_on_how_their_picture_is_cut(void **state)
{
    (void)state;
    static struct any_picture p;
    for (int i = 0; i < 90; i++) {
        picture_at_random(&p, i);
        assert_cuts_agree(p.shown, 2, bytes_of(p.format, MESH_W));
        picture_free(&p);
    }
}

static void outlines_are_the_same_in_lines_that_lie_apart_and_beside_a_mesh_that_has_none(void **state)
{
    (void)state;
    static struct any_picture p;
    for (int i = 0; i < 80; i++) {
        picture_at_random(&p, i);
        if (i & 4)
            meshes[i >> 3 & 1].mesh.neighbours = NULL;
        const unsigned line = bytes_of(p.format, MESH_W), apart = line + 2 * (1 + below(9));
        memset(pictures, GUARD, sizeof pictures);
        meshes_picture(p.shown, 2, &in_strips, pictures[0], line);
        meshes_picture(p.shown, 2, &in_strips, pictures[1], apart);
        for (unsigned y = 0; y < MESH_H; y++) {
            assert_memory_equal(pictures[1] + apart * y, pictures[0] + line * y, line);
            for (unsigned x = line; x < apart; x++)
                assert_int_equal(pictures[1][apart * y + x], GUARD);
        }
        picture_free(&p);
    }
}

/* In any colours, under any lights. */
static void pixels_that_no_outline_cuts_are_those_without_outlines(void **state)
{
    (void)state;
    static struct any_picture p;
    static bool changed[MESH_H][MESH_W];
    unsigned same = 0, other = 0;
    for (int i = 0; i < 120; i++) {
        picture_at_random(&p, i);
        const unsigned line = bytes_of(p.format, MESH_W);
        model_begin(&model, p.shown, 2);
        model_changed(&model, changed);
        for (int outlined = 0; outlined < 2; outlined++) {
            memset(pictures[outlined], GUARD, sizeof pictures[outlined]);
            meshes[0].mesh.neighbours = outlined ? meshes[0].neighbours[0] : NULL;
            meshes[1].mesh.neighbours = outlined ? meshes[1].neighbours[0] : NULL;
            meshes_picture(p.shown, 2, outlined ? &in_strips : &at_once, pictures[outlined], line);
        }
        for (unsigned y = 0; y < MESH_H; y++)
            for (unsigned x = 0; x < MESH_W; x++) {
                uint8_t with[4], without[4];
                pixel_get(without, p.format, pictures[0] + line * y, x);
                pixel_get(with, p.format, pictures[1] + line * y, x);
                if (memcmp(with, without, 4) == 0)
                    same++;
                else if (changed[y][x])
                    other++;
                else
                    fail_msg("round %d, format %d, pixel %u, %u", i, p.format, x, y);
            }
        picture_free(&p);
    }
    print_message("%u pixels are the same, %u are not\n", same, other);
    assert_true(other > 5000);
}

/* Where faces, vertices and a texture have one colour, they are drawn as if the material had it; by ALBEDO tables as faces are. */
static void outlines_in_one_colour_are_those_of_that_albedo(void **state)
{
    (void)state;
    static struct painted painted[2];
    for (int i = 0; i < 120; i++) {
        const bool by_tables = i & 1;
        const enum glint_format format = by_tables ? GLINT_RGB565 : format_number(i / 2);
        struct look look = random_look(format, by_tables ? GLINT_GAMMA : (enum glint_space)(i >> 1 & 1));
        const uint16_t texel = (uint16_t)below(65536);
        const struct glint_texture texture = {.pixels = &texel, .w = 1, .h = 1, .levels = 1, .is_smooth = i & 4};
        const enum albedo albedo = (enum albedo)(OF_VERTICES + i / 2 % 3);
        if (by_tables)
            no_phong(&look);
        look.material.albedo[0] = (uint8_t)lrint((texel >> 11) * 255 / 31.);
        look.material.albedo[1] = (uint8_t)lrint((texel >> 5 & 63) * 255 / 63.);
        look.material.albedo[2] = (uint8_t)lrint((texel & 31) * 255 / 31.);
        mesh_of(&meshes[0], i, PLAIN, NULL);
        for (unsigned f = 0; f < MESH_FACES; f++)
            memcpy(meshes[0].colours[f], look.material.albedo, 3);
        meshes[1] = meshes[0];
        meshes[1].mesh = meshes[0].mesh;
        if (by_tables) {
            assert_true(paint_of_albedo(&painted->paints[0], &look, painted->memory[0]));
            meshes[0].mesh.of_faces = &meshes[0].colours[0][0];
        } else {
            paint_of(&painted->paints[0], &look);
        }
        *(albedo == OF_FACES ? &meshes[1].mesh.of_faces : &meshes[1].mesh.of_vertices) = &meshes[0].colours[0][0];
        if (albedo == TEXTURED) {
            meshes[1].mesh.of_vertices = NULL;
            meshes[1].mesh.textures = &texture;
            meshes[1].mesh.uv = &meshes[0].uv[0][0];
        }
        for (int j = 0; j < 2; j++) {
            const struct mesh_shown shown = {&meshes[j], painted->paints};
            memset(pictures[j], GUARD, sizeof pictures[j]);
            meshes_picture(&shown, 1, j ? &in_strips : &at_once, pictures[j], bytes_of(format, MESH_W));
        }
        assert_same_pixels(pictures[1], pictures[0], format, i);
    }
}

/* ---- A square ---- */

/* Two triangles side by side, with one normal and outlines all round. */
static void upright_square(struct glint_vec normal)
{
    static const int16_t corners[4][2] = {{-30000, -27000}, {29000, -30500}, {31000, 30000}, {-31500, 25000}};
    static const uint16_t faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
    struct made_mesh *const m = &meshes[0];
    mesh_made(m, 4, 2);
    memcpy(m->faces, faces, sizeof faces);
    for (int v = 0; v < 4; v++) {
        const int16_t place[3] = {corners[v][0], corners[v][1], 0}, n[3] = {normal.x, normal.y, normal.z};
        memcpy(m->places[v], place, sizeof place);
        memcpy(m->normals[v], n, sizeof n);
    }
    m->pose.scale = 16 * 38;
    mesh_join_both_ways(m);
}

/* Colours that change evenly over the square are at its edge what they are at the middle of the pixel: over black and over white it is seen
 * how much of the pixel is drawn, and in which colour. */
static void colours_at_an_outline_are_those_of_its_plane(void **state)
{
    (void)state;
    enum { SIDE = 64 };
    static uint16_t texels[SIDE][SIDE];
    const struct look look = bare(GLINT_RGB888);
    const struct glint_texture texture = {&texels[0][0], NULL, SIDE, SIDE, 1, true};
    struct glint_paint paint;
    struct made_mesh *const m = &meshes[0];
    const struct mesh_shown shown = {m, &paint};
    paint_of(&paint, &look);
    for (unsigned y = 0; y < SIDE; y++)
        for (unsigned x = 0; x < SIDE; x++)
            texels[y][x] = (uint16_t)(x / 2 << 11 | y << 5);
    for (int textured = 0; textured < 2; textured++) {
        unsigned count = 0;
        double most = 0;
        upright_square((struct glint_vec){0, 0, 32767});
        for (int v = 0; v < 4; v++) /* 127 + place / 512, as far as the square goes */
            for (int k = 0; k < 2; k++) {
                m->colours[v][k] = (uint8_t)lrint(127 + m->places[v][k] / 512.);
                m->uv[v][k] = (uint16_t)((16384 + m->places[v][k] / 4) & 0xffff);
            }
        if (textured) {
            m->mesh.textures = &texture;
            m->mesh.uv = &m->uv[0][0];
            m->mesh.uv_bits = 15;
        } else {
            m->mesh.of_vertices = &m->colours[0][0];
        }
        for (int white = 0; white < 2; white++) {
            memset(pictures[white], 255 * white, sizeof pictures[white]);
            meshes_picture(&shown, 1, &in_strips, pictures[white], 3 * MESH_W);
        }
        for (int y = 0; y < MESH_H; y++)
            for (int x = 0; x < MESH_W; x++) {
                const uint8_t *black = pictures[0] + 3 * (MESH_W * y + x), *white = pictures[1] + 3 * (MESH_W * y + x);
                const double part = (255. + black[2] - white[2]) / 255; /* blue is 0 */
                if (part < .3 || part > .99)
                    continue;
                for (int k = 0; k < 2; k++) {
                    const double place = (k ? MESH_H / 2. - y - .5 : x + .5 - MESH_W / 2.) / 38 * 32768;
                    const double u = (16384 + place / 4) / 32768 * SIDE - .5; /* texels */
                    const double wanted = !textured ? 127 + place / 512
                                          : k       ? u * 255 / 63
                                                    : fmax(0, u - .5) / 2 * 255 / 31;
                    most = fmax(most, fabs(black[k] / part - wanted) * part);
                    count++;
                }
            }
        print_message("%u levels at outlines: off by up to %.2f\n", count, most);
        assert_true(count > 300 && most < (textured ? 3 : 1.6));
    }
}

/* A face that goes on behind the viewer: its colours change otherwise by each triangle of its fan. */
static void colours_at_an_outline_of_a_clipped_face_are_those_that_it_has_there(void **state)
{
    (void)state;
    const struct look look = bare(GLINT_RGB888);
    struct glint_paint paint;
    struct made_mesh *const m = &meshes[0];
    const struct mesh_shown shown = {m, &paint};
    unsigned count = 0;
    double most = 0;
    paint_of(&paint, &look);
    for (int round = 0; round < 300; round++) { /* of the last ones a corner lies about the near plane */
        const int16_t z = (int16_t)(round < 96 ? 2600 * (round / 3 % 11) : 23900 + round);
        const int16_t places[3][3] = {{-30000, (int16_t)(1000 * (round % 12) - 9000), z},
                                      {30000, (int16_t)(9000 - 800 * (round % 7)), (int16_t)(2600 * (round / 7 % 11))},
                                      {(int16_t)(3000 * (round % 5)), -30000, 32767}};
        static const uint8_t colours[3][3] = {{40, 200, 0}, {200, 60, 0}, {230, 230, 0}};
        mesh_made(m, 3, 1);
        for (unsigned k = 0; k < 3; k++) {
            const unsigned v = (k + (unsigned)round) % 3;
            memcpy(m->places[v], places[k], sizeof places[k]);
            memcpy(m->colours[v], colours[k], sizeof colours[k]);
            m->faces[0][(2 - k + (unsigned)round) % 3] = (uint16_t)v;
            m->normals[k][2] = 32767;
        }
        m->mesh.of_vertices = &m->colours[0][0];
        m->pose.scale = 16 * 50;
        m->distance = 16 * 42;
        for (int i = 0; i < 3; i++) { /* over black and white, with outlines; without */
            memset(pictures[i], i == 1 ? 255 : 0, sizeof pictures[i]);
            if (i < 2)
                mesh_join(m);
            else
                m->mesh.neighbours = NULL;
            meshes_picture(&shown, 1, &in_strips, pictures[i], 3 * MESH_W);
        }
        for (int i = 0; i < MESH_W * MESH_H; i++) {
            const uint8_t *black = pictures[0] + 3 * i, *white = pictures[1] + 3 * i, *plain = pictures[2] + 3 * i;
            const double part = (255. + black[2] - white[2]) / 255; /* blue is 0 */
            if (part < .5 || part > .99 || !plain[0])
                continue;
            for (int k = 0; k < 2; k++)
                most = fmax(most, fabs(black[k] / part - plain[k]) * part);
            count++;
        }
    }
    print_message("%u pixels of outlines: off by up to %.2f levels\n", count, most);
    assert_true(count > 300 && most < 1.6);
}

/* Under points, spots and several lights, and by Phong's model: a pixel of a rectangle in part, of this normal, where the square lies: at
 * z = 0. */
static void a_lit_outline_is_a_pixel_of_a_rectangle_in_part(void **state)
{
    (void)state;
    static struct painted painted;
    static uint8_t ground[4 * MESH_W];
    const struct mesh_shown shown = {&meshes[0], painted.paints};
    const struct model_mesh *const m = &model.meshes[0];
    unsigned compared = 0;
    memset(ground, GUARD, sizeof ground);
    for (int i = 0; i < 6 * GLINT_FORMAT_COUNT; i++) {
        const enum glint_format format = format_number(i);
        struct look look = random_look(format, (enum glint_space)(i / GLINT_FORMAT_COUNT & 1));
        const struct glint_vec normal = random_normal(&look);
        const unsigned count = lights_about(painted.lights);
        if (normal.x == INT16_MIN || normal.y == INT16_MIN || normal.z == INT16_MIN || format == GLINT_ARGB8888)
            continue;
        if (count < 2)
            look.material.model = GLINT_PHONG;
        assert_int_equal(glint_paint_exact(painted.paints, &look.material, &look.output), GLINT_OK);
        assert_int_equal(glint_paint_light(painted.paints, painted.lights, count, in_front), GLINT_OK);
        upright_square(normal);
        memset(pictures[0], GUARD, sizeof pictures[0]);
        meshes_picture(&shown, 1, &in_strips, pictures[0], bytes_of(format, MESH_W));
        model_begin(&model, &shown, 1);
        for (unsigned p = 0; p < 2 * 3 * MESH_W * MESH_H; p++) {
            const unsigned f = p & 1, k = p / 2 % 3;
            const int x = (int)(p / 6 % MESH_W), y = (int)(p / 6 / MESH_W);
            const int part = model_blended(m, f, k, x, y);
            if (part == 0 || model_cuts(m, !f, x, y)) /* of both triangles */
                continue;
            const uint8_t coverage = (uint8_t)(part > 255 ? 255 : part);
            const struct glint_maps maps = {.normals = &normal, .coverage = &coverage};
            uint8_t expected[4], drawn[4];
            pixel_get(expected, format, ground, (unsigned)x);
            const struct glint_surface surface = {expected, 4, (uint16_t)x, (uint16_t)y};
            assert_int_equal(draw_under(&look, painted.lights, count, &maps, 1, 1, &surface, NULL), GLINT_OK);
            pixel_get(drawn, format, pictures[0] + bytes_of(format, MESH_W) * (unsigned)y, (unsigned)x);
            compared++;
            if (memcmp(drawn, expected, 4) != 0)
                fail_msg("round %d, format %d, pixel %d, %d", i, format, x, y);
        }
    }
    print_message("%u pixels\n", compared);
    assert_true(compared > 5000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outlines_are_those_of_the_sequence_by_any_paint),
        cmocka_unit_test(an_edge_between_two_fronts_is_no_outline_where_it_ends_at_the_near_plane),
        cmocka_unit_test(outlines_of_any_meshes_do_not_depend_on_how_their_picture_is_cut),
        cmocka_unit_test(outlines_are_the_same_in_lines_that_lie_apart_and_beside_a_mesh_that_has_none),
        cmocka_unit_test(pixels_that_no_outline_cuts_are_those_without_outlines),
        cmocka_unit_test(outlines_in_one_colour_are_those_of_that_albedo),
        cmocka_unit_test(colours_at_an_outline_are_those_of_its_plane),
        cmocka_unit_test(colours_at_an_outline_of_a_clipped_face_are_those_that_it_has_there),
        cmocka_unit_test(a_lit_outline_is_a_pixel_of_a_rectangle_in_part),
    };
    return cmocka_run_group_tests_name("mesh outlined", tests, NULL, NULL);
}
