#include "exact/decide/cylinders.h"

#include "core/clock.h"
#include "exact/decide/resultant.h"
#include "exact/words.h"

enum { MOST_POLYNOMIALS = 60, MOST_ROOTS = 200, MOST_FACTORS = 64, LARGEST = 4000, HIGHEST = 12 };

/* The irreducible polynomials whose last variable is x[k], for each k. */
struct level {
    int count;
    num_f p[MOST_POLYNOMIALS];
};
struct question {
    int given, variables;
    const cagd_sign_condition *condition; /* `given` conditions, and the claim behind them */
    num_f x[CAGD_MOST_COORDINATES];
    int last[MOST_POLYNOMIALS]; /* of each condition the last variable, or -1 */
    struct level level[CAGD_MOST_COORDINATES];
    double until;
    int incomplete; /* in some cell it is not seen that one point decides */
    cagd_algebraic_point *counterexample;
};

static int is_over(const struct question *q) { return region_faults != 0 || cagd_seconds() > q->until; }

static int last_variable(const struct question *q, num_f p)
{
    int k = q->variables - 1;
    while (k >= 0 && degree_f(p, q->x[k]) < 1)
        k--;
    return k;
}

/* ---- projection ---------------------------------------------------------------------------------------- */

/* The irreducible factors of p become polynomials of their levels; 0 where there are too many. */
static int add(struct question *q, num_f p)
{
    num_f factor[MOST_FACTORS];
    int power[MOST_FACTORS];
    for (int k = last_variable(q, p); k >= 0 && region_faults == 0; k = last_variable(q, p)) {
        struct level *level = &q->level[k];
        int count = cagd_words_f(p) > LARGEST ? -1 : cagd_factors_f(p, q->x[k], MOST_FACTORS, factor, power);
        if (count < 0)
            return 0;
        for (int i = 0; i < count; i++) {
            int known = 0;
            for (int m = 0; m < level->count && !known; m++) /* up to a number */
                known = is_constant_f(div_f(factor[i], level->p[m]), NULL);
            if (!known && level->count == MOST_POLYNOMIALS)
                return 0;
            if (!known)
                level->p[level->count++] = factor[i];
            for (int e = 0; e < power[i]; e++)
                p = div_f(p, factor[i]);
        }
    }
    return region_faults == 0;
}

/* The coefficients of p down to one that is a number: where those before it are 0, the degree of p is known. */
static int add_coefficients(struct question *q, num_f p, num_f y)
{
    for (int e = degree_f(p, y); e >= 0; e--) {
        num_f c = coefficient_f(p, y, e);
        if (is_constant_f(c, NULL) && !cagd_is_zero_f(c))
            return 1;
        if (!cagd_is_zero_f(c) && !add(q, c))
            return 0;
    }
    return region_faults == 0;
}

static int project(struct question *q)
{
    for (int k = q->variables - 1; k > 0; k--) {
        num_f y = q->x[k];
        for (int i = 0; i < q->level[k].count; i++) {
            num_f p = q->level[k].p[i];
            int degree = degree_f(p, y);
            if (is_over(q) || degree > HIGHEST || !add_coefficients(q, p, y) ||
                (degree > 1 && !add(q, cagd_resultant_by_f(p, derivative_f(p, y), y))))
                return 0;
            for (int j = 0; j < i; j++)
                if (is_over(q) || !add(q, cagd_resultant_by_f(p, q->level[k].p[j], y)))
                    return 0;
        }
    }
    return !is_over(q);
}

/* ---- points -------------------------------------------------------------------------------------------- */

/* Whether the condition is true at the point, which has a coordinate for each of its variables. */
static int is_true(const struct question *q, const cagd_sign_condition *c, const cagd_algebraic_point *at)
{
    int sign = cagd_algebraic_sign(at, cagd_algebraic_value(at, c->p, q->x));
    unsigned is = sign < 0 ? CAGD_IS_NEGATIVE : sign > 0 ? CAGD_IS_POSITIVE : CAGD_IS_ZERO;
    return (c->signs & is) != 0;
}

static int lift(struct question *q, const cagd_algebraic_point *at, int is_point);

/* What is known at a point over x[0], ..., x[k]: whether there is a counterexample over it. */
static int look_at(struct question *q, const cagd_algebraic_point *at, int is_point)
{
    int k = at->count - 1;
    for (int i = 0; i < q->given && region_faults == 0; i++)
        if (q->last[i] == k && !is_true(q, &q->condition[i], at))
            return 0;
    if (q->last[q->given] == k && region_faults == 0 && is_true(q, &q->condition[q->given], at))
        return 0;
    if (is_over(q))
        return 0;
    if (at->count < q->variables)
        return lift(q, at, is_point);
    *q->counterexample = *at;
    return 1;
}

/* The same for what belongs to a point; nothing of what was computed is kept unless it is a counterexample. */
static int look_once(struct question *q, const cagd_algebraic_point *at, const cagd_root_over_k *r, num_q number,
                     int is_point)
{
    if (is_over(q))
        return 0;
    region_mark mark = region_open();
    cagd_algebraic_point next =
        r != NULL ? cagd_algebraic_with_root(at, r, q->x[0]) : cagd_algebraic_with_number(at, number);
    int found = region_faults == 0 && look_at(q, &next, is_point);
    if (!found)
        region_drop(mark);
    return found;
}

/* The polynomials of the next level over the point; with is_point its cell is a point and nothing more. */
static int specialized(struct question *q, const cagd_algebraic_point *at, int is_point, cagd_over_k out[])
{
    const struct level *level = &q->level[at->count];
    int count = 0, is_top = at->count == q->variables - 1;
    for (int i = 0; i < level->count && region_faults == 0; i++) {
        out[count] = cagd_algebraic_polynomial(at, level->p[i], q->x);
        q->incomplete |= out[count].degree < 0 && !(is_top && is_point);
        count += out[count].degree > 0;
    }
    return count;
}

/* Whether there is a counterexample over the point: numbers between the roots are looked at first, being simpler. */
static int lift(struct question *q, const cagd_algebraic_point *at, int is_point)
{
    cagd_over_k *p = cagd_region_array(MOST_POLYNOMIALS, 1, sizeof *p);
    cagd_root_over_k *root = cagd_region_array(MOST_ROOTS, 1, sizeof *root);
    if (p == NULL || root == NULL)
        return 0;
    int count = specialized(q, at, is_point, p);
    int roots = region_faults == 0 ? cagd_roots_over_k(at, count, p, MOST_ROOTS, root) : -1, found = 0;
    if (roots < 0) {
        region_faults |= FAULT_UNABLE;
        return 0;
    }
    num_q two = from_int_q(2), zero = from_int_q(0);
    for (int k = 0; k <= roots && !found && !is_over(q); k++) {
        num_q low = k > 0       ? root[k - 1].hi
                    : roots > 0 ? sub_q(root[0].lo, two)
                                : neg_q(two),
              high = k < roots   ? root[k].lo
                     : roots > 0 ? add_q(root[roots - 1].hi, two)
                                 : two;
        found = look_once(q, at, NULL, cagd_simplest_between(low, high), 0);
    }
    for (int k = 0; k < roots && !found && !is_over(q); k++)
        found = look_once(q, at, &root[k], zero, is_point);
    return found;
}

/* ---- the order of the variables ------------------------------------------------------------------------ */

/* The highest degree in which the variable occurs; less than any other for one of which a condition tells its values. */
static int weight_of(const struct question *q, num_f x)
{
    int highest = 0;
    for (int i = 0; i <= q->given; i++) {
        int degree = degree_f(q->condition[i].p, x), others = 0;
        for (int k = 0; k < q->variables; k++)
            others += degree_f(q->condition[i].p, q->x[k]) > 0;
        if (degree > 0 && others == 1 && i < q->given && q->condition[i].signs == CAGD_IS_ZERO)
            return 1000;
        highest = degree > highest ? degree : highest;
    }
    return highest;
}

/* The last variable is eliminated first: that of the least degree.  place[k] is the place of x[k] among those that were given. */
static void order(struct question *q, int place[])
{
    int weight[CAGD_MOST_COORDINATES];
    for (int k = 0; k < q->variables; k++)
        place[k] = k, weight[k] = weight_of(q, q->x[k]);
    for (int i = 1; i < q->variables; i++)
        for (int k = i; k > 0 && weight[k] > weight[k - 1]; k--) {
            num_f x = q->x[k];
            int w = weight[k], p = place[k];
            q->x[k] = q->x[k - 1], q->x[k - 1] = x;
            weight[k] = weight[k - 1], weight[k - 1] = w;
            place[k] = place[k - 1], place[k - 1] = p;
        }
}

/* The coordinates in the order in which the variables were given. */
static void put_back(const struct question *q, const int place[])
{
    cagd_algebraic_point kept = *q->counterexample;
    for (int k = 0; k < q->variables; k++)
        q->counterexample->coordinate[place[k]] = kept.coordinate[k];
}

enum cagd_implication cagd_implies(int count, const cagd_sign_condition given[], cagd_sign_condition claim,
                                   int variables, const num_f x[], double until, cagd_algebraic_point *counterexample)
{
    struct question *q = region_bytes(sizeof *q);
    int place[CAGD_MOST_COORDINATES], found = 0, good = 1;
    if (q == NULL || count + 1 > MOST_POLYNOMIALS || variables < 1 || variables > CAGD_MOST_COORDINATES)
        return CAGD_IMPLICATION_NOT_KNOWN;
    *q = (struct question){.given = count, .variables = variables, .until = until, .counterexample = counterexample};
    cagd_sign_condition *all = cagd_region_array(count + 1, 1, sizeof *all);
    for (int i = 0; i <= count && all != NULL; i++)
        all[i] = i < count ? given[i] : claim;
    for (int k = 0; k < variables; k++)
        q->x[k] = x[k];
    q->condition = all;
    if (all == NULL)
        return CAGD_IMPLICATION_NOT_KNOWN;
    order(q, place);
    cagd_algebraic_point origin = cagd_algebraic_origin();
    for (int i = 0; i <= count && good; i++) {
        q->last[i] = last_variable(q, all[i].p);
        good = add(q, all[i].p);
    }
    if (good && project(q))
        found = look_at(q, &origin, 1);
    else
        q->incomplete = 1;
    q->incomplete |= is_over(q);
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    if (found)
        put_back(q, place);
    return found ? CAGD_NOT_IMPLIED : q->incomplete ? CAGD_IMPLICATION_NOT_KNOWN : CAGD_IMPLIED;
}
