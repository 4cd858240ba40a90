/* SPDX-License-Identifier: MIT
 * glint paper as a command: its parts, what it refuses, whole reports or none, plots. */
#include <jansson.h>
#include <signal.h>

#include "files.h"

static void only_the_parts_named_are_written(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT paper -o some/deep/folder --no-plots --only fig4,models && ls some/deep/folder");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "fig4.csv\nmodels.csv\nreport.html\n");
    assert_null(strstr(result->out, "fig3"));
    char *report = whole_file("some/deep/folder/report.html");
    assert_contains(report, "this report is not complete");
    free(report);
}

static void json_is_what_claims_json_holds(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT paper -o j --no-plots --only fig4 --json >j.json && cmp j.json j/claims.json && cat j.json");
    assert_int_equal(result->status, 0);
    json_t *root = json_loads(result->out, 0, NULL);
    assert_int_equal(json_array_size(json_object_get(root, "claims")), 1);
    json_decref(root);
}

static void wrong_usage_is_named(void **state)
{
    (void)state;
    assert_refused("$GLINT paper", "-o DIR");
    assert_refused("$GLINT paper -o ''", "-o DIR");
    assert_refused("$GLINT paper -o x --only fig8", "--only: unknown part 'fig8'; choose from table1, wider");
    assert_refused("$GLINT paper -o x --only fig3,", "unknown part ''");
    assert_refused("$GLINT paper x", "'x'");
}

static void a_folder_that_cannot_be_is_named_in_one_line(void **state)
{
    (void)state;
    assert_fails("echo >file; $GLINT paper -o file --no-plots", "file: this is a file; name a folder");
    assert_fails("$GLINT paper -o file/below --no-plots", "file: this is a file; name a folder");
    assert_fails("$GLINT paper -o /proc/glint --no-plots", "/proc/glint");
    assert_fails("$GLINT paper -o nowhere/../x --no-plots", "nowhere does not exist, so '..' cannot follow it");
}

static void without_gnuplot_it_says_what_to_do_and_writes_nothing(void **state)
{
    (void)state;
    assert_fails("PATH=/nonexistent; $GLINT paper -o unplotted", "install gnuplot-nox, or pass --no-plots");
    assert_true(access("unplotted", F_OK) != 0);
}

static void a_gnuplot_that_fails_is_quoted(void **state)
{
    (void)state;
    assert_fails("mkdir fake; printf '#!/bin/sh\ncase \"$*\" in *print*) echo \" pngcairo \";; *) printf "
                 "\"\\n  ^\\n\\\"fig3.gp\\\" line 7: undefined variable: f\\n\\n\" >&2; exit 3;; esac\n' "
                 ">fake/gnuplot; chmod +x fake/gnuplot; PATH=$PWD/fake:$PATH; $GLINT paper -o unplotted --only fig3",
                 "gnuplot: no picture from fig3.gp: \"fig3.gp\" line 7: undefined variable: f; ");
    assert_false(exists("unplotted"));
}

/* ---- whole or not at all ---- */

static void when_the_disk_is_full_no_folder_is_left(void **state)
{
    (void)state;
    run("mkdir disk");
    assert_fails("ulimit -f 200; $GLINT paper -o disk/full/report --no-plots --only fig4,fig5",
                 "disk/full/report/fig5.csv: ");
    assert_int_equal(files_in("disk"), 0);
}

static void when_the_disk_is_full_a_folder_that_exists_keeps_its_files(void **state)
{
    (void)state;
    run("mkdir kept; echo mine >kept/mine; echo old >kept/fig3.csv");
    assert_fails("ulimit -f 200; $GLINT paper -o kept --no-plots --only fig3,fig5", "kept/fig5.csv: ");
    assert_quiet("echo old | cmp - kept/fig3.csv && echo mine | cmp - kept/mine");
    assert_int_equal(files_in("kept"), 2);
}

static void a_signal_leaves_nothing(void **state)
{
    (void)state;
    run("mkdir cut; printf '#!/bin/sh\ncase \"$*\" in *print*) echo \" pngcairo \";; *) kill -INT $PPID; sleep 5;; "
        "esac\n' >cut/gnuplot; chmod +x cut/gnuplot; mkdir cut/old; echo old >cut/old/fig3.csv");
    assert_int_equal(run("PATH=$PWD/cut:$PATH; $GLINT paper -o cut/new --only fig3")->status, 128 + SIGINT);
    assert_int_equal(run("PATH=$PWD/cut:$PATH; $GLINT paper -o cut/old --only fig3")->status, 128 + SIGINT);
    assert_quiet("echo old | cmp - cut/old/fig3.csv");
    assert_int_equal(files_in("cut/old"), 1);
    assert_int_equal(files_in("cut"), 2);
}

/* What holds a pipe's end is gone when the pipe has ended. */
static void gnuplot_ends_with_the_command(void **state)
{
    (void)state;
    run("mkdir ends; printf '#!/bin/sh\nexec 3>held\nkill -TERM $PPID\nsleep 2 3>&-\n: >lives\n' >ends/gnuplot; chmod "
        "+x "
        "ends/gnuplot; mkfifo held; cat held & PATH=$PWD/ends:$PATH; $GLINT paper -o unplotted --only fig3; wait");
    assert_false(exists("lives"));
}

static void a_folder_that_exists_keeps_other_files(void **state)
{
    (void)state;
    run("mkdir again; echo mine >again/mine; echo old >again/fig4.csv");
    assert_int_equal(run("$GLINT paper -o again/ --no-plots --only fig4")->status, 0);
    assert_quiet("echo mine | cmp - again/mine");
    assert_int_equal(run("$GLINT paper -o new --no-plots --only fig4 && cmp again/fig4.csv new/fig4.csv")->status, 0);
    assert_int_equal(files_in("again"), 4); /* and report.html, claims.json */
}

static void a_folder_in_a_files_place_is_named(void **state)
{
    (void)state;
    assert_fails("mkdir -p place/fig4.csv; $GLINT paper -o place --no-plots --only fig4",
                 "place/fig4.csv: is a folder");
    assert_int_equal(files_in("place"), 1);
}

static void plots_are_pictures_and_lie_in_the_report(void **state)
{
    (void)state;
    if (run("gnuplot --version")->status != 0)
        skip();
    assert_int_equal(run("$GLINT paper -o plotted --only fig3,fig5,fig6,fig7a,fig9")->status, 0);
    static const char *const names[] = {"fig3", "fig5", "fig6", "fig7a", "fig9"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[64];
        snprintf(path, sizeof path, "plotted/%s.png", names[i]);
        char *picture = whole_file(path);
        struct stat status;
        assert_memory_equal(picture, "\x89PNG", 4);
        assert_int_equal(stat(path, &status), 0);
        assert_true(status.st_size > 20000); /* an empty plot has less */
        free(picture);
    }
    char *report = whole_file("plotted/report.html");
    int pictures = 0;
    for (const char *at = report; (at = strstr(at, "<img src=\"data:image/png;base64,")); at++)
        pictures++;
    assert_int_equal(pictures, 5);
    free(report);
    /* The scripts that are kept draw the same by themselves. */
    assert_int_equal(run("cd plotted && gnuplot fig3.gp | cmp - fig3.png")->status, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_the_parts_named_are_written),
        cmocka_unit_test(json_is_what_claims_json_holds),
        cmocka_unit_test(wrong_usage_is_named),
        cmocka_unit_test(a_folder_that_cannot_be_is_named_in_one_line),
        cmocka_unit_test(without_gnuplot_it_says_what_to_do_and_writes_nothing),
        cmocka_unit_test(a_gnuplot_that_fails_is_quoted),
        cmocka_unit_test(when_the_disk_is_full_no_folder_is_left),
        cmocka_unit_test(when_the_disk_is_full_a_folder_that_exists_keeps_its_files),
        cmocka_unit_test(a_signal_leaves_nothing),
        cmocka_unit_test(gnuplot_ends_with_the_command),
        cmocka_unit_test(a_folder_that_exists_keeps_other_files),
        cmocka_unit_test(a_folder_in_a_files_place_is_named),
        cmocka_unit_test(plots_are_pictures_and_lie_in_the_report),
    };
    return cmocka_run_group_tests_name("paper command", tests, scratch_make, scratch_remove);
}
