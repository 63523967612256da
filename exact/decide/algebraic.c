#include "exact/decide/algebraic.h"

#include "exact/decide/resultant.h"
#include "exact/words.h"

enum { MOST_DEGREE = 48, MOST_FACTORS = 64, MOST_TRIES = 12, CLOSEST = 4000 };

static num_q one(void) { return from_int_q(1); }
static num_q half(num_q a) { return div_q(a, from_int_q(2)); }
static poly zero(void) { return poly_constant(from_int_q(0)); }
static int is_number(const struct cagd_root *r) { return cagd_equal_q(r->lo, r->hi); }
static struct cagd_root finer(struct cagd_root r)
{
    return is_number(&r) ? r : cagd_refine_root(r, half(sub_q(r.hi, r.lo)));
}
static cagd_over_k unable(void)
{
    region_faults |= FAULT_UNABLE;
    return (cagd_over_k){.degree = -1};
}

cagd_algebraic_point cagd_algebraic_origin(void)
{
    num_q at = from_int_q(0);
    return (cagd_algebraic_point){.theta = {at, at, 1, poly_variable()}};
}

/* ---- the field K --------------------------------------------------------------------------------------- */

static poly times(poly a, poly b, poly m) { return poly_remainder(poly_mul(a, b), m); }

/* 1/a modulo the irreducible m, by Euclid's algorithm: s a = r modulo m all along, and r becomes a number. */
static poly inverse(poly a, poly m)
{
    poly r[2] = {m, a}, s[2] = {zero(), poly_constant(one())};
    if (cagd_poly_is_zero(a))
        region_faults |= FAULT_UNDEFINED;
    while (cagd_poly_degree(r[1]) > 0 && region_faults == 0) {
        poly q = poly_quotient(r[0], r[1]), next = poly_sub(r[0], poly_mul(q, r[1])),
             factor = poly_sub(s[0], poly_mul(q, s[1]));
        r[0] = r[1], r[1] = next, s[0] = s[1], s[1] = factor;
    }
    return region_faults != 0 ? zero() : poly_remainder(poly_scale(s[1], div_q(one(), poly_coefficient(r[1], 0))), m);
}

/* The sign of the element at theta, which is enclosed more closely where that is needed. */
static int sign_at(struct cagd_root *theta, poly a)
{
    if (cagd_poly_degree(a) < 1)
        return cagd_sign_q(poly_coefficient(a, 0));
    for (int k = 0; k < CLOSEST && region_faults == 0; k++, *theta = finer(*theta))
        if (is_number(theta) || cagd_count_roots(a, theta->lo, theta->hi, CLOSED).distinct == 0)
            return cagd_sign_q(cagd_poly_value(a, theta->lo));
    region_faults |= FAULT_UNABLE;
    return 0;
}

int cagd_algebraic_sign(const cagd_algebraic_point *a, poly element)
{
    struct cagd_root theta = a->theta;
    return sign_at(&theta, element);
}

/* The value of p in x[0], ..., x[count-1] by Horner's rule, the last variable first. */
static poly value_of(const cagd_algebraic_point *a, num_f p, int count, const num_f x[])
{
    num_q number;
    while (count > 0 && degree_f(p, x[count - 1]) < 1)
        count--;
    if (count == 0) {
        if (!is_constant_f(p, &number)) {
            region_faults |= FAULT_UNABLE;
            return zero();
        }
        return poly_constant(number);
    }
    poly value = zero();
    for (int e = degree_f(p, x[count - 1]); e >= 0 && region_faults == 0; e--)
        value = poly_add(times(value, a->coordinate[count - 1], a->theta.factor),
                         value_of(a, coefficient_f(p, x[count - 1], e), count - 1, x));
    return value;
}

poly cagd_algebraic_value(const cagd_algebraic_point *a, num_f p, const num_f x[])
{
    return value_of(a, p, a->count, x);
}

/* ---- polynomials over K -------------------------------------------------------------------------------- */

static void trim(cagd_over_k *p)
{
    while (p->degree >= 0 && cagd_poly_is_zero(p->c[p->degree]))
        p->degree--;
}

cagd_over_k cagd_algebraic_polynomial(const cagd_algebraic_point *a, num_f p, const num_f x[])
{
    cagd_over_k r = {.degree = degree_f(p, x[a->count])};
    if (r.degree > CAGD_MOST_OVER_K)
        return unable();
    for (int e = 0; e <= r.degree && region_faults == 0; e++)
        r.c[e] = value_of(a, coefficient_f(p, x[a->count], e), a->count, x);
    trim(&r);
    return r;
}

static cagd_over_k scaled(const cagd_over_k *p, poly by, poly m)
{
    cagd_over_k r = {.degree = p->degree};
    for (int e = 0; e <= p->degree; e++)
        r.c[e] = times(p->c[e], by, m);
    return r;
}

static cagd_over_k monic(const cagd_over_k *p, poly m)
{
    return p->degree < 0 ? *p : scaled(p, inverse(p->c[p->degree], m), m);
}

/* Of a polynomial that is not 0. */
static cagd_over_k derivative(const cagd_over_k *p)
{
    cagd_over_k r = {.degree = p->degree - 1};
    for (int e = 1; e <= p->degree; e++)
        r.c[e - 1] = poly_scale(p->c[e], from_int_q(e));
    return r;
}

/* The remainder of *p, and the quotient in *q, by a polynomial whose leading coefficient has the inverse `by`. */
static cagd_over_k divided(cagd_over_k p, const cagd_over_k *d, poly by, poly m, cagd_over_k *q)
{
    *q = (cagd_over_k){.degree = p.degree - d->degree};
    for (int e = q->degree; e >= 0 && region_faults == 0; e--) {
        q->c[e] = times(p.c[e + d->degree], by, m);
        for (int i = 0; i <= d->degree; i++)
            p.c[e + i] = poly_sub(p.c[e + i], times(q->c[e], d->c[i], m));
    }
    p.degree = p.degree < d->degree ? p.degree : d->degree - 1;
    q->degree = q->degree < -1 ? -1 : q->degree;
    trim(&p);
    return p;
}

/* The greatest common divisor, with leading coefficient 1. */
static cagd_over_k common_divisor(cagd_over_k p, cagd_over_k q, poly m)
{
    while (q.degree >= 0 && region_faults == 0) {
        cagd_over_k quotient, d = monic(&q, m);
        q = divided(p, &d, poly_constant(one()), m, &quotient);
        p = d;
    }
    return monic(&p, m);
}

/* p without the factors that it has in common with d, in lowest terms p/gcd(p,d). */
static cagd_over_k without(const cagd_over_k *p, const cagd_over_k *d, poly m)
{
    cagd_over_k g = common_divisor(*p, *d, m), q;
    divided(*p, &g, poly_constant(one()), m, &q);
    return q;
}

static poly at_number(const cagd_over_k *p, num_q y)
{
    poly value = zero();
    for (int e = p->degree; e >= 0; e--)
        value = poly_add(poly_scale(value, y), p->c[e]);
    return value;
}

/* ---- real roots ---------------------------------------------------------------------------------------- */

/* Sturm's chain of a squarefree polynomial: p, p', and remainders with the other sign, each times a positive element. */
struct chain {
    int count;
    cagd_over_k p[CAGD_MOST_OVER_K + 1];
};

static struct chain *chain_of(const cagd_over_k *p, struct cagd_root *theta)
{
    poly m = theta->factor;
    struct chain *s = region_bytes(sizeof *s);
    if (s == NULL)
        return NULL;
    *s = (struct chain){.count = 2};
    s->p[0] = *p, s->p[1] = derivative(p);
    while (s->p[s->count - 1].degree > 0 && region_faults == 0) {
        const cagd_over_k *before = &s->p[s->count - 2], *last = &s->p[s->count - 1];
        cagd_over_k quotient, rest = divided(*before, last, inverse(last->c[last->degree], m), m, &quotient);
        if (rest.degree < 0)
            break;
        poly lead = rest.c[rest.degree];
        poly by = poly_scale(inverse(lead, m), from_int_q(-sign_at(theta, lead)));
        s->p[s->count++] = scaled(&rest, by, m);
    }
    return s;
}

/* Changes of sign in the chain at a number; with `end` = 1 or -1 beyond all roots instead. */
static int variations(const struct chain *s, struct cagd_root *theta, num_q y, int end)
{
    int count = 0, last = 0;
    for (int k = 0; k < s->count && region_faults == 0; k++) {
        const cagd_over_k *p = &s->p[k];
        int sign = p->degree < 0 ? 0 : sign_at(theta, end != 0 ? p->c[p->degree] : at_number(p, y));
        if (end < 0 && p->degree % 2 == 1)
            sign = -sign;
        count += sign * last < 0;
        last = sign != 0 ? sign : last;
    }
    return count;
}

/* All roots found so far. */
struct found {
    cagd_root_over_k *out;
    int count, room;
};

/* The `inside` roots of the chain in lo < y <= hi. */
static void isolate(const struct chain *s, const cagd_over_k *of, struct cagd_root *theta, num_q lo, num_q hi,
                    int inside, struct found *f)
{
    if (inside == 0 || f->count > f->room || region_faults != 0)
        return;
    if (inside == 1) {
        if (sign_at(theta, at_number(of, hi)) == 0)
            lo = hi;
        if (f->count < f->room)
            f->out[f->count] = (cagd_root_over_k){lo, hi, of};
        f->count++;
        return;
    }
    num_q middle = half(add_q(lo, hi));
    int below = variations(s, theta, lo, 0) - variations(s, theta, middle, 0);
    isolate(s, of, theta, lo, middle, below, f);
    isolate(s, of, theta, middle, hi, inside - below, f);
}

static void roots_of(const cagd_over_k *p, struct cagd_root *theta, struct found *f)
{
    num_q bound = one(), unused = from_int_q(0);
    const struct chain *s = chain_of(p, theta);
    if (s == NULL || region_faults != 0)
        return;
    int all = variations(s, theta, unused, -1) - variations(s, theta, unused, 1);
    while (region_faults == 0 && variations(s, theta, neg_q(bound), 0) - variations(s, theta, bound, 0) < all)
        bound = add_q(bound, bound);
    isolate(s, p, theta, neg_q(bound), bound, all, f);
}

/* The same root in half of its interval: at its upper end the polynomial is not 0, and changes its sign but once. */
static cagd_root_over_k halved(cagd_root_over_k r, struct cagd_root *theta)
{
    if (cagd_equal_q(r.lo, r.hi))
        return r;
    num_q middle = half(add_q(r.lo, r.hi));
    int sign = sign_at(theta, at_number(r.of, middle));
    if (sign == 0)
        r.lo = r.hi = middle;
    else if (sign == sign_at(theta, at_number(r.of, r.hi)))
        r.hi = middle;
    else
        r.lo = middle;
    return r;
}

/* In increasing order, with room between neighbours. */
static void sort(struct found *f, struct cagd_root *theta)
{
    for (int i = 1; i < f->count; i++)
        for (int k = i; k > 0 && region_faults == 0; k--) {
            cagd_root_over_k *before = &f->out[k - 1], *behind = &f->out[k];
            while (cagd_compare_q(before->hi, behind->lo) >= 0 && cagd_compare_q(behind->hi, before->lo) >= 0 &&
                   region_faults == 0)
                *before = halved(*before, theta), *behind = halved(*behind, theta);
            if (cagd_compare_q(before->hi, behind->lo) < 0)
                break;
            cagd_root_over_k kept = *behind;
            *behind = *before, *before = kept;
        }
}

int cagd_roots_over_k(const cagd_algebraic_point *a, int count, const cagd_over_k p[], int room, cagd_root_over_k out[])
{
    struct cagd_root theta = a->theta;
    poly m = theta.factor;
    struct found f = {.out = out, .room = room};
    cagd_over_k *part = cagd_region_array(count, 1, sizeof *part); /* squarefree, no two with a common factor */
    int parts = 0;
    for (int i = 0; i < count && part != NULL && region_faults == 0; i++) {
        if (p[i].degree < 1)
            continue;
        cagd_over_k slope = derivative(&p[i]), q = without(&p[i], &slope, m);
        for (int k = 0; k < parts && q.degree > 0; k++)
            q = without(&q, &part[k], m);
        if (q.degree > 0)
            part[parts++] = monic(&q, m);
    }
    for (int k = 0; k < parts && region_faults == 0; k++)
        roots_of(&part[k], &theta, &f);
    if (region_faults != 0 || f.count > room)
        return -1;
    sort(&f, &theta);
    return region_faults == 0 ? f.count : -1;
}

/* ---- larger fields ------------------------------------------------------------------------------------- */

cagd_algebraic_point cagd_algebraic_with_number(const cagd_algebraic_point *a, num_q y)
{
    cagd_algebraic_point r = *a;
    if (r.count == CAGD_MOST_COORDINATES)
        region_faults |= FAULT_UNABLE;
    else
        r.coordinate[r.count++] = poly_constant(y);
    return r;
}

/* The irreducible factor of p, with leading coefficient 1, that has the root between lo and hi, which p has once there. */
static poly factor_with_root(poly p, num_q lo, num_q hi, num_f carrier)
{
    num_f factor[MOST_FACTORS], of_p = from_int_f(0);
    int power[MOST_FACTORS];
    for (int e = cagd_poly_degree(p); e >= 0; e--)
        of_p = add_f(mul_f(of_p, carrier), from_rational_f(poly_coefficient(p, e)));
    int count = cagd_factors_f(of_p, carrier, MOST_FACTORS, factor, power);
    for (int i = 0; i < count; i++) {
        poly f, unit;
        cagd_poly_from_field(factor[i], carrier, &f, &unit);
        if (cagd_count_roots(f, lo, hi, CLOSED).distinct == 1)
            return poly_scale(f, div_q(one(), poly_coefficient(f, cagd_poly_degree(f))));
    }
    region_faults |= FAULT_UNABLE;
    return p;
}

/* The polynomial of that degree at most with given values at 0, 1, ..., degree (Newton). */
static poly interpolated(int degree, const num_q value[])
{
    num_q d[MOST_DEGREE + 1];
    for (int i = 0; i <= degree; i++)
        d[i] = value[i];
    for (int k = 1; k <= degree; k++)
        for (int i = degree; i >= k; i--)
            d[i] = div_q(sub_q(d[i], d[i - 1]), from_int_q(k));
    poly p = zero();
    for (int i = degree; i >= 0; i--)
        p = poly_add(poly_mul(p, poly_from_q(2, (num_q[]){from_int_q(-i), one()})), poly_constant(d[i]));
    return p;
}

/* D(t, y) for y = b - c t, as a polynomial in t over Q. */
static poly along_line(const cagd_over_k *D, num_q b, num_q c)
{
    poly y = poly_from_q(2, (num_q[]){b, neg_q(c)}), value = zero();
    for (int e = D->degree; e >= 0; e--)
        value = poly_add(poly_mul(value, y), D->c[e]);
    return value;
}

/* Res_t(m(t), D(t, z - c t)), a polynomial in z whose roots are eta + c theta for all conjugates theta and the roots eta of D over each. */
static poly norm_of(const cagd_over_k *D, poly m, num_q c)
{
    num_q value[MOST_DEGREE + 1];
    int degree = D->degree * cagd_poly_degree(m);
    for (int i = 0; i <= degree && region_faults == 0; i++) {
        poly p = along_line(D, from_int_q(i), c);
        value[i] = cagd_poly_is_zero(p) ? from_int_q(0) : cagd_poly_resultant_sylvester(m, p); /* m is monic */
    }
    return region_faults == 0 ? interpolated(degree, value) : zero();
}

/* theta as an element of Q(gamma), gamma = eta + c theta: the only common root of m(t) and D(t, gamma - c t). */
static poly old_theta(const cagd_over_k *D, poly m, num_q c, poly f)
{
    cagd_over_k of_m = {.degree = cagd_poly_degree(m)}, line = {.degree = -1};
    poly gamma = poly_remainder(poly_variable(), f);
    if (D->degree + of_m.degree > CAGD_MOST_OVER_K) {
        region_faults |= FAULT_UNABLE;
        return zero();
    }
    for (int e = 0; e <= of_m.degree; e++)
        of_m.c[e] = poly_constant(poly_coefficient(m, e));
    for (int e = D->degree; e >= 0; e--) { /* line = line (gamma - c t) + D_e(t) */
        cagd_over_k next = {.degree = D->degree + of_m.degree};
        for (int i = 0; i <= next.degree; i++) {
            poly sum = poly_constant(poly_coefficient(D->c[e], i));
            if (i <= line.degree)
                sum = poly_add(sum, times(line.c[i], gamma, f));
            if (i > 0 && i - 1 <= line.degree)
                sum = poly_sub(sum, poly_scale(line.c[i - 1], c));
            next.c[i] = sum;
        }
        trim(&next);
        line = next;
    }
    cagd_over_k g = common_divisor(of_m, line, f);
    if (g.degree != 1) {
        region_faults |= FAULT_UNABLE;
        return zero();
    }
    return poly_neg(g.c[0]);
}

/* a(b) modulo f. */
static poly composed(poly a, poly b, poly f)
{
    poly value = zero();
    for (int e = cagd_poly_degree(a); e >= 0; e--)
        value = poly_add(times(value, b, f), poly_constant(poly_coefficient(a, e)));
    return value;
}

/* K(eta) for a root of D over K, by gamma = eta + c theta, c > 0. */
static cagd_algebraic_point with_larger_field(const cagd_algebraic_point *a, cagd_root_over_k r, num_f carrier)
{
    cagd_algebraic_point b = *a;
    struct cagd_root theta = a->theta;
    poly m = theta.factor, N = zero();
    num_q c = from_int_q(0), lo = c, hi = c;
    for (int k = 1; k <= MOST_TRIES && region_faults == 0 && cagd_poly_is_zero(N); k++) {
        c = from_int_q(k);
        N = norm_of(r.of, m, c);
        if (cagd_poly_degree(poly_gcd(N, poly_derivative(N))) > 0)
            N = zero();
    }
    if (cagd_poly_is_zero(N))
        region_faults |= FAULT_UNABLE;
    for (int k = 0; k < CLOSEST && region_faults == 0; k++) {
        lo = add_q(r.lo, mul_q(c, theta.lo)), hi = add_q(r.hi, mul_q(c, theta.hi));
        if (cagd_count_roots(N, lo, hi, CLOSED).distinct == 1)
            break;
        theta = finer(theta), r = halved(r, &theta);
    }
    if (region_faults != 0)
        return b;
    poly f = factor_with_root(N, lo, hi, carrier), of_theta = old_theta(r.of, m, c, f);
    for (int k = 0; k < a->count; k++)
        b.coordinate[k] = composed(a->coordinate[k], of_theta, f);
    b.coordinate[b.count++] =
        poly_remainder(poly_sub(poly_variable(), poly_scale(of_theta, c)), f); /* eta = gamma - c theta */
    b.theta = (struct cagd_root){lo, hi, 1, f};
    return b;
}

cagd_algebraic_point cagd_algebraic_with_root(const cagd_algebraic_point *a, const cagd_root_over_k *r, num_f carrier)
{
    cagd_algebraic_point b = *a;
    int over = cagd_poly_degree(a->theta.factor);
    if (cagd_equal_q(r->lo, r->hi))
        return cagd_algebraic_with_number(a, r->lo);
    if (b.count == CAGD_MOST_COORDINATES || over * r->of->degree > MOST_DEGREE) {
        region_faults |= FAULT_UNABLE;
        return b;
    }
    if (r->of->degree == 1) {
        b.coordinate[b.count++] = times(poly_neg(r->of->c[0]), inverse(r->of->c[1], a->theta.factor), a->theta.factor);
        return b;
    }
    if (over > 1)
        return with_larger_field(a, *r, carrier);
    poly p = zero(); /* over Q */
    for (int e = r->of->degree; e >= 0; e--)
        p = poly_add(poly_mul(p, poly_variable()), r->of->c[e]);
    cagd_root_over_k near = *r;
    struct cagd_root theta = a->theta;
    while (region_faults == 0 && cagd_count_roots(p, near.lo, near.hi, CLOSED).distinct != 1)
        near = halved(near, &theta);
    if (cagd_equal_q(near.lo, near.hi))
        return cagd_algebraic_with_number(a, near.lo);
    poly f = factor_with_root(p, near.lo, near.hi, carrier);
    if (cagd_poly_degree(f) == 1)
        return cagd_algebraic_with_number(a, neg_q(poly_coefficient(f, 0)));
    b.theta = (struct cagd_root){near.lo, near.hi, 1, f};
    b.coordinate[b.count++] = poly_variable();
    return b;
}

/* ---- one coordinate ------------------------------------------------------------------------------------ */

struct cagd_root cagd_algebraic_coordinate(const cagd_algebraic_point *a, int k)
{
    struct cagd_root theta = a->theta, root[MOST_DEGREE];
    poly m = theta.factor, element = a->coordinate[k];
    int degree = cagd_poly_degree(m);
    num_q value[MOST_DEGREE + 1];
    if (cagd_poly_degree(element) < 1) {
        num_q y = poly_coefficient(element, 0);
        return (struct cagd_root){y, y, 1, poly_from_q(2, (num_q[]){neg_q(y), one()})};
    }
    for (int i = 0; i <= degree; i++) /* Res_t(m(t), z - y(t)), a power of the minimal polynomial */
        value[i] = cagd_poly_resultant_sylvester(m, poly_sub(poly_constant(from_int_q(i)), element));
    poly N = interpolated(degree, value), minimal = poly_quotient(N, poly_gcd(N, poly_derivative(N)));
    num_q far = cagd_root_bound(minimal);
    int count = cagd_isolate_roots(minimal, neg_q(far), far, root, MOST_DEGREE);
    for (int i = 0; i < count && region_faults == 0; i++) {
        poly above = poly_sub(element, poly_constant(root[i].lo)), below = poly_sub(element, poly_constant(root[i].hi));
        if (is_number(&root[i]) ? cagd_poly_is_zero(above) : sign_at(&theta, above) > 0 && sign_at(&theta, below) < 0)
            return root[i];
    }
    region_faults |= FAULT_UNABLE;
    return theta;
}
