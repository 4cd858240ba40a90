/* SPDX-License-Identifier: MIT
 * glint table: a lobe as a table, as C source for flash or raw. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/argp.h"
#include "base/c_names.h"
#include "base/message.h"
#include "base/output.h"
#include "base/parse.h"
#include "commands/commands.h"
#include "models/models.h"

enum { KEY_MODEL = 256, KEY_OF, KEY_ENTRIES, KEY_BITS, KEY_CLAMP, KEY_NAME, KEY_RAW };

/* Entry i is the lobe at the distance x = i 2^shift from the peak: x = 65536 - c_q16, or x = t_q30. */
struct table {
    struct glint_lobe lobe;
    bool of_t, clamp_peak;
    unsigned bits, shift;
    uint32_t count, one; /* `one` stands for 1.0 */
    uint32_t *entries;   /* they never rise, and the last is 0: it lies beyond the cutoff */
};

struct request {
    enum glint_model model;
    uint32_t n;
    unsigned q;
    bool raw;
    const char *name, *path;
    struct table table;
};

static const struct argp_option options[] = {
    {"model", KEY_MODEL, "NAME", 0, MODEL_WORDS "default: msh", 0},
    {"shininess", 'n', "N", 0, "Shininess, a whole number from 1 to 1000; default 60", 0},
    {"cutoff", 'q', "Q", 0, "The table ends where the highlight falls below 2^-Q, 0 to 16; default 8", 0},
    {"of", KEY_OF, "c|t", 0, "The argument: the cosine c, or t = 1 - c (default), which is finer near the peak", 0},
    {"entries", KEY_ENTRIES, "COUNT", 0, "Entries, 2 to 65536; default 256", 0},
    {"bits", KEY_BITS, "BITS", 0, "Bits an entry: 8 (1.0 is 255), 16 (1.0 is 32768; default) or 32 (1.0 is 65536)", 0},
    {"clamp-peak", KEY_CLAMP, NULL, 0, "Limit entries to 1.0, as 8 bits always do; otherwise msh reaches 1.024", 0},
    {"name", KEY_NAME, "NAME", 0, "The array's name in C and C++ (default: from the material, such as msh_n60_q8)", 1},
    {"raw", KEY_RAW, NULL, 0, "Write only the entries, low byte first", 1},
    {"output", 'o', "FILE", 0, "Write to FILE (default: -, standard output)", 1},
    {0}};

static const char doc[] =
    "Write a material's highlight as a table: C source for flash, with its look-up functions, or raw.\v"
    "The argument is the distance from the peak, x = t_q30 or x = 65536 - c_q16. Entry i is the library's value at "
    "x = i 2^SHIFT; SHIFT is the smallest for which the last entry lies beyond the cutoff and is 0. The C source "
    "states "
    "SHIFT and the largest measured errors of the nearest entry and of linear interpolation.\n"
    "\n"
    "Examples:\n"
    "  glint table --model msh -n 60 -o msh_n60_q8.h\n"
    "  glint table --model gauss -n 200 --of c --entries 64 --bits 8 -o shine.h\n"
    "  glint table --model blinn -n 20 --bits 32 --raw -o blinn.bin";

/* ---- the table ---- */

static uint32_t exact(const struct table *table, uint32_t x)
{
    const uint32_t f =
        table->of_t ? glint_lobe_eval_t(&table->lobe, x) : glint_lobe_eval(&table->lobe, GLINT_C_ONE - (int32_t)x);
    return table->clamp_peak && f > (uint32_t)GLINT_C_ONE ? (uint32_t)GLINT_C_ONE : f;
}

static void fill(struct table *table)
{
    const uint32_t x_max = table->of_t ? table->lobe.t_max_q30 : (uint32_t)GLINT_C_ONE - table->lobe.c_min_q16;
    table->one = table->bits == 8 ? 255 : table->bits == 16 ? 32768 : 65536;
    table->clamp_peak = table->clamp_peak || table->bits == 8; /* 1.024 * 255 has 9 bits; 1.024 * 32768 has 16 */
    while (((uint64_t)(table->count - 1) << table->shift) <= x_max)
        table->shift++;
    table->entries = calloc(table->count, sizeof *table->entries);
    if (!table->entries)
        fail("out of memory");
    for (uint32_t i = 0; i < table->count && ((uint64_t)i << table->shift) <= x_max; i++)
        table->entries[i] = (uint32_t)(((uint64_t)exact(table, i << table->shift) * table->one + 32768) >> 16);
}

/* The two look-ups, step by step as the C source below does them. */
static uint32_t nearest(const struct table *table, uint32_t x)
{
    const uint32_t i = (x >> table->shift) + (table->shift ? x >> (table->shift - 1) & 1 : 0);
    return i < table->count ? table->entries[i] : 0;
}

enum { FRACTION_BITS = 15 }; /* times a difference of at most 67109 is below 2^32 */

static unsigned fraction_bits(const struct table *table)
{
    return table->shift < FRACTION_BITS ? table->shift : FRACTION_BITS;
}

static uint32_t linear(const struct table *table, uint32_t x)
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
static uint32_t measure(const struct table *table, struct worst *of_nearest, struct worst *of_linear)
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

static void write_comment(FILE *out, const struct table *table)
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

static void write_entries(FILE *out, const struct table *table, const char *name)
{
    fprintf(out, "static const uint%u_t %s[%" PRIu32 "] = {", table->bits, name, table->count);
    for (uint32_t i = 0; i < table->count; i++)
        fprintf(out, "%s%" PRIu32 "%s", i % 16 ? " " : "\n    ", table->entries[i], i + 1 < table->count ? "," : "");
    fputs("\n};\n", out);
}

/* Names of the parameter and the variables end in _, which the table's name does not. */
static void write_look_ups(FILE *out, const struct table *table, const char *name)
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

static void write_source(FILE *out, const struct table *table, const char *name)
{
    write_comment(out, table);
    fputs("#include <stdint.h>\n\n", out);
    write_entries(out, table, name);
    write_look_ups(out, table, name);
}

static void write_raw(FILE *out, const struct table *table)
{
    for (uint32_t i = 0; i < table->count; i++)
        for (unsigned bit = 0; bit < table->bits; bit += 8)
            fputc((int)(table->entries[i] >> bit & 255), out);
}

/* ---- the command ---- */

static error_t parse_option(int key, char *argument, struct argp_state *state)
{
    static const char *const arguments[] = {"c", "t", NULL};
    struct request *request = state->input;
    switch (key) {
    case KEY_MODEL:
        request->model = parse_model(state, "--model", argument);
        return 0;
    case 'n':
        request->n = (uint32_t)parse_integer(state, "-n", argument, 1, GLINT_N_MAX);
        return 0;
    case 'q':
        request->q = (unsigned)parse_integer(state, "-q", argument, 0, GLINT_Q_MAX);
        return 0;
    case KEY_OF:
        request->table.of_t = parse_choice(state, "--of", "argument", argument, arguments) == 1;
        return 0;
    case KEY_ENTRIES:
        request->table.count = (uint32_t)parse_integer(state, "--entries", argument, 2, 65536);
        return 0;
    case KEY_BITS:
        if (strcmp(argument, "8") != 0 && strcmp(argument, "16") != 0 && strcmp(argument, "32") != 0)
            refuse(state, "--bits: '%s' is not 8, 16 or 32", argument);
        request->table.bits = (unsigned)atoi(argument);
        return 0;
    case KEY_CLAMP:
        request->table.clamp_peak = true;
        return 0;
    case KEY_NAME:
        request->name = parse_c_name(state, argument);
        return 0;
    case KEY_RAW:
        request->raw = true;
        return 0;
    case 'o':
        request->path = parse_output(state, "-o", argument);
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; name the file by -o", argument);
        return 0;
    case ARGP_KEY_END:
        if (request->raw && request->name)
            refuse(state, "--name is for C source; it cannot be used with --raw");
        if (request->raw && strcmp(request->path, "-") == 0 && isatty(STDOUT_FILENO))
            refuse(state, "--raw: standard output is a terminal; pipe or redirect it, or name a file by -o");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int command_table(int argc, char **argv)
{
    static const struct argp argp = {options, parse_option, NULL, doc, NULL, NULL, NULL};
    struct request request = {.model = GLINT_MSH, .n = 60, .q = 8, .path = "-"};
    struct table *table = &request.table;
    *table = (struct table){.of_t = true, .bits = 16, .count = 256};
    parse_command(&argp, 0, argc, argv, &request);
    glint_lobe_init(&table->lobe, request.model, request.n, request.q);
    fill(table);

    char name[64];
    snprintf(name, sizeof name, "%s_n%" PRIu32 "_q%u", model_names[request.model], request.n, request.q);
    struct output *output = output_open(request.path);
    if (request.raw)
        write_raw(output->stream, table);
    else
        write_source(output->stream, table, request.name ? request.name : name);
    output_close(output);
    free(table->entries);
    return EXIT_GOOD;
}
