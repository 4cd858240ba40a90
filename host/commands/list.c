/* SPDX-License-Identifier: MIT
 * glint list: what frames can be sent to. */
#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/argp.h"
#include "base/message.h"
#include "commands/commands.h"
#include "sinks/sinks.h"

enum key { KEY_JSON = 256 };

static const struct argp_option argp_options[] = {
    {"json", KEY_JSON, NULL, 0, "As JSON: an object with the sinks and, by the sink's name, an array of its devices",
     0},
    {NULL, 0, NULL, 0, NULL, 0}};

static const char doc[] =
    "Lists where `glint stream --to` can send frames, and which devices this computer has for it: "
    "USB displays, GPIO chips, SPI devices."
    "\v"
    "Examples:\n"
    "  glint list\n"
    "  glint list --json | jq -r '.sinks[].name'\n"
    "  glint list --json | jq -r '.usb[].serial'\n";

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    switch (key) {
    case KEY_JSON:
        *(bool *)state->input = true;
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; the list takes no names", text);
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* ---- as text ---- */

/* Each line of what a sink prints, indented. */
static void print_devices(const struct sink_kind *kind, const json_t *devices)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (!stream)
        fail("out of memory");
    kind->list_print(devices, stream);
    if (fclose(stream) != 0)
        fail("out of memory");
    for (char *rest = text, *line; (line = strsep(&rest, "\n")) && (*line || rest);)
        printf("  %s\n", line);
    free(text);
}

static void print_text(const json_t *all)
{
    for (unsigned i = 0; sink_kinds[i]; i++) {
        const struct sink_kind *kind = sink_kinds[i];
        const json_t *devices = json_object_get(all, kind->name);
        printf("%-9s %s\n", kind->name, kind->summary);
        if (devices && json_array_size(devices))
            print_devices(kind, devices);
        else if (devices)
            puts("  no device found");
    }
    for (const struct sink_left_out *out = sinks_left_out; out->name; out++)
        printf("%-9s not in this build: install %s and build glint again\n", out->name, out->packages);
}

/* ---- as JSON ---- */

static const char *output_word(const struct sink_kind *kind)
{
    switch (kind->output) {
    case SINK_FILE_A_FRAME:
        return "a file a frame";
    case SINK_ONE_FILE:
        return "one file";
    case SINK_STANDARD_OUTPUT:
        return "standard output";
    case SINK_TERMINAL:
        return "terminal";
    case SINK_DEVICE:
        break;
    }
    return kind->list ? "device" : "none";
}

static json_t *sinks_json(void)
{
    json_t *sinks = json_array();
    for (unsigned i = 0; sink_kinds[i]; i++)
        json_array_append_new(sinks, json_pack("{s:s, s:s, s:s, s:b, s:b}", "name", sink_kinds[i]->name, "summary",
                                               sink_kinds[i]->summary, "output", output_word(sink_kinds[i]), "shades",
                                               sink_kinds[i]->shader != NULL, "built", 1));
    for (const struct sink_left_out *out = sinks_left_out; out->name; out++)
        json_array_append_new(sinks,
                              json_pack("{s:s, s:s, s:b}", "name", out->name, "needs", out->packages, "built", 0));
    return sinks;
}

int command_list(int argc, char **argv)
{
    static const struct argp argp = {argp_options, parse_option, NULL, doc, NULL, NULL, NULL};
    bool as_json = false;
    parse_command(&argp, 0, argc, argv, &as_json);
    json_t *all = json_object();
    json_object_set_new(all, "sinks", sinks_json());
    for (unsigned i = 0; sink_kinds[i]; i++) {
        json_t *devices = sink_kinds[i]->list ? sink_kinds[i]->list() : NULL;
        if (devices)
            json_object_set_new(all, sink_kinds[i]->name, devices);
    }
    errno = 0;
    if (as_json) {
        json_dumpf(all, stdout, JSON_INDENT(2));
        putchar('\n');
    } else {
        print_text(all);
    }
    json_decref(all);
    if (fflush(stdout) != 0 || ferror(stdout))
        fail("standard output: could not be written: %s", strerror(errno));
    return EXIT_GOOD;
}
