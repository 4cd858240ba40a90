/* SPDX-License-Identifier: MIT
 * Windows of baked maps, and the highlight's box of rectangles over tables. */
#include "tables_model.h"

enum { BALL_W = 61, BALL_H = 47, CASES = 240 };
static struct glint_vec vectors[BALL_W * BALL_H]; /* as the loops read them */
static uint32_t packed[BALL_W * BALL_H];
static uint16_t map[BALL_W * BALL_H];
static uint32_t memory[2][GLINT_TABLES_DITHER_BYTES / 4];

/* A ball that leaves the corners without a surface. */
static void make_ball(enum glint_normals held)
{
    for (int i = 0; i < BALL_W * BALL_H; i++) {
        const double x = (i % BALL_W - 30) / 27., y = (23 - i / BALL_W) / 22., zz = 1 - x * x - y * y;
        struct glint_vec *n = &vectors[i];
        *n = (struct glint_vec){0, 0, 0};
        if (zz > 0)
            *n = (struct glint_vec){(int16_t)lrint(32767 * x), (int16_t)lrint(32767 * y),
                                    (int16_t)lrint(32767 * sqrt(zz))};
        packed[i] = glint_normals_pack(held, n);
        if (held != GLINT_NORMALS_INT16)
            *n = glint_normals_unpack(held, packed[i]);
        map[i] = (uint16_t)below(65536);
    }
}

/* Tables of a kind that this case draws with; the second ones for the same without a highlight. */
struct box_case {
    enum glint_normals held;
    const void *normals;
    ptrdiff_t stride;
    struct glint_tables tables, plain;
    struct glint_tables_light light, plain_light;
    uint16_t x, y, w, h;
};

static void case_init(struct box_case *c, unsigned i)
{
    const enum glint_tables_kind kind = (enum glint_tables_kind)(i % 3);
    struct glint_shader shader =
        tables_shader(kind == GLINT_TABLES_SMALL ? format_number(i / 3) : (enum glint_format)below(2));
    c->held = (enum glint_normals)(i / 3 % 3);
    shader.dither = kind == GLINT_TABLES_SMALL ? below(2) : kind == GLINT_TABLES_COLOUR && i / 9 % 2;
    if (i % 7 == 0 && c->held != GLINT_NORMALS_INT8)
        assert_int_equal(glint_light_init(&shader.light, (int32_t[]){1, 2, 3}, (int32_t[]){1, -1, 3}), GLINT_OK);
    for (int k = 0; k < 3 && kind == GLINT_TABLES_ALBEDO; k++) {
        shader.material.ambient_q16[k] = 6000;
        shader.material.diffuse_q16[k] = 50000;
    }
    make_ball(c->held);
    c->normals = c->held == GLINT_NORMALS_INT16 ? (const void *)vectors : packed;
    c->stride = BALL_W * (c->held == GLINT_NORMALS_INT16 ? 6 : 4);
    assert_int_equal(glint_tables_fill(&c->tables, kind, &shader, memory[0], sizeof memory[0]), GLINT_OK);
    assert_int_equal(glint_tables_light_init(&c->light, &c->tables, &shader.light), GLINT_OK);
    memset(shader.material.specular_q16, 0, sizeof shader.material.specular_q16);
    assert_int_equal(glint_tables_fill(&c->plain, kind, &shader, memory[1], sizeof memory[1]), GLINT_OK);
    assert_int_equal(glint_tables_light_init(&c->plain_light, &c->plain, &shader.light), GLINT_OK);
    c->x = (uint16_t)below(BALL_W);
    c->y = (uint16_t)below(BALL_H);
    c->w = (uint16_t)below(BALL_W - c->x + 1);
    c->h = (uint16_t)below(BALL_H - c->y + 1);
}

/* The window x, y, w, h into `out`, whose first line is that of line 0 and whose lines are SIDE bytes long. */
enum { SIDE = 4 * BALL_W };
static void draw_window(const struct box_case *c, bool plain, uint16_t x, uint16_t y, uint16_t w, uint16_t h,
                        uint8_t *out)
{
    const struct glint_tables *tables = plain ? &c->plain : &c->tables;
    const struct glint_tables_light *light = plain ? &c->plain_light : &c->light;
    const struct glint_surface surface = {out + SIDE * y + bytes_of((enum glint_format)tables->format, x), SIDE, x, y};
    const void *from = glint_normals_window(c->held, c->normals, c->stride, x, y);
    if (tables->kind == GLINT_TABLES_ALBEDO)
        assert_int_equal(glint_tables_albedo_rect(tables, light, c->held, from, c->stride, map + BALL_W * y + x,
                                                  2 * BALL_W, w, h, &surface),
                         GLINT_OK);
    else
        assert_int_equal(glint_tables_rect(tables, light, c->held, from, c->stride, w, h, &surface), GLINT_OK);
}

static struct glint_box box_of(const struct box_case *c, uint16_t x, uint16_t y, uint16_t w, uint16_t h)
{
    struct glint_box box = {9, 9, 9, 9};
    const void *from = glint_normals_window(c->held, c->normals, c->stride, x, y);
    assert_int_equal(glint_tables_box(&c->tables, &c->light, c->held, from, c->stride, w, h, &box), GLINT_OK);
    assert_true(box.w ? box.h && box.x + box.w <= w && box.y + box.h <= h : !(box.x | box.y | box.h));
    return box;
}

static void a_window_of_a_map_is_that_part_of_the_picture(void **state)
{
    (void)state;
    static uint8_t whole[SIDE * BALL_H], part[SIDE * BALL_H];
    struct box_case c;
    for (unsigned i = 0; i < CASES; i++) {
        case_init(&c, i);
        memset(whole, 0, sizeof whole);
        memset(part, 0, sizeof part);
        const enum glint_format format = (enum glint_format)c.tables.format;
        if (format == GLINT_MONO)
            c.x &= 0xfff8; /* on a byte */
        draw_window(&c, false, 0, 0, BALL_W, BALL_H, whole);
        draw_window(&c, false, c.x, c.y, c.w, c.h, part);
        for (unsigned y = 0; y < BALL_H; y++)
            for (unsigned x = 0; x < BALL_W; x++) {
                unsigned in_part[3], in_whole[3] = {0, 0, 0};
                stored_levels(format, part + SIDE * y, x, in_part);
                if (x >= c.x && y >= c.y && x < c.x + (unsigned)c.w && y < c.y + (unsigned)c.h)
                    stored_levels(format, whole + SIDE * y, x, in_whole);
                assert_memory_equal(in_part, in_whole, sizeof in_part);
            }
    }
}

static void beyond_the_box_the_picture_does_not_depend_on_the_highlight(void **state)
{
    (void)state;
    static uint8_t lit[SIDE * BALL_H], plain[SIDE * BALL_H];
    struct box_case c;
    unsigned differ = 0, empty = 0;
    for (unsigned i = 0; i < CASES; i++) {
        case_init(&c, i);
        memset(lit, 0, sizeof lit);
        memset(plain, 0, sizeof plain);
        c.x = c.tables.format == GLINT_MONO ? 0 : c.x;
        draw_window(&c, false, c.x, c.y, c.w, c.h, lit);
        draw_window(&c, true, c.x, c.y, c.w, c.h, plain);
        const struct glint_box box = box_of(&c, c.x, c.y, c.w, c.h);
        empty += box.w == 0;
        for (unsigned y = 0; y < BALL_H; y++)
            for (unsigned x = 0; x < BALL_W; x++) {
                unsigned a[3], b[3];
                stored_levels((enum glint_format)c.tables.format, lit + SIDE * y, x, a);
                stored_levels((enum glint_format)c.tables.format, plain + SIDE * y, x, b);
                if (memcmp(a, b, sizeof a) == 0)
                    continue;
                differ++;
                assert_in_range(x - c.x, box.x, box.x + box.w - 1u);
                assert_in_range(y - c.y, box.y, box.y + box.h - 1u);
            }
    }
    assert_in_range(differ, 5000, CASES * BALL_W * BALL_H);
    assert_in_range(empty, 10, 2 * CASES / 3);
}

/* Grows a box by a pixel of a window. */
static void add(struct glint_box *box, unsigned x, unsigned y)
{
    const unsigned right = box->w ? box->x + box->w : 0u;
    box->y = (uint16_t)(box->w ? box->y : y);
    box->x = (uint16_t)(box->w && box->x < x ? box->x : x);
    box->w = (uint16_t)((right > x + 1 ? right : x + 1) - box->x);
    box->h = (uint16_t)(y + 1 - box->y);
}

static bool holds(const struct glint_box *outer, const struct glint_box *inner)
{
    return !inner->w || (outer->w && outer->x <= inner->x && outer->y <= inner->y &&
                         outer->x + outer->w >= inner->x + inner->w && outer->y + outer->h >= inner->y + inner->h);
}

/* The loops' t and N.L are those of the vectors but for roundings, those of L and H to Q14. (How small a box SMALL tables may have depends on
 * columns whose step is 0: the test above holds it.) */
static void the_box_is_the_smallest_that_holds_the_tables_highlight(void **state)
{
    (void)state;
    const int64_t slack = 1 << 18;
    struct box_case c;
    unsigned same = 0;
    for (unsigned i = 0; i < CASES; i++) {
        case_init(&c, i);
        const struct glint_box box = box_of(&c, c.x, c.y, c.w, c.h);
        const bool small = c.tables.kind == GLINT_TABLES_SMALL;
        struct glint_box least = {0, 0, 0, 0}, most = {0, 0, 0, 0};
        for (unsigned y = 0; y < c.h; y++)
            for (unsigned x = 0; x < c.w; x++) {
                const struct glint_vec n = vectors[BALL_W * (c.y + y) + c.x + x];
                const int64_t nl = dot(n, c.light.l), dx = n.x - c.light.h.x, dy = n.y - c.light.h.y,
                              dz = n.z - c.light.h.z;
                const int64_t t = (dx * dx + dy * dy + dz * dz) / 2, last = c.tables.t_max_q30;
                if (!(n.x | n.y | n.z))
                    continue;
                if (nl >= -slack && t <= last + slack)
                    add(&most, x, y);
                if (nl > slack && t <= (small ? 0 : last) - slack)
                    add(&least, x, y);
            }
        assert_true(holds(&most, &box));
        assert_true(holds(&box, &least));
        same += !memcmp(&most, &least, sizeof most);
    }
    assert_in_range(same, CASES / 5, CASES);
}

static void a_box_is_refused_what_a_rectangle_is(void **state)
{
    (void)state;
    struct box_case c;
    case_init(&c, 3); /* COLOUR, 10 bits */
    struct glint_box box = {1, 2, 3, 4};
    const struct glint_box before = box;
    const enum glint_normals wrong = (enum glint_normals)3, int10 = GLINT_NORMALS_INT10, int8 = GLINT_NORMALS_INT8;
    struct glint_tables_light aside = c.light;
    aside.frontal = false;
    assert_int_equal(glint_tables_box(NULL, &c.light, int10, packed, 8, 2, 1, &box), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_box(&c.tables, NULL, int10, packed, 8, 2, 1, &box), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_box(&c.tables, &c.light, int10, NULL, 8, 2, 1, &box), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_box(&c.tables, &c.light, int10, packed, 8, 2, 1, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_box(&c.tables, &c.light, int10, packed, 6, 2, 1, &box), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_box(&c.tables, &c.light, wrong, packed, 8, 2, 1, &box), GLINT_ERR_FORMAT);
    assert_int_equal(glint_tables_box(&c.tables, &aside, int8, packed, 8, 2, 1, &box), GLINT_ERR_VECTOR);
    assert_memory_equal(&box, &before, sizeof box);
    assert_int_equal(glint_tables_box(&c.tables, &c.light, int10, packed, 8, 0, 5, &box), GLINT_OK);
    assert_true(!(box.x | box.y | box.w | box.h));
}

/* INT10's d of sequence.md, and v. */
static int64_t grazing(const struct glint_tables_light *light, int32_t x, int32_t y, int32_t z, int64_t *v)
{
    const int64_t dx = 32 * x - ((light->h.x + 1) >> 1), dy = 32 * y - ((light->h.y + 1) >> 1);
    const int64_t dz = 8 * z - ((light->h.z + 1) >> 1);
    *v = dx * dx + dy * dy + dz * dz;
    return light->peak - (light->peak >> 15) * (*v >> 14) - ((int64_t)z << 18);
}

/* d < 0 is dark, so d = 0 is not; words of which it is 0 are few. Of x and y the z where d, which falls, changes its sign. */
static void the_box_holds_what_the_light_grazes(void **state)
{
    (void)state;
    struct glint_shader shader = tables_shader(GLINT_RGB565);
    struct glint_tables tables;
    struct glint_tables_light light;
    shader.dither = false;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 1, 6);
    for (int k = 0; k < 3; k++)
        shader.material.specular_q16[k] = 65536;
    unsigned found = 0;
    for (int32_t lz = 100; lz < 600; lz += 10) {
        assert_int_equal(glint_light_init(&shader.light, (int32_t[]){1000, 0, lz}, (int32_t[]){0, 0, 1}), GLINT_OK);
        assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory[0], sizeof memory[0]),
                         GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
        for (int32_t i = 0; i < 256 * 511; i++) {
            const int32_t x = i % 511 - 255, y = i / 511;
            int32_t z = 0;
            int64_t v;
            for (int32_t bit = 1024; bit; bit /= 2)
                z += grazing(&light, x, y, z + bit, &v) >= 0 ? bit : 0;
            const int64_t d = grazing(&light, x, y, z, &v);
            if (z == 0 || d != 0 || v > tables.t_max_q30 >> 1)
                continue;
            const uint32_t word = (uint32_t)x << 22 | (uint32_t)y << 12 | (uint32_t)z;
            struct glint_box box;
            assert_int_equal(glint_tables_box(&tables, &light, GLINT_NORMALS_INT10, &word, 4, 1, 1, &box), GLINT_OK);
            assert_int_equal(box.w, 1);
            found++;
        }
    }
    assert_true(found > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_window_of_a_map_is_that_part_of_the_picture),
        cmocka_unit_test(beyond_the_box_the_picture_does_not_depend_on_the_highlight),
        cmocka_unit_test(the_box_is_the_smallest_that_holds_the_tables_highlight),
        cmocka_unit_test(the_box_holds_what_the_light_grazes),
        cmocka_unit_test(a_box_is_refused_what_a_rectangle_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
