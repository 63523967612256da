#include "exact/polynomial.h"

#include "exact/num_field_slot.h"
#include "exact/polynomial_slot.h"

#include <flint/fmpq.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include <string.h>

void polynomial_slot_init(void *p) { fmpq_poly_init(((struct polynomial *)p)->x); }
void polynomial_slot_clear(void *p) { fmpq_poly_clear(((struct polynomial *)p)->x); }

static struct polynomial *fresh(void) { return region_slot(SLOT_POLYNOMIAL); }

static poly fault(unsigned which)
{
    region_faults |= which;
    return (poly){fresh()};
}

/* The two ways between num_q and FLINT's rationals. */
static void set_coefficient(struct polynomial *p, int k, num_q c)
{
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_mpq(x, c.at);
    fmpq_poly_set_coeff_fmpq(p->x, k, x);
    fmpq_clear(x);
}
static num_q rational(const fmpq_t x)
{
    mpq_t v;
    mpq_init(v);
    fmpq_get_mpq(v, x);
    num_q r = from_mpq_q(v);
    mpq_clear(v);
    return r;
}

poly poly_from_q(int len, const num_q c[])
{
    struct polynomial *r = fresh();
    for (int k = len - 1; k >= 0; k--)
        set_coefficient(r, k, c[k]);
    return (poly){r};
}
poly poly_constant(num_q c) { return poly_from_q(1, &c); }
poly poly_variable(void)
{
    struct polynomial *r = fresh();
    fmpq_poly_set_coeff_si(r->x, 1, 1);
    return (poly){r};
}

int poly_degree(poly p) { return (int)fmpq_poly_degree(p.at->x); }
int poly_is_zero(poly p) { return fmpq_poly_is_zero(p.at->x); }
int poly_equal(poly p, poly q) { return fmpq_poly_equal(p.at->x, q.at->x); }

num_q poly_coefficient(poly p, int k)
{
    fmpq_t x;
    fmpq_init(x);
    fmpq_poly_get_coeff_fmpq(x, p.at->x, k);
    num_q c = rational(x);
    fmpq_clear(x);
    return c;
}
num_q poly_value(poly p, num_q t)
{
    fmpq_t x, y;
    fmpq_init(x), fmpq_init(y);
    fmpq_set_mpq(x, t.at);
    fmpq_poly_evaluate_fmpq(y, p.at->x, x);
    num_q v = rational(y);
    fmpq_clear(x), fmpq_clear(y);
    return v;
}

typedef void poly_operation(fmpq_poly_t, const fmpq_poly_t, const fmpq_poly_t);
static poly combine(poly_operation *op, poly p, poly q)
{
    struct polynomial *r = fresh();
    op(r->x, p.at->x, q.at->x);
    return (poly){r};
}
poly poly_add(poly p, poly q) { return combine(fmpq_poly_add, p, q); }
poly poly_sub(poly p, poly q) { return combine(fmpq_poly_sub, p, q); }
poly poly_mul(poly p, poly q) { return combine(fmpq_poly_mul, p, q); }
poly poly_compose(poly p, poly q) { return combine(fmpq_poly_compose, p, q); }
poly poly_gcd(poly p, poly q) { return combine(fmpq_poly_gcd, p, q); }
poly poly_quotient(poly p, poly q) { return poly_is_zero(q) ? fault(FAULT_UNDEFINED) : combine(fmpq_poly_div, p, q); }
poly poly_remainder(poly p, poly q) { return poly_is_zero(q) ? fault(FAULT_UNDEFINED) : combine(fmpq_poly_rem, p, q); }
int poly_divides(poly d, poly p) { return poly_is_zero(d) ? poly_is_zero(p) : poly_is_zero(poly_remainder(p, d)); }
poly poly_scale(poly p, num_q c) { return poly_mul(p, poly_constant(c)); }
poly poly_neg(poly p)
{
    struct polynomial *r = fresh();
    fmpq_poly_neg(r->x, p.at->x);
    return (poly){r};
}
poly poly_derivative(poly p)
{
    struct polynomial *r = fresh();
    fmpq_poly_derivative(r->x, p.at->x);
    return (poly){r};
}

/* A polynomial over Z in several variables, if it depends on variable v alone. */
static poly univariate(const fmpz_mpoly_t a, int v)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    struct polynomial *r = fresh();
    fmpz_poly_t x;
    fmpz_poly_init(x);
    if (fmpz_mpoly_is_fmpz_poly(a, v, ctx)) {
        fmpz_mpoly_get_fmpz_poly(x, a, v, ctx);
        fmpq_poly_set_fmpz_poly(r->x, x);
    } else {
        region_faults |= FAULT_UNABLE;
    }
    fmpz_poly_clear(x);
    return (poly){r};
}
void poly_from_field(num_f a, num_f variable, poly *numerator, poly *denominator)
{
    int v = field_variable_f(variable);
    *numerator = v < 0 ? fault(FAULT_UNDEFINED) : univariate(fmpz_mpoly_q_numref(a.at->x), v);
    *denominator = v < 0 ? fault(FAULT_UNDEFINED) : univariate(fmpz_mpoly_q_denref(a.at->x), v);
}

/* Yun: with c = gcd(p, p'), w = p/c is the product of all factors, and w divides out one
 * multiplicity after the other. */
int poly_squarefree(poly p, poly factor[], int multiplicity[])
{
    if (poly_is_zero(p)) {
        region_faults |= FAULT_UNDEFINED;
        return 0;
    }
    poly slope = poly_derivative(p), c = poly_gcd(p, slope);
    poly w = poly_quotient(p, c), y = poly_quotient(slope, c);
    int count = 0;
    for (int m = 1; poly_degree(w) > 0; m++) {
        poly z = poly_sub(y, poly_derivative(w)), g = poly_gcd(w, z);
        if (poly_degree(g) > 0) {
            factor[count] = g;
            multiplicity[count++] = m;
        }
        w = poly_quotient(w, g);
        y = poly_quotient(z, g);
    }
    return count;
}

/* t^n p(1/t + shift), for deg p <= n: the change between powers of t and of t/(1-t) takes two
 * reversals and a shift by one. */
static void reverse_shift_reverse(fmpq_poly_t p, int n, int shift)
{
    fmpq_poly_t line;
    fmpq_poly_init(line);
    fmpq_poly_set_coeff_si(line, 1, 1);
    fmpq_poly_set_coeff_si(line, 0, shift);
    fmpq_poly_reverse(p, p, n + 1);
    fmpq_poly_compose(p, p, line);
    fmpq_poly_reverse(p, p, n + 1);
    fmpq_poly_clear(line);
}

/* sum b_i B_i^n(t) = (1-t)^n F(t/(1-t)), F(x) = sum b_i C(n,i) x^i. */
poly poly_from_bernstein(int n, const num_q b[])
{
    struct polynomial *r = fresh();
    fmpz_t binomial;
    fmpq_t x;
    fmpz_init(binomial), fmpq_init(x);
    for (int i = n; i >= 0; i--) {
        fmpz_bin_uiui(binomial, (ulong)n, (ulong)i);
        fmpq_set_mpq(x, b[i].at);
        fmpq_mul_fmpz(x, x, binomial);
        fmpq_poly_set_coeff_fmpq(r->x, i, x);
    }
    fmpz_clear(binomial), fmpq_clear(x);
    reverse_shift_reverse(r->x, n, -1);
    return (poly){r};
}
void poly_to_bernstein(poly p, int n, num_q a, num_q b, num_q out[])
{
    struct polynomial *F = fresh();
    if (n < poly_degree(p))
        region_faults |= FAULT_UNDEFINED;
    else
        fmpq_poly_set(F->x, poly_compose(p, poly_from_q(2, (num_q[]){a, sub_q(b, a)})).at->x);
    reverse_shift_reverse(F->x, n, +1);
    fmpz_t binomial;
    fmpq_t x;
    fmpz_init(binomial), fmpq_init(x);
    for (int i = 0; i <= n; i++) {
        fmpz_bin_uiui(binomial, (ulong)n, (ulong)i);
        fmpq_poly_get_coeff_fmpq(x, F->x, i);
        fmpq_div_fmpz(x, x, binomial);
        out[i] = rational(x);
    }
    fmpz_clear(binomial), fmpq_clear(x);
}

const char *poly_to_string(poly p, const char *variable)
{
    char *flints = fmpq_poly_get_str_pretty(p.at->x, variable);
    size_t size = strlen(flints) + 1;
    char *text = memcpy(region_bytes(size), flints, size);
    flint_free(flints);
    return text;
}
