/* SPDX-License-Identifier: MIT
 * report.html, one file with the plots in it, and claims.json: two views of the same object. */
#include "paper/report.h"

#include <string.h>

#include "base/message.h"
#include "base/output.h"
#include "glint.h"
#include "paper/formula.h"

static const char style[] =
    "body{font:16px/1.5 system-ui,sans-serif;color:#222;background:#fff;max-width:72rem;margin:2rem auto;padding:0 "
    "1rem}\n"
    "h1,h2{line-height:1.2}h2{margin-top:2.5rem;border-bottom:1px solid #ccc}\n"
    "sup,sub{font-size:.75em;line-height:0}i{font-family:Georgia,'DejaVu Serif',serif}\n"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:.9rem;margin:1rem 0}\n"
    "th,td{border:1px solid #ccc;padding:.35rem .6rem;text-align:left;vertical-align:top}th{background:#f3f3f3}\n"
    "caption{text-align:left;font-weight:600;padding:.3rem 0}\n"
    "img{max-width:100%;height:auto}figure{margin:2rem 0}figcaption{font-size:.9rem;color:#444;margin-top:.4rem}\n"
    ".new{background:#f4f7fb;border-left:4px solid #2f6fb0;padding:.2rem 1.2rem}.new li{margin:.5rem 0}\n"
    "nav ol{columns:2;font-size:.95rem}nav li{break-inside:avoid}\n"
    ".v{white-space:nowrap;font-weight:600}.confirmed{color:#006b3c}.limits{color:#8a5a00}.not{color:#b00020}\n"
    "@page{size:A4;margin:16mm 14mm}\n"
    "@media print{body{font-size:9.5pt;max-width:none;margin:0;padding:0}a{color:inherit;text-decoration:none}\n"
    ".wide{overflow:visible}table{font-size:7.5pt;width:100%}th,td{padding:2pt 3pt}.v{white-space:normal}\n"
    ".many table{font-size:6pt}.many th,.many td{padding:1.5pt 2pt}\n"
    "thead{display:table-header-group}tr,figure,.short{break-inside:avoid}h2,caption{break-after:avoid}\n"
    "figure{margin:10pt 0}img{max-height:108mm;display:block;margin:auto}}\n";

static void put_cell(FILE *stream, const char *tag, const json_t *text)
{
    fprintf(stream, "<%s>", tag);
    formula_put(stream, json_string_value(text));
    fprintf(stream, "</%s>", tag);
}

static const char *value(const json_t *object, const char *key)
{
    return json_string_value(json_object_get(object, key));
}

static int count_of(const struct paper *paper, enum verdict verdict)
{
    size_t i;
    json_t *claim;
    int count = 0;
    json_array_foreach(paper->claims, i, claim) count += strcmp(value(claim, "verdict"), verdict_names[verdict]) == 0;
    return count;
}

static const char *const verdict_classes[] = {
    [CONFIRMED] = "confirmed", [WITH_LIMITS] = "limits", [NOT_CONFIRMED] = "not"};

static const char *class_of(const char *verdict)
{
    for (int i = CONFIRMED; i <= NOT_CONFIRMED; i++)
        if (strcmp(verdict, verdict_names[i]) == 0)
            return verdict_classes[i];
    return "";
}

static void put_claims(FILE *stream, const struct paper *paper)
{
    size_t i;
    json_t *claim;
    fputs("<h2 id=claims>Claims</h2>\n<div class=wide><table>\n"
          "<thead><tr><th>claim</th><th>where</th><th>computed</th><th>verdict</th></tr></thead>\n",
          stream);
    json_array_foreach(paper->claims, i, claim)
    {
        fputs("<tr>", stream);
        put_cell(stream, "td", json_object_get(claim, "claim"));
        put_cell(stream, "td", json_object_get(claim, "where"));
        put_cell(stream, "td", json_object_get(claim, "computed"));
        fprintf(stream, "<td class=\"v %s\">%s</td></tr>\n", class_of(value(claim, "verdict")),
                value(claim, "verdict"));
    }
    fputs("</table></div>\n", stream);
}

static void put_choices(FILE *stream, const struct paper *paper)
{
    size_t i;
    json_t *choice;
    fputs("<h2 id=silent>Where the paper is silent</h2>\n<div class=wide><table>\n"
          "<thead><tr><th>not stated, or an error</th><th>chosen</th><th>the other choice gives</th></tr></thead>\n",
          stream);
    json_array_foreach(paper->choices, i, choice)
    {
        fputs("<tr>", stream);
        put_cell(stream, "td", json_object_get(choice, "silent"));
        put_cell(stream, "td", json_object_get(choice, "chosen"));
        put_cell(stream, "td", json_object_get(choice, "other"));
        fputs("</tr>\n", stream);
    }
    fputs("</table></div>\n", stream);
}

static void put_table(FILE *stream, const char *part, const json_t *table)
{
    size_t i, j;
    json_t *row, *cell;
    fprintf(stream, "<div class=\"wide%s%s\" id=\"%s-table\"><table>\n<caption>",
            json_array_size(json_object_get(table, "head")) > 8 ? " many" : "",
            json_array_size(json_object_get(table, "rows")) <= 12 ? " short" : "", part);
    formula_put(stream, value(table, "title"));
    fputs("</caption>\n<thead><tr>", stream);
    json_array_foreach(json_object_get(table, "head"), j, cell) put_cell(stream, "th", cell);
    fputs("</tr></thead>\n", stream);
    json_array_foreach(json_object_get(table, "rows"), i, row)
    {
        fputs("<tr>", stream);
        json_array_foreach(row, j, cell) put_cell(stream, "td", cell);
        fputs("</tr>\n", stream);
    }
    fputs("</table></div>\n", stream);
    if (value(table, "note")) {
        put_cell(stream, "p", json_object_get(table, "note"));
        fputc('\n', stream);
    }
}

static void put_figure(FILE *stream, const json_t *figure)
{
    fprintf(stream, "<figure id=\"%s\">\n", value(figure, "part"));
    if (value(figure, "data")) {
        fprintf(stream, "<img src=\"%s\" alt=\"", value(figure, "data"));
        formula_put_plain(stream, value(figure, "title"));
        fputs("\">\n", stream);
    }
    fputs("<figcaption><b>", stream);
    formula_put(stream, value(figure, "title"));
    fputs(".</b> ", stream);
    formula_put(stream, value(figure, "caption"));
    fprintf(stream, " Data: <a href=\"%s\">%s</a>%s.</figcaption>\n</figure>\n", value(figure, "csv"),
            value(figure, "csv"), value(figure, "data") ? "" : "; drawn without --no-plots");
}

/* A table with a section of its own, where its part's figure is, too; else NULL. */
static const char *section_of(const struct paper *paper, const char *part)
{
    const json_t *table = json_object_get(paper->tables, part);
    return table ? value(table, "section") : NULL;
}

static void put_figures(FILE *stream, const struct paper *paper, const char *of_part)
{
    size_t i;
    json_t *figure;
    bool begins = !of_part;
    json_array_foreach(paper->figures, i, figure)
    {
        const char *part = value(figure, "part");
        if (of_part ? strcmp(part, of_part) != 0 : section_of(paper, part) != NULL)
            continue;
        if (begins)
            fputs("<h2 id=figures>Figures</h2>\n", stream);
        begins = false;
        put_figure(stream, figure);
    }
}

static void put_tables(FILE *stream, const struct paper *paper)
{
    const char *part;
    json_t *table;
    bool begins = true;
    json_object_foreach(paper->tables, part, table)
    {
        if (section_of(paper, part))
            continue;
        if (begins)
            fputs("<h2 id=tables>Tables</h2>\n", stream);
        begins = false;
        put_table(stream, part, table);
    }
}

static void put_sections(FILE *stream, const struct paper *paper)
{
    const char *part;
    json_t *table;
    json_object_foreach(paper->tables, part, table)
    {
        if (!section_of(paper, part))
            continue;
        fprintf(stream, "<h2 id=\"%s-section\">%s</h2>\n", part, section_of(paper, part));
        put_table(stream, part, table);
        put_figures(stream, paper, part);
    }
}

/* ---- what is not a table or a plot of data ---- */

/* Figures 2 and 8 are charts of programs: what they say in words, and where their results are. */
static const char programs[] =
    "<h2 id=programs>Figures 2 and 8: two programs</h2>\n"
    "<p>They are flow charts, without data to draw. What they do was carried out, and is in words:</p>\n"
    "<p><b>Figure 2</b>, the search. Its result is Table 1; here it is <code>glint search</code>.</p>\n<ol>\n"
    "<li>Blinn's values for the angles 0 to 90 degrees and <i>n</i> = 1 to 1000 go into an array.</li>\n"
    "<li>Stage 1: every set of exponents <i>b</i><sub>1</sub>, <i>b</i><sub>2</sub>, <i>b</i><sub>3</sub> = "
    "<i>b</i><sub>4</sub>, <i>b</i><sub>5</sub> from &minus;3 to 3, all coefficients 1: the mean absolute deviation "
    "from the array. The best five sets are kept.</li>\n"
    "<li>Stage 2: for each of the five, every set of coefficients <i>a</i><sub>1</sub>, <i>a</i><sub>2</sub>, "
    "<i>a</i><sub>3</sub> = <i>a</i><sub>4</sub>, <i>a</i><sub>5</sub> from 0.25, 0.5, 1, 1.25, 1.5, 2, 2.5, 3; the "
    "best is kept.</li>\n"
    "<li>A row for each: the deviation, exponents, coefficients.</li>\n</ol>\n"
    "<p><b>Figure 8</b>, the largest relative error. Its result is figure 9.</p>\n<ol>\n"
    "<li>For each <i>n</i> the angle runs from 0 in steps of 0.01 rad up to the cutoff.</li>\n"
    "<li>At each the relative error (17) is computed, and the largest is kept.</li>\n</ol>\n";

static void put_findings(FILE *stream, const struct paper *paper)
{
    size_t i;
    json_t *finding;
    if (!json_array_size(paper->findings))
        return;
    fputs("<div class=new>\n<h2 id=new>What is new to a reader of the paper</h2>\n<ol>\n", stream);
    json_array_foreach(paper->findings, i, finding)
    {
        put_cell(stream, "li", json_object_get(finding, "text"));
        fputc('\n', stream);
    }
    fputs("</ol>\n</div>\n", stream);
}

static void put_entry(FILE *stream, const char *anchor, const char *suffix, const char *text)
{
    fprintf(stream, "<li><a href=\"#%s%s\">", anchor, suffix);
    formula_put(stream, text);
    fputs("</a></li>\n", stream);
}

static void put_contents(FILE *stream, const struct paper *paper)
{
    const char *part;
    json_t *table, *figure;
    size_t i;
    fputs("<nav>\n<h2>Contents</h2>\n<ol>\n", stream);
    if (json_array_size(paper->findings))
        put_entry(stream, "new", "", "What is new to a reader of the paper");
    if (json_array_size(paper->claims))
        put_entry(stream, "claims", "", "Claims, with verdicts");
    if (json_array_size(paper->choices))
        put_entry(stream, "silent", "", "Where the paper is silent");
    json_object_foreach(paper->tables, part, table) if (!section_of(paper, part))
        put_entry(stream, part, "-table", value(table, "title"));
    put_entry(stream, "programs", "", "Figures 2 and 8: two programs");
    json_array_foreach(paper->figures, i, figure) if (!section_of(paper, value(figure, "part")))
        put_entry(stream, value(figure, "part"), "", value(figure, "title"));
    json_object_foreach(paper->tables, part, table) if (section_of(paper, part))
        put_entry(stream, part, "-section", section_of(paper, part));
    fputs("</ol>\n</nav>\n", stream);
}

static void put_report(FILE *stream, const struct paper *paper)
{
    fprintf(
        stream,
        "<!DOCTYPE html>\n<html lang=en>\n<meta charset=utf-8>\n"
        "<meta name=viewport content=\"width=device-width,initial-scale=1\">\n"
        "<title>The modified Schlick paper, computed</title>\n<style>\n%s</style>\n"
        "<h1>The modified Schlick paper, computed</h1>\n"
        "<p>Every claim of Ye. K. Zavalniuk, O. N. Romanyuk, V. V. Voitko, O. V. Romanyuk and A. V. Snigur, <i>The "
        "development of the modified Schlick model for the specular color component calculation</i>, 2022, "
        "<a href=\"https://doi.org/10.31649/1999-9941-2022-55-3-4-12\">DOI 10.31649/1999-9941-2022-55-3-4-12</a>, "
        "beside what was computed, in double precision and with glint's Q16 library (glint %s).</p>\n"
        "<p><b>%zu claims: %d confirmed, %d confirmed with limits, %d not confirmed.</b> The verdicts follow from the "
        "numbers beside them.%s</p>\n",
        style, GLINT_VERSION_STRING, json_array_size(paper->claims), count_of(paper, CONFIRMED),
        count_of(paper, WITH_LIMITS), count_of(paper, NOT_CONFIRMED),
        paper->complete ? "" : " Only some parts were asked for: this report is not complete.");
    put_findings(stream, paper);
    put_contents(stream, paper);
    fputs("<p>", stream);
    formula_put(
        stream,
        "Numbers in brackets are the paper's equations; x is the angle, c = cos x, n the shininess, 2^-q the "
        "cutoff. F_B = c^n is Blinn's function, F_SH = c / (n - nc + c) Schlick's (2), F_MSH = 2c / (1.25 (n - nc "
        "+ 1.25c)^2) the modified Schlick function (5).");
    fputs("</p>\n", stream);
    if (json_array_size(paper->claims))
        put_claims(stream, paper);
    if (json_array_size(paper->choices))
        put_choices(stream, paper);
    put_tables(stream, paper);
    fputs(programs, stream);
    put_figures(stream, paper, NULL);
    put_sections(stream, paper);
    fputs("</html>\n", stream);
}

json_t *paper_summary(const struct paper *paper)
{
    json_t *summary = json_pack("{s:s,s:O,s:O,s:O,s:O}", "version", GLINT_VERSION_STRING, "claims", paper->claims,
                                "choices", paper->choices, "findings", paper->findings, "numbers", paper->numbers);
    if (!summary)
        fail("out of memory");
    return summary;
}

void paper_report(const struct paper *paper)
{
    struct output *output = paper_file(paper, "report.html");
    put_report(output->stream, paper);
    output_close(output);

    json_t *summary = paper_summary(paper);
    output = paper_file(paper, "claims.json");
    json_dumpf(summary, output->stream, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
    fputc('\n', output->stream);
    output_close(output);
    json_decref(summary);
}
