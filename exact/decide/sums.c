#include "exact/decide/sums.h"

#include "exact/words.h"

#include <stdio.h>
#include <string.h>

/* ---- terms ----------------------------------------------------------------------------------------- */

static num_f whole(long m) { return from_int_f(m); }
static num_f plus(num_f a, long m) { return m == 0 ? a : add_f(a, whole(m)); }
static num_f shifted(num_f a, num_f variable, long m)
{
    return m == 0 ? a : substitute_f(a, variable, plus(variable, m));
}

static num_f power_of(num_f base, int e)
{
    num_f r = whole(1);
    for (int i = 0; i < (e < 0 ? -e : e); i++)
        r = mul_f(r, base);
    return e < 0 ? div_f(whole(1), r) : r;
}

cagd_term cagd_term_one(void) { return (cagd_term){whole(1), whole(1)}; }

/* (e + step)!/e! = (e+1) ... (e+step), and for step < 0 its inverse 1/(e (e-1) ... (e+step+1)). */
static num_f factorial_ratio(num_f e, int step)
{
    num_f r = whole(1);
    for (int i = 1; i <= step; i++)
        r = mul_f(r, plus(e, i));
    for (int i = 0; i < -step; i++)
        r = div_f(r, plus(e, -i));
    return r;
}

cagd_term cagd_term_times_factorial(cagd_term F, num_f n, num_f k, int p, int q, num_f c, int power)
{
    num_f e = add_f(add_f(mul_f(whole(p), n), mul_f(whole(q), k)), c);
    return (cagd_term){mul_f(F.by_n, power_of(factorial_ratio(e, p), power)),
                       mul_f(F.by_k, power_of(factorial_ratio(e, q), power))};
}

cagd_term cagd_term_times_binomial(cagd_term F, num_f n, num_f k, int p, int q, num_f c, int r, int s, num_f d)
{
    F = cagd_term_times_factorial(F, n, k, p, q, c, 1);
    F = cagd_term_times_factorial(F, n, k, r, s, d, -1);
    return cagd_term_times_factorial(F, n, k, p - r, q - s, sub_f(c, d), -1);
}

cagd_term cagd_term_times_power(cagd_term F, num_f base, int p, int q)
{
    return (cagd_term){mul_f(F.by_n, power_of(base, p)), mul_f(F.by_k, power_of(base, q))};
}

cagd_term cagd_term_times_rational(cagd_term F, num_f n, num_f k, num_f r)
{
    return (cagd_term){mul_f(F.by_n, div_f(shifted(r, n, 1), r)), mul_f(F.by_k, div_f(shifted(r, k, 1), r))};
}

/* ---- polynomials in k ------------------------------------------------------------------------------- */

enum { MOST_FACTORS = 64, MOST_COLUMNS = 64 };

/* The h >= 0 with f(k) = c g(k+h) for irreducible f and g; -1 where there is none. */
static int shift_between(num_f f, num_f g, num_f k)
{
    int d = cagd_degree_f(f, k);
    if (d < 1 || cagd_degree_f(g, k) != d)
        return -1;
    num_f lead_f = cagd_coefficient_f(f, k, d), lead_g = cagd_coefficient_f(g, k, d);
    num_f h =
        div_f(sub_f(div_f(cagd_coefficient_f(f, k, d - 1), lead_f), div_f(cagd_coefficient_f(g, k, d - 1), lead_g)),
              whole(d));
    num_q value;
    if (!cagd_is_constant_f(h, &value) || mpz_cmp_ui(mpq_denref(value.at), 1) != 0 || mpq_sgn(value.at) < 0 ||
        !mpz_fits_sint_p(mpq_numref(value.at)))
        return -1;
    int m = (int)mpz_get_si(mpq_numref(value.at));
    return cagd_equal_f(mul_f(f, lead_g), mul_f(shifted(g, k, m), lead_f)) ? m : -1;
}

/* a/b = (a'/b') c(k+1)/c(k) with gcd(a'(k), b'(k+h)) = 1 for every h >= 0 (Gosper and Petkovšek).  0 when there are too many
 * factors. */
static int normal_form(num_f k, num_f *a, num_f *b, num_f *c)
{
    num_f of_a[MOST_FACTORS], of_b[MOST_FACTORS];
    int power_a[MOST_FACTORS], power_b[MOST_FACTORS];
    int in_a = cagd_factors_f(*a, k, MOST_FACTORS, of_a, power_a),
        in_b = cagd_factors_f(*b, k, MOST_FACTORS, of_b, power_b);
    *c = whole(1);
    if (in_a < 0 || in_b < 0)
        return 0;
    for (int i = 0; i < in_a; i++)
        for (int j = 0; j < in_b; j++) {
            int h = shift_between(of_a[i], of_b[j], k);
            for (; h >= 0 && power_a[i] > 0 && power_b[j] > 0; power_a[i]--, power_b[j]--) {
                num_f g = of_a[i], back = shifted(g, k, -h); /* of b, but for a factor without k */
                *a = div_f(*a, g);
                *b = div_f(*b, back);
                for (int m = 1; m <= h; m++)
                    *c = mul_f(*c, shifted(g, k, -m));
            }
        }
    return 1;
}

/* The largest degree that a solution x of a(k) x(k+1) - b(k-1) x(k) = (degree `right`) can have; before is b(k-1). */
static int degree_of_solution(num_f k, num_f a, num_f before, int right)
{
    int da = cagd_degree_f(a, k), db = cagd_degree_f(before, k), d = da > db ? da : db;
    num_f lead_a = cagd_coefficient_f(a, k, d), lead_b = cagd_coefficient_f(before, k, d);
    if (!cagd_equal_f(lead_a, lead_b))
        return right - d;
    int most = right - d + 1;
    /* The next coefficient of the left side is lead (e + A/lead - B/lead) for degree e. */
    num_f e =
        d > 0 ? div_f(sub_f(cagd_coefficient_f(before, k, d - 1), cagd_coefficient_f(a, k, d - 1)), lead_a) : whole(0);
    num_q value;
    if (cagd_is_constant_f(e, &value) && mpz_cmp_ui(mpq_denref(value.at), 1) == 0 &&
        mpz_fits_sint_p(mpq_numref(value.at))) {
        long m = mpz_get_si(mpq_numref(value.at));
        most = m > most && m < MOST_COLUMNS ? (int)m : most;
    }
    return most;
}

/* ---- linear equations -------------------------------------------------------------------------------- */

/* A solution y != 0 of M y = 0 in which one of the last `last` unknowns is not 0, rows x columns; 0 where there is none.
 * Gauss and Jordan; M is changed. */
static int null_vector(int rows, int columns, int last, num_f M[], num_f y[])
{
    int pivot_of[MOST_COLUMNS], row = 0;
    for (int j = 0; j < columns; j++) {
        int p = row;
        while (p < rows && cagd_is_zero_f(M[p * columns + j]))
            p++;
        pivot_of[j] = p < rows ? row : -1;
        if (p == rows) {
            if (j < columns - last)
                continue;
            /* Column j is free: y_j = 1, the pivots follow, the rest is 0. */
            for (int i = 0; i < columns; i++)
                y[i] = whole(i == j);
            for (int i = 0; i < j; i++)
                if (pivot_of[i] >= 0)
                    y[i] = neg_f(M[pivot_of[i] * columns + j]);
            return 1;
        }
        for (int i = 0; i < columns && p != row; i++) {
            num_f kept = M[row * columns + i];
            M[row * columns + i] = M[p * columns + i];
            M[p * columns + i] = kept;
        }
        num_f inverse = div_f(whole(1), M[row * columns + j]);
        for (int i = j; i < columns; i++)
            M[row * columns + i] = mul_f(M[row * columns + i], inverse);
        for (int r = 0; r < rows; r++) {
            num_f factor = M[r * columns + j];
            if (r == row || cagd_is_zero_f(factor))
                continue;
            for (int i = j; i < columns; i++)
                M[r * columns + i] = sub_f(M[r * columns + i], mul_f(factor, M[row * columns + i]));
        }
        row++;
    }
    return 0;
}

/* ---- creative telescoping ----------------------------------------------------------------------------- */

/* F(n+j,k)/F(n,k). */
static num_f step_in_n(cagd_term F, num_f n, int j)
{
    num_f r = whole(1);
    for (int i = 0; i < j; i++)
        r = mul_f(r, shifted(F.by_n, n, i));
    return r;
}

/* The a_j as polynomials without a common denominator; R accordingly. */
static void clear_denominators(cagd_telescoper *T)
{
    num_f common = whole(1);
    for (int j = 0; j <= T->order; j++)
        common = mul_f(common, cagd_denominator_f(mul_f(common, T->a[j])));
    for (int j = 0; j <= T->order; j++)
        T->a[j] = mul_f(common, T->a[j]);
    T->R = mul_f(common, T->R);
}

/* With the telescoper of order J: sum_j a_j F(n+j,k)/F(n,k) = sum_j a_j u_j / v, so that the sum has the ratio of neighbours
 * (F/v)(k+1)/(F/v)(k) but for the polynomial sum_j a_j u_j.  In normal form that ratio is a/b c(k+1)/c(k), and G exists when
 *     a(k) x(k+1) - b(k-1) x(k) = c(k) sum_j a_j u_j(k)
 * has a polynomial solution x; then G = b(k-1) x(k)/c(k) F/v. */
static int telescope_of_order(cagd_term F, num_f n, num_f k, int order, cagd_telescoper *T)
{
    num_f s[CAGD_TELESCOPER_ORDER + 1], v = whole(1), c;
    for (int j = 0; j <= order; j++) {
        s[j] = step_in_n(F, n, j);
        v = mul_f(v, cagd_denominator_f(mul_f(v, s[j])));
    }
    num_f ratio = div_f(mul_f(F.by_k, v), shifted(v, k, 1)), a = cagd_numerator_f(ratio), b = cagd_denominator_f(ratio);
    if (!normal_form(k, &a, &b, &c))
        return 0;
    int right = 0;
    for (int j = 0; j <= order; j++) {
        s[j] = mul_f(c, mul_f(s[j], v));
        int d = cagd_degree_f(s[j], k);
        right = d > right ? d : right;
    }
    num_f before = shifted(b, k, -1);
    int degree = degree_of_solution(k, a, before, right), columns = degree + 1 + order + 1;
    if (degree < 0) /* x = 0: the sum of the a_j u_j would have to vanish */
        degree = -1, columns = order + 1;
    if (columns > MOST_COLUMNS)
        return 0;
    /* One column for each power of k in x, one for each a_j. */
    num_f column[MOST_COLUMNS], M[MOST_COLUMNS * 2 * MOST_COLUMNS], y[MOST_COLUMNS];
    int rows = right + 1;
    num_f power = whole(1);
    for (int i = 0; i <= degree; i++) {
        column[i] = sub_f(mul_f(a, shifted(power, k, 1)), mul_f(before, power));
        int d = cagd_degree_f(column[i], k);
        rows = d + 1 > rows ? d + 1 : rows;
        power = mul_f(power, k);
    }
    if (rows > 2 * MOST_COLUMNS)
        return 0;
    for (int j = 0; j <= order; j++)
        column[degree + 1 + j] = neg_f(s[j]);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            M[i * columns + j] = cagd_coefficient_f(column[j], k, i);
    if (!null_vector(rows, columns, order + 1, M, y))
        return 0;
    num_f x = whole(0);
    for (int i = degree; i >= 0; i--)
        x = add_f(mul_f(x, k), y[i]);
    T->order = order;
    for (int j = 0; j <= order; j++)
        T->a[j] = y[degree + 1 + j];
    T->R = div_f(mul_f(before, x), mul_f(c, v));
    clear_denominators(T);
    while (T->order > 0 && cagd_is_zero_f(T->a[T->order]))
        T->order--;
    return 1;
}

int cagd_telescope(cagd_term F, num_f n, num_f k, int most, cagd_telescoper *T)
{
    for (int order = 0; order <= most && order <= CAGD_TELESCOPER_ORDER; order++)
        if (telescope_of_order(F, n, k, order, T))
            return 1;
    return 0;
}

int cagd_telescoper_holds(cagd_term F, num_f n, num_f k, const cagd_telescoper *T)
{
    num_f left = whole(0);
    int some = 0;
    for (int j = 0; j <= T->order; j++) {
        left = add_f(left, mul_f(T->a[j], step_in_n(F, n, j)));
        some |= !cagd_is_zero_f(T->a[j]);
    }
    num_f right = sub_f(mul_f(shifted(T->R, k, 1), F.by_k), T->R);
    return some && cagd_equal_f(left, right);
}

/* ---- sums ------------------------------------------------------------------------------------------- */

/* Whether all coefficients of p have one sign, and one is left when n and k are 0: then p has one sign for n, k >= 0 and positive
 * values of all other variables. */
static int has_sign_of_constant(num_f p, num_f n, num_f k)
{
    num_f constant = substitute_f(substitute_f(p, n, whole(0)), k, whole(0));
    int sign = cagd_coefficients_sign_f(p), at_zero = cagd_coefficients_sign_f(constant);
    return (sign == 1 || sign == -1) && at_zero == sign;
}

/* Whether the irreducible p is positive or negative for all whole n >= k >= 0, n >= from, and positive values of all other
 * variables: for each k < from, with n - from >= 0; and for the others in k - from and n - k. */
static int has_one_sign(num_f p, num_f n, num_f k, int from)
{
    for (int j = 0; j < from; j++)
        if (!has_sign_of_constant(substitute_f(shifted(p, n, from), k, whole(j)), n, k))
            return 0;
    return has_sign_of_constant(substitute_f(shifted(p, k, from), n, add_f(plus(n, from), k)), n, k);
}

/* The same, or p is a function of another variable of which some coefficient has one sign: then it is nowhere the function 0. */
static int is_never_the_zero_function(num_f p, num_f n, num_f k, int from)
{
    if (has_one_sign(p, n, k, from))
        return 1;
    const char *name = cagd_field_variables();
    for (size_t length; *name != '\0'; name += length + (name[length] == ' ')) {
        char one[CAGD_FIELD_MAX_NAME + 1];
        length = strcspn(name, " ");
        snprintf(one, sizeof one, "%.*s", (int)length, name);
        num_f x = cagd_variable_f(one);
        if (cagd_equal_f(x, n) || cagd_equal_f(x, k))
            continue;
        for (int j = cagd_degree_f(p, x); j >= 0 && cagd_degree_f(p, x) > 0; j--)
            if (has_one_sign(cagd_coefficient_f(p, x, j), n, k, from))
                return 1;
    }
    return 0;
}

/* Every factor that contains n or k has one sign, or is nowhere the zero function; one without them is a function that is not 0. */
static int no_factor_vanishes(num_f p, num_f n, num_f k, int from, int generic)
{
    num_f factor[MOST_FACTORS], variable[] = {n, k};
    int power[MOST_FACTORS];
    if (cagd_is_zero_f(p))
        return 0;
    for (int v = 0; v < 2; v++) {
        int count = cagd_factors_f(p, variable[v], MOST_FACTORS, factor, power);
        if (count < 0)
            return 0;
        for (int i = 0; i < count; i++)
            if (!(generic ? is_never_the_zero_function : has_one_sign)(factor[i], n, k, from))
                return 0;
    }
    return 1;
}

int cagd_is_never_zero(num_f p, num_f n, num_f k, int from) { return no_factor_vanishes(p, n, k, from, 1); }

/* The last k, N = p n + e. */
static int by_of(const cagd_sum *s) { return s->by > 0 ? s->by : 1; }
static num_f last_of(const cagd_sum *s, num_f n) { return plus(mul_f(whole(by_of(s)), n), s->beyond); }

/* Factors without k for n >= from; the others for 0 <= k <= N, n being (N - e)/p. */
static int never_zero(num_f p, num_f n, num_f k, const cagd_sum *s)
{
    num_f factor[MOST_FACTORS], with_k = whole(1);
    int power[MOST_FACTORS], count = cagd_is_zero_f(p) ? -1 : cagd_factors_f(p, k, MOST_FACTORS, factor, power);
    for (int i = 0; i < count; i++) {
        p = div_f(p, power_of(factor[i], power[i]));
        with_k = mul_f(with_k, factor[i]);
    }
    if (count < 0 || !no_factor_vanishes(p, n, k, s->from, s->generic))
        return 0;
    num_f by_last = substitute_f(with_k, n, div_f(plus(n, -s->beyond), whole(by_of(s))));
    return no_factor_vanishes(cagd_numerator_f(by_last), n, k, by_of(s) * s->from + s->beyond, s->generic);
}

/* F(n+j, N+i)/F(n,N) for i <= p j. */
static num_f near_the_end(cagd_term F, num_f n, num_f k, num_f last, int j, int i)
{
    num_f r = substitute_f(step_in_n(F, n, j), k, last);
    num_f by_k = shifted(F.by_k, n, j); /* F(n+j,k+1)/F(n+j,k) */
    for (int m = 0; m < i; m++)
        r = mul_f(r, substitute_f(by_k, k, plus(last, m)));
    return r;
}

/* The terms of sum_k sum_j a_j F(n+j,k) beyond k = N - 1, over F(n,N), and what telescoping leaves at k = N. */
static num_f rest_at_the_end(const cagd_sum *s, num_f n, num_f k, const cagd_telescoper *T)
{
    num_f last = last_of(s, n), rest = substitute_f(T->R, k, last);
    for (int j = 0; j <= T->order; j++)
        for (int i = 0; i <= by_of(s) * j; i++)
            rest = add_f(rest, mul_f(T->a[j], near_the_end(s->F, n, k, last, j, i)));
    return rest;
}

/* The sum of the F(m,k) for the number m >= from. */
static num_f sum_of_row(const cagd_sum *s, num_f n, num_f k, int m)
{
    num_f value = s->first, sum = whole(0);
    for (int i = s->from; i < m; i++)
        value = mul_f(value, substitute_f(substitute_f(s->F.by_n, k, whole(0)), n, whole(i)));
    num_f by_k = substitute_f(s->F.by_k, n, whole(m));
    for (int i = 0; i <= by_of(s) * m + s->beyond; i++) {
        sum = add_f(sum, value);
        value = mul_f(value, substitute_f(by_k, k, whole(i)));
    }
    return sum;
}

enum cagd_sum_answer cagd_sum_for_every_n(const cagd_sum *s, num_f n, num_f k, int most, cagd_telescoper *T)
{
    /* The first rows: a sum that is wrong is wrong early. */
    num_f S = s->start;
    for (int m = s->from; m <= s->from + most + 1; m++) {
        if (!cagd_equal_f(sum_of_row(s, n, k, m), S))
            return CAGD_SUM_REFUTED;
        S = mul_f(S, substitute_f(s->ratio, n, whole(m)));
    }
    if (!cagd_telescope(s->F, n, k, most, T) || !cagd_telescoper_holds(s->F, n, k, T))
        return CAGD_SUM_UNDECIDED;
    /* 0 <= k <= N: the ratios and G are defined, and nothing is left at either end. */
    if (!never_zero(cagd_denominator_f(s->F.by_k), n, k, s))
        return CAGD_SUM_UNDECIDED;
    if (!never_zero(cagd_denominator_f(s->ratio), n, k, s))
        return CAGD_SUM_UNDECIDED;
    for (int j = 1; j <= T->order; j++)
        if (!never_zero(cagd_denominator_f(step_in_n(s->F, n, j)), n, k, s))
            return CAGD_SUM_UNDECIDED;
    if (!never_zero(cagd_denominator_f(T->R), n, k, s) || !cagd_is_zero_f(substitute_f(T->R, k, whole(0))) ||
        !cagd_is_zero_f(rest_at_the_end(s, n, k, T)))
        return CAGD_SUM_UNDECIDED;
    /* S satisfies the recurrence, which determines the next value, a_J being nowhere 0. */
    num_f left = whole(0), product = whole(1);
    for (int j = 0; j <= T->order; j++) {
        left = add_f(left, mul_f(T->a[j], product));
        product = mul_f(product, shifted(s->ratio, n, j));
    }
    return cagd_is_zero_f(left) && never_zero(T->a[T->order], n, k, s) ? CAGD_SUM_PROVED : CAGD_SUM_UNDECIDED;
}
