/* SPDX-License-Identifier: MIT */
#include "bake/lobe_table.h"

#include <inttypes.h>
#include <math.h>

#include "bake/c_source.h"
#include "base/memory.h"
#include "models/models.h"

/* ---- the table ---- */

static uint32_t exact(const struct lobe_table *table, uint32_t x)
{
    const uint32_t f =
        table->of_t ? glint_lobe_eval_t(&table->lobe, x) : glint_lobe_eval(&table->lobe, GLINT_C_ONE - (int32_t)x);
    return table->clamp_peak && f > (uint32_t)GLINT_C_ONE ? (uint32_t)GLINT_C_ONE : f;
}

void lobe_table_fill(struct lobe_table *table)
{
    const uint32_t x_max = table->of_t ? table->lobe.t_max_q30 : (uint32_t)GLINT_C_ONE - table->lobe.c_min_q16;
    table->one = table->bits == 8 ? 255 : table->bits == 16 ? 32768 : 65536;
    table->clamp_peak = table->clamp_peak || table->bits == 8; /* 1.024 * 255 has 9 bits; 1.024 * 32768 has 16 */
    while (((uint64_t)(table->count - 1) << table->shift) <= x_max)
        table->shift++;
    table->entries = allocate(table->count, sizeof *table->entries);
    for (uint32_t i = 0; i < table->count && ((uint64_t)i << table->shift) <= x_max; i++)
        table->entries[i] = (uint32_t)(((uint64_t)exact(table, i << table->shift) * table->one + 32768) >> 16);
}

/* The two look-ups, step by step as the C source below does them. */
static uint32_t nearest(const struct lobe_table *table, uint32_t x)
{
    const uint32_t i = (x >> table->shift) + (table->shift ? x >> (table->shift - 1) & 1 : 0);
    return i < table->count ? table->entries[i] : 0;
}

enum { FRACTION_BITS = 15 }; /* times a difference of at most 67109 is below 2^32 */

static unsigned fraction_bits(const struct lobe_table *table)
{
    return table->shift < FRACTION_BITS ? table->shift : FRACTION_BITS;
}

static uint32_t linear(const struct lobe_table *table, uint32_t x)
{
    const uint32_t i = x >> table->shift;
    if (i >= table->count - 1)
        return 0;
    const unsigned bits = fraction_bits(table);
    const uint32_t a = table->entries[i], b = table->entries[i + 1];
    const uint32_t fraction = x >> (table->shift - bits) & ((UINT32_C(1) << bits) - 1);
    return a - (((a - b) * fraction + (UINT32_C(1) << bits >> 1)) >> bits);
}

struct worst {
    double error, at;
};

/* Everywhere, or at about a million places where there are more. */
static uint32_t measure(const struct lobe_table *table, struct worst *of_nearest, struct worst *of_linear)
{
    const uint32_t end =
        (uint32_t)fmin(ldexp(table->count + 1.0, (int)table->shift), table->of_t ? GLINT_T_ONE : (double)GLINT_C_ONE);
    const uint32_t stride = end >> 20 | 1; /* odd: it meets every phase between entries */
    uint32_t places = 0;
    *of_nearest = *of_linear = (struct worst){0, 0};
    for (uint32_t x = 0; x <= end; x += stride, places++) {
        const double f = exact(table, x) / 65536.0, one = table->one;
        const double at = x / (table->of_t ? (double)GLINT_T_ONE : (double)GLINT_C_ONE);
        const double errors[] = {fabs(nearest(table, x) / one - f), fabs(linear(table, x) / one - f)};
        if (errors[0] > of_nearest->error)
            *of_nearest = (struct worst){errors[0], at};
        if (errors[1] > of_linear->error)
            *of_linear = (struct worst){errors[1], at};
    }
    return places;
}

/* ---- C source ---- */

static void write_comment(FILE *out, const struct lobe_table *table)
{
    struct worst of_nearest, of_linear;
    const uint32_t places = measure(table, &of_nearest, &of_linear);
    fprintf(out,
            "/* Written by glint table, version " GLINT_VERSION_STRING ": %s, n = %u, cutoff 2^-%u, %" PRIu32
            " bytes.\n"
            " * The argument is x = %s. Entry i is the highlight at x = i 2^%u, to the nearest;\n"
            " * %" PRIu32 " stands for 1.0, and the peak is %s.\n"
            " * Largest error between entries, measured at %" PRIu32 " places:\n"
            " *   nearest entry         %.6f (%5.2f levels of 255) at 1 - c = %.9f\n"
            " *   linear interpolation  %.6f (%5.2f levels of 255) at 1 - c = %.9f */\n",
            model_names[table->lobe.model], table->lobe.n, table->lobe.q, table->count * table->bits / 8,
            table->of_t ? "t_q30, t = 1 - c times 2^30" : "65536 - c_q16, c times 2^16", table->shift, table->one,
            table->clamp_peak ? "clamped to it" : "the model's", places, of_nearest.error, of_nearest.error * 255,
            of_nearest.at, of_linear.error, of_linear.error * 255, of_linear.at);
}

static void write_entries(FILE *out, const struct lobe_table *table)
{
    for (uint32_t i = 0; i < table->count; i++)
        fprintf(out, "%s%" PRIu32 "%s", i % 16 ? " " : "\n    ", table->entries[i], i + 1 < table->count ? "," : "");
    fputs("\n};\n", out);
}

/* Names of the parameter and the variables end in _, which the table's name does not. */
static void write_look_ups(FILE *out, const struct lobe_table *table, const char *name)
{
    const unsigned bits = fraction_bits(table);
    const uint32_t last = table->count - 1;
    fprintf(out, "\n/* The nearest entry. */\nstatic inline uint%u_t %s_nearest(uint32_t x_)\n{\n", table->bits, name);
    if (table->shift)
        fprintf(out, "    const uint32_t i_ = (x_ >> %u) + (x_ >> %u & 1);\n", table->shift, table->shift - 1);
    else
        fputs("    const uint32_t i_ = x_;\n", out);
    fprintf(out, "    return (uint%u_t)(i_ <= %" PRIu32 "u ? %s[i_] : 0);\n}\n", table->bits, last, name);

    fprintf(out, "\n/* Between two entries. */\nstatic inline uint%u_t %s_linear(uint32_t x_)\n{\n", table->bits, name);
    fprintf(out, "    const uint32_t i_ = x_ >> %u;\n    if (i_ >= %" PRIu32 "u)\n        return 0;\n", table->shift,
            last);
    fprintf(out, "    const uint32_t a_ = %s[i_], b_ = %s[i_ + 1];\n", name, name);
    fprintf(out, "    const uint32_t fraction_ = x_ >> %u & %" PRIu32 "u;\n", table->shift - bits,
            (UINT32_C(1) << bits) - 1);
    fprintf(out, "    return (uint%u_t)(a_ - (((a_ - b_) * fraction_ + %" PRIu32 "u) >> %u));\n}\n", table->bits,
            UINT32_C(1) << bits >> 1, bits);
}

void lobe_table_write_c(const struct lobe_table *table, const char *name, FILE *out)
{
    write_comment(out, table);
    fprintf(out, "#include <stdint.h>\n\nstatic const uint%u_t %s[%" PRIu32 "] = {", table->bits, name, table->count);
    write_entries(out, table);
    write_look_ups(out, table, name);
}

void lobe_table_write_header(const struct lobe_table *table, const char *name, FILE *out)
{
    const struct c_capitals macro = c_capitals(name);
    write_comment(out, table);
    c_begin_header(name, "<stdint.h>", out);
    fprintf(out, "\n#define %s_ENTRIES %" PRIu32 "\n#define %s_SHIFT %u\n", macro.text, table->count, macro.text,
            table->shift);
    c_begin_externs(out);
    fprintf(out, "extern const uint%u_t %s[%s_ENTRIES];\n", table->bits, name, macro.text);
    c_end_externs(out);
    write_look_ups(out, table, name);
    c_end_header(out);
}

void lobe_table_write_definition(const struct lobe_table *table, const char *name, const char *header, FILE *out)
{
    char type[16];
    snprintf(type, sizeof type, "uint%u_t", table->bits);
    write_comment(out, table);
    fprintf(out, "#include \"%s\"\n", header);
    c_begin_array("", type, name, "", out);
    write_entries(out, table);
}

void lobe_table_write_raw(const struct lobe_table *table, FILE *out)
{
    for (uint32_t i = 0; i < table->count; i++)
        for (unsigned bit = 0; bit < table->bits; bit += 8)
            fputc((int)(table->entries[i] >> bit & 255), out);
}
