#include "exact/number/polynomial.h"

#include "exact/number/field_slot.h"
#include "exact/number/fraction.h"
#include "exact/number/polynomial_slot.h"
#include "exact/number/recorder.h"
#include "exact/words.h"

#include <flint/fmpq.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include <limits.h>
#include <string.h>

void cagd_polynomial_slot_init(void *p) { fmpq_poly_init(((struct cagd_polynomial *)p)->x); }
void cagd_polynomial_slot_clear(void *p) { fmpq_poly_clear(((struct cagd_polynomial *)p)->x); }

static struct cagd_polynomial *fresh(void) { return cagd_fresh_slot(SLOT_POLYNOMIAL); }

static poly fault(unsigned which)
{
    region_faults |= which;
    return (poly){fresh()};
}

/* The two ways between num_q and FLINT's rationals. */
static void set_coefficient(struct cagd_polynomial *p, int k, num_q c)
{
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_mpq(x, c.at);
    fmpq_poly_set_coeff_fmpq(p->x, k, x);
    fmpq_clear(x);
}
static num_q rational_of(const fmpq_t x)
{
    mpq_t v;
    mpq_init(v);
    fmpq_get_mpq(v, x);
    num_q r = from_mpq_q(v);
    mpq_clear(v);
    return r;
}

/* ---- what is noted ------------------------------------------------------------------------------- */

/* p was made of the numbers c, or of one or two other polynomials. */
static poly made_of_numbers(const char *op, struct cagd_polynomial *p, int count, const num_q c[])
{
    if (cagd_noting()) {
        int *argument = cagd_region_array(1, count, sizeof *argument);
        for (int k = 0; argument != NULL && k < count; k++)
            argument[k] = cagd_node_of_q(c[k]);
        if (argument != NULL)
            cagd_recorder->node(p, op, count, argument);
    }
    return (poly){p};
}
static poly made_of(const char *op, struct cagd_polynomial *p, poly a, const poly *b)
{
    if (cagd_noting()) {
        int argument[2] = {cagd_node_of_poly(a), b != NULL ? cagd_node_of_poly(*b) : 0};
        cagd_recorder->node(p, op, b != NULL ? 2 : 1, argument);
    }
    return (poly){p};
}
/* A number c was taken from p, with up to three more arguments. */
static num_q taken_from(const char *op, num_q c, poly p, int count, const int more[])
{
    if (cagd_noting()) {
        int argument[5] = {cagd_node_of_poly(p)};
        for (int k = 0; k < count; k++)
            argument[k + 1] = more[k];
        cagd_recorder->node(c.at, op, count + 1, argument);
    }
    return c;
}
poly cagd_poly_from_q(int len, const num_q c[])
{
    struct cagd_polynomial *r = fresh();
    for (int k = len - 1; k >= 0; k--)
        set_coefficient(r, k, c[k]);
    return made_of_numbers("poly", r, len, c);
}
poly cagd_poly_constant(num_q c) { return poly_from_q(1, &c); }
poly cagd_poly_variable(void) { return poly_from_q(2, (num_q[]){from_int_q(0), from_int_q(1)}); }

int cagd_poly_degree(poly p) { return (int)fmpq_poly_degree(p.at->x); }
int cagd_poly_is_zero(poly p) { return fmpq_poly_is_zero(p.at->x); }
int cagd_poly_equal(poly p, poly q) { return fmpq_poly_equal(p.at->x, q.at->x); }

num_q cagd_poly_coefficient(poly p, int k)
{
    fmpq_t x;
    fmpq_init(x);
    fmpq_poly_get_coeff_fmpq(x, p.at->x, k);
    num_q c = rational_of(x);
    fmpq_clear(x);
    return taken_from("coefficient", c, p, 1, &k);
}
num_q cagd_poly_value(poly p, num_q t)
{
    fmpq_t x, y;
    fmpq_init(x), fmpq_init(y);
    fmpq_set_mpq(x, t.at);
    fmpq_poly_evaluate_fmpq(y, p.at->x, x);
    num_q v = rational_of(y);
    fmpq_clear(x), fmpq_clear(y);
    int at = cagd_noting() ? cagd_node_of_q(t) : 0;
    return taken_from("value", v, p, 1, &at);
}

typedef void poly_operation(fmpq_poly_t, const fmpq_poly_t, const fmpq_poly_t);
static poly combine(const char *name, poly_operation *op, poly p, poly q)
{
    struct cagd_polynomial *r = fresh();
    op(r->x, p.at->x, q.at->x);
    return made_of(name, r, p, &q);
}
poly cagd_poly_add(poly p, poly q) { return combine("p+", fmpq_poly_add, p, q); }
poly cagd_poly_sub(poly p, poly q) { return combine("p-", fmpq_poly_sub, p, q); }
poly cagd_poly_mul(poly p, poly q) { return combine("p*", fmpq_poly_mul, p, q); }
poly cagd_poly_compose(poly p, poly q)
{
    long m = cagd_poly_degree(p), n = cagd_poly_degree(q);
    return m > 0 && n > INT_MAX / m ? fault(FAULT_MEMORY) : combine("pcompose", fmpq_poly_compose, p, q);
}
poly cagd_poly_gcd(poly p, poly q) { return combine("pgcd", fmpq_poly_gcd, p, q); }
poly cagd_poly_quotient(poly p, poly q)
{
    return cagd_poly_degree(q) < 0 ? fault(FAULT_UNDEFINED) : combine("pquo", fmpq_poly_div, p, q);
}
poly cagd_poly_remainder(poly p, poly q)
{
    return cagd_poly_degree(q) < 0 ? fault(FAULT_UNDEFINED) : combine("prem", fmpq_poly_rem, p, q);
}
int cagd_poly_divides(poly d, poly p)
{
    return cagd_poly_degree(d) < 0 ? cagd_poly_is_zero(p) : cagd_poly_is_zero(poly_remainder(p, d));
}
poly cagd_poly_scale(poly p, num_q c) { return poly_mul(p, poly_constant(c)); }
poly cagd_poly_neg(poly p)
{
    struct cagd_polynomial *r = fresh();
    fmpq_poly_neg(r->x, p.at->x);
    return made_of("pneg", r, p, NULL);
}
poly cagd_poly_derivative(poly p)
{
    struct cagd_polynomial *r = fresh();
    fmpq_poly_derivative(r->x, p.at->x);
    return made_of("pder", r, p, NULL);
}

/* A polynomial over Z in several variables, if it depends on variable v alone. */
static poly univariate(const fmpz_mpoly_t a, int v)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    struct cagd_polynomial *r = fresh();
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
void cagd_poly_from_field(num_f a, num_f variable, poly *numerator, poly *denominator)
{
    int v = field_variable_f(variable);
    if (v < 0) {
        *numerator = *denominator = fault(FAULT_UNDEFINED);
        return;
    }
    fmpz_mpoly_t q;
    fmpz_mpoly_init(q, cagd_field_context());
    cagd_fraction_denominator(q, a.at);
    *numerator = univariate(a.at->numerator, v);
    *denominator = univariate(q, v);
    fmpz_mpoly_clear(q, cagd_field_context());
}

poly cagd_poly_primitive(poly p)
{
    struct cagd_polynomial *r = fresh();
    fmpq_poly_primitive_part(r->x, p.at->x);
    return (poly){r};
}

/* Yun: with c = gcd(p, p'), w = p/c is the product of all factors, and w divides out one
 * multiplicity after the other. */
int cagd_poly_squarefree(poly p, poly factor[], int multiplicity[])
{
    if (cagd_poly_degree(p) < 0) {
        region_faults |= FAULT_UNDEFINED;
        return 0;
    }
    poly slope = poly_derivative(p), c = poly_gcd(p, slope);
    poly w = poly_quotient(p, c), y = poly_quotient(slope, c);
    int count = 0;
    for (int m = 1; cagd_poly_degree(w) > 0; m++) {
        poly z = poly_sub(y, poly_derivative(w)), g = poly_gcd(w, z);
        if (cagd_poly_degree(g) > 0) {
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
poly cagd_poly_from_bernstein(int n, const num_q b[])
{
    struct cagd_polynomial *r = fresh();
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
    return made_of_numbers("bernstein", r, n + 1, b);
}
/* r = p(a + (b - a) t). */
static void compose_with_line(fmpq_poly_t r, poly p, num_q a, num_q b)
{
    fmpq_poly_t line;
    fmpq_t start, way;
    fmpq_poly_init(line), fmpq_init(start), fmpq_init(way);
    fmpq_set_mpq(start, a.at), fmpq_set_mpq(way, b.at);
    fmpq_sub(way, way, start);
    fmpq_poly_set_coeff_fmpq(line, 1, way);
    fmpq_poly_set_coeff_fmpq(line, 0, start);
    fmpq_poly_compose(r, p.at->x, line);
    fmpq_poly_clear(line), fmpq_clear(start), fmpq_clear(way);
}
void cagd_poly_to_bernstein(poly p, int n, num_q a, num_q b, num_q out[])
{
    struct cagd_polynomial *F = fresh();
    int ends[4] = {0, 0, n, 0};
    if (cagd_noting()) {
        ends[0] = cagd_node_of_q(a);
        ends[1] = cagd_node_of_q(b);
    }
    if (n < cagd_poly_degree(p))
        region_faults |= FAULT_UNDEFINED;
    else
        compose_with_line(F->x, p, a, b);
    reverse_shift_reverse(F->x, n, +1);
    fmpz_t binomial;
    fmpq_t x;
    fmpz_init(binomial), fmpq_init(x);
    for (int i = 0; i <= n; i++) {
        fmpz_bin_uiui(binomial, (ulong)n, (ulong)i);
        fmpq_poly_get_coeff_fmpq(x, F->x, i);
        fmpq_div_fmpz(x, x, binomial);
        out[i] = rational_of(x);
    }
    fmpz_clear(binomial), fmpq_clear(x);
    for (int i = 0; i <= n; i++) {
        ends[3] = i;
        taken_from("tobernstein", out[i], p, 4, ends);
    }
}

const char *cagd_poly_to_string(poly p, const char *variable)
{
    char *flints = fmpq_poly_get_str_pretty(p.at->x, variable);
    size_t size = strlen(flints) + 1;
    char *text = region_bytes(size);
    if (text != NULL)
        memcpy(text, flints, size);
    flint_free(flints);
    return text != NULL ? text : "";
}
