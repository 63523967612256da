/* test_conditions.c -- what the comparisons of code that is run exactly say together: which follow from the others, whether two
 * runs went the same way, and where one branches off from another. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/code/conditions.h"
#include "exact/code/polyhedron.h"

#include <stdio.h>
#include <string.h>

typedef struct cagd_code_condition condition;
enum { MOST = 4, ZERO = CAGD_CODE_ZERO, ABOVE = CAGD_CODE_ABOVE, BELOW = CAGD_CODE_BELOW };

/* ---- which conditions follow ------------------------------------------------------------------------------ */

/* "a < b" of single letters and numbers; a star in front: a precondition.  Its polynomial is left - right. */
static condition condition_of(const char *text, char room[4][16])
{
    int given = text[0] == '*';
    char relation[3];
    assert_int_equal(sscanf(text + given, "%15s %2s %15s", room[0], relation, room[1]), 3);
    snprintf(room[2], 16, "%.6s-%.6s", room[0], room[1]);
    snprintf(room[3], 16, "%.6s-%.6s", room[1], room[0]);
    static const struct {
        const char *relation;
        int holding;
    } known[] = {{"<", BELOW},         {"<=", BELOW | ZERO},  {">", ABOVE},
                 {">=", ABOVE | ZERO}, {"!=", ABOVE | BELOW}, {"==", ZERO}};
    size_t k = 0;
    while (strcmp(known[k].relation, relation) != 0)
        k++;
    return (condition){.left = room[0],
                       .relation = known[k].relation,
                       .right = room[1],
                       .difference = room[2],
                       .opposite = room[3],
                       .polynomial = room[2],
                       .holding = known[k].holding,
                       .given = given};
}

static void what_follows_is_implied(void **state)
{
    (void)state;
    static const struct {
        const char *conditions[MOST];
        const char *implied; /* of each: y or n */
    } list[] = {
        {{"a < b"}, "n"},
        {{"*a < b"}, "n"}, /* what is given is no condition of the code */
        {{"*a < b", "a < b"}, "ny"},
        {{"*a < b", "a <= b"}, "ny"},
        {{"*a <= b", "a < b"}, "nn"},
        {{"*a <= b", "a <= b"}, "ny"},
        {{"*a <= b", "b >= a"}, "ny"},
        {{"*a <= b", "b > a"}, "nn"},
        {{"*a < b", "b > a"}, "ny"},
        {{"*a < b", "a != b"}, "ny"},
        {{"*a < b", "b != a"}, "ny"},
        {{"*a > b", "a != b"}, "ny"},
        {{"*a > b", "b < a"}, "ny"},
        {{"*a >= b", "b < a"}, "nn"},
        {{"*a < b", "b < a"}, "nn"},
        {{"*a <= b", "*b <= c", "a <= c"}, "nny"},
        {{"*a <= b", "*b <= c", "a < c"}, "nnn"},
        {{"*a < b", "*b <= c", "a < c"}, "nny"},
        {{"*a <= b", "*b < c", "a < c"}, "nny"},
        {{"*b < c", "*a <= b", "c > a"}, "nny"},
        {{"*a <= b", "*c <= b", "a <= c"}, "nnn"},
        {{"*a < 1", "a < 2"}, "ny"},
        {{"*a <= 1", "a < 2"}, "ny"},
        {{"*a <= 2", "a < 2"}, "nn"},
        {{"*a <= 1/3", "a < 1/2"}, "ny"},
        {{"*a > -1", "a > -2"}, "ny"},
        {{"a < b", "b < c", "a < c"}, "nny"}, /* from others of the code */
        {{"a < c", "a < b", "b < c"}, "ynn"},
        {{"a < b", "b > a"}, "yn"}, /* one of two that say the same is left */
        {{"a < b", "c < d"}, "nn"},
        {{"a != b"}, "n"},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int with = 0; with < 2; with++) {
            char room[MOST][4][16];
            condition c[MOST];
            int count = 0;
            for (; count < MOST && list[k].conditions[count] != NULL; count++) {
                c[count] = condition_of(list[k].conditions[count], room[count]);
                if (!with)
                    c[count].polynomial = "";
                if (count > 0)
                    c[count - 1].next = &c[count];
            }
            struct cagd_code_outcome o = {.conditions = c};
            cagd_code_simplify(&o);
            for (int j = 0; j < count; j++)
                if (c[j].implied != (list[k].implied[j] == 'y'))
                    fail_msg("case %zu, %s polynomials: %s is %simplied", k, with ? "with" : "without",
                             list[k].conditions[j], c[j].implied ? "" : "not ");
            assert_int_equal(cagd_code_count_conditions(&o), count);
        }
}

/* More texts than are compared: then nothing follows by chains, whether both sides have no room or one of them. */
static void more_texts_than_are_compared(void **state)
{
    (void)state;
    enum { MANY = 210, WITH_SHARED = 400, RIGHTS = 16 };
    static char room[WITH_SHARED][4][16];
    static condition c[WITH_SHARED];
    for (int shared = 0; shared < 2; shared++) {
        const int many = shared ? WITH_SHARED : MANY;
        for (int k = 0; k < many; k++) {
            char text[32];
            snprintf(text, sizeof text, "a%d <= b%d", k, shared ? k % RIGHTS : k);
            c[k] = condition_of(text, room[k]);
            c[k].polynomial = "";
            if (k > 0)
                c[k - 1].next = &c[k];
        }
        struct cagd_code_outcome o = {.conditions = c};
        cagd_code_simplify(&o);
        for (int k = 0; k < many; k++)
            assert_false(c[k].implied);
    }
}

/* x != y is x < y where x <= y is known, with the smaller one to the left and the difference that belongs to it. */
static void unequal_becomes_less(void **state)
{
    (void)state;
    static const struct {
        const char *given, *asked, *left, *relation, *right;
    } list[] = {{"*a <= b", "a != b", "a", "<", "b"},
                {"*a >= b", "a != b", "b", "<", "a"},
                {"*b <= a", "a != b", "b", "<", "a"},
                {"*c <= b", "a != b", "a", "!=", "b"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        char room[2][4][16], expected[16];
        condition c[2] = {condition_of(list[k].given, room[0]), condition_of(list[k].asked, room[1])};
        c[0].next = &c[1];
        struct cagd_code_outcome o = {.conditions = c};
        cagd_code_simplify(&o);
        assert_string_equal(c[1].left, list[k].left);
        assert_string_equal(c[1].relation, list[k].relation);
        assert_string_equal(c[1].right, list[k].right);
        snprintf(expected, sizeof expected, "%s-%s", c[1].left, c[1].right);
        assert_string_equal(c[1].difference, expected);
        snprintf(expected, sizeof expected, "%s-%s", c[1].right, c[1].left);
        assert_string_equal(c[1].opposite, expected);
    }
}

static void denominators_that_are_not_zero_are_not_told(void **state)
{
    (void)state;
    static const struct {
        const char *condition, *left;
    } list[] = {{"a < b", "c-d\n"},
                {"b < a", "c-d\n"},
                {"a != b", "c-d\n"},
                {"a <= b", "a-b\nb-a\nc-d\n"},
                {"a == b", "a-b\nb-a\nc-d\n"},
                {"c > d", "a-b\nb-a\n"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int with = 0; with < 2; with++) { /* by their texts alone, and by the polynomials */
            char room[4][16], denominators[] = "a-b\nb-a\nc-d\n";
            condition c = condition_of(list[k].condition, room);
            if (!with)
                c.polynomial = "";
            struct cagd_code_outcome o = {.conditions = &c, .denominators = denominators};
            cagd_code_simplify(&o);
            assert_string_equal(o.denominators, list[k].left);
        }
}

/* ---- two runs ------------------------------------------------------------------------------------------- */

static const int each[] = {0, 1, 2}, first_two[] = {0, 0, 2}, last_two[] = {0, 1, 1};
static const char *const values[] = {"1", "2", "3"};
static const struct cagd_code_point apart = {.inputs = 2,
                                             .input = {{"s", 3, values, each, 1}, {"t", 3, values, each, 1}}},
                                    in_first = {.inputs = 2,
                                                .input = {{"s", 3, values, first_two, 1}, {"t", 3, values, each, 1}}},
                                    in_second = {.inputs = 2,
                                                 .input = {{"s", 3, values, each, 1}, {"t", 3, values, last_two, 1}}};

static void patterns_are_those_of_all_inputs(void **state)
{
    (void)state;
    const struct cagd_code_point *const all[] = {&apart, &in_first, &in_second};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            assert_int_equal(cagd_code_is_of_one_pattern(all[i], all[j]), i == j);
}

static void runs_go_the_same_way_or_branch_off(void **state)
{
    (void)state;
    const condition first = {.left = "a", .polynomial = "a-b", .holding = BELOW},
                    second = {.left = "b", .polynomial = "b-c", .holding = BELOW | ZERO};
    condition c[2] = {first, second};
    c[0].next = &c[1];
    struct cagd_code_outcome o = {.end = CAGD_CODE_FINISHED, .conditions = c};
    const struct cagd_code_leaf leaf = {.outcome = &o, .point = &apart};
    for (int change = 0; change <= 9; change++) {
        condition d[2] = {first, second};
        d[0].next = &d[1];
        struct cagd_code_outcome p = {.end = CAGD_CODE_FINISHED, .conditions = d};
        struct cagd_code_leaf other = {.outcome = &p, .point = &apart};
        int off = -1; /* at which condition, if at any */
        switch (change) {
        case 1:
            p.end = CAGD_CODE_BOUND;
            break;
        case 2:
            d[0].holding = ABOVE | ZERO, off = 0;
            break;
        case 3:
            d[1].holding = ABOVE, off = 1;
            break;
        case 4:
            d[1].holding = BELOW;
            break;
        case 5:
            d[1].polynomial = "b-d", d[1].holding = ABOVE;
            break;
        case 6:
            d[0].left = "x";
            break;
        case 7:
            d[0].next = NULL;
            break;
        case 8:
            other.point = &in_second, d[0].holding = ABOVE | ZERO;
            break;
        case 9:
            d[1].left = "x", d[1].holding = ABOVE, off = 1;
            break;
        default:
            break;
        }
        assert_int_equal(cagd_code_is_same_way(&leaf, &other), change == 0);
        assert_int_equal(cagd_code_is_same_way(&other, &leaf), change == 0);
        for (int k = 0; k < 3; k++) {
            assert_int_equal(cagd_code_branches_off(&leaf, k, &other), k == off);
            assert_int_equal(cagd_code_branches_off(&other, k, &leaf), k == off);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(what_follows_is_implied),
                                       unit(more_texts_than_are_compared),
                                       unit(unequal_becomes_less),
                                       unit(denominators_that_are_not_zero_are_not_told),
                                       unit(patterns_are_those_of_all_inputs),
                                       unit(runs_go_the_same_way_or_branch_off)};
    return run_unit_tests(tests);
}
