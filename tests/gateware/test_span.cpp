// SPDX-License-Identifier: MIT
// The span unit against span_model.h.
#include <cstdint>
#include <cstring>
#include <vector>

#include "Vtop.h"
#include "span_model.h"
#include "tap.h"
#include "verilated.h"

static uint64_t seed = 5;
static uint32_t bits()
{
    seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)(seed >> 32);
}
static uint32_t below(uint32_t limit)
{
    return (uint32_t)((uint64_t)bits() * limit >> 32);
}

static Vtop top;
static bool held = true; // has everything offered and not taken stayed as it was?
static const int TIMEOUT = 2000;

static void clock_edge()
{
    top.clk = 1;
    top.eval();
    top.clk = 0;
    top.eval();
}

static void reset()
{
    top.rst = 1;
    top.s_valid = 0;
    top.m_ready = 0;
    clock_edge();
    top.rst = 0;
}

// {red, green, blue}, 17 bits each
static uint64_t packed(const uint32_t k[3])
{
    return (uint64_t)k[0] << 34 | (uint64_t)k[1] << 17 | k[2];
}

// What the unit's registers hold.
struct registers {
    struct glint_material material;
    uint32_t c_min;
};

static void set_registers(const struct registers &r)
{
    top.model = r.material.model;
    top.n = r.material.n;
    top.c_min = r.c_min;
    top.clamp_peak = r.material.clamp_peak;
    top.ambient = packed(r.material.ambient_q16);
    top.diffuse = packed(r.material.diffuse_q16);
    top.specular = packed(r.material.specular_q16);
}

static struct registers of_material(enum glint_model model, uint32_t n, unsigned q)
{
    struct registers r = {};
    r.material.model = (uint8_t)model;
    r.material.n = (uint16_t)n;
    r.c_min = glint_cutoff(model, n, q);
    for (int k = 0; k < 3; k++) {
        r.material.ambient_q16[k] = below(4) ? below(20000) : 65536 * below(2);
        r.material.diffuse_q16[k] = below(4) ? below(65537) : 65536 * below(2);
        r.material.specular_q16[k] = below(4) ? below(65537) : 65536 * below(2);
    }
    r.material.clamp_peak = below(2);
    return r;
}

static struct registers random_registers()
{
    static const uint32_t shininess[] = {1, 2, 10, 60, 200, 1000};
    const uint32_t n = below(4) ? shininess[below(6)] : 1 + below(1000);
    return of_material(below(2) ? GLINT_MSH : GLINT_SCHLICK, n, below(17));
}

struct pixel {
    uint16_t rgb565;
    bool last;
};

static std::vector<pixel> drawn_by_the_model(const struct registers &r, const std::vector<glint_span> &spans)
{
    std::vector<pixel> pixels;
    for (const struct glint_span &span : spans) {
        uint16_t line[GLINT_SPAN_MAX];
        span_model(&r.material, r.c_min, &span, line);
        for (unsigned x = 0; x < span.w; x++)
            pixels.push_back({line[x], x + 1u == span.w});
    }
    return pixels;
}

// Chances of 256 that a span is offered and a pixel taken in a clock. gaps: clocks without a pixel between first and last.
// It goes on until nothing more comes, or stop pixels have.
static std::vector<pixel> drawn_by_the_unit(const std::vector<glint_span> &spans, size_t wanted, uint32_t offer,
                                            uint32_t take, unsigned *gaps, size_t stop = SIZE_MAX)
{
    std::vector<pixel> pixels;
    size_t next = 0;
    bool offered = false;
    *gaps = 0;
    for (int idle = 0; idle < TIMEOUT && pixels.size() < stop && (pixels.size() < wanted || idle < 60);) {
        if (!offered && next < spans.size() && below(256) < offer) {
            const struct glint_span &span = spans[next];
            top.s_t = span.t_q30;
            top.s_dt = span.dt_q30;
            top.s_ddt = span.ddt_q30;
            top.s_nl = (uint32_t)span.nl_q30;
            top.s_dnl = (uint32_t)span.dnl_q30;
            top.s_w = span.w;
            offered = true;
        }
        top.s_valid = offered;
        if (!offered)
            top.s_t = top.s_dt = bits(); // what is not valid must not matter
        top.m_ready = below(256) < take;
        top.eval();
        const bool valid = top.m_valid, ready = top.m_ready;
        const pixel now = {(uint16_t)top.m_rgb565, (bool)top.m_last};
        if (offered && top.s_ready) {
            offered = false;
            next++;
        }
        if (valid && ready)
            pixels.push_back(now);
        else if (!valid && !pixels.empty() && pixels.size() < wanted)
            ++*gaps;
        clock_edge();
        if (valid && !ready)
            held = held && top.m_valid && top.m_rgb565 == now.rgb565 && (bool)top.m_last == now.last;
        idle = valid && ready ? 0 : idle + 1;
    }
    return pixels;
}

static bool same(const struct registers &r, const std::vector<glint_span> &spans, uint32_t offer, uint32_t take,
                 unsigned *gaps)
{
    const std::vector<pixel> wanted = drawn_by_the_model(r, spans);
    set_registers(r);
    const std::vector<pixel> found = drawn_by_the_unit(spans, wanted.size(), offer, take, gaps);
    if (found.size() != wanted.size()) {
        printf("# %zu pixels, not %zu\n", found.size(), wanted.size());
        return false;
    }
    for (size_t i = 0; i < wanted.size(); i++)
        if (found[i].rgb565 != wanted[i].rgb565 || found[i].last != wanted[i].last) {
            printf("# pixel %zu is %04x%s, not %04x%s (model %d, n = %d)\n", i, found[i].rgb565,
                   found[i].last ? " last" : "", wanted[i].rgb565, wanted[i].last ? " last" : "", r.material.model,
                   r.material.n);
            return false;
        }
    return true;
}

static bool same(const struct registers &r, const std::vector<glint_span> &spans)
{
    unsigned gaps;
    return same(r, spans, 256, 256, &gaps);
}

// Half of them anything, half between normals about the half vector.
static struct glint_span random_span(uint16_t w)
{
    struct glint_span span = {bits(), bits(), bits(), (int32_t)bits(), (int32_t)bits(), w, {{0, 0}, {0, 0}}};
    if (below(2))
        return span;
    struct glint_paint light;
    struct glint_vec ends[2];
    const int32_t to[3] = {(int32_t)below(200) - 100, (int32_t)below(200) - 100, (int32_t)below(100)};
    if (span_model_light(&light, to) != GLINT_OK)
        return span;
    const int32_t spread = 1 << below(16);
    for (int i = 0; i < 2; i++) {
        const int32_t v[3] = {light.h.x + (int32_t)below(2 * spread) - spread,
                              light.h.y + (int32_t)below(2 * spread) - spread, light.h.z};
        if (glint_vec_normalize(&ends[i], v) != GLINT_OK)
            return span;
    }
    (void)glint_span_init(&span, &light, &ends[0], &ends[1], w);
    return span;
}

static std::vector<glint_span> random_spans(unsigned count)
{
    std::vector<glint_span> spans;
    for (unsigned i = 0; i < count; i++)
        spans.push_back(random_span((uint16_t)(below(4) ? below(20) : below(300))));
    return spans;
}

static bool random_spans_match()
{
    for (int i = 0; i < 400; i++) {
        unsigned gaps;
        static const uint32_t chances[] = {256, 200, 60, 10};
        if (!same(random_registers(), random_spans(80), chances[below(4)], chances[below(3)], &gaps))
            return false;
    }
    return true;
}

static bool the_shortest_and_the_longest_match()
{
    std::vector<glint_span> spans;
    for (const uint16_t w : {1, 1, 0, 0, 1, 4096, 0, 1, 4095, 2, 4096, 4096})
        spans.push_back(random_span(w));
    for (int i = 0; i < 4; i++)
        if (!same(random_registers(), spans))
            return false;
    return true;
}

// t and nl at and beside every limit of the reductions, one pixel each and as the middle of three.
static bool the_limits_match()
{
    static const uint32_t t_limits[] = {0,
                                        1 << 13,
                                        1 << 14,
                                        1 << 30,
                                        (1 << 30) + (1 << 13),
                                        UINT32_C(1) << 31,
                                        UINT32_C(0xf8000000),
                                        UINT32_C(0xffffe000)};
    static const uint32_t nl_limits[] = {0,
                                         1 << 13,
                                         1 << 14,
                                         1 << 30,
                                         (1 << 30) + (1 << 13),
                                         INT32_MAX,
                                         UINT32_C(0x80000000),
                                         UINT32_C(0) - (1 << 13),
                                         UINT32_C(0) - (1 << 14)};
    for (int i = 0; i < 8; i++) {
        std::vector<glint_span> spans;
        for (const uint32_t t : t_limits)
            for (const uint32_t nl : nl_limits)
                for (uint32_t beside = 0; beside < 9; beside++) {
                    const uint32_t at = t + beside / 3 - 1, nl_at = nl + beside % 3 - 1, dt = bits() >> 4,
                                   dnl = bits() >> 4;
                    spans.push_back({at, 0, 0, (int32_t)nl_at, 0, 1});
                    spans.push_back({at - dt, dt, bits(), (int32_t)(nl_at - dnl), (int32_t)dnl, 3});
                }
        struct registers r = random_registers();
        for (int k = 0; k < 3; k++) // all that lights a pixel is there
            r.material.diffuse_q16[k] = 20000 + 9000 * (uint32_t)k, r.material.specular_q16[k] = 30000;
        if (!same(r, spans))
            return false;
    }
    return true;
}

// Sums at 1, one unit beside, and far above; the peak of 1.024 raw and clamped, for each model and q.
static bool sums_saturate_as_in_the_model()
{
    for (unsigned q = 0; q <= 16; q++)
        for (unsigned flags = 0; flags < 16; flags++) {
            struct registers r = of_material(flags & 1 ? GLINT_MSH : GLINT_SCHLICK, 60, q);
            r.material.clamp_peak = flags >> 1 & 1;
            for (int k = 0; k < 3; k++) {
                r.material.specular_q16[k] = flags & 4 ? 65536 : 32767 + (uint32_t)k;
                r.material.diffuse_q16[k] = flags & 8 ? 65536 : 0;
                r.material.ambient_q16[k] = flags & 8 ? 65536 * (uint32_t)(k == 1) : 32768;
            }
            std::vector<glint_span> spans;
            for (int i = 0; i < 8; i++) // from the peak outwards, through the cutoff
                spans.push_back(
                    {UINT32_C(0) - below(1 << 20), below(1 << 20), 1 << (8 + i), 1 << (30 - i), 1 << 20, 64});
            if (!same(r, spans))
                return false;
        }
    return true;
}

static bool there_are_no_gaps()
{
    for (int i = 0; i < 20; i++) {
        std::vector<glint_span> spans;
        for (int j = 0; j < 200; j++)
            spans.push_back(random_span((uint16_t)(1 + below(3))));
        unsigned gaps;
        if (!same(random_registers(), spans, 256, 256, &gaps) || gaps) {
            printf("# %u gaps\n", gaps);
            return false;
        }
    }
    return true;
}

// Clocks from the edge that takes a span to the one that takes its first pixel, when nothing waits.
static int latency()
{
    reset();
    top.m_ready = top.s_valid = 1;
    top.s_w = 1;
    int clocks = 0;
    for (top.eval(); !top.m_valid && clocks < 100; clocks++) {
        clock_edge();
        top.s_valid = 0;
        top.eval();
    }
    reset();
    return clocks;
}

static bool a_reset_empties_it()
{
    unsigned gaps;
    const std::vector<glint_span> before = {random_span(4096)};
    for (size_t pixels = 1; pixels < 60; pixels += 7) {
        set_registers(random_registers());
        drawn_by_the_unit(before, pixels, 256, 128, &gaps, pixels);
        reset();
        if (!same(random_registers(), random_spans(5)))
            return false;
    }
    return true;
}

int main(int argc, char **argv)
{
    Verilated::commandArgs(argc, argv);
    reset();
    tap::check("random spans of both models are the model's pixels under random back-pressure", random_spans_match());
    tap::check("spans of 0, 1, 4095 and 4096 pixels are the model's pixels", the_shortest_and_the_longest_match());
    tap::check("at and beside every limit of t and N.L pixels are the model's", the_limits_match());
    tap::check("sums at and above 1 and the peak, raw and clamped, are the model's for every q",
               sums_saturate_as_in_the_model());
    tap::check("spans follow each other without a gap", there_are_no_gaps());
    tap::check("a reset in the middle of a span empties the unit", a_reset_empties_it());
    tap::check("a pixel that is offered stays until it is taken", held);
    tap::check("the first pixel comes 19 clocks after its span", latency() == 19);
    return tap::done();
}
