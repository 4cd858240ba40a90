/* SPDX-License-Identifier: MIT
 * glint list: what frames can be sent to. */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/argp.h"
#include "base/message.h"
#include "commands/commands.h"
#include "sinks/sink.h"

enum key { KEY_JSON = 256 };

static const struct argp_option argp_options[] = {
    {"json", KEY_JSON, NULL, 0, "As JSON: an object with an array for each kind of sink", 0},
    {NULL, 0, NULL, 0, NULL, 0}};

static const char doc[] = "Lists what this computer has for `glint stream` to send frames to: USB displays, GPIO "
                          "chips, SPI devices, as far as "
                          "this glint was built for them (`glint --version` tells)."
                          "\v"
                          "Examples:\n"
                          "  glint list\n"
                          "  glint list --json | jq -r '.usb[].serial'\n";

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    switch (key) {
    case KEY_JSON:
        *(bool *)state->input = true;
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "'%s' is not an option; the list takes no names", text);
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_text(const json_t *all)
{
    size_t kinds = 0;
    for (unsigned i = 0; sink_kinds[i]; i++) {
        const struct sink_kind *kind = sink_kinds[i];
        const json_t *devices = json_object_get(all, kind->name);
        if (!devices)
            continue;
        kinds++;
        printf("%s:", kind->name);
        if (json_array_size(devices)) {
            putchar('\n');
            kind->list_print(devices, stdout);
        } else {
            puts(" nothing is there");
        }
    }
    if (!kinds)
        puts("nothing: this glint was built without sinks for devices (`glint stream --help` tells what they need)");
}

int command_list(int argc, char **argv)
{
    static const struct argp argp = {argp_options, parse_option, NULL, doc, NULL, NULL, NULL};
    bool as_json = false;
    parse_command(&argp, 0, argc, argv, &as_json);
    json_t *all = json_object();
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
