/* SPDX-License-Identifier: MIT
 * glint page: the web page, served to browsers of this machine.
 *
 * A file is opened by any browser, but some give a page from a file less (links that can be shared, devices). A
 * connection has one request, which is answered from memory, on the loopback address alone. */
#include <arpa/inet.h>
#include <errno.h>
#include <limits.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/argp.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/parse.h"
#include "commands/commands.h"

enum { KEY_PORT = 256, KEY_FILE };
enum { PORT_DEFAULT = 8016, REQUEST_LINE = 1024, REQUEST_MAX = 1 << 20, CLIENTS_MAX = 16, WAIT_SECONDS = 10 };
enum { PAGE_MAX = 1 << 24 };

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
    struct stat status;
    if (stat(path, &status) != 0)
        return false;
    if (!S_ISREG(status.st_mode) || !status.st_size || status.st_size > PAGE_MAX) /* a pipe would be waited for */
        fail("%s: this is not a page; name the one that `make page` builds", path);
    FILE *stream = fopen(path, "rb");
    if (!stream)
        fail("%s: %s", path, strerror(errno));
    page->len = (size_t)status.st_size;
    page->bytes = allocate(page->len, 1);
    if (fread(page->bytes, 1, page->len, stream) != page->len)
        fail("%s: could not be read: %s", path, ferror(stream) ? strerror(errno) : "it became shorter");
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
    char own[PATH_MAX];
    const ssize_t len = readlink("/proc/self/exe", own, sizeof own - 1);
    own[len > 0 ? len : 0] = '\0';
    char *slash = strrchr(own, '/');
    if (slash)
        *slash = '\0';
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        char *name = formatted("%s%s", own, places[i]);
        const bool found = read_page(name, page);
        free(name);
        if (found)
            return;
    }
    fail("there is no page; build it with `make page`, or name it with --file");
}

/* ---- the server ---- */

/* A browser's connection: its request is read to the end, then the answer is sent. Browsers open some ahead of need, which
 * say nothing for long: so several are served at once. */
struct client {
    int socket;
    double end; /* of its time: it is closed when nothing was sent or taken until then */
    char line[REQUEST_LINE];
    size_t line_len, request_len;
    unsigned newlines; /* one after the other at the request's end: two end it */
    char head[256];
    const char *body;
    size_t head_len, body_len, sent;
};

/* What follows the path, a query, does not matter. */
static bool asks_for(const char *line, const char *path)
{
    const size_t len = strlen(path);
    return strncmp(line, path, len) == 0 && (line[len] == ' ' || line[len] == '?');
}

static void answer(struct client *client, const struct page *page)
{
    static const char nothing[] = "This server has one page: /\n";
    const bool get = strncmp(client->line, "GET ", 4) == 0, head = strncmp(client->line, "HEAD ", 5) == 0;
    const char *path = client->line + (head ? 5 : 4), *status = "404 Not Found";
    if (!get && !head)
        status = "405 Method Not Allowed";
    else if (asks_for(path, "/") || asks_for(path, "/index.html"))
        status = "200 OK";
    const bool good = status[0] == '2';
    const size_t len = good ? page->len : strlen(nothing);
    client->body = good ? page->bytes : nothing;
    client->body_len = head ? 0 : len;
    client->head_len = (size_t)snprintf(client->head, sizeof client->head,
                                        "HTTP/1.1 %s\r\nContent-Type: text/%s; charset=utf-8\r\nContent-Length: %zu\r\n"
                                        "Cache-Control: no-cache\r\nConnection: close\r\n\r\n",
                                        status, good ? "html" : "plain", len);
}

/* Of the request the line counts; what follows it is read, and may be long: cookies of other servers on this machine. */
static bool read_some(struct client *client, const struct page *page)
{
    char bytes[4096];
    const ssize_t got = recv(client->socket, bytes, sizeof bytes, MSG_DONTWAIT);
    if (got < 0)
        return errno == EAGAIN || errno == EINTR;
    client->request_len += (size_t)got;
    for (ssize_t i = 0; i < got && client->newlines < 2; i++) {
        if (client->line_len < REQUEST_LINE - 1)
            client->line[client->line_len++] = bytes[i];
        if (bytes[i] == '\n')
            client->newlines++;
        else if (bytes[i] != '\r')
            client->newlines = 0;
    }
    if (client->newlines == 2)
        answer(client, page);
    return got > 0 && client->request_len <= REQUEST_MAX;
}

static bool send_some(struct client *client)
{
    const bool in_head = client->sent < client->head_len;
    const size_t at = in_head ? client->sent : client->sent - client->head_len;
    const ssize_t sent = send(client->socket, (in_head ? client->head : client->body) + at,
                              (in_head ? client->head_len : client->body_len) - at, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0)
        return errno == EAGAIN || errno == EINTR;
    client->sent += (size_t)sent;
    client->end = seconds_now() + WAIT_SECONDS;
    return client->sent < client->head_len + client->body_len;
}

static void hang_up(struct client *client)
{
    close(client->socket);
    client->socket = -1;
}

/* The connection that has been silent for longest; NULL: there is none. */
static struct client *quietest(struct client *clients)
{
    struct client *found = NULL;
    for (int i = 0; i < CLIENTS_MAX; i++)
        if (clients[i].socket >= 0 && (!found || clients[i].end < found->end))
            found = &clients[i];
    return found;
}

/* Where all places are taken, or the system has no more, the quietest makes room; without a place the next call accepts. */
static void greet(struct client *clients, int listener)
{
    struct client *place = clients, *const quiet = quietest(clients);
    const int socket = accept4(listener, NULL, NULL, SOCK_CLOEXEC);
    const bool has_none = socket < 0 && (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM);
    if (socket < 0 && !(has_none && quiet) && errno != EINTR && errno != ECONNABORTED && errno != EAGAIN)
        fail("no connection: %s", strerror(errno));
    while (place < &clients[CLIENTS_MAX] && place->socket >= 0)
        place++;
    if (has_none || (socket >= 0 && place == &clients[CLIENTS_MAX])) {
        hang_up(quiet);
        place = quiet;
    }
    if (socket >= 0)
        *place = (struct client){.socket = socket, .end = seconds_now() + WAIT_SECONDS};
}

/* Waits for what comes next, and does it. No more is waited for than is open: poll takes no more than may be. */
static void serve(int listener, struct client *clients, const struct page *page)
{
    struct pollfd waits[CLIENTS_MAX + 1] = {{listener, POLLIN, 0}};
    struct client *of[CLIENTS_MAX + 1];
    nfds_t count = 1;
    double end = seconds_now() + 3600;
    for (struct client *client = clients; client < &clients[CLIENTS_MAX]; client++) {
        if (client->socket < 0)
            continue;
        waits[count] = (struct pollfd){client->socket, client->head_len ? POLLOUT : POLLIN, 0};
        of[count++] = client;
        if (client->end < end)
            end = client->end;
    }
    const double left = end - seconds_now();
    if (poll(waits, count, left > 0 ? (int)(1000 * left) + 1 : 0) < 0) {
        if (errno != EINTR)
            fail("no connection: %s", strerror(errno));
        return;
    }
    for (nfds_t i = 1; i < count; i++) {
        struct client *client = of[i];
        bool stays = client->end > seconds_now();
        if (waits[i].revents)
            stays = client->head_len ? send_some(client) : read_some(client, page);
        if (!stays)
            hang_up(client);
    }
    if (waits[0].revents)
        greet(clients, listener);
}

static int listen_at(long port)
{
    struct sockaddr_in address = {
        .sin_family = AF_INET, .sin_port = htons((uint16_t)port), .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    socklen_t len = sizeof address;
    const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0), yes = 1;
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
    struct client clients[CLIENTS_MAX];
    for (int i = 0; i < CLIENTS_MAX; i++)
        clients[i] = (struct client){.socket = -1};
    for (;;) /* a signal ends the program */
        serve(listener, clients, &page);
}
