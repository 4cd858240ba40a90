// SPDX-License-Identifier: MIT
// The span unit's registers on Wishbone, by a bus-functional model of a classic and of a pipelined master, and from C.
#include <cstdint>
#include <cstring>
#include <vector>

#include "Vtop.h"
#include "glint_span_unit.h"
#include "span_model.h"
#include "tap.h"
#include "unit_registers.h"
#include "verilated.h"

static Vtop top;
static uint64_t seed = 11;
static uint32_t below(uint32_t limit)
{
    seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((seed >> 32) * limit >> 32);
}

enum ending { NONE, ACK, ERR };
enum { PATIENCE = 100000 };
static bool pipelined, orderly = true; // orderly: ends come for what was asked, one each, a clock later
static uint32_t take = 256;            // chance of 256 that a pixel is taken in a clock
static unsigned open_requests;
static std::vector<uint32_t> pixels; // rgb565 << 1 | last

// A clock, with what the stream and the bus show in it. Returns how a request ended.
static enum ending clock_edge()
{
    top.m_ready = below(256) < take;
    top.clk = 0;
    top.eval();
    if (top.m_valid && top.m_ready && !top.rst)
        pixels.push_back((uint32_t)top.m_rgb565 << 1 | top.m_last);
    const enum ending end = top.wb_ack ? ACK : top.wb_err ? ERR : NONE;
    orderly = orderly && !(top.wb_ack && top.wb_err) && (end != NONE) == (open_requests != 0);
    if (end != NONE && open_requests)
        open_requests--;
    const bool taken = top.wb_cyc && top.wb_stb && !top.wb_stall && !top.rst;
    open_requests += taken;
    top.clk = 1;
    top.eval();
    if (pipelined && taken)
        top.wb_stb = 0; // a classic master holds it until the end
    return end;
}

static void reset()
{
    top.rst = 1;
    top.wb_cyc = top.wb_stb = top.wb_we = 0;
    open_requests = 0;
    clock_edge();
    top.rst = 0;
    pixels.clear();
}

static enum ending request(bool write, uint32_t offset, uint32_t value, uint32_t *read, unsigned lanes = 15)
{
    for (uint32_t gap = below(4) ? 0 : below(5); gap; gap--)
        clock_edge();
    top.wb_cyc = top.wb_stb = 1;
    top.wb_we = write;
    top.wb_adr = offset / 4;
    top.wb_sel = lanes;
    top.wb_dat_w = value;
    enum ending end = NONE;
    for (int i = 0; i < PATIENCE && end == NONE; i++) {
        end = clock_edge();
        if (end != NONE && read)
            *read = top.wb_dat_r;
        top.eval();
    }
    top.wb_cyc = top.wb_stb = 0;
    return end;
}

static uint32_t peek(uint32_t offset)
{
    uint32_t value = 0;
    const enum ending end = request(false, offset, 0, &value);
    orderly = orderly && end == ACK;
    return value;
}

void bus_write(uintptr_t address, uint32_t value)
{
    const enum ending end = request(true, (uint32_t)address, value, NULL);
    orderly = orderly && end == ACK;
}

uint32_t bus_read(uintptr_t address)
{
    return peek((uint32_t)address);
}

struct entry {
    const char *name;
    uint32_t offset, bits, most, writable;
};
#define ENTRY(NAME, name, offset, bits, most, writable) {#name, offset, bits, most, writable},
static const struct entry list[] = {GLINT_UNIT_REGISTERS(ENTRY)};

static bool registers_keep_what_is_written()
{
    reset();
    bool good = peek(GLINT_UNIT_ID) == GLINT_UNIT_ID_VALUE && peek(GLINT_UNIT_STATUS) == GLINT_UNIT_IDLE;
    for (const struct entry &r : list)
        if (r.writable && r.offset != GLINT_UNIT_W)
            for (const uint32_t value : {0u, 1u, r.most, r.most / 3, r.most + 1, UINT32_MAX}) {
                const bool beyond = value > r.most;
                bus_write(r.offset, value);
                good = good && peek(r.offset) == (beyond ? r.most : value);
                for (const struct entry &other : list) // and its neighbours stay
                    if (other.writable && other.offset > r.offset)
                        good = good && peek(other.offset) == 0;
            }
    return good;
}

// Where it must end with an error nothing may change.
static bool refused(uint32_t offset, uint32_t value, unsigned lanes = 15)
{
    const uint32_t before = peek(offset);
    return request(true, offset, value, NULL, lanes) == ERR && peek(offset) == before;
}

static bool what_may_not_be_written_ends_with_an_error()
{
    reset();
    bool good = refused(GLINT_UNIT_ID, 0) && refused(0x54, 1) && refused(0x7c, 1);
    good = good && refused(GLINT_UNIT_N, 5, 7) && refused(GLINT_UNIT_T, 5, 1) && refused(GLINT_UNIT_W, 4097) &&
           refused(GLINT_UNIT_W, UINT32_MAX) && peek(GLINT_UNIT_STATUS) == GLINT_UNIT_IDLE;
    take = 0;
    bus_write(GLINT_UNIT_W, 40); // taken by the unit, whose pixels wait
    for (int i = 0; i < 60; i++)
        clock_edge();
    good = good && peek(GLINT_UNIT_STATUS) == 0 && refused(GLINT_UNIT_N, 5) && refused(GLINT_UNIT_SPECULAR_BLUE, 5);
    bus_write(GLINT_UNIT_W, 3); // waits
    good = good && peek(GLINT_UNIT_STATUS) == GLINT_UNIT_WAITS && refused(GLINT_UNIT_T, 5) && refused(GLINT_UNIT_W, 5);
    take = 256;
    for (int i = 0; i < 200; i++)
        clock_edge();
    return good && pixels.size() == 43 && peek(GLINT_UNIT_STATUS) == GLINT_UNIT_IDLE &&
           request(true, GLINT_UNIT_N, 5, NULL) == ACK;
}

// A span that waits, one in the unit and their pixels.
static bool a_reset_drops_all()
{
    reset();
    take = 0;
    for (const uint32_t value : {40u, 3u}) {
        bus_write(GLINT_UNIT_T, value);
        bus_write(GLINT_UNIT_W, value);
        for (int i = 0; i < 60; i++)
            clock_edge();
    }
    bool good = peek(GLINT_UNIT_STATUS) == GLINT_UNIT_WAITS;
    reset();
    good = good && top.idle;
    take = 256;
    for (int i = 0; i < 100; i++)
        clock_edge();
    for (const struct entry &r : list)
        good = good && (!r.writable || peek(r.offset) == 0);
    return good && pixels.empty() && peek(GLINT_UNIT_STATUS) == GLINT_UNIT_IDLE;
}

static struct glint_span random_span()
{
    const uint32_t t = below(1u << 30), nl = below(1u << 30);
    return {t, below(1u << 20), below(1u << 12), (int32_t)nl, (int32_t)below(1u << 20), (uint16_t)below(40)};
}

static const struct glint_output rgb565 = {};

static struct glint_material random_material(enum glint_model model)
{
    struct glint_material material = {};
    material.model = (uint8_t)model;
    material.n = (uint16_t)(1 + below(1000));
    material.q = (uint8_t)below(17);
    for (int k = 0; k < 3; k++) {
        material.ambient_q16[k] = below(20000);
        material.diffuse_q16[k] = below(65537);
        material.specular_q16[k] = below(65537);
        material.albedo[k] = 255;
    }
    return material;
}

static bool spans_from_c_are_the_model_s_pixels()
{
    reset();
    for (int i = 0; i < 60; i++) {
        struct glint_material material = random_material(i % 2 ? GLINT_MSH : GLINT_SCHLICK);
        material.clamp_peak = i / 2 % 2;
        take = i % 3 ? 256 : 60;
        if (unit_set_material(&material, &rgb565) != GLINT_OK) // waits for the spans before
            return false;
        pixels.clear();
        std::vector<uint32_t> wanted;
        for (int j = 0; j < 12; j++) {
            const struct glint_span span = random_span();
            uint16_t line[64];
            span_model(&material, span_model_c_min(&material), &span, line);
            for (unsigned x = 0; x < span.w; x++)
                wanted.push_back((uint32_t)line[x] << 1 | (x + 1u == span.w));
            if (unit_shade_span(&span) != GLINT_OK)
                return false;
        }
        while (!(peek(GLINT_UNIT_STATUS) & GLINT_UNIT_IDLE)) {
        }
        if (pixels != wanted) {
            printf("# %zu pixels, %zu wanted, or others\n", pixels.size(), wanted.size());
            return false;
        }
    }
    return true;
}

static bool what_the_unit_does_not_draw_is_refused_in_c()
{
    reset();
    struct glint_material material = random_material(GLINT_SCHLICK);
    material.n = 60;
    bool good = unit_set_material(&material, &rgb565) == GLINT_OK && peek(GLINT_UNIT_N) == 60;
    material.n = 70; // none of these is written
    const auto refused = [&](enum glint_err reason, void (*change)(struct glint_material &, struct glint_output &)) {
        struct glint_material other = material;
        struct glint_output output = rgb565;
        change(other, output);
        good = good && unit_set_material(&other, &output) == reason && peek(GLINT_UNIT_N) == 60;
    };
    refused(GLINT_ERR_ARG, [](struct glint_material &m, struct glint_output &) { m.model = GLINT_BLINN; });
    refused(GLINT_ERR_ARG, [](struct glint_material &m, struct glint_output &) { m.model = GLINT_MODEL_COUNT; });
    refused(GLINT_ERR_ARG, [](struct glint_material &m, struct glint_output &) { m.albedo[1] = 254; });
    refused(GLINT_ERR_ARG, [](struct glint_material &m, struct glint_output &) { m.n = 0; });
    refused(GLINT_ERR_ARG, [](struct glint_material &m, struct glint_output &) { m.n_across = 71; });
    refused(GLINT_ERR_FORMAT, [](struct glint_material &, struct glint_output &o) { o.format = GLINT_RGB888; });
    refused(GLINT_ERR_FORMAT, [](struct glint_material &, struct glint_output &o) { o.space = GLINT_LINEAR; });
    refused(GLINT_ERR_FORMAT, [](struct glint_material &, struct glint_output &o) { o.dither = true; });
    struct glint_span span = random_span();
    span.w = 4097;
    good = good && unit_shade_span(&span) == GLINT_ERR_VECTOR && peek(GLINT_UNIT_STATUS) == GLINT_UNIT_IDLE;
    span.w = 4096;
    material.n_across = 70;
    return good && unit_shade_span(&span) == GLINT_OK && unit_set_material(&material, &rgb565) == GLINT_OK &&
           peek(GLINT_UNIT_N) == 70 && pixels.size() == 4096;
}

// From the clock that takes the write of w to the one in which its pixel is there.
static int latency()
{
    reset();
    take = 256;
    bus_write(GLINT_UNIT_W, 1); // this clock took it; one more ended it
    int clocks = 1;
    for (; pixels.empty() && clocks < 100; clocks++)
        clock_edge();
    return clocks;
}

int main(int argc, char **argv)
{
    Verilated::commandArgs(argc, argv);
    for (const bool is : {false, true}) {
        pipelined = is;
        printf("# a %s master\n", is ? "pipelined" : "classic");
        take = 256;
        tap::check("registers keep what is written, cut to their largest value", registers_keep_what_is_written());
        tap::check("what may not be written now, or at all, ends with an error and changes nothing",
                   what_may_not_be_written_ends_with_an_error());
        tap::check("spans and materials written by the C header are the model's pixels",
                   spans_from_c_are_the_model_s_pixels());
        tap::check("what the unit does not draw is refused in C, and nothing of it is written",
                   what_the_unit_does_not_draw_is_refused_in_c());
        tap::check("a reset drops the spans and pixels that wait, and registers are 0 after it", a_reset_drops_all());
    }
    printf("# %d clocks\n", latency());
    tap::check("behind a skid buffer the first pixel comes 21 clocks after its w", latency() == 21);
    tap::check("each request ends once, a clock after it was taken", orderly);
    return tap::done();
}
