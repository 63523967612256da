#include "exact/expression/sign.h"

#include "exact/decide/resultant.h"
#include "exact/words.h"

enum { MOST_FACTORS = 40, MOST_HALVINGS = 9, MOST_SIDES = 12 };

/* ---- numbers between numbers --------------------------------------------------------------------------- */

static num_q one(void) { return from_int_q(1); }
static num_q rounded_down(num_q a)
{
    mpq_t r;
    mpq_init(r);
    mpz_fdiv_q(mpq_numref(r), mpq_numref(a.at), mpq_denref(a.at));
    num_q result = from_mpq_q(r);
    mpq_clear(r);
    return result;
}

num_q cagd_simplest_between(num_q a, num_q b)
{
    if (cagd_sign_q(a) < 0 && cagd_sign_q(b) > 0)
        return from_int_q(0);
    if (cagd_sign_q(a) < 0)
        return neg_q(cagd_simplest_between(neg_q(b), neg_q(a)));
    num_q whole = rounded_down(a), next = add_q(whole, one()), above = sub_q(b, whole);
    if (cagd_compare_q(next, b) < 0)
        return next;
    if (cagd_equal_q(a, whole)) /* whole + 1/n */
        return add_q(whole, div_q(one(), add_q(rounded_down(div_q(one(), above)), one())));
    return add_q(whole, div_q(one(), cagd_simplest_between(div_q(one(), above), div_q(one(), sub_q(a, whole)))));
}

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

/* A polynomial of the parameter that vanishes wherever the signs of p on the side of t can change their pattern. */
static int critical(num_f p, num_f t, const cagd_side_of_box *s, num_f parameter, num_f *out)
{
    num_f factor[MOST_FACTORS], product = from_int_f(1), content = p;
    int power[MOST_FACTORS], count = cagd_factors_f(p, t, MOST_FACTORS, factor, power);
    for (int i = 0; i < count; i++) {
        num_f f = factor[i];
        int degree = degree_f(f, t);
        for (int e = 0; e < power[i]; e++)
            content = div_f(content, f);
        product = times(product, coefficient_f(f, t, degree), parameter);
        if (degree > 1)
            product = times(product, cagd_resultant_by_f(f, derivative_f(f, t), t), parameter);
        for (int j = 0; j < i; j++)
            product = times(product, cagd_resultant_by_f(f, factor[j], t), parameter);
        if (s->has_low)
            product = times(product, cagd_numerator_f(substitute_f(f, t, from_rational_f(s->low))), parameter);
        if (s->has_high)
            product = times(product, cagd_numerator_f(substitute_f(f, t, from_rational_f(s->high))), parameter);
    }
    *out = times(product, cagd_numerator_f(content), parameter);
    return count >= 0 && region_faults == 0;
}

static num_f at_number(num_f p, num_f variable, num_q x) { return substitute_f(p, variable, from_rational_f(x)); }

int cagd_positive_cells(num_f p, int strict, const cagd_side_of_box *t, const cagd_side_of_box *parameter,
                        cagd_cells *out)
{
    num_f lambda = parameter->variable, c;
    int rational;
    *out = (cagd_cells){0};
    if (!critical(p, t->variable, t, lambda, &c))
        return 0;
    num_q low = cagd_inside(parameter), high = low;
    poly cuts = in_one(c, lambda);
    if (!is_point(parameter)) {
        if (cagd_poly_degree(cuts) < 1)
            cuts = cagd_poly_variable();
        ends_for(cuts, parameter, &low, &high);
        out->count = degree_f(c, lambda) < 1 ? 0 : cagd_isolate_roots(cuts, low, high, out->root, CAGD_MOST_CUTS);
    }
    if (region_faults != 0 || out->count > CAGD_MOST_CUTS)
        return 0;
    separate(out->count, out->root, low, high);
    for (int k = 0; k <= out->count; k++) {
        out->sample[k] = low;
        out->empty[k] = !gap(out->count, out->root, k, low, high, &out->sample[k]) && !is_point(parameter);
        if (!out->empty[k])
            out->cell[k] = positive_on_line(in_one(at_number(p, lambda, out->sample[k]), t->variable), strict, t,
                                            &out->witness[k], &rational);
    }
    int compact = t->has_low && t->has_high && !t->low_open && !t->high_open;
    for (int k = 0; k < out->count; k++) {
        num_q point;
        int below = !out->empty[k] && out->cell[k] == CAGD_HOLDS,
            above = !out->empty[k + 1] && out->cell[k + 1] == CAGD_HOLDS;
        int fails = (!out->empty[k] && !below) || (!out->empty[k + 1] && !above);
        if (is_number(&out->root[k]))
            out->at[k] = positive_on_line(in_one(at_number(p, lambda, out->root[k].lo), t->variable), strict, t, &point,
                                          &rational);
        else if (strict) /* t with p <= 0 have a limit where the side is compact */
            out->at[k] = fails && compact ? CAGD_FAILS : CAGD_UNDECIDED;
        else /* p >= 0 on one side, and so in the limit */
            out->at[k] = below || above ? CAGD_HOLDS : CAGD_UNDECIDED;
    }
    return region_faults == 0;
}

static cagd_answer positive_in_rectangle(num_f p, int strict, const cagd_side_of_box *t, const cagd_side_of_box *lambda,
                                         num_q *at_t, num_q *at_lambda, int *rational)
{
    cagd_cells *cells = region_bytes(sizeof *cells);
    cagd_answer answer = CAGD_HOLDS;
    if (cells == NULL || !cagd_positive_cells(p, strict, t, lambda, cells))
        return CAGD_UNDECIDED;
    for (int k = 0; k <= cells->count; k++) {
        if (cells->empty[k] || cells->cell[k] == CAGD_HOLDS)
            continue;
        *at_lambda = cells->sample[k];
        return positive_on_line(in_one(at_number(p, lambda->variable, *at_lambda), t->variable), strict, t, at_t,
                                rational);
    }
    for (int k = 0; k < cells->count; k++) {
        if (is_number(&cells->root[k]) && !cagd_is_inside(lambda, cells->root[k].lo))
            continue;
        if (cells->at[k] == CAGD_UNDECIDED)
            answer = CAGD_UNDECIDED;
        if (cells->at[k] != CAGD_FAILS)
            continue;
        *at_lambda = cells->root[k].lo;
        *rational = 0;
        if (!is_number(&cells->root[k]))
            return CAGD_FAILS;
        return positive_on_line(in_one(at_number(p, lambda->variable, *at_lambda), t->variable), strict, t, at_t,
                                rational);
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

/* x = a + u, b - u, (a + b u)/(1 + u) for u > 0: the numerator of p. */
static num_f over_positive_numbers(num_f p, int count, const cagd_side_of_box side[])
{
    for (int k = 0; k < count; k++) {
        num_f u = side[k].variable;
        num_f a = from_rational_f(side[k].has_low ? side[k].low : from_int_q(0));
        num_f b = from_rational_f(side[k].has_high ? side[k].high : from_int_q(0)), x;
        if (side[k].has_low && side[k].has_high)
            x = div_f(add_f(a, mul_f(b, u)), add_f(from_int_f(1), u));
        else
            x = side[k].has_low ? add_f(a, u) : sub_f(b, u);
        p = substitute_f(p, u, x);
    }
    return p;
}

static cagd_answer positive_by_halves(num_f p, int strict, int count, const cagd_side_of_box side[], int depth,
                                      num_q point[])
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
    int bounded = 1;
    for (int k = 0; k < count; k++)
        bounded &= side[k].has_low || side[k].has_high;
    if (bounded) {
        num_f q = over_positive_numbers(p, count, side);
        int sign = region_faults == 0 ? cagd_coefficients_sign_f(q) : -2, corners = 1;
        for (int corner = 0; strict && corner < 1 << count; corner++) { /* on every face one coefficient is positive */
            for (int k = 0; k < count; k++)
                point[k] = corner >> k & 1 ? (side[k].has_high ? side[k].high : side[k].low)
                                           : (side[k].has_low ? side[k].low : side[k].high);
            corners &= sign_at(p, count, side, point) > 0;
        }
        if ((sign == 1 || (sign == 0 && !strict)) && corners)
            return CAGD_HOLDS;
    }
    if (depth == 0 || region_faults != 0)
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
        cagd_answer one_half = positive_by_halves(p, strict, count, part, depth - 1, point);
        if (one_half == CAGD_FAILS)
            return CAGD_FAILS;
        answer = one_half == CAGD_UNDECIDED ? CAGD_UNDECIDED : answer;
    }
    return answer;
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
        answer = positive_by_halves(p, strict, n, used, MOST_HALVINGS, at);
    }
    for (int k = 0; k < n; k++)
        point[which[k]] = at[k];
    return answer;
}
