/* plane-polynomials.h -- polynomials in x and y that a claim gives by their terms, α x^i y^j as (α, i, j).
 *
 * Text for the field, included after claims_on.h. */
#ifndef CAGD_RATIONAL_BEZIER_PLANE_POLYNOMIALS_H
#define CAGD_RATIONAL_BEZIER_PLANE_POLYNOMIALS_H
#if FIELD
enum { MOST_TERMS = 6 };

/* Σ α x^i y^j over so many terms (α, i, j), the exponents being whole numbers of 0, 1, 2, ... */
static inline num_f polynomial_of_terms(int terms, const num_f term[])
{
    num_f x = variable_f("x"), y = variable_f("y"), sum = from_int(0);
    for (int k = 0; k < terms; k++) {
        num_f product = term[3 * k];
        for (int axis = 0; axis < 2; axis++) {
            num_q exponent = from_int_q(0);
            is_constant_f(term[3 * k + 1 + axis], &exponent);
            for (int j = (int)to_double_q(exponent); j > 0; j--)
                product = mul(product, axis == 0 ? x : y);
        }
        sum = add(sum, product);
    }
    return sum;
}

/* The total degree of F in x and y. */
static inline int total_degree(num_f F, num_f x, num_f y)
{
    num_f s = variable_f("scale"), sx = mul(s, x), sy = mul(s, y), sum = from_int(0);
    int n = degree_f(F, x);
    for (int k = n; k >= 0; k--) {
        num_f c = coefficient_f(F, x, k), row = from_int(0);
        for (int j = degree_f(c, y); j >= 0; j--)
            row = add(mul(row, sy), coefficient_f(c, y, j));
        sum = add(mul(sum, sx), row);
    }
    return degree_f(sum, s);
}

/* The polynomial of so many terms, at most MOST_TERMS, that stands under the name in the data of the claim. */
static inline num_f given_polynomial(trial *T, const char *name, int terms)
{
    num_f term[3 * MOST_TERMS];
    given_points(T, name, terms, 3, term);
    return polynomial_of_terms(terms, term);
}
#endif
#endif
