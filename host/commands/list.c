/* SPDX-License-Identifier: MIT
 * glint list: what frames can be sent to. */
#include <argp.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/argp.h"
#include "base/clock.h"
#include "base/text.h"
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

/* ---- what there is, in time ---- */

/* A device that does not answer may hold its sink, even in the kernel: so each sink looks for its devices in a process of its
 * own, and what comes later than LIST_S is not waited for. */
#define LIST_S 1.6

struct search {
    pid_t process;
    int from; /* its end of a pipe */
};

static struct search search_start(const struct sink_kind *kind)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        fail("glint list: no pipe: %s", strerror(errno));
    const pid_t process = fork();
    if (process < 0)
        fail("glint list: no process: %s", strerror(errno));
    if (process == 0) {
        json_t *devices = kind->list();
        _exit(json_dumpfd(devices, ends[1], 0) == 0 ? EXIT_GOOD : EXIT_FAILED);
    }
    close(ends[1]);
    return (struct search){process, ends[0]};
}

/* The devices; NULL where they did not come before `until`. */
static json_t *search_end(struct search search, double until)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (!stream)
        fail("out of memory");
    for (;;) {
        char part[4096];
        const double left = until - seconds_now();
        if (poll(&(struct pollfd){.fd = search.from, .events = POLLIN}, 1, left > 0 ? (int)(1e3 * left) : 0) <= 0)
            break;
        const ssize_t bytes = read(search.from, part, sizeof part);
        if (bytes <= 0)
            break;
        fwrite(part, 1, (size_t)bytes, stream);
    }
    if (fclose(stream) != 0)
        fail("out of memory");
    json_t *devices = json_loadb(text, size, 0, NULL); /* NULL where it is not whole */
    free(text);
    close(search.from);
    if (!devices)
        kill(search.process, SIGKILL); /* and is not waited for: the kernel may hold it */
    else
        waitpid(search.process, NULL, 0);
    return devices;
}

static json_t *search_all(void)
{
    struct search searches[SINKS_MAX];
    const double until = seconds_now() + LIST_S;
    json_t *all = json_object();
    for (unsigned i = 0; sink_kinds[i]; i++)
        if (sink_kinds[i]->list)
            searches[i] = search_start(sink_kinds[i]);
    for (unsigned i = 0; sink_kinds[i]; i++)
        if (sink_kinds[i]->list)
            json_object_set_new(all, sink_kinds[i]->name, search_end(searches[i], until));
    return all;
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
        printf("  %s\n", text_clean(line, false));
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
        else if (kind->list)
            puts(devices ? "  no device found" : "  no answer in time");
    }
    for (const struct sink_left_out *out = sinks_left_out; out->name; out++)
        printf("%-9s not in this build: install %s and build glint again\n", out->name, out->packages);
}

/* ---- as JSON ---- */

static const char *output_word(const struct sink_kind *kind)
{
    return kind->output ? kind->output->word : kind->list ? "device" : "none";
}

/* Those that have devices get their array, too, which is empty where the search was not answered in time. */
static json_t *sinks_json(json_t *all)
{
    json_t *sinks = json_array();
    for (unsigned i = 0; sink_kinds[i]; i++) {
        const struct sink_kind *kind = sink_kinds[i];
        json_t *sink = json_pack("{s:s, s:s, s:s, s:b, s:b}", "name", kind->name, "summary", kind->summary, "output",
                                 output_word(kind), "shades", kind->shader != NULL, "built", 1);
        if (kind->list && !json_object_get(all, kind->name)) {
            json_object_set_new(sink, "problem", json_string("no answer in time"));
            json_object_set_new(all, kind->name, json_array());
        }
        json_array_append_new(sinks, sink);
    }
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
    json_t *all = search_all();
    json_object_set_new(all, "sinks", sinks_json(all));
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
