/* SPDX-License-Identifier: MIT
 * report.html, one file with the plots in it, and claims.json: two views of the same object. */
#include "paper/report.h"

#include <string.h>

#include "base/message.h"
#include "base/output.h"
#include "glint.h"

static const char style[] =
    "body{font:16px/1.5 system-ui,sans-serif;color:#222;background:#fff;max-width:72rem;margin:2rem auto;padding:0 "
    "1rem}\n"
    "h1,h2{line-height:1.2}h2{margin-top:2.5rem;border-bottom:1px solid #ccc}\n"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:.9rem;margin:1rem 0}\n"
    "th,td{border:1px solid #ccc;padding:.35rem .6rem;text-align:left;vertical-align:top}th{background:#f3f3f3}\n"
    "caption{text-align:left;font-weight:600;padding:.3rem 0}\n"
    "img{max-width:100%;height:auto}figure{margin:2rem 0}figcaption{font-size:.9rem;color:#444}\n"
    ".v{white-space:nowrap;font-weight:600}.confirmed{color:#006b3c}.limits{color:#8a5a00}.not{color:#b00020}\n";

/* Text into HTML. */
static void put(FILE *stream, const char *text)
{
    for (; *text; text++) {
        const char *entity = *text == '&' ? "&amp;" : *text == '<' ? "&lt;" : *text == '>' ? "&gt;" : NULL;
        if (entity)
            fputs(entity, stream);
        else
            fputc(*text, stream);
    }
}

static void put_cell(FILE *stream, const char *tag, const json_t *text)
{
    fprintf(stream, "<%s>", tag);
    put(stream, json_string_value(text));
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
    fputs("<h2>Claims</h2>\n<div "
          "class=wide><table>\n<tr><th>claim</th><th>where</th><th>computed</th><th>verdict</th></tr>\n",
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
    fputs("<h2>Where the paper is silent</h2>\n<div class=wide><table>\n"
          "<tr><th>not stated, or an error</th><th>chosen</th><th>the other choice gives</th></tr>\n",
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

static void put_table(FILE *stream, const json_t *table)
{
    size_t i, j;
    json_t *row, *cell;
    fputs("<div class=wide><table>\n<caption>", stream);
    put(stream, value(table, "title"));
    fputs("</caption>\n<tr>", stream);
    json_array_foreach(json_object_get(table, "head"), j, cell) put_cell(stream, "th", cell);
    fputs("</tr>\n", stream);
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
        put(stream, value(figure, "title"));
        fputs("\">\n", stream);
    }
    fputs("<figcaption><b>", stream);
    put(stream, value(figure, "title"));
    fputs(".</b> ", stream);
    put(stream, value(figure, "caption"));
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
            fputs("<h2>Figures</h2>\n", stream);
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
            fputs("<h2>Tables</h2>\n", stream);
        begins = false;
        put_table(stream, table);
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
        fprintf(stream, "<h2>%s</h2>\n", section_of(paper, part));
        put_table(stream, table);
        put_figures(stream, paper, part);
    }
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
        "beside what was computed, in double precision and with glint's Q16 library (glint %s). Numbers in brackets "
        "are the paper's equations; x is the angle, c = cos x, n the shininess, 2^-q the cutoff; F_B = c^n is Blinn's "
        "function, F_SH Schlick's, F_MSH the modified Schlick function.</p>\n"
        "<p><b>%zu claims: %d confirmed, %d confirmed with limits, %d not confirmed.</b> The verdicts follow from the "
        "numbers beside them.%s</p>\n",
        style, GLINT_VERSION_STRING, json_array_size(paper->claims), count_of(paper, CONFIRMED),
        count_of(paper, WITH_LIMITS), count_of(paper, NOT_CONFIRMED),
        paper->complete ? "" : " Only some parts were asked for: this report is not complete.");
    if (json_array_size(paper->claims))
        put_claims(stream, paper);
    if (json_array_size(paper->choices))
        put_choices(stream, paper);
    put_tables(stream, paper);
    put_figures(stream, paper, NULL);
    put_sections(stream, paper);
    fputs("</html>\n", stream);
}

json_t *paper_summary(const struct paper *paper)
{
    json_t *summary = json_pack("{s:s,s:O,s:O,s:O}", "version", GLINT_VERSION_STRING, "claims", paper->claims,
                                "choices", paper->choices, "numbers", paper->numbers);
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
