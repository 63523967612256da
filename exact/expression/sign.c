#include "exact/expression/sign.h"

#include "core/clock.h"
#include "exact/decide/cylinders.h"
#include "exact/decide/resultant.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { MOST_FACTORS = 200, MOST_HALVINGS = 9, MOST_SIDES = 12, SECONDS_FOR_A_NUMBER = 2, SECONDS_FOR_HALVES = 3, WORK_AT_AN_END = 48, WORK_ELSEWHERE = 24 };

/* ---- numbers between numbers --------------------------------------------------------------------------- */

static num_q one(void) { return from_int_q(1); }

static int is_point(const cagd_side_of_box *s) { return s->has_low && s->has_high && cagd_equal_q(s->low, s->high); }

num_q cagd_inside(const cagd_side_of_box *s)
{
    if (is_point(s))
        return s->low;
    num_q low = s->has_low ? s->low : sub_q(s->has_high ? s->high : from_int_q(0), from_int_q(2));
    num_q high = s->has_high ? s->high : add_q(s->has_low ? s->low : from_int_q(0), from_int_q(2));
    return cagd_simplest_between(low, high);
}

int cagd_is_inside(const cagd_side_of_box *s, num_q x)
{
    int above = s->has_low ? cagd_compare_q(x, s->low) : 1, below = s->has_high ? cagd_compare_q(s->high, x) : 1;
    return (above > 0 || (above == 0 && !s->low_open)) && (below > 0 || (below == 0 && !s->high_open));
}

/* ---- one variable -------------------------------------------------------------------------------------- */

/* The ends between which all roots are that the side has. */
static void ends_for(poly p, const cagd_side_of_box *s, num_q *low, num_q *high)
{
    num_q bound = root_bound(p);
    *low = s->has_low ? s->low : neg_q(bound);
    *high = s->has_high ? s->high : bound;
    if (!s->has_low && cagd_compare_q(*low, *high) >= 0)
        *low = sub_q(*high, one());
    if (!s->has_high && cagd_compare_q(*low, *high) >= 0)
        *high = add_q(*low, one());
}

static num_q half(num_q a) { return div_q(a, from_int_q(2)); }
static struct cagd_root finer(struct cagd_root r) { return refine_root(r, half(sub_q(r.hi, r.lo))); }
static int is_number(const struct cagd_root *r) { return cagd_equal_q(r->lo, r->hi); }

/* Until there is room between neighbours, and between a root inside and the ends. */
static void separate(int count, struct cagd_root root[], num_q low, num_q high)
{
    for (int k = 0; k < count; k++) {
        while (!is_number(&root[k]) && (cagd_compare_q(root[k].lo, low) <= 0 || cagd_compare_q(root[k].hi, high) >= 0))
            root[k] = finer(root[k]);
        while (k > 0 && cagd_compare_q(root[k - 1].hi, root[k].lo) >= 0) {
            if (!is_number(&root[k]))
                root[k] = finer(root[k]);
            if (!is_number(&root[k - 1]))
                root[k - 1] = finer(root[k - 1]);
        }
    }
}

/* A number in the k-th gap that count roots leave in [low,high], 0 <= k <= count; 0 where there is no gap. */
static int gap(int count, const struct cagd_root root[], int k, num_q low, num_q high, num_q *inside)
{
    num_q a = k > 0 ? root[k - 1].hi : low, b = k < count ? root[k].lo : high;
    if (cagd_compare_q(a, b) >= 0)
        return 0;
    *inside = cagd_simplest_between(a, b);
    return 1;
}

static cagd_answer positive_on_line(poly p, int strict, const cagd_side_of_box *s, num_q *point, int *rational)
{
    *rational = 1;
    *point = cagd_inside(s);
    if (cagd_poly_degree(p) < 1 || is_point(s)) {
        int sign = cagd_sign_q(cagd_poly_value(p, *point));
        return sign > 0 || (sign == 0 && !strict) ? CAGD_HOLDS : CAGD_FAILS;
    }
    num_q low, high;
    ends_for(p, s, &low, &high);
    int room = cagd_poly_degree(p);
    struct cagd_root *root = cagd_region_array(room, 1, sizeof *root);
    int count = root != NULL ? cagd_isolate_roots(p, low, high, root, room) : 0;
    if (region_faults != 0)
        return CAGD_UNDECIDED;
    separate(count, root, low, high);
    for (int k = 0; k <= count; k++)
        if (gap(count, root, k, low, high, point) && cagd_sign_q(cagd_poly_value(p, *point)) < 0)
            return CAGD_FAILS;
    for (int k = 0; strict && k < count; k++) {
        *point = root[k].lo;
        *rational = is_number(&root[k]);
        if (!*rational || cagd_is_inside(s, *point))
            return CAGD_FAILS;
    }
    return CAGD_HOLDS;
}

/* p as a polynomial in that variable alone. */
static poly in_one(num_f p, num_f variable)
{
    poly numerator, denominator;
    cagd_poly_from_field(p, variable, &numerator, &denominator);
    return numerator;
}

/* ---- two variables ------------------------------------------------------------------------------------- */

/* The product with a polynomial of the parameter, its constants left out. */
static num_f times(num_f product, num_f p, num_f parameter)
{
    return degree_f(p, parameter) > 0 ? mul_f(product, p) : product;
}

/* product times a polynomial of the parameter that vanishes wherever the signs of p on the side of t can change their pattern. */
static int critical(num_f p, const cagd_side_of_box *s, num_f parameter, num_f *product)
{
    num_f factor[MOST_FACTORS], content = p, t = s->variable;
    int power[MOST_FACTORS],
        count = !equal_f(t, parameter) && degree_f(p, t) > 0 ? cagd_factors_f(p, t, MOST_FACTORS, factor, power) : 0;
    for (int i = 0; i < count; i++) {
        num_f f = factor[i];
        int degree = degree_f(f, t);
        for (int e = 0; e < power[i]; e++)
            content = div_f(content, f);
        *product = times(*product, coefficient_f(f, t, degree), parameter);
        if (degree > 1)
            *product = times(*product, cagd_resultant_by_f(f, derivative_f(f, t), t), parameter);
        for (int j = 0; j < i; j++)
            *product = times(*product, cagd_resultant_by_f(f, factor[j], t), parameter);
        if (s->has_low)
            *product = times(*product, cagd_numerator_f(substitute_f(f, t, from_rational_f(s->low))), parameter);
        if (s->has_high)
            *product = times(*product, cagd_numerator_f(substitute_f(f, t, from_rational_f(s->high))), parameter);
    }
    *product = times(*product, cagd_numerator_f(content), parameter);
    return count >= 0 && region_faults == 0;
}

static num_f at_number(num_f p, num_f variable, num_q x) { return substitute_f(p, variable, from_rational_f(x)); }

/* A variable of p besides the parameter; 0 where there is none. */
static int other_variable(num_f p, num_f parameter, num_f *out)
{
    const char *name = field_variables();
    for (size_t length; *name != '\0'; name += length + (name[length] == ' ')) {
        char one_name[FIELD_MAX_NAME + 1];
        length = strcspn(name, " ");
        snprintf(one_name, sizeof one_name, "%.*s", (int)length, name);
        *out = variable_f(one_name);
        if (!equal_f(*out, parameter) && degree_f(p, *out) > 0)
            return 1;
    }
    return 0;
}

num_f cagd_factor_of_parameter(num_f p, num_f parameter)
{
    num_f factor[MOST_FACTORS], product = from_int_f(1), other;
    int power[MOST_FACTORS], count = cagd_factors_f(p, parameter, MOST_FACTORS, factor, power);
    for (int i = 0; i < count; i++)
        if (!other_variable(factor[i], parameter, &other))
            product = mul_f(product, factor[i]);
    return product;
}

/* A coefficient of p, a polynomial in the parameter alone that is not 0 unless p is. */
static num_f some_coefficient(num_f p, num_f parameter)
{
    num_f x;
    while (other_variable(p, parameter, &x))
        p = coefficient_f(p, x, degree_f(p, x));
    return p;
}

/* Whether p, as a function of the other variables, is 0 at the root. */
static int is_zero_at(num_f p, num_f parameter, const struct cagd_root *r)
{
    num_f x;
    if (other_variable(p, parameter, &x)) {
        for (int j = degree_f(p, x); j >= 0; j--)
            if (!is_zero_at(coefficient_f(p, x, j), parameter, r))
                return 0;
        return 1;
    }
    poly q = in_one(p, parameter);
    if (cagd_poly_is_zero(q) || is_number(r))
        return cagd_poly_is_zero(q) || cagd_is_zero_q(cagd_poly_value(q, r->lo));
    poly common = poly_gcd(q, r->factor);
    return cagd_poly_degree(common) > 0 && cagd_count_roots(common, r->lo, r->hi, OPEN).distinct > 0;
}

/* The constraint for a number. */
static cagd_answer holds_for(const cagd_constraint *c, num_f parameter, num_q x, num_q *witness, int *rational)
{
    num_f p = at_number(c->p, parameter, x);
    *rational = 0;
    if (c->demand == CAGD_ZERO)
        return region_faults != 0 ? CAGD_UNDECIDED : cagd_is_zero_f(p) ? CAGD_HOLDS : CAGD_FAILS;
    return positive_on_line(in_one(p, c->t.variable), c->demand == CAGD_MORE_THAN_ZERO, &c->t, witness, rational);
}

/* Whether p < 0 at the root for the t with which the constraint fails for the number x beside it: so it is when p has, as a
 * function of the parameter, no root between them. */
static int fails_beyond(const cagd_constraint *c, num_f parameter, const struct cagd_root *r, num_q x)
{
    num_q t;
    int rational, below = cagd_compare_q(x, r->lo) < 0;
    if (holds_for(c, parameter, x, &t, &rational) != CAGD_FAILS || !rational)
        return 0;
    poly q = in_one(at_number(c->p, c->t.variable, t), parameter);
    if (cagd_poly_degree(q) < 0 || cagd_sign_q(cagd_poly_value(q, x)) >= 0)
        return 0;
    return cagd_count_roots(q, below ? x : r->lo, below ? r->hi : x, CLOSED).distinct == 0;
}

/* The constraint for a root that is no rational number, from what holds for the numbers beside it. */
static cagd_answer holds_between(const cagd_constraint *c, num_f parameter, const struct cagd_root *r, int count,
                                 const num_q beside[])
{
    num_q witness;
    int rational, some = 0, all = 1, compact = c->t.has_low && c->t.has_high && !c->t.low_open && !c->t.high_open;
    int zero = c->demand == CAGD_ZERO || equal_f(c->t.variable, parameter) ? is_zero_at(c->p, parameter, r) : 0;
    if (c->demand == CAGD_ZERO || zero)
        return zero && c->demand != CAGD_MORE_THAN_ZERO ? CAGD_HOLDS : CAGD_FAILS;
    for (int k = 0; k < count; k++) {
        int holds = holds_for(c, parameter, beside[k], &witness, &rational) == CAGD_HOLDS;
        some |= holds, all &= holds;
        if (!holds && fails_beyond(c, parameter, r, beside[k]))
            return CAGD_FAILS;
    }
    if (equal_f(c->t.variable, parameter)) /* p is not 0 there, and so its sign is that beside it */
        return some ? CAGD_HOLDS : CAGD_FAILS;
    if (c->demand == CAGD_MORE_THAN_ZERO) /* numbers t with p <= 0 have a limit where the side is compact */
        return !all && compact ? CAGD_FAILS : CAGD_UNDECIDED;
    return some ? CAGD_HOLDS : CAGD_UNDECIDED; /* p >= 0 on one side, and so in the limit */
}

/* ---- a root of the parameter ------------------------------------------------------------------------------ */

/* The sign of sum c[e] y^e over K at the rational y. */
static int sign_over_root(const cagd_algebraic_point *a, const cagd_over_k *p, num_q y)
{
    poly value = cagd_poly_constant(from_int_q(0));
    for (int e = p->degree; e >= 0; e--)
        value = poly_add(poly_scale(value, y), p->c[e]);
    return cagd_algebraic_sign(a, value);
}

/* y - low, of which low is the only root. */
static cagd_over_k minus(num_q low)
{
    return (cagd_over_k){.degree = 1, .c = {cagd_poly_constant(neg_q(low)), cagd_poly_constant(one())}};
}

static int is_end(const cagd_root_over_k *r, int has_end, num_q end)
{
    return has_end && r->of->degree == 1 && cagd_poly_equal(r->of->c[0], cagd_poly_constant(neg_q(end)));
}

/* The constraint for a root itself: p over K = Q(root) has its roots in t isolated, the ends of the side being roots of y - low and y - high, and between
 * neighbours one number decides.  UNDECIDED where the degree in t times that of the root is more than `work`. */
static cagd_answer holds_at_root(const cagd_constraint *c, num_f parameter, const struct cagd_root *r, int work)
{
    enum { MOST_ROOTS = 2 * CAGD_MOST_OVER_K };
    int strict = c->demand == CAGD_MORE_THAN_ZERO, degree = cagd_poly_degree(r->factor), parts = 0;
    num_f x[] = {parameter, c->t.variable};
    cagd_root_over_k *root = cagd_region_array(MOST_ROOTS, 1, sizeof *root);
    cagd_over_k *part = cagd_region_array(3, 1, sizeof *part);
    if (root == NULL || part == NULL || degree_f(c->p, c->t.variable) * degree > work ||
        degree_f(c->p, c->t.variable) > CAGD_MOST_OVER_K)
        return CAGD_UNDECIDED;
    cagd_algebraic_point a = {.theta = *r, .count = 1};
    a.theta.factor = poly_scale(r->factor, div_q(one(), cagd_poly_coefficient(r->factor, degree)));
    a.coordinate[0] = poly_remainder(cagd_poly_variable(), a.theta.factor);
    cagd_over_k p = cagd_algebraic_polynomial(&a, c->p, x);
    if (p.degree < 0)
        return strict ? CAGD_FAILS : CAGD_HOLDS;
    const cagd_side_of_box *t = &c->t;
    for (int k = 0; k < 2; k++) {
        int has = k == 0 ? t->has_low : t->has_high, open = k == 0 ? t->low_open : t->high_open;
        num_q end = k == 0 ? t->low : t->high;
        int sign = has && !open ? sign_over_root(&a, &p, end) : 1;
        if (sign < 0 || (strict && sign == 0))
            return CAGD_FAILS;
        if (has)
            part[parts++] = minus(end);
    }
    if (is_point(t))
        return CAGD_HOLDS;
    part[parts++] = p;
    int count = cagd_roots_over_k(&a, parts, part, MOST_ROOTS, root), low = -1, high = count;
    if (count < 0)
        return CAGD_UNDECIDED;
    for (int k = 0; k < count; k++) {
        low = is_end(&root[k], t->has_low, t->low) ? k : low;
        high = is_end(&root[k], t->has_high, t->high) ? k : high;
    }
    if (strict && high - low > 1)
        return CAGD_FAILS;
    for (int k = low; k < high; k++) { /* behind root k, before root k + 1 */
        num_q y = count == 0       ? from_int_q(0)
                  : k < 0          ? sub_q(root[0].lo, one())
                  : k + 1 == count ? add_q(root[k].hi, one())
                                   : div_q(add_q(root[k].hi, root[k + 1].lo), from_int_q(2));
        if (sign_over_root(&a, &p, y) < 0)
            return CAGD_FAILS;
    }
    return region_faults == 0 ? CAGD_HOLDS : CAGD_UNDECIDED;
}

/* ---- alternatives -------------------------------------------------------------------------------------- */

/* How many constraints the clause has that begins with that one. */
static int length_of_clause(const cagd_constraint *c)
{
    int n = 1;
    while (c[n - 1].or_next)
        n++;
    return n;
}

static int is_of_parameter(const cagd_constraint *c, num_f parameter) { return equal_f(c->t.variable, parameter); }

/* Those of the clause from number i on that have the same other variable as it, if it is the first of them; alone where it has none. */
static int group_of(int n, const cagd_constraint c[], int i, num_f parameter, int of[])
{
    int count = 0, alone = is_of_parameter(&c[i], parameter);
    for (int k = 0; k < n; k++) {
        if (k != i && (alone || !equal_f(c[k].t.variable, c[i].t.variable)))
            continue;
        if (k < i)
            return 0;
        of[count++] = k;
    }
    return count;
}

/* That the constraint is false, as a sign. */
static unsigned signs_against(const cagd_constraint *c)
{
    return c->demand == CAGD_AT_LEAST_ZERO    ? CAGD_IS_NEGATIVE
           : c->demand == CAGD_MORE_THAN_ZERO ? CAGD_IS_NEGATIVE | CAGD_IS_ZERO
                                              : CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE;
}

enum { MOST_OF_GROUP = 40 };

/* Whether at every t of the side one of the constraints is true, besides `count` conditions of the parameter, which is x[1] if variables is 2 and
 * otherwise the number `at`. */
static cagd_answer one_is_true(int members, const int of[], const cagd_constraint c[], int count,
                               cagd_sign_condition given[], int variables, const num_f x[], num_q at, num_q *witness,
                               int *rational)
{
    const cagd_side_of_box *t = &c[of[0]].t;
    cagd_algebraic_point point;
    *rational = 0;
    if (t->has_low)
        given[count++] = (cagd_sign_condition){sub_f(x[0], from_rational_f(t->low)),
                                               CAGD_IS_POSITIVE | (t->low_open ? 0 : CAGD_IS_ZERO)};
    if (t->has_high)
        given[count++] = (cagd_sign_condition){sub_f(from_rational_f(t->high), x[0]),
                                               CAGD_IS_POSITIVE | (t->high_open ? 0 : CAGD_IS_ZERO)};
    for (int k = 0; k < members; k++)
        given[count++] = (cagd_sign_condition){variables == 2 ? c[of[k]].p : at_number(c[of[k]].p, x[1], at),
                                               signs_against(&c[of[k]])};
    cagd_sign_condition last = given[--count];
    last.signs = (CAGD_IS_NEGATIVE | CAGD_IS_ZERO | CAGD_IS_POSITIVE) & ~last.signs;
    enum cagd_implication is = region_faults == 0 ? cagd_implies(count, given, last, variables, x,
                                                                 cagd_seconds() + SECONDS_FOR_A_NUMBER, &point)
                                                  : CAGD_IMPLICATION_NOT_KNOWN;
    if (is == CAGD_NOT_IMPLIED) {
        struct cagd_root r = cagd_algebraic_coordinate(&point, 0);
        *witness = r.lo, *rational = is_number(&r);
    }
    return is == CAGD_IMPLIED ? CAGD_HOLDS : is == CAGD_NOT_IMPLIED ? CAGD_FAILS : CAGD_UNDECIDED;
}

/* A number, or a root with the numbers beside it, at which clauses are asked.  For a root of one constraint what holds beside it says most, and quickly;
 * what that leaves undecided is decided at the root itself, if that is not more than so much `work`. */
struct place {
    num_q at;
    const struct cagd_root *root; /* NULL: the number */
    int count;
    const num_q *beside;
    int work;
};

static cagd_answer group_at(int members, const int of[], const cagd_constraint c[], num_f parameter,
                            const struct place *p, num_q *witness, int *rational)
{
    if (members == 1 && p->root == NULL)
        return holds_for(&c[of[0]], parameter, p->at, witness, rational);
    *rational = 0;
    cagd_answer answer =
        members == 1 ? holds_between(&c[of[0]], parameter, p->root, p->count, p->beside) : CAGD_UNDECIDED;
    if (answer != CAGD_UNDECIDED || is_of_parameter(&c[of[0]], parameter) || (members == 1 && p->work == 0))
        return answer;
    if (members == 1) {
        unsigned before = region_faults;
        answer = holds_at_root(&c[of[0]], parameter, p->root, p->work);
        if (region_faults != before) /* a degree that is too high leaves it undecided */
            answer = CAGD_UNDECIDED, region_faults = before | (region_faults & FAULT_MEMORY);
        return answer;
    }
    num_f x[] = {c[of[0]].t.variable, parameter}, f = from_int_f(0);
    cagd_sign_condition given[MOST_OF_GROUP];
    if (p->root == NULL)
        return one_is_true(members, of, c, 0, given, 1, x, p->at, witness, rational);
    for (int e = cagd_poly_degree(p->root->factor); e >= 0; e--)
        f = add_f(mul_f(f, parameter), from_rational_f(cagd_poly_coefficient(p->root->factor, e)));
    given[0] = (cagd_sign_condition){f, CAGD_IS_ZERO};
    given[1] = (cagd_sign_condition){sub_f(parameter, from_rational_f(p->root->lo)), CAGD_IS_POSITIVE};
    given[2] = (cagd_sign_condition){sub_f(from_rational_f(p->root->hi), parameter), CAGD_IS_POSITIVE};
    return one_is_true(members, of, c, 3, given, 2, x, p->at, witness, rational);
}

/* The clause of n constraints: what has different other variables is asked one by one.  *which is the constraint with the witness. */
static cagd_answer clause_at(int n, const cagd_constraint c[], num_f parameter, const struct place *p, num_q *witness,
                             int *rational, int *which)
{
    cagd_answer answer = CAGD_FAILS;
    int of[MOST_OF_GROUP], with_witness = 0;
    *which = 0, *rational = 0;
    if (n > MOST_OF_GROUP - 5)
        return CAGD_UNDECIDED;
    for (int i = 0; i < n && answer != CAGD_HOLDS; i++) {
        num_q t;
        int has_witness, members = group_of(n, c, i, parameter, of);
        cagd_answer one = members > 0 ? group_at(members, of, c, parameter, p, &t, &has_witness) : CAGD_FAILS;
        answer = one == CAGD_FAILS ? answer : one == CAGD_HOLDS ? one : CAGD_UNDECIDED;
        if (members > 0 && one == CAGD_FAILS && !is_of_parameter(&c[i], parameter)) {
            with_witness++;
            *which = i, *rational = has_witness;
            if (has_witness)
                *witness = t;
        }
    }
    *rational &= with_witness == 1 || n == 1;
    return answer;
}

/* ---- cells of a parameter -------------------------------------------------------------------------------- */

/* A number where an answer may change, and the irreducible polynomial that is 0 there. */
struct cut {
    struct cagd_root root;
    num_f factor;
};

/* The roots of p, a polynomial in the parameter, in [low,high], by its irreducible factors: increasing, with room between them.
 * -1 where there are too many. */
static int cuts_of(num_f p, num_f parameter, num_q low, num_q high, struct cut out[])
{
    num_f factor[MOST_FACTORS];
    int power[MOST_FACTORS], count = 0, factors = cagd_factors_f(p, parameter, MOST_FACTORS, factor, power);
    if (factors < 0)
        return -1;
    for (int i = 0; i < factors; i++) {
        poly f = in_one(factor[i], parameter);
        int room = CAGD_MOST_CUTS - count, found = 1;
        struct cagd_root root[CAGD_MOST_CUTS];
        if (cagd_poly_degree(f) == 1) {
            num_q x = neg_q(div_q(cagd_poly_coefficient(f, 0), cagd_poly_coefficient(f, 1)));
            if (cagd_compare_q(x, low) < 0 || cagd_compare_q(x, high) > 0)
                continue;
            root[0] = (struct cagd_root){x, x, 1, f};
        } else {
            found = cagd_isolate_roots(f, low, high, root, room);
        }
        if (found > room)
            return -1;
        for (int k = 0; k < found; k++)
            out[count++] = (struct cut){root[k], factor[i]};
    }
    for (int i = 1; i < count; i++) /* different irreducible factors have no root in common */
        for (int k = i; k > 0; k--) {
            struct cagd_root *before = &out[k - 1].root, *behind = &out[k].root;
            while (cagd_compare_q(before->hi, behind->lo) >= 0 && cagd_compare_q(behind->hi, before->lo) >= 0) {
                if (!is_number(behind))
                    *behind = finer(*behind);
                if (!is_number(before))
                    *before = finer(*before);
            }
            if (cagd_compare_q(before->hi, behind->lo) < 0)
                break;
            struct cut kept = out[k];
            out[k] = out[k - 1], out[k - 1] = kept;
        }
    return count;
}

/* The cells that the roots of the polynomial c of the parameter make, without answers. */
static int cut_into_cells(num_f c, const cagd_side_of_box *parameter, cagd_cells *out, num_f factor[])
{
    num_f lambda = parameter->variable;
    num_q low = cagd_inside(parameter), high = low;
    *out = (cagd_cells){0};
    if (!is_point(parameter)) {
        poly cuts = degree_f(c, lambda) < 1 ? cagd_poly_variable() : in_one(c, lambda);
        struct cut *cut = cagd_region_array(CAGD_MOST_CUTS, 1, sizeof *cut);
        ends_for(cuts, parameter, &low, &high);
        out->count = degree_f(c, lambda) < 1 || cut == NULL ? 0 : cuts_of(c, lambda, low, high, cut);
        for (int k = 0; k < out->count; k++)
            out->root[k] = cut[k].root, factor[k] = cut[k].factor;
    }
    if (region_faults != 0 || out->count < 0)
        return 0;
    separate(out->count, out->root, low, high);
    if (out->count > 0) { /* where the side has no end, a number near the cut will do */
        num_q two = from_int_q(2);
        low = parameter->has_low ? low : sub_q(out->root[0].lo, two);
        high = parameter->has_high ? high : add_q(out->root[out->count - 1].hi, two);
    }
    for (int k = 0; k <= out->count; k++) {
        out->sample[k] = low;
        out->empty[k] = !gap(out->count, out->root, k, low, high, &out->sample[k]) && !is_point(parameter);
    }
    return 1;
}

/* The first clause that does not hold in a cell, and at a cut. */
static void answer_cell(int constraints, const cagd_constraint constraint[], num_f lambda, int k, cagd_cells *out)
{
    struct place here = {.at = out->sample[k]};
    int which;
    for (int i = 0, n; i < constraints && !out->empty[k] && out->cell[k] == CAGD_HOLDS; i += n) {
        n = length_of_clause(&constraint[i]);
        out->cell[k] = clause_at(n, &constraint[i], lambda, &here, &out->witness[k], &out->has_witness[k], &which);
        out->broken[k] = i + which;
    }
}
/* First what is quick: one clause that fails is enough. */
static void answer_cut(int constraints, const cagd_constraint constraint[], num_f lambda, int k, int wholly,
                       cagd_cells *out)
{
    const struct cagd_root *r = &out->root[k];
    num_q witness, beside[2];
    int rational, which;
    struct place here = {.at = r->lo, .root = is_number(r) ? NULL : r, .beside = beside};
    for (int side = k; side <= k + 1; side++)
        if (!out->empty[side])
            beside[here.count++] = out->sample[side];
    int is_end = (!out->empty[k] && out->cell[k] == CAGD_HOLDS) || (!out->empty[k + 1] && out->cell[k + 1] == CAGD_HOLDS);
    for (int turn = 0; turn <= wholly; turn++) {
        here.work = turn == 0 ? 0 : is_end ? WORK_AT_AN_END : WORK_ELSEWHERE;
        cagd_answer all = CAGD_HOLDS;
        for (int i = 0, n; i < constraints && all != CAGD_FAILS; i += n) {
            n = length_of_clause(&constraint[i]);
            cagd_answer answer = clause_at(n, &constraint[i], lambda, &here, &witness, &rational, &which);
            all = answer == CAGD_HOLDS ? all : answer;
        }
        out->at[k] = all;
        if (all != CAGD_UNDECIDED)
            break;
    }
}
static void answer_cells(int constraints, const cagd_constraint constraint[], const cagd_side_of_box *parameter,
                         int wholly, cagd_cells *out)
{
    num_f lambda = parameter->variable;
    memset(out->cell, 0, sizeof out->cell); /* CAGD_HOLDS */
    memset(out->at, 0, sizeof out->at);
    for (int k = 0; k <= out->count; k++)
        answer_cell(constraints, constraint, lambda, k, out);
    for (int k = 0; k < out->count; k++)
        answer_cut(constraints, constraint, lambda, k, wholly, out);
}
void cagd_answer_cells(int constraints, const cagd_constraint constraint[], const cagd_side_of_box *parameter,
                       cagd_cells *out)
{
    answer_cells(constraints, constraint, parameter, 1, out);
}

/* *product times a polynomial of the parameter at whose roots the answer to the clause can change. */
static int critical_of_clause(int n, const cagd_constraint c[], num_f lambda, num_f *product)
{
    int of[MOST_OF_GROUP];
    if (n == 1 && c->demand == CAGD_ZERO) {
        *product = times(*product, some_coefficient(c->p, lambda), lambda);
        return 1;
    }
    for (int i = 0; i < n; i++) {
        int members = n <= MOST_OF_GROUP ? group_of(n, c, i, lambda, of) : 0;
        num_f all = from_int_f(1);
        for (int k = 0; k < members; k++)
            all = mul_f(all, c[of[k]].p);
        if (members > 0 && !critical(all, &c[i].t, lambda, product))
            return 0;
    }
    return n <= MOST_OF_GROUP;
}

/* *product times the polynomials of the parameter at whose roots the answer to the clause does change, or to one of several constraints may. */
static int changes_of(int n, const cagd_constraint c[], const cagd_side_of_box *parameter, num_f *product)
{
    num_f lambda = parameter->variable, cuts = from_int_f(1), factor[CAGD_MOST_CUTS];
    cagd_cells *cells = region_bytes(sizeof *cells);
    if (!critical_of_clause(n, c, lambda, &cuts) || cells == NULL || !cut_into_cells(cuts, parameter, cells, factor))
        return 0;
    answer_cells(n, c, parameter, 0, cells);
    for (int k = 0; k < cells->count; k++) {
        int same = (cells->empty[k] || cells->cell[k] == cells->at[k]) &&
                   (cells->empty[k + 1] || cells->cell[k + 1] == cells->at[k]);
        /* Of several constraints one may change where another one holds: then it is not the same as in the cell that would be left. */
        if ((!same || n > 1) && degree_f(cagd_denominator_f(div_f(*product, factor[k])), lambda) > 0)
            *product = mul_f(*product, factor[k]);
    }
    return region_faults == 0;
}

int cagd_cells_of(int constraints, const cagd_constraint constraint[], const cagd_side_of_box *parameter,
                  cagd_cells *out)
{
    num_f c = from_int_f(1), factor[CAGD_MOST_CUTS];
    *out = (cagd_cells){0};
    for (int i = 0, n; i < constraints; i += n) {
        n = length_of_clause(&constraint[i]);
        if (!changes_of(n, &constraint[i], parameter, &c))
            return 0;
    }
    if (!cut_into_cells(c, parameter, out, factor))
        return 0;
    cagd_answer_cells(constraints, constraint, parameter, out);
    return region_faults == 0;
}

int cagd_telling_failure(const cagd_cells *c)
{
    int best = -1, best_is_near = 0;
    size_t shortest = 0;
    for (int k = 0; k <= c->count; k++) {
        if (c->empty[k] || c->cell[k] != CAGD_FAILS)
            continue;
        int near = (k > 0 && !c->empty[k - 1] && c->cell[k - 1] == CAGD_HOLDS) ||
                   (k < c->count && !c->empty[k + 1] && c->cell[k + 1] == CAGD_HOLDS);
        size_t length = strlen(to_string_q(c->sample[k]));
        if (best < 0 || near > best_is_near || (near == best_is_near && length < shortest))
            best = k, best_is_near = near, shortest = length;
    }
    return best;
}

static cagd_answer positive_in_rectangle(num_f p, int strict, const cagd_side_of_box *t, const cagd_side_of_box *lambda,
                                         num_q *at_t, num_q *at_lambda, int *rational)
{
    cagd_cells *cells = region_bytes(sizeof *cells);
    cagd_constraint c = {.p = p, .demand = strict ? CAGD_MORE_THAN_ZERO : CAGD_AT_LEAST_ZERO, .t = *t};
    cagd_answer answer = CAGD_HOLDS;
    if (cells == NULL || !cagd_cells_of(1, &c, lambda, cells))
        return CAGD_UNDECIDED;
    for (int k = 0; k <= cells->count; k++) {
        if (cells->empty[k] || cells->cell[k] == CAGD_HOLDS)
            continue;
        *at_lambda = cells->sample[k], *at_t = cells->witness[k], *rational = cells->has_witness[k];
        return cells->cell[k];
    }
    for (int k = 0; k < cells->count; k++) {
        const struct cagd_root *r = &cells->root[k];
        if (is_number(r) && !cagd_is_inside(lambda, r->lo))
            continue;
        if (cells->at[k] == CAGD_UNDECIDED)
            answer = CAGD_UNDECIDED;
        if (cells->at[k] != CAGD_FAILS)
            continue;
        *at_lambda = r->lo;
        *rational = 0;
        return is_number(r) ? holds_for(&c, lambda->variable, r->lo, at_t, rational) : CAGD_FAILS;
    }
    return answer;
}

/* ---- more variables ------------------------------------------------------------------------------------ */

/* The sign of p at a point: 1, 0, -1. */
static int sign_at(num_f p, int count, const cagd_side_of_box side[], const num_q point[])
{
    num_q value;
    for (int k = 0; k < count; k++)
        p = at_number(p, side[k].variable, point[k]);
    return region_faults == 0 && is_constant_f(p, &value) ? cagd_sign_q(value) : 1;
}

/* The numerator, (1 + u)^d p for the degree d of a side with both ends, is built without fractions. */
num_f cagd_over_positive_numbers(num_f p, int count, const cagd_side_of_box side[])
{
    for (int k = 0; k < count; k++) {
        num_f u = side[k].variable, one_more = add_f(from_int_f(1), u);
        num_f a = from_rational_f(side[k].has_low ? side[k].low : from_int_q(0));
        num_f b = from_rational_f(side[k].has_high ? side[k].high : from_int_q(0));
        if (!side[k].has_low || !side[k].has_high) {
            p = substitute_f(p, u, side[k].has_low ? add_f(a, u) : sub_f(b, u));
            continue;
        }
        num_f top = add_f(a, mul_f(b, u)), below = from_int_f(1), sum = from_int_f(0);
        for (int e = degree_f(p, u); e >= 0 && region_faults == 0; e--) {
            sum = add_f(mul_f(sum, top), mul_f(coefficient_f(p, u, e), below));
            below = mul_f(below, one_more);
        }
        p = sum;
    }
    return p;
}

int cagd_is_positive_by_coefficients(num_f p, int strict, int count, const cagd_side_of_box side[])
{
    for (int k = 0; k < count; k++)
        if (degree_f(p, side[k].variable) > 0 && !side[k].has_low && !side[k].has_high)
            return 0;
    if (cagd_coefficients_sign_f(cagd_over_positive_numbers(p, count, side)) != 1)
        return 0;
    for (int corner = 0; strict && corner < 1 << count; corner++) {
        num_f on_face = p;
        for (int k = 0; k < count; k++) {
            int high = corner >> k & 1;
            int low_is = side[k].has_low && !side[k].low_open, high_is = side[k].has_high && !side[k].high_open;
            if (low_is || high_is)
                on_face = substitute_f(on_face, side[k].variable,
                                       from_rational_f((high && high_is) || !low_is ? side[k].high : side[k].low));
        }
        if (cagd_is_zero_f(on_face))
            return 0;
    }
    return region_faults == 0;
}

/* The same, of which nothing is kept. */
static int is_shown_by_coefficients(num_f p, int strict, int count, const cagd_side_of_box side[])
{
    region_mark mark = region_open();
    int is = cagd_is_positive_by_coefficients(p, strict, count, side);
    region_drop(mark);
    return is;
}

static cagd_answer positive_by_halves(num_f p, int strict, int count, const cagd_side_of_box side[], int depth,
                                      double until, num_q point[])
{
    /* The corners, and a point inside. */
    for (int corner = 0; corner <= 1 << count; corner++) {
        int usable = 1;
        for (int k = 0; k < count; k++) {
            int high = corner >> k & 1;
            point[k] = corner == 1 << count ? cagd_inside(&side[k]) : high ? side[k].high : side[k].low;
            usable &= corner == 1 << count ||
                      (high ? side[k].has_high && !side[k].high_open : side[k].has_low && !side[k].low_open);
        }
        int sign = usable ? sign_at(p, count, side, point) : 1;
        if (sign < 0 || (sign == 0 && strict))
            return CAGD_FAILS;
    }
    if ((cagd_is_zero_f(p) && !strict) || is_shown_by_coefficients(p, strict, count, side))
        return CAGD_HOLDS;
    if (depth == 0 || region_faults != 0 || cagd_seconds() > until)
        return CAGD_UNDECIDED;
    /* The longest side in halves; a side without an end at a distance of 1 from the other. */
    int longest = 0;
    num_q length = from_int_q(-1);
    for (int k = 0; k < count; k++) {
        if (is_point(&side[k]))
            continue;
        num_q l = side[k].has_low && side[k].has_high ? sub_q(side[k].high, side[k].low) : from_int_q(4);
        if (cagd_compare_q(l, length) > 0)
            longest = k, length = l;
    }
    cagd_answer answer = CAGD_HOLDS;
    for (int high = 0; high < 2; high++) {
        cagd_side_of_box part[MOST_SIDES];
        for (int k = 0; k < count; k++)
            part[k] = side[k];
        cagd_side_of_box *s = &part[longest];
        num_q cut = s->has_low && s->has_high ? half(add_q(s->low, s->high))
                    : s->has_low              ? add_q(s->low, one())
                    : s->has_high             ? sub_q(s->high, one())
                                              : from_int_q(0);
        if (high)
            s->has_low = 1, s->low = cut, s->low_open = 0;
        else
            s->has_high = 1, s->high = cut, s->high_open = 0;
        cagd_answer one_half = positive_by_halves(p, strict, count, part, depth - 1, until, point);
        if (one_half == CAGD_FAILS)
            return CAGD_FAILS;
        answer = one_half == CAGD_UNDECIDED ? CAGD_UNDECIDED : answer;
    }
    return answer;
}

/* p over the even powers of its irreducible factors, which are positive wherever they are not 0. */
static num_f without_squares(num_f p, int count, const cagd_side_of_box side[])
{
    num_f rest = p, factor[MOST_FACTORS];
    int power[MOST_FACTORS];
    for (int k = 0; k < count; k++) {
        int factors = cagd_factors_f(rest, side[k].variable, MOST_FACTORS, factor, power);
        for (int i = 0; i < factors; i++)
            for (int e = 0; e + 1 < power[i]; e += 2)
                rest = div_f(rest, mul_f(factor[i], factor[i]));
    }
    return rest;
}

static int variables_in(num_f p, int count, const cagd_side_of_box side[])
{
    int n = 0;
    for (int k = 0; k < count; k++)
        n += degree_f(p, side[k].variable) > 0;
    return n;
}

/* Whether p >= 0 without cutting the box: by its coefficients, or, for some x of degree 2, p = A x^2 + B x + C because A, C and
 * 4 A C - B^2 are at least 0, which have one variable less. */
static int is_nonnegative_by_squares(num_f p, int count, const cagd_side_of_box side[])
{
    num_q unused[MOST_SIDES];
    int rational;
    if (variables_in(p, count, side) <= 2)
        return cagd_positive_in_box(p, 0, count, side, unused, &rational) == CAGD_HOLDS;
    p = without_squares(p, count, side);
    if (cagd_is_positive_by_coefficients(p, 0, count, side))
        return 1;
    for (int k = 0; k < count && region_faults == 0; k++) {
        num_f x = side[k].variable;
        if (degree_f(p, x) != 2)
            continue;
        num_f A = coefficient_f(p, x, 2), B = coefficient_f(p, x, 1), C = coefficient_f(p, x, 0);
        num_f part[] = {A, C, sub_f(mul_f(from_int_f(4), mul_f(A, C)), mul_f(B, B))};
        int good = 1;
        for (int i = 0; i < 3 && good; i++)
            good = is_nonnegative_by_squares(part[i], count, side);
        return good; /* the first of its kind: with all of them it would take long */
    }
    return 0;
}

cagd_answer cagd_positive_in_box(num_f p, int strict, int count, const cagd_side_of_box side[], num_q point[],
                                 int *rational)
{
    cagd_side_of_box used[MOST_SIDES];
    int which[MOST_SIDES], n = 0;
    num_q at[MOST_SIDES];
    *rational = 1;
    for (int k = 0; k < count; k++) {
        point[k] = cagd_inside(&side[k]);
        if (degree_f(p, side[k].variable) < 1)
            continue;
        if (n == MOST_SIDES)
            return CAGD_UNDECIDED;
        at[n] = point[k], which[n] = k, used[n++] = side[k];
    }
    cagd_answer answer;
    if (n <= 1) {
        cagd_side_of_box none = {.variable = cagd_variable_f("v0")};
        answer = positive_on_line(in_one(p, n == 1 ? used[0].variable : none.variable), strict,
                                  n == 1 ? &used[0] : &none, &at[0], rational);
    } else if (n == 2) {
        int swap = degree_f(p, used[0].variable) < degree_f(p, used[1].variable); /* the other way is shorter */
        answer = positive_in_rectangle(p, strict, &used[swap], &used[!swap], &at[swap], &at[!swap], rational);
    } else {
        int is = !strict && is_nonnegative_by_squares(p, n, used);
        answer = is && region_faults == 0
                     ? CAGD_HOLDS
                     : positive_by_halves(p, strict, n, used, MOST_HALVINGS, cagd_seconds() + SECONDS_FOR_HALVES, at);
    }
    for (int k = 0; k < n; k++)
        point[which[k]] = at[k];
    return answer;
}
