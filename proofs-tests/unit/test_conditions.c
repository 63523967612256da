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
        {{"*a <= b", "*b < c", "*c <= d", "a < d"}, "nnny"}, /* chains of three, whatever their order */
        {{"*c <= d", "*b < c", "*a <= b", "d > a"}, "nnny"},
        {{"*b <= c", "*c <= d", "*a <= b", "a < d"}, "nnnn"},
        {{"*b <= c", "*c <= d", "*a <= b", "d >= a"}, "nnny"},
        {{"*a > 2", "*b >= a", "b > 1"}, "nny"},
        {{"*a > -1/2", "a > -1"}, "ny"},
        {{"*a > -1", "a > -1/2"}, "nn"},
        {{"*a < 1/3", "a < 1/3"}, "ny"},
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

/* What follows by sums and multiples, of conditions and of denominators, wherever they stand among others. */
static void what_follows_from_sums(void **state)
{
    (void)state;
    static const struct {
        struct {
            const char *polynomial;
            int holding, given;
        } condition[4];
        const char *implied, *denominators, *left;
    } list[] = {
        {{{"a-1", ABOVE, 0}, {"b-2", ABOVE, 0}, {"a+b-3", ABOVE, 0}}, "nny", "a\nb\na+b\na-b\n", "a-b\n"},
        {{{"a+b-3", ABOVE, 0}, {"a-1", ABOVE, 0}, {"b-2", ABOVE, 0}}, "ynn", "a-b\na\nb\na+b\n", "a-b\n"},
        {{{"a-1", ABOVE | ZERO, 1}, {"b-2", ABOVE | ZERO, 1}, {"a+b-3", ABOVE, 0}}, "nnn", "a-1\na+b-2\n", "a-1\n"},
        {{{"a-1", ABOVE | ZERO, 1}, {"b-2", ABOVE | ZERO, 1}, {"a+b-3", ABOVE | ZERO, 0}},
         "nny",
         "b-2\na+b\nb-1\n",
         "b-2\n"},
        {{{"a-b", BELOW, 1}, {"b-c", BELOW, 1}, {"2*a-2*c", ABOVE | BELOW, 0}}, "nny", "3*a-3*c\na-2*c\n", "a-2*c\n"},
        {{{"a", ABOVE, 1}, {"b", ABOVE, 1}, {"a*b", ABOVE, 0}}, "nny", "a*b+1\na*b-1\n", "a*b-1\n"},
        {{{"a-2", ZERO, 1}, {"a-3", BELOW, 0}, {"a-2", BELOW | ZERO, 0}, {"b-1", ABOVE, 0}},
         "nyyn",
         "b\na-1\na-2\n",
         "a-2\n"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        condition c[4] = {{.left = ""}};
        char denominators[100], name[8][8];
        int count = 0;
        for (; count < 4 && list[k].condition[count].polynomial != NULL; count++) {
            snprintf(name[2 * count], 8, "l%d", count), snprintf(name[2 * count + 1], 8, "r%d", count);
            c[count] = (condition){.left = name[2 * count],
                                   .relation = "?",
                                   .right = name[2 * count + 1],
                                   .difference = "",
                                   .opposite = "",
                                   .polynomial = list[k].condition[count].polynomial,
                                   .holding = list[k].condition[count].holding,
                                   .given = list[k].condition[count].given};
            if (count > 0)
                c[count - 1].next = &c[count];
        }
        snprintf(denominators, sizeof denominators, "%s", list[k].denominators);
        struct cagd_code_outcome o = {.conditions = c, .denominators = denominators};
        cagd_code_simplify(&o);
        for (int j = 0; j < count; j++)
            if (c[j].implied != (list[k].implied[j] == 'y'))
                fail_msg("case %zu: %s is %simplied", k, c[j].polynomial, c[j].implied ? "" : "not ");
        assert_string_equal(o.denominators, list[k].left);
    }
}

/* ---- where claims hold -------------------------------------------------------------------------------------- */

static num_q value_of_letter(const void *context, const char *name, size_t length)
{
    const struct cagd_code_witness *w = context;
    for (int k = 0; k < w->count; k++)
        if (strlen(w->name[k]) == length && strncmp(w->name[k], name, length) == 0)
            return w->value[k];
    return from_int_q(0);
}

enum { MOST_CLAIMS = 5 };
static void claims_hold_somewhere_or_nowhere(void **state)
{
    (void)state;
    static const struct {
        struct cagd_code_claim claim[MOST_CLAIMS];
        int found;
    } list[] = {{{{"x", ABOVE}}, 1},
                {{{"x", 7}}, 1},
                {{{"x", 0}}, 0},
                {{{"x", ABOVE}, {"y", 0}}, 0},
                {{{"x", ABOVE}, {"x", BELOW}}, 0},
                {{{"x", ZERO}, {"x", ABOVE}}, 0},
                {{{"x", ZERO}, {"x", BELOW}}, 0},
                {{{"x", ABOVE | ZERO}, {"x", BELOW | ZERO}}, 1},
                {{{"x", ABOVE | ZERO}, {"x", BELOW | ZERO}, {"x", ABOVE | BELOW}}, 0},
                {{{"x-1", ABOVE | BELOW}, {"x-1", ABOVE | ZERO}}, 1},
                {{{"x-1", ABOVE | BELOW}, {"x-1", BELOW | ZERO}}, 1},
                {{{"x", ABOVE | BELOW}, {"y", ABOVE | BELOW}, {"x-y", ZERO}, {"x+y-1", BELOW | ZERO}}, 1},
                {{{"x", ABOVE | BELOW}, {"y", ABOVE | BELOW}, {"x+y", ZERO}, {"x-y", ZERO}}, 0},
                {{{"x", ABOVE | BELOW}, {"x-1", ABOVE | BELOW}, {"x", ABOVE | ZERO}, {"x-1", BELOW | ZERO}}, 1},
                {{{"x+y-3", ABOVE}, {"x-1", BELOW}, {"y-2", BELOW}}, 0},
                {{{"x+y-3", ABOVE}, {"x-1", BELOW | ZERO}, {"y-2", BELOW | ZERO}}, 0},
                {{{"x+y-3", ABOVE | ZERO}, {"x-1", BELOW | ZERO}, {"y-2", BELOW | ZERO}}, 1},
                {{{"x+y-3", ABOVE | ZERO}, {"x-1", BELOW}, {"y-2", BELOW | ZERO}}, 0},
                {{{"-2*x+6", ABOVE}, {"x-3", ABOVE | ZERO}}, 0},
                {{{"-2*x+6", ABOVE | ZERO}, {"x-3", ABOVE | ZERO}}, 1},
                {{{"3*k[1]-2*k[10]", ABOVE}, {"k[1]", BELOW}, {"k[10]", ABOVE}}, 0},
                {{{"3*k[1]-2*k[10]", ABOVE}, {"k[1]", BELOW}, {"k[10]", BELOW}}, 1},
                {{{"5", BELOW}}, 0},
                {{{"-5", BELOW}}, 1},
                {{{"5", ZERO}}, 0},
                /* what is not read claims nothing */
                {{{"", ABOVE}, {"(x+1)", BELOW}, {"x/2", ZERO}, {"x", ABOVE}}, 1},
                {{{"(x+1)", BELOW}, {"x", ABOVE}, {"x", BELOW}}, 0},
                /* monomials: even powers are not negative, odd ones and products as their factors are */
                {{{"x^2", BELOW}}, 0},
                {{{"x^2", BELOW | ZERO}}, 1},
                {{{"x^4*y^2", BELOW}}, 0},
                {{{"x^3", BELOW}}, 1},
                {{{"x^3", BELOW}, {"x", ABOVE | ZERO}}, 0},
                {{{"x^3", ZERO}, {"x", ABOVE | ZERO}}, 1},
                {{{"x^3", ZERO}, {"x", ABOVE}}, 0},
                {{{"x^2", ZERO}, {"-x", BELOW}}, 0},
                {{{"x^2", ZERO}, {"x-1", ABOVE | ZERO}}, 0},
                {{{"x^2", ZERO}, {"x+1", ABOVE}}, 1},
                {{{"x^2", ZERO}, {"2*x-1", ABOVE}}, 0},
                {{{"x^2", ZERO}, {"x", ABOVE | ZERO}, {"x-3", ABOVE}}, 0},
                {{{"x*y", BELOW}, {"x", ABOVE | ZERO}, {"y", ABOVE | ZERO}}, 0},
                {{{"x*y", ZERO}, {"x", ABOVE | ZERO}, {"y", ABOVE}}, 1},
                {{{"x*y", ZERO}, {"x", ABOVE}, {"y", ABOVE | ZERO}}, 1},
                {{{"x*y", ZERO}, {"x", ABOVE}, {"y", ABOVE}}, 0},
                {{{"x*y", BELOW}, {"x", ABOVE}}, 1},
                {{{"x*y", BELOW}, {"y", ABOVE}}, 1},
                {{{"x*y*z", BELOW}, {"x", ABOVE}, {"y", ABOVE}}, 1},
                {{{"x*y*z", BELOW}, {"x", ABOVE}, {"y", ABOVE}, {"z", ABOVE}}, 0},
                {{{"x^2*y", BELOW}, {"y", ABOVE | ZERO}}, 0},
                {{{"x*y^2", BELOW}, {"y", ABOVE | ZERO}}, 1},
                {{{"x*y^2", ZERO}, {"x", ABOVE}, {"y", ABOVE}}, 0},
                {{{"x*y", BELOW}, {"x+y", ABOVE}, {"x", ABOVE}}, 1},
                {{{"x*y", BELOW}, {"x+y", ABOVE}, {"y", ABOVE}}, 1},
                {{{"x*y", BELOW}, {"y+x", ABOVE | ZERO}, {"y", ABOVE}}, 1},
                {{{"x*y", BELOW}, {"x", ZERO}, {"y", ABOVE}}, 1}, /* a monomial is a variable of its own */
                {{{"x^2-2*x+1", BELOW}, {"x", BELOW}}, 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        region_mark mark = region_open();
        struct cagd_code_witness w;
        int count = 0;
        while (count < MOST_CLAIMS && list[k].claim[count].polynomial != NULL)
            count++;
        int found = cagd_code_is_anywhere(count, list[k].claim, &w);
        if (found != list[k].found)
            fail_msg("case %zu: %d", k, found);
        int is_linear = 1;
        for (int j = 0; j < count; j++)
            is_linear = is_linear && list[k].claim[j].polynomial[0] != 0 &&
                        strpbrk(list[k].claim[j].polynomial, "^/(") == NULL &&
                        strstr(list[k].claim[j].polynomial, "x*") == NULL;
        if (found == 1 && is_linear)
            assert_true(cagd_code_hold_at(count, list[k].claim, value_of_letter, &w));
        region_drop(mark);
    }
}

/* As many monomials and conditions as there is room for; what is beyond is not decided, and never called impossible. */
static void claims_beyond_what_there_is_room_for(void **state)
{
    (void)state;
    static char text[3000];
    static struct cagd_code_claim claim[500];
    struct cagd_code_witness w;
    for (int many = 240; many <= 241; many++) {
        region_mark mark = region_open();
        text[0] = 0;
        for (int k = 0; k < many; k++)
            snprintf(text + strlen(text), sizeof text - strlen(text), "%sx%d", k > 0 ? "+" : "", k);
        const struct cagd_code_claim two[] = {{text, ABOVE}, {text, BELOW}};
        assert_int_equal(cagd_code_is_anywhere(2, two, &w), many > 240);
        region_drop(mark);
    }
    for (int many = 400; many <= 401; many++) {
        region_mark mark = region_open();
        for (int k = 0; k < many; k++)
            claim[k] = (struct cagd_code_claim){"x", k == 0 ? BELOW : ABOVE};
        assert_int_equal(cagd_code_is_anywhere(many, claim, &w), many > 400 ? -1 : 0);
        region_drop(mark);
    }
}

static void claims_hold_at_a_point_or_not(void **state)
{
    (void)state;
    static const struct {
        const char *polynomial;
        int sign;
    } list[] = {{"x-2", 0},        {"x-3", -1},       {"x-1", 1},     {"-x+2", 0},     {"-x", -1},
                {"x^2-4", 0},      {"x^3-8", 0},      {"x*y+6", 0},   {"x*y", -1},     {"y^2*x-18", 0},
                {"x^2*y^2-36", 0}, {"-3*y-9", 0},     {"k[1]-5", 0},  {"k[1]^2", 1},   {"2*k[1]*x-20", 0},
                {"7", 1},          {"-7", -1},        {"x+y", -1},    {"x+y+1", 0},    {"0", 0},
                {"x-y-5", 0},      {"-x^2*k[1]", -1}, {"12*x-24", 0}, {"x^10-1024", 0}};
    num_q values[] = {from_int_q(2), from_int_q(-3), from_int_q(5)};
    static const char *names[] = {"x", "y", "k[1]"};
    const struct cagd_code_witness point = {3, names, values};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int signs = 0; signs < 8; signs++) {
            int sign = list[k].sign == 0 ? ZERO : list[k].sign > 0 ? ABOVE : BELOW, holds = (signs & sign) != 0;
            for (int at = 0; at < 3; at++) { /* first, second or third of three */
                struct cagd_code_claim claim[3] = {{"x", ABOVE}, {"x", ABOVE}, {"x", ABOVE}};
                claim[at] = (struct cagd_code_claim){list[k].polynomial, signs};
                if (cagd_code_hold_at(3, claim, value_of_letter, &point) != holds)
                    fail_msg("%s, %d", list[k].polynomial, signs);
            }
        }
    static const char *const unread[] = {"", "(x)", "x/2", "x + y"};
    for (size_t k = 0; k < sizeof unread / sizeof *unread; k++)
        assert_false(cagd_code_hold_at(1, &(struct cagd_code_claim){unread[k], 7}, value_of_letter, &point));
    assert_true(cagd_code_hold_at(0, NULL, value_of_letter, &point));
}

/* ---- the other branch of a condition -------------------------------------------------------------------------- */

static void other_branches_are_found_or_closed(void **state)
{
    (void)state;
    static const struct {
        struct cagd_code_claim way[3];
        int k, pattern, found;
        const char *text;
    } list[] = {{{{"t-7", BELOW}}, 0, 0, 1, "t-7 >= 0, at a.c:10"},
                {{{"t-7", BELOW | ZERO}}, 0, 0, 1, "t-7 > 0, at a.c:10"},
                {{{"t-7", ABOVE}}, 0, 0, 1, "t-7 <= 0, at a.c:10"},
                {{{"t-7", ABOVE | ZERO}}, 0, 0, 1, "t-7 < 0, at a.c:10"},
                {{{"t-7", ABOVE | BELOW}}, 0, 0, 1, "t-7 = 0, at a.c:10"},
                {{{"t-7", ZERO}}, 0, 0, 1, "t-7 != 0, at a.c:10"},
                {{{"t", ABOVE}, {"t-1", ABOVE | ZERO}, {"t-2", BELOW}}, 1, 0, 1, "t-1 < 0, at a.c:11"},
                {{{"t", ABOVE}, {"t-1", ABOVE | ZERO}, {"t-2", BELOW}}, 2, 0, 1, "t-2 >= 0, at a.c:12"},
                {{{"t", ABOVE}, {"t+1", ABOVE}}, 1, 0, 0, "t+1 <= 0, at a.c:11"},
                {{{"t", ABOVE}, {"t-1", ABOVE}, {"t-1", ABOVE | ZERO}}, 2, 0, 0, "t-1 < 0, at a.c:12"},
                {{{"t-u[2]", BELOW}, {"u[0]-t", BELOW}}, 1, 0, 1, "u[0]-t >= 0, at a.c:11"},
                /* neighbours that are not one variable are not equal, and in order; what is one variable stays one */
                {{{"u[0]-u[1]", BELOW}}, 0, 0, 0, "u[0]-u[1] >= 0, at a.c:10"},
                {{{"u[1]-u[2]", BELOW}}, 0, 0, 0, "u[1]-u[2] >= 0, at a.c:10"},
                {{{"u[0]-u[2]", BELOW}}, 0, 0, 0, "u[0]-u[2] >= 0, at a.c:10"},
                {{{"u[0]-u[2]", BELOW}}, 0, 1, 0, "u[0]-u[2] >= 0, at a.c:10"},
                {{{"u[2]-t", ABOVE}}, 0, 1, 1, "u[2]-t <= 0, at a.c:10"},
                {{{"u[0]-9", BELOW}}, 0, 1, 1, "u[0]-9 >= 0, at a.c:10"},
                {{{"u[1]-9", BELOW}}, 0, 2, 1, "u[1]-9 >= 0, at a.c:10"},
                /* names that begin alike */
                {{{"uv-5", BELOW}}, 0, 0, 1, "uv-5 >= 0, at a.c:10"},
                {{{"uv-u[0]", ABOVE}, {"uv-u[2]", BELOW}}, 1, 0, 1, "uv-u[2] >= 0, at a.c:11"},
                /* a square is larger somewhere, which chance finds */
                {{{"t^2-100", BELOW | ZERO}}, 0, 0, 1, "t^2-100 > 0, at a.c:10"},
                {{{"t^2+1", ABOVE}}, 0, 0, 0, "t^2+1 <= 0, at a.c:10"},
                {{{"", ABOVE}}, 0, 0, -1, "(a long expression) <= 0, at a.c:10"}};
    struct cagd_code_harness_error error;
    struct cagd_code_harness *h = cagd_code_read_harness(
        ":::{exactly} it\n:input: c = 3; t; u[3] nondecreasing; uv; u3 = 8\n:call: f();\n:output: t\n:::\n", &error);
    assert_non_null(h);
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        condition c[3] = {{.left = ""}};
        int count = 0;
        for (; count < 3 && list[k].way[count].polynomial != NULL; count++) {
            c[count] = (condition){.polynomial = list[k].way[count].polynomial,
                                   .holding = list[k].way[count].signs,
                                   .place = {"a.c", "f", 10 + count}};
            if (count > 0)
                c[count - 1].next = &c[count];
        }
        struct cagd_code_outcome o = {.conditions = c};
        struct cagd_code_point *from = cagd_code_point_new(h, list[k].pattern, 0), *point = NULL;
        const struct cagd_code_leaf leaf = {.outcome = &o, .point = from};
        char text[300];
        int found = cagd_code_branch(h, &leaf, list[k].k, &point, sizeof text, text);
        assert_string_equal(text, list[k].text);
        if (found != list[k].found || (point != NULL) != (found == 1))
            fail_msg("case %zu: %d", k, found);
        if (found == 1) {
            region_mark mark = region_open();
            assert_true(cagd_code_is_of_one_pattern(from, point));
            assert_string_equal(point->input[0].value[0], "3");
            num_q u[5];
            static const char *names[] = {"u[0]", "u[1]", "u[2]", "t", "uv"};
            for (int j = 0; j < 3; j++) {
                u[j] = cagd_from_string_q(point->input[2].value[j]);
                assert_true(j == 0 || (from->input[2].like[j] == from->input[2].like[j - 1]
                                           ? cagd_equal_q(u[j - 1], u[j])
                                           : cagd_compare_q(u[j - 1], u[j]) < 0));
            }
            u[3] = cagd_from_string_q(point->input[1].value[0]);
            u[4] = cagd_from_string_q(point->input[3].value[0]);
            assert_string_equal(point->input[4].value[0], "8");
            const struct cagd_code_witness w = {5, names, u};
            struct cagd_code_claim claim[3];
            for (int j = 0; j <= list[k].k; j++)
                claim[j] = list[k].way[j];
            claim[list[k].k].signs = 7 & ~claim[list[k].k].signs;
            assert_true(cagd_code_hold_at(list[k].k + 1, claim, value_of_letter, &w));
            region_drop(mark);
        }
        cagd_code_point_free(from);
        cagd_code_point_free(point);
    }
    cagd_code_harness_free(h);
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
                                       unit(what_follows_from_sums),
                                       unit(claims_hold_somewhere_or_nowhere),
                                       unit(claims_beyond_what_there_is_room_for),
                                       unit(claims_hold_at_a_point_or_not),
                                       unit(other_branches_are_found_or_closed),
                                       unit(patterns_are_those_of_all_inputs),
                                       unit(runs_go_the_same_way_or_branch_off)};
    return run_unit_tests(tests);
}
