/* test_harness.c -- what a block about code asks: its inputs with their shapes, its language, and the points that are tried. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/code/harness.h"
#include "exact/code/points.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

/* The block with these lines, to be freed. */
static struct cagd_code_harness *block(const char *lines)
{
    char text[2000];
    struct cagd_code_harness_error error;
    snprintf(text, sizeof text, ":::{exactly} it\n%s\n:call: double r = 1;\n:output: r\n:::\n", lines);
    struct cagd_code_harness *h = cagd_code_read_harness(text, &error);
    if (h == NULL)
        fail_msg("%s: line %d: %s", lines, error.line, error.cause);
    return h;
}

static void inputs_have_the_shapes_that_are_written(void **state)
{
    (void)state;
    static const struct {
        const char *text, *name, *low, *high;
        int count, open_low, open_high;
        enum cagd_code_shape shape;
    } list[] = {
        {"x", "x", NULL, NULL, 0, 0, 0, CAGD_CODE_ANY},
        {"x[3]", "x", NULL, NULL, 3, 0, 0, CAGD_CODE_ANY},
        {"x > 0", "x", NULL, NULL, 0, 0, 0, CAGD_CODE_POSITIVE},
        {"x[2] > 0", "x", NULL, NULL, 2, 0, 0, CAGD_CODE_POSITIVE},
        {"x in [0, 1]", "x", "0", "1", 0, 0, 0, CAGD_CODE_BETWEEN},
        {"x in [0, 1)", "x", "0", "1", 0, 0, 1, CAGD_CODE_BETWEEN},
        {"x in (0, 1]", "x", "0", "1", 0, 1, 0, CAGD_CODE_BETWEEN},
        {"x in (-1/2,  7/3)", "x", "-1/2", "7/3", 0, 1, 1, CAGD_CODE_BETWEEN},
        {"x[2] in [a, b[1]]", "x", "a", "b[1]", 2, 0, 0, CAGD_CODE_BETWEEN},
        {"x[4] increasing", "x", NULL, NULL, 4, 0, 0, CAGD_CODE_INCREASING},
        {"x[4] nondecreasing", "x", NULL, NULL, 4, 0, 0, CAGD_CODE_NONDECREASING},
        {"x = 3/4", "x", NULL, NULL, 0, 0, 0, CAGD_CODE_FIXED},
        {"x[2] = 1 -2", "x", NULL, NULL, 2, 0, 0, CAGD_CODE_FIXED},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        char line[100];
        snprintf(line, sizeof line, ":input: a; b[2]; %s; z", list[k].text);
        struct cagd_code_harness *h = block(line);
        const struct cagd_code_asked_input *in = &h->input[2];
        assert_int_equal(h->inputs, 4);
        assert_string_equal(h->input[3].name, "z");
        assert_string_equal(in->name, list[k].name);
        assert_int_equal(in->count, list[k].count);
        assert_int_equal(in->shape, list[k].shape);
        if (list[k].low != NULL) {
            assert_string_equal(in->low, list[k].low);
            assert_string_equal(in->high, list[k].high);
            assert_int_equal(in->open_low, list[k].open_low);
            assert_int_equal(in->open_high, list[k].open_high);
        }
        if (in->shape == CAGD_CODE_FIXED)
            assert_string_equal(in->value[in->count > 0 ? in->count - 1 : 0], in->count > 0 ? "-2" : "3/4");
        /* a variable for each number that is not fixed: of a, b[2], z and x */
        assert_int_equal(cagd_code_variables(h), 4 + (in->shape == CAGD_CODE_FIXED ? 0
                                                      : in->count > 0              ? in->count
                                                                                   : 1));
        cagd_code_harness_free(h);
    }
}

static void the_language_is_that_of_a_source(void **state)
{
    (void)state;
    static const struct {
        const char *lines;
        int is_cpp;
    } list[] = {{":source: a.c", 0},
                {":source: a.cc", 1},
                {":source: a.cpp", 1},
                {":source: a.cxx", 1},
                {":source: a.C", 1},
                {":source: .cc", 0},
                {":source: a.cc.c", 0},
                {":source: acc", 0},
                {":source: a.cpp.h", 0},
                {":source: a.bc", 0},
                {":source: a.c\n:source: b.C", 1},
                {":source: a.C\n:source: b.c", 1},
                {":source: a.c\n:source: b.c", 0},
                {":flag: -std=c++17", 1},
                {":flag: -O1 -std=gnu++20", 1},
                {":flag: -std=c17 -Dplus=++", 0},
                {":flag: -std=c11", 0},
                {"", 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        struct cagd_code_harness *h = block(list[k].lines);
        assert_int_equal(cagd_code_is_cpp(h), list[k].is_cpp);
        cagd_code_harness_free(h);
    }
}

/* What is wrong in the lines of a block, the first of which is the second of the file. */
static void mistakes_have_their_lines(void **state)
{
    (void)state;
    static const struct {
        const char *lines;
        int line;
        const char *cause;
    } list[] = {
        {":input: 2x", 2, "a name of at most"},
        {":title: t\n:input: x[0]", 3, "from 1 to 1000"},
        {":input: x[1001]", 2, "from 1 to 1000"},
        {":input: x[1", 2, "from 1 to 1000"},
        {":input: x; y; x", 2, "x is an input already"},
        {":input: x increasing", 2, "is not known"},
        {":input: x nondecreasing", 2, "is not known"},
        {":input: x > 1", 2, "is not known"},
        {":input: x = 1/0", 2, "is no number"},
        {":input: x = 1 2", 2, "more values than the 1"},
        {":input: x[3] = 1 2", 2, "x has 2 values; 3 were"},
        {":input: x in 0, 1]", 2, "a range like"},
        {":input: x in [0, 1", 2, "a range like"},
        {":input: x in [0 1]", 2, "a range like"},
        {":input: x in [0, y]; y", 2, "\"y\" is no end"},
        {":input: x in [x, 1]", 2, "\"x\" is no end"},
        {":input: z[2]; x in [z[], 1]", 2, "\"z[]\" is no end"},
        {":input: z[2]; x in [z[-0], 1]", 2, "\"z[-0]\" is no end"},
        {":input: z[2]; x in [0, z[2]]", 2, "\"z[2]\" is no end"},
        {":input: z[2]; x in [0, z[1]0]", 2, "\"z[1]0\" is no end"},
        {":input: z; x in [0, z0]", 2, "\"z0\" is no end"},
        {":expect: r", 2, "what it should be"},
        {":known: a.c = 1", 2, "FILE:LINE"},
        {":known: a.c:x = 1", 2, "FILE:LINE"},
        {":known: :3 = 1", 2, "FILE:LINE"},
        {":known: a.c:3[0] = 1", 2, "FILE:LINE"},
        {":known: a.c:3 == 1\n:known: a.c:3 + 1 = 1", 3, "FILE:LINE"},
        {":points: 0", 2, "from 1 to 100000"},
        {":points: 100001", 2, "from 1 to 100000"},
        {":points: 7x", 2, "from 1 to 100000"},
        {":roots: none", 2, "\"refuse\" or \"enclose\""},
        {":memcpy: copies", 2, "\"moves\""},
        {":inputs: x", 2, "no key \"inputs\""},
        {":title", 2, ":key: text"},
        {"title: t", 2, ":key: text"},
        {":input: x; y[88]", 1, "more than 88 variables"},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        char text[400];
        struct cagd_code_harness_error error = {.line = 0};
        snprintf(text, sizeof text, ":::{exactly} it\n%s\n:call: double r = 1;\n:output: r\n:::\n", list[k].lines);
        assert_null(cagd_code_read_harness(text, &error));
        if (error.line != list[k].line || strstr(error.cause, list[k].cause) == NULL)
            fail_msg("%s: line %d: %s", list[k].lines, error.line, error.cause);
    }
}

/* Of each key what it says, in the lists of its own; entries go on in lines that begin with a blank; as much as is allowed. */
static void blocks_say_what_they_ask(void **state)
{
    (void)state;
    struct cagd_code_harness *h = block(
        ":title: one\n:title: two\n:source: a.c\n:include: a.h\n:declare: int f(void);\n\tint g(void);\n:where: x > 1\n"
        ":flag: -O1\t -g\n:input: x; y[87]; z[2] = 0 1\n:points: 100000\n:roots: enclose\n:memcpy: moves\n"
        ":known: a.c:3 = x\n:known: a.c:12[2] \t= y\n:expect: r = x");
    assert_string_equal(h->title, "two");
    assert_string_equal(h->source.text[0], "a.c");
    assert_string_equal(h->include.text[0], "a.h");
    assert_string_equal(h->declare.text[0], "int f(void);\n\tint g(void);");
    assert_string_equal(h->where.text[0], "x > 1");
    assert_string_equal(h->call.text[0], "double r = 1;");
    assert_string_equal(h->output.text[0], "r");
    assert_string_equal(h->expect.text[0], "r = x");
    assert_int_equal(h->expect.number[0], 16);
    assert_int_equal(h->flag.count, 2);
    assert_string_equal(h->flag.text[1], "-g");
    assert_int_equal(h->known.count, 2);
    assert_true(h->notes_stores && h->memcpy_moves && h->enclose_roots && !h->refuse_roots);
    assert_int_equal(h->points, 100000);
    assert_int_equal(cagd_code_variables(h), 88);
    assert_null(h->next);
    cagd_code_harness_free(h);
    h = block(":roots: refuse\n:points: 1\n:call: f();\n:output: y\n:::\n\ntext\n:::{exactly} another");
    assert_true(h->refuse_roots && !h->enclose_roots && !h->memcpy_moves && !h->notes_stores);
    assert_int_equal(h->points, 1);
    assert_int_equal(h->line, 1);
    assert_string_equal(h->next->name, "another");
    assert_int_equal(h->next->line, 9);
    assert_int_equal(h->next->points, 20);
    assert_null(h->next->title);
    assert_null(h->next->next);
    cagd_code_harness_free(h);
}

static void numbers(void **state)
{
    (void)state;
    static const char *const good[] = {"3", "-3/7", "0.35", "0", "-0.5", "12/5", "+1"}, *const bad[] = {
                                                                                            "",   "x",     "1/0", "1 2",
                                                                                            "3/", "/3",    "1e",  "--1",
                                                                                            "0x", "1/2/3", "."};
    for (size_t k = 0; k < sizeof good / sizeof *good; k++)
        if (!cagd_code_is_number(good[k]))
            fail_msg("%s", good[k]);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
        if (cagd_code_is_number(bad[k]))
            fail_msg("%s", bad[k]);
}

static num_q at(const struct cagd_code_point *p, int i, int j) { return cagd_from_string_q(p->input[i].value[j]); }

/* Every point meets what is asked of its inputs. */
static void points_are_what_is_asked(void **state)
{
    (void)state;
    struct cagd_code_harness *h =
        block(":input: a = 3; p[2] > 0; u[5] increasing; v[5] nondecreasing; s in (u[1], u[2]); t in [0, 1/3)");
    int equal = 0;
    for (long k = 0; k < 200; k++) {
        struct cagd_code_point *p = cagd_code_point_new(h, k, 0);
        region_mark m = region_open();
        assert_int_equal(p->inputs, 6);
        assert_true(cagd_equal_q(at(p, 0, 0), from_int_q(3)));
        for (int j = 0; j < 2; j++)
            assert_true(cagd_sign_q(at(p, 1, j)) > 0);
        for (int j = 1; j < 5; j++) {
            assert_true(cagd_compare_q(at(p, 2, j - 1), at(p, 2, j)) < 0);
            int order = cagd_compare_q(at(p, 3, j - 1), at(p, 3, j));
            assert_true(order <= 0);
            assert_int_equal(order == 0, p->input[3].like[j] == p->input[3].like[j - 1]);
            equal += order == 0;
        }
        assert_true(cagd_compare_q(at(p, 2, 1), at(p, 4, 0)) < 0 && cagd_compare_q(at(p, 4, 0), at(p, 2, 2)) < 0);
        assert_true(cagd_sign_q(at(p, 5, 0)) >= 0 && cagd_compare_q(at(p, 5, 0), from_ratio_q(1, 3)) < 0);
        region_drop(m);
        cagd_code_point_free(p);
    }
    assert_int_equal(cagd_code_patterns(h), 16);
    assert_true(equal > 0);
    cagd_code_harness_free(h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(inputs_have_the_shapes_that_are_written),
                                       unit(the_language_is_that_of_a_source),
                                       unit(numbers),
                                       unit(mistakes_have_their_lines),
                                       unit(blocks_say_what_they_ask),
                                       unit(points_are_what_is_asked)};
    return run_unit_tests(tests);
}
