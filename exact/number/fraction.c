#include "exact/number/fraction.h"
#include "exact/words.h"

#include <flint/fmpq.h>
#include <flint/fmpz_mpoly_factor.h>
#include <string.h>

enum { MOST_FACTORED = 400, REMEMBERED = 64 }; /* terms of a divisor that FLINT factors */

/* The irreducible factors seen so far: primitive, with positive leading coefficient, no two equal. */
static _Thread_local struct {
    fmpz_mpoly_struct poly[FIELD_MOST_FACTORS];
    int count;
} factors;

/* The last divisors that were factored, in a ring: the same ones come again. */
static _Thread_local struct {
    fmpz_mpoly_struct poly[REMEMBERED];
    struct factored factored[REMEMBERED];
    int found[REMEMBERED], count, next;
} divisors;

void cagd_fraction_open(void)
{
    factors.count = 0;
    divisors.count = divisors.next = 0;
}
void cagd_fraction_close(void)
{
    while (factors.count > 0)
        fmpz_mpoly_clear(&factors.poly[--factors.count], cagd_field_context());
    while (divisors.count > 0)
        fmpz_mpoly_clear(&divisors.poly[--divisors.count], cagd_field_context());
}

/* Its index in the list, upon which p is put if it is new; -1 when the list is full. */
static int number_of_factor(const fmpz_mpoly_t p)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    for (int k = 0; k < factors.count; k++)
        if (fmpz_mpoly_equal(&factors.poly[k], p, ctx))
            return k;
    if (factors.count == FIELD_MOST_FACTORS)
        return -1;
    fmpz_mpoly_init(&factors.poly[factors.count], ctx);
    fmpz_mpoly_set(&factors.poly[factors.count], p, ctx);
    return factors.count++;
}

/* ---- contents ------------------------------------------------------------------------------------- */

/* p divided by an integer, so that it is primitive with positive leading coefficient; p = c primitive, p != 0. */
static void make_primitive(fmpz_mpoly_t primitive, fmpz_t c, const fmpz_mpoly_t p)
{
    _fmpz_vec_content(c, p->coeffs, p->length);
    if (fmpz_sgn(p->coeffs) < 0)
        fmpz_neg(c, c);
    fmpz_mpoly_scalar_divexact_fmpz(primitive, p, c, cagd_field_context());
}

/* p and c > 0 without the common divisor of the integers that divide them. */
static void reduce_content(fmpz_mpoly_t p, fmpz_t c)
{
    if (fmpz_is_one(c))
        return;
    fmpz_t g;
    fmpz_init_set(g, c);
    for (slong k = 0; k < p->length && !fmpz_is_one(g); k++)
        fmpz_gcd(g, g, p->coeffs + k);
    if (!fmpz_is_one(g)) {
        fmpz_mpoly_scalar_divexact_fmpz(p, p, g, cagd_field_context());
        fmpz_divexact(c, c, g);
    }
    fmpz_clear(g);
}

/* The next functions give p itself where there is nothing to do, and otherwise the result, which they put into `room`.
 * `room` may be p. */

/* p c */
static const fmpz_mpoly_struct *times_integer(fmpz_mpoly_t room, const fmpz_mpoly_struct *p, const fmpz_t c)
{
    if (fmpz_is_one(c))
        return p;
    fmpz_mpoly_scalar_mul_fmpz(room, p, c, cagd_field_context());
    return room;
}

/* ---- lists of factors ----------------------------------------------------------------------------- */

static int power_in(const struct factored *d, int factor)
{
    for (int k = 0; k < d->count; k++)
        if (d->factor[k] == factor)
            return d->power[k];
    return 0;
}

/* d = d f^power; 0 when that is too much. */
static int multiply_by(struct factored *d, int factor, int power)
{
    if (power == 0)
        return 1;
    int k = 0;
    while (k < d->count && d->factor[k] != factor)
        k++;
    if (k == FIELD_MOST_IN_DENOMINATOR || power > FIELD_MOST_POWER ||
        (k < d->count && d->power[k] > FIELD_MOST_POWER - power))
        return 0;
    if (k == d->count) {
        d->factor[d->count] = (unsigned char)factor;
        d->power[d->count++] = 0;
    }
    d->power[k] = (unsigned char)(d->power[k] + power);
    return 1;
}

static void drop_trivial(struct factored *d)
{
    int kept = 0;
    for (int k = 0; k < d->count; k++)
        if (d->power[k] > 0) {
            d->factor[kept] = d->factor[k];
            d->power[kept++] = d->power[k];
        }
    d->count = (unsigned char)kept;
}

/* p f^power; p for a negative power */
static const fmpz_mpoly_struct *times_power(fmpz_mpoly_t room, const fmpz_mpoly_struct *p, int factor, int power)
{
    for (; power > 0; power--, p = room)
        fmpz_mpoly_mul(room, p, &factors.poly[factor], cagd_field_context());
    return p;
}

/* p = p/f as often as f divides p, at most `most` times; how often it was. */
static int divide_out(fmpz_mpoly_t p, int factor, int most)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    int times = 0;
    fmpz_mpoly_t q;
    fmpz_mpoly_init(q, ctx);
    while (times < most && fmpz_mpoly_divides(q, p, &factors.poly[factor], ctx)) {
        fmpz_mpoly_swap(p, q, ctx);
        times++;
    }
    fmpz_mpoly_clear(q, ctx);
    return times;
}

/* p without the factors that the list `of` has and `own`, the denominator of p, has not; d loses them. */
static const fmpz_mpoly_struct *cancelled(fmpz_mpoly_t room, const fmpz_mpoly_struct *p, const struct factored *own,
                                          const struct factored *of, struct factored *d)
{
    for (int k = 0; k < of->count; k++)
        if (power_in(own, of->factor[k]) == 0) {
            if (p != room)
                fmpz_mpoly_set(room, p, cagd_field_context());
            p = room;
            int times = divide_out(room, of->factor[k], of->power[k]);
            for (int j = 0; times > 0 && j < d->count; j++)
                if (d->factor[j] == of->factor[k])
                    d->power[j] = (unsigned char)(d->power[j] - times);
        }
    return p;
}

/* ---- the factors of a divisor ------------------------------------------------------------------------ */

static int factorise(struct factored *d, const fmpz_mpoly_t p);

/* The variable in which p is linear and has the shortest coefficient, with that coefficient; -1 when there is none. */
static int linear_variable(fmpz_mpoly_t coefficient, const fmpz_mpoly_t p)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    int best = -1;
    fmpz_mpoly_t slope;
    fmpz_mpoly_init(slope, ctx);
    for (int v = 0; v < fmpz_mpoly_ctx_nvars(ctx); v++)
        if (fmpz_mpoly_degree_si(p, v, ctx) == 1) {
            fmpz_mpoly_derivative(slope, p, v, ctx);
            if (best < 0 || fmpz_mpoly_length(slope, ctx) < fmpz_mpoly_length(coefficient, ctx)) {
                fmpz_mpoly_swap(coefficient, slope, ctx);
                best = v;
            }
        }
    fmpz_mpoly_clear(slope, ctx);
    return best;
}

/* p = a x + b.  What divides p and is free of x divides a and b; the rest of p is linear in x, so it is irreducible. */
static int factorise_linear(struct factored *d, const fmpz_mpoly_t p, const fmpz_mpoly_t a)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    struct factored candidates;
    if (!factorise(&candidates, a))
        return 0;
    fmpz_t c;
    fmpz_mpoly_t rest;
    fmpz_init(c), fmpz_mpoly_init(rest, ctx);
    make_primitive(rest, c, p);
    int found = 1;
    for (int k = 0; found && k < candidates.count; k++)
        found = multiply_by(d, candidates.factor[k], divide_out(rest, candidates.factor[k], candidates.power[k]));
    int number = found ? number_of_factor(rest) : -1;
    fmpz_clear(c), fmpz_mpoly_clear(rest, ctx);
    return number >= 0 && multiply_by(d, number, 1);
}

static int factorise_by_flint(struct factored *d, const fmpz_mpoly_t p)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (fmpz_mpoly_length(p, ctx) > MOST_FACTORED)
        return 0;
    fmpz_mpoly_factor_t f;
    fmpz_mpoly_factor_init(f, ctx);
    int found = fmpz_mpoly_factor(f, p, ctx);
    for (slong k = 0; found && k < f->num; k++) {
        int small = fmpz_cmp_si(f->exp + k, FIELD_MOST_POWER) <= 0, factor = small ? number_of_factor(f->poly + k) : -1;
        found = factor >= 0 && multiply_by(d, factor, (int)fmpz_get_si(f->exp + k));
    }
    fmpz_mpoly_factor_clear(f, ctx);
    return found;
}

static int factorise_anew(struct factored *d, const fmpz_mpoly_t p)
{
    fmpz_mpoly_t coefficient;
    fmpz_mpoly_init(coefficient, cagd_field_context());
    int found = linear_variable(coefficient, p) >= 0 ? factorise_linear(d, p, coefficient) : factorise_by_flint(d, p);
    fmpz_mpoly_clear(coefficient, cagd_field_context());
    return found;
}

/* p = c prod f^e, p != 0, with an integer c and the factors into d; 0 where they are not found. */
static int factorise(struct factored *d, const fmpz_mpoly_t p)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    *d = (struct factored){.known = 1};
    if (fmpz_mpoly_is_fmpz(p, ctx))
        return 1;
    int k = 0;
    while (k < divisors.count && !fmpz_mpoly_equal(&divisors.poly[k], p, ctx))
        k++;
    if (k < divisors.count) {
        *d = divisors.factored[k];
        return divisors.found[k];
    }
    int found = factorise_anew(d, p);
    k = divisors.next;
    divisors.next = (k + 1) % REMEMBERED;
    if (k == divisors.count)
        fmpz_mpoly_init(&divisors.poly[divisors.count++], ctx);
    fmpz_mpoly_set(&divisors.poly[k], p, ctx);
    divisors.factored[k] = *d;
    return divisors.found[k] = found;
}

/* ---- to FLINT and back -------------------------------------------------------------------------------- */

void cagd_fraction_denominator(fmpz_mpoly_t q, const struct cagd_field_element *a)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (!a->factors.known) {
        fmpz_mpoly_set(q, a->rest, ctx);
        return;
    }
    fmpz_mpoly_set_fmpz(q, a->content, ctx);
    for (int k = 0; k < a->factors.count; k++)
        times_power(q, q, a->factors.factor[k], a->factors.power[k]);
}

int cagd_fraction_denominator_degree(const struct cagd_field_element *a, int variable)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (!a->factors.known)
        return (int)fmpz_mpoly_degree_si(a->rest, variable, ctx);
    slong degree = 0;
    for (int k = 0; k < a->factors.count; k++)
        degree += a->factors.power[k] * fmpz_mpoly_degree_si(&factors.poly[a->factors.factor[k]], variable, ctx);
    return (int)degree;
}

void cagd_fraction_get(fmpz_mpoly_q_t x, const struct cagd_field_element *a)
{
    fmpz_mpoly_set(fmpz_mpoly_q_numref(x), a->numerator, cagd_field_context());
    cagd_fraction_denominator(fmpz_mpoly_q_denref(x), a);
}

/* r = x, which is given up. */
static void set(struct cagd_field_element *r, fmpz_mpoly_q_t x)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    fmpz_mpoly_swap(r->numerator, fmpz_mpoly_q_numref(x), ctx);
    r->factors = (struct factored){.known = fmpz_mpoly_is_fmpz(fmpz_mpoly_q_denref(x), ctx) != 0};
    if (r->factors.known)
        fmpz_mpoly_get_fmpz(r->content, fmpz_mpoly_q_denref(x), ctx);
    else
        fmpz_mpoly_swap(r->rest, fmpz_mpoly_q_denref(x), ctx);
}

/* ---- numbers, the most frequent operands ---------------------------------------------------------------- */

static int is_number(const struct cagd_field_element *a)
{
    return a->factors.known && a->factors.count == 0 && fmpz_mpoly_is_fmpz(a->numerator, cagd_field_context());
}

typedef void on_numbers(fmpz_t, fmpz_t, const fmpz_t, const fmpz_t, const fmpz_t, const fmpz_t);

/* r = the operation on a and b, if both are numbers. */
static int are_numbers(on_numbers *operation, struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (!is_number(a) || !is_number(b))
        return 0;
    fmpz_t p, q, result;
    fmpz_init(p), fmpz_init(q), fmpz_init(result);
    fmpz_mpoly_get_fmpz(p, a->numerator, ctx), fmpz_mpoly_get_fmpz(q, b->numerator, ctx);
    operation(result, r->content, p, a->content, q, b->content);
    fmpz_mpoly_set_fmpz(r->numerator, result, ctx);
    fmpz_clear(p), fmpz_clear(q), fmpz_clear(result);
    return 1;
}

/* ---- whatever is not factored ---------------------------------------------------------------------------- */

typedef void by_flint(fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_ctx_t);

static void leave_to(by_flint *operation, struct cagd_field_element *r, const struct cagd_field_element *a,
                     const struct cagd_field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    fmpz_mpoly_q_t x, y, z;
    fmpz_mpoly_q_init(x, ctx), fmpz_mpoly_q_init(y, ctx), fmpz_mpoly_q_init(z, ctx);
    cagd_fraction_get(x, a), cagd_fraction_get(y, b);
    operation(z, x, y, ctx);
    set(r, z);
    fmpz_mpoly_q_clear(x, ctx), fmpz_mpoly_q_clear(y, ctx), fmpz_mpoly_q_clear(z, ctx);
}

/* ---- arithmetic ----------------------------------------------------------------------------------- */

static int is_zero(const struct cagd_field_element *a) { return a->numerator->length == 0; }

/* r has its numerator and content; its denominator has the factors d, of which some may have cancelled. */
static void finish(struct cagd_field_element *r, struct factored *d)
{
    if (is_zero(r)) {
        fmpz_one(r->content);
        r->factors = (struct factored){.known = 1};
        return;
    }
    drop_trivial(d);
    r->factors = *d;
    reduce_content(r->numerator, r->content);
}

/* Over the least common multiple of the denominators.  A factor f with different powers in them does not divide the new
 * numerator: it divides just one of its two terms, as a and b are in lowest terms. */
static void add_or_subtract(int sign, struct cagd_field_element *r, const struct cagd_field_element *a,
                            const struct cagd_field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (are_numbers(sign > 0 ? _fmpq_add : _fmpq_sub, r, a, b))
        return;
    const struct factored *da = &a->factors, *db = &b->factors;
    struct factored d = *da;
    int fits = da->known && db->known;
    for (int k = 0; fits && k < db->count; k++) {
        int more = db->power[k] - power_in(da, db->factor[k]);
        fits = more <= 0 || multiply_by(&d, db->factor[k], more);
    }
    if (!fits) {
        leave_to(sign > 0 ? fmpz_mpoly_q_add : fmpz_mpoly_q_sub, r, a, b);
        return;
    }
    fmpz_mpoly_t p, q;
    fmpz_t ca, cb;
    fmpz_mpoly_init(p, ctx), fmpz_mpoly_init(q, ctx);
    fmpz_init_set(ca, a->content), fmpz_init_set(cb, b->content);
    if (!fmpz_is_one(ca) && !fmpz_is_one(cb)) {
        fmpz_gcd(r->content, ca, cb);
        fmpz_divexact(ca, ca, r->content), fmpz_divexact(cb, cb, r->content);
    }
    fmpz_mul(r->content, a->content, cb);
    const fmpz_mpoly_struct *terms_of_a = times_integer(p, a->numerator, cb);
    const fmpz_mpoly_struct *terms_of_b = times_integer(q, b->numerator, ca);
    for (int k = 0; k < d.count; k++) {
        int more_in_b = power_in(db, d.factor[k]) - power_in(da, d.factor[k]);
        terms_of_a = times_power(p, terms_of_a, d.factor[k], more_in_b);
        terms_of_b = times_power(q, terms_of_b, d.factor[k], -more_in_b);
    }
    (sign > 0 ? fmpz_mpoly_add : fmpz_mpoly_sub)(r->numerator, terms_of_a, terms_of_b, ctx);
    for (int k = 0; k < d.count && !is_zero(r); k++)
        if (power_in(da, d.factor[k]) == power_in(db, d.factor[k]))
            d.power[k] = (unsigned char)(d.power[k] - divide_out(r->numerator, d.factor[k], d.power[k]));
    finish(r, &d);
    fmpz_clear(ca), fmpz_clear(cb), fmpz_mpoly_clear(p, ctx), fmpz_mpoly_clear(q, ctx);
}
void cagd_fraction_add(struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b)
{
    add_or_subtract(1, r, a, b);
}
void cagd_fraction_sub(struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b)
{
    add_or_subtract(-1, r, a, b);
}

void cagd_fraction_mul(struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (is_zero(a) || is_zero(b) || are_numbers(_fmpq_mul, r, a, b))
        return;
    struct factored d = a->factors;
    int fits = a->factors.known && b->factors.known;
    for (int k = 0; fits && k < b->factors.count; k++)
        fits = multiply_by(&d, b->factors.factor[k], b->factors.power[k]);
    if (!fits) {
        leave_to(fmpz_mpoly_q_mul, r, a, b);
        return;
    }
    fmpz_mpoly_t room_a, room_b;
    fmpz_mpoly_init(room_a, ctx), fmpz_mpoly_init(room_b, ctx);
    const fmpz_mpoly_struct *p = cancelled(room_a, a->numerator, &a->factors, &b->factors, &d);
    const fmpz_mpoly_struct *q = cancelled(room_b, b->numerator, &b->factors, &a->factors, &d);
    if (fmpz_mpoly_is_fmpz(p, ctx))
        fmpz_mpoly_scalar_mul_fmpz(r->numerator, q, p->coeffs, ctx);
    else if (fmpz_mpoly_is_fmpz(q, ctx))
        fmpz_mpoly_scalar_mul_fmpz(r->numerator, p, q->coeffs, ctx);
    else
        fmpz_mpoly_mul(r->numerator, p, q, ctx);
    fmpz_mul(r->content, a->content, b->content);
    finish(r, &d);
    fmpz_mpoly_clear(room_a, ctx), fmpz_mpoly_clear(room_b, ctx);
}

/* a/b = (p/A)/(q/B) = p (B/A)/q: what A and B have in common cancels by comparing lists, p and q by trial division. */
void cagd_fraction_div(struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (is_zero(a) || are_numbers(_fmpq_div, r, a, b))
        return;
    struct factored divisor, d = a->factors;
    const struct factored *B = &b->factors;
    int fits = a->factors.known && B->known && factorise(&divisor, b->numerator);
    for (int k = 0; fits && k < divisor.count; k++)
        fits = multiply_by(&d, divisor.factor[k], divisor.power[k]);
    if (!fits) {
        leave_to(fmpz_mpoly_q_div, r, a, b);
        return;
    }
    fmpz_mpoly_set(r->numerator, a->numerator, ctx);
    cancelled(r->numerator, r->numerator, &a->factors, &divisor, &d);
    for (int k = 0; k < B->count; k++) {
        int common = 0;
        for (int j = 0; j < d.count; j++)
            if (d.factor[j] == B->factor[k]) {
                common = d.power[j] < B->power[k] ? d.power[j] : B->power[k];
                d.power[j] = (unsigned char)(d.power[j] - common);
            }
        times_power(r->numerator, r->numerator, B->factor[k], B->power[k] - common);
    }
    times_integer(r->numerator, r->numerator, b->content);
    fmpz_t c;
    fmpz_init(c);
    _fmpz_vec_content(c, b->numerator->coeffs, b->numerator->length);
    if (fmpz_sgn(b->numerator->coeffs) < 0)
        fmpz_mpoly_neg(r->numerator, r->numerator, ctx);
    fmpz_mul(r->content, a->content, c);
    finish(r, &d);
    fmpz_clear(c);
}

void cagd_fraction_over_denominator_of(struct cagd_field_element *r, const fmpz_mpoly_t p,
                                       const struct cagd_field_element *a)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    static const struct factored none = {.known = 1};
    if (a->factors.known) {
        struct factored d = a->factors;
        fmpz_mpoly_set(r->numerator, p, ctx);
        fmpz_set(r->content, a->content);
        if (!is_zero(r))
            cancelled(r->numerator, r->numerator, &none, &a->factors, &d);
        finish(r, &d);
        return;
    }
    fmpz_mpoly_q_t x;
    fmpz_mpoly_q_init(x, ctx);
    fmpz_mpoly_set(fmpz_mpoly_q_numref(x), p, ctx);
    fmpz_mpoly_set(fmpz_mpoly_q_denref(x), a->rest, ctx);
    fmpz_mpoly_q_canonicalise(x, ctx);
    set(r, x);
    fmpz_mpoly_q_clear(x, ctx);
}

/* (p/q)' = (p' q - p q')/q^2 where q is not factored.  With q = c prod f^e it is, over the product F of the factors f that
 * have a slope, (p' F - p sum e f' F/f)/(q F), and no f in F divides that numerator: it divides all its terms but one. */
void cagd_fraction_derivative(struct cagd_field_element *r, const struct cagd_field_element *a, int variable)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    struct factored d = a->factors, constant = {.known = 1};
    fmpz_mpoly_t F, sum, slope, term;
    fmpz_mpoly_init(F, ctx), fmpz_mpoly_init(sum, ctx), fmpz_mpoly_init(slope, ctx), fmpz_mpoly_init(term, ctx);
    fmpz_mpoly_one(F, ctx);
    int fits = a->factors.known;
    for (int k = 0; fits && k < a->factors.count; k++) {
        const fmpz_mpoly_struct *f = &factors.poly[a->factors.factor[k]];
        fmpz_mpoly_derivative(slope, f, variable, ctx);
        if (fmpz_mpoly_is_zero(slope, ctx)) {
            multiply_by(&constant, a->factors.factor[k], a->factors.power[k]);
        } else { /* sum = sum f + e f' F */
            fmpz_mpoly_mul(term, slope, F, ctx);
            fmpz_mpoly_scalar_mul_si(term, term, a->factors.power[k], ctx);
            fmpz_mpoly_mul(sum, sum, f, ctx);
            fmpz_mpoly_add(sum, sum, term, ctx);
            fmpz_mpoly_mul(F, F, f, ctx);
            fits = multiply_by(&d, a->factors.factor[k], 1);
        }
    }
    if (fits) {
        static const struct factored none = {.known = 1};
        fmpz_mpoly_derivative(slope, a->numerator, variable, ctx);
        fmpz_mpoly_mul(r->numerator, slope, F, ctx);
        fmpz_mpoly_mul(term, a->numerator, sum, ctx);
        fmpz_mpoly_sub(r->numerator, r->numerator, term, ctx);
        fmpz_set(r->content, a->content);
        if (!is_zero(r))
            cancelled(r->numerator, r->numerator, &none, &constant, &d);
        finish(r, &d);
    } else {
        fmpz_mpoly_q_t x;
        fmpz_mpoly_q_init(x, ctx);
        cagd_fraction_denominator(F, a);
        fmpz_mpoly_derivative(slope, a->numerator, variable, ctx);
        fmpz_mpoly_mul(fmpz_mpoly_q_numref(x), slope, F, ctx);
        fmpz_mpoly_derivative(slope, F, variable, ctx);
        fmpz_mpoly_mul(term, a->numerator, slope, ctx);
        fmpz_mpoly_sub(fmpz_mpoly_q_numref(x), fmpz_mpoly_q_numref(x), term, ctx);
        fmpz_mpoly_mul(fmpz_mpoly_q_denref(x), F, F, ctx);
        fmpz_mpoly_q_canonicalise(x, ctx);
        set(r, x);
        fmpz_mpoly_q_clear(x, ctx);
    }
    fmpz_mpoly_clear(F, ctx), fmpz_mpoly_clear(sum, ctx), fmpz_mpoly_clear(slope, ctx), fmpz_mpoly_clear(term, ctx);
}

/* ---- questions ---------------------------------------------------------------------------------------- */

static int same_denominators(const struct cagd_field_element *a, const struct cagd_field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (a->factors.known && b->factors.known) {
        int same = fmpz_equal(a->content, b->content) && a->factors.count == b->factors.count;
        for (int k = 0; same && k < a->factors.count; k++)
            same = power_in(&b->factors, a->factors.factor[k]) == a->factors.power[k];
        return same;
    }
    fmpz_mpoly_t p, q;
    fmpz_mpoly_init(p, ctx), fmpz_mpoly_init(q, ctx);
    cagd_fraction_denominator(p, a), cagd_fraction_denominator(q, b);
    int same = fmpz_mpoly_equal(p, q, ctx);
    fmpz_mpoly_clear(p, ctx), fmpz_mpoly_clear(q, ctx);
    return same;
}

/* The lowest terms are unique.  Whatever the lists are, what is called equal here is equal: the same numerator over the same
 * product. */
int cagd_fraction_equal(const struct cagd_field_element *a, const struct cagd_field_element *b)
{
    return fmpz_mpoly_equal(a->numerator, b->numerator, cagd_field_context()) && same_denominators(a, b);
}

int cagd_fraction_is_polynomial(const struct cagd_field_element *a)
{
    return a->factors.known && a->factors.count == 0 && fmpz_is_one(a->content);
}
