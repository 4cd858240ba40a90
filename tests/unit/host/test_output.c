/* SPDX-License-Identifier: MIT
 * Output files: whole or not there, whatever ends the program. */
#include <fcntl.h>
#include <glob.h>
#include <pthread.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#if defined(_OPENMP)
#include <omp.h>
#endif

#include "files.h"

#include "bake/palette.h"
#include "base/folder.h"
#include "base/output.h"
#include "base/stop.h"
#include "compare/quality.h"
#include "scene/scene.h"
#include "scene/scenes.h"

/* ---- in a process of its own, linked in ---- */

/* What `child` ends with; it may fail(), which exits. */
static int status_of(void (*child)(void))
{
    fflush(NULL);
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        if (!freopen(".err", "w", stderr))
            _exit(99);
        child();
        _exit(0);
    }
    int status;
    assert_int_equal(waitpid(pid, &status, 0), pid);
    return status;
}

/* It comes when the file is there and its name is not yet known to the caller. */
static int signal_in_mkstemp;

/* Takes the place of libc's. The signal goes to the process, and a thread that does not hold it has time to take it. */
int mkstemp(char *name)
{
    const int descriptor = mkostemp(name, 0);
    if (signal_in_mkstemp) {
        kill(getpid(), signal_in_mkstemp);
        usleep(100000);
    }
    return descriptor;
}

static void discard_and_end(int number)
{
    output_discard_all();
    _exit(number);
}

static void open_while_a_signal_comes(void)
{
    signal_in_mkstemp = SIGTERM;
    signal(SIGTERM, discard_and_end);
    output_open("out/struck");
}

static void a_signal_while_a_file_is_opened_leaves_nothing(void **state)
{
    (void)state;
    const int status = status_of(open_while_a_signal_comes);
    assert_int_equal(WEXITSTATUS(status), SIGTERM);
    assert_int_equal(files_in("out"), 0);
}

/* As a thread that has drawn. */
static void *wait_for_work(void *unused)
{
    for (;;)
        pause();
    return unused;
}

static void *give_up(void *unused)
{
    abort();
    return unused;
}

/* As one that draws, in a program whose faults no sanitizer takes. */
static pthread_t start_thread(void *(*run_it)(void *))
{
    static const int faults[] = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS, SIGTRAP};
    const struct rlimit no_core = {0, 0};
    sigset_t before;
    pthread_t thread;
    setrlimit(RLIMIT_CORE, &no_core);
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        signal(faults[i], SIG_DFL);
    stop_at_signals();
    signals_hold_but_faults(&before);
    if (pthread_create(&thread, NULL, run_it, NULL) != 0)
        _exit(98);
    signals_release(&before);
    return thread;
}

static int sent; /* what somebody sends the process */

static void open_beside_a_thread_while_it_is_sent(void)
{
    start_thread(wait_for_work);
    signal_in_mkstemp = sent;
    output_open("out/struck");
}

static void a_fault_that_is_sent_while_a_file_is_opened_beside_a_drawing_thread_leaves_nothing(void **state)
{
    (void)state;
    static const int signals[] = {SIGABRT, SIGBUS, SIGSEGV};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        sent = signals[i];
        const int status = status_of(open_beside_a_thread_while_it_is_sent);
        assert_true(WIFSIGNALED(status));
        assert_int_equal(WTERMSIG(status), sent);
        assert_int_equal(files_in("out"), 0);
    }
}

static void give_up_beside_an_open_file(void)
{
    output_open("out/given-up");
    pthread_join(start_thread(give_up), NULL);
}

static void a_drawing_thread_that_gives_up_leaves_nothing(void **state)
{
    (void)state;
    const int status = status_of(give_up_beside_an_open_file);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), SIGABRT);
    assert_int_equal(files_in("out"), 0);
}

/* In each thread: no normal can be read. */
static void fault_in_drawing_threads(void)
{
    enum { SIDE = 64 };
    const size_t bytes = SIDE * SIDE * sizeof(double[3]);
    const struct rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    signal(SIGSEGV, SIG_DFL); /* not a sanitizer's */
    stop_at_signals();
    output_open("out/faulty");
    struct scene scene = {.width = SIDE, .height = SIDE};
    scene.normals = mmap(NULL, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    scene_normals_q15(&scene);
}

static void a_fault_in_a_drawing_thread_leaves_nothing(void **state)
{
    (void)state;
    const int status = status_of(fault_in_drawing_threads);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), SIGSEGV);
    assert_int_equal(files_in("out"), 0);
}

static unsigned deeper(volatile unsigned *above)
{
    volatile unsigned here[1024] = {*above + 1};
    return *above ? deeper(here) + here[0] : 0;
}

static void run_out_of_stack_beside_an_open_file(void)
{
    const struct rlimit no_core = {0, 0};
    struct rlimit stack;
    setrlimit(RLIMIT_CORE, &no_core);
    getrlimit(RLIMIT_STACK, &stack);
    stack.rlim_cur =
        stack.rlim_max < 8 << 20 ? stack.rlim_max : 8 << 20; /* where it is unlimited, memory would run out */
    setrlimit(RLIMIT_STACK, &stack);
    signal(SIGSEGV, SIG_DFL); /* not a sanitizer's */
    stop_at_signals();
    output_open("out/deep");
    deeper((volatile unsigned[]){1});
}

static void a_stack_that_runs_out_leaves_nothing(void **state)
{
    (void)state;
    const int status = status_of(run_out_of_stack_beside_an_open_file);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), SIGSEGV);
    assert_int_equal(files_in("out"), 0);
}

/* Does each thread but the first hold what ends a program? */
static bool threads_hold_signals(void)
{
    const unsigned long long wanted = 1ULL << (SIGINT - 1) | 1ULL << (SIGTERM - 1);
    bool all = true;
    glob_t found;
    if (glob("/proc/self/task/*/status", 0, NULL, &found) != 0)
        return false;
    for (size_t i = 0; i < found.gl_pathc; i++) {
        unsigned long long held = 0;
        char text[4000];
        read_text(found.gl_pathv[i], text, sizeof text);
        const char *at = strstr(text, "SigBlk:");
        const bool is_first = atoi(found.gl_pathv[i] + strlen("/proc/self/task/")) == getpid();
        all &= is_first || (at && sscanf(at, "SigBlk: %llx", &held) == 1 && (held & wanted) == wanted);
    }
    globfree(&found);
    return all;
}

enum { NORMALS = 1000, ENTRIES = 50 };

static void choose_a_palette(void)
{
    struct glint_vec normals[NORMALS], palette[ENTRIES];
    uint16_t places[NORMALS];
    for (int i = 0; i < NORMALS; i++)
        normals[i] = (struct glint_vec){(int16_t)(i * 20), (int16_t)(i * 37 % 9000), 20000};
    palette_choose(normals, NORMALS, ENTRIES, palette, places);
}

static void judge_what_is_baked(void)
{
    enum { SIDE = 16 };
    static double normals[SIDE * SIDE][3];
    static struct glint_vec vectors[SIDE * SIDE];
    struct quality rows[QUALITY_ROWS];
    for (int i = 0; i < SIDE * SIDE; i++) {
        normals[i][2] = 1;
        vectors[i].z = 32767;
    }
    const struct scene scene = {.width = SIDE, .height = SIDE, .normals = normals};
    const struct baked baked = {.format = BAKE_INT16, .width = SIDE, .height = SIDE, .normals = vectors};
    bake_quality(&scene, &baked, rows);
}

static void draw_a_scene(void)
{
    scene_free(scene_draw("coin", 64, 64));
}

static void (*work)(void);

static void work_in_threads(void)
{
#if defined(_OPENMP)
    omp_set_num_threads(3);
#endif
    work();
    _exit(threads_hold_signals() ? 0 : 98);
}

static volatile sig_atomic_t taken_at_once;

static void take(int signal_number)
{
    (void)signal_number;
#if defined(_OPENMP)
    taken_at_once |= omp_in_parallel();
#else
    taken_at_once = 1;
#endif
}

static void work_as_signals_come(void)
{
    const struct itimerval often = {{0, 300}, {0, 300}};
    signal(SIGALRM, take);
    setitimer(ITIMER_REAL, &often, NULL);
#if defined(_OPENMP)
    omp_set_num_threads(3);
#endif
    for (int i = 0; i < 3000 && !taken_at_once; i++)
        work();
    _exit(taken_at_once ? 0 : 98);
}

static void threads_leave_signals_to_the_first_which_takes_them_at_once(void **state)
{
    (void)state;
    static void (*const works[])(void) = {choose_a_palette, judge_what_is_baked, draw_a_scene};
    for (size_t i = 0; i < sizeof works / sizeof *works; i++) {
        work = works[i];
        assert_int_equal(status_of(work_in_threads), 0);
        assert_int_equal(status_of(work_as_signals_come), 0);
    }
}

static void fail_in_the_middle(void)
{
    struct output *output = output_open("out/holed");
    fputs("begun", output->stream);
    fflush(output->stream);
    /* The stream remembers an error, as of a write; what follows can be written. */
    if (fgetc(output->stream) != EOF || !ferror(output->stream))
        _exit(98);
    fputs("ended", output->stream);
    output_close(output);
}

static void an_error_in_the_middle_is_not_forgotten_when_the_end_is_written(void **state)
{
    (void)state;
    assert_int_equal(WEXITSTATUS(status_of(fail_in_the_middle)), 1);
    char text[200];
    read_text(".err", text, sizeof text);
    assert_contains(text, "out/holed: could not be written");
    assert_one_line(text);
    assert_int_equal(files_in("out"), 0);
}

/* ---- the command ---- */

static void be_eval_with_its_output_open(int input, int signal_number)
{
    const struct rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    signal(signal_number, SIG_DFL); /* the tests may run where it is ignored */
    dup2(input, STDIN_FILENO);
    execl(getenv("GLINT"), "glint", "eval", "-", "-o", "out/late", (char *)NULL);
    _exit(99);
}

static bool unfinished_is_there(void)
{
    glob_t found;
    const bool there = glob("out/.glint-*", 0, NULL, &found) == 0;
    globfree(&found);
    return there;
}

static void a_signal_that_ends_the_command_leaves_nothing(void **state)
{
    (void)state;
    static const int signals[] = {SIGINT,  SIGTERM, SIGHUP,  SIGQUIT, SIGXCPU, SIGALRM,
                                  SIGUSR1, SIGUSR2, SIGABRT, SIGTRAP, SIGSEGV};
#if defined(__SANITIZE_ADDRESS__)
    const size_t count = sizeof signals / sizeof *signals - 1; /* the last one has a handler of the sanitizer */
#else
    const size_t count = sizeof signals / sizeof *signals;
#endif
    for (size_t i = 0; i < count; i++) {
        int ends[2];
        assert_int_equal(pipe2(ends, O_CLOEXEC), 0);
        fflush(NULL);
        const pid_t pid = fork();
        if (pid == 0)
            be_eval_with_its_output_open(ends[0], signals[i]);
        close(ends[0]);
        while (!unfinished_is_there() && lives(pid))
            usleep(10000);
        assert_true(unfinished_is_there());
        int status;
        assert_int_equal(kill(pid, signals[i]), 0);
        assert_int_equal(waitpid(pid, &status, 0), pid);
        close(ends[1]);
        if (files_in("out") != 0)
            fail_msg("%s: %d files left", strsignal(signals[i]), files_in("out"));
        assert_true(WIFSIGNALED(status));
        assert_int_equal(WTERMSIG(status), signals[i]);
    }
}

static void a_signal_that_is_ignored_stays_so(void **state)
{
    (void)state;
    /* As under nohup: the shell sends the signal and then the end of input. */
    const struct run *result =
        run("mkfifo held; trap '' HUP; $GLINT eval - -o out/kept <held & exec 3>held; echo 1 >&3;"
            "until ls -A out | grep -q glint || ! kill -0 $!; do sleep .02; done;"
            "kill -HUP $!; exec 3>&-; wait $!");
    assert_int_equal(result->status, 0);
}

static void a_limit_on_the_size_of_files_is_a_failure_that_leaves_nothing(void **state)
{
    (void)state;
    assert_fails("(ulimit -f 4; exec $GLINT render --scene coin --size 640x640 -o out/big.ppm)",
                 "out/big.ppm: could not be written: File too large");
    assert_int_equal(files_in("out"), 0);
    assert_fails("(ulimit -f 1; exec $GLINT eval --raw 0:65536 -o out/values)", "File too large");
    assert_int_equal(files_in("out"), 0);
}

static void a_header_is_not_there_without_its_source(void **state)
{
    (void)state;
    static const char *const commands[] = {"bake --scene coin", "bake --scene teapot", "table --kind colour",
                                           "table --entries 9999"};
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        char line[200];
        snprintf(line, sizeof line, "(ulimit -f 8; exec $GLINT %s -o out/half.c)", commands[i]);
        const struct run *result = run(line);
        assert_int_equal(result->status, 1);
        assert_one_line(result->err);
        assert_contains(result->err, "out/half.c: could not be written: ");
        assert_int_equal(files_in("out"), 0);
    }
}

/* ---- folders ---- */

enum { FILES = 300 };

static void write_files(bool whole)
{
    static struct folder *folder; /* what is not closed is not lost for LeakSanitizer */
    folder = folder_open("out/many");
    for (int i = 0; i < FILES; i++) {
        char name[16];
        snprintf(name, sizeof name, "%d.txt", i);
        char *path = folder_file(folder, name);
        struct output *output = output_open(path);
        fprintf(output->stream, "%d", i);
        output_close(output);
        free(path);
    }
    if (whole)
        folder_close(folder);
}

static void write_whole_folder(void)
{
    write_files(true);
}

static void write_half_a_folder(void)
{
    write_files(false);
    exit(3);
}

static void write_folder_until_a_signal(void)
{
    stop_at_signals();
    write_files(false);
    raise(SIGTERM);
}

static void a_folder_takes_any_number_of_files(void **state)
{
    (void)state;
    assert_int_equal(status_of(write_whole_folder), 0);
    assert_int_equal(files_in("out/many"), FILES);
    assert_int_equal(status_of(write_whole_folder), 0); /* one that exists */
    assert_int_equal(files_in("out/many"), FILES);
    assert_int_equal(files_in("out"), 1);
}

static void a_folder_that_is_not_closed_leaves_nothing(void **state)
{
    (void)state;
    assert_int_equal(WEXITSTATUS(status_of(write_half_a_folder)), 3);
    assert_int_equal(files_in("out"), 0);
    assert_int_equal(WTERMSIG(status_of(write_folder_until_a_signal)), SIGTERM);
    assert_int_equal(files_in("out"), 0);
}

static int empty_folder(void **state)
{
    (void)state;
    return system("rm -rf out && mkdir out");
}

#define TEST(name) cmocka_unit_test_setup(name, empty_folder)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_signal_while_a_file_is_opened_leaves_nothing),
        TEST(a_fault_in_a_drawing_thread_leaves_nothing),
        TEST(a_stack_that_runs_out_leaves_nothing),
        TEST(a_fault_that_is_sent_while_a_file_is_opened_beside_a_drawing_thread_leaves_nothing),
        TEST(a_drawing_thread_that_gives_up_leaves_nothing),
        TEST(threads_leave_signals_to_the_first_which_takes_them_at_once),
        TEST(an_error_in_the_middle_is_not_forgotten_when_the_end_is_written),
        TEST(a_signal_that_ends_the_command_leaves_nothing),
        TEST(a_signal_that_is_ignored_stays_so),
        TEST(a_limit_on_the_size_of_files_is_a_failure_that_leaves_nothing),
        TEST(a_folder_takes_any_number_of_files),
        TEST(a_folder_that_is_not_closed_leaves_nothing),
        TEST(a_header_is_not_there_without_its_source),
    };
    return cmocka_run_group_tests_name("output", tests, scratch_make, scratch_remove);
}
