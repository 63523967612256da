/* signs.c -- what the conditions of the way that a run takes say about the signs of functions; see value.h. */
#include "exact/code/value.h"

enum { SAME = 1, GREATER = 2, LESS = 4, ANY = 7 };

/* The functions that conditions compare with 0, and what is known of their signs: those that are 0 hold for the whole path. */
enum { MOST_SIGNS = 4096 };
static struct {
    cagd_num_f function;
    int sign;
} signs_known[MOST_SIGNS];
static int sign_count;

/* f, or where it is linear a positive multiple of it, the same one for all of them. */
static cagd_num_f scaled(cagd_num_f f)
{
    struct cagd_linear at;
    if (!cagd_linear_f(f, &at) || at.count == 0)
        return f;
    cagd_num_q first = at.coefficient[0];
    return cagd_div_f(f, cagd_from_rational_f(cagd_sign_q(first) < 0 ? cagd_neg_q(first) : first));
}

void cagd_code_know_sign(cagd_num_f f, int holding)
{
    f = scaled(f);
    int opposite = (holding & SAME) | (holding & LESS ? GREATER : 0) | (holding & GREATER ? LESS : 0);
    cagd_num_f minus = cagd_neg_f(f);
    for (int k = 0; k < sign_count; k++)
        if (cagd_equal_f(signs_known[k].function, f) || cagd_equal_f(signs_known[k].function, minus)) {
            signs_known[k].sign &= cagd_equal_f(signs_known[k].function, f) ? holding : opposite;
            return;
        }
    if (sign_count < MOST_SIGNS) {
        signs_known[sign_count].function = f;
        signs_known[sign_count++].sign = holding;
    }
}

/* f wherever the conditions hold: those that say that a function is 0, linear in a variable, are solved for it.  0 at a pole, where nothing
 * is known. */
static int settle(cagd_num_f *f)
{
    for (int k = 0; k < sign_count; k++) {
        cagd_num_f zero = cagd_numerator_f(signs_known[k].function), variable, value;
        if (signs_known[k].sign != SAME || !cagd_code_solve(zero, &variable, &value))
            continue;
        *f = cagd_substitute_f(*f, variable, value);
        if (cagd_region_faults & CAGD_FAULT_UNDEFINED) {
            cagd_region_faults &= ~(unsigned)CAGD_FAULT_UNDEFINED;
            return 0;
        }
        for (int j = k + 1; j < sign_count; j++) {
            cagd_num_f g = cagd_substitute_f(signs_known[j].function, variable, value);
            if ((cagd_region_faults & CAGD_FAULT_UNDEFINED) == 0)
                signs_known[j].function = g;
            cagd_region_faults &= ~(unsigned)CAGD_FAULT_UNDEFINED;
        }
    }
    return 1;
}

int cagd_code_vanishes_here(cagd_num_f f) { return cagd_code_vanishes(f) || (settle(&f) && cagd_code_vanishes(f)); }

/* Both sides first: their difference may be large where each of them is small. */
int cagd_code_equal_here(cagd_num_f a, cagd_num_f b)
{
    return cagd_equal_f(a, b) ||
           (settle(&a) && settle(&b) && (cagd_equal_f(a, b) || cagd_code_vanishes(cagd_sub_f(a, b))));
}

/* ---- signs of functions of higher degree ----------------------------------------------------------------------- */

/* What is known of f itself: a sum of SAME, GREATER, LESS. */
static int known_of(cagd_num_f f)
{
    f = scaled(f);
    cagd_num_f minus = cagd_neg_f(f);
    for (int k = 0; k < sign_count; k++) {
        int sign = signs_known[k].sign;
        if (cagd_equal_f(signs_known[k].function, f))
            return sign;
        if (cagd_equal_f(signs_known[k].function, minus))
            return (sign & SAME) | (sign & LESS ? GREATER : 0) | (sign & GREATER ? LESS : 0);
    }
    return ANY;
}

static int is_affine(cagd_num_f f, int count, const cagd_num_f x[])
{
    if (!cagd_is_constant_f(cagd_denominator_f(f), NULL))
        return 0;
    for (int k = 0; k < count; k++) {
        int degree = cagd_degree_f(f, x[k]);
        if (degree > 1 || (degree == 1 && !cagd_is_constant_f(cagd_coefficient_f(f, x[k], 1), NULL)))
            return 0;
    }
    return 1;
}

/* The variables of f, in the order of their values at the point. */
static int sorted_variables(cagd_num_f f, cagd_num_f x[], cagd_num_q value[])
{
    int count = 0;
    for (int k = 0; k < cagd_code_variable_count(); k++) {
        cagd_num_q at;
        cagd_num_f v = cagd_code_variable_at(k, &at);
        if (cagd_degree_f(f, v) < 1 && cagd_denominator_degree_f(f, v) < 1)
            continue;
        int j = count++;
        for (; j > 0 && cagd_compare_q(value[j - 1], at) > 0; j--)
            x[j] = x[j - 1], value[j] = value[j - 1];
        x[j] = v, value[j] = at;
    }
    return count;
}

/* The largest number of which the conditions say that x > it (GREATER) or x >= it; ANY where there is none. */
static int least_of(cagd_num_f x, cagd_num_f *least)
{
    int known = ANY;
    cagd_num_q best = {NULL}, root, slope;
    for (int k = 0; k < sign_count; k++) {
        cagd_num_f f = signs_known[k].function;
        if (!cagd_has_degrees_f(f, x, 1, 0) || !cagd_is_constant_f(cagd_coefficient_f(f, x, 1), &slope) ||
            !cagd_is_constant_f(cagd_neg_f(cagd_div_f(cagd_coefficient_f(f, x, 0), cagd_coefficient_f(f, x, 1))),
                                &root))
            continue;
        int sign = signs_known[k].sign, wrong = cagd_sign_q(slope) > 0 ? LESS : GREATER;
        int order = best.at != NULL ? cagd_compare_q(root, best) : 1;
        if ((sign & wrong) != 0 || sign == SAME || order < 0 || (order == 0 && known == GREATER))
            continue;
        best = root;
        known = (sign & SAME) != 0 ? GREATER | SAME : GREATER;
    }
    if (known != ANY)
        *least = cagd_from_rational_f(best);
    return known;
}

/* Where the conditions say that x_j <= x_k, x_k is x_j + d, with the next smaller x_j; or c + d, where they say that c <= x_k for a
 * number c; d takes the place of x_k.  A function whose coefficients are then of one sign is not of the other one wherever all d >= 0;
 * and it is not 0, if it stays another function than 0 where those d are 0 of which nobody says d > 0.  Of what stands for roots and
 * angles no sign is known. */
int cagd_code_signs_here(cagd_num_f f)
{
    enum { MOST_WORDS = 20000 };
    cagd_num_f x[CAGD_FIELD_MAX_VARIABLES], zero = cagd_from_int_f(0);
    cagd_num_q value[CAGD_FIELD_MAX_VARIABLES];
    int known = known_of(f), strict[CAGD_FIELD_MAX_VARIABLES];
    if (known != ANY || cagd_words_f(f) > MOST_WORDS || cagd_code_has_others(f))
        return known;
    int count = sorted_variables(f, x, value);
    if (is_affine(f, count, x))
        return known; /* what is linear is left to the inequalities, which do more */
    for (int k = count - 1; k >= 0; k--) {
        int order = ANY, j = k - 1;
        cagd_num_f from;
        while (j >= 0 && ((order = known_of(cagd_sub_f(x[k], x[j]))) & LESS) != 0)
            j--;
        if (j >= 0)
            from = x[j];
        else
            order = least_of(x[k], &from);
        strict[k] = order == GREATER;
        if (order != ANY)
            f = cagd_substitute_f(f, x[k], cagd_add_f(x[k], from));
        else if (cagd_degree_f(f, x[k]) > 0 || cagd_denominator_degree_f(f, x[k]) > 0)
            return ANY;
    }
    cagd_code_check_faults();
    int sign = cagd_coefficients_sign_f(f);
    if (sign != 1 && sign != -1)
        return ANY;
    for (int k = 0; k < count; k++)
        if (!strict[k])
            f = cagd_substitute_f(f, x[k], zero);
    int vanishes = (cagd_region_faults & CAGD_FAULT_UNDEFINED) != 0 || cagd_is_zero_f(f);
    cagd_region_faults &= ~(unsigned)CAGD_FAULT_UNDEFINED;
    cagd_code_check_faults();
    return (sign > 0 ? GREATER : LESS) | (vanishes ? SAME : 0);
}
