/* SPDX-License-Identifier: MIT
 * Pictures of the teapot by tgx (github.com/vindar/tgx) and by glint, counted in one program. tgx has Gouraud shading alone: Phong's formula at
 * the vertices, whose colours are interpolated; floats, by the FPU, and a whole picture's depths; its mesh is the teapot in chains of triangles. Records:
 * mesh; name; n; count of a picture. A background and depths are cleared by neither's count. Pictures: pixels that are drawn. */
#include <string.h>

#include "tgx.h"

extern "C" {
#include "clock.h"
#include "machine.h"
#include "mesh.h"
}
#include "teapot.h"

namespace
{

enum { W = MESH_WIDTH, H = MESH_HEIGHT, FACES = 992, VERTICES = 530 };

tgx::RGB565 pixels[W * H];
uint16_t depths[W * H];
tgx::fVec3 places[VERTICES], normals[VERTICES];
uint16_t chains[7 * FACES + 1];
bool used[FACES];

constexpr tgx::Shader SHADERS = tgx::SHADER_ORTHO | tgx::SHADER_ZBUFFER | tgx::SHADER_GOURAUD | tgx::SHADER_NOTEXTURE;
using Renderer = tgx::Renderer3D<tgx::RGB565, SHADERS, uint16_t>;
tgx::Mesh3D<tgx::RGB565> mesh;

/* A face that is not used and has the edge from a to b: its third corner, or -1. */
int take(uint16_t a, uint16_t b)
{
    for (int f = 0; f < teapot.face_count; f++)
        for (int k = 0; k < 3 && !used[f]; k++)
            if (teapot.faces[3 * f + k] == a && teapot.faces[3 * f + (k + 1) % 3] == b) {
                used[f] = true;
                return teapot.faces[3 * f + (k + 2) % 3];
            }
    return -1;
}

/* Each chain goes on as long as it can. */
uint16_t chain()
{
    uint16_t at = 0;
    for (int f = 0; f < teapot.face_count; f++) {
        if (used[f])
            continue;
        used[f] = true;
        uint16_t *const count = &chains[at++];
        uint16_t v[3] = {teapot.faces[3 * f], teapot.faces[3 * f + 1], teapot.faces[3 * f + 2]};
        for (const uint16_t corner : v) {
            chains[at++] = corner;
            chains[at++] = corner;
        }
        for (*count = 1;; ++*count) {
            /* next of v1, v3 (bit 0): v1, v3, v4; of v3, v2: v3, v2, v4 */
            int next = take(v[0], v[2]), turned = 0;
            if (next < 0) {
                next = take(v[2], v[1]);
                turned = 32768;
            }
            if (next < 0)
                break;
            chains[at++] = static_cast<uint16_t>(next | turned);
            chains[at++] = static_cast<uint16_t>(next);
            if (turned)
                v[0] = v[2];
            else
                v[1] = v[2];
            v[2] = static_cast<uint16_t>(next);
        }
    }
    chains[at++] = 0;
    return at;
}

void begin()
{
    for (int i = 0; i < teapot.vertex_count; i++) {
        places[i] = tgx::fVec3(teapot.places[3 * i] / 32768.f, teapot.places[3 * i + 1] / 32768.f,
                               teapot.places[3 * i + 2] / 32768.f);
        normals[i] = {static_cast<float>(teapot.normals8[3 * i]), static_cast<float>(teapot.normals8[3 * i + 1]),
                      static_cast<float>(teapot.normals8[3 * i + 2])};
        normals[i].normalize();
    }
    mesh.id = 1;
    mesh.nb_vertices = mesh.nb_normals = teapot.vertex_count;
    mesh.nb_texcoords = 0;
    mesh.nb_faces = teapot.face_count;
    mesh.len_face = chain();
    mesh.vertice = places;
    mesh.normal = normals;
    mesh.face = chains;
    mesh.texcoord = nullptr;
    mesh.texture = nullptr;
    mesh.next = nullptr;
    mesh.color = tgx::RGBf(1, .6f, .4f);
    mesh.ambiant_strength = .1f;
    mesh.diffuse_strength = .6f;
    mesh.specular_strength = .8f;
    mesh.specular_exponent = 60;
    mesh.bounding_box = tgx::fBox3(-1, 1, -1, 1, -1, 1);
    mesh.name = nullptr;
}

/* As mesh.c's: a turn, and 2410 sixteenths of a pixel for 1.0; 240 units of the view are 240 pixels. */
void set(Renderer &renderer, tgx::Image<tgx::RGB565> &image)
{
    const float w = 30895 / 32768.f, x = 6849 / 32768.f, y = -8278 / 32768.f, z = -1835 / 32768.f, s = 2410 / 16.f;
    tgx::fMat4 m;
    m.setIdentity();
    const float turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                              {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                              {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            m.M[4 * column + row] = s * turn[row][column];
    m.M[14] = -300;
    renderer.setViewportSize(W, H);
    renderer.setImage(&image);
    renderer.setZbuffer(depths);
    renderer.setOrtho(-W / 2, W / 2, -H / 2, H / 2, 1, 600);
    renderer.setCulling(1);
    renderer.setShaders(tgx::SHADER_GOURAUD | tgx::SHADER_NOTEXTURE);
    renderer.setLight({4, -6, -8}, tgx::RGBf(1, 1, 1), tgx::RGBf(1, 1, 1), tgx::RGBf(1, 1, 1));
    renderer.setModelMatrix(m);
}

void record(const char *name, uint32_t counted)
{
    print_text("mesh");
    print_text(name);
    print_number(60);
    print_number(counted);
    print_end();
}

uint32_t strips(mesh_way way, uint32_t *drawn)
{
    int error = mesh_begin(way) | mesh_clothe(0);
    const uint32_t start = clock_now();
    error |= mesh_frame(0);
    uint32_t counted = clock_now() - start;
    for (unsigned y = 0; y < H; y += MESH_LINES) {
        memset(mesh_out, 0, sizeof mesh_out);
        const uint32_t before = clock_now();
        error |= mesh_strip(y);
        counted += clock_now() - before;
        for (const uint32_t two : mesh_out)
            *drawn += ((two & 0xffff) != 0) + (two >> 16 != 0);
    }
    if (error) {
        print_text("error");
        print_text("mesh teapot");
        print_end();
    }
    return counted;
}

/* Apart: its first instruction may need the FPU. */
__attribute__((noinline)) void pictures()
{
    static Renderer renderer; /* no start-up code here makes global objects */
    begin();
    tgx::Image<tgx::RGB565> image(pixels, W, H);
    set(renderer, image);
    renderer.clearZbuffer();
    const uint32_t start = clock_now();
    renderer.drawMesh(&mesh);
    record("mesh teapot tgx", clock_now() - start);
    uint32_t drawn[3] = {0, 0, 0};
    for (const tgx::RGB565 &pixel : pixels)
        drawn[0] += static_cast<uint16_t>(pixel) != 0;
    record("mesh teapot beside tgx", strips(MESH_BY_TABLES, &drawn[1]));
    record("mesh teapot gouraud beside tgx", strips(MESH_GOURAUD, &drawn[2]));
    record("mesh teapot tgx pixels", drawn[0]);
    record("mesh teapot beside tgx pixels", drawn[1]);
}

} // namespace

extern "C" bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    clock_begin();
    print_calibration();
    pictures();
    return true;
}
