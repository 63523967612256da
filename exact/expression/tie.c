#include "exact/expression/tie.h"

#include "exact/expression/cell.h"
#include "exact/expression/sign.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <stdio.h>

/* How near the ends are between which a name stands for a root. */
static num_q nearness(void) { return from_ratio_q(1, 1L << 40); }

static num_f coefficient(num_f p, num_f x, int k) { return cagd_coefficient_f(p, x, k); }

/* The square root of a > 0 that is a rational number. */
static int has_root(num_q a, num_q *root)
{
    if (cagd_sign_q(a) <= 0 || !mpz_perfect_square_p(mpq_numref(a.at)) || !mpz_perfect_square_p(mpq_denref(a.at)))
        return 0;
    mpq_t r;
    mpq_init(r);
    mpz_sqrt(mpq_numref(r), mpq_numref(a.at));
    mpz_sqrt(mpq_denref(r), mpq_denref(a.at));
    *root = cagd_from_mpq_q(r);
    mpq_clear(r);
    return 1;
}

/* A name of the page that is a variable of the field. */
static int is_free(const cagd_binding *b) { return b->unknown && b->key[0] != '\0' && !b->value.rational; }

/* x >= q or, if `above` is 0, x <= q; of a single variable. */
static void bound(cagd_context *c, num_f x, int above, num_q q, int strict)
{
    num_f d = sub_f(x, from_rational_f(q));
    cagd_limit_cell(c, above ? d : neg_f(d), strict);
}

/* ---- the circle ---------------------------------------------------------------------------------------- */

/* (c/a)^2 + (s/b)^2 = 1 with a, b > 0. */
struct ellipse {
    cagd_binding *c, *s;
    num_q a, b;
};

static int is_ellipse(num_f n, num_f x, num_f y, struct ellipse *e)
{
    num_q p, q, r;
    num_f square_x = mul_f(x, x), square_y = mul_f(y, y);
    if (cagd_degree_f(n, x) != 2 || cagd_degree_f(n, y) != 2 || !is_constant_f(coefficient(n, x, 2), &p) ||
        !is_constant_f(coefficient(n, y, 2), &q))
        return 0;
    num_f rest = sub_f(n, add_f(mul_f(from_rational_f(p), square_x), mul_f(from_rational_f(q), square_y)));
    return is_constant_f(rest, &r) && cagd_sign_q(r) != 0 && has_root(neg_q(div_q(r, p)), &e->a) &&
           has_root(neg_q(div_q(r, q)), &e->b);
}

/* Whether 0 is an end of the name. */
static int ends_at_0(const cagd_binding *b)
{
    return (b->has_low && cagd_sign_q(b->low) == 0) || (b->has_high && cagd_sign_q(b->high) == 0);
}

static int find_ellipse(cagd_context *c, num_f n, struct ellipse *e)
{
    for (int i = 0; i < c->count; i++)
        for (int k = 0; k < i; k++) {
            cagd_binding *x = &c->binding[k], *y = &c->binding[i];
            if (!is_free(x) || !is_free(y) || !is_ellipse(n, x->value.f, y->value.f, e))
                continue;
            e->c = x, e->s = y;
            if (ends_at_0(x) && !ends_at_0(y)) { /* the sign of s is that of u */
                num_q a = e->a;
                e->c = y, e->s = x, e->a = e->b, e->b = a;
            }
            return 1;
        }
    return 0;
}

/* Whether s = b is an end of a name of which nothing is lost: b lies beyond `radius`, or there and belongs to the range. */
static int says_nothing(num_q bound, int open, num_q radius)
{
    int order = cagd_compare_q(bound, radius);
    return order > 0 || (order == 0 && !open);
}

/* The bounds of c = a (1-u^2)/(1+u^2) and s = 2bu/(1+u^2) as bounds of u: c >= q is u^2 <= (a-q)/(a+q).  Others are left out. */
static void bound_ellipse(cagd_context *c, const struct ellipse *e, cagd_binding x, cagd_binding y, num_f u)
{
    num_q root, zero = from_int_q(0), a = e->a;
    int from_0 = y.has_low && cagd_sign_q(y.low) == 0, to_0 = y.has_high && cagd_sign_q(y.high) == 0;
    if (from_0)
        bound(c, u, 1, zero, y.low_open);
    if (to_0)
        bound(c, u, 0, zero, y.high_open);
    c->loose |= (y.has_low && !from_0 && !says_nothing(neg_q(y.low), y.low_open, e->b)) ||
                (y.has_high && !to_0 && !says_nothing(y.high, y.high_open, e->b));
    if (x.has_low && !says_nothing(neg_q(x.low), x.low_open, a)) {
        if (cagd_compare_q(x.low, neg_q(a)) > 0 && has_root(div_q(sub_q(a, x.low), add_q(a, x.low)), &root)) {
            bound(c, u, 0, root, x.low_open);
            bound(c, u, 1, neg_q(root), x.low_open);
        } else if (!cagd_equal_q(x.low, neg_q(a))) { /* c > -a: every u */
            c->loose = 1;
        }
    }
    if (x.has_high && !says_nothing(x.high, x.high_open, a)) {
        if (from_0 && cagd_compare_q(x.high, neg_q(a)) > 0 &&
            has_root(div_q(sub_q(a, x.high), add_q(a, x.high)), &root))
            bound(c, u, 1, root, x.high_open);
        else
            c->loose = 1;
    }
}

static num_f constant(num_q q) { return cagd_in_field(cagd_value_constant(q)); }

static int tie_ellipse(cagd_context *c, struct ellipse *e)
{
    char key[200];
    if (c->aparts == CAGD_MOST_APART)
        return 0;
    cagd_binding x = *e->c, y = *e->s;
    num_q q = div_q(e->a, e->b);
    int is_circle = cagd_equal_q(e->a, from_int_q(1)) && cagd_equal_q(q, e->a);
    if (is_circle)
        snprintf(key, sizeof key, "%s/(1+%s)", y.key, x.key);
    else
        snprintf(key, sizeof key, "(%s) %s/(%s+%s)", to_string_q(q), y.key, to_string_q(e->a), x.key);
    cagd_trace_resume();
    num_f u = cagd_in_field(cagd_value_of_key(c, key, NULL)), two = constant(from_int_q(2));
    num_f square = mul_f(u, u), below = add_f(constant(from_int_q(1)), square);
    num_f of_c = div_f(mul_f(constant(e->a), sub_f(constant(from_int_q(1)), square)), below);
    num_f of_s = div_f(mul_f(constant(e->b), mul_f(two, u)), below);
    cagd_trace_pause();
    if (region_faults != 0)
        return 0;
    cagd_binding_of(c, key)->hidden = 1;
    cagd_becomes_in_cell(c, e->c, of_c);
    cagd_becomes_in_cell(c, e->s, of_s);
    e->c->is_tied = e->s->is_tied = 1;
    bound_ellipse(c, e, x, y, u);
    c->apart[c->aparts++] = (cagd_apart){{x.key, y.key}, {x.variable, y.variable}, {neg_q(e->a), from_int_q(0)}, 2};
    return 1;
}

/* ---- one name as a function of others ------------------------------------------------------------------ */

/* r^2 <= q, or r^2 >= q, as bounds of r; 0 where they are no rational numbers. */
static int bound_square(cagd_context *c, const cagd_binding *r, int above, num_q q, int strict)
{
    num_q root;
    if (above && (cagd_sign_q(q) < 0 || (cagd_sign_q(q) == 0 && !strict)))
        return 1;
    if (!has_root(q, &root) || (above && !(r->has_low && cagd_sign_q(r->low) >= 0)))
        return 0;
    bound(c, r->value.f, above, root, strict);
    if (!above)
        bound(c, r->value.f, 1, neg_q(root), strict);
    return 1;
}

/* The bounds of x = p r^2 + q, p not 0, as bounds of r; of any other function they are left out. */
static void bound_value(cagd_context *c, num_f value, const cagd_binding *x)
{
    for (int k = 0; k < c->count; k++) {
        cagd_binding *r = &c->binding[k];
        num_q p, q;
        if (!is_free(r) || cagd_degree_f(value, r->value.f) != 2 ||
            !is_constant_f(coefficient(value, r->value.f, 2), &p) ||
            !is_constant_f(sub_f(value, mul_f(from_rational_f(p), mul_f(r->value.f, r->value.f))), &q))
            continue;
        int up = cagd_sign_q(p) > 0, good = 1;
        if (x->has_low)
            good &= bound_square(c, r, up, div_q(sub_q(x->low, q), p), x->low_open);
        if (x->has_high)
            good &= bound_square(c, r, !up, div_q(sub_q(x->high, q), p), x->high_open);
        c->loose |= !good;
        return;
    }
    c->loose |= x->has_low || x->has_high;
}

/* The name with the fewest bounds that the polynomial d has with a number as its coefficient, and otherwise not. */
static int tie_linear(cagd_context *c, num_f d)
{
    cagd_binding *best = NULL;
    num_q factor = from_int_q(1), q;
    for (int k = 0; k < c->count; k++) {
        cagd_binding *b = &c->binding[k];
        if (!is_free(b) || cagd_degree_f(d, b->value.f) != 1 || !is_constant_f(coefficient(d, b->value.f, 1), &q))
            continue;
        if (best == NULL || b->has_low + b->has_high <= best->has_low + best->has_high)
            best = b, factor = q;
    }
    if (best == NULL)
        return 0;
    cagd_binding known = *best;
    cagd_trace_resume();
    num_f value = sub_f(known.value.f, div_f(d, constant(factor)));
    cagd_trace_pause();
    cagd_becomes_in_cell(c, best, value);
    best->is_tied = 1;
    bound_value(c, value, &known);
    return region_faults == 0;
}

/* ---- one name alone ------------------------------------------------------------------------------------ */

/* The only variable of n, a polynomial of some degree; NULL where there are others. */
static cagd_binding *only_name(cagd_context *c, num_f n)
{
    cagd_binding *only = NULL;
    for (int k = 0; k < c->count; k++)
        if (c->binding[k].unknown && cagd_degree_f(n, c->binding[k].value.f) > 0) {
            if (only != NULL || !is_free(&c->binding[k]))
                return NULL;
            only = &c->binding[k];
        }
    return only;
}

static int is_within(const cagd_binding *b, num_q x)
{
    cagd_side_of_box s = {b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
    return cagd_is_inside(&s, x);
}

/* The roots of p between the bounds of the name, by its irreducible factors; -1 where there are too many. */
static int roots_of(num_f p, const cagd_binding *b, struct cagd_root out[])
{
    num_f factor[CAGD_MOST_ROOTS];
    int power[CAGD_MOST_ROOTS], factors = cagd_factors_f(p, b->value.f, CAGD_MOST_ROOTS, factor, power), count = 0;
    for (int i = 0; i < factors; i++) {
        poly f, one;
        cagd_poly_from_field(factor[i], b->value.f, &f, &one);
        num_q far = cagd_root_bound(f), low = b->has_low ? b->low : neg_q(far), high = b->has_high ? b->high : far;
        int room = CAGD_MOST_ROOTS - count;
        int found = cagd_compare_q(low, high) <= 0 ? cagd_isolate_roots(f, low, high, out + count, room) : 0;
        if (found > room || region_faults != 0)
            return -1;
        for (int k = count, last = count + found; k < last; k++) {
            struct cagd_root r = cagd_refine_root(out[k], nearness());
            if (!cagd_equal_q(r.lo, r.hi) || is_within(b, r.lo))
                out[count++] = r;
        }
    }
    return factors < 0 ? -1 : count;
}

static int tie_roots(cagd_context *c, num_f n)
{
    cagd_binding *b = only_name(c, n);
    int count = b != NULL ? roots_of(n, b, c->root) : -1;
    if (count < 0)
        return 0;
    if (count == 0) {
        c->is_empty = 1;
        return 1;
    }
    int is_near = b->has_low && b->has_high && cagd_compare_q(sub_q(b->high, b->low), nearness()) <= 0;
    if (count == 1 && is_near && !cagd_equal_q(c->root[0].lo, c->root[0].hi)) {
        b->has_root = 1, b->root = c->root[0];
        return 1;
    }
    c->roots = count, c->rooted = b;
    return -1;
}

void cagd_make_root(cagd_binding *b, poly factor)
{
    struct cagd_root root[CAGD_MOST_ROOTS];
    num_q far = cagd_root_bound(factor);
    int count = cagd_isolate_roots(factor, neg_q(far), far, root, CAGD_MOST_ROOTS);
    if (count < 1 || count > CAGD_MOST_ROOTS || region_faults != 0)
        return;
    b->has_root = b->is_number = b->hidden = 1, b->root = cagd_refine_root(root[count - 1], nearness());
    b->has_low = b->has_high = b->low_open = b->high_open = 1;
    b->low = b->root.lo, b->high = b->root.hi;
}

/* The trace is paused; what names become is noted. */
static int tie(cagd_context *c, num_f d)
{
    struct ellipse e;
    if (!is_constant_f(cagd_denominator_f(d), NULL) || region_faults != 0)
        return 0;
    num_f n = cagd_numerator_f(d);
    if (find_ellipse(c, n, &e))
        return tie_ellipse(c, &e);
    return tie_linear(c, d) ? 1 : tie_roots(c, n);
}

int cagd_tie(cagd_context *c, num_f d)
{
    cagd_trace_pause();
    int is_tied = tie(c, d);
    cagd_trace_resume();
    return is_tied;
}

/* p modulo the polynomial of the root, which is about x. */
static num_f reduced(num_f p, num_f x, const struct cagd_root *r)
{
    int m = cagd_poly_degree(r->factor);
    num_q top = cagd_poly_coefficient(r->factor, m);
    for (int e = cagd_degree_f(p, x); e >= m && region_faults == 0; e = cagd_degree_f(p, x)) {
        num_f times = coefficient(p, x, e);
        for (int i = 0; i < e - m; i++)
            times = mul_f(times, x);
        for (int i = 0; i <= m; i++) {
            num_f term = mul_f(times, from_rational_f(div_q(cagd_poly_coefficient(r->factor, i), top)));
            for (int k = 0; k < i; k++)
                term = mul_f(term, x);
            p = sub_f(p, term);
        }
    }
    return p;
}

cagd_value cagd_at_roots(const cagd_context *c, cagd_value d)
{
    for (int k = 0; k < c->count && !d.rational && region_faults == 0; k++) {
        const cagd_binding *b = &c->binding[k];
        if (!b->has_root || !b->unknown)
            continue;
        num_f x = b->value.f, n = reduced(cagd_numerator_f(d.f), x, &b->root),
              m = reduced(cagd_denominator_f(d.f), x, &b->root);
        d = cagd_value_f(div_f(n, m));
    }
    return d;
}
