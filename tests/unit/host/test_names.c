/* SPDX-License-Identifier: MIT
 * Names in written C: what a compiler does not take as the name of data is refused. */
#include "files.h"

#include "base/c_library.h"

/* Of all names of the C library those that a compiler refuses as an array's without any header, by the lines of which it complains. */
static const char list_refused[] =
    "export LC_ALL=C\n"
    "for library in libc.so.6 libm.so.6; do nm -D --defined-only $(${CC:-cc} -print-file-name=$library); done |\n"
    "    awk '{ sub(/@.*/, \"\", $3); print $3 }' | grep -E '^[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*$' | sort -u >names\n"
    "sed 's/.*/extern const unsigned char &[4];/' names | tee names.cc >names.c\n"
    "for compiler in \"${CC:-cc} -fmax-errors=0\" 'clang -ferror-limit=0'; do for file in names.c names.cc; do\n"
    "    command -v ${compiler%% *} >/dev/null && $compiler -Wall -Wextra -fsyntax-only $file 2>&1\n"
    "done; done | sed -n 's/^names\\.cc*:\\([0-9]*\\):[0-9]*: \\(error\\|warning\\):.*/\\1/p' | sort -nu >lines\n"
    "awk 'FNR == NR { wanted[$1]; next } FNR in wanted' lines names";

static void every_name_that_a_compiler_keeps_for_the_c_library_is_known(void **state)
{
    (void)state;
    static char words[1 << 16];
    unsigned count = 0, missed = 0;
    snprintf(words, sizeof words, "%s", run(list_refused)->out);
    for (char *name = strtok(words, "\n"); name; name = strtok(NULL, "\n"), count++)
        if (!is_c_library_name(name)) {
            print_message("# %s is taken\n", name);
            missed++;
        }
    assert_int_equal(missed, 0);
    assert_true(count > 250);
    static const char *const others[] = {"qsort", "time", "read", "rand", "lgammaf_r", "isalpha_l", "thrd_create"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_true(is_c_library_name(others[i]));
}

/* What gcc says of itself: all but names that begin with _. */
static const char list_built_in[] =
    "list=$(gcc -print-file-name=plugin)/include/builtins.def; test -e $list || exit 1\n"
    "sed -n 's/^DEF_\\(\\(\\|EXT_\\)LIB_\\|C[0-9][0-9X]_\\|C99_[A-Z0-9]*_\\|EXT_C99RES_\\|\\)BUILTIN *([^,]*, "
    "*\"\\([^\"]*\\)\".*/\\3/p' $list\n"
    "for suffix in f16 f32 f64 f128 f32x f64x f128x; do\n"
    "    sed -n \"s/^DEF_EXT_LIB_FLOATN_NX_BUILTINS *([^,]*, *\\\"\\([^\\\"]*\\)\\\".*/\\1$suffix/p\" $list\n"
    "done";

static void every_name_that_gcc_builds_in_is_known(void **state)
{
    (void)state;
    static char words[1 << 16];
    unsigned count = 0, missed = 0;
    const struct run *result = run(list_built_in);
    if (result->status != 0)
        skip(); /* Debian: gcc-12-plugin-dev */
    snprintf(words, sizeof words, "%s", result->out);
    for (char *name = strtok(words, "\n"); name; name = strtok(NULL, "\n"), count++)
        if (name[0] != '_' && !is_c_library_name(name)) {
            print_message("# %s is taken\n", name);
            missed++;
        }
    assert_int_equal(missed, 0);
    assert_true(count > 500);
}

static void every_command_that_writes_c_refuses_them(void **state)
{
    (void)state;
    static const char *const commands[] = {"table -n 9", "bake --scene dial --size 8x8 --as c -o out.c", "material"};
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        char command[128];
        snprintf(command, sizeof command, "$GLINT %s --name exp", commands[i]);
        assert_contains(run(command)->err, ": --name: 'exp' is a name of the C library");
    }
    assert_contains(run("$GLINT table -n 9 -o y0.c")->err, ": --name: 'y0' is a name of the C library");
}

static void other_names_are_taken_and_compile_without_a_warning(void **state)
{
    (void)state;
    static const char *const names[] = {"gold",   "torus",       "stream", "memory", "island", "index8",
                                        "string", "gamma_table", "expo",   "c",      "wall_1", "exp_l_f"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char command[128];
        snprintf(command, sizeof command,
                 "$GLINT table -n 9 -o %s.c && ${CC:-cc} -Wall -Wextra -Werror -c %s.c -o name.o", names[i], names[i]);
        const struct run *result = run(command);
        assert_string_equal(result->err, "");
        assert_int_equal(result->status, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_name_that_a_compiler_keeps_for_the_c_library_is_known),
        cmocka_unit_test(every_name_that_gcc_builds_in_is_known),
        cmocka_unit_test(every_command_that_writes_c_refuses_them),
        cmocka_unit_test(other_names_are_taken_and_compile_without_a_warning),
    };
    return cmocka_run_group_tests_name("names", tests, scratch_make, scratch_remove);
}
