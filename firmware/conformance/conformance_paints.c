/* SPDX-License-Identifier: MIT
 * Random meshes whose faces or vertices have colours, with textures and grain, under up to four lights, and with smooth outlines. A pixel of these costs
 * thousands of cycles, so that models share formats and spaces between them: one picture each. */
#include "conformance_paints.h"

#include "conformance_meshes.h"
#include "conformance_random.h"
#include "conformance_scenes.h"
#include "conformance_tables.h"

#if !CONFORMANCE_MODELS_ONLY

/* Of vertices or of faces, whichever are more. */
static uint8_t colours[3 * CONFORM_FACES];

static void random_colours(void)
{
    for (uint8_t i = 0; i < sizeof colours; i++)
        colours[i] = (uint8_t)conform_random_bits();
}

static void random_look(struct glint_material *material, struct glint_light *light, struct glint_output *output,
                        unsigned model, unsigned kind)
{
    conform_random_material(material, light, model);
    material->clamp_peak = kind >> 2 & 1;
    output->format = (uint8_t)(kind % GLINT_FORMAT_COUNT);
    output->space = kind >> 1 & 1;
    output->dither = kind & 1;
    random_colours();
}

/* Of vertices, of faces, or none. */
static struct conform_look look_of(bool vertices, bool faces, bool has_lights, bool is_outlined)
{
    const struct conform_look look = {.paint = &conform_paint,
                                      .h = conform_paint.h,
                                      .of_vertices = vertices ? colours : NULL,
                                      .of_faces = faces ? colours : NULL,
                                      .has_lights = has_lights,
                                      .is_outlined = is_outlined};
    return look;
}

/* With its halves, or not; of pixels or of places in a palette; smooth or not. */
static const struct glint_texture *random_texture(unsigned kind)
{
    enum { SIDE = 8, PIXELS = 64 + 16 + 4 + 1, COLOURS = 16 };
    static uint16_t pixels[PIXELS], palette[COLOURS];
    static struct glint_texture texture;
    for (uint8_t i = 0; i < PIXELS; i++)
        pixels[i] = (uint16_t)conform_random_bits();
    for (uint8_t i = 0; i < COLOURS; i++)
        palette[i] = (uint16_t)conform_random_bits();
    for (uint8_t i = 0; kind & 1 && i < PIXELS; i++)
        ((uint8_t *)pixels)[i] &= COLOURS - 1;
    texture.pixels = pixels;
    texture.palette = kind & 1 ? palette : NULL;
    texture.w = texture.h = SIDE;
    texture.levels = kind & 2 ? 4 : 1;
    texture.is_smooth = kind >> 2 & 1;
    return &texture;
}

static void add_exact(unsigned model, unsigned kind, bool is_outlined)
{
    struct glint_material material;
    struct glint_light light;
    struct glint_output output;
    random_look(&material, &light, &output, model, kind);
    conform_add((uint32_t)glint_paint_exact(&conform_paint, &material, &output));
    conform_light(&conform_paint, &light);
    const struct conform_look look = look_of(kind % 3 == 0, kind % 3 != 0, model == GLINT_PHONG, is_outlined);
    conform_mesh(kind, &look, 4 * CONFORM_WIDTH);
}

/* With a texture, or with grain. */
static void add_laid(unsigned model, unsigned kind, bool is_textured)
{
    struct glint_material material;
    struct glint_light light;
    struct glint_output output;
    random_look(&material, &light, &output, model, kind);
    material.n_across = (uint16_t)(is_textured ? 0 : 1 + conform_random_bits() % 100);
    conform_add((uint32_t)glint_paint_exact(&conform_paint, &material, &output));
    conform_light(&conform_paint, &light);
    struct conform_look look = look_of(false, false, true, false);
    look.has_grain = !is_textured;
    look.texture = is_textured ? random_texture(kind) : NULL;
    conform_mesh(kind, &look, 4 * CONFORM_WIDTH);
}

/* One fill for as many pictures: by vertices, by faces, clipped, at an even address or not. */
static void add_tables(enum glint_tables_kind tables, unsigned model, unsigned format, bool is_outlined,
                       bool is_textured)
{
    struct glint_material material;
    struct glint_light light;
    struct glint_output output;
    random_look(&material, &light, &output, model, format);
    output.space = GLINT_GAMMA;
    output.dither = false;
    for (uint8_t k = 0; k < 3; k++) {
        material.ambient_q16[k] = material.ambient_q16[0];
        material.diffuse_q16[k] = 45000;
    }
    if (!conform_fill(&conform_paint, tables, &material, &output))
        return;
    conform_light(&conform_paint, &light);
    for (uint8_t kind = 0; kind < 6; kind++) {
        const bool faces = (kind + format) & 1, is_albedo = tables == GLINT_TABLES_ALBEDO && !is_textured;
        struct conform_look look = look_of(is_albedo && !faces, is_albedo && faces, false, is_outlined);
        if (is_textured)
            look.texture = random_texture(kind + format);
        conform_mesh(kind, &look, (uint8_t)(2 * CONFORM_WIDTH + kind % 3));
    }
}

void conform_mesh_albedo(const struct conformance_size *size)
{
    for (uint8_t scene = 0; scene < size->scenes; scene++)
        for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
            add_exact(model, model + scene, false);
}

/* Of MSH's tables alone, for machines of little flash. */
void conform_mesh_by_albedo(const struct conformance_size *size, bool textures)
{
    for (uint8_t scene = 0; scene < size->scenes; scene++)
        for (unsigned format = GLINT_RGB565; format <= GLINT_RGB565_SWAPPED; format++)
            add_tables(GLINT_TABLES_ALBEDO, GLINT_MSH, format, false, textures);
}

void conform_mesh_textures(const struct conformance_size *size)
{
    for (uint8_t scene = 0; scene < size->scenes; scene++)
        for (unsigned kind = 0; kind < 8; kind++)
            add_laid((kind + scene) % GLINT_MODEL_COUNT, kind, true);
}

void conform_mesh_grain(const struct conformance_size *size)
{
    for (uint8_t scene = 0; scene < size->scenes; scene++)
        for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
            add_laid(model, model + scene, false);
}

static void add_lit(unsigned model, unsigned kind, bool is_outlined)
{
    struct glint_material material;
    struct glint_light light;
    struct glint_output output;
    const unsigned count = kind % (GLINT_LIGHTS_MAX + 1);
    random_look(&material, &light, &output, model, kind);
    for (unsigned i = 0; i < count; i++)
        conform_random_light(&conform_lights[i]);
    conform_add((uint32_t)glint_paint_exact(&conform_paint, &material, &output));
    conform_light(&conform_paint, &light);
    const struct conform_look look = look_of(kind % 3 == 1, kind % 3 == 2, true, is_outlined);
    conform_add((uint32_t)glint_paint_light(&conform_paint, conform_lights, count, conform_to_viewer));
    conform_mesh(kind, &look, 4 * CONFORM_WIDTH);
}

void conform_mesh_lights(const struct conformance_size *size)
{
    for (uint8_t scene = 0; scene < size->scenes; scene++)
        for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
            add_lit(model, model + scene + 1, false);
}

static void add_outlined_by_tables(void)
{
    for (unsigned format = GLINT_RGB565; format <= GLINT_RGB565_SWAPPED; format++) {
        add_tables(GLINT_TABLES_COLOUR, format ? GLINT_MSH : GLINT_LYON, format, true, false);
        add_tables(GLINT_TABLES_ALBEDO, format ? GLINT_SCHLICK : GLINT_MSH, format, true, false);
    }
}

void conform_mesh_outlines(const struct conformance_size *size, bool tables)
{
    for (uint8_t scene = 0; scene < size->scenes; scene++) {
        if (tables)
            add_outlined_by_tables();
        for (unsigned model = 0; !tables && model < GLINT_MODEL_COUNT; model++) {
            add_exact(model, model + scene + 2, true);
            add_lit(model, model + scene + 4, true);
        }
    }
}

#endif
