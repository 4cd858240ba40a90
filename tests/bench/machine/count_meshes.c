/* SPDX-License-Identifier: MIT
 * Counts pictures of the teapot, and one of 320 by 240 of a ball of 576 triangles with a texture, which is full screen in height. Records: mesh;
 * name; n; count of a picture. */
#include "clock.h"
#include "glint_mesh.h"
#include "mesh.h"

#include "machine.h"

static void count_picture(const char *name, enum mesh_way way, unsigned which)
{
    int error = mesh_begin(way);
    error |= mesh_clothe(which);
    const uint32_t start = clock_now();
    error |= mesh_frame(which);
    for (unsigned y = 0; y < MESH_HEIGHT; y += MESH_LINES)
        error |= mesh_strip(y);
    const uint32_t counted = clock_now() - start;
    print_text(error ? "error" : "mesh");
    print_text(name);
    print_number(60);
    print_number(counted);
    print_end();
}

enum {
    RINGS = 17,
    CORNERS = 18,
    WIDTH = 320,
    HEIGHT = 240,
    LINES = 16,
    SIDE = 64,
    KEPT = 100,
    FACES = 2 * CORNERS * (RINGS - 1)
};
static int16_t places[(RINGS + 1) * CORNERS][3];
static uint16_t uv[(RINGS + 1) * CORNERS][2], faces[FACES][3], texels[SIDE * SIDE], picture[WIDTH * LINES];
static uint32_t frame_memory[(2 * WIDTH * LINES + 1024 + KEPT * GLINT_MESH_KEPT_BYTES) / 4], mesh_memory[2048],
    tables[GLINT_TABLES_ALBEDO_BYTES / 4];

/* From an angle to the next, 360 / 18 or 180 / 17 degrees, Q14: cosine and sine. */
static void turn(int32_t at[2], int32_t cosine, int32_t sine)
{
    const int32_t x = (at[0] * cosine - at[1] * sine) / 16384, y = (at[0] * sine + at[1] * cosine) / 16384;
    at[0] = x;
    at[1] = y;
}

static void make_ball(void)
{
    int32_t down[2] = {16384, 0};
    unsigned count = 0;
    for (unsigned j = 0; j <= RINGS; j++, turn(down, 16105, 3010)) {
        int32_t around[2] = {16384, 0};
        for (unsigned i = 0; i < CORNERS; i++, turn(around, 15396, 5604)) {
            int16_t *const place = places[j * CORNERS + i];
            place[0] = (int16_t)(down[1] * around[0] / 8200);
            place[1] = (int16_t)(down[0] * 16384 / 8200);
            place[2] = (int16_t)(-down[1] * around[1] / 8200);
            uv[j * CORNERS + i][0] = (uint16_t)(i * 65536 / CORNERS);
            uv[j * CORNERS + i][1] = (uint16_t)(j * 16384 / RINGS);
        }
    }
    for (unsigned j = 0; j < RINGS; j++)
        for (unsigned i = 0; i < CORNERS; i++) {
            const uint16_t a = (uint16_t)(j * CORNERS + i), b = (uint16_t)(j * CORNERS + (i + 1) % CORNERS);
            const uint16_t two[2][3] = {{a, (uint16_t)(a + CORNERS), (uint16_t)(b + CORNERS)},
                                        {a, (uint16_t)(b + CORNERS), b}};
            for (unsigned k = 0; k < 2; k++)
                for (unsigned l = 0; l < 3 && (k ? j > 0 : j + 1 < RINGS); l++)
                    faces[count / 3][count % 3] = two[k][l], count++;
        }
    for (unsigned i = 0; i < SIDE * SIDE; i++)
        texels[i] = (uint16_t)(i * 0x9e37u);
}

static void count_ball(const char *name, bool is_smooth, uint16_t distance)
{
    static const struct glint_material stone = {.model = GLINT_MSH,
                                                .n = 60,
                                                .ambient_q16 = {6554, 6554, 6554},
                                                .diffuse_q16 = {40632, 40632, 40632},
                                                .specular_q16 = {52429, 52429, 52429},
                                                .albedo = {255, 255, 255},
                                                .clamp_peak = true};
    static const struct glint_output output = {.format = GLINT_RGB565};
    static const int32_t to_light[3] = {-4, 6, 8}, to_viewer[3] = {0, 0, 1};
    const struct glint_texture texture = {texels, NULL, SIDE, SIDE, 1, is_smooth};
    const struct glint_mesh mesh = {.places = places[0],
                                    .normals = places[0],
                                    .faces = faces[0],
                                    .vertex_count = sizeof places / sizeof *places,
                                    .face_count = FACES,
                                    .textures = &texture,
                                    .uv = uv[0],
                                    .uv_bits = 14,
                                    .use = &glint_use_mesh_albedo};
    const struct glint_pose pose = {{30895, 6849, -8278, -1835}, {0, 0, 0}, 16 * 118};
    struct glint_paint paint;
    struct glint_light light;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    make_ball();
    int error = glint_mesh_check(&mesh) |
                glint_paint_tables_for(&paint, &glint_use_albedo, &stone, &output, tables, sizeof tables,
                                       &glint_use_msh, &glint_use_rgb565) |
                glint_light_directional(&light, to_light) | glint_paint_light_by(&paint, &light, 1, to_viewer, NULL);
    const uint32_t start = clock_now();
    error |= glint_mesh_begin(&frame, WIDTH, HEIGHT, LINES, distance, frame_memory, sizeof frame_memory) |
             glint_mesh_add(&frame, &drawn, &mesh, &pose, &paint, mesh_memory, sizeof mesh_memory);
    for (uint16_t y = 0; y < HEIGHT; y = (uint16_t)(y + LINES)) {
        const struct glint_surface surface = {picture, 2 * WIDTH, 0, y};
        error |= glint_mesh_strip(&frame, y, LINES, &surface);
    }
    const uint32_t counted = clock_now() - start;
    print_text(error ? "error" : "mesh");
    print_text(name);
    print_number(60);
    print_number(counted);
    print_end();
}

bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    clock_begin();
    print_calibration();
    count_picture("mesh teapot", MESH_BY_TABLES, 0);
    count_picture("mesh teapot split", MESH_BY_TABLES, 1);
    count_picture("mesh teapot exact", MESH_EXACT, 0);
    count_picture("mesh teapot split exact", MESH_EXACT, 1);
    count_picture("mesh teapot gouraud", MESH_GOURAUD, 0);
    count_picture("mesh teapot split gouraud", MESH_GOURAUD, 1);
    count_picture("mesh teapot textured", MESH_TEXTURED, 0);
    count_ball("mesh ball textured, 320x240", false, 0);
    count_ball("mesh ball textured, bilinear, 320x240", true, 0);
    count_ball("mesh ball textured, perspective, 320x240", false, 8000);
    return true;
}
