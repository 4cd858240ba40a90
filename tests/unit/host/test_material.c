/* SPDX-License-Identifier: MIT
 * glint material: what it prints compiles, and draws the pixels of glint render. */
#include <jansson.h>

#include "files.h"
#include "glint.h"
#include "image/format.h"
#include "models/models.h"
#include "scene/materials.h"
#include "scene/scenes.h"

enum { WIDTH = 12, HEIGHT = 8 };
#define WARN "-Wall -Wextra -Wconversion -pedantic -Werror -I\"$GLINT_SOURCE/lib\" "

/* A program that draws the baked height map with what is printed, and writes a PPM's bytes after its head. */
static const char program[] =
    "printf '#include <stdio.h>\n#include \"stone.h\"\n#include \"look.h\"\n"
    "static unsigned char pixels[3 * 96];\n"
    "int main(void) {\n"
    "struct glint_paint paint;\n"
    "struct glint_light lights[look_light_count];\n"
    "struct glint_maps maps = {stone, 6 * 12, NULL, 0, NULL, 0, NULL, 0, NULL, 0, 0, 0, 0, {0, 0}, NULL, 0};\n"
    "struct glint_surface target = {pixels, 3 * 12, 0, 0};\n"
    "if (glint_paint_exact(&paint, &look, &look_output) != GLINT_OK) return 1;\n"
    "if (look_light(&paint, lights) != GLINT_OK) return 2;\n"
    "if (glint_draw_rect(&paint, &maps, 12, 8, &target, NULL) != GLINT_OK) return 3;\n"
    "fwrite(pixels, 1, sizeof pixels, stdout); return 0; }\n' >out/t.c && cd out && "
    "gcc -std=c99 " WARN "t.c ../lib.a -o t && ./t >c.ppm && "
    "g++ -std=c++11 " WARN "-x c++ t.c -x none ../lib.a -o t && ./t >cxx.ppm";

static int make_library(void **state)
{
    return make_maps(state) == 0 ? library_make() : -1;
}

static void the_printed_material_draws_the_pixels_of_render(void **state)
{
    (void)state;
    static const char *const looks[] = {
        "--model cayley -n 60 --ambient .2",
        "--model phong -n 9 -q 3 --space linear --light 1,2,3 --view .1,0,1 --color 255,0,17",
        "--ambient 0,.5,1 --diffuse .3,.2,.1 --specular 1,0,.7 --dither --clamp-peak --light=-3,0,1",
        "--light 1,1,2,.5,1,2",
        "--point 3,4,5,30,1,.5,.25 --light 1,2,1 --spot 2,2,9,6,4,40,10,30.5 --spot 2,7,9,6,4,40,10,30,0,0,3",
    };
    for (size_t i = 0; i < sizeof looks / sizeof *looks; i++) {
        char line[400];
        assert_quiet("$GLINT bake --height heights.png --to int16 --name stone -o out/stone.h >out/log");
        snprintf(line, sizeof line, "$GLINT material %s --name look -o out/look.h", looks[i]);
        assert_quiet(line);
        snprintf(line, sizeof line,
                 "$GLINT render --height heights.png %s -o out/r.ppm && tail -c %d out/r.ppm >out/w.ppm", looks[i],
                 3 * WIDTH * HEIGHT);
        assert_quiet(line);
        assert_quiet(program);
        assert_same_file("out/c.ppm", "out/w.ppm");
        assert_same_file("out/cxx.ppm", "out/w.ppm");
    }
}

/* The lines in the comment on top name what is linked. */
static void the_example_on_top_compiles_for_every_model_format_and_space(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * GLINT_FORMAT_COUNT || i < GLINT_MODEL_COUNT; i++) {
        char line[900];
        snprintf(line, sizeof line,
                 "$GLINT material --model %s --format %s --space %s --name look -o out/look.h && "
                 "{ echo '#include \"look.h\"'; echo 'int main(void) { struct glint_paint paint; int error;'; "
                 "sed -n 's/^ [*]   //; /^struct\\|^glint\\|^look/p' out/look.h | sed 's/^glint/error = (int)&/; "
                 "s/^look/error += (int)&/'; echo 'return error; }'; } >out/l.c && "
                 "cd out && gcc -std=c99 " WARN "l.c ../lib.a -o l && ./l && g++ -std=c++11 " WARN
                 "-c -x c++ l.c -o l.o",
                 model_names[i % GLINT_MODEL_COUNT], format_names[i % GLINT_FORMAT_COUNT],
                 space_names[i / GLINT_FORMAT_COUNT % 2]);
        assert_quiet(line);
    }
}

static void json_holds_the_same_numbers(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT material --scene coin -n 200 --ambient .2 --light 1,2,4 --format rgb565 --dither --json");
    assert_string_equal(result->err, "");
    json_t *root = json_loads(result->out, 0, NULL);
    const char *model, *format, *space;
    int n, q, ambient, specular[3], light[3], dither;
    assert_int_equal(json_unpack(root, "{s:s, s:i, s:i, s:s, s:s, s:b, s:[i, *], s:[i, i, i], s:[i, i, i]}", "model",
                                 &model, "n", &n, "q", &q, "format", &format, "space", &space, "dither", &dither,
                                 "ambient_q16", &ambient, "specular_q16", &specular[0], &specular[1], &specular[2],
                                 "to_light", &light[0], &light[1], &light[2]),
                     0);
    assert_string_equal(model, "msh");
    assert_string_equal(format, "rgb565");
    assert_string_equal(space, "gamma");
    assert_int_equal(n, 200);
    assert_int_equal(q, 8);
    assert_int_equal(dither, 1);
    assert_int_equal(ambient, 13107);
    assert_int_equal(specular[0], 49152); /* the coin's own: .75, .68, .5 */
    assert_int_equal(specular[2], 32768);
    assert_int_equal(light[2], 1 << 30);
    assert_int_equal(light[0], 1 << 28);
    json_decref(root);
}

static void roughness_is_the_shininess_of_gltf(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        unsigned n;
        bool says; /* what it was held to */
    } wanted[] = {{".5", 30, false},  {".22", 852, false}, {".212", 988, false},
                  {".2", 1000, true}, {"0", 1000, true},   {"1", 1, true}};
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        char line[160], n[32];
        snprintf(line, sizeof line, "$GLINT material --roughness %s --model ggx --json", wanted[i].text);
        const struct run *made = run(line);
        snprintf(n, sizeof n, "\"n\": %u,", wanted[i].n);
        assert_int_equal(made->status, 0);
        assert_contains(made->out, n);
        assert_int_equal(strstr(made->err, "is beyond 1..1000") != NULL, wanted[i].says);
    }
    assert_int_equal(run("$GLINT material --roughness 1.1")->status, 2);
    assert_refused("$GLINT material --roughness .05 --material nope", "unknown material 'nope'");
    assert_refused("$GLINT table --roughness .05 --raw --name a", "--name is for C source");
    assert_quiet("$GLINT table --roughness .05 --shininess 60 -o a.h && $GLINT table -n 60 -o b.h && cmp a.h b.h");
    assert_quiet("$GLINT material --roughness .05 -n 60 --json | grep -q '\"n\": 60,'");
}

static int lines_with(const char *text, const char *start)
{
    int count = 0;
    for (; text; text = strchr(text, '\n'), text = text ? text + 1 : NULL)
        count += strncmp(text, start, strlen(start)) == 0;
    return count;
}

/* So that nobody edits one without the other. */
static void the_header_of_materials_is_what_the_command_writes(void **state)
{
    (void)state;
    assert_quiet(
        "$GLINT material --all -o out/materials.h && cmp out/materials.h \"$GLINT_SOURCE\"/lib/examples/materials.h");
    assert_quiet("echo '#include \"materials.h\"' >out/m.c && gcc -std=c99 " WARN "-c out/m.c -o out/m.o && "
                 "g++ -std=c++11 " WARN "-c -x c++ out/m.c -o out/m.o");
}

static void each_material_is_listed_with_the_source_of_its_colour(void **state)
{
    (void)state;
    static char list[65536];
    strcpy(list, run("$GLINT material --list")->out);
    for (unsigned i = 0; preset_names[i]; i++) {
        const struct preset preset = preset_of(i);
        assert_int_equal(lines_with(list, preset.name), 1);
        assert_contains(list, preset.source);
    }
}

/* Those of the list, but for what an option gives. */
static void options_beside_a_material_override_it(void **state)
{
    (void)state;
    const struct preset gold = preset_of(0);
    static const char *const names[] = {"--preset", "--material"};
    for (int i = 0; i < 2; i++) {
        char line[200];
        int n, specular, diffuse, albedo[3];
        snprintf(line, sizeof line, "$GLINT material %s gold -n 77 --specular .25 --json", names[i]);
        json_t *root = json_loads(run(line)->out, 0, NULL);
        assert_int_equal(json_unpack(root, "{s:i, s:[i, *], s:[i, *], s:[i, i, i]}", "n", &n, "specular_q16", &specular,
                                     "diffuse_q16", &diffuse, "albedo", &albedo[0], &albedo[1], &albedo[2]),
                         0);
        assert_int_equal(n, 77);
        assert_int_equal(specular, 16384);
        assert_int_equal(diffuse, (int)(gold.finish.diffuse[0] * 65536 + .5));
        for (int k = 0; k < 3; k++)
            assert_int_equal(albedo[k], gold.color[k]);
        json_decref(root);
    }
}

/* The ball, not the wall behind it; --color is of all; a height map has the material's colour throughout. */
static void a_scene_is_made_of_the_material(void **state)
{
    (void)state;
    struct scene *own = scene_draw("sphere", 64, 64),
                 *jade = scene_draw_in("sphere", 64, 64, preset_of(11).color, false);
    assert_memory_equal(own->albedo, jade->albedo, 3);
    assert_memory_equal(&jade->albedo[3 * (32 * 64 + 32)], preset_of(11).color, 3);
    scene_free(own);
    scene_free(jade);
    assert_quiet("$GLINT render --height heights.png --material copper -o out/a.ppm");
    char line[200];
    const struct preset copper = preset_of(2);
    snprintf(line, sizeof line, "$GLINT render --height heights.png --material copper --color %d,%d,%d -o out/b.ppm",
             copper.color[0], copper.color[1], copper.color[2]);
    assert_quiet(line);
    assert_same_file("out/a.ppm", "out/b.ppm");
}

static void wrong_values_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *options, *part;
    } wrong[] = {
        {"--json --point 1,2,3,4", "--json: has one --light without a colour"},
        {"--json --light 1,1,1 --light 1,2,1", "--json: has one --light without a colour"},
        {"--json --light 1,1,1,.5,.5,.5", "--json: has one --light without a colour"},
        {"--json --name x", "--name is for C source"},
        {"--name int", "--name: 'int'"},
        {"out.h", "unexpected argument 'out.h'"},
        {"--scene ball", "sphere, watchface, coin"},
        {"-n 0", "-n"},
        {"--material golf", "--material: unknown material 'golf'"},
        {"--preset mud", "--preset: unknown material 'mud'"},
        {"--across 0", "--across"},
        {"--list --all", "give only one of --list, --all and --json"},
        {"--all --preset gold", "--all is of all materials; leave out --material and --preset"},
        {"--list --name x", "--list is of all materials; leave out --name"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT material %s", wrong[i].options);
        assert_refused(line, wrong[i].part);
    }
    assert_refused("$GLINT render -o out/x.png", "no surface"); /* which material alone leaves out */
}

/* These are no part of a material or of tables, and options that change nothing are not offered. */
static void commands_that_draw_nothing_have_no_options_of_maps_meshes_and_paths(void **state)
{
    (void)state;
    static const char *const commands[] = {"material", "table"};
    static const char *const options[] = {"mesh",        "crease", "split",   "axes",   "turn",  "zoom",
                                          "perspective", "height", "normals", "mask",   "scale", "bevel",
                                          "wrap",        "flip-y", "size",    "albedo", "gloss", "path"};
    static char of_render[65536];
    strcpy(of_render, run("$GLINT render --_options")->out);
    for (size_t c = 0; c < 2; c++) {
        char line[200], word[40];
        for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
            snprintf(line, sizeof line, "$GLINT %s --%s=20", commands[c], options[i]);
            snprintf(word, sizeof word, "unknown option '--%s'", options[i]);
            assert_refused(line, word);
        }
        snprintf(line, sizeof line, "$GLINT %s --_options", commands[c]);
        const char *offered = run(line)->out;
        assert_int_equal(lines_with(offered, "--model"), 1);
        for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
            snprintf(word, sizeof word, "--%s", options[i]);
            assert_int_equal(lines_with(offered, word), 0);
            assert_int_equal(lines_with(of_render, word), 1);
        }
    }
    assert_int_equal(run("$GLINT material --scene teapot -o out/teapot.h")->status, 0); /* its finish */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_printed_material_draws_the_pixels_of_render),
        cmocka_unit_test(the_example_on_top_compiles_for_every_model_format_and_space),
        cmocka_unit_test(json_holds_the_same_numbers),
        cmocka_unit_test(roughness_is_the_shininess_of_gltf),
        cmocka_unit_test(the_header_of_materials_is_what_the_command_writes),
        cmocka_unit_test(each_material_is_listed_with_the_source_of_its_colour),
        cmocka_unit_test(options_beside_a_material_override_it),
        cmocka_unit_test(a_scene_is_made_of_the_material),
        cmocka_unit_test(wrong_values_are_refused),
        cmocka_unit_test(commands_that_draw_nothing_have_no_options_of_maps_meshes_and_paths),
    };
    return cmocka_run_group_tests_name("material", tests, make_library, scratch_remove);
}
