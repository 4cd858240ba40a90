// SPDX-License-Identifier: MIT
// The demo's picture and its timing: what a monitor would see, against the model of spans. Writes the frames as PNG files into
// GATEWARE_BUILD. Between the frames that are looked at the counter is set on: only its step and its wrap are waited for.
#include <png.h>
#include <stdlib.h>
#include <string.h>

#include <string>

#include "Vtop.h"
#include "Vtop___024root.h"
#include "span_model.h"
#include "sphere_model.h"
#include "tap.h"
#include "verilated.h"

enum { WIDTH = 640, HEIGHT = 480, CLOCKS = 800, LINES = 525, STEP = -1 };

static Vtop top;

static void clock_edge()
{
    top.clk = 1;
    top.eval();
    top.clk = 0;
    top.eval();
}

typedef std::vector<uint16_t> picture;

static picture drawn_by_the_model(unsigned frame, enum glint_model model)
{
    struct glint_material material = {};
    static const uint32_t ambient[] = {7000, 2200, 1800}, diffuse[] = {52000, 13000, 9000};
    material.model = (uint8_t)model;
    material.n = 60;
    for (int k = 0; k < 3; k++) {
        material.ambient_q16[k] = ambient[k];
        material.diffuse_q16[k] = diffuse[k];
        material.specular_q16[k] = 50000;
    }
    const struct glint_paint light = orbit_frame(frame);
    picture pixels(WIDTH * HEIGHT);
    for (int row = SPHERE_Y - SPHERE_ROWS; row <= SPHERE_Y + SPHERE_ROWS; row++) {
        int column = SPHERE_X - sphere_half_width(SPHERE_Y - row);
        for (const struct glint_span &span : sphere_row(row, light)) {
            span_model(&material, span_model_c_min(&material), &span, &pixels[(size_t)(row * WIDTH + column)]);
            column += span.w;
        }
    }
    return pixels;
}

// From a frame's first visible pixel to the next frame's. The timing, as a monitor counts it, into *good. Below the picture the
// frame counter has stepped, or is set to next.
static picture shown(bool *good, int next = STEP)
{
    picture pixels;
    for (int line = 0; line < LINES; line++) {
        if (line == 490 && next != STEP)
            top.rootp->glint_demo__DOT__frame = (uint8_t)next;
        for (int x = 0; x < CLOCKS; x++) {
            const bool visible = x < WIDTH && line < HEIGHT;
            *good = *good && top.visible == visible && top.hsync == !(x >= 656 && x < 752) &&
                    top.vsync == !(line >= 490 && line < 492) && (visible || top.rgb565 == 0);
            if (top.visible)
                pixels.push_back(top.rgb565);
            clock_edge();
        }
    }
    return pixels;
}

static bool write_png(const picture &pixels, const std::string &name)
{
    std::vector<uint8_t> rgb;
    for (const uint16_t p : pixels)
        for (const int level : {(p >> 11) * 255 / 31, (p >> 5 & 63) * 255 / 63, (p & 31) * 255 / 31})
            rgb.push_back((uint8_t)level);
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = WIDTH;
    image.height = HEIGHT;
    image.format = PNG_FORMAT_RGB;
    return png_image_write_to_file(&image, name.c_str(), 0, rgb.data(), 0, NULL);
}

int main(int argc, char **argv)
{
    Verilated::commandArgs(argc, argv);
    const char *folder = getenv("GATEWARE_BUILD");
    const std::string prefix = std::string(folder ? folder : ".") + "/demo-";
    top.rst = 1;
    for (int i = 0; i < 4; i++)
        clock_edge();
    top.rst = 0;
    clock_edge();
    clock_edge(); // the outputs are two clocks late
    bool timing = true, same = true, written = true, other_model = true;
    shown(&timing); // the first frame's first line was never prepared
    timing = true;
    // From a frame to the next by itself (1, 2), across the wrap (238, 239, 0, 1), and set on to others of the orbit.
    const unsigned frames[] = {1, 2, 40, 80, 120, 160, 238, 239, 0, 1, 91, 122};
    const size_t count = sizeof frames / sizeof frames[0];
    for (size_t i = 0; i < count; i++) {
        const bool schlick = i + 1 == count;
        const unsigned frame = frames[i], next = frames[schlick ? 0 : i + 1];
        top.choose_schlick = i + 2 >= count;
        const picture found = shown(&timing, next == (frame + 1) % ORBIT_FRAMES ? STEP : (int)next);
        const bool equal = found == drawn_by_the_model(frame, schlick ? GLINT_SCHLICK : GLINT_MSH);
        (schlick ? other_model : same) &= equal;
        if (!equal)
            printf("# frame %u differs\n", frame);
        written = written && write_png(found, prefix + std::to_string(frame) + ".png");
    }
    tap::check("frames of an orbit, 239 and 0 among them, are the library's pictures of the same spans",
               same && written);
    tap::check("with the button held it is Schlick's highlight, from the next frame on", other_model);
    tap::check("640x480 in 800 clocks and 525 lines, syncs negative, black outside", timing);
    return tap::done();
}
