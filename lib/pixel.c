/* SPDX-License-Identifier: MIT
 * A pixel in 64 bits, as sequence.md has it; how pixels are stored; and in gamma space what a material folds to for the formats' loops. */
#include "glint_pixel.h"

#define PIXEL_ONE ((uint64_t)65535 << 32) /* a value of 1.0 */

const uint16_t glint_bayer_rows[4] GLINT_FLASH = {0xa280, 0x6e4c, 0x91b3, 0x5d7f};

#define PIXEL_TRAITS(number, name, bits, channels, red, green, blue) {bits, {red, green, blue}},
const struct glint_format_traits glint_formats[GLINT_FORMAT_COUNT] GLINT_FLASH = {GLINT_FORMATS(PIXEL_TRAITS)};
#undef PIXEL_TRAITS

/* a x for a <= 2^16, x < 2^48: by products of 32 bits where one of 64 is a function. */
static inline uint64_t pixel_product(uint32_t a, uint64_t x)
{
#if GLINT_THUMB1
    const uint32_t low = (uint32_t)x, high = (uint32_t)(x >> 32);
    return a * (low & 0xffff) + ((uint64_t)(a * (low >> 16)) << 16) + ((uint64_t)(a * high) << 32);
#else
    return a * x;
#endif
}

uint64_t glint_exact_value(const struct glint_material *m, unsigned k, uint32_t albedo, uint32_t nl_q16, uint64_t shine)
{
    const uint64_t lit = ((uint64_t)glint_coefficient(m->ambient_q16[k]) << 16) +
                         pixel_product(glint_coefficient(m->diffuse_q16[k]), nl_q16);
    const uint64_t x = pixel_product(albedo, lit) + pixel_product(glint_coefficient(m->specular_q16[k]), shine);
    return x < PIXEL_ONE ? x : PIXEL_ONE;
}

uint32_t glint_exact_level(uint64_t x, uint32_t max, uint32_t weight)
{
    const uint32_t z = (uint32_t)((pixel_product(max, x) + ((uint64_t)(65535 * weight) << 27)) >> 32);
    /* z / 65535 for z = 65535 q + r = 65536 q + r - q, q <= 256: z >> 16 is q, or q - 1 where r < q */
    return (z + (z >> 16) + 1) >> 16;
}

/* Channel by channel, to keep the stack low. */
uint64_t glint_exact_channel(const struct glint_paint *paint, const struct glint_run *run, unsigned i, unsigned k,
                             const struct glint_sample *sum)
{
    const uint8_t *albedo = run->albedo ? run->albedo + 3 * i : paint->material.albedo;
    const uint32_t gloss = (run->gloss ? run->gloss[i] : 255) * 257u;
    return glint_exact_value(&paint->material, k, albedo[k] * 257u, sum->nl_q16, pixel_product(gloss, sum->f_q16));
}

void glint_exact_levels(uint8_t levels[4], const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                        const struct glint_sample *sum, unsigned apart)
{
    const uint32_t weight = glint_weight(paint, run, i);
    for (unsigned k = 0; k < 3; k++, sum += apart)
        levels[k] = (uint8_t)glint_exact_level(glint_exact_channel(paint, run, i, k, sum),
                                               GLINT_FLASH_U8(glint_formats[paint->output.format].max[k]), weight);
}

static void store_565(uint8_t *low, uint8_t *high, const uint8_t *levels, unsigned count, uint32_t open)
{
    for (const uint8_t *end = levels + 4 * count; levels != end; levels += 4, low += 2, high += 2, open >>= 1) {
        const uint32_t pixel = (uint32_t)levels[0] << 11 | (uint32_t)levels[1] << 5 | levels[2];
        if (!(open & 1)) {
            *low = (uint8_t)pixel;
            *high = (uint8_t)(pixel >> 8);
        }
    }
}

static void store_rgb(uint8_t *red, int blue, unsigned bytes, const uint8_t *levels, unsigned count, uint32_t open)
{
    for (const uint8_t *end = levels + 4 * count; levels != end; levels += 4, red += bytes, open >>= 1) {
        if (!(open & 1)) {
            red[0] = levels[0];
            red[blue / 2] = levels[1];
            red[blue] = levels[2];
        }
    }
}

/* Pixels of 4, 2 or 1 bits: a byte is put together before it is written. */
static void store_bits(uint8_t *line, uint32_t x, const uint8_t *levels, unsigned count, uint32_t open, unsigned bits)
{
    uint8_t *at = line + (bits * x >> 3);
    unsigned left = 8 - (bits * (unsigned)x & 7); /* bits of the byte that are not in `byte` yet */
    uint32_t byte = (uint32_t)*at >> left;        /* above it are bits of those before */
    for (const uint8_t *end = levels + count; levels != end; open >>= 1) {
        uint32_t level = *levels++;
        left -= bits;
        if (open & 1)
            level = (uint32_t)*at >> left & ((1u << bits) - 1);
        byte = byte << bits | level;
        if (left == 0) {
            *at++ = (uint8_t)byte;
            left = 8;
        }
    }
    if (left != 8)
        *at = (uint8_t)(byte << left | (*at & ((1u << left) - 1)));
}

void glint_store_run(uint8_t format, uint8_t *line, uint32_t x, const uint8_t *levels, unsigned count, uint32_t open)
{
    const unsigned bits = GLINT_FLASH_U8(glint_formats[format].bits), bytes = bits >> 3;
    uint8_t *out = line + bytes * x;
    if (bytes == 2) {
        const bool swapped = format == GLINT_RGB565_SWAPPED;
        store_565(out + swapped, out + !swapped, levels, count, open);
    } else if (bytes > 2) {
        const bool blue_first = glint_format_is_blue_first(format);
        store_rgb(blue_first ? out + 2 : out, blue_first ? -2 : 2, bytes, levels, count, open);
    } else if (bytes) {
        for (; count--; out++, levels++, open >>= 1)
            if (!(open & 1))
                *out = *levels;
    } else {
        store_bits(line, x, levels, count, open, bits);
    }
}

void glint_store_alpha(uint8_t format, uint8_t *line, uint32_t x, unsigned count, const uint8_t *coverage)
{
    if (format != GLINT_XRGB8888 && format != GLINT_ARGB8888)
        return;
    coverage = coverage && format == GLINT_ARGB8888 ? coverage + x : NULL;
    for (line += 4 * x + 3; count--; line += 4)
        *line = coverage ? *coverage++ : 255;
}

/* Called, not inlined, for less code: it is only set-up. */
#define LEVELS_CALLED __attribute__((noinline)) static

/* n / 2^bits, rounded down, and by how much that times 2^16 is low where n is low by less than 2. bits <= 16. */
struct levels_cut {
    uint32_t value, low; /* low <= 2^16 + 2^12 */
};
LEVELS_CALLED struct levels_cut levels_cut_of(uint32_t n, unsigned bits)
{
    const struct levels_cut cut = {n >> bits, ((n & (((uint32_t)1 << bits) - 1)) + 2) << (16 - bits)};
    return cut;
}

/* n / 255, rounded down, without a division: the first sum is low by less than 4, and never high. */
static uint32_t levels_by_255(uint32_t n)
{
    uint32_t q = (n >> 8) + (n >> 16) + (n >> 24);
    while (n - q * 255 >= 255)
        q++;
    return q;
}

/* The largest shift at which the largest sum of a channel, or the largest level, and a threshold, less than 1, leave
 * V < 2^32 - 2^20. A sum of 3.03 * 255 leaves 22, one of 33.1 * 255 (up = 4) 18. */
static unsigned levels_shift(const struct glint_material *m, const struct glint_coefficients *c, const uint8_t max[3],
                             unsigned up)
{
    uint32_t most = (uint32_t)GLINT_FLASH_U8(max[1]) << 16;
    for (int k = 0; k < 3; k++) {
        const uint32_t s = c->s[k]; /* F <= 67109 < 33/32 2^16 */
        const uint32_t sum =
            (glint_coefficient(m->ambient_q16[k]) + ((c->d[k] + s + (s >> 5) + 1) << up)) * GLINT_FLASH_U8(max[k]);
        most = sum > most ? sum : most;
    }
    unsigned shift = 28;
    while (most + 65536 > UINT32_C(0xfff00000) >> (shift - 16))
        shift--;
    return shift;
}

/* Every n below is < 2^24, and low by < 2. Of several lights nl and F are sums, shifted down: low by less than 1 more. */
void glint_levels_fold(struct glint_paint *p, const struct glint_coefficients *c, unsigned up)
{
    const struct glint_material *m = &p->material;
    const uint8_t *const max = glint_formats[p->output.format].max;
    const unsigned shift = levels_shift(m, c, max, up);
    const bool grey = glint_format_is_grey(p->output.format);
    const uint32_t half = grey || p->output.dither ? 0 : (uint32_t)1 << (shift - 1);
    const uint32_t is_down = p->of.exact.nl_down != 0;
    p->of.exact.shift = shift;
    p->of.exact.w = p->of.exact.w_maps = 0;
    for (int k = 0; k < 3; k++) {
        /* Coefficients in levels of the channel, Q16: low by < 1, in RGB exact. 2^16 255 256 < 2^32 */
        const uint32_t levels = GLINT_FLASH_U8(max[k]) * (grey ? glint_luma((unsigned)k) : 256);
        const uint32_t albedo = m->albedo[k], a = glint_coefficient(m->ambient_q16[k]) * levels >> 8;
        const uint32_t d = c->d[k] * levels >> 8;
        const struct levels_cut q = levels_cut_of(levels_by_255(d * albedo), 32 - shift - up);
        const struct levels_cut r = levels_cut_of(c->s[k] * levels >> 8, 32 - shift - up);
        const struct levels_cut diffuse = levels_cut_of(levels_by_255(d * 256), 33 - shift - up);
        p->of.exact.p[k] = (levels_by_255(a * albedo) << (shift - 16)) + half; /* low by < 2 2^(shift - 16) */
        p->of.exact.ambient[k] = levels_by_255(a * 256)
                                 << (shift - 17); /* low by < 2 2^(shift - 17), times 255 / 2^7 */
        p->of.exact.q[k] = q.value;               /* Q nl: low by q.low, as nl <= 2^16 */
        p->of.exact.diffuse[k] = diffuse.value;   /* low by diffuse.low, times 255 / 2^7 */
        p->of.exact.r[k] = r.value;               /* R F: low by 33/32 r.low, and (R + 1) slack of F */
        /* 1: what the loop of grey takes off and step 6 cuts, < 2 in three channels (tests/proof) */
        const uint32_t both =
            ((uint32_t)2 << (shift - 16)) + r.low + (r.low >> 5) + p->of.exact.slack * (r.value + 1) + 1;
        const uint32_t w = both + q.low + is_down * (q.value + 1);
        /* >> 7 loses < 1 of 255, and F gloss / 255 < 1 + 2^-6: glint_by_255. W < 2^shift for a slack up to 64, of which
         * a unit is R + 1 <= 2^(shift - 8) */
        const uint32_t w_maps =
            both + 2 * diffuse.low + 255 + r.value + (r.value >> 6) + is_down * 2 * (diffuse.value + 1);
        p->of.exact.w = grey ? p->of.exact.w + w : w > p->of.exact.w ? w : p->of.exact.w;
        p->of.exact.w_maps = grey                          ? p->of.exact.w_maps + w_maps
                             : w_maps > p->of.exact.w_maps ? w_maps
                                                           : p->of.exact.w_maps;
    }
}

/* The threshold of b, the lowest 4 bits of row, times 2^shift: 2b + 1 of 32, or 16. one: 2^15 / 32, or 16 times that, less
 * paint->of.exact.high. */
static inline uint32_t levels_threshold(uint32_t row, uint32_t one, uint32_t shift)
{
    return ((row << 28 >> 17) + one) << (shift - 15);
}

void glint_levels_bias(uint32_t bias[4], const struct glint_paint *p, const struct glint_run *run)
{
    const bool dither = p->output.dither;
    const uint32_t shift = p->of.exact.shift, one = (dither ? 1024u : 16384u) - p->of.exact.high;
    uint32_t row = dither ? glint_bayer_row(run->left + run->x, run->y) : 0;
    for (unsigned i = 0; i < 4; i++, row >>= 4)
        bias[i] = levels_threshold(row, one, shift);
}

void glint_levels_base(uint32_t base[12], const struct glint_paint *p, const struct glint_run *run)
{
    const uint32_t shift = p->of.exact.shift, one = 1024u - p->of.exact.high;
    uint32_t row = glint_bayer_row(run->left + run->x, run->y);
    for (const uint32_t *end = base + 12; base != end; base += 3, row >>= 4) {
        const uint32_t threshold = levels_threshold(row, one, shift);
        for (unsigned k = 0; k < 3; k++)
            base[k] = p->of.exact.p[k] + threshold;
    }
}

/* V as with maps, and so W, a channel after the other. In grey the sum of the channels' shares is the level; step 6 rounds it down,
 * by less than 1 here, which is taken off. */
uint32_t glint_levels_apart(const struct glint_paint *p, const struct glint_run *run,
                            const struct glint_sample *samples, unsigned count)
{
    const uint8_t format = p->output.format;
    const unsigned shift = (unsigned)p->of.exact.shift;
    const bool grey = glint_format_is_grey(format);
    const uint8_t *albedo = run->albedo ? run->albedo : p->material.albedo;
    uint32_t bias[4], open = 0;
    glint_levels_bias(bias, p, run);
    glint_levels_alpha(format, run, 0, count);
    for (unsigned i = 0; i < count; i++, albedo += run->albedo ? 3 : 0) {
        const struct glint_sample *sample = samples + i;
        uint32_t sum = bias[i & 3] - grey, undecided = 0;
        uint8_t levels[4];
        for (unsigned k = 0; k < 3; k++, sample += run->apart) {
            const uint32_t most = (uint32_t)GLINT_FLASH_U8(glint_formats[format].max[k]) << shift;
            const uint32_t f = run->gloss ? glint_by_255(sample->f_q16 * run->gloss[i]) : sample->f_q16;
            uint32_t v = (albedo[k] * ((p->of.exact.ambient[k] + p->of.exact.diffuse[k] * sample->nl_q16) >> 7)) +
                         p->of.exact.r[k] * f;
            if (grey)
                v = sum += glint_levels_hold(v, (most >> 8) * glint_luma(k));
            else
                v += sum;
            v = glint_levels_hold(v, most);
            if (!grey || k == 2)
                undecided |= v ^ (v + p->of.exact.w_maps);
            levels[k] = (uint8_t)(v >> shift);
        }
        levels[0] = levels[grey ? 2 : 0];
        if (undecided >> shift)
            open |= (uint32_t)1 << i;
        else
            glint_store_run(format, run->line, run->x + i, levels, 1, 0);
    }
    return open;
}
