/* test_drawn.c -- statements that were drawn, each with the answer that it has to have, which a reader of another kind found
 * (proofs-tests/check/drawn.py): whether it holds, in how many cases of its whole numbers it is looked at, and in how many it fails. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/check.h"
#include "exact/expression/read.h"

#include "proofs-tests/unit/drawn_statements.h"

#include <string.h>

static void drawn(void **state)
{
    (void)state;
    int counts[3] = {0};
    cagd_reading_error error;
    for (size_t k = 0; k < sizeof drawn_statements / sizeof *drawn_statements; k += STRIDE) {
        region_mark mark = region_open();
        cagd_scope scope = {0};
        for (size_t m = 0; m < sizeof drawn_definitions / sizeof *drawn_definitions; m++)
            if (!cagd_read_definition(&scope, drawn_definitions[m], 0, (int)strlen(drawn_definitions[m]), &error))
                fail_msg("%s: %s", drawn_definitions[m], error.message);
        const char *ranges = drawn_statements[k].ranges, *text = drawn_statements[k].statement;
        if (!cagd_read_ranges(&scope, ranges, 0, (int)strlen(ranges), &error))
            fail_msg("%s: %s", ranges, error.message);
        const cagd_tree *t = cagd_read_statement(&scope, text, 0, (int)strlen(text), &error);
        if (t == NULL)
            fail_msg("%s: %s", text, error.message);
        cagd_finding found;
        cagd_check(&scope, t, 60, &found);
        if (found.answer != drawn_statements[k].answer || found.cases != drawn_statements[k].cases ||
            found.failing != drawn_statements[k].failing)
            fail_msg("%d, %s for %s: answer %d, %ld of %ld cases fail", drawn_statements[k].number, text, ranges,
                     (int)found.answer, found.failing, found.cases);
        counts[found.answer]++;
        region_faults = 0;
        field_close();
        region_drop(mark);
    }
    assert_true(STRIDE * counts[CAGD_HOLDS] > 400 && STRIDE * counts[CAGD_FAILS] > 600);
    assert_true(4 * counts[CAGD_UNDECIDED] < counts[CAGD_HOLDS]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(drawn)};
    return run_unit_tests(tests);
}
