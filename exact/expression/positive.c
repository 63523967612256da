#include "exact/expression/positive.h"

#include "exact/record/trace.h"
#include "exact/words.h"

enum { MOST_SIDES = 12, MOST_FACTORS = 64, MOST_CUTS = 3000, MOST_DEPTH = 16 };

/* The function in factors, and the trees of their parts. */
struct proof {
    int count;
    num_f factor[MOST_FACTORS];
    int power[MOST_FACTORS], sign[MOST_FACTORS];
    num_q constant;
    int cuts, cut[MOST_CUTS]; /* a number that cuts stands in `cut` by its place in `at`, as -2 - place */
    int numbers;
    num_q at[MOST_CUTS];
};

/* p = (what is left) times the factors, to their powers times e; 0 where there are too many, or not all is in the variables of the box. */
static int take_factors(struct proof *f, num_f p, int e, int count, const cagd_side_of_box side[])
{
    num_q rest;
    for (int k = 0; k < count; k++) {
        if (degree_f(p, side[k].variable) < 1)
            continue;
        int found =
            cagd_factors_f(p, side[k].variable, MOST_FACTORS - f->count, f->factor + f->count, f->power + f->count);
        if (found < 0)
            return 0;
        for (int i = 0; i < found; i++, f->count++) {
            for (int m = 0; m < f->power[f->count]; m++)
                p = div_f(p, f->factor[f->count]);
            f->power[f->count] *= e;
        }
    }
    if (!is_constant_f(p, &rest) || cagd_is_zero_q(rest))
        return 0;
    f->constant = e > 0 ? mul_q(f->constant, rest) : div_q(f->constant, rest);
    return region_faults == 0;
}

/* The side that is cut: the longest on which p depends, in halves; one without an end at 0, or farther out with every cut. */
static int where_to_cut(num_f p, int count, const cagd_side_of_box side[], int depth, num_q *at)
{
    int longest = -1;
    num_q length = from_int_q(0), far = from_int_q(1L << depth);
    for (int k = 0; k < count; k++) {
        const cagd_side_of_box *s = &side[k];
        if (degree_f(p, s->variable) < 1)
            continue;
        num_q l = s->has_low && s->has_high ? sub_q(s->high, s->low) : far;
        if (longest >= 0 && cagd_compare_q(l, length) <= 0)
            continue;
        longest = k, length = l;
        *at = s->has_low && s->has_high ? div_q(add_q(s->low, s->high), from_int_q(2))
              : s->has_low              ? add_q(s->low, far)
              : s->has_high             ? sub_q(s->high, far)
                                        : from_int_q(0);
    }
    return longest;
}

static int prove(struct proof *f, num_f p, int strict, int count, const cagd_side_of_box side[], int depth)
{
    num_q at;
    if (f->cuts + 3 > MOST_CUTS || depth > MOST_DEPTH || region_faults != 0)
        return 0;
    if (cagd_is_positive_by_coefficients(p, strict, count, side)) {
        f->cut[f->cuts++] = -1;
        return 1;
    }
    num_f middle = p;
    for (int k = 0; k < count; k++) /* one value of the other sign, and it is in vain */
        middle = substitute_f(middle, side[k].variable, from_rational_f(cagd_inside(&side[k])));
    if (is_constant_f(middle, &at) && cagd_sign_q(at) < 0)
        return 0;
    int which = where_to_cut(p, count, side, depth, &at);
    if (which < 0)
        return 0;
    f->cut[f->cuts++] = which;
    f->cut[f->cuts++] = -2 - f->numbers;
    f->at[f->numbers++] = at;
    for (int above = 0; above < 2; above++) {
        cagd_side_of_box part[MOST_SIDES];
        for (int k = 0; k < count; k++)
            part[k] = side[k];
        if (above)
            part[which].has_low = 1, part[which].low = at, part[which].low_open = 0;
        else
            part[which].has_high = 1, part[which].high = at, part[which].high_open = 0;
        if (!prove(f, p, strict, count, part, depth + 1))
            return 0;
    }
    return 1;
}

/* The sign of factor i, if one is needed, with its tree. */
static int sign_of_factor(struct proof *f, int i, int strict, int count, const cagd_side_of_box side[])
{
    int odd = f->power[i] % 2 != 0, cuts = f->cuts, numbers = f->numbers;
    f->sign[i] = 0;
    if (!odd && (!strict || f->power[i] < 0))
        return 1;
    for (int sign = 1; sign >= -1; sign -= 2) {
        f->sign[i] = sign, f->cuts = cuts, f->numbers = numbers;
        if (prove(f, sign > 0 ? f->factor[i] : neg_f(f->factor[i]), strict && f->power[i] > 0, count, side, 0))
            return 1;
        if (region_faults != 0)
            return 0;
    }
    return 0;
}

static int find_proof(struct proof *f, cagd_value d, int strict, int count, const cagd_side_of_box side[])
{
    num_f value = cagd_in_field(d);
    *f = (struct proof){.constant = from_int_q(1)};
    if (count > MOST_SIDES)
        return 0;
    if (cagd_is_zero_f(value)) {
        f->constant = from_int_q(0);
        return !strict;
    }
    if (!take_factors(f, cagd_numerator_f(value), 1, count, side) ||
        !take_factors(f, cagd_denominator_f(value), -1, count, side))
        return 0;
    int sign = cagd_sign_q(f->constant);
    for (int i = 0; i < f->count; i++) {
        if (!sign_of_factor(f, i, strict, count, side))
            return 0;
        sign *= f->power[i] % 2 != 0 ? f->sign[i] : 1;
    }
    return sign > 0;
}

static int constant_node(num_q q) { return cagd_node_of_q(cagd_value_constant(q).q); }

int cagd_note_sign_in_box(cagd_value d, int strict, int count, const cagd_side_of_box side[])
{
    struct proof *f = region_bytes(sizeof *f);
    int node[MOST_FACTORS], variable[MOST_SIDES], low[MOST_SIDES], high[MOST_SIDES], open[2 * MOST_SIDES];
    if (f == NULL || !cagd_trace_noting())
        return 0;
    cagd_trace_pause();
    int found = find_proof(f, d, strict, count, side);
    cagd_trace_resume();
    if (!found || region_faults != 0)
        return 0;
    int of = d.rational ? cagd_node_of_q(d.q) : cagd_node_of_f(d.f), constant = constant_node(f->constant);
    for (int i = 0; i < f->count; i++)
        node[i] = cagd_node_of_f(f->factor[i]);
    for (int k = 0; k < count; k++) {
        variable[k] = cagd_node_of_f(side[k].variable);
        low[k] = side[k].has_low ? constant_node(side[k].low) : -1;
        high[k] = side[k].has_high ? constant_node(side[k].high) : -1;
        open[2 * k] = side[k].low_open, open[2 * k + 1] = side[k].high_open;
    }
    for (int i = 0; i < f->cuts; i++)
        if (f->cut[i] < -1)
            f->cut[i] = constant_node(f->at[-2 - f->cut[i]]);
    if (!cagd_trace_fact("sign_in_box"))
        return 0;
    cagd_trace_put_list("of", 1, &of);
    cagd_trace_put_list("constant", 1, &constant);
    cagd_trace_put_list("factors", f->count, node);
    cagd_trace_put_list("variables", count, variable);
    cagd_trace_put_list("low", count, low);
    cagd_trace_put_list("high", count, high);
    cagd_trace_put_list("open", 2 * count, open);
    cagd_trace_put_list("powers", f->count, f->power);
    cagd_trace_put_list("signs", f->count, f->sign);
    cagd_trace_put_list("cuts", f->cuts, f->cut);
    cagd_trace_put("strict", strict);
    cagd_trace_put("is", 1);
    cagd_trace_fact_end();
    return 1;
}
