#include "exact/expression/angle_bounds.h"

#include "exact/expression/angle.h"
#include "exact/expression/cell.h"
#include "exact/words.h"

enum { MOST_PARTS = 48, NEARNESS = 1 << 20 };

int cagd_share_of_angle(const cagd_context *c) { return c->whole_angles ? 2 : 4; }

/* ---- from where to where --------------------------------------------------------------------------------- */

/* Ends from -1/2 to 3/2 of the way around: where there is an x for everything between them, perhaps after turning by quarters. */
static void turn(cagd_way_around *w, num_q full)
{
    num_q half = div_q(full, from_int_q(2)), quarter = div_q(full, from_int_q(4));
    if (cagd_compare_q(w->end[1], half) <= 0)
        return;
    num_q middle = div_q(add_q(w->end[0], w->end[1]), from_int_q(2));
    while (cagd_compare_q(middle, mul_q(quarter, from_ratio_q(2 * w->quarters + 1, 2))) > 0)
        w->quarters++;
    for (int k = 0; k < 2; k++)
        w->end[k] = sub_q(w->end[k], mul_q(quarter, from_int_q(w->quarters)));
    if (cagd_compare_q(w->end[0], neg_q(half)) < 0 || cagd_compare_q(w->end[1], half) > 0)
        w->known = 0;
}

cagd_way_around cagd_way_of_angle(const cagd_context *c, const cagd_variable *v)
{
    cagd_way_around w = {.known = 1, .all = 1};
    if (v->low == NULL && v->high == NULL)
        return w;
    if (v->low == NULL || v->high == NULL || !cagd_multiple_of_pi(c->scope, v->low, &w.end[0]) ||
        !cagd_multiple_of_pi(c->scope, v->high, &w.end[1])) {
        w.known = 0;
        return w;
    }
    num_q full = from_int_q(cagd_share_of_angle(c)), length = sub_q(w.end[1], w.end[0]);
    w.is_empty = cagd_sign_q(length) < 0;
    int order = cagd_compare_q(length, full);
    w.all = order > 0 || (order == 0 && !(v->low_open && v->high_open));
    if (w.is_empty || w.all)
        return w;
    num_q turns = cagd_floor_q(add_q(div_q(w.end[0], full), from_ratio_q(1, 2))); /* x is the same after so many */
    for (int k = 0; k < 2; k++)
        w.end[k] = sub_q(w.end[k], mul_q(turns, full));
    cagd_way_around before = w;
    turn(&w, full);
    num_q behind = sub_q(before.end[1], full);
    if (!w.known && cagd_compare_q(behind, before.end[0]) < 0) {
        w = before;
        w.wraps = 1, w.end[1] = behind;
    }
    return w;
}

/* tan of that many times pi where it is -1, 0 or 1: 1 and *x; 2 for -1/2 and 1/2; 0 for others. */
static int tangent_of(num_q times, num_q *x)
{
    for (int k = -2; k <= 2; k++)
        if (cagd_equal_q(times, from_ratio_q(k, 4))) {
            *x = from_int_q(k);
            return k == 2 || k == -2 ? 2 : 1;
        }
    return 0;
}

/* tan(p pi/q), |p/q| < 1/2, as a root: those of Im (1 + i x)^q are tan(k pi/q), increasing with k.  0 where q is too great. */
static int root_tangent(num_q times, struct cagd_root *out)
{
    num_f x = cagd_variable_f("v0");
    long p = 0, q = 1;
    while (q <= MOST_PARTS && !cagd_value_is_whole(cagd_value_q(mul_q(times, from_int_q(q))), &p))
        q++;
    if (q > MOST_PARTS)
        return 0;
    num_f re = from_int_f(1), im = from_int_f(0), factor[MOST_PARTS];
    int power[MOST_PARTS];
    for (long k = 0; k < q; k++) {
        num_f next = sub_f(re, mul_f(im, x));
        im = add_f(mul_f(re, x), im), re = next;
    }
    poly all, one, f;
    cagd_poly_from_field(im, x, &all, &one);
    num_q far = cagd_root_bound(all);
    int factors = cagd_factors_f(im, x, MOST_PARTS, factor, power);
    for (int i = 0; i < factors && region_faults == 0; i++) {
        struct cagd_root root[MOST_PARTS];
        cagd_poly_from_field(factor[i], x, &f, &one);
        int count = cagd_poly_degree(f) > 1 ? cagd_isolate_roots(f, neg_q(far), far, root, MOST_PARTS) : 0;
        for (int k = 0; k < count && k < MOST_PARTS; k++) {
            *out = cagd_refine_root(root[k], from_ratio_q(1, NEARNESS));
            if (cagd_count_roots(all, neg_q(far), out->lo, CLOSED).distinct == p + (q - 1) / 2)
                return region_faults == 0;
        }
    }
    return 0;
}

int cagd_end_of_angle(const cagd_binding *b, int k, num_f *p)
{
    if (!b->is_root_end[k])
        return 0;
    const struct cagd_root *r = &b->root_end[k];
    num_f x = b->value.f;
    *p = from_int_f(0);
    for (int e = cagd_poly_degree(r->factor); e >= 0; e--)
        *p = add_f(mul_f(*p, x), from_rational_f(cagd_poly_coefficient(r->factor, e)));
    if (cagd_sign_q(cagd_poly_value(r->factor, k == 0 ? r->hi : r->lo)) < 0)
        *p = neg_f(*p);
    return 1;
}

/* The sign of x - r, which is not 0 where r is no rational number. */
static int side_of_root(num_q x, struct cagd_root r)
{
    while (region_faults == 0 && cagd_compare_q(r.lo, x) <= 0 && cagd_compare_q(x, r.hi) <= 0 &&
           !cagd_equal_q(r.lo, r.hi))
        r = cagd_refine_root(r, div_q(sub_q(r.hi, r.lo), from_int_q(2)));
    return cagd_compare_q(x, r.lo);
}

int cagd_is_within_angle(const cagd_binding *b, num_q x)
{
    for (int k = 0; k < 2; k++)
        if (b->is_root_end[k] && side_of_root(x, b->root_end[k]) != (k == 0 ? 1 : -1))
            return 0;
    return 1;
}

/* Whether between the bounds of x the polynomials of the ends that are roots have no other roots than those. */
static int roots_tell(const cagd_binding *b)
{
    for (int k = 0; k < 2; k++) {
        if (!b->is_root_end[k])
            continue;
        poly f = b->root_end[k].factor;
        num_q far = cagd_root_bound(f), low = b->has_low ? b->low : neg_q(far), high = b->has_high ? b->high : far;
        int own = 0;
        for (int m = 0; m < 2; m++)
            own += b->is_root_end[m] && cagd_poly_degree(poly_gcd(f, b->root_end[m].factor)) > 0;
        if (own == 2 && b->root_end_open[0] != b->root_end_open[1]) /* the sign does not tell which end is which */
            return 0;
        if (cagd_compare_q(low, high) >= 0 || cagd_count_roots(f, low, high, CLOSED).distinct != own)
            return 0;
    }
    return region_faults == 0;
}

/* A number between the end k of x, a root, and the nearest number within its bounds where the polynomial of the end is 0, or which is the other end;
 * 0 where there is none. */
static int cut_behind(const cagd_binding *b, int k, num_q *m)
{
    struct cagd_root root[MOST_PARTS], own = b->root_end[k], near;
    num_q far = cagd_root_bound(own.factor), step = from_ratio_q(1, NEARNESS);
    num_q low = k == 0       ? own.hi
                : b->has_low ? b->low
                             : neg_q(far),
          high = k == 1        ? own.lo
                 : b->has_high ? b->high
                               : far;
    int count = cagd_compare_q(low, high) < 0 ? cagd_isolate_roots(own.factor, low, high, root, MOST_PARTS) : 0;
    if (count < 1 || count > MOST_PARTS || region_faults != 0)
        return 0;
    near = cagd_refine_root(root[k == 0 ? 0 : count - 1], step);
    *m = k == 0 ? near.lo : near.hi;
    if (b->is_root_end[1 - k]) {
        const struct cagd_root *other = &b->root_end[1 - k];
        num_q end = k == 0 ? other->lo : other->hi;
        if (cagd_compare_q(end, *m) == (k == 0 ? -1 : 1))
            *m = end;
    }
    if (cagd_compare_q(k == 0 ? own.hi : *m, k == 0 ? *m : own.lo) >= 0)
        return 0;
    *m = k == 0 ? cagd_simplest_between(own.hi, *m) : cagd_simplest_between(*m, own.lo);
    return region_faults == 0;
}

/* ---- ends as bounds of x --------------------------------------------------------------------------------- */

/* x is asked for below m, at m, and above m. */
static int cut_at(cagd_context *c, const cagd_binding *b, num_q m)
{
    if (c->split == NULL && !c->has_cut)
        c->split = b->key, c->split_at = m;
    return 0;
}

/* The tangent of so many times pi: its kind as above, a number, or a root. */
struct end {
    int kind;
    num_q x;
    struct cagd_root root;
};

static int find_end(num_q times, struct end *e)
{
    e->kind = tangent_of(times, &e->x);
    return e->kind > 0 || root_tangent(times, &e->root);
}

/* x is above that end, or below it for k = 1. */
static void bound(cagd_context *c, cagd_binding *b, int k, const struct end *e, int open)
{
    num_q x = e->x;
    if (e->kind == 2)
        return;
    if (e->kind == 0) {
        const struct cagd_root *r = &e->root;
        x = k == 0 ? r->lo : r->hi;
        if (k == 0 ? b->has_low && cagd_compare_q(b->low, r->hi) >= 0
                   : b->has_high && cagd_compare_q(b->high, r->lo) <= 0)
            return; /* a part of the range that does not reach to this end */
        b->is_root_end[k] = 1, b->root_end[k] = *r, b->root_end_open[k] = open;
    }
    num_f above = cagd_in_field(cagd_value_sub(b->value, cagd_value_q(x)));
    cagd_limit_cell(c, k == 0 ? above : neg_f(above), e->kind == 0 || open);
}

/* The sign of x - end. */
static int side_of_end(num_q x, const struct end *e)
{
    return e->kind == 0 ? side_of_root(x, e->root) : cagd_compare_q(x, e->x);
}

/* x is above the first end, or below the second, which is less. */
static int bound_outside(cagd_context *c, cagd_binding *b, const struct end e[2], const int open[2])
{
    if (b->value.rational) {
        int above = side_of_end(b->value.q, &e[0]), below = -side_of_end(b->value.q, &e[1]);
        c->is_empty |= above < open[0] && below < open[1];
        return 1;
    }
    num_q m = cagd_simplest_between(e[1].kind == 0 ? e[1].root.hi : e[1].x, e[0].kind == 0 ? e[0].root.lo : e[0].x);
    int is_above = b->has_low && cagd_compare_q(b->low, m) >= 0,
        is_below = b->has_high && cagd_compare_q(b->high, m) <= 0;
    if (!is_above && !is_below)
        return cut_at(c, b, m);
    bound(c, b, is_above ? 0 : 1, &e[is_above ? 0 : 1], open[is_above ? 0 : 1]);
    return 1;
}

int cagd_bound_angle(cagd_context *c, const cagd_variable *v, cagd_binding *b, const cagd_way_around *w, int *has_apart)
{
    *has_apart = w->all || w->wraps;
    c->used_bounds |= v->low != NULL;
    if (!w->known)
        return 0;
    if (w->is_empty)
        c->is_empty = 1, *has_apart = 0;
    if (w->is_empty || w->all)
        return 1;
    num_q full = from_int_q(cagd_share_of_angle(c)), half = div_q(full, from_int_q(2));
    if (!w->wraps)
        *has_apart =
            (!v->low_open && cagd_equal_q(w->end[0], neg_q(half))) || (!v->high_open && cagd_equal_q(w->end[1], half));
    struct end end[2];
    const int open[2] = {v->low_open, v->high_open};
    for (int k = 0; k < 2; k++)
        if (!find_end(div_q(w->end[k], full), &end[k]))
            return 0;
    if (w->wraps && !bound_outside(c, b, end, open))
        return 0;
    for (int k = 0; k < 2 && !w->wraps; k++)
        bound(c, b, k, &end[k], open[k]);
    if (b->value.rational) { /* a number is inside, or it is not */
        c->is_empty |= !w->wraps && !cagd_is_within_angle(b, b->value.q);
        return 1;
    }
    num_q m;
    for (int k = 0; k < 2 && !roots_tell(b); k++)
        if (b->is_root_end[k] && cut_behind(b, k, &m))
            return cut_at(c, b, m);
    return roots_tell(b);
}
