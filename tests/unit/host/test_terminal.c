/* SPDX-License-Identifier: MIT
 * --to terminal, in a terminal of script(1)'s. */
#include "files.h"

#include <fcntl.h>
#include <sys/ioctl.h>

#if GLINT_WITH_TERMINAL
#define SPHERE "$GLINT stream sphere --size 60x40 --to png "
#define COIN "$GLINT stream coin --size 40x30 --to terminal "
#define IN_TERMINAL(command) "TERM=xterm-256color script -qec \"stty rows 24 cols 60; " command "\" typed >/dev/null"

static void the_terminal_shows_it_and_gets_its_cursor_back(void **state)
{
    (void)state;
    static char typed[1 << 20];
    assert_fails(SPHERE "--to terminal", "standard output is not a terminal");
    if (run("command -v script")->status != 0)
        skip();
    assert_int_equal(run(IN_TERMINAL(COIN "--frames 2 --fps 0"))->status, 0);
    read_text("typed", typed, sizeof typed);
    assert_contains(typed, "\033[?25l");
    assert_contains(typed, "\033[38;"); /* colours */
    assert_contains(strstr(typed, "\033[?25l"), "\033[?25h");
    assert_int_equal(run("export NO_COLOR=1; " IN_TERMINAL(COIN "--frames 1"))->status, 0);
    read_text("typed", typed, sizeof typed);
    assert_null(strstr(typed, "\033[38;"));
    assert_contains(typed, "\033[?25h");
    assert_quiet("printf '1 1 1\\n1\\n' >lights.txt"); /* fails when it has begun */
    assert_int_equal(run(IN_TERMINAL(COIN "--lights lights.txt"))->status, 1);
    read_text("typed", typed, sizeof typed);
    assert_contains(strstr(typed, "\033[?25l"), "\033[?25h");
    assert_contains(typed, "line 2");
    const struct run *paced = run(IN_TERMINAL(COIN "--frames 4 --fps 10 --json 2>paced"));
    assert_int_equal(paced->status, 0);
    assert_true(strtod(run("grep '\"seconds\"' paced | tr -dc 0-9.")->out, NULL) >=
                .3); /* and as slow as the machine */
    assert_int_equal(run(IN_TERMINAL("timeout --foreground -s INT 1 " COIN "--fps 4; test \\$? = 124"))->status, 0);
    read_text("typed", typed, sizeof typed);
    assert_contains(typed, "\033[?25h");
}

static void every_signal_that_ends_it_gives_the_terminal_its_cursor_back(void **state)
{
    (void)state;
    static char typed[1 << 20];
    static const char *const signals[] = {"HUP",  "QUIT", "TERM",   "PIPE", "USR1", "USR2",
                                          "ALRM", "PROF", "VTALRM", "XCPU", "XFSZ"};
    if (run("command -v script")->status != 0)
        skip();
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        char line[700]; /* 25[l]: typed begins with this command, which must not match itself */
        snprintf(line, sizeof line,
                 "rm -f typed; TERM=xterm-256color script -fqec \"stty rows 24 cols 60; env --default-signal=%s " COIN
                 "--fps 4 & "
                 "for i in \\$(seq 200); do grep -q 25[l] typed && break; sleep .05; done; kill -%s \\$!; wait \\$!; "
                 "echo ended \\$?\" typed >/dev/null",
                 signals[i], signals[i]);
        assert_int_equal(run(line)->status, 0);
        read_text("typed", typed, sizeof typed);
        assert_contains(typed, "\033[?25l");
        assert_contains(strstr(typed, "\033[?25l"), "\033[?25h");
        assert_contains(typed, "ended 1"); /* 128 and the signal's number */
    }
}

static void a_stream_that_is_stopped_gives_the_cursor_back_and_takes_it_when_it_goes_on(void **state)
{
    (void)state;
    static char typed[1 << 20];
    if (run("command -v script")->status != 0)
        skip();
    const struct run *result =
        run("rm -f typed; cat >job <<'EOF'\n"
            "set -m\nstty rows 24 cols 60\n"
            "soon() { for i in $(seq 200); do eval \"$1\" && break; sleep .05; done; }\n" COIN "--fps 4 &\n"
            "soon 'grep -q 25l typed'\n"
            "kill -TSTP $!\nsoon 'grep -q \"T (stopped)\" /proc/$!/status'\necho STOPPED\n"
            "kill -CONT $!\nsoon '[ $(grep -c 25l typed) -gt 1 ] || sed 1,/STOPPED/d typed | grep -q 25l'\n"
            "kill -TERM $!\nwait $!\necho ended $?\nEOF\n"
            "TERM=xterm-256color script -fqec 'bash job' typed >/dev/null");
    assert_int_equal(result->status, 0);
    read_text("typed", typed, sizeof typed);
    const char *stopped = strstr(typed, "STOPPED");
    assert_non_null(stopped);
    char *before = strndup(typed, (size_t)(stopped - typed));
    assert_contains(strstr(before, "\033[?25l"), "\033[?25h");
    free(before);
    const char *hidden = strstr(stopped, "\033[?25l");
    assert_non_null(hidden);
    assert_contains(hidden, "\033[?25h");
    assert_contains(hidden, "ended 143");
}

/* A frame in a terminal of this size: exit 0 and not a word on standard error. */
static void assert_shown(unsigned short rows, unsigned short columns, unsigned short width, unsigned short height)
{
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    assert_true(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
    const int end = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    assert_int_equal(
        ioctl(end, TIOCSWINSZ,
              &(struct winsize){.ws_row = rows, .ws_col = columns, .ws_xpixel = width, .ws_ypixel = height}),
        0);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        setenv("TERM", "xterm-256color", 1);
        if (dup2(end, STDOUT_FILENO) < 0 || !freopen("said", "w", stderr))
            _exit(126);
        execl(getenv("GLINT"), "glint", "stream", "coin", "--to", "terminal", "--frames", "1", (char *)NULL);
        _exit(127);
    }
    close(end);
    static char shown[65536];
    while (read(terminal, shown, sizeof shown) > 0)
        ;
    close(terminal);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    read_text("said", shown, sizeof shown);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || *shown)
        fail_msg("%u rows, %u columns, %u x %u pixels: status %#x, %s", rows, columns, width, height, (unsigned)status,
                 shown);
}

static void a_terminal_may_state_any_size(void **state)
{
    (void)state;
    assert_shown(24, 80, 0, 0);
    assert_shown(24, 80, 1, 1);
    assert_shown(1, 1, 8, 16);
    assert_shown(1, 65535, 0, 0);
    assert_shown(65535, 1, 65535, 65535);
    assert_shown(40, 8192, 0, 0);
    assert_shown(65535, 65535, 65535, 65535);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_terminal_shows_it_and_gets_its_cursor_back),
        cmocka_unit_test(every_signal_that_ends_it_gives_the_terminal_its_cursor_back),
        cmocka_unit_test(a_terminal_may_state_any_size),
        cmocka_unit_test(a_stream_that_is_stopped_gives_the_cursor_back_and_takes_it_when_it_goes_on),
    };
    return cmocka_run_group_tests(tests, make_maps, scratch_remove);
}
#else
int main(void)
{
    puts("ok 1 - terminal # SKIP libchafa is not there");
    return 0;
}
#endif
