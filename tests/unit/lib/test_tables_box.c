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

/* A paint of tables that this case draws with; the second one for the same without a highlight. */
struct box_case {
    enum glint_normals held;
    struct look look;
    struct glint_paint paint, plain;
    struct glint_maps maps;
    uint16_t x, y, w, h;
};

static void case_init(struct box_case *c, unsigned i)
{
    const enum glint_tables_kind kind = i % 3 == 2 ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR;
    struct look look = tables_look((enum glint_format)below(2));
    c->held = (enum glint_normals)(i / 3 % 2);
    look.output.dither = i % 3 == 1;
    if (i % 7 == 0 && c->held != GLINT_NORMALS_INT8)
        assert_int_equal(look_light(&look, (int32_t[]){1, 2, 3}, (int32_t[]){1, -1, 3}), GLINT_OK);
    if (kind == GLINT_TABLES_ALBEDO)
        make_grey(&look, 6000, 50000);
    make_ball(c->held);
    const bool is_8 = c->held == GLINT_NORMALS_INT8;
    c->maps = (struct glint_maps){.normals = is_8 ? (const void *)packed : vectors,
                                  .normals_stride = BALL_W * (is_8 ? 4 : 6),
                                  .normals_format = (uint8_t)c->held};
    if (kind == GLINT_TABLES_ALBEDO) {
        c->maps.albedo = (const uint8_t *)map;
        c->maps.albedo_stride = 2 * BALL_W;
        c->maps.albedo_format = GLINT_RGB565;
    }
    c->look = look;
    paint_of_tables(&c->paint, kind, &look, memory[0]);
    memset(look.material.specular_q16, 0, sizeof look.material.specular_q16);
    paint_of_tables(&c->plain, kind, &look, memory[1]);
    c->x = (uint16_t)below(BALL_W);
    c->y = (uint16_t)below(BALL_H);
    c->w = (uint16_t)below(BALL_W - c->x + 1);
    c->h = (uint16_t)below(BALL_H - c->y + 1);
}

/* The case's window into `out`, whose first line is that of line 0. At an odd address, where lines are not aligned, too. */
enum { SIDE = 2 * BALL_W, ROOM = SIDE * BALL_H + 1 };
static void draw_window(const struct box_case *c, const struct glint_paint *paint, uint8_t *out, struct glint_box *box)
{
    const struct glint_surface surface = {out + SIDE * c->y + 2 * c->x, SIDE, c->x, c->y};
    struct glint_maps maps = c->maps;
    maps.normals = glint_normals_window(c->held, maps.normals, maps.normals_stride, c->x, c->y);
    if (maps.albedo)
        maps.albedo += 2 * (BALL_W * c->y + c->x);
    assert_int_equal(glint_draw_rect(paint, &maps, c->w, c->h, &surface, box), GLINT_OK);
}

static struct glint_box box_of(const struct box_case *c)
{
    static uint8_t scratch[ROOM];
    struct glint_box box = {9, 9, 9, 9};
    draw_window(c, &c->paint, scratch, &box);
    assert_true(box.w ? box.h && box.x + box.w <= c->w && box.y + box.h <= c->h : !(box.x | box.y | box.h));
    return box;
}

static void a_window_of_a_map_is_that_part_of_the_picture(void **state)
{
    (void)state;
    static uint8_t whole[ROOM], part[ROOM];
    struct box_case c;
    for (unsigned i = 0; i < CASES; i++) {
        case_init(&c, i);
        struct box_case all = c;
        struct glint_box box;
        const unsigned odd = i / 6 % 2;
        all.x = all.y = 0;
        all.w = BALL_W;
        all.h = BALL_H;
        memset(whole, 0, sizeof whole);
        memset(part, 0, sizeof part);
        draw_window(&all, &all.paint, whole, NULL);
        draw_window(&c, &c.paint, part + odd, i & 1 ? &box : NULL); /* whether a box is asked for or not */
        for (unsigned y = 0; y < BALL_H; y++)
            for (unsigned x = 0; x < BALL_W; x++) {
                const bool inside = x >= c.x && y >= c.y && x < c.x + (unsigned)c.w && y < c.y + (unsigned)c.h;
                const uint8_t none[2] = {0, 0};
                assert_memory_equal(part + odd + SIDE * y + 2 * x, inside ? whole + SIDE * y + 2 * x : none, 2);
            }
    }
}

static void beyond_the_box_the_picture_does_not_depend_on_the_highlight(void **state)
{
    (void)state;
    static uint8_t lit[ROOM], plain[ROOM];
    struct box_case c;
    unsigned differ = 0, empty = 0;
    for (unsigned i = 0; i < CASES; i++) {
        case_init(&c, i);
        struct glint_box box;
        memset(lit, 0, sizeof lit);
        memset(plain, 0, sizeof plain);
        draw_window(&c, &c.paint, lit, &box);
        draw_window(&c, &c.plain, plain, NULL);
        empty += box.w == 0;
        for (unsigned y = 0; y < BALL_H; y++)
            for (unsigned x = 0; x < BALL_W; x++) {
                if (memcmp(lit + SIDE * y + 2 * x, plain + SIDE * y + 2 * x, 2) == 0)
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

/* The loops' t and N.L are those of the vectors but for roundings, those of L and H to Q14. */
static void the_box_is_the_smallest_that_holds_the_tables_highlight(void **state)
{
    (void)state;
    const int64_t slack = 1 << 18;
    struct box_case c;
    unsigned same = 0;
    for (unsigned i = 0; i < CASES; i++) {
        case_init(&c, i);
        const struct glint_box box = box_of(&c);
        struct glint_box least = {0, 0, 0, 0}, most = {0, 0, 0, 0};
        for (unsigned y = 0; y < c.h; y++)
            for (unsigned x = 0; x < c.w; x++) {
                const struct glint_vec n = vectors[BALL_W * (c.y + y) + c.x + x];
                const int64_t nl = dot(n, c.look.l), t = t_of(n, c.look.h), last = c.paint.of.tables.filled.t_max_q30;
                if (!is_surface(n))
                    continue;
                if (nl >= -slack && t <= last + slack)
                    add(&most, x, y);
                if (nl > slack && t <= last - slack)
                    add(&least, x, y);
            }
        assert_true(holds(&most, &box));
        assert_true(holds(&box, &least));
        same += same_box(&most, &least);
    }
    assert_in_range(same, CASES / 5, CASES);
}

/* N.L < 0 is dark, so 0 is not: a light from the side, and normals across it. (ALBEDO's d of INT8 has the other sign, and is dark at 0.) */
static void the_box_holds_what_the_light_grazes(void **state)
{
    (void)state;
    static const struct glint_vec up = {0, 0, 32767};
    struct look look = tables_look(GLINT_RGB565);
    set_model(&look, GLINT_MSH, 1, 16);
    assert_int_equal(look_light(&look, (const int32_t[]){1, 0, 0}, in_front), GLINT_OK);
    make_grey(&look, 0, 50000);
    for (int k = 0; k < 3; k++)
        look.material.specular_q16[k] = 65536;
    for (unsigned i = 0; i < 12; i++) {
        const enum glint_tables_kind kind = i % 3 == 2 ? GLINT_TABLES_ALBEDO : GLINT_TABLES_COLOUR;
        struct glint_paint paint;
        uint16_t out[2] = {0, 0};
        const uint16_t albedo = 0;
        struct glint_box box;
        look.output.dither = i % 3 == 1;
        paint_of_tables(&paint, kind, &look, memory[0]);
        const bool is_8 = i / 3 & 1;
        const uint32_t word = glint_normals_pack(GLINT_NORMALS_INT8, &up);
        const struct glint_maps maps = {.normals = is_8 ? (const void *)&word : &up,
                                        .normals_format = is_8 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT16,
                                        .albedo = kind == GLINT_TABLES_ALBEDO ? (const uint8_t *)&albedo : NULL,
                                        .albedo_format = GLINT_RGB565};
        const struct glint_surface surface = {(uint8_t *)out + (i >= 6), 2, 0, 0};
        assert_int_equal(glint_draw_rect(&paint, &maps, 1, 1, &surface, &box), GLINT_OK);
        const bool shines = !is_8 || kind != GLINT_TABLES_ALBEDO;
        assert_int_equal(box.w, shines);
        assert_int_equal(box.h, shines);
        assert_int_equal(out[0] || out[1], shines);
    }
}

/* As of a rectangle: a pixel at a time. */
static void the_box_of_a_span_is_that_of_its_pixels(void **state)
{
    (void)state;
    unsigned some = 0;
    for (unsigned i = 0; i < CASES; i++) {
        struct box_case c;
        uint16_t line[BALL_W], alone[BALL_W];
        uint8_t coverage[BALL_W];
        case_init(&c, i);
        const struct glint_span span = {below(c.paint.of.tables.filled.t_max_q30 + (1 << 20)),
                                        below(1 << 25) - (1u << 24),
                                        below(1 << 18),
                                        (int32_t)below(1u << 30) - (1 << 28),
                                        (int32_t)below(1 << 25) - (1 << 24),
                                        BALL_W,
                                        {{0, 0}, {0, 0}}};
        struct glint_box box, least = {0, 0, 0, 0};
        struct glint_maps maps = c.maps;
        for (unsigned x = 0; x < BALL_W; x++)
            coverage[x] = (uint8_t)below(3);
        maps.coverage = i & 1 ? coverage : NULL;
        const struct glint_surface surface = {line, 2, 0, 5};
        memset(line, GUARD, sizeof line);
        memset(alone, GUARD, sizeof alone);
        assert_int_equal(glint_draw_span(&c.paint, &span, &maps, &surface, &box), GLINT_OK);
        uint32_t t = span.t_q30, dt = span.dt_q30, nl = (uint32_t)span.nl_q30;
        for (unsigned x = 0; x < BALL_W; x++) {
            const struct glint_span one = {t, 0, 0, (int32_t)nl, 0, 1, {{0, 0}, {0, 0}}};
            struct glint_maps here = {.albedo = maps.albedo ? maps.albedo + 2 * x : NULL,
                                      .albedo_format = GLINT_RGB565,
                                      .coverage = maps.coverage ? coverage + x : NULL};
            const struct glint_surface at = {alone + x, 2, (uint16_t)x, 5};
            struct glint_box pixel;
            assert_int_equal(glint_draw_span(&c.paint, &one, &here, &at, &pixel), GLINT_OK);
            const uint32_t used = t >= UINT32_C(0xf8000000) ? 0 : t;
            const bool shines = (int32_t)nl >= 0 && used <= c.paint.of.tables.filled.t_max_q30;
            assert_int_equal(pixel.w, shines && (!maps.coverage || coverage[x]));
            if (pixel.w)
                add(&least, x, 0);
            t += dt;
            dt += span.ddt_q30;
            nl += (uint32_t)span.dnl_q30;
        }
        assert_memory_equal(line, alone, sizeof line);
        assert_true(same_box(&box, &least));
        some += box.w > 0;
    }
    assert_in_range(some, CASES / 4, CASES - 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_window_of_a_map_is_that_part_of_the_picture),
        cmocka_unit_test(beyond_the_box_the_picture_does_not_depend_on_the_highlight),
        cmocka_unit_test(the_box_is_the_smallest_that_holds_the_tables_highlight),
        cmocka_unit_test(the_box_holds_what_the_light_grazes),
        cmocka_unit_test(the_box_of_a_span_is_that_of_its_pixels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
