/* SPDX-License-Identifier: MIT
 * glint page: the web page, served to browsers of this machine.
 *
 * A file is opened by any browser, but some give a page from a file less (links that can be shared, devices). One
 * connection at a time, one request each, from memory, on the loopback address alone. */
#include <arpa/inet.h>
#include <errno.h>
#include <limits.h>
#include <netinet/in.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/parse.h"
#include "commands/commands.h"

enum { KEY_PORT = 256, KEY_FILE };
enum { PORT_DEFAULT = 8016, REQUEST_MAX = 8192, WAIT_SECONDS = 5, PAGE_MAX = 1 << 24 };

struct request {
    long port;
    const char *file;
};

static const struct argp_option options[] = {
    {"port", KEY_PORT, "PORT", 0, "The port, 0..65535; 0: any that is free (default 8016)", 0},
    {"file", KEY_FILE, "FILE", 0, "The page (default: the installed one, or the one that `make page` built)", 0},
    {0}};

static const char doc[] =
    "Serves the page on which the library shades in a browser, to this machine alone, until it is stopped by Ctrl-C."
    "\v"
    "The page is one file and needs no server: build/page/index.html, which `make page` builds, opens in any browser, "
    "too. It sends nothing.\n"
    "\n"
    "Examples:\n"
    "  glint page\n"
    "  glint page --port 0\n";

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct request *request = state->input;
    switch (key) {
    case KEY_PORT:
        request->port = parse_integer(state, "--port", text, 0, 65535);
        return 0;
    case KEY_FILE:
        request->file = text;
        return 0;
    case ARGP_KEY_ARG:
        refuse(state, "unexpected argument '%s'; --file names a page", text);
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* ---- the file ---- */

struct page {
    char *bytes;
    size_t len;
};

static bool read_page(const char *path, struct page *page)
{
    FILE *stream = fopen(path, "rb");
    struct stat status;
    if (!stream)
        return false;
    if (fstat(fileno(stream), &status) != 0 || !S_ISREG(status.st_mode) || !status.st_size || status.st_size > PAGE_MAX)
        fail("%s: this is not a page; name the one that `make page` builds", path);
    page->len = (size_t)status.st_size;
    page->bytes = allocate(page->len, 1);
    if (fread(page->bytes, 1, page->len, stream) != page->len)
        fail("%s: could not be read: %s", path, strerror(errno));
    fclose(stream);
    return true;
}

/* Where make install puts it, and where make page builds it, both as seen from the command's own file. */
static void find_page(const char *path, struct page *page)
{
    static const char *const places[] = {"/../share/glint/page.html", "/../page/index.html"};
    if (path) {
        if (!read_page(path, page))
            fail("%s: %s", path, strerror(errno));
        return;
    }
    char own[PATH_MAX], *name;
    const ssize_t len = readlink("/proc/self/exe", own, sizeof own - 1);
    own[len > 0 ? len : 0] = '\0';
    char *slash = strrchr(own, '/');
    if (slash)
        *slash = '\0';
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        if (asprintf(&name, "%s%s", own, places[i]) < 0)
            fail("out of memory");
        const bool found = read_page(name, page);
        free(name);
        if (found)
            return;
    }
    fail("there is no page; build it with `make page`, or name it with --file");
}

/* ---- the server ---- */

static void send_all(int client, const char *bytes, size_t len)
{
    while (len) {
        const ssize_t sent = send(client, bytes, len, MSG_NOSIGNAL);
        if (sent <= 0)
            return; /* the browser went away */
        bytes += sent;
        len -= (size_t)sent;
    }
}

static void answer(int client, const char *status, const struct page *page, bool with_page)
{
    static const char nothing[] = "This server has one page: /\n";
    const bool good = status[0] == '2';
    const size_t len = good ? page->len : strlen(nothing);
    char head[256];
    const int head_len = snprintf(head, sizeof head,
                                  "HTTP/1.1 %s\r\nContent-Type: text/%s; charset=utf-8\r\nContent-Length: %zu\r\n"
                                  "Cache-Control: no-cache\r\nConnection: close\r\n\r\n",
                                  status, good ? "html" : "plain", len);
    send_all(client, head, (size_t)head_len);
    if (with_page)
        send_all(client, good ? page->bytes : nothing, len);
}

/* What follows the path, a query, does not matter. */
static bool asks_for(const char *line, const char *path)
{
    const size_t len = strlen(path);
    return strncmp(line, path, len) == 0 && (line[len] == ' ' || line[len] == '?');
}

static void serve(int client, const struct page *page)
{
    char text[REQUEST_MAX + 1];
    size_t len = 0;
    const struct timeval patience = {WAIT_SECONDS, 0};
    setsockopt(client, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    setsockopt(client, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    do {
        const ssize_t got = recv(client, text + len, REQUEST_MAX - len, 0);
        if (got <= 0)
            return; /* closed, or silent for too long */
        len += (size_t)got;
        text[len] = '\0';
    } while (!strstr(text, "\r\n\r\n") && len < REQUEST_MAX);
    const bool get = strncmp(text, "GET ", 4) == 0, head = strncmp(text, "HEAD ", 5) == 0;
    const char *path = text + (head ? 5 : 4);
    if (!get && !head)
        answer(client, "405 Method Not Allowed", page, true);
    else if (asks_for(path, "/") || asks_for(path, "/index.html"))
        answer(client, "200 OK", page, get);
    else
        answer(client, "404 Not Found", page, get);
}

static int listen_at(long port)
{
    struct sockaddr_in address = {
        .sin_family = AF_INET, .sin_port = htons((uint16_t)port), .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    socklen_t len = sizeof address;
    const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), yes = 1;
    if (listener < 0)
        fail("no socket: %s", strerror(errno));
    setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (bind(listener, (struct sockaddr *)&address, len) != 0 || listen(listener, 8) != 0)
        fail("port %ld: %s; choose another with --port, or --port 0", port, strerror(errno));
    if (getsockname(listener, (struct sockaddr *)&address, &len) != 0)
        fail("port %ld: %s", port, strerror(errno));
    printf("http://localhost:%u/ until Ctrl-C\n", ntohs(address.sin_port));
    if (fflush(stdout) != 0)
        fail("standard output: could not be written: %s", strerror(errno));
    return listener;
}

int command_page(int argc, char **argv)
{
    static const struct argp argp = {options, parse_option, NULL, doc, NULL, NULL, NULL};
    struct request request = {.port = PORT_DEFAULT};
    parse_command(&argp, 0, argc, argv, &request);
    struct page page;
    find_page(request.file, &page);
    const int listener = listen_at(request.port);
    for (;;) { /* a signal ends the program */
        const int client = accept4(listener, NULL, NULL, SOCK_CLOEXEC);
        if (client < 0 && errno != EINTR && errno != ECONNABORTED)
            fail("port %ld: %s", request.port, strerror(errno));
        if (client < 0)
            continue;
        serve(client, &page);
        close(client);
    }
}
