#include "exact/fraction.h"

#include <flint/fmpz_mpoly_factor.h>
#include <string.h>

enum { MOST_FACTORED = 400, REMEMBERED = 64 }; /* terms of a divisor that is factored, unless it is linear */

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

void fraction_open(void)
{
    factors.count = 0;
    divisors.count = divisors.next = 0;
}
void fraction_close(void)
{
    while (factors.count > 0)
        fmpz_mpoly_clear(&factors.poly[--factors.count], field_context());
    while (divisors.count > 0)
        fmpz_mpoly_clear(&divisors.poly[--divisors.count], field_context());
}

/* Its index in the list, upon which p is put if it is new; -1 when the list is full. */
static int number_of_factor(const fmpz_mpoly_t p)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
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

static void content(fmpz_t c, const fmpz_mpoly_t p) { _fmpz_vec_content(c, p->coeffs, p->length); }

/* p divided by an integer, so that it is primitive with positive leading coefficient. */
static void make_primitive(fmpz_mpoly_t primitive, const fmpz_mpoly_t p)
{
    fmpz_t c;
    fmpz_init(c);
    content(c, p);
    if (fmpz_sgn(p->coeffs) < 0)
        fmpz_neg(c, c);
    fmpz_mpoly_scalar_divexact_fmpz(primitive, p, c, field_context());
    fmpz_clear(c);
}

/* Both without the common divisor of the integers that divide them. */
static void reduce_contents(fmpz_mpoly_t p, fmpz_mpoly_t q)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    fmpz_t a, b;
    fmpz_init(a), fmpz_init(b);
    content(a, q);
    if (!fmpz_is_one(a)) {
        content(b, p);
        fmpz_gcd(a, a, b);
        if (!fmpz_is_one(a)) {
            fmpz_mpoly_scalar_divexact_fmpz(p, p, a, ctx);
            fmpz_mpoly_scalar_divexact_fmpz(q, q, a, ctx);
        }
    }
    fmpz_clear(a), fmpz_clear(b);
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

/* p = p f^power */
static void expand_by(fmpz_mpoly_t p, int factor, int power)
{
    for (; power > 0; power--)
        fmpz_mpoly_mul(p, p, &factors.poly[factor], field_context());
}

/* p = p/f as often as f divides p, at most `most` times; how often it was. */
static int divide_out(fmpz_mpoly_t p, int factor, int most)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
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

/* |p| = c prod f^e with the factors into d; 0 where it is not found. */
static int factorise_anew(struct factored *d, const fmpz_mpoly_t p)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
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

static int factorise(struct factored *d, const fmpz_mpoly_t p)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    *d = (struct factored){.known = 1};
    if (fmpz_mpoly_is_fmpz(p, ctx))
        return 1;
    if (fmpz_mpoly_length(p, ctx) > MOST_FACTORED)
        return 0;
    int k = 0;
    while (k < divisors.count && !fmpz_mpoly_equal(&divisors.poly[k], p, ctx))
        k++;
    if (k == divisors.count) {
        k = divisors.next;
        divisors.next = (k + 1) % REMEMBERED;
        if (k == divisors.count)
            fmpz_mpoly_init(&divisors.poly[divisors.count++], ctx);
        fmpz_mpoly_set(&divisors.poly[k], p, ctx);
        if (fmpz_mpoly_total_degree_si(p, ctx) == 1) {
            fmpz_mpoly_t primitive;
            fmpz_mpoly_init(primitive, ctx);
            make_primitive(primitive, p);
            int factor = number_of_factor(primitive);
            fmpz_mpoly_clear(primitive, ctx);
            divisors.found[k] = factor >= 0 && multiply_by(d, factor, 1);
        } else {
            divisors.found[k] = factorise_anew(d, p);
        }
        divisors.factored[k] = *d;
    }
    *d = divisors.factored[k];
    return divisors.found[k];
}

/* ---- arithmetic ----------------------------------------------------------------------------------- */

typedef void by_flint(fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_ctx_t);

/* Without the lists; what has a constant denominator has no factors in it all the same. */
static void leave_to(by_flint *operation, struct field_element *r, const struct field_element *a,
                     const struct field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    operation(r->x, a->x, b->x, ctx);
    r->denominator = (struct factored){.known = fmpz_mpoly_is_fmpz(fmpz_mpoly_q_denref(r->x), ctx) != 0};
}

static int both_known(const struct field_element *a, const struct field_element *b)
{
    return a->denominator.known && b->denominator.known && (a->denominator.count > 0 || b->denominator.count > 0);
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

/* r has its numerator, and a denominator with the factors d and more: those that cancelled.  In lowest terms but for
 * integers. */
static void finish(struct field_element *r, struct factored *d, int cancelled)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    fmpz_mpoly_struct *denominator = fmpz_mpoly_q_denref(r->x);
    if (cancelled) {
        fmpz_t c;
        fmpz_init(c);
        content(c, denominator);
        fmpz_mpoly_set_fmpz(denominator, c, ctx);
        fmpz_clear(c);
        for (int k = 0; k < d->count; k++)
            expand_by(denominator, d->factor[k], d->power[k]);
        drop_trivial(d);
    }
    reduce_contents(fmpz_mpoly_q_numref(r->x), denominator);
    r->denominator = *d;
}

/* Over the least common multiple of the denominators.  A factor f with different powers in them does not divide the new
 * numerator: it divides just one of its two terms, as a and b are in lowest terms. */
static void add_or_subtract(by_flint *operation, struct field_element *r, const struct field_element *a,
                            const struct field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    const struct factored *da = &a->denominator, *db = &b->denominator;
    struct factored d = *da;
    int fits = both_known(a, b), cancelled = 0;
    for (int k = 0; fits && k < db->count; k++) {
        int more = db->power[k] - power_in(da, db->factor[k]);
        fits = more <= 0 || multiply_by(&d, db->factor[k], more);
    }
    if (!fits) {
        leave_to(operation, r, a, b);
        return;
    }
    fmpz_mpoly_struct *numerator = fmpz_mpoly_q_numref(r->x), *denominator = fmpz_mpoly_q_denref(r->x);
    fmpz_mpoly_t other;
    fmpz_t ca, cb, g;
    fmpz_init(ca), fmpz_init(cb), fmpz_init(g), fmpz_mpoly_init(other, ctx);
    content(ca, fmpz_mpoly_q_denref(a->x)), content(cb, fmpz_mpoly_q_denref(b->x));
    fmpz_gcd(g, ca, cb);
    fmpz_divexact(ca, ca, g), fmpz_divexact(cb, cb, g);
    fmpz_mpoly_scalar_mul_fmpz(numerator, fmpz_mpoly_q_numref(a->x), cb, ctx);
    fmpz_mpoly_scalar_mul_fmpz(other, fmpz_mpoly_q_numref(b->x), ca, ctx);
    fmpz_mpoly_scalar_mul_fmpz(denominator, fmpz_mpoly_q_denref(a->x), cb, ctx);
    for (int k = 0; k < d.count; k++) {
        int in_a = power_in(da, d.factor[k]), in_b = power_in(db, d.factor[k]);
        expand_by(numerator, d.factor[k], in_b - in_a);
        expand_by(denominator, d.factor[k], in_b - in_a);
        expand_by(other, d.factor[k], in_a - in_b);
    }
    (operation == fmpz_mpoly_q_add ? fmpz_mpoly_add : fmpz_mpoly_sub)(numerator, numerator, other, ctx);
    if (fmpz_mpoly_is_zero(numerator, ctx)) {
        fmpz_mpoly_one(denominator, ctx);
        r->denominator = (struct factored){.known = 1};
    } else {
        for (int k = 0; k < d.count; k++)
            if (power_in(da, d.factor[k]) == power_in(db, d.factor[k])) {
                int times = divide_out(numerator, d.factor[k], d.power[k]);
                d.power[k] = (unsigned char)(d.power[k] - times);
                cancelled += times;
            }
        finish(r, &d, cancelled);
    }
    fmpz_clear(ca), fmpz_clear(cb), fmpz_clear(g), fmpz_mpoly_clear(other, ctx);
}

/* p without the factors that the denominator `of` has and `own`, the denominator of p, has not; d loses them. */
static int cancel(fmpz_mpoly_t p, const struct factored *own, const struct factored *of, struct factored *d)
{
    int cancelled = 0;
    for (int k = 0; k < d->count; k++) {
        int most = power_in(of, d->factor[k]);
        if (most > 0 && power_in(own, d->factor[k]) == 0) {
            int times = divide_out(p, d->factor[k], most);
            d->power[k] = (unsigned char)(d->power[k] - times);
            cancelled += times;
        }
    }
    return cancelled;
}

static void multiply(by_flint *operation, struct field_element *r, const struct field_element *a,
                     const struct field_element *b, const struct field_element *original)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    const struct factored *da = &a->denominator, *db = &b->denominator;
    struct factored d = *da;
    int fits = both_known(a, b) && !fmpz_mpoly_q_is_zero(a->x, ctx) && !fmpz_mpoly_q_is_zero(b->x, ctx);
    for (int k = 0; fits && k < db->count; k++)
        fits = multiply_by(&d, db->factor[k], db->power[k]);
    if (!fits) {
        leave_to(operation, r, a, original);
        return;
    }
    fmpz_mpoly_struct *numerator = fmpz_mpoly_q_numref(r->x), *denominator = fmpz_mpoly_q_denref(r->x);
    fmpz_mpoly_t other;
    fmpz_mpoly_init(other, ctx);
    fmpz_mpoly_set(numerator, fmpz_mpoly_q_numref(a->x), ctx);
    fmpz_mpoly_set(other, fmpz_mpoly_q_numref(b->x), ctx);
    int cancelled = cancel(numerator, da, db, &d) + cancel(other, db, da, &d);
    fmpz_mpoly_mul(numerator, numerator, other, ctx);
    fmpz_mpoly_mul(denominator, fmpz_mpoly_q_denref(a->x), fmpz_mpoly_q_denref(b->x), ctx);
    finish(r, &d, cancelled);
    fmpz_mpoly_clear(other, ctx);
}

void fraction_add(struct field_element *r, const struct field_element *a, const struct field_element *b)
{
    add_or_subtract(fmpz_mpoly_q_add, r, a, b);
}
void fraction_sub(struct field_element *r, const struct field_element *a, const struct field_element *b)
{
    add_or_subtract(fmpz_mpoly_q_sub, r, a, b);
}
void fraction_mul(struct field_element *r, const struct field_element *a, const struct field_element *b)
{
    multiply(fmpz_mpoly_q_mul, r, a, b, b);
}

/* a times 1/b */
void fraction_div(struct field_element *r, const struct field_element *a, const struct field_element *b)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    struct field_element inverse;
    if (!a->denominator.known || !b->denominator.known || !factorise(&inverse.denominator, fmpz_mpoly_q_numref(b->x))) {
        leave_to(fmpz_mpoly_q_div, r, a, b);
        return;
    }
    fmpz_mpoly_q_init(inverse.x, ctx);
    fmpz_mpoly_struct *numerator = fmpz_mpoly_q_numref(inverse.x), *denominator = fmpz_mpoly_q_denref(inverse.x);
    fmpz_mpoly_set(numerator, fmpz_mpoly_q_denref(b->x), ctx);
    fmpz_mpoly_set(denominator, fmpz_mpoly_q_numref(b->x), ctx);
    if (fmpz_sgn(denominator->coeffs) < 0) {
        fmpz_mpoly_neg(numerator, numerator, ctx);
        fmpz_mpoly_neg(denominator, denominator, ctx);
    }
    multiply(fmpz_mpoly_q_div, r, a, &inverse, b);
    fmpz_mpoly_q_clear(inverse.x, ctx);
}

int fraction_list_is_true(const struct field_element *a)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    fmpz_mpoly_t product;
    fmpz_mpoly_init(product, ctx);
    fmpz_mpoly_one(product, ctx);
    for (int k = 0; k < a->denominator.count; k++)
        expand_by(product, a->denominator.factor[k], a->denominator.power[k]);
    int whole =
        fmpz_mpoly_divides(product, fmpz_mpoly_q_denref(a->x), product, ctx) && fmpz_mpoly_is_fmpz(product, ctx);
    fmpz_mpoly_clear(product, ctx);
    return whole || !a->denominator.known;
}
