// SPDX-License-Identifier: MIT
// The demo's spans against glint_span_init.
#include "Vtop.h"
#include "sphere_model.h"
#include "tap.h"
#include "verilated.h"

static Vtop top;

static void clock_edge()
{
    top.clk = 1;
    top.eval();
    top.clk = 0;
    top.eval();
}

static void set_light(const struct glint_paint &light)
{
    const struct glint_vec l = light.l, h = light.h;
    const int64_t hh = (int64_t)h.x * h.x + (int64_t)h.y * h.y + (int64_t)h.z * h.z;
    const uint64_t lx = 0xffffff & (uint32_t)(SPHERE_STEP * l.x), ly = 0xffffff & (uint32_t)(SPHERE_STEP * l.y);
    const uint64_t hx = 0xffffff & (uint32_t)(SPHERE_STEP * h.x), hy = 0xffffff & (uint32_t)(SPHERE_STEP * h.y);
    const uint64_t high = hx << 40 | hy << 16 | (uint16_t)h.z, low = lx << 40 | ly << 16 | (uint16_t)l.z;
    top.light[0] = (uint32_t)(SPHERE_ONE + hh);
    top.light[1] = (uint32_t)high;
    top.light[2] = (uint32_t)(high >> 32);
    top.light[3] = (uint32_t)low;
    top.light[4] = (uint32_t)(low >> 32);
}

static bool same(const struct glint_span &a, const struct glint_span &b)
{
    return a.t_q30 == b.t_q30 && a.dt_q30 == b.dt_q30 && a.ddt_q30 == b.ddt_q30 && a.nl_q30 == b.nl_q30 &&
           a.dnl_q30 == b.dnl_q30 && a.w == b.w;
}

static int longest; // clocks of a row

/* hold: clocks that each span waits. */
static bool row_matches(int row, unsigned frame, int hold)
{
    const struct glint_paint light = orbit_frame(frame);
    const std::vector<glint_span> wanted = sphere_row(row, light);
    set_light(light);
    top.row = row;
    top.start = 1;
    clock_edge();
    top.start = 0;
    size_t found = 0;
    int clocks = 1, wait = hold;
    for (; top.busy && clocks < 4000; clocks++) {
        top.m_ready = top.m_valid && wait-- <= 0;
        top.eval();
        if (top.m_valid && top.m_ready) {
            const struct glint_span span = {top.m_t, top.m_dt,        top.m_ddt, (int32_t)top.m_nl, (int32_t)top.m_dnl,
                                            top.m_w, {{0, 0}, {0, 0}}};
            if (found >= wanted.size() || !same(span, wanted[found])) {
                printf("# row %d, frame %u, span %zu: t %08x dt %08x ddt %08x nl %08x dnl %08x w %u\n", row, frame,
                       found, span.t_q30, span.dt_q30, span.ddt_q30, (unsigned)span.nl_q30, (unsigned)span.dnl_q30,
                       span.w);
                return false;
            }
            found++;
            wait = hold;
        }
        clock_edge();
    }
    if (!hold && clocks > longest)
        longest = clocks;
    return found == wanted.size() && top.half_width == sphere_half_width(SPHERE_Y - row);
}

static bool rows_match(unsigned frame_step, int hold)
{
    for (unsigned frame = 0; frame < ORBIT_FRAMES; frame += frame_step)
        for (int row = SPHERE_Y - SPHERE_ROWS; row <= SPHERE_Y + SPHERE_ROWS; row++)
            if (!row_matches(row, frame, hold))
                return false;
    return true;
}

int main(int argc, char **argv)
{
    Verilated::commandArgs(argc, argv);
    top.rst = 1;
    clock_edge();
    top.rst = 0;
    tap::check("the spans of every row are those of glint_span_init, at 24 places of the light", rows_match(10, 0));
    tap::check("so they are where each has to wait", rows_match(80, 40));
    printf("# at most %d clocks a row\n", longest);
    tap::check("a row is prepared within 740 of a line's 800 clocks", longest <= 740);
    return tap::done();
}
