/* test_harness.c -- what a block about code asks: its inputs with their shapes, its language, and the points that are tried. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/code/driver.h"
#include "exact/code/formula.h"
#include "exact/code/harness.h"
#include "exact/code/points.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
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

/* The text of its driver, to be freed. */
static char *driver_of(const struct cagd_code_harness *h)
{
    char *text = NULL;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    cagd_code_write_driver(h, "page.md", out);
    fclose(out);
    return text;
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
        {"x in  [0, 1]", "x", "0", "1", 0, 0, 0, CAGD_CODE_BETWEEN},
        {"x in [0, 1)", "x", "0", "1", 0, 0, 1, CAGD_CODE_BETWEEN},
        {"x in (0, 1]", "x", "0", "1", 0, 1, 0, CAGD_CODE_BETWEEN},
        {"x in (-1/2,  7/3)", "x", "-1/2", "7/3", 0, 1, 1, CAGD_CODE_BETWEEN},
        {"x[2] in [a, b[1]]", "x", "a", "b[1]", 2, 0, 0, CAGD_CODE_BETWEEN},
        {"x[4] increasing", "x", NULL, NULL, 4, 0, 0, CAGD_CODE_INCREASING},
        {"x[4] nondecreasing", "x", NULL, NULL, 4, 0, 0, CAGD_CODE_NONDECREASING},
        {"x = 3/4", "x", NULL, NULL, 0, 0, 0, CAGD_CODE_FIXED},
        {"x[2] = 1 -2", "x", NULL, NULL, 2, 0, 0, CAGD_CODE_FIXED},
        {"x[2] = 1,-2", "x", NULL, NULL, 2, 0, 0, CAGD_CODE_FIXED},
        {"x[2]=1 ,\t-2", "x", NULL, NULL, 2, 0, 0, CAGD_CODE_FIXED},
        {"x >0", "x", NULL, NULL, 0, 0, 0, CAGD_CODE_POSITIVE},
        {"x>  0", "x", NULL, NULL, 0, 0, 0, CAGD_CODE_POSITIVE},
        {"_x_1[3]\tincreasing", "_x_1", NULL, NULL, 3, 0, 0, CAGD_CODE_INCREASING},
        {"x in [b[0], a)", "x", "b[0]", "a", 0, 0, 1, CAGD_CODE_BETWEEN},
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
        {":expect: r[0] = w", 2, "one element is (r[0])"},
        {":expect: r[] = w", 2, "at least 1"},
        {":expect: r[2] = w\n:expect: r[-1] = w", 3, "at least 1"},
        {":output: r[0]", 2, "at least 1"},
        {":input: twelveletters", 2, "a name of at most 11"},
        {":input: in twelveletters", 2, "is not known"},
        {":known: a.c = 1", 2, "FILE:LINE"},
        {":known: a.c: = 1", 2, "FILE:LINE"},
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
        {":input: x\n increasing\n y", 2, "x: \"  increasing  y\" is not known; nothing"}, /* in one line */
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

/* Of each key 64 lines are read and no more; of inputs 64. */
static void there_is_room_for_so_many_lines(void **state)
{
    (void)state;
    static const char *const keys[] = {"source", "include", "declare", "where",   "output", "expect",
                                       "known",  "let",     "use",     "printed", "call",   "flag"};
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
        for (int many = 62; many <= 65; many++) {
            char *text = NULL;
            size_t size;
            FILE *out = open_memstream(&text, &size);
            int is_flag = strcmp(keys[k], "flag") == 0, is_call = strcmp(keys[k], "call") == 0;
            fprintf(out, ":::{exactly} it\n:input: x\n%s%s", is_call ? "" : ":call: double r = x;\n",
                    strcmp(keys[k], "output") == 0 ? "" : ":output: r\n");
            if (strcmp(keys[k], "let") == 0 || strcmp(keys[k], "use") == 0)
                fputs(":printed: r = x\n", out);
            if (is_flag)
                fputs(":flag:", out);
            for (int j = 0; j < many; j++)
                fprintf(out,
                        is_flag                           ? " -D%s%d"
                        : strcmp(keys[k], "known") == 0   ? ":%s: a.c:%d = 1\n"
                        : strcmp(keys[k], "let") == 0     ? ":%s: h_{%d} = 1\n"
                        : strcmp(keys[k], "use") == 0     ? ":%s: bernstein B_i^n(t)\n"
                        : strcmp(keys[k], "printed") == 0 ? ":%s: r = %d x\n"
                        : strcmp(keys[k], "output") == 0  ? ":%s: r\n"
                                                          : ":%s: r = %d\n",
                        keys[k], j);
            fputs(is_flag ? "\n:::\n" : ":::\n", out);
            fclose(out);
            struct cagd_code_harness_error error = {.line = 0, .cause = ""};
            struct cagd_code_harness *h = cagd_code_read_harness(text, &error);
            if (many == 65) {
                assert_null(h);
                assert_string_equal(error.cause, "more than 64 lines of one key");
            } else if (h == NULL && strcmp(keys[k], "let") != 0 && strcmp(keys[k], "use") != 0) {
                fail_msg("%s, %d: %s", keys[k], many, error.cause);
            }
            cagd_code_harness_free(h);
            free(text);
        }
    for (int many = 64; many <= 65; many++) {
        char text[1000] = ":::{exactly} it\n:call: f();\n:output: a0\n:input: ";
        struct cagd_code_harness_error error;
        for (int k = 0; k < many; k++)
            snprintf(text + strlen(text), sizeof text - strlen(text), "a%d;", k);
        strcat(text, "\n:::\n");
        struct cagd_code_harness *h = cagd_code_read_harness(text, &error);
        assert_int_equal(h != NULL, many == 64);
        if (h == NULL)
            assert_string_equal(error.cause, "more than 64 inputs");
        cagd_code_harness_free(h);
    }
}

/* Which texts are arrays, and which have a name. */
static void outputs_are_arrays_or_numbers(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int is_array, is_name;
        long count;
    } list[] = {{"R", 0, 1, 0},
                {"R[3]", 1, 1, 3},
                {"R[1000]", 1, 1, 1000},
                {"R[1]", 1, 1, 1},
                {"s.R[3]", 0, 0, 0},
                {"(R[3])", 0, 0, 0},
                {"R[k]", 0, 0, 0},
                {"p->R[3]", 0, 0, 0},
                {"R[2][3]", 0, 0, 0},
                {"f(x)[3]", 0, 0, 0},
                {"R[3]+1", 0, 0, 0},
                {"R + 1", 0, 0, 0},
                {"3R", 0, 0, 0},
                {"", 0, 0, 0},
                {"_a9", 0, 1, 0},
                {"elevenlette", 0, 1, 0},
                {"twelveletter", 0, 0, 0},
                {"R[3", 0, 0, 0},
                {"R]", 0, 0, 0},
                {"-R[3]", 0, 0, 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        long count;
        int elements;
        char name[CAGD_CODE_MOST_NAME + 1];
        if (cagd_code_is_array(list[k].text, &count) != list[k].is_array ||
            (list[k].is_array && count != list[k].count))
            fail_msg("%s", list[k].text);
        if (cagd_code_output_name(list[k].text, name, &elements) != list[k].is_name ||
            (list[k].is_name && elements != list[k].count))
            fail_msg("%s", list[k].text);
        if (list[k].is_name)
            assert_int_equal(strncmp(name, list[k].text, strlen(name)), 0);
    }
    static const char *const trimmed[] = {" a b ", "a b", "\t\na", "a", "", "", "  ", "", "a", "a"};
    for (size_t k = 0; k < sizeof trimmed / sizeof *trimmed; k += 2) {
        char *text = cagd_code_trimmed(trimmed[k], strlen(trimmed[k]));
        assert_string_equal(text, trimmed[k + 1]);
        free(text);
    }
}

static void texts_that_are_no_blocks(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int line;
        const char *cause;
    } list[] = {{"text\n", 1, "no block is in it"},
                {"\n:::{exactly}\n:::\n", 2, "the block has no name"},
                {"\n:::{exactly} it\n:call: f();\n:output: r\n", 2, "it: the block does not end"},
                {":::{exactly} it\n more\n:::\n", 2, ":key: text"},
                {"\n:::{exactly} it\n:output: r\n:::\n", 2, "it: there is no :call:"},
                {":::{exactly} it\n:title: t\n:call: f();\n:::\n", 1, "it: there is neither :expect: nor :output:"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        struct cagd_code_harness_error error = {.line = 0};
        assert_null(cagd_code_read_harness(list[k].text, &error));
        if (error.line != list[k].line || strstr(error.cause, list[k].cause) == NULL)
            fail_msg("%s: line %d: %s", list[k].text, error.line, error.cause);
    }
}

/* Of each key what it says, in the lists of its own; entries go on in lines that begin with a blank; as much as is allowed. */
static void blocks_say_what_they_ask(void **state)
{
    (void)state;
    struct cagd_code_harness *h = block(
        ":title: one\n:title: two\n:source: a.c\n:include: a.h\n:declare: int f(void);\n\tint g(void);\n:where: x > 1\n"
        ":flag: -O1\t -g\n:input: x; ; y[87]; z[2] = 0 1\n:points: 100000\n:roots: enclose\n:memcpy: moves\n"
        ":known: a.c:3= x\n:known: a.c:12[2] \t= y\n:expect: r = x");
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

/* The program that is made of a block is this, line by line, behind the declarations. */
static void the_driver_is_what_the_block_says(void **state)
{
    (void)state;
    static const char *const wanted =
        "#line 2 \"page.md\"\n"
        "#include <a.h>\n"
        "#line 3 \"page.md\"\n"
        "#include \"b.h\"\n"
        "#line 4 \"page.md\"\n"
        "int f(void);\n"
        "void cagd_code_entry(void)\n"
        "{\n"
        "    double x;\n"
        "    cagd_code_input(\"x\", 1, &x);\n"
        "    double elevenlette;\n"
        "    cagd_code_input(\"elevenlette\", 1, &elevenlette);\n"
        "    double y[1];\n"
        "    cagd_code_input(\"y\", 1, y);\n"
        "    double z[2];\n"
        "    cagd_code_input(\"z\", 2, z);\n"
        "    double u[3];\n"
        "    cagd_code_input(\"u\", 3, u);\n"
        "    double v[12];\n"
        "    cagd_code_input(\"v\", 12, v);\n"
        "    cagd_code_given(1);\n"
        "    for (int cagd_k = 0; cagd_k < 1; cagd_k++)\n"
        "        cagd_code_where(x > 0);\n"
        "    for (int cagd_k = 0; cagd_k < 1; cagd_k++)\n"
        "        cagd_code_where(((double)1 / (double)2) <= elevenlette && elevenlette < x);\n"
        "    for (int cagd_k = 0; cagd_k < 1; cagd_k++)\n"
        "        cagd_code_where(((double)-30 / (double)1) < y[cagd_k] && y[cagd_k] <= ((double)7 / (double)20));\n"
        "    for (int cagd_k = 1; cagd_k < 3; cagd_k++)\n"
        "        cagd_code_where(u[cagd_k - 1] < u[cagd_k]);\n"
        "    for (int cagd_k = 1; cagd_k < 12; cagd_k++)\n"
        "        cagd_code_where(v[cagd_k - 1] <= v[cagd_k]);\n"
        "#line 6 \"page.md\"\n"
        "    cagd_code_where(x > 1);\n"
        "#line 7 \"page.md\"\n"
        "    cagd_code_where(x < y[0]);\n"
        "    cagd_code_given(0);\n"
        "    cagd_code_side(1);\n"
        "#line 17 \"page.md\"\n"
        "    double r = 1;\n"
        "    cagd_code_side(0);\n"
        "#line 8 \"page.md\"\n"
        "    { const double cagd_wanted = x; cagd_code_known(\"a.c:3\", 1, &cagd_wanted); }\n"
        "#line 9 \"page.md\"\n"
        "    cagd_code_known(\"a.c:12\", 2, y);\n"
        "#line 15 \"page.md\"\n"
        "    cagd_code_output(\"u\", 3, u);\n"
        "#line 16 \"page.md\"\n"
        "    { const double cagd_out = (u[0]); cagd_code_output(\"(u[0])\", 1, &cagd_out); }\n"
        "#line 18 \"page.md\"\n"
        "    { const double cagd_out = r; cagd_code_output(\"r\", 1, &cagd_out); }\n"
        "#line 10 \"page.md\"\n"
        "    { const double cagd_got = r; cagd_code_side(2);\n"
        "      const double cagd_wanted = x; cagd_code_side(0);\n"
        "      cagd_code_expect(\"r\", 1, &cagd_got, &cagd_wanted); }\n"
        "#line 11 \"page.md\"\n"
        "    cagd_code_expect(\"r\", 12, r, uuu);\n"
        "#line 12 \"page.md\"\n"
        "    { const double cagd_got = s.u[1]; cagd_code_side(2);\n"
        "      const double cagd_wanted = u[1]; cagd_code_side(0);\n"
        "      cagd_code_expect(\"s.u[1]\", 1, &cagd_got, &cagd_wanted); }\n"
        "#line 13 \"page.md\"\n"
        "    { const double cagd_got = u[k]; cagd_code_side(2);\n"
        "      const double cagd_wanted = x; cagd_code_side(0);\n"
        "      cagd_code_expect(\"u[k]\", 1, &cagd_got, &cagd_wanted); }\n"
        "#line 14 \"page.md\"\n"
        "    { const double cagd_got = (u[0]); cagd_code_side(2);\n"
        "      const double cagd_wanted = u[0]; cagd_code_side(0);\n"
        "      cagd_code_expect(\"(u[0])\", 1, &cagd_got, &cagd_wanted); }\n"
        "}\n";
    struct cagd_code_harness *h =
        block(":include: <a.h>\n:include: \"b.h\"\n:declare: int f(void);\n:input: x > 0; elevenlette in [1/2, x); "
              "y[1] in (-30, 0.35]; "
              "z[2] = 0 1; u[3] increasing; v[12] nondecreasing\n:where: x > 1\n:where: x < y[0]\n:known: a.c:3= x\n"
              ":known: a.c:12[2] \t= y\n:expect: r = x\n:expect: r[12] = uuu\n:expect: s.u[1] = u[1]\n:expect: u[k] = "
              "x\n:expect: (u[0]) = "
              "u[0]\n:output: u[3]\n:output: (u[0])");
    char *text = driver_of(h);
    const char *own = strstr(text, "#line");
    assert_non_null(own);
    assert_string_equal(own, wanted);
    free(text);
    cagd_code_harness_free(h);
}

/* Formulas are texts of C behind the names of the outputs that have one; a line that goes on is one line. */
static void formulas_are_handed_over_as_they_are_printed(void **state)
{
    (void)state;
    struct cagd_code_harness *h =
        block(":input: x; c[2]\n:output: R[2]\n:output: s\n:output: R[0] + 1\n:let: h = \\frac{x}{2}\n"
              ":printed: R_j\n = h + c_j\n:for: j = 0..1\n:printed: s = x");
    char *text = driver_of(h);
    const char *own = strstr(text, "cagd_code_name(\"R\"");
    assert_non_null(own);
    assert_string_equal(own, "cagd_code_name(\"R\", 2, R);\n"
                             "    cagd_code_name(\"s\", 0, &s);\n"
                             "    cagd_code_name(\"r\", 0, &r);\n"
                             "    cagd_code_let(\"h = \\\\frac{x}{2}\");\n"
                             "#line 7 \"page.md\"\n"
                             "    cagd_code_printed(\"R_j  = h + c_j\", \"j = 0..1\", __FILE__, __LINE__);\n"
                             "#line 10 \"page.md\"\n"
                             "    cagd_code_printed(\"s = x\", \"j = 0..1\", __FILE__, __LINE__);\n"
                             "}\n");
    free(text);
    cagd_code_harness_free(h);
}

/* Names of letters alone: one stands by itself, a Greek one as TeX has it, others upright; with anything else in them, in whatever place,
 * they are no names of formulas. */
static void names_in_formulas(void **state)
{
    (void)state;
    static const char *const list[][2] = {
        {"t", "t"}, {"lambda", "\\lambda"}, {"knot", "\\mathrm{knot}"}, {"to", "\\mathrm{to}"}, {"", NULL}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (long count = 0; count < 3; count++) {
            char name[80];
            const char *head = cagd_code_formula_head(list[k][0], count);
            assert_int_equal(head != NULL, list[k][1] != NULL);
            if (head == NULL)
                continue;
            snprintf(name, sizeof name, "%s%s", list[k][1], count > 0 ? "_" : "");
            assert_string_equal(head, name);
            for (size_t at = 0; at <= strlen(list[k][0]); at++)
                for (const char *other = "0_9 \\$.{"; *other != '\0'; other++) {
                    snprintf(name, sizeof name, "%.*s%c%s", (int)at, list[k][0], *other, list[k][0] + at);
                    assert_null(cagd_code_formula_head(name, count));
                }
        }
    char longest[100];
    int known = 0;
    for (size_t n = 1; n < sizeof longest - 1; n++) { /* where the text has no room there is none, and no half of one */
        memset(longest, 'a', n), longest[n] = '\0';
        const char *head = cagd_code_formula_head(longest, 1);
        assert_true(head == NULL || strstr(head, longest) != NULL);
        known += head != NULL;
    }
    assert_true(known >= 64 && known < 80);
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
    cagd_region_faults = CAGD_FAULT_UNDEFINED; /* what was wrong before still is */
    assert_true(cagd_code_is_number("3"));
    assert_int_equal(cagd_region_faults, CAGD_FAULT_UNDEFINED);
    cagd_region_faults = 0;
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

/* p, q with q > 0 and no common factor, of the first number of the k-th point. */
static long numerator(const struct cagd_code_point *p, long *q)
{
    char *end;
    long n = strtol(p->input[0].value[0], &end, 10);
    *q = *end == '/' ? strtol(end + 1, NULL, 10) : 1;
    return n;
}

/* Small fractions that grow with k, up to 33; fine ones are multiples of 2^-36 or 2^-40 of at most 8 and 4. */
static void points_are_drawn_widely(void **state)
{
    (void)state;
    struct cagd_code_harness *any = block(":input: x"), *positive = block(":input: x > 0"), *all[] = {any, positive};
    for (int shape = 0; shape < 2; shape++) {
        long least = 0, most = 0, deepest = 0, different = 0, before = 0;
        for (long k = 0; k < 400; k++) {
            struct cagd_code_point *p = cagd_code_point_new(all[shape], k, 0);
            long q, n = numerator(p, &q), size = k < 60 ? 3 + k / 2 : 33;
            assert_in_range(labs(n), 0, size);
            assert_in_range(q, 1, 1 + size / 2);
            least = n < least ? n : least, most = n > most ? n : most, deepest = q > deepest ? q : deepest;
            different += n != before, before = n;
            cagd_code_point_free(p);
        }
        assert_int_equal(least, shape == 0 ? -33 : 0);
        assert_int_equal(most, 33);
        assert_int_equal(deepest, 17);
        assert_true(different > 350);
        long bits = shape == 0 ? 1L << 36 : 1L << 40, below_half = 0, above_half = 0, negative = 0;
        for (long k = 0; k < 100; k++) {
            struct cagd_code_point *p = cagd_code_point_new(all[shape], k, 1);
            long q, n = numerator(p, &q), limit = shape == 0 ? 8 : 4;
            assert_true(q > 1 << 20 && bits % q == 0);
            assert_true(labs(n) / q < limit);
            negative += n < 0;
            below_half += labs(n) / q < limit / 2, above_half += labs(n) / q >= limit / 2;
            cagd_code_point_free(p);
        }
        assert_true(below_half > 25 && above_half > 25 &&
                    (shape == 0 ? negative > 25 && negative < 75 : negative == 0));
        cagd_code_harness_free(all[shape]);
    }
}

/* Each closed end is met, and no open one; fine points lie between. */
static void ends_of_ranges_are_met(void **state)
{
    (void)state;
    static const char *const lines[] = {":input: x in [2, 3]", ":input: x in (2, 3]", ":input: x in [2, 3)",
                                        ":input: x in (2, 3)"};
    for (int s = 0; s < 4; s++) {
        struct cagd_code_harness *h = block(lines[s]);
        int low = 0, high = 0;
        for (long k = 0; k < 240; k++) {
            struct cagd_code_point *p = cagd_code_point_new(h, k, k % 2 != 0);
            long q, n = numerator(p, &q);
            assert_true(2 * q <= n && n <= 3 * q);
            if (n % q != 0)
                assert_true(k % 2 != 0 ? q > 1 << 20 : q <= 34);
            low += n == 2 * q, high += n == 3 * q;
            cagd_code_point_free(p);
        }
        assert_true(s % 2 == 0 ? low > 5 && low < 60 : low == 0);
        assert_true(s < 2 ? high > 5 && high < 60 : high == 0);
        cagd_code_harness_free(h);
    }
}

/* A name alone and one with an index, of which another is the beginning. */
static void ranges_end_at_earlier_inputs(void **state)
{
    (void)state;
    struct cagd_code_harness *h = block(":input: ab = 7; a = 3; b[3] = 4 5 6; x in [a, b[1]]");
    for (long k = 0; k < 60; k++) {
        struct cagd_code_point *p = cagd_code_point_new(h, k, 0);
        region_mark m = region_open();
        assert_true(cagd_compare_q(at(p, 3, 0), from_int_q(3)) >= 0 && cagd_compare_q(at(p, 3, 0), from_int_q(5)) <= 0);
        assert_false(p->input[0].variable);
        assert_true(p->input[3].variable);
        region_drop(m);
        cagd_code_point_free(p);
    }
    cagd_code_harness_free(h);
}

/* Equal neighbours in every way that there is: the bits of k say which. */
static void every_pattern_is_met(void **state)
{
    (void)state;
    struct cagd_code_harness *h = block(":input: u[3] nondecreasing; v[2] nondecreasing"),
                             *more = block(":input: u[20] nondecreasing");
    assert_int_equal(cagd_code_patterns(h), 8);
    assert_int_equal(cagd_code_patterns(more), 1024);
    for (long k = 0; k < 16; k++) {
        struct cagd_code_point *p = cagd_code_point_new(h, k, 0);
        const int *u = p->input[0].like, *v = p->input[1].like;
        assert_int_equal((u[1] == 0) + 2 * (u[2] == u[1]) + 4 * (v[1] == 0), k % 8);
        cagd_code_point_free(p);
    }
    cagd_code_harness_free(h);
    cagd_code_harness_free(more);
}

/* A copy has numbers of its own. */
static void copies_are_apart(void **state)
{
    (void)state;
    struct cagd_code_harness *h = block(":input: a; b[3]; u[2] nondecreasing");
    struct cagd_code_point *p = cagd_code_point_new(h, 1, 0), *copy = cagd_code_point_copy(p);
    assert_int_equal(copy->inputs, 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < (i == 0 ? 1 : i == 1 ? 3 : 2); j++) {
            assert_string_equal(copy->input[i].value[j], p->input[i].value[j]);
            assert_ptr_not_equal(copy->input[i].value[j], p->input[i].value[j]);
            assert_int_equal(copy->input[i].like[j], p->input[i].like[j]);
        }
    char *first = strdup(p->input[1].value[1]), *third = strdup(p->input[1].value[0]);
    cagd_code_point_set(copy, 1, 2, "77/5");
    assert_string_equal(copy->input[1].value[2], "77/5");
    assert_string_equal(copy->input[1].value[1], first);
    assert_string_equal(copy->input[1].value[0], third);
    assert_string_not_equal(p->input[1].value[2], "77/5");
    free(first);
    free(third);
    cagd_code_point_free(p);
    cagd_code_point_free(copy);
    cagd_code_harness_free(h);
}

/* The same block has the same points, and one of another name has others. */
static void names_and_numbers_choose_points(void **state)
{
    (void)state;
    struct cagd_code_harness_error error;
    struct cagd_code_harness *h[3];
    static const char *const name[] = {"one", "one", "eno"};
    int others = 0;
    for (int k = 0; k < 3; k++) {
        char text[200];
        snprintf(text, sizeof text, ":::{exactly} %s\n:input: x[4]\n:call: f();\n:output: x[4]\n:::\n", name[k]);
        h[k] = cagd_code_read_harness(text, &error);
        assert_non_null(h[k]);
    }
    for (long k = 0; k < 20; k++) {
        struct cagd_code_point *p[3];
        for (int i = 0; i < 3; i++)
            p[i] = cagd_code_point_new(h[i], k, 0);
        for (int j = 0; j < 4; j++) {
            assert_string_equal(p[0]->input[0].value[j], p[1]->input[0].value[j]);
            others += strcmp(p[0]->input[0].value[j], p[2]->input[0].value[j]) != 0;
        }
        for (int i = 0; i < 3; i++)
            cagd_code_point_free(p[i]);
    }
    assert_true(others > 60);
    for (int k = 0; k < 3; k++)
        cagd_code_harness_free(h[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(inputs_have_the_shapes_that_are_written),
                                       unit(the_language_is_that_of_a_source),
                                       unit(numbers),
                                       unit(names_in_formulas),
                                       unit(mistakes_have_their_lines),
                                       unit(there_is_room_for_so_many_lines),
                                       unit(outputs_are_arrays_or_numbers),
                                       unit(texts_that_are_no_blocks),
                                       unit(blocks_say_what_they_ask),
                                       unit(the_driver_is_what_the_block_says),
                                       unit(formulas_are_handed_over_as_they_are_printed),
                                       unit(points_are_what_is_asked),
                                       unit(points_are_drawn_widely),
                                       unit(ends_of_ranges_are_met),
                                       unit(ranges_end_at_earlier_inputs),
                                       unit(every_pattern_is_met),
                                       unit(copies_are_apart),
                                       unit(names_and_numbers_choose_points)};
    return run_unit_tests(tests);
}
