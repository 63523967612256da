/* test_refused.c -- formulas with a mistake: each formula of the pages of proofs-tests/check is cut off before each of its tokens, and has
 * one of them left out, twice, or another one in its place.  What is read has trees whose parts are places of the text; what is refused
 * has a reason and a place of the text; and no fault is left. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/check.h"
#include "exact/expression/read.h"
#include "exact/words.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST = 600, TOKENS = 300 };

typedef enum { DEFINITION, RANGES, STATEMENT } kind;
static int refused, taken;

/* Parts may be those of a definition, on a line of its own. */
static void is_within_lines(const cagd_tree *t, int depth)
{
    assert_true(t->from >= 0 && t->from <= t->to && t->to <= LONGEST && depth <= 4 * CAGD_MOST_DEPTH);
    for (int k = 0; k < t->count; k++)
        is_within_lines(t->at[k], depth + 1);
}

/* Reads the text in a copy of the scope; whether it is one. */
static int reads(const cagd_scope *known, kind what, const char *text)
{
    cagd_scope scope = *known;
    cagd_reading_error error = {0};
    const int size = (int)strlen(text);
    const cagd_tree *t = NULL;
    region_mark mark = region_open();
    int good = what == DEFINITION ? cagd_read_definition(&scope, text, 0, size, &error)
               : what == RANGES   ? cagd_read_ranges(&scope, text, 0, size, &error)
                                  : (t = cagd_read_statement(&scope, text, 0, size, &error)) != NULL;
    if (region_faults != 0)
        fail_msg("%s: a fault is left", text);
    if (t != NULL)
        is_within_lines(t, 0);
    if (!good && (error.message[0] == '\0' || error.from < 0 || error.from > error.to || error.to > size))
        fail_msg("%s: refused at %d for '%s'", text, error.from, error.message);
    region_drop(mark);
    *(good ? &taken : &refused) += 1;
    return good;
}

/* Where the tokens begin, and behind the last where the text ends; their number. */
static int tokens_of(const char *text, int begin[TOKENS + 1])
{
    int count = 0, at = 0;
    for (; text[at] != '\0' && count < TOKENS; count++) {
        begin[count] = at;
        if (text[at++] == '\\' && text[at] != '\0' && !isalpha((unsigned char)text[at]))
            at++;
        else if (text[at - 1] == '\\')
            while (isalpha((unsigned char)text[at]))
                at++;
        while (text[at] == ' ')
            at++;
    }
    begin[count] = at;
    return count;
}

static void with_mistakes(const cagd_scope *scope, kind what, const char *text)
{
    static const char *const other[] = {"]", "}", ")",     "^",       "_",       "q",  ",",       "\\frac ",
                                        "{", "(", "\\le ", "\\left ", "\\dots ", "' ", "\\text{", "\\sum ",
                                        "=", "|", "d",     "\\sqrt",  "!",       "7"};
    enum { OTHERS = sizeof other / sizeof *other };
    int begin[TOKENS + 1], count = tokens_of(text, begin);
    char changed[LONGEST + 20];
    for (int k = 0; k < count; k++) {
        const int at = begin[k], behind = begin[k + 1];
        snprintf(changed, sizeof changed, "%.*s", at, text);
        reads(scope, what, changed);
        snprintf(changed, sizeof changed, "%.*s%s", at, text, text + behind);
        reads(scope, what, changed);
        snprintf(changed, sizeof changed, "%.*s%s", behind, text, text + at);
        reads(scope, what, changed);
        for (int m = 0; m < OTHERS; m++) {
            snprintf(changed, sizeof changed, "%.*s%s%s", at, text, other[m], text + behind);
            reads(scope, what, changed);
        }
    }
}

/* The lines of a page: definitions between :::{let} and :::, what is :printed: and the ranges of :for: behind it. */
static int page(const char *name)
{
    char path[512], line[LONGEST], printed[LONGEST] = "";
    snprintf(path, sizeof path, "%s/%s.md", PAGES, name);
    FILE *file = fopen(path, "r");
    if (file == NULL)
        fail_msg("%s cannot be read", path);
    cagd_scope known = {0};
    int in_definitions = 0, formulas = 0;
    while (fgets(line, sizeof line, file) != NULL) {
        line[strcspn(line, "\n")] = '\0';
        cagd_scope scope = known;
        cagd_reading_error error;
        const int length = (int)strlen(line);
        if (strncmp(line, ":::", 3) == 0) {
            if (printed[0] != '\0' && reads(&scope, STATEMENT, printed))
                with_mistakes(&scope, STATEMENT, printed), formulas++;
            printed[0] = '\0';
            in_definitions = strcmp(line, ":::{let}") == 0;
        } else if (in_definitions) {
            if (!reads(&scope, DEFINITION, line))
                continue;
            with_mistakes(&scope, DEFINITION, line), formulas++;
            assert_true(cagd_read_definition(&known, line, 0, length, &error));
        } else if (strncmp(line, ":printed: ", 10) == 0) {
            strcpy(printed, line + 10);
        } else if (strncmp(line, ":for: ", 6) == 0 && printed[0] != '\0' && reads(&scope, RANGES, line + 6)) {
            with_mistakes(&scope, RANGES, line + 6);
            assert_true(cagd_read_ranges(&scope, line, 6, length, &error));
            if (reads(&scope, STATEMENT, printed))
                with_mistakes(&scope, STATEMENT, printed), formulas++;
            printed[0] = '\0';
        }
    }
    fclose(file);
    return formulas;
}

static void pages_with_mistakes(void **state)
{
    (void)state;
    static const char *const name[] = {"page", "literature", "referee", "shape", "bases", "deng-zhang-2022"};
    int formulas = 0;
    field_open(32);
    refused = taken = 0;
    for (size_t k = 0; k < sizeof name / sizeof *name; k++)
        formulas += page(name[k]);
    assert_true(formulas > 300 && refused > 100000 && taken > 10000);
    print_message("%d formulas, %d refused, %d read\n", formulas, refused, taken);
    field_close();
}

/* What the pages have not: each line is read, in the scope of those before it, and then with mistakes. */
static void other_formulas_with_mistakes(void **state)
{
    (void)state;
    static const struct {
        kind what;
        const char *text;
    } list[] = {
        {DEFINITION, "x, y, z, x_i, P_i, Q_{ij} \\in \\R"},
        {DEFINITION, "a, b \\in \\mathbb{R}, a < b"},
        {DEFINITION, "u_i < u_{i+1}"},
        {DEFINITION, "f(t) = \\begin{cases} t, & t < 1 \\\\ 1, & t \\ge 1 \\\\ \\end{cases}"},
        {DEFINITION, "g(t) = \\left\\{ \\begin{array}{ll} t, & t < 1 \\\\ 1, & t \\ge 1 \\end{array} \\right."},
        {DEFINITION, "h(t) = t^2 + 1, \\quad t \\in [0, 1)"},
        {DEFINITION, "h_2(t) = t, \\quad 0 \\le t < 1, t \\ne x"},
        {DEFINITION, "N_i(t) = 1, \\quad t \\in [u_i, u_{i+1})"},
        {DEFINITION, "p(x, y) = x^2 y + y^3"},
        {DEFINITION, "P_i^{(r)}(t) = t P_i + r"},
        {DEFINITION, "R_i^{[r]} = i + r"},
        {DEFINITION, "\\mathbf{a} = (1, x, y)"},
        {DEFINITION, "M = \\begin{pmatrix} 1 & x \\\\ y & 2 \\end{pmatrix}"},
        {DEFINITION, "L = \\left[ \\begin{array}{cc} 1 & x \\\\ y & 2 \\end{array} \\right]"},
        {RANGES, "n = 1, 2, \\dots"},
        {RANGES, "k = 0, \\dots, n, \\quad t \\in [0, 1), s \\ge 0"},
        {RANGES, "x \\ne y, x \\in [0, 1]"},
        {STATEMENT, "x = x \\text{ and } y = y."},
        {STATEMENT, "\\frac{\\mathrm d}{\\mathrm d t} f(t) \\ge 0"},
        {STATEMENT, "\\frac{\\mathrm{d}^2}{\\mathrm{d} t^2} h(t) = 2"},
        {STATEMENT, "\\frac{\\partial^3}{\\partial x^2 \\partial y} (x^2 y) = 2"},
        {STATEMENT, "\\frac{\\partial^3 p(x,y)}{\\partial x^2 \\partial y} = 2"},
        {STATEMENT, "\\sum_{i=0, \\dots, n} i = n(n+1)/2"},
        {STATEMENT, "\\sum_{i+j=n} i j \\ge \\sum_{i+j \\le n} 0 + \\sum_{i+j<n} 0"},
        {STATEMENT, "\\prod_{0 \\le i < j \\le n} (x_j - x_i) = \\prod_{\\substack{i=0 \\\\ i \\ne 1}}^n x_i"},
        {STATEMENT, "\\sum_{0 \\le i, j \\le n} x_i x_j = \\sum_{i,j=0}^n x_i x_j"},
        {STATEMENT, "x_0 + x_1 + \\dots + x_n = \\sum_{i=0}^n x_i"},
        {STATEMENT, "1 \\cdot 3 \\cdots (2n-1) \\le 1 + 3 + \\dots + (2n-1)"},
        {STATEMENT, "x^n + x^{n-1} y + \\dots + y^n = 1 - x + x^2 - \\dots + (-1)^n x^n"},
        {STATEMENT, "0 \\le x \\le 1 \\Rightarrow x^2 \\le x \\text{ or } \\neg (y = 0)"},
        {STATEMENT, "(x < y \\land y < z) \\iff (x < y < z \\lor x = y)"},
        {STATEMENT, "\\forall i \\in \\{0, \\dots, n\\}: \\exists j \\in \\{0, \\dots, n\\}: i = j"},
        {STATEMENT, "{h'}^2(t) + h''(t) + h^{(2)}(t) + P_1^{(2)}(t) = R_1^{[3]}"},
        {STATEMENT, "M \\cdot L \\cdot M = M L M"},
        {STATEMENT, "\\|\\mathbf{a}\\|^2 = \\mathbf{a} \\cdot \\mathbf{a} = 1 + x^2 + y^2"},
        {STATEMENT, "\\mathbf{a} \\times \\mathbf{a} = (0, 0, 0)"},
        {STATEMENT, "\\int_0^1 h(t) \\, dt = \\left. \\left( t^3/3 + t \\right) \\right|_{t=1}"},
        {STATEMENT, "\\max(x, y) + \\min\\{x, y\\} = x + y, |x|^2 = x^2"},
        {STATEMENT, "(x - y)_+^2 = \\binom{n}{k}_x + [n]_x! + \\sqrt[3]{x}"},
        {STATEMENT, "\\frac12 x^{2} = \\tfrac{1}{2} x^2"},
    };
    cagd_scope known = {0};
    int wrong = 0;
    field_open(32);
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        cagd_reading_error error = {0};
        const char *text = list[k].text;
        if (reads(&known, list[k].what, text)) {
            with_mistakes(&known, list[k].what, text);
            if (list[k].what == DEFINITION)
                assert_true(cagd_read_definition(&known, text, 0, (int)strlen(text), &error));
            else if (list[k].what == RANGES)
                assert_true(cagd_read_ranges(&known, text, 0, (int)strlen(text), &error));
        } else {
            cagd_scope again = known;
            (void)(list[k].what == DEFINITION ? cagd_read_definition(&again, text, 0, (int)strlen(text), &error)
                   : list[k].what == RANGES   ? cagd_read_ranges(&again, text, 0, (int)strlen(text), &error)
                                            : cagd_read_statement(&again, text, 0, (int)strlen(text), &error) != NULL);
            print_message("%s: at %d: %s\n", text, error.from, error.message);
            wrong++;
        }
    }
    assert_int_equal(wrong, 0);
    field_close();
}

/* As many parts of a kind as there may be are read, and one more is refused, or joined to others. */
static void more_than_there_may_be(void **state)
{
    (void)state;
    static const struct {
        const char *first, *each, *last;
        int so_many;
        const char *message; /* for one more; NULL: it is read, too */
    } list[] = {
        {"x", "+x", " = 1", 3 * CAGD_MOST_CHILDREN, NULL},
        {"x", " x", " = 1", CAGD_MOST_CHILDREN - 1, "factors"},
        {"x = 1", ", x = 1", "", CAGD_MOST_CHILDREN - 1, "conditions"},
    };
    static char text[400000];
    cagd_scope known = {0};
    field_open(8);
    assert_true(cagd_read_definition(&known, "x \\in \\mathbb{R}", 0, 16, &(cagd_reading_error){0}));
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int more = 0; more < 2; more++) {
            cagd_reading_error error = {0};
            strcpy(text, list[k].first);
            for (int m = 0; m < list[k].so_many + more; m++)
                strcat(text, list[k].each);
            strcat(text, list[k].last);
            const cagd_tree *t = cagd_read_statement(&known, text, 0, (int)strlen(text), &error);
            if ((t == NULL) != (more && list[k].message != NULL) ||
                (t == NULL && strstr(error.message, list[k].message) == NULL))
                fail_msg("%d more of '%s': %s", more, list[k].each, error.message);
        }
    /* Brackets in one another: of numbers, of conditions, and of what is negated. */
    static const char *const around[][2] = {{"(", ")"}, {"\\neg (", ")"}};
    for (int k = 0; k < 2; k++)
        for (int depth = 1; depth < 2 * CAGD_MOST_DEPTH; depth++) {
            cagd_reading_error error = {0};
            text[0] = '\0';
            for (int m = 0; m < depth; m++)
                strcat(text, around[k][0]);
            strcat(text, "x = 1");
            for (int m = 0; m < depth; m++)
                strcat(text, around[k][1]);
            const cagd_tree *t = cagd_read_statement(&known, text, 0, (int)strlen(text), &error);
            if (t == NULL && strstr(error.message, "levels of brackets") == NULL)
                fail_msg("%d brackets: %s", depth, error.message);
            if ((t != NULL && depth > CAGD_MOST_DEPTH) || (t == NULL && depth < CAGD_MOST_DEPTH / 2))
                fail_msg("%d brackets: %s", depth, t != NULL ? "read" : error.message);
        }
    /* More signs than a formula may have. */
    cagd_reading_error error = {0};
    char *at = text;
    for (int m = 0; m < 20000; m++)
        at = stpcpy(at, "x+");
    stpcpy(at, "x = 1");
    assert_null(cagd_read_statement(&known, text, 0, (int)strlen(text), &error));
    assert_non_null(strstr(error.message, "20000 signs"));
    /* Nothing at all, and a character that nothing begins with. */
    assert_false(reads(&known, STATEMENT, "") || reads(&known, DEFINITION, "") || reads(&known, RANGES, ""));
    assert_false(reads(&known, STATEMENT, "\x01") || reads(&known, DEFINITION, "\x01") ||
                 reads(&known, RANGES, "\x01"));
    field_close();
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(pages_with_mistakes), unit(other_formulas_with_mistakes),
                                       unit(more_than_there_may_be)};
    return run_unit_tests(tests);
}
