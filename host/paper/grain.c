/* SPDX-License-Identifier: MIT
 * Beyond the paper: grain. m = n_across t + (n - n_across) (H.T)^2 / 2 in the place of n t makes the modified Schlick function anisotropic,
 * along T by n and across it by n_across; beside the anisotropic lobes of others, each over its peak, in double precision. */
#include "paper/grain.h"

#include <math.h>
#include <stdbool.h>

#include "base/output.h"
#include "models/models.h"
#include "paper/figure.h"

enum { ALONG = 200, ACROSS = 8, SIZE = 160 };

/* ---- lobes ---- */

/* H beside the surface's axes: N, T, B = N x T. */
struct half {
    double c, t, b;
};
typedef double lobe(double n, double n_across, const struct half *h);

static double msh(double n, double n_across, const struct half *h)
{
    const double m = n_across * (1 - h->c) + (n - n_across) * h->t * h->t / 2, d = m + 1.25 * h->c;
    return 2 * h->c / (1.25 * d * d);
}

static double ggx_by_grain(double n, double n_across, const struct half *h)
{
    const double t = 1 - h->c, m = n_across * t + (n - n_across) * h->t * h->t / 2, e = 1 + m - n_across * t * t / 2;
    return 1 / (e * e);
}

/* What the others have of both shininesses: n (1 - c^2) where they are one. */
static double of_both(double n, double n_across, const struct half *h)
{
    return n * h->t * h->t + n_across * h->b * h->b;
}

static double ashikhmin(double n, double n_across, const struct half *h)
{
    const double sine = 1 - h->c * h->c;
    return sine < 1e-12 ? 1 : pow(h->c, of_both(n, n_across, h) / sine);
}

static double ward(double n, double n_across, const struct half *h)
{
    return exp(-of_both(n, n_across, h) / (2 * h->c * h->c));
}

static double ggx(double n, double n_across, const struct half *h)
{
    const double x = h->t * h->t * (1 + n / 2), y = h->b * h->b * (1 + n_across / 2), e = h->c * h->c + x + y;
    return 1 / (e * e);
}

static const struct other {
    const char *key, *title;
    lobe *value;
} others[] = {
    {"ashikhmin", "Ashikhmin-Shirley 2000", ashikhmin},
    {"ward", "Ward 1992", ward},
    {"ggx", "GGX, anisotropic", ggx},
};
enum { OTHERS = sizeof others / sizeof *others };

/* ---- surfaces: of the square -1..1, x right, y up ---- */

struct place {
    double n[3], t[3];
};
typedef bool surface(double x, double y, struct place *place);

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void set_unit(double v[3], double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    v[0] = x / length;
    v[1] = y / length;
    v[2] = z / length;
}

/* A knob: domed a little, its edge bevelled; the grain runs round its middle. */
static bool disc(double x, double y, struct place *place)
{
    const double r = hypot(x, y) + 1e-9, slope = r > 0.82 ? (r - 0.82) * 9 : r * 0.12;
    set_unit(place->n, x / r * slope, y / r * slope, 1);
    set_unit(place->t, -y / r, x / r, 0);
    return r < 0.93;
}

/* A ball turned about its upright axis. */
static bool sphere(double x, double y, struct place *place)
{
    const double u = x / 0.93, v = y / 0.93, square = 1 - u * u - v * v;
    set_unit(place->n, u, v, sqrt(fmax(square, 1e-9)));
    set_unit(place->t, place->n[2], 0, -place->n[0]);
    return square > 0;
}

/* Bowed a little, its edges bevelled; the grain runs from left to right. */
static bool plate(double x, double y, struct place *place)
{
    const double slope_x = fabs(x) > 0.84 ? copysign(0.8, x) : 0.4 * x;
    const double slope_y = fabs(y) > 0.62 ? copysign(0.8, y) : 0.2 * y;
    set_unit(place->n, slope_x, slope_y, 1);
    const double n0 = place->n[0];
    set_unit(place->t, 1 - n0 * n0, -n0 * place->n[1], -n0 * place->n[2]);
    return fabs(x) < 0.93 && fabs(y) < 0.71;
}

static const struct shape {
    const char *key, *title;
    surface *at;
} shapes[] = {
    {"disc", "disc, spun", disc},
    {"sphere", "sphere, turned", sphere},
    {"plate", "plate, brushed", plate},
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

/* ---- what is lit ---- */

struct pixel {
    bool is_there, is_lit;
    double nl;
    struct half h;
};

static struct pixel pixel_at(const struct shape *shape, int column, int line)
{
    struct place place;
    double light[3], half[3];
    set_unit(light, -0.5, 0.6, 0.9);
    set_unit(half, light[0], light[1], light[2] + 1); /* the viewer is at 0, 0, 1 */
    struct pixel pixel = {
        .is_there = shape->at((column + 0.5) / SIZE * 2 - 1, 1 - (line + 0.5) / SIZE * 2, &place),
    };
    const double *n = place.n, *t = place.t;
    const double b[3] = {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]};
    pixel.nl = fmax(dot(n, light), 0);
    pixel.h = (struct half){fmin(dot(n, half), 1), dot(half, t), dot(half, b)};
    pixel.is_lit = pixel.is_there && pixel.nl > 0 && pixel.h.c > 0;
    return pixel;
}

static double lit_by(lobe *value, double n_across, const struct pixel *pixel)
{
    return pixel->is_lit ? value(ALONG, n_across, &pixel->h) : 0;
}

/* ---- how far apart ---- */

struct apart {
    double mean, largest, c; /* c: where it is largest */
};

static struct apart measure(const struct shape *shape, lobe *ours, lobe *other, double n_across)
{
    struct apart apart = {0, 0, 0};
    long count = 0;
    for (int line = 0; line < SIZE; line++)
        for (int column = 0; column < SIZE; column++) {
            const struct pixel pixel = pixel_at(shape, column, line);
            const double error = fabs(lit_by(ours, n_across, &pixel) - lit_by(other, n_across, &pixel));
            count += pixel.is_there;
            apart.mean += pixel.is_there ? error : 0;
            if (error > apart.largest) {
                apart.largest = error;
                apart.c = pixel.h.c;
            }
        }
    apart.mean /= (double)count;
    return apart;
}

/* ---- the report ---- */

static int grey(const struct pixel *pixel, lobe *value)
{
    if (!pixel->is_there)
        return 20;
    const double sum = 0.43 * (0.22 + 0.55 * pixel->nl) + 0.78 * lit_by(value, ACROSS, pixel);
    return (int)lround(255 * fmin(sum, 1));
}

static void write_pictures(struct output *csv)
{
    fputs("x,y", csv->stream);
    for (int i = 0; i < SHAPES; i++) {
        fprintf(csv->stream, ",%s_msh", shapes[i].key);
        for (int k = 0; k < OTHERS; k++)
            fprintf(csv->stream, ",%s_%s", shapes[i].key, others[k].key);
    }
    fputc('\n', csv->stream);
    for (int line = 0; line < SIZE; line++)
        for (int column = 0; column < SIZE; column++) {
            fprintf(csv->stream, "%d,%d", column, line);
            for (int i = 0; i < SHAPES; i++) {
                const struct pixel pixel = pixel_at(&shapes[i], column, line);
                fprintf(csv->stream, ",%d", grey(&pixel, msh));
                for (int k = 0; k < OTHERS; k++)
                    fprintf(csv->stream, ",%d", grey(&pixel, others[k].value));
            }
            fputc('\n', csv->stream);
        }
}

static void put_row(struct paper *paper, json_t *table, const struct shape *shape, const char *key, const char *ours,
                    const char *other, const struct apart *apart)
{
    char name[64];
    paper_table_row(table, 6, json_string(shape->title), json_string(ours), json_string(other),
                    json_sprintf("%.4f", apart->mean), json_sprintf("%.3f", apart->largest),
                    apart->largest < 1e-9 ? json_string("-") : json_sprintf("%.3f", apart->c));
    snprintf(name, sizeof name, "grain_mean_%s_%s", shape->key, key);
    paper_number(paper, name, apart->mean);
    snprintf(name, sizeof name, "grain_largest_%s_%s", shape->key, key);
    paper_number(paper, name, apart->largest);
}

static double write_table(struct paper *paper, json_t *table)
{
    double of_ggx = 0;
    for (int i = 0; i < SHAPES; i++) {
        for (int k = 0; k < OTHERS; k++) {
            const struct apart apart = measure(&shapes[i], msh, others[k].value, ACROSS);
            put_row(paper, table, &shapes[i], others[k].key, "MSH by m", others[k].title, &apart);
        }
        const struct apart blinn = measure(&shapes[i], msh, ashikhmin, ALONG); /* is c^n then */
        put_row(paper, table, &shapes[i], "blinn", "MSH, n_across = n", "Blinn's c^n", &blinn);
        of_ggx = fmax(of_ggx, measure(&shapes[i], ggx_by_grain, ggx, ACROSS).largest);
    }
    paper_number(paper, "grain_largest_ggx_by_m", of_ggx);
    return of_ggx;
}

static const char script[] =
    "set multiplot layout 3,4 margins 0.01,0.99,0.01,0.96 spacing 0.01,0.02\nset palette gray\nunset colorbox\nunset "
    "key\nunset tics\nunset border\nunset grid\n"
    "set cbrange [0:255]\nset size ratio -1\nset yrange [*:*] reverse\n"
    "names = 'msh ashikhmin ward ggx'\ntitles = \"'MSH by m' 'Ashikhmin-Shirley' 'Ward' 'GGX, anisotropic'\"\n"
    "do for [shape in 'disc sphere plate'] { do for [k = 1:4] {\n"
    "  set title (shape eq 'disc' ? word(titles, k) : '')\n"
    "  plot 'grain.csv' using 'x':'y':sprintf('%s_%s', shape, word(names, k)) with image\n"
    "} }\nunset multiplot\n";

void paper_grain(struct paper *paper)
{
    static const char *const head[] = {"surface",          "ours", "beside", "mean difference", "largest",
                                       "there c = N.H is", NULL};
    struct output *csv = paper_file(paper, "grain.csv");
    write_pictures(csv);
    output_close(csv);
    json_t *table = paper_table_new(paper, "grain", "F by grain beside the anisotropic lobes of others", head);
    const double of_ggx = write_table(paper, table);
    json_object_set_new(table, "section", json_string("Beyond the paper: anisotropy for one dot product more"));
    json_object_set_new(table, "note",
                        json_sprintf("n enters F_MSH only as n t, t = 1 - c. Let T be the direction of the scratches, "
                                     "of length 1 and in the surface, n the "
                                     "shininess along them and n_across the one across. With m = n_across t + (n - "
                                     "n_across) (H.T)^2 / 2 in the place of n t "
                                     "F_MSH = 2c / (1.25 (m + 1.25 c)^2) is anisotropic, for one dot product, one "
                                     "square and two products more; with "
                                     "n_across = n it is the paper's function. m lies between the smaller and the "
                                     "larger n times t. Here n = %d and "
                                     "n_across = %d, on %d x %d pixels, the light at (-.5, .6, .9), every lobe over "
                                     "its peak: Ashikhmin and Shirley's "
                                     "c^((n (H.T)^2 + n_across (H.B)^2) / (1 - c^2)); Ward's exp(-((H.T / a)^2 + (H.B "
                                     "/ b)^2) / c^2), a^2 = 2 / n; GGX "
                                     "1 / (c^2 + (H.T / a)^2 + (H.B / b)^2)^2, a^2 = 2 / (n + 2); b alike of n_across, "
                                     "B = N x T. The rows of Blinn's say "
                                     "how far the paper's function is from c^n on the same surface. GGX itself by m, 1 "
                                     "/ (1 + m - n_across t^2 / 2)^2, "
                                     "is anisotropic GGX: they differ by at most %.1e.",
                                     ALONG, ACROSS, SIZE, SIZE, of_ggx));
    paper_finding(
        paper, "grain",
        json_sprintf(
            "F_MSH can be made anisotropic for one dot product more: with m in the place of n t, as the "
            "last section has it. On a spun disc it is then %.4f from Ashikhmin and Shirley's lobe in the mean, "
            "where the isotropic one is %.4f from Blinn's.",
            measure(&shapes[0], msh, ashikhmin, ACROSS).mean, measure(&shapes[0], msh, ashikhmin, ALONG).mean));
    paper_figure(paper, "grain", "Grain: spun, turned and brushed metal", 1000, 800, script,
                 json_sprintf("n = %d along the grain, %d across it. Ambient and diffuse light are the same in all.",
                              ALONG, ACROSS));
}
