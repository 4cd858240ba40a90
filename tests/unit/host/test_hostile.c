/* SPDX-License-Identifier: MIT
 * What a slip or an attack could do: replace an input, reach the terminal, hang at a pipe. */
#include "base/text.h"
#include "files.h"
#include "run.h"

/* ---- outputs that are inputs ---- */

static void an_output_that_is_also_an_input_is_refused_and_kept(void **state)
{
    (void)state;
    static const char *const commands[] = {
        "render --height out/in.png -o out/in.png",
        "render --height out/in.png -o out/../out/in.png",
        "render --height out/in.png -o out/link.png",
        "render --height out/link.png -o out/in.png",
        "render --height out/in.png -o out/hard.png",
        "render --height - -o out/in.png <out/in.png",
        "render --height out/other.png --albedo out/in.png -o out/in.png",
        "render --height out/other.png --gloss out/in.png -o out/link.png",
        "render --height out/other.png --mask out/in.png -o out/hard.png",
        "render --height out/in.png -o out/new.png --error-map out/link.png",
        "render --height out/in.png --error-map out/in.png",
        "bake --height out/in.png --as raw -o out/link.png",
        "bake --height out/in.png --as c -o out/hard.png",
        "eval - -o out/in.txt <out/in.txt",
        "stream --height out/in.png --to png --frames 1 -o out/in.png",
        "stream --height out/other.png --albedo out/in.png --to png --frames 1 -o out/in.png",
        "stream --height out/other.png --to png --frames 1 --lights out/in.txt -o out/in.txt",
    };
    assert_quiet("cp heights.png out/in.png && cp out/in.png out/other.png && "
                 "cp out/in.png out/kept.png && ln -s in.png out/link.png && ln out/in.png out/hard.png && "
                 "echo 1 1 1 >out/in.txt && cp out/in.txt out/kept.txt");
    const int before = files_in("out");
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT %s", commands[i]);
        assert_fails(line, ": this file is also an input; name another for the output");
        assert_same_file("out/in.png", "out/kept.png");
        assert_same_file("out/in.txt", "out/kept.txt");
        assert_int_equal(files_in("out"), before);
    }
    assert_quiet("$GLINT render --height out/in.png -o out/other.png"); /* as equal as it is, it is another file */
}

/* Frame 12 would have the name of an input: nothing is written, not even frames 0 to 11. */
static void a_frame_that_would_replace_an_input_is_refused_before_the_first_one(void **state)
{
    (void)state;
    static const char *const commands[] = {
        "--height out/frame-0012.png --to png --frames 13",
        "--height heights.png --albedo out/frame-0012.png --to png",
        "--height heights.png --to png --lights out/frame-0012.png",
        "--height heights.png --mask out/same.png --to png --frames 13",
        "--height out/frame-0012.png --to panel --frames 13",
    };
    assert_quiet(
        "cp heights.png out/frame-0012.png && ln out/frame-0012.png out/same.png && cp out/same.png out/copy.png");
    const int before = files_in("out");
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT stream %s -o out/frame-%%04d.png", commands[i]);
        assert_fails(line, "out/frame-0012.png: this file is also an input; name another for the output");
        assert_same_file("out/frame-0012.png", "out/copy.png");
        assert_int_equal(files_in("out"), before);
    }
    assert_quiet("$GLINT stream --height out/frame-0012.png --to png --frames 12 -o out/frame-%04d.png");
}

static void a_source_and_a_header_that_are_one_file_are_refused(void **state)
{
    (void)state;
    assert_quiet("ln -s one.h out/one.c && echo old >out/two.c && ln out/two.c out/two.h");
    assert_fails("$GLINT bake --scene coin -o out/one.c", "out/one.h: leads to the same file as out/one.c; remove the");
    assert_fails("$GLINT table --kind colour -o out/two.c", "out/two.h: leads to the same file as out/two.c");
    assert_fails("$GLINT bake --scene teapot -o out/two.c", "out/two.h: leads to the same file as out/two.c");
    assert_quiet("test ! -e out/one.h && test \"$(cat out/two.h)\" = old && rm out/two.*");
}

/* ---- texts ---- */

static void texts_lose_control_characters_and_what_is_not_utf_8(void **state)
{
    (void)state;
    static const struct {
        const char *text, *clean;
    } texts[] = {
        {"", ""},
        {"plain", "plain"},
        {"\303\244\342\202\254\360\237\230\200", "\303\244\342\202\254\360\237\230\200"}, /* of 2, 3 and 4 bytes */
        {"a\033[31mb\177c\r\n", "a?[31mb?c??"},
        {"a\302\233"
         "31mb",
         "a?31mb"},                                 /* C1: CSI */
        {"\302\200\302\237\302\240", "??\302\240"}, /* the ends of C1 */
        {"a\23331mb", "a?31mb"},                    /* a byte that continues nothing */
        {"\300\233", "??"},                         /* longer than need be */
        {"\340\202\233", "???"},
        {"\355\240\200", "???"},      /* a surrogate */
        {"\364\220\200\200", "????"}, /* beyond U+10FFFF */
        {"\370\210\200\200\200", "?????"},
        {"\342\202", "??"}, /* ends within a character */
        {"\303", "?"},
        {"\303(", "?("},
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        char text[32];
        strcpy(text, texts[i].text);
        assert_string_equal(text_clean(text, false), texts[i].clean);
    }
    char text[] = "a\n\033\302\233";
    assert_string_equal(text_clean(text, true), "a\n\033?");
}

static void file_names_do_not_reach_the_terminal_as_they_are(void **state)
{
    (void)state;
    assert_fails("$GLINT render --height \"$(printf 'no\\302\\23331m')\" -o x.png", "glint: no?31m: No such file");
    assert_fails("$GLINT render --height \"$(printf 'no\\23331m')\" -o x.png", "glint: no?31m: No such file");
    assert_refused("$GLINT \"$(printf 'no\\302\\23331m')\"", "unknown command 'no?31m'");
    const struct run *result =
        run("$GLINT render --scene sphere --size 8x8 --compare -o \"$(printf 'out/a\\302\\2331m.png')\"");
    assert_int_equal(result->status, 0);
    assert_memory_equal(result->out, "out/a?1m.png: ", 14);
}

/* ---- signals ---- */

static void a_signal_at_a_pipe_without_a_reader_ends_a_stream_with_its_status(void **state)
{
    (void)state;
    assert_quiet("mkfifo out/pipe.png");
    static const struct {
        const char *signal;
        int status;
    } signals[] = {{"INT", 130}, {"TERM", 143}};
    for (int i = 0; i < 2; i++) {
        char line[200];
        snprintf(line, sizeof line,
                 "timeout --foreground --preserve-status -s %s 1 $GLINT stream sphere --size 16x16 --to png --frames 1 "
                 "-o out/pipe.png",
                 signals[i].signal);
        const struct run *result = run(line);
        assert_string_equal(result->err, "");
        assert_int_equal(result->status, signals[i].status);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_output_that_is_also_an_input_is_refused_and_kept),
        cmocka_unit_test(a_frame_that_would_replace_an_input_is_refused_before_the_first_one),
        cmocka_unit_test(a_source_and_a_header_that_are_one_file_are_refused),
        cmocka_unit_test(texts_lose_control_characters_and_what_is_not_utf_8),
        cmocka_unit_test(file_names_do_not_reach_the_terminal_as_they_are),
        cmocka_unit_test(a_signal_at_a_pipe_without_a_reader_ends_a_stream_with_its_status),
    };
    return cmocka_run_group_tests_name("hostile", tests, make_maps, scratch_remove);
}
