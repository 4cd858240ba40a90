/* SPDX-License-Identifier: MIT
 * The child processes in which libraries read files: they die with their parent, have limits, and their end is one line. */
#include "files.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include "base/clock.h"
#include "commands/commands.h"
#include "image/svg.h"
#include "mesh/import.h"

/* Takes the place of the host's: the machine stands still for a minute before each look. */
double seconds_now(void)
{
    static double now;
    return now += 60;
}

#if GLINT_WITH_MESH || GLINT_WITH_SVG
/* A glTF of 30 nodes, each of which has the next one twice: libassimp makes 2^30 of them. */
static void make_endless_mesh(const char *path)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0]}], \"nodes\": [");
    for (int i = 1; i < 30; i++)
        fprintf(file, "{\"children\": [%d, %d]}, ", i, i);
    fprintf(file, "{}]}\n");
    assert_int_equal(fclose(file), 0);
}

static void make_svg(const char *path, unsigned side, const char *drawing)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='%u' height='%u'>%s</svg>\n", side, side, drawing);
    assert_int_equal(fclose(file), 0);
}

static const char endless_drawing[] =
    "<filter id='f'><feTurbulence numOctaves='1000000000'/></filter><rect width='90' height='90' filter='url(#f)'/>";

/* The first child of a process, which has at most one; 0: the process ended without. */
static pid_t child_of(pid_t parent)
{
    char path[64];
    long child = 0;
    snprintf(path, sizeof path, "/proc/%d/task/%d/children", parent, parent);
    for (; child == 0; usleep(500)) {
        siginfo_t ended = {.si_pid = 0};
        FILE *file = fopen(path, "r");
        if (file && fscanf(file, "%ld", &child) != 1)
            child = 0;
        if (file)
            fclose(file);
        assert_int_equal(waitid(P_PID, (id_t)parent, &ended, WEXITED | WNOHANG | WNOWAIT), 0);
        if (ended.si_pid == parent)
            break;
    }
    return (pid_t)child;
}

static pid_t start(const char *command)
{
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    return pid;
}

/* Orphans become this process's children, so that it sees their end. A child that went on would stop at its limit, after 10 seconds of the
 * processor's time. */
static void assert_child_dies(const char *command, int signal, unsigned delay_us)
{
    int status;
    struct rusage usage;
    const pid_t parent = start(command), child = child_of(parent);
    assert_true(child > 0);
    usleep(delay_us);
    assert_int_equal(kill(parent, signal), 0);
    assert_int_equal(waitpid(parent, &status, 0), parent);
    assert_true(WIFSIGNALED(status) || WEXITSTATUS(status) == 128 + signal);
    assert_int_equal(wait4(child, &status, 0, &usage), child);
    if (usage.ru_utime.tv_sec + usage.ru_stime.tv_sec >= 8)
        fail_msg("%s: its child lived for long after signal %d", command, signal);
}

static void a_child_dies_with_its_parent(void **state)
{
    (void)state;
    static const int signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGKILL, SIGSEGV, SIGUSR1, SIGALRM};
    static const char *const commands[] = {
#if GLINT_WITH_MESH
        "exec $GLINT render --mesh endless.gltf -o no.png 2>/dev/null",
        "exec $GLINT stream --mesh endless.gltf --to none 2>/dev/null",
#endif
#if GLINT_WITH_SVG
        "exec $GLINT render --height endless.svg -o no.png 2>/dev/null",
        "exec $GLINT stream --height endless.svg --to none 2>/dev/null",
#endif
    };
    enum { COMMANDS = sizeof commands / sizeof *commands, SIGNALS = sizeof signals / sizeof *signals };
    assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0), 0);
    make_endless_mesh("endless.gltf");
    make_svg("endless.svg", 2000, endless_drawing);
    for (unsigned i = 0; i < 112; i++)
        assert_child_dies(commands[i % COMMANDS], signals[i / COMMANDS % SIGNALS], 997 * i % 40000);
    assert_true(waitpid(-1, NULL, WNOHANG) < 0); /* none is left */
}
#endif

static void a_machine_that_stands_still_ends_no_child(void **state)
{
    (void)state;
#if GLINT_WITH_SVG
    make_svg("good.svg", 20, "<rect width='9' height='9'/>");
    assert_quiet("\"$STILL\" --height good.svg --bevel 3 -o still.png");
#endif
#if GLINT_WITH_MESH
    assert_quiet(
        "printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "endsolid a\n' >good.stl; \"$STILL\" --mesh good.stl --size 9x9 -o still.png");
#endif
}

#if GLINT_WITH_SVG
static void a_drawing_that_librsvg_cannot_bear_is_one_line(void **state)
{
    (void)state;
    static const struct {
        unsigned side;
        const char *drawing, *part;
    } cases[] = {
        {90, "<text font-size='1e7' y='9'>a</text>", "bad.svg: "},
        {2000, endless_drawing, "bad.svg: librsvg did not read it within 10 s"},
        {200, "<text font-family='none such' font-size='1e5' y='100'>a</text>", "bad.svg: "},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        make_svg("bad.svg", cases[i].side, cases[i].drawing);
        const struct run *result = run("$GLINT render --height bad.svg -o no.png");
        assert_true(result->status <= 1); /* 0: it drew something */
        assert_one_line(result->err);
        assert_contains(result->err, cases[i].part);
    }
}
#endif

/* STILL is this program as glint render. */
int main(int count, char **words)
{
    if (count > 1)
        return command_render(count, words);
    setenv("STILL", realpath("/proc/self/exe", NULL), 1);
    const struct CMUnitTest tests[] = {
#if GLINT_WITH_MESH || GLINT_WITH_SVG
        cmocka_unit_test(a_child_dies_with_its_parent),
#endif
        cmocka_unit_test(a_machine_that_stands_still_ends_no_child),
#if GLINT_WITH_SVG
        cmocka_unit_test(a_drawing_that_librsvg_cannot_bear_is_one_line),
#endif
    };
    return cmocka_run_group_tests_name("children", tests, scratch_make, scratch_remove);
}
