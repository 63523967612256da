#include "exact/expression/enclosed.h"

#include "core/clock.h"
#include "exact/expression/angle.h"
#include "exact/expression/angle_bounds.h"
#include "exact/expression/irrational.h"
#include "exact/expression/sign.h"
#include "exact/words.h"

#include <mpfr.h>
#include <string.h>

enum { PRECISION = 320, ERROR = -240, LARGEST = 1 << 20, COARSE = 40, FINE = 160, ROUNDS = 600, NOT_KNOWN = 2 };

/* What a name is between: both numbers are one where it has a value. */
struct between {
    num_q low, high;
};

struct box {
    const cagd_context *c;
    struct between of[CAGD_MOST_UNKNOWNS]; /* of the unknown bindings */
};

/* ---- enclosures ------------------------------------------------------------------------------------------ */

/* The greatest multiple of 2^-bits that is no greater than x; `up`: the least that is no less. */
static num_q rounded(mpfr_srcptr x, int bits, int up)
{
    mpz_t m;
    mpfr_t scaled;
    mpfr_init2(scaled, PRECISION), mpz_init(m);
    mpfr_mul_2si(scaled, x, bits, up ? MPFR_RNDU : MPFR_RNDD);
    mpfr_get_z(m, scaled, up ? MPFR_RNDU : MPFR_RNDD);
    mpq_t q;
    mpq_init(q);
    mpq_set_z(q, m), mpq_div_2exp(q, q, (mp_bitcnt_t)bits);
    num_q r = cagd_from_mpq_q(q);
    mpq_clear(q), mpz_clear(m), mpfr_clear(scaled);
    return r;
}

static struct between enclosed_pi(int bits)
{
    struct between b;
    mpfr_t x;
    mpfr_init2(x, PRECISION);
    mpfr_const_pi(x, MPFR_RNDD), b.low = rounded(x, bits, 0);
    mpfr_const_pi(x, MPFR_RNDU), b.high = rounded(x, bits, 1);
    mpfr_clear(x);
    return b;
}

/* tan((v - q pi)/share), or tan((v - q) pi/share) for of_pi: the angle is computed with an error below 2^ERROR, v being no great number, and the tangent
 * grows with it where no pole is between.  0 where one may be. */
static int enclosed_tangent(num_q v, int of_pi, num_q q, int share, int bits, struct between *out)
{
    if (cagd_compare_q(v, from_int_q(LARGEST)) > 0 || cagd_compare_q(v, from_int_q(-LARGEST)) < 0)
        return 0;
    mpfr_t pi, angle, error, end[2];
    mpfr_inits2(PRECISION, pi, angle, error, end[0], end[1], (mpfr_ptr)0);
    mpfr_const_pi(pi, MPFR_RNDN);
    if (of_pi) {
        mpfr_mul_q(angle, pi, sub_q(v, q).at, MPFR_RNDN);
    } else {
        mpfr_mul_q(angle, pi, q.at, MPFR_RNDN);
        mpfr_neg(angle, angle, MPFR_RNDN);
        mpfr_add_q(angle, angle, v.at, MPFR_RNDN);
    }
    mpfr_div_si(angle, angle, share, MPFR_RNDN);
    mpfr_set_si_2exp(error, 1, ERROR, MPFR_RNDU);
    mpfr_sub(end[0], angle, error, MPFR_RNDD), mpfr_tan(end[0], end[0], MPFR_RNDD);
    mpfr_add(end[1], angle, error, MPFR_RNDU), mpfr_tan(end[1], end[1], MPFR_RNDU);
    int good = mpfr_number_p(end[0]) && mpfr_number_p(end[1]) && mpfr_cmp(end[0], end[1]) <= 0 &&
               mpfr_cmpabs_ui(end[0], LARGEST) < 0 && mpfr_cmpabs_ui(end[1], LARGEST) < 0;
    if (good)
        out->low = rounded(end[0], bits, 0), out->high = rounded(end[1], bits, 1);
    mpfr_clears(pi, angle, error, end[0], end[1], (mpfr_ptr)0);
    return good;
}

/* The tangent of binding m, whose angle is the number v. */
static int enclose_tangent(struct box *b, int m, num_q v, int bits)
{
    const cagd_binding *x = &b->c->binding[m];
    num_q turned =
        from_ratio_q(x->turned * cagd_share_of_angle(b->c), 4); /* quarters of the way around: of 2 pi, or of 4 pi */
    if (cagd_is_zero_q(v) && x->turned == 0) {
        b->of[m] = (struct between){v, v};
        return 1;
    }
    return enclosed_tangent(v, x->of_pi, turned, cagd_share_of_angle(b->c), bits, &b->of[m]);
}

/* ---- signs in the box ------------------------------------------------------------------------------------ */

/* The sign of f, or NOT_KNOWN. */
static int sign_in(const struct box *b, num_f f)
{
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    num_q point[CAGD_MOST_UNKNOWNS], value;
    int count = 0, unused;
    num_f p = mul_f(cagd_numerator_f(f), cagd_denominator_f(f));
    for (int m = 0; m < b->c->count; m++) {
        const struct between *x = &b->of[m];
        num_f name = b->c->binding[m].value.f;
        if (!b->c->binding[m].unknown)
            continue;
        if (cagd_equal_q(x->low, x->high))
            p = substitute_f(p, name, from_rational_f(x->low));
        else
            side[count++] = (cagd_side_of_box){name, 1, 1, 0, 0, x->low, x->high};
    }
    if (region_faults != 0)
        return NOT_KNOWN;
    if (is_constant_f(p, &value))
        return cagd_sign_q(value);
    for (int sign = 1; sign >= -1 && region_faults == 0; sign -= 2)
        if (cagd_positive_in_box(sign > 0 ? p : neg_f(p), 1, count, side, point, &unused) == CAGD_HOLDS)
            return sign;
    return NOT_KNOWN;
}

static int sign_of_value(const struct box *b, cagd_value d)
{
    return region_faults != 0 ? NOT_KNOWN : d.rational ? cagd_sign_q(d.q) : sign_in(b, d.f);
}

/* Whether all relations of t, or of all of them, are true. */
static int is_true(cagd_context *c, const struct box *b, const cagd_tree *t)
{
    if (t->kind != CAGD_ALL && t->kind != CAGD_RELATION)
        return 0;
    for (int k = 0; t->kind == CAGD_ALL && k < t->count; k++)
        if (!is_true(c, b, t->at[k]))
            return 0;
    for (int k = 0; t->kind == CAGD_RELATION && k + 1 < t->count; k++) {
        int sign = sign_of_value(b, cagd_value_sub(cagd_evaluate(c, t->at[k]), cagd_evaluate(c, t->at[k + 1])));
        if (sign == NOT_KNOWN || !cagd_relation_holds(sign, t->relation[k]))
            return 0;
    }
    return 1;
}

/* Whether the end is one of the name, or there is none. */
static int is_beyond(cagd_context *c, const struct box *b, cagd_value x, const cagd_tree *end, int up, int open)
{
    if (end == NULL)
        return 1;
    cagd_value y = cagd_evaluate(c, end);
    int sign = sign_of_value(b, up ? cagd_value_sub(y, x) : cagd_value_sub(x, y));
    return sign == 1 || (sign == 0 && !open);
}

/* Whether the name is within the bounds that it has in the part that is looked at. */
static int is_in_part(const struct box *b, const cagd_binding *x)
{
    for (int up = 0; up < 2; up++) {
        if (!(up ? x->has_high : x->has_low))
            continue;
        num_f bound = from_rational_f(up ? x->high : x->low);
        int sign = sign_in(b, up ? sub_f(bound, x->value.f) : sub_f(x->value.f, bound));
        if (sign != 1 && (sign != 0 || (up ? x->high_open : x->low_open)))
            return 0;
    }
    return 1;
}

/* Whether everything that is supposed is true: what was declared of the names, what the part is, conditions. */
static int is_supposed(const struct box *b)
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL)
        return 0;
    *c = *b->c;
    int is = 1, count = c->count;
    for (int m = 0; m < count && is; m++) {
        const cagd_binding *x = &c->binding[m];
        const cagd_variable *v = x->variable;
        is = !x->unknown || is_in_part(b, x);
        if (is && v != NULL && !v->whole)
            is = is_beyond(c, b, x->value, v->low, 0, v->low_open) &&
                 is_beyond(c, b, x->value, v->high, 1, v->high_open);
    }
    for (int k = 0; k < c->limits && is; k++) {
        int sign = sign_in(b, c->limit[k].form);
        is = sign == 1 || (sign == 0 && !c->limit[k].strict);
    }
    for (int k = 0; k < c->scope->condition_count && is; k++)
        is = is_true(c, b, c->scope->conditions[k]);
    if (is && c->premise != NULL)
        is = is_true(c, b, c->premise);
    is = is && c->count == count && region_faults == 0;
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    return is;
}

/* ---- numbers --------------------------------------------------------------------------------------------- */

/* Number `place` for the name: a part of the way between its bounds where it has both, or a simple one. */
static num_q number_at(const cagd_binding *b, int place)
{
    static const int part[][2] = {{1, 2}, {1, 4}, {3, 4},  {1, 8},   {7, 8},   {1, 3},   {2, 3},
                                  {0, 1}, {1, 1}, {1, 32}, {31, 32}, {1, 100}, {99, 100}},
                     simple[][2] = {{1, 1}, {2, 1}, {1, 2},  {3, 1}, {1, 10}, {-1, 1}, {3, 2},  {0, 1},  {1, 4},
                                    {5, 2}, {4, 1}, {-2, 1}, {6, 1}, {-1, 2}, {-3, 1}, {10, 1}, {1, 100}};
    int has_both = b->has_low && b->has_high,
        count = has_both ? (int)(sizeof part / sizeof *part) : (int)(sizeof simple / sizeof *simple);
    const int *q = has_both ? part[place % count] : simple[place % count];
    num_q x = from_ratio_q(q[0], q[1]);
    return has_both ? add_q(b->low, mul_q(sub_q(b->high, b->low), x)) : x;
}

/* Every name has a number, another choice in every round. */
static int choose(struct box *b, int round, int bits, cagd_enclosed_example *out)
{
    const cagd_context *c = b->c;
    enum { CHOICES = 17 };
    for (int m = 0; m < c->count; m++) {
        const cagd_binding *x = &c->binding[m];
        out->is_enclosed[m] = 0;
        if (!x->unknown || x->angle != NULL || strcmp(x->key, CAGD_PI) == 0)
            continue;
        cagd_side_of_box side = {x->value.f, x->has_low, x->has_high, x->low_open, x->high_open, x->low, x->high};
        num_q v = number_at(x, round % CHOICES);
        round /= CHOICES;
        if (!cagd_is_inside(&side, v))
            return 0;
        b->of[m] = (struct between){v, v}, out->value[m] = v;
    }
    for (int m = 0; m < c->count; m++) {
        const cagd_binding *x = &c->binding[m];
        const int is_pi = strcmp(x->key, CAGD_PI) == 0;
        const cagd_binding *number = x->angle != NULL ? cagd_binding_of((cagd_context *)c, x->angle) : NULL;
        if (!x->unknown || (x->angle == NULL && !is_pi))
            continue;
        out->is_enclosed[m] = is_pi || number != NULL, out->value[m] = from_int_q(0);
        if (is_pi) {
            b->of[m] = enclosed_pi(bits);
        } else if (number != NULL) {
            const num_q v = number->unknown ? out->value[number - c->binding] : number->value.q;
            if (!enclose_tangent(b, m, v, bits))
                return 0;
        } else {
            cagd_side_of_box side = {x->value.f, x->has_low, x->has_high, x->low_open, x->high_open, x->low, x->high};
            out->value[m] = cagd_inside(&side);
            b->of[m] = (struct between){out->value[m], out->value[m]};
            if (!cagd_is_within_angle(x, out->value[m]))
                return 0;
        }
    }
    return region_faults == 0;
}

/* Whether every name without a value can have a number here: none is near a place or a root, and none that is an angle with another value. */
static int can_choose(const cagd_context *c)
{
    for (int m = 0; m < c->count; m++) {
        const cagd_binding *x = &c->binding[m];
        const cagd_binding *number = x->angle != NULL ? cagd_binding_of((cagd_context *)c, x->angle) : NULL;
        if (x->solved || (x->unknown && (x->near || x->has_root)) || (number != NULL && !x->unknown) ||
            (number != NULL && !number->unknown && !number->value.rational))
            return 0;
    }
    return 1;
}

static int is_false(const struct box *b, const cagd_relation_sides *s, cagd_enclosed_example *out)
{
    int below = sign_in(b, s->m), above;
    if (below != 1 && below != -1)
        return 0;
    for (int i = 0; i < s->divisors; i++) {
        int sign = sign_in(b, s->divisor[i]);
        if (sign != 1 && sign != -1)
            return 0;
    }
    above = sign_in(b, s->n);
    out->order = below * above;
    return above != NOT_KNOWN && region_faults == 0 && !cagd_relation_holds(out->order, s->relation);
}

/* About the value of a side. */
static double value_near(const struct box *b, const cagd_tree *side)
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL)
        return 0;
    *c = *b->c;
    cagd_value v = cagd_evaluate(c, side);
    num_f f = cagd_in_field(v);
    num_q q = from_int_q(0);
    for (int m = 0; m < b->c->count && region_faults == 0; m++)
        if (b->c->binding[m].unknown)
            f = substitute_f(f, b->c->binding[m].value.f, from_rational_f(b->of[m].low));
    return region_faults == 0 && is_constant_f(f, &q) ? to_double_q(q) : 0;
}

int cagd_find_enclosed_example(const cagd_context *c, const cagd_tree *t, int k, cagd_enclosed_example *out)
{
    cagd_relation_sides *s = region_bytes(sizeof *s);
    struct box *b = region_bytes(sizeof *b);
    if (s == NULL || b == NULL || k < 0 || !c->mixes_angles || region_faults != 0 || !can_choose(c) ||
        !cagd_find_sides(c, t, k, s)) {
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
        return 0;
    }
    b->c = c;
    double now = cagd_seconds(), until = c->until > now ? now + (c->until - now) / 4 : now + 1;
    for (int round = 0; round < ROUNDS && cagd_seconds() < until; round++)
        for (int bits = COARSE; bits <= FINE; bits *= 4) {
            region_mark mark = region_open();
            int found = choose(b, round, bits, out) && is_false(b, s, out) && is_supposed(b);
            region_faults &= FAULT_MEMORY | FAULT_CROWDED;
            if (found) {
                out->left = value_near(b, t->at[k]), out->right = value_near(b, t->at[k + 1]);
                return region_faults == 0;
            }
            region_drop(mark);
        }
    return 0;
}
