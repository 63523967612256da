#include "exact/expression/example.h"

#include "exact/expression/angle.h"
#include "exact/expression/cell.h"
#include "exact/expression/sign.h"
#include "exact/expression/suppose.h"
#include "exact/words.h"

enum { MOST_CANDIDATES = 16, MOST_TRIES = 1500, MOST_LOOKS = 3000, MOST_ROUNDS = 12 };

static cagd_side_of_box side_of(const cagd_binding *b)
{
    return (cagd_side_of_box){b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
}

/* Whether the number is within what was declared of its name, the other names having values. */
static int is_declared(cagd_context *exact, const cagd_binding *b)
{
    const cagd_variable *v = b->variable;
    for (int high = 0; v != NULL && high < 2; high++) {
        const cagd_tree *end = high ? v->high : v->low;
        int strict = high ? v->high_open : v->low_open;
        if (end == NULL)
            continue;
        cagd_relation relation =
            high ? (strict ? CAGD_LESS : CAGD_LESS_OR_EQUAL) : (strict ? CAGD_GREATER : CAGD_GREATER_OR_EQUAL);
        if (cagd_compare_values(exact, b->value, relation, cagd_evaluate(exact, end)) != 1)
            return 0;
    }
    return 1;
}

/* The value of a name that is a function of others, these having values. */
static num_q value_of_solved(const cagd_context *c, const cagd_binding *b, const num_q value[])
{
    num_q q = b->value.q;
    num_f f = b->value.f;
    if (b->value.rational)
        return q;
    for (int m = 0; m < c->count; m++)
        if (c->binding[m].unknown)
            f = substitute_f(f, c->binding[m].value.f, from_rational_f(value[m]));
    q = from_int_q(0);
    is_constant_f(f, &q);
    return q;
}

/* As cagd_is_example; -1 where the numbers are not within what is supposed. */
static int look_at(const cagd_context *c, const cagd_tree *t, int k, num_q value[], num_q *left, num_q *right)
{
    cagd_context *exact = region_bytes(sizeof *exact);
    if (exact == NULL || region_faults != 0)
        return 0;
    *exact = *c;
    exact->in_field = 0, exact->steps = CAGD_USUAL_STEPS, exact->trouble = NULL, exact->split = NULL;
    exact->until =
        0; /* numbers take their steps alone, and so few of them as are tried are looked at when the time is over, too */
    for (int m = 0; m < c->count; m++)
        if (c->binding[m].unknown) {
            cagd_side_of_box s = side_of(&c->binding[m]);
            if (c->binding[m].is_number || !cagd_is_inside(&s, value[m]) ||
                !cagd_is_within_angle(&c->binding[m], value[m]))
                return -1;
            exact->binding[m].unknown = 0;
            exact->binding[m].value = cagd_value_q(value[m]);
        }
    for (int m = 0; m < c->count; m++)
        if (c->binding[m].solved) {
            value[m] = value_of_solved(c, &c->binding[m], value);
            exact->binding[m].solved = 0;
            exact->binding[m].value = cagd_value_q(value[m]);
        }
    exact->limits = exact->memos = exact->is_empty = 0;
    exact->in_field = 1; /* for what is derived */
    int is = 1;
    for (int m = 0; m < c->count && is == 1; m++)
        is = is_declared(exact, &exact->binding[m]);
    if (is == 1)
        is = cagd_conditions_hold(exact);
    const int is_within = is == 1;
    *left = *right = from_int_q(0);
    if (is == 1 && k < 0)
        is = cagd_truth(exact, t) == 0;
    if (is == 1 && k >= 0) {
        cagd_value a = cagd_evaluate(exact, t->at[k]), b = cagd_evaluate(exact, t->at[k + 1]);
        is = region_faults == 0 && a.rational && b.rational && cagd_compare_values(exact, a, t->relation[k], b) == 0;
        *left = a.q, *right = b.q;
    }
    is = is == 1 && region_faults == 0 && !exact->mixes_angles;
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    return is_within ? is : -1;
}

int cagd_is_example(const cagd_context *c, const cagd_tree *t, int k, num_q value[], num_q *left, num_q *right)
{
    return look_at(c, t, k, value, left, right) == 1;
}

/* Numbers within the bounds, the simplest first. */
static int candidates(const cagd_binding *b, num_q out[])
{
    static const int simple[][2] = {{0, 1}, {1, 1},  {2, 1}, {-1, 1}, {1, 2}, {3, 1},  {-2, 1}, {1, 3},
                                    {2, 3}, {-1, 2}, {3, 2}, {1, 4},  {3, 4}, {1, 10}, {10, 1}};
    cagd_side_of_box s = side_of(b);
    int count = 0;
    for (int k = 0; k < (int)(sizeof simple / sizeof *simple); k++) {
        num_q x = from_ratio_q(simple[k][0], simple[k][1]);
        if (cagd_is_inside(&s, x))
            out[count++] = x;
    }
    if (count < 4 && s.has_low && s.has_high && cagd_compare_q(s.low, s.high) < 0) {
        num_q cut = s.low;
        for (int k = 0; k < 4; k++) {
            cut = cagd_simplest_between(cut, s.high);
            out[count++] = cut;
        }
    }
    if (s.has_low && !s.low_open)
        out[count++] = s.low;
    if (s.has_high && !s.high_open)
        out[count++] = s.high;
    if (count == 0)
        out[count++] = cagd_inside(&s);
    return count;
}

/* All choices whose places in the lists have the sum `total`: simple numbers first. */
struct search {
    const cagd_context *c;
    const cagd_tree *t;
    int k, tries, looks, unknowns, of[CAGD_MOST_UNKNOWNS], count[CAGD_MOST_UNKNOWNS];
    num_q (*list)[MOST_CANDIDATES + 6];
    num_q *value, *left, *right;
};

static int is_example(struct search *s) { return cagd_is_example(s->c, s->t, s->k, s->value, s->left, s->right); }

static int is_patient(const struct search *s) { return s->tries <= MOST_TRIES && s->looks <= MOST_LOOKS; }

static int choose(struct search *s, int m, int total)
{
    if (m == s->unknowns) {
        if (total > 0 || ++s->looks > MOST_LOOKS)
            return 0;
        region_mark mark = region_open();
        int is = look_at(s->c, s->t, s->k, s->value, s->left, s->right);
        s->tries += is >= 0; /* numbers that are not within what is supposed take next to no time */
        if (is != 1)
            region_drop(mark);
        return is == 1;
    }
    for (int i = 0; i < s->count[m] && i <= total && is_patient(s); i++) {
        s->value[s->of[m]] = s->list[m][i];
        if (choose(s, m + 1, total - i))
            return 1;
    }
    return 0;
}

static int is_prime(long n)
{
    for (long d = 2; d * d <= n; d++)
        if (n % d == 0)
            return 0;
    return n > 1;
}

/* Different numbers for different names, another choice in every round: knots must not coincide, nor denominators vanish. */
static num_q different(const cagd_binding *b, int m, int unknowns, int round)
{
    cagd_side_of_box s = side_of(b);
    long prime = 2 * unknowns + 3;
    while (!is_prime(prime))
        prime++;
    long place = (m * (round % (prime - 1) + 1) + round) % prime;
    num_q x = from_int_q(place - prime / 2);
    if (cagd_is_inside(&s, x))
        return x;
    num_q part = from_ratio_q(place + 1, prime + 1);
    if (s.has_low && s.has_high)
        return add_q(s.low, mul_q(sub_q(s.high, s.low), part));
    x = from_int_q(place + 1);
    return s.has_low ? add_q(s.low, x) : s.has_high ? sub_q(s.high, x) : x;
}

/* The numbers of an example become simpler one by one as long as it remains one. */
static int simplified(struct search *s)
{
    for (int m = 0; m < s->unknowns; m++) {
        num_q kept = s->value[s->of[m]];
        int simpler = 0;
        for (int i = 0; i < s->count[m] && !simpler; i++) {
            s->value[s->of[m]] = s->list[m][i];
            simpler = is_example(s);
        }
        if (!simpler)
            s->value[s->of[m]] = kept;
    }
    return is_example(s);
}

static int find_among_different(struct search *s)
{
    for (int round = 0; round < MOST_ROUNDS; round++) {
        for (int m = 0; m < s->unknowns; m++)
            s->value[s->of[m]] = different(&s->c->binding[s->of[m]], m, s->unknowns, round);
        if (is_example(s))
            return simplified(s);
    }
    return 0;
}

/* Around a point of the cell, farther away first: names that are ordered keep their order there. */
static int find_in_cell(struct search *s)
{
    enum { NEAREST = 8 };
    cagd_context *c = region_bytes(sizeof *c);
    num_q at[CAGD_MOST_UNKNOWNS];
    if (c == NULL || s->c->limits == 0)
        return 0;
    *c = *s->c;
    if (!cagd_point_of_cell(c, at))
        return 0;
    for (int round = 0; round < MOST_ROUNDS; round++) {
        num_q step = from_int_q(1);
        for (int near = 0; near <= NEAREST; near++, step = div_q(step, from_int_q(3))) {
            for (int m = 0; m < s->unknowns; m++) {
                long move = (m * (round + 2) + round) % (2 * s->unknowns + 3) - s->unknowns;
                num_q by = near < NEAREST ? mul_q(step, from_ratio_q(move, s->unknowns + 1)) : from_int_q(0);
                s->value[s->of[m]] = add_q(at[s->of[m]], by);
            }
            if (is_example(s))
                return simplified(s);
        }
    }
    return 0;
}

int cagd_find_example(const cagd_context *c, const cagd_tree *t, int k, num_q value[], num_q *left, num_q *right)
{
    struct search s = {.c = c, .t = t, .k = k, .value = value, .left = left, .right = right};
    int most = 0;
    s.list = c->mixes_angles ? NULL : cagd_region_array(CAGD_MOST_UNKNOWNS, 1, sizeof *s.list);
    if (s.list == NULL)
        return 0;
    for (int m = 0; m < c->count; m++)
        if (c->binding[m].unknown) {
            s.of[s.unknowns] = m;
            s.count[s.unknowns] = candidates(&c->binding[m], s.list[s.unknowns]);
            most += s.count[s.unknowns++] - 1;
        }
    for (int total = 0; total <= most && is_patient(&s); total++)
        if (choose(&s, 0, total))
            return 1;
    *left = *right = from_int_q(0);
    return find_among_different(&s) || find_in_cell(&s);
}
