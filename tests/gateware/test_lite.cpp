/* SPDX-License-Identifier: MIT
 * The lite core against its table, and what that costs against the library. */
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "stream.h"
#include "tap.h"

extern "C" {
#include "glint.h"
}

double sc_time_stamp()
{
    return 0;
}

namespace
{

constexpr int32_t ONE = GLINT_C_ONE;
constexpr uint32_t ENTRIES = 208;

/* As the module says: u of entry i. */
uint32_t u_of(uint32_t i)
{
    return i < 16 ? i : (16 + i % 16) << (i / 16 - 1);
}

struct Table {
    uint32_t f[ENTRIES + 1];
    Table(enum glint_model model, uint32_t n)
    {
        for (uint32_t i = 0; i <= ENTRIES; i++)
            f[i] = glint_eval(model, n, ONE - static_cast<int32_t>(u_of(i)));
    }
    uint32_t drop(uint32_t i) const
    {
        return f[i] - f[i + 1];
    }
    uint32_t word(uint32_t i) const
    {
        return f[i] << 15 | drop(i);
    }
};

/* Whose interval c lies in, and how far, in 1/256. */
struct Place {
    uint32_t entry, part;
    explicit Place(int32_t c)
    {
        const uint32_t u = static_cast<uint32_t>(ONE - c);
        const int shift = u < 32 ? 0 : 27 - __builtin_clz(u); /* 16 <= u >> shift < 32 */
        entry = u < 16 ? u : 16 * static_cast<uint32_t>(shift + 1) + (u >> shift) - 16;
        part = shift ? (u - u_of(entry)) << 8 >> shift : 0;
    }
};

uint32_t line(const Table &table, Place at)
{
    uint32_t sum = 0; /* cut after each bit, as there */
    for (int i = 0; i < 8; i++)
        sum = (sum + (at.part >> i & 1 ? table.drop(at.entry) : 0)) >> 1;
    return table.f[at.entry] - sum;
}

class Lite : public Stream
{
  public:
    void material(const Table &table, uint32_t c_min)
    {
        for (uint32_t i = 0; i < ENTRIES; i++) {
            top.t_write = 1;
            top.t_entry = i;
            top.t_value = table.word(i);
            clock();
        }
        top.t_write = 0;
        top.c_min = c_min;
    }
};

bool all_of_a_material(Lite &lite, Random &random, enum glint_model model, uint32_t n, unsigned q, bool pressed)
{
    const Table table(model, n);
    const int32_t c_min = static_cast<int32_t>(glint_cutoff(model, n, q));
    lite.forget();
    lite.material(table, static_cast<uint32_t>(c_min));
    for (int32_t c = -131072; c <= 131071;) {
        lite.ready(!pressed || random.one_in(2));
        if (pressed && random.one_in(3))
            lite.offer_nothing();
        else
            lite.offer(c, c < c_min || c <= 0 ? 0 : line(table, Place(std::min(c, ONE))));
        c += lite.clock();
    }
    lite.drain();
    return lite.good();
}

/* Largest error over all c, F at or above the cutoff; -1 where a difference does not fit. Between two entries both F, which falls
 * with u, and the line lie between the entries' values: where these differ by no more than the worst so far, there is none worse. */
int error_of(enum glint_model model)
{
    int worst = 0;
    for (uint32_t n = 1; n <= GLINT_N_MAX; n++) {
        const Table table(model, n);
        for (uint32_t i = 0; i < ENTRIES; i++)
            if (table.drop(i) >= 1 << 12)
                return -1;
        for (uint32_t i = 0; i < ENTRIES; i++)
            for (uint32_t u = u_of(i); static_cast<int>(table.drop(i)) > worst && u < u_of(i + 1); u++) {
                const int32_t c = ONE - static_cast<int32_t>(u);
                const int f = static_cast<int>(glint_eval(model, n, c));
                worst = std::max(worst, abs(static_cast<int>(line(table, Place(c))) - f));
            }
    }
    return worst;
}

bool within(const char *name, enum glint_model model, int most)
{
    const int error = error_of(model);
    printf("# %s: largest error %d of 2^-16, %.3f levels of 255\n", name, error, error * 255 / 65536.);
    return error >= 0 && error <= most;
}

} // namespace

int main()
{
    static Lite lite;
    Random random;
    tap::check("each c gives the line between its entries: MSH",
               all_of_a_material(lite, random, GLINT_MSH, 60, 8, false));
    tap::check("each c gives the line between its entries: Blinn, n = 1000",
               all_of_a_material(lite, random, GLINT_BLINN, 1000, 16, false));
    tap::check("under gaps and back-pressure: each pixel once, in order, held while it waits",
               all_of_a_material(lite, random, GLINT_SCHLICK, 1, 16, true));
    const int most = 29;
#define NAME(number, name, function, use, grain) #name,
    static const char *const names[] = {GLINT_MODELS(NAME)};
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++) {
        char sentence[100];
        snprintf(sentence, sizeof sentence, "%s: within %d of 2^-16 of the library for every c and n", names[model],
                 most);
        tap::check(sentence, within(names[model], static_cast<enum glint_model>(model), most));
    }
    tap::check("F comes 6 clocks after its cosine", lite.latency() == 6);
    return tap::done();
}
