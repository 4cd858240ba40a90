/* SPDX-License-Identifier: MIT
 * The table of models on the paper's grid, and what one evaluation costs. */
#include "paper/models.h"

#include <math.h>

#include "base/output.h"
#include "models/formulas.h"
#include "models/models.h"
#include "paper/q16.h"

/* A row of the table. */
struct entry {
    const struct model_facts *facts;
    const char *key; /* in the names of numbers */
    int model;       /* of the library; -1: double only */
};

/* Fitted to c^n, to compare with. */
static const struct model_facts spherical_gaussian = {
    .title = "Spherical Gaussian, fitted",
    .formula = "exp(-(n + .775)(1-c))",
    .value = spherical_gaussian_double,
    .operations = {.multiply = 1, .add = 1, .more = "exp"},
};

enum { ENTRIES = GLINT_MODEL_COUNT - 2 + 1 }; /* without Blinn and Phong, which are c^n; with the fitted one */

static void list_entries(struct entry entries[ENTRIES])
{
    int count = 0;
    for (int model = 0; model < GLINT_MODEL_COUNT; model++)
        if (model != GLINT_BLINN && model != GLINT_PHONG)
            entries[count++] = (struct entry){model_facts[model], model_names[model], model};
    entries[count] = (struct entry){&spherical_gaussian, "spherical_gaussian", -1};
}

static const char *title_of(const struct entry *entry)
{
    return entry->facts->long_title ? entry->facts->long_title : entry->facts->title;
}

struct measured {
    double mean, largest, largest_from_2;    /* |F - c^n| on the grid of 91 angles and n = 1..1000 */
    double mean_q16, largest_q16, apart_q16; /* the library's, and how far it is from the double */
    double epicentre;                        /* largest relative error (17) at (6), n = 2..1000, percent */
    double spot, spot_60, peak; /* cutoff angle over Blinn's at q = 8: largest over n, at n = 60; F(0), n = 60 */
    int spot_n;
};

/* Over the grid of the paper: whole degrees, n = 1..1000. Each value is compared with Blinn's c^n, in double and as the
 * library gives it, and the library's with the double. */
static void measure_grid(const struct entry *entry, struct measured *m)
{
    for (int n = 1; n <= 1000; n++)
        for (int angle = 0; angle <= 90; angle++) {
            const double x = angle * PI / 180, c = cos(x), blinn = model_double(GLINT_BLINN, n, c);
            const double f = entry->facts->value(n, c), error = absolute_error(f, blinn);
            m->mean += error / (91.0 * 1000);
            m->largest = fmax(m->largest, error);
            if (n >= 2)
                m->largest_from_2 = fmax(m->largest_from_2, error);
            if (entry->model < 0)
                continue;
            const double q16 = q16_from_t((enum glint_model)entry->model, n, x);
            m->mean_q16 += absolute_error(q16, blinn) / (91.0 * 1000);
            m->largest_q16 = fmax(m->largest_q16, absolute_error(q16, blinn));
            m->apart_q16 = fmax(m->apart_q16, fabs(q16 - f) * GLINT_C_ONE);
        }
}

/* The angle where F, which falls, meets 2^-q: by bisection, since not every model has a closed form. 90 degrees where F
 * stays above. */
static double cutoff_by_bisection(const struct entry *entry, double n, double q)
{
    double low = 0, high = PI / 2;
    for (int i = 0; i < 60; i++) {
        const double middle = (low + high) / 2;
        *(entry->facts->value(n, cos(middle)) >= exp2(-q) ? &low : &high) = middle;
    }
    return low;
}

static struct measured measure(const struct entry *entry)
{
    struct measured m = {0};
    measure_grid(entry, &m);
    for (int n = 1; n <= 1000; n++) {
        const double spot = cutoff_by_bisection(entry, n, 8) / blinn_cutoff_angle(n, 8);
        if (spot > m.spot) {
            m.spot = spot;
            m.spot_n = n;
        }
        const double c = cos(epicentre_angle(n));
        if (n >= 2)
            m.epicentre =
                fmax(m.epicentre, relative_error_percent(entry->facts->value(n, c), model_double(GLINT_BLINN, n, c)));
    }
    m.spot_60 = cutoff_by_bisection(entry, 60, 8) / blinn_cutoff_angle(60, 8);
    m.peak = entry->facts->value(60, 1);
    return m;
}

static int operation_count(const struct model_operations *operations)
{
    return operations->multiply + operations->add + operations->divide;
}

/* Multiplications for c^n by squaring: one for each bit after the first, one more for each of these that is set. */
static int power_by_squaring(unsigned n)
{
    int count = 0;
    for (; n > 1; n >>= 1)
        count += 1 + (int)(n & 1);
    return count;
}

static void operations_claim(struct paper *paper)
{
    const int prepared = operation_count(&model_msh.operations), printed = 8; /* 5 x, 2 +, 1 / in (5) */
    int fewer_squaring = 0, fewer_repeated = 0, most = 0;
    for (unsigned n = 1; n <= 1000; n++) {
        fewer_squaring += prepared < power_by_squaring(n);
        fewer_repeated += printed < (int)n - 1;
        most = power_by_squaring(n) > most ? power_by_squaring(n) : most;
    }
    paper_claim(paper, "models", "text", "F_MSH needs fewer operations than Blinn and Phong",
                verdict_of(fewer_squaring == 1000, fewer_squaring > 0),
                json_sprintf(
                    "MSH %d operations as printed, %d with constants prepared, one of them a division; c^n takes n - 1 "
                    "multiplications, more than %d for %d of 1000 n, or by squaring up to %d (%d at n = 60), more "
                    "than %d for %d of 1000 n. On a given machine the cost of a division decides",
                    printed, prepared, printed, fewer_repeated, most, power_by_squaring(60), prepared, fewer_squaring));
    paper_choice(
        paper, "models", "how operations are counted, and how Blinn's power is computed",
        json_sprintf("one each for +, x, /; constants of the material prepared; c^n by squaring, n whole"),
        json_sprintf("a library pow() or a table of c^n: then no count of operations decides, but time and memory"));
    paper_count(paper, "operations_msh", prepared);
    paper_count(paper, "operations_fewer_than_squaring_of_1000", fewer_squaring);
}

static void write_row(FILE *stream, const struct entry *entry, const struct measured *m)
{
    fprintf(stream, "\"%s\",\"%s\",%.9f,%.9f,%.9f,%.6f,%.6f,%d,%.6f,%.6f,%d,%d,%d,%s,", title_of(entry),
            entry->facts->formula, m->mean, m->largest, m->largest_from_2, m->epicentre, m->spot, m->spot_n, m->spot_60,
            m->peak, entry->facts->operations.multiply, entry->facts->operations.add, entry->facts->operations.divide,
            entry->facts->operations.more ? "yes" : "no");
    if (entry->model >= 0)
        fprintf(stream, "%.9f,%.9f,%.6f", m->mean_q16, m->largest_q16, m->apart_q16);
    else
        fputs(",,", stream);
    fputc('\n', stream);
}

static json_t *note_of(const struct entry entries[ENTRIES], int nearer)
{
    json_t *note =
        json_sprintf("Errors are |F - c^n| on the paper's grid: whole degrees 0 to 90, n = 1..1000. %d of the other %d "
                     "models are nearer to Blinn's than MSH in the mean. 1 ulp = 2^-16. Operations: for one c, "
                     "constants of n prepared.",
                     nearer, ENTRIES - 1);
    for (int i = 0; i < ENTRIES; i++) {
        if (!entries[i].facts->source)
            continue;
        json_t *longer =
            json_sprintf("%s %s: %s.", json_string_value(note), entries[i].facts->title, entries[i].facts->source);
        json_decref(note);
        note = longer;
    }
    return note;
}

void paper_models(struct paper *paper)
{
    static const char *const head[] = {"model",
                                       "formula",
                                       "mean error",
                                       "largest error",
                                       "largest, n >= 2",
                                       "at the epicentre, n >= 2",
                                       "spot / Blinn's, q = 8, n = 60",
                                       "largest over n",
                                       "peak, n = 60",
                                       "operations",
                                       "Q16 mean, largest error",
                                       "Q16 less double",
                                       NULL};
    json_t *table = paper_table_new(paper, "models", "The models compared with Blinn's c^n", head);
    struct output *csv = paper_file(paper, "models.csv");
    fputs("model,formula,mean,largest,largest_from_n2,epicentre_percent,spot_ratio_q8,spot_ratio_n,spot_ratio_q8_n60,"
          "peak,multiply,add,divide,more,mean_q16,largest_q16,largest_ulp_q16\n",
          csv->stream);
    struct entry entries[ENTRIES];
    struct measured m[ENTRIES];
    int nearer = 0;
    double msh_mean = 0, msh_largest = 0;
    list_entries(entries);
    for (int i = 0; i < ENTRIES; i++) {
        m[i] = measure(&entries[i]);
        write_row(csv->stream, &entries[i], &m[i]);
        if (entries[i].model == GLINT_MSH) {
            msh_mean = m[i].mean;
            msh_largest = m[i].largest_from_2;
        }
        const struct model_operations *o = &entries[i].facts->operations;
        const bool fixed = entries[i].model >= 0;
        paper_table_row(table, 12, json_string(title_of(&entries[i])), json_string(entries[i].facts->formula),
                        json_sprintf("%.5f", m[i].mean), json_sprintf("%.4f", m[i].largest),
                        json_sprintf("%.4f", m[i].largest_from_2), json_sprintf("%.1f %%", m[i].epicentre),
                        json_sprintf("%.2f", m[i].spot_60), json_sprintf("%.2f at n = %d", m[i].spot, m[i].spot_n),
                        json_sprintf("%.3f", m[i].peak),
                        operation_count(o) ? json_sprintf("%d x, %d +, %d /%s%s", o->multiply, o->add, o->divide,
                                                          o->more ? ", " : "", o->more ? o->more : "")
                                           : json_string("-"),
                        fixed ? json_sprintf("%.5f, %.4f", m[i].mean_q16, m[i].largest_q16) : json_string("-"),
                        fixed ? json_sprintf("%.3f ulp", m[i].apart_q16) : json_string("-"));
        char name[48];
        snprintf(name, sizeof name, "mean_%s", entries[i].key);
        paper_number(paper, name, m[i].mean);
        snprintf(name, sizeof name, "largest_%s", entries[i].key);
        paper_number(paper, name, m[i].largest);
        snprintf(name, sizeof name, "largest_%s_from_n2", entries[i].key);
        paper_number(paper, name, m[i].largest_from_2);
    }
    output_close(csv);
    for (int i = 0; i < ENTRIES; i++)
        nearer += m[i].mean < msh_mean;
    json_object_set_new(table, "note", note_of(entries, nearer));
    const double printed_angle = 20 * PI / 180; /* between H and L where the light is 40 degrees from the viewer */
    paper_choice(
        paper, "models", "Gauss's angle x, printed as between H and L", json_sprintf("between N and H, as for Blinn's"),
        json_sprintf("as printed the highlight does not depend on the normal: with the light 40 degrees from the "
                     "viewer F = %.4f everywhere at n = 60",
                     model_double(GLINT_GAUSS, 60, cos(printed_angle))));
    operations_claim(paper);
    int cayley = 0;
    while (cayley < ENTRIES - 1 && entries[cayley].model != GLINT_CAYLEY)
        cayley++;
    paper_finding(
        paper, "models",
        json_sprintf("%d of the other %d models are nearer to Blinn's c^n in the mean than MSH. Cayley, which is "
                     "ours, deviates by %.5f (MSH: %.5f) and by %.4f at most (MSH: %.4f, for n >= 2), with one "
                     "division, too.",
                     nearer, ENTRIES - 1, m[cayley].mean, msh_mean, m[cayley].largest, msh_largest));
}
