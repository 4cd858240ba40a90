/* SPDX-License-Identifier: MIT
 * What all of the glint command has in common: statuses, messages, help, numbers, output files. */
#include <sys/stat.h>

#include "run.h"

#include "glint.h"
#include "sinks/sinks.h"

#define EVAL "$GLINT eval -n 60 0.99"

/* ---- help and usage ---- */

static const char *const commands[] = {"",         "render", "eval", "cutoff", "table", "bake",
                                       "material", "stream", "list", "search", "paper", "page"};
enum { COMMANDS = sizeof commands / sizeof *commands };

static void help_of_every_command_has_an_example_and_exits_0(void **state)
{
    (void)state;
    for (size_t i = 0; i < COMMANDS; i++) {
        char command[64];
        snprintf(command, sizeof command, "$GLINT %s --help", commands[i]);
        const struct run *result = run(command);
        assert_int_equal(result->status, 0);
        assert_contains(result->out, "\nExamples:\n  glint ");
        assert_string_equal(result->err, "");
    }
}

/* glibc's argp writes without end, into a closed pipe, too, until its seconds of the processor are used up. */
static void argp_margins_leave_help_as_it_is(void **state)
{
    (void)state;
    assert_int_equal(
        run("$GLINT eval --help >asked; (ulimit -t 9; ARGP_HELP_FMT=rmargin=1 $GLINT eval --help) | cmp - asked "
            "&& test -s asked")
            ->status,
        0);
}

static void help_and_a_command_give_what_its_option_gives(void **state)
{
    (void)state;
    for (size_t i = 0; i < COMMANDS; i++) {
        char command[128];
        snprintf(command, sizeof command, "$GLINT %s --help >asked; $GLINT help %s | cmp - asked && test -s asked",
                 commands[i], commands[i]);
        assert_int_equal(run(command)->status, 0);
    }
    assert_contains(run("$GLINT help help")->out, "\nExamples:\n  glint render");
    assert_contains(run("$GLINT help foo")->err, "glint: unknown command 'foo'; choose from render, ");
    assert_contains(run("$GLINT help render stream")->err, "glint: unexpected argument 'stream'");
    assert_int_equal(run("$GLINT help render stream")->status, 2);
}

static void every_command_that_draws_a_scene_takes_its_name_with_and_without_the_option(void **state)
{
    (void)state;
    static const char *const lines[] = {"render %s --size 20x20 -o -", "bake %s --size 20x20 -o -",
                                        "stream %s --size 20x20 --frames 1 --to raw"};
    static const char *const scenes[] = {"coin", "teapot"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
            char with[32], a[96], b[96], command[256];
            snprintf(with, sizeof with, "--scene %s", scenes[k]);
            const bool sized = k == 0 || i != 1; /* baked, a mesh has no size */
            const char *line = sized ? lines[i] : "bake %s -o -";
            snprintf(a, sizeof a, line, scenes[k]);
            snprintf(b, sizeof b, line, with);
            snprintf(command, sizeof command, "$GLINT %s >a && $GLINT %s >b && test -s a && cmp a b", a, b);
            assert_int_equal(run(command)->status, 0);
        }
        char line[128], command[192];
        snprintf(line, sizeof line, lines[i], "coin dial");
        snprintf(command, sizeof command, "$GLINT %s >a", line);
        assert_refused(command, "unexpected argument 'dial'; one scene is enough");
        snprintf(line, sizeof line, lines[i], "wall.png");
        snprintf(command, sizeof command, "$GLINT %s >a", line);
        assert_refused(command, "unexpected argument 'wall.png'; name files by --height");
    }
    assert_int_equal(
        run("$GLINT render --scene teapot --scene coin -o - >a && $GLINT render coin -o - >b && cmp a b")->status,
        0); /* the last counts */
}

/* argp breaks what is longer than a line, and what it breaks cannot be copied into a shell. */
static void no_example_and_no_list_in_help_is_broken(void **state)
{
    (void)state;
    for (size_t i = 0; i < COMMANDS; i++) {
        char command[64];
        snprintf(command, sizeof command, "$GLINT %s --help", commands[i]);
        bool indented = false;
        for (const char *line = run(command)->out; *line; line = strchr(line, '\n') + 1) {
            if (indented && !strchr(" \n", *line))
                fail_msg("%s: '%.30s' is the rest of the line before", command, line);
            indented = *line == ' ';
        }
    }
}

static void no_heading_in_help_comes_twice(void **state)
{
    (void)state;
    for (size_t i = 0; i < COMMANDS; i++) {
        char command[96];
        snprintf(command, sizeof command, "$GLINT %s --help | grep '^ [A-Z].*:$' | sort | uniq -d", commands[i]);
        assert_string_equal(run(command)->out, "");
    }
}

static void an_option_that_argp_refuses_is_told_in_one_line_by_every_command(void **state)
{
    (void)state;
    for (size_t i = 0; i < COMMANDS; i++) {
        char command[64];
        snprintf(command, sizeof command, "$GLINT %s --shiny", commands[i]);
        assert_refused(command, "'--shiny'; see `glint");
    }
}

static void version_is_the_librarys(void **state)
{
    (void)state;
    const char *version = "glint " GLINT_VERSION_STRING "\n";
    assert_memory_equal(run("$GLINT --version")->out, version, strlen(version));
    assert_memory_equal(run("$GLINT eval --version")->out, version, strlen(version));
}

static void version_tells_the_libraries_and_the_sinks(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT --version");
    assert_contains(result->out, "liblz4 1.");
    for (unsigned i = 0; sink_kinds[i]; i++)
        assert_contains(strstr(result->out, "\nsinks:"), sink_kinds[i]->name);
}

static void no_command_is_wrong_usage(void **state)
{
    (void)state;
    assert_refused("$GLINT", "glint: no command; choose one; see `glint --help`");
    assert_refused("$GLINT eval", "see `glint eval --help`");
}

static void an_unknown_command_is_named(void **state)
{
    (void)state;
    assert_refused("$GLINT rendre", "'rendre'");
    assert_refused("$GLINT ''", "''");
}

static void an_unknown_option_is_named(void **state)
{
    (void)state;
    assert_refused("$GLINT --colour", "glint: unknown option '--colour'; see `glint --help`\n");
    assert_refused("$GLINT eval --colour 1", "glint eval: unknown option '--colour'; see `glint eval --help`\n");
    assert_refused("$GLINT eval -n", "glint eval: option '-n' needs a value: LIST; see `glint eval --help`\n");
    assert_refused("$GLINT eval --c 1", "option '--c' is ambiguous; choose from --cutoff, --csv; see");
    assert_refused("$GLINT eval --csv=1 1", "option '--csv' takes no value; see");
    assert_refused("$GLINT eval \"--$(printf 'a\\nTry `b')\"", "unknown option '--a?Try `b'; see `glint eval --help`");
    assert_refused("$GLINT eval --$(printf %0100000d 7)", "unknown option '--0");
    assert_true(strlen(run("$GLINT eval --$(printf %0100000d 7)")->err) < 300);
}

static void an_unknown_model_is_named_with_those_there_are(void **state)
{
    (void)state;
    assert_refused("$GLINT eval --model Blin 1",
                   "--model: unknown model 'Blin'; did you mean 'blinn'? choose from msh, schlick");
}

/* ---- numbers ---- */

static void malformed_numbers_are_refused_by_name(void **state)
{
    (void)state;
    static const char *const numbers[] = {
        "",    "1e",   "0x", "0x10", "nan", "inf",   "1,,2", " 5",  "5 ",
        "1.5", "five", "1:", "1:2:", "--5", "0:5:0", "5:1",  "1e9", "99999999999999999999"};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char command[96], wanted[64];
        snprintf(command, sizeof command, "$GLINT eval -n '%s' 1", numbers[i]);
        snprintf(wanted, sizeof wanted, "-n: '%s'", numbers[i]);
        assert_refused(command, wanted);
        snprintf(command, sizeof command, "$GLINT table --cutoff '%s'", numbers[i]);
        assert_refused(command, "-q: ");
        snprintf(command, sizeof command, "$GLINT table -q '%s'", numbers[i]);
        snprintf(wanted, sizeof wanted, "-q: '%s'", numbers[i]);
        assert_refused(command, wanted);
    }
    assert_refused("$GLINT table -q 1,2", "-q: '1,2' is not a whole number from 0 to 16");
    assert_refused("$GLINT table --across 60", "the highlight alone has --model, -n, -q and --clamp-peak");
    assert_refused("$GLINT table --view 0,0,1", "the highlight alone has --model, -n, -q and --clamp-peak");
    assert_refused("$GLINT eval -n 0 1", "from 1 to 1000");
    assert_refused("$GLINT eval -n 1001 1", "from 1 to 1000");
}

static void a_message_is_one_line_whatever_it_quotes(void **state)
{
    (void)state;
    assert_fails("$GLINT eval 1 -o \"$(printf 'no\\nsuch\\033[31m/file')\"", "no?such?[31m/file");
    assert_refused("$GLINT eval -n \"$(printf '1\\n2')\" 1", "-n: '1?2'");
}

static void a_long_text_is_quoted_in_part(void **state)
{
    (void)state;
    assert_refused("$GLINT eval -n $(printf %0100000d 7)x 1", "' is not a list from 1 to 1000: A, A:B or A:B:STEP");
    assert_true(strlen(run("$GLINT eval -n $(printf %0100000d 7)x 1")->err) < 300);
    assert_contains(run("$GLINT eval -n $(printf %0100000d 7)x 1")->err, "-n: '0000");
    assert_fails("$GLINT eval 1 -o $(printf %0100000d 7)", "000...000");
    assert_true(strlen(run("$GLINT eval 1 -o $(printf %0100000d 7)")->err) < 300);
    assert_refused("$GLINT $(printf %0100000d 7)", "unknown command '000");
    assert_true(strlen(run("$GLINT $(printf %0100000d 7)")->err) < 300);
    /* Characters of two bytes: none is cut in two. */
    assert_fails("printf '\\303\\244%.0s' $(seq 500) | $GLINT eval -", "standard input, line 1: '\303\244");
    const char *dots = strstr(run("printf '\\303\\244%.0s' $(seq 500) | $GLINT eval -")->err, "...");
    assert_non_null(dots);
    assert_int_equal((unsigned char)dots[-1], 0244);
    assert_int_equal((unsigned char)dots[3], 0303);
    assert_null(strstr(run("$GLINT eval -n $(printf %050d 7)x 1")->err, "..."));
}

static void what_is_no_page_is_not_served(void **state)
{
    (void)state;
    assert_fails("$GLINT page --port 0 --file no-page.html", "no-page.html: No such file");
    assert_fails("$GLINT page --port 0 --file .", ".: this is not a page; name the one that `make page` builds");
    assert_fails("mkfifo pipe.html; $GLINT page --port 0 --file pipe.html", "pipe.html: this is not a page");
    assert_fails(">empty.html; $GLINT page --port 0 --file empty.html", "empty.html: this is not a page; name the one");
}

/* ---- standard output ---- */

static void a_full_disk_is_a_failure(void **state)
{
    (void)state;
    assert_fails(EVAL " >/dev/full", "standard output: could not be written: No space left on device");
    assert_fails(EVAL " -o /dev/full", "/dev/full");
    assert_fails("$GLINT cutoff >/dev/full", "standard output");
    assert_fails("$GLINT table >/dev/full", "standard output");
    assert_fails("$GLINT --help >/dev/full", "standard output");
    assert_fails("$GLINT render --scene sphere --size 8x8 --compare >/dev/full",
                 "the comparison could not be written: No");
    assert_fails("$GLINT bake --scene coin --size 8x8 >/dev/full", "the quality could not be written: No space");
    assert_fails("ulimit -f 99; $GLINT bake --scene coin --size 170x170 --as raw -o full.bin",
                 "full.bin: could not be written: File too large");
}

static void a_closed_standard_output_is_a_failure(void **state)
{
    (void)state;
    assert_fails(EVAL " >&-", "standard output");
}

static void a_closed_pipe_is_a_failure(void **state)
{
    (void)state;
    assert_fails("{ $GLINT eval --raw 0:65536; echo $? >code; } | head -n 1; exit $(cat code)", "Broken pipe");
}

static void a_closed_standard_output_does_not_spoil_a_file(void **state)
{
    (void)state;
    assert_int_equal(run(EVAL " -o closed.txt >&-")->status, 0);
    assert_int_equal(run(EVAL " -o open.txt && cmp open.txt closed.txt")->status, 0);
}

static void no_escape_codes_go_where_no_terminal_is(void **state)
{
    (void)state;
    static const char *const quiet[] = {EVAL, ("NO_COLOR=1 " EVAL), "TERM=xterm-256color $GLINT eval --help"};
    for (size_t i = 0; i < sizeof quiet / sizeof *quiet; i++) {
        const struct run *result = run(quiet[i]);
        assert_int_equal(result->status, 0);
        assert_null(strchr(result->out, '\033'));
        assert_null(strchr(result->err, '\033'));
    }
}

/* ---- output files ---- */

static void a_file_is_kept_where_its_successor_fails(void **state)
{
    (void)state;
    assert_fails("echo old >kept; (ulimit -f 1; $GLINT eval --raw 0:65536 -o kept)", "glint: kept: could not be");
    assert_string_equal(run("cat kept")->out, "old\n");
    assert_string_equal(run("ls -A | grep -c '^.glint'")->out, "0\n");
}

static void an_interrupted_run_leaves_nothing(void **state)
{
    (void)state;
    /* It waits for standard input with its output open. */
    const struct run *result = run("mkfifo input; $GLINT eval - -o late <input & exec 3>input; echo 1 >&3;"
                                   "until ls -A | grep -q '^.glint' || ! kill -0 $!; do sleep .02; done;"
                                   "ls -A | grep -q '^.glint' || echo not begun; kill $!; wait $!");
    assert_string_equal(result->out, "");
    assert_int_equal(result->status, 128 + 15);
    assert_string_equal(run("ls -A | grep -c -e '^.glint' -e '^late'")->out, "0\n");
}

static void a_replaced_file_keeps_its_mode(void **state)
{
    (void)state;
    assert_string_equal(run("echo old >mode; chmod 640 mode; " EVAL " -o mode && stat -c %a mode")->out, "640\n");
}

static void a_new_file_has_the_mode_of_the_umask(void **state)
{
    (void)state;
    assert_string_equal(run("umask 027; " EVAL " -o new && stat -c %a new")->out, "640\n");
}

static void a_symbolic_link_stays_one(void **state)
{
    (void)state;
    assert_int_equal(run("echo old >target; ln -s target link; " EVAL " -o link && test -L link")->status, 0);
    assert_int_equal(run(EVAL " | cmp - target")->status, 0);
    assert_int_equal(run("mkdir -p sub; ln -s sub/new dangling; " EVAL " -o dangling && test -L dangling")->status, 0);
    assert_int_equal(run(EVAL " | cmp - sub/new")->status, 0);
}

static void pipes_and_devices_are_written_in_place(void **state)
{
    (void)state;
    assert_int_equal(run(EVAL " -o /dev/null && test -c /dev/null")->status, 0);
    assert_int_equal(run("mkfifo pipe; cat pipe >piped & " EVAL " -o pipe && wait && " EVAL " | cmp - piped")->status,
                     0);
}

/* Whatever name of standard output is given, a file that it goes to keeps what is before and after. */
static void a_file_behind_standard_output_is_written_where_it_stands(void **state)
{
    (void)state;
    assert_int_equal(run(EVAL " >alone; (echo before; cat alone; echo after) >wanted")->status, 0);
    assert_int_equal(run("ln -s /dev/stdout out; for i in /dev/stdout /dev/fd/1 out; do echo before >found; " EVAL
                         " -o $i >>found && echo after >>found && cmp found wanted >&2 || exit; done")
                         ->status,
                     0);
    assert_int_equal(run("(echo before; " EVAL " -o /dev/stdout; echo after) >found && cmp found wanted >&2")->status,
                     0);
    assert_int_equal(run("ls -A | grep -q glint-")->status, 1);
}

static void a_file_behind_another_descriptor_is_written_where_it_stands(void **state)
{
    (void)state;
    assert_int_equal(run(EVAL " >alone; (echo before; cat alone; echo after) >wanted; ln -s /dev/fd/4 four")->status,
                     0);
    assert_int_equal(run("for i in /dev/fd/4 /proc/self/fd/4 four; do { echo before >&4; " EVAL
                         " -o $i; echo after >&4; } 4>found && cmp found wanted >&2 || exit; done")
                         ->status,
                     0);
    assert_int_equal(
        run("{ echo before >&2; " EVAL " -o /dev/stderr; echo after >&2; } 2>found; cmp found wanted")->status, 0);
    assert_int_equal(run("ls -A | grep -q glint-")->status, 1);
}

/* By whatever name, into a file or a pipe. */
static void what_is_said_of_an_output_is_never_written_into_it(void **state)
{
    (void)state;
    static const char *const talking[] = {"bake coin --size 20x20 --as raw", "bake teapot --as raw",
                                          "render coin --size 20x20 --image raw --compare",
                                          "stream coin --size 20x20 --to y4m --frames 2 --stats"};
    for (size_t i = 0; i < sizeof talking / sizeof *talking; i++) {
        char command[1000];
        snprintf(
            command, sizeof command,
            "$GLINT %s -o - >said 2>/dev/null; ln -sf /dev/stdout way; for i in /dev/stdout way; do "
            "$GLINT %s -o $i >found && cmp said found >&2 && $GLINT %s -o $i | cat >found && cmp said found >&2 || "
            "exit; done",
            talking[i], talking[i], talking[i]);
        const struct run *result = run(command);
        if (result->status != 0)
            fail_msg("%s: %s", command, result->err);
    }
    assert_int_equal(run("$GLINT render coin --size 20x20 --error-map /dev/stdout >found")->status, 2);
}

static void a_name_of_the_longest_length_can_be_written(void **state)
{
    (void)state;
    assert_int_equal(run("name=$(printf %0255d 0); " EVAL " -o $name && test -s $name && rm $name")->status, 0);
}

static void an_output_that_cannot_be_is_named(void **state)
{
    (void)state;
    assert_fails(EVAL " -o missing/file", "missing/file");
    assert_fails(EVAL " -o .", ".: this is a folder; name a file");
    assert_fails("touch plain; " EVAL " -o plain/file", "plain/file");
    static const char *const unnamed[] = {
        EVAL " -o ''",         "$GLINT cutoff -o ''", "$GLINT table -o ''",
        "$GLINT search -o ''", "$GLINT paper -o ''",  "$GLINT render --scene sphere -o ''",
    };
    for (size_t i = 0; i < sizeof unnamed / sizeof *unnamed; i++)
        assert_refused(unnamed[i], "-o");
    assert_refused("$GLINT render --scene sphere --error-map ''", "--error-map: the file name is empty");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(argp_margins_leave_help_as_it_is),
        cmocka_unit_test(help_and_a_command_give_what_its_option_gives),
        cmocka_unit_test(help_of_every_command_has_an_example_and_exits_0),
        cmocka_unit_test(every_command_that_draws_a_scene_takes_its_name_with_and_without_the_option),
        cmocka_unit_test(no_example_and_no_list_in_help_is_broken),
        cmocka_unit_test(no_heading_in_help_comes_twice),
        cmocka_unit_test(an_option_that_argp_refuses_is_told_in_one_line_by_every_command),
        cmocka_unit_test(version_is_the_librarys),
        cmocka_unit_test(version_tells_the_libraries_and_the_sinks),
        cmocka_unit_test(no_command_is_wrong_usage),
        cmocka_unit_test(an_unknown_command_is_named),
        cmocka_unit_test(an_unknown_option_is_named),
        cmocka_unit_test(an_unknown_model_is_named_with_those_there_are),
        cmocka_unit_test(malformed_numbers_are_refused_by_name),
        cmocka_unit_test(a_message_is_one_line_whatever_it_quotes),
        cmocka_unit_test(a_long_text_is_quoted_in_part),
        cmocka_unit_test(what_is_no_page_is_not_served),
        cmocka_unit_test(a_full_disk_is_a_failure),
        cmocka_unit_test(a_closed_standard_output_is_a_failure),
        cmocka_unit_test(a_closed_pipe_is_a_failure),
        cmocka_unit_test(a_closed_standard_output_does_not_spoil_a_file),
        cmocka_unit_test(no_escape_codes_go_where_no_terminal_is),
        cmocka_unit_test(a_file_is_kept_where_its_successor_fails),
        cmocka_unit_test(an_interrupted_run_leaves_nothing),
        cmocka_unit_test(a_replaced_file_keeps_its_mode),
        cmocka_unit_test(a_new_file_has_the_mode_of_the_umask),
        cmocka_unit_test(a_symbolic_link_stays_one),
        cmocka_unit_test(pipes_and_devices_are_written_in_place),
        cmocka_unit_test(a_file_behind_standard_output_is_written_where_it_stands),
        cmocka_unit_test(a_file_behind_another_descriptor_is_written_where_it_stands),
        cmocka_unit_test(what_is_said_of_an_output_is_never_written_into_it),
        cmocka_unit_test(a_name_of_the_longest_length_can_be_written),
        cmocka_unit_test(an_output_that_cannot_be_is_named),
    };
    return cmocka_run_group_tests_name("command line", tests, scratch_make, scratch_remove);
}
