/* SPDX-License-Identifier: MIT
 * --to terminal, in a pseudoterminal. */
#include "files.h"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>

#include "base/clock.h"

#if GLINT_WITH_TERMINAL
#define SPHERE "$GLINT stream sphere --size 60x40 --to png "
#define COIN "exec $GLINT stream coin --size 40x30 --to terminal "
#define HIDDEN "\033[?25l"
#define BACK "\033[?25h"
#define MARK "\001" /* the test writes it to the terminal: what the program wrote before stands before it */

static struct {
    int screen, line; /* the terminal's ends: the test's, and the program's */
    pid_t child;
    char shown[1 << 25];
    size_t len;
} terminal;

static const struct winsize usual_size = {.ws_row = 24, .ws_col = 60};

/* A command of the shell's, in a group of processes of its own, as a job: it can be stopped. */
static void start(const char *command, const struct winsize *size)
{
    terminal.shown[terminal.len = 0] = '\0';
    terminal.screen = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    assert_true(terminal.screen >= 0 && grantpt(terminal.screen) == 0 && unlockpt(terminal.screen) == 0);
    const char *name = ptsname(terminal.screen);
    terminal.line = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    assert_int_equal(ioctl(terminal.line, TIOCSWINSZ, size), 0);
    terminal.child = fork();
    assert_true(terminal.child >= 0);
    if (terminal.child == 0) {
        for (int number = 1; number < SIGRTMIN; number++)
            signal(number, SIG_DFL); /* the caller may have it ignored */
        setenv("TERM", "xterm-256color", 1);
        const int out = open(name, O_RDWR | O_NOCTTY);
        if (setpgid(0, 0) != 0 || dup2(out, STDOUT_FILENO) < 0 || !freopen("said", "w", stderr))
            _exit(126);
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
}

static void read_some(void)
{
    const size_t room = sizeof terminal.shown - 1 - terminal.len;
    const ssize_t count = read(terminal.screen, terminal.shown + terminal.len, room);
    assert_true(count > 0);
    terminal.shown[terminal.len += (size_t)count] = '\0';
}

/* Waits until the text is shown after the first `from` bytes; where. A program that ends without it fails the test. */
static const char *shows(size_t from, const char *text)
{
    const char *at;
    bool is_last = false; /* the mark stands behind all that the program wrote */
    while (!(at = strstr(terminal.shown + from, text))) {
        siginfo_t gone = {0};
        if (is_last && strstr(terminal.shown + from, MARK))
            fail_msg("it ended without '%s': %s", text + 1, run("cat said")->out);
        if (!is_last && waitid(P_PID, (id_t)terminal.child, &gone, WEXITED | WNOHANG | WNOWAIT) == 0 && gone.si_pid)
            is_last = write(terminal.line, MARK, 1) == 1;
        if (poll(&(struct pollfd){.fd = terminal.screen, .events = POLLIN}, 1, 10) > 0)
            read_some();
    }
    return at;
}

/* Waits until the child is stopped or has ended, and all that it wrote is shown; its status. */
static int changes(void)
{
    int status;
    while (waitpid(terminal.child, &status, WUNTRACED | WNOHANG) == 0)
        if (poll(&(struct pollfd){.fd = terminal.screen, .events = POLLIN}, 1, 10) > 0)
            read_some();
    const size_t before = terminal.len;
    while (write(terminal.line, MARK, 1) != 1) /* there is no room */
        read_some();
    shows(before, MARK);
    return status;
}

/* Waits for the end; the exit status, -1: a signal's. */
static int ends(void)
{
    const int status = changes();
    close(terminal.line);
    close(terminal.screen);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static int ran(const char *command)
{
    start(command, &usual_size);
    return ends();
}

static void the_terminal_shows_it_and_gets_its_cursor_back(void **state)
{
    (void)state;
    assert_fails(SPHERE "--to terminal", "standard output is not a terminal");
    assert_int_equal(ran(COIN "--frames 2 --fps 0"), 0);
    assert_contains(terminal.shown, "\033[38;"); /* colours */
    assert_contains(shows(0, HIDDEN), BACK);
    assert_int_equal(ran("export NO_COLOR=1; " COIN "--frames 1"), 0);
    assert_null(strstr(terminal.shown, "\033[38;"));
    assert_contains(terminal.shown, BACK);
    assert_quiet("printf '1 1 1\\n1\\n' >lights.txt"); /* fails when it has begun */
    assert_int_equal(ran(COIN "--lights lights.txt"), 1);
    assert_contains(strstr(terminal.shown, HIDDEN), BACK);
    assert_quiet("grep -q 'line 2' said");
    assert_int_equal(ran(COIN "--frames 4 --fps 10 --json"), 0);
    assert_true(strtod(run("grep '\"seconds\"' said | tr -dc 0-9.")->out, NULL) >= .3); /* and as slow as the machine */
}

static void every_signal_that_ends_it_gives_the_terminal_its_cursor_back(void **state)
{
    (void)state;
    static const int signals[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGTERM,   SIGPIPE, SIGUSR1,
                                  SIGUSR2, SIGALRM, SIGPROF, SIGVTALRM, SIGXCPU, SIGXFSZ};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        start(COIN "--fps 4", &usual_size);
        shows(0, HIDDEN);
        assert_int_equal(kill(terminal.child, signals[i]), 0);
        assert_int_equal(ends(), 128 + signals[i]);
        assert_contains(strstr(terminal.shown, HIDDEN), BACK);
    }
}

static void a_stream_that_is_stopped_gives_the_cursor_back_and_takes_it_when_it_goes_on(void **state)
{
    (void)state;
    start(COIN "--fps 4", &usual_size);
    shows(0, HIDDEN);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(kill(terminal.child, SIGTSTP), 0);
        assert_true(WIFSTOPPED(changes()));
        const char *hidden = terminal.shown, *next;
        while ((next = strstr(hidden + 1, HIDDEN))) /* the last */
            hidden = next;
        assert_contains(hidden, BACK);
        const size_t stopped = terminal.len;
        assert_int_equal(kill(terminal.child, SIGCONT), 0);
        shows(stopped, HIDDEN);
    }
    assert_int_equal(kill(terminal.child, SIGTERM), 0);
    assert_int_equal(ends(), 128 + SIGTERM);
    assert_contains(strrchr(terminal.shown, 'l'), BACK);
}

/* By Ctrl-S: it takes nothing, not even the cursor. The first signal asks, and where nobody reads the stream ends all the same; so it
 * does at once where the second one comes meanwhile. */
static void a_terminal_that_is_held_up_does_not_keep_the_stream_from_ending(void **state)
{
    (void)state;
    for (int signals = 1; signals <= 2; signals++) {
        siginfo_t gone;
        start(COIN "--fps 4", &usual_size);
        shows(0, HIDDEN);
        assert_int_equal(tcflow(terminal.line, TCOOFF), 0);
        assert_int_equal(kill(terminal.child, SIGTERM), 0);
        if (signals == 2) {
            usleep(600000);
            kill(terminal.child, SIGINT);
        }
        assert_int_equal(waitid(P_PID, (id_t)terminal.child, &gone, WEXITED | WNOWAIT), 0);
        assert_int_equal(tcflow(terminal.line, TCOON), 0);
        const int status = ends();
        assert_true(signals == 1 ? status == 128 + SIGTERM
                                 : status == -1 || status == 128 + SIGTERM || status == 128 + SIGINT);
    }
}

/* What it runs beside the stop is never less than its frames take, on any machine. */
static void a_stream_that_stood_still_goes_on_at_its_pace(void **state)
{
    (void)state;
    const double began = seconds_now();
    start(COIN "--fps 10 --frames 30", &usual_size);
    shows(0, HIDDEN);
    assert_int_equal(kill(terminal.child, SIGSTOP), 0);
    assert_true(WIFSTOPPED(changes()));
    const double stopped = seconds_now();
    sleep(4); /* in which all frames were due */
    const double went_on = seconds_now();
    assert_int_equal(kill(terminal.child, SIGCONT), 0);
    assert_int_equal(ends(), 0);
    assert_true(stopped - began + seconds_now() - went_on >= 2.8);
}

/* Another thread would write the cursor while the first writes a frame. */
static void the_first_thread_alone_takes_signals(void **state)
{
    (void)state;
    start(COIN "--fps 4", &usual_size);
    shows(0, HIDDEN);
    assert_int_equal(kill(terminal.child, SIGSTOP), 0);
    assert_true(WIFSTOPPED(changes()));
    char path[300];
    snprintf(path, sizeof path, "/proc/%d/task", terminal.child);
    DIR *tasks = opendir(path);
    assert_non_null(tasks);
    for (const struct dirent *task; (task = readdir(tasks));) {
        if (*task->d_name == '.' || atol(task->d_name) == terminal.child)
            continue;
        char status[8192];
        snprintf(path, sizeof path, "/proc/%d/task/%s/status", terminal.child, task->d_name);
        read_text(path, status, sizeof status);
        const char *blocked = strstr(status, "SigBlk:");
        assert_non_null(blocked);
        static const int signals[] = {SIGTSTP, SIGCONT, SIGTERM, SIGINT, SIGHUP};
        for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
            if (!(strtoull(blocked + strlen("SigBlk:"), NULL, 16) >> (signals[i] - 1) & 1))
                fail_msg("%.40s takes %s", status, strsignal(signals[i]));
    }
    closedir(tasks);
    assert_int_equal(kill(terminal.child, SIGTERM), 0);
    assert_int_equal(kill(terminal.child, SIGCONT), 0);
    assert_int_equal(ends(), 128 + SIGTERM);
}

/* A frame in a terminal of this size: exit 0 and not a word on standard error. */
static void assert_shown(unsigned short rows, unsigned short columns, unsigned short width, unsigned short height)
{
    char said[8192];
    start("exec $GLINT stream coin --to terminal --frames 1",
          &(struct winsize){.ws_row = rows, .ws_col = columns, .ws_xpixel = width, .ws_ypixel = height});
    const int status = ends();
    read_text("said", said, sizeof said);
    if (status != 0 || *said)
        fail_msg("%u rows, %u columns, %u x %u pixels: status %d, %s", rows, columns, width, height, status, said);
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

static void the_picture_is_of_the_kind_and_colours_that_the_terminal_has(void **state)
{
    (void)state;
    static const char *const kinds[][2] = {
        {"xterm-kitty", "\033_Ga=T,f=32"}, {"mlterm", "\033P0;1;0q"}, {"screen", "\033[38;5;"}, {"linux", "\033[30m"}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        char line[200];
        snprintf(line, sizeof line, "unset COLORTERM TERM_PROGRAM; export TERM=%s; " COIN "--frames 1", kinds[i][0]);
        assert_int_equal(ran(line), 0);
        assert_contains(terminal.shown, kinds[i][1]);
        assert_contains(terminal.shown, BACK);
    }
}

static void a_terminal_that_gets_another_size_is_cleared_and_filled(void **state)
{
    (void)state;
    start(COIN "--fps 4", &usual_size);
    shows(0, HIDDEN);
    const size_t before = terminal.len;
    assert_int_equal(ioctl(terminal.line, TIOCSWINSZ, &(struct winsize){.ws_row = 12, .ws_col = 30}), 0);
    shows(before, HIDDEN "\033[2J");
    assert_int_equal(kill(terminal.child, SIGTERM), 0);
    assert_int_equal(ends(), 128 + SIGTERM);
}

static void what_is_no_text_is_not_written_to_a_terminal(void **state)
{
    (void)state;
    assert_int_equal(ran("$GLINT stream coin --to y4m -o - --frames 1"), 2);
    assert_quiet("grep -q -e '--to y4m: standard output is a terminal; pipe or redirect it' said");
    assert_int_equal(ran("$GLINT table --raw"), 2);
    assert_quiet("grep -q -e '--raw: standard output is a terminal; pipe or redirect it' said");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_picture_is_of_the_kind_and_colours_that_the_terminal_has),
        cmocka_unit_test(a_terminal_that_gets_another_size_is_cleared_and_filled),
        cmocka_unit_test(what_is_no_text_is_not_written_to_a_terminal),
        cmocka_unit_test(the_terminal_shows_it_and_gets_its_cursor_back),
        cmocka_unit_test(every_signal_that_ends_it_gives_the_terminal_its_cursor_back),
        cmocka_unit_test(a_terminal_may_state_any_size),
        cmocka_unit_test(a_terminal_that_is_held_up_does_not_keep_the_stream_from_ending),
        cmocka_unit_test(a_stream_that_stood_still_goes_on_at_its_pace),
        cmocka_unit_test(the_first_thread_alone_takes_signals),
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
