/* SPDX-License-Identifier: MIT */
#include "base/manual.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp_options.h"
#include "glint.h"

/* ---- roff ---- */

/* Text as roff prints it, to be copied from the page: every dash is a minus, a line that begins with a dot is text. */
static void put_text(const char *text, size_t length, FILE *out)
{
    if (length && (*text == '.' || *text == '\''))
        fputs("\\&", out);
    for (size_t i = 0; i < length; i++) {
        if (text[i] == '\\')
            fputs("\\e", out);
        else if (text[i] == '-')
            fputs("\\-", out);
        else
            fputc(text[i], out);
    }
}

/* A command's name as pages have it, "glint-render". */
static void put_name(const char *name, bool capitals, FILE *out)
{
    for (const char *at = name; *at; at++)
        if (*at == ' ' || *at == '-')
            fputs("\\-", out);
        else
            fputc(capitals ? toupper((unsigned char)*at) : *at, out);
}

static void put_line(const char *text, FILE *out)
{
    put_text(text, strlen(text), out);
    fputc('\n', out);
}

static void put_capitals(const char *text, size_t length, FILE *out)
{
    for (size_t i = 0; i < length; i++)
        fputc(toupper((unsigned char)text[i]), out);
}

/* Lines that begin with a blank are shown as they are, a line that ends with a colon before such lines is a heading, others
 * are paragraphs; those before the first heading are notes. */
static void put_paragraphs(const char *text, FILE *out)
{
    bool as_it_is = false, has_heading = false;
    while (*text) {
        const size_t length = strcspn(text, "\n");
        const char *next = text + length + (text[length] == '\n');
        const bool indented = *text == ' ' && length;
        if (indented != as_it_is)
            fputs(indented ? ".PP\n.nf\n" : ".fi\n", out);
        as_it_is = indented;
        if (length && !indented && text[length - 1] == ':' && *next == ' ') {
            fputs(".SH ", out);
            put_capitals(text, length - 1, out);
            fputc('\n', out);
            has_heading = true;
        } else if (length && strncmp(text, "Exit status: ", strlen("Exit status: ")) != 0) { /* has a section */
            fputs(has_heading ? "" : ".SH NOTES\n", out);
            has_heading = true;
            fputs(indented ? "" : ".PP\n", out);
            put_text(text, length, out);
            fputc('\n', out);
        }
        text = next;
    }
    if (as_it_is)
        fputs(".fi\n", out);
}

/* ---- the tables ---- */

/* Puts what the command's help_filter makes of a text, the text itself where it has none. */
static void put_filtered(const struct argp *root, int key, const char *text, void (*put)(const char *text, FILE *out),
                         FILE *out)
{
    const struct argp *argp = root->children[0].argp;
    char *own = argp->help_filter ? argp->help_filter(key, text, NULL) : (char *)(uintptr_t)text;
    if (own)
        put(own, out);
    if (own != text)
        free(own);
}

static bool has_letter(const struct argp_option *option)
{
    return option->key > ' ' && option->key < 127;
}

static void put_option(const struct argp *root, const struct argp_option *option, FILE *out)
{
    fputs(".TP\n", out);
    if (has_letter(option)) {
        fprintf(out, "\\fB\\-%s%c\\fR", option->key == '-' ? "\\" : "", option->key);
        if (option->arg && !option->name)
            fprintf(out, " \\fI%s\\fR", option->arg);
        if (option->name)
            fputs(", ", out);
    }
    if (option->name) {
        fputs("\\fB\\-\\-", out);
        put_name(option->name, false, out);
        fputs("\\fR", out);
        if (option->arg)
            fprintf(out, option->flags & OPTION_ARG_OPTIONAL ? "[=\\fI%s\\fR]" : "=\\fI%s\\fR", option->arg);
    }
    fputc('\n', out);
    put_filtered(root, option->key, option->doc ? option->doc : "", put_line, out);
}

static void put_options(const struct argp *root, FILE *out)
{
    struct option_list list = {.count = 0};
    options_collect(root, &list);
    fputs(".SH OPTIONS\n", out);
    for (unsigned i = 0; i < list.count; i++) {
        const struct argp_option *option = list.options[i];
        if (!option_is_heading(option) && !(option->flags & OPTION_HIDDEN)) {
            put_option(root, option, out);
        } else if (option_is_heading(option) && option->doc && i + 1 < list.count &&
                   list.groups[i + 1] == list.groups[i]) {
            fputs(".SS ", out);
            put_text(option->doc, strlen(option->doc) - (option->doc[strlen(option->doc) - 1] == ':'), out);
            fputc('\n', out);
        }
    }
}

void manual_write(const struct argp *root, const char *name, FILE *out)
{
    const struct argp *argp = root->children[0].argp;
    const char *doc = argp->doc ? argp->doc : "", *more = strchr(doc, '\v');
    size_t length = more ? (size_t)(more - doc) : strlen(doc);
    if (strncmp(doc, name, strlen(name)) == 0 && strncmp(doc + strlen(name), ": ", 2) == 0) {
        doc += strlen(name) + 2; /* the page says it itself */
        length -= strlen(name) + 2;
    }
    fputs(".TH ", out);
    put_name(name, true, out);
    fputs(" 1 \"\" \"glint " GLINT_VERSION_STRING "\" \"User Commands\"\n.SH NAME\n", out);
    put_name(name, false, out);
    fputs(" \\- ", out);
    put_text(doc, options_sentence(doc, length), out);
    fprintf(out, "\n.SH SYNOPSIS\n\\fB%s\\fR ", name);
    const char *args = argp->args_doc ? argp->args_doc : "";
    fprintf(out, "%s%s\n", strstr(args, "OPTION") ? "" : "[OPTION...] ", args);
    fputs(".SH DESCRIPTION\n", out);
    put_text(doc, length, out);
    fputc('\n', out);
    put_options(root, out);
    put_filtered(root, ARGP_KEY_HELP_POST_DOC, more ? more + 1 : NULL, put_paragraphs, out);
    fputs(".SH \"EXIT STATUS\"\n0 good, 1 failed, 2 wrong usage\n.SH \"SEE ALSO\"\n", out);
    fputs(strchr(name, ' ') ? "\\fBglint\\fR(1)\n" : "\\fBglint\\-\\fICOMMAND\\fR(1) for each command\n", out);
}

void manual_list_options(const struct argp *root, FILE *out)
{
    struct option_list list = {.count = 0};
    options_collect(root, &list);
    for (unsigned i = 0; i < list.count; i++) {
        const struct argp_option *option = list.options[i];
        if (option_is_heading(option) || option->flags & OPTION_HIDDEN)
            continue;
        const char *arg = option->arg ? option->arg : "", *text = option->doc ? option->doc : "";
        const int length = (int)options_sentence(text, strlen(text));
        if (has_letter(option))
            fprintf(out, "-%c%s%s\t%.*s\n", option->key, *arg ? "=" : "", arg, length, text);
        if (option->name)
            fprintf(out, "--%s%s%s\t%.*s\n", option->name, *arg ? "=" : "", arg, length, text);
    }
}
