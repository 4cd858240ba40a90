/* SPDX-License-Identifier: MIT
 * glint page as a server: what browsers ask, and connections that say nothing. */
#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdbool.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include "base/clock.h"
#include "commands/commands.h"
#include "files.h"

enum { PAGE_LEN = 300000 }; /* more than a socket holds */

/* Takes the place of the host's, which closes what says nothing for 10 s: on a machine that stands still, everything. Here time only tells
 * what came first. */
double seconds_now(void)
{
    static double now;
    return now += 1e-6;
}

static pid_t server;
static uint16_t port;

static int server_start(void **state)
{
    if (scratch_make(state) != 0)
        return -1;
    FILE *page = fopen("page.html", "w");
    int ends[2];
    if (!page || fprintf(page, "<html>%*s", PAGE_LEN - 6, "</html>") != PAGE_LEN || fclose(page) != 0 ||
        pipe(ends) != 0)
        return -1;
    server = fork();
    if (server == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL); /* where the test was killed */
        dup2(ends[1], STDOUT_FILENO);
        static char *words[] = {"glint page", "--port", "0", "--file", "page.html", NULL};
        _exit(command_page(5, words));
    }
    close(ends[1]);
    FILE *out = fdopen(ends[0], "r");
    const int found = fscanf(out, "http://localhost:%hu/", &port);
    fclose(out);
    return found == 1 ? 0 : -1;
}

static int server_stop(void **state)
{
    int status;
    kill(server, SIGTERM);
    const bool ended = waitpid(server, &status, 0) == server && WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM;
    return scratch_remove(state) == 0 && ended ? 0 : -1;
}

static int connected(void)
{
    const struct sockaddr_in address = {
        .sin_family = AF_INET, .sin_port = htons(port), .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    const int client = socket(AF_INET, SOCK_STREAM, 0);
    assert_true(client >= 0);
    assert_int_equal(connect(client, (const struct sockaddr *)&address, sizeof address), 0);
    return client;
}

static void say(int client, const char *text)
{
    assert_int_equal(send(client, text, strlen(text), MSG_NOSIGNAL), strlen(text));
}

/* All that comes until the server closes. */
static const char *heard(int client)
{
    static char text[PAGE_LEN + 1000];
    size_t len = 0;
    ssize_t got;
    while ((got = recv(client, text + len, sizeof text - 1 - len, 0)) > 0)
        len += (size_t)got;
    text[len] = '\0';
    close(client);
    return text;
}

static void assert_page(int client)
{
    const char *text = heard(client), *body = strstr(text, "\r\n\r\n");
    assert_memory_equal(text, "HTTP/1.1 200 OK\r\n", 17);
    assert_contains(text, "Content-Length: 300000\r\n");
    assert_non_null(body);
    assert_int_equal(strlen(body + 4), PAGE_LEN);
}

static const char *asked(const char *request)
{
    const int client = connected();
    say(client, request);
    return heard(client);
}

static void requests_get_the_page_or_a_status(void **state)
{
    (void)state;
    static const char *const good[] = {"GET / HTTP/1.1\r\n\r\n", "GET /index.html?light=1,0,1 HTTP/1.1\r\nA: b\r\n\r\n",
                                       "GET / HTTP/1.0\n\n"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        const int client = connected();
        say(client, good[i]);
        assert_page(client);
    }
    assert_contains(asked("GET /../page.html HTTP/1.1\r\n\r\n"), "HTTP/1.1 404 Not Found\r\n");
    assert_contains(asked("GET /index HTTP/1.1\r\n\r\n"), "\r\n\r\nThis server has one page: /\n");
    assert_contains(asked("POST / HTTP/1.1\r\n\r\n"), "HTTP/1.1 405 Method Not Allowed\r\n");
    assert_contains(asked("\n\n"), "HTTP/1.1 405 ");
    const char *head = asked("HEAD / HTTP/1.1\r\n\r\n");
    assert_contains(head, "HTTP/1.1 200 OK\r\n");
    assert_string_equal(strstr(head, "\r\n\r\n"), "\r\n\r\n");
}

/* Cookies of every server on this machine come with a request to any of them. */
static void a_request_with_long_headers_gets_the_page(void **state)
{
    (void)state;
    char line[4100];
    memset(line, 'c', sizeof line);
    memcpy(line, "Cookie: ", 8);
    strcpy(&line[4096], "\r\n");
    const int client = connected();
    say(client, "GET / HTTP/1.1\r\n");
    for (int i = 0; i < 8; i++)
        say(client, line);
    say(client, "\r\n");
    assert_page(client);
}

/* A browser may open a connection before it has anything to ask. It must not delay the others. */
static void connections_that_say_nothing_hold_nobody_up(void **state)
{
    (void)state;
    const int silent = connected(), slow = connected(), deaf = connected(), quick = connected();
    say(slow, "GET / HT");
    say(deaf, "GET / HTTP/1.1\r\n\r\n"); /* and does not read yet */
    say(quick, "GET / HTTP/1.1\r\n\r\n");
    assert_page(quick);
    say(slow, "TP/1.1\r\n\r\n"); /* each is still served */
    assert_page(slow);
    assert_page(deaf);
    say(silent, "GET / HTTP/1.1\r\n\r\n");
    assert_page(silent);
}

static void however_many_say_nothing_the_next_gets_the_page(void **state)
{
    (void)state;
    int silent[40];
    for (int i = 0; i < 40; i++)
        silent[i] = connected();
    const int client = connected();
    say(client, "GET / HTTP/1.1\r\n\r\n");
    assert_page(client);
    for (int i = 0; i < 40; i++)
        close(silent[i]);
}

static void a_server_without_room_for_files_serves_on(void **state)
{
    (void)state;
    struct rlimit usual, few;
    assert_int_equal(prlimit(server, RLIMIT_NOFILE, NULL, &usual), 0);
    few = usual;
    few.rlim_cur = 0;
    for (int left = 4; left > 0; few.rlim_cur++) { /* numbers that the server does not use */
        char path[64];
        snprintf(path, sizeof path, "/proc/%d/fd/%d", (int)server, (int)few.rlim_cur);
        left -= !exists(path);
    }
    assert_int_equal(prlimit(server, RLIMIT_NOFILE, &few, NULL), 0);
    however_many_say_nothing_the_next_gets_the_page(state);
    assert_int_equal(prlimit(server, RLIMIT_NOFILE, &usual, NULL), 0);
}

static void the_page_is_found_from_where_the_command_is_or_what_to_do_is_said(void **state)
{
    (void)state;
    assert_quiet("mkdir -p own/bin own/share/glint && cp \"$(readlink -f \"$GLINT\")\" own/bin/glint");
    assert_fails("own/bin/glint page --port 0", "there is no page; build it with `make page`, or name it with --file");
    static const char *const places[] = {"own/share/glint/page.html", "own/page/index.html"};
    for (int i = 0; i < 2; i++) { /* of make install, and of make page */
        char line[400];
        snprintf(line, sizeof line,
                 "rm -rf own/share own/page ends; mkdir -p \"$(dirname %s)\"; echo '<html></html>' >%s; mkfifo ends; "
                 "own/bin/glint page --port 0 >ends & read -r url <ends; kill $!; wait; echo \"$url\"",
                 places[i], places[i]);
        assert_contains(run(line)->out, "http://localhost:");
    }
}

static void what_is_no_page_or_no_port_is_said(void **state)
{
    (void)state;
    char line[200];
    assert_refused("$GLINT page own.html", "unexpected argument 'own.html'; --file names a page");
    assert_fails("$GLINT page --port 0 --file nowhere.html", "nowhere.html: No such file or directory");
    assert_fails("$GLINT page --port 0 --file .", ".: this is not a page; name the one that `make page` builds");
    snprintf(line, sizeof line, "$GLINT page --file page.html --port %u", port);
    assert_fails(line, "Address already in use; choose another with --port, or --port 0");
    assert_fails("$GLINT page --file page.html --port 0 >/dev/full", "standard output: could not be written");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(requests_get_the_page_or_a_status),
        cmocka_unit_test(a_request_with_long_headers_gets_the_page),
        cmocka_unit_test(connections_that_say_nothing_hold_nobody_up),
        cmocka_unit_test(however_many_say_nothing_the_next_gets_the_page),
        cmocka_unit_test(a_server_without_room_for_files_serves_on),
        cmocka_unit_test(the_page_is_found_from_where_the_command_is_or_what_to_do_is_said),
        cmocka_unit_test(what_is_no_page_or_no_port_is_said),
    };
    return cmocka_run_group_tests_name("page", tests, server_start, server_stop);
}
