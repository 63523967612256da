/* evaluate_number.c -- powers, factorials, binomial coefficients, q-numbers, roots. */
#include "exact/expression/evaluator.h"
#include "exact/expression/tie.h"
#include "exact/words.h"

#include <stdio.h>

enum { MOST_FACTORIAL = 1000, MOST_Q = 100 };

/* ---- powers and the like ------------------------------------------------------------------------------- */

/* Whether a letter that is usual for whole numbers stands in it and was not said to be one. */
static int has_real_index(const cagd_context *c, const cagd_tree *t)
{
    if (t->kind == CAGD_NAME && t->count == 0 && cagd_is_usual_index(t->head)) {
        const cagd_variable *v = cagd_declared(c->scope, t->head);
        return v != NULL && !v->whole;
    }
    for (int k = 0; k < t->count; k++)
        if (has_real_index(c, t->at[k]))
            return 1;
    return 0;
}

cagd_value cagd_power_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    long e;
    cagd_value exponent = cagd_evaluate_in(c, t->at[1], f), r = cagd_value_int(1), base;
    if (t->at[0]->kind == CAGD_NORM && cagd_value_is_whole(exponent, &e) && e % 2 == 0) { /* no root is needed */
        base = cagd_dot_value(c, t->at[0]->at[0], t->at[0]->at[0], f);
        exponent = cagd_value_int(e / 2);
    } else {
        base = cagd_evaluate_in(c, t->at[0], f);
    }
    if (region_faults != 0)
        return r;
    if (!cagd_value_is_whole(exponent, &e) || e > CAGD_MOST_POWER || e < -CAGD_MOST_POWER)
        return cagd_fail(c, t->at[1], FAULT_UNABLE,
                         has_real_index(c, t->at[1])
                             ? "an exponent is a whole number, and this one may be any: a range as in ':for: n = 0, 1, "
                               "\\dots' makes it one"
                             : "an exponent is a whole number, at most 1000");
    if (e < 0 && cagd_is_zero_at_roots(c, base))
        return cagd_divides_by_0(c, t);
    if (e < 0 && !cagd_note_divisor(c, base))
        return cagd_fail(c, t, FAULT_UNABLE, "too many divisors");
    for (long m = e < 0 ? -e : e; m > 0; m /= 2) {
        if (m % 2 == 1)
            r = cagd_value_mul(r, base);
        if (m > 1)
            base = cagd_value_mul(base, base);
    }
    return e < 0 ? cagd_value_div(cagd_value_int(1), r) : r;
}

cagd_value cagd_factorial_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    long m;
    cagd_value a = cagd_evaluate_in(c, t->at[0], f), r = cagd_value_int(1);
    if (region_faults != 0)
        return r;
    if (!cagd_value_is_whole(a, &m) || m > MOST_FACTORIAL)
        return cagd_fail(c, t, FAULT_UNABLE, "a factorial is of a whole number, at most 1000");
    if (m < 0)
        return cagd_fail(c, t, FAULT_UNDEFINED, "the factorial of a negative number");
    for (long k = 2; k <= m; k++)
        r = cagd_value_mul(r, cagd_value_int(k));
    return r;
}

cagd_value cagd_binomial_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    long b;
    cagd_value a = cagd_evaluate_in(c, t->at[0], f), below = cagd_evaluate_in(c, t->at[1], f), r = cagd_value_int(1);
    if (region_faults != 0)
        return r;
    if (!cagd_value_is_whole(below, &b) || b > MOST_FACTORIAL)
        return cagd_fail(c, t, FAULT_UNABLE, "below in a binomial coefficient stands a whole number, at most 1000");
    if (b < 0)
        return cagd_value_int(0);
    for (long k = 0; k < b && !cagd_value_is_zero(r); k++)
        r = cagd_value_div(cagd_value_mul(r, cagd_value_sub(a, cagd_value_int(k))), cagd_value_int(k + 1));
    return r;
}

/* ---- q-numbers ----------------------------------------------------------------------------------------- */

/* The whole number that child k of t is, from 0 to MOST_Q; -1 where it is none. */
static long count_of(cagd_context *c, const cagd_tree *t, int k, const cagd_frame *f)
{
    long n = -1;
    cagd_value v = cagd_evaluate_in(c, t->at[k], f);
    if (region_faults == 0 && (!cagd_value_is_whole(v, &n) || n > MOST_Q || n < -MOST_Q))
        cagd_fail(c, t->at[k], FAULT_UNABLE, "q-numbers are of whole numbers, at most 100");
    return n;
}

/* 1 + q + ... + q^(n-1). */
static cagd_value q_number(long n, cagd_value q)
{
    cagd_value sum = cagd_value_int(0);
    for (long k = 0; k < n; k++)
        sum = cagd_value_add(cagd_value_mul(sum, q), cagd_value_int(1));
    return sum;
}

/* The q-number of n, or the q-factorial: polynomials in q, so q = 1 is no exception. */
cagd_value cagd_q_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    long n = count_of(c, t, 0, f);
    cagd_value q = cagd_evaluate_in(c, t->at[1], f), product = cagd_value_int(1);
    if (region_faults != 0)
        return q;
    if (n < 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a q-number of a negative number");
    if (t->kind == CAGD_Q_NUMBER)
        return q_number(n, q);
    for (long k = 2; k <= n; k++)
        product = cagd_value_mul(product, q_number(k, q));
    return product;
}

/* By the rule [n, k] = [n-1, k-1] + q^k [n-1, k]; 0 for k < 0 and k > n. */
cagd_value cagd_q_binomial_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    long n = count_of(c, t, 0, f), k = count_of(c, t, 1, f);
    cagd_value q = cagd_evaluate_in(c, t->at[2], f), row[MOST_Q + 1];
    if (region_faults != 0)
        return q;
    if (n < 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a q-binomial coefficient of a negative number");
    if (k < 0 || k > n)
        return cagd_value_int(0);
    for (long j = 0; j <= k; j++)
        row[j] = cagd_value_int(j == 0);
    for (long m = 1; m <= n && region_faults == 0; m++) {
        cagd_value before = row[0], power = cagd_value_int(1);
        for (long j = 1; j <= k && j <= m; j++) {
            cagd_value above = row[j];
            power = cagd_value_mul(power, q);
            row[j] = cagd_value_add(before, cagd_value_mul(power, above));
            before = above;
        }
    }
    return row[k];
}

/* ---- roots --------------------------------------------------------------------------------------------- */

/* a = s^2 m with a whole m in which no square of a number up to 1000 is left. */
static num_q without_squares(num_q a, num_q *s)
{
    enum { LARGEST_SQUARE = 1000 };
    mpz_t m;
    mpq_t r;
    mpz_init(m), mpq_init(r);
    mpz_mul(m, mpq_numref(a.at), mpq_denref(a.at)); /* p/q = pq/q^2 */
    mpz_set_ui(mpq_numref(r), 1), mpz_set(mpq_denref(r), mpq_denref(a.at));
    for (unsigned long d = 2; d <= LARGEST_SQUARE; d++)
        while (mpz_divisible_ui_p(m, d * d)) {
            mpz_divexact_ui(m, m, d * d);
            mpz_mul_ui(mpq_numref(r), mpq_numref(r), d);
        }
    mpq_canonicalize(r);
    *s = cagd_from_mpq_q(r);
    mpq_set_z(r, m);
    num_q rest = cagd_from_mpq_q(r);
    mpz_clear(m), mpq_clear(r);
    return rest;
}

/* sqrt(a) for a number a > 0 that is no square: a variable near the root of x^2 - m, times a number (tie.h). */
static cagd_value root_of_number(cagd_context *c, const cagd_tree *t, num_q a)
{
    num_q times, m = without_squares(a, &times), c0[3] = {neg_q(m), cagd_from_int_q(0), cagd_from_int_q(1)};
    char key[120];
    if (snprintf(key, sizeof key, "\\sqrt{%s}", to_string_q(m)) >= (int)sizeof key)
        return cagd_fail(c, t, FAULT_UNABLE, "a root of a number that is too long");
    cagd_value x = cagd_value_of_key(c, key, NULL);
    cagd_binding *b = region_faults == 0 ? cagd_binding_of(c, key) : NULL;
    if (b == NULL)
        return x;
    if (!b->has_root)
        cagd_make_root(b, cagd_poly_from_q(3, c0));
    return cagd_value_mul(cagd_value_q(times), x);
}

/* The root that is not negative, if n is even: of a square of a function it is the function or its negative, by its sign. */
cagd_value cagd_root_of_value(cagd_context *c, const cagd_tree *t, cagd_value a, long n)
{
    if (region_faults != 0)
        return a;
    cagd_value r = a.rational ? cagd_value_q(root_q((int)n, a.q)) : cagd_value_f(cagd_root_f((int)n, a.f));
    if (region_faults != 0) {
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
        if (region_faults == 0 && n == 2 && a.rational && cagd_sign_q(a.q) > 0 && c->has_roots)
            return root_of_number(c, t, a.q);
        c->met_root = 1;
        return cagd_fail(c, t, FAULT_UNABLE,
                         n % 2 == 0 && a.rational && cagd_sign_q(a.q) < 0
                             ? "the root of a negative number"
                             : "a root that is no rational function: write a name, r^2 = ..., r \\ge 0 in :for:");
    }
    int positive = a.rational || n % 2 == 1 ? 1 : cagd_compare_values(c, r, CAGD_GREATER_OR_EQUAL, cagd_value_int(0));
    if (positive < 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a root whose sign depends on variables");
    return positive ? r : cagd_value_sub(cagd_value_int(0), r);
}

cagd_value cagd_root_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    long n;
    cagd_value a = cagd_evaluate_in(c, t->at[0], f), index = cagd_evaluate_in(c, t->at[1], f);
    if (region_faults != 0)
        return a;
    if (!cagd_value_is_whole(index, &n) || n < 1 || n > CAGD_MOST_POWER)
        return cagd_fail(c, t, FAULT_UNABLE, "a root is the n-th for a whole number n");
    return cagd_root_of_value(c, t, a, n);
}
