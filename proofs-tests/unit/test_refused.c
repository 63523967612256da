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

int main(void)
{
    const struct CMUnitTest tests[] = {unit(pages_with_mistakes)};
    return run_unit_tests(tests);
}
