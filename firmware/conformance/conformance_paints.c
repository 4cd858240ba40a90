/* SPDX-License-Identifier: MIT
 * Random meshes whose faces or vertices have colours, and under up to four lamps. A pixel of these costs thousands of cycles, so that
 * models share formats and spaces between them: one picture each. */
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

static void random_shader(struct glint_shader *shader, unsigned model, unsigned kind)
{
    conform_random_shader(shader, model);
    shader->format = (uint8_t)(kind % GLINT_FORMAT_COUNT);
    shader->space = kind >> 1 & 1;
    shader->dither = kind & 1;
    shader->clamp_peak = kind >> 2 & 1;
    random_colours();
}

static void add_exact(unsigned model, unsigned kind)
{
    struct glint_shader shader;
    struct glint_prepared prepared;
    random_shader(&shader, model, kind);
    const struct glint_mesh_albedo albedo = {&prepared, kind % 3 ? NULL : colours, kind % 3 ? colours : NULL};
    const struct glint_paint paint = {&glint_mesh_exact_albedo, &albedo};
    conform_add((uint32_t)glint_shade_prepare(&prepared, &shader));
    conform_mesh(kind, &shader.light, &paint, 4 * CONFORM_WIDTH);
}

/* One fill for as many pictures: by vertices, by faces, clipped, at an even address or not. */
static void add_tables(unsigned model, unsigned format)
{
    struct glint_shader shader;
    struct glint_tables tables;
    random_shader(&shader, model, format);
    shader.space = GLINT_GAMMA;
    shader.dither = false;
    for (uint8_t k = 0; k < 3; k++) {
        shader.material.ambient_q16[k] = shader.material.ambient_q16[0];
        shader.material.diffuse_q16[k] = 45000;
    }
    if (!conform_fill(&tables, GLINT_TABLES_ALBEDO, &shader))
        return;
    for (uint8_t kind = 0; kind < 6; kind++) {
        const bool faces = (kind + format) & 1;
        const struct glint_mesh_albedo albedo = {&tables, faces ? NULL : colours, faces ? colours : NULL};
        const struct glint_paint paint = {&glint_mesh_tables_albedo, &albedo};
        conform_mesh(kind, &shader.light, &paint, (uint8_t)(2 * CONFORM_WIDTH + kind % 3));
    }
}

void conform_mesh_albedo(const struct conformance_size *size, bool tables)
{
    for (uint8_t scene = 0; scene < size->scenes; scene++)
        if (tables)
            for (unsigned format = GLINT_RGB565; format <= GLINT_RGB565_SWAPPED; format++)
                add_tables(format ? GLINT_MSH : GLINT_GAUSS, format);
        else
            for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
                add_exact(model, model + scene);
}

/* The memory of tables is free here. */
static void add_lit(unsigned model, unsigned kind)
{
    struct glint_shader shader;
    struct glint_mesh_lights lights = {NULL, NULL, NULL};
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    const struct glint_paint paint = {&glint_mesh_lit, &lights};
    const unsigned count = kind % (GLINT_LAMPS_MAX + 1);
    size_t bytes;
    random_shader(&shader, model, kind);
    for (unsigned i = 0; i < count; i++)
        conform_random_lamp(&lamps[i]);
    void *const memory = conform_memory(&bytes);
    conform_add((uint32_t)glint_mesh_lights_init(&lights, &shader, lamps, count, memory, bytes));
    lights.of_vertices = kind % 3 == 1 ? colours : NULL;
    lights.of_faces = kind % 3 == 2 ? colours : NULL;
    conform_mesh(kind, &shader.light, &paint, 4 * CONFORM_WIDTH);
}

void conform_mesh_lamps(const struct conformance_size *size)
{
    for (uint8_t scene = 0; scene < size->scenes; scene++)
        for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
            add_lit(model, model + scene + 1);
}

#endif
